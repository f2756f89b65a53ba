//! The disturbance that a request chooses. Its size is a parameter of the table: `elevator`, `gust`, `part` and so on, and `time` for
//! how long the motion is watched.

use super::error::ExportError;
use crate::findings::{Findings, Problem};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::motion::outputs::Output;
use crate::key::{Keyed, nearest};
use crate::scenario::{Parameter, Scenario, Shape, Source};

/// Sets plane and disturbance, one of `sources`; `what` they are, in a message. Without a name it stays that of the page.
pub(super) fn choose_disturbance(
    scenario: &mut Scenario,
    plane: Option<&str>,
    name: Option<&str>,
    sources: &[Source],
    what: &str,
) -> Result<Source, ExportError> {
    let planes = match plane {
        Some(name) => vec![named(name, &Plane::ALL, "plane")?],
        None => vec![scenario.plane, Plane::Longitudinal, Plane::Lateral],
    };
    if let Some(name) = name {
        let source = named(name, sources, what)?;
        let of_plane = planes.iter().find(|plane| Source::of(**plane).contains(&source));
        scenario.plane = *of_plane.ok_or_else(|| {
            ExportError::Request(format!("{name} doesn't disturb {} motion", planes[0].key()))
        })?;
        scenario.disturbance.choices[scenario.plane].source = source;
    } else {
        scenario.plane = planes[0];
    }
    Ok(scenario.disturbance.choices[scenario.plane].source)
}

/// Sets the shape; `None` where the disturbance has one of its own.
pub(super) fn choose_shape(
    scenario: &mut Scenario,
    name: Option<&str>,
) -> Result<Option<Shape>, ExportError> {
    let choice = &mut scenario.disturbance.choices[scenario.plane];
    if let Some(name) = name {
        let shape = named(name, Shape::VALUES, "shape")?;
        let shapes = choice.source.shapes();
        if !shapes.contains(&shape) {
            let keys: Vec<&str> = shapes.iter().map(|shape| shape.key()).collect();
            let expected = if keys.is_empty() { "none".to_owned() } else { keys.join(", ") };
            let problem = format!("{} has no shape \"{name}\"; expected {expected}", choice.source.key());
            return Err(ExportError::Request(problem));
        }
        *choice.shape_mut() = shape;
    }
    Ok(choice.shape())
}

/// Sets the mode that is flown alone, if one is: of those of the aircraft as it flies, under a law of feedback where there is one.
pub(super) fn choose_mode(
    scenario: &mut Scenario,
    name: Option<&str>,
    source: Source,
) -> Result<Option<ModeName>, ExportError> {
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
    let modes: Vec<ModeName> = findings.flown_modes().iter().map(|mode| mode.naming.name).collect();
    let choice = &mut scenario.disturbance.choices[scenario.plane];
    if let Some(name) = name {
        let wanted = ModeName::by_key(name);
        let by_name = modes.iter().position(|mode| Some(*mode) == wanted);
        // By its number, as in links.
        let by_number =
            || (1..=modes.len()).find(|number| number.to_string() == name).map(|number| number - 1);
        choice.mode = by_name.or_else(by_number).ok_or_else(|| {
            let keys = modes.iter().map(|mode| mode.key()).collect::<Vec<_>>().join("\", \"");
            ExportError::Request(format!("there is no mode \"{name}\" here; expected \"{keys}\""))
        })?;
    }
    Ok(modes.get(choice.mode).or(modes.last()).copied())
}

/// The same scenario for the aircraft without its law and without further states, which flies its own mode by that name; at rest where it
/// has none. Whether it has one.
pub(super) fn flown_alone(mut scenario: Scenario, mode: ModeName) -> (Scenario, bool) {
    let findings = Findings::of(scenario.clone());
    let place = findings.modes().iter().position(|own| own.naming.name == mode);
    let disturbance = &mut scenario.disturbance;
    match place {
        Some(place) => disturbance.choices[scenario.plane].mode = place,
        None => disturbance.sizes.mode = 0.0,
    }
    (scenario, place.is_some())
}

/// Refuses a size that is set although the disturbance doesn't have it: it would be ignored.
pub(super) fn check_sizes(scenario: &Scenario, sizes: &[&'static Parameter]) -> Result<(), ExportError> {
    let choice = &scenario.disturbance.choices[scenario.plane];
    let mut own = choice.parameters(scenario.plane);
    own.extend(["times", "time"]);
    let Some(Parameter { key, name, .. }) = sizes.iter().find(|size| !own.contains(&size.key)) else {
        return Ok(());
    };
    let (plane, source) = (scenario.plane.key(), choice.source.key());
    let disturbance =
        choice.shape().map_or_else(|| source.to_owned(), |shape| format!("{source} {}", shape.key()));
    let expected = own.join(", ");
    Err(ExportError::Request(format!(
        "{key} ({name}) is no size of the disturbance \"{disturbance}\" in {plane} motion; expected {expected}"
    )))
}

/// Refuses a command that no gain listens to: nothing would move.
pub(super) fn check_command(scenario: &Scenario, source: Source) -> Result<(), ExportError> {
    let plane = scenario.plane;
    match source.command().map(Output::commanded) {
        Some(output) if !scenario.law.listens_to(plane, output) => {
            let controls = match plane {
                Plane::Longitudinal => ["de", "dt"],
                Plane::Lateral => ["da", "dr"],
            };
            let [first, second] = controls.map(|control| format!("k.{}_{control}", output.key()));
            Err(ExportError::Request(format!(
                "{}: nothing listens to a command of {} without a gain of it; set {first} or {second}",
                source.key(),
                output.key()
            )))
        }
        Some(_) | None => Ok(()),
    }
}

/// Refuses every size that is set, where nothing is disturbed.
pub(super) fn check_no_sizes(sizes: &[&'static Parameter]) -> Result<(), ExportError> {
    match sizes.first() {
        Some(Parameter { key, name, .. }) => Err(ExportError::Request(format!(
            "{key} ({name}) sizes a disturbance, which has no part in this answer; only \"respond\" uses it"
        ))),
        None => Ok(()),
    }
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

/// The value of a key, one of `fitting`; `what` they are, in a message.
pub(super) fn named<T: Keyed>(name: &str, fitting: &[T], what: &str) -> Result<T, ExportError> {
    T::by_key(name).filter(|value| fitting.contains(value)).ok_or_else(|| {
        let keys: Vec<&str> = fitting.iter().map(|value| value.key()).collect();
        ExportError::Request(match nearest(name, keys.iter().copied()) {
            Some(nearest) => format!("there is no {what} \"{name}\"; did you mean \"{nearest}\"?"),
            None => format!("there is no {what} \"{name}\"; expected one of {}", keys.join(", ")),
        })
    })
}
