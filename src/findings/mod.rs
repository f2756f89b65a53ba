//! Everything that follows from a scenario, in one place: each result is found once, when it is first asked for.
//!
//! Page, command line, JSON and JavaScript read the same [`Findings`], so that none of them can say something else than another.
//!
//! | file | in one line |
//! |---|---|
//! | [`chart`] | a measure over the range of a slider |
//! | `charting` | the same, found |
//! | [`change`] | what a change of the aircraft did to each mode, and by which derivatives |
//! | `closed_loop` | modes, margins, motion and loops under the law of feedback |
//! | [`equations`] | A and B entry by entry, what they are made of, the characteristic polynomial |
//! | `least_gain` | the least gain that reaches a level of handling qualities |
//! | `existing_range` | the part of a slider's range in which there is such a flight |
//! | `sensitivities` | how strongly each parameter moves each mode |
//! | `loop_sensitivities` | the same under a law, and to its gains |
//! | `locus` | the path along which a parameter sends the poles |
//! | `loop_placement` | the model whose gains bring a pole to a place |
//! | `placement` | which parameters bring a pole to a place, and why no further |
//! | `time_shown` | the time in which the slowest visible mode is seen |
//! | `trajectory` | the aircraft at one moment of its motion |
//! | `metrics` | the numbers a course asks of a motion |
//! | [`measures`] | the one table of what can be read, by key |
//! | `flown` | the aircraft as it flies, under the law or with the loop shown open |
//! | `flown_metrics` | the numbers a course asks of a motion under the law |
//! | `known_map` | the map of the damping over gain and washout |
//! | `frequency` | gain, phase and peaks over frequency |

pub mod change;
pub mod chart;
mod charting;
mod closed_loop;
pub mod equations;
mod existing_range;
mod flown;
mod flown_metrics;
mod frequency;
mod known_map;
mod least_gain;
mod locus;
mod loop_placement;
mod loop_sensitivities;
pub mod measures;
mod metrics;
mod placement;
mod sensitivities;
mod time_shown;
mod trajectory;

use std::cell::{OnceCell, RefCell};
use std::ops::RangeInclusive;
use std::rc::Rc;

use thiserror::Error;

use crate::flight::aircraft::aircraft_model::AircraftModel;
use crate::flight::aircraft::coefficients::Coefficients;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::flight::analysis::{GravityCheck, Motion, PlaneAnalysis, analyse_at_rest, motion};
use crate::flight::feedback::loop_curve::LoopCurve;
use crate::flight::feedback::loop_flight::{Beside, fly_closed};
use crate::flight::feedback::margins::LoopMargins;
use crate::flight::feedback::{LoopAnalysis, LoopError};
use crate::flight::modes::locus::Locus;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::experiment::fly;
use crate::flight::motion::flight_path::FlightPath;
use crate::flight::motion::frequency_response::frequency_range;
use crate::flight::motion::modal_decomposition::{ModalDecomposition, SplitError};
use crate::flight::motion::outputs::Output;
use crate::flight::motion::six_dof::{SixDof, SixDofError};
use crate::flight::verdicts::level_boundaries::{Boundary, level_boundaries};
use crate::flight::{Analysis, AnalysisError, Experiment};
use crate::key::Keyed as _;
use crate::scenario::{Page, Parameter, Scenario};

pub use chart::MeasureChart;
pub use equations::Equations;
pub use frequency::FrequencyResponse;
pub use least_gain::{LeastGain, NoLeastGain};
pub use metrics::{Extreme, Metrics, OutputMetrics};
pub use placement::{Obstacle, Placed, PlacementError};
pub use sensitivities::{RowSensitivity, by_strength};
pub use time_shown::{seen_in, watched_at};
pub use trajectory::{MomentArrow, Pose, Trajectory};

