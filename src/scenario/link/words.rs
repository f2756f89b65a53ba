//! The words of a link that are neither parameters nor keys of a list. They never change, whatever the program calls things.

use crate::flight::aircraft::further::MOST_FURTHER;

/// Before the key of a derivative or matrix entry: the number is added to the value that follows from the rest.
pub(super) const ADDED: &str = "add.";

/// Before the keys of the pinned state.
pub(super) const PINNED: &str = "pin.";

/// The units in which numbers are shown.
pub(super) const UNITS: &str = "units";

/// The notation in which equations are shown.
pub(super) const NOTATION: &str = "notation";

/// The aircraft itself, where it is none of those that ship.
pub(super) const OWN: &str = "own";

/// Class of aircraft that levels are judged for.
pub(super) const CLASS: &str = "class";

/// Category of flight phase that levels are judged for.
pub(super) const CATEGORY: &str = "category";

/// The parameter of the time shown: with a value it stays.
pub(super) const TIME: &str = "time";

/// The time shown, where it follows the slowest mode that is seen: its value at present.
pub(super) const FOLLOWS: &str = "follows";

/// Whether the nonlinear flight is drawn too.
pub(super) const FLIGHTS: [(&str, bool); 2] = [("linear", false), ("nonlinear", true)];

/// Whether motions over time are split into modes.
pub(super) const SPLITS: [(&str, bool); 2] = [("whole", false), ("modes", true)];

/// Whether the playback begins again at its end.
pub(super) const LOOPS: [(&str, bool); 2] = [("off", false), ("on", true)];

/// Whether the playback plays when the scene is opened.
pub(super) const PLAYS: [(&str, bool); 2] = [("off", false), ("on", true)];

/// Whether the aircraft is shown as it flies without its law of feedback.
pub(super) const FEEDBACKS: [(&str, bool); 2] = [("closed", false), ("open", true)];

/// How the page looks.
pub(super) const LOOK: &str = "look";

/// Whether the scene fills the screen.
pub(super) const PRESENT: &str = "present";

/// The same as a word.
pub(super) const PRESENTS: [(&str, bool); 2] = [("off", false), ("on", true)];

/// Most modes of a plane: of its four states, the further ones of its source, and the four that a law appends, which are the place on the
/// path, a washout and two actuators.
const MOST_MODES: usize = 4 + MOST_FURTHER + 4;

/// Seconds of motion played in a second.
pub(super) const RATES: [(&str, f64); 9] = [
    ("0.125", 0.125),
    ("0.25", 0.25),
    ("0.5", 0.5),
    ("1", 1.0),
    ("2", 2.0),
    ("4", 4.0),
    ("8", 8.0),
    ("16", 16.0),
    ("32", 32.0),
];

/// A list with nothing in it.
pub(super) const NOTHING: &str = "none";

pub(super) const MARKS: [&str; 2] = ["approximations", "levels"];

pub(super) const DETAILS: [&str; 3] = ["shape", "levels", "approximations"];

pub(super) const OVERLAYS: [&str; 9] =
    ["body", "earth", "angles", "rates", "forces", "flow", "path", "moments", "stability"];

/// The mode by whose sensitivity the equations are coloured, counted from one.
pub(super) const COLOURED: [(&str, Option<usize>); 5] =
    [("1", Some(0)), ("2", Some(1)), ("3", Some(2)), ("4", Some(3)), (NOTHING, None)];

/// The place of a mode that is flown alone, which is counted from one as a person does; of as many as there can be.
pub(super) fn place_of_mode(number: &str) -> Option<usize> {
    let is_number = number.bytes().all(|byte| byte.is_ascii_digit()) && !number.starts_with('0');
    number
        .parse()
        .ok()
        .filter(|number| is_number && (1..=MOST_MODES).contains(number))
        .map(|number: usize| number - 1)
}

pub(super) fn word_of<T: PartialEq>(words: &[(&'static str, T)], meaning: T) -> Option<&'static str> {
    words.iter().find(|(_, other)| *other == meaning).map(|(word, _)| *word)
}

pub(super) fn meaning_of<T: Copy>(words: &[(&str, T)], word: &str) -> Option<T> {
    words.iter().find(|(other, _)| *other == word).map(|(_, meaning)| *meaning)
}
