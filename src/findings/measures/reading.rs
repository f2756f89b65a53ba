//! What a measure reads of a scenario: a number, a verdict, or the reason why there is none.

use super::{AircraftQuantity, LoopOf, LoopQuantity, Measure, Metric, ModeQuantity, PlaneQuantity};
use crate::findings::{Extreme, Findings, OutputMetrics, Problem};
use crate::flight::Analysis;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::outputs::Output;
use crate::flight::verdicts::handling_qualities::{Level, Verdict};
use crate::scenario::Parameter;

/// What was read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// A finite number in SI.
    Number(f64),
    /// A verdict on stability.
    Stability(Stability),
    /// A level of handling qualities.
    Level(Level),
}

/// Why there is nothing to read.
#[derive(Clone, Debug, PartialEq)]
pub enum Absence {
    /// The aircraft can't be analysed so.
    Problem(Problem),
    /// The aircraft's source has no data of a plane.
    NoPlane(Plane),
    /// There is no mode by this name.
    NoMode(ModeName),
    /// The mode doesn't oscillate.
    DoesNotOscillate(ModeName),
    /// The mode oscillates, so that it has no time constant.
    Oscillates(ModeName),
    /// The mode doesn't grow.
    DoesNotGrow(ModeName),
    /// The mode doesn't die away.
    DoesNotDieAway(ModeName),
    /// No requirement judges it, or no class is chosen.
    NotJudged,
    /// The law moves no such control, or there is none.
    NoLoop(LoopOf),
    /// The loop is neutral at no such change, or has no such frequency.
    NoMargin(LoopQuantity),
    /// The aircraft isn't given by coefficients.
    NoCoefficients,
    /// The aircraft doesn't have this parameter.
    NoParameter(&'static Parameter),
    /// The output is of the other plane than the motion on screen.
    OtherPlane(Output),
    /// The motion has no such metric: it isn't a step, or it ends beyond the linear model.
    NoMetric(Metric),
}

impl Measure {
    /// What it reads.
    pub fn read(self, findings: &Findings) -> Result<Reading, Absence> {
        match self {
            Self::OfMode(name, quantity) => of_mode(findings, name, quantity),
            Self::OfPlane(plane, quantity) => of_plane(findings, plane_of(findings, plane)?, quantity),
            Self::OfLoop(of, quantity) => of_loop(findings, of, quantity),
            Self::OfAircraft(quantity) => of_aircraft(findings, quantity),
            Self::OfOutput(output, metric) => of_output(findings, output, metric),
            Self::OfParameter(parameter) => {
                if parameter.applies(findings.scenario()) {
                    finite(parameter.get(findings.scenario())).ok_or(Absence::NoParameter(parameter))
                } else {
                    Err(Absence::NoParameter(parameter))
                }
            }
        }
    }
}

fn finite(value: f64) -> Option<Reading> {
    value.is_finite().then_some(Reading::Number(value))
}

fn analysis(findings: &Findings) -> Result<&Analysis, Absence> {
    findings.analysis().as_ref().map_err(|error| Absence::Problem(error.clone().into()))
}

fn plane_of(findings: &Findings, plane: Plane) -> Result<&PlaneAnalysis, Absence> {
    match &analysis(findings)?.planes[plane] {
        Some(Ok(analysis)) => Ok(analysis),
        Some(Err(error)) => Err(Absence::Problem(error.clone().into())),
        None => Err(Absence::NoPlane(plane)),
    }
}

fn of_mode(findings: &Findings, name: ModeName, quantity: ModeQuantity) -> Result<Reading, Absence> {
    let planes = Plane::ALL.map(|plane| plane_of(findings, plane));
    let found = planes.iter().flatten().find_map(|plane| {
        let mode = findings.modes_in_flight(plane).into_iter().find(|mode| mode.naming.name == name)?;
        Some((*plane, mode))
    });
    let Some((plane, mode)) = found else {
        // Neither plane: say why, where both have failed.
        return Err(match planes {
            [Err(problem @ Absence::Problem(_)), Err(_)] => problem,
            _ => Absence::NoMode(name),
        });
    };
    let (number, without) = match quantity {
        ModeQuantity::RealPart => (Some(mode.lambda.re), Absence::NoMode(name)),
        ModeQuantity::ImaginaryPart => (Some(mode.lambda.im), Absence::NoMode(name)),
        ModeQuantity::NaturalFrequency => (mode.natural_frequency(), Absence::DoesNotOscillate(name)),
        ModeQuantity::DampingRatio => (mode.damping_ratio(), Absence::DoesNotOscillate(name)),
        ModeQuantity::Period => (mode.period(), Absence::DoesNotOscillate(name)),
        ModeQuantity::Cycles => (mode.cycles(), Absence::DoesNotOscillate(name)),
        ModeQuantity::TimeToHalf => (mode.time_to_half(), Absence::DoesNotDieAway(name)),
        ModeQuantity::TimeToDouble => (mode.time_to_double(), Absence::DoesNotGrow(name)),
        ModeQuantity::TimeConstant if mode.is_oscillatory() => (None, Absence::Oscillates(name)),
        ModeQuantity::TimeConstant => {
            (mode.time_constant().filter(|tau| *tau > 0.0), Absence::DoesNotDieAway(name))
        }
        ModeQuantity::Stability => return Ok(Reading::Stability(mode.stability)),
        ModeQuantity::Level => {
            return level_of(findings, plane, mode).map(Reading::Level).ok_or(Absence::NotJudged);
        }
    };
    number.and_then(finite).ok_or(without)
}

/// The worst level that a mode has.
fn level_of(findings: &Findings, plane: &PlaneAnalysis, mode: &Mode) -> Option<Level> {
    let of_mode =
        levels_in_flight(findings, plane).iter().filter(|verdict| verdict.modes.contains(&mode.naming.name));
    of_mode.filter_map(|verdict| verdict.level).max()
}

/// The levels of a plane as it flies: under the law where there is one.
fn levels_in_flight<'a>(findings: &'a Findings, plane: &'a PlaneAnalysis) -> &'a [Verdict] {
    match findings.closed_loop_of(plane.model.plane) {
        Some(Ok(closed)) => &closed.levels,
        Some(Err(_)) | None => &plane.levels,
    }
}

/// The dynamic stability of a plane as it flies.
fn stability_in_flight(findings: &Findings, plane: &PlaneAnalysis) -> Stability {
    match findings.closed_loop_of(plane.model.plane) {
        Some(Ok(closed)) => closed.dynamic_stability,
        Some(Err(_)) | None => plane.dynamic_stability,
    }
}

fn of_plane(findings: &Findings, plane: &PlaneAnalysis, quantity: PlaneQuantity) -> Result<Reading, Absence> {
    Ok(match quantity {
        PlaneQuantity::Stability => Reading::Stability(stability_in_flight(findings, plane)),
        PlaneQuantity::StaticStability => Reading::Stability(plane.static_stability.verdict),
        PlaneQuantity::Determinant => Reading::Number(plane.static_stability.determinant),
        PlaneQuantity::Oscillations => {
            let modes = findings.modes_in_flight(plane);
            Reading::Number(modes.into_iter().filter(|mode| mode.is_oscillatory()).count() as f64)
        }
    })
}

fn of_loop(findings: &Findings, of: LoopOf, quantity: LoopQuantity) -> Result<Reading, Absence> {
    let (plane, input) = of.input();
    plane_of(findings, plane)?;
    let margins = findings.loop_margins(plane)[input].as_ref().ok_or(Absence::NoLoop(of))?;
    let number = match quantity {
        LoopQuantity::GainMargin => margins.raise.map(|margin| margin.factor),
        LoopQuantity::GainReduction => margins.lower.map(|margin| margin.factor),
        LoopQuantity::PhaseMargin => margins.phase.map(|margin| margin.angle),
        LoopQuantity::Crossover => margins.phase.map(|margin| margin.frequency),
        LoopQuantity::SensitivityPeak => margins.sensitivity.map(|peak| peak.value),
    };
    number.and_then(finite).ok_or(Absence::NoMargin(quantity))
}

fn of_aircraft(findings: &Findings, quantity: AircraftQuantity) -> Result<Reading, Absence> {
    let analysis = analysis(findings)?;
    let worst = |of: &dyn Fn(&PlaneAnalysis) -> Stability| {
        let planes = analysis.planes.iter().filter_map(|plane| plane.as_ref()?.as_ref().ok());
        planes.map(of).max().map(Reading::Stability).ok_or(Absence::Problem(Problem::NoData))
    };
    let number = |value: Option<f64>, without: Absence| value.and_then(finite).ok_or(without);
    match quantity {
        AircraftQuantity::Stability => worst(&|plane| stability_in_flight(findings, plane)),
        AircraftQuantity::StaticStability => worst(&|plane| plane.static_stability.verdict),
        AircraftQuantity::StaticMargin => {
            number(analysis.margins.map(|margins| margins.static_margin), Absence::NoCoefficients)
        }
        AircraftQuantity::ManoeuvreMargin => {
            number(analysis.margins.map(|margins| margins.manoeuvre_margin), Absence::NoCoefficients)
        }
        AircraftQuantity::Level => {
            let level = findings.overall_level_in_flight();
            level.map(Reading::Level).ok_or(Absence::NotJudged)
        }
        AircraftQuantity::GravityRatio => {
            let ratio = analysis.gravity.map(|gravity| gravity.rate / gravity.expected_rate);
            number(ratio, Absence::NoPlane(Plane::Longitudinal))
        }
    }
}

fn of_output(findings: &Findings, output: Output, metric: Metric) -> Result<Reading, Absence> {
    if !Output::of(findings.scenario().plane).contains(&output) {
        return Err(Absence::OtherPlane(output));
    }
    let Some(metrics) = findings.flown_metrics() else {
        return Err(findings.problem().map_or(Absence::NoMetric(metric), Absence::Problem));
    };
    let of_output =
        metrics.outputs.iter().find(|one| one.output == output).ok_or(Absence::NoMetric(metric))?;
    let OutputMetrics { extreme, steady, step, .. } = of_output;
    let peak = extreme.as_ref().and_then(|extreme| match *extreme {
        Extreme::Peak { value, time } => Some((value, time)),
        Extreme::Beyond(_) => None,
    });
    let number = match metric {
        Metric::Peak => peak.map(|(value, _)| value),
        Metric::PeakTime => peak.map(|(_, time)| time),
        Metric::Steady => *steady,
        Metric::RiseTime => step.and_then(|step| step.rise_time),
        Metric::SettlingTime => step.map(|step| step.settling_time),
        Metric::Overshoot => step.map(|step| step.overshoot),
    };
    number.and_then(finite).ok_or(Absence::NoMetric(metric))
}
