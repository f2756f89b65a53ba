//! The notation of the equations, in velocities or in angles of the flow. Links, files and programs keep w, v and SI whatever a
//! person looks at.

use crate::content::LengthUnit;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::aircraft::states::{Lateral, Longitudinal};
use crate::key::keys;

/// The states that stand for motion across the x axis. Books have both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// The velocities w and v.
    #[default]
    Velocities,
    /// The angles α = w/V and β = v/V. Where the x axis is not along the flight path, w/V isn't quite the angle of attack.
    Angles,
}

keys! {
    Notation {
        Velocities => "w-v" | "wv",
        Angles => "alpha-beta" | "angles",
    }
}

impl Notation {
    /// The other one, for a key.
    pub const fn next(self) -> Self {
        match self {
            Self::Velocities => Self::Angles,
            Self::Angles => Self::Velocities,
        }
    }
}

/// What a person has chosen to read: the unit of length, and the notation with the speed that belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convention {
    /// The unit of length.
    pub length: LengthUnit,
    /// The notation.
    pub notation: Notation,
    /// True airspeed V of the model of each plane \[m/s\], positive.
    pub speed: ByPlane<f64>,
}

impl Convention {
    /// That of links, files and programs: SI, and velocities.
    pub const SI: Self = Self {
        length: LengthUnit::Metre,
        notation: Notation::Velocities,
        speed: ByPlane { longitudinal: 1.0, lateral: 1.0 },
    };

    /// The factor from a state \[SI\] to what stands for it, 1/V of w and of v in angles, otherwise 1.
    pub fn of_state(&self, plane: Plane, state: usize) -> f64 {
        match self.angle(plane) {
            Some(index) if index == state => 1.0 / self.speed[plane],
            _ => 1.0,
        }
    }

    /// The factor from an entry of A, or in columns 4 and 5 of B, to that of the notation: x̃ = T x gives Ã = T A T⁻¹, B̃ = T B.
    pub fn of_entry(&self, plane: Plane, row: usize, column: usize) -> f64 {
        self.of_state(plane, row) / if column < 4 { self.of_state(plane, column) } else { 1.0 }
    }

    /// Place of the state that is an angle of the flow; none in velocities.
    pub fn angle(&self, plane: Plane) -> Option<usize> {
        (self.notation == Notation::Angles).then_some(match plane {
            Plane::Longitudinal => Longitudinal::W.index(),
            Plane::Lateral => Lateral::V.index(),
        })
    }
}
