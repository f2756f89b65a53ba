//! One small plot of a response: its title with the value at the cursor, and its curves.

use egui::{Align2, FontId, Id, Rect, Ui, UiBuilder, Vec2, WidgetInfo, accesskit::Role};
use egui_plot::{GridMark, Line, LineStyle, Plot, PlotPoint, PlotPoints, VLine};

use super::axis_range::AxisRange;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::number::significant;

const TITLE_HEIGHT: f32 = 20.0;

/// What a small plot shows.
#[derive(Debug)]
pub struct Curves<'a> {
    /// Symbol of the quantity.
    pub symbol: &'static str,
    /// Unit of the quantity.
    pub unit: &'a str,
    /// Symbol and unit of the horizontal axis.
    pub against: (&'static str, &'a str),
    /// The curve, in shown units.
    pub now: &'a [PlotPoint],
    /// The pinned curve, if any.
    pub ghost: Option<&'a [PlotPoint]>,
}

/// A small plot with its ranges as they are on screen.
#[derive(Debug, Default)]
pub struct ResponsePlot {
    x: AxisRange,
    y: AxisRange,
}

impl ResponsePlot {
    /// Draws the curves over `rect`, which are functions of the horizontal axis, with the cursor that all share.
    pub fn show(&mut self, ui: &mut Ui, rect: Rect, curves: &Curves<'_>, cursor: &mut Option<f64>) {
        let value = cursor.and_then(|t| at(curves.now, t));
        title(ui, rect, curves, value);
        let last = curves.now.last().map_or(1.0, |point| point.x);
        let x = self.x.toward(ui, 0.0..=last.max(1e-3));
        let response = self.plot(ui, rect, curves, x, *cursor);
        if let Some(pointer) = response.hover_pos() {
            let fraction = f64::from((pointer.x - response.rect.left()) / response.rect.width());
            *cursor = Some((fraction * last).clamp(0.0, last));
        }
    }

    /// Draws the curves over `rect` as paths in a plane; `mark` is the time of the cursor's place on the path.
    pub fn show_path(&mut self, ui: &mut Ui, rect: Rect, curves: &Curves<'_>, mark: Option<PlotPoint>) {
        title(ui, rect, curves, None);
        let x = self.x.toward(ui, range(curves, |point| point.x));
        let y_range = self.y.toward(ui, range(curves, |point| point.y));
        let plot_rect = below_title(rect);
        let palette = Palette::of(ui);
        draw(ui, plot_rect, curves, x, y_range, |plot| {
            plot.points(egui_plot::Points::new("", vec![[0.0, 0.0]]).radius(2.5).color(palette.weak).allow_hover(false));
            if let Some(mark) = mark {
                plot.points(egui_plot::Points::new("", vec![[mark.x, mark.y]]).radius(4.0).color(palette.text).allow_hover(false));
            }
        });
        let label = Symbol::parse(curves.against.0).job(12.0, palette.weak);
        let galley = ui.painter().layout_job(label);
        ui.painter().galley(plot_rect.right_bottom() - galley.size() - Vec2::new(4.0, 16.0), galley, palette.weak);
    }

    fn plot(&mut self, ui: &mut Ui, rect: Rect, curves: &Curves<'_>, x: std::ops::RangeInclusive<f64>, cursor: Option<f64>) -> egui::Response {
        let y = self.y.toward(ui, range(curves, |point| point.y));
        let palette = Palette::of(ui);
        draw(ui, below_title(rect), curves, x, y, |plot| {
            if let Some(t) = cursor {
                plot.vline(VLine::new("", t).color(palette.weak).width(1.0).style(LineStyle::dotted_dense()).allow_hover(false));
            }
        })
    }
}

fn below_title(rect: Rect) -> Rect {
    Rect::from_min_max(rect.min + Vec2::new(0.0, TITLE_HEIGHT), rect.max)
}

fn draw<'a>(
    ui: &mut Ui,
    rect: Rect,
    curves: &Curves<'a>,
    x: std::ops::RangeInclusive<f64>,
    y: std::ops::RangeInclusive<f64>,
    extra: impl FnOnce(&mut egui_plot::PlotUi<'a>) + 'a,
) -> egui::Response {
    let palette = Palette::of(ui);
    let (now, ghost) = (curves.now, curves.ghost);
    let (x_range, y_range) = (x.clone(), y.clone());
    let plot = ui
        .scope_builder(UiBuilder::new().max_rect(rect), |ui| {
            Plot::new(Id::unique((curves.symbol, curves.against.0)))
                .width(rect.width())
                .height(rect.height())
                .show_axes(false)
                .show_background(false)
                .grid_color(palette.hairline)
                .grid_spacing(70.0..=260.0)
                .allow_zoom(false)
                .allow_drag(false)
                .allow_scroll(false)
                .allow_boxed_zoom(false)
                .allow_double_click_reset(false)
                .show_crosshair(false)
                .label_formatter(|_| None)
                .show(ui, move |plot| {
                    plot.set_plot_bounds_x(x_range);
                    plot.set_plot_bounds_y(y_range);
                    plot.hline(egui_plot::HLine::new("", 0.0).color(palette.ghost).width(1.0).allow_hover(false));
                    if let Some(ghost) = ghost {
                        plot.line(
                            Line::new("pinned", PlotPoints::Borrowed(ghost))
                                .color(palette.ghost)
                                .width(1.2)
                                .style(LineStyle::dashed_dense())
                                .allow_hover(false),
                        );
                    }
                    plot.line(Line::new("now", PlotPoints::Borrowed(now)).color(palette.text).width(1.8).allow_hover(false));
                    extra(plot);
                })
        })
        .inner;
    let words = describe(curves);
    plot.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words.as_str()));
    tick_labels(ui, rect, x, y);
    plot.response
}

