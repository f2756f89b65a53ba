//! Inputs and outputs of a motion: key, symbol, name and unit of each.

use super::Dimension;
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::command::Command;
use crate::flight::motion::outputs::Output;
use crate::key::Keyed;

/// How an input or output is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Short name for files and programs, never changed once published.
    pub key: &'static str,
    /// Symbol as the book writes it.
    pub symbol: &'static str,
    /// Name in words.
    pub name: &'static str,
    /// Its dimension, for its unit.
    pub dimension: Dimension,
}

impl Quantity {
    /// How an input of a plane is written, in the sense of [`Self::input_sign`].
    pub const fn of_input(plane: Plane, channel: Channel) -> Self {
        let (key, symbol, name, dimension) = match (plane, channel) {
            (Plane::Longitudinal, Channel::First) => ("elevator", "δ_e", "elevator", Dimension::Angle),
            (Plane::Longitudinal, Channel::Second) => {
                ("throttle", "δ_t", "throttle", Dimension::ShareOfWeight)
            }
            (Plane::Lateral, Channel::First) => ("aileron", "δ_a", "aileron", Dimension::Angle),
            (Plane::Lateral, Channel::Second) => ("rudder", "δ_r", "rudder", Dimension::Angle),
            (_, Channel::AirAlong) => ("u_gust", "u_g", "air from ahead", Dimension::AirSpeed),
            (Plane::Longitudinal, Channel::AirAcross) => ("w_gust", "w_g", "rising air", Dimension::AirSpeed),
            (Plane::Lateral, Channel::AirAcross) => {
                ("v_gust", "v_g", "air to the right", Dimension::AirSpeed)
            }
            (_, Channel::Command(command)) => match command {
                Command::Speed => ("u_command", "u_c", "commanded speed", Dimension::Speed),
                Command::PitchAngle => ("theta_command", "θ_c", "commanded pitch angle", Dimension::Angle),
                Command::Height => ("h_command", "h_c", "commanded height", Dimension::Length),
                Command::YawRate => ("r_command", "r_c", "commanded yaw rate", Dimension::AngularRate),
                Command::BankAngle => ("phi_command", "φ_c", "commanded bank angle", Dimension::Angle),
                Command::Heading => ("psi_command", "ψ_c", "commanded heading", Dimension::Angle),
            },
        };
        Self { key, symbol, name, dimension }
    }

    /// Sign of an input as it is shown beside its number along the axes, that of [`Channel`]: air that rises or comes from ahead
    /// counts positive, as its size does, though it moves against z and x.
    pub const fn input_sign(plane: Plane, channel: Channel) -> f64 {
        match (plane, channel) {
            (_, Channel::AirAlong) | (Plane::Longitudinal, Channel::AirAcross) => -1.0,
            (_, Channel::First | Channel::Second | Channel::Command(_))
            | (Plane::Lateral, Channel::AirAcross) => 1.0,
        }
    }

    /// How this output is written.
    pub fn of(output: Output) -> Self {
        let (symbol, name, dimension) = match output {
            Output::ForwardSpeed => ("Δu", "forward speed", Dimension::Speed),
            Output::DownSpeed => ("Δw", "velocity along z", Dimension::Speed),
            Output::AngleOfAttack => ("Δα", "angle of attack", Dimension::Angle),
            Output::PitchRate => ("q", "pitch rate", Dimension::AngularRate),
            Output::PitchAngle => ("Δθ", "pitch angle", Dimension::Angle),
            Output::PathAngle => ("Δγ", "flight-path angle", Dimension::Angle),
            Output::NormalLoad => ("Δn_z", "normal load factor", Dimension::Load),
            Output::Height => ("Δh", "height gained", Dimension::Length),
            Output::Distance => ("Δx", "distance gained", Dimension::Length),
            Output::SideSpeed => ("v", "sideways velocity", Dimension::Speed),
            Output::Sideslip => ("β", "sideslip", Dimension::Angle),
            Output::RollRate => ("p", "roll rate", Dimension::AngularRate),
            Output::YawRate => ("r", "yaw rate", Dimension::AngularRate),
            Output::BankAngle => ("φ", "bank angle", Dimension::Angle),
            Output::SideLoad => ("n_y", "lateral load factor", Dimension::Load),
            Output::Heading => ("ψ", "heading", Dimension::Angle),
            Output::Offset => ("y", "sideways displacement", Dimension::Length),
        };
        Self { key: output.key(), symbol, name, dimension }
    }
}
