//! What is taken along of a scene: scripts, files, data and figures, each as one text.

use serde::Serialize;

use super::closed_loop::LoopOutcome;
use super::disturbance::no_motion;
use super::error::ExportError;
use super::link::{DisturbanceRequest, disturbed};
use super::plane::PlaneReport;
use super::scene::Scene;
use super::script::study::Study;
use super::script::{aircraft_files, data, jsbsim, latex, levels, matlab, notebook, python};
use super::{figure, page};
use crate::findings::measures::Measure;
use crate::findings::{Findings, MeasureChart};
use crate::key::{Keyed, keys, nearest};
use crate::scenario::view::Tab;
use crate::scenario::{Parameter, Scenario};
use crate::words;

/// A form in which a scene is taken along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A script for python-control.
    Python,
    /// The same as a Jupyter notebook.
    Notebook,
    /// A script for MATLAB and GNU Octave.
    Matlab,
    /// Matrices and modes for a report.
    Latex,
    /// The aircraft as an aircraft file.
    Toml,
    /// The plane on screen as bare matrices.
    Json,
    /// The aircraft for JSBSim.
    Jsbsim,
    /// Every number of the aircraft, as CSV.
    Derivatives,
    /// The pole map, as CSV.
    Poles,
    /// The modes, as CSV.
    Modes,
    /// The motion over time, as CSV.
    Response,
    /// The numbers of the motion, as CSV.
    Metrics,
    /// Gain and phase over frequency, as CSV.
    Frequency,
    /// A measure over a slider, as CSV.
    Chart,
    /// Levels of handling qualities by paragraph, as JSON.
    Levels,
    /// The pole map, as a figure.
    PolesFigure,
    /// The motion over time, as a figure.
    ResponseFigure,
    /// Gain and phase over frequency, as a figure.
    FrequencyFigure,
    /// A measure over a slider, as a figure.
    ChartFigure,
    /// The aircraft, as a figure.
    AircraftFigure,
    /// The scene as a page of paper.
    Page,
}

keys! {
    Target {
        Python => "python" | "py",
        Notebook => "notebook" | "jupyter" | "ipynb",
        Matlab => "matlab" | "octave" | "m",
        Latex => "latex" | "tex",
        Toml => "toml",
        Json => "json",
        Jsbsim => "jsbsim",
        Derivatives => "derivatives",
        Poles => "poles",
        Modes => "modes",
        Response => "response",
        Metrics => "metrics" | "figures",
        Frequency => "frequency",
        Chart => "chart",
        Levels => "levels",
        PolesFigure => "poles-figure" | "poles-svg",
        ResponseFigure => "response-figure" | "response-svg",
        FrequencyFigure => "frequency-figure" | "frequency-svg",
        ChartFigure => "chart-figure" | "chart-svg",
        AircraftFigure => "aircraft-figure" | "aircraft-svg",
        Page => "page" | "print" | "html",
    }
}

impl Target {
    /// Ending of its files and its media type.
    pub const fn form(self) -> (&'static str, &'static str) {
        match self {
            Self::Python => ("py", "text/x-python"),
            Self::Notebook => ("ipynb", "application/x-ipynb+json"),
            Self::Matlab => ("m", "text/x-matlab"),
            Self::Latex => ("tex", "application/x-tex"),
            Self::Toml => ("toml", "application/toml"),
            Self::Jsbsim => ("xml", "application/xml"),
            Self::Json | Self::Levels => ("json", "application/json"),
            Self::Derivatives
            | Self::Poles
            | Self::Modes
            | Self::Response
            | Self::Metrics
            | Self::Frequency
            | Self::Chart => ("csv", "text/csv"),
            Self::PolesFigure
            | Self::ResponseFigure
            | Self::FrequencyFigure
            | Self::ChartFigure
            | Self::AircraftFigure => ("svg", "image/svg+xml"),
            Self::Page => ("html", "text/html"),
        }
    }
}

/// What was taken along.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "TakenAlong"))]
pub struct TakenAlong {
    /// The text.
    pub text: String,
    /// A name for its file.
    pub file: String,
    /// Its media type.
    pub media_type: &'static str,
    /// What of the link can't be used, and what of the scene has no place in it, in sentences.
    pub notices: Vec<String>,
}

