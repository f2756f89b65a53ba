//! How strongly each parameter moves each mode under a law of feedback, and each gain the modes of an aircraft without one.
//!
//! dλ/dp = lᴴ (∂A/∂p) v / (lᴴ v) as of four states, A being that of the whole. Of a gain ∂A/∂p is exact, since A goes straight with it;
//! of what the aircraft is made of it is the slope between two matrices near by.

use nalgebra::{Complex, DMatrix, DVector};

use super::sensitivities::{RowSensitivity, strengths};
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::feedback::closed_model::{Appended, ClosedModel, appended_by};
use crate::flight::feedback::loop_modes::LoopMode;
use crate::flight::feedback::{Law, LoopAnalysis};
use crate::flight::modes::eigen::eigen;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::sensitivity::{Sensitivity, moved_by};
use crate::scenario::{Page, Parameter, Scenario, parameters};

/// Half of the step between the two matrices, in notable changes of the parameter.
const STEP: f64 = 1e-3;

/// The sensitivities of `modes` to every parameter on a page that the aircraft has; under a law they are those of `flown`.
pub(super) fn of_page(
    scenario: &Scenario,
    modes: &[Mode],
    flown: Option<&LoopAnalysis>,
    page: Page,
) -> Vec<RowSensitivity> {
    let shown = parameters().filter(|p| p.is_shown(scenario, page));
    shown.filter_map(|p| row(scenario, modes, flown, p)).collect()
}

fn row(
    scenario: &Scenario,
    modes: &[Mode],
    flown: Option<&LoopAnalysis>,
    parameter: &'static Parameter,
) -> Option<RowSensitivity> {
    let (value, change) = (parameter.get(scenario), parameter.notable_change(scenario));
    if parameter.is_filter() && value == 0.0 {
        // A filter that isn't there has no rate: with a little of it the rate would come through otherwise, or a root from far away.
        return None;
    }
    let step = STEP * change;
    let at = |value: f64| {
        let mut moved = scenario.clone();
        parameter.set(&mut moved, value);
        let model = model_of(&moved)?;
        Some((moved.law, model))
    };
    let ((law, model), above, below) = (at(value)?, at(value + step)?, at(value - step)?);
    let [now, with_it] = [appended_by(&law, &model), appended_by(&above.0, &above.1)];
    let states = if with_it.len() > now.len() { with_it } else { now };
    let a = |(law, model): &(_, PlaneModel)| Some(ClosedModel::with(model, law, states.clone()).ok()?.a);
    let rate = (a(&above)? - a(&below)?) / (2.0 * step);
    let rates: Vec<Sensitivity> = match flown.filter(|closed| closed.closed.appended == states) {
        Some(closed) => {
            let of = |whole: &LoopMode| rate_of(&whole.mode, &whole.adjoint, &whole.shape, &rate);
            closed.modes.iter().map(of).collect()
        }
        None => among(modes, &law, &model, &states, &rate)?,
    };
    let strengths = strengths(modes, &rates, change);
    Some(RowSensitivity { key: parameter.key, change, modes: rates, strengths })
}

/// The same of modes in whose states the parameter has no part yet: those of the gain are added, and move nothing.
fn among(
    modes: &[Mode],
    law: &Law,
    model: &PlaneModel,
    states: &Appended,
    rate: &DMatrix<f64>,
) -> Option<Vec<Sensitivity>> {
    let whole = eigen(&ClosedModel::with(model, law, states.clone()).ok()?.a).ok()?;
    let of = |mode: &Mode| {
        let distance = |i: &usize| (whole.values[*i] - mode.lambda).norm();
        let nearest = (0..whole.values.len()).min_by(|i, j| distance(i).total_cmp(&distance(j)))?;
        let column = |matrix: &DMatrix<Complex<f64>>| matrix.column(nearest).into_owned();
        Some(rate_of(mode, &column(&whole.left), &column(&whole.right), rate))
    };
    modes.iter().map(of).collect()
}

fn rate_of(
    mode: &Mode,
    adjoint: &DVector<Complex<f64>>,
    shape: &DVector<Complex<f64>>,
    rate: &DMatrix<f64>,
) -> Sensitivity {
    let product = adjoint.dotc(shape);
    let moved = adjoint.dotc(&(rate.map(Complex::from) * shape)) / product;
    moved_by(mode, moved, mode.condition.max(1.0 / product.norm()))
}

/// The model of the plane on screen.
pub(super) fn model_of(scenario: &Scenario) -> Option<PlaneModel> {
    scenario.edited.models().ok()?.planes[scenario.plane].take()
}
