//! The words of a link that are no parameters. They never change, whatever the program calls things.

use super::super::view::{Pane, StandardView, Tab};
use super::super::{Page, Shape, Source};
use crate::flight::aircraft::plane::Plane;

/// Before the key of a derivative or matrix entry: the number is added to the value that follows from the rest.
pub(super) const ADDED: &str = "add.";

/// Before the keys of the pinned state.
pub(super) const PINNED: &str = "pin.";

/// The parameter of the time shown: with a value it stays.
pub(super) const TIME: &str = "time";

/// The time shown, where it follows the slowest mode that is seen: its value at present.
pub(super) const FOLLOWS: &str = "follows";

pub(super) const PLANES: [(&str, Plane); 2] = [("lon", Plane::Longitudinal), ("lat", Plane::Lateral)];

pub(super) const PAGES: [(&str, Page); 3] =
    [("coefficients", Page::Coefficients), ("dimensional", Page::Dimensional), ("matrix", Page::Matrix)];

pub(super) const TABS: [(&str, Tab); 4] =
    [("time", Tab::Time), ("phase", Tab::Phase), ("frequency", Tab::Frequency), ("figures", Tab::Metrics)];

/// Whether the nonlinear flight is drawn too.
pub(super) const FLIGHTS: [(&str, bool); 2] = [("linear", false), ("nonlinear", true)];

/// Whether motions over time are split into modes.
pub(super) const SPLITS: [(&str, bool); 2] = [("whole", false), ("modes", true)];

/// Whether the playback begins again at its end.
pub(super) const LOOPS: [(&str, bool); 2] = [("off", false), ("on", true)];

/// Seconds of motion played in a second.
pub(super) const RATES: [(&str, f64); 5] = [("0.25", 0.25), ("0.5", 0.5), ("1", 1.0), ("2", 2.0), ("4", 4.0)];

pub(super) const PANES: [(&str, Pane); 3] =
    [("poles", Pane::Poles), ("aircraft", Pane::Aircraft), ("response", Pane::Response)];

pub(super) const STANDARD_VIEWS: [(&str, StandardView); 4] = [
    ("three-quarter", StandardView::ThreeQuarter),
    ("chase", StandardView::Chase),
    ("side", StandardView::Side),
    ("top", StandardView::Top),
];

/// A list with nothing in it.
pub(super) const NOTHING: &str = "none";

pub(super) const MARKS: [&str; 2] = ["approximations", "levels"];

pub(super) const DETAILS: [&str; 3] = ["shape", "levels", "approximations"];

pub(super) const OVERLAYS: [&str; 8] =
    ["body", "earth", "angles", "rates", "forces", "flow", "path", "moments"];

pub(super) const SOURCES: [(&str, Source); 10] = [
    ("elevator", Source::Elevator),
    ("throttle", Source::Throttle),
    ("gust", Source::VerticalGust),
    ("head_gust", Source::HeadGust),
    ("aileron", Source::Aileron),
    ("rudder", Source::Rudder),
    ("side_gust", Source::SideGust),
    ("turbulence", Source::Turbulence),
    ("release", Source::Release),
    ("mode", Source::OneMode),
];

pub(super) const SHAPES: [(&str, Shape); 7] = [
    ("step", Shape::Step),
    ("pulse", Shape::Pulse),
    ("doublet", Shape::Doublet),
    ("3211", Shape::ThreeTwoOneOne),
    ("sine", Shape::Sine),
    ("sweep", Shape::Sweep),
    ("1-cos", Shape::OneMinusCosine),
];

/// The mode flown alone, counted from one as a person does.
pub(super) const MODES: [(&str, usize); 4] = [("1", 0), ("2", 1), ("3", 2), ("4", 3)];

pub(super) const fn plane(plane: Plane) -> &'static str {
    match plane {
        Plane::Longitudinal => "lon",
        Plane::Lateral => "lat",
    }
}

pub(super) fn word_of<T: PartialEq>(words: &[(&'static str, T)], meaning: T) -> Option<&'static str> {
    words.iter().find(|(_, other)| *other == meaning).map(|(word, _)| *word)
}

pub(super) fn meaning_of<T: Copy>(words: &[(&str, T)], word: &str) -> Option<T> {
    words.iter().find(|(other, _)| *other == word).map(|(_, meaning)| *meaning)
}

pub(super) fn can_disturb(plane: Plane, source: Source) -> bool {
    Source::of(plane).contains(&source)
}

/// Whether a control can move so.
pub(super) fn is_of_control(shape: Shape) -> bool {
    Source::Elevator.shapes().contains(&shape)
}

/// Whether a gust can have this shape.
pub(super) fn is_of_gust(shape: Shape) -> bool {
    Source::VerticalGust.shapes().contains(&shape)
}
