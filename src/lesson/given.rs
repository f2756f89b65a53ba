//! What a person has given to a lesson: plain data that is kept, reported and graded.
//!
//! As JSON it is `{"1.2": {"answer": {"chosen": [0]}, "final": true}, "3.1": {"hints": 1, "tries": 4, "reached": true}}`, by step and
//! part, both counted from 1. Any text gives this or an error, and what doesn't fit the lesson any more is left out.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::answer::Answer;
use super::file::Lesson;
use super::step::Part;

/// The part of a step, both counted from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Place {
    /// The step.
    pub step: usize,
    /// The part of it.
    pub part: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.step.saturating_add(1), self.part.saturating_add(1))
    }
}

impl From<Place> for String {
    fn from(place: Place) -> Self {
        place.to_string()
    }
}

impl TryFrom<String> for Place {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let from_one = |number: &str| number.parse::<usize>().ok()?.checked_sub(1);
        let read = text.split_once('.').and_then(|(step, part)| Some((from_one(step)?, from_one(part)?)));
        let (step, part) =
            read.ok_or_else(|| format!("expected step and part such as \"1.2\", found \"{text}\""))?;
        Ok(Self { step, part })
    }
}

/// What was given to one part: to a question, to a task, or to something to write.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Given {
    /// The answer as it stands, final or not; of a question or something to write.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub answer: Option<Answer>,
    /// Answers to a question that were given before and are wrong, where more than one may be given.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub earlier: Vec<Answer>,
    /// Whether the answer was given once and for all: from then on it is compared, and what it was asked for is shown.
    #[serde(rename = "final")]
    pub is_final: bool,
    /// How many hints of a task were shown.
    pub hints: usize,
    /// How often a scene was left as it is that doesn't reach the goal.
    pub tries: u32,
    /// Whether a solution was shown before the goal was reached.
    pub solution_shown: bool,
    /// Whether the goal was reached.
    pub reached: bool,
}

impl Given {
    /// The answer that is final, if there is one.
    pub fn final_answer(&self) -> Option<&Answer> {
        self.answer.as_ref().filter(|_| self.is_final)
    }

    /// Gives the answer as it stands: it is final if it is right, or if no more may follow; otherwise it can be changed.
    pub fn give(&mut self, is_right: bool, tries: u32) {
        let Some(answer) = &self.answer else { return };
        if is_right || self.tries_left(tries) <= 1 {
            self.is_final = true;
        } else {
            self.earlier.push(answer.clone());
        }
    }

    /// How many of so many answers may still be given.
    pub fn tries_left(&self, tries: u32) -> u32 {
        if self.is_final {
            0
        } else {
            tries.saturating_sub(u32::try_from(self.earlier.len()).unwrap_or(u32::MAX))
        }
    }

    /// Makes an answer final.
    pub fn answer(&mut self, answer: Answer) {
        (self.answer, self.is_final) = (Some(answer), true);
    }

    /// Whether the goal was reached without its solution.
    pub const fn is_unaided(&self) -> bool {
        self.reached && !self.solution_shown
    }

    fn is_blank(&self) -> bool {
        *self == Self::default()
    }

    /// Takes over what is missing here: answers that have come further, and a goal that was reached with the help that there was until
    /// then.
    fn complete(&mut self, other: Self) {
        let answered = |given: &Self| (given.is_final, given.earlier.len(), given.answer.is_some());
        if answered(&other) > answered(self) {
            (self.answer, self.earlier, self.is_final) = (other.answer, other.earlier, other.is_final);
        }
        if self.reached == other.reached {
            self.hints = self.hints.max(other.hints);
            self.solution_shown |= other.solution_shown;
        } else if other.reached {
            (self.hints, self.solution_shown, self.reached) = (other.hints, other.solution_shown, true);
        }
        self.tries = self.tries.max(other.tries);
    }
}

/// What was given to a whole lesson, by step and part.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Answers(BTreeMap<Place, Given>);

impl Answers {
    /// Of a part; nothing where nothing was given.
    pub fn get(&self, place: Place) -> Option<&Given> {
        self.0.get(&place)
    }

    /// Of a part, to be changed.
    pub fn at(&mut self, place: Place) -> &mut Given {
        self.0.entry(place).or_default()
    }

    /// All that isn't blank, in the order of the lesson.
    pub fn iter(&self) -> impl Iterator<Item = (Place, &Given)> {
        self.0.iter().filter(|(_, given)| !given.is_blank()).map(|(place, given)| (*place, given))
    }

    /// Takes over from others what is missing here.
    pub fn complete(&mut self, others: Self) {
        for (place, given) in others.0 {
            self.0.entry(place).or_default().complete(given);
        }
    }

    /// Whether nothing was given.
    pub fn is_empty(&self) -> bool {
        self.iter().next().is_none()
    }

    /// The same without what doesn't fit a lesson, such as one whose file has changed since.
    pub fn fitting(mut self, lesson: &Lesson) -> Self {
        self.0.retain(|place, given| {
            let part = lesson.steps.get(place.step).and_then(|step| step.parts.get(place.part));
            match part {
                Some(Part::Prediction(prediction)) => {
                    given.earlier.iter().chain(&given.answer).all(|answer| answer.fits(&prediction.kind))
                }
                Some(Part::Write(_)) => given
                    .answer
                    .as_ref()
                    .is_none_or(|answer| matches!(answer, Answer::Text(_) | Answer::DontKnow)),
                Some(Part::Task(task)) => {
                    given.hints = given.hints.min(task.hints.len());
                    given.answer.is_none() && given.earlier.is_empty()
                }
                Some(Part::Text(_) | Part::Reveal(_) | Part::Notes(_)) | None => false,
            }
        });
        self
    }
}
