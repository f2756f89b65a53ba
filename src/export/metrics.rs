//! The numbers a course asks of a motion, as the page shows them.

use serde::Serialize;

use crate::findings::{Extreme, Metrics, OutputMetrics};
use crate::scenario::Quantity;

/// Figures of a motion, from its beginning to where it is no small disturbance any more. Peaks and the time to bank are of the time
/// shown, all others of the whole motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Figures"))]
pub struct MetricsReport {
    /// When the disturbance begins \[s\]: times after it count from here.
    pub start: f64,
    /// Metrics of each output, in their order.
    pub outputs: Vec<OutputMetricsReport>,
    /// Largest change of the load factor, normal or lateral after the plane, with its sign; null where it is no peak.
    pub peak_load_factor: Option<PeakReport>,
    /// Load factor where the linear model ends while it is still growing; null where it has a peak.
    pub load_factor_beyond: Option<f64>,
    /// Whether there are no steady values only because the linear model ends on the way to them.
    pub steady_is_beyond: bool,
    /// Time after the start at which the bank angle first is 30° either way \[s\]; of lateral motion but in turbulence.
    pub time_to_bank: Option<f64>,
    /// Height between the first two turning points of the phugoid's part of the height \[m\]; of longitudinal motion but in turbulence.
    pub phugoid_swing: Option<f64>,
    /// First pitch acceleration over the load factor at which the short period settles \[rad/s² per g\]; of the elevator.
    pub control_anticipation: Option<f64>,
}

/// Metrics of one output, in its SI unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "OutputFigures"))]
pub struct OutputMetricsReport {
    /// Name of the output.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// Value farthest from zero; null where that is no peak.
    pub peak: Option<PeakReport>,
    /// Value where the linear model ends while it is still growing, nobody knows how far; null where it has a peak.
    pub beyond: Option<f64>,
    /// Value that it goes to after a step; null where it goes to none, or where the linear model ends on the way.
    pub steady: Option<f64>,
    /// Time from 10 % to 90 % of the steady value, both for the first time \[s\]; null too where the linear model ends on the way.
    pub rise_time: Option<f64>,
    /// Time after the step from which it stays within 2 % of the steady value \[s\], likewise.
    pub settling_time: Option<f64>,
    /// Overshoot beyond the steady value, as a fraction of it, likewise.
    pub overshoot: Option<f64>,
    /// Root mean square of the change over the time watched; in turbulence only.
    pub root_mean_square: Option<f64>,
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

impl MetricsReport {
    pub(super) fn of(metrics: &Metrics) -> Self {
        let (peak_load_factor, load_factor_beyond) = parted(metrics.load_factor);
        Self {
            start: metrics.start,
            outputs: metrics.outputs.iter().map(OutputMetricsReport::of).collect(),
            peak_load_factor,
            load_factor_beyond,
            steady_is_beyond: metrics.steady_is_beyond,
            time_to_bank: metrics.time_to_bank,
            phugoid_swing: metrics.phugoid_swing,
            control_anticipation: metrics.control_anticipation,
        }
    }
}

impl OutputMetricsReport {
    fn of(metrics: &OutputMetrics) -> Self {
        let &OutputMetrics { output, extreme, steady, step, root_mean_square } = metrics;
        let (peak, beyond) = parted(extreme);
        let Quantity { key, dimension, .. } = Quantity::of(output);
        Self {
            name: key,
            unit: dimension.si_symbol(),
            peak,
            beyond,
            steady,
            rise_time: step.and_then(|step| step.rise_time),
            settling_time: step.map(|step| step.settling_time),
            overshoot: step.map(|step| step.overshoot),
            root_mean_square,
        }
    }
}

/// The peak, or else the value that is none.
fn parted(extreme: Option<Extreme>) -> (Option<PeakReport>, Option<f64>) {
    match extreme {
        Some(Extreme::Peak { value, time }) => (Some(PeakReport { value, time }), None),
        Some(Extreme::Beyond(value)) => (None, Some(value)),
        None => (None, None),
    }
}
