//! The linear model of longitudinal motion, ẋ = A x + B δ.

use nalgebra::{Matrix4, Vector4};

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

/// Longitudinal motion about a steady flight condition: ẋ = A x + B δe, x = \[u, w, q, θ\].
///
/// ```text
///     ⎡ Xu       Xw       0         −g cos θ₀ ⎤        ⎡  0  ⎤
/// A = ⎢ Zu       Zw       U₀ + Zq       0     ⎥    B = ⎢ Zδe ⎥
///     ⎢ Mu       Mw       Mq            0     ⎥        ⎢ Mδe ⎥
///     ⎣ 0        0        1             0     ⎦        ⎣  0  ⎦
/// ```
///
/// The entries are those of A itself: where a source gives ẇ derivatives, they are already folded in
/// (the entry Mu is Mu + Mẇ Zu, and so on; McRuer, Ashkenas & Graham 1973, §4).
#[derive(Clone, Debug, PartialEq)]
pub struct LongitudinalModel {
    /// State matrix A, SI and radians.
    pub a: Matrix4<f64>,
    /// Elevator column B \[per rad\], trailing edge down positive.
    pub b_elevator: Vector4<f64>,
    /// Trim speed U₀ along x \[m/s\], positive.
    pub u0: f64,
}

impl LongitudinalModel {
    /// Column by which a steady vertical gust w_g \[m/s\], downward positive, enters: −A\[:, w\].
    ///
    /// The aerodynamic terms feel w − w_g; the w column of A is purely aerodynamic, the kinematic U₀ stands in
    /// the q column (Etkin, *Dynamics of Atmospheric Flight*, §13.2). Pitch-rate penetration is left out.
    pub fn b_vertical_gust(&self) -> Vector4<f64> {
        -self.a.column(Longitudinal::W.index())
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
