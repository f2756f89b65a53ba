//! One small plot: its title with the value at the cursor, its axes with round figures, and its curves.

use std::ops::RangeInclusive;

use egui::{Align2, Color32, FontId, Id, Rect, Ui, UiBuilder, Vec2, WidgetInfo, accesskit::Role};
use egui_plot::{HLine, Line, LineStyle, PlotPoint, PlotPoints, Points, Span, VLine};

use crate::number::{round_up, significant};
use crate::ui::axis_range::AxisRange;
use crate::ui::finger;
use crate::ui::responses::legend::{self, SAMPLE};
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
    /// What it is, for the legend and screen readers.
    pub name: &'static str,
    /// Its points.
    pub points: Vec<PlotPoint>,
    /// How many of them, from the first, are drawn.
    drawn: usize,
    /// Its colour.
    pub color: Color32,
    /// How it is drawn.
    pub stroke: Stroke,
    /// What of it is needed on screen, at the scale at which it was shown last.
    thinned: Option<(Vec2, Vec<PlotPoint>)>,
}

impl Curve {
    /// A curve all of which is drawn.
    pub fn new(name: &'static str, points: Vec<PlotPoint>, color: Color32, stroke: Stroke) -> Self {
        Self { name, drawn: points.len(), points, color, stroke, thinned: None }
    }

    /// The same curve, of which only the first points are drawn.
    pub fn drawn_for(self, count: usize) -> Self {
        Self { drawn: count, ..self }
    }

    /// Its points as far as they are drawn.
    pub fn drawn_part(&self) -> &[PlotPoint] {
        &self.points[..self.points.len().min(self.drawn)]
    }

    /// Finds what is needed on screen, unless that is known.
    fn thin(&mut self, scale: Vec2) {
        if self.thinned.as_ref().is_none_or(|(of, _)| *of != scale) {
            self.thinned = Some((scale, thin(self.drawn_part(), scale)));
        }
    }

    fn thinned(&self) -> &[PlotPoint] {
        self.thinned.as_ref().map_or(&[], |(_, points)| points)
    }
}

/// What a small plot shows.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Symbol of the quantity.
    pub symbol: String,
    /// Unit of the quantity.
    pub unit: String,
    /// Symbol and unit of the horizontal axis.
    pub against: (&'static str, &'static str),
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
    /// Range of the vertical axis, likewise.
    pub y_range: Option<RangeInclusive<f64>>,
    /// Whether the horizontal axis is a logarithm to base ten.
    pub logarithmic: bool,
    /// Whether the vertical axis holds zero.
    pub with_zero: bool,
    /// Symbols of the curves, where each is another quantity: the title then names them all.
    pub quantities: Vec<&'static str>,
    /// Whether symbol and unit stand at the end of the horizontal axis.
    pub names_axis: bool,
    /// Whether the vertical axis is a phase in degrees, which is read in right angles.
    pub is_phase: bool,
}

impl Picture {
    /// Of functions of time.
    pub fn of_time(symbol: impl Into<String>, unit: impl Into<String>, curves: Vec<Curve>) -> Self {
        Self {
            symbol: symbol.into(),
            unit: unit.into(),
            against: ("t", "s"),
            curves,
            beyond: None,
            uprights: Vec::new(),
            dots: Vec::new(),
            x_range: None,
            y_range: None,
            logarithmic: false,
            with_zero: true,
            quantities: Vec::new(),
            names_axis: false,
            is_phase: false,
        }
    }

    /// The ranges of both axes.
    fn ranges(&mut self) -> (RangeInclusive<f64>, RangeInclusive<f64>) {
        let x = self.x_range.take().unwrap_or_else(|| self.range(|point| point.x));
        let y = self.y_range.take().unwrap_or_else(|| self.range(|point| point.y));
        (self.x_range, self.y_range) = (Some(x.clone()), Some(y.clone()));
        (x, y)
    }

