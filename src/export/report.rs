//! Everything that follows for an aircraft, for other programs: SI and radians, fields in the order of a report.

use nalgebra::{Complex, Vector4};
use serde::Serialize;

use super::subject::{ExportError, Subject};
use crate::content::{Aircraft, Status};
use crate::flight::analysis::{Margins, PlaneAnalysis};
use crate::flight::approximations::{Approximation, ModeValue};
use crate::flight::handling_qualities::Verdict;
use crate::flight::mil_f_8785c::{Category, Class, Criterion};
use crate::flight::modes::{DynamicStability, Mode};
use crate::flight::plane::{Plane, Trim};
use crate::flight::static_stability::{PlaneStaticStability, PlaneStiffness, StaticVerdict};
use crate::flight::{Analysis, AnalysisError};

/// Which aircraft was asked about.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AircraftReport {
    /// Short name; `file` for bare matrices.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Flight condition in words.
    pub condition: String,
    /// Where its numbers come from.
    pub source: String,
    /// `verified` where every published number is reproduced, else `unverified`.
    pub status: &'static str,
    /// Why, in a sentence or two.
    pub status_reason: String,
    /// Class of MIL-F-8785C, our assignment.
    pub class: Option<&'static str>,
    /// Flight-phase category of MIL-F-8785C, our assignment.
    pub phase: Option<&'static str>,
    /// The planes of motion that it has data of.
    pub planes: Vec<&'static str>,
}

/// What follows for an aircraft.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// The unit of every number below, by the name of its field; numbers without one are ratios.
    pub units: Units,
    /// What was set on it, SI.
    pub set: std::collections::BTreeMap<String, f64>,
    /// Longitudinal motion, x = \[u, w, q, θ\]; null where the aircraft has no data of it.
    pub longitudinal: Option<PlaneOutcome>,
    /// Lateral–directional motion, x = \[v, p, r, φ\].
    pub lateral: Option<PlaneOutcome>,
    /// Static margin in mean chords, positive where stable; of an aircraft given by coefficients only.
    pub static_margin: Option<f64>,
    /// Manoeuvre margin in mean chords.
    pub manoeuvre_margin: Option<f64>,
    /// False where gravity and speed of the model can't belong to one system of units.
    pub gravity_is_plausible: Option<bool>,
}

/// Units by the name of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units;

impl Units {
    /// Field and unit.
    pub const ALL: [(&'static str, &'static str); 22] = [
        ("re", "1/s"),
        ("im", "rad/s"),
        ("eigenvalues", "1/s"),
        ("natural_frequency", "rad/s"),
        ("damped_frequency", "rad/s"),
        ("period", "s"),
        ("time_to_half", "s"),
        ("time_to_double", "s"),
        ("time_constant", "s"),
        ("root", "1/s"),
        ("determinant", "1/s⁴"),
        ("pitch_stiffness", "1/(m·s)"),
        ("to_manoeuvre_point", "1/(m·s)"),
        ("weathercock_stiffness", "1/(m·s)"),
        ("dihedral_effect", "1/(m·s)"),
        ("spiral_condition", "1/(m·s²)"),
        ("speed", "m/s"),
        ("alpha0", "rad"),
        ("gamma0", "rad"),
        ("gravity", "m/s²"),
        ("states", "m/s, rad/s, rad"),
        ("inputs", "rad; throttle as a share of the weight where the source says nothing of its engine"),
    ];
}

impl Serialize for Units {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Self::ALL)
    }
}

/// What follows for one plane, or why nothing does.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PlaneOutcome {
    /// What follows.
    Analysed(Box<PlaneReport>),
    /// Why nothing does.
    Failed {
        /// In one sentence.
        error: String,
    },
}

impl PlaneOutcome {
    /// What follows, if anything does.
    pub fn report(&self) -> Option<&PlaneReport> {
        match self {
            Self::Analysed(report) => Some(report),
            Self::Failed { .. } => None,
        }
    }
}

