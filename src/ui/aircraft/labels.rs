//! Words on the picture: each beside what it names, none over another, none beyond the edge.

use std::collections::HashMap;
use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, CornerRadius, FontId, Galley, Id, Mesh, Painter, Pos2, Rect, Stroke, Vec2};

use crate::ui::symbol::Symbol;
use crate::ui::theme::Palette;

const SIZE: f32 = 13.0;
const MARGIN: Vec2 = Vec2::new(4.0, 1.0);
/// In a narrower pane there are symbols only, no words.
const SMALL: f32 = 420.0;
/// Side of a square of the silhouette.
const SQUARE: f32 = 8.0;
/// A label that is farther from what it names has a line to it.
const LED: f32 = 18.0;
/// A label moves no farther from its place than this.
const FARTHEST: f32 = 90.0;

/// Labels to be placed when all are known.
#[derive(Debug, Default)]
pub(super) struct Labels(Vec<Label>);

/// What stands after a symbol.
#[derive(Clone, Debug)]
pub(super) enum Words {
    /// Nothing.
    None,
    /// A name, for which a small pane has no room.
    Name(&'static str),
    /// A number with its unit.
    Value(String),
}

#[derive(Debug)]
struct Label {
    symbol: String,
    words: Words,
    color: Color32,
    at: Pos2,
    /// Where it stands, seen from there.
    towards: Vec2,
}

impl Labels {
    /// A symbol, words after it, and where it stands: beside a point, in a direction.
    pub fn add(&mut self, symbol: &str, words: Words, color: Color32, at: Pos2, towards: Vec2) {
        self.0.push(Label { symbol: symbol.to_owned(), words, color, at, towards });
    }

    /// Draws all of them, the first at their own places and the others where there is room, beside the aircraft rather than on
    /// it; with a line to what it names where that is far.
    pub fn paint(
        self,
        painter: &Painter,
        pane: Rect,
        taken: &[Rect],
        silhouette: &Silhouette,
        palette: &Palette,
    ) {
        let is_small = pane.width() < SMALL;
        let shown: Vec<(&Label, Arc<Galley>, Rect)> = self
            .0
            .iter()
            .filter(|label| pane.expand(20.0).contains(label.at))
            .map(|label| {
                let galley = painter.layout_job(label.job(is_small));
                let size = galley.size() + 2.0 * MARGIN;
                let reach =
                    6.0 + (0.5 * size.x * label.towards.x.abs()).max(0.5 * size.y * label.towards.y.abs());
                (label, galley, Rect::from_center_size(label.at + label.towards * reach, size))
            })
            .collect();
        let wanted: Vec<Rect> = shown.iter().map(|(.., wanted)| *wanted).collect();
        // Where each stood in the frame before, seen from where it was wanted: it stays there while it can.
        let id = Id::unique("labels on the aircraft");
        let before: HashMap<String, Vec2> = painter.ctx().data(|data| data.get_temp(id)).unwrap_or_default();
        let last: Vec<Option<Vec2>> =
            shown.iter().map(|(label, ..)| before.get(&label.symbol).copied()).collect();
        let places = placed(&wanted, &last, pane, taken, |place| silhouette.is_under(place));
        let mut now = HashMap::new();
        for ((label, galley, wanted), place) in shown.into_iter().zip(places) {
            let Some(place) = place else { continue };
            now.insert(label.symbol.clone(), place.center() - wanted.center());
            if place.distance_to_pos(label.at) > LED {
                painter.line_segment([place.clamp(label.at), label.at], Stroke::new(1.0, label.color));
            }
            painter.rect_filled(place, CornerRadius::same(4), palette.label_ground());
            painter.galley(place.min + MARGIN, galley, label.color);
        }
        painter.ctx().data_mut(|data| data.insert_temp(id, now));
    }
}

/// What of a pane the aircraft covers, in squares.
#[derive(Debug)]
pub(super) struct Silhouette {
    pane: Rect,
    columns: usize,
    covered: Vec<bool>,
}

impl Silhouette {
    /// Of the faces as they are drawn.
    pub fn of(mesh: &Mesh, pane: Rect) -> Self {
        let columns = (pane.width() / SQUARE).ceil().max(1.0) as usize;
        let rows = (pane.height() / SQUARE).ceil().max(1.0) as usize;
        let mut silhouette = Self { pane, columns, covered: vec![false; columns * rows] };
        for corners in mesh.indices.chunks_exact(3) {
            let points = corners.iter().filter_map(|&k| Some(mesh.vertices.get(k as usize)?.pos));
            let face = points.fold(Rect::NOTHING, |face, point| {
                Rect::from_min_max(face.min.min(point), face.max.max(point))
            });
            for k in silhouette.squares(face) {
                silhouette.covered[k] = true;
            }
        }
        silhouette
    }

    /// Whether some of the aircraft is under a place.
    fn is_under(&self, place: Rect) -> bool {
        self.squares(place).any(|k| self.covered[k])
    }

