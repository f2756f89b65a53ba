//! One small plot: its title with the value at the cursor, its axes with round numbers, and its curves.

use std::ops::RangeInclusive;

use egui::{
    Align2, Color32, FontId, Id, Pos2, Rect, Response, Sense, Stroke, Ui, Vec2, WidgetInfo, accesskit::Role,
};

use super::{AxisRange, Chart, Curve, Pattern, PlotPoint, Primitive, Room, Scale, Tick, View, paint};
use crate::number::{round_up, significant};
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};
use crate::ui::{copy, finger};

const TITLE_HEIGHT: f32 = 20.0;
/// Room for the numbers left of a plot and below it, where they are of this size.
const GUTTER: Vec2 = Vec2::new(36.0, 14.0);
const TICK: f32 = 10.0;
/// Room right of a plot for the last number.
const MARGIN: f32 = 8.0;
/// So far the first and the last number may reach beyond a plot: into the gutter, and into what parts it from the next.
const OVERHANG: f32 = 14.0;
/// Least distance of the numbers on either axis, and as a share of its length.
const APART: Vec2 = Vec2::new(30.0, 24.0);
const SHARE: Vec2 = Vec2::new(0.18, 0.14);
/// So many times the range of what is in full colour, a plot shows what is faded too.
const MOST_GROWTH: f64 = 6.0;
/// So much of it at least, however far it grows.
const LEAST_GROWTH: f64 = 1.5;
/// Length of a sample of a line in a title or a legend.
pub const SAMPLE: f32 = 18.0;
/// Radius of a dot.
pub const DOT: f32 = 3.5;

/// What a small plot shows.
#[derive(Clone, Debug)]
pub struct PlotContent {
    /// Symbol of the quantity.
    pub symbol: String,
    /// Unit of the quantity.
    pub unit: String,
    /// Symbol and unit of the horizontal axis.
    pub against: (&'static str, &'static str),
    /// The curves; the first is the one whose value the title tells.
    pub curves: Vec<Curve>,
    /// Parts of the horizontal axis on a ground of their own: where the motion is no small disturbance any more, what is stable.
    pub grounds: Vec<(RangeInclusive<f64>, Color32)>,
    /// Upright lines with a colour: the cursor, frequencies of modes.
    pub uprights: Vec<(f64, Color32)>,
    /// Dots with a colour.
    pub dots: Vec<(PlotPoint, Color32)>,
    /// Range of the horizontal axis; of the curves where there is none.
    pub x_range: Option<RangeInclusive<f64>>,
    /// Range of the vertical axis, likewise.
    pub y_range: Option<RangeInclusive<f64>>,
    /// Rings with a colour: zeros.
    pub rings: Vec<(PlotPoint, Color32)>,
    /// Straight lines, with colour and pattern.
    pub segments: Vec<([PlotPoint; 2], Color32, Pattern)>,
    /// Rectangles of the ground, with their colours.
    pub shades: Vec<(View, Color32)>,
    /// Words in the plot, centred here.
    pub labels: Vec<(PlotPoint, &'static str)>,
    /// Whether a plot below it has the same horizontal axis, and tells it.
    pub is_above: bool,
    /// Whether both axes have one scale.
    pub has_one_scale: bool,
    /// How both axes are divided.
    pub scales: (Scale, Scale),
    /// Whether the vertical axis holds zero.
    pub with_zero: bool,
    /// Symbols of the curves, where each is another quantity: the title then names them all.
    pub quantities: Vec<&'static str>,
    /// Whether no value of the curves is told.
    pub is_silent: bool,
    /// Whether of the numbers of the vertical axis only zero is told: how far a hidden curve goes may be what is asked.
    pub hides_size: bool,
}

impl PlotContent {
    /// Plots of functions of time.
    pub fn of_time(symbol: impl Into<String>, unit: impl Into<String>, curves: Vec<Curve>) -> Self {
        Self {
            symbol: symbol.into(),
            unit: unit.into(),
            against: ("t", "s"),
            curves,
            grounds: Vec::new(),
            uprights: Vec::new(),
            dots: Vec::new(),
            rings: Vec::new(),
            segments: Vec::new(),
            shades: Vec::new(),
            labels: Vec::new(),
            is_above: false,
            has_one_scale: false,
            x_range: None,
            y_range: None,
            scales: (Scale::Even, Scale::Even),
            with_zero: true,
            quantities: Vec::new(),
            is_silent: false,
            hides_size: false,
        }
    }

