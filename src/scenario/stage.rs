//! The stage: what of the page is on, what is hidden, what is locked, and how large it is. A workbench has everything; a lesson's
//! step, a slide or an embedded frame has what it is about.

use super::{Parameter, Scenario, parameters};
use crate::key::keys;

/// What of the page is on, hidden and locked.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The parts that are on, in the order of [`Part::VALUES`](crate::key::Keyed::VALUES); all where it is empty.
    parts: Vec<Part>,
    /// Keys of the parameters that are offered as sliders, in the order of the table; all where it is empty.
    pub offered: Vec<&'static str>,
    /// What isn't shown, in the order of [`Hidden::VALUES`](crate::key::Keyed::VALUES).
    hidden: Vec<Hidden>,
    /// What stays as it is, in the order of [`Lock::VALUES`](crate::key::Keyed::VALUES).
    locks: Vec<Lock>,
    /// Keys of the parameters that stay as they are, in the order of the table.
    pub locked: Vec<&'static str>,
    /// Size of letters and strokes over the usual one.
    pub type_size: f64,
}

/// A part of the page that can be on or off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The sliders.
    Derivatives,
    /// The pole map.
    Poles,
    /// The aircraft in flight.
    Aircraft,
    /// The responses.
    Response,
    /// The verdicts, and the cards of the modes.
    Modes,
    /// The equations; on only where they are named, for otherwise they stand with the sliders of their entries.
    Equations,
}

keys! {
    Part {
        Derivatives => "derivatives",
        Poles => "poles",
        Aircraft => "aircraft",
        Response => "response",
        Modes => "modes",
        Equations => "equations",
    }
}

/// Something that isn't shown, so that a question about it is a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hidden {
    /// The names of the modes.
    Names,
    /// Everything that is measured; not the ticks of axes, nor the values of sliders.
    Numbers,
    /// Why a mode has its name, what it is made of, and what a change would do to it.
    Reasons,
    /// Whether the motion and the equilibrium are stable.
    Verdicts,
    /// The levels of handling qualities.
    Levels,
    /// The curves of the responses; their axes stay.
    Curves,
    /// The name of the aircraft.
    AircraftName,
}

keys! {
    Hidden {
        Names => "names",
        Numbers => "numbers",
        Reasons => "reasons",
        Verdicts => "verdicts",
        Levels => "levels",
        Curves => "curves",
        AircraftName => "aircraft-name",
    }
}

/// Something other than one parameter that stays as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lock {
    /// Which aircraft is studied.
    Aircraft,
    /// Which plane of motion.
    Plane,
    /// What disturbs the motion, and for how long it is watched.
    Disturbance,
    /// How it is looked at.
    View,
    /// Every parameter, and what levels are judged for.
    All,
}

keys! {
    Lock {
        Aircraft => "aircraft",
        Plane => "plane",
        Disturbance => "disturbance",
        View => "view",
        All => "all",
    }
}

impl Default for Stage {
    fn default() -> Self {
        Self {
            parts: Vec::new(),
            offered: Vec::new(),
            hidden: Vec::new(),
            locks: Vec::new(),
            locked: Vec::new(),
            type_size: 1.0,
        }
    }
}

impl Stage {
    /// Smallest and largest size of type over the usual one.
    pub const TYPE_SIZES: [f64; 2] = [0.8, 3.0];

    /// A stage with these parts on; with everything where there are none.
    pub fn with(parts: Vec<Part>) -> Self {
        Self { parts: in_order(parts), ..Self::default() }
    }

    /// The same stage with this hidden.
    pub fn hiding(self, hidden: Vec<Hidden>) -> Self {
        Self { hidden: in_order(hidden), ..self }
    }

    /// The same stage with this locked, beside single parameters.
    pub fn locking(self, locks: Vec<Lock>) -> Self {
        Self { locks: in_order(locks), ..self }
    }

    /// The parts that were named; none where everything is on.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// What isn't shown.
    pub fn hidden(&self) -> &[Hidden] {
        &self.hidden
    }

    /// What stays as it is, beside single parameters.
    pub fn locks(&self) -> &[Lock] {
        &self.locks
    }

    /// Whether a part is on.
    pub fn has(&self, part: Part) -> bool {
        self.parts.is_empty() && part != Part::Equations || self.parts.contains(&part)
    }

    /// Whether a parameter is offered, by its key.
    pub fn offers(&self, key: &str) -> bool {
        self.offered.is_empty() || self.offered.contains(&key)
    }

    /// Whether something is hidden.
    pub fn hides(&self, what: Hidden) -> bool {
        self.hidden.contains(&what)
    }

    /// Whether something stays as it is. An aircraft whose name is hidden does, for its name stands where it is chosen.
    pub fn locks_up(&self, what: Lock) -> bool {
        self.locks.contains(&what) || what == Lock::Aircraft && self.hides(Hidden::AircraftName)
    }

    /// Whether a parameter stays as it is.
    pub fn locks_parameter(&self, parameter: &Parameter) -> bool {
        self.locks.contains(&Lock::All)
            || self.locked.contains(&parameter.key)
            || parameter.is_of_disturbance() && self.locks.contains(&Lock::Disturbance)
    }

    /// Whether anything stays as it is.
    pub fn locks_anything(&self) -> bool {
        !self.locks.is_empty() || !self.locked.is_empty() || self.locks_up(Lock::Aircraft)
    }

    /// Puts back what is locked, as it was `before`, whatever has been done since.
    ///
    /// Another aircraft, where it may be chosen, comes with its own numbers.
    pub fn hold(&self, before: &Scenario, now: &mut Scenario) {
        if self.locks_up(Lock::Aircraft) && now.aircraft.key != before.aircraft.key {
            let (plane, disturbance) = (now.plane, now.disturbance);
            *now = Scenario { plane, disturbance, ..before.clone() };
        }
        if self.locks_up(Lock::Plane) && now.aircraft.plane_notes[before.plane].is_some() {
            now.plane = before.plane;
        }
        if self.locks_up(Lock::Disturbance) {
            now.disturbance = before.disturbance;
        }
        if self.locks_up(Lock::View) {
            (now.units, now.notation) = (before.units, before.notation);
        }
        let is_same = now.aircraft.key == before.aircraft.key;
        if is_same && self.locks_up(Lock::All) {
            now.task = before.task;
        }
        for parameter in parameters().filter(|p| self.locks_parameter(p)) {
            if parameter.is_of_disturbance() || is_same {
                hold(parameter, before, now);
            }
            if parameter.key == TIME {
                // What is set stays, and what doesn't stay follows: it does what it did.
                now.disturbance.follows = before.disturbance.follows;
            }
        }
    }

    /// Whether a parameter can be locked, of a scenario.
    pub(super) fn can_lock(parameter: &Parameter, scenario: &Scenario) -> bool {
        parameter.is_of_disturbance() || parameter.applies(scenario)
    }
}

/// Key of the time shown.
pub const TIME: &str = "time";

/// Puts a parameter back, to the last bit: of what follows from the rest, what is added to it.
fn hold(parameter: &Parameter, before: &Scenario, now: &mut Scenario) {
    match (parameter.added(before), parameter.added(now)) {
        (Some(added), Some(other)) if added != other => parameter.set_added(now, added),
        (None, None) if parameter.get(before) != parameter.get(now) => {
            parameter.set(now, parameter.get(before));
        }
        _ => {}
    }
}

/// Each once, in the order of their list.
fn in_order<T: Ord>(mut values: Vec<T>) -> Vec<T> {
    values.sort();
    values.dedup();
    values
}
