//! The modes along a range of one parameter.

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::aircraft::AircraftReport;
use super::disturbance::check_no_sizes;
use super::error::ExportError;
use super::measures::{MeasureValue, find_measure, value_of};
use super::report::Units;
use super::scene::Scene;
use super::subject::{checked, find_parameter, set_on};
use crate::findings::Findings;
use crate::findings::measures::Measure;
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::feedback::closed_model::ClosedModel;
use crate::flight::feedback::loop_analysis::worst_stability;
use crate::flight::feedback::{Law, analyse_loop};
use crate::flight::modes::mode::{Mode, modes};
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::static_stability::plane_static_stability;
use crate::key::Keyed;
use crate::scenario::{Parameter, Scenario};
use crate::words::{self, Told};

/// More points than this are refused: a slip of the finger, and more than a file is good for.
pub const MOST_POINTS: usize = 100_000;

/// A change of verdict is found to this fraction of the step between two points, 2⁻⁴⁰.
const HALVINGS: usize = 40;

/// A parameter, and the values that it goes through.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
#[serde(deny_unknown_fields)]
pub struct SweepRequest {
    /// Key of the parameter.
    pub parameter: String,
    /// First value \[SI\].
    pub from: f64,
    /// Last value \[SI\].
    pub to: f64,
    /// Number of values, both ends among them.
    #[serde(default = "some_points")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub points: usize,
    /// Keys of measures that are read at every point.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub measures: Vec<String>,
}

const fn some_points() -> usize {
    51
}

/// Modes and verdicts along a sweep.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Sweep"))]
pub struct SweepReport {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// The unit of every number below, by the name of its field.
    #[cfg_attr(test, ts(type = "Record<string, string>"))]
    pub units: Units,
    /// Other values set on it, SI.
    #[cfg_attr(test, ts(type = "Record<string, number>"))]
    pub set: BTreeMap<String, f64>,
    /// What of the link can't be used, in sentences; none without a link.
    pub notices: Vec<String>,
    /// Key of the parameter.
    pub parameter: &'static str,
    /// Its SI unit: that of `value`, `between` and `at`.
    pub unit: &'static str,
    /// The measures that were asked for, with the SI unit of each number, in the order of `measures` at every point.
    pub measures: Vec<MeasureColumn>,
    /// The points in order.
    pub points: Vec<SweepPoint>,
    /// Changes of a verdict, with their places.
    pub changes: Vec<SweepChange>,
}

/// A measure that is read at every point of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MeasureColumn {
    /// Its key.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// SI unit of its numbers; empty for a ratio or a verdict.
    pub unit: &'static str,
}

/// A point of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SweepPoint {
    /// Value of the parameter.
    pub value: f64,
    /// Longitudinal motion; null where the aircraft has no data of it or the parameter doesn't move it.
    pub longitudinal: Option<SweepPlane>,
    /// Lateral–directional motion, likewise.
    pub lateral: Option<SweepPlane>,
    /// Reason why a plane with data has no modes here.
    pub error: Option<String>,
    /// What the measures read here; null where there is nothing to read.
    pub measures: Vec<Option<MeasureValue>>,
}

/// A plane of motion at one point.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SweepPlane {
    /// `stable`, `neutral` or `unstable`.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub static_stability: &'static str,
    /// Stability of the worst mode.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub dynamic_stability: &'static str,
    /// det A.
    pub determinant: f64,
    /// The modes.
    pub modes: Vec<SweepMode>,
}

/// A mode at one point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SweepMode {
    /// Key of the mode.
    #[cfg_attr(test, ts(type = "ModeKey"))]
    pub key: &'static str,
    /// Name of the mode.
    pub name: &'static str,
    /// `stable`, `neutral` or `unstable`: whether this mode dies away.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub stability: &'static str,
    /// Real part.
    pub re: f64,
    /// Imaginary part, not negative.
    pub im: f64,
    /// ωₙ, of an oscillation.
    pub natural_frequency: Option<f64>,
    /// ζ, of an oscillation.
    pub damping_ratio: Option<f64>,
}

/// A change of verdict between two neighbouring points.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SweepChange {
    /// The plane.
    #[cfg_attr(test, ts(type = "PlaneName"))]
    pub plane: &'static str,
    /// `static` or `dynamic`.
    #[cfg_attr(test, ts(type = "StabilityKind"))]
    pub stability: &'static str,
    /// The points before and after it.
    pub between: [f64; 2],
    /// Value of the parameter there, by bisection; the value of one change, should there be several between the two points.
    pub at: f64,
    /// The verdict before.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub from: &'static str,
    /// The verdict after.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub to: &'static str,
}

