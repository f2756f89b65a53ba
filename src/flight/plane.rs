//! The linear model of motion in one plane of symmetry's sense, ẋ = A x + B δ: longitudinal or lateral–directional.

use nalgebra::{Matrix4, Matrix4x2};

/// The two families of motion that separate for a symmetric aircraft in symmetric flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// x = \[u, w, q, θ\], inputs \[elevator δe, throttle δt\].
    Longitudinal,
    /// x = \[v, p, r, φ\], inputs \[aileron δa, rudder δr\].
    Lateral,
}

/// Steady flight about which the motion is linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trim {
    /// True airspeed V \[m/s\], positive.
    pub speed: f64,
    /// Angle of attack α₀ of the body x axis \[rad\]; zero in stability axes.
    pub alpha0: f64,
    /// Flight-path angle γ₀ \[rad\], climbing positive.
    pub gamma0: f64,
    /// Acceleration of free fall \[m/s²\].
    pub gravity: f64,
}

impl Trim {
    /// U₀ = V cos α₀ \[m/s\].
    pub fn u0(&self) -> f64 {
        self.speed * self.alpha0.cos()
    }

    /// W₀ = V sin α₀ \[m/s\].
    pub fn w0(&self) -> f64 {
        self.speed * self.alpha0.sin()
    }

    /// Pitch angle θ₀ = γ₀ + α₀ \[rad\].
    pub fn theta0(&self) -> f64 {
        self.gamma0 + self.alpha0
    }
}

/// Motion in one plane about a trim: ẋ = A x + B δ, SI and radians.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneModel {
    /// Which plane, and so which states and inputs.
    pub plane: Plane,
    /// State matrix.
    pub a: Matrix4<f64>,
    /// Input columns.
    pub b: Matrix4x2<f64>,
    /// The steady flight.
    pub trim: Trim,
}
