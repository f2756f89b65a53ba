//! A linear motion followed from end to end at times of its own, so that what is read off it doesn't depend on how it is drawn.
//!
//! The times lie close together beside the fastest mode that is still alive and the input's own frequency, and on every edge of
//! the inputs, from which a piece goes to the next edge. Between two of them the motion is smooth, and can be had exactly at any time.

use nalgebra::Vector4;

use super::outputs::OutputRow;
use super::response::{DrivenSystem, Place, Step};
use super::small_disturbance::is_small;
use crate::few;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::mode::Mode;

/// Time between two nodes in units of 1/|λ|: 25 in a period.
const SPACING: f64 = 0.25;

/// A mode is alive until it has died away to e^{−25}, 10⁻¹¹ of what it was at the last edge.
const ALIVE: f64 = 25.0;

/// Nodes beyond these are not taken.
const MOST_NODES: usize = 20_000;

/// Steps of a search between two nodes, which needs half a dozen.
const SEARCH: usize = 24;

/// A linear motion at its nodes, up to where it is no small disturbance any more.
pub struct Course<'a> {
    forced: &'a DrivenSystem,
    pieces: Vec<Vec<Node>>,
    /// Time from which it is no small disturbance \[s\], the end of the course then.
    pub small_until: Option<f64>,
    /// Whether it had to end early, with too much to follow.
    pub is_cut: bool,
}

/// A time and where the motion is.
struct Node {
    time: f64,
    place: Place,
}

/// An output at a node, from within its piece: at an edge, from the side of the piece.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Time \[s\].
    pub time: f64,
    /// Value of the output.
    pub value: f64,
    piece: usize,
    node: usize,
}

impl Reading {
    /// The same node with a time after it and the value there.
    pub const fn moved(self, time: f64, value: f64) -> Self {
        Self { time, value, ..self }
    }
}

impl<'a> Course<'a> {
    /// The motion from t = 0 to `end` \[s\], or to where it is no small disturbance; `modes` are those of the model.
    pub fn new(model: &PlaneModel, forced: &'a DrivenSystem, modes: &[Mode], end: f64) -> Self {
        let start = Place { x: forced.start, path: forced.start_path };
        let first = Node { time: 0.0, place: start };
        let mut course = Self { forced, pieces: Vec::new(), small_until: None, is_cut: false };
        if !is_small(model, &start.x) {
            course.small_until = Some(0.0);
            course.pieces.push(vec![first]);
            return course;
        }
        let mut edges: Vec<f64> = forced.forcings.iter().flat_map(|forcing| forcing.input.edges()).collect();
        edges.retain(|&edge| edge > 0.0 && edge < end);
        edges.push(end);
        edges.sort_by(f64::total_cmp);
        let (mut from, mut left, mut step) = (first, MOST_NODES, None);
        for edge in edges {
            if edge.is_nan() || edge <= from.time {
                continue;
            }
            let piece = course.piece(model, modes, from, edge, (&mut left, &mut step));
            let Some(&Node { time, place }) = piece.last() else { break };
            from = Node { time, place };
            course.pieces.push(piece);
            if course.small_until.is_some() || course.is_cut {
                break;
            }
        }
        course
    }

    /// From a node to the next edge, in stretches between the times at which modes have died away. `left` are the nodes that may
    /// still be taken, `step` the last step, which serves again where it is as long.
    fn piece(
        &mut self,
        model: &PlaneModel,
        modes: &[Mode],
        from: Node,
        edge: f64,
        (left, step): (&mut usize, &mut Option<(f64, Step)>),
    ) -> Vec<Node> {
        let (forced, start) = (self.forced, from.time);
        let of_inputs =
            forced.forcings.iter().map(|forcing| forcing.input.highest_frequency()).fold(0.0, f64::max);
        let held = forced.forcings.iter().all(|forcing| forcing.input.is_constant_between_edges());
        // Of samples joined by lines a piece is short already.
        let least = if held || of_inputs > 0.0 { 4.0 } else { 1.0 };
        let dead_after =
            |mode: &Mode| if mode.lambda.re < 0.0 { ALIVE / -mode.lambda.re } else { f64::INFINITY };
        let mut ends: Vec<f64> =
            modes.iter().map(|mode| start + dead_after(mode)).filter(|&t| t < edge).collect();
        ends.push(edge);
        ends.sort_by(f64::total_cmp);
        let mut nodes = vec![from];
        for stretch_end in ends {
            let last = nodes.len() - 1;
            let begin = nodes[last].time;
            if stretch_end.is_nan() || stretch_end <= begin {
                continue;
            }
            let alive = modes.iter().filter(|mode| start + dead_after(mode) > begin);
            let fastest = alive.map(|mode| mode.lambda.norm()).fold(of_inputs, f64::max);
            let count = ((stretch_end - begin) * fastest / SPACING).ceil().max(least);
            if count.is_nan() || count > *left as f64 {
                self.is_cut = true;
                return nodes;
            }
            *left -= count as usize;
            let length = (stretch_end - begin) / count;
            let as_long = step.take_if(|(last, _)| (*last - length).abs() <= 1e-9 * length);
            let (_, step) = step.insert(as_long.unwrap_or_else(|| (length, Step::over(forced, length))));
            for k in 1..=count as usize {
                let Node { time, place } = nodes[nodes.len() - 1];
                let next = step.advance(forced, &place, time);
                if !is_small(model, &next.x) {
                    let at = self.last_small(model, time, &place, length);
                    self.small_until = Some(at.time);
                    nodes.push(at);
                    return nodes;
                }
                let time = if k == count as usize { stretch_end } else { begin + k as f64 * length };
                nodes.push(Node { time, place: next });
            }
        }
        nodes
    }

