//! The course on the page: fetched when it is wanted, with the lesson that a link names, and files that a person opens.

use std::rc::Rc;

use egui::Ui;

use super::{App, OwnFile, PhonePane};
use crate::content::{ContentError, TextFile, lessons};
use crate::lesson::{Course, Record};
use crate::scenario::link::LessonPlace;
use crate::ui::lesson::Session;
use crate::words;

/// The course as far as it is there.
#[derive(Debug, Default)]
pub(super) enum CourseState {
    /// Nobody has wanted it yet.
    #[default]
    Unwanted,
    /// It has been asked for.
    Coming,
    Here(Rc<Course>),
    /// Why it can't be had.
    Missing(String),
}

/// What stands in the pane of the lesson.
#[derive(Debug, Default)]
pub(super) enum LessonPane {
    #[default]
    Closed,
    /// The lesson of a place is on its way; whether its file has been asked for.
    Coming {
        place: LessonPlace,
        is_asked: bool,
    },
    Open(Box<Session>),
    /// Why it can't be opened, each a sentence.
    Faulty(Vec<String>),
}

/// Files that the page wants and can't read itself: whoever holds the page does, and gives them to [`App::receive`].
#[derive(Clone, Debug)]
pub enum FileRequest {
    /// Those of the course, by their names in [`lessons::NAMES`].
    Course,
    /// A lesson at a path below the page's folder, with the glossary and the references beside it, if there are any.
    Lesson(String),
    /// Those that a person chooses.
    Pick,
    /// This one is to be saved.
    Save(TextFile),
    /// A figure is to become a picture (PNG), saved or copied.
    Picture {
        /// The figure.
        svg: TextFile,
        /// Whether it is copied.
        copies: bool,
    },
    /// A page is to be printed.
    Print(String),
    /// Those that a person has dropped on the page.
    #[cfg(target_arch = "wasm32")]
    Dropped(Vec<egui::DroppedFileHandle>),
}

impl App {
    /// Says that files can be chosen and saved. They can always be dropped on the page.
    pub fn offer_files(&mut self) {
        self.panes.has_files = true;
    }

    /// Says that figures can become pictures, and that pages can be printed.
    pub fn offer_pictures(&mut self) {
        self.panes.has_pictures = true;
    }

    /// What is to be read for the page next.
    pub fn take_file_request(&mut self) -> Option<FileRequest> {
        self.panes.file_requests.pop()
    }

    /// Takes the files that were asked for, or why they can't be had.
    pub fn receive(&mut self, request: &FileRequest, files: Result<Vec<TextFile>, String>) {
        match (request, files) {
            (FileRequest::Course, Ok(files)) => {
                self.panes.course = CourseState::Here(Rc::new(Course::read(&files)));
            }
            (FileRequest::Course, Err(reason)) => {
                if matches!(self.panes.lesson, LessonPane::Coming { .. }) {
                    self.panes.lesson = LessonPane::Faulty(vec![reason.clone()]);
                }
                self.panes.course = CourseState::Missing(reason);
            }
            (FileRequest::Lesson(path), Ok(files)) => {
                let place = match &self.panes.lesson {
                    LessonPane::Coming { place, .. } if place.address == *path => place.clone(),
                    // Something else has been opened since.
                    _ => return,
                };
                self.open_own(&files, place, false);
            }
            (_, Err(reason)) => self.panes.lesson = LessonPane::Faulty(vec![reason]),
            (_, Ok(files)) => self.open_files(&files),
        }
    }

    /// Opens what a person has chosen or dropped: lessons, reports and lists of links as [`Self::open_files`] does, all else as an
    /// aircraft of their own.
    pub fn open_own_files(&mut self, files: Result<Vec<OwnFile>, String>) {
        let files = match files {
            Ok(files) if files.is_empty() => return,
            Ok(files) => files,
            Err(problem) => return self.refuse_file(problem),
        };
        if !files.iter().any(is_of_lessons) {
            return self.review_files(files);
        }
        self.panes.import = None;
        let texts: Result<Vec<TextFile>, _> =
            files.iter().map(|file| TextFile::from_bytes(&file.name, &file.bytes)).collect();
        match texts {
            Ok(texts) => self.open_files(&texts),
            Err(error) => {
                self.panes.lesson = LessonPane::Faulty(vec![format!("{error}.")]);
                self.panes.phone_pane = PhonePane::Lesson;
            }
        }
    }

    /// Opens what a person has brought: a lesson, with its glossary and references where they come along, or a report of what they
    /// have done elsewhere.
    pub fn open_files(&mut self, files: &[TextFile]) {
        self.panes.lessons = false;
        if let Some(lesson) = files.iter().find(|file| file.name.ends_with(".md")) {
            let address = LessonPlace::address_of(&lesson.name);
            return self.open_own(files, LessonPlace { address, step: 0, begins: true }, true);
        }
        let links =
            files.iter().find(|file| file.name.to_lowercase().ends_with(".txt") && file.text.contains('#'));
        if let Some(links) = links {
            return self.open_links(&links.text);
        }
        let is_report = |file: &&TextFile| file.name.ends_with(".html") || file.name.ends_with(".json");
        match files.iter().find(is_report) {
            Some(report) => self.take_up_report(report),
            None => {
                let names: Vec<String> = files.iter().map(|file| format!("“{}”", file.name)).collect();
                let sentence = format!(
                    "{}: expected a lesson, a file that ends with .md, or a report, which ends with .html.",
                    names.join(", ")
                );
                self.panes.lesson = LessonPane::Faulty(vec![sentence]);
            }
        }
        self.panes.phone_pane = PhonePane::Lesson;
    }

