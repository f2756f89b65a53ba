//! Bare matrices A and B with named states, from JSON, CSV or MATLAB text, as a study like any other.
//!
//! Every form says the same things, and each is required but for those in brackets:
//!
//! | key | meaning |
//! |---|---|
//! | `units` | `"SI"` (metres) or `"ft-slug-s"` (feet); time is in seconds |
//! | \[`angles`\] | `"rad"`, which is also meant where it is missing, `"deg"` or `"crad"`, a hundredth of a radian: of every angle, rate, elevator, aileron and rudder |
//! | `speed` (`V`) or `u0` (`U0`) | true airspeed, or its part along the *x* axis, in the unit of length over seconds |
//! | \[`alpha0_deg`, `gamma0_deg`\] | trim angle of attack of the *x* axis and flight-path angle, zero where missing |
//! | `states` | four names in the order of the file: *u*, *w* or α, *q*, θ; or *v* or β, *p*, *r*, φ |
//! | `inputs` | a name for each column of B: elevator, throttle; or aileron, rudder |
//! | `A`, \[`B`\] | four rows; without B there are no inputs |
//! | \[`name`\] | words for a title |
//!
//! An exact similarity turns the matrices read into the order, units and states of [`crate::flight`].

mod decimal_commas;
pub(super) mod draft;
pub(super) mod form_bare;
pub(super) mod form_csv;
pub(super) mod form_json;
pub(super) mod form_matlab;
pub(super) mod names;
mod script_tokens;
pub(super) mod state_names;

use super::aircraft::{Aircraft, ContentError};
use draft::{Draft, Problem};

/// A form in which matrices are written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixFormat {
    /// An object: `{"units": "SI", "speed": 54, "states": […], "inputs": […], "A": [[…], …], "B": [[…], …]}`.
    Json,
    /// Settings such as `units,SI`, then a row of names (states, then inputs), then a row of numbers for each state; a row may
    /// begin with the name of its state.
    Csv,
    /// `A = [ … ; … ];` and the same for B, with the settings as variables or as comments such as `% units: SI`.
    Matlab,
}

impl MatrixFormat {
    /// The forms by the name that a request gives them, which is also how their files end.
    pub const NAMES: [(&'static str, Self); 3] =
        [("json", Self::Json), ("csv", Self::Csv), ("m", Self::Matlab)];

    /// The form that a file's name ends in.
    pub fn of_file(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        let found = Self::NAMES.iter().find(|(known, _)| ending.eq_ignore_ascii_case(known));
        found.map(|&(_, format)| format)
    }
}

/// The text with U+2212, a true minus sign as this program prints it, as the hyphen that number readers know; elsewhere than before
/// a number it stays. So it is with the dash that word processors make of a hyphen, unless it stands between two numbers.
pub(super) fn plain_signs(text: &str) -> String {
    let mut rest = text.chars().peekable();
    let mut plain = String::with_capacity(text.len());
    let mut before = ' ';
    while let Some(c) = rest.next() {
        let is_sign = c == '−' || (c == '–' && !before.is_alphanumeric());
        let signs = is_sign && rest.peek().is_some_and(|next| next.is_ascii_digit() || *next == '.');
        plain.push(if signs { '-' } else { c });
        before = c;
    }
    plain
}

/// A text without a matrix A says so before anything else is asked of it.
fn with_a(draft: Draft) -> Result<Draft, Problem> {
    if draft.has("A") {
        Ok(draft)
    } else {
        Err((1, "A: missing; expected a line that begins with \"A = [\"".to_owned()))
    }
}

impl Aircraft {
    /// Reads bare matrices and converts them to SI; `file` is its name for messages and, without a `name`, its title.
    pub fn from_matrices(file: &str, text: &str, format: MatrixFormat) -> Result<Self, ContentError> {
        // Windows' editors begin a text with a mark of its encoding.
        let text = &plain_signs(text.trim_start_matches('\u{feff}'));
        let problem = |(line, problem)| ContentError { file: file.to_owned(), line, problem };
        if text.trim().is_empty() {
            return Err(problem((1, "the file is empty; expected the matrices A and B".to_owned())));
        }
        let draft = match format {
            MatrixFormat::Json => form_json::read(text),
            MatrixFormat::Csv => form_csv::read(text),
            MatrixFormat::Matlab => form_matlab::read(text).and_then(with_a),
        };
        draft.and_then(|draft| draft.into_aircraft(file)).map_err(problem)
    }
}
