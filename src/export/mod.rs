//! What other programs ask and read. A [`Subject`] is an aircraft as they name it, or a link, and ends at a
//! [`Scene`]: all else answers a request about that, for the command line and JavaScript alike.
//! SI and radians, and every number finite or null.

mod aircraft;
mod approximation;
mod class_answers;
mod closed_loop;
mod disturbance;
mod document;
mod error;
mod event;
mod figure;
mod flown;
mod frequency;
pub mod json;
mod lesson_report;
mod level;
mod link;
mod list;
mod measures;
mod message;
mod metrics;
mod mode;
mod page;
mod plane;
mod report;
mod respond;
mod scene;
mod script;
mod signal;
mod split;
mod subject;
mod sweep;
mod take_along;
#[cfg(test)]
mod typescript;
mod why;

use serde_json::{Map, Value, json};

use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::{Motion, PlaneAnalysis};
use crate::flight::modes::mode::Mode;
use crate::flight::{Analysis, AnalysisError};
use crate::key::Keyed;
use crate::scenario::parameters;
use crate::words;

pub use aircraft::AircraftReport;
pub use approximation::{ApproximationReport, ValueReport};
pub use class_answers::{ClassSource, class_answers};
pub use closed_loop::{LeastGainReport, LoopModeReport, LoopMotion, LoopOutcome, LoopReport, MarginsReport};
pub use error::ExportError;
pub use event::{Event, Spot};
pub use flown::{FlightOutcome, FlightReport, LimitReport, StopReport};
pub use frequency::{
    FREQUENCIES, FrequencyReport, FrequencyRequest, GainPeak, Measured, TransferReport, frequency, gain_unit,
};
pub use lesson_report::ReportSource;
pub use level::{JudgedReport, LevelReport, OverallLevelReport};
pub use link::{DisturbanceRequest, LinkReport, link_to};
pub use list::{ParameterReport, list, parameters_of};
pub use measures::{MeasureReport, MeasureValue, measures_of};
pub use message::{Message, Request};
pub use metrics::{MetricsReport, OutputMetricsReport, PeakReport};
pub use mode::ModeReport;
pub use plane::{PlaneReport, StaticReport, StiffnessReport, TrimReport, WholeReport};
pub use report::{PlaneOutcome, Report, Units, analyse};
pub use respond::{ResponseReport, ResponseRequest, respond};
pub use scene::Scene;
pub use signal::Signal;
pub use split::{PartReport, SplitOutcome, SplitReport};
pub use subject::{Source, Subject};
pub use sweep::{
    MOST_POINTS, Sweep, SweepChange, SweepMode, SweepPlane, SweepPoint, SweepReport, SweepRequest,
};
pub use take_along::{TakenAlong, Target, take_along};
pub use why::{CauseReport, MovedReport, ShiftReport, WhyMode, WhyPlane, WhyReport, why};

/// The scenario and its analysis, SI and radians; an analysis that failed is a sentence.
pub fn state(findings: &Findings) -> Value {
    let scenario = findings.scenario();
    let parameters: Map<String, Value> = parameters()
        .filter(|p| p.applies(scenario))
        .map(|p| (p.key.to_owned(), json!(p.get(scenario))))
        .collect();
    let choice = &scenario.disturbance.choices[scenario.plane];
    json!({
        "aircraft": scenario.aircraft.key,
        "plane": scenario.plane.key(),
        "disturbance": words::disturbance::choice(choice),
        "disturbance_key": choice.source.key(),
        "shape_key": choice.shape().map(Keyed::key),
        "parameters": parameters,
        "analysis": match findings.analysis() {
            Ok(analysis) => of_analysis(analysis),
            Err(error) => of_error(error),
        },
    })
}

fn of_analysis(analysis: &Analysis) -> Value {
    let of = |plane: Plane| match analysis.planes[plane].as_ref()? {
        Ok(plane) => Some(of_plane(plane)),
        Err(error) => Some(of_error(error)),
    };
    json!({
        "longitudinal": of(Plane::Longitudinal),
        "lateral": of(Plane::Lateral),
        "static_margin": analysis.margins.map(|margins| margins.static_margin),
        "manoeuvre_margin": analysis.margins.map(|margins| margins.manoeuvre_margin),
        "overall_level": analysis.overall_level().map(|overall| words::verdict::overall(&overall)),
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
        "dynamic_stability": plane.dynamic_stability.key(),
        "static_stability": plane.static_stability.verdict.key(),
        "determinant": plane.static_stability.determinant,
        "levels": plane.levels.iter().map(words::verdict::sentence).collect::<Vec<_>>(),
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
        "key": mode.naming.name.key(),
        "name": words::mode::title(mode.naming.name),
        "reason": words::naming::reason(mode),
        "re": mode.lambda.re,
        "im": mode.lambda.im,
        "damping_ratio": mode.damping_ratio(),
        "natural_frequency": mode.natural_frequency(),
        "period": mode.period(),
        "time_to_half": mode.time_to_half(),
        "time_to_double": mode.time_to_double(),
        "stability": mode.stability.key(),
        "participation": mode.participation,
    })
}
