//! The controls of XFLR5 and flow5: XFLR5 has one set of surfaces without a name, flow5 as many as there are, each by its name.

use super::naming;
use super::review::Field;
use super::sheet::Sheet;
use crate::content::matrix::draft::Problem;
use crate::content::matrix::state_names::{control, plane_of_control};
use crate::flight::aircraft::plane::Plane;
use crate::number::significant;

/// What a set does to the other plane is told from this share of what it does to its own.
const MUCH: f64 = 1e-3;

/// What one set does.
#[derive(Clone, Debug)]
pub(super) struct ControlSet {
    /// Its name in the log; XFLR5 gives none.
    pub name: Option<String>,
    /// Line of its heading.
    pub line: usize,
    /// Rates of u, w, q, θ by the control.
    pub longitudinal: [f64; 4],
    /// Rates of v, p, r, φ.
    pub lateral: [f64; 4],
}

impl ControlSet {
    /// The control that its name means; one without a name is the elevator, unless it rolls or yaws more than it pitches.
    fn control(&self) -> Option<&'static str> {
        match &self.name {
            Some(name) => control(name),
            None => self.by_effect().is_none_or(|key| key == "elevator").then_some("elevator"),
        }
    }

    /// The control that turns the aircraft as this one does; `None` where it does nothing.
    fn by_effect(&self) -> Option<&'static str> {
        let [_, _, pitch, _] = self.longitudinal.map(f64::abs);
        let [_, roll, yaw, _] = self.lateral.map(f64::abs);
        if pitch + roll + yaw == 0.0 {
            None
        } else if pitch >= roll.max(yaw) {
            Some("elevator")
        } else if roll >= yaw {
            Some("aileron")
        } else {
            Some("rudder")
        }
    }
}

/// What each set is: by its name, or as a person says. `None` where a person has to say it yet.
pub(super) fn named(sheet: &mut Sheet, sets: &[ControlSet]) -> Result<Option<Vec<String>>, Problem> {
    if sets.is_empty() {
        return Ok(Some(Vec::new()));
    }
    // One of several without a name says nothing of itself.
    let is_alone = sets.iter().filter(|set| set.name.is_none()).count() < 2;
    let known: Vec<Option<&str>> =
        sets.iter().map(|set| set.control().filter(|_| is_alone || set.name.is_some())).collect();
    let is_told = known.iter().all(Option::is_some);
    let mut names: Vec<String> = Vec::new();
    for (k, (set, known_as)) in sets.iter().zip(&known).enumerate() {
        let likely = set.by_effect().filter(|&key| {
            !known.contains(&Some(key)) && names.iter().all(|before| control(before) != Some(key))
        });
        let own = set.name.as_ref().map(|name| name.replace([',', ';'], " "));
        let name = match known_as {
            Some(key) => own.unwrap_or_else(|| (*key).to_owned()),
            None => likely.map(str::to_owned).or(own).unwrap_or_else(|| format!("set{}", k + 1)),
        };
        names.push(name);
    }
    let told = names.join(", ");
    let of_log: Vec<&str> = sets.iter().filter_map(|set| set.name.as_deref()).collect();
    let meaning = if of_log.is_empty() {
        "what the control is".to_owned()
    } else {
        format!("what the control sets {} are, in this order", of_log.join(", "))
    };
    let reason = "by their names, and else by the axis that each turns the aircraft about most";
    let suggestion = (!is_told).then(|| (told.clone(), reason.to_owned()));
    let field = Field::choice("inputs", &meaning, &[]);
    let Some(text) = sheet.chosen(field, is_told.then_some(told.as_str()), suggestion)? else {
        return Ok(None);
    };
    let names = naming::split(&text);
    if names.len() != sets.len() {
        let line = sets.first().map_or(1, |set| set.line);
        let (expected, found) = (sets.len(), names.len());
        return Err((
            line,
            format!("inputs: expected a name for each of the {expected} control sets, found {found}: {text}"),
        ));
    }
    for (set, name) in sets.iter().zip(&names) {
        say(sheet, set, name);
    }
    Ok(Some(names))
}

/// What was made of a set, and what is left out of it.
fn say(sheet: &mut Sheet, set: &ControlSet, name: &str) {
    let Some(key) = control(name) else { return };
    let what = set.name.as_ref().map_or_else(|| "The control".to_owned(), |name| format!("The set {name}"));
    let whole = if set.name.is_none() { "; a set of several surfaces counts as one" } else { "" };
    sheet.remark(format!("{what} is read as the {key}, in radians{whole}."));
    let largest = |rates: [f64; 4]| rates.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
    let (own, other, plane) = match plane_of_control(key) {
        Plane::Longitudinal => (largest(set.longitudinal), largest(set.lateral), "lateral"),
        Plane::Lateral => (largest(set.lateral), largest(set.longitudinal), "longitudinal"),
    };
    if other > MUCH * own {
        sheet.remark(format!(
            "What it does to the {plane} motion is left out: at most {} beside {}, in the units of B.",
            significant(other, 3),
            significant(own, 3)
        ));
    }
}
