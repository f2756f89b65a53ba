//! The frequency response of an output to what disturbs: gain and phase, and the peaks that oscillations make.

use std::f64::consts::{PI, TAU};

use crate::flight::Start;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::experiment::forced;
use crate::flight::motion::frequency_response::{FrequencyPoint, Peak, frequency_response, peaks, transfer};
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::transfer_function::{StateSpace, TransferFunction};
use crate::scenario::{Quantity, Scenario};

/// Points over all frequencies where nothing else is asked for: finer than a screen can tell between peaks.
pub(super) const POINTS: usize = 400;

/// The response is followed at so many frequencies a decade at least, however few are asked for, so that no peak and no turn of
/// the phase is missed between two of them.
const FOLLOWED_PER_DECADE: f64 = 100.0;

/// The frequency response of one output.
#[derive(Clone, Debug, PartialEq)]
pub struct FrequencyResponse {
    /// Evenly spread over a logarithmic axis; points where it is infinite are left out.
    pub points: Vec<FrequencyPoint>,
    /// Local maxima of the gain. None where a mode grows: then no steady oscillation ever answers a sine, and the curves are only
    /// the transfer function at s = jω.
    pub peaks: Vec<Peak>,
    /// The transfer function in factored form; `None` where its roots can't be had.
    pub function: Option<TransferFunction>,
}

impl FrequencyResponse {
    /// The response of an output to a unit of what disturbs, in the sense in which its size counts, at `count` frequencies between two \[rad/s\].
    pub(super) fn of(
        scenario: &Scenario,
        PlaneAnalysis { model, modes, .. }: &PlaneAnalysis,
        output: Output,
        range: (f64, f64),
        count: usize,
    ) -> Self {
        let unit = Input::Step { amplitude: 1.0, start: 0.0 };
        let inputs = [(scenario.driven_channel(), unit)];
        let forced = forced(&scenario.edited, model, &inputs, Start::Rest, &[]);
        let row = output.row(model, &forced);
        let steps = count.saturating_sub(1).max(1);
        let decades = (range.1 / range.0).log10();
        let parts = ((FOLLOWED_PER_DECADE * decades / steps as f64).ceil() as usize).max(1);
        let mut points = frequency_response(&forced, &row, 0, range, steps * parts + 1);
        let sign = Quantity::input_sign(model.plane, scenario.driven_channel());
        if sign < 0.0 {
            turn(&mut points);
        }
        let function =
            StateSpace::of(&forced, &row, 0).and_then(|whole| whole.with_sign(sign).factored().ok());
        let is_growing = modes.iter().any(|mode| mode.stability == Stability::Unstable);
        let value = |frequency: f64| transfer(&forced, &row, 0, frequency);
        let peaks = if is_growing { Vec::new() } else { peaks(&value, &points, modes) };
        if parts > 1 {
            // Those that were asked for are among them, to the last bit.
            let asked = |k: usize| range.0 * (range.1 / range.0).powf(k as f64 / steps as f64);
            let asked: Vec<f64> = (0..=steps).map(asked).collect();
            points.retain(|point| asked.binary_search_by(|other| other.total_cmp(&point.frequency)).is_ok());
        }
        Self { points, peaks, function }
    }

    /// Frequencies \[rad/s\] at which the gain passes one, in SI: they mean something where input and output have one unit.
    pub fn gain_crossovers(&self) -> Vec<f64> {
        self.crossings(&|point| point.value.norm().ln())
    }

    /// Frequencies \[rad/s\] at which the output is half a turn behind or ahead of the input, with the phase there \[rad\]: an odd multiple
    /// of π.
    pub fn phase_crossovers(&self) -> Vec<(f64, f64)> {
        let turns = self.points.iter().map(|point| point.phase / TAU);
        let (least, most) =
            turns.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), turn| (a.min(turn), b.max(turn)));
        let mut found = Vec::new();
        let mut half = (least - 0.5).ceil() + 0.5;
        while half <= most {
            let at = self.crossings(&|point| point.phase / TAU - half);
            found.extend(at.into_iter().map(|frequency| (frequency, half * TAU)));
            half += 1.0;
        }
        found
    }

    /// Frequencies \[rad/s\] at which something passes zero, straight over their logarithms between the points.
    fn crossings(&self, height: &dyn Fn(&FrequencyPoint) -> f64) -> Vec<f64> {
        let mut found = Vec::new();
        for pair in self.points.windows(2) {
            let [a, b] = [&pair[0], &pair[1]].map(height);
            if (a < 0.0) != (b < 0.0) && (b - a).is_finite() {
                found.push(pair[0].frequency * (pair[1].frequency / pair[0].frequency).powf(a / (a - b)));
            }
        }
        found
    }
}

/// Turns the sense of the input: the phase goes by half a turn, and stays between −π and π at the first point.
fn turn(points: &mut [FrequencyPoint]) {
    let ahead = points.first().is_some_and(|first| first.phase <= 0.0);
    for point in points {
        point.value = -point.value;
        point.phase += if ahead { PI } else { -PI };
    }
}
