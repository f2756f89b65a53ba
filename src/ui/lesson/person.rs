//! The name or number of the person, which is asked for once: their own numbers follow from it, and a link that is handed in has it.

use egui::{Button, Key, TextEdit, Ui};

use super::Wish;
use crate::lesson::normalised;
use crate::ui::theme;

/// Longest name \[characters\].
const LONGEST: usize = 80;

/// Draws the field and its button; gives the name once it is told.
pub fn person_ui(ui: &mut Ui, why: &str, typed: &mut String) -> Option<Wish> {
    ui.label(why);
    let told = ui.horizontal_wrapped(|ui| {
        let field = TextEdit::singleline(typed).desired_width(180.0).char_limit(LONGEST);
        let response = ui.add(field).accessible_name("Your name or number");
        theme::focus_frame(ui, &response);
        // A name without a letter or digit would be nobody's.
        let can = !normalised(typed).is_empty();
        let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        ui.add_enabled(can, Button::new("That’s me")).clicked() || can && entered
    });
    told.inner.then(|| Wish::Person(typed.trim().to_owned()))
}
