//! How far a loop is from instability: gain and phase margins, the peak of the sensitivity, and Nyquist's count.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::loop_transfer::LoopTransfer;

/// A real part counts as growing above this fraction of the largest |λ|, as a mode does.
const NEUTRAL_FRACTION: f64 = 1e-9;

/// So small a share of the largest |L| is rounding.
const NOTHING: f64 = 1e-10;

/// Halvings of an interval in which something is sought: to the last bit.
const HALVINGS: usize = 200;

/// A change of the gain of the whole loop that makes it neutral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GainMargin {
    /// The factor on all gains to the input: above 1 they may be raised so far, below 1 lowered.
    pub factor: f64,
    /// Angular frequency at which it then oscillates \[rad/s\]; zero where it diverges.
    pub frequency: f64,
}

/// A change of phase around a loop that makes it neutral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseMargin {
    /// The lag \[rad\], between −π and π; a negative one is a lead. Whether the loop bears less of it, or needs more, is told by whether
    /// it is stable.
    pub angle: f64,
    /// Crossover frequency, at which |L| = 1 \[rad/s\].
    pub frequency: f64,
}

/// The greatest of |1/(1 + L(jω))|: the reciprocal of the distance of L from −1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensitivityPeak {
    /// Its value.
    pub value: f64,
    /// Angular frequency at which it is \[rad/s\].
    pub frequency: f64,
}

/// The margins of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopMargins {
    /// The least factor above 1 that makes it neutral; `None` where no rise of the gain does.
    pub raise: Option<GainMargin>,
    /// The greatest factor below 1 that does; `None` where no lowering does.
    pub lower: Option<GainMargin>,
    /// The margin of phase that is smallest, of all crossovers; `None` where |L| crosses 1 nowhere.
    pub phase: Option<PhaseMargin>,
    /// The peak of the sensitivity; `None` where it is above 1 at no frequency.
    pub sensitivity: Option<SensitivityPeak>,
    /// How often L goes around −1 clockwise while s goes up the imaginary axis and back around the right: the closed loop has so many
    /// growing roots more than the loop cut. `None` where L goes through −1, or so near that they can't be counted.
    pub turns: Option<i32>,
}

impl LoopMargins {
    /// The margins of a loop.
    pub fn of(transfer: &LoopTransfer) -> Self {
        let at = |frequency: f64| Some((frequency, transfer.over_frequency(frequency)?));
        let points: Vec<(f64, Complex<f64>)> = transfer.frequencies().into_iter().filter_map(at).collect();
        let largest = points.iter().map(|(_, value)| value.norm()).fold(0.0, f64::max);
        let mut factors: Vec<GainMargin> = Vec::new();
        let mut phases: Vec<PhaseMargin> = Vec::new();
        // At rest L is a real number.
        if let Some((_, value)) = at(0.0)
            && value.re < -NOTHING * largest
        {
            factors.push(GainMargin { factor: -1.0 / value.re, frequency: 0.0 });
        }
        for pair in points.windows(2) {
            let [(low, before), (high, after)] = pair else { continue };
            if before.im.signum() != after.im.signum() {
                let found = crossing(transfer, (*low, *high), |value| value.im);
                // Where L is next to nothing its sign is rounding.
                let is_there = |value: Complex<f64>| value.re < -NOTHING * largest && is_real(value);
                if let Some((frequency, value)) = found.filter(|(_, value)| is_there(*value)) {
                    factors.push(GainMargin { factor: -1.0 / value.re, frequency });
                }
            }
            if (before.norm() > 1.0) != (after.norm() > 1.0)
                && let Some((frequency, value)) =
                    crossing(transfer, (*low, *high), |value| value.norm() - 1.0)
            {
                // arg(−L): how far L is before −1, turning clockwise
                phases.push(PhaseMargin { angle: (-value).arg(), frequency });
            }
        }
        let raise = factors.iter().filter(|margin| margin.factor > 1.0);
        let lower = factors.iter().filter(|margin| margin.factor < 1.0);
        Self {
            raise: raise.min_by(|a, b| a.factor.total_cmp(&b.factor)).copied(),
            lower: lower.max_by(|a, b| a.factor.total_cmp(&b.factor)).copied(),
            phase: phases.into_iter().min_by(|a, b| a.angle.abs().total_cmp(&b.angle.abs())),
            sensitivity: sensitivity_peak(transfer, &points),
            turns: turns(transfer),
        }
    }
}

