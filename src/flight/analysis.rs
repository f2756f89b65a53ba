//! The one entry point: everything that follows from an edited study and an experiment.

use thiserror::Error;

use super::aircraft::aircraft_model::{AircraftModel, ModelError, Models, TrimmedModel};
use super::aircraft::axes::StabilityAxes;
use super::aircraft::edits::{EditedModel, Offsets};
use super::aircraft::plane::{ByPlane, Plane, PlaneModel};
use super::aircraft::states::Longitudinal::{Theta, U};
use super::aircraft::states::entry;
use super::modes::approximations::{Approximation, DownwashLag, approximations};
use super::modes::eigen::EigenError;
use super::modes::mode::{Mode, modes};
use super::motion::experiment::{Experiment, forced};
use super::motion::inputs::Input;
use super::motion::modal_decomposition::{ModalDecomposition, SplitError, modal_decomposition};
use super::motion::outputs::Output;
use super::motion::response::{DrivenSystem, Response, respond};
use super::motion::small_disturbance::{SmallLimit, outgrown};
use super::verdicts::handling_qualities::{Verdict, handling_qualities};
use super::verdicts::overall_level::{OverallLevel, overall_level};
use super::verdicts::static_stability::{
    PlaneStaticStability, manoeuvre_margin, plane_static_stability, static_margin,
};
use super::verdicts::task::Task;
use crate::flight::modes::stability::Stability;

/// Standard acceleration of free fall g \[m/s²\] (CGPM 1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Gravity in the model beside gravity at the Earth's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GravityCheck {
    /// g cos θ₀ / U₀ of the model \[1/s\]; free of any unit of length.
    pub rate: f64,
    /// The rate with standard gravity at the same speed \[1/s\].
    pub expected_rate: f64,
}

impl GravityCheck {
    /// Whether gravity and speed can belong to one system of units.
    ///
    /// Feet taken for metres are a factor of 3.28 apart; a climb at 45° is a factor of 0.71. Two either way
    /// lets every steady flight path through and no confusion of units.
    pub fn is_plausible(&self) -> bool {
        (0.5..=2.0).contains(&(self.rate / self.expected_rate))
    }
}

/// Everything that follows for one plane of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneAnalysis {
    /// The model.
    pub model: PlaneModel,
    /// The modes in the order of their names, each conjugate pair once.
    pub modes: Vec<Mode>,
    /// The verdict on the whole: that of its worst mode.
    pub dynamic_stability: Stability,
    /// Static stability, a verdict of its own.
    pub static_stability: PlaneStaticStability,
    /// Textbook approximations beside the exact modes.
    pub approximations: Vec<Approximation>,
    /// Handling qualities after MIL-F-8785C, where the aircraft has a class.
    pub levels: Vec<Verdict>,
}

/// Margins of longitudinal static stability, in mean chords.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// Static margin H_n = −Cm_α/C_Lα: the neutral point behind the centre of gravity.
    pub static_margin: f64,
    /// Manoeuvre margin H_m: the manoeuvre point behind the centre of gravity.
    pub manoeuvre_margin: f64,
}

/// The motion in an experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// The model that moves.
    pub model: PlaneModel,
    /// The experiment that it is put through.
    pub experiment: Experiment,
    /// Its equations with all that drives them.
    pub forced: DrivenSystem,
    /// The states.
    pub response: Response,
    /// Time \[s\] from which the motion is no small disturbance any more: the linear answer is still that of the equations, but no
    /// longer that of the aircraft.
    pub small_until: Option<f64>,
    /// What a law of feedback moves each control by, which `forced` has too; `None` without one.
    pub by_law: Option<[Input; 2]>,
}

impl Motion {
    /// Values of an output at the samples.
    pub fn values(&self, output: Output) -> Vec<f64> {
        output.row(&self.model, &self.forced).of(&self.forced, &self.response).collect()
    }

    /// How many samples, from the first, are of a small disturbance, and the one after.
    pub fn small_samples(&self) -> usize {
        let Response { states, dt, .. } = &self.response;
        self.small_until.map_or(states.len(), |time| (time / dt).round() as usize + 1)
    }

    /// The limit that the motion has passed when it is no small disturbance any more.
    pub fn outgrown(&self) -> Option<SmallLimit> {
        self.small_until?;
        self.response.states.iter().find_map(|x| outgrown(&self.model, x))
    }

    /// The same split into the parts of the modes of this model.
    pub fn split(&self, modes: &[Mode], output: Output) -> Result<ModalDecomposition, SplitError> {
        modal_decomposition(modes, &output.row(&self.model, &self.forced), &self.forced, &self.response)
    }
}

/// Everything that follows from an edited study and an experiment. Nothing here is saved: it can always be had again.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// Motion in each plane, or why there is none; `None` where the aircraft has no data of it.
    pub planes: ByPlane<Option<Result<PlaneAnalysis, AnalysisError>>>,
    /// How far the neutral and the manoeuvre point lie behind the centre of gravity, where coefficients say so.
    pub margins: Option<Margins>,
    /// Gravity beside speed, to catch mixed units; of the longitudinal model.
    pub gravity: Option<GravityCheck>,
    /// The motion in the experiment, where its plane has a model.
    pub motion: Option<Motion>,
}

