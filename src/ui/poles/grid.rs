//! The ground of a pole map: half planes, rays of equal damping ratio, arcs of equal natural frequency, and their figures.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Mesh, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2};
use nalgebra::Complex;

use crate::number::{nice_step, trimmed};
use crate::ui::chart::{Chart, Room, Scale, Tick, View};
use crate::ui::kept::kept;
use crate::ui::labels::Placement;
use crate::ui::theme::{self, Palette};

/// Damping ratios of the rays.
const DAMPING_RATIOS: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

/// Length of a dash and of the gap behind it.
const DASH: (f32, f32) = (5.0, 5.0);

/// Arcs on a fitted map, no more than these, and fewer where rounding makes their step larger.
const ARCS: f64 = 6.0;
/// Arcs on a map are never more than this.
const MOST_ARCS: f64 = 60.0;

/// Natural frequencies of the arcs \[rad/s\]: two to six round numbers over what the map shows of the left half plane.
fn arc_frequencies(view: View) -> impl Iterator<Item = f64> {
    // The nearest point to the origin, which may be off the map.
    let nearest = |low: f64, high: f64| 0.0_f64.clamp(low.min(high), high.max(low));
    let near = nearest(view.left, view.right.min(0.0)).hypot(nearest(view.bottom, view.top));
    let far = view.reach();
    let edge = view.top.max(-view.bottom).max(-view.left);
    let span = if near > 0.0 { far - near } else { edge };
    let step = nice_step(span / ARCS);
    let first = (near / step).ceil().max(1.0);
    let count = ((far / step).floor() - first + 1.0).clamp(0.0, MOST_ARCS) as usize;
    (0..count).map(move |k| (first + k as f64) * step)
}

/// ωₙ(cos θ + j sin θ) over the left half plane, by chords that leave it by a tenth of a point at most, or, on an arc of more than
/// 50,000 points, that look straight as it does.
pub fn arc(wn: f64, chart: &Chart) -> impl Iterator<Item = Complex<f64>> + use<> {
    let radius = wn / chart.per_point();
    // A chord c leaves an arc of radius R by c²/8R; n of them make a quarter of the circle.
    let steps = (1.8 * radius.sqrt()).clamp(12.0, 400.0) as i32;
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
    let dashes = kept(painter.ctx(), name, (*chart, palette), || dashes(chart, palette));
    painter.add(Shape::mesh(dashes));
    painter.hline(chart.rect.x_range(), origin.y, Stroke::new(1.0, palette.grid));
    painter.vline(origin.x, chart.rect.y_range(), Stroke::new(1.5, palette.strong));
}

