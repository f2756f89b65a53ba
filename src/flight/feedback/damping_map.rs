//! What the gain of a rate and the time constant of its washout make of the damping: a map over both.

use nalgebra::Complex;

use super::closed_model::ClosedModel;
use super::law::{Law, RATE};
use super::loop_analysis::analyse_loop;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::modes::mode::Mode;
use crate::flight::verdicts::handling_qualities::Level;
use crate::flight::verdicts::overall_level::overall_level;
use crate::flight::verdicts::task::Task;

/// Washouts of a map \[s\], from and to; a longer one is as good as none.
pub const WASHOUTS: (f64, f64) = (0.1, 20.0);

/// Place of no washout, one step of a factor of two beyond the longest.
const NO_WASHOUT: f64 = 1.602;

/// How many intervals the gains and the washouts of a map are divided into.
pub type Fineness = (usize, usize);

/// Damping over gain and washout, all else as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct DampingMap {
    /// Gains, from zero on.
    pub gains: Vec<f64>,
    /// [Places](place_of) of the washouts, the shortest first and none last.
    pub places: Vec<f64>,
    /// Damping ratio of the oscillation that is damped least, 1 where nothing oscillates; of each washout, of each gain.
    pub damping: Vec<Vec<f64>>,
    /// The level of the plane, likewise, of as many washouts as have been [judged](Self::judge); `None` where it can't be told.
    pub levels: Vec<Vec<Option<Level>>>,
}

/// A segment of a line on a map: (gain, place) of its ends.
pub type Segment = [(f64, f64); 2];

/// Where a washout \[s\] is on a map: the logarithm to base ten of its time constant, with none at all as the longest.
pub fn place_of(washout: f64) -> f64 {
    if washout > 0.0 { washout.clamp(WASHOUTS.0, WASHOUTS.1).log10() } else { NO_WASHOUT }
}

/// The washout \[s\] at a place, zero for none.
pub fn washout_at(place: f64) -> f64 {
    let longest = WASHOUTS.1.log10();
    if place > 0.5 * (longest + NO_WASHOUT) {
        0.0
    } else {
        10_f64.powf(place.clamp(WASHOUTS.0.log10(), longest))
    }
}

/// The law with another gain of the rate to an input, and another washout.
pub fn law_with(law: &Law, model: &PlaneModel, input: usize, gain: f64, washout: f64) -> Law {
    let mut law = *law;
    let of_plane = &mut law.planes[model.plane];
    of_plane.washout = washout;
    if input == 0 {
        of_plane.to_first[RATE] = gain
    } else {
        of_plane.to_second[RATE] = gain
    }
    law
}

/// Damping ratio of the oscillation that a law damps least, 1 where nothing oscillates; `None` where there are no roots.
pub fn least_damping(model: &PlaneModel, law: &Law) -> Option<f64> {
    Some(damping_of(eigenvalues(&ClosedModel::new(model, law).ok()?.a).ok()?.as_slice()))
}

fn damping_of(roots: &[Complex<f64>]) -> f64 {
    let oscillations = roots.iter().filter(|root| root.im > 0.0);
    oscillations.map(|root| -root.re / root.norm()).fold(1.0, f64::min)
}

/// A real root grows above this fraction of the largest, as a mode does.
const NEUTRAL: f64 = 1e-9;

/// Of the gains from `low` to `high`, zero among them, the one whose least damping is greatest with a washout, and that damping; `None`
/// where there are no roots. A gain with which more roots grow without oscillating than without it is no better one.
pub fn best_gain(
    model: &PlaneModel,
    law: &Law,
    input: usize,
    washout: f64,
    [low, high]: [f64; 2],
) -> Option<(f64, f64)> {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    // On either side of zero, closer together near it.
    const LOOKED_AT: i32 = 100;
    let with = |gain: f64| -> Option<(f64, usize)> {
        let law = law_with(law, model, input, gain, washout);
        let roots = eigenvalues(&ClosedModel::new(model, &law).ok()?.a).ok()?;
        let size = roots.iter().map(|root| root.norm()).fold(0.0, f64::max);
        let growing = roots.iter().filter(|root| root.im == 0.0 && root.re > NEUTRAL * size).count();
        Some((damping_of(roots.as_slice()), growing))
    };
    let growing = with(0.0)?.1;
    let of = |gain: f64| with(gain).map(|found| if found.1 > growing { -1.0 } else { found.0 });
    let place = |k: i32| {
        let share = f64::from(k.clamp(-LOOKED_AT, LOOKED_AT)) / f64::from(LOOKED_AT);
        share * share.abs() * if k < 0 { -low } else { high }
    };
    let (mut at, mut best) = (0, (0.0, of(0.0)?));
    for k in -LOOKED_AT..=LOOKED_AT {
        let found = (place(k), of(place(k))?);
        if found.1 > best.1 {
            (at, best) = (k, found);
        }
    }
    // Between its neighbours there is one maximum.
    let (mut low, mut high) = (place(at - 1), place(at + 1));
    for _ in 0..40 {
        let (a, b) = (high - RATIO * (high - low), low + RATIO * (high - low));
        if of(a)? > of(b)? { high = b } else { low = a }
    }
    let middle = 0.5 * (low + high);
    let refined = of(middle)?;
    Some(if refined > best.1 + 1e-9 { (middle, refined) } else { best })
}

