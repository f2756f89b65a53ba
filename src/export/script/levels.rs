//! The levels of handling qualities, keyed by the paragraphs of MIL-F-8785C.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::export::error::ExportError;
use crate::export::level::{LevelReport, OverallLevelReport};
use crate::findings::Findings;
use crate::key::Keyed as _;

/// Every verdict of both planes under its paragraph, and the level as a whole.
pub fn levels(findings: &Findings) -> Result<Value, ExportError> {
    let analysis = findings.analysis().as_ref().map_err(Clone::clone)?;
    let Some(task) = findings.scenario().task else {
        let key = &findings.scenario().aircraft.key;
        let problem =
            format!("{key} has no class of aircraft and category of flight phase that levels are judged for");
        return Err(ExportError::Request(problem));
    };
    let mut paragraphs: BTreeMap<&str, Vec<LevelReport>> = BTreeMap::new();
    for plane in analysis.planes.iter().flatten().flatten() {
        for verdict in &plane.levels {
            let report = LevelReport::of(verdict);
            paragraphs.entry(report.paragraph).or_default().push(report);
        }
    }
    Ok(json!({
        "aircraft": findings.scenario().aircraft.key,
        "specification": "MIL-F-8785C",
        "class": task.class.key(),
        "category": task.category.key(),
        "overall": analysis.overall_level().map(|overall| OverallLevelReport::of(&overall)),
        "paragraphs": paragraphs,
    }))
}
