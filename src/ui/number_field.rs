//! A number that can be typed. What can't be used is refused in one sentence, and what was typed stays.

use egui::text::{CCursor, CCursorRange};
use egui::{FontId, Id, Key, Response, RichText, TextEdit, Ui};

use super::arrow_keys;
use super::theme::{self, Palette};
use crate::scenario::ValueError;
use crate::words;

/// The text that a person is typing, or has typed in vain.
#[derive(Clone, Debug)]
struct Draft {
    text: String,
    refusal: Option<String>,
    /// The number beside which it was typed: once that has changed, the draft is void.
    beside: String,
}

/// The outcome of one frame.
#[derive(Debug)]
pub struct NumberField {
    /// The field.
    pub response: Response,
    /// A number that was typed and accepted.
    pub accepted: Option<f64>,
    /// Why what was typed is refused, until it is mended or given up with Escape.
    pub refusal: Option<Refusal>,
}

/// Why what was typed is refused.
#[derive(Debug)]
pub struct Refusal {
    sentence: String,
    /// Whether it has been refused in this frame.
    is_new: bool,
}

impl Refusal {
    /// The sentence, in a row of its own; a new one is brought into sight.
    pub fn show(&self, ui: &mut Ui) {
        let text = RichText::new(format!("⚠ {}", self.sentence)).font(theme::small());
        let sentence = ui.label(text.color(Palette::of(ui).bad));
        if self.is_new {
            sentence.scroll_to_me(None);
            // What was typed is drawn as refused from the next frame on.
            ui.request_repaint();
        }
    }
}

/// Draws a field of a width and a size of type that shows `shown`; on Enter or when left, what was typed goes through `read`.
pub fn number_field_ui(
    ui: &mut Ui,
    id: Id,
    name: &str,
    shown: &str,
    (width, size): (f32, f32),
    read: impl FnOnce(&str) -> Result<f64, ValueError>,
) -> NumberField {
    let palette = Palette::of(ui);
    let mut draft: Option<Draft> =
        ui.data(|data| data.get_temp::<Draft>(id)).filter(|draft| draft.beside == shown);
    let mut text = draft.as_ref().map_or_else(|| shown.to_owned(), |draft| draft.text.clone());
    // A small field stands below something else.
    let above = if size < theme::sizes(ui).name { 0 } else { 3 };
    let refused = draft.as_ref().is_some_and(|draft| draft.refusal.is_some());

    let output = TextEdit::singleline(&mut text)
        .id(id)
        .desired_width(width)
        .align(egui::Align2::RIGHT_CENTER)
        .font(FontId::proportional(size))
        .margin(egui::Margin::symmetric(4, above))
        .text_color(if refused { palette.bad } else { palette.text })
        .char_limit(32)
        .show(ui);
    let mut response = output.response.response.accessible_name(name);
    theme::focus_frame(ui, &response);
    if response.has_focus() {
        arrow_keys::keep(ui, &response);
    }
    if response.gained_focus() {
        let mut state = output.state;
        let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
        state.cursor.set_char_range(Some(all));
        state.store(ui.ctx(), id);
    }
    if response.changed() {
        draft = Some(Draft { text: text.clone(), refusal: None, beside: shown.to_owned() });
    }

    let mut accepted = None;
    if response.lost_focus() {
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            draft = None;
        } else if let Some(typed) = draft.as_mut() {
            match read(&typed.text) {
                Ok(value) => {
                    accepted = Some(value);
                    draft = None;
                    response.mark_changed();
                }
                Err(error) => typed.refusal = Some(words::refusal::sentence(&error)),
            }
        }
    }
    let refusal = draft.as_ref().and_then(|draft| draft.refusal.clone());
    let refusal = refusal.map(|sentence| Refusal { sentence, is_new: response.lost_focus() });
    ui.data_mut(|data| match draft {
        Some(draft) => {
            data.insert_temp(id, draft);
        }
        None => data.remove::<Draft>(id),
    });
    NumberField { response, accepted, refusal }
}
