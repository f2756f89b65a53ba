//! A study with what a person has changed beyond it: offsets on dimensional derivatives and on entries of the matrices.
//!
//! ```text
//! coefficients, knobs, condition ──► derivatives + offsets ──► A, B + offsets
//! ```
//!
//! An offset stays while what lies before it changes, so every page of sliders can be edited at any time.

use nalgebra::{Matrix4, Matrix4x2};

use super::aircraft_model::{AircraftModel, DerivativeModel, ModelError, Models};
use super::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use super::plane::{ByPlane, Plane};
use super::real::{Real, Record};

/// Offsets that a person has added to the derivatives and matrices that follow from the model; all zero at first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Offsets {
    /// Added to the longitudinal derivatives.
    pub longitudinal: LongitudinalDerivatives,
    /// Added to the lateral derivatives.
    pub lateral: LateralDerivatives,
    /// Added to the matrices of the models.
    pub matrices: ByPlane<MatrixOffsets>,
}

/// Added to A and B.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MatrixOffsets {
    /// Added to A.
    pub a: Matrix4<f64>,
    /// Added to B.
    pub b: Matrix4x2<f64>,
}

impl Offsets {
    /// Derivatives with their offsets.
    pub fn on<T: Real>(&self, aircraft_model: DerivativeModel<T>) -> DerivativeModel<T> {
        let DerivativeModel { trim, inertia, longitudinal, lateral } = aircraft_model;
        DerivativeModel {
            trim,
            inertia,
            longitudinal: longitudinal.map(|d| d.zip(&self.longitudinal, |x, offset: f64| x + offset)),
            lateral: lateral.map(|d| d.zip(&self.lateral, |x, offset: f64| x + offset)),
        }
    }
}

/// A study and the offsets on what follows from it.
#[derive(Clone, Debug, PartialEq)]
pub struct EditedModel {
    /// Coefficients, knobs and flight condition, or whatever the source has.
    pub aircraft_model: AircraftModel,
    /// Beyond it.
    pub offsets: Offsets,
}

impl EditedModel {
    /// A study as it is.
    pub fn new(aircraft_model: AircraftModel) -> Self {
        Self { aircraft_model, offsets: Offsets::default() }
    }

    /// Dimensional derivatives with their offsets; `None` where the source has bare matrices.
    pub fn derivatives(&self) -> Result<Option<DerivativeModel>, ModelError> {
        Ok(self.aircraft_model.to_derivatives()?.map(|aircraft_model| self.offsets.on(aircraft_model)))
    }

    /// Dimensional derivatives from which the matrices of a plane follow; `None` where the source has bare matrices, or
    /// entries have been edited apart from any derivative.
    pub fn derivatives_behind(&self, plane: Plane) -> Option<DerivativeModel> {
        let untouched = self.offsets.matrices[plane] == MatrixOffsets::default();
        if untouched { self.derivatives().ok()? } else { None }
    }

    /// The models before the offsets on their matrices.
    pub fn models_of_derivatives(&self) -> Result<Models, ModelError> {
        match self.derivatives()? {
            Some(derivatives) => Ok(derivatives.models()),
            None => self.aircraft_model.models(),
        }
    }

    /// The models of both planes.
    pub fn models(&self) -> Result<Models, ModelError> {
        let mut models = self.models_of_derivatives()?;
        for model in models.planes.iter_mut().flatten() {
            let offsets = &self.offsets.matrices[model.plane];
            model.a += offsets.a;
            model.b += offsets.b;
        }
        Ok(models)
    }
}
