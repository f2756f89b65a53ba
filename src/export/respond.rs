//! The motion that a disturbance leads to, sampled in time.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::report::{AircraftReport, input_names, state_names};
use super::subject::{ExportError, Subject, plane_name};
use crate::flight::plane::Plane;
use crate::flight::response::MOST_STEPS;
use crate::flight::{Channel, analyse};
use crate::scenario::DisturbanceKind;

/// The disturbances by the name that a request gives them. Their sizes are parameters of the table: `step`, `pulse`,
/// `pulse_for`, `throttle`, `gust`, `aileron`, `rudder`, `side_gust`, and `time` for how long the motion is watched.
pub const DISTURBANCES: [(&str, Plane, DisturbanceKind); 7] = [
    ("elevator-step", Plane::Longitudinal, DisturbanceKind::ElevatorStep),
    ("elevator-pulse", Plane::Longitudinal, DisturbanceKind::ElevatorPulse),
    ("throttle-step", Plane::Longitudinal, DisturbanceKind::ThrottleStep),
    ("vertical-gust", Plane::Longitudinal, DisturbanceKind::VerticalGust),
    ("rudder-pulse", Plane::Lateral, DisturbanceKind::RudderPulse),
    ("aileron-pulse", Plane::Lateral, DisturbanceKind::AileronPulse),
    ("side-gust", Plane::Lateral, DisturbanceKind::SideGust),
];

/// Which disturbance, and how finely its motion is wanted.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ResponseRequest {
    /// One of [`DISTURBANCES`], which says the plane, too; by default the first of the aircraft's first plane.
    pub disturbance: Option<String>,
    /// Steps between the samples, one less than their number; 600 by default.
    pub steps: Option<usize>,
}

/// The motion after a disturbance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ResponseReport {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// What was set on it, SI.
    pub set: BTreeMap<String, f64>,
    /// `longitudinal` or `lateral`.
    pub plane: &'static str,
    /// Its name in a request.
    pub disturbance: &'static str,
    /// Times of the samples \[s\].
    pub time: Vec<f64>,
    /// What disturbs, at these times.
    pub input: Signal,
    /// What moves, at these times: the states first.
    pub outputs: Vec<Signal>,
    /// Time \[s\] from which the motion is no small disturbance any more, so that the linear model means nothing.
    pub small_until: Option<f64>,
    /// Time \[s\] of the first sample left out, where the motion had outgrown numbers worth having.
    pub cut_at: Option<f64>,
}

/// One quantity over time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Signal {
    /// What it is.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// Its values, one a time.
    pub values: Vec<f64>,
}

const STEPS: usize = 600;

/// The motion of an aircraft as it is set.
pub fn respond(subject: &Subject, request: &ResponseRequest) -> Result<ResponseReport, ExportError> {
    let mut scenario = subject.scenario()?;
    let (disturbance, plane, kind) = chosen(request.disturbance.as_deref(), scenario.plane)?;
    *scenario.disturbance.kind_mut(plane) = kind;
    let mut experiment = scenario.disturbance.experiment(plane);
    experiment.grid.steps = request.steps.unwrap_or(STEPS);
    if !(1..=MOST_STEPS).contains(&experiment.grid.steps) {
        let problem = format!("steps: expected 1 to {MOST_STEPS}, found {}", experiment.grid.steps);
        return Err(ExportError::Request(problem));
    }
    let analysis = analyse(&scenario.edited, None, &experiment)?;
    let missing = || {
        let aircraft = scenario.aircraft.key.clone();
        // A plane with data may have no model, and then it says why.
        match analysis.of(plane) {
            Some(Err(error)) => error.clone().into(),
            _ => ExportError::NoPlane { aircraft, plane },
        }
    };
    let motion = analysis.motion.as_ref().ok_or_else(missing)?;

    let samples = 0..motion.response.states.len();
    let time: Vec<f64> = samples.map(|k| experiment.grid.time(k)).collect();
    let [first, second] = input_names(plane);
    let (name, unit) = match (experiment.channel, plane) {
        (Channel::First, _) => (first, "rad"),
        (Channel::Second, Plane::Longitudinal) => (second, ""),
        (Channel::Second, Plane::Lateral) => (second, "rad"),
        (Channel::Gust, Plane::Longitudinal) => ("w_gust", "m/s"),
        (Channel::Gust, Plane::Lateral) => ("v_gust", "m/s"),
    };
    let input = Signal { name, unit, values: time.iter().map(|&t| experiment.input.at(t)).collect() };
    let units = match plane {
        Plane::Longitudinal => ["m/s", "m/s", "rad/s", "rad"],
        Plane::Lateral => ["m/s", "rad/s", "rad/s", "rad"],
    };
    let state = |k: usize| motion.response.states.iter().map(|x| x[k]).collect();
    let outputs = state_names(plane)
        .into_iter()
        .zip(units)
        .enumerate()
        .map(|(k, (name, unit))| Signal { name, unit, values: state(k) })
        .collect();
    Ok(ResponseReport {
        aircraft: AircraftReport::of(&scenario.aircraft),
        set: subject.set.iter().cloned().collect(),
        plane: plane_name(plane),
        disturbance,
        time,
        input,
        outputs,
        small_until: motion.small_until,
        cut_at: motion.response.cut_at,
    })
}

fn chosen(name: Option<&str>, plane: Plane) -> Result<(&'static str, Plane, DisturbanceKind), ExportError> {
    let found = DISTURBANCES.iter().find(|(known, of, _)| name.map_or(*of == plane, |name| name == *known));
    found.copied().ok_or_else(|| {
        let names = DISTURBANCES.map(|(name, ..)| name).join(", ");
        let name = name.unwrap_or_default();
        ExportError::Request(format!("there is no disturbance \"{name}\"; expected one of {names}"))
    })
}
