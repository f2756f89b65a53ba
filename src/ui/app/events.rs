//! What has happened, told to whoever holds the page and asks for it: the scene once it is at rest, and what is done in a lesson.

use std::time::Duration;

use egui::Ui;

use super::App;
use crate::export::{Event, Spot};
use crate::lesson::{Answers, Given, Place};
use crate::ui::lesson::Session;

/// A scene is told once it has been left as it is for so long \[s\]: not each frame of a drag, nor each step of a key that is held.
const RESTS: f64 = 0.3;

/// What has happened and hasn't been taken yet.
#[derive(Debug, Default)]
pub(super) struct Events {
    /// Whether anyone takes them.
    are_wanted: bool,
    waiting: Vec<Event>,
    /// Link of the scene that was told last.
    told: String,
    /// Link of another scene, and since when it is as it is \[s\].
    moving: Option<(String, f64)>,
    /// The lesson as it was when it was last looked at.
    before: Option<Followed>,
}

/// Of a lesson, what is told when it changes.
#[derive(Debug, PartialEq)]
struct Followed {
    address: String,
    step: usize,
    answers: Answers,
}

impl App {
    /// Begins to note what happens, from here on; whoever asks for it takes it with [`Self::take_events`].
    pub fn want_events(&mut self) {
        self.events.are_wanted = true;
        self.events.told = self.link();
    }

    /// What has happened since it was last asked for, in order; nothing before [`Self::want_events`].
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events.waiting)
    }

    /// What the person has done in their lessons, as it stands.
    pub fn report_event(&self) -> Event {
        Event::Report { records: self.records.clone() }
    }

    /// Notes what has happened, at the end of a frame.
    pub(super) fn note_events(&mut self, ui: &Ui) {
        if !self.events.are_wanted {
            return;
        }
        self.note_lesson();
        self.note_scene(ui);
    }

    fn note_scene(&mut self, ui: &Ui) {
        let (now, is_held) = ui.input(|input| (input.time, input.pointer.any_down()));
        if is_held {
            // The frame of the release comes here again.
            return;
        }
        let link = self.link();
        let Events { told, moving, waiting, .. } = &mut self.events;
        if link == *told {
            *moving = None;
            return;
        }
        let since = match moving {
            Some((moved, since)) if *moved == link => *since,
            _ => now,
        };
        let left = RESTS - (now - since);
        if left > 0.0 {
            *moving = Some((link, since));
            ui.request_repaint_after(Duration::from_secs_f64(left));
        } else {
            *moving = None;
            told.clone_from(&link);
            waiting.push(Event::Scene { link });
        }
    }

    fn note_lesson(&mut self) {
        let Some(session) = self.session() else {
            self.events.before = None;
            return;
        };
        let (step, address) = (session.place().step, session.address());
        let before = self.events.before.as_ref().filter(|before| before.address == address);
        let is_opened = before.is_none_or(|before| before.step != step);
        let answers = &session.record().answers;
        if !is_opened && before.is_some_and(|before| before.answers == *answers) {
            return;
        }
        let mut happened = Vec::new();
        if let Some(before) = before {
            for (place, given) in answers.iter() {
                let blank = Given::default();
                let was = before.answers.get(place).unwrap_or(&blank);
                happened.extend(self.answered(session, place, given).filter(|_| !was.is_final));
                happened.extend(self.reached(session, place, given).filter(|_| !was.reached));
            }
        }
        if is_opened {
            let title = session.heading().to_owned();
            happened.push(Event::StepOpened { at: spot(session, step), title });
        }
        let followed = Followed { address: address.to_owned(), step, answers: answers.clone() };
        self.events.before = Some(followed);
        self.events.waiting.extend(happened);
    }

    fn answered(&self, session: &Session, place: Place, given: &Given) -> Option<Event> {
        let answer = given.final_answer()?.clone();
        let right = session.is_right(place, &answer, &self.aircraft);
        Some(Event::Answered { at: spot(session, place.step), part: place.part + 1, answer, right })
    }

    fn reached(&self, session: &Session, place: Place, given: &Given) -> Option<Event> {
        let reached = || Event::GoalReached {
            at: spot(session, place.step),
            part: place.part + 1,
            unaided: given.is_unaided(),
            link: self.link_of_scene(&self.view),
        };
        given.reached.then(reached)
    }
}

/// A step of the lesson that is open, counted from 0 here and from 1 there.
fn spot(session: &Session, step: usize) -> Spot {
    let (done, steps) = session.done();
    Spot { lesson: session.address().to_owned(), step: step + 1, steps, done }
}
