//! What a link that is handed in says beside its scene: whose it is, and which help they had: `by=Ada%20Lovelace&help=2.solution`.

use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};

use super::pieces::Pieces;

/// Longest name that is read \[characters\].
const LONGEST_NAME: usize = 100;

/// The word for a solution that was shown.
const SOLUTION: &str = "solution";

/// Whose work a link is, and which help they had.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HandedIn {
    /// The name or number that they typed.
    pub by: String,
    /// How many hints were shown.
    pub hints: usize,
    /// Whether a solution was shown before the goal was reached.
    pub solution_shown: bool,
}

impl HandedIn {
    /// The pieces of a link, with an `&` before each.
    pub fn in_link(&self) -> String {
        let hints = (self.hints > 0).then(|| self.hints.to_string());
        let help: Vec<String> =
            hints.into_iter().chain(self.solution_shown.then(|| SOLUTION.to_owned())).collect();
        let help = if help.is_empty() { String::new() } else { format!("&help={}", help.join(".")) };
        format!("&by={}{help}", utf8_percent_encode(&self.by, NON_ALPHANUMERIC))
    }

    /// Takes its pieces out of a link; `None` where nobody's name is in it.
    pub(super) fn read(pieces: &mut Pieces) -> Option<Self> {
        let help = |word: &str| (word == SOLUTION).then_some(None).or_else(|| word.parse().ok().map(Some));
        let help: Vec<Option<usize>> = pieces.take_list("help", &[SOLUTION], help);
        let by = pieces.take("by")?.trim().chars().take(LONGEST_NAME).collect();
        let hints = help.iter().flatten().copied().max().unwrap_or(0);
        Some(Self { by, hints, solution_shown: help.contains(&None) })
    }
}