/// What follows for one plane of motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlaneReport {
    /// Names of the states, in the order of the rows and columns.
    pub states: [&'static str; 4],
    /// Names of the inputs, in the order of the columns of B.
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
    pub dynamic_stability: &'static str,
    /// Static stability, a verdict of its own.
    pub static_stability: StaticReport,
    /// Textbook approximations beside the exact modes.
    pub approximations: Vec<ApproximationReport>,
    /// Handling qualities after MIL-F-8785C, where the aircraft has a class.
    pub levels: Vec<LevelReport>,
}

/// A steady flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
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

/// One mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModeReport {
    /// What it is called.
    pub name: &'static str,
    /// Why, with numbers.
    pub reason: String,
    /// Share of the mode in the states that gave it its name, 0 to 1.
    pub confidence: f64,
    /// Real part σ of its eigenvalue.
    pub re: f64,
    /// Imaginary part ω ≥ 0 of its eigenvalue; positive stands for the pair σ ± jω.
    pub im: f64,
    /// `stable`, `neutral` or `unstable`.
    pub stability: &'static str,
    /// ωₙ, of an oscillation.
    pub natural_frequency: Option<f64>,
    /// ζ, negative when it grows; of an oscillation.
    pub damping_ratio: Option<f64>,
    /// ω_d, of an oscillation.
    pub damped_frequency: Option<f64>,
    /// T, of an oscillation.
    pub period: Option<f64>,
    /// t½, of what dies away.
    pub time_to_half: Option<f64>,
    /// t₂, of what grows.
    pub time_to_double: Option<f64>,
    /// Oscillations until the amplitude has halved or doubled.
    pub cycles: Option<f64>,
    /// τ = −1/λ, of a real mode.
    pub time_constant: Option<f64>,
    /// Share of each state, adding up to 1.
    pub participation: [f64; 4],
    /// Right eigenvector of unit length, \[real, imaginary\] of each state.
    pub eigenvector: [[f64; 2]; 4],
    /// Left eigenvector l of unit length, lᴴ A = λ lᴴ.
    pub left_eigenvector: [[f64; 2]; 4],
    /// How far λ moves at worst for a relative change of A: 1 at best, 1e16 at a repeated root.
    pub condition: f64,
}

/// Static stability of a plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StaticReport {
    /// `stable`, `neutral` or `unstable`, from the sign of det A.
    pub verdict: &'static str,
    /// det A.
    pub determinant: f64,
    /// The stiffnesses behind it.
    #[serde(flatten)]
    pub stiffness: StiffnessReport,
}

/// The stiffnesses of a plane, in stability axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
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
        /// N'v, positive is restoring.
        weathercock_stiffness: f64,
        /// L'v, negative is restoring.
        dihedral_effect: f64,
        /// L'v N'r − N'v L'r, positive is a stable spiral in level flight.
        spiral_condition: f64,
    },
}

/// A textbook approximation beside the exact mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ApproximationReport {
    /// The mode that it approximates.
    pub mode: &'static str,
    /// What it is called.
    pub name: &'static str,
    /// Its formula.
    pub formula: &'static str,
    /// What it leaves out.
    pub neglects: &'static str,
    /// What it gives; null where it gives nothing.
    pub value: Option<ValueReport>,
    /// The exact mode; null where the aircraft has none.
    pub exact: Option<ValueReport>,
    /// Relative error of ωₙ or of the root.
    pub error: Option<f64>,
    /// Relative error of ζ.
    pub damping_error: Option<f64>,
}

/// What an approximation or a mode is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ValueReport {
    /// An oscillation, or two roots taken together.
    SecondOrder {
        /// ωₙ.
        natural_frequency: f64,
        /// ζ, where the approximation gives one.
        damping_ratio: Option<f64>,
    },
    /// A real root.
    Root {
        /// λ.
        root: f64,
    },
}

