//! The motion that a disturbance leads to, sampled in time.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::aircraft::AircraftReport;
use super::closed_loop::LoopMotion;
use super::disturbance::{
    check_command, check_sizes, choose_disturbance, choose_mode, choose_shape, flown_alone, no_motion,
};
use super::error::ExportError;
use super::flown::FlightOutcome;
use super::metrics::MetricsReport;
use super::scene::Scene;
use super::signal::Signal;
use super::split::SplitOutcome;
use super::subject::set_on;
use crate::findings::Findings;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::MOST_STEPS;
use crate::key::Keyed;
use crate::scenario::{Quantity, Source};
use crate::words;

/// A disturbance, the number of samples, and the extras that are wanted.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
#[serde(deny_unknown_fields)]
pub struct ResponseRequest {
    /// `longitudinal` or `lateral`; by default that of the disturbance, and the aircraft's first where it can be both.
    #[cfg_attr(test, ts(optional, type = "PlaneName"))]
    pub plane: Option<String>,
    /// Key of the disturbance; by default the plane's first, elevator or rudder. Its size is a parameter.
    #[cfg_attr(test, ts(optional, type = "Disturbance"))]
    pub disturbance: Option<String>,
    /// Its shape in time, of those it can have; by default that of the page.
    #[cfg_attr(test, ts(optional, type = "Shape"))]
    pub shape: Option<String>,
    /// Key of the mode that is flown alone, with the disturbance `mode`: under a law one of those; by default the first. Its name and its number are read, too.
    pub mode: Option<String>,
    /// Steps between the samples, one less than their number; 600 by default, in turbulence one each 0.05 s.
    pub steps: Option<usize>,
    /// Whether the same is flown in six degrees of freedom, without linearising; by default only where a link says so.
    pub nonlinear: Option<bool>,
    /// Whether each output is split into the parts of the modes; likewise.
    pub split: Option<bool>,
}

/// The motion after a disturbance.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Motion"))]
pub struct ResponseReport {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// Values set on it, SI.
    #[cfg_attr(test, ts(type = "Record<string, number>"))]
    pub set: BTreeMap<String, f64>,
    /// What of the link can't be used, and a mode that is flown alone where the aircraft without its law hasn't it, in sentences.
    pub notices: Vec<String>,
    /// `longitudinal` or `lateral`.
    #[cfg_attr(test, ts(type = "PlaneName"))]
    pub plane: &'static str,
    /// Key of the disturbance.
    #[cfg_attr(test, ts(type = "Disturbance"))]
    pub disturbance: &'static str,
    /// Key of its shape; null where it has one of its own.
    #[cfg_attr(test, ts(type = "Shape | null"))]
    pub shape: Option<&'static str>,
    /// Name of the mode that is flown alone; null with other disturbances.
    pub mode: Option<&'static str>,
    /// Its key.
    #[cfg_attr(test, ts(type = "ModeKey | null"))]
    pub mode_key: Option<&'static str>,
    /// Times of the samples \[s\].
    pub time: Vec<f64>,
    /// Inputs at these times, in the sense of their parameters: air is positive where it rises, comes from ahead or moves to the
    /// right. None where the aircraft is let go.
    pub inputs: Vec<Signal>,
    /// Outputs at these times, as changes from the steady flight: those of the plane, by their keys.
    pub outputs: Vec<Signal>,
    /// Time \[s\] from which the motion is no small disturbance any more, so that the linear answer is no longer that of the aircraft.
    pub small_until: Option<f64>,
    /// The limit that it has passed then, in one sentence; null where it stays small.
    pub small_limit: Option<String>,
    /// Time \[s\] of the first sample left out, where the motion had outgrown numbers worth having.
    pub cut_at: Option<f64>,
    /// Metrics of the motion while it is a small disturbance.
    #[serde(rename = "figures")]
    pub metrics: MetricsReport,
    /// The parts of the modes in each of the outputs; null where they weren't asked for.
    pub split: Option<Vec<SplitOutcome>>,
    /// The same without linearising; null where it wasn't asked for.
    pub nonlinear: Option<FlightOutcome>,
    /// The same linear motion under the law of feedback; null where nothing is fed back. All else is of the aircraft without it.
    pub closed_loop: Option<LoopMotion>,
}

