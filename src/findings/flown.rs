//! The aircraft as it flies and as it is shown: under its law of feedback, unless nothing is fed back or the loop is shown open, and with
//! the further states of its source.

use super::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::{Motion, PlaneAnalysis, small_until};
use crate::flight::feedback::loop_split::split_closed;
use crate::flight::feedback::{Law, LoopAnalysis, LoopError, analyse_loop};
use crate::flight::modes::mode::Mode;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::modal_decomposition::{ModalDecomposition, SplitError};
use crate::flight::motion::outputs::Output;
use crate::flight::verdicts::overall_level::{OverallLevel, overall_level};

impl Findings {
    /// The analysis of the plane on screen under its law and with the further states of its source, where it is that which is shown.
    pub fn law_flown(&self) -> Option<&LoopAnalysis> {
        self.law_flown_of(self.scenario.plane)
    }

    fn law_flown_of(&self, plane: Plane) -> Option<&LoopAnalysis> {
        if self.is_opened { self.unfed_of(plane) } else { self.closed_loop_of(plane)?.as_ref().ok() }
    }

    /// The same with all gains at zero; `None` where the source has no further states.
    fn unfed_of(&self, plane: Plane) -> Option<&LoopAnalysis> {
        let analysed = || {
            let open = self.analysis().as_ref().ok()?.planes[plane].as_ref()?.as_ref().ok()?;
            open.model.further.as_ref()?;
            analyse_loop(&open.model, &Law::default(), self.scenario.task).ok()
        };
        self.unfed[plane].get_or_init(analysed).as_ref()
    }

    /// Whether the four states of the plane on screen fly otherwise than alone: under a law, or pushed by further states.
    pub fn flies_otherwise(&self) -> bool {
        self.law_flown().is_some_and(|flown| flown.closed.pushes_the_four())
    }

    /// Whether a law moves the plane on screen as it is shown.
    pub fn is_fed_back(&self) -> bool {
        self.law_flown().is_some_and(|flown| flown.closed.is_fed_back())
    }

    /// The level of handling qualities of all planes as they fly, with the criterion that governs it.
    pub fn flown_level(&self) -> Option<OverallLevel<'_>> {
        let planes = Plane::ALL.into_iter().filter_map(|plane| self.flown_of(plane));
        overall_level(planes.map(|plane| (plane.levels.as_slice(), plane.modes.as_slice())))
    }

    /// Why nothing follows under the law.
    pub fn loop_problem(&self) -> Option<&LoopError> {
        self.closed_loop()?.as_ref().err()
    }

    /// The analysis of the plane on screen as it flies: modes, dynamic stability and levels are those under the law; static stability
    /// and approximations are of the aircraft alone.
    pub fn flown(&self) -> Option<&PlaneAnalysis> {
        self.flown_of(self.scenario.plane)
    }

    fn flown_of(&self, plane: Plane) -> Option<&PlaneAnalysis> {
        let open = self.analysis().as_ref().ok()?.planes[plane].as_ref()?.as_ref().ok()?;
        let under_law = || {
            let closed = self.law_flown_of(plane)?;
            Some(PlaneAnalysis {
                model: open.model.clone(),
                modes: closed.modes.iter().map(|mode| mode.mode.clone()).collect(),
                dynamic_stability: closed.dynamic_stability,
                static_stability: open.static_stability,
                approximations: open.approximations.clone(),
                levels: closed.levels.clone(),
            })
        };
        self.flown[plane].get_or_init(under_law).as_ref().or(Some(open))
    }

    /// The modes of the plane on screen as it flies; none where it has no analysis.
    pub fn flown_modes(&self) -> &[Mode] {
        self.flown().map_or(&[], |plane| &plane.modes)
    }

    /// The poles of the state that is not shown: those without the law, or without the further states, where they fly; those under the law
    /// where the loop is shown open.
    pub fn poles_of_other(&self) -> Vec<&Mode> {
        let Some(Ok(closed)) = self.closed_loop() else { return Vec::new() };
        if self.is_opened {
            return if closed.closed.is_fed_back() { whole(closed) } else { Vec::new() };
        }
        match (
            closed.closed.is_fed_back().then(|| self.unfed_of(self.scenario.plane)).flatten(),
            self.plane(),
        ) {
            (Some(unfed), _) => whole(unfed),
            (None, Some(open)) if closed.closed.pushes_the_four() => open.modes.iter().collect(),
            _ => Vec::new(),
        }
    }

    /// The motion in the plane on screen as it flies.
    pub fn flown_motion(&self) -> Option<&Motion> {
        let under_law = || self.motion_under_law(self.motion()?.experiment.grid.steps);
        self.flown_motion.get_or_init(under_law).as_ref().or_else(|| self.motion())
    }

    /// The same motion at other samples: `steps` between them, one less than their number.
    pub fn flown_motion_in(&self, steps: usize) -> Option<Motion> {
        self.motion_under_law(steps).or_else(|| self.motion_in(steps))
    }

    /// An output of the motion as it flies, split into the parts of the modes as they fly.
    pub fn flown_split(&self, output: Output) -> Option<Result<ModalDecomposition, SplitError>> {
        let Some(closed) = self.law_flown() else { return self.split(output).cloned() };
        let motion = self.flown_motion()?;
        let whole = self.closed_motion_in(motion.experiment.grid.steps)?;
        let row = output.row(&motion.model, &motion.forced);
        Some(split_closed(closed, &row, &motion.forced.path, &whole.states, &motion.values(output)))
    }

    /// The motion under the law: the aircraft's own equations with its controls moved as the law moves them, exact at the samples.
    fn motion_under_law(&self, steps: usize) -> Option<Motion> {
        let closed = &self.law_flown()?.closed;
        let (response, open) = (self.closed_motion_in(steps)?, self.motion()?);
        let mut experiment = open.experiment.clone();
        experiment.grid.steps = steps;
        let moved = |input: usize| response.controls.iter().map(|controls| controls[input]).collect();
        let inputs = [0, 1].map(|input| Input::Samples { dt: response.dt, values: moved(input) });
        let further = |k: usize| {
            let values = response.states.iter().map(|x| x[4 + k]).collect();
            Input::Samples { dt: response.dt, values }
        };
        let four = response.as_of_aircraft();
        Some(Motion {
            small_until: small_until(&open.model, &four),
            model: open.model.clone(),
            experiment,
            forced: closed.with_courses(&open.forced, inputs.clone(), further),
            response: four,
            by_law: closed.is_fed_back().then_some(inputs),
        })
    }
}

/// The modes of all states.
fn whole(analysis: &LoopAnalysis) -> Vec<&Mode> {
    analysis.modes.iter().map(|mode| &mode.mode).collect()
}
