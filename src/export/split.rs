//! A motion as the sum of its modes.

use serde::Serialize;

use crate::flight::analysis::Motion;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::outputs::Output;
use crate::key::Keyed;
use crate::scenario::Quantity;
use crate::words;

/// An output split into the parts of the modes, or why it has no meaningful split.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum SplitOutcome {
    /// The parts.
    Split(SplitReport),
    /// No parts can be told.
    Refused {
        /// Name of the output.
        name: &'static str,
        /// In one sentence.
        error: String,
    },
}

/// The parts of an output; with `rest` they add up to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Split"))]
pub struct SplitReport {
    /// Name of the output.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// The part of each mode, in the order of the modes.
    pub parts: Vec<PartReport>,
    /// The rest, which no mode makes: the immediate effect of the input, and the drift of the path.
    pub rest: Vec<f64>,
}

/// The part of one mode in an output.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Part"))]
pub struct PartReport {
    /// Name of the mode.
    pub mode: &'static str,
    /// Its key.
    #[cfg_attr(test, ts(type = "ModeKey"))]
    pub mode_key: &'static str,
    /// A value at each time.
    pub values: Vec<f64>,
}

impl SplitOutcome {
    /// The outputs of a motion, in their order, split into the parts of the modes of its model.
    pub(super) fn of(motion: &Motion, modes: &[Mode]) -> Vec<Self> {
        let split = |&output: &Output| {
            let Quantity { key: name, dimension, .. } = Quantity::of(output);
            let sum = match motion.split(modes, output) {
                Ok(sum) => sum,
                Err(error) => return Self::Refused { name, error: error.to_string() },
            };
            let part = |(mode, values): (&Mode, Vec<f64>)| PartReport {
                mode: words::mode::title(mode.naming.name),
                mode_key: mode.naming.name.key(),
                values,
            };
            let parts = modes.iter().zip(sum.parts).map(part).collect();
            Self::Split(SplitReport { name, unit: dimension.si_symbol(), parts, rest: sum.rest })
        };
        Output::of(motion.model.plane).iter().map(split).collect()
    }

    /// The parts, if there are any.
    pub fn split(&self) -> Option<&SplitReport> {
        match self {
            Self::Split(split) => Some(split),
            Self::Refused { .. } => None,
        }
    }
}