const STEPS: usize = 600;

/// The motion of an aircraft as it is set.
pub fn respond(scene: &Scene, request: &ResponseRequest) -> Result<ResponseReport, ExportError> {
    let mut scenario = scene.scenario.clone();
    let (named_plane, name) = (request.plane.as_deref(), request.disturbance.as_deref());
    let source = choose_disturbance(&mut scenario, named_plane, name, Source::VALUES, "disturbance")?;
    let plane = scenario.plane;
    let shape = choose_shape(&mut scenario, request.shape.as_deref())?;
    let mode = choose_mode(&mut scenario, request.mode.as_deref(), source)?;
    check_sizes(&scenario, &scene.sizes)?;
    check_command(&scenario, source)?;

    let own = if source == Source::Turbulence { scenario.experiment().grid.steps } else { STEPS };
    let steps = request.steps.unwrap_or(own);
    if !(1..=MOST_STEPS).contains(&steps) {
        let problem = format!("steps: expected 1 to {MOST_STEPS}, found {steps}");
        return Err(ExportError::Request(problem));
    }
    let findings = Findings::of(scenario.clone());
    let mut notices = scene.notices.clone();
    // A mode is counted among those under the law; the aircraft alone has its own.
    let without_law;
    let alone = match mode.filter(|_| findings.closed_loop().is_some()) {
        Some(mode) => {
            let (scenario, has_it) = flown_alone(scenario, mode);
            if !has_it {
                notices.push(words::feedback::not_alone(mode));
            }
            without_law = Findings::of(scenario);
            &without_law
        }
        None => &findings,
    };
    let (Some(motion), Some(metrics)) = (alone.motion_in(steps), alone.metrics()) else {
        return Err(no_motion(alone));
    };
    let experiment = &motion.experiment;

    let time: Vec<f64> = (0..motion.response.states.len()).map(|k| experiment.grid.time(k)).collect();
    let inputs = experiment.inputs.iter().map(|(channel, input)| {
        let Quantity { key: name, dimension, .. } = Quantity::of_input(plane, *channel);
        let sign = Quantity::input_sign(plane, *channel);
        // Zero stays plain zero.
        let values = time.iter().map(|&t| sign * input.at(t) + 0.0).collect();
        Signal { name, unit: dimension.si_symbol(), values }
    });
    let outputs = Output::of(plane).iter().map(|&output| Signal::of(output, motion.values(output)));
    let is_split = request.split.unwrap_or(scene.view.response.split);
    let split = is_split.then(|| SplitOutcome::of(&motion, alone.modes()));
    let length = findings.scenario().units.length_of_reports();
    let is_flown = request.nonlinear.unwrap_or(scene.view.response.nonlinear);
    let nonlinear = is_flown.then(|| findings.flight_in(steps)).flatten();
    let nonlinear = nonlinear.map(|flight| FlightOutcome::of(flight, &motion.model, experiment.grid, length));
    Ok(ResponseReport {
        aircraft: AircraftReport::of(&findings.scenario().aircraft),
        set: set_on(findings.scenario()),
        notices,
        plane: plane.key(),
        disturbance: source.key(),
        shape: shape.map(Keyed::key),
        mode: mode.map(words::mode::title),
        mode_key: mode.map(Keyed::key),
        inputs: inputs.collect(),
        outputs: outputs.collect(),
        time,
        small_until: motion.small_until,
        small_limit: words::small_disturbance::sentence(&motion, length),
        cut_at: motion.response.cut_at,
        metrics: MetricsReport::of(metrics),
        split,
        nonlinear,
        closed_loop: LoopMotion::of(&findings, steps),
    })
}
