//! The lists to choose from: the aircraft, and the parameters of one of them.

use serde::Serialize;

use super::aircraft::AircraftReport;
use crate::content::embedded_aircraft;
use crate::key::Keyed;
use crate::scenario::{Scenario, parameters};

/// The aircraft that ship, in the order of the page's chooser.
pub fn list() -> Vec<AircraftReport> {
    embedded_aircraft().0.iter().map(AircraftReport::of).collect()
}

/// A parameter that can be set on an aircraft.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Parameter"))]
pub struct ParameterReport {
    /// Its key, in `set` and in a sweep.
    pub key: &'static str,
    /// Name in words.
    pub name: &'static str,
    /// Its meaning, in a sentence.
    pub meaning: &'static str,
    /// The sign that stabilises, or the effect of a positive or a larger value.
    pub sign: &'static str,
    /// SI unit of the numbers below; empty for a ratio.
    pub unit: &'static str,
    /// `longitudinal` or `lateral`; null for both.
    #[cfg_attr(test, ts(type = "PlaneName | null"))]
    pub plane: Option<&'static str>,
    /// Value on this aircraft.
    pub value: f64,
    /// Ends of its slider: the physical range.
    pub slider: [f64; 2],
    /// Least and greatest value that is accepted.
    pub accepted: [f64; 2],
}

/// The parameters that an aircraft has, in the order of the page.
pub fn parameters_of(scenario: &Scenario) -> Vec<ParameterReport> {
    let report = parameters().filter(|p| p.applies(scenario)).map(|p| {
        let (slider, accepted) = (p.range(scenario), p.accepted(scenario));
        ParameterReport {
            key: p.key,
            name: p.name,
            meaning: p.meaning,
            sign: p.sign,
            unit: p.dimension.si_symbol(),
            plane: p.plane.map(Keyed::key),
            value: p.get(scenario),
            slider: [*slider.start(), *slider.end()],
            accepted: [*accepted.start(), *accepted.end()],
        }
    });
    report.collect()
}
