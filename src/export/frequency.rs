//! The frequency response of an output to an input: Bode's plot in numbers.

use std::collections::BTreeMap;

use nalgebra::Complex;
use serde::{Deserialize, Serialize};

use super::aircraft::AircraftReport;
use super::disturbance::{check_no_sizes, choose_disturbance, named, no_motion};
use super::error::ExportError;
use super::scene::Scene;
use super::subject::set_on;
use super::sweep::MOST_POINTS;
use crate::findings::{Findings, FrequencyResponse};
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::frequency_response::Peak;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::transfer_function::TransferFunction;
use crate::key::Keyed;
use crate::scenario::{Quantity, Source};
use crate::words;

/// Frequencies \[rad/s\] that are accepted: no motion of an aircraft is beyond them.
pub const FREQUENCIES: [f64; 2] = [1e-6, 1e6];

/// An input, an output, and the frequencies.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
#[serde(deny_unknown_fields)]
pub struct FrequencyRequest {
    /// `longitudinal` or `lateral`; by default that of the disturbance, else that of the output, else the aircraft's first.
    #[cfg_attr(test, ts(optional, type = "PlaneName"))]
    pub plane: Option<String>,
    /// Key of a control or a gust, which disturbs by one channel; by default the plane's first, elevator or rudder.
    #[cfg_attr(test, ts(optional, type = "ControlOrGust"))]
    pub disturbance: Option<String>,
    /// Key of an output, as a motion names them; by default that of the link, else the pitch rate `q` or the sideslip `beta`.
    pub output: Option<String>,
    /// First angular frequency \[rad/s\]; by default below all modes, on a whole decade.
    pub from: Option<f64>,
    /// Last angular frequency \[rad/s\]; by default above all modes, on a whole decade.
    pub to: Option<f64>,
    /// Number of frequencies, evenly spread over a logarithmic axis, both ends among them; 400 by default.
    pub points: Option<usize>,
}

/// A frequency response.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "FrequencyResponse"))]
pub struct FrequencyReport {
    /// The aircraft.
    pub aircraft: AircraftReport,
    /// Values set on it, SI.
    #[cfg_attr(test, ts(type = "Record<string, number>"))]
    pub set: BTreeMap<String, f64>,
    /// What of the link can't be used, in sentences; none without a link.
    pub notices: Vec<String>,
    /// `longitudinal` or `lateral`.
    #[cfg_attr(test, ts(type = "PlaneName"))]
    pub plane: &'static str,
    /// Key of the disturbance.
    #[cfg_attr(test, ts(type = "ControlOrGust"))]
    pub disturbance: &'static str,
    /// The input, in the sense of the disturbance's size: air is positive where it rises, comes from ahead or moves to the right.
    pub input: Measured,
    /// The output.
    pub output: Measured,
    /// Unit of the gain: that of the output for one of the input.
    pub gain_unit: String,
    /// Angular frequencies ω \[rad/s\]; without those at which the response is infinite.
    pub frequency: Vec<f64>,
    /// Gain |G(jω)|, one a frequency.
    pub gain: Vec<f64>,
    /// Phase of G(jω) \[rad\], one a frequency: continuous, and between −π and π at the first.
    pub phase: Vec<f64>,
    /// Local maxima of the gain in order, with the oscillations that make them; none where a mode grows.
    pub peaks: Vec<GainPeak>,
    /// The transfer function in factored form; null where its roots can't be had.
    pub transfer_function: Option<TransferReport>,
    /// Gain and phase under the law of feedback at these frequencies; null where nothing is fed back. All else is of the aircraft
    /// without it.
    pub closed_loop: Option<LoopFrequency>,
    /// Name of a mode that grows: then no steady oscillation ever answers a sine, and the numbers are only the transfer function
    /// at s = jω. Null where every mode stays.
    pub growing_mode: Option<&'static str>,
    /// Its key.
    #[cfg_attr(test, ts(type = "ModeKey | null"))]
    pub growing_mode_key: Option<&'static str>,
}

