//! A measure over the range of a slider: how it goes, where it is now, what is stable, what the levels ask. Held with the pointer, the
//! chart moves the slider.

use std::ops::RangeInclusive;
use std::rc::Rc;

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::style::StyleModifier;
use egui::{
    Button, Id, Key, Label, PopupCloseBehavior, Rect, RichText, ScrollArea, TextEdit, Ui, Vec2, emath,
};

use super::legend::{self, Entry, Mark};
use super::{Canvas, note_ui};
use crate::findings::chart::{ChartPoint, Limit};
use crate::findings::measures::{Measure, Reading};
use crate::findings::{Findings, MeasureChart};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::Level;
use crate::number::trimmed;
use crate::scenario::view::ChartView;
use crate::scenario::{Convention, Hidden, Parameter, Scenario, ValueError, Written, parameters};
use crate::ui::chart::{Curve, Pattern, PlotContent, PlotPoint, SmallPlot};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives::Rows;
use crate::ui::finger;
use crate::ui::number_field::number_field_ui;
use crate::ui::slider::ReferenceSlider;
use crate::ui::slider_search::condensed;
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};
use crate::words;

/// Height of the slider below the chart, and of the chart on a phone \[points\].
const SLIDER: f32 = 24.0;
const ON_PHONE: f32 = 240.0;
/// Of the list of a chooser.
const LIST: Vec2 = Vec2::new(300.0, 280.0);
/// Of the field for a line of one's own.
const FIELD: f32 = 48.0;

/// The chart as it is on screen.
#[derive(Debug, Default)]
pub struct ChartPlot {
    plot: SmallPlot,
    /// What was drawn last.
    last: Option<Rc<MeasureChart>>,
    /// What is searched for in the choosers of measure and slider.
    searches: [String; 2],
}

/// The measure of a view, if there is one by its key that can be charted.
fn measure_of(view: &ChartView) -> Option<Measure> {
    Measure::find(&view.measure).filter(|measure| MeasureChart::can_show(*measure))
}

impl ChartPlot {
    /// Which measure over which slider, and lines of one's own.
    pub fn choosers_ui(
        &mut self,
        ui: &mut Ui,
        scenario: &Scenario,
        view: &mut ChartView,
        findings: &Findings,
    ) {
        if hides(ui) {
            return;
        }
        let [of_measure, of_slider] = &mut self.searches;
        let measure = measure_of(view);
        let now = measure.map_or_else(|| view.measure.clone(), words::measure::name);
        let listed = || measures(scenario, findings).collect::<Vec<_>>();
        let names = || listed().into_iter().map(words::measure::name).collect();
        if let Some(chosen) = searched_ui(ui, ("Measure of the chart", &now), of_measure, &names)
            && let Some(measure) = listed().get(chosen).filter(|chosen| Some(**chosen) != measure)
        {
            (view.measure, view.lines) = (measure.key(), Vec::new());
        }
        ui.label("over");
        let curtain = Curtain::of(ui);
        let sliders = || {
            let offered = |p: &&Parameter| ChartView::can_be_over(p, scenario) && curtain.offers(p);
            parameters().filter(offered).collect::<Vec<&'static Parameter>>()
        };
        let name_of = |parameter| name_of(parameter, scenario.convention());
        let names = || sliders().into_iter().map(name_of).collect();
        let now = view.over(scenario).map(name_of).unwrap_or_default();
        if let Some(chosen) = searched_ui(ui, ("Slider of the chart", &now), of_slider, &names) {
            view.over = sliders().get(chosen).copied();
        }
        if let Some(measure) = measure {
            lines_ui(ui, measure, scenario.convention(), &mut view.lines);
        }
    }

    /// The chart. One of the motion takes its time: it stays as it was while something is dragged that changes it.
    fn found(
        &mut self,
        ui: &Ui,
        findings: &Findings,
        parameter: &'static Parameter,
        measure: Measure,
    ) -> Rc<MeasureChart> {
        let is_slow = matches!(measure, Measure::OfOutput(..));
        let is_of_this =
            |chart: &&Rc<MeasureChart>| *chart.parameter == *parameter && chart.measure == measure && is_slow;
        let stays = ui.input(|input| input.pointer.any_down());
        let kept = self.last.as_ref().filter(|_| stays).filter(is_of_this).cloned();
        let chart = kept.unwrap_or_else(|| findings.chart(parameter, measure));
        self.last = Some(chart.clone());
        chart
    }

