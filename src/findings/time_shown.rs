//! The time shown: as long as the slowest mode that the disturbance makes visible takes to be seen.

use super::Findings;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::experiment::{Experiment, forced};
use crate::flight::motion::modal_decomposition::modal_decomposition;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::{TimeGrid, respond};
use crate::number::round_up;
use crate::scenario::{Scenario, Source};

/// A mode is visible whose part reaches this share of the whole in one of the states: a dozen points of a small plot.
const VISIBLE: f64 = 0.1;

/// Steps in which the motion is looked at: eighty a period of the mode in question.
const STEPS: usize = 240;

/// Periods of an oscillation that are wanted.
const PERIODS: f64 = 2.5;

/// A mode that doesn't oscillate is seen in a minute \[s\]: it has no more to show than which way it goes, and the fast modes
/// beside it would be lost in its time.
const SLOPE: f64 = 60.0;

/// The time shown stays as it is while it is within these shares of the time that is wanted: they are far apart, so that it
/// hardly ever changes while a slider moves. A time that has just been rounded up lies well between them.
const CALM: (f64, f64) = (0.66, 1.6);

/// Shortest and longest time that a mode is given \[s\].
const LENGTHS: (f64, f64) = (2.0, 240.0);

/// Longest time that can be shown \[s\].
const LONGEST: f64 = 300.0;

/// A round time in which a mode flown alone is seen \[s\]: three periods, or most of its dying away or growing.
pub fn seen_in(mode: &Mode) -> f64 {
    let periods = mode.period().map_or(0.0, |period| 3.0 * period);
    let halves = halves(mode);
    let wanted = if periods > 0.0 { periods.max(halves.min(2.0 * periods)) } else { halves };
    round_up(wanted.clamp(LENGTHS.0, LENGTHS.1))
}

/// Time in which a mode dies away to three per cent or grows as much \[s\]; five minutes where it does neither.
fn halves(mode: &Mode) -> f64 {
    5.0 * mode.time_to_half().or(mode.time_to_double()).unwrap_or(60.0)
}

/// Time that a mode is given beside others \[s\].
fn length(mode: &Mode) -> f64 {
    let wanted = mode.period().map_or_else(|| halves(mode).min(SLOPE), |period| PERIODS * period);
    wanted.clamp(LENGTHS.0, LENGTHS.1)
}

impl Findings {
    /// The time to be shown \[s\]: where it is to follow, that of the slowest mode that is seen, unless it is near that already.
    pub fn time_shown(&self) -> f64 {
        let disturbance = &self.scenario.disturbance;
        let time = disturbance.sizes.time;
        match self.time_to_see().filter(|_| disturbance.follows) {
            Some(wanted) if !(CALM.0 * wanted..=CALM.1 * wanted).contains(&time) => round_up(wanted),
            _ => time,
        }
    }

    /// Time in which the slowest visible mode is seen, and the disturbance to its end \[s\]; `None` where nothing is visible.
    pub fn time_to_see(&self) -> Option<f64> {
        *self.time_to_see.get_or_init(|| {
            let Scenario { plane, disturbance, .. } = &self.scenario;
            let modes = &self.plane()?.modes;
            let choice = &disturbance.choices[*plane];
            if choice.source == Source::OneMode {
                return modes.get(choice.mode).or(modes.last()).map(seen_in);
            }
            let mut lengths: Vec<(usize, f64)> = modes.iter().map(length).enumerate().collect();
            lengths.sort_by(|(_, a), (_, b)| b.total_cmp(a));
            // Turbulence has something for every mode.
            let all = choice.source == Source::Turbulence;
            let seen = |&(i, length): &(usize, f64)| all || self.shows(i, length);
            let (_, slowest) = lengths.into_iter().find(seen)?;
            let end = disturbance.input(*plane).and_then(|(_, input)| input.edges().last()).unwrap_or(0.0);
            Some(slowest.max(end + LENGTHS.0).min(LONGEST))
        })
    }

    /// Whether a mode is visible in the motion of so much time \[s\]; all are where they can't be told apart.
    fn shows(&self, index: usize, duration: f64) -> bool {
        let Some(PlaneAnalysis { model, modes, .. }) = self.plane() else { return false };
        let Experiment { inputs, start, .. } = self.scenario.experiment();
        let forced = forced(&self.scenario.edited, model, &inputs, start, modes);
        let response = respond(&forced, TimeGrid { duration, steps: STEPS });
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        Output::of(self.scenario.plane).iter().take(4).any(|output| {
            let row = output.row(model, &forced);
            let whole = largest(&row.of(&forced, &response).collect::<Vec<f64>>());
            match modal_decomposition(modes, &row, &forced, &response) {
                Ok(sum) => whole > 0.0 && largest(&sum.parts[index]) >= VISIBLE * whole,
                Err(_) => whole > 0.0,
            }
        })
    }
}
