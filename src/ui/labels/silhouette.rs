//! What a picture covers of a pane, coarsely: labels stand beside it.

use egui::{Mesh, Rect};

/// Side of a square.
const SQUARE: f32 = 8.0;

/// The part of a pane that faces cover, in squares.
#[derive(Debug)]
pub struct Silhouette {
    pane: Rect,
    columns: usize,
    covered: Vec<bool>,
}

impl Silhouette {
    /// The squares under the triangles of a mesh.
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

    /// Whether something of it is under a place.
    pub fn is_under(&self, place: Rect) -> bool {
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

#[cfg(test)]
mod tests {
    use egui::{Color32, Pos2, Vec2};

    use super::*;

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
