//! Parts of the page.

use crate::flight::aircraft::plane::Plane;
use crate::scenario::view::{Entries, Pane, StandardView, Tab};

/// A tab of the responses.
pub const fn tab(tab: Tab) -> &'static str {
    match tab {
        Tab::Time => "Time",
        Tab::Phase => "Phase",
        Tab::Frequency => "Frequency",
        Tab::Metrics => "Numbers",
    }
}

/// As what the entries of the equations stand.
pub const fn entries(entries: Entries) -> &'static str {
    match entries {
        Entries::Numbers => "Numbers",
        Entries::Symbols => "Symbols",
        Entries::Full => "In full",
    }
}

/// The same where it can't be seen.
pub const fn entries_in_words(entries: Entries) -> &'static str {
    match entries {
        Entries::Numbers => "Entries as numbers",
        Entries::Symbols => "Entries as symbols",
        Entries::Full => "Entries as what they are made of",
    }
}

/// The button of a pane.
pub const fn maximise(pane: Pane) -> &'static str {
    match pane {
        Pane::Poles => "Maximise the pole map",
        Pane::Aircraft => "Maximise the aircraft",
        Pane::Response => "Maximise the response",
        Pane::Equations => "Maximise the equations",
    }
}

/// A standard view as its button has it.
pub const fn standard_view(view: StandardView) -> &'static str {
    match view {
        StandardView::ThreeQuarter => "3/4",
        StandardView::Chase => "Chase",
        StandardView::Side => "Side",
        StandardView::Top => "Top",
    }
}

/// A standard view where its button can't be seen.
pub const fn standard_view_in_words(view: StandardView) -> &'static str {
    match view {
        StandardView::ThreeQuarter => "Three-quarter view",
        StandardView::Chase => "View from behind",
        StandardView::Side => "View from the right",
        StandardView::Top => "View from above",
    }
}

/// A plane of motion, as the switch at the top of the page has it.
pub const fn plane(plane: Plane) -> &'static str {
    match plane {
        Plane::Longitudinal => "Longitudinal",
        Plane::Lateral => "Lateral–directional",
    }
}

/// An aircraft whose name is hidden.
pub const AN_AIRCRAFT: &str = "The aircraft";

/// What stands where an aircraft is chosen whose name is hidden.
pub const NAME_HIDDEN: &str = "Aircraft: its name is hidden";

/// What stands where numbers would, were they not hidden.
pub const NUMBERS_HIDDEN: &str = "The numbers are hidden in this scene";

/// Something that can't be changed.
pub const LOCKED: &str = "Locked in this scene";
