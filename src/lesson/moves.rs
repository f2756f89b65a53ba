//! The movements of sliders that lead from one scene to another.

use crate::number::trimmed;
use crate::scenario::stage::TIME;
use crate::scenario::{Parameter, Scenario, Written, parameters};

/// The movement of one slider. What follows from others moves by what is added to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// What is moved.
    pub parameter: &'static Parameter,
    /// Its value before and after \[SI\].
    pub values: (f64, f64),
    /// What is added to it before and after, if it follows from others.
    added: Option<(f64, f64)>,
}

/// The parameters that were themselves moved, in the order of the table: without what follows from them, and without the time shown,
/// which follows the motion.
pub fn moves(from: &Scenario, to: &Scenario) -> Vec<Move> {
    let moved = |parameter: &'static Parameter| {
        let values = (parameter.get(from), parameter.get(to));
        let added = parameter.added(to).map(|after| (parameter.added(from).unwrap_or(0.0), after));
        let differs = match added {
            Some((before, after)) => before != after,
            None => parameter.applies(to) && values.0 != values.1,
        };
        differs.then_some(Move { parameter, values, added })
    };
    parameters().filter(|parameter| parameter.key != TIME).filter_map(moved).collect()
}

impl Move {
    /// Moves the slider so far, from 0 to 1.
    pub fn set(&self, scenario: &mut Scenario, share: f64) {
        let between = |(from, to): (f64, f64)| if share >= 1.0 { to } else { from + share * (to - from) };
        match self.added {
            Some(added) => self.parameter.set_added(scenario, between(added)),
            None => self.parameter.set(scenario, between(self.values)),
        }
    }

    /// From where to where, with its unit: "−0.683 → −1.4 1/rad".
    pub fn in_words(&self, scenario: &Scenario) -> String {
        let Written { unit, in_si, .. } = self.parameter.written(scenario.convention());
        let shown = |value: f64| trimmed(value / in_si, 3);
        format!("{} → {} {unit}", shown(self.values.0), shown(self.values.1)).trim_end().to_owned()
    }
}
