//! A lesson beside the scene: one step at a time, which asks before it shows.
//!
//! | file | in one line |
//! |---|---|
//! | `text` | running text: paragraphs, lists, tables |
//! | `word` | a word that leads somewhere |
//! | `formula` | a formula, set |
//! | `question` | a question, its answer, and what is said of it |
//! | `choose`, `estimate`, `order` | statements, a number, an order |
//! | `place`, `sketch` | a pole and a curve, put and drawn on a `pad` |
//! | `task` | a goal, hints and tries |
//! | `way` | how near a measure is, as a bar |
//! | `solution` | a solution played slider by slider |
//! | `person` | the name that is asked for |
//! | `write` | something to write |
//! | `map`, `sheet` | the steps of the lesson, and the lessons |

mod choose;
mod estimate;
pub(super) mod formula;
mod map;
mod order;
mod pad;
mod person;
mod place;
mod question;
mod references;
mod sheet;
mod sketch;
mod solution;
mod task;
mod text;
mod way;
mod word;
mod write;

use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

use egui::{Button, Frame, RichText, Ui};

use super::curtain::Curtain;
use super::theme::{self, Palette};
use crate::content::{Aircraft, ContentError};
use crate::findings::Findings;
use crate::lesson::{Answer, Lesson, Part, Place, Record, Shelf, Step};
use crate::scenario::Scenario;
use crate::scenario::link::{HandedIn, LessonPlace};
use person::person_ui;
use question::{Asked, question_ui};
pub use references::references_sheet_ui;
pub use sheet::{Chosen, Offer, lessons_sheet_ui};
use task::{Tried, task_ui};
use text::text_ui;
use write::write_ui;

/// A lesson that is open: where the person is in it, and what they have answered.
#[derive(Debug)]
pub struct Session {
    /// Where it was opened from: the key of a lesson that ships, the path or the name of a file.
    address: String,
    lesson: Rc<Lesson>,
    shelf: Rc<Shelf>,
    /// What has been done in it, and where the person is.
    record: Record,
    /// The scene of the step as it was at its start.
    start: Rc<Findings>,
    /// Questions that have been on screen.
    asked: BTreeMap<Place, Asked>,
    /// Tasks that have been on screen.
    tried: BTreeMap<Place, Tried>,
    /// The name of the person, as far as it is typed where it is asked for.
    typed: String,
    /// Whether they have asked once to begin again.
    asks_to_forget: bool,
}

/// What a person asks for in the pane of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// Study this, seen as before.
    Set(Box<Scenario>),
    /// Open a scene.
    Scene(String),
    /// Open another lesson of the course, by its key.
    Lesson(String),
    /// Open the scene of the step.
    Step,
    /// Be known by this name or number.
    Person(String),
    /// Copy the link of a task that is reached, to hand it in.
    HandIn(Place),
    /// See the other lessons, and the report.
    Lessons,
    /// Fill the screen with the step.
    Present,
    /// Close the lesson.
    Close,
}

impl Session {
    /// A lesson at the step of a place, or at its last if it has fewer, with what was done in it before; what doesn't fit it any
    /// more is left out.
    pub fn open(
        lesson: Rc<Lesson>,
        shelf: Rc<Shelf>,
        place: LessonPlace,
        before: Record,
        aircraft: &[Arc<Aircraft>],
    ) -> Result<Self, ContentError> {
        let lesson = if before.seed.is_empty() { lesson } else { Rc::new(lesson.of_person(&before.seed)) };
        let step = place.step.min(lesson.steps.len().saturating_sub(1));
        let start = Rc::new(start_of(&lesson.file, lesson.steps.get(step), aircraft)?);
        let record = Record { title: lesson.title.clone(), step, ..before };
        let (asked, tried) = (BTreeMap::new(), BTreeMap::new());
        let typed = String::new();
        let mut session = Self {
            address: place.address,
            lesson,
            shelf,
            record,
            start,
            asked,
            tried,
            typed,
            asks_to_forget: false,
        };
        session.fit_record();
        Ok(session)
    }