/// Symbol and unit on the left; on the right the value at the cursor.
fn title(ui: &Ui, rect: Rect, curves: &Curves<'_>, value: Option<f64>) {
    let palette = Palette::of(ui);
    let mut job = Symbol::parse(curves.symbol).job(14.0, palette.text);
    let unit = if curves.against.0 == "t" {
        format!("  {}", curves.unit)
    } else {
        format!("  {} against {}", curves.unit, curves.against.1)
    };
    job.append(&unit, 0.0, egui::TextFormat::simple(theme::small(), palette.weak));
    let galley = ui.painter().layout_job(job);
    ui.painter().galley(rect.min + Vec2::new(2.0, 0.0), galley, palette.text);
    if let Some(value) = value {
        let text = format!("{} {}", significant(value, 3), curves.unit);
        ui.painter().text(rect.right_top() + Vec2::new(-4.0, 2.0), Align2::RIGHT_TOP, text, theme::semibold(11.5), palette.text);
    }
}

/// Labels inside the frame: first and last round number of the vertical axis, round numbers of the horizontal one.
fn tick_labels(ui: &Ui, rect: Rect, x: std::ops::RangeInclusive<f64>, y: std::ops::RangeInclusive<f64>) {
    let palette = Palette::of(ui);
    let font = FontId::proportional(10.0);
    let painter = ui.painter().with_clip_rect(rect);
    let horizontal = |value: f64| rect.left() + ((value - x.start()) / (x.end() - x.start())) as f32 * rect.width();
    let vertical = |value: f64| rect.bottom() - ((value - y.start()) / (y.end() - y.start())) as f32 * rect.height();
    for mark in marks(&y, rect.height(), 46.0) {
        let at = egui::pos2(rect.left() + 3.0, vertical(mark.value));
        if at.y > rect.top() + 10.0 && at.y < rect.bottom() - 16.0 {
            painter.text(at, Align2::LEFT_BOTTOM, label(&mark), font.clone(), palette.weak);
        }
    }
    for mark in marks(&x, rect.width(), 80.0) {
        let at = egui::pos2(horizontal(mark.value), rect.bottom() - 2.0);
        if at.x > rect.left() + 24.0 && at.x < rect.right() - 14.0 {
            painter.text(at, Align2::CENTER_BOTTOM, label(&mark), font.clone(), palette.weak);
        }
    }
}

/// Round numbers in a range, at least `apart` points from each other.
fn marks(range: &std::ops::RangeInclusive<f64>, length: f32, apart: f32) -> Vec<GridMark> {
    let span = range.end() - range.start();
    let raw = span * f64::from(apart / length.max(1.0));
    let decade = 10_f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0].into_iter().map(|d| d * decade).find(|step| *step >= raw).unwrap_or(10.0 * decade);
    let first = (range.start() / step).ceil();
    (0..=(span / step).min(40.0) as i32)
        .map(|k| GridMark { value: (first + f64::from(k)) * step, step_size: step })
        .filter(|mark| range.contains(&mark.value))
        .collect()
}

fn label(mark: &GridMark) -> String {
    let decimals = (-mark.step_size.log10().floor()).clamp(0.0, 9.0) as usize;
    if mark.value.abs() >= 1e6 { significant(mark.value, 2) } else { crate::number::fixed(mark.value, decimals) }
}

/// The range of all curves with a margin, wide enough to include zero.
fn range(curves: &Curves<'_>, coordinate: impl Fn(&PlotPoint) -> f64) -> std::ops::RangeInclusive<f64> {
    let all = curves.now.iter().chain(curves.ghost.into_iter().flatten());
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    for value in all.map(coordinate) {
        low = low.min(value);
        high = high.max(value);
    }
    if high - low < 1e-12 {
        return -1.0..=1.0;
    }
    // Ends are multiples of an eighth of a round number, so that they hold still through small changes.
    let step = super::axis_range::round_up(high - low) / 8.0;
    ((low / step).floor() - 0.6) * step..=((high / step).ceil() + 0.6) * step
}

/// Linear interpolation at t, exact at the samples.
fn at(points: &[PlotPoint], t: f64) -> Option<f64> {
    let i = points.partition_point(|point| point.x <= t);
    let (a, b) = (points.get(i.checked_sub(1)?)?, points.get(i));
    Some(match b {
        Some(b) if b.x > a.x => a.y + (b.y - a.y) * (t - a.x) / (b.x - a.x),
        _ => a.y,
    })
}

fn describe(curves: &Curves<'_>) -> String {
    let symbol = Symbol::parse(curves.symbol).plain();
    let extreme = |pick: fn(f64, f64) -> f64| curves.now.iter().map(|point| point.y).fold(0.0, pick);
    let last = curves.now.last().map_or(0.0, |point| point.y);
    format!(
        "Response of {symbol} in {}: between {} and {}, {} at the end",
        curves.unit,
        significant(extreme(f64::min), 3),
        significant(extreme(f64::max), 3),
        significant(last, 3),
    )
}
