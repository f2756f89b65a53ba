//! One plane of motion out of a system, with the states that are kept beside its four.

use super::system::System;
use crate::content::matrix::state_names::control;
use crate::flight::aircraft::further::AppendedState;
use crate::flight::aircraft::plane::Plane;
use crate::key::Keyed as _;

/// One plane out of a system.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub plane: Plane,
    /// Places of its states in the system, in the order of the state vector.
    pub states: [usize; 4],
    /// The states that are kept beside them.
    pub further: Vec<Further>,
    pub a: Vec<Vec<f64>>,
    /// The controls by the names that they have here.
    pub inputs: Vec<&'static str>,
    pub b: Vec<Vec<f64>>,
}

impl Part {
    /// Places of all its states, the four first.
    pub fn all(&self) -> Vec<usize> {
        self.states.iter().copied().chain(self.further.iter().map(|further| further.place)).collect()
    }
}

/// A state beside the four.
#[derive(Clone, Copy, Debug)]
pub(super) struct Further {
    /// Its place in the system.
    pub place: usize,
    /// What it is here.
    pub state: AppendedState,
}

impl Further {
    /// The control that it is, if it is one.
    pub fn control(&self) -> Option<&'static str> {
        let is_control = Plane::ALL.iter().any(|&plane| AppendedState::controls(plane).contains(&self.state));
        is_control.then(|| self.state.key())
    }

    /// The input that commands it, where it is a control that an input does anything to.
    pub fn command(&self, system: &System) -> Option<usize> {
        let key = self.control()?;
        (0..system.inputs.len())
            .find(|&j| control(&system.inputs[j]) == Some(key) && system.b[self.place][j] != 0.0)
    }
}