/// An answer over frequency under a law.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LoopFrequency {
    /// Gain |G(jω)|, one a frequency.
    pub gain: Vec<f64>,
    /// Phase of G(jω) \[rad\], one a frequency, between −π and π at the first.
    pub phase: Vec<f64>,
    /// The transfer function under the law.
    pub transfer_function: Option<TransferReport>,
}

/// A transfer function K ∏(s − z) / ∏(s − p).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "TransferFunction"))]
pub struct TransferReport {
    /// K, in units of the gain and of s; zero where the input doesn't reach the output.
    pub gain: f64,
    /// Zeros as \[real part, imaginary part\], each pair with both.
    pub zeros: Vec<[f64; 2]>,
    /// Poles likewise, those of the path over the Earth among them.
    pub poles: Vec<[f64; 2]>,
    /// The whole in factors, in SI: `−3 s (s + 0.2) / [(s² + 2·0.1·0.2 s + 0.2²) (s + 4)]`.
    pub text: String,
    /// What zeros in the right half-plane do, in one sentence; null where there are none.
    pub zeros_on_the_right: Option<String>,
}

/// A quantity and its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Measured {
    /// Its key.
    pub name: &'static str,
    /// Its SI unit; empty for a ratio, as the throttle's.
    pub unit: &'static str,
}

/// A local maximum of the gain.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct GainPeak {
    /// Name of the oscillation nearest in frequency.
    pub mode: &'static str,
    /// Its key.
    #[cfg_attr(test, ts(type = "ModeKey"))]
    pub mode_key: &'static str,
    /// Its angular frequency \[rad/s\], to seven digits or so: a maximum is flat.
    pub frequency: f64,
    /// Gain there; null where it has no bound, at an oscillation that neither dies away nor grows.
    pub gain: Option<f64>,
}

const POINTS: usize = 400;

/// The frequency response of an aircraft as it is set.
pub fn frequency(scene: &Scene, request: &FrequencyRequest) -> Result<FrequencyReport, ExportError> {
    check_no_sizes(&scene.sizes)?;
    let mut scenario = scene.scenario.clone();
    let wanted = request.output.as_deref().map(|name| named(name, Output::VALUES, "output")).transpose()?;
    if let (None, Some(output)) = (&request.disturbance, wanted) {
        scenario.plane = output.plane();
    }
    let with_channel: Vec<Source> =
        Source::VALUES.iter().copied().filter(|source| source.has_frequencies()).collect();
    let (named_plane, name) = (request.plane.as_deref(), request.disturbance.as_deref());
    let source = choose_disturbance(&mut scenario, named_plane, name, &with_channel, "input")?;
    let plane = scenario.plane;
    // A link's, as on the page: turbulence enters by the air across, and what has no input by the first control.
    let source = match (source, plane) {
        (Source::Turbulence, Plane::Longitudinal) => Source::VerticalGust,
        (Source::Turbulence, Plane::Lateral) => Source::SideGust,
        (source, _) if source.has_frequencies() => source,
        (_, Plane::Longitudinal) => Source::Elevator,
        (_, Plane::Lateral) => Source::Aileron,
    };
    scenario.disturbance.choices[plane].source = source;
    let output = match wanted {
        Some(output) if output.plane() == plane => output,
        Some(output) => {
            let (key, plane) = (output.key(), plane.key());
            return Err(ExportError::Request(format!("{key} doesn't move in {plane} motion")));
        }
        None => scene.view.response.frequency_of[plane],
    };
    let points = request.points.unwrap_or(POINTS);
    if !(2..=MOST_POINTS).contains(&points) {
        return Err(ExportError::Request(format!("points: expected 2 to {MOST_POINTS}, found {points}")));
    }
    let findings = Findings::of(scenario);
    let range = checked_range(request, findings.frequency_range())?;
    let response = findings.frequency_over(output, range, points).ok_or_else(|| no_motion(&findings))?;
    let at: Vec<f64> = response.points.iter().map(|point| point.frequency).collect();
    let closed_loop = findings.closed_frequency_at(output, &at);
    let closed_function = findings.closed_state_space(output).and_then(|whole| whole.factored().ok());
    let scenario = findings.scenario();
    let FrequencyResponse { points, peaks, function } = &response;
    let growing_mode = findings.growing_mode().map(|mode| mode.naming.name);
    let input = Measured::of(Quantity::of_input(plane, scenario.driven_channel()));
    let output = Measured::of(Quantity::of(output));
    Ok(FrequencyReport {
        aircraft: AircraftReport::of(&scenario.aircraft),
        set: set_on(scenario),
        notices: scene.notices.clone(),
        plane: plane.key(),
        disturbance: source.key(),
        gain_unit: gain_unit(output.unit, input.unit),
        input,
        output,
        frequency: points.iter().map(|point| point.frequency).collect(),
        gain: points.iter().map(|point| point.value.norm()).collect(),
        phase: points.iter().map(|point| point.phase).collect(),
        peaks: peaks.iter().map(GainPeak::of).collect(),
        transfer_function: function.as_ref().map(TransferReport::of),
        closed_loop: closed_loop.map(|points| LoopFrequency {
            gain: points.iter().map(|point| point.value.norm()).collect(),
            phase: points.iter().map(|point| point.phase).collect(),
            transfer_function: closed_function.as_ref().map(TransferReport::of),
        }),
        growing_mode: growing_mode.map(words::mode::title),
        growing_mode_key: growing_mode.map(Keyed::key),
    })
}

