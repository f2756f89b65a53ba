//! A curve, and what of it is needed on screen.

use egui::{Color32, Pos2, Stroke, Vec2};

use super::thin::thin;
use super::{Chart, Pattern, PlotPoint, Primitive};

/// How much of its colour the area between a curve and zero has.
const FILL: f32 = 0.12;
/// How much of its colour a curve has where it is faded.
const FADED: f32 = 0.4;
/// Length of an arrowhead, half its width, and the length of curve from one to the next.
const ARROW: (f32, f32, f32) = (7.0, 3.2, 110.0);
/// No curve has more arrowheads than this.
const MOST_ARROWS: usize = 5;

/// A curve in shown units.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is, for the legend and screen readers.
    pub name: &'static str,
    /// Its points.
    pub points: Vec<PlotPoint>,
    /// How many of them, from the first, are drawn in full colour; from the last of them on it is faded.
    full: usize,
    /// Its colour.
    pub color: Color32,
    /// How it is drawn.
    pub pattern: Pattern,
    /// It is drawn no thinner than this.
    pub thinnest: f32,
    /// Whether arrowheads tell the sense of time along it.
    is_directed: bool,
    /// What of both parts is needed on screen, at the scale at which it was shown last.
    thinned: Option<(Vec2, [Vec<PlotPoint>; 2])>,
}

impl Curve {
    /// A curve all of which is drawn in full colour.
    pub fn new(name: &'static str, points: Vec<PlotPoint>, color: Color32, pattern: Pattern) -> Self {
        Self {
            name,
            full: points.len(),
            points,
            color,
            pattern,
            thinnest: 0.0,
            is_directed: false,
            thinned: None,
        }
    }

    /// The same curve, faded after its first points.
    pub fn faded_after(self, count: usize) -> Self {
        Self { full: count, ..self }
    }

    /// The same curve with arrowheads in the sense of time.
    pub fn directed(self) -> Self {
        Self { is_directed: true, ..self }
    }

    /// Its points as far as they are drawn in full colour.
    pub fn full_part(&self) -> &[PlotPoint] {
        &self.points[..self.points.len().min(self.full)]
    }

    /// Its points where it is faded, from the last of the others on; none where nothing is.
    pub(super) fn faded_part(&self) -> &[PlotPoint] {
        if self.full < self.points.len() { &self.points[self.full.saturating_sub(1)..] } else { &[] }
    }

    /// Its value at a place between its points, linearly, and exact at them.
    pub fn at(&self, x: f64) -> Option<f64> {
        let points = &self.points;
        let i = points.partition_point(|point| point.x <= x);
        let (a, b) = (points.get(i.checked_sub(1)?)?, points.get(i));
        match b {
            Some(b) => Some(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)),
            // At its very end, though not beyond.
            None => (x - a.x <= 1e-9 * a.x.abs()).then_some(a.y),
        }
    }

    /// Adds what it is drawn with.
    pub fn draw(&mut self, chart: &Chart, list: &mut Vec<Primitive>) {
        let scale = chart.scale();
        if self.thinned.as_ref().is_none_or(|(of, _)| *of != scale) {
            let parts = [self.full_part(), self.faded_part()].map(|part| thin(part, scale));
            self.thinned = Some((scale, parts));
        }
        let Some((_, [full, faded])) = &self.thinned else { return };
        for (points, color) in [(faded, self.color.gamma_multiply(FADED)), (full, self.color)] {
            if self.pattern == Pattern::Filled {
                let line = points.iter().map(|point| chart.position(*point)).collect();
                let base = chart.position(PlotPoint::default()).y;
                list.push(Primitive::Area { line, base, color: color.gamma_multiply(FILL) });
            }
            let stroke = Stroke::new(self.pattern.width().max(self.thinnest), color);
            let parts = chart.clipped(points.iter().copied()).into_iter();
            list.extend(parts.map(|points| Primitive::Line { points, stroke, pattern: self.pattern }));
        }
        if self.is_directed {
            let on_screen: Vec<Pos2> = full.iter().map(|point| chart.position(*point)).collect();
            let stroke = Stroke::new(self.pattern.width(), self.color);
            list.extend(arrowheads(&on_screen).map(|points| Primitive::Line {
                points: points.to_vec(),
                stroke,
                pattern: Pattern::Full,
            }));
        }
    }
}

/// Arrowheads along a line on the screen: the first where it has begun to move, the others at even distances along it.
fn arrowheads(line: &[Pos2]) -> impl Iterator<Item = [Pos2; 3]> {
    let (length, half, apart) = ARROW;
    let mut next = 0.25 * apart;
    let mut gone = 0.0;
    let steps: Vec<(Pos2, Vec2)> = line
        .windows(2)
        .filter_map(|ends| {
            let step = ends[1] - ends[0];
            gone += step.length();
            let is_due = gone >= next && step.length() > 0.0;
            if is_due {
                next = gone + apart;
            }
            is_due.then(|| (ends[1], step.normalized()))
        })
        .take(MOST_ARROWS)
        .collect();
    steps.into_iter().map(move |(tip, along)| {
        let (back, aside) = (tip - length * along, half * along.rot90());
        [back + aside, tip, back - aside]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrowheads_point_along_the_line_and_are_few() {
        let line: Vec<Pos2> = (0..=2000).map(|k| Pos2::new(k as f32, 0.0)).collect();
        let heads: Vec<_> = arrowheads(&line).collect();
        assert_eq!(heads.len(), MOST_ARROWS);
        for [above, tip, below] in heads {
            assert!(tip.x > above.x && tip.x > below.x && above.y * below.y < 0.0);
        }
        assert_eq!(arrowheads(&[Pos2::ZERO; 9]).count(), 0);
        assert_eq!(arrowheads(&[]).count(), 0);
    }
}
