//! A question that is asked before anything is shown.

use super::scene::Scene;
use super::text::Text;
use crate::findings::measures::Measure;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::motion::outputs::Output;

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// What is asked.
    pub ask: Text,
    /// What is answered, and how.
    pub kind: Kind,
    /// The scene that has the answer, where it isn't that of the step.
    pub after: Option<Scene>,
    /// How many answers may be given, until one is right.
    pub tries: u32,
    /// What a right answer is worth; `None` where the file says nothing.
    pub points: Option<f64>,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// What is answered. Each wrong answer has its reason; the right one is told by the reveal.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// One of a few statements, or all that are right.
    Choose {
        /// The statements.
        choices: Vec<Choice>,
        /// Whether several are right.
        several: bool,
    },
    /// A number, answered in the unit that the page shows.
    Estimate {
        /// What is estimated.
        measure: Measure,
        /// Shown if the answer lies on the wrong side of the present value, or of zero.
        wrong_way: Text,
        /// Shown if it is the right way but not near.
        far: Text,
    },
    /// A pole on the map.
    Place {
        /// The mode whose pole it is.
        mode: ModeName,
        /// Shown if the answer is on the wrong side of the imaginary axis.
        wrong_side: Text,
        /// Shown if it is on the right side but not near.
        far: Text,
    },
    /// A curve over the axes of the response.
    Sketch {
        /// What is drawn.
        output: Output,
        /// Shown if it starts the wrong way.
        first: Text,
        /// Shown if it oscillates and shouldn't, or not often enough.
        oscillates: Text,
        /// Shown if it ends elsewhere.
        ends: Text,
    },
    /// Things in order, least first.
    Order {
        /// The things.
        items: Vec<Item>,
        /// What they are ordered by.
        measure: Measure,
        /// Shown if the order is another.
        because: Text,
    },
}

/// A statement to choose.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What it says.
    pub says: Text,
    /// Whether it is right.
    pub right: bool,
    /// Shown if it is chosen.
    pub because: Option<Text>,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// A thing to put in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it says.
    pub says: Text,
    /// Its scene.
    pub scene: Scene,
}

impl Prediction {
    /// All of its text.
    pub fn texts(&self) -> Vec<&Text> {
        let mut texts = vec![&self.ask];
        match &self.kind {
            Kind::Choose { choices, .. } => {
                texts.extend(
                    choices.iter().flat_map(|choice| [Some(&choice.says), choice.because.as_ref()]).flatten(),
                );
            }
            Kind::Estimate { wrong_way, far, .. } => texts.extend([wrong_way, far]),
            Kind::Place { wrong_side, far, .. } => texts.extend([wrong_side, far]),
            Kind::Sketch { first, oscillates, ends, .. } => texts.extend([first, oscillates, ends]),
            Kind::Order { items, because, .. } => {
                texts.extend(items.iter().map(|item| &item.says));
                texts.push(because);
            }
        }
        texts
    }

    /// The same, to be changed.
    pub(super) fn texts_mut(&mut self) -> Vec<&mut Text> {
        let mut texts = vec![&mut self.ask];
        match &mut self.kind {
            Kind::Choose { choices, .. } => {
                texts.extend(
                    choices
                        .iter_mut()
                        .flat_map(|choice| [Some(&mut choice.says), choice.because.as_mut()])
                        .flatten(),
                );
            }
            Kind::Estimate { wrong_way, far, .. } => texts.extend([wrong_way, far]),
            Kind::Place { wrong_side, far, .. } => texts.extend([wrong_side, far]),
            Kind::Sketch { first, oscillates, ends, .. } => texts.extend([first, oscillates, ends]),
            Kind::Order { items, because, .. } => {
                texts.extend(items.iter_mut().map(|item| &mut item.says));
                texts.push(because);
            }
        }
        texts
    }
}
