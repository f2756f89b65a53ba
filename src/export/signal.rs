//! A quantity over time.

use serde::Serialize;

use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;

/// A quantity over time.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Signal {
    /// Its key, such as `theta`.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// Its values, one a time.
    pub values: Vec<f64>,
}

impl Signal {
    /// Values of an output.
    pub(super) fn of(output: Output, values: Vec<f64>) -> Self {
        let Quantity { key, dimension, .. } = Quantity::of(output);
        Self { name: key, unit: dimension.si_symbol(), values }
    }
}
