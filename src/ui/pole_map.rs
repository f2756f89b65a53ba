//! The pole map: eigenvalues in the complex plane, the slow ones a second time at their own scale.

use egui::{
    Align2, Color32, FontId, Pos2, Rect, RichText, Stroke, Ui, UiBuilder, Vec2, WidgetInfo, accesskit::Role,
};
use egui_plot::{Line, LineStyle, MarkerShape, PlotPoint, PlotPoints, Points, Span, VLine};

use super::axis_range::{AxisRange, round_up};
use super::pole_grid::{self, View};
use super::pole_labels::Placement;
use super::theme::{self, Palette};
use crate::flight::locus::{Locus, Sample};
use crate::flight::modes::{DynamicStability, Mode};
use crate::number::{fixed, significant};

/// The ranges of both maps as they are on screen.
#[derive(Debug, Default)]
pub struct PoleMap {
    whole: MapRange,
    slow: MapRange,
}

#[derive(Debug, Default)]
struct MapRange {
    x: AxisRange,
    y: AxisRange,
}

impl PoleMap {
    /// Draws both maps side by side, or one above the other where that gives them a better shape.
    pub fn show(&mut self, ui: &mut Ui, modes: &[Mode], ghost: Option<&[Mode]>, locus: Option<&Locus>) {
        let palette = Palette::of(ui);
        let (rect, _) = ui.allocate_exact_size(ui.available_size(), egui::Sense::hover());
        let split = rect.left() + (0.6 * rect.width()).round();
        let whole = Rect::from_min_max(rect.min, Pos2::new(split - 5.0, rect.max.y));
        let slow = Rect::from_min_max(Pos2::new(split + 5.0, rect.min.y), rect.max);

        let all: Vec<&Mode> = modes.iter().collect();
        let few = slow_modes(modes);
        let maps = [
            Map { name: "All modes", rect: whole, ranged: all, inset: None },
            Map { name: "Slow modes, own scale", rect: slow, ranged: few, inset: None },
        ];
        let mut views = Vec::new();
        for (map, range) in maps.iter().zip([&mut self.whole, &mut self.slow]) {
            views.push(range.toward(ui, map.wanted_view(), map.plot_rect()));
        }
        let [whole, slow] = maps;
        let drawn = Drawn { modes, ghost, locus };
        Map { inset: Some(views[1]), ..whole }.show(ui, palette, views[0], drawn);
        slow.show(ui, palette, views[1], drawn);
    }
}

impl MapRange {
    /// The view to draw now: `wanted`, widened to the shape of `rect` so that both axes have one scale.
    fn toward(&mut self, ui: &Ui, wanted: View, rect: Rect) -> View {
        let aspect = f64::from(rect.width() / rect.height().max(1.0));
        let width = wanted.right - wanted.left;
        let (left, top) = if width < 2.0 * wanted.top * aspect {
            (wanted.right - 2.0 * wanted.top * aspect, wanted.top)
        } else {
            (wanted.left, 0.5 * width / aspect)
        };
        let x = self.x.toward(ui, left..=wanted.right);
        let y = self.y.toward(ui, -top..=top);
        View { left: *x.start(), right: *x.end(), top: *y.end() }
    }
}

/// The modes below the widest gap between one |λ| and the next: those that the fast ones would crowd together.
fn slow_modes(modes: &[Mode]) -> Vec<&Mode> {
    let mut sorted: Vec<&Mode> = modes.iter().collect();
    sorted.sort_by(|a, b| a.lambda.norm().total_cmp(&b.lambda.norm()));
    let gap = |pair: &[&Mode]| pair[1].lambda.norm() / pair[0].lambda.norm().max(f64::MIN_POSITIVE);
    let widest = sorted.windows(2).enumerate().max_by(|a, b| gap(a.1).total_cmp(&gap(b.1)));
    let count = widest.map_or(1, |(i, _)| i + 1);
    sorted.truncate(count);
    sorted
}

/// What both maps draw.
#[derive(Clone, Copy)]
struct Drawn<'a> {
    modes: &'a [Mode],
    ghost: Option<&'a [Mode]>,
    /// The path of the slider that the person is at.
    locus: Option<&'a Locus>,
}

