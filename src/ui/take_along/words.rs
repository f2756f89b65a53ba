//! The forms in which a scene is taken along.

use crate::export::Target;
use crate::scenario::view::{Pane, Tab};

/// The targets in the order of the sheet, in groups with a title.
pub const GROUPS: [(&str, &[Target]); 5] = [
    ("Scripts", &[Target::Python, Target::Notebook, Target::Matlab, Target::Latex]),
    ("The aircraft", &[Target::Toml, Target::Json, Target::Derivatives, Target::Jsbsim]),
    (
        "What is on screen as numbers",
        &[
            Target::Poles,
            Target::Modes,
            Target::Response,
            Target::Metrics,
            Target::Frequency,
            Target::Chart,
            Target::Levels,
        ],
    ),
    (
        "Figures",
        &[
            Target::PolesFigure,
            Target::ResponseFigure,
            Target::FrequencyFigure,
            Target::ChartFigure,
            Target::AircraftFigure,
        ],
    ),
    ("Paper", &[Target::Page]),
];

/// The targets of a pane, its figure first.
pub const fn of_pane(pane: Pane, tab: Tab) -> (&'static str, &'static [Target]) {
    match (pane, tab) {
        (Pane::Poles, _) => ("The pole map", &[Target::PolesFigure, Target::Poles, Target::Modes]),
        (Pane::Aircraft, _) => ("The aircraft on screen", &[Target::AircraftFigure]),
        (Pane::Response, Tab::Frequency) => {
            ("The frequency response", &[Target::FrequencyFigure, Target::Frequency])
        }
        (Pane::Response, Tab::Chart) => ("The chart", &[Target::ChartFigure, Target::Chart]),
        (Pane::Response, Tab::Metrics) => {
            ("The numbers of the response", &[Target::Metrics, Target::Response])
        }
        (Pane::Response, _) => ("The response", &[Target::ResponseFigure, Target::Response]),
        (Pane::Equations, _) => ("The equations", &[Target::Latex, Target::Json]),
    }
}

/// The button that takes a pane along.
pub const fn take_pane(pane: Pane) -> &'static str {
    match pane {
        Pane::Poles => "Save or copy the pole map",
        Pane::Aircraft => "Save or copy the picture of the aircraft",
        Pane::Response => "Save or copy the response",
        Pane::Equations => "Save or copy the equations",
    }
}

/// A target, as its button says it.
pub const fn target(target: Target) -> &'static str {
    match target {
        Target::Python => "Python",
        Target::Notebook => "Notebook",
        Target::Matlab => "MATLAB, Octave",
        Target::Latex => "LaTeX",
        Target::Toml => "Aircraft file",
        Target::Json => "Matrices",
        Target::Derivatives => "Derivatives",
        Target::Jsbsim => "JSBSim",
        Target::Poles => "Pole map",
        Target::Modes => "Modes",
        Target::Response => "Response",
        Target::Metrics => "Numbers of the response",
        Target::Frequency => "Frequency response",
        Target::Chart => "Chart",
        Target::Levels => "Levels",
        Target::PolesFigure => "Figure of the pole map",
        Target::ResponseFigure => "Figure of the response",
        Target::FrequencyFigure => "Figure of the frequency response",
        Target::ChartFigure => "Figure of the chart",
        Target::AircraftFigure => "Figure of the aircraft",
        Target::Page => "Page of paper",
    }
}

/// What a target is good for.
pub const fn hint(target: Target) -> &'static str {
    match target {
        Target::Python => {
            "A script for python-control (.py): matrices, modes, and what is on screen drawn again"
        }
        Target::Notebook => "The same as a Jupyter notebook (.ipynb)",
        Target::Matlab => "A script for MATLAB or GNU Octave (.m)",
        Target::Latex => "Matrices and modes for a report (.tex)",
        Target::Toml => "The aircraft with what was changed on it (.toml); this page opens it again",
        Target::Json => "A and B of the plane on screen (.json)",
        Target::Jsbsim => "An aircraft for the simulator JSBSim (.xml)",
        Target::Derivatives => "Every number of the aircraft (.csv)",
        Target::Poles => "Eigenvalues (.csv)",
        Target::Modes => "Names, frequencies, damping, times (.csv)",
        Target::Response => "The motion over time (.csv)",
        Target::Metrics => "Peaks, rise and settling times, overshoot (.csv)",
        Target::Frequency => "Gain and phase (.csv)",
        Target::Chart => "A measure over a slider (.csv)",
        Target::Levels => "Levels of handling qualities by paragraph (.json)",
        Target::PolesFigure
        | Target::ResponseFigure
        | Target::FrequencyFigure
        | Target::ChartFigure
        | Target::AircraftFigure => "On white, for paper",
        Target::Page => "Poles, aircraft, modes, motion and link on one page (.html)",
    }
}
