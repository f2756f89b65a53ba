//! Requests and answers as JSON text: what JavaScript calls.
//!
//! A request is one object. It names its aircraft by one of `aircraft` (a key of the list), `link` (a link to a scene), `toml` (the
//! text of an aircraft file) or `matrices` (the text of bare matrices, with `format`: `"json"`, `"csv"` or `"m"`); `file` is a name for messages, and
//! `set` holds values by the keys of the table of parameters \[SI, radians\]. What is asked stands beside them: the fields of
//! [`ResponseRequest`], [`FrequencyRequest`], [`SweepRequest`] or [`DisturbanceRequest`]. A field that isn't known is a mistake.

use std::collections::BTreeMap;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::error::ExportError;
use super::frequency::FrequencyRequest;
use super::link::DisturbanceRequest;
use super::respond::ResponseRequest;
use super::scene::Scene;
use super::subject::{Source, Subject};
use super::sweep::{Sweep, SweepRequest};
use crate::content::MatrixFormat;
use crate::content::import::{self, FileBytes};
use crate::findings::Findings;

/// The fields of a request that say which aircraft.
const SUBJECT: [&str; 9] =
    ["aircraft", "link", "toml", "matrices", "format", "file", "set", "class", "category"];

/// Which aircraft, and what is set on it: one of `aircraft`, `link`, `toml` and `matrices`, or a link with the `toml` that it names.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Subject", optional_fields))]
pub(super) struct SubjectForm {
    /// Key of an aircraft of the list, such as `navion`.
    aircraft: Option<String>,
    /// Link to a scene, with or without its `#` and the address before that; what else the request says counts above it.
    link: Option<String>,
    /// Text of an aircraft file; beside a link that of the aircraft which the link names by its key, where it is too long for it.
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
    /// Class of aircraft that levels are judged for; that of the link or of the aircraft's file without one.
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
    let (scene, Nothing {}) = read(request)?;
    written(&super::parameters_of(&scene.scenario))
}

/// What can be read of an aircraft: an array of [`super::MeasureReport`].
pub fn measures(request: &str) -> Result<String, ExportError> {
    let (scene, Nothing {}) = read(request)?;
    written(&super::measures_of(&Findings::of(scene.scenario), true))
}

/// Everything that follows for an aircraft: a [`super::Report`].
pub fn analyse(request: &str) -> Result<String, ExportError> {
    let (scene, Nothing {}) = read(request)?;
    written(&super::analyse(&scene)?)
}

/// The motion after a disturbance: a [`super::ResponseReport`].
pub fn respond(request: &str) -> Result<String, ExportError> {
    let (scene, request): (_, ResponseRequest) = read(request)?;
    written(&super::respond(&scene, &request)?)
}

/// Gain and phase over frequency: a [`super::FrequencyReport`].
pub fn frequency(request: &str) -> Result<String, ExportError> {
    let (scene, request): (_, FrequencyRequest) = read(request)?;
    written(&super::frequency(&scene, &request)?)
}

/// The modes along a parameter: a [`super::SweepReport`].
pub fn sweep(request: &str) -> Result<String, ExportError> {
    let (scene, request): (_, SweepRequest) = read(request)?;
    written(&Sweep::new(scene, &request)?.report())
}

/// The scene as a link: a [`super::LinkReport`].
pub fn link(request: &str) -> Result<String, ExportError> {
    let mut fields = fields(request)?;
    let address = text_of(&mut fields, "address")?;
    let (scene, request): (_, DisturbanceRequest) = of_fields(fields)?;
    written(&super::link_to(&scene, &request, address.as_deref())?)
}

/// The scene in another program's form, `target`: a [`super::TakenAlong`].
pub fn take_along(request: &str) -> Result<String, ExportError> {
    let mut fields = fields(request)?;
    let target = text_of(&mut fields, "target")?;
    let target = target.ok_or_else(|| ExportError::Request("target: missing".to_owned()))?;
    let (scene, request): (_, DisturbanceRequest) = of_fields(fields)?;
    written(&super::take_along(&scene, &target, &request)?)
}

/// What is in a file of another program or of matrices: a [`Review`](crate::content::import::review::Review). `fills` is an object
/// with what was typed beside it, as texts; `mass` is AVL's mass file.
pub fn read_file(name: &str, bytes: &[u8], fills: &str, mass: Option<&[u8]>) -> Result<String, ExportError> {
    let fills: BTreeMap<String, String> = from(serde_json::from_str(fills))?;
    let mut files = vec![FileBytes { name, bytes }];
    files.extend(mass.map(|bytes| FileBytes { name: "mass file", bytes }));
    written(&import::review(&files, &fills)?)
}

fn read<T: DeserializeOwned>(request: &str) -> Result<(Scene, T), ExportError> {
    of_fields(fields(request)?)
}

fn fields(request: &str) -> Result<Map<String, Value>, ExportError> {
    from(serde_json::from_str(request))
}

/// A field that is a text, taken out.
fn text_of(fields: &mut Map<String, Value>, key: &str) -> Result<Option<String>, ExportError> {
    match fields.remove(key) {
        None => Ok(None),
        Some(Value::String(text)) => Ok(Some(text)),
        Some(other) => Err(ExportError::Request(format!("{key}: expected a text, found {other}"))),
    }
}

fn of_fields<T: DeserializeOwned>(mut fields: Map<String, Value>) -> Result<(Scene, T), ExportError> {
    let subject: Map<String, Value> = SUBJECT.iter().filter_map(|key| fields.remove_entry(*key)).collect();
    let form: SubjectForm = from(serde_json::from_value(Value::Object(subject)))?;
    let subject = form.subject()?;
    let request = from(serde_json::from_value(Value::Object(fields)))?;
    Ok((subject.scene()?, request))
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
        let source = match (self.aircraft, self.link, self.toml, self.matrices, self.format.as_deref()) {
            (Some(key), None, None, None, None) => Source::Listed(key),
            (None, Some(link), None, None, None) => Source::Link(link),
            (None, Some(link), Some(text), None, None) => Source::LinkOf { link, text },
            (None, None, Some(text), None, None) => Source::Toml { file: file("aircraft.toml"), text },
            (None, None, None, Some(text), Some(format)) => {
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
            (None, None, None, Some(_), None) => {
                return wrong("format: missing; expected \"json\", \"csv\" or \"m\" beside matrices");
            }
            (None, None, None, None, None) => {
                return wrong("the request names no aircraft; expected aircraft, link, toml or matrices");
            }
            _ => {
                return wrong(
                    "expected one of aircraft, link, toml and matrices, toml also beside a link, and format beside matrices only",
                );
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
