//! Why the modes of an aircraft stand elsewhere than those of its file, for other programs.

use serde::Serialize;

use super::error::ExportError;
use super::scene::Scene;
use crate::findings::Findings;
use crate::findings::change::{Cause, Change, Kind, Moved, NewTrim, Shift, reference_of};
use crate::flight::aircraft::plane::Plane;
use crate::key::Keyed as _;
use crate::scenario::Scenario;
use crate::words;

/// What became of an aircraft since its file, in both planes; numbers in SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WhyReport {
    /// Key of the aircraft.
    pub aircraft: String,
    /// Its name.
    pub name: String,
    /// One a plane that has changed.
    pub planes: Vec<WhyPlane>,
    /// What of the link can't be used, in sentences; none without a link.
    pub notices: Vec<String>,
    /// What it is compared with: `file`, the aircraft's file, or `pinned`, the state that the link has pinned.
    pub since: &'static str,
    /// Where the disturbance leads, if it is a step of a control that leads to steady flight.
    pub new_trim: Option<String>,
}

/// What became of one plane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WhyPlane {
    /// Its key.
    pub plane: &'static str,
    /// What was moved, in words.
    pub sentence: String,
    /// What was moved.
    pub edits: Vec<MovedReport>,
    /// The modes that have moved.
    pub modes: Vec<WhyMode>,
}

/// What became of one mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WhyMode {
    /// Its key.
    pub key: &'static str,
    /// Its name.
    pub name: &'static str,
    /// What changed and why, one to three sentences.
    pub sentences: Vec<String>,
    /// Its numbers that have moved.
    pub shifts: Vec<ShiftReport>,
}

/// A number that has moved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShiftReport {
    /// Its key: natural_frequency, damping_ratio or root.
    pub key: &'static str,
    /// Before.
    pub from: f64,
    /// After.
    pub to: f64,
    /// What each derivative did to it; null where roots meet on the way.
    pub causes: Option<Vec<CauseReport>>,
    /// Key of the approximation that has the change, if one does.
    pub approximation: Option<&'static str>,
    /// Its relative error before and after.
    pub errors: Option<[f64; 2]>,
}

/// A parameter that has moved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovedReport {
    /// Its key.
    pub key: &'static str,
    /// Before.
    pub from: f64,
    /// After.
    pub to: f64,
}

/// The part of a derivative.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CauseReport {
    /// The derivative.
    #[serde(flatten)]
    pub moved: MovedReport,
    /// Its part in the change.
    pub part: f64,
}

/// Why the modes stand where they do, and not where the aircraft's file has them, or the pinned state if there is one.
pub fn why(scene: &Scene) -> Result<WhyReport, ExportError> {
    let scenario = &scene.scenario;
    let mut notices = scene.notices.clone();
    let is_same = |pinned: &&Scenario| pinned.aircraft.key == scenario.aircraft.key;
    let pinned = scene.pinned.as_ref().filter(is_same);
    if scene.pinned.is_some() && pinned.is_none() {
        notices.push(words::change::OTHER_PINNED.to_owned());
    }
    let reference = pinned.cloned().unwrap_or_else(|| reference_of(scenario));
    let findings = Findings::of(scenario.clone());
    findings.analysis().as_ref().map_err(Clone::clone)?;
    let planes = Plane::ALL.into_iter().filter_map(|plane| of_plane(&reference, scenario, plane)).collect();
    let convention = scenario.convention();
    Ok(WhyReport {
        aircraft: scenario.aircraft.key.clone(),
        name: scenario.aircraft.name.clone(),
        planes,
        notices,
        since: if pinned.is_some() { "pinned" } else { "file" },
        new_trim: NewTrim::of(&findings).map(|trim| plain(&words::new_trim::sentence(&trim, convention))),
    })
}

fn of_plane(reference: &Scenario, scenario: &Scenario, plane: Plane) -> Option<WhyPlane> {
    let in_plane = |scenario: Scenario| Findings::of(Scenario { plane, ..scenario });
    let (before, after) = (in_plane(reference.clone()), in_plane(scenario.clone()));
    let change = Change::between(&before, &after).filter(|change| !change.edits.is_empty())?;
    let convention = scenario.convention();
    let modes = change.modes.iter().filter_map(|mode| {
        let reasons = words::change::reasons(&change, mode, convention)?;
        let shifts = match &mode.kind {
            Kind::Still | Kind::New => Vec::new(),
            Kind::Root(shift) => vec![ShiftReport::of("root", shift)],
            Kind::Oscillation(oscillation) => vec![
                ShiftReport::of("natural_frequency", &oscillation.frequency),
                ShiftReport::of("damping_ratio", &oscillation.damping_ratio),
            ],
        };
        Some(WhyMode {
            key: mode.name.key(),
            name: words::mode::title(mode.name),
            sentences: std::iter::once(reasons.headline)
                .chain(reasons.more)
                .map(|text| plain(&text))
                .collect(),
            shifts,
        })
    });
    Some(WhyPlane {
        plane: plane.key(),
        sentence: plain(&words::change::edits(&change, convention)),
        modes: modes.collect(),
        edits: change.edits.iter().map(MovedReport::of).collect(),
    })
}

/// Symbols without the braces that the page sets them by, and every space a plain one.
fn plain(text: &str) -> String {
    text.replace(['{', '}'], "").replace('\u{a0}', " ")
}

impl MovedReport {
    fn of(moved: &Moved) -> Self {
        let Moved { key, from, to } = *moved;
        Self { key, from, to }
    }
}

impl ShiftReport {
    fn of(key: &'static str, shift: &Shift) -> Self {
        let Shift { from, to, causes, formula, .. } = shift;
        let cause = |cause: &Cause| CauseReport { moved: MovedReport::of(&cause.moved), part: cause.part };
        let formula = formula.as_ref();
        Self {
            key,
            from: *from,
            to: *to,
            causes: causes.as_ref().map(|causes| causes.iter().map(cause).collect()),
            approximation: formula.map(|[before, _]| before.name.key()),
            errors: formula.map(|pair| pair.each_ref().map(|formula| formula.error)),
        }
    }
}