impl DampingMap {
    /// The map for gains of the rate to an input from zero to `reach`; `None` where some of it has no roots.
    pub fn of(
        model: &PlaneModel,
        law: &Law,
        (input, reach): (usize, f64),
        (across, upward): Fineness,
    ) -> Option<Self> {
        let (low, high) = (WASHOUTS.0.log10(), WASHOUTS.1.log10());
        let gains: Vec<f64> = (0..=across).map(|k| reach * k as f64 / across as f64).collect();
        let mut places: Vec<f64> =
            (0..=upward).map(|k| low + (high - low) * k as f64 / upward as f64).collect();
        places.push(NO_WASHOUT);
        let mut damping = Vec::with_capacity(places.len());
        for place in &places {
            let laws = gains.iter().map(|gain| law_with(law, model, input, *gain, washout_at(*place)));
            damping.push(laws.map(|law| least_damping(model, &law)).collect::<Option<Vec<f64>>>()?);
        }
        Some(Self { gains, places, damping, levels: Vec::new() })
    }

    /// Judges the laws of one washout more, which takes the names of all modes and so twenty times as long as their roots; whether
    /// there was one to judge.
    pub fn judge(&mut self, model: &PlaneModel, law: &Law, input: usize, task: Task) -> bool {
        let Some(place) = self.places.get(self.levels.len()) else { return false };
        let laws = self.gains.iter().map(|gain| law_with(law, model, input, *gain, washout_at(*place)));
        self.levels.push(laws.map(|law| level_under(model, &law, task)).collect());
        true
    }

    /// The last of the gains.
    pub fn reach(&self) -> f64 {
        self.gains.last().copied().unwrap_or_default()
    }

    /// The line on which the damping ratio has a value, in segments.
    pub fn damped_by(&self, value: f64) -> Vec<Segment> {
        self.line(&|row, column| self.damping[row][column] - value)
    }

    /// The line on one side of which the level is `level` or better, and on the other worse, in segments: it passes between the points
    /// of the map. None until all of it has been judged.
    pub fn bound_of(&self, level: Level) -> Vec<Segment> {
        let is_good = |row: usize, column: usize| self.levels[row][column].is_some_and(|l| l <= level);
        let side = |row, column| if is_good(row, column) { 1.0 } else { -1.0 };
        if self.levels.len() < self.places.len() { Vec::new() } else { self.line(&side) }
    }

    /// Where a height over the points of the map is zero (marching squares; straight between the points).
    fn line(&self, height: &dyn Fn(usize, usize) -> f64) -> Vec<Segment> {
        let mut segments = Vec::new();
        for row in 1..self.places.len() {
            for column in 1..self.gains.len() {
                // Around the square.
                let corners = [(row - 1, column - 1), (row - 1, column), (row, column), (row, column - 1)];
                let heights = corners.map(|(row, column)| height(row, column));
                let mut met = Vec::new();
                for k in 0..4 {
                    let (from, to) = (k, (k + 1) % 4);
                    let (a, b) = (heights[from], heights[to]);
                    if (a < 0.0) != (b < 0.0) {
                        let share = a / (a - b);
                        let at = |of: &dyn Fn((usize, usize)) -> f64| {
                            of(corners[from]) + share * (of(corners[to]) - of(corners[from]))
                        };
                        met.push((at(&|(_, column)| self.gains[column]), at(&|(row, _)| self.places[row])));
                    }
                }
                segments.extend(met.chunks_exact(2).map(|ends| [ends[0], ends[1]]));
            }
        }
        segments
    }
}

/// The level of a plane under a law; `None` where it can't be told.
fn level_under(model: &PlaneModel, law: &Law, task: Task) -> Option<Level> {
    let closed = analyse_loop(model, law, Some(task)).ok()?;
    let modes: Vec<Mode> = closed.modes.into_iter().map(|mode| mode.mode).collect();
    overall_level(std::iter::once((closed.levels.as_slice(), modes.as_slice())))?.level
}
