//! The modes of a model with states beside the four.

use nalgebra::{Complex, DMatrix, DVector, Dyn, Vector4};

use super::closed_model::ClosedModel;
use super::families::{Family, Root, followed};
use super::loop_naming::{Unnamed, name_modes};
use crate::flight::aircraft::further::AppendedState;
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::eigen::{Eigen, EigenError, eigen};
use crate::flight::modes::mode::{Mode, condition, modes};
use crate::flight::modes::mode_name::{Amplitudes, ModeName, UnnamedMode};
use crate::flight::modes::reason::Fact;
use crate::flight::modes::stability::{Stability, dynamic_stability};

/// A mode of a model with states beside the four.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopMode {
    /// The mode as it shows in the four states: eigenvectors and participation are theirs alone, of unit length and adding up to 1.
    /// Eigenvalue, condition number, stability and name are those of the whole.
    pub mode: Mode,
    /// Right eigenvector over all states, SI, of unit length.
    pub shape: DVector<Complex<f64>>,
    /// Left eigenvector over all states, of unit length.
    pub adjoint: DVector<Complex<f64>>,
    /// Participation of every state, adding up to 1.
    pub participation: Vec<f64>,
}

impl LoopMode {
    /// Share of the four states of the aircraft, 0 to 1.
    pub fn aircraft_share(&self) -> f64 {
        self.participation.iter().take(4).sum()
    }

    /// Whether a pilot feels it as a motion of the aircraft, so that it has to be judged: all but an oscillation that dies away and is
    /// mostly of states beside the four, with no root of the aircraft in it.
    pub fn is_of_flight(&self) -> bool {
        let Mode { naming, stability, .. } = &self.mode;
        let is_named = !matches!(naming.name, ModeName::FeedbackOscillation | ModeName::FurtherOscillation);
        let met = [Fact::MeetsFeedback, Fact::MeetsFurther];
        is_named
            || *stability == Stability::Unstable
            || self.aircraft_share() >= 0.5
            || naming.reason.facts.iter().any(|fact| met.contains(fact))
    }
}

/// The named modes of a model under a law, each conjugate pair once, in the order of
/// [`ModeName`](crate::flight::modes::mode_name::ModeName).
pub fn loop_modes(closed: &ClosedModel) -> Result<Vec<LoopMode>, EigenError> {
    let ClosedModel { model, a, .. } = closed;
    let eigen = eigen(a)?;
    let apart = closed.apart();
    let roots = followed(&modes(model)?, &apart, &(a - &apart))?;
    let families = families_of(closed, &eigen, roots, &apart);
    let spectral_radius = eigen.values.iter().map(|l| l.norm()).fold(0.0, f64::max);
    let still = |i: usize| is_still(closed, &families, &eigen.values, i);
    let kept: Vec<usize> =
        (0..eigen.values.len()).filter(|&i| eigen.values[i].im >= 0.0 || still(i)).collect();
    let unnamed: Vec<Unnamed> = kept
        .iter()
        .map(|&i| {
            let is_still = still(i);
            let lambda = if is_still { Complex::from(0.0) } else { eigen.values[i] };
            let stability = dynamic_stability(lambda.re, spectral_radius);
            let re = if stability == Stability::Neutral { 0.0 } else { lambda.re };
            let participation = eigen.participation(i).as_slice().to_vec();
            let shape = of_aircraft(&eigen.right.column(i).into_owned());
            let is_longitudinal = model.plane == Plane::Longitudinal;
            let rigid = UnnamedMode {
                lambda: Complex::new(re, lambda.im),
                participation: among_four(&participation),
                stability,
                amplitudes: is_longitudinal.then(|| Amplitudes::of(&model.trim, &shape)),
            };
            let other = if lambda.im > 0.0 { i + 1 } else { i };
            Unnamed { rigid, participation, families: [families[i], families[other]] }
        })
        .collect();
    let names = name_modes(closed, &unnamed);
    let mut modes: Vec<LoopMode> = kept
        .iter()
        .zip(unnamed)
        .zip(names)
        .map(|((&i, unnamed), naming)| {
            let (shape, adjoint) = (eigen.right.column(i).into_owned(), eigen.left.column(i).into_owned());
            LoopMode {
                mode: Mode {
                    lambda: unnamed.rigid.lambda,
                    shape: of_aircraft(&shape),
                    adjoint: of_aircraft(&adjoint),
                    condition: condition(&eigen, i, spectral_radius),
                    participation: unnamed.rigid.participation,
                    naming,
                    stability: unnamed.rigid.stability,
                },
                shape,
                adjoint,
                participation: unnamed.participation,
            }
        })
        .collect();
    modes.sort_by_key(|mode| mode.mode.naming.name);
    Ok(modes)
}

/// A height, heading or position moves so much more slowly than the fastest mode where it only seems to: a source that is found by
/// differences has entries of that size.
const STILL: f64 = 1e-6;

