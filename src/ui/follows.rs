//! What follows from a slider, in words for a screen reader: the mode that it moves most, and the verdict.

use super::curtain::Curtain;
use crate::findings::{Findings, RowSensitivity};
use crate::scenario::Hidden;
use crate::words;

/// What follows from the value of a parameter with these sensitivities, as far as nothing of it is hidden.
pub fn follows(findings: &Findings, curtain: &Curtain, row: Option<&RowSensitivity>) -> Option<String> {
    let (plane, modes) = (findings.flown()?, findings.flown_modes());
    let row = row.filter(|_| !curtain.hides_influence());
    let mut most = (None, 0.0);
    for (index, strength) in row.map_or(&[][..], |row| &row.strengths).iter().enumerate() {
        if let Some(strength) = strength.filter(|strength| *strength > most.1) {
            most = (Some(index), strength);
        }
    }
    let index = most.0.or_else(|| curtain.order(modes).first().copied())?;
    let mode = modes.get(index)?;
    let numbers = (!curtain.hides(Hidden::Numbers))
        .then(|| format!("{} {}", curtain.title(mode.naming.name), words::pole_map::aloud(mode)));
    let verdict =
        (!curtain.hides(Hidden::Verdicts)).then(|| words::stability::dynamic_alone(plane).to_owned());
    let said: Vec<String> = numbers.into_iter().chain(verdict).collect();
    (!said.is_empty()).then(|| said.join(", "))
}
