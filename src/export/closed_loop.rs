//! An aircraft under a law of feedback, or with the further states of its source: modes, margins, motion and frequency response.

use nalgebra::{Complex, DVector};
use serde::Serialize;

use super::level::LevelReport;
use super::metrics::MetricsReport;
use super::mode::ModeReport;
use super::signal::Signal;
use crate::findings::{Findings, NoLeastGain};
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::LoopAnalysis;
use crate::flight::feedback::loop_modes::LoopMode;
use crate::flight::feedback::loop_response::LoopResponse;
use crate::flight::feedback::margins::LoopMargins;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::verdicts::handling_qualities::Level;
use crate::key::Keyed;
use crate::number::significant;
use crate::scenario::{Parameter, Quantity, Scenario, parameters};
use crate::words;

/// A plane of motion under its law and with its further states, or the reason why it has no analysis.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum LoopOutcome {
    /// The analysis.
    Analysed(Box<LoopReport>),
    /// No analysis.
    Failed {
        /// In one sentence.
        error: String,
    },
}

/// A plane of motion under its law of feedback, with the further states of its source.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ClosedLoop"))]
pub struct LoopReport {
    /// Whether a law feeds anything back; otherwise it is the aircraft with the further states of its source.
    pub feedback: bool,
    /// Keys of all states: the four of the aircraft, the further ones of its source, and those of the law.
    pub states: Vec<&'static str>,
    /// State matrix of the whole, row by row.
    pub a: Vec<Vec<f64>>,
    /// All eigenvalues as \[real part, imaginary part\], each pair with both, in the order of the modes.
    pub eigenvalues: Vec<[f64; 2]>,
    /// The modes, each conjugate pair once.
    pub modes: Vec<LoopModeReport>,
    /// `stable`, `neutral` or `unstable`: that of the worst mode.
    #[cfg_attr(test, ts(type = "Stability"))]
    pub dynamic_stability: &'static str,
    /// Handling qualities after MIL-F-8785C, where the aircraft has a class.
    pub levels: Vec<LevelReport>,
    /// The loop of each control that the law moves, cut before its actuator, the other one closed.
    pub loops: Vec<MarginsReport>,
    /// How much of each gain that isn't zero the plane needs to be at Level 1, all else as it is; none where the aircraft has no class.
    pub least_gains: Vec<LeastGainReport>,
}

/// The least of a gain with which its plane is at Level 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LeastGain"))]
pub struct LeastGainReport {
    /// Key of the gain.
    pub gain: &'static str,
    /// Its SI unit; empty for a ratio.
    pub unit: &'static str,
    /// The one nearest to zero, of either sign; zero where none is needed, null where none of its slider reaches Level 1.
    pub least: Option<f64>,
    /// Why none does, in words.
    pub reason: Option<String>,
}

/// A mode under a law: its numbers, its share in the aircraft's states, and in all.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LoopMode"))]
pub struct LoopModeReport {
    /// As of an aircraft alone: `participation` and both eigenvectors are those of the four states among themselves.
    #[serde(flatten)]
    pub mode: ModeReport,
    /// Share of each state, adding up to 1.
    pub participation_of_all: Vec<f64>,
    /// Right eigenvector over all states, of unit length.
    pub eigenvector_of_all: Vec<[f64; 2]>,
    /// Left eigenvector over all states, of unit length.
    pub left_eigenvector_of_all: Vec<[f64; 2]>,
}

/// How far a loop is from instability.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LoopMargins"))]
pub struct MarginsReport {
    /// Key of the control.
    pub control: &'static str,
    /// Factor above 1 on all gains to it at which it is neutral; null where none is.
    pub raise: Option<f64>,
    /// Frequency at which it then oscillates \[rad/s\].
    pub raise_frequency: Option<f64>,
    /// Factor below 1 on all gains to it at which it is neutral; null where none is.
    pub lower: Option<f64>,
    /// Frequency at which it then oscillates \[rad/s\]; zero where it diverges.
    pub lower_frequency: Option<f64>,
    /// Lag around the loop \[rad\] at which it is neutral, negative of a lead: the smallest of all crossovers.
    pub phase_margin: Option<f64>,
    /// Crossover frequency \[rad/s\], where the gain around the loop is 1.
    pub crossover: Option<f64>,
    /// Greatest of |1/(1 + L)|; null where it is above 1 nowhere.
    pub sensitivity_peak: Option<f64>,
    /// Frequency of that \[rad/s\].
    pub sensitivity_frequency: Option<f64>,
    /// Turns of L around −1, clockwise: growing roots of the closed loop less those of the loop cut.
    pub turns: Option<i32>,
}

/// A motion under a law.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LoopMotion {
    /// Outputs at the times of the motion, as far as it goes.
    pub outputs: Vec<Signal>,
    /// What the law moves each control by.
    pub controls: Vec<Signal>,
    /// Figures of the motion under the law; of a step of a command, how it is followed.
    pub metrics: MetricsReport,
    /// Time \[s\] of the first sample left out, where the motion had outgrown numbers worth having.
    pub cut_at: Option<f64>,
}

impl LoopOutcome {
    /// A plane under its law; `None` where nothing is fed back and the source has four states.
    pub(super) fn of(findings: &Findings, plane: Plane) -> Option<Self> {
        Some(match findings.closed_loop_of(plane)? {
            Ok(analysis) => Self::Analysed(Box::new(LoopReport::of(analysis, findings))),
            Err(error) => Self::Failed { error: error.to_string() },
        })
    }
}