    /// Opens the lesson of these files; what is wrong with them is said where it would stand. Those that nobody else has are kept
    /// with what is done in it.
    pub(super) fn open_own(&mut self, files: &[TextFile], place: LessonPlace, keeps: bool) {
        let course = Course::read(files);
        let course = match self.course() {
            Some(shipped) => course.with_shelf(&shipped.shelf),
            None => course,
        };
        match course.lessons.first() {
            Some(_) if course.errors.is_empty() => {
                let record = self.records.lessons.entry(place.address.clone()).or_default();
                record.files = if keeps { files.to_vec() } else { Vec::new() };
                self.begin_lesson(&course, 0, place);
            }
            _ => self.panes.lesson = LessonPane::Faulty(sentences(&course.errors)),
        }
        self.panes.phone_pane = PhonePane::Lesson;
    }

    /// Opens a lesson of the course, or a file below the page's folder.
    pub(super) fn want_lesson(&mut self, place: LessonPlace) {
        self.panes.lesson = LessonPane::Coming { place, is_asked: false };
        self.panes.phone_pane = PhonePane::Lesson;
    }

    /// The course, if it is here; asks for it once.
    pub(super) fn course(&mut self) -> Option<Rc<Course>> {
        if matches!(self.panes.course, CourseState::Unwanted) {
            self.panes.course = match lessons::built_in() {
                Some(files) => CourseState::Here(Rc::new(Course::read(&files))),
                None => {
                    self.panes.file_requests.push(FileRequest::Course);
                    CourseState::Coming
                }
            };
        }
        match &self.panes.course {
            CourseState::Here(course) => Some(course.clone()),
            _ => None,
        }
    }

    /// Opens the lesson that is wanted once it is here, and what was dropped on the page.
    pub(super) fn attend_lesson(&mut self, ui: &Ui) {
        self.take_dropped(ui);
        if let LessonPane::Open(session) = &mut self.panes.lesson {
            session.tell_as(&self.scenario);
        }
        let LessonPane::Coming { place, is_asked: false } = &self.panes.lesson else { return };
        let place = place.clone();
        let Some(course) = self.course() else { return };
        if let Some((index, _)) = course.find(&place.address) {
            self.begin_lesson(&course, index, place);
        } else if let Some(files) = self.own_files(&place.address) {
            self.open_own(&files, place, true);
        } else if place.address.ends_with(".md") {
            self.panes.file_requests.push(FileRequest::Lesson(place.address.clone()));
            self.panes.lesson = LessonPane::Coming { place, is_asked: true };
        } else {
            let sentence = format!("There is no lesson “{}”.", place.address);
            self.panes.lesson = LessonPane::Faulty(vec![sentence]);
        }
    }

    /// What was dropped on the page. A browser reads files in its own time.
    fn take_dropped(&mut self, ui: &Ui) {
        let dropped = ui.input(|input| input.raw.dropped_files.clone());
        if dropped.is_empty() {
            return;
        }
        if self.is_kept() {
            self.share.show(ui, words::view::KEPT);
            return;
        }
        #[cfg(target_arch = "wasm32")]
        self.panes.file_requests.push(FileRequest::Dropped(dropped));
        #[cfg(not(target_arch = "wasm32"))]
        {
            let read = |file: &egui::DroppedFileHandle| {
                let name = file.path().file_name().unwrap_or_default().to_string_lossy().into_owned();
                Ok(OwnFile { name, bytes: file.bytes()? })
            };
            let files = dropped.iter().map(read).collect();
            self.open_own_files(files);
        }
    }

    /// The files of a lesson that were brought to this device.
    fn own_files(&self, address: &str) -> Option<Vec<TextFile>> {
        self.records.lessons.get(address).map(|record| record.files.clone()).filter(|files| !files.is_empty())
    }

    fn begin_lesson(&mut self, course: &Course, index: usize, mut place: LessonPlace) {
        let Some(lesson) = course.lessons.get(index) else { return };
        let mut before = self.records.lessons.get(&place.address).cloned().unwrap_or_default();
        if !before.title.is_empty() && before.title != lesson.title {
            // Another lesson in a file of the same name: what was answered in the old one says nothing here.
            before = Record { files: before.files, ..Record::default() };
        }
        if before.seed.is_empty() && lesson.varies() {
            before.seed = self.records.person.clone();
        }
        let begins = place.begins;
        let (done, count) = before.done(lesson);
        if begins && place.step == 0 && done < count {
            // Where the person left it.
            place.step = before.step;
        }
        match Session::open(lesson.clone(), course.shelf.clone(), place, before, &self.aircraft) {
            Ok(session) => {
                self.panes.lesson = LessonPane::Open(Box::new(session));
                if begins {
                    self.open_step();
                }
            }
            Err(error) => self.panes.lesson = LessonPane::Faulty(sentences(&[error])),
        }
    }
}

/// Whether a file is a lesson, a report or a list of links, by its name and its first words.
fn is_of_lessons(file: &OwnFile) -> bool {
    let name = file.name.to_lowercase();
    let holds = |words: &str| file.bytes.windows(words.len()).any(|part| part == words.as_bytes());
    name.ends_with(".md")
        || name.ends_with(".html")
        || name.ends_with(".txt") && (holds("#v=") || holds("ac="))
        || name.ends_with(".json") && holds("\"lessons\"")
}

fn sentences(errors: &[ContentError]) -> Vec<String> {
    errors.iter().map(ToString::to_string).collect()
}
