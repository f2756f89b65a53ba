//! Labels beside points, placed so that none lies on another.

use egui::{Pos2, Rect, Vec2};

/// Rectangles that are taken, inside a frame.
#[derive(Debug)]
pub struct Placement {
    frame: Rect,
    taken: Vec<Rect>,
}

impl Placement {
    /// Nothing placed yet inside `frame`.
    pub fn new(frame: Rect) -> Self {
        Self { frame, taken: Vec::new() }
    }

    /// Keeps labels off a place.
    pub fn keep_clear(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Whether a place is inside the frame and nothing lies on it.
    pub fn is_free(&self, place: Rect) -> bool {
        self.frame.contains_rect(place) && !self.taken.iter().any(|taken| taken.intersects(place))
    }

    /// Where a label of this size goes beside `anchor`, nearest free place first; `None` where there is no room.
    pub fn beside(&mut self, anchor: Pos2, size: Vec2) -> Option<Rect> {
        let place = candidates(anchor, size).find(|place| self.is_free(*place))?;
        self.taken.push(place.expand(2.0));
        Some(place)
    }
}

/// Places around an anchor, from near to far; right and left first, since labels are wide.
fn candidates(anchor: Pos2, size: Vec2) -> impl Iterator<Item = Rect> {
    [12.0_f32, 26.0, 48.0, 80.0].into_iter().flat_map(move |gap| {
        let (dx, dy) = (0.5 * size.x + gap, 0.5 * size.y + gap);
        [
            Vec2::new(0.0, -dy),
            Vec2::new(dx, 0.0),
            Vec2::new(-dx, 0.0),
            Vec2::new(-dx, -0.7 * dy),
            Vec2::new(dx, -0.7 * dy),
            Vec2::new(0.0, dy),
            Vec2::new(-dx, 0.7 * dy),
            Vec2::new(dx, 0.7 * dy),
        ]
        .map(|offset| Rect::from_center_size(anchor + offset, size))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_never_overlap_and_stay_inside() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        let mut placement = Placement::new(frame);
        let size = Vec2::new(90.0, 28.0);
        let placed: Vec<Rect> =
            (0..6).filter_map(|i| placement.beside(Pos2::new(200.0 + 3.0 * i as f32, 150.0), size)).collect();
        assert!(placed.len() >= 4);
        for (i, a) in placed.iter().enumerate() {
            assert!(frame.contains_rect(*a));
            assert!(placed[i + 1..].iter().all(|b| !a.intersects(*b)));
        }
    }

    #[test]
    fn a_label_with_no_room_is_left_out() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(50.0, 20.0));
        assert_eq!(Placement::new(frame).beside(Pos2::new(10.0, 10.0), Vec2::new(90.0, 28.0)), None);
    }
}