    /// The range of all curves with a margin. What isn't drawn may leave it.
    fn range(&self, coordinate: impl Fn(&PlotPoint) -> f64) -> RangeInclusive<f64> {
        let all = self.curves.iter().flat_map(Curve::drawn_part).map(coordinate);
        let start = if self.with_zero { (0.0, 0.0) } else { (f64::INFINITY, f64::NEG_INFINITY) };
        // Comparisons, since `f64::min` is a call of a function in a browser.
        let widened = |(low, high): (f64, f64), value: f64| {
            (if value < low { value } else { low }, if value > high { value } else { high })
        };
        let (low, high) = all.fold(start, widened);
        if high - low <= 1e-12 {
            let middle = if low.is_finite() { low } else { 0.0 };
            return middle - 1.0..=middle + 1.0;
        }
        // Ends are multiples of an eighth of a round number, so that they hold still through small changes.
        let step = round_up(high - low) / 8.0;
        ((low / step).floor() - 0.6) * step..=((high / step).ceil() + 0.6) * step
    }

    fn words(&self) -> String {
        let symbol = Symbol::parse(&self.symbol).plain();
        let points = self.curves.first().map_or(&[][..], Curve::drawn_part);
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
        picture: &mut Picture,
        cursor: Option<f64>,
    ) -> Option<f64> {
        let value = picture.curves.first().zip(cursor).and_then(|(curve, x)| at(curve.drawn_part(), x));
        title(ui, rect, picture, value);
        let (x, y) = picture.ranges();
        let (x, y) = (self.x.toward(ui, x), self.y.toward(ui, y));
        let frame = Rect::from_min_max(
            rect.min + Vec2::new(GUTTER.x, TITLE_HEIGHT),
            rect.max - Vec2::new(0.0, GUTTER.y),
        );
        let scale = frame.size() / Vec2::new((x.end() - x.start()) as f32, (y.end() - y.start()) as f32);
        picture.curves.iter_mut().for_each(|curve| curve.thin(scale));
        let response = draw(ui, frame, picture, (x.clone(), y), cursor);
        theme::focus_ring(ui, &response);
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
    picture: &Picture,
    (x, y): (RangeInclusive<f64>, RangeInclusive<f64>),
    cursor: Option<f64>,
) -> egui::Response {
    let palette = Palette::of(ui);
    let horizontal = if picture.logarithmic { decades(&x) } else { marks(&x, rect.width(), APART.x, false) };
    let vertical = marks(&y, rect.height(), APART.y, picture.is_phase);
    let name = picture.names_axis.then_some(picture.against);
    tick_labels(ui, rect, (&x, &horizontal), (&y, &vertical), name);
    let id = Id::unique((&picture.symbol, &picture.unit, picture.against.0));
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
                let line = Line::new(curve.name, PlotPoints::Borrowed(curve.thinned())).color(curve.color);
                let line = match curve.stroke {
                    Stroke::Full => line.width(1.8).allow_band(false),
                    Stroke::Part => line.width(1.3).fill(0.0).fill_alpha(0.12).allow_band(false),
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
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, picture.words()));
    response
}

/// Symbol and unit on the left; on the right the value at the cursor.
fn title(ui: &Ui, rect: Rect, picture: &Picture, value: Option<f64>) {
    let palette = Palette::of(ui);
    if !picture.quantities.is_empty() {
        quantities(ui, rect, picture);
    } else {
        quantity(ui, rect, picture);
    }
    // Of several quantities nobody could tell whose it is.
    if let Some(value) = value.filter(|_| picture.quantities.len() < 2) {
        let text = format!("{} {}", significant(value, 3), picture.unit);
        let corner = rect.right_top() + Vec2::new(-4.0, 2.0);
        ui.painter().text(corner, Align2::RIGHT_TOP, text, theme::semibold(11.5), palette.text);
    }
}

