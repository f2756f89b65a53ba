//! A question with statements to choose from.

use egui::{Button, RichText, Ui};

use crate::lesson::{Answer, Choice, Given};
use crate::ui::symbol::prose;
use crate::ui::theme::{self, Palette};

/// Draws the statements; once the answer is final, with marks of what is right.
pub fn choose_ui(ui: &mut Ui, choices: &[Choice], several: bool, given: &mut Given) {
    let palette = Palette::of(ui);
    let mut chosen = match &given.answer {
        Some(Answer::Chosen(chosen)) => chosen.clone(),
        _ => Vec::new(),
    };
    if several && !given.is_final {
        let hint = RichText::new("More than one may be right.");
        ui.label(hint.font(theme::small()).color(palette.weak));
    }
    let mut changed = false;
    for (number, choice) in choices.iter().enumerate() {
        let mark = match (given.is_final, choice.right) {
            (false, _) => "",
            (true, true) => "✓ ",
            (true, false) => "✗ ",
        };
        let is_chosen = chosen.contains(&number);
        let color = if is_chosen { ui.visuals().selection.stroke.color } else { palette.text };
        let says = prose(&format!("{mark}{}", choice.says.plain()), theme::body(), color);
        let button = Button::selectable(is_chosen, says).frame_when_inactive(true).wrap();
        if ui.add(button).clicked() && !given.is_final {
            changed = true;
            match (several, is_chosen) {
                (true, true) => chosen.retain(|other| *other != number),
                (true, false) => chosen.push(number),
                (false, _) => chosen = vec![number],
            }
        }
    }
    if changed {
        given.answer = (!chosen.is_empty()).then_some(Answer::Chosen(chosen));
    }
}
