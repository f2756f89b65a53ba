//! What is a small disturbance: how far the linear equations are an approximation of anything. The limits are ours, and generous.

use nalgebra::Vector4;

use super::outputs::Output;
use crate::flight::aircraft::plane::{Plane, PlaneModel};

/// Largest change of speed, over the speed of the trim.
pub const LARGEST_SPEED: f64 = 0.5;

/// Largest change of α and β \[rad\]: 20°, about the stall.
pub const LARGEST_FLOW_ANGLE: f64 = 0.35;

/// Largest change of pitch and bank angle \[rad\].
pub const LARGEST_ATTITUDE: f64 = 1.0;

/// The limit that a disturbance has passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmallLimit {
    /// The output that has passed it.
    pub output: Output,
    /// The limit on either side of zero, SI.
    pub limit: f64,
}

/// The limit that a state has passed; `None` of a small disturbance: |u| ≤ V/2, |α| and |β| ≤ 0.35 rad, |θ| and |φ| ≤ 1 rad.
pub fn outgrown(model: &PlaneModel, x: &Vector4<f64>) -> Option<SmallLimit> {
    let v = model.trim.speed;
    let [first, second, _, attitude] = (*x).into();
    let speed = (Output::ForwardSpeed, first, LARGEST_SPEED * v);
    let passed = |(output, value, limit): (Output, f64, f64)| {
        // Written so that NaN has passed it too.
        let is_within = value.abs() <= limit;
        (!is_within).then_some(SmallLimit { output, limit })
    };
    match model.plane {
        // α = w/V
        Plane::Longitudinal => {
            let flow = (Output::AngleOfAttack, second / v, LARGEST_FLOW_ANGLE);
            let pitch = (Output::PitchAngle, attitude, LARGEST_ATTITUDE);
            [speed, flow, pitch].into_iter().find_map(passed)
        }
        // β = v/V
        Plane::Lateral => {
            let flow = (Output::Sideslip, first / v, LARGEST_FLOW_ANGLE);
            let bank = (Output::BankAngle, attitude, LARGEST_ATTITUDE);
            [flow, bank].into_iter().find_map(passed)
        }
    }
}

/// Whether a disturbance is small.
pub fn is_small(model: &PlaneModel, x: &Vector4<f64>) -> bool {
    outgrown(model, x).is_none()
}
