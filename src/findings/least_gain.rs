//! The least gain with which a plane of motion reaches a level of handling qualities.
//!
//! The gains that do needn't lie together: a little damps, more drives an oscillation of the actuator, and between two good ranges
//! may be a bad one. So the whole range of the slider is looked at first, and then every edge found is refined.

use super::Findings;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::feedback::analyse_loop;
use crate::flight::modes::mode::Mode;
use crate::flight::verdicts::handling_qualities::Level;
use crate::flight::verdicts::overall_level::overall_level;
use crate::scenario::{Page, Parameter, Scenario};

/// Gains looked at on either side of zero, closer together near it: a range between two of them isn't seen.
const LOOKED_AT: i32 = 64;

/// Halvings of the interval in which an edge lies: to the last bit of what a slider tells apart.
const HALVINGS: usize = 40;

/// The gains with which a plane reaches a level, all else as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastGain {
    /// The one nearest to zero, of either sign, SI; zero where none is needed.
    pub gain: f64,
    /// All of the slider's range, as intervals from the lowest up, SI.
    pub ranges: Vec<[f64; 2]>,
}

/// Why no gain reaches a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoLeastGain {
    /// The parameter isn't a gain of this aircraft.
    NotAGain,
    /// There is no class to judge by, or the plane has no analysis.
    NotJudged,
    /// None of the slider does.
    Nowhere {
        /// The best level that any does, and the gain nearest to zero with it; `None` where with all of them
        /// flight has something in it that no requirement judges.
        best: Option<(Level, f64)>,
    },
}

impl Findings {
    /// The gains with which the plane of a gain is at a level or better, with all else as it is.
    pub fn least_gain(&self, parameter: &'static Parameter, wanted: Level) -> Result<LeastGain, NoLeastGain> {
        let scenario = self.scenario();
        let plane = match (parameter.page, parameter.plane) {
            (Some(Page::Feedback), Some(plane)) if parameter.is_gain() && parameter.applies(scenario) => {
                plane
            }
            _ => return Err(NoLeastGain::NotAGain),
        };
        let open =
            self.analysis().as_ref().ok().and_then(|analysis| analysis.planes[plane].as_ref()?.as_ref().ok());
        let open = open.filter(|open| !open.levels.is_empty()).ok_or(NoLeastGain::NotJudged)?;
        let mut moved = scenario.clone();
        let mut level = |gain: f64| level_with(&mut moved, &open.model, parameter, gain);
        let range = parameter.range(scenario);
        let gains: Vec<f64> = (-LOOKED_AT..=LOOKED_AT)
            .map(|k| {
                let share = f64::from(k) / f64::from(LOOKED_AT);
                let end = if k < 0 { -range.start() } else { *range.end() };
                share * share.abs() * end
            })
            .collect();
        let levels: Vec<Option<Level>> = gains.iter().map(|gain| level(*gain)).collect();
        let reaches = |level: Option<Level>| level.is_some_and(|level| level <= wanted);
        let mut ranges: Vec<[f64; 2]> = Vec::new();
        for (k, gain) in gains.iter().enumerate() {
            if !reaches(levels[k]) {
                continue;
            }
            let begins = k == 0 || !reaches(levels[k - 1]);
            if begins {
                let first = if k == 0 { *gain } else { edge(*gain, gains[k - 1], |g| reaches(level(g))) };
                ranges.push([first, *gain]);
            }
            let last = match gains.get(k + 1) {
                Some(next) if !reaches(levels[k + 1]) => edge(*gain, *next, |g| reaches(level(g))),
                Some(_) | None => *gain,
            };
            if let Some(range) = ranges.last_mut() {
                range[1] = last;
            }
        }
        let nearest = |range: &[f64; 2]| 0.0_f64.clamp(range[0], range[1]);
        let least = ranges.iter().map(nearest).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        match least {
            Some(gain) => Ok(LeastGain { gain, ranges }),
            None => {
                let judged = levels.iter().zip(&gains).filter_map(|(level, gain)| Some(((*level)?, *gain)));
                let best = judged.min_by(|(a, x), (b, y)| a.cmp(b).then(x.abs().total_cmp(&y.abs())));
                Err(NoLeastGain::Nowhere { best })
            }
        }
    }
}

/// The level of a plane with a gain; `None` where it can't be told.
fn level_with(
    scenario: &mut Scenario,
    model: &PlaneModel,
    parameter: &Parameter,
    gain: f64,
) -> Option<Level> {
    parameter.set(scenario, gain);
    let closed = analyse_loop(model, &scenario.law, scenario.task).ok()?;
    let modes: Vec<Mode> = closed.modes.into_iter().map(|mode| mode.mode).collect();
    overall_level(std::iter::once((closed.levels.as_slice(), modes.as_slice())))?.level
}

/// The last gain, from one that is good on the way to one that isn't, that still is.
fn edge(mut good: f64, mut bad: f64, mut is_good: impl FnMut(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        if is_good(middle) { good = middle } else { bad = middle }
    }
    good
}
