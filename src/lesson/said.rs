//! What is said of answers, of what the model says to them, and of goals.

use nalgebra::Complex;

use super::answer::{Answer, Comparison, Estimated, PlaceCompared};
use super::goal::Progress;
use super::prediction::{Kind, Prediction};
use super::sketch::{Direction, End, Features};
use super::task::Wanted;
use super::truth::Truth;
use crate::content::LengthUnit;
use crate::findings::measures::Measure;
use crate::number::significant;
use crate::words::{measure, verdict};

impl Comparison {
    /// What the answer is, in a sentence.
    pub fn says(&self) -> &'static str {
        match self {
            Self::DontKnow => "Now you can find out.",
            Self::Number(Estimated::Near) => "Within 10 %.",
            Self::Number(Estimated::RightOrder) => "The right order.",
            Self::Number(Estimated::Far) => "The right way, but far.",
            Self::Number(Estimated::WrongWay) => "The other way.",
            Self::Place(PlaceCompared::Near) => "That is the place.",
            Self::Place(PlaceCompared::RightRegion) => "The right region.",
            Self::Place(PlaceCompared::Far) => "The right side, but far.",
            Self::Place(PlaceCompared::WrongSide) => "The other side.",
            compared if compared.is_right() => "That is right.",
            _ => "Not so.",
        }
    }
}

/// An answer in words.
pub fn answer(prediction: &Prediction, answer: &Answer, length: LengthUnit) -> String {
    match (answer, &prediction.kind) {
        (Answer::DontKnow, _) => "I don’t know".to_owned(),
        (Answer::Chosen(chosen), Kind::Choose { choices, .. }) => {
            joined(chosen.iter().filter_map(|&number| Some(choices.get(number)?.says.plain())))
        }
        (Answer::Number(number), Kind::Estimate { measure, .. }) => of_measure(*measure, *number, length),
        (Answer::Place { real, imaginary }, _) => pole(Complex::new(*real, *imaginary)),
        (Answer::Sketch(values), _) => curve(values),
        (Answer::Order(order), Kind::Order { items, .. }) => {
            joined(order.iter().filter_map(|&number| Some(items.get(number)?.says.plain())))
        }
        (Answer::Text(text), _) => text.clone(),
        (Answer::Chosen(_) | Answer::Number(_) | Answer::Order(_), _) => "–".to_owned(),
    }
}

/// What the model says to a question, in words.
pub fn truth(prediction: &Prediction, truth: &Truth, length: LengthUnit) -> String {
    match (truth, &prediction.kind) {
        (Truth::Choices, Kind::Choose { choices, .. }) => {
            joined(choices.iter().filter(|choice| choice.right).map(|choice| choice.says.plain()))
        }
        (Truth::Number { found, .. }, Kind::Estimate { measure, .. }) => of_measure(*measure, *found, length),
        (Truth::Pole(found), _) => pole(*found),
        (Truth::Curve { values, .. }, _) => curve(values),
        (Truth::Values(values), Kind::Order { items, measure, .. }) => {
            let mut order: Vec<usize> = (0..items.len().min(values.len())).collect();
            order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
            joined(order.iter().map(|&number| {
                format!("{} ({})", items[number].says.plain(), of_measure(*measure, values[number], length))
            }))
        }
        (Truth::Choices | Truth::Number { .. } | Truth::Values(_), _) => "–".to_owned(),
    }
}

/// What a condition of a goal wants, in words.
pub fn wanted(of: Measure, wanted: &Wanted, progress: &Progress, length: LengthUnit) -> String {
    let number = |value: f64| of_measure(of, value, length);
    match (wanted, progress.wanted) {
        (Wanted::Stability(stability), _) => measure::word(*stability).to_owned(),
        (Wanted::Level(level), _) => format!("{} or better", verdict::level(*level)),
        (Wanted::Absent, _) => "that there is none".to_owned(),
        (_, Some((low, high))) if high == f64::INFINITY => format!("at least {}", number(low)),
        (_, Some((low, high))) if low == f64::NEG_INFINITY => format!("at most {}", number(high)),
        (_, Some((low, high))) => format!("{} to {}", number(low), number(high)),
        (_, None) => "–".to_owned(),
    }
}

fn of_measure(of: Measure, value: f64, length: LengthUnit) -> String {
    measure::number(of.dimension(), value, length)
}

fn pole(pole: Complex<f64>) -> String {
    format!("{} ± {}i 1/s", significant(pole.re, 3), significant(pole.im.abs(), 3))
}

/// What matters of a curve.
fn curve(values: &[f64]) -> String {
    let Features { first, turns, ends } = Features::of(values);
    let first = match first {
        Direction::Up => "begins upward",
        Direction::Down => "begins downward",
        Direction::None => "does not move",
    };
    let swings = match turns {
        0 => "never turns".to_owned(),
        1 => "turns once".to_owned(),
        turns => format!("turns {turns} times"),
    };
    let ends = match ends {
        End::Above => "ends above where it began",
        End::Back => "ends where it began",
        End::Below => "ends below where it began",
        End::Away => "grows and does not end",
    };
    format!("{first}, {swings}, {ends}")
}

fn joined(texts: impl Iterator<Item = String>) -> String {
    texts.collect::<Vec<_>>().join(" · ")
}
