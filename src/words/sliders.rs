//! Pages of sliders and the groups on them.

use crate::scenario::Page;
use crate::scenario::parameters::Group;

/// A page of sliders.
pub const fn page(page: Page) -> &'static str {
    match page {
        Page::Coefficients => "Coefficients",
        Page::Dimensional => "Dimensional",
        Page::Matrix => "Matrix",
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
        Group::Disturbance => "Disturbance",
    }
}
