//! A motion under a law as the sum of its modes: as without one (see
//! [`modal_decomposition`](crate::flight::motion::modal_decomposition)), over all states, and what the law moves the controls by is a
//! part of the modes too.

use nalgebra::{Complex, DVector, RowDVector, Vector2, Vector4};

use super::closed_model::ClosedModel;
use super::loop_analysis::LoopAnalysis;
use super::loop_modes::LoopMode;
use crate::flight::motion::modal_decomposition::{ModalDecomposition, SplitError, WORST_SPLIT};
use crate::flight::motion::outputs::OutputRow;
use crate::flight::motion::response::PathRates;

/// A mode nearer to zero than this fraction of the fastest makes a drift of the path and no part of it.
const DRIFTS: f64 = 1e-9;

/// Splits an output with these values at the samples into the parts of the modes; `row` reads it off the aircraft's own equations with
/// what it is moved by beside behind the other inputs, and `states` are all of them.
pub fn split_closed(
    analysis: &LoopAnalysis,
    row: &OutputRow,
    path: &PathRates,
    states: &[DVector<f64>],
    values: &[f64],
) -> Result<ModalDecomposition, SplitError> {
    let LoopAnalysis { closed, modes, .. } = analysis;
    let of_path = row.path != Vector2::zeros();
    let fastest = modes.iter().map(|mode| mode.mode.lambda.norm()).fold(0.0, f64::max);
    for LoopMode { mode, .. } in modes {
        let name = mode.naming.name;
        if mode.condition > WORST_SPLIT {
            return Err(SplitError::Dependent { name, condition: mode.condition });
        }
        if of_path && mode.lambda.norm() <= DRIFTS * fastest {
            return Err(SplitError::Drift { name });
        }
    }
    let readings: Vec<RowDVector<f64>> = modes.iter().map(|mode| reading(closed, mode, row, path)).collect();
    let mut sum = ModalDecomposition {
        parts: readings.iter().map(|reading| states.iter().map(|x| reading.tr_dot(x)).collect()).collect(),
        rest: values.to_vec(),
    };
    for part in &sum.parts {
        for (rest, value) in sum.rest.iter_mut().zip(part) {
            *rest -= value;
        }
    }
    Ok(sum)
}

/// The row that reads a mode's part of an output off all states: part = Re(g lᴴ x), g = c v / (lᴴ v), twice that for a pair.
fn reading(closed: &ClosedModel, mode: &LoopMode, row: &OutputRow, path: &PathRates) -> RowDVector<f64> {
    let (v, l, lambda) = (&mode.shape, &mode.adjoint, mode.mode.lambda);
    let complex = |x: f64| Complex::from(x);
    let four = Vector4::from_fn(|k, _| v[k]);
    let mut gain = row.states.map(complex).dot(&four);
    // Behind the disturbances stand what the law moves each control by, and the further states of the source.
    let beside = row.inputs.len().saturating_sub(2 + closed.of_source());
    let mut courses = row.inputs.iter().skip(beside).map(|(direct, _)| *direct);
    for ((of_states, _), direct) in closed.controls().iter().zip(courses.by_ref()) {
        gain += of_states.map(complex).tr_dot(v) * direct;
    }
    for (k, direct) in courses.enumerate() {
        gain += v[4 + k] * direct;
    }
    if row.path != Vector2::zeros() {
        // ṗ = K v z + P p, all of a mode ∝ e^{λt}; P has only the entry by which the first coordinate drives the second
        let driven: Vector2<Complex<f64>> = path.of_states.map(complex) * four;
        let first = driven[0] / lambda;
        gain += first * row.path[0] + (driven[1] + first * path.of_path[(1, 0)]) / lambda * row.path[1];
    }
    let gain = gain / l.dotc(v) * if mode.mode.is_oscillatory() { 2.0 } else { 1.0 };
    RowDVector::from_fn(v.len(), |_, k| (gain * l[k].conj()).re)
}
