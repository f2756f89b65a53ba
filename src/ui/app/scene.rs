//! What undo goes through: the scenario and the state that is pinned beside it.

use std::sync::Arc;

use crate::scenario::Scenario;

/// A pinned state.
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// What it is called on screen.
    pub name: String,
    /// The state as it was pinned. It is put through the disturbance of the scene, whatever its own is.
    pub scenario: Scenario,
}

/// What undo brings back: everything that a person does, but not how they look at it.
#[derive(Clone)]
pub(super) struct Scene {
    pub scenario: Scenario,
    pub ghost: Option<Arc<Ghost>>,
}

impl PartialEq for Scene {
    /// A time shown that follows is nothing that a person has done: it may differ.
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (&self.scenario, &other.scenario);
        let follow = a.disturbance.follows && b.disturbance.follows;
        let same = a == b
            || follow && {
                let mut a = a.clone();
                a.disturbance.sizes.time = b.disturbance.sizes.time;
                a == *b
            };
        // Mostly it is the very same, and needs no look at its numbers.
        let ghosts = (self.ghost.as_ref(), other.ghost.as_ref());
        same && match ghosts {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b) || a == b,
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

/// What a pinned state is called.
pub(super) fn name(scenario: &Scenario) -> String {
    let edited = if scenario.is_edited() { ", edited" } else { "" };
    format!("{}{edited}", scenario.aircraft.name)
}
