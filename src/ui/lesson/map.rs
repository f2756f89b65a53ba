//! The steps of a lesson, with those that are done.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{PopupCloseBehavior, RichText, Ui};

use crate::lesson::{Lesson, Record};
use crate::ui::theme;

/// What is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chosen {
    /// Go to a step.
    Step(usize),
    /// Begin the lesson again, without what was answered.
    Again,
}

/// Draws where the person is; the list of steps is in its menu, and below it the way to begin again, which is asked for twice. `asked`
/// is whether it was asked for once.
pub fn map_ui(ui: &mut Ui, lesson: &Lesson, record: &Record, asked: &mut bool) -> Option<Chosen> {
    let text = format!("Step {} of {}", record.step + 1, lesson.steps.len());
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let button = MenuButton::new(RichText::new(format!("{text} ▾")).font(theme::small())).config(config);
    let (response, chosen) = button.ui(ui, |ui| {
        let mut chosen = None;
        for (number, step) in lesson.steps.iter().enumerate() {
            let mark = if record.is_done(lesson, number) { "✓" } else { "○" };
            let title = format!("{mark} {}. {}", number + 1, step.title);
            if ui.selectable_label(number == record.step, title).clicked() {
                chosen = Some(Chosen::Step(number));
                ui.close();
            }
        }
        ui.separator();
        if !*asked {
            *asked = ui.button("Forget my answers …").clicked();
        } else if ui.button("All answers to this lesson are lost: forget them").clicked() {
            (chosen, *asked) = (Some(Chosen::Again), false);
            ui.close();
        }
        chosen
    });
    response.accessible_name(text);
    match chosen {
        Some(chosen) => chosen.inner,
        None => {
            // Whoever has closed the menu since has thought better of it.
            *asked = false;
            None
        }
    }
}
