//! A scene as a link, for other programs.

use serde::{Deserialize, Serialize};

use super::disturbance::{check_sizes, choose_disturbance, choose_mode, choose_shape};
use super::error::ExportError;
use super::scene::Scene;
use crate::key::Keyed;
use crate::scenario::{Source, link};

/// A disturbance, and how its motion is shown.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
#[serde(deny_unknown_fields)]
pub struct DisturbanceRequest {
    /// `longitudinal` or `lateral`; by default that of the disturbance or of the scene.
    #[cfg_attr(test, ts(optional, type = "PlaneName"))]
    pub plane: Option<String>,
    /// Key of the disturbance; by default that of the scene. Its size is a parameter.
    #[cfg_attr(test, ts(optional, type = "Disturbance"))]
    pub disturbance: Option<String>,
    /// Its shape in time, of those it can have.
    #[cfg_attr(test, ts(optional, type = "Shape"))]
    pub shape: Option<String>,
    /// The mode that is flown alone, by its key or its number, with the disturbance `mode`.
    pub mode: Option<String>,
    /// Whether the nonlinear flight is drawn too.
    pub nonlinear: Option<bool>,
    /// Whether motions over time are split into modes.
    pub split: Option<bool>,
}

/// A scene as a link.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Link"))]
pub struct LinkReport {
    /// The link, with its `#` and the address before that if there is one.
    pub link: String,
    /// What of the link in the request can't be used, in sentences.
    pub notices: Vec<String>,
}

/// A scene under another disturbance.
pub(super) fn disturbed(scene: &Scene, request: &DisturbanceRequest) -> Result<Scene, ExportError> {
    let mut scene = scene.clone();
    let scenario = &mut scene.scenario;
    let (plane, name) = (request.plane.as_deref(), request.disturbance.as_deref());
    let source = choose_disturbance(scenario, plane, name, Source::VALUES, "disturbance")?;
    choose_shape(scenario, request.shape.as_deref())?;
    if request.mode.is_some() {
        choose_mode(scenario, request.mode.as_deref(), source)?;
    }
    check_sizes(scenario, &scene.sizes)?;
    if scenario.aircraft.plane_notes[scenario.plane].is_none() {
        return Err(ExportError::NoPlane { aircraft: scenario.aircraft.key.clone(), plane: scenario.plane });
    }
    let response = &mut scene.view.response;
    response.nonlinear = request.nonlinear.unwrap_or(response.nonlinear);
    response.split = request.split.unwrap_or(response.split);
    Ok(scene)
}

/// The scene of a request as a link, behind the address of the page if there is one.
pub fn link_to(
    scene: &Scene,
    request: &DisturbanceRequest,
    address: Option<&str>,
) -> Result<LinkReport, ExportError> {
    let (aircraft, key) = (&scene.scenario.aircraft, &scene.scenario.aircraft.key);
    if !link::own::has_room(aircraft) {
        let most = link::own::LONGEST_OWN;
        return Err(ExportError::Request(format!(
            "{key} is too long for a link, which has room for {most} characters of it"
        )));
    }
    if aircraft.own.is_none() && !scene.has_link() {
        return Err(ExportError::Request(format!("a link names an aircraft of the list, and {key} is none")));
    }
    let Scene { scenario, pinned, view, lesson, notices, .. } = disturbed(scene, request)?;
    let address = address.unwrap_or_default();
    let page = address.split_once('#').map_or(address, |(page, _)| page);
    let lesson = lesson.map(|place| place.in_link()).unwrap_or_default();
    let link = link::write(&scenario, &view, pinned.as_ref());
    Ok(LinkReport { link: format!("{page}#{link}{lesson}"), notices })
}
