//! Requests and answers as JSON text: what JavaScript calls.
//!
//! A request is one object. It names its aircraft by one of `aircraft` (a key of the list), `toml` (the text of an aircraft file)
//! or `matrices` (the text of bare matrices, with `format`: `"json"`, `"csv"` or `"m"`); `file` is a name for messages, and
//! `set` holds values by the keys of the table of parameters \[SI, radians\]. What is asked stands beside them: the fields of
//! [`ResponseRequest`], [`FrequencyRequest`] or [`SweepRequest`]. A field that isn't known is a mistake.

use std::collections::BTreeMap;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::frequency::FrequencyRequest;
use super::respond::ResponseRequest;
use super::subject::{ExportError, Source, Subject};
use super::sweep::{Sweep, SweepRequest};
use crate::content::MatrixFormat;
use crate::findings::Findings;
use crate::scenario::Scenario;

/// The fields of a request that say which aircraft.
const SUBJECT: [&str; 8] = ["aircraft", "toml", "matrices", "format", "file", "set", "class", "category"];

/// Which aircraft, and what is set on it: one of `aircraft`, `toml` and `matrices`.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Subject", optional_fields))]
pub(super) struct SubjectForm {
    /// Key of an aircraft of the list, such as `navion`.
    aircraft: Option<String>,
    /// Text of an aircraft file.
    toml: Option<String>,
    /// Text of bare matrices A and B with named states.
    matrices: Option<String>,
    /// How `matrices` is written; `m` is MATLAB.
    #[cfg_attr(test, ts(optional, type = "MatrixFormat"))]
    format: Option<String>,
    /// Name of the text in messages.
    file: Option<String>,
    /// Values by the keys of the parameters \[SI, radians\].
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    set: BTreeMap<String, f64>,
    /// Class of aircraft that levels are judged for; that of the aircraft's file without one.
    #[cfg_attr(test, ts(optional, type = "AircraftClass"))]
    class: Option<String>,
    /// Category of flight phase that levels are judged for.
    #[cfg_attr(test, ts(optional, type = "FlightPhase"))]
    category: Option<String>,
}

/// A request with nothing beside its aircraft.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Nothing {}

/// The aircraft that ship: an array of [`super::AircraftReport`].
pub fn list() -> Result<String, ExportError> {
    written(&super::list())
}

/// The parameters of an aircraft: an array of [`super::ParameterReport`].
pub fn parameters(request: &str) -> Result<String, ExportError> {
    let (scenario, Nothing {}) = read(request)?;
    written(&super::parameters_of(&scenario))
}

/// What can be read of an aircraft: an array of [`super::MeasureReport`].
pub fn measures(request: &str) -> Result<String, ExportError> {
    let (scenario, Nothing {}) = read(request)?;
    written(&super::measures_of(&Findings::of(scenario), true))
}

/// Everything that follows for an aircraft: a [`super::Report`].
pub fn analyse(request: &str) -> Result<String, ExportError> {
    let (scenario, Nothing {}) = read(request)?;
    written(&super::analyse(&Findings::of(scenario))?)
}

/// The motion after a disturbance: a [`super::ResponseReport`].
pub fn respond(request: &str) -> Result<String, ExportError> {
    let (scenario, request): (_, ResponseRequest) = read(request)?;
    written(&super::respond(&scenario, &request)?)
}

/// Gain and phase over frequency: a [`super::FrequencyReport`].
pub fn frequency(request: &str) -> Result<String, ExportError> {
    let (scenario, request): (_, FrequencyRequest) = read(request)?;
    written(&super::frequency(&scenario, &request)?)
}

/// The modes along a parameter: a [`super::SweepReport`].
pub fn sweep(request: &str) -> Result<String, ExportError> {
    let (scenario, request): (_, SweepRequest) = read(request)?;
    written(&Sweep::new(scenario, &request)?.report())
}

fn read<T: DeserializeOwned>(request: &str) -> Result<(Scenario, T), ExportError> {
    let mut fields: Map<String, Value> = from(serde_json::from_str(request))?;
    let subject: Map<String, Value> = SUBJECT.iter().filter_map(|key| fields.remove_entry(*key)).collect();
    let form: SubjectForm = from(serde_json::from_value(Value::Object(subject)))?;
    let subject = form.subject()?;
    let request = from(serde_json::from_value(Value::Object(fields)))?;
    Ok((subject.scenario()?, request))
}

fn from<T>(outcome: Result<T, serde_json::Error>) -> Result<T, ExportError> {
    outcome.map_err(|error| ExportError::Request(format!("the request can't be read: {error}")))
}

fn written(answer: &impl Serialize) -> Result<String, ExportError> {
    serde_json::to_string(answer)
        .map_err(|error| ExportError::Request(format!("the answer can't be written: {error}")))
}

impl SubjectForm {
    fn subject(self) -> Result<Subject, ExportError> {
        let wrong = |problem: &str| Err(ExportError::Request(problem.to_owned()));
        let file = |default: &str| self.file.clone().unwrap_or_else(|| default.to_owned());
        let source = match (self.aircraft, self.toml, self.matrices, self.format.as_deref()) {
            (Some(key), None, None, None) => Source::Listed(key),
            (None, Some(text), None, None) => Source::Toml { file: file("aircraft.toml"), text },
            (None, None, Some(text), Some(format)) => {
                let known = MatrixFormat::NAMES.iter().find(|(name, _)| *name == format);
                match known {
                    Some(&(name, format)) => {
                        Source::Matrices { file: file(&format!("matrices.{name}")), text, format }
                    }
                    None => {
                        return wrong(&format!(
                            "format: expected \"json\", \"csv\" or \"m\", found \"{format}\""
                        ));
                    }
                }
            }
            (None, None, Some(_), None) => {
                return wrong("format: missing; expected \"json\", \"csv\" or \"m\" beside matrices");
            }
            (None, None, None, None) => {
                return wrong("the request names no aircraft; expected aircraft, toml or matrices");
            }
            _ => {
                return wrong("expected one of aircraft, toml and matrices, and format beside matrices only");
            }
        };
        Ok(Subject {
            source,
            set: self.set.into_iter().collect(),
            class: self.class,
            category: self.category,
        })
    }
}
