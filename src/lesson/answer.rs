//! An answer compared with what the model does.

use crate::few;
use nalgebra::Complex;
use serde::{Deserialize, Serialize};

use super::prediction::Kind;
use super::sketch::Features;
use super::text::Text;

/// An answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// "I don't know": an answer like every other.
    DontKnow,
    /// The statements that were chosen, by number.
    Chosen(Vec<usize>),
    /// A number \[SI\].
    Number(f64),
    /// A place on the pole map.
    Place {
        /// Real part \[1/s\].
        real: f64,
        /// Imaginary part \[rad/s\].
        imaginary: f64,
    },
    /// A curve, at equal steps of time, in the unit of its output \[SI\].
    Sketch(Vec<f64>),
    /// The things by number, least first.
    Order(Vec<usize>),
    /// Text in one's own words.
    Text(String),
}

impl Answer {
    /// Whether it can be an answer to a question of this kind: no statement that isn't there, no number that isn't finite.
    pub fn fits(&self, kind: &Kind) -> bool {
        match (self, kind) {
            (Self::DontKnow, _) => true,
            (Self::Chosen(chosen), Kind::Choose { choices, several }) => {
                chosen.iter().all(|number| *number < choices.len()) && (*several || chosen.len() <= 1)
            }
            (Self::Number(number), Kind::Estimate { .. }) => number.is_finite(),
            (Self::Place { real, imaginary }, Kind::Place { .. }) => {
                real.is_finite() && imaginary.is_finite()
            }
            (Self::Sketch(values), Kind::Sketch { .. }) => values.iter().all(|value| value.is_finite()),
            (Self::Order(order), Kind::Order { items, .. }) => {
                order.len() == items.len() && (0..items.len()).all(|number| order.contains(&number))
            }
            _ => false,
        }
    }
}

/// How an estimate compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Estimated {
    /// Within 10 %.
    Near,
    /// Within a factor of three.
    RightOrder,
    /// Farther, but the right way.
    Far,
    /// On the other side of the value before, or of zero.
    WrongWay,
}

/// How a place on the pole map compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceCompared {
    /// Within a tenth of the pole's distance from the origin.
    Near,
    /// Within half of it.
    RightRegion,
    /// Farther, on the right side of the imaginary axis.
    Far,
    /// On the other side.
    WrongSide,
}

/// How an answer compares.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// Nothing was claimed.
    DontKnow,
    /// The statements that were chosen and are wrong, and whether all right ones were chosen.
    Chosen {
        /// Wrong ones, by number.
        wrong: Vec<usize>,
        /// Whether no right one is missing.
        complete: bool,
    },
    /// Of a number.
    Number(Estimated),
    /// Of a place.
    Place(PlaceCompared),
    /// Of a curve.
    Sketch {
        /// Whether it starts the right way.
        first: bool,
        /// Whether it swings as it should.
        swings: bool,
        /// Whether it ends where it should.
        ends: bool,
    },
    /// Which places of the order are right.
    Order(Vec<bool>),
}

impl Comparison {
    /// Of a choice.
    pub fn of_choice(kind: &Kind, chosen: &[usize]) -> Self {
        let Kind::Choose { choices, .. } = kind else { return Self::DontKnow };
        let is_right = |number: usize| choices.get(number).is_some_and(|choice| choice.right);
        Self::Chosen {
            wrong: chosen.iter().copied().filter(|&number| !is_right(number)).collect(),
            complete: (0..choices.len())
                .filter(|&number| is_right(number))
                .all(|number| chosen.contains(&number)),
        }
    }

    /// Of a number with the model's; `before` is the value at the step's scene where the question is of another.
    pub fn of_number(answer: f64, found: f64, before: Option<f64>) -> Self {
        let near = (answer - found).abs() <= 0.1 * found.abs();
        let other_sign = answer * found < 0.0;
        let other_way = before.is_some_and(|before| (answer - before) * (found - before) < 0.0);
        let factor = answer / found;
        Self::Number(if near {
            Estimated::Near
        } else if other_sign || other_way {
            Estimated::WrongWay
        } else if (1.0 / 3.0..=3.0).contains(&factor) {
            Estimated::RightOrder
        } else {
            Estimated::Far
        })
    }

    /// Of a place with the model's pole.
    pub fn of_place(answer: Complex<f64>, pole: Complex<f64>) -> Self {
        // The map shows both of a pair; either is meant.
        let distance =
            (answer - pole).norm().min((answer - pole.conj()).norm()) / pole.norm().max(f64::MIN_POSITIVE);
        Self::Place(if distance <= 0.1 {
            PlaceCompared::Near
        } else if answer.re * pole.re < 0.0 {
            PlaceCompared::WrongSide
        } else if distance <= 0.5 {
            PlaceCompared::RightRegion
        } else {
            PlaceCompared::Far
        })
    }

    /// Of a curve with the model's.
    pub fn of_sketch(answer: &[f64], found: &[f64]) -> Self {
        let (answer, found) = (Features::of(answer), Features::of(found));
        Self::Sketch {
            first: answer.first == found.first,
            swings: answer.swings_like(found),
            ends: answer.ends == found.ends,
        }
    }

    /// Of an order with the values of the things.
    pub fn of_order(answer: &[usize], values: &[f64]) -> Self {
        let mut right: Vec<usize> = (0..values.len()).collect();
        few::sort_by(&mut right, |&a, &b| values[a].total_cmp(&values[b]));
        Self::Order(right.iter().enumerate().map(|(place, thing)| answer.get(place) == Some(thing)).collect())
    }

    /// Whether nothing is wrong with it.
    pub fn is_right(&self) -> bool {
        match self {
            Self::DontKnow => false,
            Self::Chosen { wrong, complete } => wrong.is_empty() && *complete,
            Self::Number(number) => *number == Estimated::Near,
            Self::Place(place) => *place == PlaceCompared::Near,
            Self::Sketch { first, swings, ends } => *first && *swings && *ends,
            Self::Order(places) => places.iter().all(|right| *right),
        }
    }

    /// The reasons of the file that fit what is wrong.
    pub fn reasons<'k>(&self, kind: &'k Kind) -> Vec<&'k Text> {
        match (self, kind) {
            (Self::Chosen { wrong, .. }, Kind::Choose { choices, .. }) => {
                wrong.iter().filter_map(|&number| choices.get(number)?.because.as_ref()).collect()
            }
            (Self::Number(Estimated::WrongWay), Kind::Estimate { wrong_way, .. }) => vec![wrong_way],
            (Self::Number(Estimated::RightOrder | Estimated::Far), Kind::Estimate { far, .. }) => vec![far],
            (Self::Place(PlaceCompared::WrongSide), Kind::Place { wrong_side, .. }) => vec![wrong_side],
            (Self::Place(PlaceCompared::RightRegion | PlaceCompared::Far), Kind::Place { far, .. }) => {
                vec![far]
            }
            (
                Self::Sketch { first, swings, ends },
                Kind::Sketch { first: of_first, oscillates, ends: of_ends, .. },
            ) => [(first, of_first), (swings, oscillates), (ends, of_ends)]
                .into_iter()
                .filter(|(right, _)| !**right)
                .map(|(_, reason)| reason)
                .collect(),
            (Self::Order(_), Kind::Order { because, .. }) if !self.is_right() => vec![because],
            _ => Vec::new(),
        }
    }
}
