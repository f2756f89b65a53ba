//! One thing to fill in: a number, a text, or a choice among a few.

use std::collections::BTreeMap;

use egui::{Align2, ComboBox, RichText, TextEdit, Ui};

use super::review_sheet::Field;
use crate::ui::theme;

/// Width of a field \[points\].
const WIDTH: f32 = 150.0;

/// Draws the field with what is being typed. Gives the value that is taken; an empty one takes it back.
pub fn field_ui(ui: &mut Ui, field: &Field, typed: &mut BTreeMap<String, String>) -> Option<String> {
    let mut taken = None;
    ui.horizontal_wrapped(|ui| {
        let unit = if field.unit.is_empty() { String::new() } else { format!(" [{}]", field.unit) };
        let name = format!("{}{unit}", field.meaning);
        let text = RichText::new(format!("{name}{}", if field.is_missing() { " – missing" } else { "" }));
        let label = ui.label(if field.is_missing() {
            text.font(theme::semibold(theme::sizes(ui).body))
        } else {
            text
        });
        if field.choices.is_empty() {
            let now = field.value.clone().unwrap_or_default();
            let mut text = typed.get(&field.key).cloned().unwrap_or_else(|| now.clone());
            let edit = ui
                .add(TextEdit::singleline(&mut text).desired_width(WIDTH).align(Align2::LEFT_CENTER))
                .labelled_by(label.id);
            if edit.changed() {
                typed.insert(field.key.clone(), text.clone());
            }
            if edit.lost_focus() && text != now {
                taken = Some(text);
            }
        } else {
            let shown =
                field.value.as_ref().map_or_else(|| "Choose …".to_owned(), |value| field.words(value));
            let chooser = ComboBox::from_id_salt(&field.key).selected_text(&shown).width(WIDTH);
            let chooser = chooser.show_ui(ui, |ui| {
                for choice in &field.choices {
                    let is_it = field.value.as_ref() == Some(&choice.key);
                    if ui.selectable_label(is_it, &choice.words).clicked() {
                        taken = Some(choice.key.clone());
                    }
                }
            });
            theme::name_chooser(chooser, &name, &shown);
        }
        if let Some(suggested) = field.offered() {
            let button = ui.button(format!("Take {}", field.words(suggested)));
            let button = button.on_hover_text(field.reason.as_deref().unwrap_or("This is likely."));
            if button.clicked() {
                taken = Some(suggested.clone());
            }
        }
    });
    if let Some(reason) = field.reason.as_ref().filter(|_| field.suggested.is_some()) {
        ui.label(RichText::new(reason).font(theme::small()));
    }
    taken
}
