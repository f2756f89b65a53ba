//! The analysis of one plane of motion.

use nalgebra::Complex;
use serde::Serialize;

use super::approximation::ApproximationReport;
use super::closed_loop::LoopOutcome;
use super::level::LevelReport;
use super::mode::ModeReport;
use crate::flight::Channel;
use crate::flight::aircraft::plane::{PlaneModel, Trim};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::feedback::closed_model::ClosedModel;
use crate::flight::modes::mode::Mode;
use crate::flight::motion::outputs::Output;
use crate::flight::verdicts::static_stability::{PlaneStaticStability, PlaneStiffness};
use crate::key::Keyed;
use crate::scenario::{Notation, Quantity};

/// The analysis of one plane of motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Plane"))]
pub struct PlaneReport {
    /// Keys of the states, in the order of the rows and columns.
    pub states: [&'static str; 4],
    /// Keys of the inputs, in the order of the columns of B.
    pub inputs: [&'static str; 2],
    /// State matrix, row by row.
    pub a: [[f64; 4]; 4],
    /// Input matrix, row by row.
    pub b: [[f64; 2]; 4],
    /// The steady flight.
    pub trim: TrimReport,
    /// All four eigenvalues as \[real part, imaginary part\], each pair with both, in the order of the modes.
    pub eigenvalues: Vec<[f64; 2]>,
    /// The modes, each conjugate pair once.
    pub modes: Vec<ModeReport>,
    /// `stable`, `neutral` or `unstable`: that of the worst mode.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub dynamic_stability: &'static str,
    /// Static stability, a verdict of its own.
    pub static_stability: StaticReport,
    /// Textbook approximations beside the exact modes.
    pub approximations: Vec<ApproximationReport>,
    /// Handling qualities after MIL-F-8785C, where the aircraft has a class.
    pub levels: Vec<LevelReport>,
    /// A and B of all states of the source, where it has more than these four; null otherwise.
    pub whole: Option<WholeReport>,
    /// The same plane under the law of feedback and with all states of its source; null where nothing is fed back and the source has
    /// four. All else is of the four states without a law.
    pub closed_loop: Option<LoopOutcome>,
}

/// A model with states beside the four, or under a law of feedback.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "WholeModel"))]
pub struct WholeReport {
    /// Keys of the states, the four first: `h`, `x`, `psi`, `y`, `elevator` and other controls, `engine`, `other`.
    pub states: Vec<&'static str>,
    /// State matrix, row by row.
    pub a: Vec<Vec<f64>>,
    /// Input matrix, row by row: a control that is a state is commanded.
    pub b: Vec<[f64; 2]>,
}

/// A steady flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Trim"))]
pub struct TrimReport {
    /// True airspeed V.
    pub speed: f64,
    /// Angle of attack of the x axis; zero in stability axes.
    pub alpha0: f64,
    /// Flight-path angle, climbing positive.
    pub gamma0: f64,
    /// Acceleration of free fall.
    pub gravity: f64,
}

/// Static stability of a plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "StaticStability"))]
pub struct StaticReport {
    /// `stable`, `neutral` or `unstable`: of the pitch stiffness, or the worse of those in yaw and roll.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub verdict: &'static str,
    /// det A.
    pub determinant: f64,
    /// Whether the stiffnesses are derivatives as such; else they are found from A: M_w as if M_u were zero, the others with the
    /// product of inertia folded in.
    pub plain_derivatives: bool,
    /// The stiffnesses.
    #[serde(flatten)]
    pub stiffness: StiffnessReport,
}

/// The stiffnesses of a plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Stiffness"))]
#[serde(untagged)]
pub enum StiffnessReport {
    /// Pitch.
    Longitudinal {
        /// M_w, negative is restoring.
        pitch_stiffness: f64,
        /// By how much M_w would have to grow to come to the manoeuvre point.
        to_manoeuvre_point: Option<f64>,
    },
    /// Yaw and roll.
    Lateral {
        /// N_v, positive is restoring.
        weathercock_stiffness: f64,
        /// L_v, negative is restoring.
        dihedral_effect: f64,
        /// L'v N'r − N'v L'r, positive is a stable spiral in level flight.
        spiral_condition: f64,
    },
}

impl PlaneReport {
    /// The report of an analysis, without what follows under a law; formulas are in a notation, matrices in u, w, q, θ and v, p, r, φ.
    pub fn of(analysis: &PlaneAnalysis, notation: Notation) -> Self {
        let PlaneAnalysis { model, modes, dynamic_stability, static_stability, approximations, levels } =
            analysis;
        let Trim { speed, alpha0, gamma0, gravity } = model.trim;
        let with_conjugate = |mode: &Mode| {
            let Complex { re, im } = mode.lambda;
            let conjugate = mode.is_oscillatory().then_some([re, -im]);
            std::iter::once([re, im]).chain(conjugate)
        };
        Self {
            states: Output::states(model.plane).map(Keyed::key),
            inputs: [Channel::First, Channel::Second]
                .map(|channel| Quantity::of_input(model.plane, channel).key),
            a: std::array::from_fn(|i| std::array::from_fn(|j| model.a[(i, j)])),
            b: std::array::from_fn(|i| std::array::from_fn(|j| model.b[(i, j)])),
            trim: TrimReport { speed, alpha0, gamma0, gravity },
            eigenvalues: modes.iter().flat_map(with_conjugate).collect(),
            modes: modes.iter().map(ModeReport::of).collect(),
            dynamic_stability: dynamic_stability.key(),
            static_stability: StaticReport::of(static_stability),
            approximations: approximations.iter().map(|one| ApproximationReport::of(one, notation)).collect(),
            levels: levels.iter().map(LevelReport::of).collect(),
            whole: model.further.as_ref().map(|_| WholeReport::of(model)),
            closed_loop: None,
        }
    }
}

impl WholeReport {
    fn of(model: &PlaneModel) -> Self {
        let four = Output::states(model.plane).map(Keyed::key);
        let (a, b) = (model.whole_a(), [0, 1].map(|input| model.whole_b(input)));
        Self {
            states: four.into_iter().chain(model.further_states().iter().map(|state| state.key())).collect(),
            a: a.row_iter().map(|row| row.iter().copied().collect()).collect(),
            b: (0..a.nrows()).map(|k| [b[0][k], b[1][k]]).collect(),
        }
    }

    /// The same under a law of feedback, with the states that it appends.
    pub(super) fn under_law(closed: &ClosedModel) -> Self {
        let four = Output::states(closed.model.plane).map(Keyed::key);
        let b = closed.commands();
        Self {
            states: four.into_iter().chain(closed.appended.iter().map(|state| state.key())).collect(),
            a: closed.a.row_iter().map(|row| row.iter().copied().collect()).collect(),
            b: b.row_iter().map(|row| [row[0], row[1]]).collect(),
        }
    }
}

impl StaticReport {
    fn of(stability: &PlaneStaticStability) -> Self {
        Self {
            verdict: stability.verdict.key(),
            determinant: stability.determinant,
            plain_derivatives: stability.is_plain,
            stiffness: match stability.stiffness {
                PlaneStiffness::Longitudinal { m_w, to_manoeuvre_point } => {
                    StiffnessReport::Longitudinal { pitch_stiffness: m_w.value, to_manoeuvre_point }
                }
                PlaneStiffness::Lateral { n_v, l_v, spiral } => StiffnessReport::Lateral {
                    weathercock_stiffness: n_v.value,
                    dihedral_effect: l_v.value,
                    spiral_condition: spiral.value,
                },
            },
        }
    }
}