    /// Draws the chart and the slider below it over all the room there is; either moves the parameter.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>, edited: &mut Scenario) {
        if let Some((parameter, value)) = self.moved(ui, canvas) {
            parameter.set_or_reset(edited, value);
        }
    }

    /// The same; gives the parameter that a person has moved, and its new value \[SI\].
    fn moved(&mut self, ui: &mut Ui, canvas: Canvas<'_>) -> Option<(&'static Parameter, f64)> {
        let Canvas { findings, pinned, palette, curtain, .. } = canvas;
        let scenario = findings.scenario();
        let view = &canvas.view.chart[scenario.plane];
        if hides(ui) {
            ui.label(RichText::new(words::view::NUMBERS_HIDDEN).color(palette.weak));
            return None;
        }
        let Some(measure) = measure_of(view) else {
            note_ui(ui, &words::chart::unknown(&view.measure));
            return None;
        };
        let Some(parameter) = view.over(scenario) else {
            note_ui(ui, words::chart::NO_SLIDER);
            return None;
        };
        let chart = self.found(ui, findings, parameter, measure);
        let convention = scenario.convention();
        let axes = Axes::of(parameter, measure, convention);
        let value = parameter.get(scenario) / axes.x;
        let reading = measure.read(findings);
        let told = match &reading {
            Ok(reading) => words::chart::now(
                &words::measure::reading(measure, *reading, convention),
                &Symbol::parse(axes.over.symbol).plain(),
                &words::measure::with_unit(&trimmed(value, 4), axes.over.unit),
            ),
            Err(absence) => words::chart::no_reading(absence, convention.length),
        };
        let mut picture = axes.picture(&chart, palette);
        let of_pinned = pinned.filter(|pinned| ChartView::can_be_over(parameter, pinned.scenario()));
        if let Some(pinned) = of_pinned {
            let chart = pinned.chart(parameter, measure);
            let curves = axes.runs(&chart, "pinned", palette.pinned, Pattern::Dashed);
            picture.curves.extend(curves);
        }
        axes.add_lines(&mut picture, &chart, view, palette);
        picture.uprights.push((value, palette.accent));
        if let Ok(Reading::Number(number)) = reading {
            picture.dots.push((PlotPoint::new(value, number / axes.y), palette.accent));
        }
        ui.label(RichText::new(told).font(theme::small()));
        legend::legend_ui(ui, &entries(&picture, &chart, palette), canvas.beside);
        let is_free = curtain.frees(parameter);
        let below = if is_free { SLIDER } else { 0.0 };
        let height = if canvas.rows == Rows::Touch { ON_PHONE } else { ui.available_height().max(150.0) };
        let (room, _) = ui.allocate_exact_size(Vec2::new(ui.available_width(), height), egui::Sense::hover());
        let place = room.with_max_y(room.bottom() - below);
        let frame = SmallPlot::frame(ui, place, &picture);
        let cursor = ui.input(|input| input.pointer.hover_pos()).and_then(|at| {
            let range = picture.x_range.clone()?;
            let part = f64::from((at.x - frame.left()) / frame.width());
            frame.contains(at).then(|| range.start() + part * (range.end() - range.start()))
        });
        // The title tells the value of the first.
        let under = |x: f64| picture.curves.iter().position(|curve| curve.at(x).is_some());
        if let Some(place) = cursor.and_then(under).filter(|place| *place < axes.count(&chart)) {
            picture.curves.swap(0, place);
        }
        let (response, drawn) = self.plot.draw(ui, place, &mut picture, cursor);
        theme::focus_ring(ui, &response);
        if !is_free {
            return None;
        }
        let slider = Over::of(scenario, parameter, findings, axes.x);
        let held =
            finger::works_on(ui, &response) && (response.is_pointer_button_down_on() || response.clicked());
        let at = response.interact_pointer_pos().filter(|_| held);
        let by_chart = at.map(|at| slider.near(drawn.at(at).x, frame));
        let by_slider = slider.show(ui, room.with_min_y(place.bottom()), frame);
        let moved = by_slider.or(by_chart.filter(|moved| *moved != value))?;
        let in_si = if moved == slider.reference { parameter.reference(scenario) } else { moved * axes.x };
        let accepted = parameter.check(scenario, in_si).ok()?;
        Some((parameter, accepted))
    }
}

