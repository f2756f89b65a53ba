//! A step of a lesson: a heading, a scene, and what is read, asked and done there.

use super::notes::Notes;
use super::prediction::Prediction;
use super::scene::Scene;
use super::task::Task;
use super::text::Text;
use super::vary::Vary;
use super::writing::Writing;

/// A step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its heading.
    pub title: String,
    /// Its scene: that of the step before it where it names none.
    pub scene: Scene,
    /// Numbers of its scene that each person has their own of.
    pub vary: Vec<Vary>,
    /// What it consists of, in order.
    pub parts: Vec<Part>,
    /// Line of the heading, counted from 1.
    pub line: usize,
}

/// A part of a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// Running text.
    Text(Text),
    /// A question.
    Prediction(Prediction),
    /// Text that is shown when every question before it in the step has its answer.
    Reveal(Text),
    /// Something to do.
    Task(Task),
    /// Something to write.
    Write(Writing),
    /// What whoever presents the step wants to say; nobody else sees it.
    Notes(Notes),
}

impl Part {
    /// What a question or a task is worth: what the file says, or one point.
    pub fn points(&self) -> Option<f64> {
        match self {
            Self::Prediction(prediction) => Some(prediction.points.unwrap_or(1.0)),
            Self::Task(task) => Some(task.points.unwrap_or(1.0)),
            Self::Text(_) | Self::Reveal(_) | Self::Write(_) | Self::Notes(_) => None,
        }
    }
}

impl Step {
    /// The questions, in order.
    pub fn predictions(&self) -> impl Iterator<Item = &Prediction> {
        self.parts.iter().filter_map(|part| match part {
            Part::Prediction(prediction) => Some(prediction),
            Part::Text(_) | Part::Reveal(_) | Part::Task(_) | Part::Write(_) | Part::Notes(_) => None,
        })
    }

    /// The tasks, in order.
    pub fn tasks(&self) -> impl Iterator<Item = &Task> {
        self.parts.iter().filter_map(|part| match part {
            Part::Task(task) => Some(task),
            Part::Text(_) | Part::Reveal(_) | Part::Prediction(_) | Part::Write(_) | Part::Notes(_) => None,
        })
    }

    /// The notes, in order.
    pub fn notes(&self) -> impl Iterator<Item = &Notes> {
        self.parts.iter().filter_map(|part| match part {
            Part::Notes(notes) => Some(notes),
            _ => None,
        })
    }

    /// How long it is to take \[min\], where its notes say so.
    pub fn minutes(&self) -> Option<f64> {
        self.notes().filter_map(|notes| notes.minutes).reduce(|sum, minutes| sum + minutes)
    }

    /// All of its text: what is read at once, and what is shown later. Without its notes, which nobody reads in a lesson.
    pub fn texts(&self) -> Vec<&Text> {
        self.parts
            .iter()
            .flat_map(|part| match part {
                Part::Text(text) | Part::Reveal(text) => vec![text],
                Part::Prediction(prediction) => prediction.texts(),
                Part::Task(task) => task.texts(),
                Part::Write(writing) => vec![&writing.ask],
                Part::Notes(_) => Vec::new(),
            })
            .collect()
    }
}
