//! The experiment that a scenario describes, in the terms of the core.

use super::Scenario;
use crate::flight::analysis::{Motion, forced};
use crate::flight::inputs::Input;
use crate::flight::response::{Forced, TimeGrid};
use crate::flight::{Channel, Experiment, Start};

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

    /// Where the disturbance enters: of several, or of a motion without any, the first that a frequency response can be of.
    pub fn driven_channel(&self) -> Channel {
        self.experiment().inputs.first().map_or(Channel::First, |(channel, _)| *channel)
    }

    /// The equations of a motion, driven by a unit of what disturbs it.
    pub fn driven(&self, motion: &Motion) -> Forced {
        let unit = Input::Step { amplitude: 1.0, start: 0.0 };
        forced(&self.edited, &motion.model, &[(self.driven_channel(), unit)], Start::Rest, &[])
    }
}