    /// The same with its axes alone: they hold the curves that aren't drawn, and tell neither how far those go nor on which side of zero.
    pub fn without_curves(mut self) -> Self {
        let (_, y) = self.ranges();
        if self.with_zero {
            let most = y.start().abs().max(y.end().abs());
            self.y_range = Some(-most..=most);
        }
        let (curves, grounds, uprights, dots, rings) = Default::default();
        let (segments, shades, labels) = Default::default();
        let without = Self { curves, grounds, uprights, dots, rings, segments, shades, labels, ..self };
        Self { is_silent: true, hides_size: true, ..without }
    }

    /// Whether a number of the vertical axis is told.
    fn tells(&self, tick: &Tick) -> bool {
        !self.hides_size || tick.value == 0.0
    }

    /// The ranges of both axes.
    fn ranges(&mut self) -> (RangeInclusive<f64>, RangeInclusive<f64>) {
        let x = self.x_range.take().unwrap_or_else(|| self.range(|point| point.x));
        let y = self.y_range.take().unwrap_or_else(|| self.range(|point| point.y));
        (self.x_range, self.y_range) = (Some(x.clone()), Some(y.clone()));
        (x, y)
    }

    /// The range of all curves with a margin. What is faded may leave it.
    fn range(&self, coordinate: impl Fn(&PlotPoint) -> f64) -> RangeInclusive<f64> {
        let start = if self.with_zero { (0.0, 0.0) } else { (f64::INFINITY, f64::NEG_INFINITY) };
        // Comparisons, since `f64::min` is a call of a function in a browser.
        let widened = |(low, high): (f64, f64), value: f64| {
            (if value < low { value } else { low }, if value > high { value } else { high })
        };
        let full = self.curves.iter().flat_map(Curve::full_part).map(&coordinate).fold(start, widened);
        let whole = self.curves.iter().flat_map(Curve::faded_part).map(&coordinate).fold(full, widened);
        let (low, high) = with_faded(full, whole);
        if high - low <= 1e-12 {
            let middle = if low.is_finite() { low } else { 0.0 };
            return middle - 1.0..=middle + 1.0;
        }
        // Ends are multiples of an eighth of a round number, so that they hold still through small changes.
        let step = round_up(high - low) / 8.0;
        ((low / step).floor() - 0.6) * step..=((high / step).ceil() + 0.6) * step
    }

    /// Its curves as a table, those of the first one's places.
    fn table(&self) -> String {
        let Some(first) = self.curves.first() else { return String::new() };
        let with_unit = |symbol: &str, unit: &str| {
            let symbol = Symbol::parse(symbol).plain();
            if unit.is_empty() { symbol } else { format!("{symbol} [{unit}]") }
        };
        let is_beside = |curve: &&Curve| {
            let places = curve.points.iter().map(|point| point.x);
            places.eq(first.points.iter().map(|point| point.x))
        };
        let beside: Vec<&Curve> = self.curves.iter().filter(is_beside).collect();
        let names = beside.iter().enumerate().map(|(place, curve)| {
            let symbol = self.quantities.get(place).copied().unwrap_or(self.symbol.as_str());
            format!("{} {}", curve.name, with_unit(symbol, &self.unit))
        });
        let head = std::iter::once(with_unit(self.against.0, self.against.1)).chain(names);
        let mut lines = vec![head.collect::<Vec<_>>().join("\t")];
        for (place, point) in first.points.iter().enumerate() {
            let values = beside.iter().map(|curve| curve.points[place].y.to_string());
            let line = std::iter::once(point.x.to_string()).chain(values);
            lines.push(line.collect::<Vec<_>>().join("\t"));
        }
        lines.join("\n") + "\n"
    }

