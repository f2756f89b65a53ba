//! A response as the sum of its modes.
//!
//! With left and right eigenvectors, lᵢᴴ vᵢ = 1, every state is x = Σ vᵢ (lᵢᴴ x): the part of mode i is vᵢ zᵢ with its modal
//! coordinate zᵢ = lᵢᴴ x, and for a pair twice the real part. The split is taken from the exact response, sample by sample, so its
//! sum is that response to rounding, whatever the input. A coordinate of the path follows from a mode as vᵢ zᵢ passed through the
//! path's rates over λᵢ; what no mode makes, the drift of the path and what an input does at once, is a part of its own.

use nalgebra::{Complex, Vector2, Vector4};
use thiserror::Error;

use super::outputs::OutputRow;
use super::response::{DrivenSystem, PathRates, Response};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;

/// Above this condition number of a mode its part is not drawn: parts a thousand times the motion would cancel each other.
pub const WORST_SPLIT: f64 = 1e3;

/// An output split into the parts of its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalDecomposition {
    /// One a mode, in the order of the modes: the output's values at the samples.
    pub parts: Vec<Vec<f64>>,
    /// The part that no mode makes: what the input does at once, and the drift of the path.
    pub rest: Vec<f64>,
}

/// Why a response has no meaningful split.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SplitError {
    /// Eigenvectors nearly dependent, so that the parts would be huge and cancel each other.
    Dependent {
        /// The mode.
        name: ModeName,
        /// Its condition number.
        condition: f64,
    },
    /// A coordinate of the path, with a mode that neither dies away nor grows.
    Drift {
        /// The mode.
        name: ModeName,
    },
}

/// Splits an output of a response into the parts of the modes of its A.
pub fn modal_decomposition(
    modes: &[Mode],
    row: &OutputRow,
    forced: &DrivenSystem,
    response: &Response,
) -> Result<ModalDecomposition, SplitError> {
    let of_path = row.path != Vector2::zeros();
    let fastest = modes.iter().map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
    for mode in modes {
        let name = mode.naming.name;
        if mode.condition > WORST_SPLIT {
            return Err(SplitError::Dependent { name, condition: mode.condition });
        }
        if of_path && mode.lambda.norm() <= 1e-9 * fastest {
            return Err(SplitError::Drift { name });
        }
    }
    let readings: Vec<Reading> = modes.iter().map(|mode| Reading::new(mode, row, forced)).collect();
    let count = response.states.len();
    let mut sum = ModalDecomposition {
        parts: vec![Vec::with_capacity(count); modes.len()],
        rest: Vec::with_capacity(count),
    };
    for (x, whole) in response.states.iter().zip(row.of(forced, response)) {
        let mut rest = whole;
        for (part, reading) in sum.parts.iter_mut().zip(&readings) {
            let value = reading.of(x);
            rest -= value;
            part.push(value);
        }
        sum.rest.push(rest);
    }
    Ok(sum)
}

/// State and path at which a motion begins that stays in one mode: the real part of its shape, turned and scaled so that the
/// greatest of the states `angles` is `amplitude` \[rad\] at the start, and of its integral along the path, v/λ.
///
/// `angles` turns the states into angles to be compared: \[u, w, q, θ\] ↦ (w/V, θ), \[v, p, r, φ\] ↦ (v/V, φ). The path of a mode
/// that doesn't oscillate begins at zero: to be its integral it would have to come from far away.
pub fn single_mode(
    mode: &Mode,
    angles: [Vector4<f64>; 2],
    rates: &PathRates,
    amplitude: f64,
) -> (Vector4<f64>, Vector2<f64>) {
    let seen = angles.map(|row| row.map(Complex::from).dot(&mode.shape));
    let largest = if seen[0].norm() >= seen[1].norm() { seen[0] } else { seen[1] };
    let scale = if largest.norm() <= 1e-12 * mode.shape.norm() {
        // A mode without any angle: of the speed alone.
        Complex::from(amplitude)
    } else {
        Complex::from(amplitude) / largest
    };
    let state = (mode.shape * scale).map(|x| x.re);
    let path = (path_of_mode(mode, rates) * scale).map(|x| x.re);
    (state, if mode.is_oscillatory() { path } else { Vector2::zeros() })
}

/// How a mode's part of an output is read off the states: part = Re(g · lᴴ x), one row.
pub(super) struct Reading {
    states: Vector4<f64>,
    gain: Complex<f64>,
    adjoint: Vector4<Complex<f64>>,
}

impl Reading {
    pub fn new(mode: &Mode, row: &OutputRow, forced: &DrivenSystem) -> Self {
        let (v, l) = (&mode.shape, &mode.adjoint);
        let complex = |row: &Vector4<f64>| row.map(Complex::from);
        // y = c v z + k p with ṗ = K v z + P p, and all of a mode ∝ e^{λt}: p = (λ − P)⁻¹ K v z
        let mut gain = complex(&row.states).dot(v);
        if row.path != Vector2::zeros() {
            let path = path_of_mode(mode, &forced.path);
            gain += path[0] * row.path[0] + path[1] * row.path[1];
        }
        let gain = gain / l.dotc(v) * if mode.is_oscillatory() { 2.0 } else { 1.0 };
        Self { states: l.map(|l| (gain * l.conj()).re), gain, adjoint: *l }
    }

    /// The part at a state.
    pub fn of(&self, x: &Vector4<f64>) -> f64 {
        self.states.dot(x)
    }

    /// The part as an output of its own.
    pub fn row(&self, forced: &DrivenSystem) -> OutputRow {
        OutputRow {
            states: self.states,
            path: Vector2::zeros(),
            inputs: vec![(0.0, 0.0); forced.forcings.len()],
        }
    }

    /// Its envelope there: the largest that the part would be with another phase.
    pub fn envelope(&self, x: &Vector4<f64>) -> f64 {
        (self.gain * self.adjoint.dotc(&x.map(Complex::from))).norm()
    }
}

/// Path that belongs to a mode's shape while all goes as e^{λt}; not finite where λ is zero.
fn path_of_mode(mode: &Mode, rates: &PathRates) -> Vector2<Complex<f64>> {
    let driven: Vector2<Complex<f64>> = rates.of_states.map(Complex::from) * mode.shape;
    let first = driven[0] / mode.lambda;
    // P has only the entry by which the first coordinate drives the second.
    Vector2::new(first, (driven[1] + first * rates.of_path[(1, 0)]) / mode.lambda)
}