    /// Where the motion leaves what is small, within a step after a time at which it is small.
    fn last_small(&self, model: &PlaneModel, time: f64, place: &Place, length: f64) -> Node {
        let (mut small, mut large) = (0.0, length);
        for _ in 0..40 {
            let middle = 0.5 * (small + large);
            let at = Step::over(self.forced, middle).advance(self.forced, place, time);
            if is_small(model, &at.x) { small = middle } else { large = middle }
        }
        let place = Step::over(self.forced, small).advance(self.forced, place, time);
        Node { time: time + small, place }
    }

    /// Time of the last node \[s\].
    pub fn end(&self) -> f64 {
        self.pieces.last().and_then(|piece| piece.last()).map_or(0.0, |node| node.time)
    }

    /// State at the last node.
    pub fn last_state(&self) -> Vector4<f64> {
        self.pieces.last().and_then(|piece| piece.last()).map_or(self.forced.start, |node| node.place.x)
    }

    /// An output at every node, piece by piece: an edge stands at the end of one and at the beginning of the next.
    pub fn readings(&self, row: &OutputRow) -> Vec<Vec<Reading>> {
        let of_piece = |(piece, nodes): (usize, &Vec<Node>)| {
            let last = nodes.len() - 1;
            let of_node = |(node, Node { time, place }): (usize, &Node)| {
                let ends = node == last && node > 0;
                let value = self.value(row, place, if ends { time.next_down() } else { *time });
                Reading { time: *time, value, piece, node }
            };
            nodes.iter().enumerate().map(of_node).collect()
        };
        self.pieces.iter().enumerate().map(of_piece).collect()
    }

    fn value(&self, row: &OutputRow, place: &Place, t: f64) -> f64 {
        row.states.dot(&place.x) + row.path.dot(&place.path) + row.direct(self.forced, t)
    }

    /// An output at a time not before a node and before the end of its piece.
    fn at(&self, row: &OutputRow, reading: &Reading, t: f64) -> f64 {
        let Node { time, place } = &self.pieces[reading.piece][reading.node];
        let place = Step::over(self.forced, t - time).advance(self.forced, place, *time);
        self.value(row, &place, t)
    }

    /// Time and value where `size` of an output is largest beside node `k` of its piece, between the neighbours of that node: by
    /// parabolas through exact values.
    pub fn turning(
        &self,
        row: &OutputRow,
        piece: &[Reading],
        k: usize,
        size: impl Fn(f64) -> f64,
    ) -> (f64, f64) {
        let (before, after) = (k.saturating_sub(1), (k + 1).min(piece.len() - 1));
        let at = |t: f64| (t, self.at(row, &piece[if t < piece[k].time { before } else { k }], t));
        let mut points: Vec<(f64, f64)> = (before..=after).map(|k| (piece[k].time, piece[k].value)).collect();
        if let [first, last] = points[..] {
            points.insert(1, at(0.5 * (first.0 + last.0)));
        }
        let largest = |points: &[(f64, f64)]| {
            (0..points.len()).max_by(|&a, &b| size(points[a].1).total_cmp(&size(points[b].1))).unwrap_or(0)
        };
        for _ in 0..SEARCH {
            let [a, b, c] = points[..] else { break };
            let (fall, rise) = (size(b.1) - size(c.1), size(b.1) - size(a.1));
            let (to_c, to_a) = ((b.0 - a.0) * fall, (b.0 - c.0) * rise);
            // Vertex of the parabola through three points (Press et al., *Numerical Recipes*, §10.3).
            let t = b.0 - 0.5 * ((b.0 - a.0) * to_c - (b.0 - c.0) * to_a) / (to_c - to_a);
            let apart = 1e-9 * (c.0 - a.0);
            // Written so that NaN is none.
            if !(t > a.0 && t < c.0) || points.iter().any(|point| (point.0 - t).abs() < apart) {
                break;
            }
            points.push(at(t));
            few::sort_by(&mut points, |a, b| a.0.total_cmp(&b.0));
            // The largest with its neighbours.
            points.remove(if largest(&points) <= 1 { 3 } else { 0 });
        }
        points[largest(&points)]
    }

    /// Time at which `beyond` of an output passes zero from below, between two readings of a piece: below it at the first, not at the
    /// second \[s\].
    pub fn crossing(
        &self,
        row: &OutputRow,
        [first, second]: [&Reading; 2],
        beyond: impl Fn(f64) -> f64,
    ) -> f64 {
        let at = |t: f64| (t, beyond(self.at(row, first, t)));
        let (mut low, mut high) = ((first.time, beyond(first.value)), (second.time, beyond(second.value)));
        // False position, the end that stays weighing half (Illinois).
        for _ in 0..SEARCH {
            let t = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            if !(t > low.0 && t < high.0) || high.0 - low.0 < 1e-12 * high.0 {
                break;
            }
            let found = at(t);
            if found.1 < 0.0 {
                (low, high.1) = (found, 0.5 * high.1);
            } else {
                (high, low.1) = (found, 0.5 * low.1);
            }
        }
        high.0
    }
}