/// Whether a chart would tell what is hidden.
fn hides(ui: &Ui) -> bool {
    let curtain = Curtain::of(ui);
    curtain.hides_influence() || curtain.hides(Hidden::Curves)
}

/// The units of both axes in SI, and what they are of.
struct Axes {
    over: Written,
    of: Written,
    x: f64,
    y: f64,
}

impl Axes {
    fn of(parameter: &'static Parameter, measure: Measure, convention: Convention) -> Self {
        let (over, of) = (parameter.written(convention), words::measure::written(measure, convention));
        Self { over, of, x: over.in_si, y: of.in_si }
    }

    /// How many curves are of the chart itself.
    fn count(&self, chart: &MeasureChart) -> usize {
        chart.runs().count()
    }

    /// A curve for each part in which there is a reading.
    fn runs(
        &self,
        chart: &MeasureChart,
        name: &'static str,
        color: egui::Color32,
        pattern: Pattern,
    ) -> Vec<Curve> {
        let point = |value: f64, reading: f64| PlotPoint::new(value / self.x, reading / self.y);
        let curve = |points: Vec<PlotPoint>| Curve::new(name, points, color, pattern);
        let points =
            |run: &[ChartPoint]| run.iter().filter_map(|at| Some(point(at.value, at.reading?))).collect();
        chart.runs().map(|run| curve(points(run))).collect()
    }

    /// The measure over the slider, on the ground of what is stable.
    fn picture(&self, chart: &MeasureChart, palette: &Palette) -> PlotContent {
        let curves = self.runs(chart, "this aircraft", palette.text, Pattern::Full);
        let ends = [chart.points.first(), chart.points.last()].map(|point| point.map_or(0.0, |p| p.value));
        let range = chart.range().map(|(low, high)| self.with_limits(chart, (low / self.y, high / self.y)));
        let grounds = chart.stabilities().map(|(part, stability)| {
            let color =
                if stability == Stability::Stable { palette.stable_half } else { palette.unstable_half };
            (part.start() / self.x..=part.end() / self.x, color)
        });
        PlotContent {
            against: (self.over.symbol, self.over.unit),
            grounds: grounds.collect(),
            x_range: Some(ends[0] / self.x..=ends[1] / self.x),
            y_range: range,
            with_zero: false,
            ..PlotContent::of_time(self.of.symbol, self.of.unit, curves)
        }
    }

    /// A range of the measure with some room, and with the limits that are near it.
    fn with_limits(&self, chart: &MeasureChart, (low, high): (f64, f64)) -> RangeInclusive<f64> {
        let span = if high > low { high - low } else { high.abs().max(1.0) };
        let near = low - 0.5 * span..=high + 0.5 * span;
        let limits = chart.points.iter().flat_map(|point| &point.limits).map(|limit| limit.value / self.y);
        let (low, high) = limits
            .filter(|limit| near.contains(limit))
            .fold((low, high), |(low, high), limit| (low.min(limit), high.max(limit)));
        let room = 0.06 * (high - low).max(0.2 * span);
        low - room..=high + room
    }