    /// Takes over what was done in it on another page of this device. Says whether the scene of the step is another by it.
    pub fn join(&mut self, others: Record, aircraft: &[Arc<Aircraft>]) -> bool {
        let is_other = !others.seed.is_empty() && self.take_name(&others.seed, aircraft);
        let before = self.record.begun_again;
        self.record.join(others);
        if self.record.begun_again != before {
            (self.asked, self.tried) = Default::default();
        }
        self.fit_record();
        is_other
    }

    /// Leaves out of the record what doesn't fit the lesson.
    fn fit_record(&mut self) {
        let count = self.lesson.steps.len();
        self.record.version.clone_from(&self.lesson.version);
        self.record.answers = std::mem::take(&mut self.record.answers).fitting(&self.lesson);
        self.record.seen.retain(|step| *step < count);
        self.record.seen.insert(self.record.step);
    }

    /// Whether the step has numbers of each person's own and waits for their name.
    pub fn waits_for_name(&self) -> bool {
        self.record.seed.is_empty() && self.current().is_some_and(|step| !step.vary.is_empty())
    }

    /// Takes the name from which varied numbers follow. Says whether the scene of the step is another by it.
    pub fn take_name(&mut self, person: &str, aircraft: &[Arc<Aircraft>]) -> bool {
        let waited = self.waits_for_name();
        if self.record.seed.is_empty() && self.lesson.varies() {
            self.record.seed = person.to_owned();
            self.lesson = Rc::new(self.lesson.of_person(person));
            if let Ok(start) = start_of(&self.lesson.file, self.current(), aircraft) {
                self.start = Rc::new(start);
            }
        }
        waited
    }

    /// The pieces of a link by which a task is handed in, after those of a scene, with the scene that reached its goal.
    pub fn handed_in(&self, place: Place, by: &str) -> Option<String> {
        let given = self.record.answers.get(place)?;
        let handed_in =
            HandedIn { by: by.to_owned(), hints: given.hints, solution_shown: given.solution_shown };
        let scene = self.record.scenes.get(&place)?;
        Some(format!("{scene}{}{}", self.place().in_link(), handed_in.in_link()))
    }

    /// Where the person is.
    pub fn place(&self) -> LessonPlace {
        LessonPlace { address: self.address.clone(), step: self.record.step, begins: false }
    }

    /// Where it was opened from.
    pub fn address(&self) -> &str {
        &self.address
    }

    /// Tells its numbers as a scene shows them.
    pub fn tell_as(&mut self, scene: &Scenario) {
        let start = self.start.scenario();
        let told = start.clone().shown_as(scene);
        if *start != told {
            self.start = Rc::new(Findings::of(told));
        }
    }

    /// Whether its file is on this device only.
    pub fn is_own(&self) -> bool {
        !self.record.files.is_empty()
    }

    /// Its steps.
    pub fn steps(&self) -> &[Step] {
        &self.lesson.steps
    }

    /// The step that the person is at.
    pub fn step(&self) -> Option<&Step> {
        self.current()
    }

    /// What follows from the scene of the step at its start.
    pub fn start(&self) -> &Findings {
        &self.start
    }

    /// What has been done in it.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// Keeps the scene of each task of the step: the last that met its goal, and until there is one the last that was tried. Whether one
    /// is reached now that wasn't: where the pane is drawn that is noted there, but on a phone another may be in its place.
    pub fn keep_scene(
        &mut self,
        now: &Findings,
        aircraft: &[Arc<Aircraft>],
        link: impl Fn() -> String,
    ) -> bool {
        self.tell_as(now.scenario());
        if now.scenario() == self.start.scenario() {
            return false;
        }
        let mut is_open = !self.waits_for_name();
        let mut is_new = false;
        let step = self.record.step;
        let parts = self.lesson.steps.get(step).map_or(&[][..], |step| &step.parts);
        for (part, what) in parts.iter().enumerate() {
            let place = Place { step, part };
            match what {
                Part::Prediction(_) => {
                    is_open &= self.record.answers.get(place).is_some_and(|given| given.is_final);
                }
                Part::Task(task) => {
                    let given = self.record.answers.at(place);
                    let is_met = task.is_met(&self.start, now, aircraft);
                    is_new |= is_open && is_met && !given.reached;
                    given.reached |= is_open && is_met;
                    if is_met || !given.reached {
                        self.record.scenes.insert(place, link());
                    }
                }
                Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => {}
            }
        }
        is_new
    }

