//! A question for a number.

use egui::{Key, RichText, TextEdit, Ui};

use super::place::read;
use super::text::Context;
use crate::findings::measures::Measure;
use crate::lesson::{Answer, Given, Truth};
use crate::number::significant;
use crate::scenario::Written;
use crate::ui::theme::{self, Palette};
use crate::words;

/// A number as it is being typed; `None` where nothing has been typed yet.
pub type Typed = Option<String>;

/// Draws the field, and says whether the answer is given by Enter; once it is final, what was said beside what it is.
pub fn estimate_ui(
    ui: &mut Ui,
    measure: Measure,
    given: &mut Given,
    typed: &mut Typed,
    truth: Option<&Truth>,
    context: Context<'_>,
) -> bool {
    let convention = context.start.scenario().convention();
    let Written { unit, in_si, .. } = words::measure::written(measure, convention);
    let in_words = |number: f64| words::measure::value(measure, number, convention);
    if given.is_final {
        let Some(Truth::Number { found, .. }) = truth else { return false };
        let found_in_words = in_words(*found);
        let sentence = match given.answer {
            Some(Answer::Number(said)) => {
                let factor = words::lesson::factor(said, *found);
                format!("You said {}; it is {found_in_words}{factor}.", in_words(said))
            }
            _ => format!("It is {found_in_words}."),
        };
        ui.label(sentence);
        return false;
    }
    let text = typed.get_or_insert_with(|| match given.answer {
        Some(Answer::Number(number)) => significant(number / in_si, 6),
        _ => String::new(),
    });
    let gives = ui.horizontal(|ui| {
        let field = TextEdit::singleline(text).desired_width(90.0).char_limit(32);
        let name = format!("Your estimate: {}", words::measure::name(measure));
        let response = ui.add(field).accessible_name(name);
        theme::focus_frame(ui, &response);
        ui.label(unit);
        if response.changed() {
            given.answer = read(text).ok().map(|number| Answer::Number(number * in_si));
        }
        response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
    });
    if !text.trim().is_empty() && given.answer.is_none() {
        let problem = format!("“{}” is not a number; type one such as 2.5", text.trim());
        ui.label(RichText::new(problem).font(theme::small()).color(Palette::of(ui).bad));
    }
    gives.inner && given.answer.is_some()
}
