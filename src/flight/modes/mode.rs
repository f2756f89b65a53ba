//! One natural mode of motion: an eigenvalue, its shape, and the numbers a course asks for.

use std::f64::consts::{LN_2, TAU};

use nalgebra::{Complex, DefaultAllocator, Matrix4, Vector4};
use smallvec::SmallVec;

use super::eigen::{Eigen, EigenError, eigen};
use super::mode_name::{Amplitudes, Naming, UnnamedMode};
use super::naming::name_modes;
use super::schur::{Room, Size};
use super::stability::{Stability, dynamic_stability};
use crate::few;
use crate::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use crate::flight::aircraft::states::State;

/// The largest condition number told: the reciprocal of rounding, where nothing is known of the root any more.
pub const WORST_CONDITION: f64 = 1e16;

/// Closer than this fraction of the largest |λ| of the matrix, two eigenvalues count as one repeated root.
const REPEATED_FRACTION: f64 = 1e-8;

/// A natural mode: one real eigenvalue, or a conjugate pair counted once.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Eigenvalue λ = σ + jω \[1/s\] with ω ≥ 0; ω > 0 stands for the pair σ ± jω.
    pub lambda: Complex<f64>,
    /// Right eigenvector v over \[u, w, q, θ\] or \[v, p, r, φ\], SI, of unit length.
    pub shape: Vector4<Complex<f64>>,
    /// Left eigenvector l, lᴴ A = λ lᴴ, of unit length: how strongly each state excites the mode.
    pub adjoint: Vector4<Complex<f64>>,
    /// How far λ moves, at worst, for a relative change of the matrix: 1 at best, [`WORST_CONDITION`] at a repeated root.
    pub condition: f64,
    /// Participation of each state, |left × right| of that entry, adding up to 1.
    pub participation: [f64; 4],
    /// Its name and the reason for it.
    pub naming: Naming,
    /// Whether it dies away or grows.
    pub stability: Stability,
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
        // Adding zero makes −0 a 0.
        self.natural_frequency().map(|wn| -self.lambda.re / wn + 0.0)
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
        (self.stability == Stability::Stable).then(|| LN_2 / -self.lambda.re)
    }

    /// Time to double amplitude, ln 2/σ \[s\]; of a mode that grows only.
    pub fn time_to_double(&self) -> Option<f64> {
        (self.stability == Stability::Unstable).then(|| LN_2 / self.lambda.re)
    }

    /// Oscillations until the amplitude has halved or doubled, (ln 2/|σ|)/T.
    pub fn cycles(&self) -> Option<f64> {
        let time = self.time_to_half().or(self.time_to_double())?;
        Some(time / self.period()?)
    }

    /// Time constant τ = −1/λ \[s\], negative when growing; of a real mode that is not neutral only.
    pub fn time_constant(&self) -> Option<f64> {
        (!self.is_oscillatory() && self.stability != Stability::Neutral).then(|| -1.0 / self.lambda.re)
    }

    /// Participation of one state, 0 to 1.
    pub fn share(&self, state: impl State) -> f64 {
        self.participation[state.index()]
    }

    /// Component of one state in the eigenvector.
    pub fn component(&self, state: impl State) -> Complex<f64> {
        self.shape[state.index()]
    }
}

/// The named modes of a model, each conjugate pair once, in the order of [`super::mode_name::ModeName`].
pub fn modes(model: &PlaneModel) -> Result<Vec<Mode>, EigenError> {
    named_modes(model.plane, &model.a, Some(&model.trim))
}

/// The named modes of a state matrix of one plane, in the order of [`super::mode_name::ModeName`].
///
/// Without a trim no angle of attack is known, so reasons say nothing of amplitudes.
pub fn modes_of(plane: Plane, a: &Matrix4<f64>) -> Result<Vec<Mode>, EigenError> {
    named_modes(plane, a, None)
}

fn named_modes(plane: Plane, a: &Matrix4<f64>, trim: Option<&Trim>) -> Result<Vec<Mode>, EigenError> {
    let eigen = eigen(a)?;
    let spectral_radius = eigen.values.iter().map(|l| l.norm()).fold(0.0, f64::max);
    let kept: Vec<usize> = (0..4).filter(|&i| eigen.values[i].im >= 0.0).collect();
    let trim = trim.filter(|_| plane == Plane::Longitudinal);
    let unnamed: SmallVec<[UnnamedMode; 4]> = kept
        .iter()
        .map(|&i| {
            let lambda = eigen.values[i];
            let stability = dynamic_stability(lambda.re, spectral_radius);
            // What is neither stable nor unstable has rounding for a real part.
            let re = if stability == Stability::Neutral { 0.0 } else { lambda.re };
            let amplitudes = trim.map(|trim| Amplitudes::of(trim, &eigen.right.column(i).into_owned()));
            let participation = eigen.participation(i).into();
            UnnamedMode { lambda: Complex::new(re, lambda.im), participation, stability, amplitudes }
        })
        .collect();
    let mut modes: Vec<Mode> = kept
        .iter()
        .zip(&unnamed)
        .zip(name_modes(plane, &unnamed))
        .map(|((&i, mode), naming)| Mode {
            lambda: mode.lambda,
            shape: Vector4::from(eigen.right.column(i)),
            adjoint: Vector4::from(eigen.left.column(i)),
            condition: condition(&eigen, i, spectral_radius),
            participation: mode.participation,
            naming,
            stability: mode.stability,
        })
        .collect();
    few::sort_by_key(&mut modes, |mode| mode.naming.name);
    Ok(modes)
}

/// Condition number of eigenvalue `i`, the least that any units of the states could give it.
///
/// 1/|lᴴv| depends on the units (Wilkinson 1965). Over all diagonal scalings its least value is Σ|lₖ||vₖ| / |lᴴv|, by the
/// inequality of Cauchy and Schwarz. Two equal eigenvalues with independent vectors would still read 1, but no derivative of
/// either is defined: there ρ/gap stands instead.
pub(in crate::flight) fn condition<N: Size>(eigen: &Eigen<N>, i: usize, spectral_radius: f64) -> f64
where
    DefaultAllocator: Room<N>,
{
    let (v, l) = (eigen.right.column(i), eigen.left.column(i));
    let (product, sum) =
        (l.dotc(&v).norm(), v.iter().zip(l.iter()).map(|(v, l)| v.norm() * l.norm()).sum::<f64>());
    let of_vectors = if product > 0.0 { sum / product } else { WORST_CONDITION };
    let gap = (0..eigen.values.len())
        .filter(|&j| j != i)
        .map(|j| (eigen.values[j] - eigen.values[i]).norm())
        .fold(f64::INFINITY, f64::min);
    let of_gap = if gap > REPEATED_FRACTION * spectral_radius {
        1.0
    } else if gap > 0.0 {
        spectral_radius / gap
    } else {
        WORST_CONDITION
    };
    // `max` and `min` also turn a NaN of 0/0 into a bound.
    of_vectors.max(of_gap).clamp(1.0, WORST_CONDITION)
}
