//! The ground of a pole map: half planes, rays of equal damping ratio, arcs of equal natural frequency, and their figures.

use egui::epaint::Tessellator;
use egui::{Align2, FontId, Mesh, Painter, Rect, Shape, Stroke, Vec2, pos2};
use nalgebra::Complex;

use super::chart::{Chart, View};
use super::labels::Placement;
use crate::number::trimmed;
use crate::ui::kept::kept;
use crate::ui::theme::Palette;

/// Damping ratios of the rays.
const DAMPING_RATIOS: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

/// Arcs on a map are no more than this.
const MOST_ARCS: f64 = 60.0;

/// Natural frequencies of the arcs \[rad/s\]: three to six round numbers over what the map shows of the left half plane.
fn arc_frequencies(view: View) -> impl Iterator<Item = f64> {
    // The nearest point to the origin, which may be off the map.
    let nearest = |low: f64, high: f64| 0.0_f64.clamp(low.min(high), high.max(low));
    let near = nearest(view.left, view.right.min(0.0)).hypot(nearest(view.bottom, view.top));
    let far = view.reach();
    let edge = view.top.max(-view.bottom).max(-view.left);
    let span = if near > 0.0 { far - near } else { edge };
    let decade = 10_f64.powf((span / 3.0).log10().floor());
    let digit = span / 3.0 / decade;
    let step = decade
        * if digit < 2.0 {
            1.0
        } else if digit < 5.0 {
            2.0
        } else {
            5.0
        };
    let first = (near / step).ceil().max(1.0);
    let count = ((far / step).floor() - first + 1.0).clamp(0.0, MOST_ARCS) as usize;
    (0..count).map(move |k| (first + k as f64) * step)
}

/// ωₙ(cos θ + j sin θ) over the left half plane, finely enough for any zoom.
pub fn arc(wn: f64, chart: &Chart) -> impl Iterator<Item = Complex<f64>> + use<> {
    let radius = wn / chart.per_point();
    let steps = (0.5 * radius).clamp(24.0, 400.0) as i32;
    (-steps..=steps).map(move |k| {
        let angle = std::f64::consts::FRAC_PI_2 * (2.0 + f64::from(k) / f64::from(steps));
        Complex::from_polar(wn, angle)
    })
}

/// Both rays of a damping ratio, λ = ωₙ(−ζ ± j√(1 − ζ²)), from one end to the other by way of the origin.
pub fn rays(zeta: f64, chart: &Chart) -> [Complex<f64>; 3] {
    let end = Complex::new(-zeta, (1.0 - zeta * zeta).sqrt()) * (2.0 * chart.view.reach());
    [end, Complex::from(0.0), end.conj()]
}

/// Draws the ground of the map called `name`.
pub fn draw(painter: &Painter, name: &str, chart: &Chart, palette: &'static Palette) {
    let origin = chart.position(Complex::from(0.0));
    let Rect { min, max } = chart.rect;
    let boundary = origin.x.clamp(min.x, max.x);
    let left = Rect::from_min_max(min, pos2(boundary, max.y));
    let right = Rect::from_min_max(pos2(boundary, min.y), max);
    painter.rect_filled(left, 0.0, palette.stable_half);
    painter.rect_filled(right, 0.0, palette.unstable_half);
    // Hundreds of dashes, which stay where they are as long as the map shows the same part of the plane.
    let key = (*chart, palette, painter.pixels_per_point());
    painter.add(Shape::mesh(kept(painter.ctx(), name, key, || dashes(painter, chart, palette))));
    painter.hline(chart.rect.x_range(), origin.y, Stroke::new(1.0, palette.grid));
    painter.vline(origin.x, chart.rect.y_range(), Stroke::new(1.5, palette.strong));
}

