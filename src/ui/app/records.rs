//! What the person has done in their lessons: followed as they do it, saved as a report, taken up from one.

use egui::Ui;

use super::App;
use super::course::{CourseState, FileRequest, LessonPane};
use crate::content::TextFile;
use crate::export::ReportSource;
use crate::lesson::{Course, Records};
use crate::words;

/// Name of the file of a report.
const REPORT: &str = "eigenwing-report.html";

impl App {
    /// Takes up what was done on this device before, or in another tab, in the lesson that is open too, where `known` was kept when this
    /// page last read or wrote it. Says whether something was done here that isn't there. What can't be read is left out: it was
    /// damaged outside this page.
    pub fn take_up_records(&mut self, json: &str, known: &str) -> bool {
        let Ok(others) = Records::read(json) else { return true };
        self.records.join(others.clone(), &Records::read(known).unwrap_or_default());
        let adds = self.records.adds_to(&others);
        // A lecture does so when it is over.
        if !self.view.presents {
            self.join_lesson(&others);
        }
        adds
    }

    /// Has the lesson that is open take over what was done in it elsewhere.
    pub(super) fn join_lesson(&mut self, others: &Records) {
        let LessonPane::Open(session) = &mut self.panes.lesson else { return };
        let record = others.lessons.get(session.address()).cloned();
        if record.is_some_and(|record| session.join(record, &self.aircraft)) {
            self.open_step();
        }
    }

    /// Takes up what was done elsewhere, with which a lesson that is open goes on.
    pub fn go_on_with(&mut self, records: Records) {
        let place = self.lesson_place(true);
        self.records.complete(records);
        self.records_changed = true;
        if let Some(place) = place {
            self.want_lesson(place);
        }
    }

    /// What has been done, as JSON, where it has changed since it was last asked for.
    pub fn take_changed_records(&mut self) -> Option<String> {
        std::mem::take(&mut self.records_changed).then(|| self.records_as_json())
    }

    /// What has been done, as JSON.
    pub fn records_as_json(&self) -> String {
        self.records.to_json()
    }

    /// Follows the lesson that is open, at the end of a frame; never while something is dragged.
    pub(super) fn keep_record(&mut self, ui: &Ui) {
        // Nothing of a lecture is what the person has done.
        if self.view.presents || ui.input(|input| input.pointer.any_down()) {
            return;
        }
        // What is drawn again has findings of what was before.
        if !self.is_found() {
            return;
        }
        // Taken out, so that the scene can be asked for.
        let mut pane = std::mem::take(&mut self.panes.lesson);
        let mut is_reached = false;
        if let LessonPane::Open(session) = &mut pane {
            is_reached =
                session.keep_scene(&self.findings, &self.aircraft, || self.link_of_scene(&self.view));
            if self.records.lessons.get(session.address()) != Some(session.record()) {
                self.records.lessons.insert(session.address().to_owned(), session.record().clone());
                self.records_changed = true;
            }
        }
        self.panes.lesson = pane;
        if is_reached {
            self.share.show(ui, words::view::REACHED);
        }
    }

    /// Has the report saved.
    pub(super) fn save_report(&mut self) {
        let none = Course::default();
        let course = match &self.panes.course {
            CourseState::Here(course) => course.as_ref(),
            CourseState::Unwanted | CourseState::Coming | CourseState::Missing(_) => &none,
        };
        let source = ReportSource { course, aircraft: &self.aircraft, address: &self.share.address };
        let report = TextFile::new(REPORT, &self.records.report(source));
        self.panes.file_requests.push(FileRequest::Save(report));
    }

    /// Takes up a report of what was done elsewhere, and says so where a lesson would stand.
    pub(super) fn take_up_report(&mut self, file: &TextFile) {
        match Records::read(&file.text) {
            Ok(records) => {
                self.records.complete(records);
                self.records_changed = true;
                self.close_lesson();
                self.panes.lessons = true;
            }
            Err(error) => {
                let sentence = format!("“{}” is no report of a lesson: {error}.", file.name);
                self.panes.lesson = LessonPane::Faulty(vec![sentence]);
            }
        }
    }
}