    /// The link of the step's scene.
    pub fn link(&self) -> &str {
        self.current().map_or("", |step| &step.scene.link)
    }

    /// Keys of the sliders that the step's task offers; none where it offers all.
    pub fn offered(&self) -> Vec<&'static str> {
        let tasks = self.current().into_iter().flat_map(Step::tasks);
        tasks.flat_map(|task| task.offer.iter().map(|parameter| parameter.key)).collect()
    }

    /// Whether every question of the step has its answer, and there is one: then its scene hides nothing any more.
    pub fn is_revealed(&self) -> bool {
        let parts = self.current().into_iter().flat_map(|step| step.parts.iter().enumerate());
        let mut questions = parts.filter(|(_, part)| matches!(part, Part::Prediction(_))).peekable();
        questions.peek().is_some()
            && questions.all(|(part, _)| {
                self.record
                    .answers
                    .get(Place { step: self.record.step, part })
                    .is_some_and(|given| given.is_final)
            })
    }

    /// Whether a task of the step waits: its goal would often answer the question that stands before it, and so would its sliders.
    pub fn holds_task_back(&self) -> bool {
        let parts = self.current().into_iter().flat_map(|step| step.parts.iter().enumerate());
        let mut from_question = parts.skip_while(|(part, is)| {
            let place = Place { step: self.record.step, part: *part };
            !matches!(is, Part::Prediction(_))
                || self.record.answers.get(place).is_some_and(|given| given.is_final)
        });
        from_question.any(|(_, part)| matches!(part, Part::Task(_)))
    }

    /// Heading of the step.
    pub fn heading(&self) -> &str {
        self.current().map_or("", |step| &step.title)
    }

    /// How many steps are done, of those that there are.
    pub fn done(&self) -> (usize, usize) {
        self.record.done(&self.lesson)
    }

    /// Whether an answer to a question of the step is right; `None` where there is nothing to compare it with.
    pub fn is_right(&self, place: Place, answer: &Answer, aircraft: &[Arc<Aircraft>]) -> Option<bool> {
        let part = self.current().filter(|_| place.step == self.record.step)?.parts.get(place.part)?;
        let Part::Prediction(prediction) = part else { return None };
        let truth = prediction.truth(&self.start, aircraft)?;
        Some(truth.compare(&prediction.kind, answer).is_right())
    }

    fn current(&self) -> Option<&Step> {
        self.lesson.steps.get(self.record.step)
    }

    /// Puts back what had been done in it before, at the step where it is.
    pub fn forget(&mut self, before: Record) {
        let step = self.record.step;
        self.record = Record { step, ..before };
        self.record.seen.insert(step);
    }

    /// Begins again at the first step, without what was answered.
    fn begin_again(&mut self, aircraft: &[Arc<Aircraft>]) {
        self.record = self.record.begun_again();
        (self.asked, self.tried) = Default::default();
        self.go_to(0, aircraft);
    }

    /// Goes to another step. Says whether its scene is another.
    pub fn go_to(&mut self, step: usize, aircraft: &[Arc<Aircraft>]) -> bool {
        let before = (self.link().to_owned(), self.offered());
        self.record.step = step.min(self.lesson.steps.len().saturating_sub(1));
        self.record.seen.insert(self.record.step);
        let before_it = self.start.clone();
        if let Ok(start) = start_of(&self.lesson.file, self.current(), aircraft) {
            self.start = Rc::new(start);
        }
        self.tell_as(before_it.scenario());
        before != (self.link().to_owned(), self.offered())
    }
}

/// What follows from the scene of a step.
fn start_of(file: &str, step: Option<&Step>, aircraft: &[Arc<Aircraft>]) -> Result<Findings, ContentError> {
    let opened = step.and_then(|step| step.scene.open(aircraft));
    opened.map(|opened| Findings::of(opened.scenario)).ok_or_else(|| ContentError {
        file: file.to_owned(),
        line: step.map_or(1, |step| step.line),
        problem: "expected a step with a scene".to_owned(),
    })
}

