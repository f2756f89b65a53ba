//! What one person has done in their lessons: kept on their device, written into a report, and read from it again.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::file::Lesson;
use super::given::{Answers, Place};
use super::step::Part;
use crate::content::TextFile;

/// What one person has done in one lesson.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Record {
    /// Title of the lesson.
    pub title: String,
    /// The version of its file, see [`Lesson::version`].
    #[serde(skip_serializing_if = "String::is_empty")]
    pub version: String,
    /// The name or number from which its varied numbers follow; empty where none vary, or nobody was asked yet.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub seed: String,
    /// The step that is open, counted from 0.
    pub step: usize,
    /// Steps that have been open.
    pub seen: BTreeSet<usize>,
    /// What was answered, and what help was asked for.
    pub answers: Answers,
    /// Links to the scenes in which goals were reached, or with which their steps were left.
    pub scenes: BTreeMap<Place, String>,
    /// How often it was begun again, without what had been answered before.
    #[serde(skip_serializing_if = "is_none")]
    pub begun_again: u32,
    /// The files of a lesson that isn't beside the page.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<TextFile>,
}

/// Whether there is nothing to be written.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde gives what it writes by reference")]
const fn is_none(count: &u32) -> bool {
    *count == 0
}

impl Record {
    /// The lesson as it is when it is begun again: its file, its version and whose numbers it has stay.
    pub fn begun_again(&self) -> Self {
        let Self { title, version, seed, begun_again, files, .. } = self.clone();
        Self { title, version, seed, begun_again: begun_again.saturating_add(1), files, ..Self::default() }
    }

    /// How many steps of a lesson are done, of those that it has: every question has its answer, and every goal is reached.
    pub fn done(&self, lesson: &Lesson) -> (usize, usize) {
        let count = lesson.steps.len();
        ((0..count).filter(|&step| self.is_done(lesson, step)).count(), count)
    }

    /// Whether a step is done. One that asks nothing is done once it has been open.
    pub fn is_done(&self, lesson: &Lesson, step: usize) -> bool {
        let parts = lesson.steps.get(step).map_or(&[][..], |step| &step.parts);
        let is_done = |(part, what): (usize, &Part)| {
            let given = self.answers.get(Place { step, part });
            match what {
                Part::Prediction(_) => given.is_some_and(|given| given.is_final),
                Part::Task(_) => given.is_some_and(|given| given.reached),
                Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => true,
            }
        };
        self.seen.contains(&step) && parts.iter().enumerate().all(is_done)
    }

    /// Takes over what was done in the same lesson on another page of this device. What was begun again on either is begun again on both;
    /// of another lesson in a file of the same name nothing is taken over.
    pub fn join(&mut self, other: Self) {
        if !self.title.is_empty() && !other.title.is_empty() && self.title != other.title {
            return;
        }
        match self.begun_again.cmp(&other.begun_again) {
            Ordering::Less => *self = Self { step: self.step, ..other },
            Ordering::Equal => self.complete(other),
            Ordering::Greater => {}
        }
    }

    /// Takes over from another record what is missing here.
    fn complete(&mut self, other: Self) {
        if self.title.is_empty() {
            (self.title, self.version) = (other.title, other.version);
        }
        self.seen.extend(other.seen);
        self.answers.complete(other.answers);
        for (place, scene) in other.scenes {
            self.scenes.entry(place).or_insert(scene);
        }
        self.begun_again = self.begun_again.max(other.begun_again);
        if self.files.is_empty() {
            self.files = other.files;
        }
        if self.seed.is_empty() {
            self.seed = other.seed;
        }
    }
}

/// What one person has done in all their lessons.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Records {
    /// The name that they gave for their report; empty without one.
    pub person: String,
    /// Lessons by where they were opened from: their key, the path or the name of their file.
    pub lessons: BTreeMap<String, Record>,
}

/// Around the records in a report, which is a page.
const BEGINS: &str = r#"<script type="application/json" id="eigenwing-records">"#;
const ENDS: &str = "</script>";

impl Records {
    /// As JSON.
    pub fn to_json(&self) -> String {
        // Maps have text for their keys, so there is nothing that JSON can't say.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Out of JSON, or out of a report that carries it; an error says what is wrong with it.
    pub fn read(text: &str) -> Result<Self, serde_json::Error> {
        let json = text
            .split_once(BEGINS)
            .and_then(|(_, rest)| rest.split_once(ENDS))
            .map_or(text, |(json, _)| json);
        serde_json::from_str(json)
    }

    /// Whether a page carries records.
    pub fn are_in(text: &str) -> bool {
        text.contains(BEGINS)
    }

    /// As an element of a page, which shows nothing of it.
    pub fn to_element(&self) -> String {
        // No text in it can end the element.
        format!("{BEGINS}{}{ENDS}", self.to_json().replace('<', "\\u003c"))
    }

    /// Takes over from others what is missing here. Nothing that is here is lost.
    pub fn complete(&mut self, others: Self) {
        if self.person.is_empty() {
            self.person = others.person;
        }
        self.with(others.lessons, Record::complete);
    }

    /// Takes over what was done on another page of this device, see [`Record::join`], since both knew the same: the name is that of the
    /// page where it was changed.
    pub fn join(&mut self, others: Self, known: &Self) {
        if self.person == known.person {
            self.person = others.person;
        }
        self.with(others.lessons, Record::join);
    }

    /// Whether something was done here that others don't have.
    pub fn adds_to(&self, others: &Self) -> bool {
        let mut both = others.clone();
        both.join(self.clone(), others);
        both != *others
    }

    fn with(&mut self, others: BTreeMap<String, Record>, take_over: impl Fn(&mut Record, Record)) {
        for (address, record) in others {
            match self.lessons.get_mut(&address) {
                Some(own) => take_over(own, record),
                None => {
                    self.lessons.insert(address, record);
                }
            }
        }
    }
}
