//! The names that people give to states and inputs.

use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::states::{Lateral, Longitudinal};

/// Dimension of a state, which says how it becomes SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::content) enum Kind {
    /// A velocity: u, w, v.
    Velocity,
    /// α or β in place of w or v: w = U₀ α, v = V β.
    FlowAngle,
    /// An angle or its rate.
    Angle,
}

/// A state by one of its names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::content) struct State {
    pub plane: Plane,
    /// Its place in the state vector.
    pub index: usize,
    pub kind: Kind,
}

/// An input by one of its names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::content) struct Input {
    pub plane: Plane,
    /// Its column of B.
    pub column: usize,
    /// Whether it is an angle.
    pub is_angle: bool,
}

pub(in crate::content) const STATES_EXPECTED: &str = "u, w (or alpha), q, theta, or v (or beta), p, r, phi";
pub(in crate::content) const INPUTS_EXPECTED: &str = "elevator and throttle, or aileron and rudder";

/// The state of this name.
pub(in crate::content) fn state(name: &str) -> Option<State> {
    use Kind::{Angle, FlowAngle, Velocity};
    let longitudinal =
        |state: Longitudinal, kind| State { plane: Plane::Longitudinal, index: state.index(), kind };
    let lateral = |state: Lateral, kind| State { plane: Plane::Lateral, index: state.index(), kind };
    Some(match plain(name).as_str() {
        "u" => longitudinal(Longitudinal::U, Velocity),
        "w" => longitudinal(Longitudinal::W, Velocity),
        "alpha" | "α" | "aoa" => longitudinal(Longitudinal::W, FlowAngle),
        "q" => longitudinal(Longitudinal::Q, Angle),
        "theta" | "θ" => longitudinal(Longitudinal::Theta, Angle),
        "v" => lateral(Lateral::V, Velocity),
        "beta" | "β" => lateral(Lateral::V, FlowAngle),
        "p" => lateral(Lateral::P, Angle),
        "r" => lateral(Lateral::R, Angle),
        "phi" | "φ" | "ϕ" => lateral(Lateral::Phi, Angle),
        _ => return None,
    })
}

/// The input of this name.
pub(in crate::content) fn input(name: &str) -> Option<Input> {
    let (plane, column, is_angle) = match plain(name).as_str() {
        "elevator" | "de" | "delta_e" | "δe" | "δ_e" => (Plane::Longitudinal, 0, true),
        "throttle" | "dt" | "delta_t" | "δt" | "δ_t" => (Plane::Longitudinal, 1, false),
        "aileron" | "da" | "delta_a" | "δa" | "δ_a" => (Plane::Lateral, 0, true),
        "rudder" | "dr" | "delta_r" | "δr" | "δ_r" => (Plane::Lateral, 1, true),
        _ => return None,
    };
    Some(Input { plane, column, is_angle })
}

/// Small letters, and no Δ in front.
fn plain(name: &str) -> String {
    name.trim().trim_start_matches('Δ').to_lowercase()
}
