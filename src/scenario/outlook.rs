//! What a slider would do: how strongly it moves each mode, and the path along which it would send the poles.

use nalgebra::Matrix4;

use super::Scenario;
use super::parameters::{Page, Parameter, parameters};
use crate::flight::aircraft::coefficients::Coefficients;
use crate::flight::aircraft::study::Study;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::locus::{Locus, locus};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::sensitivity::{Sensitivity, sensitivity};

/// Points of a path: twice what a wide screen can tell apart.
const LOCUS_EVALUATIONS: usize = 200;

/// How one parameter moves the modes of the studied plane.
#[derive(Clone, Debug, PartialEq)]
pub struct RowSensitivity {
    /// Key of the parameter.
    pub key: &'static str,
    /// The change of the parameter that is meant \[SI\]: ten per cent more of its size, or a sixtieth of its slider where it is near zero.
    pub change: f64,
    /// One a mode, in the order of the analysis, per unit of the parameter.
    pub modes: Vec<Sensitivity>,
    /// Size of the move of each λ relative to |λ| for that change; `None` at a repeated root.
    pub strengths: Vec<Option<f64>>,
}

impl Scenario {
    /// The sensitivities of every parameter on a page that the aircraft has.
    pub fn sensitivities(&self, analysis: &PlaneAnalysis, page: Page) -> Vec<RowSensitivity> {
        parameters()
            .filter(|p| p.is_shown(self, page))
            .filter_map(|p| self.sensitivity(analysis, p))
            .collect()
    }

    /// The coefficients with knobs and flight condition applied; `None` where the source has none or there is no such flight.
    pub fn coefficients_in_effect(&self) -> Option<Coefficients> {
        match &self.edited.study {
            Study::Coefficients(study) => Some(study.derive().ok()?.coefficients),
            Study::Derivatives(_) | Study::Matrices(_) => None,
        }
    }

    fn sensitivity(&self, analysis: &PlaneAnalysis, parameter: &'static Parameter) -> Option<RowSensitivity> {
        let a_rate = self.matrix_rate(parameter)?;
        let change = parameter.notable_change(self);
        let modes: Vec<Sensitivity> = analysis.modes.iter().map(|mode| sensitivity(mode, &a_rate)).collect();
        let fastest = analysis.modes.iter().map(|mode| mode.lambda.norm()).fold(f64::MIN_POSITIVE, f64::max);
        let strength = |(mode, sensitivity): (&Mode, &Sensitivity)| {
            let size = mode.lambda.norm().max(1e-3 * fastest);
            sensitivity.rate().map(|rate| (rate.lambda.norm() * change / size).min(f64::MAX))
        };
        let strengths = analysis.modes.iter().zip(&modes).map(strength).collect();
        Some(RowSensitivity { key: parameter.key, change, modes, strengths })
    }

    /// ∂A/∂p of the studied plane, exactly; `None` where the parameter or the model is missing, or where the parameter can't be
    /// moved.
    pub fn matrix_rate(&self, parameter: &Parameter) -> Option<Matrix4<f64>> {
        parameter.matrix_rate(&self.edited, self.plane)
    }

    /// A of the studied plane with one parameter at another value.
    fn matrix_at(&self, parameter: &Parameter, value: f64) -> Option<Matrix4<f64>> {
        let mut moved = self.clone();
        parameter.set(&mut moved, value);
        Some(moved.edited.models().ok()?.planes[self.plane].as_ref()?.a)
    }

    /// The path of the poles along the whole range of a parameter's slider.
    pub fn locus(&self, parameter: &Parameter) -> Locus {
        let range = parameter.range(self);
        locus(
            self.plane,
            |value| self.matrix_at(parameter, value),
            (*range.start(), *range.end()),
            parameter.get(self),
            LOCUS_EVALUATIONS,
        )
    }
}
