//! The states and inputs of both planes of motion, named.

use nalgebra::Matrix4;

/// A state of one plane.
pub trait State: Copy {
    /// Row or column of this state in A, B and x.
    fn index(self) -> usize;
}

impl State for Longitudinal {
    fn index(self) -> usize {
        Self::index(self)
    }
}

impl State for Lateral {
    fn index(self) -> usize {
        Self::index(self)
    }
}

/// Entry of A: what a unit of the state of `column` adds to the rate of the state of `row`.
pub fn entry<T: Copy, S: State>(a: &Matrix4<T>, row: S, column: S) -> T {
    a[(row.index(), column.index())]
}

/// The states of longitudinal motion, in the order of the state vector x = \[u, w, q, θ\].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Longitudinal {
    /// Forward speed u \[m/s\], faster positive.
    U,
    /// Velocity along z, w \[m/s\], downward positive.
    W,
    /// Pitch rate q \[rad/s\], nose-up positive.
    Q,
    /// Pitch angle θ \[rad\], nose-up positive.
    Theta,
}

impl Longitudinal {
    /// All four, in the order of the state vector.
    pub const ALL: [Self; 4] = [Self::U, Self::W, Self::Q, Self::Theta];

    /// Row or column of this state in A, B and x.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// The states of lateral–directional motion, in the order of the state vector x = \[v, p, r, φ\].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lateral {
    /// Sideslip velocity v \[m/s\], to the right positive; β ≈ v/V.
    V,
    /// Roll rate p \[rad/s\], right wing down positive.
    P,
    /// Yaw rate r \[rad/s\], nose right positive.
    R,
    /// Bank angle φ \[rad\], right wing down positive.
    Phi,
}

impl Lateral {
    /// All four, in the order of the state vector.
    pub const ALL: [Self; 4] = [Self::V, Self::P, Self::R, Self::Phi];

    /// Row or column of this state in A, B and x.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// Column of the elevator δe in the longitudinal B.
pub const ELEVATOR: usize = 0;

/// Column of the throttle δt in the longitudinal B.
pub const THROTTLE: usize = 1;

/// Column of the aileron δa in the lateral B.
pub const AILERON: usize = 0;

/// Column of the rudder δr in the lateral B.
pub const RUDDER: usize = 1;
