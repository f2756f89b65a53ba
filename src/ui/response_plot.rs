//! One small plot of a response: its title with the value at the cursor, and its curves.

use std::ops::RangeInclusive;

use egui::{Align2, Color32, FontId, Id, Rect, Ui, UiBuilder, Vec2, WidgetInfo, accesskit::Role};
use egui_plot::{GridMark, HLine, Line, LineStyle, PlotPoint, PlotPoints, Span, VLine};

use super::axis_range::AxisRange;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::number::significant;

const TITLE_HEIGHT: f32 = 20.0;
/// Room for the figures left of a plot and below it.
const GUTTER: Vec2 = Vec2::new(36.0, 14.0);
/// Least distance of the figures on either axis.
const APART: Vec2 = Vec2::new(64.0, 34.0);

/// A curve in shown units.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Its points.
    pub points: Vec<PlotPoint>,
    /// How many of them, from the first, are of a small disturbance; the rest is not drawn.
    pub small: usize,
}

impl Curve {
    /// The part that is drawn: one point beyond the small disturbance, so that it is seen leaving.
    fn small_part(&self) -> &[PlotPoint] {
        &self.points[..self.points.len().min(self.small + 1)]
    }
}

/// What a small plot shows.
#[derive(Debug)]
pub struct Curves<'a> {
    /// Symbol of the quantity.
    pub symbol: &'static str,
    /// Unit of the quantity.
    pub unit: &'a str,
    /// Symbol and unit of the horizontal axis.
    pub against: (&'static str, &'a str),
    /// The curve.
    pub now: &'a Curve,
    /// The pinned curve, if any.
    pub ghost: Option<&'a Curve>,
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
        let palette = Palette::of(ui);
        let points = &curves.now.points;
        title(ui, rect, curves, cursor.and_then(|t| at(points, t)));
        let last = points.last().map_or(1.0, |point| point.x).max(1e-3);
        let x = self.x.toward(ui, 0.0..=last);
        let y = self.y.toward(ui, range(curves, |point| point.y));
        let beyond = points.get(curves.now.small).map(|point| point.x..=last);
        let marked = *cursor;
        let response = draw(ui, frame_in(rect), curves, (x, y), beyond, |plot| {
            if let Some(time) = marked {
                let line =
                    VLine::new("", time).color(palette.weak).width(1.0).style(LineStyle::dotted_dense());
                plot.vline(line.allow_hover(false));
            }
        });
        if let Some(pointer) = response.hover_pos() {
            let fraction = f64::from((pointer.x - response.rect.left()) / response.rect.width());
            *cursor = Some((fraction * last).clamp(0.0, last));
        }
    }

    /// Draws the curves over `rect` as paths in a plane; `mark` is the time of the cursor's place on the path.
    pub fn show_path(&mut self, ui: &mut Ui, rect: Rect, curves: &Curves<'_>, mark: Option<PlotPoint>) {
        title(ui, rect, curves, None);
        let x = self.x.toward(ui, range(curves, |point| point.x));
        let y = self.y.toward(ui, range(curves, |point| point.y));
        let palette = Palette::of(ui);
        draw(ui, frame_in(rect), curves, (x, y), None, |plot| {
            plot.points(
                egui_plot::Points::new("", vec![[0.0, 0.0]])
                    .radius(2.5)
                    .color(palette.weak)
                    .allow_hover(false),
            );
            if let Some(mark) = mark {
                plot.points(
                    egui_plot::Points::new("", vec![[mark.x, mark.y]])
                        .radius(4.0)
                        .color(palette.text)
                        .allow_hover(false),
                );
            }
        });
    }
}

/// The frame of a plot in its place, without title and figures.
fn frame_in(rect: Rect) -> Rect {
    Rect::from_min_max(rect.min + Vec2::new(GUTTER.x, TITLE_HEIGHT), rect.max - Vec2::new(0.0, GUTTER.y))
}

