//! The line for a first visit: nothing to read first, and three ways to begin.

use egui::{Button, Frame, Margin, Panel, Ui};

use super::App;
use crate::scenario::link::LessonPlace;
use crate::ui::theme::Palette;

/// The lesson that the riddles are in.
const RIDDLES: &str = "hangar";

impl App {
    /// Puts the line on screen: nobody has been here before.
    pub fn greet(&mut self) {
        self.panes.greets = true;
    }

    /// Whether the line is on screen. Once it was dismissed it is for ever.
    pub fn greets(&self) -> bool {
        self.panes.greets
    }

    pub(super) fn greeting_ui(&mut self, ui: &mut Ui) {
        // Whoever comes by a link to a lesson has begun.
        if !self.panes.greets || self.has_lesson() {
            return;
        }
        let ground = Frame::new().fill(Palette::of(ui).good_ground).inner_margin(Margin::symmetric(14, 7));
        Panel::top("greeting").frame(ground).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label("New here? Start with a question.");
                let course = ui
                    .button("The course")
                    .on_hover_text("From which way is z to mending a matrix")
                    .clicked();
                let riddle = ui.button("A riddle").on_hover_text("A goal, some sliders, and you").clicked();
                let workbench = ui
                    .add(Button::new("The workbench"))
                    .on_hover_text("Everything on this page, without a lesson")
                    .clicked();
                self.panes.lessons |= course;
                if riddle {
                    self.want_lesson(LessonPlace { address: RIDDLES.to_owned(), step: 0, begins: true });
                }
                if course || riddle || workbench {
                    self.panes.greets = false;
                    ui.request_repaint();
                }
            });
        });
    }
}
