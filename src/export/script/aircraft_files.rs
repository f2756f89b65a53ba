//! The aircraft itself, to be opened again: as an aircraft file, and as bare matrices.

use serde_json::{Value, json};

use crate::content::lines_with_key;
use crate::export::error::ExportError;
use crate::export::plane::PlaneReport;
use crate::export::scene::Scene;
use crate::scenario::link;

/// The key of what was changed.
const EDITS: &str = "edits";

/// The aircraft's own file, with what was changed on it in a line `edits`, in the words and units of links. Opened again it is the
/// same aircraft, to the last bit.
pub fn toml(scene: &Scene) -> Result<String, ExportError> {
    let Some(text) = &scene.file else {
        let key = &scene.scenario.aircraft.key;
        let problem =
            format!("{key} is given by bare matrices, which have no aircraft file; \"json\" writes them");
        return Err(ExportError::Request(problem));
    };
    let edits = link::edits(&scene.scenario);
    let kept: String =
        lines_with_key(text, EDITS).filter(|(_, is_edits)| !is_edits).map(|(line, _)| line).collect();
    // The words of a link have no sign that a text in quotes would mind.
    Ok(if edits.is_empty() { kept } else { format!("{EDITS} = \"{edits}\"\n{kept}") })
}

/// The plane on screen as bare matrices, in the form of docs/MATRICES.md, with all states of its source.
pub fn matrices(scene: &Scene, plane: &PlaneReport) -> Value {
    let (states, a, b) = match &plane.whole {
        Some(whole) => (json!(whole.states), json!(whole.a), json!(whole.b)),
        None => (json!(plane.states), json!(plane.a), json!(plane.b)),
    };
    json!({
        "name": format!("{}: {}", scene.scenario.aircraft.name, scene.scenario.aircraft.condition),
        "units": "SI",
        "angles": "rad",
        "speed": plane.trim.speed,
        "alpha0_deg": plane.trim.alpha0.to_degrees(),
        "gamma0_deg": plane.trim.gamma0.to_degrees(),
        "states": states,
        "inputs": plane.inputs,
        "A": a,
        "B": b,
    })
}