/// Whether a root is one of the path that stays where it is; of a pair both are.
fn is_still(closed: &ClosedModel, families: &[Family], values: &DVector<Complex<f64>>, i: usize) -> bool {
    let is_of_path = |i: &usize| match families[*i] {
        Family::Appended(k) => k < closed.of_source() && closed.appended[k].is_of_path(),
        _ => false,
    };
    let pair = match values[i].im {
        im if im > 0.0 => i..=i + 1,
        im if im < 0.0 => i - 1..=i,
        _ => i..=i,
    };
    let radius = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    values[i].norm() <= STILL * radius && pair.into_iter().all(|i| is_of_path(&i))
}

/// The family of each eigenvalue, from the roots that were followed to it.
fn families_of(
    closed: &ClosedModel,
    eigen: &Eigen<Dyn>,
    mut roots: Vec<Root>,
    apart: &DMatrix<f64>,
) -> Vec<Family> {
    let nearest = |value: &Complex<f64>| {
        let distance = |root: &Root| (root.0 - value).norm();
        let k = (0..roots.len()).min_by(|&i, &j| distance(&roots[i]).total_cmp(&distance(&roots[j])));
        k.map_or(Family::Lateral, |k| roots.swap_remove(k).1)
    };
    let mut families: Vec<Family> = eigen.values.iter().map(nearest).collect();
    let washout = closed.appended.iter().position(|state| *state == AppendedState::YawRateWashout);
    let n = families.len();
    let participations: Vec<DVector<f64>> = (0..n).map(|i| eigen.participation(i)).collect();
    let share = |i: usize, family: Family| {
        let participation = participations[i].as_slice();
        // A turn fills the washout, which is then as much of the spiral as the bank angle.
        let filled = washout.filter(|_| family == Family::Spiral).map_or(0.0, |k| participation[4 + k]);
        family.share(participation) + filled
    };
    let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect();
    // Whether both roots of a pair are of one family, so that it has a name that an exchange would take away.
    let is_whole = |families: &[Family], i: usize| match eigen.values[i].im {
        im if im > 0.0 => families[i] == families[i + 1],
        im if im < 0.0 => families[i] == families[i - 1],
        _ => false,
    };
    let is_truer = |families: &[Family], (i, j): (usize, usize)| {
        let (of_i, of_j) = (families[i], families[j]);
        let needed = match (of_i, of_j) {
            // Actuators of one lag, or integrals, begin at one root: which is whose is told by their states alone.
            (Family::Appended(k), Family::Appended(l)) if apart[(4 + k, 4 + k)] == apart[(4 + l, 4 + l)] => {
                SAME
            }
            _ if is_whole(families, i) || is_whole(families, j) => MUCH_TRUER,
            _ => TRUER,
        };
        share(i, of_j) + share(j, of_i) > share(i, of_i) + share(j, of_j) + needed
    };
    // Each exchange makes the names truer, so that they come to an end.
    while let Some(&(i, j)) = pairs.iter().find(|pair| is_truer(&families, **pair)) {
        families.swap(i, j);
    }
    families
}

/// So much more of the participation must names tell when exchanged than as they were followed: roots that cross on the axis, or that
/// the gains carry into each other's place, have gone ways that tell nothing of what they are.
const TRUER: f64 = 0.25;

/// The same where a pair of one family would become one of two.
const MUCH_TRUER: f64 = 1.0;

/// Rounding of shares.
const SAME: f64 = 1e-9;

/// The four states' part of a vector, of unit length; zero where it has none.
fn of_aircraft(vector: &DVector<Complex<f64>>) -> Vector4<Complex<f64>> {
    let part = Vector4::from_fn(|k, _| vector[k]);
    let length = part.norm();
    if length > f64::MIN_POSITIVE { part.unscale(length) } else { Vector4::zeros() }
}

/// Participation of the four states among themselves; even where they have none.
fn among_four(participation: &[f64]) -> [f64; 4] {
    let sum: f64 = participation.iter().take(4).sum();
    std::array::from_fn(|k| if sum > f64::MIN_POSITIVE { participation[k] / sum } else { 0.25 })
}

/// One mode alone at the start: the real part of its shape, turned and scaled so that the greatest of `angles` is `amplitude` \[rad\].
///
/// `angles` are rows over the four states, as of [`single_mode`](crate::flight::motion::modal_decomposition::single_mode).
pub fn start_in(mode: &LoopMode, angles: [Vector4<f64>; 2], amplitude: f64) -> DVector<f64> {
    let four = Vector4::from_fn(|k, _| mode.shape[k]);
    let seen = angles.map(|row| row.map(Complex::from).dot(&four));
    let largest = if seen[0].norm() >= seen[1].norm() { seen[0] } else { seen[1] };
    let scale = if largest.norm() <= 1e-12 * mode.shape.norm() {
        Complex::from(amplitude)
    } else {
        Complex::from(amplitude) / largest
    };
    mode.shape.map(|x| (x * scale).re)
}
