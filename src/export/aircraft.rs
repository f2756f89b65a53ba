//! An aircraft's name, source and status.

use serde::Serialize;

use crate::content::Aircraft;
use crate::flight::aircraft::plane::Plane;
use crate::key::Keyed;

/// An aircraft's name, source and status.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Aircraft"))]
pub struct AircraftReport {
    /// Short name; `file` for bare matrices.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Flight condition in words.
    pub condition: String,
    /// Source of its numbers.
    pub source: String,
    /// `verified` where every published number is reproduced, else `unverified`.
    #[cfg_attr(test, ts(type = "Status"))]
    pub status: &'static str,
    /// Reason of the status, in a sentence or two.
    pub status_reason: String,
    /// Remarks on the source: misprints, what is estimated, what is our assignment.
    pub notes: Vec<String>,
    /// Class of MIL-F-8785C, our assignment.
    #[cfg_attr(test, ts(type = "AircraftClass | null"))]
    pub class: Option<&'static str>,
    /// Flight-phase category of MIL-F-8785C, our assignment.
    #[cfg_attr(test, ts(type = "FlightPhase | null"))]
    pub phase: Option<&'static str>,
    /// The planes of motion that it has data of.
    #[cfg_attr(test, ts(type = "Array<PlaneName>"))]
    pub planes: Vec<&'static str>,
}

impl AircraftReport {
    /// The report of an aircraft.
    pub fn of(aircraft: &Aircraft) -> Self {
        let models = aircraft.aircraft_model.models().unwrap_or_default();
        Self {
            key: aircraft.key.clone(),
            name: aircraft.name.clone(),
            condition: aircraft.condition.clone(),
            source: aircraft.source.clone(),
            status: aircraft.status.key(),
            status_reason: aircraft.status_reason.clone(),
            notes: aircraft.notes.clone(),
            class: aircraft.task.map(|task| task.class.key()),
            phase: aircraft.task.map(|task| task.category.key()),
            planes: Plane::ALL
                .into_iter()
                .filter(|plane| models.planes[*plane].is_some())
                .map(Keyed::key)
                .collect(),
        }
    }
}
