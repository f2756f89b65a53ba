//! What follows under the law of feedback and with the further states of a source: modes, margins, motion and frequency response of the
//! whole, its loops cut, and the map of its damping. Where both are, they are one model.

use std::rc::Rc;

use super::frequency::FrequencyResponse;
use super::{Findings, known_map};
use crate::flight::Start;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::feedback::damping_map::{DampingMap, best_gain, least_damping};
use crate::flight::feedback::law::RATE;
use crate::flight::feedback::loop_curve::LoopCurve;
use crate::flight::feedback::loop_response::LoopResponse;
use crate::flight::feedback::loop_transfer::{LoopTransfer, closed_state_space, continuous};
use crate::flight::feedback::margins::LoopMargins;
use crate::flight::feedback::{LoopAnalysis, LoopError, analyse_loop};
use crate::flight::modes::mode::Mode;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::experiment::forced;
use crate::flight::motion::frequency_response::{FrequencyPoint, peaks};
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::transfer_function::StateSpace;
use crate::flight::verdicts::handling_qualities::{Level, Verdict};
use crate::flight::verdicts::overall_level::overall_level;
use crate::scenario::Quantity;

impl Findings {
    /// The analysis of the plane on screen under the law and with the further states of its source; `None` where nothing is fed back and
    /// there are none, or the plane has no analysis.
    pub fn closed_loop(&self) -> Option<&Result<LoopAnalysis, LoopError>> {
        self.closed_loop_of(self.scenario.plane)
    }

    /// The same of any plane.
    pub fn closed_loop_of(&self, plane: Plane) -> Option<&Result<LoopAnalysis, LoopError>> {
        let law = &self.scenario.law;
        let analysed = || {
            let open = self.analysis().as_ref().ok()?.planes[plane].as_ref()?.as_ref().ok()?;
            (!law.is_open(plane) || open.model.further.is_some())
                .then(|| analyse_loop(&open.model, law, self.scenario.task))
        };
        self.closed_loops[plane].get_or_init(analysed).as_ref()
    }

    /// The margins of the loops of both inputs of a plane, elevator or aileron first, each cut before its actuator with the other closed; `None` of one
    /// that nothing drives.
    pub fn loop_margins(&self, plane: Plane) -> &[Option<LoopMargins>; 2] {
        let of = |input: usize| {
            let closed = self.closed_loop_of(plane)?.as_ref().ok()?;
            let transfer = LoopTransfer::of(&closed.closed, input).ok()??;
            Some(LoopMargins::of(&transfer))
        };
        self.loop_margins[plane].get_or_init(|| [of(0), of(1)])
    }

    /// The modes of a plane as it flies: under the law where there is one, with the further states of the source.
    pub fn modes_in_flight<'a>(&'a self, open: &'a PlaneAnalysis) -> Vec<&'a Mode> {
        match self.closed_loop_of(open.model.plane) {
            Some(Ok(closed)) => closed.modes.iter().map(|mode| &mode.mode).collect(),
            Some(Err(_)) | None => open.modes.iter().collect(),
        }
    }

    /// The worst level of handling qualities of all planes as they fly.
    pub fn overall_level_in_flight(&self) -> Option<Level> {
        let analysis = self.analysis().as_ref().ok()?;
        let planes = analysis.planes.iter().filter_map(|plane| plane.as_ref()?.as_ref().ok());
        let judged: Vec<(&[Verdict], Vec<Mode>)> = planes
            .map(|open| {
                let levels = match self.closed_loop_of(open.model.plane) {
                    Some(Ok(closed)) => &closed.levels,
                    Some(Err(_)) | None => &open.levels,
                };
                (levels.as_slice(), self.modes_in_flight(open).into_iter().cloned().collect())
            })
            .collect();
        overall_level(judged.iter().map(|(levels, modes)| (*levels, modes.as_slice())))?.level
    }

    /// The motion in the plane on screen under the law, in the same experiment as without: `steps` between the samples.
    pub fn closed_motion_in(&self, steps: usize) -> Option<LoopResponse> {
        let closed = self.closed_loop()?.as_ref().ok()?;
        let motion = self.motion()?;
        let mut experiment = motion.experiment.clone();
        experiment.grid.steps = steps;
        Some(closed.respond(&motion.forced, &experiment))
    }

