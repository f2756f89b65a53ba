//! The numbers a course asks of a response: how fast, how far over, where to, and what the pilot feels.
//!
//! All are read off the exact motion (see [`super::course`]), so that neither the samples on screen nor the time shown changes them.

use super::course::{Course, Reading};
use super::modal_decomposition::{Reading as ModeReading, WORST_SPLIT};
use super::outputs::{Output, OutputRow};
use super::response::{DrivenSystem, steady_state};
use super::small_disturbance::is_small;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::aircraft::states::Longitudinal;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;

/// Within this fraction of the steady value a response counts as settled.
pub const SETTLED: f64 = 0.02;

/// An overshoot smaller than this fraction of the steady value is none.
const OVERSHOT: f64 = 1e-4;

/// Between nodes a turning value is at most this much larger than the node: 25 nodes a period leave out 0.8 %.
const BESIDE: f64 = 0.97;

/// Metrics of an output's answer to a step, of the whole motion, however much of it is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepMetrics {
    /// Value that the output goes to, in its unit.
    pub steady: f64,
    /// Time from 10 % to 90 % of the steady value, both for the first time \[s\].
    pub rise_time: Option<f64>,
    /// Time after the step from which it stays within [`SETTLED`] of the steady value for ever \[s\].
    pub settling_time: f64,
    /// How far it goes beyond the steady value, as a fraction of it: zero if it never does.
    pub overshoot: f64,
}

/// Metrics of an output after a step at `start` that leads to `steady`; `modes` are those of the model.
///
/// `None` where the steady value is too small beside the motion to measure by (a thousandth of the peak), where the motion is no
/// small disturbance all the way, or takes too long to settle to be followed.
pub fn step_metrics(
    model: &PlaneModel,
    modes: &[Mode],
    forced: &DrivenSystem,
    row: &OutputRow,
    start: f64,
    steady: f64,
) -> Option<StepMetrics> {
    let column = &forced.forcings.first()?.column;
    let amplitude = forced.forcings.first()?.input.at(start);
    let end_state = steady_state(&forced.a, column)? * amplitude;
    let at_step = Course::new(model, forced, modes, start).last_state();
    // The envelope of the modes' parts in what is left to go: Σ aᵢ e^{σᵢt}
    let left = at_step - end_state;
    let parts: Vec<(f64, f64)> = modes
        .iter()
        .map(|mode| (ModeReading::new(mode, row, forced).envelope(&left), mode.lambda.re))
        .collect();
    let envelope = |t: f64| parts.iter().map(|(size, sigma)| size * (sigma * t).exp()).sum::<f64>();
    let within = |share: f64| {
        let after = falls_to(envelope, share * steady.abs())?;
        let course = Course::new(model, forced, modes, start + after.max(f64::MIN_POSITIVE));
        (course.small_until.is_none() && !course.is_cut).then_some(course)
    };
    // To where nothing can leave the band, or come to be an overshoot, any more.
    let course = within(SETTLED)?;
    let overshoot = overshoot(&course, row, steady);
    let longer = if overshoot < SETTLED { Some(within(overshoot.max(OVERSHOT))?) } else { None };
    let course = longer.unwrap_or(course);
    let readings = course.readings(row);
    let (_, most) = peak(&course, row)?;
    if !(steady.is_finite() && steady.abs() > 1e-3 * most.abs() && steady != 0.0) {
        return None;
    }
    let reached = |share: f64| first_beyond(&course, row, &readings, |value| value / steady - share);
    Some(StepMetrics {
        steady,
        rise_time: reached(0.9).and_then(|high| Some(high - reached(0.1)?)),
        settling_time: (settled_from(&course, row, readings.last()?, steady) - start).max(0.0),
        overshoot: self::overshoot(&course, row, steady),
    })
}

/// A time at which a falling function is down to a level, at most half as long again as the first; zero if it is at once, `None` if it
/// doesn't come there in 10⁷ s.
fn falls_to(size: impl Fn(f64) -> f64, level: f64) -> Option<f64> {
    // NaN never is.
    let is_down = |t: f64| size(t) <= level;
    if is_down(0.0) {
        return Some(0.0);
    }
    let mut high = 1e-3;
    while !is_down(high) {
        high *= 1.5;
        if high > 1e7 {
            return None;
        }
    }
    Some(high)
}

/// How far an output goes beyond its steady value, as a fraction of it; zero where it is less than can be told.
fn overshoot(course: &Course<'_>, row: &OutputRow, steady: f64) -> f64 {
    let beyond = |value: f64| value / steady - 1.0;
    let most = largest(course, row, &course.readings(row), beyond).map_or(0.0, |(_, value)| beyond(value));
    if most > OVERSHOT { most } else { 0.0 }
}