    fn words(&self) -> String {
        let symbol = Symbol::parse(&self.symbol).plain();
        let points = self.curves.first().map_or(&[][..], Curve::full_part);
        let extreme =
            |pick: fn(f64, f64) -> f64| points.iter().map(|point| point.y).reduce(pick).unwrap_or(0.0);
        let last = points.last().map_or(0.0, |point| point.y);
        let others: Vec<&str> = self.curves.iter().skip(1).map(|curve| curve.name).collect();
        let is_faded = self.curves.first().is_some_and(|curve| !curve.faded_part().is_empty());
        let until = if is_faded { "where it is no longer small" } else { "at the end" };
        let against =
            if self.against.0 == "t" { "time".to_owned() } else { Symbol::parse(self.against.0).plain() };
        let with = if others.is_empty() { String::new() } else { format!("; with {}", others.join(", ")) };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" in {}", self.unit) };
        if self.is_silent || points.is_empty() {
            return format!("{symbol}{unit} against {against}{with}");
        }
        format!(
            "{symbol}{unit} against {against}: between {} and {}, {} {until}{with}",
            significant(extreme(f64::min), 3),
            significant(extreme(f64::max), 3),
            significant(last, 3),
        )
    }
}

/// What is shown of a range `whole` in which curves are in full colour over the range `full` only.
///
/// Up to [`MOST_GROWTH`] times the range in full colour all is shown. What grows beyond that leaves the plot: the more it does, the
/// less of it is shown, so that the part in full colour is never pressed flat.
fn with_faded(full: (f64, f64), whole: (f64, f64)) -> (f64, f64) {
    let span = full.1 - full.0;
    let growth = (whole.1 - whole.0) / span;
    if !(growth > MOST_GROWTH && span > 0.0) {
        return whole;
    }
    let shown = (MOST_GROWTH * MOST_GROWTH / growth).max(LEAST_GROWTH);
    let beyond = (shown - 1.0) * span;
    (whole.0.max(full.0 - beyond), whole.1.min(full.1 + beyond))
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
        picture: &mut PlotContent,
        cursor: Option<f64>,
    ) -> Option<f64> {
        let (response, chart) = self.draw(ui, rect, picture, cursor);
        theme::focus_ring(ui, &response);
        let held = finger::works_on(ui, &response);
        // A finger that has tapped is nowhere any more.
        let pointer = if response.clicked() { response.interact_pointer_pos() } else { response.hover_pos() };
        let pointer = pointer.filter(|_| held)?;
        Some(chart.at(pointer).x.clamp(chart.view.left, chart.view.right))
    }

    /// Where the curves of a picture are in the room that it has.
    pub fn frame(ui: &Ui, rect: Rect, picture: &PlotContent) -> Rect {
        let mut gutter = GUTTER * (theme::sizes(ui).tick / TICK);
        if picture.is_above {
            gutter.y = 0.0;
        }
        Rect::from_min_max(
            rect.min + Vec2::new(gutter.x, TITLE_HEIGHT),
            rect.max - Vec2::new(MARGIN, gutter.y),
        )
    }

    /// Draws the picture, for who works on it: what has been done to it, and the chart.
    pub fn draw(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        picture: &mut PlotContent,
        cursor: Option<f64>,
    ) -> (Response, Chart) {
        let value = picture.curves.first().zip(cursor).and_then(|(curve, x)| Some((curve.at(x)?, x)));
        title(ui, rect, picture, value.filter(|_| !picture.is_silent));
        let (x, y) = picture.ranges();
        let (x, y) = (self.x.toward(ui, x), self.y.toward(ui, y));
        let frame = Self::frame(ui, rect, picture);
        let (left, right, bottom, top) = (*x.start(), *x.end(), *y.start(), *y.end());
        let view = View { left, right, bottom, top };
        let view = if picture.has_one_scale { view.holding(frame) } else { view };
        let chart = Chart { rect: frame, view };
        let id = Id::unique((&picture.symbol, &picture.unit, picture.against.0));
        // Not for the keyboard, which would find nothing to do there.
        let response = ui.interact(frame, id, Sense::CLICK | Sense::DRAG);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, picture.words()));
        let painter = ui.painter_at(frame.expand(1.0));
        let ticks = axes(ui, picture, &chart);
        let thinnest = if theme::is_for_a_room(ui) { Pattern::Full.width() } else { 0.0 };
        picture.curves.iter_mut().for_each(|curve| curve.thinnest = thinnest);
        paint(&painter, draw(picture, &chart, &ticks, cursor, Palette::of(ui)));
        let font = FontId::proportional(theme::sizes(ui).tick);
        for (at, text) in &picture.labels {
            painter.text(
                chart.position(*at),
                Align2::CENTER_CENTER,
                text,
                font.clone(),
                Palette::of(ui).text,
            );
        }
        if !picture.is_silent {
            copy::offer(ui, frame, &|| picture.table());
        }
        (response, chart)
    }
}