/// A sweep under way: an iterator over its points, so that a person can be shown how far it is.
#[derive(Debug)]
pub struct Sweep {
    scenario: Scenario,
    set: BTreeMap<String, f64>,
    notices: Vec<String>,
    parameter: &'static Parameter,
    planes: Vec<Plane>,
    measures: Vec<Measure>,
    values: Vec<f64>,
    next: usize,
}

impl Sweep {
    /// Checks everything; nothing is computed yet.
    pub fn new(scene: Scene, request: &SweepRequest) -> Result<Self, ExportError> {
        check_no_sizes(&scene.sizes)?;
        let Scene { scenario, notices, .. } = scene;
        let parameter = find_parameter(&request.parameter)?;
        let &SweepRequest { from, to, points, .. } = request;
        for end in [from, to] {
            checked(&scenario, parameter, end)?;
        }
        if !(2..=MOST_POINTS).contains(&points) {
            let problem = format!("points: expected 2 to {MOST_POINTS}, found {points}");
            return Err(ExportError::Request(problem));
        }
        if from == to {
            return Err(ExportError::Request(format!("a sweep from {from} to {to} goes nowhere")));
        }
        let last = points - 1;
        let value = |k: usize| from * ((last - k) as f64 / last as f64) + to * (k as f64 / last as f64);
        let measures = request.measures.iter().map(|key| find_measure(key)).collect::<Result<Vec<_>, _>>()?;
        let set = set_on(&scenario);
        let planes = moved_planes(&scenario, parameter, from, to);
        if planes.is_empty() && measures.is_empty() {
            let Parameter { key, name, .. } = parameter;
            return Err(ExportError::Request(format!(
                "{key} ({name}) moves no mode: there is nothing to sweep"
            )));
        }
        Ok(Self {
            scenario,
            set,
            notices,
            parameter,
            planes,
            measures,
            values: (0..points).map(value).collect(),
            next: 0,
        })
    }

    /// Everything at once.
    pub fn report(mut self) -> SweepReport {
        let points: Vec<SweepPoint> = self.by_ref().collect();
        self.report_of(points)
    }

    /// The points of this sweep together with where verdicts change between them.
    pub fn report_of(&self, points: Vec<SweepPoint>) -> SweepReport {
        let mut changes = Vec::new();
        for &plane in &self.planes {
            for kind in Verdict::ALL {
                self.find_changes(plane, kind, &points, &mut changes);
            }
        }
        SweepReport {
            aircraft: AircraftReport::of(&self.scenario.aircraft),
            units: Units,
            set: self.set.clone(),
            notices: self.notices.clone(),
            parameter: self.parameter.key,
            unit: self.parameter.dimension.si_symbol(),
            measures: self.measures.iter().map(|measure| MeasureColumn::of(*measure)).collect(),
            points,
            changes,
        }
    }

    fn point(&self, value: f64) -> SweepPoint {
        let moved = moved(&self.scenario, self.parameter, value);
        let measures = self.read(&moved);
        let length = moved.units.length_of_reports();
        let models = match moved.edited.models() {
            Ok(models) => models,
            Err(error) => {
                let error = Some(Told(&error, length).to_string());
                return SweepPoint { value, longitudinal: None, lateral: None, error, measures };
            }
        };
        let is_of = |problem: &&ModelError| problem.plane().is_none_or(|plane| self.planes.contains(&plane));
        let mut error = models.problems.iter().find(is_of).map(|problem| Told(problem, length).to_string());
        let mut of = |plane: Plane| {
            let model = models.planes[plane].as_ref().filter(|_| self.planes.contains(&plane))?;
            match sweep_plane(model, &moved) {
                Ok(plane) => Some(plane),
                Err(problem) => {
                    error.get_or_insert(problem);
                    None
                }
            }
        };
        let (longitudinal, lateral) = (of(Plane::Longitudinal), of(Plane::Lateral));
        SweepPoint { value, longitudinal, lateral, error, measures }
    }

    /// What the measures read of a scenario.
    fn read(&self, moved: &Scenario) -> Vec<Option<MeasureValue>> {
        if self.measures.is_empty() {
            return Vec::new();
        }
        let findings = Findings::of(moved.clone());
        self.measures.iter().map(|measure| value_of(*measure, &findings)).collect()
    }