    fn squares(&self, rect: Rect) -> impl Iterator<Item = usize> + use<> {
        let rect = rect.intersect(self.pane);
        let columns = self.columns;
        let from = ((rect.min - self.pane.min) / SQUARE).floor();
        let to = ((rect.max - self.pane.min) / SQUARE).ceil();
        let is_empty = !rect.is_positive();
        let (rows, across) = if is_empty {
            (0..0, 0..0)
        } else {
            (from.y as usize..to.y as usize, from.x as usize..(to.x as usize).min(columns))
        };
        let last = self.covered.len();
        rows.flat_map(move |row| across.clone().map(move |column| row * columns + column))
            .filter(move |k| *k < last)
    }
}

impl Label {
    /// Symbol and words; without a name in a small pane.
    fn job(&self, is_small: bool) -> LayoutJob {
        let mut job = Symbol::parse(&self.symbol).job(SIZE, self.color);
        let words = match &self.words {
            Words::None => None,
            Words::Name(name) => (!is_small).then_some(*name),
            Words::Value(value) => Some(value.as_str()),
        };
        if let Some(words) = words {
            let gap = if self.symbol.is_empty() { 0.0 } else { 4.0 };
            job.append(words, gap, TextFormat::simple(FontId::proportional(0.88 * SIZE), self.color));
        }
        job
    }
}

/// Places for rectangles inside a pane, none over another or over what is taken, each near where it is wanted and with nothing
/// under it that it `hides` if that can be; `None` where there is no room.
fn placed(
    wanted: &[Rect],
    last: &[Option<Vec2>],
    pane: Rect,
    taken: &[Rect],
    hides: impl Fn(Rect) -> bool,
) -> Vec<Option<Rect>> {
    let inner = pane.shrink(3.0);
    let mut done: Vec<Rect> = taken.to_vec();
    let mut places = Vec::with_capacity(wanted.len());
    for (rect, last) in wanted.iter().zip(last) {
        let free = |place: &Rect| {
            inner.expand(0.5).contains_rect(*place)
                && !done.iter().any(|other| other.expand(1.0).intersects(*place))
        };
        let roomy = |place: &Rect| free(&place.expand(5.0)) && !hides(place.expand(5.0));
        let at = |shift: Vec2| inside(rect.translate(shift), inner);
        let place = Some(at(Vec2::ZERO))
            .filter(roomy)
            .or_else(|| last.map(at).filter(|place| free(place) && !hides(*place)))
            .or_else(|| around().map(at).find(|place| free(place) && !hides(*place)))
            .or_else(|| around().map(at).find(free));
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
        let places: Vec<Rect> = placed(&wanted, &vec![None; wanted.len()], pane, &taken, |_| false)
            .into_iter()
            .flatten()
            .collect();
        assert_eq!(places.len(), wanted.len());
        for (k, place) in places.iter().enumerate() {
            assert!(pane.contains_rect(*place), "{place}");
            assert!(!taken[0].intersects(*place), "{place}");
            assert!(places[..k].iter().all(|other| !other.intersects(*place)), "{place}");
        }
    }

    #[test]
    fn labels_stand_beside_the_silhouette_and_stay_where_they_were() {
        let pane = Rect::from_min_size(Pos2::ZERO, Vec2::new(300.0, 300.0));
        // A cross like an aircraft from above.
        let covered = [
            Rect::from_min_max(Pos2::new(130.0, 60.0), Pos2::new(165.0, 240.0)),
            Rect::from_min_max(Pos2::new(50.0, 120.0), Pos2::new(250.0, 155.0)),
        ];
        let hides = |place: Rect| covered.iter().any(|part| part.intersects(place));
        let at = |x, y| Rect::from_center_size(Pos2::new(x, y), Vec2::new(30.0, 16.0));
        let wanted = [at(150.0, 140.0), at(150.0, 100.0), at(90.0, 140.0), at(20.0, 20.0)];
        let places = placed(&wanted, &[None; 4], pane, &[], hides);
        let shifts: Vec<Option<Vec2>> = places
            .iter()
            .zip(wanted)
            .map(|(place, wanted)| Some(place.as_ref()?.center() - wanted.center()))
            .collect();
        assert!(places.iter().flatten().all(|place| !hides(*place)), "{places:?}");
        assert_eq!(shifts[3], Some(Vec2::ZERO));
        // All a little further: none jumps.
        let moved = wanted.map(|wanted| wanted.translate(Vec2::new(2.0, 1.0)));
        for ((place, moved), shift) in
            placed(&moved, &shifts, pane, &[], hides).iter().zip(moved).zip(&shifts)
        {
            let now = place.expect("a place").center() - moved.center();
            assert!((now - shift.expect("a place")).length() < 0.1 || shift == &Some(Vec2::ZERO), "{now}");
        }
    }

    #[test]
    fn a_silhouette_is_where_the_faces_are() {
        let pane = Rect::from_min_size(Pos2::new(40.0, 30.0), Vec2::new(200.0, 100.0));
        let mut mesh = Mesh::default();
        let corners = [Pos2::new(100.0, 60.0), Pos2::new(130.0, 60.0), Pos2::new(100.0, 80.0)];
        corners.into_iter().for_each(|corner| mesh.colored_vertex(corner, Color32::WHITE));
        mesh.add_triangle(0, 1, 2);
        let silhouette = Silhouette::of(&mesh, pane);
        let at = |x, y| Rect::from_center_size(Pos2::new(x, y), Vec2::splat(10.0));
        assert!(silhouette.is_under(at(110.0, 65.0)));
        assert!(!silhouette.is_under(at(60.0, 65.0)) && !silhouette.is_under(at(110.0, 110.0)));
        assert!(!silhouette.is_under(at(500.0, 500.0)));
    }
}