/// All within the frame, from the ground up.
fn draw(
    picture: &mut PlotContent,
    chart: &Chart,
    ticks: &[Vec<Tick>; 2],
    cursor: Option<f64>,
    palette: &Palette,
) -> Vec<Primitive> {
    let mut list = Vec::new();
    let upright = |x: f64, color: Color32, pattern: Pattern| {
        let x = chart.position(PlotPoint::new(x, 0.0)).x;
        let ends = [chart.rect.bottom(), chart.rect.top()].map(|y| Pos2::new(x, y));
        Primitive::line(ends, Stroke::new(1.0, color), pattern)
    };
    let level = |y: f64, color: Color32| {
        let y = chart.position(PlotPoint::new(0.0, y)).y;
        let ends = [chart.rect.left(), chart.rect.right()].map(|x| Pos2::new(x, y));
        Primitive::line(ends, Stroke::new(1.0, color), Pattern::Full)
    };
    for (View { left, right, bottom, top }, color) in &picture.shades {
        let [from, to] =
            [(*left, *top), (*right, *bottom)].map(|(x, y)| chart.position(PlotPoint::new(x, y)));
        list.push(Primitive::Rectangle(Rect::from_min_max(from, to).intersect(chart.rect), *color));
    }
    for (part, color) in &picture.grounds {
        let [from, to] = [part.start(), part.end()].map(|x| chart.position(PlotPoint::new(*x, 0.0)).x);
        let rect = Rect::from_x_y_ranges(from..=to, chart.rect.y_range()).intersect(chart.rect);
        list.push(Primitive::Rectangle(rect, *color));
    }
    let [horizontal, vertical] = ticks;
    list.extend(vertical.iter().map(|tick| level(tick.value, palette.hairline)));
    list.extend(horizontal.iter().map(|tick| upright(tick.value, palette.hairline, Pattern::Full)));
    if picture.with_zero {
        list.push(level(0.0, palette.pinned));
    }
    // The first is drawn last, on top.
    picture.curves.iter_mut().rev().for_each(|curve| curve.draw(chart, &mut list));
    list.extend(picture.uprights.iter().map(|&(x, color)| upright(x, color, Pattern::Dashed)));
    list.extend(cursor.map(|x| upright(x, palette.weak, Pattern::Dotted)));
    for (ends, color, pattern) in &picture.segments {
        let stroke = Stroke::new(1.8, *color);
        let parts = chart.clipped(*ends).into_iter();
        list.extend(parts.map(|points| Primitive::Line { points, stroke, pattern: *pattern }));
    }
    list.extend(picture.rings.iter().map(|&(at, color)| Primitive::Ring(chart.position(at), DOT, color)));
    list.extend(picture.dots.iter().map(|&(at, color)| Primitive::Dot(chart.position(at), DOT, color)));
    list
}

