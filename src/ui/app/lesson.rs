//! The lesson that is open beside the scene, and what it does to the scene.

use egui::{ScrollArea, Ui};

use super::{App, PhonePane};
use crate::scenario::Stage;
use crate::ui::finger;
use crate::ui::lesson::{Session, Wish, lesson_ui, lessons_sheet_ui};

impl App {
    /// The sheet of lessons, where it is open.
    pub(super) fn lessons_ui(&mut self, ui: &Ui) {
        if !self.panes.lessons {
            return;
        }
        let (chosen, wanted) = lessons_sheet_ui(ui);
        self.panes.lessons = wanted;
        let session = chosen.and_then(|file| Session::open(file, &self.aircraft));
        match session {
            Some(Ok(session)) => {
                self.panes.lesson = Some(session);
                self.panes.phone_pane = PhonePane::Lesson;
                self.open_step();
                ui.request_repaint();
            }
            Some(Err(error)) => self.content_errors.push(error),
            None => {}
        }
    }

    /// Whether a lesson is open.
    pub(super) fn has_lesson(&self) -> bool {
        self.panes.lesson.is_some()
    }

    /// The step of the lesson that is open.
    pub(super) fn lesson_ui(&mut self, ui: &mut Ui) {
        let area = ScrollArea::vertical().auto_shrink(false);
        finger::scroll_area_ui(ui, "lesson", area, |ui| self.step_ui(ui));
    }

    /// The same without a scroll area of its own.
    pub(super) fn step_ui(&mut self, ui: &mut Ui) {
        let Some(session) = &mut self.panes.lesson else { return };
        match lesson_ui(ui, session, &self.findings, &self.aircraft) {
            Some(Wish::Step) => self.open_step(),
            Some(Wish::Scene(link)) => self.open_scene(&link),
            Some(Wish::Close) => {
                self.panes.lesson = None;
                self.view.stage = Stage::default();
            }
            None => return,
        }
        ui.request_repaint();
    }

    /// Opens the scene of the step, with the sliders that its task offers.
    fn open_step(&mut self) {
        let Some(session) = &self.panes.lesson else { return };
        let (link, offered) = (session.link().to_owned(), session.offered());
        self.open(&link);
        if self.view.stage.offered.is_empty() {
            self.view.stage.offered = offered;
        }
    }

    fn open_scene(&mut self, link: &str) {
        let stage = self.view.stage.clone();
        self.open(link);
        if self.view.stage == Stage::default() {
            // A scene within a step leaves the sliders that are offered.
            self.view.stage = stage;
        }
    }
}
