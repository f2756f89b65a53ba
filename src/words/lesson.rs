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

/// What matters of a sketch, each with a sentence: whether it starts, swings and ends as it should.
pub fn features(first: bool, swings: bool, ends: bool) -> [(bool, &'static str); 3] {
    [
        (first, if first { "It starts the right way." } else { "It starts another way." }),
        (swings, if swings { "It swings about as often." } else { "It swings another number of times." }),
        (ends, if ends { "It ends where it should." } else { "It ends elsewhere." }),
    ]
}
