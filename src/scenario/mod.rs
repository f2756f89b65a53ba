//! What is being studied: the document that a person edits. Plain data, finite by construction.

mod dimension;
mod disturbance;
pub mod parameters;

use std::sync::Arc;

use crate::content::Aircraft;
use crate::flight::linear::LongitudinalModel;
use crate::flight::{Analysis, AnalysisError, analyse};

pub use dimension::Dimension;
pub use disturbance::{Disturbance, DisturbanceKind, START};
pub use parameters::{PARAMETERS, Parameter, ValueError};

/// One aircraft with the person's edits, and the disturbance it is put through.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// The aircraft as its file has it: the reference of every slider.
    pub aircraft: Arc<Aircraft>,
    /// Its model as edited, SI.
    pub model: LongitudinalModel,
    /// What disturbs it, and for how long it is watched.
    pub disturbance: Disturbance,
}

impl Scenario {
    /// An aircraft as its file has it, put through the first disturbance a person sees.
    pub fn new(aircraft: Arc<Aircraft>) -> Self {
        Self { model: aircraft.longitudinal.clone(), aircraft, disturbance: Disturbance::default() }
    }

    /// The same disturbance with another aircraft.
    pub fn with_aircraft(&self, aircraft: Arc<Aircraft>) -> Self {
        Self { disturbance: self.disturbance, ..Self::new(aircraft) }
    }

    /// The same aircraft and disturbance with every derivative back at its reference.
    pub fn with_reference_model(&self) -> Self {
        self.with_aircraft(self.aircraft.clone())
    }

    /// Whether any derivative differs from the reference.
    pub fn is_edited(&self) -> bool {
        self.model != self.aircraft.longitudinal
    }

    /// Everything that follows from it.
    pub fn analyse(&self) -> Result<Analysis, AnalysisError> {
        analyse(&self.model, &self.disturbance.experiment())
    }
}