/// The title of a picture of one quantity.
fn quantity(ui: &Ui, rect: Rect, picture: &Picture) {
    let palette = Palette::of(ui);
    let mut job = Symbol::parse(&picture.symbol).job(15.0, palette.text);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    job.append(&format!("  {}", picture.unit), 0.0, weak());
    if picture.against.0 != "t" {
        job.append(" against ", 0.0, weak());
        Symbol::parse(picture.against.0).append_to(&mut job, 13.0, palette.text);
        job.append(&format!(" {}", picture.against.1), 0.0, weak());
    }
    let galley = ui.painter().layout_job(job);
    ui.painter().galley(rect.min + Vec2::new(2.0, 0.0), galley, palette.text);
}

/// The title of a picture of inputs: of each, as far as there is room, a sample of its curve, its symbol and its name.
fn quantities(ui: &Ui, rect: Rect, picture: &Picture) {
    let palette = Palette::of(ui);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    let several = picture.quantities.len() > 1;
    let galleys = |with_symbol: bool, with_name: bool| -> Vec<_> {
        let parts = picture.quantities.iter().zip(&picture.curves).enumerate();
        let parts = parts.map(|(i, (symbol, curve))| {
            let mut job = egui::text::LayoutJob::default();
            if with_symbol {
                Symbol::parse(symbol).append_to(&mut job, 15.0, palette.text);
            }
            if with_name {
                job.append(curve.name, if with_symbol { 5.0 } else { 0.0 }, weak());
            }
            if i + 1 == picture.quantities.len() {
                job.append(&picture.unit, 8.0, weak());
            }
            ui.painter().layout_job(job)
        });
        parts.collect()
    };
    let before = if several { SAMPLE + 4.0 } else { 0.0 };
    let wide = |galley: &egui::Galley| before + galley.size().x + 10.0;
    // Room for the value of one; of several there is none.
    let room = rect.width() - if several { 0.0 } else { 70.0 };
    let fits = |shown: &Vec<std::sync::Arc<egui::Galley>>| {
        shown.iter().map(|galley| wide(galley)).sum::<f32>() <= room
    };
    let choices: &[(bool, bool)] = if several { &[(true, true), (false, true)] } else { &[(true, true)] };
    let shown = choices.iter().map(|&(symbol, name)| galleys(symbol, name)).find(fits);
    let mut left_top = rect.min + Vec2::new(2.0, 0.0);
    for (galley, curve) in shown.unwrap_or_else(|| galleys(true, false)).into_iter().zip(&picture.curves) {
        if several {
            let middle = left_top + Vec2::new(0.0, 10.0);
            legend::sample(ui.painter(), middle, legend::Mark::Curve(curve.stroke), curve.color);
        }
        let width = wide(&galley);
        let down = if several { 10.0 - 0.5 * galley.size().y } else { 0.0 };
        ui.painter().galley(left_top + Vec2::new(before, down), galley, palette.text);
        left_top.x += width;
    }
}

/// A place on an axis and its figure.
struct Mark {
    value: f64,
    label: String,
}

/// The figures of both axes, outside the frame, and at the end of the horizontal one its symbol and unit.
fn tick_labels(
    ui: &Ui,
    rect: Rect,
    (x, horizontal): Axis<'_>,
    (y, vertical): Axis<'_>,
    name: Option<(&str, &str)>,
) {
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
    let mut end = f32::INFINITY;
    if let Some((symbol, unit)) = name {
        let mut job = Symbol::parse(symbol).job(11.5, palette.weak);
        job.append(&format!(", {unit}"), 0.0, egui::TextFormat::simple(font.clone(), palette.weak));
        let galley = ui.painter().layout_job(job);
        end = rect.right() - galley.size().x;
        ui.painter().galley(egui::pos2(end, rect.bottom()), galley, palette.weak);
    }
    for mark in horizontal {
        let at = egui::pos2(rect.left() + fraction(x, mark.value) * rect.width(), rect.bottom() + 1.0);
        let galley = ui.painter().layout_no_wrap(mark.label.clone(), font.clone(), palette.weak);
        let half = 0.5 * galley.size().x;
        // Where the name of the axis stands there is no room for a figure.
        if at.x + half + 4.0 <= end {
            ui.painter().galley(at - Vec2::new(half, 0.0), galley, palette.weak);
        }
    }
}

