//! Words on the picture: each beside what it names, none over another, none beyond the edge.

use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, CornerRadius, FontId, Galley, Painter, Pos2, Rect, Vec2};

use crate::ui::symbol::Symbol;
use crate::ui::theme::Palette;

const SIZE: f32 = 13.0;
const MARGIN: Vec2 = Vec2::new(4.0, 1.0);
/// A label moves no farther from its place than this.
const FARTHEST: f32 = 90.0;

/// Labels to be placed when all are known.
#[derive(Debug, Default)]
pub(super) struct Labels(Vec<Label>);

#[derive(Debug)]
struct Label {
    symbol: String,
    words: String,
    color: Color32,
    at: Pos2,
    /// Where it stands, seen from there.
    towards: Vec2,
}

impl Labels {
    /// A symbol, words after it, and where it stands: beside a point, in a direction.
    pub fn add(&mut self, symbol: &str, words: &str, color: Color32, at: Pos2, towards: Vec2) {
        let (symbol, words) = (symbol.to_owned(), words.to_owned());
        self.0.push(Label { symbol, words, color, at, towards });
    }

    /// Draws all of them, the first at their own places and the others where there is room.
    pub fn paint(self, painter: &Painter, pane: Rect, taken: &[Rect], palette: &Palette) {
        let galleys: Vec<(Arc<Galley>, Color32, Pos2)> = self
            .0
            .iter()
            .filter(|label| pane.expand(20.0).contains(label.at))
            .map(|label| {
                let galley = painter.layout_job(label.job());
                let half = 0.5 * galley.size() + MARGIN;
                let reach = 6.0 + (half.x * label.towards.x.abs()).max(half.y * label.towards.y.abs());
                (galley, label.color, label.at + label.towards * reach)
            })
            .collect();
        let wanted: Vec<Rect> = galleys
            .iter()
            .map(|(galley, _, middle)| Rect::from_center_size(*middle, galley.size() + 2.0 * MARGIN))
            .collect();
        for ((galley, color, _), place) in galleys.into_iter().zip(placed(&wanted, pane, taken)) {
            let Some(place) = place else { continue };
            painter.rect_filled(place, CornerRadius::same(4), palette.label_ground());
            painter.galley(place.min + MARGIN, galley, color);
        }
    }
}

impl Label {
    fn job(&self) -> LayoutJob {
        let mut job = Symbol::parse(&self.symbol).job(SIZE, self.color);
        if !self.words.is_empty() {
            let gap = if self.symbol.is_empty() { 0.0 } else { 4.0 };
            job.append(&self.words, gap, TextFormat::simple(FontId::proportional(0.88 * SIZE), self.color));
        }
        job
    }
}

/// Places for rectangles inside a pane, none over another or over what is taken, each near where it is wanted; `None`
/// where there is no room.
fn placed(wanted: &[Rect], pane: Rect, taken: &[Rect]) -> Vec<Option<Rect>> {
    let inner = pane.shrink(3.0);
    let mut done: Vec<Rect> = taken.to_vec();
    let mut places = Vec::with_capacity(wanted.len());
    for rect in wanted {
        let place = around().map(|shift| inside(rect.translate(shift), inner)).find(|place| {
            inner.expand(0.5).contains_rect(*place)
                && !done.iter().any(|other| other.expand(1.0).intersects(*place))
        });
        done.extend(place);
        places.push(place);
    }
    places
}

/// Moved as little as needed to be inside.
fn inside(rect: Rect, pane: Rect) -> Rect {
    let low = (pane.min - rect.min).max(Vec2::ZERO);
    let high = (pane.max - rect.max).min(Vec2::ZERO);
    rect.translate(low + high)
}

/// Shifts on wider and wider rings.
fn around() -> impl Iterator<Item = Vec2> {
    const STEP: f32 = 10.0;
    const DIRECTIONS: usize = 12;
    let rings = (1..=(FARTHEST / STEP) as usize).flat_map(|ring| {
        (0..DIRECTIONS).map(move |k| {
            STEP * ring as f32 * Vec2::angled(std::f32::consts::TAU * k as f32 / DIRECTIONS as f32)
        })
    });
    std::iter::once(Vec2::ZERO).chain(rings)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_that_want_the_same_place_stand_apart_inside_the_pane() {
        let pane = Rect::from_min_size(Pos2::ZERO, Vec2::new(300.0, 200.0));
        let at = |x, y| Rect::from_center_size(Pos2::new(x, y), Vec2::new(50.0, 16.0));
        let wanted =
            [at(150.0, 100.0); 6].into_iter().chain([at(0.0, 0.0), at(300.0, 200.0), at(295.0, 198.0)]);
        let wanted: Vec<Rect> = wanted.collect();
        let taken = [Rect::from_min_size(Pos2::ZERO, Vec2::new(40.0, 30.0))];
        let places: Vec<Rect> = placed(&wanted, pane, &taken).into_iter().flatten().collect();
        assert_eq!(places.len(), wanted.len());
        for (k, place) in places.iter().enumerate() {
            assert!(pane.contains_rect(*place), "{place}");
            assert!(!taken[0].intersects(*place), "{place}");
            assert!(places[..k].iter().all(|other| !other.intersects(*place)), "{place}");
        }
    }
}
