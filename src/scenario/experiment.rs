//! The experiment that a scenario describes, in the terms of the core.

use super::{Scenario, Source};
use crate::flight::aircraft::aircraft_model::AircraftModel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::response::TimeGrid;
use crate::flight::motion::turbulence::{Dryden, Severity};
use crate::flight::{Channel, Experiment};

/// Intervals between the samples of a response: one a pixel or finer on a wide screen.
const STEPS: usize = 1200;

/// Time between the samples of turbulence \[s\]: an aircraft at 200 m/s meets air 10 m apart, less than its length. It doesn't
/// depend on the time shown, so that showing more of it doesn't change the air.
const TURBULENCE_STEP: f64 = 0.05;

/// Turbulence is that of this height above the ground at least \[m\], 1000 ft: below it changes with every metre, and no source
/// says how high the ground is.
const LEAST_HEIGHT: f64 = 304.8;

impl Scenario {
    /// The experiment on the plane on screen.
    pub fn experiment(&self) -> Experiment {
        let disturbance = &self.disturbance;
        let plane = self.plane;
        let duration = disturbance.sizes.time;
        let (steps, inputs) = if disturbance.choices[plane].source == Source::Turbulence {
            // Samples of the motion fall on those of the air.
            let steps = (duration / TURBULENCE_STEP).round().max(1.0);
            (steps as usize, self.turbulence(steps as usize + 1))
        } else {
            (STEPS, disturbance.input(plane).into_iter().collect())
        };
        let grid = TimeGrid { duration, steps };
        Experiment { plane, inputs, start: disturbance.start(plane), grid }
    }

    /// Air of Dryden's form, with the chosen σ_w and the lengths and proportions of the altitude.
    fn turbulence(&self, count: usize) -> Vec<(Channel, Input)> {
        let sizes = &self.disturbance.sizes;
        let (speed, altitude) = match &self.edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => {
                (aircraft_model.condition.speed, aircraft_model.condition.altitude)
            }
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => {
                (self.aircraft.speed(), self.aircraft.particulars.altitude.unwrap_or(0.0))
            }
        };
        let mut air = Dryden::at(altitude.max(LEAST_HEIGHT), speed, Severity::Moderate);
        let [_, _, sigma_w] = air.intensity;
        let factor = if sigma_w > 0.0 { sizes.turbulence * sizes.times / sigma_w } else { 0.0 };
        air.intensity = air.intensity.map(|sigma| sigma * factor);
        let dt = sizes.time / (count - 1) as f64;
        let samples = air.samples(sizes.seed as u64, dt, count);
        let component =
            |i: usize| Input::Samples { dt, values: samples.iter().map(|gust| gust[i]).collect() };
        match self.plane {
            Plane::Longitudinal => {
                vec![(Channel::AirAcross, component(2)), (Channel::AirAlong, component(0))]
            }
            Plane::Lateral => vec![(Channel::AirAcross, component(1))],
        }
    }

    /// Where the disturbance enters: of several, or of a motion without any, the first that a frequency response can be of. A command
    /// moves nothing but through a law.
    pub fn driven_channel(&self) -> Channel {
        let source = self.disturbance.choices[self.plane].source;
        if source == Source::Turbulence {
            return Channel::AirAcross;
        }
        if source.command().is_some() {
            return Channel::First;
        }
        self.disturbance.input(self.plane).map_or(Channel::First, |(channel, _)| channel)
    }
}
