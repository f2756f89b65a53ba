//! Something to write in one's own words.

use egui::{TextEdit, Ui};

use super::text::{Context, text_ui};
use crate::lesson::{Answer, Given, Writing};
use crate::ui::theme;

/// Longest text that is kept \[characters\].
const LONGEST: usize = 4000;

/// Draws what is asked and the field for it; what is written is kept as it stands.
pub fn write_ui(ui: &mut Ui, writing: &Writing, given: &mut Given, context: Context<'_>) {
    text_ui(ui, &writing.ask, context);
    let mut text = match &given.answer {
        Some(Answer::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let field = TextEdit::multiline(&mut text)
        .desired_width(f32::INFINITY)
        .desired_rows(4)
        .char_limit(LONGEST)
        .hint_text("In your own words");
    let response = ui.add(field).accessible_name(format!("Your words: {}", writing.ask.plain()));
    theme::focus_frame(ui, &response);
    if response.changed() {
        given.answer = (!text.trim().is_empty()).then_some(Answer::Text(text));
    }
}
