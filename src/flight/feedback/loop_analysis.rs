//! Everything that follows for a plane under a law, or with the further states of its source alone.

use nalgebra::{DVector, Vector2};

use super::closed_model::ClosedModel;
use super::law::Law;
use super::loop_modes::{LoopMode, loop_modes, start_in};
use super::loop_response::{LoopResponse, respond_closed};
use crate::flight::aircraft::aircraft_model::ModelError;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::eigen::EigenError;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::experiment::{Experiment, Start, angles};
use crate::flight::motion::modal_decomposition::single_mode;
use crate::flight::motion::response::DrivenSystem;
use crate::flight::verdicts::handling_qualities::{Verdict, handling_qualities};
use crate::flight::verdicts::task::Task;

/// Everything that follows for a plane of motion under a law and with the further states of its source, as [`PlaneAnalysis`](crate::flight::analysis::PlaneAnalysis) without one.
///
/// Textbook approximations and static stability are of the aircraft alone.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopAnalysis {
    /// The model.
    pub closed: ClosedModel,
    /// Its modes in the order of their names, each conjugate pair once.
    pub modes: Vec<LoopMode>,
    /// The verdict on the whole: that of its worst mode. A height, heading or position that stays where it is counts for nothing: flight
    /// is the same there.
    pub dynamic_stability: Stability,
    /// Handling qualities after MIL-F-8785C, where the aircraft has a class.
    pub levels: Vec<Verdict>,
}

/// Why a plane under a law can't be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LoopError {
    /// The model has a number that is none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The eigenvalues could not be had.
    #[error(transparent)]
    Eigen(#[from] EigenError),
}

/// Analyses a plane under a law.
pub fn analyse_loop(model: &PlaneModel, law: &Law, task: Option<Task>) -> Result<LoopAnalysis, LoopError> {
    let closed = ClosedModel::new(model, law)?;
    let modes = loop_modes(&closed)?;
    let of_flight = || -> Vec<Mode> {
        modes.iter().filter(|mode| mode.is_of_flight()).map(|mode| mode.mode.clone()).collect()
    };
    Ok(LoopAnalysis {
        dynamic_stability: worst_stability(modes.iter().map(|mode| &mode.mode)),
        levels: task.map_or_else(Vec::new, |task| handling_qualities(model, &of_flight(), task)),
        closed,
        modes,
    })
}

/// The verdict on all modes of a plane: that of the worst. A height, heading or position that stays where it is counts for nothing.
pub fn worst_stability<'a>(modes: impl Iterator<Item = &'a Mode>) -> Stability {
    use ModeName::{Heading, Height, Position};
    let counts = |mode: &&Mode| {
        let is_of_path = matches!(mode.naming.name, Height | Heading | Position);
        !(is_of_path && mode.stability == Stability::Neutral)
    };
    modes.filter(counts).map(|mode| mode.stability).max().unwrap_or_default()
}

impl LoopAnalysis {
    /// Where the motion in an experiment begins, and on which path: released, the aircraft alone is away from steady flight; in one mode,
    /// the law with it.
    pub fn start(&self, forced: &DrivenSystem, start: Start) -> (DVector<f64>, Vector2<f64>) {
        if let Start::Mode { index, amplitude } = start
            && let Some(mode) = self.modes.get(index).or(self.modes.last())
        {
            let seen = angles(&self.closed.model);
            let (_, path) = single_mode(&mode.mode, seen, &forced.path, amplitude);
            return (start_in(mode, seen, amplitude), path);
        }
        let mut at = DVector::zeros(self.closed.size());
        at.rows_mut(0, 4).copy_from(&forced.start);
        (at, forced.start_path)
    }

    /// The motion in an experiment, from what drives the aircraft without the law: `forced` of the same experiment.
    pub fn respond(&self, forced: &DrivenSystem, experiment: &Experiment) -> LoopResponse {
        let (start, start_path) = self.start(forced, experiment.start);
        let forced = DrivenSystem { start_path, ..forced.clone() };
        respond_closed(&self.closed, &forced, &start, experiment.grid)
    }
}
