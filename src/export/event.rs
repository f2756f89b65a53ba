//! What the page tells whoever holds it: the page around its frame, a window of notes.

use serde::Serialize;

use crate::lesson::{Answer, Records};

/// Something that the page tells. As JSON its kind is its `type`: `{"type": "goal-reached", …}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "type", rename_all = "kebab-case")]
pub enum Event {
    /// The page is there: it takes messages, and has drawn its first frame.
    Ready {
        /// The whole scene, without the `#`.
        link: String,
    },
    /// How high the page would like its frame to be: told when it is ready, and when that changes.
    Height {
        /// The height that shows all of the stage at the present width, and not more \[CSS pixels\].
        height: f32,
    },
    /// A message from outside can't be used.
    Error {
        /// What is wrong with it.
        sentence: String,
    },
    /// The scene is another, and has come to rest.
    Scene {
        /// The whole scene, without the `#`.
        link: String,
    },
    /// A step of a lesson was opened.
    StepOpened {
        /// The step.
        #[serde(flatten)]
        at: Spot,
        /// Its heading.
        title: String,
    },
    /// A question was answered once and for all.
    Answered {
        /// The step.
        #[serde(flatten)]
        at: Spot,
        /// The part of the step, counted from 1.
        part: usize,
        /// The answer.
        #[cfg_attr(test, ts(type = "unknown"))]
        answer: Answer,
        /// Whether nothing is wrong with it; null where there is nothing to compare it with.
        right: Option<bool>,
    },
    /// The goal of a task was reached for the first time.
    GoalReached {
        /// The step.
        #[serde(flatten)]
        at: Spot,
        /// The part of the step, counted from 1.
        part: usize,
        /// Whether no solution had been shown.
        unaided: bool,
        /// The scene that reached it, without the `#`.
        link: String,
    },
    /// What the person has done in their lessons.
    Report {
        /// As a report of the page holds it.
        #[cfg_attr(test, ts(type = "unknown"))]
        records: Records,
    },
}

/// Where in a lesson something has happened, and how far the person is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Spot {
    /// The lesson: its key, the path or the name of its file.
    pub lesson: String,
    /// The step, counted from 1.
    pub step: usize,
    /// How many steps the lesson has.
    pub steps: usize,
    /// How many of them are done: every question has its answer, and every goal is reached.
    pub done: usize,
}
