//! Frequency response of any input to any output: gain and phase over frequency, with the peaks that modes make.

use nalgebra::{Complex, Matrix4, Vector2, Vector4};

use super::outputs::OutputRow;
use super::response::DrivenSystem;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;

/// Gain and phase at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyPoint {
    /// Angular frequency ω \[rad/s\].
    pub frequency: f64,
    /// G(jω), output unit over input unit.
    pub value: Complex<f64>,
    /// Phase \[rad\], continuous from the point before.
    pub phase: f64,
}

/// A local maximum of the gain, with the oscillation that makes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The oscillation nearest in frequency.
    pub mode: ModeName,
    /// Angular frequency of the maximum \[rad/s\].
    pub frequency: f64,
    /// Gain there; `None` where it has no bound, at an oscillation that neither dies away nor grows.
    pub gain: Option<f64>,
}

/// G(jω) of the forcing with index `input`: c (jω − A)⁻¹ (b + jω ḃ) + d + jω ḋ, the path included.
///
/// `None` at a pole on the imaginary axis, for ω = 0 with a path, or where there is no such input.
pub fn transfer(
    forced: &DrivenSystem,
    row: &OutputRow,
    input: usize,
    frequency: f64,
) -> Option<Complex<f64>> {
    let forcing = forced.forcings.get(input)?;
    let &(d, of_rate) = row.inputs.get(input)?;
    let s = Complex::new(0.0, frequency);
    let complex = |x: f64| Complex::from(x);
    let system = Matrix4::from_diagonal_element(s) - forced.a.map(complex);
    let driven: Vector4<Complex<f64>> = forcing.column.map(complex) + forcing.rate_column.map(complex) * s;
    let x = system.full_piv_lu().solve(&driven)?;
    let mut value = row.states.map(complex).dot(&x) + complex(d) + s * of_rate;
    if row.path != Vector2::zeros() {
        let rates = forced.path.of_states.map(complex) * x;
        let first = rates[0] / s;
        let second = (rates[1] + first * forced.path.of_path[(1, 0)]) / s;
        value += first * row.path[0] + second * row.path[1];
    }
    (value.re.is_finite() && value.im.is_finite()).then_some(value)
}

/// Angular frequencies around the modes \[rad/s\], from and to: on whole decades, a factor of 2 to 20 beyond them, and around 1.
pub fn frequency_range(modes: &[Mode]) -> (f64, f64) {
    let sizes = modes.iter().map(|mode| mode.lambda.norm()).filter(|size| *size > 1e-4);
    let (low, high) = sizes.fold((1.0_f64, 1.0_f64), |(low, high), size| (low.min(size), high.max(size)));
    (10_f64.powf((0.5 * low).log10().floor()), 10_f64.powf((2.0 * high).log10().ceil().min(4.0)))
}

/// The response at `count` frequencies evenly spread over a logarithmic axis; points where it is infinite are left out.
pub fn frequency_response(
    forced: &DrivenSystem,
    row: &OutputRow,
    input: usize,
    (low, high): (f64, f64),
    count: usize,
) -> Vec<FrequencyPoint> {
    let mut points: Vec<FrequencyPoint> = Vec::with_capacity(count);
    let steps = count.saturating_sub(1).max(1) as f64;
    for k in 0..count {
        let frequency = low * (high / low).powf(k as f64 / steps);
        let Some(value) = transfer(forced, row, input, frequency) else { continue };
        let mut phase = value.arg();
        if let Some(last) = points.last() {
            // The same angle, on the turn nearest to the last.
            let turn = std::f64::consts::TAU;
            phase += turn * ((last.phase - phase) / turn).round();
        }
        points.push(FrequencyPoint { frequency, value, phase });
    }
    points
}

/// Local maxima of the gain, each with the oscillation whose natural frequency is nearest, found on the points and refined
/// between them.
pub fn peaks(
    value: &dyn Fn(f64) -> Option<Complex<f64>>,
    points: &[FrequencyPoint],
    modes: &[Mode],
) -> Vec<Peak> {
    let gain = |frequency: f64| value(frequency).map_or(0.0, |value| value.norm());
    let mut found = Vec::new();
    for three in points.windows(3) {
        let [before, at, after] = three else { continue };
        let norm = at.value.norm();
        if !(norm > before.value.norm() && norm >= after.value.norm()) {
            continue;
        }
        let frequency = maximum(gain, before.frequency, after.frequency);
        let away = |mode: &Mode| (mode.lambda.norm() / frequency).ln().abs();
        let oscillations = modes.iter().filter(|mode| mode.is_oscillatory());
        let Some(mode) = oscillations.min_by(|a, b| away(a).total_cmp(&away(b))) else { continue };
        let unbounded = mode.stability == Stability::Neutral && away(mode) < 1e-3;
        found.push(Peak {
            mode: mode.naming.name,
            frequency: if unbounded { mode.lambda.im } else { frequency },
            gain: (!unbounded).then(|| gain(frequency)),
        });
    }
    found
}

/// Golden-section search for the one maximum between two frequencies (Press et al., *Numerical Recipes*, §10.2).
fn maximum(gain: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    let (mut low, mut high) = (low, high);
    for _ in 0..60 {
        let (a, b) = (high - RATIO * (high - low), low + RATIO * (high - low));
        if gain(a) > gain(b) { high = b } else { low = a }
    }
    0.5 * (low + high)
}