/// One of the two maps.
struct Map<'a> {
    name: &'static str,
    rect: Rect,
    /// The modes that its range is made for.
    ranged: Vec<&'a Mode>,
    /// What the other map shows, drawn as a frame in this one.
    inset: Option<View>,
}

impl Map<'_> {
    fn plot_rect(&self) -> Rect {
        let mut rect = self.rect;
        rect.min.y += 18.0;
        rect
    }

    /// The part of the plane that holds its modes with room for labels, in round numbers.
    fn wanted_view(&self) -> View {
        let largest = |part: fn(&Mode) -> f64| self.ranged.iter().map(|mode| part(mode)).fold(0.0, f64::max);
        let (left, right) = (largest(|m| -m.lambda.re), largest(|m| m.lambda.re));
        let reach = left.max(right).max(largest(|m| m.lambda.im)).max(1e-3);
        let top = round_up((1.3 * largest(|m| m.lambda.im)).max(0.35 * reach));
        View {
            left: -round_up((1.25 * left).max(0.5 * reach)),
            right: round_up((1.3 * right).max(0.22 * reach)),
            top,
        }
    }

    fn show(&self, ui: &mut Ui, palette: &Palette, view: View, drawn: Drawn<'_>) {
        let Drawn { modes, ghost, locus } = drawn;
        ui.painter().text(self.rect.min, Align2::LEFT_TOP, self.name, theme::small(), palette.weak);
        let rect = self.plot_rect();
        let plot = ui
            .scope_builder(UiBuilder::new().max_rect(rect), |ui| {
                theme::still_plot(self.name, rect).show(ui, |plot| {
                    plot.set_plot_bounds_x(view.left..=view.right);
                    plot.set_plot_bounds_y(-view.top..=view.top);
                    plane(plot, view, palette);
                    if let Some(inset) = self.inset {
                        frame_of(plot, inset, palette);
                    }
                    for branch in locus.into_iter().flat_map(|locus| branches(locus, palette)) {
                        plot.line(branch);
                    }
                    for mode in ghost.into_iter().flatten() {
                        plot.points(
                            poles(mode)
                                .shape(MarkerShape::Circle)
                                .filled(false)
                                .radius(5.0)
                                .color(palette.ghost),
                        );
                    }
                    for mode in modes {
                        plot.points(
                            poles(mode)
                                .shape(MarkerShape::Cross)
                                .radius(6.5)
                                .color(palette.mode(mode.naming.name)),
                        );
                    }
                })
            })
            .inner;
        let description = describe(self.name, modes);
        plot.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, description.as_str()));

        let position = |re: f64, im: f64| plot.transform.position_from_point(&PlotPoint::new(re, im));
        let painter = ui.painter().with_clip_rect(rect);
        let mut placement = Placement::new(rect.shrink(3.0));
        for mode in modes {
            for im in [mode.lambda.im, -mode.lambda.im] {
                placement.keep_clear(Rect::from_center_size(position(mode.lambda.re, im), Vec2::splat(14.0)));
            }
        }
        // No label across the stability boundary.
        placement.keep_clear(Rect::from_center_size(position(0.0, 0.0), Vec2::new(2.0, 2.0 * rect.height())));
        for mode in modes {
            let anchor = position(mode.lambda.re, mode.lambda.im);
            if rect.contains(anchor) && self.inset.is_none_or(|inset| !crowded(mode, view, inset)) {
                label(&painter, palette, &mut placement, anchor, mode);
            } else if rect.contains(anchor) {
                name_only(&painter, palette, &mut placement, anchor, mode);
            }
        }
        grid_labels(&painter, palette, &mut placement, view, &position);
        hover_ui(ui, &plot.response, palette, modes, &position);
        ui.painter().rect_stroke(rect, 4.0, Stroke::new(1.0, palette.hairline), egui::StrokeKind::Inside);
    }
}

/// Whether a mode belongs to the other map, where there is room for its numbers.
fn crowded(mode: &Mode, view: View, inset: View) -> bool {
    inset.top < 0.3 * view.top && mode.lambda.norm() < inset.top.max(-inset.left)
}

