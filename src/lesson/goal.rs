//! A goal on a scene: what each condition measures, what it wants, and whether it is met.

use std::sync::Arc;

use super::moves::moves;
use super::task::{Amount, Condition, Task, Wanted};
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::findings::measures::{Absence, Reading};
use crate::scenario::Scenario;

/// How near a condition is.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// What is read now.
    pub now: Result<Reading, Absence>,
    /// What was read at the start.
    pub start: Result<Reading, Absence>,
    /// The least and the greatest number \[SI\] that meet it, for a condition on a number.
    pub wanted: Option<(f64, f64)>,
    /// Whether it is met.
    pub met: bool,
    /// How much of the way from the start is done, 0 to 1; 1 where it is met.
    pub share: f64,
}

/// The progress of each condition of a task from its start.
pub fn progress(task: &Task, start: &Findings, now: &Findings, aircraft: &[Arc<Aircraft>]) -> Vec<Progress> {
    task.until.iter().map(|condition| condition.progress(start, now, aircraft)).collect()
}

impl Task {
    /// Whether every condition is met, by no more changes than are allowed.
    pub fn is_met(&self, start: &Findings, now: &Findings, aircraft: &[Arc<Aircraft>]) -> bool {
        let changed = changes(start.scenario(), now.scenario());
        self.changes.is_none_or(|most| changed.len() <= most)
            && progress(self, start, now, aircraft).iter().all(|progress| progress.met)
    }
}

/// Keys of the parameters that were themselves moved.
pub(super) fn changes(start: &Scenario, now: &Scenario) -> Vec<&'static str> {
    moves(start, now).into_iter().map(|step| step.parameter.key).collect()
}

impl Condition {
    fn progress(&self, start: &Findings, now: &Findings, aircraft: &[Arc<Aircraft>]) -> Progress {
        let (now, start) = (self.measure.read(now), self.measure.read(start));
        let wanted = self.wanted_range(&start, aircraft);
        let met = match (&self.wanted, &now) {
            (Wanted::Absent, now) => now.is_err(),
            (Wanted::Stability(wanted), Ok(Reading::Stability(found))) => wanted == found,
            (Wanted::Level(wanted), Ok(Reading::Level(found))) => found <= wanted,
            (_, Ok(Reading::Number(number))) => {
                wanted.is_some_and(|(low, high)| (low..=high).contains(number))
            }
            _ => false,
        };
        let share = match (met, wanted, number(&start), number(&now)) {
            (true, ..) => 1.0,
            (false, Some(wanted), Some(start), Some(now)) => {
                let (before, left) = (distance(start, wanted), distance(now, wanted));
                if before > 0.0 { (1.0 - left / before).clamp(0.0, 1.0) } else { 0.0 }
            }
            _ => 0.0,
        };
        Progress { now, start, wanted, met, share }
    }

    fn wanted_range(
        &self,
        start: &Result<Reading, Absence>,
        aircraft: &[Arc<Aircraft>],
    ) -> Option<(f64, f64)> {
        let value = |amount: Amount| match amount {
            Amount::Number(number) => Some(number),
            Amount::TimesStart(times) => Some(times * number(start)?),
        };
        let around = |centre: f64, share: f64| (centre - share * centre.abs(), centre + share * centre.abs());
        match &self.wanted {
            Wanted::AtLeast(amount) => Some((value(*amount)?, f64::INFINITY)),
            Wanted::AtMost(amount) => Some((f64::NEG_INFINITY, value(*amount)?)),
            Wanted::Within(share, amount) => Some(around(value(*amount)?, *share)),
            Wanted::SameAs(share, scene) => {
                let there = Findings::of(scene.open(aircraft)?.scenario);
                Some(around(number(&self.measure.read(&there))?, *share))
            }
            Wanted::Stability(_) | Wanted::Level(_) | Wanted::Absent => None,
        }
    }
}

fn number(reading: &Result<Reading, Absence>) -> Option<f64> {
    match reading {
        Ok(Reading::Number(number)) => Some(*number),
        Ok(Reading::Stability(_) | Reading::Level(_)) | Err(_) => None,
    }
}

/// How far a number is from a range.
fn distance(number: f64, (low, high): (f64, f64)) -> f64 {
    (low - number).max(number - high).max(0.0)
}
