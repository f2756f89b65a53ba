//! Textbook approximations beside the exact modes.

use serde::Serialize;

use crate::flight::modes::approximations::{Approximation, ModeValue};
use crate::key::Keyed;
use crate::scenario::Notation;
use crate::words;

/// A textbook approximation beside the exact mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Approximation"))]
pub struct ApproximationReport {
    /// Name of the mode that it approximates.
    pub mode: &'static str,
    /// Key of the mode.
    #[cfg_attr(test, ts(type = "ModeKey"))]
    pub mode_key: &'static str,
    /// Name of the approximation, among those of the mode.
    pub name: &'static str,
    /// Key of the approximation, among all.
    #[cfg_attr(test, ts(type = "ApproximationKey"))]
    pub key: &'static str,
    /// Its formula.
    pub formula: &'static str,
    /// Terms and motions that it leaves out.
    pub neglects: String,
    /// Its result; null where it gives none.
    pub value: Option<ValueReport>,
    /// The exact mode; null where the aircraft has none.
    pub exact: Option<ValueReport>,
    /// Relative error of ωₙ or of the root.
    pub error: Option<f64>,
    /// Relative error of ζ.
    pub damping_error: Option<f64>,
}

/// Frequency and damping, or a real root.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ModeValue"))]
#[serde(untagged)]
pub enum ValueReport {
    /// An oscillation, or two roots taken together.
    SecondOrder {
        /// ωₙ.
        natural_frequency: f64,
        /// ζ, where the approximation gives one.
        damping_ratio: Option<f64>,
    },
    /// A real root.
    Root {
        /// λ.
        root: f64,
    },
}

impl ApproximationReport {
    /// An approximation as it is told, in a notation.
    pub fn of(approximation: &Approximation, notation: Notation) -> Self {
        let value = |value: ModeValue| match value {
            ModeValue::SecondOrder { natural_frequency, damping_ratio } => {
                ValueReport::SecondOrder { natural_frequency, damping_ratio }
            }
            ModeValue::Root(root) => ValueReport::Root { root },
        };
        Self {
            mode: words::mode::title(approximation.name.concerns()),
            mode_key: approximation.name.concerns().key(),
            name: words::approximation::name(approximation.name, notation),
            key: approximation.name.key(),
            formula: words::approximation::formula(approximation.name, notation),
            neglects: words::approximation::neglects(approximation.name, notation).into_owned(),
            value: approximation.value.map(value),
            exact: approximation.exact.map(value),
            error: approximation.error(),
            damping_error: approximation.damping_error(),
        }
    }
}
