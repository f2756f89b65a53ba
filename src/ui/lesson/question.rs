//! A question: what was answered, and what is said of it.

use egui::{Button, Color32, RichText, Ui};

use super::choose::choose_ui;
use super::estimate::{Typed, estimate_ui};
use super::order::order_ui;
use super::place::place_ui;
use super::sketch::{Hand, sketch_ui};
use super::text::{Context, text_ui};
use crate::lesson::drawing;
use crate::lesson::{Answer, Comparison, Estimated, Given, Kind, PlaceCompared, Prediction, Truth};
use crate::ui::theme::{self, Palette};
use crate::words;

/// A question on screen: what of it is found or typed already.
#[derive(Debug, Default)]
pub struct Asked {
    /// What the model says, once it is needed.
    truth: Option<Option<Truth>>,
    /// A number as it is being typed.
    typed: Typed,
    /// The hand on the pad of a sketch.
    hand: Hand,
}

impl Asked {
    fn truth(&mut self, prediction: &Prediction, context: Context<'_>) -> Option<Truth> {
        self.truth.get_or_insert_with(|| prediction.truth(context.start, context.aircraft)).clone()
    }
}

/// Draws a question with its answer, and once that is final what is to be said of it.
pub fn question_ui(
    ui: &mut Ui,
    prediction: &Prediction,
    given: &mut Given,
    asked: &mut Asked,
    context: Context<'_>,
) {
    ui.scope(|ui| {
        text_ui(ui, &prediction.ask, context);
    });
    // The axes of a place and of a sketch need it before.
    let needs_axes = matches!(prediction.kind, Kind::Place { .. } | Kind::Sketch { .. });
    let truth = if given.is_final || needs_axes { asked.truth(prediction, context) } else { None };
    match &prediction.kind {
        Kind::Choose { choices, several } => choose_ui(ui, choices, *several, given),
        Kind::Estimate { measure, .. } => {
            estimate_ui(ui, *measure, given, &mut asked.typed, truth.as_ref(), context);
        }
        Kind::Order { items, measure, .. } => {
            order_ui(ui, items, *measure, given, truth.as_ref(), context);
        }
        Kind::Place { mode, .. } => {
            let moves = prediction.after.is_some();
            place_ui(ui, *mode, moves, given, truth.as_ref(), context);
        }
        Kind::Sketch { output, .. } => {
            sketch_ui(ui, *output, given, &mut asked.hand, truth.as_ref(), context);
        }
    }
    if given.is_final {
        outcome_ui(ui, prediction, given, truth.as_ref(), context);
    } else {
        buttons_ui(ui, given);
    }
}

/// The buttons below a question; "I don't know" is an answer too.
fn buttons_ui(ui: &mut Ui, given: &mut Given) {
    ui.horizontal(|ui| {
        let can = given.answer.as_ref().is_some_and(|answer| match answer {
            Answer::Sketch(drawn) => drawing::is_whole(drawn),
            _ => true,
        });
        if ui.add_enabled(can, Button::new("Answer")).clicked() {
            given.is_final = true;
            if let Some(Answer::Sketch(drawn)) = &mut given.answer {
                drawing::finish(drawn);
            }
        }
        if ui.button("I don’t know").clicked() {
            given.answer(Answer::DontKnow);
        }
    });
}

/// What is said of an answer: whether it is right, and the reasons that fit what is wrong with it.
fn outcome_ui(
    ui: &mut Ui,
    prediction: &Prediction,
    given: &Given,
    truth: Option<&Truth>,
    context: Context<'_>,
) {
    let (Some(answer), Some(truth)) = (given.final_answer(), truth) else {
        ui.label("There is nothing to compare it with at this scene.");
        return;
    };
    let outcome = truth.compare(&prediction.kind, answer);
    let palette = Palette::of(ui);
    let color = color(&outcome, palette);
    ui.label(RichText::new(outcome.says()).font(theme::semibold(theme::body().size)).color(color));
    let features = match outcome {
        Comparison::Sketch { first, swings, ends } => words::lesson::features(first, swings, ends).to_vec(),
        _ => Vec::new(),
    };
    for (is_right, sentence) in features {
        let (mark, color) = if is_right { ("✓", palette.good) } else { ("✗", palette.bad) };
        ui.label(RichText::new(format!("{mark} {sentence}")).color(color));
    }
    for reason in outcome.reasons(&prediction.kind) {
        text_ui(ui, reason, context);
    }
}

/// The colour in which it is told what an answer is.
fn color(outcome: &Comparison, palette: &'static Palette) -> Color32 {
    match outcome {
        Comparison::DontKnow => palette.text,
        outcome if outcome.is_right() => palette.good,
        Comparison::Number(Estimated::RightOrder | Estimated::Far)
        | Comparison::Place(PlaceCompared::RightRegion | PlaceCompared::Far) => palette.warning,
        _ => palette.bad,
    }
}
