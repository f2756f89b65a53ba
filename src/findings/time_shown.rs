//! The time shown: as long as the slowest mode that the disturbance makes visible takes to be seen.

use super::Findings;
use crate::few;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::feedback::loop_response::respond_closed;
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

/// Times that are shown, up to powers of ten \[s\]: far apart, so that the time hardly ever changes while a slider moves.
const TIMES: [f64; 7] = [1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0];

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

/// The one of [`TIMES`] with a power of ten that is nearest by its ratio to a time \[s\], which must be positive.
fn nearest(wanted: f64) -> f64 {
    let decade = 10_f64.powf(wanted.log10().floor());
    let distance = |step: &f64| (step * decade / wanted).ln().abs();
    TIMES.into_iter().min_by(|x, y| distance(x).total_cmp(&distance(y))).map_or(wanted, |step| step * decade)
}

/// Seconds of motion a second in which a mode flown alone can be watched: a turn takes four seconds, and what doesn't turn six.
pub fn watched_at(mode: &Mode) -> f64 {
    mode.period().map_or_else(|| seen_in(mode) / 6.0, |period| period / 4.0)
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
    /// The time to be shown \[s\]: where it is to follow, that of the slowest mode that is seen, whatever was shown before; and
    /// where nothing says how long to look, as it is.
    pub fn time_shown(&self) -> f64 {
        let disturbance = &self.scenario.disturbance;
        match self.time_to_see().filter(|_| disturbance.follows) {
            Some(wanted) => {
                let time = nearest(wanted);
                // The disturbance is seen to its end.
                if time < self.end_of_disturbance() { round_up(wanted) } else { time }
            }
            None => disturbance.sizes.time,
        }
    }

    /// When the disturbance is over \[s\]; zero where it never is.
    fn end_of_disturbance(&self) -> f64 {
        let Scenario { plane, disturbance, .. } = &self.scenario;
        disturbance.input(*plane).and_then(|(_, input)| input.edges().last()).unwrap_or(0.0)
    }

    /// Time in which the slowest visible mode is seen, and the disturbance to its end \[s\]; `None` where nothing is visible.
    pub fn time_to_see(&self) -> Option<f64> {
        *self.time_to_see.get_or_init(|| {
            let Scenario { plane, disturbance, .. } = &self.scenario;
            let modes = &self.flown()?.modes;
            let choice = &disturbance.choices[*plane];
            if choice.source == Source::OneMode {
                return modes.get(choice.mode).or(modes.last()).map(seen_in);
            }
            let mut lengths: Vec<(usize, f64)> = modes.iter().map(length).enumerate().collect();
            few::sort_by(&mut lengths, |(_, a), (_, b)| b.total_cmp(a));
            // Turbulence has something for every mode.
            let all = choice.source == Source::Turbulence;
            let seen = |&(i, length): &(usize, f64)| all || self.shows(i, length);
            let (_, slowest) = lengths.into_iter().find(seen)?;
            Some(slowest.max(self.end_of_disturbance() + LENGTHS.0).min(LONGEST))
        })
    }

    /// Whether a mode is visible in the motion of so much time \[s\]; all are where they can't be told apart.
    fn shows(&self, index: usize, duration: f64) -> bool {
        let Some(PlaneAnalysis { model, modes, .. }) = self.plane() else { return false };
        let Experiment { inputs, start, .. } = self.scenario.experiment();
        let forced = forced(&self.scenario.edited, model, &inputs, start, modes);
        let grid = TimeGrid { duration, steps: STEPS };
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if let Some(closed) = self.law_flown() {
            let (from, _) = closed.start(&forced, start);
            let response = respond_closed(&closed.closed, &forced, &from, grid);
            return closed.modes.get(index).is_some_and(|mode| mode.shows(&response, VISIBLE));
        }
        let response = respond(&forced, grid);
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