/// Writes the numbers of both axes outside the frame, a unit of time after the last; gives the ticks across and upward.
fn axes(ui: &Ui, picture: &PlotContent, chart: &Chart) -> [Vec<Tick>; 2] {
    let (View { left, right, bottom, top }, rect) = (chart.view, chart.rect);
    let color = Palette::of(ui).weak;
    let font = FontId::proportional(theme::sizes(ui).tick);
    let painter = ui.painter();
    let set = |text: &str| painter.layout_no_wrap(text.to_owned(), font.clone(), color);
    let width = |text: &str| set(text).size().x;
    let height = set("0").size().y;
    let apart = APART.max(SHARE * rect.size());
    let across = Room { length: rect.width(), apart: apart.x, extent: &width, overhang: OVERHANG };
    // At the bottom none reaches down to those of the other axis.
    let upward = Room { length: rect.height(), apart: apart.y, extent: &|_| height, overhang: 1.0 };
    let ticks =
        [picture.scales.0.ticks(&(left..=right), across), picture.scales.1.ticks(&(bottom..=top), upward)];
    let mut end = rect.left();
    for tick in ticks[0].iter().filter(|_| !picture.is_above) {
        let galley = set(&tick.label);
        let x = chart.position(PlotPoint::new(tick.value, 0.0)).x;
        let place = Align2::CENTER_TOP.anchor_size(Pos2::new(x, rect.bottom() + 1.0), galley.size());
        painter.galley(place.min, galley, color);
        end = place.right();
    }
    if picture.against.0 == "t" {
        painter.galley(Pos2::new(end, rect.bottom() + 1.0), set(&format!(" {}", picture.against.1)), color);
    }
    for tick in ticks[1].iter().filter(|tick| picture.tells(tick)) {
        let at = Pos2::new(rect.left() - 4.0, chart.position(PlotPoint::new(0.0, tick.value)).y);
        painter.text(at, Align2::RIGHT_CENTER, &tick.label, font.clone(), color);
    }
    ticks
}

/// Draws a sample of a curve, as long as [`SAMPLE`] and with the middle of its left end here.
pub fn sample(left: Pos2, pattern: Pattern, color: Color32) -> Primitive {
    if pattern == Pattern::Filled {
        let middle = left + Vec2::new(0.5 * SAMPLE, 0.0);
        return Primitive::Rectangle(Rect::from_center_size(middle, Vec2::splat(9.0)), color);
    }
    let stroke = Stroke::new(pattern.width(), color);
    Primitive::line([left, left + Vec2::new(SAMPLE, 0.0)], stroke, pattern)
}

/// Symbol and unit on the left; on the right the value at the cursor.
fn title(ui: &Ui, rect: Rect, picture: &PlotContent, value: Option<(f64, f64)>) {
    let palette = Palette::of(ui);
    if !picture.quantities.is_empty() {
        quantities(ui, rect, picture);
    } else {
        quantity(ui, rect, picture);
    }
    // Of several quantities nobody could tell whose it is.
    if let Some((value, x)) = value.filter(|_| picture.quantities.len() < 2) {
        let mut text = format!("{} {}", significant(value, 3), picture.unit);
        if picture.scales.0 == Scale::Decades {
            // Of a frequency too, in short.
            let unit = picture.unit.split(' ').next().unwrap_or_default();
            let x = significant(10_f64.powf(x), 3);
            text = format!("{} {unit} at {x} {}", significant(value, 3), picture.against.1);
        }
        let corner = rect.right_top() + Vec2::new(-4.0, 2.0);
        ui.painter().text(
            corner,
            Align2::RIGHT_TOP,
            text,
            theme::semibold(theme::sizes(ui).small),
            palette.text,
        );
    }
}