/// A scenario with everything that follows from it.
#[derive(Debug)]
pub struct Findings {
    scenario: Scenario,
    analysis: OnceCell<Result<Analysis, AnalysisError>>,
    /// One a page of sliders.
    sensitivities: [OnceCell<Vec<RowSensitivity>>; Page::VALUES.len()],
    /// Likewise.
    existing: [OnceCell<Vec<existing_range::Of>>; Page::VALUES.len()],
    coefficients: OnceCell<Option<Coefficients>>,
    level_boundaries: OnceCell<Vec<Boundary>>,
    flight: OnceCell<Option<Result<FlightPath, SixDofError>>>,
    splits: OfOutputs<Result<ModalDecomposition, SplitError>>,
    frequency: OfOutputs<FrequencyResponse>,
    equations: OnceCell<Option<Equations>>,
    metrics: OnceCell<Option<Metrics>>,
    time_to_see: OnceCell<Option<f64>>,
    locus: RefCell<Option<locus::Known>>,
    chart: RefCell<Option<chart::Known>>,
    closed_loops: ByPlane<OnceCell<Option<Result<LoopAnalysis, LoopError>>>>,
    unfed: ByPlane<OnceCell<Option<LoopAnalysis>>>,
    loop_margins: ByPlane<OnceCell<[Option<LoopMargins>; 2]>>,
    /// Whether the loop is shown open.
    is_opened: bool,
    flown: ByPlane<OnceCell<Option<PlaneAnalysis>>>,
    flown_motion: OnceCell<Option<Motion>>,
    flown_metrics: OnceCell<Option<Metrics>>,
    /// Of either input of the plane on screen.
    loop_curves: [OnceCell<Option<LoopCurve>>; 2],
    damping_map: RefCell<Option<known_map::KnownMap>>,
    closed_frequency: OfOutputs<FrequencyResponse>,
}

/// A result for each output of the plane on screen, `None` where nothing moves; in the order of [`Output::of`].
type OfOutputs<T> = Vec<OnceCell<Option<T>>>;

/// Why nothing follows for the plane on screen.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Problem {
    /// It can't be analysed.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// The aircraft's source says nothing of it.
    #[error("the source has no data for this plane of motion")]
    NoData,
}

/// Something that a person should know before they believe the numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remark {
    /// Gravity and speed of the model can't belong to one system of units.
    MixedUnits(GravityCheck),
}

impl Findings {
    /// The findings of a scenario; nothing is computed yet.
    pub fn of(scenario: Scenario) -> Self {
        let outputs = Output::of(scenario.plane).len();
        Self {
            scenario,
            analysis: OnceCell::new(),
            sensitivities: Default::default(),
            existing: Default::default(),
            coefficients: OnceCell::new(),
            level_boundaries: OnceCell::new(),
            flight: OnceCell::new(),
            splits: std::iter::repeat_with(OnceCell::new).take(outputs).collect(),
            frequency: std::iter::repeat_with(OnceCell::new).take(outputs).collect(),
            equations: OnceCell::new(),
            metrics: OnceCell::new(),
            time_to_see: OnceCell::new(),
            locus: RefCell::default(),
            chart: RefCell::default(),
            closed_loops: ByPlane::default(),
            unfed: ByPlane::default(),
            loop_margins: ByPlane::default(),
            is_opened: false,
            flown: ByPlane::default(),
            flown_motion: OnceCell::new(),
            flown_metrics: OnceCell::new(),
            loop_curves: Default::default(),
            damping_map: RefCell::default(),
            closed_frequency: std::iter::repeat_with(OnceCell::new).take(outputs).collect(),
        }
    }

    /// The same with the loop shown open: what [flies](Self::flown) is the aircraft without its law.
    pub fn opened(self, is_opened: bool) -> Self {
        Self {
            is_opened,
            flown: ByPlane::default(),
            flown_motion: OnceCell::new(),
            flown_metrics: OnceCell::new(),
            flight: OnceCell::new(),
            chart: RefCell::default(),
            ..self
        }
    }

    /// Whether the loop is shown open.
    pub fn is_opened(&self) -> bool {
        self.is_opened
    }

    /// The findings of a scenario that has come out of this one by an edit: a locus, a map and a chart are found again only if they are
    /// others.
    pub fn after(&self, scenario: Scenario) -> Self {
        let (locus, damping_map, chart) = (self.locus.clone(), self.damping_map.clone(), self.chart.clone());
        Self { locus, damping_map, chart, ..Self::of(scenario) }
    }

    /// The findings of a scenario in which nothing moves: where many are compared by their modes.
    fn at_rest(scenario: Scenario) -> Self {
        let analysis = analyse_at_rest(&scenario.edited, scenario.task);
        Self { analysis: OnceCell::from(analysis), ..Self::of(scenario) }
    }

    /// The findings of a scenario of whose motion only one output is wanted: where many are compared by it.
    fn of_one_output(scenario: Scenario, output: Output) -> Self {
        let findings = Self::of(scenario);
        let metrics = findings
            .motion()
            .map(|motion| Metrics::of_one(&findings.scenario, motion, findings.modes(), output));
        Self { metrics: OnceCell::from(metrics), ..findings }
    }

