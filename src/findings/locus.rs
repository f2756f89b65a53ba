//! The path along which a parameter would send the poles.

use std::rc::Rc;

use nalgebra::Matrix4;

use crate::flight::modes::locus::{Locus, locus};
use crate::scenario::{Disturbance, Parameter, Scenario};

/// Points of a path: twice what a wide screen can tell apart.
const EVALUATIONS: usize = 200;

/// The locus found last.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The scenario with the parameter at its reference.
    start: Scenario,
    key: &'static str,
    locus: Rc<Locus>,
}

/// The path of the poles along the whole range of a parameter's slider, from its reference: the one found last where that is the
/// same. It doesn't depend on where along it the parameter is, nor on the disturbance.
pub(super) fn known_or_found(
    known: &mut Option<Known>,
    scenario: &Scenario,
    parameter: &'static Parameter,
) -> Rc<Locus> {
    let mut start = scenario.clone();
    parameter.reset(&mut start);
    start.disturbance = Disturbance::default();
    match known {
        Some(known) if known.key == parameter.key && known.start == start => known.locus.clone(),
        _ => {
            let locus = Rc::new(locus_from(&start, parameter));
            *known = Some(Known { start, key: parameter.key, locus: locus.clone() });
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
