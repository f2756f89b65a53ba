//! What can be read of an aircraft, by key.

use serde::Serialize;

use super::error::ExportError;
use crate::findings::Findings;
use crate::findings::measures::{Measure, Reading};
use crate::key::{Keyed, nearest};
use crate::words;

/// A measure as it reads on an aircraft.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Measure"))]
pub struct MeasureReport {
    /// Its key.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// SI unit of the number; empty for a ratio or a verdict.
    pub unit: &'static str,
    /// A number in SI, or the key of a verdict; null where there is nothing to read.
    pub value: Option<MeasureValue>,
    /// The reason why there is nothing to read.
    pub absent: Option<String>,
}

/// A number in SI, or the key of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum MeasureValue {
    /// A number.
    Number(f64),
    /// A verdict on stability, or a level.
    Verdict(&'static str),
}

impl MeasureValue {
    fn of(reading: Reading) -> Self {
        match reading {
            Reading::Number(value) => Self::Number(value),
            Reading::Stability(stability) => Self::Verdict(stability.key()),
            Reading::Level(level) => Self::Verdict(level.key()),
        }
    }
}

impl MeasureReport {
    fn of(measure: Measure, findings: &Findings) -> Self {
        let read = measure.read(findings);
        let length = findings.scenario().units.length_of_reports();
        Self {
            key: measure.key(),
            name: words::measure::name(measure),
            unit: measure.dimension().si_symbol(),
            value: read.as_ref().ok().copied().map(MeasureValue::of),
            absent: read.err().map(|absence| words::measure::absence(&absence, length)),
        }
    }
}

/// The measures of an aircraft that have something to read; with `all`, the others too, each with its reason.
pub fn measures_of(findings: &Findings, all: bool) -> Vec<MeasureReport> {
    let reports = Measure::all().map(|measure| MeasureReport::of(measure, findings));
    reports.filter(|report| all || report.value.is_some()).collect()
}

/// The measure by a key in a request.
pub(super) fn find_measure(key: &str) -> Result<Measure, ExportError> {
    Measure::find(key).ok_or_else(|| {
        let keys: Vec<String> = Measure::all().map(Measure::key).collect();
        let nearest = nearest(key, keys.iter().map(String::as_str));
        ExportError::UnknownMeasure { key: key.to_owned(), nearest }
    })
}

/// What a measure reads, or nothing.
pub(super) fn value_of(measure: Measure, findings: &Findings) -> Option<MeasureValue> {
    measure.read(findings).ok().map(MeasureValue::of)
}
