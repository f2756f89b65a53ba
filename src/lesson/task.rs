//! Something to do: a goal, what may be used for it, and the conditions that are met when it is reached.

use super::scene::Scene;
use super::text::Text;
use crate::findings::measures::Measure;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::Level;
use crate::scenario::Parameter;

/// A task.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The goal in words.
    pub goal: Text,
    /// The sliders that may be moved; all where there are none.
    pub offer: Vec<&'static Parameter>,
    /// How many of them may differ from the start at most.
    pub changes: Option<usize>,
    /// What it is worth to reach the goal without the solution; `None` where the file says nothing.
    pub points: Option<f64>,
    /// Whether a hint costs the points too.
    pub unaided: bool,
    /// When the solution is shown.
    pub solution_after: SolutionAfter,
    /// Hints, shown one at a time.
    pub hints: Vec<Text>,
    /// A scene that meets the goal.
    pub solution: Option<Scene>,
    /// The conditions, all to be met at once.
    pub until: Vec<Condition>,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// When a solution is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolutionAfter {
    /// After as many tries.
    Tries(u32),
    /// In an examination.
    Never,
}

/// A condition on a measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What is measured.
    pub measure: Measure,
    /// What it must be.
    pub wanted: Wanted,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// What a measure must be.
#[derive(Clone, Debug, PartialEq)]
pub enum Wanted {
    /// At least this.
    AtLeast(Amount),
    /// At most this.
    AtMost(Amount),
    /// Within a fraction of this.
    Within(f64, Amount),
    /// This verdict.
    Stability(Stability),
    /// This level or a better one.
    Level(Level),
    /// Nothing to read: the mode or the quantity is gone.
    Absent,
    /// Within a fraction of what it is at another scene.
    SameAs(f64, Scene),
}

/// A number of a condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// A number in SI.
    Number(f64),
    /// So many times the value at the start.
    TimesStart(f64),
}

impl Task {
    /// All of its text.
    pub fn texts(&self) -> Vec<&Text> {
        std::iter::once(&self.goal).chain(&self.hints).collect()
    }
}
