//! What a person has added to a parameter that follows from others: its offset.

use super::{Parameter, Place, ValueError, read};
use crate::scenario::Scenario;

/// An offset may be this many times the extent of its slider. It is wider than what may be typed as a value, for an offset
/// stays as it was while the value that it was meant for moves on.
const ADDED_BEYOND: f64 = 1e6;

impl Parameter {
    /// What is added to the value that follows from the rest \[SI\]; `None` for a parameter that follows from nothing.
    pub fn added(&self, scenario: &Scenario) -> Option<f64> {
        let offsets = &scenario.edited.offsets;
        match self.place {
            Place::LongitudinalDerivative(of) => Some(read(of, &offsets.longitudinal)),
            Place::LateralDerivative(of) => Some(read(of, &offsets.lateral)),
            Place::A(plane, row, column, sign) => Some(sign * offsets.matrices[plane].a[(row, column)]),
            Place::B(plane, row, column) => Some(offsets.matrices[plane].b[(row, column)]),
            _ => None,
        }
    }

    /// Sets what is added \[SI\]; does nothing to a parameter that follows from nothing.
    pub fn set_added(&self, scenario: &mut Scenario, value: f64) {
        let offsets = &mut scenario.edited.offsets;
        match self.place {
            Place::LongitudinalDerivative(of) => *of(&mut offsets.longitudinal) = value,
            Place::LateralDerivative(of) => *of(&mut offsets.lateral) = value,
            Place::A(plane, row, column, sign) => {
                offsets.matrices[plane].a[(row, column)] = sign * value;
            }
            Place::B(plane, row, column) => offsets.matrices[plane].b[(row, column)] = value,
            _ => {}
        }
    }

    /// Accepts or refuses an offset \[SI\] that came from outside.
    pub fn check_added(&self, scenario: &Scenario, value: f64) -> Result<f64, ValueError> {
        let range = self.range(scenario);
        let reach = ADDED_BEYOND * range.start().abs().max(range.end().abs());
        self.check_within(scenario, value, -reach..=reach)
    }
}
