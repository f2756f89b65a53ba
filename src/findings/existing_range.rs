//! The part of a slider's range in which there is such an aircraft and such a flight.

use std::ops::RangeInclusive;

use crate::scenario::{Page, Parameter, Scenario, parameters};

/// Key of a parameter, and the part of its slider's range in which there is a flight \[SI\].
pub(super) type Of = (&'static str, RangeInclusive<f64>);

/// Halvings between a value that exists and one that doesn't: 4096 parts of the range, finer than a slider.
const HALVINGS: usize = 12;

/// Values that are tried where the present one doesn't exist.
const TRIED: usize = 24;

/// For each parameter of a page of which only a part of the range exists, that part \[SI\].
pub(super) fn of_page(scenario: &Scenario, page: Page) -> Vec<Of> {
    let partly = |p: &'static Parameter| Some((p.key, existing(scenario, p)?));
    parameters().filter(|p| p.is_shown(scenario, page)).filter_map(partly).collect()
}

/// The part of a parameter's range that exists with all others as they are, in one piece about the present value; `None` where all
/// of it does, or nothing.
fn existing(scenario: &Scenario, parameter: &Parameter) -> Option<RangeInclusive<f64>> {
    let (mut moved, plane) = (scenario.clone(), scenario.plane);
    let mut exists = |value: f64| {
        parameter.set(&mut moved, value);
        moved
            .edited
            .models()
            .is_ok_and(|models| models.problems.iter().all(|problem| problem.plane() != Some(plane)))
    };
    let (low, high) = parameter.range(scenario).into_inner();
    let ends = (exists(low), exists(high));
    if ends == (true, true) {
        return None;
    }
    let tried = (0..=TRIED).map(|k| low + (high - low) * k as f64 / TRIED as f64);
    let now = parameter.get(scenario).clamp(low, high);
    let inside = std::iter::once(now).chain(tried).find(|value| exists(*value))?;
    let mut edge = |end: f64| {
        let (mut good, mut bad) = (inside, end);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (good + bad);
            if exists(middle) { good = middle } else { bad = middle }
        }
        good
    };
    let from = if ends.0 { low } else { edge(low) };
    let to = if ends.1 { high } else { edge(high) };
    Some(from..=to)
}