fn poles(mode: &Mode) -> Points<'static> {
    let mut points = vec![PlotPoint::new(mode.lambda.re, mode.lambda.im)];
    if mode.is_oscillatory() {
        points.push(PlotPoint::new(mode.lambda.re, -mode.lambda.im));
    }
    Points::new(mode.naming.name.text(), PlotPoints::Owned(points)).allow_hover(false)
}

/// The path of each pole in the colour of its mode, broken where there is no such aircraft.
fn branches(locus: &Locus, palette: &Palette) -> Vec<Line<'static>> {
    let line = |points: Vec<PlotPoint>, color: Color32| {
        let line = Line::new("", PlotPoints::Owned(points)).color(color.gamma_multiply(0.65)).width(2.0);
        line.style(LineStyle::dotted_dense()).allow_band(false).allow_hover(false)
    };
    let mut lines = Vec::new();
    for (branch, name) in locus.names.iter().enumerate() {
        let color = name.map_or(palette.ghost, |name| palette.mode(name));
        for run in locus.samples.split(|sample| sample.poles.is_none()) {
            let pole = |sample: &Sample| {
                sample.poles.map(|poles| PlotPoint::new(poles[branch].re, poles[branch].im))
            };
            let points: Vec<PlotPoint> = run.iter().filter_map(pole).collect();
            if points.len() > 1 {
                lines.push(line(points, color));
            }
        }
    }
    lines
}

/// Half planes, stability boundary, real axis, rays and arcs.
fn plane(plot: &mut egui_plot::PlotUi<'_>, view: View, palette: &Palette) {
    let half = |range, color: Color32| {
        Span::new("", range).axis(egui_plot::Axis::X).fill(color).border_color(Color32::TRANSPARENT)
    };
    plot.span(half(view.left.min(0.0)..=0.0, palette.stable_half));
    plot.span(half(0.0..=view.right.max(0.0), palette.unstable_half));
    pole_grid::grid(plot, view, palette);
    let axis = egui_plot::HLine::new("", 0.0).color(palette.grid).width(1.0).allow_hover(false);
    plot.hline(axis);
    plot.vline(VLine::new("", 0.0).color(palette.strong).width(1.5).allow_hover(false));
}

fn frame_of(plot: &mut egui_plot::PlotUi<'_>, inset: View, palette: &Palette) {
    let corners = [
        (inset.left, -inset.top),
        (inset.right, -inset.top),
        (inset.right, inset.top),
        (inset.left, inset.top),
    ];
    let points = corners.map(|(x, y)| PlotPoint::new(x, y)).to_vec();
    plot.polygon(
        egui_plot::Polygon::new("", PlotPoints::Owned(points))
            .fill_color(Color32::TRANSPARENT)
            .stroke(Stroke::new(1.0, palette.ghost))
            .style(LineStyle::Solid)
            .allow_hover(false),
    );
}

/// Name and the two numbers that matter most, beside a pole.
fn label(painter: &egui::Painter, palette: &Palette, placement: &mut Placement, anchor: Pos2, mode: &Mode) {
    let color = palette.mode(mode.naming.name);
    let name = painter.layout_no_wrap(mode.naming.name.text().to_owned(), theme::semibold(12.5), color);
    let numbers = painter.layout_no_wrap(numbers(mode), FontId::proportional(11.0), color);
    let size = Vec2::new(name.size().x.max(numbers.size().x), name.size().y + numbers.size().y);
    if let Some(place) = placement.beside(anchor, size) {
        let below = place.min + Vec2::new(0.0, name.size().y);
        painter.galley(place.min, name, color);
        painter.galley(below, numbers, color);
    } else {
        name_only(painter, palette, placement, anchor, mode);
    }
}

fn name_only(
    painter: &egui::Painter,
    palette: &Palette,
    placement: &mut Placement,
    anchor: Pos2,
    mode: &Mode,
) {
    let color = palette.mode(mode.naming.name);
    let name = painter.layout_no_wrap(mode.naming.name.text().to_owned(), theme::semibold(11.5), color);
    if let Some(place) = placement.beside(anchor, name.size()) {
        painter.galley(place.min, name, color);
    }
}

