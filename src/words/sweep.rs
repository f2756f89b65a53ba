//! Sweeps of a parameter.

use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::stability::Stability;

/// A change of a verdict on a plane at a value of the parameter with its unit.
pub fn change(at: &str, plane: Plane, is_static: bool, from: Stability, to: Stability) -> String {
    let motion = match plane {
        Plane::Longitudinal => "longitudinal",
        Plane::Lateral => "lateral–directional",
    };
    let kind = if is_static { "statically" } else { "dynamically" };
    let [from, to] = [from, to].map(stability);
    format!("At {at} the {motion} motion goes from {kind} {from} to {to}.")
}

const fn stability(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Neutral => "neutral",
        Stability::Unstable => "unstable",
    }
}
