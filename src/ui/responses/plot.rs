//! One small plot: its title with the value at the cursor, its axes with round figures, and its curves.

use std::ops::RangeInclusive;

use egui::{Align2, Color32, FontId, Id, Rect, Ui, UiBuilder, Vec2, WidgetInfo, accesskit::Role};
use egui_plot::{HLine, Line, LineStyle, PlotPoint, PlotPoints, Points, Span, VLine};

use crate::number::{round_up, significant};
use crate::ui::axis_range::AxisRange;
use crate::ui::finger;
use crate::ui::responses::thin::thin;
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

const TITLE_HEIGHT: f32 = 20.0;
/// Room for the figures left of a plot and below it.
const GUTTER: Vec2 = Vec2::new(36.0, 14.0);
/// Least distance of the figures on either axis.
const APART: Vec2 = Vec2::new(64.0, 34.0);

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stroke {
    /// The motion itself.
    Full,
    /// A part of it, filled down to zero.
    Part,
    /// Something to compare with: dashed.
    Dashed,
    /// Something else to compare with: dotted.
    Dotted,
}

/// A curve in shown units.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is, for screen readers.
    pub name: &'static str,
    /// Its points.
    pub points: Vec<PlotPoint>,
    /// How many of them, from the first, are drawn.
    pub drawn: usize,
    /// Its colour.
    pub color: Color32,
    /// How it is drawn.
    pub stroke: Stroke,
}

impl Curve {
    fn drawn_part(&self) -> &[PlotPoint] {
        &self.points[..self.points.len().min(self.drawn)]
    }
}

/// What a small plot shows.
#[derive(Debug)]
pub struct Picture<'a> {
    /// Symbol of the quantity.
    pub symbol: &'a str,
    /// Unit of the quantity.
    pub unit: &'a str,
    /// Symbol and unit of the horizontal axis.
    pub against: (&'a str, &'a str),
    /// The curves; the first is the one whose value the title tells.
    pub curves: Vec<Curve>,
    /// Where nothing is drawn any more, shaded.
    pub beyond: Option<RangeInclusive<f64>>,
    /// Upright lines with a colour: the cursor, frequencies of modes.
    pub uprights: Vec<(f64, Color32)>,
    /// Dots with a colour.
    pub dots: Vec<(PlotPoint, Color32)>,
    /// Range of the horizontal axis; of the curves where there is none.
    pub x_range: Option<RangeInclusive<f64>>,
    /// Whether the horizontal axis is a logarithm to base ten.
    pub logarithmic: bool,
    /// Whether the vertical axis holds zero.
    pub with_zero: bool,
}

impl<'a> Picture<'a> {
    /// Of functions of time.
    pub fn of_time(symbol: &'a str, unit: &'a str, curves: Vec<Curve>) -> Self {
        Self {
            symbol,
            unit,
            against: ("t", "s"),
            curves,
            beyond: None,
            uprights: Vec::new(),
            dots: Vec::new(),
            x_range: None,
            logarithmic: false,
            with_zero: true,
        }
    }

    /// The range of all curves with a margin. What isn't drawn may leave it.
    fn range(&self, coordinate: impl Fn(&PlotPoint) -> f64) -> RangeInclusive<f64> {
        let all = self.curves.iter().flat_map(Curve::drawn_part).map(coordinate);
        let start = if self.with_zero { (0.0, 0.0) } else { (f64::INFINITY, f64::NEG_INFINITY) };
        let (low, high) = all.fold(start, |(low, high), value| (low.min(value), high.max(value)));
        if high - low <= 1e-12 {
            let middle = if low.is_finite() { low } else { 0.0 };
            return middle - 1.0..=middle + 1.0;
        }
        // Ends are multiples of an eighth of a round number, so that they hold still through small changes.
        let step = round_up(high - low) / 8.0;
        ((low / step).floor() - 0.6) * step..=((high / step).ceil() + 0.6) * step
    }

    fn words(&self) -> String {
        let symbol = Symbol::parse(self.symbol).plain();
        let points = self.curves.first().map_or(&[][..], |curve| &curve.points);
        let extreme =
            |pick: fn(f64, f64) -> f64| points.iter().map(|point| point.y).reduce(pick).unwrap_or(0.0);
        let last = points.last().map_or(0.0, |point| point.y);
        let others: Vec<&str> = self.curves.iter().skip(1).map(|curve| curve.name).collect();
        let with = if others.is_empty() { String::new() } else { format!("; with {}", others.join(", ")) };
        format!(
            "{symbol} in {} against {}: between {} and {}, {} at the end{with}",
            self.unit,
            if self.against.0 == "t" { "time".to_owned() } else { Symbol::parse(self.against.0).plain() },
            significant(extreme(f64::min), 3),
            significant(extreme(f64::max), 3),
            significant(last, 3),
        )
    }
}

