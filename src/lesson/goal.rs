//! A goal on a scene: what each condition measures, what it wants, and whether it is met.

use std::sync::Arc;

use super::given::Given;
use super::moves::moves;
use super::task::{Amount, Condition, Task, Wanted};
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::findings::measures::{Absence, Reading};
use crate::scenario::{Parameter, Scenario};

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

/// Why a scene doesn't count, whatever is measured there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// It is of another aircraft than the start.
    OtherAircraft,
    /// Its levels are judged for another class or category than at the start.
    OtherTask,
    /// These were moved and aren't offered.
    NotOffered(Vec<&'static str>),
    /// More sliders differ from the start than may.
    TooMany {
        /// How many differ.
        found: usize,
        /// How many may.
        most: usize,
    },
}

impl Task {
    /// Whether the scene counts and every condition is met.
    pub fn is_met(&self, start: &Findings, now: &Findings, aircraft: &[Arc<Aircraft>]) -> bool {
        self.unfit(start, now).is_none()
            && progress(self, start, now, aircraft).iter().all(|progress| progress.met)
    }

    /// Whether its points are earned by what was given: the goal is reached, without its solution, and without a hint where
    /// that counts.
    pub const fn is_earned(&self, given: &Given) -> bool {
        given.is_unaided() && !(self.unaided && given.hints > 0)
    }

    /// Why a scene doesn't count for it. The disturbance may be another: it tells what the aircraft does, and doesn't change it.
    pub fn unfit(&self, start: &Findings, now: &Findings) -> Option<Unfit> {
        let (start, now) = (start.scenario(), now.scenario());
        if !is_same(&now.aircraft, &start.aircraft) {
            return Some(Unfit::OtherAircraft);
        }
        if now.task != start.task {
            return Some(Unfit::OtherTask);
        }
        let moved = moves(start, now);
        let is_offered = |parameter: &Parameter| {
            self.offer.is_empty() || parameter.is_of_disturbance() || self.offer.contains(&parameter)
        };
        let strangers: Vec<&str> = moved
            .iter()
            .map(|step| step.parameter)
            .filter(|parameter| !is_offered(parameter))
            .map(|parameter| parameter.key)
            .collect();
        if !strangers.is_empty() {
            return Some(Unfit::NotOffered(strangers));
        }
        let found = moved.len();
        self.changes.filter(|most| found > *most).map(|most| Unfit::TooMany { found, most })
    }
}

/// Whether two aircraft are the same in all that is computed or judged from them; a file can bear the key of another.
fn is_same(aircraft: &Arc<Aircraft>, other: &Arc<Aircraft>) -> bool {
    Arc::ptr_eq(aircraft, other)
        || aircraft.key == other.key
            && aircraft.aircraft_model == other.aircraft_model
            && aircraft.baseline == other.baseline
            && aircraft.particulars == other.particulars
            && aircraft.limits == other.limits
            && aircraft.task == other.task
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