impl TransferReport {
    fn of(function: &TransferFunction) -> Self {
        let pairs = |roots: &[Complex<f64>]| roots.iter().map(|root| [root.re, root.im]).collect();
        Self {
            gain: function.gain,
            zeros: pairs(&function.zeros),
            poles: pairs(&function.poles),
            text: words::transfer_function::fraction(function, 1.0).line(),
            zeros_on_the_right: words::transfer_function::zeros_on_the_right(function),
        }
    }

    /// The whole in factors, with its gain in a unit of so much in SI.
    pub fn line(&self, unit: f64) -> String {
        let roots = |of: &[[f64; 2]]| of.iter().map(|&[re, im]| Complex::new(re, im)).collect();
        let function =
            TransferFunction { gain: self.gain, zeros: roots(&self.zeros), poles: roots(&self.poles) };
        words::transfer_function::fraction(&function, unit).line()
    }
}

impl GainPeak {
    fn of(&Peak { mode, frequency, gain }: &Peak) -> Self {
        Self { mode: words::mode::title(mode), mode_key: mode.key(), frequency, gain }
    }
}

impl Measured {
    fn of(Quantity { key, dimension, .. }: Quantity) -> Self {
        Self { name: key, unit: dimension.si_symbol() }
    }
}

/// The ends that are asked for, or else those of the modes.
fn checked_range(request: &FrequencyRequest, own: (f64, f64)) -> Result<(f64, f64), ExportError> {
    let (from, to) = (request.from.unwrap_or(own.0), request.to.unwrap_or(own.1));
    let [lowest, highest] = FREQUENCIES;
    for (end, value) in [("from", from), ("to", to)] {
        if !(lowest..=highest).contains(&value) {
            let problem = format!("{end}: expected {lowest} to {highest} rad/s, found {value}");
            return Err(ExportError::Request(problem));
        }
    }
    if to <= from {
        return Err(ExportError::Request(format!("expected from below to, found {from} and {to} rad/s")));
    }
    Ok((from, to))
}

/// Unit of a gain: that of an output for one of an input.
pub fn gain_unit(output: &str, input: &str) -> String {
    if input.is_empty() { output.to_owned() } else { format!("{output} per {input}") }
}
