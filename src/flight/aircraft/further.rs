//! Further states of an aircraft beside the four of a plane, as its source has them: height, heading, place, an engine, controls with a
//! lag of their own.
//!
//! ```text
//! ẋ₄ = A x₄ + C xₐ + B δ        C of a control that is a state is its column of B: the surface moves the aircraft, not the command
//! ẋₐ = R x₄ + D xₐ + E δ        E of such a control is what its command does
//! ```
//!
//! A and B are those of [`PlaneModel`](super::plane::PlaneModel), and edited there; the rest is kept as the source has it.

use nalgebra::DMatrix;

use crate::key::keys;

/// Most further states of a plane.
pub const MOST_FURTHER: usize = 8;

/// A state beside the four of a plane: of an aircraft's source, or of a law of feedback.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AppendedState {
    /// Height gained on the steady flight \[m\].
    Height,
    /// Distance along the ground gained on the steady flight \[m\], forward positive.
    Distance,
    /// Heading ψ \[rad\], nose right positive.
    Heading,
    /// Place across the flight path \[m\], to the right positive.
    Offset,
    /// The slow part of the pitch rate, which the washout takes away \[rad/s\].
    PitchRateWashout,
    /// The slow part of the yaw rate, which the washout takes away \[rad/s\].
    YawRateWashout,
    /// Elevator behind its actuator \[rad\], trailing edge down positive.
    Elevator,
    /// Thrust behind the lag of the engine, as the throttle.
    Throttle,
    /// Aileron behind its actuator \[rad\], right one up positive.
    Aileron,
    /// Rudder behind its actuator \[rad\], trailing edge left positive.
    Rudder,
    /// Thrust or the speed of an engine, in the unit of the source.
    Engine,
    /// Any other, in the unit of the source.
    Other,
}

keys! {
    AppendedState {
        Height => "h",
        Distance => "x",
        Heading => "psi",
        Offset => "y",
        PitchRateWashout => "q-washout",
        YawRateWashout => "r-washout",
        Elevator => "elevator",
        Throttle => "throttle",
        Aileron => "aileron",
        Rudder => "rudder",
        Engine => "engine",
        Other => "other",
    }
}

impl AppendedState {
    /// Whether it is where the aircraft is or heads, on which flight in air of one density doesn't depend.
    pub const fn is_of_path(self) -> bool {
        matches!(self, Self::Height | Self::Distance | Self::Heading | Self::Offset)
    }

    /// Whether it is a length.
    pub const fn is_length(self) -> bool {
        matches!(self, Self::Height | Self::Distance | Self::Offset)
    }

    /// Whether a source may have more than one of it.
    pub const fn may_repeat(self) -> bool {
        matches!(self, Self::Distance | Self::Offset | Self::Engine | Self::Other)
    }
}

/// The further states of an aircraft in one plane, SI and radians.
#[derive(Clone, Debug, PartialEq)]
pub struct FurtherStates {
    /// What they are, in the order of the state vector behind the four: at most [`MOST_FURTHER`].
    pub states: Vec<AppendedState>,
    /// R: rates of each for a unit of each of the four, four columns.
    pub of_four: DMatrix<f64>,
    /// C: rates of the four for a unit of each, four rows; zero for a control, whose column is that of B.
    pub to_four: DMatrix<f64>,
    /// D: rates of each for a unit of each.
    pub among: DMatrix<f64>,
    /// E: rates of each for a unit of each input, two columns.
    pub of_inputs: DMatrix<f64>,
}

impl FurtherStates {
    /// Place of a state among them, the first of its kind.
    pub fn place(&self, state: AppendedState) -> Option<usize> {
        self.states.iter().position(|other| *other == state)
    }

    /// Whether every number is one.
    pub fn is_finite(&self) -> bool {
        [&self.of_four, &self.to_four, &self.among, &self.of_inputs]
            .into_iter()
            .all(|part| part.iter().all(|x| x.is_finite()))
    }
}