/// Draws the step, and gives what the person asks for; `person` is their name, empty as long as it isn't known. `now` is what
/// follows from the scene on screen.
pub fn lesson_ui(
    ui: &mut Ui,
    session: &mut Session,
    person: &str,
    now: &Findings,
    aircraft: &[Arc<Aircraft>],
) -> Option<Wish> {
    let palette = Palette::of(ui);
    let mut wish = None;
    ui.horizontal(|ui| {
        let title = RichText::new(&session.lesson.title).font(theme::small()).color(palette.weak);
        ui.label(title);
        if Curtain::of(ui).keeps() {
            return;
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let close = Button::new(RichText::new("Close").font(theme::small()));
            if ui.add(close).accessible_name("Close the lesson").clicked() {
                wish = Some(Wish::Close);
            }
            let present = Button::new(RichText::new("Present").font(theme::small()));
            let present = ui.add(present).accessible_name("Present this lesson");
            if present.on_hover_text("Each step fills the screen, for a room to look at (F)").clicked() {
                wish = Some(Wish::Present);
            }
        });
    });
    let index = session.record.step;
    let Some(step) = session.lesson.steps.get(index) else { return wish };
    theme::heading(ui, RichText::new(&step.title).font(theme::semibold(theme::sizes(ui).card)), 2);
    let context = text::Context { start: &session.start, shelf: &session.shelf, aircraft };
    // What comes after a question is shown once it has its answer; of varied numbers nothing before it is known whose they are.
    let mut is_open = !session.waits_for_name();
    let parts = if is_open { &step.parts[..] } else { &[] };
    if !is_open {
        let why = "Here everybody has numbers of their own. They follow from your name or number, so type it as you will hand it in.";
        wish = person_ui(ui, why, &mut session.typed).or(wish);
    }
    for (place, part) in parts.iter().enumerate() {
        let at = Place { step: index, part: place };
        match part {
            Part::Text(text) => wish = text_ui(ui, text, context).or(wish),
            Part::Prediction(prediction) => {
                let (given, asked) = (session.record.answers.at(at), session.asked.entry(at).or_default());
                ui.push_id(at, |ui| question_ui(ui, prediction, given, asked, context));
                is_open &= given.is_final;
            }
            Part::Reveal(text) if is_open => {
                let frame = Frame::new().fill(palette.stable_half).corner_radius(8).inner_margin(8);
                wish = frame.show(ui, |ui| text_ui(ui, text, context)).inner.or(wish);
            }
            Part::Task(task) if is_open => {
                let (given, tried) = (session.record.answers.at(at), session.tried.entry(at).or_default());
                let asked = ui.push_id(at, |ui| task_ui(ui, task, given, tried, now, context)).inner;
                wish = asked.or(wish);
                if given.reached && session.lesson.is_homework() {
                    if person.is_empty() {
                        wish = person_ui(ui, "To hand it in, tell whose it is.", &mut session.typed).or(wish);
                    } else if ui.button("Copy the link to hand in").clicked() {
                        wish = Some(Wish::HandIn(at));
                    }
                }
            }
            Part::Reveal(_) | Part::Task(_) => {}
            // They are for whoever presents.
            Part::Notes(_) => continue,
            Part::Write(writing) => {
                let given = session.record.answers.at(at);
                ui.push_id(at, |ui| write_ui(ui, writing, given, context));
            }
        }
        ui.add_space(6.0);
    }
    let count = session.lesson.steps.len();
    ui.separator();
    let (mut to, mut begins_again) = (None, false);
    ui.horizontal(|ui| {
        if ui.add_enabled(index > 0, Button::new("← Back")).clicked() {
            to = Some(index - 1);
        }
        match map::map_ui(ui, &session.lesson, &session.record, &mut session.asks_to_forget) {
            Some(map::Chosen::Step(step)) => to = Some(step),
            Some(map::Chosen::Again) => begins_again = true,
            None => {}
        }
        if index + 1 == count {
            if !Curtain::of(ui).keeps() && ui.button("To the lessons").clicked() {
                wish = Some(Wish::Lessons);
            }
            return;
        }
        let next = if is_open { "Next →" } else { "Skip →" };
        if ui.button(next).clicked() {
            to = Some(index + 1);
        }
    });
    if begins_again {
        session.begin_again(aircraft);
        return Some(Wish::Step);
    }
    if let Some(to) = to
        && session.go_to(to, aircraft)
    {
        wish = Some(Wish::Step);
    }
    wish
}
