//! The disturbances a person can choose, each with its own remembered size.

use crate::flight::inputs::Input;
use crate::flight::plane::Plane;
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
    /// More thrust at once.
    ThrottleStep,
    /// The aircraft flies into steadily rising air with a sharp edge.
    VerticalGust,
    /// The aileron moves at once and soon goes back.
    AileronPulse,
    /// The rudder moves at once and soon goes back.
    RudderPulse,
    /// The aircraft flies into air that moves steadily to the right.
    SideGust,
}

impl DisturbanceKind {
    /// Those of a plane, in the order of the chooser.
    pub const fn of(plane: Plane) -> &'static [Self] {
        match plane {
            Plane::Longitudinal => {
                &[Self::ElevatorStep, Self::ElevatorPulse, Self::ThrottleStep, Self::VerticalGust]
            }
            Plane::Lateral => &[Self::RudderPulse, Self::AileronPulse, Self::SideGust],
        }
    }

    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ElevatorStep => "Elevator step",
            Self::ElevatorPulse => "Elevator pulse",
            Self::ThrottleStep => "Throttle step",
            Self::VerticalGust => "Vertical gust",
            Self::AileronPulse => "Aileron pulse",
            Self::RudderPulse => "Rudder pulse",
            Self::SideGust => "Side gust",
        }
    }

    /// Keys of the parameters that size it.
    pub const fn parameters(self) -> &'static [&'static str] {
        match self {
            Self::ElevatorStep => &["step", "time"],
            Self::ElevatorPulse => &["pulse", "pulse_for", "time"],
            Self::ThrottleStep => &["throttle", "time"],
            Self::VerticalGust => &["gust", "time"],
            Self::AileronPulse => &["aileron", "pulse_for", "time"],
            Self::RudderPulse => &["rudder", "pulse_for", "time"],
            Self::SideGust => &["side_gust", "time"],
        }
    }
}

/// A disturbance and the time for which it is watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance {
    /// Which one disturbs longitudinal motion.
    pub longitudinal: DisturbanceKind,
    /// Which one disturbs lateral motion.
    pub lateral: DisturbanceKind,
    /// Elevator of the step \[rad\], trailing edge down positive.
    pub step_elevator: f64,
    /// Elevator of the pulse \[rad\], trailing edge down positive.
    pub pulse_elevator: f64,
    /// Throttle of the step, the change of thrust as a fraction of the weight.
    pub step_throttle: f64,
    /// Aileron of the pulse \[rad\], in the source's sense.
    pub pulse_aileron: f64,
    /// Rudder of the pulse \[rad\], trailing edge left positive.
    pub pulse_rudder: f64,
    /// Length of a pulse \[s\].
    pub pulse_duration: f64,
    /// Speed of the rising air \[m/s\], upward positive.
    pub gust_speed: f64,
    /// Speed of the air from the left \[m/s\], to the right positive.
    pub side_gust_speed: f64,
    /// Time shown \[s\].
    pub duration: f64,
}

impl Default for Disturbance {
    /// The step of one degree, long enough to see a phugoid; the pulse is the lesson's, 0.1 rad for 0.2 s.
    fn default() -> Self {
        Self {
            longitudinal: DisturbanceKind::ElevatorStep,
            lateral: DisturbanceKind::RudderPulse,
            step_elevator: 1_f64.to_radians(),
            pulse_elevator: 0.1,
            step_throttle: 0.02,
            pulse_aileron: 2_f64.to_radians(),
            pulse_rudder: 5_f64.to_radians(),
            pulse_duration: 0.2,
            gust_speed: 3.0,
            side_gust_speed: 3.0,
            duration: 60.0,
        }
    }
}

impl Disturbance {
    /// Which one disturbs a plane.
    pub const fn kind(&self, plane: Plane) -> DisturbanceKind {
        match plane {
            Plane::Longitudinal => self.longitudinal,
            Plane::Lateral => self.lateral,
        }
    }

    /// Which one disturbs a plane, to change.
    pub const fn kind_mut(&mut self, plane: Plane) -> &mut DisturbanceKind {
        match plane {
            Plane::Longitudinal => &mut self.longitudinal,
            Plane::Lateral => &mut self.lateral,
        }
    }

    /// The experiment to analyse for a plane.
    pub fn experiment(&self, plane: Plane) -> Experiment {
        let step = |amplitude| Input::Step { amplitude, start: START };
        let pulse = |amplitude| Input::Pulse { amplitude, start: START, duration: self.pulse_duration };
        let (channel, input) = match self.kind(plane) {
            DisturbanceKind::ElevatorStep => (Channel::First, step(self.step_elevator)),
            DisturbanceKind::ElevatorPulse => (Channel::First, pulse(self.pulse_elevator)),
            DisturbanceKind::ThrottleStep => (Channel::Second, step(self.step_throttle)),
            // Rising air moves against z, which points down: w_g = −speed.
            DisturbanceKind::VerticalGust => (Channel::Gust, step(-self.gust_speed)),
            DisturbanceKind::AileronPulse => (Channel::First, pulse(self.pulse_aileron)),
            DisturbanceKind::RudderPulse => (Channel::Second, pulse(self.pulse_rudder)),
            DisturbanceKind::SideGust => (Channel::Gust, step(self.side_gust_speed)),
        };
        Experiment { plane, channel, input, grid: TimeGrid { duration: self.duration, steps: STEPS } }
    }
}
