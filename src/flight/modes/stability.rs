//! Stable, neutral or unstable: of a motion as time goes on, or of a moment that meets a displacement.

use crate::key::keys;

/// Below this fraction of the largest |λ| of the matrix, a real part counts as zero.
///
/// Eigenvalues carry rounding of a few 1e-16 of the matrix norm; 1e-9 is far above that and far below any
/// growth rate a person could measure.
const NEUTRAL_FRACTION: f64 = 1e-9;

/// A verdict on stability, from the best to the worst: the verdict on a whole is the greatest of its parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stability {
    /// A disturbance dies away (σ < 0); a displacement meets a moment that points back.
    #[default]
    Stable,
    /// Neither, within rounding.
    Neutral,
    /// A disturbance grows (σ > 0); a displacement meets a moment that takes it further.
    Unstable,
}

keys! {
    Stability {
        Stable => "stable",
        Neutral => "neutral",
        Unstable => "unstable",
    }
}

/// Whether a motion with real part `sigma` grows, in a matrix whose largest |λ| is `spectral_radius`, both \[1/s\].
pub fn dynamic_stability(sigma: f64, spectral_radius: f64) -> Stability {
    if sigma.abs() <= NEUTRAL_FRACTION * spectral_radius {
        Stability::Neutral
    } else if sigma < 0.0 {
        Stability::Stable
    } else {
        Stability::Unstable
    }
}
