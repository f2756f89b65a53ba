//! Numbers that carry their derivative along: exact differentiation of any formula written with them.
//!
//! ε² = 0, so f(x + ε) = f(x) + f′(x) ε (Griewank & Walther, *Evaluating Derivatives*, 2008, §3). There is no step size and
//! no cancellation. Write a chain "slider → coefficient → derivative → A" with [`Dual`] and [`matrix_rate`] gives its ∂A/∂p.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Matrix4;

/// x + x′ε: a value and its derivative with respect to one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The value x.
    pub value: f64,
    /// Its derivative x′.
    pub rate: f64,
}

impl Dual {
    /// The parameter itself: its derivative is one.
    pub const fn parameter(value: f64) -> Self {
        Self { value, rate: 1.0 }
    }

    /// A constant: its derivative is zero.
    pub const fn constant(value: f64) -> Self {
        Self { value, rate: 0.0 }
    }

    /// sin x, x in radians.
    pub fn sin(self) -> Self {
        Self { value: self.value.sin(), rate: self.value.cos() * self.rate }
    }

    /// cos x, x in radians.
    pub fn cos(self) -> Self {
        Self { value: self.value.cos(), rate: -self.value.sin() * self.rate }
    }

    /// tan x, x in radians.
    pub fn tan(self) -> Self {
        // (tan x)′ = 1 + tan² x
        let tan = self.value.tan();
        Self { value: tan, rate: (1.0 + tan * tan) * self.rate }
    }

    /// √x.
    pub fn sqrt(self) -> Self {
        // (√x)′ = 1/(2√x)
        let root = self.value.sqrt();
        Self { value: root, rate: self.rate / (2.0 * root) }
    }

    /// eˣ.
    pub fn exp(self) -> Self {
        let exp = self.value.exp();
        Self { value: exp, rate: exp * self.rate }
    }

    /// xⁿ.
    pub fn powi(self, n: i32) -> Self {
        // (xⁿ)′ = n xⁿ⁻¹
        let slope = if n == 0 { 0.0 } else { f64::from(n) * self.value.powi(n.saturating_sub(1)) };
        Self { value: self.value.powi(n), rate: slope * self.rate }
    }
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self::constant(value)
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, rate: self.rate + other.rate }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, rate: self.rate - other.rate }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // (x y)′ = x′ y + x y′
        Self { value: self.value * other.value, rate: self.rate * other.value + self.value * other.rate }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, rate: self.rate * factor }
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // (x/y)′ = (x′ − (x/y) y′)/y
        let value = self.value / other.value;
        Self { value, rate: (self.rate - value * other.rate) / other.value }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate }
    }
}

/// A(p) and ∂A/∂p of a state matrix given row by row; `None` where either is not finite.
pub fn matrix_rate(a: impl FnOnce(Dual) -> [[Dual; 4]; 4], p: f64) -> Option<(Matrix4<f64>, Matrix4<f64>)> {
    let entries = a(Dual::parameter(p));
    let value = Matrix4::from_fn(|i, j| entries[i][j].value);
    let rate = Matrix4::from_fn(|i, j| entries[i][j].rate);
    value.iter().chain(rate.iter()).all(|x| x.is_finite()).then_some((value, rate))
}
