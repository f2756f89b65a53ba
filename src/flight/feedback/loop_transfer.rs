//! Over frequency: the loop of each input, cut before its actuator, and the answer of the whole to what disturbs it.
//!
//! L(s) = −K (s − A_cut)⁻¹ e is what comes back for a unit that is sent into the actuator, with its sign turned, so that the closed loop
//! has its poles where 1 + L(s) = 0 and what matters is how near L comes to −1. The loop of the other input stays closed.

use nalgebra::{Complex, DVector, RowDVector};

use super::appended::AppendedState;
use super::closed_model::ClosedModel;
use crate::flight::modes::eigen::EigenError;
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::motion::frequency_response::FrequencyPoint;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::DrivenSystem;
use crate::flight::motion::transfer_function::{StateSpace, TransferFunction};

/// The loop of one input, cut before its actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopTransfer {
    loop_cut: StateSpace,
    /// Poles of L: eigenvalues with the loop cut.
    pub poles: Vec<Complex<f64>>,
    /// Poles of the closed loop.
    pub closed_poles: Vec<Complex<f64>>,
}

impl LoopTransfer {
    /// The loop of an input; `None` where nothing is asked of it.
    pub fn of(closed: &ClosedModel, input: usize) -> Result<Option<Self>, EigenError> {
        if !closed.is_driven(input) {
            return Ok(None);
        }
        let cut = closed.cut(input);
        Ok(Some(Self {
            poles: eigenvalues(&cut)?.as_slice().to_vec(),
            closed_poles: eigenvalues(&closed.a)?.as_slice().to_vec(),
            loop_cut: StateSpace {
                a: cut,
                b: closed.enters.column(input).into_owned(),
                b_rate: DVector::zeros(closed.size()),
                c: -closed.asked.row(input),
                direct: (0.0, 0.0),
            },
        }))
    }

    /// L(s); `None` at a pole of it.
    pub fn at(&self, s: Complex<f64>) -> Option<Complex<f64>> {
        self.loop_cut.at(s)
    }

    /// How many poles of L grow.
    pub fn growing(&self) -> usize {
        let radius = self.poles.iter().map(|pole| pole.norm()).fold(0.0, f64::max);
        self.poles.iter().filter(|pole| pole.re > SMALLEST * radius).count()
    }

    /// L in factored form.
    pub fn factored(&self) -> Result<TransferFunction, EigenError> {
        self.loop_cut.factored()
    }

    /// L(jω) at a frequency \[rad/s\].
    pub fn over_frequency(&self, frequency: f64) -> Option<Complex<f64>> {
        self.at(Complex::new(0.0, frequency))
    }

    /// L(jω) at `count` frequencies evenly spread over a logarithmic axis, with a phase that doesn't jump.
    pub fn points(&self, range: (f64, f64), count: usize) -> Vec<FrequencyPoint> {
        let steps = count.saturating_sub(1).max(1) as f64;
        let at = (0..count).map(|k| range.0 * (range.1 / range.0).powf(k as f64 / steps));
        continuous(at, |frequency| self.over_frequency(frequency))
    }

    /// L(jω) at frequencies between which it does nothing unseen, with a phase that doesn't jump.
    pub fn curve(&self) -> Vec<FrequencyPoint> {
        continuous(self.frequencies().into_iter(), |frequency| self.over_frequency(frequency))
    }

