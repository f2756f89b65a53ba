//! Labels beside points, placed so that none lies on another.

use egui::{Pos2, Rect, Vec2};

/// Rectangles that are taken, inside a frame.
#[derive(Debug)]
pub struct Placement {
    frame: Rect,
    taken: Vec<Rect>,
    /// Better left free, but a label may lie there rather than nowhere.
    shunned: Vec<Rect>,
}

impl Placement {
    /// Nothing placed yet inside `frame`.
    pub fn new(frame: Rect) -> Self {
        Self { frame, taken: Vec::new(), shunned: Vec::new() }
    }

    /// Keeps labels off a place.
    pub fn keep_clear(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Keeps labels off a place while there is room elsewhere.
    pub fn shun(&mut self, rect: Rect) {
        self.shunned.push(rect);
    }

    /// Whether it is better left free.
    fn is_shunned(&self, place: Rect) -> bool {
        self.shunned.iter().any(|shunned| shunned.intersects(place))
    }

    /// Whether a place is inside the frame and nothing lies on it.
    fn is_free(&self, place: Rect) -> bool {
        self.frame.contains_rect(place) && !self.taken.iter().any(|taken| taken.intersects(place))
    }

    /// Takes a place if it is free, and says whether it was.
    pub fn take(&mut self, place: Rect) -> bool {
        let free = self.is_free(place);
        if free {
            self.taken.push(place.expand(2.0));
        }
        free
    }

    /// Where a label of this size goes beside `anchor`, nearest free place first; `None` where there is no room.
    pub fn beside(&mut self, anchor: Pos2, size: Vec2) -> Option<Rect> {
        let frame = self.frame;
        self.take_first(candidates(anchor, size).map(|place| pushed_into(frame, place)))
    }

    /// Takes the first free place that is not shunned, else the first free one.
    pub fn take_first(&mut self, places: impl Iterator<Item = Rect>) -> Option<Rect> {
        let mut free = places.filter(|place| self.is_free(*place)).peekable();
        let first = *free.peek()?;
        let place = free.find(|place| !self.is_shunned(*place)).unwrap_or(first);
        self.taken.push(place.expand(2.0));
        Some(place)
    }
}

/// A place at the edge of the frame moves inwards, as far as it has to.
fn pushed_into(frame: Rect, place: Rect) -> Rect {
    let inwards = |low: f32, high: f32, from: f32, to: f32| (from - low).max(0.0) + (to - high).min(0.0);
    place.translate(Vec2::new(
        inwards(place.left(), place.right(), frame.left(), frame.right()),
        inwards(place.top(), place.bottom(), frame.top(), frame.bottom()),
    ))
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
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_label_with_no_room_is_left_out() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(50.0, 20.0));
        assert_eq!(Placement::new(frame).beside(Pos2::new(10.0, 10.0), Vec2::new(90.0, 28.0)), None);
    }

    #[test]
    fn a_lone_label_finds_a_place_near_its_pole() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        for (x, y) in [(200.0, 150.0), (3.0, 3.0), (397.0, 297.0), (3.0, 150.0)] {
            let anchor = Pos2::new(x, y);
            let place = Placement::new(frame).beside(anchor, Vec2::new(90.0, 28.0)).expect("a place");
            assert!(place.distance_to_pos(anchor) < 30.0, "{place} for {anchor}");
        }
    }

    #[test]
    fn a_label_lies_on_a_shunned_place_only_where_there_is_no_other() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        let (anchor, size) = (frame.center(), Vec2::new(90.0, 28.0));
        let mut placement = Placement::new(frame);
        let line = Rect::from_center_size(anchor, Vec2::new(4.0, 300.0));
        placement.shun(line);
        assert!(!placement.beside(anchor, size).expect("a place").intersects(line));
        let mut placement = Placement::new(frame);
        placement.shun(frame);
        assert!(placement.beside(anchor, size).is_some());
    }

    fn points() -> impl Strategy<Value = Vec<(Pos2, Vec2)>> {
        let one = (-40.0..760.0_f32, -40.0..420.0_f32, 5.0..140.0_f32, 8.0..30.0_f32);
        proptest::collection::vec(one.prop_map(|(x, y, w, h)| (Pos2::new(x, y), Vec2::new(w, h))), 0..12)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

        /// Poles and other marks anywhere, labels of any size beside some of them and at fixed places, as a map has them.
        #[test]
        fn no_label_lies_on_another_or_on_a_mark_or_outside(
            width in 60.0..700.0_f32,
            height in 40.0..400.0_f32,
            marks in points(),
            poles in points(),
            fixed in points(),
        ) {
            let frame = Rect::from_min_size(Pos2::new(5.0, 7.0), Vec2::new(width, height));
            let mut placement = Placement::new(frame);
            let mut clear: Vec<Rect> = marks.iter().map(|(at, _)| Rect::from_center_size(*at, Vec2::splat(12.0))).collect();
            clear.extend(poles.iter().map(|(at, _)| Rect::from_center_size(*at, Vec2::splat(14.0))));
            clear.push(Rect::from_center_size(frame.center(), Vec2::new(2.0, 2.0 * height)));
            clear.iter().for_each(|mark| placement.keep_clear(*mark));
            let mut labels: Vec<Rect> =
                poles.iter().filter_map(|(at, size)| placement.beside(*at, *size)).collect();
            for (at, size) in fixed {
                let place = Rect::from_min_size(at, size);
                if placement.take(place) {
                    labels.push(place);
                }
            }
            for (i, label) in labels.iter().enumerate() {
                prop_assert!(frame.contains_rect(*label), "{label} outside");
                prop_assert!(labels[i + 1..].iter().all(|other| !label.intersects(*other)), "{label} on another");
                prop_assert!(clear.iter().all(|mark| !label.intersects(*mark)), "{label} on a mark");
            }
        }
    }
}
