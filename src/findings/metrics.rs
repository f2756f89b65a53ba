//! The numbers a course asks of a motion, as long as it is a small disturbance: beyond, the linear model means nothing. Peaks and
//! the time to bank are of the time shown, all others of the whole motion.

use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::Motion;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::course::Course;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response_metrics::{
    StepMetrics, control_anticipation, peak, phugoid_swing, root_mean_square, steady_is_beyond,
    steady_output, step_metrics, time_to_bank,
};
use crate::scenario::{START, Scenario, Source};

/// A steady value below this fraction of the peak is zero on paper: the rest is rounding.
const ROUNDING: f64 = 1e-9;

/// Metrics of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Metrics {
    /// When the disturbance begins \[s\]: times after it count from here.
    pub start: f64,
    /// One an output, in the order of [`Output::of`] the plane.
    pub outputs: Vec<OutputMetrics>,
    /// Largest change of the load factor \[g\], normal or lateral after the plane.
    pub load_factor: Option<Extreme>,
    /// Time after the start at which the bank angle first is 30° either way \[s\]; of lateral motion but in turbulence.
    pub time_to_bank: Option<f64>,
    /// Height between the first two turning points of the phugoid's part of the height \[m\]; of longitudinal motion but in turbulence.
    pub phugoid_swing: Option<f64>,
    /// Whether there are no steady values although every mode dies away: on the way to them the motion is no small disturbance.
    pub steady_is_beyond: bool,
    /// First pitch acceleration over the load factor at which the short period settles \[rad/s² per g\]; of the elevator.
    pub control_anticipation: Option<f64>,
}

/// Metrics of one output, in its SI unit.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputMetrics {
    /// The output.
    pub output: Output,
    /// Its value farthest from zero.
    pub extreme: Option<Extreme>,
    /// Value that it goes to after a step, where every mode dies away and the motion is small all the way.
    pub steady: Option<f64>,
    /// How fast a step is answered and how far over; `None` too where the linear model ends on the way.
    pub step: Option<StepMetrics>,
    /// Root mean square of the change, in turbulence only: the measure of a motion without end or pattern.
    pub root_mean_square: Option<f64>,
}

/// The value farthest from zero, with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extreme {
    /// A peak.
    Peak {
        /// Its value.
        value: f64,
        /// When \[s\].
        time: f64,
    },
    /// No peak: the value where the linear model ends, from where the motion goes on to grow, nobody knows how far.
    Beyond(f64),
}

impl Metrics {
    /// Metrics of one output of a motion, and nothing else: where many motions are compared by it.
    pub(super) fn of_one(scenario: &Scenario, motion: &Motion, modes: &[Mode], output: Output) -> Self {
        Self::some(scenario, motion, modes, &[output], false)
    }

    /// Metrics of a motion; `modes` are those of its model.
    pub(super) fn of(scenario: &Scenario, motion: &Motion, modes: &[Mode]) -> Self {
        Self::some(scenario, motion, modes, Output::of(motion.model.plane), true)
    }

    /// Metrics of some outputs, and of the motion as a whole where they are wanted.
    fn some(scenario: &Scenario, motion: &Motion, modes: &[Mode], outputs: &[Output], whole: bool) -> Self {
        let Motion { model, forced, experiment, .. } = motion;
        let plane = model.plane;
        let course = Course::new(model, forced, modes, experiment.grid.duration);
        let row = |output: Output| output.row(model, forced);
        let choice = &scenario.disturbance.choices[plane];
        // Let go, in one mode and in turbulence the disturbance is there from the first.
        let start = if choice.shape().is_some() { START } else { 0.0 };
        let is_random = choice.source == Source::Turbulence;
        let steady_is_beyond = is_step(motion) && steady_is_beyond(model, modes, forced);
        let of_output = |&output: &Output| {
            let of_output = OutputMetrics::of(output, motion, modes, &course, is_random);
            if steady_is_beyond { OutputMetrics { steady: None, step: None, ..of_output } } else { of_output }
        };
        let outputs: Vec<OutputMetrics> = outputs.iter().map(of_output).collect();
        let load = match plane {
            Plane::Longitudinal => Output::NormalLoad,
            Plane::Lateral => Output::SideLoad,
        };
        let swing = || phugoid_swing(model, modes, forced, &row(Output::Height));
        let banked = || time_to_bank(&course, &row(Output::BankAngle), start);
        let anticipation = || control_anticipation(model, modes, forced, 0);
        Self {
            start,
            load_factor: outputs.iter().find(|of| of.output == load).and_then(|of| of.extreme),
            outputs,
            steady_is_beyond,
            // Of irregular air neither says anything of the aircraft.
            time_to_bank: (whole && plane == Plane::Lateral && !is_random).then(banked).flatten(),
            phugoid_swing: (whole && plane == Plane::Longitudinal && !is_random).then(swing).flatten(),
            control_anticipation: (whole && choice.source == Source::Elevator).then(anticipation).flatten(),
        }
    }
}

/// Whether a step is the disturbance.
fn is_step(motion: &Motion) -> bool {
    matches!(motion.forced.forcings.first().map(|forcing| &forcing.input), Some(Input::Step { .. }))
}

impl OutputMetrics {
    fn of(output: Output, motion: &Motion, modes: &[Mode], course: &Course<'_>, is_random: bool) -> Self {
        let Motion { model, forced, .. } = motion;
        let row = output.row(model, forced);
        let most = peak(course, &row);
        let extreme = most.map(|(time, value)| {
            let grows = course.small_until.is_some_and(|end| time >= end);
            if grows { Extreme::Beyond(value) } else { Extreme::Peak { value, time } }
        });
        let steady = match forced.forcings.first().map(|forcing| &forcing.input) {
            Some(Input::Step { amplitude, .. }) => steady_output(modes, &row, forced, 0, *amplitude),
            _ => None,
        };
        let rounding = ROUNDING * most.map_or(0.0, |(_, value)| value.abs());
        let steady = steady.map(|steady| if steady.abs() <= rounding { 0.0 } else { steady });
        let squares = || {
            let mut values = motion.values(output);
            values.truncate(motion.small_samples());
            root_mean_square(&values)
        };
        Self {
            output,
            extreme,
            steady,
            step: steady.and_then(|steady| step_metrics(model, modes, forced, &row, START, steady)),
            root_mean_square: is_random.then(squares).flatten(),
        }
    }
}

impl Extreme {
    /// The value that is a peak, and when \[s\].
    pub fn peak(self) -> Option<(f64, f64)> {
        match self {
            Self::Peak { value, time } => Some((value, time)),
            Self::Beyond(_) => None,
        }
    }
}
