//! What a camera sees.

use egui::{Pos2, Rect};

use crate::scenario::view::Camera;
use crate::shape::Point;

/// Half of the angle of view, up and down \[rad\].
const HALF_VIEW: f32 = 0.30;
/// The aircraft stands below the middle of the pane by this part of its height, so that there is sky.
const LOWERED: f32 = 0.07;

impl Camera {
    /// What it sees in a pane: an aircraft of a radius \[m\], and a point to look at in Earth axes from the aircraft.
    pub(super) fn lens(&self, pane: Rect, radius: f32, target: Point) -> Lens {
        let (sin, cos) = self.azimuth.sin_cos();
        let (up, level) = self.elevation.sin_cos();
        // North, east, down: behind is south, and on the right east.
        let towards_eye = Point::new(-cos * level, sin * level, -up);
        let forward = -towards_eye;
        let right = Point::new(sin, cos, 0.0);
        let up = right.cross(&forward);
        let narrow = (0.5 * pane.width()).min(0.68 * pane.height()).max(1.0);
        let focal = 0.5 * pane.height() / HALF_VIEW.tan();
        let distance = self.distance * (1.03 * radius * focal / narrow + 0.6 * radius);
        let middle = pane.center() + egui::vec2(0.0, LOWERED * pane.height());
        Lens { eye: target + towards_eye * distance, forward, right, up, middle, focal }
    }
}

/// A camera in its place: Earth axes from the aircraft to points of the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lens {
    pub eye: Point,
    pub forward: Point,
    pub right: Point,
    pub up: Point,
    pub middle: Pos2,
    /// Distance from eye to screen, in points.
    pub focal: f32,
}

impl Lens {
    /// (right, up, forward) of the eye \[m\].
    pub fn seen(&self, p: &Point) -> Point {
        let d = p - self.eye;
        Point::new(d.dot(&self.right), d.dot(&self.up), d.dot(&self.forward))
    }

    /// Where something seen is on the screen; it must be before the eye.
    pub fn on_screen(&self, seen: &Point) -> Pos2 {
        let scale = self.focal / seen.z.max(1e-3);
        self.middle + egui::vec2(seen.x * scale, -seen.y * scale)
    }

    /// Where a point is on the screen; `None` behind the eye.
    pub fn project(&self, p: &Point) -> Option<Pos2> {
        let seen = self.seen(p);
        (seen.z > 1e-2 * self.eye.norm()).then(|| self.on_screen(&seen))
    }

    /// How large a length \[m\] at a place looks \[points\].
    pub fn scale_at(&self, p: &Point) -> f32 {
        self.focal / self.seen(p).z.max(1e-3)
    }

    /// Height of the horizon on the screen.
    pub fn horizon(&self) -> f32 {
        // Straight ahead and level: forward·cos, up·sin of the angle looked down
        let level = self.forward.x.hypot(self.forward.y).max(1e-4);
        let down = self.forward.z;
        self.middle.y - self.focal * down / level
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::view::StandardView;

    fn lens(view: StandardView) -> Lens {
        let pane = Rect::from_min_size(Pos2::ZERO, egui::vec2(600.0, 400.0));
        view.camera().lens(pane, 5.0, Point::zeros())
    }

    fn on_screen(lens: &Lens, p: Point) -> Pos2 {
        lens.project(&p).expect("it is before the eye")
    }

    #[test]
    fn right_is_right_from_behind_and_ahead_is_right_from_the_right() {
        let middle = |lens: &Lens| on_screen(lens, Point::zeros());
        let chase = lens(StandardView::Chase);
        assert!(on_screen(&chase, Point::y()).x > middle(&chase).x + 5.0);
        assert!(on_screen(&chase, Point::z()).y > middle(&chase).y + 5.0, "down is down");
        let side = lens(StandardView::Side);
        assert!(on_screen(&side, Point::x()).x > middle(&side).x + 5.0);
        let top = lens(StandardView::Top);
        assert!(on_screen(&top, Point::x()).y < middle(&top).y - 5.0, "ahead is up");
    }

    #[test]
    fn what_is_far_and_as_high_as_the_eye_is_on_the_horizon() {
        for view in [StandardView::ThreeQuarter, StandardView::Chase, StandardView::Side] {
            let lens = lens(view);
            let ahead = Point::new(lens.forward.x, lens.forward.y, 0.0);
            let far = on_screen(&lens, lens.eye + ahead * 1e4 + lens.right * 1e3);
            assert!((far.y - lens.horizon()).abs() < 0.5, "{view:?}");
        }
    }

    #[test]
    fn nothing_behind_the_eye_is_on_the_screen() {
        let lens = lens(StandardView::ThreeQuarter);
        assert_eq!(lens.project(&(lens.eye - lens.forward)), None);
    }
}
