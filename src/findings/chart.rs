//! A measure over the range of a parameter's slider.

use std::ops::RangeInclusive;
use std::rc::Rc;

use super::measures::{AircraftQuantity, Measure, ModeQuantity, PlaneQuantity};
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::Level;
use crate::flight::verdicts::mil_f_8785c::Quantity;
use crate::scenario::{Parameter, Scenario};

/// A measure over the range of a slider.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureChart {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The measure.
    pub measure: Measure,
    /// From one end of the slider to the other, by rising value.
    pub points: Vec<ChartPoint>,
}

/// What is there at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartPoint {
    /// Value of the parameter \[SI\].
    pub value: f64,
    /// What the measure reads \[SI\]; `None` where there is nothing to read.
    pub reading: Option<f64>,
    /// Dynamic stability of the plane on screen; `None` where there is no such flight.
    pub stability: Option<Stability>,
    /// Limits that levels of handling qualities set on the measure.
    pub limits: Vec<Limit>,
}

/// A limit on a measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The best level that asks for it.
    pub level: Level,
    /// Whether it is the least value allowed; else it is the greatest.
    pub is_minimum: bool,
    /// The quantity that the specification sets it on.
    pub quantity: Quantity,
    /// The limit \[SI\].
    pub value: f64,
}

impl Limit {
    /// Whether it is the same limit, at another value of the parameter.
    pub fn is_like(&self, other: &Self) -> bool {
        (self.level, self.is_minimum, self.quantity) == (other.level, other.is_minimum, other.quantity)
    }
}

impl ChartPoint {
    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.reading.is_some(), self.stability) == (other.reading.is_some(), other.stability)
    }
}

impl MeasureChart {
    /// Whether a measure can be charted: it reads numbers, not verdicts.
    pub fn can_show(measure: Measure) -> bool {
        !matches!(
            measure,
            Measure::OfMode(_, ModeQuantity::Stability | ModeQuantity::Level)
                | Measure::OfPlane(_, PlaneQuantity::Stability | PlaneQuantity::StaticStability)
                | Measure::OfAircraft(
                    AircraftQuantity::Stability | AircraftQuantity::StaticStability | AircraftQuantity::Level
                )
        )
    }

    /// The parts in which there is something to read, each of at least one point.
    pub fn runs(&self) -> impl Iterator<Item = &[ChartPoint]> {
        let runs = self.points.chunk_by(|a, b| a.reading.is_some() && b.reading.is_some());
        runs.filter(|run| run.iter().all(|point| point.reading.is_some()))
    }

    /// Ranges of the parameter \[SI\] of one stability each.
    pub fn stabilities(&self) -> impl Iterator<Item = (RangeInclusive<f64>, Stability)> {
        let parts = self.points.chunk_by(|a, b| a.stability == b.stability);
        parts.filter_map(|part| {
            let (first, last) = (part.first()?, part.last()?);
            Some((first.value..=last.value, first.stability?))
        })
    }

    /// What of its values is worth to be seen \[SI\]: all of them, but for ends that run away, as a time does where it is for ever.
    pub fn range(&self) -> Option<(f64, f64)> {
        let mut values: Vec<f64> = self.points.iter().filter_map(|point| point.reading).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (*values.first()?, *values.last()?);
        let (low, high) = (values[values.len() / 10], values[values.len() * 9 / 10]);
        let reach = 1.5 * (high - low);
        Some(if reach > 0.0 { (first.max(low - reach), last.min(high + reach)) } else { (first, last) })
    }

    /// Limits as lines over the parameter \[SI\], the best level first.
    pub fn limits(&self) -> Vec<(Limit, Vec<(f64, f64)>)> {
        let mut lines: Vec<(Limit, Vec<(f64, f64)>)> = Vec::new();
        for point in &self.points {
            for limit in &point.limits {
                let at = (point.value, limit.value);
                match lines.iter_mut().find(|(other, _)| other.is_like(limit)) {
                    Some((_, line)) => line.push(at),
                    None => lines.push((*limit, vec![at])),
                }
            }
        }
        lines
    }
}

/// The chart found last.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The scenario with the parameter at its reference, and without what the measure doesn't depend on.
    pub start: Scenario,
    pub chart: Rc<MeasureChart>,
}
