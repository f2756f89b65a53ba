//! The motion that a disturbance leads to, sampled in time.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::report::{AircraftReport, input_names};
use super::subject::{ExportError, Subject, nearest, plane_name};
use crate::flight::outputs::Output;
use crate::flight::plane::Plane;
use crate::flight::response::MOST_STEPS;
use crate::flight::{Analysis, Channel, analyse};
use crate::scenario::{Quantity, Scenario, Shape, Source};

/// The disturbances by the name that a request gives them. Their sizes are parameters of the table, of the page
/// [`crate::scenario::Page::Disturbance`]: `elevator`, `gust`, `part` and so on, and `time` for how long the motion is watched.
pub const DISTURBANCES: [(&str, Source); 10] = [
    ("elevator", Source::Elevator),
    ("throttle", Source::Throttle),
    ("vertical-gust", Source::VerticalGust),
    ("head-gust", Source::HeadGust),
    ("rudder", Source::Rudder),
    ("aileron", Source::Aileron),
    ("side-gust", Source::SideGust),
    ("turbulence", Source::Turbulence),
    ("release", Source::Release),
    ("mode", Source::OneMode),
];

/// The shapes in time by the name that a request gives them.
pub const SHAPES: [(&str, Shape); 7] = [
    ("step", Shape::Step),
    ("pulse", Shape::Pulse),
    ("doublet", Shape::Doublet),
    ("3-2-1-1", Shape::ThreeTwoOneOne),
    ("sine", Shape::Sine),
    ("sweep", Shape::Sweep),
    ("1-cosine", Shape::OneMinusCosine),
];

/// Which disturbance, and how finely its motion is wanted.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ResponseRequest {
    /// `longitudinal` or `lateral`; by default that of the disturbance, and the aircraft's first where it can be both.
    pub plane: Option<String>,
    /// One of [`DISTURBANCES`]; by default the plane's first, elevator or rudder.
    pub disturbance: Option<String>,
    /// One of [`SHAPES`] that the disturbance can have; by default that of the page.
    pub shape: Option<String>,
    /// Name of the mode that is flown alone, with the disturbance `mode`; by default the first.
    pub mode: Option<String>,
    /// Steps between the samples, one less than their number; 600 by default, in turbulence one each 0.05 s.
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
    /// The disturbance by its name in a request.
    pub disturbance: &'static str,
    /// Its shape by its name in a request; null where it has one of its own.
    pub shape: Option<&'static str>,
    /// Name of the mode that is flown alone; null with other disturbances.
    pub mode: Option<&'static str>,
    /// Times of the samples \[s\].
    pub time: Vec<f64>,
    /// What disturbs, at these times; none where the aircraft is let go.
    pub inputs: Vec<Signal>,
    /// What moves, at these times, as a change from the steady flight: [`Output::of`] the plane, by [`Quantity::key`].
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
    let (disturbance, source) = choose_disturbance(&mut scenario, request)?;
    let plane = scenario.plane;
    let shape = choose_shape(&mut scenario, request, disturbance)?;
    let mode = choose_mode(&mut scenario, request, source)?;

    let mut experiment = scenario.experiment();
    let own = if source == Source::Turbulence { experiment.grid.steps } else { STEPS };
    experiment.grid.steps = request.steps.unwrap_or(own);
    if !(1..=MOST_STEPS).contains(&experiment.grid.steps) {
        let problem = format!("steps: expected 1 to {MOST_STEPS}, found {}", experiment.grid.steps);
        return Err(ExportError::Request(problem));
    }
    let analysis = analyse(&scenario.edited, None, &experiment)?;
    let motion = analysis.motion.as_ref().ok_or_else(|| no_motion(&scenario, &analysis))?;

    let time: Vec<f64> = (0..motion.response.states.len()).map(|k| experiment.grid.time(k)).collect();
    let inputs = experiment.inputs.iter().map(|(channel, input)| {
        let (name, unit) = channel_name(plane, *channel);
        Signal { name, unit, values: time.iter().map(|&t| input.at(t)).collect() }
    });
    let outputs = Output::of(plane).iter().map(|&output| {
        let Quantity { key, dimension, .. } = Quantity::of(output);
        Signal { name: key, unit: dimension.si_symbol(), values: motion.values(output) }
    });
    Ok(ResponseReport {
        aircraft: AircraftReport::of(&scenario.aircraft),
        set: subject.set.iter().cloned().collect(),
        plane: plane_name(plane),
        disturbance,
        shape,
        mode,
        inputs: inputs.collect(),
        outputs: outputs.collect(),
        time,
        small_until: motion.small_until,
        cut_at: motion.response.cut_at,
    })
}