/// Frame, figures and curves; `beyond` is where the motion is no small disturbance any more.
fn draw<'a>(
    ui: &mut Ui,
    rect: Rect,
    curves: &Curves<'a>,
    (x, y): (RangeInclusive<f64>, RangeInclusive<f64>),
    beyond: Option<RangeInclusive<f64>>,
    extra: impl FnOnce(&mut egui_plot::PlotUi<'a>) + 'a,
) -> egui::Response {
    let palette = Palette::of(ui);
    let (now, ghost) = (curves.now, curves.ghost);
    let (horizontal, vertical) = (marks(&x, rect.width(), APART.x), marks(&y, rect.height(), APART.y));
    tick_labels(ui, rect, (&x, &horizontal), (&y, &vertical));
    let plot = ui
        .scope_builder(UiBuilder::new().max_rect(rect), |ui| {
            theme::still_plot(Id::unique((curves.symbol, curves.against.0)), rect).show(ui, move |plot| {
                plot.set_plot_bounds_x(x);
                plot.set_plot_bounds_y(y);
                if let Some(beyond) = beyond {
                    let span = Span::new("", beyond).fill(palette.unstable_half);
                    plot.span(span.border_color(Color32::TRANSPARENT));
                }
                for mark in &vertical {
                    plot.hline(
                        HLine::new("", mark.value).color(palette.hairline).width(1.0).allow_hover(false),
                    );
                }
                for mark in &horizontal {
                    plot.vline(
                        VLine::new("", mark.value).color(palette.hairline).width(1.0).allow_hover(false),
                    );
                }
                plot.hline(HLine::new("", 0.0).color(palette.ghost).width(1.0).allow_hover(false));
                if let Some(ghost) = ghost {
                    plot.line(
                        Line::new("pinned", PlotPoints::Borrowed(ghost.small_part()))
                            .color(palette.ghost)
                            .width(1.2)
                            .style(LineStyle::dashed_dense())
                            .allow_band(false)
                            .allow_hover(false),
                    );
                }
                plot.line(
                    Line::new("now", PlotPoints::Borrowed(now.small_part()))
                        .color(palette.text)
                        .width(1.8)
                        .allow_band(false)
                        .allow_hover(false),
                );
                extra(plot);
            })
        })
        .inner;
    let words = describe(curves);
    plot.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words.as_str()));
    plot.response
}

/// Symbol and unit on the left; on the right the value at the cursor.
fn title(ui: &Ui, rect: Rect, curves: &Curves<'_>, value: Option<f64>) {
    let palette = Palette::of(ui);
    let mut job = Symbol::parse(curves.symbol).job(15.0, palette.text);
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
        ui.painter().text(
            rect.right_top() + Vec2::new(-4.0, 2.0),
            Align2::RIGHT_TOP,
            text,
            theme::semibold(11.5),
            palette.text,
        );
    }
}

/// The figures of both axes, outside the frame.
fn tick_labels(ui: &Ui, rect: Rect, (x, horizontal): Axis<'_>, (y, vertical): Axis<'_>) {
    let palette = Palette::of(ui);
    let font = FontId::proportional(10.0);
    let fraction = |range: &RangeInclusive<f64>, value: f64| {
        ((value - range.start()) / (range.end() - range.start())) as f32
    };
    for mark in vertical {
        let at = egui::pos2(rect.left() - 4.0, rect.bottom() - fraction(y, mark.value) * rect.height());
        ui.painter().text(at, Align2::RIGHT_CENTER, label(mark), font.clone(), palette.weak);
    }
    for mark in horizontal {
        let at = egui::pos2(rect.left() + fraction(x, mark.value) * rect.width(), rect.bottom() + 1.0);
        ui.painter().text(at, Align2::CENTER_TOP, label(mark), font.clone(), palette.weak);
    }
}

/// A range and the round numbers in it.
type Axis<'a> = (&'a RangeInclusive<f64>, &'a [GridMark]);

/// Round numbers in a range, at least `apart` points from each other.
fn marks(range: &RangeInclusive<f64>, length: f32, apart: f32) -> Vec<GridMark> {
    let span = range.end() - range.start();
    let raw = span * f64::from(apart / length.max(1.0));
    let decade = 10_f64.powf(raw.log10().floor());
    let step =
        [1.0, 2.0, 5.0].into_iter().map(|d| d * decade).find(|step| *step >= raw).unwrap_or(10.0 * decade);
    let first = (range.start() / step).ceil();
    (0..=(span / step).min(40.0) as i32)
        .map(|k| GridMark { value: (first + f64::from(k)) * step, step_size: step })
        .filter(|mark| range.contains(&mark.value))
        .collect()
}

fn label(mark: &GridMark) -> String {
    let decimals = (-mark.step_size.log10().floor()).clamp(0.0, 9.0) as usize;
    if mark.value.abs() >= 1e5 {
        significant(mark.value, 2)
    } else {
        crate::number::fixed(mark.value, decimals)
    }
}

/// The range of all curves with a margin, wide enough to include zero. What is no small disturbance any more may leave it.
fn range(curves: &Curves<'_>, coordinate: impl Fn(&PlotPoint) -> f64) -> RangeInclusive<f64> {
    let all = [Some(curves.now), curves.ghost].into_iter().flatten().flat_map(Curve::small_part);
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
    let extreme = |pick: fn(f64, f64) -> f64| curves.now.points.iter().map(|point| point.y).fold(0.0, pick);
    let last = curves.now.points.last().map_or(0.0, |point| point.y);
    format!(
        "Response of {symbol} in {} against {}: between {} and {}, {} at the end",
        curves.unit,
        if curves.against.0 == "t" { "time" } else { "α" },
        significant(extreme(f64::min), 3),
        significant(extreme(f64::max), 3),
        significant(last, 3),
    )
}
