//! A part of the plane of the data on a part of the screen.

use egui::{Pos2, Rect, Vec2};
use nalgebra::Complex;

/// Points of the screen beyond this are not told apart: far outside any screen, and squares of them are still numbers.
const FAR: f64 = 1e7;

/// A point of the plane of the data, in shown units: of λ the real and the imaginary part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlotPoint {
    /// Along the horizontal axis.
    pub x: f64,
    /// Along the vertical axis.
    pub y: f64,
}

impl PlotPoint {
    /// A point by its coordinates.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
}

impl From<Complex<f64>> for PlotPoint {
    fn from(lambda: Complex<f64>) -> Self {
        Self::new(lambda.re, lambda.im)
    }
}

impl From<PlotPoint> for Complex<f64> {
    fn from(point: PlotPoint) -> Self {
        Self::new(point.x, point.y)
    }
}

/// The part of the plane on screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Value at the left edge.
    pub left: f64,
    /// Value at the right edge.
    pub right: f64,
    /// Value at the bottom edge.
    pub bottom: f64,
    /// Value at the top edge.
    pub top: f64,
}

impl View {
    /// Distance of the farthest corner from the origin.
    pub fn reach(self) -> f64 {
        self.left.abs().max(self.right.abs()).hypot(self.top.max(-self.bottom))
    }

    /// The same centre and height in the shape of `rect`, so that both axes have one scale.
    pub fn shaped(self, rect: Rect) -> Self {
        let half = 0.5 * (self.top - self.bottom) * f64::from(rect.width() / rect.height().max(1.0));
        let middle = 0.5 * (self.left + self.right);
        Self { left: middle - half, right: middle + half, ..self }
    }

    /// As much more around it as the shape of `rect` needs for both axes to have one scale.
    pub fn holding(self, rect: Rect) -> Self {
        let (wide, high) = (self.right - self.left, self.top - self.bottom);
        let ratio = f64::from(rect.width() / rect.height().max(1.0));
        let more = (wide / ratio - high).max(0.0);
        let (bottom, top) = (self.bottom - 0.5 * more, self.top + 0.5 * more);
        Self { bottom, top, ..self }.shaped(rect)
    }

    /// `factor` times nearer, with what is at `about` staying where it is.
    pub fn zoomed(self, factor: f64, about: PlotPoint) -> Self {
        let toward = |x: f64, centre: f64| centre + (x - centre) / factor;
        Self {
            left: toward(self.left, about.x),
            right: toward(self.right, about.x),
            bottom: toward(self.bottom, about.y),
            top: toward(self.top, about.y),
        }
    }

    /// What lies further by `x` and `y`.
    pub fn moved(self, PlotPoint { x, y }: PlotPoint) -> Self {
        Self { left: self.left + x, right: self.right + x, bottom: self.bottom + y, top: self.top + y }
    }
}

/// A view and the rectangle that it fills.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chart {
    /// Where on the screen.
    pub rect: Rect,
    /// What part of the plane.
    pub view: View,
}

impl Chart {
    /// Units of either axis that a point of the screen is wide and high.
    fn units_per_point(&self) -> PlotPoint {
        let View { left, right, bottom, top } = self.view;
        let size = self.rect.size().max(Vec2::splat(1.0));
        PlotPoint::new((right - left) / f64::from(size.x), (top - bottom) / f64::from(size.y))
    }

    /// Units of the horizontal axis that a point of the screen is wide; of both axes, where they have one scale.
    pub fn per_point(&self) -> f64 {
        self.units_per_point().x
    }

    /// Points of the screen that a unit of either axis takes.
    pub fn scale(&self) -> Vec2 {
        let unit = self.units_per_point();
        Vec2::new(1.0 / unit.x as f32, 1.0 / unit.y as f32)
    }

    /// Where a point of the plane is on the screen.
    pub fn position(&self, at: impl Into<PlotPoint>) -> Pos2 {
        let (at, unit) = (at.into(), self.units_per_point());
        let x = ((at.x - self.view.left) / unit.x).clamp(-FAR, FAR) as f32;
        let y = ((self.view.top - at.y) / unit.y).clamp(-FAR, FAR) as f32;
        self.rect.min + Vec2::new(x, y)
    }