    /// The scenario that all of it follows from.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The analysis of both planes and the motion in the plane on screen.
    pub fn analysis(&self) -> &Result<Analysis, AnalysisError> {
        self.analysis.get_or_init(|| self.scenario.analyse())
    }

    /// Whether the analysis has been asked for.
    pub fn is_analysed(&self) -> bool {
        self.analysis.get().is_some()
    }

    /// The analysis of the plane on screen, where all went well.
    pub fn plane(&self) -> Option<&PlaneAnalysis> {
        self.analysis().as_ref().ok()?.planes[self.scenario.plane].as_ref()?.as_ref().ok()
    }

    /// Why there is no analysis of the plane on screen.
    pub fn problem(&self) -> Option<Problem> {
        match self.analysis() {
            Err(error) => Some(error.clone().into()),
            Ok(analysis) => match &analysis.planes[self.scenario.plane] {
                Some(Ok(_)) => None,
                Some(Err(error)) => Some(error.clone().into()),
                None => Some(Problem::NoData),
            },
        }
    }

    /// The modes of the plane on screen; none where it has no analysis.
    pub fn modes(&self) -> &[Mode] {
        self.plane().map_or(&[], |plane| &plane.modes)
    }

    /// The first mode that grows, if one does: then a motion has no steady value and a sine no steady answer.
    pub fn growing_mode(&self) -> Option<&Mode> {
        self.flown_modes().iter().find(|mode| mode.stability == Stability::Unstable)
    }

    /// The motion in the plane on screen.
    pub fn motion(&self) -> Option<&Motion> {
        self.analysis().as_ref().ok()?.motion.as_ref()
    }

    /// The ground in heights gained on the steady flight \[m\], where the motion goes below it while it is small: the altitude of the
    /// case counts from sea level, and the linear model knows no ground.
    pub fn ground(&self) -> Option<f64> {
        let motion = self.flown_motion().filter(|motion| motion.model.plane == Plane::Longitudinal)?;
        let Scenario { edited, aircraft, .. } = &self.scenario;
        let altitude = match &edited.aircraft_model {
            AircraftModel::Coefficients(model) => model.condition.altitude,
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => aircraft.particulars.altitude?,
        };
        let heights = motion.values(Output::Height);
        let lowest = heights.iter().take(motion.small_samples()).copied().fold(0.0, f64::min);
        // The lift of the elevator itself takes it down by millimetres before it climbs.
        (lowest < -altitude - 1.0).then_some(-altitude)
    }

    /// The same motion at other samples: `steps` between them, one less than their number.
    pub fn motion_in(&self, steps: usize) -> Option<Motion> {
        Some(motion(&self.scenario.edited, self.plane()?, &self.experiment_in(steps)?))
    }

    /// The nonlinear flight through the same disturbance, or why there is none.
    pub fn flight(&self) -> Option<&Result<FlightPath, SixDofError>> {
        let flight = || self.flight_in(self.motion()?.experiment.grid.steps);
        self.flight.get_or_init(flight).as_ref()
    }

    /// Whether there is a nonlinear flight, without flying it.
    pub fn can_fly(&self) -> bool {
        self.plane().is_some() && SixDof::new(&self.scenario.edited).is_ok()
    }

    /// The same flight at other samples: `steps` between them. A law moves the controls, of both planes.
    pub fn flight_in(&self, steps: usize) -> Option<Result<FlightPath, SixDofError>> {
        let PlaneAnalysis { model, modes, .. } = self.plane()?;
        let Scenario { edited, law, aircraft, .. } = &self.scenario;
        let experiment = self.experiment_in(steps)?;
        if self.is_opened || Plane::ALL.into_iter().all(|plane| law.is_open(plane)) {
            return Some(fly(edited, model, modes, &experiment));
        }
        let closed = self.law_flown();
        Some(fly_closed(edited, law, &aircraft.limits, Beside { model, modes, closed }, &experiment))
    }

    fn experiment_in(&self, steps: usize) -> Option<Experiment> {
        let mut experiment = self.motion()?.experiment.clone();
        experiment.grid.steps = steps;
        Some(experiment)
    }

    /// An output of the motion split into the parts of the modes.
    pub fn split(&self, output: Output) -> Option<&Result<ModalDecomposition, SplitError>> {
        let split = || Some(self.motion()?.split(self.modes(), output));
        self.splits.get(self.index(output)?)?.get_or_init(split).as_ref()
    }

