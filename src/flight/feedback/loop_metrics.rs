//! How an output answers a step under a law: how fast, how far over and where to, of the whole motion, however much of it is shown.
//!
//! From rest the motion after a step is x∞ − e^{At} x∞. It is followed exactly from node to node, as close together as the fastest mode
//! that is still alive asks for, until all have died away; between two nodes an output is the cubic that has its values and slopes.

use nalgebra::{DVector, RowDVector};

use super::appended::AppendedState;
use super::closed_model::ClosedModel;
use super::loop_modes::LoopMode;
use super::loop_response::exponential;
use crate::flight::modes::stability::Stability;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::DrivenSystem;
use crate::flight::motion::response_metrics::{SETTLED, StepMetrics};
use crate::flight::motion::small_disturbance::is_small;

/// Time between two nodes in units of 1/|λ|: 63 in a period, so that a cubic is within 10⁻⁶ of the motion.
const SPACING: f64 = 0.1;

/// A mode is alive until it has died away to e^{−16}, 10⁻⁷ of what it was.
const ALIVE: f64 = 16.0;

/// Nodes beyond these are not taken.
const MOST_NODES: usize = 40_000;

/// An overshoot smaller than this fraction of the steady value is none.
const OVERSHOT: f64 = 1e-4;

/// The motion after a step that is the only disturbance, from rest.
pub struct LoopStep<'a> {
    closed: &'a ClosedModel,
    forced: &'a DrivenSystem,
    amplitude: f64,
    /// State that it goes to.
    end: DVector<f64>,
    /// Times after the step \[s\], with what is left to go to the end there, and its rate.
    nodes: Vec<(f64, DVector<f64>, DVector<f64>)>,
    /// Whether it is a small disturbance all the way.
    pub is_small: bool,
}

