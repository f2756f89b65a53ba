//! What the model says to a question.

use std::sync::Arc;

use nalgebra::Complex;

use super::answer::{Answer, Comparison};
use super::prediction::{Item, Kind, Prediction};
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::findings::measures::{Measure, Reading};

/// What the model says.
#[derive(Clone, Debug, PartialEq)]
pub enum Truth {
    /// The file itself says which statements are right.
    Choices,
    /// A number, and what it is at the step's scene where the question is of another \[SI\].
    Number {
        /// The number asked for.
        found: f64,
        /// The same before.
        before: Option<f64>,
    },
    /// A pole, that of a pair with the positive imaginary part \[1/s\].
    Pole(Complex<f64>),
    /// A motion at equal steps of time.
    Curve {
        /// Its values \[SI\].
        values: Vec<f64>,
        /// The step of time \[s\].
        dt: f64,
    },
    /// The number of each thing, in the order of the file.
    Values(Vec<f64>),
}

impl Prediction {
    /// What the model says; `start` follows from the step's scene. `None` where there is nothing to compare with, which the check tells.
    pub fn truth(&self, start: &Findings, aircraft: &[Arc<Aircraft>]) -> Option<Truth> {
        let elsewhere = match &self.after {
            Some(scene) => Some(Findings::of(scene.open(aircraft)?.scenario)),
            None => None,
        };
        let there = elsewhere.as_ref().unwrap_or(start);
        match &self.kind {
            Kind::Choose { .. } => Some(Truth::Choices),
            Kind::Estimate { measure, .. } => Some(Truth::Number {
                found: number(*measure, there)?,
                before: elsewhere.as_ref().and_then(|_| number(*measure, start)),
            }),
            Kind::Place { mode, .. } => {
                let mode = there.flown_modes().iter().find(|found| found.naming.name == *mode)?;
                Some(Truth::Pole(mode.lambda))
            }
            Kind::Sketch { output, .. } => {
                let motion = there.flown_motion()?;
                let values = motion.values(*output);
                // What is no small disturbance any more is no part of the answer.
                let small = motion.small_samples().min(values.len());
                Some(Truth::Curve { values: values[..small].to_vec(), dt: motion.response.dt })
            }
            Kind::Order { items, measure, .. } => {
                let value =
                    |item: &Item| number(*measure, &Findings::of(item.scene.open(aircraft)?.scenario));
                Some(Truth::Values(items.iter().map(value).collect::<Option<_>>()?))
            }
        }
    }
}

impl Truth {
    /// How an answer to a question compares; one of another kind claims nothing.
    pub fn compare(&self, kind: &Kind, answer: &Answer) -> Comparison {
        match (self, answer) {
            (Self::Choices, Answer::Chosen(chosen)) => Comparison::of_choice(kind, chosen),
            (Self::Number { found, before }, Answer::Number(answer)) => {
                Comparison::of_number(*answer, *found, *before)
            }
            (Self::Pole(pole), Answer::Place { real, imaginary }) => {
                Comparison::of_place(Complex::new(*real, *imaginary), *pole)
            }
            (Self::Curve { values, .. }, Answer::Sketch(answer)) => Comparison::of_sketch(answer, values),
            (Self::Values(values), Answer::Order(order)) => Comparison::of_order(order, values),
            _ => Comparison::DontKnow,
        }
    }
}

fn number(measure: Measure, findings: &Findings) -> Option<f64> {
    match measure.read(findings) {
        Ok(Reading::Number(number)) => Some(number),
        Ok(Reading::Stability(_) | Reading::Level(_)) | Err(_) => None,
    }
}
