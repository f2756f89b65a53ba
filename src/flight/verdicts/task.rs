//! What handling qualities are judged for.

use super::mil_f_8785c::{Category, Class};

/// Class of aircraft and category of flight phase for which a specification is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Task {
    /// Class of aircraft.
    pub class: Class,
    /// Category of flight phase.
    pub category: Category,
}
