//! An aircraft in one flight condition, as its file has it.

use std::sync::Arc;

pub use super::published::{Published, PublishedMode, Quantity};
pub use super::reader::ContentError;
use crate::flight::aircraft::aircraft_model::{AircraftModel, DerivativeModel, Models};
use crate::flight::aircraft::plane::ByPlane;
use crate::flight::motion::control_limits::NamedLimits;
use crate::flight::verdicts::task::Task;
use crate::key::keys;

/// An aircraft in one flight condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Aircraft {
    /// Short name for links and tests, never changed once published.
    pub key: String,
    /// Text of its file, where it is a person's own and none of those that ship: what a link carries.
    pub own: Option<Arc<str>>,
    /// Name on screen.
    pub name: String,
    /// Flight condition in words.
    pub condition: String,
    /// Name of its shape, for [`embedded_shape`](super::shapes::embedded_shape).
    pub shape: &'static str,
    /// Unit of length in which its numbers are shown.
    pub length_unit: LengthUnit,
    /// Whether the modes of every plane were checked against published ones.
    pub status: Status,
    /// Reason of the status, in a sentence or two.
    pub status_reason: String,
    /// Source of every number.
    pub source: String,
    /// Everything a person may edit, at the source's values.
    pub aircraft_model: AircraftModel,
    /// Derivatives and models that follow from it.
    pub baseline: Baseline,
    /// Status and source of the data of each plane, where there are any.
    pub plane_notes: ByPlane<Option<PlaneNotes>>,
    /// Mass and geometry as far as the source has them, SI, for drawing and reading; the study computes with its own.
    pub particulars: Particulars,
    /// Limits of its controls, where its file names any.
    pub limits: NamedLimits,
    /// Class and flight-phase category of MIL-F-8785C, our assignment.
    pub task: Option<Task>,
    /// Remarks for a reader of the source: misprints, what is estimated, what is our assignment. A sentence or two each.
    pub notes: Vec<String>,
}

/// Derivatives and models of an aircraft before any edit, found once: the ranges of its sliders are drawn from them.
#[derive(Clone, Debug, PartialEq)]
pub struct Baseline {
    /// Dimensional derivatives; `None` where the source has bare matrices.
    pub derivatives: Option<DerivativeModel>,
    /// The linear models.
    pub models: Models,
}

impl Baseline {
    /// The derivatives and models of a study; empty where there is no such steady flight.
    pub fn new(aircraft_model: &AircraftModel) -> Self {
        Self {
            derivatives: aircraft_model.to_derivatives().ok().flatten(),
            models: aircraft_model.models().unwrap_or_default(),
        }
    }
}

/// Status and source of the data of one plane of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneNotes {
    /// Whether the published modes are reproduced.
    pub status: Status,
    /// Reason of the status, in a sentence or two.
    pub status_reason: String,
    /// Source of the numbers of this plane.
    pub source: String,
    /// The published modes.
    pub published: Vec<Published>,
}

/// Mass and geometry as far as a source has them, SI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Particulars {
    /// Mass \[kg\].
    pub mass: Option<f64>,
    /// Wing area \[m²\].
    pub wing_area: Option<f64>,
    /// Span \[m\].
    pub span: Option<f64>,
    /// Mean chord \[m\].
    pub chord: Option<f64>,
    /// True airspeed \[m/s\].
    pub speed: Option<f64>,
    /// Altitude \[m\].
    pub altitude: Option<f64>,
    /// Mach number.
    pub mach: Option<f64>,
}

/// Result of checking an aircraft's modes against published ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Every published number is reproduced.
    Verified,
    /// Something is open; the reason says what.
    Unverified,
}

keys! {
    Status {
        Verified => "verified",
        Unverified => "unverified",
    }
}

/// A unit of length in which an aircraft's numbers are shown; time is in seconds, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Metre.
    Metre,
    /// Foot.
    Foot,
    /// Hundred feet, the hidden unit of the lesson's matrix.
    HundredFeet,
}

impl LengthUnit {
    /// The units by the name that a file gives them.
    pub const NAMES: [(&'static str, Self); 3] =
        [("m", Self::Metre), ("ft", Self::Foot), ("100 ft", Self::HundredFeet)];

    /// Length of this unit in metres.
    pub const fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            // 1 ft = 0.3048 m, exactly
            Self::Foot => 0.3048,
            Self::HundredFeet => 30.48,
        }
    }

    /// Its symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Foot => "ft",
            Self::HundredFeet => "100 ft",
        }
    }
}

impl Aircraft {
    /// True airspeed of the reference \[m/s\].
    pub fn speed(&self) -> f64 {
        match &self.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => aircraft_model.reference.condition.speed,
            AircraftModel::Derivatives(aircraft_model) => aircraft_model.trim.speed,
            AircraftModel::Matrices(aircraft_model) => {
                aircraft_model.iter().flatten().next().map_or(1.0, |model| model.trim.speed)
            }
        }
    }
}
