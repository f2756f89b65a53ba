//! The lesson that is open beside the scene, and what it does to the scene.

use egui::{Button, RichText, ScrollArea, Ui};

use super::App;
use super::course::{CourseState, FileRequest, LessonPane};
use crate::scenario::link::LessonPlace;
use crate::scenario::{Part, Stage};
use crate::ui::curtain::Curtain;
use crate::ui::finger;
use crate::ui::lesson::{Chosen, Offer, Session, Wish, lesson_ui, lessons_sheet_ui, references_sheet_ui};
use crate::ui::theme::{self, Palette};

impl App {
    /// The sheet of lessons or that of references, where it is open.
    pub(super) fn lessons_ui(&mut self, ui: &Ui) {
        // Whatever has asked for it.
        self.panes.lessons &= !self.is_kept();
        if self.panes.references
            && let Some(course) = self.course()
        {
            self.panes.references = references_sheet_ui(ui, &course.shelf, &self.aircraft);
        }
        if !self.panes.lessons {
            return;
        }
        let course = self.course();
        let offer = match (&course, &self.panes.course) {
            (Some(course), _) => Offer::Course(course),
            (None, CourseState::Missing(reason)) => Offer::Missing(reason),
            (None, _) => Offer::Coming,
        };
        let person = self.records.person.clone();
        let (chosen, wanted) = lessons_sheet_ui(ui, &offer, &mut self.records, self.panes.has_files);
        self.records_changed |= self.records.person != person;
        self.panes.lessons = wanted && chosen.is_none();
        match chosen {
            Some(Chosen::Lesson(key)) => {
                self.want_lesson(LessonPlace { address: key, step: 0, begins: true });
            }
            Some(Chosen::File) => self.panes.file_requests.push(FileRequest::Pick),
            Some(Chosen::Links) => {
                self.panes.deck.get_or_insert_default();
            }
            Some(Chosen::References) => self.panes.references = true,
            Some(Chosen::Report) => self.save_report(),
            Some(Chosen::Again) => {
                self.panes.course = CourseState::Unwanted;
                self.panes.lessons = true;
            }
            None => return,
        }
        ui.request_repaint();
    }

    /// Whether the pane of a lesson is on screen.
    pub(super) fn has_lesson(&self) -> bool {
        !matches!(self.panes.lesson, LessonPane::Closed)
    }

    /// Where the person is in a lesson; in one that is on this device only where that counts.
    pub(super) fn lesson_place(&self, with_own: bool) -> Option<LessonPlace> {
        match &self.panes.lesson {
            LessonPane::Open(session) => (with_own || !session.is_own()).then(|| session.place()),
            LessonPane::Coming { place, .. } => Some(place.clone()),
            LessonPane::Closed | LessonPane::Faulty(_) => None,
        }
    }

    /// The lesson that is open.
    pub(super) fn session(&self) -> Option<&Session> {
        match &self.panes.lesson {
            LessonPane::Open(session) => Some(session),
            _ => None,
        }
    }

    /// Whether the sliders are on the page: where a task waits for a question, they come with it.
    pub(super) fn has_sliders(&self) -> bool {
        self.view.stage.has(Part::Derivatives) && !self.session().is_some_and(Session::holds_task_back)
    }

    /// The pane of the lesson.
    pub(super) fn lesson_ui(&mut self, ui: &mut Ui) {
        let area = ScrollArea::vertical().auto_shrink(false);
        finger::scroll_area_ui(ui, "lesson", area, |ui| self.step_ui(ui));
    }

    /// The same without a scroll area of its own.
    pub(super) fn step_ui(&mut self, ui: &mut Ui) {
        let wish = match &mut self.panes.lesson {
            LessonPane::Closed => None,
            LessonPane::Coming { .. } => {
                ui.label("The lesson is on its way.");
                None
            }
            LessonPane::Open(session) => {
                lesson_ui(ui, session, &self.records.person, &self.findings, &self.aircraft)
            }
            LessonPane::Faulty(sentences) => faults_ui(ui, sentences),
        };
        match wish {
            Some(Wish::Step) => self.open_step(),
            Some(Wish::Set(scenario)) => self.scenario = *scenario,
            Some(Wish::Scene(link)) => self.open_scene(&link),
            Some(Wish::Lesson(address)) => {
                self.want_lesson(LessonPlace { address, step: 0, begins: true });
            }
            Some(Wish::Present) => self.view.presents = true,
            Some(Wish::Person(person)) => self.take_person(person),
            Some(Wish::HandIn(place)) => {
                let session = self.session();
                let link = session.and_then(|session| session.handed_in(place, &self.records.person));
                if let Some(link) = link {
                    self.share.copy(ui, &link, false);
                }
            }
            Some(Wish::Lessons) => self.panes.lessons = true,
            Some(Wish::Close) => self.close_lesson(),
            None => return,
        }
        ui.request_repaint();
    }

    /// Takes the name that was asked for, with the numbers that follow from it.
    fn take_person(&mut self, person: String) {
        if let LessonPane::Open(session) = &mut self.panes.lesson
            && session.take_name(&person, &self.aircraft)
        {
            self.open_step();
        }
        self.records.person = person;
        self.records_changed = true;
    }

    /// Closes the lesson; its stage goes with it.
    pub(super) fn close_lesson(&mut self) {
        self.panes.lesson = LessonPane::Closed;
        self.view.stage = Stage::default();
    }

    /// Opens the scene of the step, with the sliders that its task offers.
    pub(super) fn open_step(&mut self) {
        let Some(session) = self.session() else { return };
        let (link, offered) = (session.link().to_owned(), session.offered());
        let presents = self.view.presents;
        self.open(&link);
        self.view.presents |= presents;
        if self.view.stage.offered.is_empty() {
            self.view.stage.offered = offered;
        }
    }

    pub(super) fn open_scene(&mut self, link: &str) {
        let (stage, presents) = (self.view.stage.clone(), self.view.presents);
        self.open(link);
        self.view.presents |= presents;
        if self.view.stage == Stage::default() {
            // A scene within a step leaves the sliders that are offered.
            self.view.stage = stage;
        }
    }
}

/// Why a lesson can't be opened, where it would stand.
fn faults_ui(ui: &mut Ui, sentences: &[String]) -> Option<Wish> {
    let palette = Palette::of(ui);
    let title = RichText::new("This lesson can’t be opened").font(theme::semibold(theme::sizes(ui).card));
    theme::heading(ui, title, 2);
    for sentence in sentences {
        ui.label(RichText::new(format!("⚠ {sentence}")).color(palette.bad));
    }
    if Curtain::of(ui).keeps() {
        return None;
    }
    ui.add_space(8.0);
    ui.add(Button::new("Close")).accessible_name("Close the lesson").clicked().then_some(Wish::Close)
}