/// Time from which an output stays within the band, in the readings of the piece that goes to the end.
fn settled_from(course: &Course<'_>, row: &OutputRow, piece: &[Reading], steady: f64) -> f64 {
    let outside = |value: f64| (value / steady - 1.0).abs() - SETTLED;
    let away = |k: usize| outside(piece[k].value) + SETTLED;
    for k in (0..piece.len()).rev() {
        let next = piece.get(k + 1);
        if away(k) > SETTLED {
            return next.map_or(piece[k].time, |next| {
                course.crossing(row, [&piece[k], next], |value| -outside(value))
            });
        }
        let turns = (k == 0 || away(k) >= away(k - 1)) && next.is_none_or(|_| away(k) >= away(k + 1));
        if turns && away(k) > BESIDE * SETTLED {
            let (time, value) = course.turning(row, piece, k, outside);
            if outside(value) > 0.0 {
                let from = piece.iter().rposition(|reading| reading.time <= time).unwrap_or(0);
                let turned = piece[from].moved(time, value);
                let after = piece.get(from + 1);
                return after
                    .map_or(time, |after| course.crossing(row, [&turned, after], |value| -outside(value)));
            }
        }
    }
    piece.first().map_or(0.0, |first| first.time)
}

/// First time at which `beyond` of an output is no longer negative \[s\].
fn first_beyond(
    course: &Course<'_>,
    row: &OutputRow,
    readings: &[Vec<Reading>],
    beyond: impl Fn(f64) -> f64,
) -> Option<f64> {
    for piece in readings {
        let Some(k) = piece.iter().position(|reading| beyond(reading.value) >= 0.0) else { continue };
        // At the beginning of a piece it has jumped there.
        return Some(match k.checked_sub(1) {
            Some(before) => course.crossing(row, [&piece[before], &piece[k]], &beyond),
            None => piece[k].time,
        });
    }
    None
}

/// Time and value where `size` of an output is largest, the first of equals.
fn largest(
    course: &Course<'_>,
    row: &OutputRow,
    readings: &[Vec<Reading>],
    size: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let all = readings.iter().flatten();
    let most = all.map(|reading| size(reading.value)).fold(f64::NEG_INFINITY, f64::max);
    let mut best: Option<(f64, f64)> = None;
    for piece in readings {
        for (k, reading) in piece.iter().enumerate() {
            let at = size(reading.value);
            let turns = (k == 0 || at >= size(piece[k - 1].value))
                && piece.get(k + 1).is_none_or(|next| at >= size(next.value));
            // What is rounding, or flat, has no vertex.
            let found = if turns && at > 0.0 && at >= BESIDE * most && piece.len() > 1 {
                course.turning(row, piece, k, &size)
            } else {
                (reading.time, reading.value)
            };
            if best.is_none_or(|(_, value)| size(found.1) > size(value)) {
                best = Some(found);
            }
        }
    }
    best
}

/// Value that an output goes to after a step of size `amplitude` of the forcing with index `input`. `None` where not every mode
/// dies away, A is singular, or the output goes along the path, which has no end.
pub fn steady_output(
    modes: &[Mode],
    row: &OutputRow,
    forced: &DrivenSystem,
    input: usize,
    amplitude: f64,
) -> Option<f64> {
    let stable = modes.iter().all(|mode| mode.stability == Stability::Stable);
    if !stable || row.path.iter().any(|k| *k != 0.0) {
        return None;
    }
    let steady = steady_state(&forced.a, &forced.forcings.get(input)?.column)?;
    let parts = row.states.component_mul(&steady);
    let direct = row.inputs.get(input)?.0;
    let value = parts.sum() + direct;
    // What is left of parts that cancel is rounding.
    let size = parts.iter().fold(direct.abs(), |size, part| size.max(part.abs()));
    let value = if value.abs() <= 1e-12 * size { 0.0 } else { value * amplitude };
    value.is_finite().then_some(value)
}

/// Whether every mode dies away, but the motion after a step, forcing 0, is no small disturbance all the way to its end.
pub fn steady_is_beyond(model: &PlaneModel, modes: &[Mode], forced: &DrivenSystem) -> bool {
    let slowest = modes.iter().map(|mode| mode.lambda.re).fold(f64::NEG_INFINITY, f64::max);
    let Some(forcing) = forced.forcings.first() else { return false };
    if !modes.iter().all(|mode| mode.stability == Stability::Stable) {
        return false;
    }
    let amplitude = forcing.input.at(f64::MAX);
    let end_state = steady_state(&forced.a, &forcing.column).map(|state| state * amplitude);
    if !end_state.is_some_and(|state| is_small(model, &state)) {
        return true;
    }
    // e^{σt} = SETTLED
    let last_edge = forcing.input.edges().fold(0.0, f64::max);
    let settled = last_edge + SETTLED.ln() / slowest;
    Course::new(model, forced, modes, settled).small_until.is_some()
}

/// Time \[s\] and value of an output where it is farthest from zero; `None` of nothing.
pub fn peak(course: &Course<'_>, row: &OutputRow) -> Option<(f64, f64)> {
    largest(course, row, &course.readings(row), f64::abs)
}

