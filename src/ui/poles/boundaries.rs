//! Boundaries of the levels of handling qualities: lines in the colour of their mode, hatched on the side that fails.

use egui::{FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2};
use nalgebra::Complex;

use super::grid;
use crate::flight::verdicts::handling_qualities::Level;
use crate::flight::verdicts::level_boundaries::{Boundary, Line};
use crate::ui::chart::{Chart, spaced};
use crate::ui::labels::Placement;
use crate::ui::theme::{self, Palette};
use crate::words;

/// Distance and length of the strokes of the hatching.
const HATCH: (f32, f32) = (7.0, 6.0);
/// Half the length of a boundary that is set on real roots: it means something on the real axis only.
const ON_AXIS: f32 = 30.0;

/// A boundary on the screen.
pub struct Drawn<'a> {
    boundary: &'a Boundary,
    /// Its visible parts.
    parts: Vec<Vec<Pos2>>,
    /// Towards the failing side, at a point.
    fails: Box<dyn Fn(Pos2) -> Vec2>,
}

/// Where a boundary is on the map.
pub fn drawn<'a>(boundary: &'a Boundary, chart: &Chart) -> Drawn<'a> {
    let origin = chart.position(Complex::from(0.0));
    // Towards larger ζ, ωₙ or σ.
    let outward: Box<dyn Fn(Pos2) -> Vec2>;
    let parts = match boundary.line {
        Line::DampingRatio(zeta) => {
            let side = (1.0 - zeta * zeta).sqrt() as f32;
            // Across the ray, away from the imaginary axis; y grows downwards.
            outward = Box::new(move |at| {
                let up = if at.y < origin.y { 1.0 } else { -1.0 };
                Vec2::new(-side, up * zeta as f32)
            });
            let [up, zero, down] = grid::rays(zeta, chart);
            [chart.clipped([zero, up]), chart.clipped([zero, down])].concat()
        }
        Line::NaturalFrequency(wn) => {
            outward = Box::new(move |at| (at - origin).normalized());
            chart.clipped(grid::arc(wn, chart))
        }
        Line::RealPart(sigma) => {
            outward = Box::new(|_| Vec2::RIGHT);
            let end = if boundary.is_of_real_root() {
                f64::from(ON_AXIS) * chart.per_point()
            } else {
                2.0 * chart.view.reach()
            };
            chart.clipped([Complex::new(sigma, end), Complex::new(sigma, -end)])
        }
    };
    let sign = if boundary.above { -1.0 } else { 1.0 };
    Drawn { boundary, parts, fails: Box::new(move |at| sign * outward(at)) }
}

fn strength(level: Level) -> f32 {
    match level {
        Level::One => 0.85,
        Level::Two => 0.6,
        Level::Three | Level::Beyond => 0.4,
    }
}

/// Draws the lines.
pub fn draw(painter: &Painter, palette: &Palette, lines: &[Drawn<'_>]) {
    for Drawn { boundary, parts, fails } in lines {
        let color = palette.mode(boundary.criterion.concerns()).gamma_multiply(strength(boundary.level));
        let hatch = Stroke::new(1.0, color.gamma_multiply(0.7));
        for part in parts {
            for at in spaced(part, HATCH.0) {
                let across = fails(at);
                let along = Vec2::new(-across.y, across.x);
                painter.line_segment([at, at + HATCH.1 * (across + 0.6 * along)], hatch);
            }
            painter.add(Shape::line(part.clone(), Stroke::new(1.4, color)));
        }
    }
}

/// Keeps labels off the lines.
pub fn keep_clear(placement: &mut Placement, lines: &[Drawn<'_>]) {
    for at in lines.iter().flat_map(|line| &line.parts).flat_map(|part| spaced(part, 8.0)) {
        placement.keep_clear(Rect::from_center_size(at, Vec2::splat(5.0)));
    }
}

/// Distance from a point of the screen to a boundary \[points\].
pub fn distance(boundary: &Boundary, chart: &Chart, to: Pos2) -> f32 {
    let parts = drawn(boundary, chart).parts;
    parts.iter().flat_map(|part| spaced(part, 3.0)).map(|at| at.distance(to)).fold(f32::INFINITY, f32::min)
}

/// Writes what each line is, beside it on the side that keeps the limit, where there is room.
pub fn labels(painter: &Painter, palette: &Palette, placement: &mut Placement, lines: &[Drawn<'_>]) {
    for Drawn { boundary, parts, fails } in lines {
        let color = palette.mode_text(boundary.criterion.concerns());
        let font = FontId::proportional(theme::sizes(painter.ctx()).tick);
        let galley = painter.layout_no_wrap(words::verdict::boundary(boundary), font, color);
        let place = |at: Pos2| {
            let keeps = -fails(at);
            let half = 0.5 * galley.size();
            // The box touches the line with the corner or side that is nearest to it.
            Rect::from_center_size(
                at + keeps * 5.5 + Vec2::new(keeps.x * half.x, keeps.y * half.y),
                galley.size(),
            )
        };
        let along = parts.iter().flat_map(|part| spaced(part, 12.0));
        if let Some(place) = placement.take_first(along.map(place)) {
            painter.galley(place.min, galley, color);
        }
    }
}