/// Rays and arcs.
fn dashes(chart: &Chart, palette: &Palette) -> Mesh {
    let mut mesh = Mesh::default();
    let mut dashed = |line: Vec<Vec<Pos2>>| {
        let mut dashes = Vec::new();
        for part in line {
            Shape::dashed_line_many(&part, Stroke::new(1.0, palette.grid), DASH.0, DASH.1, &mut dashes);
        }
        for dash in dashes {
            if let Shape::LineSegment { points, .. } = dash {
                thin_line(&mut mesh, points, palette.grid);
            }
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
    mesh
}

/// A line a point wide whose colour fades to both sides: two thirds of the corners that egui would give it and two fifths of the
/// triangles, since it has no caps. There are hundreds on a map, and every frame draws them.
fn thin_line(mesh: &mut Mesh, ends: [Pos2; 2], color: Color32) {
    let across = (ends[1] - ends[0]).normalized().rot90();
    let first = mesh.vertices.len() as u32;
    for end in ends {
        mesh.colored_vertex(end - across, Color32::TRANSPARENT);
        mesh.colored_vertex(end, color);
        mesh.colored_vertex(end + across, Color32::TRANSPARENT);
    }
    for k in [first, first + 1] {
        mesh.add_triangle(k, k + 1, k + 3);
        mesh.add_triangle(k + 1, k + 4, k + 3);
    }
}

/// Length of a tick at the lower edge.
const TICK: f32 = 4.0;
/// From one row of words to the next.
const ROW: f32 = 17.0;
/// Figures of arcs are so far from each other.
const APART: f32 = 30.0;
/// Ticks of the real axis likewise.
const TICKS_APART: f32 = 44.0;

/// Writes the scale before anything else takes its place: figures of Re λ along the lower edge, with ticks there and on the real
/// axis where real poles are read, and one arc's ωₙ, which it gives.
pub fn scale(painter: &Painter, chart: &Chart, palette: &Palette, placement: &mut Placement) -> Option<f64> {
    let (rect, origin) = (chart.rect, chart.position(Complex::from(0.0)));
    let line = Stroke::new(1.0, palette.weak);
    for Tick { value, label } in ticks(chart, &|text| figure(painter, text.to_owned(), palette).size().x) {
        let x = chart.position(Complex::from(value)).x;
        painter.vline(x, rect.bottom() - TICK..=rect.bottom(), line);
        painter.vline(x, origin.y - 0.6 * TICK..=origin.y + 0.6 * TICK, line);
        let galley = figure(painter, label, palette);
        let place = Align2::CENTER_BOTTOM.anchor_size(pos2(x, rect.bottom() - TICK), galley.size());
        write(painter, placement, galley, [place]);
    }
    arc_frequencies(chart.view).find(|wn| arc_label(painter, chart, palette, placement, *wn))
}

/// Round numbers of Re λ on the map but for 0, which has its own line; `width` is that of a label.
fn ticks(chart: &Chart, width: &dyn Fn(&str) -> f32) -> Vec<Tick> {
    let is_zero = |label: &str| label.chars().all(|c| matches!(c, '0' | '.'));
    let extent = |label: &str| if is_zero(label) { f32::INFINITY } else { width(label) };
    let room = Room { length: chart.rect.width(), apart: TICKS_APART, extent: &extent, overhang: -3.0 };
    Scale::Even.ticks(&(chart.view.left..=chart.view.right), room)
}

fn figure(painter: &Painter, text: String, palette: &Palette) -> Arc<Galley> {
    painter.layout_no_wrap(text, FontId::proportional(theme::sizes(painter.ctx()).tick), palette.weak)
}

/// Writes a figure at the first of some places that is free, and says whether one was.
fn write(
    painter: &Painter,
    placement: &mut Placement,
    galley: Arc<Galley>,
    places: impl IntoIterator<Item = Rect>,
) -> bool {
    let place = places.into_iter().find(|place| placement.take(*place));
    if let Some(place) = place {
        painter.galley(place.min, galley, Color32::PLACEHOLDER);
    }
    place.is_some()
}

/// Writes ωₙ beside the end of an arc on the imaginary axis, or on the real axis; says whether there was room.
fn arc_label(
    painter: &Painter,
    chart: &Chart,
    palette: &Palette,
    placement: &mut Placement,
    wn: f64,
) -> bool {
    let galley = figure(painter, format!("{} rad/s", trimmed(wn, 4)), palette);
    let [below, above] = [-wn, wn].map(|im| chart.position(Complex::new(0.0, im)) + Vec2::new(-5.0, 0.0));
    let real = chart.position(Complex::from(-wn)) + Vec2::new(2.0, 2.0);
    let places = [(below, Align2::RIGHT_CENTER), (above, Align2::RIGHT_CENTER), (real, Align2::LEFT_TOP)];
    let places = places.map(|(at, align)| align.anchor_size(at, galley.size()));
    write(painter, placement, galley, places)
}

/// Writes figures of rays and of the arcs but for the one that is `written`, and what the axes are, where there is room.
pub fn labels(
    painter: &Painter,
    chart: &Chart,
    palette: &Palette,
    placement: &mut Placement,
    written: Option<f64>,
) {
    let mut faint = |text: String, places: &[(Pos2, Align2)]| {
        let galley = figure(painter, text, palette);
        let size = galley.size();
        write(painter, placement, galley, places.iter().map(|(at, align)| align.anchor_size(*at, size)))
    };
    let (rect, origin) = (chart.rect, chart.position(Complex::from(0.0)));
    // Above the figures along the edge.
    let above = |x: f32, rows: f32| pos2(x, rect.bottom() - TICK - rows * ROW);
    let (left, right) = (rect.left() + 6.0, rect.right() - 6.0);
    let on_axis = pos2(rect.left() + 5.0, origin.y - 2.0);
    let beside = [(on_axis, Align2::LEFT_BOTTOM), (above(left, 2.0), Align2::LEFT_BOTTOM)];
    faint("Re λ, 1/s".to_owned(), &beside);
    faint("Im λ".to_owned(), &[(pos2(origin.x + 5.0, rect.top() + 4.0), Align2::LEFT_TOP)]);
    if origin.x > rect.left() {
        faint("stable".to_owned(), &[(above(left, 1.0), Align2::LEFT_BOTTOM)]);
    }
    if origin.x < rect.right() {
        faint("unstable".to_owned(), &[(above(right, 1.0), Align2::RIGHT_BOTTOM)]);
    }
    let inner = chart.part(rect.shrink2(Vec2::new(14.0, 10.0)));
    for zeta in DAMPING_RATIOS {
        let [up, origin, _] = rays(zeta, chart);
        // Just inside the edge that the ray leaves by.
        if let Some(end) = inner.clipped([origin, up]).last().and_then(|part| part.last()) {
            faint(format!("ζ {zeta}"), &[(*end + Vec2::new(0.0, 2.0), Align2::CENTER_CENTER)]);
        }
    }
    // Those that are a whole number of steps from the one that is written.
    let mut arcs = arc_frequencies(chart.view).peekable();
    let first = written.or(arcs.peek().copied()).unwrap_or(0.0);
    let apart = if theme::is_for_a_room(painter.ctx()) { 2.2 * APART } else { APART };
    let mut last = first;
    for wn in arcs.filter(|wn| *wn > first) {
        if wn - last > f64::from(apart) * chart.per_point() {
            arc_label(painter, chart, palette, placement, wn);
            last = wn;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_map_has_two_figures_of_the_real_axis_and_a_wide_one_has_none_on_another() {
        let width = |text: &str| 6.0 * text.chars().count() as f32;
        for (points, height) in [(70.0, 260.0), (99.0, 260.0), (155.0, 190.0), (236.0, 320.0), (600.0, 500.0)]
        {
            let rect = Rect::from_min_size(pos2(3.0, 4.0), Vec2::new(points, height));
            for k in 0..200 {
                let scale = 1e-4 * 10_f64.powf(0.04 * f64::from(k));
                let view = View { left: -5.0 * scale, right: scale, bottom: -scale, top: scale };
                let chart = Chart { rect, view };
                let ticks = ticks(&chart, &width);
                assert!(ticks.len() >= 2, "{points} points, {scale}: {ticks:?}");
                let end = |tick: &Tick, side: f32| {
                    chart.position(Complex::from(tick.value)).x + side * 0.5 * width(&tick.label)
                };
                let apart = ticks.windows(2).all(|pair| end(&pair[0], 1.0) < end(&pair[1], -1.0));
                assert!(apart || points < 200.0, "{points} points, {scale}: {ticks:?}");
            }
        }
    }

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
            let view = fitted.zoomed(factor, about.into());
            let arcs: Vec<f64> = arc_frequencies(view).collect();
            assert!((2..=40).contains(&arcs.len()), "{factor}: {arcs:?}");
            assert!(arcs.iter().all(|wn| *wn <= view.reach()), "{factor}: {arcs:?}");
        }
    }
}
