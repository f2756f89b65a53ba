//! A question: what was answered, and what is said of it.

use egui::{Button, Color32, RichText, Ui};

use super::choose::choose_ui;
use super::estimate::{Typed, estimate_ui};
use super::order::order_ui;
use super::place::place_ui;
use super::sketch::{Hand, sketch_ui};
use super::text::{Context, text_ui};
use crate::lesson::{Answer, Comparison, Estimated, Given, Kind, PlaceCompared, Prediction, Truth};
use crate::lesson::{drawing, said};
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
    let is_judged = given.is_final || !given.earlier.is_empty();
    let truth = if is_judged || needs_axes { asked.truth(prediction, context) } else { None };
    if !given.is_final
        && let Some(worth) = said::worth(prediction)
    {
        ui.label(RichText::new(worth).font(theme::small()).color(Palette::of(ui).weak));
    }
    let mut gives = false;
    match &prediction.kind {
        Kind::Choose { choices, several } => choose_ui(ui, choices, *several, given),
        Kind::Estimate { measure, .. } => {
            gives = estimate_ui(ui, *measure, given, &mut asked.typed, truth.as_ref(), context);
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
    if !given.is_final {
        gives |= buttons_ui(ui, given);
    }
    if gives {
        let truth = asked.truth(prediction, context);
        let is_right = truth
            .zip(given.answer.as_ref())
            .is_none_or(|(truth, answer)| truth.compare(&prediction.kind, answer).is_right());
        given.give(is_right, prediction.tries);
    }
    if is_judged {
        outcome_ui(ui, prediction, given, truth.as_ref(), context);
    }
}

/// The buttons below a question, and whether the answer is given; "I don't know" is an answer too, and the last.
fn buttons_ui(ui: &mut Ui, given: &mut Given) -> bool {
    let row = ui.horizontal(|ui| {
        let can = given.answer.as_ref().is_some_and(|answer| match answer {
            Answer::Sketch(drawn) => drawing::is_whole(drawn),
            _ => true,
        });
        let gives = ui.add_enabled(can, Button::new("Answer")).clicked();
        if gives && let Some(Answer::Sketch(drawn)) = &mut given.answer {
            drawing::finish(drawn);
        }
        if ui.button("I don’t know").clicked() {
            given.answer(Answer::DontKnow);
        }
        gives
    });
    row.inner
}

/// What is said of an answer: whether it is right, and the reasons that fit what is wrong with it.
fn outcome_ui(
    ui: &mut Ui,
    prediction: &Prediction,
    given: &Given,
    truth: Option<&Truth>,
    context: Context<'_>,
) {
    let (Some(answer), Some(truth)) = (given.final_answer().or(given.earlier.last()), truth) else {
        ui.label("There is nothing to compare it with at this scene.");
        return;
    };
    let outcome = truth.compare(&prediction.kind, answer);
    let palette = Palette::of(ui);
    let color = color(&outcome, palette);
    let strong = theme::semibold(theme::body().size);
    let earned = prediction.points.filter(|_| given.is_final);
    let earned = earned.map_or_else(String::new, |of| format!(" {}.", said::earned(of, outcome.is_right())));
    ui.label(RichText::new(format!("{}{earned}", outcome.says())).font(strong.clone()).color(color));
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
    if !given.is_final {
        ui.label(RichText::new(said::tries_left(given.tries_left(prediction.tries))).font(strong));
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
