//! How an eigenvalue moves when a parameter does: exact first derivatives.
//!
//! dλ/dp = lᴴ (∂A/∂p) v / (lᴴ v), with the left and right eigenvectors of the mode (Wilkinson, *The Algebraic
//! Eigenvalue Problem*, 1965, §2.5). Where two roots meet, λ turns like a square root and has no derivative; then the answer
//! says so and gives no number.

use nalgebra::{Complex, Matrix4};

use super::mode::Mode;

/// Above this condition number κ a root counts as repeated.
///
/// Eigenvectors carry an error of about κ·10⁻¹⁶, and lᴴv, itself 1/κ, a relative one of κ²·10⁻¹⁶: at 10⁵ a derivative is
/// still good to 10⁻⁶, and holds for changes of the matrix of 10⁻¹⁰ only. A slider can't stop that close to a meeting point by chance.
pub const REPEATED_CONDITION: f64 = 1e5;

/// Rate at which a mode moves with a parameter p, each per unit of p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// dλ/dp \[1/s per unit of p\].
    pub lambda: Complex<f64>,
    /// dωₙ/dp \[rad/s per unit of p\]; of an oscillation only.
    pub natural_frequency: Option<f64>,
    /// dζ/dp \[per unit of p\]; of an oscillation only.
    pub damping_ratio: Option<f64>,
}

impl Rate {
    /// dσ/dp, the rate of the real part: positive towards instability.
    pub fn sigma(&self) -> f64 {
        self.lambda.re
    }

    /// dω/dp, the rate of the damped frequency (of the upper pole of a pair).
    pub fn omega(&self) -> f64 {
        self.lambda.im
    }
}

/// How a mode answers a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sensitivity {
    /// The root is simple: its exact rate.
    Simple(Rate),
    /// The root is (nearly) repeated: it turns like a square root and has no rate worth a number.
    Repeated {
        /// Condition number of the eigenvalue, 10⁵ and more.
        condition: f64,
    },
    /// ∂A/∂p is not finite, or the rate too large for a number.
    NotFinite,
}

impl Sensitivity {
    /// The rate, if there is one.
    pub fn rate(&self) -> Option<Rate> {
        match self {
            Self::Simple(rate) => Some(*rate),
            Self::Repeated { .. } | Self::NotFinite => None,
        }
    }
}

/// Sensitivity of `mode` to a parameter p with the given ∂A/∂p.
pub fn sensitivity(mode: &Mode, a_rate: &Matrix4<f64>) -> Sensitivity {
    if mode.condition > REPEATED_CONDITION {
        return Sensitivity::Repeated { condition: mode.condition };
    }
    let (v, l) = (&mode.shape, &mode.adjoint);
    // dλ/dp = lᴴ (∂A/∂p) v / (lᴴ v); a real mode has real vectors, and its rate is real
    let mut moved = Complex::from(0.0);
    for i in 0..4 {
        for j in 0..4 {
            if a_rate[(i, j)] != 0.0 {
                moved += l[i].conj() * v[j] * a_rate[(i, j)];
            }
        }
    }
    moved_by(mode, moved / l.dotc(v), mode.condition)
}

/// How a mode answers a parameter that moves its λ at a rate, at a condition number of the whole of which it is a mode.
pub fn moved_by(mode: &Mode, lambda: Complex<f64>, condition: f64) -> Sensitivity {
    if condition > REPEATED_CONDITION {
        return Sensitivity::Repeated { condition };
    }
    if !(lambda.re.is_finite() && lambda.im.is_finite()) {
        return Sensitivity::NotFinite;
    }
    Sensitivity::Simple(rate_of(mode, lambda))
}

/// ∂A/∂p for p the entry of A in row i and column j: one there and zero elsewhere (all zero outside the matrix).
pub fn entry_rate(row: usize, column: usize) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| if (i, j) == (row, column) { 1.0 } else { 0.0 })
}

fn rate_of(mode: &Mode, lambda: Complex<f64>) -> Rate {
    let (wn, sigma) = (mode.lambda.norm(), mode.lambda.re);
    let (natural_frequency, damping_ratio) = if mode.is_oscillatory() {
        // dωₙ = Re(λ̄ dλ)/ωₙ, by division first: |λ|² may not be a number
        let unit = mode.lambda / wn;
        let d_wn = (unit.conj() * lambda).re;
        // ζ = −σ/ωₙ:  dζ = −(dσ − σ dωₙ/ωₙ)/ωₙ
        (Some(d_wn), Some(-(lambda.re - sigma / wn * d_wn) / wn))
    } else {
        (None, None)
    };
    let finite = |x: &f64| x.is_finite();
    Rate {
        lambda,
        natural_frequency: natural_frequency.filter(finite),
        damping_ratio: damping_ratio.filter(finite),
    }
}