/// A small plot with its ranges as they are on screen.
#[derive(Debug, Default)]
pub struct SmallPlot {
    x: AxisRange,
    y: AxisRange,
}

impl SmallPlot {
    /// Draws the picture over `rect`, with the cursor at the horizontal place `cursor`; gives the place under the pointer.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        picture: &Picture<'_>,
        cursor: Option<f64>,
    ) -> Option<f64> {
        let value = picture.curves.first().zip(cursor).and_then(|(curve, x)| at(&curve.points, x));
        title(ui, rect, picture, value);
        let x = picture.x_range.clone().unwrap_or_else(|| picture.range(|point| point.x));
        let x = self.x.toward(ui, x);
        let y = self.y.toward(ui, picture.range(|point| point.y));
        let frame = Rect::from_min_max(
            rect.min + Vec2::new(GUTTER.x, TITLE_HEIGHT),
            rect.max - Vec2::new(0.0, GUTTER.y),
        );
        let response = draw(ui, frame, picture, (x.clone(), y), cursor);
        let held = finger::works_on(ui, &response);
        // A finger that has tapped is nowhere any more.
        let pointer = if response.clicked() { response.interact_pointer_pos() } else { response.hover_pos() };
        let pointer = pointer.filter(|_| held)?;
        let fraction = f64::from((pointer.x - frame.left()) / frame.width()).clamp(0.0, 1.0);
        Some(x.start() + fraction * (x.end() - x.start()))
    }
}

/// Frame, figures and curves.
fn draw(
    ui: &mut Ui,
    rect: Rect,
    picture: &Picture<'_>,
    (x, y): (RangeInclusive<f64>, RangeInclusive<f64>),
    cursor: Option<f64>,
) -> egui::Response {
    let palette = Palette::of(ui);
    let horizontal = if picture.logarithmic { decades(&x) } else { marks(&x, rect.width(), APART.x) };
    let mut vertical = marks(&y, rect.height(), APART.y);
    if vertical.len() < 2 {
        // One figure alone gives no scale.
        vertical = marks(&y, rect.height(), 0.5 * APART.y);
    }
    tick_labels(ui, rect, (&x, &horizontal), (&y, &vertical));
    let scale = rect.size() / Vec2::new((x.end() - x.start()) as f32, (y.end() - y.start()) as f32);
    let id = Id::unique((picture.symbol, picture.unit, picture.against.0));
    let plot = ui.scope_builder(UiBuilder::new().max_rect(rect), |ui| {
        theme::still_plot(id, rect).show(ui, |plot| {
            plot.set_plot_bounds_x(x);
            plot.set_plot_bounds_y(y);
            if let Some(beyond) = picture.beyond.clone() {
                let span = Span::new("", beyond).fill(palette.unstable_half);
                plot.span(span.border_color(Color32::TRANSPARENT));
            }
            for mark in &vertical {
                plot.hline(HLine::new("", mark.value).color(palette.hairline).width(1.0).allow_hover(false));
            }
            for mark in &horizontal {
                plot.vline(VLine::new("", mark.value).color(palette.hairline).width(1.0).allow_hover(false));
            }
            if picture.with_zero {
                plot.hline(HLine::new("", 0.0).color(palette.ghost).width(1.0).allow_hover(false));
            }
            // The first is drawn last, on top.
            for curve in picture.curves.iter().rev() {
                let points = PlotPoints::Owned(thin(curve.drawn_part(), scale));
                let line = Line::new(curve.name, points).color(curve.color);
                let line = match curve.stroke {
                    Stroke::Full => line.width(1.8).allow_band(false),
                    Stroke::Part => line.width(1.3).fill(0.0).fill_alpha(0.12),
                    Stroke::Dashed => line.width(1.2).style(LineStyle::dashed_dense()).allow_band(false),
                    Stroke::Dotted => line.width(1.6).style(LineStyle::dotted_dense()).allow_band(false),
                };
                plot.line(line.allow_hover(false));
            }
            for &(place, color) in &picture.uprights {
                let line = VLine::new("", place).color(color).width(1.0).style(LineStyle::dashed_dense());
                plot.vline(line.allow_hover(false));
            }
            if let Some(cursor) = cursor {
                let line = VLine::new("", cursor).color(palette.weak).width(1.0);
                plot.vline(line.style(LineStyle::dotted_dense()).allow_hover(false));
            }
            for &(place, color) in &picture.dots {
                let dot = Points::new("", vec![[place.x, place.y]]).radius(3.5).color(color);
                plot.points(dot.allow_hover(false));
            }
        })
    });
    let response = plot.inner.response;
    let words = picture.words();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words.as_str()));
    response
}

