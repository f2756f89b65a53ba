//! Why a request can't be answered.

use thiserror::Error;

use crate::content::ContentError;
use crate::flight::AnalysisError;
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::plane::Plane;
use crate::key::Keyed;

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
