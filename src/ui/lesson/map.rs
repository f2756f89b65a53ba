//! The steps of a lesson, with those that are done.

use egui::containers::menu::MenuButton;
use egui::{RichText, Ui};

use crate::lesson::{Lesson, Record};
use crate::ui::theme;

/// Draws where the person is; the list of steps is in its menu. Gives the step that they go to.
pub fn map_ui(ui: &mut Ui, lesson: &Lesson, record: &Record) -> Option<usize> {
    let text = format!("Step {} of {}", record.step + 1, lesson.steps.len());
    let button = MenuButton::new(RichText::new(format!("{text} ▾")).font(theme::small()));
    let (response, chosen) = button.ui(ui, |ui| {
        let mut chosen = None;
        for (number, step) in lesson.steps.iter().enumerate() {
            let mark = if record.is_done(lesson, number) { "✓" } else { "○" };
            let title = format!("{mark} {}. {}", number + 1, step.title);
            if ui.selectable_label(number == record.step, title).clicked() {
                chosen = Some(number);
            }
        }
        chosen
    });
    response.accessible_name(text);
    chosen.and_then(|chosen| chosen.inner)
}
