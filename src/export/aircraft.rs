//! An aircraft's name, source and status.

use serde::Serialize;

use super::subject::plane_name;
use crate::content::{Aircraft, Status};
use crate::flight::aircraft::plane::Plane;
use crate::flight::verdicts::mil_f_8785c::{Category, Class};

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
        let name_of = |status| Status::NAMES.iter().find(|(_, s)| *s == status).map_or("", |(name, _)| name);
        let models = aircraft.study.models().unwrap_or_default();
        let planes = Plane::ALL;
        Self {
            key: aircraft.key.clone(),
            name: aircraft.name.clone(),
            condition: aircraft.condition.clone(),
            source: aircraft.source.clone(),
            status: name_of(aircraft.status),
            status_reason: aircraft.status_reason.clone(),
            notes: aircraft.notes.clone(),
            class: aircraft
                .class
                .and_then(|class| Class::NAMES.iter().find(|(_, c)| *c == class).map(|&(name, _)| name)),
            phase: aircraft
                .phase
                .and_then(|phase| Category::NAMES.iter().find(|(_, c)| *c == phase).map(|&(name, _)| name)),
            planes: planes
                .into_iter()
                .filter(|plane| models.planes[*plane].is_some())
                .map(plane_name)
                .collect(),
        }
    }
}