impl Analysis {
    /// The level of handling qualities as a whole, of the planes that could be analysed; `None` where nothing is judged.
    pub fn overall_level(&self) -> Option<OverallLevel<'_>> {
        let analysed = self.planes.iter().filter_map(|plane| plane.as_ref()?.as_ref().ok());
        overall_level(analysed.map(|plane| (plane.levels.as_slice(), plane.modes.as_slice())))
    }
}

/// Why something can't be analysed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AnalysisError {
    /// There is no such aircraft or no such steady flight.
    AircraftModel(#[from] ModelError),
    /// The eigenvalues could not be had.
    Eigen(#[from] EigenError),
    /// The trim speed is not a positive number.
    TrimSpeed(f64),
}

/// Analyses one aircraft in one experiment. Pure and total: equal arguments give equal answers; what can't be analysed is an
/// error with a sentence, and leaves the other plane alone.
pub fn analyse(
    edited: &EditedModel,
    task: Option<Task>,
    experiment: &Experiment,
) -> Result<Analysis, AnalysisError> {
    let mut analysis = analyse_at_rest(edited, task)?;
    if let Some(Ok(disturbed)) = &analysis.planes[experiment.plane] {
        analysis.motion = Some(motion(edited, disturbed, experiment));
    }
    Ok(analysis)
}

/// The same without a motion: where many aircraft are compared by their modes.
pub fn analyse_at_rest(edited: &EditedModel, task: Option<Task>) -> Result<Analysis, AnalysisError> {
    let Models { mut planes, problems } = edited.models()?;
    let gravity = planes.longitudinal.as_ref().and_then(gravity_check);
    let problem = |plane: Plane| problems.iter().copied().find(|problem| problem.plane() == Some(plane));
    Ok(Analysis {
        planes: ByPlane::from_fn(|plane| match planes[plane].take() {
            Some(model) => Some(analyse_plane(model, edited, task)),
            None => problem(plane).map(|problem| Err(problem.into())),
        }),
        margins: margins(edited),
        gravity,
        motion: None,
    })
}

fn analyse_plane(
    model: PlaneModel,
    edited: &EditedModel,
    task: Option<Task>,
) -> Result<PlaneAnalysis, AnalysisError> {
    let speed = model.trim.speed;
    if !(speed.is_finite() && speed > 0.0) {
        return Err(AnalysisError::TrimSpeed(speed));
    }
    let modes = modes(&model)?;
    let stability_axes = StabilityAxes::of(&model);
    let derivatives = edited.derivatives_behind(model.plane);
    let lag = DownwashLag::of(edited.derivatives().ok().flatten().as_ref());
    Ok(PlaneAnalysis {
        dynamic_stability: modes.iter().map(|mode| mode.stability).max().unwrap_or_default(),
        static_stability: plane_static_stability(&stability_axes, derivatives.as_ref()),
        approximations: approximations(&stability_axes, lag, &modes),
        levels: task.map_or_else(Vec::new, |task| handling_qualities(&model, &modes, task)),
        modes,
        model,
    })
}

/// The motion of an analysed plane in an experiment.
pub fn motion(edited: &EditedModel, disturbed: &PlaneAnalysis, experiment: &Experiment) -> Motion {
    let PlaneAnalysis { model, modes, .. } = disturbed;
    let forced = forced(edited, model, &experiment.inputs, experiment.start, modes);
    let response = respond(&forced, experiment.grid);
    Motion {
        small_until: small_until(model, &response),
        model: model.clone(),
        experiment: experiment.clone(),
        forced,
        response,
        by_law: None,
    }
}

/// When a motion is first seen not to be small; `None` if it never is.
pub(crate) fn small_until(model: &PlaneModel, response: &Response) -> Option<f64> {
    let k = response.states.iter().position(|x| outgrown(model, x).is_some())?;
    Some(k as f64 * response.dt)
}

/// Margins of an aircraft given by coefficients, unless its derivatives have been edited apart from them.
fn margins(edited: &EditedModel) -> Option<Margins> {
    let AircraftModel::Coefficients(aircraft_model) = &edited.aircraft_model else { return None };
    let untouched = Offsets::default();
    if edited.offsets.longitudinal != untouched.longitudinal
        || edited.offsets.matrices.longitudinal != untouched.matrices.longitudinal
    {
        return None;
    }
    let TrimmedModel { flight, airframe, coefficients, .. } = aircraft_model.derive().ok()?;
    let c = coefficients.longitudinal;
    let static_margin = static_margin(c.cm_alpha, c.cl_alpha)?;
    let manoeuvre_margin =
        manoeuvre_margin(static_margin, c.cm_q, flight.density, airframe.s, airframe.c, airframe.mass)?;
    Some(Margins { static_margin, manoeuvre_margin })
}

fn gravity_check(model: &PlaneModel) -> Option<GravityCheck> {
    // The u row of A carries −g cos θ₀ in the θ column.
    let u0 = model.trim.u0();
    let check = GravityCheck { rate: -entry(&model.a, U, Theta) / u0, expected_rate: STANDARD_GRAVITY / u0 };
    check.rate.is_finite().then_some(check)
}
