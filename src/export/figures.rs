//! The numbers a course asks of a motion.

use serde::Serialize;

use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::Motion;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::course::Course;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::{Output, OutputRow};
use crate::flight::motion::response_metrics::{
    control_anticipation, peak, phugoid_swing, steady_output, step_figures, time_to_bank,
};
use crate::scenario::{Quantity, START, Scenario, Source};

/// Figures of a motion, from its beginning to where it is no small disturbance any more. Peaks and the time to bank are of the time
/// shown, all others of the whole motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Figures"))]
pub struct FiguresReport {
    /// When the disturbance begins \[s\]: times after it count from here.
    pub start: f64,
    /// Metrics of each output, in their order.
    pub outputs: Vec<OutputFigures>,
    /// Largest change of the load factor, normal or lateral after the plane, with its sign.
    pub peak_load_factor: Option<PeakReport>,
    /// Time after the start at which the bank angle first is 30° either way \[s\]; of lateral motion but in turbulence.
    pub time_to_bank: Option<f64>,
    /// Height between the first two turning points of the phugoid's part of the height \[m\]; of longitudinal motion but in turbulence.
    pub phugoid_swing: Option<f64>,
    /// First pitch acceleration over the load factor at which the short period settles \[rad/s² per g\]; of the elevator.
    pub control_anticipation: Option<f64>,
}

/// Figures of one output, in its SI unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OutputFigures {
    /// Name of the output.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// Value farthest from zero.
    pub peak: Option<PeakReport>,
    /// Value that it goes to after a step; null where it goes to none.
    pub steady: Option<f64>,
    /// Time from 10 % to 90 % of the steady value, both for the first time \[s\].
    pub rise_time: Option<f64>,
    /// Time after the step from which it stays within 2 % of the steady value for ever, whether that is shown or not \[s\].
    pub settling_time: Option<f64>,
    /// Overshoot beyond the steady value, as a fraction of it.
    pub overshoot: Option<f64>,
}

/// A value farthest from zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Peak"))]
pub struct PeakReport {
    /// The value, with its sign.
    pub value: f64,
    /// When \[s\].
    pub time: f64,
}

impl FiguresReport {
    pub(super) fn of(scenario: &Scenario, motion: &Motion, modes: &[Mode]) -> Self {
        let Motion { model, forced, experiment, .. } = motion;
        let plane = model.plane;
        let course = Course::new(model, forced, modes, experiment.grid.duration);
        let source = scenario.disturbance.choices[plane].source;
        // A disturbance without a start of its own acts from the first sample on.
        let start = if source.shapes().is_empty() { 0.0 } else { START };
        let load = match plane {
            Plane::Longitudinal => Output::NormalLoad,
            Plane::Lateral => Output::SideLoad,
        };
        let row = |output: Output| output.row(model, forced);
        // In turbulence neither says anything of the aircraft.
        let random = source == Source::Turbulence;
        let swing = || phugoid_swing(model, modes, forced, &row(Output::Height));
        let banked = || time_to_bank(&course, &row(Output::BankAngle), start);
        let anticipation = || control_anticipation(model, modes, forced, 0);
        Self {
            start,
            outputs: Output::of(plane)
                .iter()
                .map(|&output| OutputFigures::of(output, motion, modes, &course))
                .collect(),
            peak_load_factor: PeakReport::of(&course, &row(load)),
            time_to_bank: (plane == Plane::Lateral && !random).then(banked).flatten(),
            phugoid_swing: (plane == Plane::Longitudinal && !random).then(swing).flatten(),
            control_anticipation: (source == Source::Elevator).then(anticipation).flatten(),
        }
    }
}

impl OutputFigures {
    fn of(output: Output, motion: &Motion, modes: &[Mode], course: &Course<'_>) -> Self {
        let row = output.row(&motion.model, &motion.forced);
        let steady = match motion.forced.forcings.first().map(|forcing| &forcing.input) {
            Some(Input::Step { amplitude, .. }) => steady_output(modes, &row, &motion.forced, 0, *amplitude),
            _ => None,
        };
        let peak = PeakReport::of(course, &row);
        // A steady value that is zero on paper is rounding.
        let rounding = 1e-12 * peak.map_or(0.0, |peak| peak.value.abs());
        let steady = steady.map(|steady| if steady.abs() <= rounding { 0.0 } else { steady });
        let figures =
            steady.and_then(|steady| step_figures(&motion.model, modes, &motion.forced, &row, START, steady));
        let Quantity { key, dimension, .. } = Quantity::of(output);
        Self {
            name: key,
            unit: dimension.si_symbol(),
            peak,
            steady,
            rise_time: figures.and_then(|figures| figures.rise_time),
            settling_time: figures.map(|figures| figures.settling_time),
            overshoot: figures.map(|figures| figures.overshoot),
        }
    }
}

impl PeakReport {
    fn of(course: &Course<'_>, row: &OutputRow) -> Option<Self> {
        peak(course, row).map(|(time, value)| Self { value, time })
    }
}