/// The title of a picture of one quantity.
fn quantity(ui: &Ui, rect: Rect, picture: &PlotContent) {
    let palette = Palette::of(ui);
    let mut job = Symbol::parse(&picture.symbol).job(theme::sizes(ui).title_symbol, palette.text);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    job.append(&format!("  {}", picture.unit), 0.0, weak());
    if picture.against.0 != "t" && !picture.is_above {
        job.append(" against ", 0.0, weak());
        Symbol::parse(picture.against.0).append_to(&mut job, theme::sizes(ui).inline_symbol, palette.text);
        job.append(&format!(" {}", picture.against.1), 0.0, weak());
    }
    let galley = ui.painter().layout_job(job);
    ui.painter().galley(rect.min + Vec2::new(2.0, 0.0), galley, palette.text);
}

/// The title of a picture of inputs: of each, as far as there is room, a sample of its curve, its symbol and its name.
fn quantities(ui: &Ui, rect: Rect, picture: &PlotContent) {
    let palette = Palette::of(ui);
    let weak = || egui::TextFormat::simple(theme::small(), palette.weak);
    let several = picture.quantities.len() > 1;
    let galleys = |with_symbol: bool, with_name: bool| -> Vec<_> {
        let parts = picture.quantities.iter().zip(&picture.curves).enumerate();
        let parts = parts.map(|(i, (symbol, curve))| {
            let mut job = egui::text::LayoutJob::default();
            if with_symbol {
                Symbol::parse(symbol).append_to(&mut job, theme::sizes(ui).title_symbol, palette.text);
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
            let left = left_top + Vec2::new(0.0, 10.0);
            paint(ui.painter(), vec![sample(left, curve.pattern, curve.color)]);
        }
        let width = wide(&galley);
        let down = if several { 10.0 - 0.5 * galley.size().y } else { 0.0 };
        ui.painter().galley(left_top + Vec2::new(before, down), galley, palette.text);
        left_top.x += width;
    }
}

#[cfg(test)]
mod tests {
    use super::{PlotContent, Tick, with_faded};

    #[test]
    fn axes_without_their_curves_do_not_tell_on_which_side_of_zero_these_are() {
        let plot = PlotContent { y_range: Some(-4.0..=1.0), ..PlotContent::of_time("α", "deg", Vec::new()) };
        assert_eq!(plot.clone().without_curves().y_range, Some(-4.0..=4.0));
        let anywhere = PlotContent { with_zero: false, ..plot };
        assert_eq!(anywhere.without_curves().y_range, Some(-4.0..=1.0));
    }

    #[test]
    fn axes_without_their_curves_tell_only_where_zero_is() {
        let plot = PlotContent::of_time("α", "deg", Vec::new());
        let tick = |value: f64| Tick { value, label: value.to_string() };
        let told = |plot: &PlotContent| [-5.0, 0.0, 5.0].map(|value| plot.tells(&tick(value)));
        assert_eq!(told(&plot), [true; 3]);
        assert_eq!(told(&plot.without_curves()), [false, true, false]);
    }

    #[test]
    fn a_faded_curve_is_shown_whole_unless_it_grows_without_bound() {
        let full = (-1.0, 1.0);
        assert_eq!(with_faded(full, full), full);
        assert_eq!(with_faded(full, (-4.0, 5.0)), (-4.0, 5.0));
        // Beyond that the part in full colour keeps a sixth of the plot at least, and more the further the rest goes.
        let mut before = f64::INFINITY;
        for growth in [12.0, 13.0, 20.0, 100.0, 1e9] {
            let (low, high) = with_faded(full, (-1.0, growth));
            assert!(low == -1.0 && (2.0..=11.0).contains(&high) && high <= before, "{growth}: {high}");
            before = high;
        }
        // What doesn't move while it is small has no scale of its own.
        assert_eq!(with_faded((0.0, 0.0), (0.0, 3.0)), (0.0, 3.0));
    }
}
