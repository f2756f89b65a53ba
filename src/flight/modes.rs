//! One natural mode of motion: an eigenvalue, its shape, and the numbers a course asks for.

use std::f64::consts::{LN_2, TAU};

use nalgebra::{Complex, Vector4};

use super::linear::Longitudinal;
use super::naming::Naming;

/// Below this fraction of the largest |λ| of the matrix, a real part counts as zero.
///
/// Eigenvalues carry rounding of a few 1e-16 of the matrix norm; 1e-9 is far above that and far below any
/// growth rate a person could measure.
const NEUTRAL_FRACTION: f64 = 1e-9;

/// What a disturbance in one mode, or in the whole aircraft, does as time goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DynamicStability {
    /// It dies away: σ < 0.
    Stable,
    /// It neither dies away nor grows: σ = 0 within rounding.
    Neutral,
    /// It grows: σ > 0.
    Unstable,
}

/// A natural mode: one real eigenvalue, or a conjugate pair counted once.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Eigenvalue λ = σ + jω \[1/s\] with ω ≥ 0; ω > 0 stands for the pair σ ± jω.
    pub lambda: Complex<f64>,
    /// Right eigenvector over \[u, w, q, θ\], SI, of unit length.
    pub shape: Vector4<Complex<f64>>,
    /// Participation of each state, |left × right| of that entry, adding up to 1.
    pub participation: [f64; 4],
    /// Its name and the reason for it.
    pub naming: Naming,
    /// Whether it dies away or grows.
    pub stability: DynamicStability,
}

impl Mode {
    /// Whether this is a conjugate pair.
    pub fn is_oscillatory(&self) -> bool {
        self.lambda.im > 0.0
    }

    /// Undamped natural frequency ωₙ = |λ| \[rad/s\]; of an oscillation only.
    pub fn natural_frequency(&self) -> Option<f64> {
        // ωₙ = √(σ² + ω²)
        self.is_oscillatory().then(|| self.lambda.norm())
    }

    /// Damping ratio ζ = −σ/ωₙ, negative when the oscillation grows; of an oscillation only.
    pub fn damping_ratio(&self) -> Option<f64> {
        self.natural_frequency().map(|wn| -self.lambda.re / wn)
    }

    /// Damped frequency ω_d = |Im λ| \[rad/s\]; of an oscillation only.
    pub fn damped_frequency(&self) -> Option<f64> {
        self.is_oscillatory().then_some(self.lambda.im)
    }

    /// Period T = 2π/ω_d \[s\]; of an oscillation only.
    pub fn period(&self) -> Option<f64> {
        self.damped_frequency().map(|wd| TAU / wd)
    }

    /// Time to half amplitude, ln 2/|σ| \[s\]; of a mode that dies away only.
    pub fn time_to_half(&self) -> Option<f64> {
        (self.stability == DynamicStability::Stable).then(|| LN_2 / -self.lambda.re)
    }

    /// Time to double amplitude, ln 2/σ \[s\]; of a mode that grows only.
    pub fn time_to_double(&self) -> Option<f64> {
        (self.stability == DynamicStability::Unstable).then(|| LN_2 / self.lambda.re)
    }

    /// Oscillations until the amplitude has halved or doubled, (ln 2/|σ|)/T.
    pub fn cycles(&self) -> Option<f64> {
        let time = self.time_to_half().or(self.time_to_double())?;
        Some(time / self.period()?)
    }

    /// Time constant τ = −1/λ \[s\], negative when growing; of a real mode that is not neutral only.
    pub fn time_constant(&self) -> Option<f64> {
        (!self.is_oscillatory() && self.stability != DynamicStability::Neutral).then(|| -1.0 / self.lambda.re)
    }

    /// Participation of one state, 0 to 1.
    pub fn share(&self, state: Longitudinal) -> f64 {
        self.participation[state.index()]
    }
}

/// Whether a motion with real part `sigma` grows, in a matrix whose largest |λ| is `spectral_radius`, both \[1/s\].
pub fn dynamic_stability(sigma: f64, spectral_radius: f64) -> DynamicStability {
    if sigma.abs() <= NEUTRAL_FRACTION * spectral_radius {
        DynamicStability::Neutral
    } else if sigma < 0.0 {
        DynamicStability::Stable
    } else {
        DynamicStability::Unstable
    }
}
