//! A number in the text: `= phugoid.period`, measured at the step's scene or, `= phugoid.period at #v=1&…`, at another.

use std::sync::Arc;

use super::scene::Scene;
use crate::content::{Aircraft, ContentError};
use crate::findings::Findings;
use crate::findings::measures::{Absence, Measure};
use crate::key::nearest;
use crate::words;

/// A number in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// What is measured.
    pub measure: Measure,
    /// Where, if not at the step's scene.
    pub at: Option<Scene>,
    /// Line of the file, counted from 1.
    pub line: usize,
}

impl Number {
    /// Reads what follows the sign of equality.
    pub(super) fn read(file: &str, line: usize, text: &str) -> Result<Self, ContentError> {
        let (key, at) = match text.split_once(" at ") {
            Some((key, link)) => (key.trim(), Some(Scene { link: link.trim().to_owned(), line })),
            None => (text.trim(), None),
        };
        let measure =
            measure(key).map_err(|problem| ContentError { file: file.to_owned(), line, problem })?;
        Ok(Self { measure, at, line })
    }

    /// What it reads with its unit, in words. `findings` are those of the step's scene; `None` where the link of its own scene
    /// leads nowhere.
    pub fn value(&self, findings: &Findings, aircraft: &[Arc<Aircraft>]) -> Option<Result<String, Absence>> {
        let elsewhere = match &self.at {
            Some(scene) => {
                let scenario = scene.open(aircraft)?.scenario;
                Some(Findings::of(scenario.shown_as(findings.scenario())))
            }
            None => None,
        };
        let findings = elsewhere.as_ref().unwrap_or(findings);
        let convention = findings.scenario().convention();
        let reading = self.measure.read(findings);
        Some(reading.map(|reading| words::measure::reading(self.measure, reading, convention)))
    }
}

/// The measure by its key, or a sentence with the key most like it.
pub(super) fn measure(key: &str) -> Result<Measure, String> {
    Measure::find(key).ok_or_else(|| {
        let keys: Vec<String> = Measure::all().map(Measure::key).collect();
        unknown("measure", key, keys.iter().map(String::as_str))
    })
}

/// "there is no measure "x"; did you mean "y"?"
pub(super) fn unknown<'n>(kind: &str, key: &str, names: impl Iterator<Item = &'n str>) -> String {
    let nearest =
        nearest(key, names).map_or_else(String::new, |nearest| format!("; did you mean \"{nearest}\"?"));
    format!("there is no {kind} \"{key}\"{nearest}")
}
