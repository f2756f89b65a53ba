//! A curve with the points left out that nobody would miss on screen: drawing costs by the point.

use egui::Vec2;

use super::PlotPoint;

/// How far a curve may pass from a point that was left out [points on screen].
const TOLERANCE: f32 = 0.15;

/// The points of a curve, of which one unit is as much as `scale` on screen, without those that lie within
/// [`TOLERANCE`] of the line between two that stay. The first and the last stay. No three in one place stay: what they do
/// to a line, GPUs don't agree on.
///
/// The cone of Williams ("An efficient algorithm for the piecewise linear approximation of planar curves", Computer
/// Graphics and Image Processing 8, 1978): from the last point that stays, every point after it opens a cone around
/// itself; the line may go on as long as it stays in all of them and leads away. One pass.
pub fn thin(points: &[PlotPoint], scale: Vec2) -> Vec<PlotPoint> {
    let Some((&first, rest)) = points.split_first() else { return Vec::new() };
    let mut kept = vec![first];
    let (mut from, mut last) = (first, first);
    let mut cone: Option<Cone> = None;
    for &point in rest {
        let mut way = between(from, point, scale);
        if cone.as_ref().is_some_and(|cone| !cone.holds(way)) {
            kept.push(last);
            from = last;
            cone = None;
            way = between(from, point, scale);
        }
        // A point that can't be told from where the line starts says nothing of where it leads.
        let square = way.length_sq();
        if square > TOLERANCE * TOLERANCE {
            cone = Some(Cone::around(way, square).narrowed(cone));
        }
        last = point;
    }
    if points.len() > 1 {
        kept.push(last);
    }
    kept
}

fn between(from: PlotPoint, to: PlotPoint, scale: Vec2) -> Vec2 {
    Vec2::new((to.x - from.x) as f32, (to.y - from.y) as f32) * scale
}

/// Where a line may lead so that it passes every point so far.
struct Cone {
    /// Its right and left edge.
    edges: (Vec2, Vec2),
    /// Square of how far it has led.
    square: f32,
}

impl Cone {
    fn around(way: Vec2, square: f32) -> Self {
        // `Vec2::length` is hypot, which takes longer in a browser than all the rest.
        let aside = way.rot90() * (TOLERANCE / square.sqrt());
        // rot90 turns to the side on which the cross product with `way` is negative.
        Self { edges: (way + aside, way - aside), square }
    }

    fn holds(&self, way: Vec2) -> bool {
        way.length_sq() >= self.square && cross(self.edges.0, way) >= 0.0 && cross(way, self.edges.1) >= 0.0
    }

    /// What it has in common with one that holds its middle.
    fn narrowed(self, by: Option<Self>) -> Self {
        let Some(by) = by else { return self };
        let right = if cross(by.edges.0, self.edges.0) > 0.0 { self.edges.0 } else { by.edges.0 };
        let left = if cross(self.edges.1, by.edges.1) > 0.0 { self.edges.1 } else { by.edges.1 };
        Self { edges: (right, left), square: self.square }
    }
}

fn cross(a: Vec2, b: Vec2) -> f32 {
    a.x * b.y - a.y * b.x
}

#[cfg(test)]
mod tests {
    use egui::{Pos2, Vec2};
    use proptest::prelude::*;

    use super::{PlotPoint, TOLERANCE, thin};

    const SCALE: Vec2 = Vec2::new(7.0, 90.0);

    /// Largest distance on screen of a point that was left out from the line that is drawn for it.
    fn error(points: &[PlotPoint], kept: &[PlotPoint]) -> f32 {
        let place = |p: &PlotPoint| Pos2::new(p.x as f32 * SCALE.x, p.y as f32 * SCALE.y);
        let mut from = 0;
        let mut most = 0.0_f32;
        for pair in kept.windows(2) {
            let to =
                from + 1 + points[from + 1..].iter().position(|p| *p == pair[1]).expect("one of the points");
            let (a, b) = (place(&pair[0]), place(&pair[1]));
            for left_out in &points[from + 1..to] {
                let along = (b - a).length_sq();
                let t = ((place(left_out) - a).dot(b - a) / along.max(1e-12)).clamp(0.0, 1.0);
                most = most.max((a + (b - a) * t - place(left_out)).length());
            }
            from = to;
        }
        assert_eq!(from, points.len() - 1, "the last point stays");
        most
    }

    fn damped(frequency: f64, damping: f64) -> Vec<PlotPoint> {
        (0..=1200)
            .map(|k| f64::from(k) * 0.05)
            .map(|t| PlotPoint::new(t, (-damping * t).exp() * (frequency * t).sin()))
            .collect()
    }

    #[test]
    fn a_smooth_curve_needs_a_tenth_of_its_points() {
        let points = damped(0.21, 0.017);
        assert!(thin(&points, SCALE).len() * 10 < points.len());
    }

    #[test]
    fn a_straight_line_needs_two_and_an_edge_stays_upright() {
        let line: Vec<_> = (0..100).map(|k| PlotPoint::new(f64::from(k), 0.5)).collect();
        assert_eq!(thin(&line, SCALE), [line[0], line[99]]);
        let edge = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [5.0, 2.0]].map(|[x, y]| PlotPoint::new(x, y));
        assert_eq!(thin(&edge, SCALE), edge);
        assert_eq!(thin(&edge[..1], SCALE), edge[..1]);
        assert_eq!(thin(&[], SCALE), []);
        let rest = [PlotPoint::new(1.0, 1.0); 5];
        assert_eq!(thin(&rest, SCALE), rest[..2]);
    }

    proptest! {
        #[test]
        fn nothing_is_drawn_further_than_the_tolerance_from_where_it_is(
            frequency in 0.01..30.0_f64,
            damping in -0.02..2.0_f64,
            jumps in prop::collection::vec((0_usize..1200, -1.0..1.0_f64), 0..5),
        ) {
            let mut points = damped(frequency, damping);
            for (from, height) in jumps {
                points[from..].iter_mut().for_each(|point| point.y += height);
            }
            let kept = thin(&points, SCALE);
            prop_assert!(error(&points, &kept) <= 1.2 * TOLERANCE);
        }

        #[test]
        fn a_path_that_turns_back_keeps_its_ends(
            steps in prop::collection::vec((-1.0..1.0_f64, -0.1..0.1_f64), 2..300),
        ) {
            let mut place = (0.0, 0.0);
            let points: Vec<_> = steps.iter().map(|(x, y)| {
                place = (place.0 + x, place.1 + y);
                PlotPoint::new(place.0, place.1)
            }).collect();
            let kept = thin(&points, SCALE);
            prop_assert!(error(&points, &kept) <= 1.2 * TOLERANCE);
        }
    }
}
