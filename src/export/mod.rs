//! What other programs ask and read. [`state()`] is that of the page; all else answers a request about a [`Subject`]: the
//! command line and JavaScript go through the same functions. SI and radians, and every number finite or null.

pub mod json;
mod list;
mod report;
mod respond;
mod subject;
mod sweep;

use serde_json::{Map, Value, json};

use crate::flight::analysis::{Motion, PlaneAnalysis};
use crate::flight::modes::{DynamicStability, Mode};
use crate::flight::plane::Plane;
use crate::flight::static_stability::StaticVerdict;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::{Scenario, parameters};

pub use list::{ParameterReport, list, parameters_of};
pub use report::{
    AircraftReport, ApproximationReport, JudgedReport, LevelReport, ModeReport, PlaneOutcome, PlaneReport,
    Report, StaticReport, StiffnessReport, TrimReport, Units, ValueReport, analyse,
};
pub use respond::{DISTURBANCES, ResponseReport, ResponseRequest, SHAPES, Signal, respond};
pub use subject::{ExportError, Source, Subject};
pub use sweep::{
    MOST_POINTS, Sweep, SweepChange, SweepMode, SweepPlane, SweepPoint, SweepReport, SweepRequest,
};

/// What is studied and what follows from it, SI and radians; an analysis that failed is a sentence.
pub fn state(scenario: &Scenario, analysis: &Result<Analysis, AnalysisError>) -> Value {
    let parameters: Map<String, Value> = parameters()
        .filter(|p| p.applies(scenario))
        .map(|p| (p.key.to_owned(), json!(p.get(scenario))))
        .collect();
    json!({
        "aircraft": scenario.aircraft.key,
        "plane": match scenario.plane {
            Plane::Longitudinal => "longitudinal",
            Plane::Lateral => "lateral",
        },
        "disturbance": scenario.disturbance.choice(scenario.plane).text(),
        "parameters": parameters,
        "analysis": match analysis {
            Ok(analysis) => of_analysis(analysis),
            Err(error) => of_error(error),
        },
    })
}

fn of_analysis(analysis: &Analysis) -> Value {
    let of = |plane: Plane| match analysis.of(plane)? {
        Ok(plane) => Some(of_plane(plane)),
        Err(error) => Some(of_error(error)),
    };
    json!({
        "longitudinal": of(Plane::Longitudinal),
        "lateral": of(Plane::Lateral),
        "static_margin": analysis.margins.map(|margins| margins.static_margin),
        "manoeuvre_margin": analysis.margins.map(|margins| margins.manoeuvre_margin),
        "gravity_is_plausible": analysis.gravity.map(|gravity| gravity.is_plausible()),
        "response": analysis.motion.as_ref().map(of_motion),
    })
}

fn of_error(error: &AnalysisError) -> Value {
    json!({ "error": error.to_string() })
}

fn of_plane(plane: &PlaneAnalysis) -> Value {
    json!({
        "modes": plane.modes.iter().map(of_mode).collect::<Vec<_>>(),
        "dynamic_stability": word(plane.dynamic_stability),
        "static_stability": match plane.static_stability.verdict {
            StaticVerdict::Stable => "stable",
            StaticVerdict::Neutral => "neutral",
            StaticVerdict::Unstable => "unstable",
        },
        "determinant": plane.static_stability.determinant,
        "levels": plane.levels.iter().map(|verdict| verdict.sentence()).collect::<Vec<_>>(),
    })
}

fn of_motion(motion: &Motion) -> Value {
    json!({
        "dt": motion.response.dt,
        "samples": motion.response.states.len(),
        "last": motion.response.states.last().map(|x| [x[0], x[1], x[2], x[3]]),
        "small_until": motion.small_until,
    })
}

fn of_mode(mode: &Mode) -> Value {
    json!({
        "name": mode.naming.name.text(),
        "reason": mode.naming.reason,
        "re": mode.lambda.re,
        "im": mode.lambda.im,
        "damping_ratio": mode.damping_ratio(),
        "natural_frequency": mode.natural_frequency(),
        "period": mode.period(),
        "time_to_half": mode.time_to_half(),
        "time_to_double": mode.time_to_double(),
        "stability": word(mode.stability),
        "participation": mode.participation,
    })
}

fn word(stability: DynamicStability) -> &'static str {
    match stability {
        DynamicStability::Stable => "stable",
        DynamicStability::Neutral => "neutral",
        DynamicStability::Unstable => "unstable",
    }
}
