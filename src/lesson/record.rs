//! What one person has done in their lessons: kept on their device, written into a report, and read from it again.

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
    /// The step that is open, counted from 0.
    pub step: usize,
    /// Steps that have been open.
    pub seen: BTreeSet<usize>,
    /// What was answered, and what help was asked for.
    pub answers: Answers,
    /// Links to the scenes in which goals were reached, or with which their steps were left.
    pub scenes: BTreeMap<Place, String>,
    /// The files of a lesson that isn't beside the page.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<TextFile>,
}

impl Record {
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
                Part::Text(_) | Part::Reveal(_) | Part::Write(_) => true,
            }
        };
        self.seen.contains(&step) && parts.iter().enumerate().all(is_done)
    }

    /// Takes over from another record what is missing here.
    fn complete(&mut self, other: Self) {
        self.seen.extend(other.seen);
        self.answers.complete(other.answers);
        for (place, scene) in other.scenes {
            self.scenes.entry(place).or_insert(scene);
        }
        if self.files.is_empty() {
            self.files = other.files;
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
        for (address, record) in others.lessons {
            match self.lessons.get_mut(&address) {
                Some(own) => own.complete(record),
                None => {
                    self.lessons.insert(address, record);
                }
            }
        }
    }
}