    /// The aircraft under the law from what disturbs it, in the sense in which its size counts, to an output; `None` where nothing is
    /// fed back and the source has four states.
    pub fn closed_state_space(&self, output: Output) -> Option<StateSpace> {
        let scenario = self.scenario();
        let closed = &self.closed_loop()?.as_ref().ok()?.closed;
        let unit = Input::Step { amplitude: 1.0, start: 0.0 };
        let inputs = [(scenario.driven_channel(), unit)];
        let forced = forced(&scenario.edited, &closed.model, &inputs, Start::Rest, &[]);
        let sign = Quantity::input_sign(closed.model.plane, scenario.driven_channel());
        Some(closed_state_space(closed, &forced, output, 0)?.with_sign(sign))
    }

    /// The frequency response under the law at given frequencies \[rad/s\]; `None` where nothing is fed back.
    pub fn closed_frequency_at(&self, output: Output, frequencies: &[f64]) -> Option<Vec<FrequencyPoint>> {
        let whole = self.closed_state_space(output)?;
        Some(continuous(frequencies.iter().copied(), |frequency| whole.over_frequency(frequency)))
    }

    /// The frequency response under the law, at the frequencies of [`Self::frequency`]; `None` where nothing is fed back.
    pub fn closed_frequency(&self, output: Output) -> Option<&FrequencyResponse> {
        let found = || {
            let closed = self.closed_loop()?.as_ref().ok()?;
            let whole = self.closed_state_space(output)?;
            let at = self.frequency(output)?.points.iter().map(|point| point.frequency);
            let value = |frequency: f64| whole.over_frequency(frequency);
            let points = continuous(at, value);
            let modes: Vec<Mode> = closed.modes.iter().map(|mode| mode.mode.clone()).collect();
            let is_growing = closed.dynamic_stability == Stability::Unstable;
            let peaks = if is_growing { Vec::new() } else { peaks(&value, &points, &modes) };
            Some(FrequencyResponse { points, peaks, function: whole.factored().ok() })
        };
        self.closed_frequency.get(self.index(output)?)?.get_or_init(found).as_ref()
    }

    /// The loop of an input of the plane on screen, elevator or aileron first; `None` where nothing drives it.
    pub fn loop_curve(&self, input: usize) -> Option<&LoopCurve> {
        let found = || {
            let closed = &self.closed_loop()?.as_ref().ok()?.closed;
            let margins = self.loop_margins(self.scenario.plane).get(input).copied().flatten()?;
            LoopCurve::of(closed, input, margins)
        };
        self.loop_curves.get(input)?.get_or_init(found).as_ref()
    }

    /// The input whose gain of the rate a map of the plane on screen is over: the one asked for, else the other; `None` where the rate
    /// is fed back to none.
    pub fn mapped_input(&self, asked: usize) -> Option<usize> {
        let gains = self.scenario.law.planes[self.scenario.plane].gains();
        self.closed_loop()?.as_ref().ok()?;
        [asked.min(1), 1 - asked.min(1)].into_iter().find(|&input| gains[input][RATE] != 0.0)
    }

    /// The map of the damping for gains of the rate to an input from zero to `reach`, coarse where it must not take long; the one found
    /// last where that is the same.
    pub fn damping_map(&self, input: usize, reach: f64, is_coarse: bool) -> Option<Rc<DampingMap>> {
        let of = (&self.scenario, &self.plane()?.model);
        known_map::known_or_found(&mut self.damping_map.borrow_mut(), of, (input, reach), is_coarse)
    }

    /// Judges the laws of one washout more of that map, where the aircraft has a class; whether there was one to judge.
    pub fn judge_map(&self) -> bool {
        self.plane().is_some_and(|plane| known_map::judge(&mut self.damping_map.borrow_mut(), &plane.model))
    }

    /// Damping ratio of the oscillation that the law of the plane on screen damps least, 1 where nothing oscillates.
    pub fn damping_here(&self) -> Option<f64> {
        least_damping(&self.plane()?.model, &self.scenario.law)
    }

    /// Of a range of gains of the rate to an input the one that damps best with the washout of the law, and that damping ratio.
    pub fn best_gain(&self, input: usize, range: [f64; 2]) -> Option<(f64, f64)> {
        let law = &self.scenario.law;
        best_gain(&self.plane()?.model, law, input, law.planes[self.scenario.plane].washout, range)
    }
}
