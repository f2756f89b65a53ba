//! The disturbances a person can choose, each with its own remembered size.

use crate::flight::inputs::Input;
use crate::flight::response::TimeGrid;
use crate::flight::{Channel, Experiment};

/// Every disturbance begins here, so that the undisturbed flight before it can be seen \[s\].
pub const START: f64 = 1.0;

/// Intervals between the samples of a response: one a pixel or finer on a wide screen.
const STEPS: usize = 1200;

/// Which disturbance the aircraft is put through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DisturbanceKind {
    /// The elevator moves at once and stays.
    ElevatorStep,
    /// The elevator moves at once and soon goes back: the disturbance of the lesson.
    ElevatorPulse,
    /// The aircraft flies into steadily rising air with a sharp edge.
    VerticalGust,
}

impl DisturbanceKind {
    /// All, in the order of the chooser.
    pub const ALL: [Self; 3] = [Self::ElevatorStep, Self::ElevatorPulse, Self::VerticalGust];

    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ElevatorStep => "Elevator step",
            Self::ElevatorPulse => "Elevator pulse",
            Self::VerticalGust => "Vertical gust",
        }
    }
}

/// A disturbance and the time for which it is watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance {
    /// Which one.
    pub kind: DisturbanceKind,
    /// Elevator of the step \[rad\], trailing edge down positive.
    pub step_elevator: f64,
    /// Elevator of the pulse \[rad\], trailing edge down positive.
    pub pulse_elevator: f64,
    /// Length of the pulse \[s\].
    pub pulse_duration: f64,
    /// Speed of the rising air \[m/s\], upward positive.
    pub gust_speed: f64,
    /// Time shown \[s\].
    pub duration: f64,
}

impl Default for Disturbance {
    /// The step of one degree, long enough to see a phugoid; the pulse is the lesson's, 0.1 rad for 0.2 s.
    fn default() -> Self {
        Self {
            kind: DisturbanceKind::ElevatorStep,
            step_elevator: 1_f64.to_radians(),
            pulse_elevator: 0.1,
            pulse_duration: 0.2,
            gust_speed: 3.0,
            duration: 60.0,
        }
    }
}

impl Disturbance {
    /// The experiment to analyse.
    pub fn experiment(&self) -> Experiment {
        let (channel, input) = match self.kind {
            DisturbanceKind::ElevatorStep => {
                (Channel::Elevator, Input::Step { amplitude: self.step_elevator, start: START })
            }
            DisturbanceKind::ElevatorPulse => (
                Channel::Elevator,
                Input::Pulse { amplitude: self.pulse_elevator, start: START, duration: self.pulse_duration },
            ),
            // Rising air moves against z, which points down: w_g = −speed.
            DisturbanceKind::VerticalGust => {
                (Channel::VerticalGust, Input::Step { amplitude: -self.gust_speed, start: START })
            }
        };
        Experiment { channel, input, grid: TimeGrid { duration: self.duration, steps: STEPS } }
    }
}
