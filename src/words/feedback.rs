//! The law of feedback and the further states of a source: whether what is on screen flies under it and with them, and what states are
//! called.

use crate::findings::{LeastGain, NoLeastGain};
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::LoopError;
use crate::flight::feedback::appended::AppendedState;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::verdicts::handling_qualities::Level;
use crate::words::mode;

/// Above the verdicts, where a law flies.
pub const UNDER_LAW: &str =
    "Under the law of feedback. Static stability and approximations are of the aircraft alone.";

/// The same where its loop is shown open.
pub const SHOWN_OPEN: &str = "The loop is shown open: the aircraft without its law of feedback";

/// On the page of gains, where all are zero.
pub const NOTHING_FED_BACK: &str = "Nothing is fed back: every gain is zero";

/// At the head of what is taken along, and beside it.
pub const TAKEN_WITHOUT: &str =
    "This is the aircraft without its law of feedback, but for A_whole and B_whole in scripts.";

/// Above the verdicts of an aircraft with further states and without a law.
pub const WITH_FURTHER: &str = "With the states that the file has beside these four. Static stability and approximations are of the four.";

/// Where something is shown that neither a law nor further states change.
pub const fn alone(is_fed_back: bool) -> &'static str {
    if is_fed_back { "Of the aircraft without its law of feedback" } else { "Of the four states alone" }
}

/// The list of gains whose least is looked for.
pub const LEAST_GAIN: &str = "Least gain for Level 1 ▾";
/// The same for who doesn't see it.
pub const LEAST_GAIN_NAME: &str = "Least gain for Level 1";
/// What it does.
pub const LEAST_GAIN_MEANING: &str = "Brings a gain of your choice as little away from zero as this plane needs to be at Level 1, all else as it is";
/// Why it can't.
pub const NOT_JUDGED: &str =
    "Choose a class of aircraft above the mode cards first: levels are judged for one";

/// What came of it; `shown` writes a gain with its unit.
pub fn least_gain(found: &Result<LeastGain, NoLeastGain>, shown: impl Fn(f64) -> String) -> String {
    match found {
        Ok(LeastGain { gain, .. }) if *gain == 0.0 => "Level 1 needs none of it".to_owned(),
        Ok(LeastGain { gain, ranges }) => {
            let range = ranges.iter().find(|range| (range[0]..=range[1]).contains(gain));
            let [low, high] = range.copied().unwrap_or([*gain; 2]);
            let far = if *gain < 0.0 { low } else { high };
            format!("Level 1 from {} to {}", shown(*gain), shown(far))
        }
        Err(NoLeastGain::Nowhere { best: Some((level, gain)) }) => {
            let level = match level {
                Level::One => "Level 1",
                Level::Two => "Level 2",
                Level::Three => "Level 3",
                Level::Beyond => "worse than Level 3",
            };
            format!("no gain of this slider reaches Level 1; the best is {level}, at {}", shown(*gain))
        }
        Err(NoLeastGain::Nowhere { best: None }) => {
            "no gain of this slider reaches Level 1: with none of them can a level be told".to_owned()
        }
        Err(NoLeastGain::NotAGain | NoLeastGain::NotJudged) => NOT_JUDGED.to_owned(),
    }
}

/// The first choice of whether the loop is shown closed or open.
pub const CLOSED: &str = "Closed";
/// What the first shows.
pub const CLOSED_MEANING: &str =
    "Everything as it flies under the law; poles without it are marked by hollow squares";
/// The second choice.
pub const OPEN: &str = "Open";
/// What it shows.
pub const OPEN_MEANING: &str =
    "Everything as it flies without the law; poles under it are marked by hollow squares";

/// The crosses and the hollow squares of the pole map.
pub const fn legend(is_opened: bool, is_fed_back: bool) -> [&'static str; 2] {
    match (is_opened, is_fed_back) {
        (true, _) => ["without the law", "under it"],
        (false, true) => ["under the law", "without it"],
        (false, false) => ["with all states", "the four alone"],
    }
}

/// Of a mode that is flown alone under the law.
pub fn not_alone(mode: ModeName) -> String {
    let name = mode::in_a_sentence(mode);
    format!(
        "The aircraft alone has no {name}: its own motion is at rest, and the {name} is flown under the law."
    )
}

/// Of a fast actuator, whose pole would leave no room for the others.
pub const OUT_OF_SIGHT: &str = "So far to the left of the others that the map begins without it";

/// Why nothing follows under a law, and what is shown instead.
pub fn problem(error: &LoopError) -> String {
    format!("Under the law of feedback this can’t be analysed: {error}. Shown is the aircraft without it.")
}

/// What a law moves each input of a plane by: symbol and name.
pub const fn moved(plane: Plane) -> [(&'static str, &'static str); 2] {
    match plane {
        Plane::Longitudinal => [("δ_{e,law}", "elevator by the law"), ("δ_{t,law}", "throttle by the law")],
        Plane::Lateral => [("δ_{a,law}", "aileron by the law"), ("δ_{r,law}", "rudder by the law")],
    }
}

/// A state beside the four, short and in words.
pub const fn state(state: AppendedState) -> [&'static str; 2] {
    match state {
        AppendedState::Height => ["h", "height"],
        AppendedState::Heading => ["ψ", "heading"],
        AppendedState::Distance => ["x", "distance"],
        AppendedState::Offset => ["y", "displacement"],
        AppendedState::PitchRateWashout | AppendedState::YawRateWashout => ["washout", "washout"],
        AppendedState::Elevator => ["δe", "elevator’s actuator"],
        AppendedState::Throttle => ["δt", "engine"],
        AppendedState::Engine => ["engine", "engine"],
        AppendedState::Other => ["other", "another state"],
        AppendedState::Aileron => ["δa", "aileron’s actuator"],
        AppendedState::Rudder => ["δr", "rudder’s actuator"],
    }
}
