//! The damping over the gain of a rate and its washout: a ground with lines of equal damping and the limits of the levels, on which
//! the law is a point that can be dragged.

use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

use egui::{Color32, Id, Key, Rect, RichText, Sense, Ui, Vec2, WidgetInfo, accesskit::Role};

use super::legend::{self, Entry, Mark};
use super::time::tall_grid;
use super::{CacheKey, Canvas, kept};
use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::damping_map::{DampingMap, place_of, washout_at};
use crate::flight::feedback::law::RATE;
use crate::flight::verdicts::handling_qualities::Level;
use crate::number::{round_up, significant};
use crate::scenario::{Hidden, Lock, Parameter, Scenario};
use crate::ui::chart::{Pattern, PlotContent, PlotPoint, Scale, SmallPlot, View};
use crate::ui::curtain::Curtain;
use crate::ui::theme::{self, Palette};
use crate::ui::{arrow_keys, finger};
use crate::words::loops as words;

/// Damping ratios whose lines are drawn, with their names.
const LINES: [(f64, &str); 8] = [
    (0.0, "ζ = 0"),
    (0.1, "0.1"),
    (0.2, "0.2"),
    (0.3, "0.3"),
    (0.4, "0.4"),
    (0.5, "0.5"),
    (0.7, "0.7"),
    (0.9, "0.9"),
];
/// Levels whose limits are drawn, with their names.
const LEVELS: [(Level, &str); 3] =
    [(Level::One, "limit of Level 1"), (Level::Two, "limit of Level 2"), (Level::Three, "limit of Level 3")];
/// So many times the gain are on the map at least.
const AROUND: f64 = 1.6;
/// Steps of an arrow key across the map and up it.
const STEPS: (f64, f64) = (200.0, 40.0);

/// Between a row of the map that has been judged and the next.
const A_MOMENT: Duration = Duration::from_millis(1);

/// The map.
#[derive(Debug, Default)]
pub struct MapPlot {
    plot: SmallPlot,
    /// Gain at the right edge while the point is held.
    held: Option<f64>,
    sheet: Option<(Drawn, (PlotContent, Vec<Entry>))>,
    told: Option<(CacheKey, Option<String>)>,
}

/// The key of the picture.
#[derive(Debug)]
struct Drawn {
    map: Rc<DampingMap>,
    palette: &'static Palette,
    /// Whether the limits of the levels can be drawn.
    judged: bool,
    curtain: Arc<Curtain>,
}

impl PartialEq for Drawn {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.map, &other.map)
            && self.judged == other.judged
            && std::ptr::eq(self.palette, other.palette)
            && self.curtain == other.curtain
    }
}

