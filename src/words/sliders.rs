//! Pages of sliders and the groups on them.

use crate::scenario::Page;
use crate::scenario::parameters::Group;

/// A page of sliders.
pub const fn page(page: Page) -> &'static str {
    match page {
        Page::Coefficients => "Coefficients",
        Page::Dimensional => "Dimensional",
        Page::Matrix => "Matrix",
        Page::Feedback => "Feedback",
    }
}

/// A group of sliders.
pub const fn group(group: Group) -> &'static str {
    match group {
        Group::Speed => "Speed",
        Group::AngleOfAttack => "Angle of attack",
        Group::AngleOfAttackRate => "Rate of angle of attack",
        Group::PitchRate => "Pitch rate",
        Group::Sideslip => "Sideslip",
        Group::RollRate => "Roll rate",
        Group::YawRate => "Yaw rate",
        Group::Attitude => "Gravity",
        Group::Elevator => "Elevator",
        Group::Throttle => "Throttle",
        Group::Aileron => "Aileron",
        Group::Rudder => "Rudder",
        Group::Aircraft => "Aircraft and flight condition",
        Group::Mach => "Mach number",
        Group::Filters => "Washout and lags",
        Group::Disturbance => "Disturbance",
    }
}

/// Above the list of what moves the modes most.
pub const fn strongest(page: Page) -> &'static str {
    match page {
        Page::Coefficients | Page::Dimensional | Page::Matrix => "Which derivative moves which mode",
        Page::Feedback => "Which gain moves which mode",
    }
}

/// What stands in place of the sliders where a page has none.
pub const NONE: &str = "No slider of this page, since this can't be analysed.";

/// The same where none of its sliders is offered.
pub const NOT_OFFERED: &str = "No slider of this page is offered here.";

/// The same where a search has left none.
pub fn no_match(search: &str) -> String {
    format!("No slider of this page matches “{search}”.")
}

/// In a pane that shows what followed last, where nothing follows from the sliders as they are.
pub const AS_IT_WAS: &str = "As it was last: with the sliders as they are it can't be analysed.";

/// In a pane where nothing has ever followed.
pub const NOTHING: &str = "Nothing to show, since this can't be analysed.";

/// Where the equations are, for who searches for them among the sliders.
pub const EQUATIONS: &str = "The equations are behind the button beside this field (E).";

/// Where a search of the sliders would have found one.
pub fn elsewhere(name: &str, place: &str) -> String {
    format!("The {name} is under {place}.")
}
