//! How fast the state matrix moves with a parameter: the chain from the parameter to A with numbers that carry their rate.

use nalgebra::Matrix4;

use super::{Parameter, Place};
use crate::flight::aircraft::edits::Edited;
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::real::{Dual64, with_parameter};
use crate::flight::aircraft::study::{CoefficientStudy, DerivativeStudy, Study};
use crate::flight::modes::sensitivity::entry_rate;

impl Parameter {
    /// ∂A/∂p of a plane; zero of a parameter that doesn't enter it.
    pub(in crate::scenario) fn matrix_rate(&self, edited: &Edited, plane: Plane) -> Option<Matrix4<f64>> {
        let derivatives = match self.place {
            Place::LongitudinalCoefficient(_)
            | Place::LateralCoefficient(_)
            | Place::Knob(_)
            | Place::Condition(_) => {
                let Study::Coefficients(study) = &edited.study else { return None };
                edited.offsets.on(self.among_coefficients(study)?.derive().ok()?.derivatives)
            }
            Place::LongitudinalDerivative(_) | Place::LateralDerivative(_) => {
                self.among_derivatives(&edited.derivatives().ok()??)?
            }
            Place::A(of, row, column, sign) => {
                let models = edited.models().ok()?;
                models.planes[of].as_ref().and(models.planes[plane].as_ref())?;
                // p = ±a, so a = ±p
                let rate = if of == plane { sign } else { 0.0 };
                return Some(entry_rate(row, column) * rate);
            }
            Place::B(of, ..) => {
                let models = edited.models().ok()?;
                return models.planes[of]
                    .as_ref()
                    .and(models.planes[plane].as_ref())
                    .map(|_| Matrix4::zeros());
            }
            Place::Disturbance(_) => {
                return edited.models().ok()?.planes[plane].as_ref().map(|_| Matrix4::zeros());
            }
        };
        let rate = derivatives.models().planes[plane].as_ref()?.a.map(|x| x.eps);
        rate.iter().all(|x| x.is_finite()).then_some(rate)
    }

    /// The study with this coefficient, knob or flight condition as the parameter.
    fn among_coefficients(&self, study: &CoefficientStudy) -> Option<CoefficientStudy<Dual64>> {
        let mut dual = study.at_rest();
        let (given, c) = (&study.coefficients, &mut dual.coefficients);
        match self.place {
            Place::LongitudinalCoefficient(of) => c.longitudinal = with_parameter(&given.longitudinal, of),
            Place::LateralCoefficient(of) => c.lateral = Some(with_parameter(given.lateral.as_ref()?, of)),
            Place::Knob(of) => dual.knobs = with_parameter(&study.knobs, of),
            Place::Condition(of) => dual.condition = with_parameter(&study.condition, of),
            _ => return None,
        }
        Some(dual)
    }

    /// The study with this derivative as the parameter.
    fn among_derivatives(&self, study: &DerivativeStudy) -> Option<DerivativeStudy<Dual64>> {
        let mut dual = study.at_rest();
        match self.place {
            Place::LongitudinalDerivative(of) => {
                dual.longitudinal = Some(with_parameter(study.longitudinal.as_ref()?, of));
            }
            Place::LateralDerivative(of) => {
                dual.lateral = Some(with_parameter(study.lateral.as_ref()?, of));
            }
            _ => return None,
        }
        Some(dual)
    }
}
