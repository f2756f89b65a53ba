//! A part of the plane of λ on a part of the screen.

use egui::{Pos2, Rect, Vec2};
use nalgebra::Complex;

/// Points of the screen beyond this are not told apart: far outside any screen, and squares of them are still numbers.
const FAR: f64 = 1e7;

/// The part of the plane on screen \[1/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Real part at the left edge.
    pub left: f64,
    /// Real part at the right edge.
    pub right: f64,
    /// Imaginary part at the bottom edge.
    pub bottom: f64,
    /// Imaginary part at the top edge.
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

    /// `factor` times nearer, with what is at `about` staying where it is.
    pub fn zoomed(self, factor: f64, about: Complex<f64>) -> Self {
        let toward = |x: f64, centre: f64| centre + (x - centre) / factor;
        Self {
            left: toward(self.left, about.re),
            right: toward(self.right, about.re),
            bottom: toward(self.bottom, about.im),
            top: toward(self.top, about.im),
        }
    }

    /// What lies further by `by`.
    pub fn moved(self, by: Complex<f64>) -> Self {
        Self {
            left: self.left + by.re,
            right: self.right + by.re,
            bottom: self.bottom + by.im,
            top: self.top + by.im,
        }
    }
}

/// A view and the rectangle that it fills.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chart {
    /// Where on the screen.
    pub rect: Rect,
    /// What part of the plane, with one scale on both axes.
    pub view: View,
}

impl Chart {
    /// Width of a point of the screen in the plane \[1/s\].
    pub fn per_point(&self) -> f64 {
        (self.view.right - self.view.left) / f64::from(self.rect.width().max(1.0))
    }

    /// Where λ is on the screen.
    pub fn position(&self, lambda: Complex<f64>) -> Pos2 {
        let scale = 1.0 / self.per_point();
        let x = ((lambda.re - self.view.left) * scale).clamp(-FAR, FAR) as f32;
        let y = ((self.view.top - lambda.im) * scale).clamp(-FAR, FAR) as f32;
        self.rect.min + Vec2::new(x, y)
    }

    /// Which λ is there on the screen.
    pub fn at(&self, position: Pos2) -> Complex<f64> {
        let from = position - self.rect.min;
        Complex::new(self.view.left, self.view.top) + self.across(from)
    }

    /// How far it is in the plane from one end of a way on the screen to the other.
    pub fn across(&self, way: Vec2) -> Complex<f64> {
        Complex::new(f64::from(way.x), -f64::from(way.y)) * self.per_point()
    }

    /// What of the chart lies in `rect`.
    pub fn part(&self, rect: Rect) -> Self {
        let (min, max) = (self.at(rect.min), self.at(rect.max));
        Self { rect, view: View { left: min.re, right: max.re, bottom: max.im, top: min.im } }
    }

    /// The parts of a line that are on the map.
    pub fn clipped(&self, line: impl IntoIterator<Item = Complex<f64>>) -> Vec<Vec<Pos2>> {
        let frame = self.rect.expand(3.0);
        let mut parts: Vec<Vec<Pos2>> = Vec::new();
        let mut before: Option<Pos2> = None;
        for lambda in line {
            let here = self.position(lambda);
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
            assert!((CHART.at(CHART.position(lambda)) - lambda).norm() < 1e-6);
        }
        assert_eq!(CHART.position(Complex::new(-3.0, 1.0)), CHART.rect.min);
        assert_eq!(CHART.position(Complex::new(1.0, -1.0)), CHART.rect.max);
    }

    #[test]
    fn zooming_keeps_what_is_under_the_pointer() {
        let pointer = Pos2::new(57.0, 93.0);
        let zoomed = Chart { view: CHART.view.zoomed(3.0, CHART.at(pointer)), ..CHART };
        assert!((zoomed.at(pointer) - CHART.at(pointer)).norm() < 1e-6);
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