/// Whether a crossing of the real axis is one, and no jump of a pole's phase.
fn is_real(value: Complex<f64>) -> bool {
    value.im.abs() <= 1e-6 * value.re.abs()
}

/// Frequency and L between two at which `side` of L changes its sign.
fn crossing(
    transfer: &LoopTransfer,
    (low, high): (f64, f64),
    side: impl Fn(Complex<f64>) -> f64,
) -> Option<(f64, Complex<f64>)> {
    let (mut low, mut high) = (low, high);
    let begins = side(transfer.over_frequency(low)?) > 0.0;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            break;
        }
        if (side(transfer.over_frequency(middle)?) > 0.0) == begins { low = middle } else { high = middle }
    }
    Some((low, transfer.over_frequency(low)?))
}

/// Golden-section search about the sample nearest to −1.
fn sensitivity_peak(transfer: &LoopTransfer, points: &[(f64, Complex<f64>)]) -> Option<SensitivityPeak> {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    let distance = |value: Complex<f64>| (value + 1.0).norm();
    let k = (0..points.len()).min_by(|&a, &b| distance(points[a].1).total_cmp(&distance(points[b].1)))?;
    let of = |frequency: f64| transfer.over_frequency(frequency).map_or(f64::INFINITY, distance);
    let (mut low, mut high) = (points[k.saturating_sub(1)].0, points[(k + 1).min(points.len() - 1)].0);
    for _ in 0..80 {
        let (a, b) = (high - RATIO * (high - low), low + RATIO * (high - low));
        if of(a) < of(b) { high = b } else { low = a }
    }
    let middle = 0.5 * (low + high);
    let nearest = [(points[k].0, distance(points[k].1)), (middle, of(middle))]
        .into_iter()
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    let value = 1.0 / nearest.1;
    // Beyond the last frequency it is 1.
    (value.is_finite() && value > 1.0).then_some(SensitivityPeak { value, frequency: nearest.0 })
}

/// Clockwise turns of L around −1 along s = ε + jω: ε is where a root begins to count as growing, so that roots of the cut loop on the
/// imaginary axis, an integrator's, are passed on their right.
fn turns(transfer: &LoopTransfer) -> Option<i32> {
    let radius =
        transfer.poles.iter().chain(&transfer.closed_poles).map(|pole| pole.norm()).fold(0.0, f64::max);
    let shift = (NEUTRAL_FRACTION * radius).max(f64::MIN_POSITIVE);
    let of = |frequency: f64| Some(transfer.at(Complex::new(shift, frequency))? + 1.0);
    // From zero up; the way below the real axis is its mirror image.
    let mut frequencies = vec![0.0];
    let (low, high) = (0.1 * shift, 1e4 * radius.max(f64::MIN_POSITIVE));
    let count = (20.0 * (high / low).log10()).ceil().max(2.0);
    frequencies.extend((0..=count as usize).map(|k| low * (high / low).powf(k as f64 / count)));
    frequencies.extend(transfer.frequencies());
    frequencies.sort_by(f64::total_cmp);
    frequencies.dedup();
    let mut turned = 0.0;
    for pair in frequencies.windows(2) {
        let [low, high] = pair else { continue };
        turned += angle_between((*low, of(*low)?), (*high, of(*high)?), &of, 0)?;
    }
    // At the end L is next to nothing, so that 1 + L is as good as 1.
    let last = of(*frequencies.last()?)?;
    turned -= last.arg();
    let whole = -2.0 * turned / TAU;
    ((whole - whole.round()).abs() < 0.1).then(|| whole.round() as i32)
}

/// The angle by which 1 + L turns from one frequency to another, counter-clockwise; halved until no part can hide a turn.
fn angle_between(
    from: (f64, Complex<f64>),
    to: (f64, Complex<f64>),
    of: &impl Fn(f64) -> Option<Complex<f64>>,
    depth: u32,
) -> Option<f64> {
    let ratio = to.1 / from.1;
    let angle = ratio.arg();
    if angle.abs() < PI / 6.0 && (0.25..4.0).contains(&ratio.norm()) {
        return Some(angle);
    }
    let middle = 0.5 * (from.0 + to.0);
    if depth > 60 || !(from.0 < middle && middle < to.0) {
        return None;
    }
    let at = (middle, of(middle)?);
    Some(angle_between(from, at, of, depth + 1)? + angle_between(at, to, of, depth + 1)?)
}
