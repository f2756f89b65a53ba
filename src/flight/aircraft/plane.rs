//! The linear model of motion in one plane of symmetry's sense, ẋ = A x + B δ: longitudinal or lateral–directional.

use std::ops::{Index, IndexMut};
use std::sync::Arc;

use nalgebra::{Matrix4, Matrix4x2};

use super::further::FurtherStates;
use super::real::Real;
use crate::key::keys;

/// The two families of motion that separate for a symmetric aircraft in symmetric flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// x = \[u, w, q, θ\], inputs \[elevator δe, throttle δt\].
    Longitudinal,
    /// x = \[v, p, r, φ\], inputs \[aileron δa, rudder δr\].
    Lateral,
}

keys! {
    Plane {
        Longitudinal => "longitudinal" | "lon",
        Lateral => "lateral" | "lat",
    }
}

impl Plane {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Longitudinal, Self::Lateral];

    /// Before the keys of a link that there is one a plane of: `lon.source`.
    pub const fn short(self) -> &'static str {
        match self {
            Self::Longitudinal => "lon",
            Self::Lateral => "lat",
        }
    }
}

/// One thing for each plane: `pair.lateral`, or `pair[plane]` where the plane is a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ByPlane<T> {
    /// The value of longitudinal motion.
    pub longitudinal: T,
    /// The value of lateral–directional motion.
    pub lateral: T,
}

impl<T> ByPlane<T> {
    /// Both by one rule.
    pub fn from_fn(mut of: impl FnMut(Plane) -> T) -> Self {
        Self { longitudinal: of(Plane::Longitudinal), lateral: of(Plane::Lateral) }
    }

    /// Each by one rule.
    pub fn map<U>(self, mut of: impl FnMut(T) -> U) -> ByPlane<U> {
        ByPlane { longitudinal: of(self.longitudinal), lateral: of(self.lateral) }
    }

    /// Both to read, the longitudinal first.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        [&self.longitudinal, &self.lateral].into_iter()
    }

    /// Both to change, the longitudinal first.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        [&mut self.longitudinal, &mut self.lateral].into_iter()
    }
}

impl<T> Index<Plane> for ByPlane<T> {
    type Output = T;

    fn index(&self, plane: Plane) -> &T {
        match plane {
            Plane::Longitudinal => &self.longitudinal,
            Plane::Lateral => &self.lateral,
        }
    }
}

impl<T> IndexMut<Plane> for ByPlane<T> {
    fn index_mut(&mut self, plane: Plane) -> &mut T {
        match plane {
            Plane::Longitudinal => &mut self.longitudinal,
            Plane::Lateral => &mut self.lateral,
        }
    }
}

/// Steady flight about which the motion is linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trim<T = f64> {
    /// True airspeed V \[m/s\], positive.
    pub speed: T,
    /// Angle of attack α₀ of the body x axis \[rad\]; zero in stability axes.
    pub alpha0: f64,
    /// Flight-path angle γ₀ \[rad\], climbing positive.
    pub gamma0: T,
    /// Acceleration of free fall \[m/s²\].
    pub gravity: f64,
}

impl<T: Real> Trim<T> {
    /// U₀ = V cos α₀ \[m/s\].
    pub fn u0(&self) -> T {
        self.speed * self.alpha0.cos()
    }

    /// W₀ = V sin α₀ \[m/s\].
    pub fn w0(&self) -> T {
        self.speed * self.alpha0.sin()
    }

    /// Pitch angle θ₀ = γ₀ + α₀ \[rad\].
    pub fn theta0(&self) -> T {
        self.gamma0 + self.alpha0
    }
}

/// Motion in one plane about a trim: ẋ = A x + B δ, SI and radians.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneModel<T = f64> {
    /// Which plane, and so which states and inputs.
    pub plane: Plane,
    /// State matrix.
    pub a: Matrix4<T>,
    /// Input columns.
    pub b: Matrix4x2<T>,
    /// The steady flight.
    pub trim: Trim<T>,
    /// States beside the four, where the source has any; `None` otherwise.
    pub further: Option<Arc<FurtherStates>>,
}