/// A range and the round numbers in it.
type Axis<'a> = (&'a RangeInclusive<f64>, &'a [Mark]);

/// Round numbers in a range, at least `apart` points from each other, but never fewer than two: one is no scale.
fn marks(range: &RangeInclusive<f64>, length: f32, apart: f32, is_phase: bool) -> Vec<Mark> {
    let span = range.end() - range.start();
    let raw = span * f64::from(apart / length.max(1.0));
    let decade = 10_f64.powf(raw.log10().floor());
    // Steps that are far enough apart, and below them those that are not.
    let steps = [10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1].map(|d| d * decade);
    let fitting = steps.into_iter().rev().find(|step| *step >= raw).unwrap_or(10.0 * decade);
    let at = |step: f64| -> Vec<f64> {
        let first = (range.start() / step).ceil();
        let all = (0..=(span / step).min(40.0) as i32).map(|k| (first + f64::from(k)) * step);
        all.filter(|value| range.contains(value)).collect()
    };
    let of_two = steps.into_iter().filter(|step| *step <= fitting).find(|step| at(*step).len() >= 2);
    let of_a_turn =
        [45.0, 90.0, 180.0, 360.0].into_iter().find(|step| is_phase && *step >= raw && at(*step).len() >= 2);
    let step = of_a_turn.or(of_two).unwrap_or(fitting);
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    let label = |value: f64| {
        if value.abs() >= 1e5 {
            // As many digits as tell it from the next.
            let digits = (value.abs().log10().floor() - step.log10().floor()).clamp(1.0, 16.0) as usize + 1;
            significant(value, digits)
        } else {
            crate::number::fixed(value, decimals)
        }
    };
    at(step).into_iter().map(|value| Mark { value, label: label(value) }).collect()
}

/// The powers of ten in a range of logarithms; where there are fewer than two, their double and fivefold too.
fn decades(range: &RangeInclusive<f64>) -> Vec<Mark> {
    let (first, last) = (range.start().floor().max(-12.0) as i32, range.end().floor().min(12.0) as i32);
    let within = |digits: &[f64]| -> Vec<Mark> {
        let all = (first..=last).flat_map(|power| digits.iter().map(move |digit| digit * 10_f64.powi(power)));
        all.filter(|value| range.contains(&value.log10()))
            .map(|value| Mark { value: value.log10(), label: significant(value, 1) })
            .collect()
    };
    let powers = within(&[1.0]);
    if powers.len() < 2 { within(&[1.0, 2.0, 5.0]) } else { powers }
}

/// Linear interpolation at x, exact at the points.
fn at(points: &[PlotPoint], x: f64) -> Option<f64> {
    let i = points.partition_point(|point| point.x <= x);
    let (a, b) = (points.get(i.checked_sub(1)?)?, points.get(i));
    match b {
        Some(b) => Some(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)),
        // At its very end, though not beyond.
        None => (x - a.x <= 1e-9 * a.x.abs()).then_some(a.y),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::marks;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Of any range that a plot can have, on an axis of any length.
        #[test]
        fn an_axis_has_two_figures_at_least(
            low in -1.0..1.0_f64,
            size in 0.01..2.0_f64,
            power in -9..9_i32,
            length in 20.0..900.0_f32,
        ) {
            let unit = 10_f64.powi(power);
            let marks = marks(&(low * unit..=(low + size) * unit), length, 34.0, false);
            prop_assert!(marks.len() >= 2, "{} of them", marks.len());
            for pair in marks.windows(2) {
                prop_assert!(pair[0].value < pair[1].value);
                prop_assert!(power < -6 || pair[0].label != pair[1].label, "{} twice", pair[0].label);
            }
        }
    }
}
