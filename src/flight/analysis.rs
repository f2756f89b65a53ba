//! The one entry point: everything that follows from a model and an experiment.

use nalgebra::Vector4;
use thiserror::Error;

use super::eigen::EigenError;
use super::inputs::Input;
use super::linear::{Longitudinal, LongitudinalModel};
use super::modes::{DynamicStability, Mode, modes_of};
use super::plane::Plane;
use super::response::{Response, TimeGrid, respond};
use super::static_stability::{StaticStability, static_stability};

/// Standard acceleration of free fall g \[m/s²\] (CGPM 1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Where a disturbance enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Elevator deflection \[rad\], trailing edge down positive.
    Elevator,
    /// Vertical gust w_g \[m/s\], downward positive, through −A\[:, w\].
    VerticalGust,
}

/// One disturbance and the time for which it is watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// Where the disturbance enters.
    pub channel: Channel,
    /// Its shape in time.
    pub input: Input,
    /// The samples at which the motion is wanted.
    pub grid: TimeGrid,
}

/// Gravity in the model beside gravity at the Earth's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GravityCheck {
    /// g cos θ₀ / U₀ of the model \[1/s\]; free of any unit of length.
    pub rate: f64,
    /// What it would be with standard gravity at the same speed \[1/s\].
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

/// Everything that follows from a model and an experiment. Nothing here is saved: it can always be had again.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// The modes, short period first, each conjugate pair once.
    pub modes: Vec<Mode>,
    /// The verdict on the whole: that of its worst mode.
    pub dynamic_stability: DynamicStability,
    /// Static stability, a verdict of its own.
    pub static_stability: StaticStability,
    /// Gravity beside speed, to catch mixed units.
    pub gravity: GravityCheck,
    /// The motion in the experiment.
    pub response: Response,
    /// Time \[s\] from which the motion is no small disturbance any more, so that the linear model means nothing.
    pub small_until: Option<f64>,
}

/// Why a model can't be analysed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AnalysisError {
    /// The eigenvalues could not be had.
    #[error(transparent)]
    Eigen(#[from] EigenError),
    /// The trim speed is not a positive number.
    #[error("the trim speed must be a positive number, not {0} m/s")]
    TrimSpeed(f64),
}

/// Analyses one aircraft in one experiment. Pure and total: equal arguments give equal answers, and what can't
/// be analysed is an error with a sentence.
pub fn analyse(model: &LongitudinalModel, experiment: &Experiment) -> Result<Analysis, AnalysisError> {
    if !(model.u0.is_finite() && model.u0 > 0.0) {
        return Err(AnalysisError::TrimSpeed(model.u0));
    }
    let modes = modes(model)?;
    let dynamic_stability = worst(modes.iter().map(|mode| mode.stability));
    let b = match experiment.channel {
        Channel::Elevator => model.b_elevator,
        Channel::VerticalGust => model.b_vertical_gust(),
    };
    let response = respond(&model.a, &b, &experiment.input, experiment.grid);
    Ok(Analysis {
        dynamic_stability,
        static_stability: static_stability(model),
        gravity: gravity_check(model),
        small_until: small_until(&response, model.u0),
        response,
        modes,
    })
}

/// When a motion first leaves |u| ≤ U₀/2, |w|/U₀ ≤ 0.35 (α = 20°, about the stall), |θ| ≤ 1 rad; `None` if it never does.
///
/// Beyond these the linear equations are no approximation of anything. The limits are ours, and generous.
fn small_until(response: &Response, u0: f64) -> Option<f64> {
    let small = |x: &Vector4<f64>| {
        let [u, w, _, theta] = (*x).into();
        u.abs() <= 0.5 * u0 && w.abs() <= 0.35 * u0 && theta.abs() <= 1.0
    };
    let k = response.states.iter().position(|x| !small(x))?;
    Some(k as f64 * response.dt)
}

/// The named modes of a longitudinal model, short period first.
pub fn modes(model: &LongitudinalModel) -> Result<Vec<Mode>, EigenError> {
    modes_of(Plane::Longitudinal, &model.a)
}

fn worst(verdicts: impl Iterator<Item = DynamicStability>) -> DynamicStability {
    verdicts.fold(DynamicStability::Stable, |worst, verdict| match (worst, verdict) {
        (DynamicStability::Unstable, _) | (_, DynamicStability::Unstable) => DynamicStability::Unstable,
        (DynamicStability::Neutral, _) | (_, DynamicStability::Neutral) => DynamicStability::Neutral,
        (DynamicStability::Stable, DynamicStability::Stable) => DynamicStability::Stable,
    })
}

fn gravity_check(model: &LongitudinalModel) -> GravityCheck {
    // The u row of A carries −g cos θ₀ in the θ column.
    let g_cos_theta0 = -model.a[(Longitudinal::U.index(), Longitudinal::Theta.index())];
    GravityCheck { rate: g_cos_theta0 / model.u0, expected_rate: STANDARD_GRAVITY / model.u0 }
}
