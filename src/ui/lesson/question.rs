//! A question: what was answered, and what is said of it.

use egui::{Button, RichText, TextEdit, Ui};

use super::text::{Context, text_ui};
use crate::findings::Findings;
use crate::findings::measures::{Measure, Reading};
use crate::lesson::{Comparison, Estimated, Item, Kind, Prediction};
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};
use crate::words;

/// What a person has answered, or is about to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// Numbers of the statements that are chosen.
    chosen: Vec<usize>,
    /// The number as it is typed.
    typed: String,
    /// Numbers of the things in their order.
    order: Vec<usize>,
    /// What the answer was compared with, once it was given.
    outcome: Option<Comparison>,
}

impl Given {
    /// Whether it has been answered.
    pub fn is_answered(&self) -> bool {
        self.outcome.is_some()
    }
}

/// Draws a question with its answer, and once that is given what is to be said of it.
pub fn question_ui(ui: &mut Ui, prediction: &Prediction, given: &mut Given, context: Context<'_>) {
    let palette = Palette::of(ui);
    ui.scope(|ui| {
        text_ui(ui, &prediction.ask, context);
    });
    let answered = given.is_answered();
    let mut answer = None;
    match &prediction.kind {
        Kind::Choose { choices, several } => {
            for (number, choice) in choices.iter().enumerate() {
                let mark = match (answered, choice.right) {
                    (false, _) => "",
                    (true, true) => "✓ ",
                    (true, false) => "✗ ",
                };
                let is_chosen = given.chosen.contains(&number);
                let color = if is_chosen { ui.visuals().selection.stroke.color } else { palette.text };
                let says = prose(&format!("{mark}{}", choice.says.plain()), theme::body(), color);
                let button = Button::selectable(is_chosen, says).frame_when_inactive(true).wrap();
                if ui.add(button).clicked() && !answered {
                    if *several && is_chosen {
                        given.chosen.retain(|other| *other != number);
                    } else if *several {
                        given.chosen.push(number);
                    } else {
                        given.chosen = vec![number];
                    }
                }
            }
            if answer_ui(ui, answered, !given.chosen.is_empty(), given) {
                answer = Some(Comparison::of_choice(&prediction.kind, &given.chosen));
            }
        }
        Kind::Estimate { measure, .. } => {
            let length = context.start.scenario().aircraft.length_unit;
            let unit = measure.dimension();
            ui.horizontal(|ui| {
                let field = TextEdit::singleline(&mut given.typed).desired_width(90.0).interactive(!answered);
                let name = format!("Your estimate: {}", words::measure::name(*measure));
                ui.add(field).accessible_name(name);
                ui.label(unit.symbol(length));
            });
            let number = given.typed.trim().replace(',', ".").replace('−', "-").parse::<f64>().ok();
            let number = number.filter(|number| number.is_finite());
            if !given.typed.trim().is_empty() && number.is_none() {
                let problem = format!("“{}” is not a number; type one such as 2.5", given.typed.trim());
                ui.label(RichText::new(problem).font(theme::small()).color(palette.bad));
            }
            if answer_ui(ui, answered, number.is_some(), given)
                && let (Some(number), Some(found)) = (number, found(prediction, *measure, context))
            {
                let before = prediction.after.as_ref().and_then(|_| read(*measure, context.start));
                answer = Some(Comparison::of_number(number * unit.in_si(length), found, before));
            }
        }
        Kind::Order { items, measure, .. } => {
            if given.order.len() != items.len() {
                given.order = (0..items.len()).collect();
            }
            order_ui(ui, items, &mut given.order, answered);
            if answer_ui(ui, answered, true, given) {
                let value = |item: &Item| {
                    let there = item.scene.open(context.aircraft)?;
                    read(*measure, &Findings::of(there.scenario))
                };
                let values: Option<Vec<f64>> = items.iter().map(value).collect();
                answer = values.map(|values| Comparison::of_order(&given.order, &values));
            }
        }
        Kind::Place { .. } | Kind::Sketch { .. } => {
            ui.label("Think of an answer, or draw it on paper, before you go on.");
            if answer_ui(ui, answered, false, given) {
                answer = Some(Comparison::DontKnow);
            }
        }
    }
    given.outcome = given.outcome.take().or(answer);
    if let Some(outcome) = &given.outcome {
        let (verdict, color) = said(outcome, palette);
        let found = match &prediction.kind {
            Kind::Estimate { measure, .. } => found(prediction, *measure, context).map(|found| {
                words::measure::number(
                    measure.dimension(),
                    found,
                    context.start.scenario().aircraft.length_unit,
                )
            }),
            _ => None,
        };
        let sentence = match found {
            Some(found) => format!("{verdict} It is {found}."),
            None => verdict.to_owned(),
        };
        ui.label(RichText::new(sentence).font(theme::semibold(theme::body().size)).color(color));
        for reason in outcome.reasons(&prediction.kind) {
            text_ui(ui, reason, context);
        }
    }
}

/// The buttons below a question. Says whether it is answered now; "I don't know" is an answer too.
fn answer_ui(ui: &mut Ui, answered: bool, can: bool, given: &mut Given) -> bool {
    if answered {
        return false;
    }
    ui.horizontal(|ui| {
        let answer = ui.add_enabled(can, Button::new("Answer")).clicked();
        if ui.button("I don’t know").clicked() {
            given.outcome = Some(Comparison::DontKnow);
        }
        answer
    })
    .inner
}

/// Things in an order that a person changes by moving one up.
fn order_ui(ui: &mut Ui, items: &[Item], order: &mut [usize], answered: bool) {
    let mut up = None;
    for (place, &number) in order.iter().enumerate() {
        let Some(item) = items.get(number) else { continue };
        ui.horizontal(|ui| {
            let says = item.says.plain();
            let button = Button::new("↑");
            let can = place > 0 && !answered;
            if ui.add_enabled(can, button).accessible_name(format!("Move “{says}” up")).clicked() {
                up = Some(place);
            }
            ui.label(format!("{}. {says}", place + 1));
        });
    }
    if let Some(place) = up {
        order.swap(place - 1, place);
    }
}

/// What an answer is, in a sentence, and the colour that it is told in.
fn said(outcome: &Comparison, palette: &'static Palette) -> (&'static str, egui::Color32) {
    match outcome {
        Comparison::DontKnow => ("Now you can find out.", palette.text),
        Comparison::Number(Estimated::Near) => ("Within 10 %.", palette.good),
        Comparison::Number(Estimated::RightOrder) => ("The right order.", palette.warning),
        Comparison::Number(Estimated::Far) => ("The right way, but far.", palette.warning),
        Comparison::Number(Estimated::WrongWay) => ("The other way.", palette.bad),
        outcome if outcome.is_right() => ("That is right.", palette.good),
        _ => ("Not so.", palette.bad),
    }
}

/// What the measure of a question is where its answer is.
fn found(prediction: &Prediction, measure: Measure, context: Context<'_>) -> Option<f64> {
    match &prediction.after {
        Some(scene) => read(measure, &Findings::of(scene.open(context.aircraft)?.scenario)),
        None => read(measure, context.start),
    }
}

fn read(measure: Measure, findings: &Findings) -> Option<f64> {
    match measure.read(findings) {
        Ok(Reading::Number(number)) => Some(number),
        Ok(Reading::Stability(_) | Reading::Level(_)) | Err(_) => None,
    }
}