/// Keys of the gain of the rate to either input, and of its washout.
const fn keys(plane: Plane) -> ([&'static str; 2], &'static str) {
    match plane {
        Plane::Longitudinal => (["k.q_de", "k.q_dt"], "washout_q"),
        Plane::Lateral => (["k.r_da", "k.r_dr"], "washout"),
    }
}

impl MapPlot {
    /// Draws the map, and edits the law where its point is moved.
    pub fn show(&mut self, ui: &mut Ui, canvas: Canvas<'_>, scenario: &mut Scenario) {
        let Canvas { findings, view, palette, curtain, .. } = canvas;
        let of: &Findings = findings;
        let plane = of.scenario().plane;
        let Some(input) = of.mapped_input(usize::from(view.cuts_second[plane])) else { return };
        let law = &of.scenario().law.planes[plane];
        let (gain, washout) = (law.gains()[input][RATE], law.washout);
        let (is_down, escapes) = ui.input(|input| (input.pointer.any_down(), input.key_pressed(Key::Escape)));
        if !is_down || escapes {
            self.held = None;
        }
        let reach = self.held.unwrap_or_else(|| round_up(AROUND * gain.abs()).copysign(gain));
        // The point leaves the map as it is; everything else that is dragged makes another.
        let Some(map) = of.damping_map(input, reach, is_down && self.held.is_none()) else { return };
        if !is_down && of.judge_map() {
            // The rest in the frames to come, so that none of them takes long.
            ui.request_repaint_after(A_MOMENT);
        }
        let is_told = !curtain.hides_values() && !curtain.hides_any(&[Hidden::Verdicts, Hidden::Curves]);
        let (gain_key, washout_key) = (keys(plane).0[input], keys(plane).1);
        let rows = [gain_key, washout_key].map(Parameter::find);
        // The best of the slider, whatever part of it the map shows.
        let told = kept(&mut self.told, CacheKey::of(canvas), || {
            let range = rows[0]?.range(of.scenario());
            let best = of.best_gain(input, [*range.start(), *range.end()]);
            let (here, best) = of.damping_here().zip(best)?;
            Some(words::map((gain, here), washout, best))
        });
        if let Some(text) = told.as_deref().filter(|_| is_told) {
            let font = theme::semibold(theme::sizes(ui).small);
            ui.label(RichText::new(text).font(font).color(palette.text));
        }
        let judged = map.levels.len() == map.places.len();
        let key = Drawn { map: map.clone(), palette, judged, curtain: curtain.clone() };
        let symbol = rows[0].map_or("k", |row| row.symbol);
        let (picture, entries) =
            kept(&mut self.sheet, key, || picture(&map, symbol, palette, is_told, canvas));
        legend::legend_ui(ui, entries, canvas.beside);
        let Some(place) = tall_grid(ui, 1, canvas.rows).first().copied() else { return };
        let at = PlotPoint::new(gain, place_of(washout));
        picture.dots = vec![(at, palette.text)];
        let (ground, chart) = self.plot.draw(ui, place, picture, None);
        let [Some(gain_row), Some(washout_row)] = rows else { return };
        let is_free = !curtain.locks(Lock::View) && curtain.frees(gain_row);
        let works = finger::works_on(ui, &ground);
        let point = Rect::from_center_size(chart.position(at), Vec2::splat(14.0));
        let point = ui.interact(point, Id::unique("point of the map"), Sense::focusable_noninteractive());
        let said = if curtain.hides(Hidden::Numbers) {
            "The law on the map".to_owned()
        } else {
            format!(
                "The law on the map: gain {}, washout {} s",
                significant(gain, 3),
                significant(washout, 3)
            )
        };
        point.widget_info(|| WidgetInfo::labeled(Role::Button, true, said.as_str()));
        ui.ctx().accesskit_node_builder(point.id, |node| {
            node.set_description(
                "Left and right change the gain, up and down the washout, with Shift further.",
            );
        });
        theme::focus_ring(ui, &point);
        if !is_free {
            return;
        }
        let mut wanted = None;
        let pressed = (ground.dragged() || ground.clicked()) && works;
        if let Some(pointer) = ground.interact_pointer_pos().filter(|_| pressed) {
            self.held = Some(reach).filter(|_| is_down);
            wanted = Some(chart.at(pointer));
        }
        if point.has_focus() {
            arrow_keys::keep(ui, &point);
            let steps = ui.input(|input| {
                let presses = |key| input.num_presses(key) as f64;
                let times = if input.modifiers.shift { 10.0 } else { 1.0 };
                let across = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
                (times * across, times * (presses(Key::ArrowUp) - presses(Key::ArrowDown)))
            });
            if steps != (0.0, 0.0) {
                let span = map.places.last().copied().unwrap_or(1.0) - map.places[0];
                let up = at.y + steps.1 * span / STEPS.1;
                wanted = Some(PlotPoint::new(at.x + steps.0 * reach.abs() / STEPS.0, up));
            }
        }
        let Some(wanted) = wanted else { return };
        // In round numbers, and never no gain at all, without which there would be no map.
        let step = reach.abs() / (2.0 * STEPS.0);
        let gain = step * (wanted.x.abs().min(reach.abs()) / step).round().max(1.0);
        let gain = if wanted.x * reach > 0.0 { gain.copysign(reach) } else { step.copysign(reach) };
        let time = washout_at(wanted.y);
        let coarseness = if time < 1.0 { 100.0 } else { 10.0 };
        let time =
            if (wanted.y - at.y).abs() < 1e-9 { washout } else { (time * coarseness).round() / coarseness };
        for (row, value) in [(gain_row, gain), (washout_row, time)] {
            let range = row.range(scenario);
            if curtain.frees(row) {
                row.set(scenario, value.clamp(*range.start(), *range.end()));
            }
        }
    }
}

/// The ground by its damping, lines of equal damping with their numbers, and the limits of the levels.
fn picture(
    map: &DampingMap,
    symbol: &'static str,
    palette: &Palette,
    is_told: bool,
    canvas: Canvas<'_>,
) -> (PlotContent, Vec<Entry>) {
    let mut picture = PlotContent {
        against: (symbol, ""),
        with_zero: false,
        x_range: Some(0.0_f64.min(map.reach())..=0.0_f64.max(map.reach())),
        y_range: map.places.first().copied().zip(map.places.last().copied()).map(|(a, b)| a..=b),
        scales: (Scale::Even, Scale::Decades),
        ..PlotContent::of_time("T_w", "s", Vec::new())
    };
    let mut entries = Vec::new();
    if !is_told {
        return (canvas.veiled(picture), entries);
    }
    for row in 1..map.places.len() {
        for column in 1..map.gains.len() {
            let (left, right) = (map.gains[column - 1], map.gains[column]);
            let cell = View {
                left: left.min(right),
                right: left.max(right),
                bottom: map.places[row - 1],
                top: map.places[row],
            };
            let corners = [(row - 1, column - 1), (row - 1, column), (row, column - 1), (row, column)];
            let mean = 0.25 * corners.iter().map(|&(row, column)| map.damping[row][column]).sum::<f64>();
            picture.shades.push((cell, shade(mean, palette)));
        }
    }
    let mut lines = |segments: Vec<[(f64, f64); 2]>, color: Color32, pattern: Pattern| {
        let ends = |(x, y): (f64, f64)| PlotPoint::new(x, y);
        let middle = segments.get(segments.len() / 2).map(|[from, _]| ends(*from));
        picture.segments.extend(segments.into_iter().map(|segment| (segment.map(ends), color, pattern)));
        middle
    };
    let mut labels = Vec::new();
    for (value, name) in LINES {
        let color = if value == 0.0 { palette.bad } else { palette.weak };
        labels.extend(lines(map.damped_by(value), color, Pattern::Full).map(|at| (at, name)));
    }
    entries
        .push(Entry { mark: Mark::Curve(Pattern::Full), color: palette.weak, name: "least ζ".to_owned() });
    for (level, name) in LEVELS {
        let pattern = if level == Level::One { Pattern::Dashed } else { Pattern::Dotted };
        if lines(map.bound_of(level), palette.warning, pattern).is_some() {
            entries.push(Entry { mark: Mark::Curve(pattern), color: palette.warning, name: name.to_owned() });
        }
    }
    if let Some(top) = map.places.last() {
        let middle = PlotPoint::new(0.5 * map.reach(), top - 0.06);
        labels.push((middle, "no washout"));
    }
    picture.labels = labels;
    entries.push(Entry { mark: Mark::Dot, color: palette.text, name: "the law, to be dragged".to_owned() });
    (canvas.veiled(picture), entries)
}

/// The ground where an oscillation is damped by so much.
fn shade(damping: f64, palette: &Palette) -> Color32 {
    if damping < 0.0 {
        palette.unstable_half
    } else {
        palette.good.gamma_multiply(0.04 + 0.5 * damping.min(1.0) as f32)
    }
}
