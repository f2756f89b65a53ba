//! A mode with all its numbers.

use nalgebra::{Complex, Vector4};
use serde::Serialize;

use crate::flight::modes::mode::Mode;
use crate::key::Keyed;
use crate::words;

/// A mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Mode"))]
pub struct ModeReport {
    /// Key of the mode.
    #[cfg_attr(test, ts(type = "ModeKey"))]
    pub key: &'static str,
    /// Name of the mode.
    pub name: &'static str,
    /// Why, with numbers.
    pub reason: String,
    /// Share of the mode in the states that gave it its name, 0 to 1.
    pub confidence: f64,
    /// Real part σ of its eigenvalue.
    pub re: f64,
    /// Imaginary part ω ≥ 0 of its eigenvalue; positive stands for the pair σ ± jω.
    pub im: f64,
    /// `stable`, `neutral` or `unstable`.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub stability: &'static str,
    /// ωₙ, of an oscillation.
    pub natural_frequency: Option<f64>,
    /// ζ, negative when it grows; of an oscillation.
    pub damping_ratio: Option<f64>,
    /// ω_d, of an oscillation.
    pub damped_frequency: Option<f64>,
    /// T, of an oscillation.
    pub period: Option<f64>,
    /// t½, of what dies away.
    pub time_to_half: Option<f64>,
    /// t₂, of what grows.
    pub time_to_double: Option<f64>,
    /// Oscillations until the amplitude has halved or doubled.
    pub cycles: Option<f64>,
    /// τ = −1/λ, of a real mode.
    pub time_constant: Option<f64>,
    /// Share of each state, adding up to 1.
    pub participation: [f64; 4],
    /// Right eigenvector of unit length, \[real, imaginary\] of each state.
    pub eigenvector: [[f64; 2]; 4],
    /// Left eigenvector l of unit length, lᴴ A = λ lᴴ.
    pub left_eigenvector: [[f64; 2]; 4],
    /// Condition number of λ, its greatest movement for a relative change of A: 1 at best, 1e16 at a repeated root.
    pub condition: f64,
}

impl ModeReport {
    /// A mode as it is told.
    pub fn of(mode: &Mode) -> Self {
        let pairs = |vector: &Vector4<Complex<f64>>| std::array::from_fn(|k| [vector[k].re, vector[k].im]);
        let finite = |value: Option<f64>| value.filter(|x| x.is_finite());
        Self {
            key: mode.naming.name.key(),
            name: words::mode::title(mode.naming.name),
            reason: words::naming::reason(mode),
            confidence: mode.naming.confidence,
            re: mode.lambda.re,
            im: mode.lambda.im,
            stability: mode.stability.key(),
            natural_frequency: finite(mode.natural_frequency()),
            damping_ratio: finite(mode.damping_ratio()),
            damped_frequency: finite(mode.damped_frequency()),
            period: finite(mode.period()),
            time_to_half: finite(mode.time_to_half()),
            time_to_double: finite(mode.time_to_double()),
            cycles: finite(mode.cycles()),
            time_constant: finite(mode.time_constant()),
            participation: mode.participation,
            eigenvector: pairs(&mode.shape),
            left_eigenvector: pairs(&mode.adjoint),
            condition: mode.condition,
        }
    }
}