    /// Which point of the plane is there on the screen.
    pub fn at(&self, position: Pos2) -> PlotPoint {
        let from = self.across(position - self.rect.min);
        PlotPoint::new(self.view.left + from.x, self.view.top + from.y)
    }

    /// How far it is in the plane from one end of a way on the screen to the other.
    pub fn across(&self, way: Vec2) -> PlotPoint {
        let unit = self.units_per_point();
        PlotPoint::new(f64::from(way.x) * unit.x, -f64::from(way.y) * unit.y)
    }

    /// What of the chart lies in `rect`.
    pub fn part(&self, rect: Rect) -> Self {
        let (min, max) = (self.at(rect.min), self.at(rect.max));
        Self { rect, view: View { left: min.x, right: max.x, bottom: max.y, top: min.y } }
    }

    /// The parts of a line that are on the chart.
    pub fn clipped<P: Into<PlotPoint>>(&self, line: impl IntoIterator<Item = P>) -> Vec<Vec<Pos2>> {
        let frame = self.rect.expand(3.0);
        let mut parts: Vec<Vec<Pos2>> = Vec::new();
        let mut before: Option<Pos2> = None;
        for point in line {
            let here = self.position(point);
            if let Some((from, to)) = before.and_then(|before| inside(frame, before, here)) {
                match parts.last_mut().filter(|part| part.last() == Some(&from)) {
                    Some(part) => part.push(to),
                    None => parts.push(vec![from, to]),
                }
            }
            before = Some(here);
        }
        parts
    }
}

/// The part of the way from `a` to `b` inside `frame` (Liang & Barsky 1984).
fn inside(frame: Rect, a: Pos2, b: Pos2) -> Option<(Pos2, Pos2)> {
    let way = b - a;
    let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
    for (step, room) in [
        (-way.x, a.x - frame.left()),
        (way.x, frame.right() - a.x),
        (-way.y, a.y - frame.top()),
        (way.y, frame.bottom() - a.y),
    ] {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    // Ends that are inside stay as they are to the last bit, so that parts join.
    let at = |t: f32| if t == 1.0 { b } else { a + t * way };
    (enter <= leave).then(|| (at(enter), at(leave)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHART: Chart = Chart {
        rect: Rect { min: Pos2::new(10.0, 20.0), max: Pos2::new(210.0, 120.0) },
        view: View { left: -3.0, right: 1.0, bottom: -1.0, top: 1.0 },
    };

    #[test]
    fn a_point_of_the_screen_and_of_the_plane_belong_to_each_other() {
        for lambda in [Complex::new(-3.0, 1.0), Complex::new(0.0, 0.0), Complex::new(0.7, -0.9)] {
            assert!((Complex::from(CHART.at(CHART.position(lambda))) - lambda).norm() < 1e-6);
        }
        assert_eq!(CHART.position(Complex::new(-3.0, 1.0)), CHART.rect.min);
        assert_eq!(CHART.position(Complex::new(1.0, -1.0)), CHART.rect.max);
    }

    #[test]
    fn zooming_keeps_what_is_under_the_pointer() {
        let pointer = Pos2::new(57.0, 93.0);
        let zoomed = Chart { view: CHART.view.zoomed(3.0, CHART.at(pointer)), ..CHART };
        let [now, before] = [zoomed, CHART].map(|chart| Complex::from(chart.at(pointer)));
        assert!((now - before).norm() < 1e-6);
        assert!((3.0 * zoomed.per_point() - CHART.per_point()).abs() < 1e-12);
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_has_two_parts_and_nothing_outside() {
        let line = [(-1.0, 0.0), (-1.0, 5.0), (0.0, 5.0), (0.0, 0.0), (0.5, 0.0)];
        let parts = CHART.clipped(line.map(|(re, im)| Complex::new(re, im)));
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[1].len(), 3);
        assert!(parts.iter().flatten().all(|point| CHART.rect.expand(4.0).contains(*point)));
        assert!(CHART.clipped([Complex::new(-1e300, 3.0), Complex::new(1e300, 3.0)]).is_empty());
        assert_eq!(CHART.clipped([Complex::new(-1e300, 0.0), Complex::new(1e300, 0.0)]).len(), 1);
    }
}
