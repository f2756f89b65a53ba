//! The subject of a request: an aircraft of the list or of a text, and the values set on it.

use std::collections::BTreeMap;
use std::sync::Arc;

use thiserror::Error;

use crate::content::{Aircraft, ContentError, FILES, MatrixFormat};
use crate::flight::AnalysisError;
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::plane::Plane;
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

/// Error of a request that can't be answered, in one sentence.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ExportError {
    /// The text of an aircraft can't be read.
    #[error(transparent)]
    Content(#[from] ContentError),
    /// Not an aircraft of the list.
    #[error("there is no aircraft \"{name}\" in the list{}", did_you_mean(.nearest))]
    UnknownAircraft {
        /// The key in the request.
        name: String,
        /// The key most like it.
        nearest: Option<String>,
    },
    /// Not a key of the table of parameters.
    #[error("there is no parameter \"{key}\"{}", did_you_mean(.nearest))]
    UnknownParameter {
        /// The key in the request.
        key: String,
        /// The key most like it.
        nearest: Option<String>,
    },
    /// Not a key of the table of measures.
    #[error("there is no measure \"{key}\"{}", did_you_mean(.nearest))]
    UnknownMeasure {
        /// The key in the request.
        key: String,
        /// The key most like it.
        nearest: Option<String>,
    },
    /// A key that this aircraft doesn't have.
    #[error("{aircraft} has no parameter {key} ({name}): its source has no numbers for it")]
    NotOfAircraft {
        /// The key.
        key: &'static str,
        /// The parameter in words.
        name: &'static str,
        /// Key of the aircraft.
        aircraft: String,
    },
    /// NaN or infinite.
    #[error("{0}: expected a finite number")]
    NotFinite(&'static str),
    /// Between two whole numbers, where only those mean something.
    #[error("{0}: expected a whole number")]
    NotWhole(&'static str),
    /// Beyond anything with a meaning.
    #[error("{key}: {value} is beyond what is accepted, {low} to {high}")]
    Beyond {
        /// The key.
        key: &'static str,
        /// The refused value with its SI unit.
        value: String,
        /// Least accepted value.
        low: String,
        /// Greatest accepted value, with its SI unit.
        high: String,
    },
    /// The aircraft has no data of a plane of motion.
    #[error("{aircraft} has no {} data", .plane.key())]
    NoPlane {
        /// Key of the aircraft.
        aircraft: String,
        /// The plane.
        plane: Plane,
    },
    /// There is no such steady flight.
    #[error(transparent)]
    AircraftModel(#[from] ModelError),
    /// The analysis failed.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// The request itself makes no sense.
    #[error("{0}")]
    Request(String),
}

fn did_you_mean(nearest: &Option<String>) -> String {
    nearest.as_ref().map_or_else(String::new, |nearest| format!("; did you mean \"{nearest}\"?"))
}

impl Subject {
    /// An aircraft of the list as it is.
    pub fn listed(key: &str) -> Self {
        Self { source: Source::Listed(key.to_owned()), set: Vec::new(), class: None, category: None }
    }

    /// The aircraft with its parameters set.
    pub fn scenario(&self) -> Result<Scenario, ExportError> {
        let aircraft = self.source.aircraft()?;
        let mut scenario = Scenario::new(Arc::new(aircraft));
        let mut settings = self
            .set
            .iter()
            .map(|(key, value)| Ok((find_parameter(key)?, *value)))
            .collect::<Result<Vec<_>, ExportError>>()?;
        settings.sort_by_key(|(parameter, _)| parameters().position(|p| p.key == parameter.key));
        for (parameter, value) in settings {
            let value = checked(&scenario, parameter, value)?;
            parameter.set(&mut scenario, value);
        }
        if self.class.is_some() || self.category.is_some() {
            let usual = scenario.task.unwrap_or_default();
            scenario.task = Some(Task {
                class: chosen(self.class.as_deref(), "class", usual.class)?,
                category: chosen(self.category.as_deref(), "category", usual.category)?,
            });
        }
        Ok(scenario)
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
    fn aircraft(&self) -> Result<Aircraft, ExportError> {
        Ok(match self {
            Self::Listed(key) => {
                let keys = || FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"));
                let found = FILES.iter().find(|(file, _)| file.strip_suffix(".toml") == Some(key));
                let unknown =
                    || ExportError::UnknownAircraft { name: key.clone(), nearest: nearest(key, keys()) };
                let (file, text) = found.ok_or_else(unknown)?;
                Aircraft::from_toml(file, text)?
            }
            Self::Toml { file, text } => Aircraft::from_toml(file, text)?,
            Self::Matrices { file, text, format } => Aircraft::from_matrices(file, text, *format)?,
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
