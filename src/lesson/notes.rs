//! Notes for whoever presents: the fenced block `notes`. They are never on the slide, nor beside the scene of a lesson.

use super::text::Text;
use crate::content::ContentError;

/// Notes.
#[derive(Clone, Debug, PartialEq)]
pub struct Notes {
    /// How long the step is to take \[min\].
    pub minutes: Option<f64>,
    /// What they say.
    pub text: Text,
}

/// Reads notes. `fence` is the line of the fence, `after` what follows the word there; the Markdown begins on the line `first`.
pub(super) fn read(
    file: &str,
    (fence, after): (usize, &str),
    (first, markdown): (usize, &str),
) -> Result<Notes, ContentError> {
    let minutes = match after.trim() {
        "" => None,
        words => Some(minutes(words).ok_or_else(|| ContentError {
            file: file.to_owned(),
            line: fence,
            problem: format!("expected minutes, such as ```notes 3 min, found \"{words}\""),
        })?),
    };
    Ok(Notes { minutes, text: Text::read(file, first, markdown)? })
}

/// Minutes as they are written, "3 min" or "2.5 minutes"; `None` for anything else, and for a time that is none.
pub(super) fn minutes(words: &str) -> Option<f64> {
    let number = ["minutes", "minute", "min"].into_iter().find_map(|unit| words.strip_suffix(unit))?;
    let minutes: f64 = number.trim().parse().ok()?;
    (minutes.is_finite() && minutes > 0.0).then_some(minutes)
}