impl LoopReport {
    fn of(analysis: &LoopAnalysis, findings: &Findings) -> Self {
        let closed = &analysis.closed;
        let plane = closed.model.plane;
        let four = Output::states(plane).map(Keyed::key);
        let with_conjugate = |mode: &LoopMode| {
            let Complex { re, im } = mode.mode.lambda;
            std::iter::once([re, im]).chain(mode.mode.is_oscillatory().then_some([re, -im]))
        };
        let margins = [Channel::First, Channel::Second].into_iter().zip(findings.loop_margins(plane));
        Self {
            feedback: closed.is_fed_back(),
            states: four.into_iter().chain(closed.appended.iter().map(|state| state.key())).collect(),
            a: closed.a.row_iter().map(|row| row.iter().copied().collect()).collect(),
            eigenvalues: analysis.modes.iter().flat_map(with_conjugate).collect(),
            modes: analysis.modes.iter().map(LoopModeReport::of).collect(),
            dynamic_stability: analysis.dynamic_stability.key(),
            levels: analysis.levels.iter().map(LevelReport::of).collect(),
            loops: margins
                .filter_map(|(channel, margins)| Some(MarginsReport::of(plane, channel, margins.as_ref()?)))
                .collect(),
            least_gains: gains_of(findings.scenario(), plane)
                .filter_map(|gain| LeastGainReport::of(gain, findings))
                .collect(),
        }
    }
}

/// The gains of a plane that aren't zero.
fn gains_of(scenario: &Scenario, plane: Plane) -> impl Iterator<Item = &'static Parameter> {
    let is_of = move |p: &&Parameter| p.is_gain() && p.plane == Some(plane) && p.applies(scenario);
    parameters().filter(is_of).filter(|p| p.get(scenario) != 0.0)
}

impl LeastGainReport {
    fn of(gain: &'static Parameter, findings: &Findings) -> Option<Self> {
        let found = findings.least_gain(gain, Level::One);
        let unit = gain.dimension.si_symbol();
        let (least, reason) = match &found {
            Ok(found) => (Some(found.gain), None),
            Err(NoLeastGain::Nowhere { .. }) => {
                let shown = |value: f64| format!("{} {unit}", significant(value, 3)).trim_end().to_owned();
                (None, Some(words::feedback::least_gain(&found, shown)))
            }
            Err(NoLeastGain::NotAGain | NoLeastGain::NotJudged) => return None,
        };
        Some(Self { gain: gain.key, unit, least, reason })
    }
}

impl LoopModeReport {
    fn of(mode: &LoopMode) -> Self {
        let pairs = |vector: &DVector<Complex<f64>>| vector.iter().map(|x| [x.re, x.im]).collect();
        Self {
            mode: ModeReport::of(&mode.mode),
            participation_of_all: mode.participation.clone(),
            eigenvector_of_all: pairs(&mode.shape),
            left_eigenvector_of_all: pairs(&mode.adjoint),
        }
    }
}

impl MarginsReport {
    fn of(plane: Plane, channel: Channel, margins: &LoopMargins) -> Self {
        let LoopMargins { raise, lower, phase, sensitivity, turns } = *margins;
        Self {
            control: Quantity::of_input(plane, channel).key,
            raise: raise.map(|margin| margin.factor),
            raise_frequency: raise.map(|margin| margin.frequency),
            lower: lower.map(|margin| margin.factor),
            lower_frequency: lower.map(|margin| margin.frequency),
            phase_margin: phase.map(|margin| margin.angle),
            crossover: phase.map(|margin| margin.frequency),
            sensitivity_peak: sensitivity.map(|peak| peak.value),
            sensitivity_frequency: sensitivity.map(|peak| peak.frequency),
            turns,
        }
    }
}

impl LoopMotion {
    /// The motion on screen under its law; `None` where nothing is fed back and the source has four states.
    pub(super) fn of(findings: &Findings, steps: usize) -> Option<Self> {
        let response = findings.closed_motion_in(steps)?;
        let closed = &findings.closed_loop()?.as_ref().ok()?.closed;
        let motion = findings.motion()?;
        let plane = motion.model.plane;
        let LoopResponse { dt, controls, cut_at, .. } = &response;
        let moved = |input: usize| controls.iter().map(|controls| controls[input]).collect::<Vec<f64>>();
        // The aircraft's own equations with its controls moved so: outputs are read off those at the samples.
        let inputs = [0, 1].map(|input| Input::Samples { dt: *dt, values: moved(input).into() });
        let further = |k: usize| {
            let values = response.states.iter().map(|x| x[4 + k]).collect::<Vec<f64>>();
            Input::Samples { dt: *dt, values: values.into() }
        };
        let whole = closed.with_courses(&motion.forced, inputs, further);
        let four = response.as_of_aircraft();
        let output = |&output: &Output| {
            let values = output.row(&motion.model, &whole).of(&whole, &four).collect();
            Signal::of(output, values)
        };
        let control = |(input, channel): (usize, Channel)| {
            let Quantity { key: name, dimension, .. } = Quantity::of_input(plane, channel);
            Signal { name, unit: dimension.si_symbol(), values: moved(input) }
        };
        Some(Self {
            outputs: Output::of(plane).iter().map(output).collect(),
            controls: [Channel::First, Channel::Second].into_iter().enumerate().map(control).collect(),
            metrics: MetricsReport::of(findings.flown_metrics()?),
            cut_at: *cut_at,
        })
    }
}
