//! A scene in a few words, as the heading of a slide that has none, and what is said of it on paper.

use super::{disturbance, mode, view};
use crate::flight::modes::mode_name::ModeName;
use crate::scenario::{Choice, Shape, Source};

/// Of which aircraft, what was changed of it, and what disturbs it. `aircraft` is its name, if it may be told; `changed` are the names of
/// what was changed.
pub fn title(aircraft: Option<&str>, changed: &[&str], disturbed: &str) -> String {
    let aircraft = aircraft.unwrap_or(view::AN_AIRCRAFT);
    match changed {
        [] => format!("{aircraft}: {disturbed}"),
        [one] => format!("{aircraft}, another {one}: {disturbed}"),
        _ => format!("{aircraft}, changed: {disturbed}"),
    }
}

/// What is said on paper of the link of a scene; nothing where it stands there with its address. `is_own` says that the aircraft is a
/// person's own.
pub fn printed(link: Option<&str>, is_own: bool) -> Option<&'static str> {
    match link {
        Some(link) if link.starts_with('#') => Some("It opens behind the address of a page of Eigenwing."),
        Some(_) => None,
        None if is_own => Some(
            "Without a link: the aircraft is too long for one. It opens again from its file, which “Take along” saves.",
        ),
        None => Some("Without a link: the aircraft is none of the list, and known by its matrices only."),
    }
}

/// Why some words of a figure look otherwise elsewhere: its letters are outlines, and these have none.
pub fn no_outline(letters: &[&str]) -> String {
    let letters = letters.join(" ");
    format!(
        "Words with {letters} stay text, in whatever font there is: figures have no outline of it. A picture from the command line lacks such words."
    )
}

/// What disturbs it. `flown` is the name of the mode that is flown alone, if it may be told.
pub fn disturbed(choice: &Choice, flown: Option<ModeName>) -> String {
    let source = match choice.source {
        Source::Elevator => "elevator",
        Source::Throttle => "throttle",
        Source::VerticalGust => "vertical gust",
        Source::HeadGust => "head gust",
        Source::Aileron => "aileron",
        Source::Rudder => "rudder",
        Source::SideGust => "side gust",
        Source::Turbulence => "turbulence",
        Source::Release => "let go away from steady flight",
        Source::OneMode => match flown {
            Some(name) => return format!("the {} alone", mode::in_a_sentence(name)),
            None => "one mode alone",
        },
        Source::PitchCommand => "pitch command",
        Source::SpeedCommand => "speed command",
        Source::HeightCommand => "height command",
        Source::BankCommand => "bank command",
        Source::YawRateCommand => "yaw-rate command",
        Source::HeadingCommand => "heading command",
    };
    match choice.shape() {
        // A gust is one whatever its shape.
        None | Some(Shape::OneMinusCosine) => source.to_owned(),
        Some(shape) => format!("{source} {}", disturbance::shape(shape)),
    }
}