/// "ζ 0.69 · 2.4 s" of an oscillation, the time to half or double of a real root.
fn numbers(mode: &Mode) -> String {
    let numbers = match (mode.damping_ratio(), mode.period()) {
        (Some(zeta), Some(period)) => format!("ζ {} · T {} s", fixed(zeta, 2), significant(period, 3)),
        _ => match (mode.time_to_half(), mode.time_to_double()) {
            (Some(t), _) => format!("halves in {} s", significant(t, 2)),
            (_, Some(t)) => format!("doubles in {} s", significant(t, 2)),
            _ => "neutral".to_owned(),
        },
    };
    if mode.is_oscillatory() && mode.stability == DynamicStability::Unstable {
        format!("{numbers} · unstable")
    } else {
        numbers
    }
}

/// What the map shows, in words.
fn describe(name: &str, modes: &[Mode]) -> String {
    let modes: Vec<String> =
        modes.iter().map(|mode| format!("{} {}", mode.naming.name.text(), numbers(mode))).collect();
    format!("Pole map, {name}: {}", modes.join("; "))
}

fn grid_labels(
    painter: &egui::Painter,
    palette: &Palette,
    placement: &mut Placement,
    view: View,
    position: &impl Fn(f64, f64) -> Pos2,
) {
    let mut faint = |text: String, at: Pos2, align: Align2| {
        let galley =
            painter.layout_no_wrap(text, FontId::proportional(10.0), palette.weak.gamma_multiply(0.8));
        let place = align.anchor_size(at, galley.size());
        if placement.is_free(place) {
            placement.keep_clear(place.expand(2.0));
            painter.galley(place.min, galley, palette.weak);
        }
    };
    faint("Re λ, 1/s".to_owned(), position(view.left, 0.0) + Vec2::new(5.0, -2.0), Align2::LEFT_BOTTOM);
    faint("Im λ".to_owned(), position(0.0, view.top) + Vec2::new(5.0, 4.0), Align2::LEFT_TOP);
    faint("stable".to_owned(), position(view.left, -view.top) + Vec2::new(6.0, -4.0), Align2::LEFT_BOTTOM);
    faint(
        "unstable".to_owned(),
        position(view.right, -view.top) + Vec2::new(-6.0, -4.0),
        Align2::RIGHT_BOTTOM,
    );
    for zeta in pole_grid::DAMPING_RATIOS {
        let slope = (1.0 - zeta * zeta).sqrt() / zeta;
        // Just inside the edge that the ray leaves by: the top, or the left.
        let im = (0.93 * view.top).min(0.95 * slope * -view.left);
        faint(format!("ζ {zeta}"), position(-im / slope, im) + Vec2::new(0.0, -2.0), Align2::CENTER_CENTER);
    }
    for wn in pole_grid::arc_frequencies(view).filter(|wn| *wn < 0.97 * -view.left) {
        faint(
            format!("{} rad/s", significant(wn, 2).trim_end_matches(".0")),
            position(-wn, 0.0) + Vec2::new(2.0, 2.0),
            Align2::LEFT_TOP,
        );
    }
}

/// The numbers of the nearest pole while the pointer is near it.
fn hover_ui(
    ui: &Ui,
    response: &egui::Response,
    palette: &Palette,
    modes: &[Mode],
    position: &impl Fn(f64, f64) -> Pos2,
) {
    let Some(pointer) = response.hover_pos() else { return };
    let distance = |mode: &&Mode| {
        position(mode.lambda.re, mode.lambda.im)
            .distance(pointer)
            .min(position(mode.lambda.re, -mode.lambda.im).distance(pointer))
    };
    let nearest = modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    if let Some(mode) = nearest.filter(|mode| distance(mode) < 16.0) {
        response.show_tooltip_ui(|ui| {
            ui.label(
                RichText::new(mode.naming.name.text())
                    .font(theme::semibold(12.5))
                    .color(palette.mode(mode.naming.name)),
            );
            ui.label(format!("λ = {} 1/s", eigenvalue(mode)));
            ui.label(numbers(mode));
        });
        ui.set_cursor_icon(egui::CursorIcon::Crosshair);
    }
}

/// "−2.51 ± 2.59j".
pub fn eigenvalue(mode: &Mode) -> String {
    let re = significant(mode.lambda.re, 4);
    if mode.is_oscillatory() { format!("{re} ± {}j", significant(mode.lambda.im, 4)) } else { re }
}
