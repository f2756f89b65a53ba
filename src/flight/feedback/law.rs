//! The law of feedback: how strongly what is measured moves each control, and what lies on the way.
//!
//! ```text
//! what is measured ──► washout (rates only) ──► gains, summed ──► lag of the actuator ──┐
//!                                                                                       ▼
//! pilot, disturbance ─────────────────────────────────────────────────────────────────► + ──► control of the aircraft
//! ```
//!
//! The sign is that of δ = +k y for every gain: a positive gain moves the control in its own positive sense, trailing edge down or
//! left, more thrust, right wing down, when what is measured is positive. So positive gains of pitch rate and α to the elevator and of
//! yaw rate to the rudder work against the motion, while against a roll the gain to the aileron is negative.
//!
//! The pilot's own deflection goes to the surface beside the actuator of the law (a damper in series): with all gains at zero the
//! aircraft is that without a law, whatever the lags.

use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::motion::outputs::Output;

/// How many quantities a plane measures.
pub const SIGNALS: usize = 5;

/// Place of the rate, q or r, among the [`signals`]: it may pass a washout.
pub const RATE: usize = 2;

/// Place of the height or the heading among the [`signals`]: to be measured, it has to be a state.
pub const PATH: usize = 4;

/// What is measured in a plane, in the order of the gains.
pub const fn signals(plane: Plane) -> [Output; SIGNALS] {
    match plane {
        Plane::Longitudinal => [
            Output::ForwardSpeed,
            Output::AngleOfAttack,
            Output::PitchRate,
            Output::PitchAngle,
            Output::Height,
        ],
        Plane::Lateral => {
            [Output::Sideslip, Output::RollRate, Output::YawRate, Output::BankAngle, Output::Heading]
        }
    }
}

/// A law of feedback of both planes, SI. Without any gain nothing is fed back.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law {
    /// The law of each plane.
    pub planes: ByPlane<PlaneLaw>,
    /// Time constant τ of the actuators of elevator, aileron and rudder, 1/(τs + 1) \[s\]; zero is none.
    pub actuator: f64,
    /// Time constant of the engine, by which thrust follows the law \[s\]; zero is none.
    pub engine: f64,
}

/// The part of a law in one plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlaneLaw {
    /// Gain k of each of the [`signals`] to the first input, elevator or aileron \[rad per SI unit\].
    pub to_first: [f64; SIGNALS],
    /// The same to the second input: throttle \[share of weight per SI unit\], or rudder \[rad per SI unit\].
    pub to_second: [f64; SIGNALS],
    /// Time constant T of the washout s/(s + 1/T) on the way of the rate \[s\]; zero is none, and lets all of the rate through.
    pub washout: f64,
}

impl Law {
    /// Whether nothing is fed back in a plane.
    pub fn is_open(&self, plane: Plane) -> bool {
        let law = &self.planes[plane];
        law.to_first.iter().chain(&law.to_second).all(|gain| *gain == 0.0)
    }

    /// Whether a quantity of a plane is fed back, so that a command of it does something.
    pub fn listens_to(&self, plane: Plane, output: Output) -> bool {
        let signal = signals(plane).iter().position(|signal| *signal == output);
        signal.is_some_and(|signal| self.planes[plane].gains().iter().any(|gains| gains[signal] != 0.0))
    }

    /// Time constant of the lag on the way to each input of a plane \[s\]; zero is none.
    pub fn lags(&self, plane: Plane) -> [f64; 2] {
        match plane {
            Plane::Longitudinal => [self.actuator, self.engine],
            Plane::Lateral => [self.actuator; 2],
        }
    }
}

impl PlaneLaw {
    /// The gains to each input.
    pub const fn gains(&self) -> [&[f64; SIGNALS]; 2] {
        [&self.to_first, &self.to_second]
    }
}