    /// Frequencies \[rad/s\] between which L does nothing unseen: evenly spread beyond all poles, and closer around each resonance.
    pub(super) fn frequencies(&self) -> Vec<f64> {
        let poles = || self.poles.iter().chain(&self.closed_poles).filter(|pole| pole.im >= 0.0);
        let sizes = || poles().map(|pole| pole.norm()).filter(|size| *size > 0.0);
        let high = sizes().fold(f64::MIN_POSITIVE, f64::max);
        let low = sizes().filter(|size| *size > SMALLEST * high).fold(high, f64::min);
        let (low, high) = (low / BEYOND, high * BEYOND);
        let count = ((high / low).log10() * PER_DECADE).ceil().max(2.0);
        let mut all: Vec<f64> =
            (0..=count as usize).map(|k| low * (high / low).powf(k as f64 / count)).collect();
        for pole in poles().filter(|pole| pole.im > 0.0) {
            let width = pole.re.abs().max(1e-6 * pole.im);
            all.extend((-40..=40).map(|k| pole.im + 0.2 * f64::from(k) * width).filter(|w| *w > 0.0));
        }
        all.retain(|frequency| frequency.is_finite());
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }
}

/// A pole nearer to zero than this fraction of the largest is none to look around.
const SMALLEST: f64 = 1e-9;
/// So far beyond the poles nothing happens any more.
const BEYOND: f64 = 1e3;
/// Frequencies looked at in a decade.
const PER_DECADE: f64 = 60.0;

/// The whole from the forcing of `forced` with index `input` to an output of the aircraft; `None` where there is no such input.
pub fn closed_state_space(
    closed: &ClosedModel,
    forced: &DrivenSystem,
    output: Output,
    input: usize,
) -> Option<StateSpace> {
    let forcing = forced.forcings.get(input)?;
    let none = || Input::Step { amplitude: 0.0, start: 0.0 };
    let whole = closed.with_courses(forced, [none(), none()], |_| none());
    let row = output.row(&closed.model, &whole);
    let at_end = forced.forcings.len();
    let [b, b_rate] = closed.columns(forcing);
    let felt = closed.felt(forcing);
    let mut c = RowDVector::zeros(closed.size());
    c.columns_mut(0, 4).copy_from(&row.states.transpose());
    let (mut d, of_rate) = row.inputs[input];
    for (i, (of_states, at_once)) in closed.controls().iter().enumerate() {
        let moved = row.inputs[at_end + i].0;
        c += of_states * moved;
        if *at_once {
            d += felt[i] * moved;
        }
    }
    for k in 0..closed.of_source() {
        c[4 + k] += row.inputs[at_end + 2 + k].0;
    }
    // Those of the law are the path itself; those of the source are what it says they are.
    let of_source = closed.of_source();
    let place = |state| {
        let place = closed.appended.iter().position(|other| *other == state)?;
        (place >= of_source).then_some(4 + place)
    };
    let known = [place(AppendedState::Heading), place(AppendedState::Height)];
    let four = StateSpace { a: closed.a.clone(), b, b_rate, c, direct: (d, of_rate) };
    Some(four.with_path(&forced.path, row.path, known))
}

/// The answer of an output of the aircraft under a law to the forcing of `forced` with index `input`, at given frequencies
/// \[rad/s\]; points where it is infinite are left out.
pub fn closed_frequency_response(
    closed: &ClosedModel,
    forced: &DrivenSystem,
    output: Output,
    input: usize,
    frequencies: &[f64],
) -> Vec<FrequencyPoint> {
    let Some(whole) = closed_state_space(closed, forced, output, input) else { return Vec::new() };
    continuous(frequencies.iter().copied(), |frequency| whole.over_frequency(frequency))
}

/// Points at frequencies, the phase of each on the turn nearest to that before.
pub fn continuous(
    frequencies: impl Iterator<Item = f64>,
    transfer: impl Fn(f64) -> Option<Complex<f64>>,
) -> Vec<FrequencyPoint> {
    let mut points: Vec<FrequencyPoint> = Vec::new();
    for frequency in frequencies {
        let Some(value) = transfer(frequency) else { continue };
        let mut phase = value.arg();
        if let Some(last) = points.last() {
            let turn = std::f64::consts::TAU;
            phase += turn * ((last.phase - phase) / turn).round();
        }
        points.push(FrequencyPoint { frequency, value, phase });
    }
    points
}
