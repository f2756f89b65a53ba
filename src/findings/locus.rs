//! The path along which a parameter would send the poles.

use std::rc::Rc;

use nalgebra::Matrix4;

use crate::flight::feedback::closed_model::{Appended, ClosedModel, appended_by};
use crate::flight::feedback::loop_modes::loop_modes;
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::modes::locus::{Locus, Poles, locus, locus_of};
use crate::scenario::{Disturbance, Parameter, Scenario};

/// Points of a path: twice what a wide screen can tell apart.
const EVALUATIONS: usize = 200;

/// The locus found last.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The scenario with the parameter at its reference.
    start: Scenario,
    key: &'static str,
    is_closed: bool,
    locus: Rc<Locus>,
}

/// The path of the poles along the whole range of a parameter's slider, from its reference, under the law or without it: the one found
/// last where that is the same. It doesn't depend on where along it the parameter is, nor on the disturbance.
pub(super) fn known_or_found(
    known: &mut Option<Known>,
    scenario: &Scenario,
    parameter: &'static Parameter,
    is_closed: bool,
) -> Rc<Locus> {
    let mut start = scenario.clone();
    parameter.reset(&mut start);
    start.disturbance = Disturbance::default();
    match known {
        Some(known) if (known.key, known.is_closed) == (parameter.key, is_closed) && known.start == start => {
            known.locus.clone()
        }
        _ => {
            let found =
                if is_closed { closed_from(&start, parameter) } else { locus_from(&start, parameter) };
            let locus = Rc::new(found);
            *known = Some(Known { start, key: parameter.key, is_closed, locus: locus.clone() });
            locus
        }
    }
}

fn locus_from(start: &Scenario, parameter: &Parameter) -> Locus {
    let range = parameter.range(start);
    let matrix = |value| -> Option<Matrix4<f64>> {
        let mut moved = start.clone();
        parameter.set(&mut moved, value);
        Some(moved.edited.models().ok()?.planes[start.plane].as_ref()?.a)
    };
    locus(start.plane, matrix, (*range.start(), *range.end()), parameter.get(start), EVALUATIONS)
}

/// The same under the law: over a gain the root locus of a course. The states are those of all of the range, so that every branch goes
/// from end to end.
fn closed_from(start: &Scenario, parameter: &Parameter) -> Locus {
    let range = parameter.range(start);
    let (low, high) = (*range.start(), *range.end());
    let at = |value: f64| -> Option<(Scenario, _)> {
        let mut moved = start.clone();
        parameter.set(&mut moved, value);
        let model = moved.edited.models().ok()?.planes[start.plane].take()?;
        Some((moved, model))
    };
    let states =
        [low, high].into_iter().filter_map(|value| at(value).map(|(of, model)| appended_by(&of.law, &model)));
    let states: Appended = states.max_by_key(|states| states.len()).unwrap_or_default();
    let closed = |value: f64| {
        let (of, model) = at(value)?;
        ClosedModel::with(&model, &of.law, states.clone()).ok()
    };
    let poles = |value: f64, _: Option<&Poles>| -> Option<Poles> {
        Some(eigenvalues(&closed(value)?.a).ok()?.iter().copied().collect())
    };
    let named = |value: f64| {
        let modes = loop_modes(&closed(value)?).ok()?;
        Some(modes.iter().map(|mode| (mode.mode.lambda, mode.mode.naming.name)).collect())
    };
    // Where a filter is zero it isn't there.
    let (low, reference) =
        if parameter.is_filter() { (NEARLY_NONE * high, high) } else { (low, parameter.get(start)) };
    locus_of(&poles, &named, (low, high), reference, EVALUATIONS)
}

/// The least time constant on the path of a filter, as a part of its range.
const NEARLY_NONE: f64 = 1e-3;
