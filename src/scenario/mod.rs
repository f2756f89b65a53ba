//! What is being studied: the document that a person edits. Plain data, finite by construction.

mod dimension;
mod disturbance;
mod experiment;
pub mod link;
mod notation;
pub mod parameters;
mod quantity;
pub mod stage;
mod units;
pub mod view;

use std::sync::Arc;

use crate::content::{Aircraft, LengthUnit};
use crate::flight::aircraft::aircraft_model::AircraftModel;
use crate::flight::aircraft::edits::{EditedModel, Offsets};
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::feedback::Law;
use crate::flight::verdicts::task::Task;
use crate::flight::{Analysis, AnalysisError, analyse};

pub use dimension::Dimension;
pub use disturbance::{Choice, Disturbance, START, Shape, Sizes, Source};
pub use notation::{Convention, Notation};
pub use parameters::{Page, Parameter, ValueError, Written, parameters};
pub use quantity::Quantity;
pub use stage::{Hidden, Lock, Part, Stage};
pub use units::Units;
pub use view::View;

/// One aircraft with the person's edits, and the disturbance it is put through.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// The aircraft as its file has it: the reference of every slider.
    pub aircraft: Arc<Aircraft>,
    /// The aircraft as edited, SI.
    pub edited: EditedModel,
    /// The law of feedback, without any gain at first.
    pub law: Law,
    /// The plane of motion that is studied.
    pub plane: Plane,
    /// The disturbance, and for how long the motion is watched.
    pub disturbance: Disturbance,
    /// Class of aircraft and phase of flight that handling qualities are judged for; without one they aren't.
    pub task: Option<Task>,
    /// The units in which its numbers are shown.
    pub units: Units,
    /// The notation in which its equations are shown.
    pub notation: Notation,
}

/// Compared many times in every frame, nearly always with one of the same aircraft.
impl PartialEq for Scenario {
    fn eq(&self, other: &Self) -> bool {
        let Self { aircraft, edited, law, plane, disturbance, task, units, notation } = self;
        *plane == other.plane
            && *disturbance == other.disturbance
            && *task == other.task
            && (*units, *notation) == (other.units, other.notation)
            && *law == other.law
            && *edited == other.edited
            && (Arc::ptr_eq(aircraft, &other.aircraft) || *aircraft == other.aircraft)
    }
}

impl Scenario {
    /// An aircraft as its file has it, put through the first disturbance a person sees, in the first plane it has data of.
    pub fn new(aircraft: Arc<Aircraft>) -> Self {
        let has_longitudinal = aircraft.plane_notes.longitudinal.is_some();
        Self {
            edited: EditedModel::new(aircraft.aircraft_model.clone()),
            task: aircraft.task,
            aircraft,
            law: Law::default(),
            plane: if has_longitudinal { Plane::Longitudinal } else { Plane::Lateral },
            disturbance: Disturbance::default(),
            units: Units::default(),
            notation: Notation::default(),
        }
    }

    /// The same disturbance with another aircraft, its numbers shown alike.
    pub fn with_aircraft(&self, aircraft: Arc<Aircraft>) -> Self {
        let mut scenario = Self { disturbance: self.disturbance, ..Self::new(aircraft) }.shown_as(self);
        if scenario.aircraft.plane_notes[self.plane].is_some() {
            scenario.plane = self.plane;
        }
        scenario
    }

    /// The same aircraft and disturbance with every derivative back at its reference.
    pub fn with_reference_model(&self) -> Self {
        self.with_aircraft(self.aircraft.clone())
    }

    /// The same with its numbers shown as those of another.
    pub fn shown_as(self, other: &Self) -> Self {
        let Self { units, notation, .. } = *other;
        Self { units, notation, ..self }
    }

    /// Whether anything of the aircraft differs from the reference.
    pub fn is_edited(&self) -> bool {
        self.edited.aircraft_model != self.aircraft.aircraft_model
            || self.edited.offsets != Offsets::default()
    }

    /// The unit of length in which its numbers are shown.
    pub fn length_unit(&self) -> LengthUnit {
        self.units.length(self.aircraft.length_unit)
    }

    /// What a person has chosen to read of it.
    pub fn convention(&self) -> Convention {
        let speed = match &self.edited.aircraft_model {
            AircraftModel::Coefficients(model) => ByPlane::from_fn(|_| model.condition.speed),
            AircraftModel::Derivatives(model) => ByPlane::from_fn(|_| model.trim.speed),
            AircraftModel::Matrices(planes) => {
                ByPlane::from_fn(|plane| planes[plane].as_ref().map_or(1.0, |model| model.trim.speed))
            }
        };
        Convention { length: self.length_unit(), notation: self.notation, speed }
    }

    /// Everything that follows from it.
    pub fn analyse(&self) -> Result<Analysis, AnalysisError> {
        analyse(&self.edited, self.task, &self.experiment())
    }
}
