//! The numbers a course asks of a motion under a law of feedback: peaks are of the samples shown, what a step leads to is of the whole
//! motion.

use super::Findings;
use super::metrics::{Extreme, Metrics, OutputMetrics};
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::Motion;
use crate::flight::feedback::LoopAnalysis;
use crate::flight::feedback::loop_metrics::LoopStep;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response_metrics::root_mean_square;
use crate::scenario::{START, Source};

impl Findings {
    /// Metrics of the motion as it flies; without a law, [`Self::metrics`].
    pub fn flown_metrics(&self) -> Option<&Metrics> {
        match self.law_flown().filter(|flown| flown.closed.pushes_the_four()) {
            Some(closed) => {
                let metrics = || Some(self.closed_metrics(closed, self.flown_motion()?));
                self.flown_metrics.get_or_init(metrics).as_ref()
            }
            None => self.metrics(),
        }
    }

    fn closed_metrics(&self, closed: &LoopAnalysis, motion: &Motion) -> Metrics {
        let plane = motion.model.plane;
        let choice = &self.scenario.disturbance.choices[plane];
        let step = self.motion().and_then(|open| LoopStep::of(&closed.closed, &closed.modes, &open.forced));
        let is_beyond = step.as_ref().is_some_and(|step| !step.is_small);
        let step = step.filter(|step| step.is_small);
        let of_output = |&output: &Output| {
            let values = motion.values(output);
            let small = &values[..motion.small_samples().min(values.len())];
            let extreme = largest(small, motion.response.dt).map(|(time, value)| {
                let grows = motion.small_until.is_some_and(|end| time >= end);
                if grows { Extreme::Beyond(value) } else { Extreme::Peak { value, time } }
            });
            OutputMetrics {
                output,
                extreme,
                steady: step.as_ref().and_then(|step| step.steady(output)),
                step: step.as_ref().and_then(|step| step.metrics(output)),
                root_mean_square: (choice.source == Source::Turbulence)
                    .then(|| root_mean_square(small))
                    .flatten(),
            }
        };
        let outputs: Vec<OutputMetrics> = Output::of(plane).iter().map(of_output).collect();
        let load = match plane {
            Plane::Longitudinal => Output::NormalLoad,
            Plane::Lateral => Output::SideLoad,
        };
        let start = if choice.shape().is_some() { START } else { 0.0 };
        Metrics {
            start,
            load_factor: outputs.iter().find(|of| of.output == load).and_then(|of| of.extreme),
            time_to_bank: (plane == Plane::Lateral && choice.source != Source::Turbulence)
                .then(|| banked(motion, start))
                .flatten(),
            outputs,
            steady_is_beyond: is_beyond,
            phugoid_swing: None,
            control_anticipation: None,
        }
    }
}

/// Time \[s\] and value farthest from zero of samples, with the vertex of the parabola about it.
fn largest(values: &[f64], dt: f64) -> Option<(f64, f64)> {
    let k = (0..values.len()).max_by(|&i, &j| values[i].abs().total_cmp(&values[j].abs()).then(j.cmp(&i)))?;
    let at = values[k];
    let (Some(before), Some(after)) = (k.checked_sub(1).map(|k| values[k]), values.get(k + 1)) else {
        return Some((k as f64 * dt, at));
    };
    let (slope, bend) = (0.5 * (after - before), after - 2.0 * at + before);
    // A jump on one side has no vertex.
    let is_smooth = (after - at).abs().max((at - before).abs()) < 0.05 * at.abs();
    if bend == 0.0 || !is_smooth {
        return Some((k as f64 * dt, at));
    }
    let shift = -slope / bend;
    Some(((k as f64 + shift) * dt, at + 0.5 * slope * shift))
}

/// Time after `start` at which the bank angle first is 30° either way \[s\], between the samples.
fn banked(motion: &Motion, start: f64) -> Option<f64> {
    let bank = motion.values(Output::BankAngle);
    let limit = std::f64::consts::FRAC_PI_6;
    let k = bank.iter().take(motion.small_samples()).position(|phi| phi.abs() >= limit)?;
    let before = k.checked_sub(1).map_or(bank[k], |k| bank[k]);
    let share = if k == 0 { 0.0 } else { (limit - before.abs()) / (bank[k].abs() - before.abs()) };
    Some((k.saturating_sub(1) as f64 + share) * motion.response.dt - start)
}