impl<'a> LoopStep<'a> {
    /// The motion after the step that drives `forced`; `None` where something else does, not every mode dies away, or it takes too long
    /// to be followed.
    pub fn of(closed: &'a ClosedModel, modes: &[LoopMode], forced: &'a DrivenSystem) -> Option<Self> {
        let [forcing] = forced.forcings.as_slice() else { return None };
        let Input::Step { amplitude, .. } = forcing.input else { return None };
        let at_rest = forced.start.iter().chain(&forced.start_path).all(|x| *x == 0.0);
        if !at_rest || modes.iter().any(|mode| mode.mode.stability != Stability::Stable) {
            return None;
        }
        let [column, _] = closed.columns(forcing);
        let end = closed.a.clone().full_piv_lu().solve(&(column * -amplitude))?;
        if !end.iter().all(|x| x.is_finite()) {
            return None;
        }
        let mut alive: Vec<(f64, f64)> =
            modes.iter().map(|mode| (ALIVE / -mode.mode.lambda.re, mode.mode.lambda.norm())).collect();
        alive.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut time, mut left) = (0.0, -end.clone());
        let mut nodes = vec![(0.0, left.clone(), &closed.a * &left)];
        for (k, (dies, _)) in alive.iter().enumerate() {
            let fastest = alive[k..].iter().map(|(_, speed)| *speed).fold(f64::MIN_POSITIVE, f64::max);
            let steps = ((dies - time) * fastest / SPACING).ceil();
            if steps.is_nan() || steps < 1.0 {
                continue;
            }
            if steps + nodes.len() as f64 > MOST_NODES as f64 {
                return None;
            }
            let (from, length) = (time, (dies - time) / steps);
            let onward = exponential(&(&closed.a * length));
            for step in 1..=steps as usize {
                left = &onward * left;
                nodes.push((from + length * step as f64, left.clone(), &closed.a * &left));
            }
            time = *dies;
        }
        let four = |left: &DVector<f64>| nalgebra::Vector4::from_fn(|k, _| left[k] + end[k]);
        let is_small = nodes.iter().all(|(_, left, _)| is_small(&closed.model, &four(left)));
        Some(Self { closed, forced, amplitude, end, nodes, is_small })
    }

    /// The value that an output goes to; `None` where it goes along the path, which has no end unless the law holds it.
    pub fn steady(&self, output: Output) -> Option<f64> {
        let (row, direct) = self.row(output)?;
        let parts = row.iter().zip(&self.end).map(|(c, x)| c * x);
        // What is left of parts that cancel is rounding.
        let size = parts.clone().fold(direct.abs(), |size, part| size.max(part.abs()));
        let value = parts.sum::<f64>() + direct;
        Some(if value.abs() <= 1e-9 * size { 0.0 } else { value })
    }

    /// Metrics of an output; `None` where its steady value is too small beside the motion to measure by, a thousandth of the peak.
    pub fn metrics(&self, output: Output) -> Option<StepMetrics> {
        let steady = self.steady(output).filter(|steady| *steady != 0.0)?;
        let points = self.points(output)?;
        let most = points.iter().map(|point| point.value.abs()).fold(0.0, f64::max);
        if steady.abs() <= 1e-3 * most {
            return None;
        }
        let share = |value: f64| value / steady;
        let reached = |wanted: f64| {
            let k = points.iter().position(|point| share(point.value) >= wanted)?;
            Some(match k.checked_sub(1) {
                Some(before) => self.crossing(&points[before], &points[k], steady * wanted),
                None => 0.0,
            })
        };
        let most = points.iter().map(|point| share(point.value) - 1.0).fold(0.0, f64::max);
        let outside = |value: f64| (share(value) - 1.0).abs() > SETTLED;
        let settling_time = match points.iter().rposition(|point| outside(point.value)) {
            None => 0.0,
            Some(k) => {
                let (from, to) = (&points[k], points.get(k + 1)?);
                let side = (share(from.value) - 1.0).signum();
                self.crossing(from, to, steady * (1.0 + side * SETTLED))
            }
        };
        Some(StepMetrics {
            steady,
            rise_time: reached(0.9).and_then(|high| Some(high - reached(0.1)?)),
            settling_time,
            overshoot: if most > OVERSHOT { most } else { 0.0 },
        })
    }

    /// An output as a row over all states, and what the step makes of it at once.
    fn row(&self, output: Output) -> Option<(RowDVector<f64>, f64)> {
        let none = || Input::Step { amplitude: 0.0, start: 0.0 };
        let whole = self.closed.with_courses(self.forced, [none(), none()], |_| none());
        let of = output.row(&self.closed.model, &whole);
        let mut row = RowDVector::zeros(self.closed.size());
        row.columns_mut(0, 4).copy_from(&of.states.transpose());
        for (coordinate, state) in [(0, AppendedState::Heading), (1, AppendedState::Height)] {
            if of.path[coordinate] != 0.0 {
                let of_plane = state == AppendedState::of_path(self.closed.model.plane);
                let place =
                    self.closed.appended.iter().position(|other| *other == state).filter(|_| of_plane)?;
                row[4 + place] += of.path[coordinate];
            }
        }
        let felt = self.closed.felt(self.forced.forcings.first()?);
        let mut direct = of.inputs[0].0;
        for (input, (moved, at_once)) in self.closed.controls().iter().enumerate() {
            let effect = of.inputs[1 + input].0;
            row += moved * effect;
            direct += if *at_once { effect * felt[input] } else { 0.0 };
        }
        for k in 0..self.closed.of_source() {
            row[4 + k] += of.inputs[3 + k].0;
        }
        Some((row, direct * self.amplitude))
    }

    /// An output at the nodes and where it turns between two: from each to the next it goes one way.
    fn points(&self, output: Output) -> Option<Vec<Point>> {
        let (row, _) = self.row(output)?;
        let steady = self.steady(output)?;
        let at = |k: usize| {
            let (time, left, rate) = &self.nodes[k];
            (*time, steady + row.tr_dot(left), row.tr_dot(rate))
        };
        let mut points = Vec::with_capacity(self.nodes.len());
        for k in 0..self.nodes.len() {
            let (time, value, slope) = at(k);
            let next = self.nodes.get(k + 1).map(|_| at(k + 1));
            let piece =
                next.map_or(Cubic::still(time, value), |next| Cubic::between((time, value, slope), next));
            points.push(Point { time, value, piece });
            if let Some((end, _, next_slope)) = next.filter(|(_, _, next_slope)| slope * next_slope < 0.0) {
                let turn = halved((time, end), |t| piece.slope(t) * next_slope > 0.0);
                points.push(Point { time: turn, value: piece.at(turn), piece });
            }
        }
        Some(points)
    }

    /// When an output passes a level between two points.
    fn crossing(&self, from: &Point, to: &Point, level: f64) -> f64 {
        let up = to.value > from.value;
        halved((from.time, to.time), |t| (from.piece.at(t) >= level) == up)
    }
}

/// A time \[s\] after the step, the value of an output, and how it goes on.
struct Point {
    time: f64,
    value: f64,
    piece: Cubic,
}

/// Hermite's cubic between two nodes.
#[derive(Clone, Copy)]
struct Cubic {
    start: f64,
    length: f64,
    /// Coefficients of the powers of the share of the way.
    of: [f64; 4],
}

impl Cubic {
    const fn still(start: f64, value: f64) -> Self {
        Self { start, length: 1.0, of: [value, 0.0, 0.0, 0.0] }
    }

    fn between((start, a, a_slope): (f64, f64, f64), (end, b, b_slope): (f64, f64, f64)) -> Self {
        let length = end - start;
        let (from, to) = (a_slope * length, b_slope * length);
        Self { start, length, of: [a, from, 3.0 * (b - a) - 2.0 * from - to, 2.0 * (a - b) + from + to] }
    }

    fn at(&self, time: f64) -> f64 {
        let s = (time - self.start) / self.length;
        let [a, b, c, d] = self.of;
        a + s * (b + s * (c + s * d))
    }

    fn slope(&self, time: f64) -> f64 {
        let s = (time - self.start) / self.length;
        let [_, b, c, d] = self.of;
        (b + s * (2.0 * c + s * 3.0 * d)) / self.length
    }
}

/// The first time of two between which something becomes so, by halving.
fn halved((mut before, mut after): (f64, f64), is_so: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (before + after);
        if is_so(middle) { after = middle } else { before = middle }
    }
    after
}
