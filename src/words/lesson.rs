//! Lessons: what is said of a person's answers.

use crate::number::significant;

/// By what factor an estimate is off, as the end of a sentence; nothing where it is near, or where no factor tells it.
pub fn factor(said: f64, found: f64) -> String {
    let ratio = said / found;
    if !ratio.is_finite() || ratio == 0.0 || (ratio - 1.0).abs() <= 0.1 {
        return String::new();
    }
    if ratio < 0.0 {
        return ", of the other sign".to_owned();
    }
    let (way, factor) = if ratio > 1.0 { ("high", ratio) } else { ("low", 1.0 / ratio) };
    format!(", so you were too {way} by a factor of {}", significant(factor, 2))
}
