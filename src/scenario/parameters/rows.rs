//! The rows of all pages as one table.

use super::{Parameter, coefficients, dimensional, disturbance, feedback, knobs, matrix};

/// Every row of the table, in the order of the pages.
pub fn parameters() -> impl Iterator<Item = &'static Parameter> {
    coefficients::ROWS
        .iter()
        .chain(&knobs::ROWS)
        .chain(&dimensional::ROWS)
        .chain(&matrix::ROWS)
        .chain(&feedback::ROWS)
        .chain(&disturbance::ROWS)
}

impl Parameter {
    /// The row with this key.
    pub fn find(key: &str) -> Option<&'static Self> {
        parameters().find(|p| p.key == key)
    }
}
