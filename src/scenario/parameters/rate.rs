//! Rate of the state matrix with a parameter: the chain from the parameter to A, on numbers that carry their rate.

use nalgebra::Matrix4;

use super::{Parameter, Place};
use crate::flight::aircraft::aircraft_model::{AircraftModel, CoefficientModel, DerivativeModel};
use crate::flight::aircraft::edits::EditedModel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::real::{Dual64, seeded};
use crate::flight::modes::sensitivity::entry_rate;

impl Parameter {
    /// ∂A/∂p of a plane, exactly; zero of a parameter that doesn't enter it, `None` where the parameter or the model is missing, or
    /// where the parameter can't be moved.
    pub fn matrix_rate(&self, edited: &EditedModel, plane: Plane) -> Option<Matrix4<f64>> {
        let rate = match self.place {
            Place::LongitudinalCoefficient(of) => of_coefficients(edited, plane, |given, dual| {
                dual.coefficients.longitudinal = seeded(&given.coefficients.longitudinal, of);
                Some(())
            }),
            Place::LateralCoefficient(of) => of_coefficients(edited, plane, |given, dual| {
                let lateral = given.coefficients.lateral.as_ref()?;
                dual.coefficients.lateral = Some(seeded(lateral, of));
                Some(())
            }),
            Place::Knob(of) => of_coefficients(edited, plane, |given, dual| {
                dual.knobs = seeded(&given.knobs, of);
                Some(())
            }),
            Place::Condition(of) => of_coefficients(edited, plane, |given, dual| {
                dual.condition = seeded(&given.condition, of);
                Some(())
            }),
            Place::LongitudinalDerivative(of) => of_derivatives(edited, plane, |given, dual| {
                dual.longitudinal = Some(seeded(given.longitudinal.as_ref()?, of));
                Some(())
            }),
            Place::LateralDerivative(of) => of_derivatives(edited, plane, |given, dual| {
                dual.lateral = Some(seeded(given.lateral.as_ref()?, of));
                Some(())
            }),
            Place::A(of, row, column, sign) => {
                let models = edited.models().ok()?;
                models.planes[of].as_ref().and(models.planes[plane].as_ref())?;
                // p = ±a, so a = ±p
                Some(entry_rate(row, column) * if of == plane { sign } else { 0.0 })
            }
            Place::B(of, ..) => {
                let models = edited.models().ok()?;
                models.planes[of].as_ref().and(models.planes[plane].as_ref()).map(|_| Matrix4::zeros())
            }
            // A law leaves the aircraft's own A as it is.
            Place::Feedback(_) | Place::Disturbance(_) => {
                edited.models().ok()?.planes[plane].as_ref().map(|_| Matrix4::zeros())
            }
        };
        rate.filter(|rate| rate.iter().all(|x| x.is_finite()))
    }
}

/// ∂A/∂p through the whole chain; `seed` makes one number of the study the parameter.
fn of_coefficients(
    edited: &EditedModel,
    plane: Plane,
    seed: impl FnOnce(&CoefficientModel, &mut CoefficientModel<Dual64>) -> Option<()>,
) -> Option<Matrix4<f64>> {
    let AircraftModel::Coefficients(given) = &edited.aircraft_model else { return None };
    let mut dual = given.constant();
    seed(given, &mut dual)?;
    of_models(&edited.offsets.on(dual.derive().ok()?.derivatives), plane)
}

/// ∂A/∂p from the derivatives on; `seed` makes one of them the parameter.
fn of_derivatives(
    edited: &EditedModel,
    plane: Plane,
    seed: impl FnOnce(&DerivativeModel, &mut DerivativeModel<Dual64>) -> Option<()>,
) -> Option<Matrix4<f64>> {
    let given = edited.derivatives().ok()??;
    let mut dual = given.constant();
    seed(&given, &mut dual)?;
    of_models(&dual, plane)
}

fn of_models(aircraft_model: &DerivativeModel<Dual64>, plane: Plane) -> Option<Matrix4<f64>> {
    Some(aircraft_model.models().planes[plane].as_ref()?.a.map(|x| x.eps))
}
