//! All that a chart is drawn with, in points of the screen.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, Stroke};

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Without gaps.
    Full,
    /// Without gaps, on an area that is filled down to zero.
    Filled,
    /// In dashes.
    Dashed,
    /// In dots.
    Dotted,
}

/// Length of a dash and of the gap behind it.
const DASH: (f32, f32) = (5.0, 3.1);
/// From dot to dot.
const DOTS: f32 = 5.0;

impl Pattern {
    /// Width of a curve of this pattern; the radius of its dots.
    pub const fn width(self) -> f32 {
        match self {
            Self::Full => 1.8,
            Self::Filled => 1.3,
            Self::Dashed => 1.2,
            Self::Dotted => 1.6,
        }
    }
}

/// One thing to draw.
#[derive(Clone, Debug, PartialEq)]
pub enum Primitive {
    /// A line through points.
    Line {
        /// The points.
        points: Vec<Pos2>,
        /// Its width and colour.
        stroke: Stroke,
        /// Its dashes or dots.
        pattern: Pattern,
    },
    /// The area between a line and a height.
    Area {
        /// The line.
        line: Vec<Pos2>,
        /// The height.
        base: f32,
        /// Its colour.
        color: Color32,
    },
    /// A filled rectangle.
    Rectangle(Rect, Color32),
    /// A filled circle.
    Dot(Pos2, f32, Color32),
    /// A circle.
    Ring(Pos2, f32, Color32),
}

impl Primitive {
    /// A straight line.
    pub fn line(ends: [Pos2; 2], stroke: Stroke, pattern: Pattern) -> Self {
        Self::Line { points: ends.to_vec(), stroke, pattern }
    }
}

/// Draws a list, the last on top.
pub fn paint(painter: &Painter, list: Vec<Primitive>) {
    for primitive in list {
        match primitive {
            Primitive::Line { points, stroke, pattern } => match pattern {
                Pattern::Full | Pattern::Filled => {
                    painter.add(Shape::line(points, stroke));
                }
                Pattern::Dashed => {
                    painter.extend(Shape::dashed_line(&points, stroke, DASH.0, DASH.1));
                }
                Pattern::Dotted => {
                    painter.extend(Shape::dotted_line(&points, stroke.color, DOTS, stroke.width));
                }
            },
            Primitive::Area { line, base, color } => {
                painter.add(Shape::mesh(area(&line, base, color)));
            }
            Primitive::Rectangle(rect, color) => {
                painter.rect_filled(rect, 0.0, color);
            }
            Primitive::Dot(at, radius, color) => {
                painter.circle_filled(at, radius, color);
            }
            Primitive::Ring(at, radius, color) => {
                painter.circle_stroke(at, radius, Stroke::new(1.6, color));
            }
        }
    }
}

/// Triangles between a line and a height, on whichever side of it the line is.
fn area(line: &[Pos2], base: f32, color: Color32) -> Mesh {
    let mut mesh = Mesh::default();
    let mut corners = |points: &[Pos2]| {
        let first = mesh.vertices.len() as u32;
        points.iter().for_each(|point| mesh.colored_vertex(*point, color));
        (2..points.len() as u32).for_each(|k| mesh.add_triangle(first, first + k - 1, first + k));
    };
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let foot = |point: Pos2| Pos2::new(point.x, base);
        if (a.y - base) * (b.y - base) < 0.0 {
            let crossing = a + (b - a) * ((base - a.y) / (b.y - a.y));
            corners(&[a, foot(a), crossing]);
            corners(&[crossing, foot(b), b]);
        } else {
            corners(&[a, foot(a), foot(b), b]);
        }
    }
    mesh
}

/// Points of a line at equal distances.
pub fn spaced(line: &[Pos2], distance: f32) -> Vec<Pos2> {
    let mut points = Vec::new();
    let mut ahead = 0.5 * distance;
    for pair in line.windows(2) {
        let way = pair[1] - pair[0];
        let length = way.length();
        while ahead <= length {
            points.push(pair[0] + way * (ahead / length));
            ahead += distance;
        }
        ahead -= length;
    }
    points
}

#[cfg(test)]
mod tests {
    use egui::Vec2;

    use super::*;

    /// Size of the filled area, overlaps counted twice.
    fn size(mesh: &Mesh) -> f32 {
        let corner = |k: &u32| mesh.vertices[*k as usize].pos;
        let triangles = mesh.indices.chunks_exact(3).map(|corners| {
            let [a, b, c] = [corner(&corners[0]), corner(&corners[1]), corner(&corners[2])];
            0.5 * ((b - a).x * (c - a).y - (b - a).y * (c - a).x).abs()
        });
        triangles.sum()
    }

    #[test]
    fn an_area_is_that_between_its_line_and_its_height_on_both_sides() {
        // ∫ |8 cos x| dx over two periods, x in tenths of a point: 4 · 2 · 8 · 10.
        let wave = |k: i32| {
            let x = k as f32 * 0.01 * 2.0 * std::f32::consts::TAU;
            Pos2::new(30.0 + 10.0 * x, 70.0 + 8.0 * x.cos())
        };
        let line: Vec<Pos2> = (0..=100).map(wave).collect();
        let area = size(&area(&line, 70.0, Color32::RED));
        assert!((area - 640.0).abs() < 3.0, "{area}");
    }

    #[test]
    fn points_along_a_line_are_spaced_evenly_around_its_corners() {
        let line = [Pos2::ZERO, Pos2::new(10.0, 0.0), Pos2::new(10.0, 20.0)];
        let points = spaced(&line, 4.0);
        assert_eq!(points[..3], [Pos2::new(2.0, 0.0), Pos2::new(6.0, 0.0), Pos2::new(10.0, 0.0)]);
        assert_eq!(points[3] - points[2], Vec2::new(0.0, 4.0));
        assert_eq!(points.len(), 8);
    }
}