/// Population root mean square √(Σx²/N), in the unit of the values; of a change from steady flight it is taken about zero.
/// `None` of nothing.
pub fn root_mean_square(values: &[f64]) -> Option<f64> {
    let largest = values.iter().map(|x| x.abs()).reduce(f64::max)?;
    if largest == 0.0 {
        return Some(0.0);
    }
    // Beside the largest, so that no square runs over.
    let sum: f64 = values.iter().map(|x| (x / largest).powi(2)).sum();
    Some(largest * (sum / values.len() as f64).sqrt())
}

/// Time after `start` at which the bank angle first is 30° either way \[s\] (MIL-F-8785C §3.3.4 asks for such times).
pub fn time_to_bank(course: &Course<'_>, bank: &OutputRow, start: f64) -> Option<f64> {
    let beyond = |phi: f64| phi.abs() - std::f64::consts::FRAC_PI_6;
    first_beyond(course, bank, &course.readings(bank), beyond).map(|time| time - start)
}

/// Height between the first two turning points of the phugoid's part of the height \[m\], from crest to trough or trough to crest,
/// whether they are shown or not.
///
/// `height` is the row of [`Output::Height`]. `None` if there is no phugoid that oscillates and can be told from the other modes, or
/// if it doesn't turn twice while the disturbance is small.
pub fn phugoid_swing(
    model: &PlaneModel,
    modes: &[Mode],
    forced: &DrivenSystem,
    height: &OutputRow,
) -> Option<f64> {
    let phugoid = modes.iter().find(|mode| mode.naming.name == ModeName::Phugoid)?;
    if !modes.iter().all(|mode| mode.condition < WORST_SPLIT) {
        return None;
    }
    let last_edge = forced.forcings.iter().flat_map(|forcing| forcing.input.edges()).fold(0.0, f64::max);
    let course = Course::new(model, forced, modes, last_edge + 1.5 * phugoid.period()?);
    let part = ModeReading::new(phugoid, height, forced).row(forced);
    let pieces = course.readings(&part);
    // Each node once: at an edge the one that ends a piece.
    let nodes: Vec<(usize, usize)> =
        (0..pieces.len()).flat_map(|i| (usize::from(i > 0)..pieces[i].len()).map(move |k| (i, k))).collect();
    let turns: Vec<f64> = nodes
        .windows(3)
        .filter_map(|three| {
            let [before, at, after] = [0, 1, 2].map(|j| pieces[three[j].0][three[j].1].value);
            let sense = (at - before).signum();
            ((at - before) * (after - at) < 0.0)
                .then(|| turning_value(&course, &part, &pieces, three[1], sense))
        })
        .take(2)
        .collect();
    match turns[..] {
        [first, second] => Some((second - first).abs()),
        _ => None,
    }
}

/// Where an output turns at a node, upward for a `sense` of 1: at an edge on either side of it.
fn turning_value(
    course: &Course<'_>,
    row: &OutputRow,
    pieces: &[Vec<Reading>],
    (i, k): (usize, usize),
    sense: f64,
) -> f64 {
    let size = |value: f64| sense * value;
    let (_, mut value) = course.turning(row, &pieces[i], k, size);
    if let Some(next) = pieces.get(i + 1).filter(|_| k + 1 == pieces[i].len()) {
        let (_, other) = course.turning(row, next, 0, size);
        value = sense * size(value).max(size(other));
    }
    value
}

/// Control anticipation parameter as a step of the elevator shows it \[rad/s² per g\]: the first pitch acceleration over the load
/// factor at which the short period settles, the phugoid left out (Bihrle 1966; MIL-F-8785C §3.2.2.1).
///
/// `None` without a short period that oscillates or where its load factor is nothing.
pub fn control_anticipation(
    model: &PlaneModel,
    modes: &[Mode],
    forced: &DrivenSystem,
    elevator: usize,
) -> Option<f64> {
    let mode = modes.iter().find(|mode| mode.naming.name == ModeName::ShortPeriod)?;
    let column = &forced.forcings.get(elevator)?.column;
    let row = Output::NormalLoad.row(model, forced);
    // z∞ = −lᴴ b/λ, and n = 2 Re(c v z) + d
    let (v, l) = (&mode.shape, &mode.adjoint);
    let complex = |row: &nalgebra::Vector4<f64>| row.map(nalgebra::Complex::from);
    let coordinate = -l.dotc(&complex(column)) / (l.dotc(v) * mode.lambda);
    let load = 2.0 * (complex(&row.states).dot(v) * coordinate).re + row.inputs.get(elevator)?.0;
    let pitch_acceleration = column[Longitudinal::Q.index()];
    let value = pitch_acceleration / load;
    (value.is_finite() && mode.condition < WORST_SPLIT).then_some(value.abs())
}
