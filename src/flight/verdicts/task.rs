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

/// A light aircraft in cruise: judged at first where an aircraft has no class of its own.
impl Default for Task {
    fn default() -> Self {
        Self { class: Class::I, category: Category::B }
    }
}