    /// The place of an output among those of the plane on screen.
    fn index(&self, output: Output) -> Option<usize> {
        Output::of(self.scenario.plane).iter().position(|other| *other == output)
    }

    /// The coefficients as knobs and flight condition make them; `None` where the source has none or there is no such flight.
    pub fn coefficients(&self) -> Option<&Coefficients> {
        let derived = || match &self.scenario.edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => Some(aircraft_model.derive().ok()?.coefficients),
            AircraftModel::Derivatives(_) | AircraftModel::Matrices(_) => None,
        };
        self.coefficients.get_or_init(derived).as_ref()
    }

    /// The sensitivities of the [flown modes](Self::flown_modes) to every parameter on a page that the aircraft has; none where the plane
    /// has no analysis.
    pub fn sensitivities(&self, page: Page) -> &[RowSensitivity] {
        self.sensitivities[page as usize].get_or_init(|| match self.plane() {
            None => Vec::new(),
            // While the loop is shown open no gain does anything.
            Some(_) if page == Page::Feedback && self.is_opened && self.closed_loop().is_some() => Vec::new(),
            Some(_) if page == Page::Feedback || self.law_flown().is_some() => {
                loop_sensitivities::of_page(&self.scenario, self.flown_modes(), self.law_flown(), page)
            }
            Some(plane) => sensitivities::of_page(&self.scenario, plane, page),
        })
    }

    /// The part of a slider's range \[SI\] in which there is such an aircraft and such a flight, with all else as it is; `None` where
    /// it is all of it, or none.
    pub fn existing_range(&self, parameter: &Parameter) -> Option<RangeInclusive<f64>> {
        let page = parameter.page?;
        let of_page =
            self.existing[page as usize].get_or_init(|| existing_range::of_page(&self.scenario, page));
        of_page.iter().find(|(key, _)| *key == parameter.key).map(|(_, range)| range.clone())
    }

    /// The path of the poles along the whole range of a parameter's slider, wherever along it the parameter is.
    pub fn locus(&self, parameter: &'static Parameter) -> Rc<Locus> {
        let is_closed = parameter.page == Some(Page::Feedback) || self.law_flown().is_some();
        locus::known_or_found(&mut self.locus.borrow_mut(), &self.scenario, parameter, is_closed)
    }

    /// The equations of the plane on screen, as one would write them on a board.
    pub fn equations(&self) -> Option<&Equations> {
        let of = |plane| Equations::of(&self.scenario.edited, plane, self.scenario.convention());
        self.equations.get_or_init(|| self.plane().map(of)).as_ref()
    }

    /// Metrics of the motion; `None` where nothing moves.
    pub fn metrics(&self) -> Option<&Metrics> {
        let metrics = || Some(Metrics::of(&self.scenario, self.motion()?, self.modes()));
        self.metrics.get_or_init(metrics).as_ref()
    }

    /// Angular frequencies around the modes \[rad/s\], from and to, on whole decades.
    pub fn frequency_range(&self) -> (f64, f64) {
        frequency_range(self.modes())
    }

    /// The frequency response of an output to a unit of what disturbs, over [`Self::frequency_range`].
    pub fn frequency(&self, output: Output) -> Option<&FrequencyResponse> {
        let response = || self.frequency_over(output, self.frequency_range(), frequency::POINTS);
        self.frequency.get(self.index(output)?)?.get_or_init(response).as_ref()
    }

    /// The same at `count` frequencies between others \[rad/s\].
    pub fn frequency_over(
        &self,
        output: Output,
        range: (f64, f64),
        count: usize,
    ) -> Option<FrequencyResponse> {
        Some(FrequencyResponse::of(&self.scenario, self.plane()?, output, range, count))
    }

    /// The limits of the handling-quality levels in the complex plane; none where the aircraft has no class.
    pub fn level_boundaries(&self) -> &[Boundary] {
        self.level_boundaries.get_or_init(|| {
            let judged = self.scenario.task.zip(self.flown());
            judged.map_or_else(Vec::new, |(task, plane)| level_boundaries(&plane.model, &plane.modes, task))
        })
    }

    /// Remarks that a person should know before they believe the numbers.
    pub fn remarks(&self) -> Vec<Remark> {
        let gravity = self.analysis().as_ref().ok().and_then(|analysis| analysis.gravity);
        gravity.filter(|gravity| !gravity.is_plausible()).map(Remark::MixedUnits).into_iter().collect()
    }
}
