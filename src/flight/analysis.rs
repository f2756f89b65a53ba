//! The one entry point: everything that follows from a model and an experiment.

use nalgebra::Vector4;
use thiserror::Error;

use super::eigen::{EigenError, eigen};
use super::inputs::Input;
use super::linear::{Longitudinal, LongitudinalModel};
use super::modes::{DynamicStability, Mode, dynamic_stability};
use super::naming::{Shape, name_modes};
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
    Ok(Analysis {
        dynamic_stability,
        static_stability: static_stability(model),
        gravity: gravity_check(model),
        response: respond(&model.a, &b, &experiment.input, experiment.grid),
        modes,
    })
}

/// The named modes of a model, short period first.
pub fn modes(model: &LongitudinalModel) -> Result<Vec<Mode>, EigenError> {
    let eigen = eigen(&model.a)?;
    let spectral_radius = eigen.values.iter().map(|l| l.norm()).fold(0.0, f64::max);
    let kept: Vec<usize> = (0..4).filter(|&i| eigen.values[i].im >= 0.0).collect();
    let shapes: Vec<Shape> = kept
        .iter()
        .map(|&i| Shape {
            lambda: eigen.values[i],
            participation: eigen.participation(i),
            stability: dynamic_stability(eigen.values[i].re, spectral_radius),
        })
        .collect();
    let mut modes: Vec<Mode> = kept
        .iter()
        .zip(&shapes)
        .zip(name_modes(&shapes))
        .map(|((&i, shape), naming)| Mode {
            lambda: shape.lambda,
            shape: Vector4::from(eigen.right.column(i)),
            participation: shape.participation,
            naming,
            stability: shape.stability,
        })
        .collect();
    modes.sort_by_key(|mode| mode.naming.name);
    Ok(modes)
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