    /// Limits of levels, and lines of one's own.
    fn add_lines(
        &self,
        picture: &mut PlotContent,
        chart: &MeasureChart,
        view: &ChartView,
        palette: &Palette,
    ) {
        let shown = picture.y_range.clone().unwrap_or(f64::NEG_INFINITY..=f64::INFINITY);
        let is_seen = |(_, line): &(Limit, Vec<(f64, f64)>)| {
            line.iter().any(|(_, limit)| shown.contains(&(limit / self.y)))
        };
        for (limit, line) in chart.limits().into_iter().filter(is_seen) {
            let points = line.iter().map(|(x, y)| PlotPoint::new(x / self.x, y / self.y)).collect();
            let color = match limit.level {
                Level::One => palette.good,
                Level::Two => palette.warning,
                Level::Three | Level::Beyond => palette.bad,
            };
            let name = words::chart::limit(limit.level);
            picture.curves.push(Curve::new(name, points, color, Pattern::Dashed));
        }
        let Some(range) = picture.x_range.clone() else { return };
        for line in &view.lines {
            let ends = [range.start(), range.end()].map(|x| PlotPoint::new(*x, line / self.y));
            picture.curves.push(Curve::new("own line", ends.into(), palette.accent, Pattern::Dotted));
        }
        if let Some(shown) = picture.y_range.take() {
            let own = view.lines.iter().map(|line| line / self.y);
            let (low, high) = own.fold(shown.into_inner(), |(low, high), y| (low.min(y), high.max(y)));
            picture.y_range = Some(low..=high);
        }
    }
}

/// What the legend has: the curves, and the grounds that differ.
fn entries(picture: &PlotContent, chart: &MeasureChart, palette: &Palette) -> Vec<Entry> {
    let mut entries = legend::curves(std::slice::from_ref(picture));
    let mut ground = |is_there: bool, color: egui::Color32, name: &str| {
        if is_there {
            let mark = Mark::Curve(Pattern::Filled);
            entries.push(Entry { mark, color, name: name.to_owned() });
        }
    };
    let is =
        |stable: bool| chart.stabilities().any(|(_, stability)| (stability == Stability::Stable) == stable);
    ground(is(true), palette.stable_half, "stable");
    ground(is(false), palette.unstable_half, "not stable");
    entries
}

/// The slider that the chart is over, in its shown unit.
struct Over {
    name: String,
    text: String,
    value: f64,
    range: RangeInclusive<f64>,
    reference: f64,
    exists: Option<RangeInclusive<f64>>,
}

impl Over {
    fn of(scenario: &Scenario, parameter: &'static Parameter, findings: &Findings, in_si: f64) -> Self {
        let shown = |range: RangeInclusive<f64>| range.start() / in_si..=range.end() / in_si;
        let value = parameter.get(scenario) / in_si;
        let Written { symbol, unit, .. } = parameter.written(scenario.convention());
        Self {
            name: format!("{} {}, below the chart", parameter.name, Symbol::parse(symbol).plain()),
            text: words::measure::with_unit(&trimmed(value, 4), unit),
            value,
            range: shown(parameter.range(scenario)),
            reference: parameter.reference(scenario) / in_si,
            exists: findings.existing_range(parameter).map(shown),
        }
    }

    /// The roundest value at a place on the chart, never one that doesn't exist.
    fn near(&self, x: f64, frame: Rect) -> f64 {
        let point = (self.range.end() - self.range.start()) / f64::from(frame.width().max(1.0));
        if (x - self.reference).abs() < 1.5 * point {
            return self.reference;
        }
        let round = emath::smart_aim::best_in_range_f64(x - 0.5 * point, x + 0.5 * point);
        let exists = self.exists.as_ref().unwrap_or(&self.range);
        round.clamp(*exists.start(), *exists.end())
    }

    /// Draws it as wide as the chart; gives the value that it is set to.
    fn show(&self, ui: &mut Ui, room: Rect, frame: Rect) -> Option<f64> {
        let slider = ReferenceSlider {
            name: &self.name,
            value_text: self.text.clone(),
            value: self.value,
            range: self.range.clone(),
            reference: self.reference,
            exists: self.exists.clone(),
            in_effect: None,
        };
        let place = Rect::from_x_y_ranges(frame.x_range().expand(7.0), room.y_range());
        let builder = egui::UiBuilder::new().max_rect(place);
        ui.scope_builder(builder, |ui| slider.show(ui, place.size()).1).inner
    }
}

