//! What other programs read: the state of the page as JSON.

use serde_json::{Map, Value, json};

use crate::flight::modes::{DynamicStability, Mode};
use crate::flight::static_stability::StaticVerdict;
use crate::flight::{Analysis, AnalysisError};
use crate::scenario::{PARAMETERS, Scenario};

/// What is studied and what follows from it, SI and radians; an analysis that failed is a sentence.
pub fn state(scenario: &Scenario, analysis: &Result<Analysis, AnalysisError>) -> Value {
    let parameters: Map<String, Value> =
        PARAMETERS.iter().map(|p| (p.key.to_owned(), json!(p.get(scenario)))).collect();
    let analysis = match analysis {
        Ok(analysis) => of_analysis(analysis),
        Err(error) => json!({ "error": error.to_string() }),
    };
    json!({
        "aircraft": scenario.aircraft.key,
        "disturbance": scenario.disturbance.kind.text(),
        "parameters": parameters,
        "analysis": analysis,
    })
}

fn of_analysis(analysis: &Analysis) -> Value {
    json!({
        "modes": analysis.modes.iter().map(of_mode).collect::<Vec<_>>(),
        "dynamic_stability": word(analysis.dynamic_stability),
        "static_stability": match analysis.static_stability.verdict {
            StaticVerdict::Stable => "stable",
            StaticVerdict::Neutral => "neutral",
            StaticVerdict::Unstable => "unstable",
        },
        "determinant": analysis.static_stability.determinant,
        "gravity_is_plausible": analysis.gravity.is_plausible(),
        "response": {
            "dt": analysis.response.dt,
            "samples": analysis.response.states.len(),
            "last": analysis.response.states.last().map(|x| [x[0], x[1], x[2], x[3]]),
        },
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
