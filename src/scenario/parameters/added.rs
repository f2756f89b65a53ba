//! The offset that a person has added to a parameter that follows from others.

use super::{Parameter, Place, ValueError};
use crate::flight::aircraft::edits::Offsets;
use crate::scenario::Scenario;

/// An offset may be this many times the extent of its slider. It is wider than what may be typed as a value, for an offset
/// stays as it was while the value that it was meant for moves on.
const ADDED_BEYOND: f64 = 1e6;

impl Parameter {
    /// Offset on the value that follows from the rest \[SI\]; `None` for a parameter that follows from nothing.
    pub fn added(&self, scenario: &Scenario) -> Option<f64> {
        let mut offsets = scenario.edited.offsets.clone();
        self.offset(&mut offsets).map(|(offset, sign)| sign * *offset)
    }

    /// Sets what is added \[SI\]; does nothing to a parameter that follows from nothing.
    pub fn set_added(&self, scenario: &mut Scenario, value: f64) {
        if let Some((offset, sign)) = self.offset(&mut scenario.edited.offsets) {
            *offset = sign * value;
        }
    }

    /// The offset on what it follows from, and the sign with which the parameter is written; `None` if it follows from nothing.
    pub(super) fn offset<'a>(&self, offsets: &'a mut Offsets) -> Option<(&'a mut f64, f64)> {
        match self.place {
            Place::LongitudinalDerivative(of) => Some((of(&mut offsets.longitudinal), 1.0)),
            Place::LateralDerivative(of) => Some((of(&mut offsets.lateral), 1.0)),
            Place::A(plane, row, column, sign) => Some((&mut offsets.matrices[plane].a[(row, column)], sign)),
            Place::B(plane, row, column) => Some((&mut offsets.matrices[plane].b[(row, column)], 1.0)),
            Place::LongitudinalCoefficient(_)
            | Place::LateralCoefficient(_)
            | Place::Knob(_)
            | Place::Condition(_)
            | Place::Feedback(_)
            | Place::Disturbance(_) => None,
        }
    }

    /// Accepts or refuses an offset \[SI\] that came from outside.
    pub fn check_added(&self, scenario: &Scenario, value: f64) -> Result<f64, ValueError> {
        let range = self.range(scenario);
        let reach = ADDED_BEYOND * range.start().abs().max(range.end().abs());
        self.check_within(scenario, value, -reach..=reach)
    }
}