/// A level of handling qualities.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LevelReport {
    /// What was judged.
    pub criterion: &'static str,
    /// `Level 1` to `Level 3`, or `Worse than Level 3`.
    pub level: &'static str,
    /// Whether a value equals a limit to three digits.
    pub on_boundary: bool,
    /// Paragraph of MIL-F-8785C.
    pub paragraph: &'static str,
    /// Its table or figure, and page.
    pub table: &'static str,
    /// The values judged.
    pub values: Vec<JudgedReport>,
    /// The verdict with the limit that governs it, in one sentence.
    pub sentence: String,
}

/// A value that was judged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct JudgedReport {
    /// Its symbol.
    pub symbol: &'static str,
    /// The value.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
}

/// Everything that follows for an aircraft as it is set.
pub fn analyse(subject: &Subject) -> Result<Report, ExportError> {
    let scenario = subject.scenario()?;
    let analysis = scenario.analyse()?;
    let Analysis { margins, gravity, .. } = analysis;
    Ok(Report {
        aircraft: AircraftReport::of(&scenario.aircraft),
        units: Units,
        set: subject.set.iter().cloned().collect(),
        longitudinal: analysis.longitudinal.as_ref().map(PlaneOutcome::of),
        lateral: analysis.lateral.as_ref().map(PlaneOutcome::of),
        static_margin: margins.map(|Margins { static_margin, .. }| static_margin),
        manoeuvre_margin: margins.map(|Margins { manoeuvre_margin, .. }| manoeuvre_margin),
        gravity_is_plausible: gravity.map(|gravity| gravity.is_plausible()),
    })
}

impl AircraftReport {
    /// What an aircraft says of itself.
    pub fn of(aircraft: &Aircraft) -> Self {
        let name_of = |status| Status::NAMES.iter().find(|(_, s)| *s == status).map_or("", |(name, _)| name);
        let models = aircraft.study.models().unwrap_or_default();
        let planes = [Plane::Longitudinal, Plane::Lateral];
        Self {
            key: aircraft.key.clone(),
            name: aircraft.name.clone(),
            condition: aircraft.condition.clone(),
            source: aircraft.source.clone(),
            status: name_of(aircraft.status),
            status_reason: aircraft.status_reason.clone(),
            class: aircraft
                .class
                .and_then(|class| Class::NAMES.iter().find(|(_, c)| *c == class).map(|&(name, _)| name)),
            phase: aircraft
                .phase
                .and_then(|phase| Category::NAMES.iter().find(|(_, c)| *c == phase).map(|&(name, _)| name)),
            planes: planes
                .into_iter()
                .filter(|plane| models.of(*plane).is_some())
                .map(super::subject::plane_name)
                .collect(),
        }
    }
}

impl PlaneOutcome {
    fn of(outcome: &Result<PlaneAnalysis, AnalysisError>) -> Self {
        match outcome {
            Ok(analysis) => Self::Analysed(Box::new(PlaneReport::of(analysis))),
            Err(error) => Self::Failed { error: error.to_string() },
        }
    }
}

/// Names of the states of a plane.
pub const fn state_names(plane: Plane) -> [&'static str; 4] {
    match plane {
        Plane::Longitudinal => ["u", "w", "q", "theta"],
        Plane::Lateral => ["v", "p", "r", "phi"],
    }
}

/// Names of the inputs of a plane.
pub const fn input_names(plane: Plane) -> [&'static str; 2] {
    match plane {
        Plane::Longitudinal => ["elevator", "throttle"],
        Plane::Lateral => ["aileron", "rudder"],
    }
}

impl PlaneReport {
    fn of(analysis: &PlaneAnalysis) -> Self {
        let PlaneAnalysis { model, modes, dynamic_stability, static_stability, approximations, levels } =
            analysis;
        let Trim { speed, alpha0, gamma0, gravity } = model.trim;
        let with_conjugate = |mode: &Mode| {
            let Complex { re, im } = mode.lambda;
            let conjugate = mode.is_oscillatory().then_some([re, -im]);
            std::iter::once([re, im]).chain(conjugate)
        };
        Self {
            states: state_names(model.plane),
            inputs: input_names(model.plane),
            a: std::array::from_fn(|i| std::array::from_fn(|j| model.a[(i, j)])),
            b: std::array::from_fn(|i| std::array::from_fn(|j| model.b[(i, j)])),
            trim: TrimReport { speed, alpha0, gamma0, gravity },
            eigenvalues: modes.iter().flat_map(with_conjugate).collect(),
            modes: modes.iter().map(ModeReport::of).collect(),
            dynamic_stability: dynamic_word(*dynamic_stability),
            static_stability: StaticReport::of(static_stability),
            approximations: approximations.iter().map(ApproximationReport::of).collect(),
            levels: levels.iter().map(LevelReport::of).collect(),
        }
    }
}

