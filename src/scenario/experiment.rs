//! The experiment that a scenario describes, in the terms of the core.

use super::Scenario;
use crate::flight::Experiment;
use crate::flight::response::TimeGrid;

/// Intervals between the samples of a response: one a pixel or finer on a wide screen.
const STEPS: usize = 1200;

impl Scenario {
    /// The experiment on the plane on screen.
    pub fn experiment(&self) -> Experiment {
        let disturbance = &self.disturbance;
        let grid = TimeGrid { duration: disturbance.sizes.time, steps: STEPS };
        let plane = self.plane;
        let inputs = disturbance.input(plane).into_iter().collect();
        Experiment { plane, inputs, start: disturbance.start(plane), grid }
    }
}
