//! The sheet that offers the lessons of the course.

use std::rc::Rc;

use egui::{Frame, Id, Modal, RichText, ScrollArea, TextEdit, Ui};

use crate::lesson::{Course, Lesson, Records, said};
use crate::ui::finger;
use crate::ui::theme::{self, Palette};

/// What can be offered.
#[derive(Clone, Copy, Debug)]
pub enum Offer<'a> {
    /// The course is on its way.
    Coming,
    /// The course can't be had, and why.
    Missing(&'a str),
    /// The course.
    Course(&'a Course),
}

/// What a person chose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Chosen {
    /// A lesson, by its key.
    Lesson(String),
    /// A file of their own.
    File,
    /// To ask for the course once more.
    Again,
    /// To make a lecture of links.
    Links,
    /// To see the references.
    References,
    /// To save the report.
    Report,
}

/// Draws the sheet. Gives what was chosen, and whether the sheet is still wanted.
pub fn lessons_sheet_ui(
    ui: &Ui,
    offer: &Offer<'_>,
    records: &mut Records,
    has_files: bool,
) -> (Option<Chosen>, bool) {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let mut chosen = None;
    let modal = Modal::new(Id::unique("lessons")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(460.0));
        theme::heading(ui, RichText::new("Lessons").heading().size(theme::sizes(ui).sheet), 2);
        ui.label("New here? Each begins with a question, and answers it on this page.");
        match offer {
            Offer::Coming => {
                ui.add_space(8.0);
                ui.label("They are on their way.");
            }
            Offer::Missing(reason) => {
                ui.add_space(8.0);
                ui.label(RichText::new(format!("⚠ {reason}")).color(Palette::of(ui).bad));
                if ui.button("Try again").clicked() {
                    chosen = Some(Chosen::Again);
                }
            }
            Offer::Course(course) => {
                let room = ui.content_rect().height() - 300.0;
                let area = ScrollArea::vertical().max_height(room.max(160.0));
                let list = |ui: &mut Ui| course_ui(ui, course, records);
                chosen = finger::scroll_area_ui(ui, "lessons", area, list);
            }
        }
        ui.add_space(8.0);
        if has_files && !records.lessons.is_empty() {
            ui.horizontal_wrapped(|ui| {
                let name =
                    TextEdit::singleline(&mut records.person).hint_text("Your name").desired_width(150.0);
                ui.add(name).accessible_name("Your name, for the report");
                if ui.button("Save my report").on_hover_text(REPORT).clicked() {
                    chosen = Some(Chosen::Report);
                }
            });
            ui.add_space(8.0);
        }
        ui.label(
            RichText::new("A lesson of your own, or a report, can be dropped on this page.")
                .font(theme::small()),
        );
        ui.horizontal_wrapped(|ui| {
            if has_files && ui.button("Open a file …").clicked() {
                chosen = Some(Chosen::File);
            }
            if ui.button("A lecture from links …").clicked() {
                chosen = Some(Chosen::Links);
            }
            if matches!(offer, Offer::Course(_)) && ui.button("References").clicked() {
                chosen = Some(Chosen::References);
            }
            ui.button("Go on without a lesson").clicked()
        })
        .inner
    });
    (chosen, !modal.inner && !modal.should_close())
}

/// What a report is.
const REPORT: &str = "A page to print or hand in: what you predicted, what happened, and the scenes of your tasks. \
    Nothing leaves this device unless you send it. Drop it on this page to go on with it elsewhere.";

fn course_ui(ui: &mut Ui, course: &Course, records: &Records) -> Option<Chosen> {
    let lessons = course.lessons.iter().filter(|lesson| !lesson.lecture);
    let mut lectures = course.lessons.iter().filter(|lesson| lesson.lecture).peekable();
    let mut chosen = list_ui(ui, lessons, records);
    if lectures.peek().is_some() {
        ui.add_space(12.0);
        theme::heading(ui, RichText::new("Lectures").font(theme::semibold(theme::sizes(ui).card)), 3);
        ui.label(RichText::new("To be presented to a room.").font(theme::small()));
        chosen = list_ui(ui, lectures, records).or(chosen);
    }
    for error in &course.errors {
        ui.label(RichText::new(format!("⚠ {error}")).color(Palette::of(ui).bad));
    }
    chosen
}

fn list_ui<'l>(
    ui: &mut Ui,
    lessons: impl Iterator<Item = &'l Rc<Lesson>>,
    records: &Records,
) -> Option<Chosen> {
    let mut chosen = None;
    for lesson in lessons {
        ui.add_space(8.0);
        let title = RichText::new(&lesson.title).font(theme::semibold(theme::sizes(ui).value));
        if ui.button(title).clicked() {
            chosen = Some(Chosen::Lesson(lesson.key().to_owned()));
        }
        let about = lesson.about.as_deref().unwrap_or_default();
        let done = records.lessons.get(lesson.key()).map(|record| record.done(lesson));
        let about = match done {
            // Nobody answers a lecture.
            _ if lesson.lecture => match lesson.minutes() {
                Some(minutes) => format!("{} · {about}", said::minutes(minutes)),
                None => about.to_owned(),
            },
            Some((done, count)) if done == count => format!("✓ done · {about}"),
            Some((done, count)) => format!("{done} of {count} steps done · {about}"),
            None => about.to_owned(),
        };
        ui.label(RichText::new(about).font(theme::small()));
    }
    chosen
}
