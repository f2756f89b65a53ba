//! The numbers a course asks of a response: how fast, how far over, where to, and what the pilot feels.

use super::modal_sum::ModalSum;
use super::outputs::{Output, OutputRow};
use super::response::{Forced, steady_state};
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;

/// Within this fraction of the steady value a response counts as settled.
pub const SETTLED: f64 = 0.02;

/// Figures of an output's answer to a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepFigures {
    /// Value that the output goes to, in its unit.
    pub steady: f64,
    /// Time from 10 % to 90 % of the steady value, both for the first time \[s\].
    pub rise_time: Option<f64>,
    /// Time after the step from which it stays within [`SETTLED`] of the steady value \[s\]; `None` if not yet at the end.
    pub settling_time: Option<f64>,
    /// How far it goes beyond the steady value, as a fraction of it: zero if it has settled without, `None` if it hasn't gone
    /// beyond and may yet.
    pub overshoot: Option<f64>,
}

/// Figures of the values of an output at samples `dt` apart, after a step at `start` that leads to `steady`.
///
/// `None` where the steady value is too small beside the motion to measure by (a thousandth of the peak).
pub fn step_figures(values: &[f64], dt: f64, start: f64, steady: f64) -> Option<StepFigures> {
    let peak = values.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
    if !(steady.is_finite() && steady.abs() > 1e-3 * peak && steady != 0.0) {
        return None;
    }
    let shares: Vec<f64> = values.iter().map(|x| x / steady).collect();
    let reached = |share: f64| crossing(&shares, dt, share);
    let rise_time = reached(0.9).and_then(|high| Some(high - reached(0.1)?));
    let outside = shares.iter().rposition(|share| (share - 1.0).abs() > SETTLED);
    let settling_time = match outside {
        None => Some(0.0),
        Some(k) if k + 1 < shares.len() => {
            // Where the last way in crosses the band.
            let (before, after) = ((shares[k] - 1.0).abs(), (shares[k + 1] - 1.0).abs());
            let fraction = if before > after { (before - SETTLED) / (before - after) } else { 1.0 };
            Some(((k as f64 + fraction) * dt - start).max(0.0))
        }
        Some(_) => None,
    };
    let beyond = shares.iter().fold(0.0, |over: f64, share| over.max(share - 1.0));
    let overshoot = Some(beyond).filter(|beyond| *beyond > 0.0 || settling_time.is_some());
    Some(StepFigures { steady, rise_time, settling_time, overshoot })
}

/// First time at which values `dt` apart reach a level from below, straight between the samples \[s\].
fn crossing(values: &[f64], dt: f64, level: f64) -> Option<f64> {
    let k = values.iter().position(|&x| x >= level)?;
    let Some(before) = k.checked_sub(1).map(|k| values[k]) else { return Some(0.0) };
    Some((k as f64 - (values[k] - level) / (values[k] - before)) * dt)
}

/// Value that an output goes to after a step of size `amplitude` of the forcing with index `input`. `None` where not every mode
/// dies away, A is singular, or the output goes along the path, which has no end.
pub fn steady_output(
    modes: &[Mode],
    row: &OutputRow,
    forced: &Forced,
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

/// Value farthest from zero and its time \[s\]; `None` of nothing.
pub fn peak(values: &[f64], dt: f64) -> Option<(f64, f64)> {
    let (k, value) = values.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    Some((k as f64 * dt, *value))
}

/// Population root mean square √(Σx²/N), in the unit of the values; of a change from steady flight it is taken about zero.
/// `None` of nothing.
pub fn root_mean_square(values: &[f64]) -> Option<f64> {
    let (_, largest) = peak(values, 0.0)?;
    if largest == 0.0 {
        return Some(0.0);
    }
    // Beside the largest, so that no square runs over.
    let sum: f64 = values.iter().map(|x| (x / largest).powi(2)).sum();
    Some(largest.abs() * (sum / values.len() as f64).sqrt())
}

/// Time after `start` at which the bank angle first is 30° either way \[s\] (MIL-F-8785C §3.3.4 asks for such times).
pub fn time_to_bank(bank: &[f64], dt: f64, start: f64) -> Option<f64> {
    let sizes: Vec<f64> = bank.iter().map(|phi| phi.abs()).collect();
    crossing(&sizes, dt, std::f64::consts::FRAC_PI_6).map(|time| time - start)
}

/// Height between the first two turning points of the phugoid's part of the height \[m\], from crest to trough or trough to crest.
///
/// `height` is the split of [`Output::Height`]. `None` if there is no phugoid that oscillates, or less than a swing of it.
pub fn phugoid_swing(modes: &[Mode], height: &ModalSum) -> Option<f64> {
    let phugoid = modes.iter().position(|mode| mode.naming.name == ModeName::Phugoid)?;
    let part = height.parts.get(phugoid)?;
    let turns: Vec<f64> = part
        .windows(3)
        .filter(|three| (three[1] - three[0]) * (three[2] - three[1]) < 0.0)
        .map(|three| three[1])
        .take(2)
        .collect();
    match turns[..] {
        [first, second] => Some((second - first).abs()),
        _ => None,
    }
}

/// Control anticipation parameter as a step of the elevator shows it \[rad/s² per g\]: the first pitch acceleration over the load
/// factor at which the short period settles, the phugoid left out (Bihrle 1966; MIL-F-8785C §3.2.2.1).
///
/// `None` without a short period that oscillates or where its load factor is nothing.
pub fn control_anticipation(
    model: &PlaneModel,
    modes: &[Mode],
    forced: &Forced,
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
    let pitch_acceleration = column[crate::flight::aircraft::states::Longitudinal::Q.index()];
    let value = pitch_acceleration / load;
    (value.is_finite() && mode.condition < super::modal_sum::WORST_SPLIT).then_some(value.abs())
}
