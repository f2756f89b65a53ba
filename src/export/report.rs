//! Everything that follows for an aircraft, for other programs: SI and radians, fields in the order of a report.

use serde::Serialize;

use super::aircraft::AircraftReport;
use super::closed_loop::LoopOutcome;
use super::disturbance::check_no_sizes;
use super::error::ExportError;
use super::level::OverallLevelReport;
use super::plane::PlaneReport;
use super::scene::Scene;
use super::subject::set_on;
use crate::findings::Findings;
use crate::flight::analysis::{Margins, PlaneAnalysis};
use crate::flight::{Analysis, AnalysisError};
use crate::words::{self, Told};

/// The analysis of an aircraft.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Analysis"))]
pub struct Report {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// How far its numbers can be trusted as they are set, in words: the aircraft's own status is that of its file.
    pub status_now: String,
    /// The unit of every number below, by the name of its field; numbers without one are ratios.
    #[cfg_attr(test, ts(type = "Record<string, string>"))]
    pub units: Units,
    /// Values set on it, SI.
    #[cfg_attr(test, ts(type = "Record<string, number>"))]
    pub set: std::collections::BTreeMap<String, f64>,
    /// What of the link can't be used, in sentences; none without a link.
    pub notices: Vec<String>,
    /// Longitudinal motion, x = \[u, w, q, θ\]; null where the aircraft has no data of it.
    pub longitudinal: Option<PlaneOutcome>,
    /// Lateral–directional motion, x = \[v, p, r, φ\].
    pub lateral: Option<PlaneOutcome>,
    /// Static margin in mean chords, positive where stable; of an aircraft given by coefficients only.
    pub static_margin: Option<f64>,
    /// Manoeuvre margin in mean chords.
    pub manoeuvre_margin: Option<f64>,
    /// The level of handling qualities as a whole; null where nothing is judged.
    pub overall_level: Option<OverallLevelReport>,
    /// False where gravity and speed of the model can't belong to one system of units.
    pub gravity_is_plausible: Option<bool>,
}

/// Units by the name of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units;

impl Units {
    /// Field and unit.
    pub const ALL: [(&'static str, &'static str); 22] = [
        ("re", "1/s"),
        ("im", "rad/s"),
        ("eigenvalues", "1/s"),
        ("natural_frequency", "rad/s"),
        ("damped_frequency", "rad/s"),
        ("period", "s"),
        ("time_to_half", "s"),
        ("time_to_double", "s"),
        ("time_constant", "s"),
        ("root", "1/s"),
        ("determinant", "1/s⁴"),
        ("pitch_stiffness", "1/(m·s)"),
        ("to_manoeuvre_point", "1/(m·s)"),
        ("weathercock_stiffness", "1/(m·s)"),
        ("dihedral_effect", "1/(m·s)"),
        ("spiral_condition", "1/(m·s²)"),
        ("speed", "m/s"),
        ("alpha0", "rad"),
        ("gamma0", "rad"),
        ("gravity", "m/s²"),
        ("states", "m/s, rad/s, rad"),
        ("inputs", "rad; throttle as a share of the weight where the source says nothing of its engine"),
    ];
}

impl Serialize for Units {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Self::ALL)
    }
}

/// The analysis of one plane, or the reason why there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum PlaneOutcome {
    /// The analysis.
    Analysed(Box<PlaneReport>),
    /// No analysis.
    Failed {
        /// In one sentence.
        error: String,
    },
}

impl PlaneOutcome {
    /// The analysis, if there is one.
    pub fn report(&self) -> Option<&PlaneReport> {
        match self {
            Self::Analysed(report) => Some(report),
            Self::Failed { .. } => None,
        }
    }
}

impl PlaneOutcome {
    fn of(outcome: &Result<PlaneAnalysis, AnalysisError>, findings: &Findings) -> Self {
        match outcome {
            Ok(analysis) => {
                let closed_loop = LoopOutcome::of(findings, analysis.model.plane);
                Self::Analysed(Box::new(PlaneReport {
                    closed_loop,
                    ..PlaneReport::of(analysis, findings.scenario().notation)
                }))
            }
            Err(error) => {
                let length = findings.scenario().units.length_of_reports();
                Self::Failed { error: Told(error, length).to_string() }
            }
        }
    }
}

/// Everything that follows for an aircraft as it is set.
pub fn analyse(scene: &Scene) -> Result<Report, ExportError> {
    check_no_sizes(&scene.sizes)?;
    let findings = Findings::of(scene.scenario.clone());
    let analysis = findings.analysis().as_ref().map_err(Clone::clone)?;
    let &Analysis { margins, gravity, .. } = analysis;
    let aircraft = &findings.scenario().aircraft;
    let of_plane = |outcome| PlaneOutcome::of(outcome, &findings);
    Ok(Report {
        aircraft: AircraftReport::of(aircraft),
        status_now: words::status::sentence(&aircraft.name, aircraft.status, findings.scenario().is_edited()),
        units: Units,
        set: set_on(findings.scenario()),
        notices: scene.notices.clone(),
        longitudinal: analysis.planes.longitudinal.as_ref().map(of_plane),
        lateral: analysis.planes.lateral.as_ref().map(of_plane),
        static_margin: margins.map(|Margins { static_margin, .. }| static_margin),
        manoeuvre_margin: margins.map(|Margins { manoeuvre_margin, .. }| manoeuvre_margin),
        overall_level: analysis.overall_level().map(|overall| OverallLevelReport::of(&overall)),
        gravity_is_plausible: gravity.map(|gravity| gravity.is_plausible()),
    })
}
