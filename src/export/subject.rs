//! The subject of a request: an aircraft of the list, of a text or of a link, and the values set on it.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::error::ExportError;
use super::scene::Scene;
use crate::content::{Aircraft, FILES, MatrixFormat};
use crate::few;
use crate::flight::verdicts::task::Task;
use crate::key::{Keyed, nearest};
use crate::number::significant;
use crate::scenario::{Parameter, Scenario, ValueError, parameters};

/// Origin of an aircraft. The library reads no files: the caller hands over their text.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// An aircraft of the list, by its key.
    Listed(String),
    /// An aircraft file in the form of those under `assets/aircraft`.
    Toml {
        /// Its name, for messages.
        file: String,
        /// Its text.
        text: String,
    },
    /// The scene of a link, with or without its `#` and what stands before that.
    Link(String),
    /// The same of a link that names an aircraft which is too long for it.
    LinkOf {
        /// The link.
        link: String,
        /// Text of the aircraft's file.
        text: String,
    },
    /// Bare matrices.
    Matrices {
        /// Its name, for messages.
        file: String,
        /// Its text.
        text: String,
        /// The form that it is written in.
        format: MatrixFormat,
    },
}

/// An aircraft with the parameters that are set on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// Origin of the aircraft.
    pub source: Source,
    /// Keys of the table of parameters and their values \[SI, radians\]. They are set in the order of that table, coefficients
    /// before what follows from them, so that each ends at its value.
    pub set: Vec<(String, f64)>,
    /// Key of the class of aircraft that levels are judged for; that of the aircraft's file without one.
    pub class: Option<String>,
    /// Key of the category of flight phase that levels are judged for.
    pub category: Option<String>,
}

impl Subject {
    /// An aircraft of the list as it is.
    pub fn listed(key: &str) -> Self {
        Self { source: Source::Listed(key.to_owned()), set: Vec::new(), class: None, category: None }
    }

    /// The aircraft with its parameters set.
    pub fn scenario(&self) -> Result<Scenario, ExportError> {
        Ok(self.scene()?.scenario)
    }

    /// The same with all that stands beside it in a link.
    pub fn scene(&self) -> Result<Scene, ExportError> {
        let mut scene = self.source.scene()?;
        let scenario = &mut scene.scenario;
        let mut settings = self
            .set
            .iter()
            .map(|(key, value)| Ok((find_parameter(key)?, *value)))
            .collect::<Result<Vec<_>, ExportError>>()?;
        few::sort_by_key(&mut settings, |(parameter, _)| parameters().position(|p| p.key == parameter.key));
        for (parameter, value) in settings {
            let value = checked(scenario, parameter, value)?;
            if parameter.is_of_disturbance() && value != parameter.get(scenario) {
                scene.sizes.push(parameter);
            }
            parameter.set(scenario, value);
        }
        if self.class.is_some() || self.category.is_some() {
            let usual = scenario.task.unwrap_or_default();
            scenario.task = Some(Task {
                class: chosen(self.class.as_deref(), "class", usual.class)?,
                category: chosen(self.category.as_deref(), "category", usual.category)?,
            });
        }
        Ok(scene)
    }
}

/// The value of a key in a request, or `usual` without one.
fn chosen<T: Keyed>(key: Option<&str>, field: &str, usual: T) -> Result<T, ExportError> {
    let Some(key) = key else { return Ok(usual) };
    T::by_key(key).ok_or_else(|| {
        let keys: Vec<&str> = T::VALUES.iter().map(|value| value.key()).collect();
        ExportError::Request(format!("{field}: expected one of {}, found \"{key}\"", keys.join(", ")))
    })
}

/// Values set on an aircraft \[SI\]: every parameter that differs from its file. An offset on what follows from others has their
/// rounding in its last digit, which is left out.
pub(super) fn set_on(scenario: &Scenario) -> BTreeMap<String, f64> {
    let edited = parameters().filter(|p| p.applies(scenario) && p.is_edited(scenario));
    let value = |p: &Parameter| {
        let exact = p.get(scenario);
        format!("{exact:.14e}").parse().unwrap_or(exact)
    };
    edited.map(|p| (p.key.to_owned(), value(p))).collect()
}

impl Source {
    fn scene(&self) -> Result<Scene, ExportError> {
        Ok(match self {
            Self::Link(link) => Scene::of_link(link, None)?,
            Self::LinkOf { link, text } => Scene::of_link(link, Some(text))?,
            Self::Listed(key) => {
                let keys = || FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"));
                let found = FILES.iter().find(|(file, _)| file.strip_suffix(".toml") == Some(key));
                let unknown =
                    || ExportError::UnknownAircraft { name: key.clone(), nearest: nearest(key, keys()) };
                let (file, text) = found.ok_or_else(unknown)?;
                Scene::of_file(Aircraft::from_toml(file, text)?, text)
            }
            // A file that ships is named by its key; any other is carried by a link.
            Self::Toml { file, text } if FILES.iter().any(|(_, shipped)| shipped == text) => {
                Scene::of_file(Aircraft::from_toml(file, text)?, text)
            }
            Self::Toml { file, text } => Scene::of_file(Aircraft::own(file, text)?, text),
            Self::Matrices { file, text, format } => {
                let aircraft = Aircraft::from_matrices(file, text, *format)?;
                Scenario::new(Arc::new(aircraft)).into()
            }
        })
    }
}

/// The row of the table of parameters with this key.
pub(super) fn find_parameter(key: &str) -> Result<&'static Parameter, ExportError> {
    Parameter::find(key).ok_or_else(|| ExportError::UnknownParameter {
        key: key.to_owned(),
        nearest: rolling_moment(key).or_else(|| nearest(key, parameters().map(|p| p.key))),
    })
}

/// The key of a rolling moment that is written as in books, `cl_beta`: here `cl` is the lift.
fn rolling_moment(key: &str) -> Option<String> {
    let key = key.to_lowercase();
    let rolling = format!("croll_{}", key.strip_prefix("cl_")?);
    Parameter::find(&rolling).map(|parameter| parameter.key.to_owned())
}

/// A value that the aircraft's parameter accepts \[SI\].
pub(super) fn checked(
    scenario: &Scenario,
    parameter: &'static Parameter,
    value: f64,
) -> Result<f64, ExportError> {
    if !parameter.applies(scenario) {
        // Without a steady flight nothing that follows from it is there either.
        scenario.edited.models()?;
        let (key, name, aircraft) = (parameter.key, parameter.name, scenario.aircraft.key.clone());
        return Err(ExportError::NotOfAircraft { key, name, aircraft });
    }
    parameter.check(scenario, value).map_err(|error| match error {
        ValueError::NotFinite | ValueError::NotANumber(_) => ExportError::NotFinite(parameter.key),
        ValueError::NotWhole => ExportError::NotWhole(parameter.key),
        ValueError::Absurd { .. } => {
            let accepted = parameter.accepted(scenario);
            let unit = parameter.dimension.si_symbol();
            let with_unit = |x: f64| format!("{} {unit}", significant(x, 4)).trim_end().to_owned();
            ExportError::Beyond {
                key: parameter.key,
                value: with_unit(value),
                low: significant(*accepted.start(), 4),
                high: with_unit(*accepted.end()),
            }
        }
    })
}