    /// Places where a verdict turns from stable to unstable or back. A point on the boundary is neither; across points without
    /// modes nothing is said.
    fn find_changes(&self, plane: Plane, kind: Verdict, points: &[SweepPoint], found: &mut Vec<SweepChange>) {
        let mut before: Option<(f64, &'static str)> = None;
        for point in points {
            let Some(to) = kind.of(plane, point) else {
                before = None;
                continue;
            };
            if to == Stability::Neutral.key() {
                continue;
            }
            if let Some((value, from)) = before.filter(|(_, from)| *from != to) {
                let between = [value, point.value];
                let at = self.boundary(plane, kind, from, between);
                let stability = kind.key();
                found.push(SweepChange { plane: plane.key(), stability, between, at, from, to });
            }
            before = Some((point.value, to));
        }
    }

    /// Value at which the verdict stops being `from`.
    fn boundary(&self, plane: Plane, kind: Verdict, from: &str, [mut before, mut after]: [f64; 2]) -> f64 {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (before + after);
            match kind.of(plane, &self.point(middle)) {
                Some(verdict) if verdict == Stability::Neutral.key() => return middle,
                Some(verdict) if verdict == from => before = middle,
                _ => after = middle,
            }
        }
        0.5 * (before + after)
    }
}

impl MeasureColumn {
    fn of(measure: Measure) -> Self {
        Self {
            key: measure.key(),
            name: words::measure::name(measure),
            unit: measure.dimension().si_symbol(),
        }
    }
}

impl Iterator for Sweep {
    type Item = SweepPoint;

    fn next(&mut self) -> Option<SweepPoint> {
        let value = *self.values.get(self.next)?;
        self.next += 1;
        Some(self.point(value))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.values.len() - self.next;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Sweep {}

#[derive(Clone, Copy)]
pub(super) enum Verdict {
    Static,
    Dynamic,
}

impl Verdict {
    pub(super) const ALL: [Self; 2] = [Self::Static, Self::Dynamic];

    pub(super) const fn key(self) -> &'static str {
        match self {
            Self::Static => "static",
            Self::Dynamic => "dynamic",
        }
    }

    fn of(self, plane: Plane, point: &SweepPoint) -> Option<&'static str> {
        let plane = match plane {
            Plane::Longitudinal => point.longitudinal.as_ref(),
            Plane::Lateral => point.lateral.as_ref(),
        }?;
        Some(match self {
            Self::Static => plane.static_stability,
            Self::Dynamic => plane.dynamic_stability,
        })
    }
}

fn moved(scenario: &Scenario, parameter: &Parameter, value: f64) -> Scenario {
    let mut moved = scenario.clone();
    parameter.set(&mut moved, value);
    moved
}

/// The planes whose A is not the same at both ends and in the middle. Where there is no such flight, nothing is known of it and
/// both are kept.
fn moved_planes(scenario: &Scenario, parameter: &Parameter, from: f64, to: f64) -> Vec<Plane> {
    let at = [from, 0.5 * (from + to), to].map(|value| {
        let moved = moved(scenario, parameter, value);
        Some((moved.edited.models().ok()?, moved.law))
    });
    let is_moved = |plane: &Plane| match &at {
        [Some(first), Some(second), Some(third)] => {
            let a = [first, second, third].map(|(models, law)| {
                let model = models.planes[*plane].as_ref()?;
                Some((model.a, flown_matrix(model, law)))
            });
            a[0] != a[1] || a[1] != a[2]
        }
        _ => true,
    };
    Plane::ALL.into_iter().filter(is_moved).collect()
}

/// A of a plane under its law; `None` where nothing is fed back.
fn flown_matrix(model: &PlaneModel, law: &Law) -> Option<DMatrix<f64>> {
    if law.is_open(model.plane) && model.further.is_none() {
        return None;
    }
    ClosedModel::new(model, law).ok().map(|closed| closed.a)
}

/// The modes of a plane as it flies: under the law where there is one.
fn flown_modes(model: &PlaneModel, law: &Law) -> Result<Vec<Mode>, String> {
    if law.is_open(model.plane) && model.further.is_none() {
        return modes(model).map_err(|error| error.to_string());
    }
    let closed = analyse_loop(model, law, None).map_err(|error| error.to_string())?;
    Ok(closed.modes.into_iter().map(|mode| mode.mode).collect())
}

fn sweep_plane(model: &PlaneModel, scenario: &Scenario) -> Result<SweepPlane, String> {
    let modes = flown_modes(model, &scenario.law)?;
    let derivatives = scenario.edited.derivatives_behind(model.plane);
    let of_static = plane_static_stability(&StabilityAxes::of(model), derivatives.as_ref());
    Ok(SweepPlane {
        static_stability: of_static.verdict.key(),
        dynamic_stability: worst_stability(modes.iter()).key(),
        determinant: of_static.determinant,
        modes: modes.iter().map(sweep_mode).collect(),
    })
}

fn sweep_mode(mode: &Mode) -> SweepMode {
    SweepMode {
        key: mode.naming.name.key(),
        name: words::mode::title(mode.naming.name),
        stability: mode.stability.key(),
        re: mode.lambda.re,
        im: mode.lambda.im,
        natural_frequency: mode.natural_frequency(),
        damping_ratio: mode.damping_ratio(),
    }
}
