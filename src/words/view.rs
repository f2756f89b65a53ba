//! Parts of the page.

use crate::flight::aircraft::plane::Plane;
use crate::scenario::view::{Entries, Pane, StandardView, Tab};
use crate::scenario::{Notation, Units};

/// A tab of the responses.
pub const fn tab(tab: Tab) -> &'static str {
    match tab {
        Tab::Time => "Time",
        Tab::Phase => "Phase",
        Tab::Frequency => "Frequency",
        Tab::Loop => "Loop",
        Tab::Nyquist => "Nyquist",
        Tab::Map => "Gain map",
        Tab::Metrics => "Numbers",
        Tab::Chart => "Chart",
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

/// The part of the page that a pane is, for a screen reader that goes through them.
pub const fn landmark(pane: Pane) -> &'static str {
    match pane {
        Pane::Poles => "Map",
        Pane::Aircraft => "Flight",
        Pane::Response => "Motion",
        Pane::Equations => "Matrices",
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

/// The units that numbers are shown in, as their switch has them.
pub const fn units(units: Units) -> &'static str {
    match units {
        Units::Source => "as in the source",
        Units::Si => "metres",
        Units::Feet => "feet",
    }
}

/// The notation of the equations, as its switch has it.
pub const fn notation(notation: Notation) -> &'static str {
    match notation {
        Notation::Velocities => "w and v",
        Notation::Angles => "α and β",
    }
}

/// What a notation is.
pub const NOTATION_MEANING: &str = "How equations and derivatives are written: with the velocities w and v, or with the angles α = w/V and β = v/V, so that     M_α = V M_w. The motion is the same.";

/// An aircraft whose name is hidden.
pub const AN_AIRCRAFT: &str = "The aircraft";

/// What stands where an aircraft is chosen whose name is hidden.
pub const NAME_HIDDEN: &str = "Aircraft: its name is hidden";

/// What stands where numbers would, were they not hidden.
pub const NUMBERS_HIDDEN: &str = "The numbers are hidden in this scene";

/// Something that can't be changed.
pub const LOCKED: &str = "Locked in this scene";

/// A file that was dropped on a page in a frame that stays with what was opened on it.
pub const KEPT: &str = "In this frame no other lesson can be opened";

/// The goal of a task was reached while its lesson was out of sight.
pub const REACHED: &str = "✓ Done: the goal of this step is reached";

/// A link was copied that has no room for the aircraft.
pub const TOO_LONG_FOR_A_LINK: &str = "Link copied, without your aircraft: it is too long for a link. Elsewhere it opens after its \
    file, which Take along (X) saves";