/// Rays and arcs.
fn dashes(painter: &Painter, chart: &Chart, palette: &Palette) -> Mesh {
    let mut shapes = Vec::new();
    let mut dashed = |line: Vec<Vec<egui::Pos2>>| {
        for part in line {
            Shape::dashed_line_many(&part, Stroke::new(1.0, palette.grid), 4.0, 4.0, &mut shapes);
        }
    };
    for zeta in DAMPING_RATIOS {
        let [up, origin, down] = rays(zeta, chart);
        dashed(chart.clipped([origin, up]));
        dashed(chart.clipped([origin, down]));
    }
    for wn in arc_frequencies(chart.view) {
        dashed(chart.clipped(arc(wn, chart)));
    }
    let options = painter.ctx().tessellation_options(|options| *options);
    // Neither text nor discs, so the texture doesn't matter.
    let mut tessellator = Tessellator::new(painter.pixels_per_point(), options, [1, 1], Vec::new());
    let mut mesh = Mesh::default();
    shapes.into_iter().for_each(|shape| tessellator.tessellate_shape(shape, &mut mesh));
    mesh
}

/// Writes figures of rays and arcs, and what the axes are, where there is room.
pub fn labels(painter: &Painter, chart: &Chart, palette: &Palette, placement: &mut Placement) {
    let mut faint = |text: String, at: egui::Pos2, align: Align2| {
        let galley =
            painter.layout_no_wrap(text, FontId::proportional(10.0), palette.weak.gamma_multiply(0.8));
        let place = align.anchor_size(at, galley.size());
        if placement.take(place) {
            painter.galley(place.min, galley, palette.weak);
        }
    };
    let (rect, origin) = (chart.rect, chart.position(Complex::from(0.0)));
    faint("Re λ, 1/s".to_owned(), pos2(rect.left() + 5.0, origin.y - 2.0), Align2::LEFT_BOTTOM);
    faint("Im λ".to_owned(), pos2(origin.x + 5.0, rect.top() + 4.0), Align2::LEFT_TOP);
    if origin.x > rect.left() {
        faint("stable".to_owned(), rect.left_bottom() + Vec2::new(6.0, -4.0), Align2::LEFT_BOTTOM);
    }
    if origin.x < rect.right() {
        faint("unstable".to_owned(), rect.right_bottom() + Vec2::new(-6.0, -4.0), Align2::RIGHT_BOTTOM);
    }
    let inner = chart.part(rect.shrink2(Vec2::new(14.0, 10.0)));
    for zeta in DAMPING_RATIOS {
        let [up, origin, _] = rays(zeta, chart);
        // Just inside the edge that the ray leaves by.
        if let Some(end) = inner.clipped([origin, up]).last().and_then(|part| part.last()) {
            faint(format!("ζ {zeta}"), *end + Vec2::new(0.0, 2.0), Align2::CENTER_CENTER);
        }
    }
    for wn in arc_frequencies(chart.view) {
        let at = chart.position(Complex::from(-wn));
        if at.x > rect.left() + 4.0 {
            let text = format!("{} rad/s", trimmed(wn, 4));
            faint(text, at + Vec2::new(2.0, 2.0), Align2::LEFT_TOP);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_view_has_a_few_arcs_through_it() {
        let fitted = View { left: -5.0, right: 1.0, bottom: -4.0, top: 4.0 };
        for (factor, about) in [
            (1.0, Complex::new(0.0, 0.0)),
            (7.0, Complex::new(-2.5, 2.5)),
            (200.0, Complex::new(-2.5, 2.5)),
            (30.0, Complex::new(-0.02, 0.2)),
            (0.1, Complex::new(-1.0, 0.0)),
        ] {
            let view = fitted.zoomed(factor, about);
            let arcs: Vec<f64> = arc_frequencies(view).collect();
            assert!((2..=40).contains(&arcs.len()), "{factor}: {arcs:?}");
            assert!(arcs.iter().all(|wn| *wn <= view.reach()), "{factor}: {arcs:?}");
        }
    }
}
