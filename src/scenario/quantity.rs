//! The outputs of a motion as a person reads them: symbol, name and unit.

use super::Dimension;
use crate::flight::motion::outputs::Output;

/// How an output is written.
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
    /// How this output is written.
    pub const fn of(output: Output) -> Self {
        let (key, symbol, name, dimension) = match output {
            Output::ForwardSpeed => ("u", "Δu", "forward speed", Dimension::Speed),
            Output::DownSpeed => ("w", "Δw", "velocity along z", Dimension::Speed),
            Output::AngleOfAttack => ("alpha", "Δα", "angle of attack", Dimension::Angle),
            Output::PitchRate => ("q", "q", "pitch rate", Dimension::AngularRate),
            Output::PitchAngle => ("theta", "Δθ", "pitch angle", Dimension::Angle),
            Output::PathAngle => ("gamma", "Δγ", "flight-path angle", Dimension::Angle),
            Output::NormalLoad => ("nz", "Δn_z", "normal load factor", Dimension::Load),
            Output::Height => ("h", "Δh", "height gained", Dimension::Length),
            Output::Distance => ("x", "Δx", "distance gained", Dimension::Length),
            Output::SideSpeed => ("v", "v", "sideways velocity", Dimension::Speed),
            Output::Sideslip => ("beta", "β", "sideslip", Dimension::Angle),
            Output::RollRate => ("p", "p", "roll rate", Dimension::AngularRate),
            Output::YawRate => ("r", "r", "yaw rate", Dimension::AngularRate),
            Output::BankAngle => ("phi", "φ", "bank angle", Dimension::Angle),
            Output::SideLoad => ("ny", "n_y", "lateral load factor", Dimension::Load),
            Output::Heading => ("psi", "ψ", "heading", Dimension::Angle),
            Output::Offset => ("y", "y", "sideways displacement", Dimension::Length),
        };
        Self { key, symbol, name, dimension }
    }
}