impl ModeReport {
    /// A mode as it is told.
    pub fn of(mode: &Mode) -> Self {
        let pairs = |vector: &Vector4<Complex<f64>>| std::array::from_fn(|k| [vector[k].re, vector[k].im]);
        let finite = |value: Option<f64>| value.filter(|x| x.is_finite());
        Self {
            name: mode.naming.name.text(),
            reason: mode.naming.reason.clone(),
            confidence: mode.naming.confidence,
            re: mode.lambda.re,
            im: mode.lambda.im,
            stability: dynamic_word(mode.stability),
            natural_frequency: finite(mode.natural_frequency()),
            damping_ratio: finite(mode.damping_ratio()),
            damped_frequency: finite(mode.damped_frequency()),
            period: finite(mode.period()),
            time_to_half: finite(mode.time_to_half()),
            time_to_double: finite(mode.time_to_double()),
            cycles: finite(mode.cycles()),
            time_constant: finite(mode.time_constant()),
            participation: mode.participation,
            eigenvector: pairs(&mode.shape),
            left_eigenvector: pairs(&mode.adjoint),
            condition: mode.condition,
        }
    }
}

impl StaticReport {
    fn of(stability: &PlaneStaticStability) -> Self {
        Self {
            verdict: static_word(stability.verdict),
            determinant: stability.determinant,
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

impl ApproximationReport {
    fn of(approximation: &Approximation) -> Self {
        let value = |value: ModeValue| match value {
            ModeValue::SecondOrder { natural_frequency, damping_ratio } => {
                ValueReport::SecondOrder { natural_frequency, damping_ratio }
            }
            ModeValue::Root(root) => ValueReport::Root { root },
        };
        Self {
            mode: approximation.name.concerns().text(),
            name: approximation.name.text(),
            formula: approximation.formula,
            neglects: approximation.neglects,
            value: approximation.value.map(value),
            exact: approximation.exact.map(value),
            error: approximation.error(),
            damping_error: approximation.damping_error(),
        }
    }
}

impl LevelReport {
    fn of(verdict: &Verdict) -> Self {
        Self {
            criterion: match verdict.criterion {
                Criterion::Phugoid => "Phugoid damping",
                Criterion::ShortPeriodDamping => "Short-period damping",
                Criterion::ShortPeriodFrequency => "Short-period frequency",
                Criterion::DutchRoll => "Dutch roll",
                Criterion::RollMode => "Roll mode",
                Criterion::Spiral => "Spiral",
                Criterion::CoupledRollSpiral => "Coupled roll–spiral",
            },
            level: verdict.level.text(),
            on_boundary: verdict.on_boundary,
            paragraph: verdict.paragraph,
            table: verdict.table,
            values: verdict
                .values
                .iter()
                .map(|&(quantity, value)| JudgedReport {
                    symbol: quantity.symbol(),
                    value,
                    unit: quantity.unit().trim_start(),
                })
                .collect(),
            sentence: verdict.sentence(),
        }
    }
}

/// Dynamic stability in a word.
pub const fn dynamic_word(stability: DynamicStability) -> &'static str {
    match stability {
        DynamicStability::Stable => "stable",
        DynamicStability::Neutral => "neutral",
        DynamicStability::Unstable => "unstable",
    }
}

/// Static stability in a word.
pub const fn static_word(verdict: StaticVerdict) -> &'static str {
    match verdict {
        StaticVerdict::Stable => "stable",
        StaticVerdict::Neutral => "neutral",
        StaticVerdict::Unstable => "unstable",
    }
}
