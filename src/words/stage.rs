//! The stage: what of the page is on, hidden and locked.

use crate::scenario::{Hidden, Lock, Part};

/// A part of the page.
pub const fn part(part: Part) -> &'static str {
    match part {
        Part::Derivatives => "sliders",
        Part::Poles => "pole map",
        Part::Aircraft => "aircraft",
        Part::Response => "responses",
        Part::Modes => "modes",
        Part::Equations => "equations",
    }
}

/// Something that isn't shown.
pub const fn hidden(hidden: Hidden) -> &'static str {
    match hidden {
        Hidden::Names => "names of modes",
        Hidden::Numbers => "numbers",
        Hidden::Reasons => "reasons",
        Hidden::Verdicts => "verdicts",
        Hidden::Levels => "levels",
        Hidden::Curves => "curves",
        Hidden::AircraftName => "name of the aircraft",
    }
}

/// Something that stays as it is.
pub const fn lock(lock: Lock) -> &'static str {
    match lock {
        Lock::Aircraft => "aircraft",
        Lock::Plane => "plane of motion",
        Lock::Disturbance => "disturbance",
        Lock::View => "view",
        Lock::All => "all numbers",
    }
}
