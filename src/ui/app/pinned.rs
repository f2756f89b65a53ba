//! A state that is kept beside the one on screen, so that a person sees what has changed.

use crate::scenario::Scenario;

/// A pinned state.
#[derive(Clone, Debug, PartialEq)]
pub struct Pinned {
    /// Its name on screen.
    pub name: String,
    /// The state as it was pinned. It is put through the disturbance of the scene, whatever its own is.
    pub scenario: Scenario,
}

impl Pinned {
    /// A state as it is, by the name of its aircraft.
    pub fn new(scenario: Scenario) -> Self {
        let edited = if scenario.is_edited() { ", edited" } else { "" };
        Self { name: format!("{}{edited}", scenario.aircraft.name), scenario }
    }
}
