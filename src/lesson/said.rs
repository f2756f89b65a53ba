//! What is said of answers, of what the model says to them, and of goals.

use nalgebra::Complex;

use super::answer::{Answer, Comparison, Estimated, PlaceCompared};
use super::given::Given;
use super::goal::{Progress, Unfit};
use super::prediction::{Kind, Prediction};
use super::sketch::{Direction, End, Features};
use super::task::{SolutionAfter, Task, Wanted};
use super::truth::Truth;
use crate::few;
use crate::findings::measures::Measure;
use crate::number::{significant, trimmed};
use crate::scenario::Convention;
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

/// What a question is worth and how often it may be answered, where either is more than usual.
pub fn worth(prediction: &Prediction) -> Option<String> {
    let tries = (prediction.tries > 1).then(|| format!("{} tries", prediction.tries));
    let said: Vec<String> = prediction.points.map(points).into_iter().chain(tries).collect();
    (!said.is_empty()).then(|| said.join(" · "))
}

/// How often a question may still be answered.
pub fn tries_left(left: u32) -> String {
    match left {
        1 => "One more answer counts.".to_owned(),
        left => format!("{left} more answers count."),
    }
}

/// What was earned of what could be.
pub fn earned(of: f64, is_earned: bool) -> String {
    format!("{} of {}", trimmed(if is_earned { of } else { 0.0 }, 4), points(of))
}

/// How often a lesson was begun again.
pub fn begun_again(times: u32) -> String {
    match times {
        1 => "begun again once".to_owned(),
        times => format!("begun again {times} times"),
    }
}

/// What was earned of what could be, of several parts.
pub fn sum(earned: f64, of: f64) -> String {
    format!("{} of {}", trimmed(earned, 4), points(of))
}

/// What a task is worth, and what it costs to be helped; said before anybody asks for help.
pub fn worth_of_task(task: &Task, given: &Given) -> Option<String> {
    let of = task.points.or(task.unaided.then_some(1.0))?;
    let has_hints = !task.hints.is_empty();
    let has_solution = task.solution.is_some() && task.solution_after != SolutionAfter::Never;
    Some(if given.reached {
        earned(of, task.is_earned(given))
    } else if given.solution_shown {
        "No points any more: the solution was shown.".to_owned()
    } else if task.unaided && given.hints > 0 {
        "No points any more: a hint was shown.".to_owned()
    } else {
        let help = match (has_hints, has_solution) {
            (true, true) if task.unaided => ", only without a hint or the solution",
            (true, true) => ", only without the solution; a hint costs nothing",
            (true, false) if task.unaided => ", only without a hint",
            (true, false) => "; a hint costs nothing",
            (false, true) => ", only without the solution",
            (false, false) => "",
        };
        points(of) + help
    })
}

fn points(of: f64) -> String {
    if of == 1.0 { "1 point".to_owned() } else { format!("{} points", trimmed(of, 4)) }
}

/// Why a scene doesn't count for a task, as a sentence.
pub fn unfit(unfit: &Unfit) -> String {
    match unfit {
        Unfit::OtherAircraft => "It is another aircraft than at the start.".to_owned(),
        Unfit::OtherTask => {
            "Its levels are judged for another class or category than at the start.".to_owned()
        }
        Unfit::NotOffered(keys) => {
            format!("{} differs from the start, which isn’t offered.", keys.join(", "))
        }
        Unfit::TooMany { found, most: 1 } => format!("{found} sliders differ from the start; only one may."),
        Unfit::TooMany { found, most } => {
            format!("{found} sliders differ from the start; no more than {most} may.")
        }
    }
}

/// An answer in words.
pub fn answer(prediction: &Prediction, answer: &Answer, convention: Convention) -> String {
    match (answer, &prediction.kind) {
        (Answer::DontKnow, _) => "I don’t know".to_owned(),
        (Answer::Chosen(chosen), Kind::Choose { choices, .. }) => {
            joined(chosen.iter().filter_map(|&number| Some(choices.get(number)?.says.plain())))
        }
        (Answer::Number(number), Kind::Estimate { measure, .. }) => of_measure(*measure, *number, convention),
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
pub fn truth(prediction: &Prediction, truth: &Truth, convention: Convention) -> String {
    match (truth, &prediction.kind) {
        (Truth::Choices, Kind::Choose { choices, .. }) => {
            joined(choices.iter().filter(|choice| choice.right).map(|choice| choice.says.plain()))
        }
        (Truth::Number { found, .. }, Kind::Estimate { measure, .. }) => {
            of_measure(*measure, *found, convention)
        }
        (Truth::Pole(found), _) => pole(*found),
        (Truth::Curve { values, .. }, _) => curve(values),
        (Truth::Values(values), Kind::Order { items, measure, .. }) => {
            let mut order: Vec<usize> = (0..items.len().min(values.len())).collect();
            few::sort_by(&mut order, |&a, &b| values[a].total_cmp(&values[b]));
            joined(order.iter().map(|&number| {
                format!(
                    "{} ({})",
                    items[number].says.plain(),
                    of_measure(*measure, values[number], convention)
                )
            }))
        }
        (Truth::Choices | Truth::Number { .. } | Truth::Values(_), _) => "–".to_owned(),
    }
}

/// What a condition of a goal wants, in words.
pub fn wanted(of: Measure, wanted: &Wanted, progress: &Progress, convention: Convention) -> String {
    let number = |value: f64| of_measure(of, value, convention);
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

/// A time of a lecture: "45 min".
pub fn minutes(minutes: f64) -> String {
    format!("{} min", trimmed(minutes, 3))
}

fn of_measure(of: Measure, value: f64, convention: Convention) -> String {
    measure::value(of, value, convention)
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