/// Symbol and unit on the left; on the right the value at the cursor.
fn title(ui: &Ui, rect: Rect, picture: &Picture<'_>, value: Option<f64>) {
    let palette = Palette::of(ui);
    let mut job = Symbol::parse(picture.symbol).job(15.0, palette.text);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    job.append(&format!("  {}", picture.unit), 0.0, weak());
    if picture.against.0 != "t" {
        job.append(" against ", 0.0, weak());
        Symbol::parse(picture.against.0).append_to(&mut job, 13.0, palette.text);
        job.append(&format!(" {}", picture.against.1), 0.0, weak());
    }
    let galley = ui.painter().layout_job(job);
    ui.painter().galley(rect.min + Vec2::new(2.0, 0.0), galley, palette.text);
    if let Some(value) = value {
        let text = format!("{} {}", significant(value, 3), picture.unit);
        let corner = rect.right_top() + Vec2::new(-4.0, 2.0);
        ui.painter().text(corner, Align2::RIGHT_TOP, text, theme::semibold(11.5), palette.text);
    }
}

/// A place on an axis and its figure.
struct Mark {
    value: f64,
    label: String,
}

/// The figures of both axes, outside the frame.
fn tick_labels(ui: &Ui, rect: Rect, (x, horizontal): Axis<'_>, (y, vertical): Axis<'_>) {
    let palette = Palette::of(ui);
    let font = FontId::proportional(10.0);
    let fraction = |range: &RangeInclusive<f64>, value: f64| {
        ((value - range.start()) / (range.end() - range.start())) as f32
    };
    for mark in vertical {
        // At the very bottom a little higher, above the first figure of the other axis.
        let height = (fraction(y, mark.value) * rect.height()).max(5.0);
        let at = egui::pos2(rect.left() - 4.0, rect.bottom() - height);
        ui.painter().text(at, Align2::RIGHT_CENTER, &mark.label, font.clone(), palette.weak);
    }
    for mark in horizontal {
        let at = egui::pos2(rect.left() + fraction(x, mark.value) * rect.width(), rect.bottom() + 1.0);
        ui.painter().text(at, Align2::CENTER_TOP, &mark.label, font.clone(), palette.weak);
    }
}

/// A range and the round numbers in it.
type Axis<'a> = (&'a RangeInclusive<f64>, &'a [Mark]);

/// Round numbers in a range, at least `apart` points from each other.
fn marks(range: &RangeInclusive<f64>, length: f32, apart: f32) -> Vec<Mark> {
    let span = range.end() - range.start();
    let raw = span * f64::from(apart / length.max(1.0));
    let decade = 10_f64.powf(raw.log10().floor());
    let step =
        [1.0, 2.0, 5.0].into_iter().map(|d| d * decade).find(|step| *step >= raw).unwrap_or(10.0 * decade);
    let first = (range.start() / step).ceil();
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    let label = |value: f64| {
        if value.abs() >= 1e5 { significant(value, 2) } else { crate::number::fixed(value, decimals) }
    };
    (0..=(span / step).min(40.0) as i32)
        .map(|k| (first + f64::from(k)) * step)
        .filter(|value| range.contains(value))
        .map(|value| Mark { value, label: label(value) })
        .collect()
}

/// The powers of ten in a range of logarithms.
fn decades(range: &RangeInclusive<f64>) -> Vec<Mark> {
    let (first, last) = (range.start().ceil().max(-12.0) as i32, range.end().floor().min(12.0) as i32);
    (first..=last)
        .map(|power| Mark { value: f64::from(power), label: significant(10_f64.powi(power), 1) })
        .collect()
}

/// Linear interpolation at x, exact at the points.
fn at(points: &[PlotPoint], x: f64) -> Option<f64> {
    let i = points.partition_point(|point| point.x <= x);
    let (a, b) = (points.get(i.checked_sub(1)?)?, points.get(i));
    Some(match b {
        Some(b) if b.x > a.x => a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x),
        _ => a.y,
    })
}
