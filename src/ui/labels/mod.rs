//! Labels beside points: each near what it names and told from the others, none on another or on a mark, and none that jumps
//! from frame to frame.
//!
//! Places are tried around the point, and the one of least [cost](Placement::cost) is taken; where nothing is free there is no
//! label. A label keeps its place until another is better by [`STEADY`].

mod silhouette;

use std::f32::consts::TAU;
use std::sync::Arc;

use egui::{Painter, Pos2, Rect, Shape, Vec2};

use super::theme::Palette;

pub use silhouette::Silhouette;

/// From a point to the label beside it.
const GAP: f32 = 10.0;
/// A label that is farther from its point has a leader to it.
const BESIDE: f32 = 2.0 * GAP;
/// A leader ends so far from its point: at the edge of its mark.
const MARK_RADIUS: f32 = 8.0;
/// Two points that are nearer than this are one to the eye: a leader to the one may touch the other.
pub const MERGED: f32 = 10.0;

// Costs, in points of the screen: a leader costs its length.
/// A label that says less than another could.
const LESS: f32 = 500.0;
/// A leader in the other half of the map.
const OTHER_HALF: f32 = 80.0;
/// On something that is better left free.
const SHUNNED: f32 = 40.0;
/// On an arrow, or a leader across it.
const ON_ARROW: f32 = 60.0;
/// A turn of one radian from where a label belongs.
const ASIDE: f32 = 15.0;
/// A place is left for one that is better by this.
const STEADY: f32 = 39.0;

/// Places that are taken, inside a frame.
#[derive(Clone, Debug)]
pub struct Placement {
    frame: Rect,
    taken: Vec<Rect>,
    labels: Vec<Rect>,
    leaders: Vec<[Pos2; 2]>,
    /// Better left free, but a label may lie there rather than nowhere.
    shunned: Vec<Rect>,
    silhouette: Option<Arc<Silhouette>>,
    arrows: Vec<[Pos2; 2]>,
}

/// A label that is wanted, and its point.
#[derive(Debug)]
pub struct Wanted {
    /// Its points: of a pair both, the first beside which the label rather stands.
    pub own: Vec<Pos2>,
    /// Points that it must not be taken for.
    pub others: Vec<Pos2>,
    /// Its half of the map, where it stands without a leader.
    pub half: Rect,
    /// Sizes that it can have, the best first.
    pub sizes: Vec<Vec2>,
    /// The first of them that it may have.
    pub first: usize,
    /// On which side of its point it belongs, where that is one: a direction of length 1.
    pub towards: Option<Vec2>,
    /// What a leader costs beside its length.
    pub leader: f32,
}

/// Where a label stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// There.
    pub rect: Rect,
    /// Which of its sizes it has.
    pub size: usize,
    /// From the label to its point, where the label doesn't stand beside it.
    pub leader: Option<[Pos2; 2]>,
    /// Which of its points it belongs to.
    point: usize,
}

/// Where a label stood: it stays there as long as it can, so that nothing jumps while a slider moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RememberedPlace {
    /// From its point to its middle.
    offset: Vec2,
    place: Place,
}

impl Placement {
    /// Nothing placed yet inside `frame`.
    pub fn new(frame: Rect) -> Self {
        Self {
            frame,
            taken: Vec::new(),
            labels: Vec::new(),
            leaders: Vec::new(),
            shunned: Vec::new(),
            silhouette: None,
            arrows: Vec::new(),
        }
    }