/// The measures that have something to read now, of the plane on screen.
fn measures<'a>(scenario: &'a Scenario, findings: &'a Findings) -> impl Iterator<Item = Measure> {
    let names = move || {
        let plane = findings.plane().into_iter();
        plane.flat_map(|plane| findings.modes_in_flight(plane)).map(|mode| mode.naming.name)
    };
    let is_here = move |measure: &Measure| match *measure {
        Measure::OfMode(name, _) => names().any(|other| other == name),
        Measure::OfPlane(plane, _) => plane == scenario.plane,
        Measure::OfLoop(of, _) => of.input().0 == scenario.plane,
        Measure::OfAircraft(_) => scenario.plane == Plane::Longitudinal,
        Measure::OfOutput(output, _) => output.plane() == scenario.plane,
        Measure::OfParameter(parameter) => {
            parameter.page.is_some_and(|page| parameter.is_shown(scenario, page))
        }
    };
    let reads = |measure: &Measure| matches!(measure.read(findings), Ok(Reading::Number(_)));
    Measure::all().filter(|measure| MeasureChart::can_show(*measure)).filter(is_here).filter(reads)
}

/// A slider as the list has it.
fn name_of(parameter: &'static Parameter, convention: Convention) -> String {
    format!("{} · {}", Symbol::parse(parameter.written(convention).symbol).plain(), parameter.name)
}

/// A list that can be searched; gives the place of what was chosen in it.
fn searched_ui(
    ui: &mut Ui,
    (name, now): (&str, &str),
    search: &mut String,
    list: &dyn Fn() -> Vec<String>,
) -> Option<usize> {
    let config = MenuConfig::new().style(StyleModifier::default());
    let config = config.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let field = Id::unique(("search", name));
    let button = MenuButton::new(format!("{now} ▾")).config(config);
    let (response, inner) = button.ui(ui, |ui| {
        ui.set_width(LIST.x);
        let response =
            TextEdit::singleline(search).id(field).hint_text("Find").desired_width(LIST.x).show(ui);
        let response = response.response.response.accessible_name(format!("Find a {}", name.to_lowercase()));
        theme::focus_frame(ui, &response);
        let by_enter = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let wanted = condensed(search);
        let mut chosen = None;
        ScrollArea::vertical().max_height(LIST.y).auto_shrink([false, true]).show(ui, |ui| {
            for (place, text) in list().into_iter().enumerate() {
                if !condensed(&text).contains(&wanted) {
                    continue;
                }
                if by_enter {
                    chosen = chosen.or(Some(place));
                }
                if ui.add(Button::selectable(text == now, text)).clicked() {
                    chosen = Some(place);
                }
            }
        });
        if chosen.is_some() {
            ui.close();
        }
        chosen
    });
    if response.clicked() {
        search.clear();
        if !theme::is_for_fingers(ui) {
            ui.memory_mut(|memory| memory.request_focus(field));
        }
    }
    response.accessible_name(format!("{name}: {now}"));
    inner.and_then(|inner| inner.inner)
}

/// Lines of one's own: typed in the unit of the measure, and taken away by their buttons.
fn lines_ui(ui: &mut Ui, measure: Measure, convention: Convention, lines: &mut Vec<f64>) {
    let Written { unit, in_si, .. } = words::measure::written(measure, convention);
    let mut away = None;
    for (place, line) in lines.iter().enumerate() {
        let shown = words::measure::with_unit(&trimmed(line / in_si, 4), unit);
        let button = Button::new(RichText::new(format!("{shown} ✕")).font(theme::small()));
        if ui.add(button).accessible_name(format!("Remove the line at {shown}")).clicked() {
            away = Some(place);
        }
    }
    if let Some(place) = away {
        lines.remove(place);
    }
    if lines.len() >= ChartView::MOST_LINES {
        return;
    }
    ui.add(Label::new("Line at").extend());
    let name = if unit.is_empty() { "line at".to_owned() } else { format!("line at, in {unit}") };
    let read = |text: &str| {
        let number = text.trim().replace('−', "-").replace(',', ".").parse::<f64>();
        let number = number.map_err(|_| ValueError::NotANumber(text.trim().to_owned()))?;
        if number.is_finite() { Ok(number * in_si) } else { Err(ValueError::NotFinite) }
    };
    let id = Id::unique(("chart", "line"));
    let field = number_field_ui(ui, id, &name, "", (FIELD, theme::sizes(ui).name), read);
    if !unit.is_empty() {
        ui.label(RichText::new(unit).font(theme::small()).color(Palette::of(ui).weak));
    }
    if let Some(refusal) = field.refusal {
        refusal.show(ui);
    }
    lines.extend(field.accepted);
}
