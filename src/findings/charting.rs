//! The chart of a measure, found: the aircraft at many values of a parameter, and the measure read of each.

use std::rc::Rc;

use super::Findings;
use super::chart::{ChartPoint, Known, Limit, MeasureChart};
use super::measures::{Measure, ModeQuantity, PlaneQuantity, Reading};
use crate::flight::verdicts::level_boundaries::{Boundary, Line};
use crate::flight::verdicts::mil_f_8785c::Quantity;
use crate::scenario::{Disturbance, Notation, Parameter, Scenario, Units};

/// Points at even distances; of a metric of the motion, which takes more time, fewer.
const EVEN: usize = 33;
const EVEN_OF_MOTION: usize = 17;
/// Halvings between two points of which only one has a reading, or only one is stable: a fortieth of their distance is left.
const HALVINGS: usize = 5;
/// So often is that done.
const MOST_EDGES: usize = 5;

impl Findings {
    /// A measure along the whole range of a parameter's slider: the one found last where that is the same. It doesn't depend on where
    /// along it the parameter is.
    pub fn chart(&self, parameter: &'static Parameter, measure: Measure) -> Rc<MeasureChart> {
        let mut start =
            Scenario { units: Units::default(), notation: Notation::default(), ..self.scenario.clone() };
        parameter.reset(&mut start);
        if !matches!(measure, Measure::OfOutput(..)) {
            start.disturbance = Disturbance::default();
        }
        let mut known = self.chart.borrow_mut();
        match &*known {
            Some(Known { start: of, chart })
                if *of == start && *chart.parameter == *parameter && chart.measure == measure =>
            {
                chart.clone()
            }
            _ => {
                let chart = Rc::new(found(&start, parameter, measure));
                *known = Some(Known { start, chart: chart.clone() });
                chart
            }
        }
    }
}

fn found(start: &Scenario, parameter: &'static Parameter, measure: Measure) -> MeasureChart {
    let (low, high) = parameter.range(start).into_inner();
    let at = |value: f64| {
        let mut moved = start.clone();
        parameter.set(&mut moved, value);
        point(moved, value, measure)
    };
    let count = if matches!(measure, Measure::OfOutput(..)) { EVEN_OF_MOTION } else { EVEN };
    let last = (count - 1) as f64;
    let mut points: Vec<ChartPoint> = Vec::with_capacity(count + 2 * MOST_EDGES);
    let mut edges = 0;
    for k in 0..count {
        let here = at(low + (high - low) * (k as f64 / last));
        if let Some(before) = points.last().filter(|before| !before.is_like(&here) && edges < MOST_EDGES) {
            edges += 1;
            let (mut one, mut other) = (before.clone(), here.clone());
            for _ in 0..HALVINGS {
                let middle = at(0.5 * (one.value + other.value));
                if middle.is_like(&one) { one = middle } else { other = middle }
            }
            if one.value > before.value {
                points.push(one);
            }
            if other.value < here.value {
                points.push(other);
            }
        }
        points.push(here);
    }
    MeasureChart { parameter, measure, points }
}

fn point(scenario: Scenario, value: f64, measure: Measure) -> ChartPoint {
    let plane = scenario.plane;
    let findings = match measure {
        Measure::OfOutput(output, _) => Findings::of_one_output(scenario, output),
        _ => Findings::at_rest(scenario),
    };
    let reading = match measure.read(&findings) {
        Ok(Reading::Number(number)) => Some(number),
        Ok(Reading::Stability(_) | Reading::Level(_)) | Err(_) => None,
    };
    let stability = match Measure::OfPlane(plane, PlaneQuantity::Stability).read(&findings) {
        Ok(Reading::Stability(stability)) => Some(stability),
        _ => None,
    };
    let limits = match measure {
        Measure::OfMode(name, quantity) => {
            let of_mode = findings.level_boundaries().iter().filter(|boundary| boundary.concerns(name));
            of_mode.filter_map(|boundary| limit(boundary, quantity)).collect()
        }
        _ => Vec::new(),
    };
    ChartPoint { value, reading, stability, limits }
}

/// The limit that a boundary sets on a quantity of its mode.
fn limit(boundary: &Boundary, quantity: ModeQuantity) -> Option<Limit> {
    let &Boundary { level, requirement, line, above, .. } = boundary;
    let (is_minimum, value) = match (quantity, line, requirement.quantity) {
        (ModeQuantity::DampingRatio, Line::DampingRatio(zeta), _) => (above, zeta),
        (ModeQuantity::NaturalFrequency, Line::NaturalFrequency(wn), _) => (above, wn),
        (ModeQuantity::RealPart, Line::RealPart(sigma), _) => (above, sigma),
        (ModeQuantity::TimeConstant, _, Quantity::TimeConstant)
        | (ModeQuantity::TimeToDouble, _, Quantity::TimeToDouble) => {
            (requirement.is_minimum, requirement.limit)
        }
        _ => return None,
    };
    Some(Limit { level, is_minimum, quantity: requirement.quantity, value })
}