/// A scene in another program's form, by the key of the target.
pub fn take_along(
    scene: &Scene,
    wanted: &str,
    request: &DisturbanceRequest,
) -> Result<TakenAlong, ExportError> {
    let target = Target::by_key(wanted).ok_or_else(|| {
        let keys = || Target::VALUES.iter().map(|target| target.key());
        ExportError::Request(match nearest(wanted, keys()) {
            Some(nearest) => format!("there is no target \"{wanted}\"; did you mean \"{nearest}\"?"),
            None => {
                format!(
                    "there is no target \"{wanted}\"; expected one of {}",
                    keys().collect::<Vec<_>>().join(", ")
                )
            }
        })
    })?;
    let scene = disturbed(scene, request)?;
    let findings = Findings::of(scene.scenario.clone()).opened(scene.view.shows_open);
    let mut notices = scene.notices.clone();
    let text = text(target, &scene, &findings, &mut notices)?;
    let (ending, media_type) = target.form();
    let file = format!("{}-{}.{ending}", scene.scenario.aircraft.key, target.key());
    Ok(TakenAlong { text, file, media_type, notices })
}

fn text(
    target: Target,
    scene: &Scene,
    findings: &Findings,
    notices: &mut Vec<String>,
) -> Result<String, ExportError> {
    let analysis = || findings.plane().ok_or_else(|| no_motion(findings));
    let flown = || findings.flown().ok_or_else(|| no_motion(findings));
    let plane = || {
        let Scenario { plane, notation, .. } = *findings.scenario();
        let closed_loop = LoopOutcome::of(findings, plane);
        Ok::<_, ExportError>(PlaneReport { closed_loop, ..PlaneReport::of(analysis()?, notation) })
    };
    let study = || Study::of(scene, findings).ok_or_else(|| no_motion(findings));
    let charted = || charted(scene, findings.scenario());
    let shows_flight = scene.view.response.nonlinear;
    if shows_flight && matches!(target, Target::Python | Target::Notebook | Target::Matlab | Target::Response)
    {
        notices.push("The nonlinear flight isn't taken along: it is the linear motion.".to_owned());
    }
    let is_without_law = matches!(
        target,
        Target::Python | Target::Notebook | Target::Matlab | Target::Latex | Target::Json | Target::Jsbsim
    );
    if is_without_law && !findings.scenario().law.is_open(findings.scenario().plane) {
        notices.push(words::feedback::TAKEN_WITHOUT.to_owned());
    }
    let taken = match target {
        Target::Python => python::python(&study()?),
        Target::Notebook => indented(&notebook::notebook(&study()?)),
        Target::Matlab => matlab::matlab(&study()?),
        Target::Latex => latex::latex(&study()?, findings.scenario().length_unit()),
        Target::Toml => aircraft_files::toml(scene)?,
        Target::Json => indented(&aircraft_files::matrices(scene, &plane()?)),
        Target::Jsbsim => jsbsim::jsbsim(scene, notices)?,
        Target::Derivatives => data::derivatives(findings),
        Target::Poles => data::poles(&plane()?),
        Target::Modes => data::modes(&plane()?),
        Target::Response => data::response(scene)?,
        Target::Metrics => data::metrics(findings).ok_or_else(|| no_motion(findings))?,
        Target::Frequency => data::bode(scene)?,
        Target::Chart => data::chart(findings, charted()?),
        Target::Levels => indented(&levels::levels(findings)?),
        Target::PolesFigure => figure::poles(scene, findings, flown()?),
        Target::ResponseFigure => figure::response(scene, findings).ok_or_else(|| no_motion(findings))?,
        Target::FrequencyFigure => figure::frequency(scene, findings).ok_or_else(|| no_motion(findings))?,
        Target::ChartFigure => figure::chart(scene, findings, charted()?),
        Target::AircraftFigure => figure::aircraft(findings).ok_or_else(|| no_motion(findings))?,
        Target::Page => {
            let motion = match scene.view.response.tab {
                Tab::Frequency => figure::frequency(scene, findings),
                Tab::Chart => Some(figure::chart(scene, findings, charted()?)),
                _ => figure::response(scene, findings),
            };
            page::page(scene, findings, flown()?, motion.as_deref())
        }
    };
    if matches!(target.form().0, "svg" | "html") {
        let letters = figure::without_outline(&taken);
        if !letters.is_empty() {
            notices.push(words::scene::no_outline(&letters));
        }
    }
    Ok(taken)
}

/// The slider and the measure of the chart.
fn charted(scene: &Scene, scenario: &Scenario) -> Result<(&'static Parameter, Measure), ExportError> {
    let view = &scene.view.response.chart[scenario.plane];
    let parameter = view.over(scenario).ok_or_else(|| words::chart::NO_SLIDER.to_owned());
    let measure = Measure::find(&view.measure).filter(|measure| MeasureChart::can_show(*measure));
    let measure = measure.ok_or_else(|| words::chart::unknown(&view.measure));
    let problem = |sentence: String| ExportError::Request(sentence.trim_end_matches('.').to_owned());
    Ok((parameter.map_err(problem)?, measure.map_err(problem)?))
}

fn indented(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}
