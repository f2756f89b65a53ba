//! The disturbances by name, as a request chooses them.

use super::plane::input_names;
use super::subject::{ExportError, nearest, plane_name};
use crate::findings::{Findings, Problem};
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::scenario::{Scenario, Shape, Source};
use crate::words;

/// The disturbances by the name that a request gives them. Their sizes are parameters of the table:
/// `elevator`, `gust`, `part` and so on, and `time` for how long the motion is watched.
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

/// Name and SI unit of what enters by a channel. Air is positive as in [`Channel`]: forward, downward, to the right.
pub const fn channel_name(plane: Plane, channel: Channel) -> (&'static str, &'static str) {
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

/// Sets plane and disturbance, one of `table`; `what` they are, in a message. Without a name it stays that of the page.
pub(super) fn choose_disturbance(
    scenario: &mut Scenario,
    plane: Option<&str>,
    name: Option<&str>,
    table: &[(&'static str, Source)],
    what: &str,
) -> Result<(&'static str, Source), ExportError> {
    let planes = match plane {
        Some(name) => vec![plane_named(name)?],
        None => vec![scenario.plane, Plane::Longitudinal, Plane::Lateral],
    };
    if let Some(name) = name {
        let (_, source) = named(name, table, what)?;
        let of_plane = planes.iter().find(|plane| Source::of(**plane).contains(&source));
        scenario.plane = *of_plane.ok_or_else(|| {
            ExportError::Request(format!("{name} doesn't disturb {} motion", plane_name(planes[0])))
        })?;
        scenario.disturbance.choices[scenario.plane].source = source;
    } else {
        scenario.plane = planes[0];
    }
    let source = scenario.disturbance.choices[scenario.plane].source;
    Ok((name_of(source, &DISTURBANCES), source))
}

/// Sets the shape; `None` where the disturbance has one of its own.
pub(super) fn choose_shape(
    scenario: &mut Scenario,
    name: Option<&str>,
    disturbance: &str,
) -> Result<Option<&'static str>, ExportError> {
    let choice = &mut scenario.disturbance.choices[scenario.plane];
    if let Some(name) = name {
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
pub(super) fn choose_mode(
    scenario: &mut Scenario,
    name: Option<&str>,
    source: Source,
) -> Result<Option<&'static str>, ExportError> {
    if source != Source::OneMode {
        return match name {
            Some(_) => {
                Err(ExportError::Request("mode: expected with the disturbance \"mode\" only".to_owned()))
            }
            None => Ok(None),
        };
    }
    let findings = Findings::of(scenario.clone());
    if findings.plane().is_none() {
        return Err(no_motion(&findings));
    }
    let names: Vec<&'static str> =
        findings.modes().iter().map(|mode| words::mode::title(mode.naming.name)).collect();
    let choice = &mut scenario.disturbance.choices[scenario.plane];
    if let Some(name) = name {
        choice.mode = names.iter().position(|known| known.eq_ignore_ascii_case(name)).ok_or_else(|| {
            let names = names.join("\", \"");
            ExportError::Request(format!("there is no mode \"{name}\" here; expected \"{names}\""))
        })?;
    }
    Ok(names.get(choice.mode).copied())
}

/// Error of a scenario without motion: the plane has no data, or its data no model.
pub(super) fn no_motion(findings: &Findings) -> ExportError {
    let scenario = findings.scenario();
    match findings.problem() {
        Some(Problem::Analysis(error)) => error.into(),
        Some(Problem::NoData) | None => {
            ExportError::NoPlane { aircraft: scenario.aircraft.key.clone(), plane: scenario.plane }
        }
    }
}

fn plane_named(name: &str) -> Result<Plane, ExportError> {
    let planes = Plane::ALL.map(|plane| (plane_name(plane), plane));
    named(name, &planes, "plane").map(|(_, plane)| plane)
}

/// The row of this name in a table of names.
pub(super) fn named<T: Copy>(
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
