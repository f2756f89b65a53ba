//! Arrows on the picture, straight ones and ones around an axis, of even width on the screen.

use std::f32::consts::TAU;

use egui::{Color32, Painter, Pos2, Shape, Stroke, Vec2};

use super::camera::Lens;
use crate::shape::Point;

const HEAD: f32 = 9.0;
const POINTS_PER_TURN: f32 = 72.0;
/// Every so many of its points tell a label where an arc is.
const COARSE: usize = 5;

/// An arrow's ink.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArrowStyle {
    pub color: Color32,
    pub width: f32,
    /// Around the line, so that it is seen on anything.
    pub halo: Color32,
    pub is_dashed: bool,
}

/// The end of an arrow on the screen, the direction that it has there, and how it goes there, roughly.
#[derive(Clone, Debug)]
pub(super) struct Tip {
    pub at: Pos2,
    pub towards: Vec2,
    pub line: Vec<Pos2>,
}

/// A straight arrow; `None` where nothing of it is drawn.
pub(super) fn straight(
    painter: &Painter,
    lens: &Lens,
    pen: ArrowStyle,
    from: Point,
    along: Point,
) -> Option<Tip> {
    let (a, b) = (lens.project(&from)?, lens.project(&(from + along))?);
    line(painter, pen, &[a, b])
}

/// A line between two points without a head.
pub(super) fn plain(painter: &Painter, lens: &Lens, pen: ArrowStyle, from: Point, along: Point) {
    if let (Some(a), Some(b)) = (lens.project(&from), lens.project(&(from + along))) {
        strokes(painter, pen, &[a, b]);
    }
}

/// An arrow that goes from one direction, by an angle \[rad\], towards another, about a middle.
pub(super) fn arc(
    painter: &Painter,
    lens: &Lens,
    pen: ArrowStyle,
    (middle, from, towards): (Point, Point, Point),
    angle: f32,
) -> Option<Tip> {
    let steps = (angle.abs() / TAU * POINTS_PER_TURN).ceil().clamp(2.0, POINTS_PER_TURN) as usize;
    let points: Option<Vec<Pos2>> = (0..=steps)
        .map(|k| {
            let (sin, cos) = (angle * k as f32 / steps as f32).sin_cos();
            lens.project(&(middle + from * cos + towards * sin))
        })
        .collect();
    line(painter, pen, &points?)
}

fn line(painter: &Painter, pen: ArrowStyle, points: &[Pos2]) -> Option<Tip> {
    let end = *points.last()?;
    // Its direction at the end, from a point that isn't too near to have one.
    let before = points.iter().rev().find(|point| point.distance(end) > 2.0)?;
    let towards = (end - *before).normalized();
    let length: f32 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    // A short arrow has a small head.
    let head = HEAD.min(0.6 * length);
    let neck = end - towards * head;
    // The shaft ends within the head; an arc may have been beyond it before.
    let is_behind = |p: &Pos2| (*p - end).dot(towards) < -0.7 * head;
    let count = points.iter().rposition(is_behind).map_or(0, |last| last + 1);
    let mut shaft = points[..count].to_vec();
    shaft.push(end - towards * 0.7 * head);
    strokes(painter, pen, &shaft);
    let wing = towards.rot90() * (0.42 * head + 0.4 * pen.width);
    let corners = vec![end, neck + wing, neck - wing];
    painter.add(Shape::convex_polygon(corners, pen.color, Stroke::new(1.0, pen.halo)));
    // Eight parts of half a turn are an arc to a label.
    let mut line: Vec<Pos2> = points.iter().copied().step_by(COARSE).collect();
    line.push(neck);
    Some(Tip { at: end, towards, line })
}

fn strokes(painter: &Painter, pen: ArrowStyle, points: &[Pos2]) {
    if pen.is_dashed {
        painter.extend(Shape::dashed_line(points, Stroke::new(pen.width, pen.color), 5.0, 4.0));
    } else {
        painter.line(points.to_vec(), Stroke::new(pen.width + 2.0, pen.halo));
        painter.line(points.to_vec(), Stroke::new(pen.width, pen.color));
    }
}
