//! Disturbances: what moves, in which shape.

use crate::scenario::{Choice, Shape, Source};

/// The source of a disturbance.
pub const fn source(source: Source) -> &'static str {
    match source {
        Source::Elevator => "Elevator",
        Source::Throttle => "Throttle",
        Source::VerticalGust => "Vertical gust",
        Source::HeadGust => "Head gust",
        Source::Aileron => "Aileron",
        Source::Rudder => "Rudder",
        Source::SideGust => "Side gust",
        Source::Turbulence => "Turbulence",
        Source::Release => "Initial state",
        Source::OneMode => "One mode",
        Source::PitchCommand => "Pitch command",
        Source::SpeedCommand => "Speed command",
        Source::HeightCommand => "Height command",
        Source::BankCommand => "Bank command",
        Source::YawRateCommand => "Yaw-rate command",
        Source::HeadingCommand => "Heading command",
    }
}

/// The shape of a control or gust in time.
pub const fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::Step => "step",
        Shape::Pulse => "pulse",
        Shape::Doublet => "doublet",
        Shape::ThreeTwoOneOne => "3-2-1-1",
        Shape::Sine => "sine",
        Shape::Sweep => "sweep",
        Shape::OneMinusCosine => "1 − cosine",
    }
}

/// A disturbance with its shape: "Elevator step".
pub fn choice(choice: &Choice) -> String {
    match choice.shape() {
        Some(of) => format!("{} {}", source(choice.source), shape(of)),
        None => source(choice.source).to_owned(),
    }
}

/// Said where the height falls below sea level.
pub const BELOW_GROUND: &str = "The height falls below sea level: the linear model knows no ground, and asks only how the motion goes on.";