    /// Keeps labels off a place.
    pub fn keep_clear(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Keeps labels off a place while there is room elsewhere.
    pub fn shun(&mut self, rect: Rect) {
        self.shunned.push(rect);
    }

    /// Keeps labels off a shape while there is room elsewhere.
    pub fn shun_silhouette(&mut self, silhouette: Arc<Silhouette>) {
        self.silhouette = Some(silhouette);
    }

    /// Keeps labels and leaders off a line while there is room elsewhere.
    pub fn shun_arrow(&mut self, line: &[Pos2]) {
        self.arrows.extend(line.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// Whether it is better left free.
    fn is_shunned(&self, place: Rect) -> bool {
        self.shunned.iter().any(|shunned| shunned.intersects(place))
            || self.silhouette.as_ref().is_some_and(|silhouette| silhouette.is_under(place))
    }

    /// Whether a place is inside the frame and nothing lies on it.
    fn is_free(&self, place: Rect) -> bool {
        let on_leader = |leader: &[Pos2; 2]| touches(place.expand(2.0), *leader);
        self.frame.contains_rect(place)
            && !self.taken.iter().chain(&self.labels).any(|taken| taken.intersects(place))
            && !self.leaders.iter().any(on_leader)
    }

    /// Takes a place if it is free, and says whether it was.
    pub fn take(&mut self, place: Rect) -> bool {
        let free = self.is_free(place);
        if free {
            self.labels.push(place.expand(2.0));
        }
        free
    }

    /// Takes the first free place that is not shunned, else the first free one.
    pub fn take_first(&mut self, places: impl Iterator<Item = Rect>) -> Option<Rect> {
        let mut free = places.filter(|place| self.is_free(*place)).peekable();
        let first = *free.peek()?;
        let place = free.find(|place| !self.is_shunned(*place)).unwrap_or(first);
        self.labels.push(place.expand(2.0));
        Some(place)
    }

    /// Finds a place for a label and takes it; `None` where there is no room. What was `kept` is kept while it is possible;
    /// where the map `rests`, it gives way to what is better.
    pub fn label(
        &mut self,
        wanted: &Wanted,
        kept: Option<RememberedPlace>,
        rests: bool,
    ) -> Option<(Place, RememberedPlace)> {
        let kept = kept.and_then(|kept| self.again(wanted, kept));
        let place = match kept {
            Some(kept) if !rests => kept,
            Some(kept) => self.best(wanted, self.cost(wanted, &kept) - STEADY).unwrap_or(kept),
            None => self.best(wanted, f32::INFINITY)?,
        };
        self.labels.push(place.rect.expand(2.0));
        self.leaders.extend(place.leader);
        let offset = place.rect.center() - wanted.own[place.point];
        Some((place, RememberedPlace { offset, place }))
    }

    /// What a place costs: with all its words, beside its point, on the side where it belongs and on nothing that is better
    /// left free, nothing.
    fn cost(&self, wanted: &Wanted, place: &Place) -> f32 {
        let led = place.leader.map_or(0.0, |leader| {
            let across = self.arrows.iter().filter(|arrow| cross(**arrow, leader)).count() as f32;
            let away = if wanted.half.contains_rect(place.rect) { 0.0 } else { OTHER_HALF };
            wanted.leader + leader[0].distance(leader[1]) + away + ON_ARROW * across
        });
        let shunned = if self.is_shunned(place.rect) { SHUNNED } else { 0.0 };
        let on_arrow = self.arrows.iter().any(|arrow| touches(place.rect, *arrow));
        let on_arrow = if on_arrow { ON_ARROW } else { 0.0 };
        least_cost(wanted, place.point, place.size, place.rect) + led + shunned + on_arrow
    }

    /// The same place beside the point where it is now.
    fn again(&self, wanted: &Wanted, kept: RememberedPlace) -> Option<Place> {
        let RememberedPlace { offset, place: Place { size, point, leader, .. } } = kept;
        let (own, size_now) = (wanted.own.get(point)?, wanted.sizes.get(size)?);
        if size < wanted.first {
            return None;
        }
        let rect = self.pushed_in(Rect::from_center_size(*own + offset, *size_now));
        if leader.is_none() {
            self.beside(wanted, point, size, rect)
        } else {
            self.led(wanted, point, size, rect)
        }
    }

    /// The place of least cost, where that is below `limit`; of equal ones the first.
    fn best(&self, wanted: &Wanted, limit: f32) -> Option<Place> {
        let mut best = None;
        let mut least = limit;
        for size in wanted.first..wanted.sizes.len() {
            for point in 0..wanted.own.len() {
                for rect in places(wanted.own[point], wanted.sizes[size], wanted.towards) {
                    let rect = self.pushed_in(rect);
                    let away = rect.distance_to_pos(wanted.own[point]);
                    let led = if away < BESIDE { 0.0 } else { wanted.leader + away - MARK_RADIUS };
                    // Most are seen to be dear before it is asked whether they are free.
                    if least_cost(wanted, point, size, rect) + led >= least {
                        continue;
                    }
                    let beside = self.beside(wanted, point, size, rect);
                    let place = beside.or_else(|| self.led(wanted, point, size, rect));
                    let Some(place) = place else { continue };
                    let cost = self.cost(wanted, &place);
                    if cost < least {
                        (best, least) = (Some(place), cost);
                    }
                }
            }
        }
        best
    }

    /// A place without a leader: free, near, in its half, and plainly nearer to its own point than to any other.
    fn beside(&self, wanted: &Wanted, point: usize, size: usize, rect: Rect) -> Option<Place> {
        let own = rect.distance_to_pos(wanted.own[point]);
        let plain = || wanted.others.iter().all(|other| rect.distance_to_pos(*other) > 1.4 * own + 2.0);
        let here = own < BESIDE && wanted.half.contains_rect(rect) && plain() && self.is_free(rect);
        here.then_some(Place { rect, size, leader: None, point })
    }

    /// A place with a leader, which passes no other point and crosses nothing that is written.
    fn led(&self, wanted: &Wanted, point: usize, size: usize, rect: Rect) -> Option<Place> {
        let own = wanted.own[point];
        let from = rect.clamp(own);
        let way = own - from;
        if way.length() < MARK_RADIUS + 4.0 || !self.frame.contains(own) || !self.is_free(rect) {
            return None;
        }
        let leader = [from, own - way.normalized() * MARK_RADIUS];
        let passes = |other: &Pos2| {
            other.distance(own) > MERGED
                && touches(Rect::from_center_size(*other, Vec2::splat(2.0 * MARK_RADIUS)), leader)
        };
        let clear = !wanted.others.iter().any(passes)
            && !self.labels.iter().any(|label| touches(*label, leader))
            && !self.leaders.iter().any(|other| cross(*other, leader));
        clear.then_some(Place { rect, size, leader: Some(leader), point })
    }

    /// A place at the edge of the frame moves inwards, as far as it has to.
    fn pushed_in(&self, place: Rect) -> Rect {
        let inwards = |low: f32, high: f32, from: f32, to: f32| (from - low).max(0.0) + (to - high).min(0.0);
        let frame = self.frame;
        place.translate(Vec2::new(
            inwards(place.left(), place.right(), frame.left(), frame.right()),
            inwards(place.top(), place.bottom(), frame.top(), frame.bottom()),
        ))
    }
}

/// Draws a leader: dotted, and fainter than anything that it could be taken for, in no colour that has a meaning.
pub fn draw_leader(painter: &Painter, ends: [Pos2; 2], palette: &Palette) {
    painter.extend(Shape::dotted_line(&ends, palette.weak.gamma_multiply(0.8), 3.0, 0.6));
}

/// What a place costs whatever lies there: where a label belongs to one side, its way from there.
fn least_cost(wanted: &Wanted, point: usize, size: usize, rect: Rect) -> f32 {
    let aside = wanted.towards.map_or(0.0, |towards| {
        let own = wanted.own[point];
        let way = (rect.center() - own).normalized();
        ASIDE * way.dot(towards).clamp(-1.0, 1.0).acos() + rect.distance_to_pos(own)
    });
    LESS * size as f32 + aside
}

/// Whether a straight line touches a rectangle.
fn touches(rect: Rect, [a, b]: [Pos2; 2]) -> bool {
    if !rect.intersects(Rect::from_two_pos(a, b)) {
        return false;
    }
    let corners = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()];
    rect.contains(a) || rect.contains(b) || (0..4).any(|k| cross([corners[k], corners[(k + 1) % 4]], [a, b]))
}

/// Whether two straight lines meet.
fn cross([a, b]: [Pos2; 2], [c, d]: [Pos2; 2]) -> bool {
    let side = |p: Pos2, q: Pos2, r: Pos2| (q - p).x * (r - p).y - (q - p).y * (r - p).x;
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Places for a label, from near its point to far: on the side where it belongs first, or where it belongs to none beside the
/// point on all sides.
fn places(at: Pos2, size: Vec2, towards: Option<Vec2>) -> impl Iterator<Item = Rect> {
    let beside = towards.is_none().then(|| adjacent(at, size)).into_iter().flatten();
    beside.chain(around(at, size, towards))
}

/// Places beside a point: above and below before the sides, where the real axis runs through a label.
fn adjacent(at: Pos2, size: Vec2) -> impl Iterator<Item = Rect> {
    let half = 0.5 * size;
    let (dx, dy) = (half.x + GAP, half.y + GAP);
    // A corner next to the mark.
    let (cx, cy) = (half.x + 0.5 * GAP, half.y + 0.8 * GAP);
    [
        Vec2::new(0.0, -dy),
        Vec2::new(-0.6 * half.x, -dy),
        Vec2::new(0.6 * half.x, -dy),
        Vec2::new(-cx, -cy),
        Vec2::new(cx, -cy),
        Vec2::new(-dx, 0.0),
        Vec2::new(dx, 0.0),
        Vec2::new(0.0, dy),
        Vec2::new(-0.6 * half.x, dy),
        Vec2::new(0.6 * half.x, dy),
        Vec2::new(-cx, cy),
        Vec2::new(cx, cy),
    ]
    .into_iter()
    .map(move |offset| Rect::from_center_size(at + offset, size))
}

/// Places around a point, wider and wider; on each ring the side where the label belongs first.
fn around(at: Pos2, size: Vec2, towards: Option<Vec2>) -> impl Iterator<Item = Rect> {
    const DIRECTIONS: usize = 16;
    const GAPS: [f32; 12] = [6.0, 12.0, 18.0, 28.0, 40.0, 55.0, 75.0, 100.0, 130.0, 170.0, 220.0, 280.0];
    let turn = towards.map_or(0.0, Vec2::angle);
    GAPS.into_iter().flat_map(move |gap| {
        (0..DIRECTIONS).map(move |k| {
            // To one side and the other in turn.
            let steps = k.div_ceil(2) as f32 * if k % 2 == 0 { 1.0 } else { -1.0 };
            let toward = Vec2::angled(turn + TAU * steps / DIRECTIONS as f32);
            let offset = Vec2::new(toward.x * (0.5 * size.x + gap), toward.y * (0.5 * size.y + gap));
            Rect::from_center_size(at + offset, size)
        })
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn lone(at: Pos2, size: Vec2) -> Wanted {
        Wanted {
            own: vec![at],
            others: Vec::new(),
            half: Rect::EVERYTHING,
            sizes: vec![size],
            first: 0,
            towards: None,
            leader: 10_000.0,
        }
    }

    #[test]
    fn a_label_with_no_room_is_left_out() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(50.0, 20.0));
        let wanted = lone(Pos2::new(10.0, 10.0), Vec2::new(90.0, 28.0));
        assert_eq!(Placement::new(frame).label(&wanted, None, true), None);
    }

    #[test]
    fn a_lone_label_finds_a_place_near_its_pole() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        for (x, y) in [(200.0, 150.0), (3.0, 3.0), (397.0, 297.0), (3.0, 150.0)] {
            let anchor = Pos2::new(x, y);
            let wanted = lone(anchor, Vec2::new(90.0, 28.0));
            let mut placement = Placement::new(frame);
            placement.keep_clear(Rect::from_center_size(anchor, Vec2::splat(14.0)));
            let (place, _) = placement.label(&wanted, None, true).expect("a place");
            assert!(place.rect.distance_to_pos(anchor) < 20.0, "{place:?} for {anchor}");
            assert_eq!(place.leader, None);
        }
    }

    #[test]
    fn a_label_moves_with_its_pole_and_keeps_its_side_while_the_hand_is_at_work() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        let size = Vec2::new(90.0, 28.0);
        let mut kept: Option<RememberedPlace> = None;
        let mut offsets = Vec::new();
        for step in 0..200 {
            // The pole goes down past another one on its right.
            let at = Pos2::new(200.0, 60.0 + step as f32);
            let wanted = Wanted { others: vec![Pos2::new(260.0, 150.0)], ..lone(at, size) };
            let (place, now) = Placement::new(frame).label(&wanted, kept, false).expect("a place");
            offsets.push(place.rect.center() - at);
            kept = Some(now);
        }
        let jumps = offsets.windows(2).filter(|pair| (pair[1] - pair[0]).length() > 0.01).count();
        assert!(jumps <= 1, "{jumps} jumps");
    }

    #[test]
    fn a_label_lies_on_a_shunned_place_only_where_there_is_no_other() {
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        let wanted = lone(frame.center(), Vec2::new(90.0, 28.0));
        let place = |shunned: Rect| {
            let mut placement = Placement::new(frame);
            placement.shun(shunned);
            placement.label(&wanted, None, true).expect("a place").0
        };
        let line = Rect::from_center_size(frame.center(), Vec2::new(4.0, 300.0));
        assert!(!place(line).rect.intersects(line));
        assert_eq!(place(frame).leader, None);
    }

    /// Arrows from one point all around, with the labels of their tips: a scene that turns.
    fn turned(angle: f32, kept: &mut [Option<RememberedPlace>; 5]) -> Vec<Place> {
        let centre = Pos2::new(200.0, 150.0);
        let tips = [(0.0, 90.0), (0.2, 60.0), (1.7, 100.0), (3.3, 30.0), (4.9, 80.0)];
        let tips = tips.map(|(at, length)| (Vec2::angled(angle + at), length));
        let mut placement = Placement::new(Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0)));
        for (towards, length) in tips {
            let tip = centre + length * towards;
            placement.keep_clear(Rect::from_center_size(tip, Vec2::splat(8.0)));
            placement.shun_arrow(&[centre, tip]);
        }
        let place = |((towards, length), kept): ((Vec2, f32), &mut Option<RememberedPlace>)| {
            let wanted = Wanted {
                towards: Some(towards),
                leader: 30.0,
                ..lone(centre + length * towards, Vec2::new(56.0, 16.0))
            };
            let (place, now) = placement.label(&wanted, *kept, true)?;
            *kept = Some(now);
            Some(place)
        };
        tips.into_iter().zip(kept).filter_map(place).collect()
    }

    #[test]
    fn labels_of_arrows_that_turn_stand_at_their_tips_off_all_arrows_and_seldom_jump() {
        let mut kept = [None; 5];
        let mut jumps = 0;
        for step in 0..360 {
            let before = kept;
            let places = turned((step as f32).to_radians(), &mut kept);
            assert_eq!(places.len(), 5, "{step}°");
            assert!(places.iter().filter(|place| place.leader.is_some()).count() <= 1, "{step}°");
            for (i, place) in places.iter().enumerate() {
                assert!(places[i + 1..].iter().all(|other| !other.rect.intersects(place.rect)), "{step}°");
            }
            let shift = |(a, b): (Option<RememberedPlace>, Option<RememberedPlace>)| {
                Some((a?.offset - b?.offset).length())
            };
            jumps += before.into_iter().zip(kept).filter_map(shift).filter(|shift| *shift > 25.0).count();
        }
        // Five labels go once around: each changes its side a few times.
        assert!(jumps <= 40, "{jumps} jumps");
    }

    #[test]
    fn a_label_stands_beside_a_silhouette_where_it_needs_no_leader_for_that() {
        let mut mesh = egui::Mesh::default();
        let corners = [Pos2::new(60.0, 40.0), Pos2::new(340.0, 40.0), Pos2::new(200.0, 260.0)];
        corners.into_iter().for_each(|corner| mesh.colored_vertex(corner, egui::Color32::WHITE));
        mesh.add_triangle(0, 1, 2);
        let frame = Rect::from_min_size(Pos2::ZERO, Vec2::new(400.0, 300.0));
        let mut placement = Placement::new(frame);
        placement.shun_silhouette(Arc::new(Silhouette::of(&mesh, frame)));
        let covered = |rect: Rect| Silhouette::of(&mesh, frame).is_under(rect);
        for (tip, on_it) in
            [(Pos2::new(300.0, 30.0), false), (Pos2::new(330.0, 70.0), false), (Pos2::new(200.0, 70.0), true)]
        {
            let size = Vec2::new(20.0, 12.0);
            let wanted = Wanted { towards: Some(Vec2::X), leader: 25.0, ..lone(tip, size) };
            let (place, _) = placement.clone().label(&wanted, None, true).expect("a place");
            assert_eq!(covered(place.rect), on_it, "{place:?}");
            assert_eq!(place.leader, None, "{place:?}");
        }
    }

    fn points() -> impl Strategy<Value = Vec<(Pos2, Vec2)>> {
        let one = (-40.0..760.0_f32, -40.0..420.0_f32, 5.0..140.0_f32, 8.0..30.0_f32);
        proptest::collection::vec(one.prop_map(|(x, y, w, h)| (Pos2::new(x, y), Vec2::new(w, h))), 0..9)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

        /// Poles and other marks anywhere, labels of any size beside some of them and at fixed places, as a map has them.
        #[test]
        fn no_label_lies_on_another_or_on_a_mark_or_outside_and_each_belongs_to_its_pole(
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
            let mut labels: Vec<Rect> = Vec::new();
            let mut leaders: Vec<(usize, [Pos2; 2])> = Vec::new();
            for (i, (at, size)) in poles.iter().enumerate() {
                let others: Vec<Pos2> = poles.iter().map(|(other, _)| *other).filter(|other| other != at).collect();
                let wanted = Wanted { others: others.clone(), ..lone(*at, *size) };
                let Some((place, kept)) = placement.label(&wanted, None, true) else { continue };
                match place.leader {
                    None => {
                        let own = place.rect.distance_to_pos(*at);
                        prop_assert!(others.iter().all(|other| place.rect.distance_to_pos(*other) > own), "of another");
                    }
                    Some([from, to]) => {
                        prop_assert!(place.rect.expand(0.1).contains(from) && to.distance(*at) < 9.0);
                        leaders.push((i, [from, to]));
                    }
                }
                prop_assert_eq!(kept.place, place);
                labels.push(place.rect);
            }
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
                prop_assert!(leaders.iter().all(|(_, leader)| !touches(label.shrink(0.5), *leader)), "crossed");
            }
        }
    }
}