/// Name and SI unit of what enters by a channel. Air is positive as in [`Channel`]: forward, downward, to the right.
const fn channel_name(plane: Plane, channel: Channel) -> (&'static str, &'static str) {
    let [first, second] = input_names(plane);
    match (channel, plane) {
        (Channel::First, _) => (first, "rad"),
        (Channel::Second, Plane::Longitudinal) => (second, ""),
        (Channel::Second, Plane::Lateral) => (second, "rad"),
        (Channel::AirAlong, _) => ("u_gust", "m/s"),
        (Channel::AirAcross, Plane::Longitudinal) => ("w_gust", "m/s"),
        (Channel::AirAcross, Plane::Lateral) => ("v_gust", "m/s"),
    }
}

/// Sets plane and disturbance.
fn choose_disturbance(
    scenario: &mut Scenario,
    request: &ResponseRequest,
) -> Result<(&'static str, Source), ExportError> {
    let planes = match request.plane.as_deref() {
        Some(name) => vec![plane_named(name)?],
        None => vec![scenario.plane, Plane::Longitudinal, Plane::Lateral],
    };
    if let Some(name) = request.disturbance.as_deref() {
        let (_, source) = named(name, &DISTURBANCES, "disturbance")?;
        let of_plane = planes.iter().find(|plane| Source::of(**plane).contains(&source));
        scenario.plane = *of_plane.ok_or_else(|| {
            ExportError::Request(format!("{name} doesn't disturb {} motion", plane_name(planes[0])))
        })?;
        scenario.disturbance.choice_mut(scenario.plane).source = source;
    } else {
        scenario.plane = planes[0];
    }
    let source = scenario.disturbance.choice(scenario.plane).source;
    Ok((name_of(source, &DISTURBANCES), source))
}

/// Sets the shape; `None` where the disturbance has one of its own.
fn choose_shape(
    scenario: &mut Scenario,
    request: &ResponseRequest,
    disturbance: &str,
) -> Result<Option<&'static str>, ExportError> {
    let choice = scenario.disturbance.choice_mut(scenario.plane);
    if let Some(name) = request.shape.as_deref() {
        let (_, shape) = named(name, &SHAPES, "shape")?;
        let shapes = choice.source.shapes();
        if !shapes.contains(&shape) {
            let names: Vec<&str> = shapes.iter().map(|shape| name_of(*shape, &SHAPES)).collect();
            let expected = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            let problem = format!("{disturbance} has no shape \"{name}\"; expected {expected}");
            return Err(ExportError::Request(problem));
        }
        *choice.shape_mut() = shape;
    }
    Ok(choice.shape().map(|shape| name_of(shape, &SHAPES)))
}

/// Sets the mode that is flown alone, if one is.
fn choose_mode(
    scenario: &mut Scenario,
    request: &ResponseRequest,
    source: Source,
) -> Result<Option<&'static str>, ExportError> {
    if source != Source::OneMode {
        return match request.mode {
            Some(_) => {
                Err(ExportError::Request("mode: expected with the disturbance \"mode\" only".to_owned()))
            }
            None => Ok(None),
        };
    }
    let analysis = scenario.analyse()?;
    let Some(Ok(of_plane)) = analysis.of(scenario.plane) else { return Err(no_motion(scenario, &analysis)) };
    let names: Vec<&'static str> = of_plane.modes.iter().map(|mode| mode.naming.name.text()).collect();
    let choice = scenario.disturbance.choice_mut(scenario.plane);
    if let Some(name) = request.mode.as_deref() {
        choice.mode = names.iter().position(|known| known.eq_ignore_ascii_case(name)).ok_or_else(|| {
            let names = names.join("\", \"");
            ExportError::Request(format!("there is no mode \"{name}\" here; expected \"{names}\""))
        })?;
    }
    Ok(names.get(choice.mode).copied())
}

/// Why nothing moves: the plane has no data, or its data no model.
fn no_motion(scenario: &Scenario, analysis: &Analysis) -> ExportError {
    match analysis.of(scenario.plane) {
        Some(Err(error)) => error.clone().into(),
        _ => ExportError::NoPlane { aircraft: scenario.aircraft.key.clone(), plane: scenario.plane },
    }
}

fn plane_named(name: &str) -> Result<Plane, ExportError> {
    let planes = [Plane::Longitudinal, Plane::Lateral].map(|plane| (plane_name(plane), plane));
    named(name, &planes, "plane").map(|(_, plane)| plane)
}

/// The row of this name in a table of names.
fn named<T: Copy>(
    name: &str,
    table: &[(&'static str, T)],
    what: &str,
) -> Result<(&'static str, T), ExportError> {
    table.iter().find(|(known, _)| *known == name).copied().ok_or_else(|| {
        let names: Vec<&str> = table.iter().map(|&(name, _)| name).collect();
        ExportError::Request(match nearest(name, names.iter().copied()) {
            Some(nearest) => format!("there is no {what} \"{name}\"; did you mean \"{nearest}\"?"),
            None => format!("there is no {what} \"{name}\"; expected one of {}", names.join(", ")),
        })
    })
}

fn name_of<T: PartialEq>(value: T, table: &[(&'static str, T)]) -> &'static str {
    table.iter().find(|(_, known)| *known == value).map_or("", |(name, _)| name)
}
