//! The response pane: which disturbance, how strong, and the motion that follows: over time, as phase portraits, over frequency,
//! in numbers, and a measure over a slider. Where a law feeds back, its loops too, and the map of its damping.

mod chart;
mod curves;
mod disturbance;
mod fraction;
mod frequency;
mod legend;
mod loops;
mod map;
mod metrics;
mod phase;
mod stack;
mod time;

use std::rc::Rc;
use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::{Button, Rect, RichText, Ui};
pub use time::height_for_a_room;

use super::chart::PlotContent;
use super::curtain::Curtain;
use super::derivatives::Rows;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::findings::Findings;
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::outputs::Output;
use crate::scenario::view::{ResponseView, Tab};
use crate::scenario::{Hidden, Lock, Quantity, Scenario};
use crate::words;

/// The plots as they are on screen: how a person has set them up is in [`ResponseView`].
#[derive(Debug, Default)]
pub struct Responses {
    /// What the rows of choosers leave free at their end.
    beside: Option<Rect>,
    time: time::TimePlots,
    phase: phase::PhasePlots,
    frequency: frequency::FrequencyPlots,
    loops: loops::LoopPlots,
    map: map::MapPlot,
    chart: chart::ChartPlot,
}

impl Responses {
    /// Heading and choosers; edits the disturbance in place. The modes of `findings` are those that can be flown alone.
    pub fn choosers_ui(
        &mut self,
        ui: &mut Ui,
        scenario: &mut Scenario,
        view: &mut ResponseView,
        findings: &Findings,
    ) {
        let modes = findings.flown_modes();
        let shown = tab_shown(view.tab, findings);
        let plane = scenario.plane;
        ui.horizontal_wrapped(|ui| {
            theme::heading(ui, RichText::new("Response to").heading(), 2);
            disturbance::disturbance_ui(ui, scenario, modes);
        });
        ui.horizontal_wrapped(|ui| {
            if Curtain::of(ui).locks(Lock::View) {
                ui.disable();
            }
            for tab in Tab::ALL.into_iter().filter(|tab| has(*tab, findings)) {
                if ui.selectable_label(shown == tab, words::view::tab(tab)).clicked() {
                    view.tab = tab;
                }
            }
            ui.add_space(8.0);
            match shown {
                Tab::Time => time::choosers_ui(ui, plane, &mut view.shown[plane], &mut view.split),
                Tab::Phase => phase::choosers_ui(ui, plane, &mut view.portraits[plane]),
                Tab::Frequency => frequency::choosers_ui(ui, plane, &mut view.frequency_of[plane]),
                Tab::Loop | Tab::Nyquist => loops::choosers_ui(ui, findings, &mut view.cuts_second[plane]),
                Tab::Map | Tab::Metrics => {}
                Tab::Chart => self.chart.choosers_ui(ui, scenario, &mut view.chart[plane], findings),
            }
            if matches!(shown, Tab::Time | Tab::Phase) {
                ui.checkbox(&mut view.nonlinear, "Nonlinear").on_hover_text(
                    "The six rigid-body equations, integrated, beside the linear model. Raise the factor × to see them part",
                );
            }
            let free = ui.available_rect_before_wrap();
            // Of several rows, the last.
            let row = Rect::from_x_y_ranges(free.x_range(), ui.cursor().y_range());
            self.beside = Some(row.with_min_x(row.left() + 8.0));
        });
    }

    /// Time under the pointer \[s\].
    pub fn hovered(&self) -> Option<f64> {
        self.time.hovered()
    }

    /// Forgets what the pointer was on: for frames in which the plots aren't drawn.
    pub fn leave(&mut self) {
        self.time.leave();
    }

    /// Where the cursor stands while the pointer is elsewhere \[s\].
    pub fn set_time(&mut self, time: f64) {
        self.time.played = Some(time).filter(|time| *time > 0.0);
    }

    /// Draws the motion over all the room there is; the map and the chart edit the scenario in place.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        (scenario, view): (&mut Scenario, &mut ResponseView),
        findings: &Rc<Findings>,
        pinned: Option<&Rc<Findings>>,
        rows: Rows,
    ) {
        let curtain = Curtain::of(ui);
        let is_told = !curtain.hides_values();
        let tab = tab_shown(view.tab, findings);
        if matches!(tab, Tab::Time | Tab::Phase | Tab::Metrics) && is_told {
            large_ui(ui, view, findings, rows);
        }
        let is_for_a_room = theme::is_for_a_room(ui);
        if findings.ground().is_some() && is_told && !is_for_a_room && matches!(tab, Tab::Time | Tab::Phase) {
            note_ui(ui, words::disturbance::BELOW_GROUND);
        }
        if let Some(end) = (view.shows_flight() && is_told).then(|| end_of_flight(findings)).flatten() {
            note_ui(ui, &end);
        }
        if view.shows_flight() && is_told && !is_for_a_room {
            let bites =
                findings.trajectory(true).map_or(Vec::new(), |flown| words::limits::sentences(flown.bites()));
            for sentence in bites {
                note_ui(ui, &sentence);
            }
        }
        let beside = self.beside.take();
        let canvas =
            Canvas { findings, pinned, view, palette: Palette::of(ui), curtain: &curtain, rows, beside };
        if tab != Tab::Time {
            self.time.leave();
        }
        match tab {
            Tab::Time => self.time.show(ui, canvas),
            Tab::Phase => self.phase.show(ui, canvas, self.time.played),
            Tab::Frequency => self.frequency.show(ui, canvas),
            Tab::Loop | Tab::Nyquist => self.loops.show(ui, canvas),
            Tab::Map => self.map.show(ui, canvas, scenario),
            Tab::Metrics if curtain.hides(Hidden::Numbers) => {
                ui.label(RichText::new(words::view::NUMBERS_HIDDEN).color(Palette::of(ui).weak));
            }
            Tab::Metrics => metrics::metrics_ui(ui, findings, pinned.map(Rc::as_ref)),
            Tab::Chart => self.chart.show(ui, canvas, scenario),
        }
    }
}

/// Whether a tab has something to show.
fn has(tab: Tab, findings: &Findings) -> bool {
    match tab {
        Tab::Loop | Tab::Nyquist => loops::input_shown(findings, false).is_some(),
        Tab::Map => findings.mapped_input(0).is_some(),
        Tab::Time | Tab::Phase | Tab::Frequency | Tab::Metrics | Tab::Chart => true,
    }
}

/// The tab on screen: without a law, the frequency response stands in for those of its loops.
fn tab_shown(chosen: Tab, findings: &Findings) -> Tab {
    if has(chosen, findings) { chosen } else { Tab::Frequency }
}

/// Where the motion is no small disturbance any more, and the nonlinear flight, where there is one.
fn large_ui(ui: &mut Ui, view: &mut ResponseView, findings: &Findings, rows: Rows) {
    let length = findings.scenario().length_unit();
    let Some(limit) =
        findings.flown_motion().and_then(|motion| words::small_disturbance::sentence(motion, length))
    else {
        return;
    };
    let is_drawn = matches!(view.tab, Tab::Time | Tab::Phase);
    let next =
        if is_drawn { "the linear curve goes on, faded" } else { "the numbers are of the time before" };
    let contents = |ui: &mut Ui| {
        note_ui(ui, &format!("{limit}; {next}."));
        if is_drawn && !view.nonlinear && findings.can_fly() && !theme::is_for_a_room(ui) {
            let offer = Button::new(RichText::new("Draw the nonlinear flight").font(theme::small()));
            view.nonlinear |= ui.add(offer).clicked();
        }
    };
    match rows {
        Rows::Dense => ui.horizontal_wrapped(contents),
        // In a row as high as a button the lines of the sentence would stand far apart.
        Rows::Touch => ui.vertical(contents),
    };
}

/// Why there is no nonlinear flight, or where it ends.
fn end_of_flight(findings: &Findings) -> Option<String> {
    let length = findings.scenario().length_unit();
    match findings.flight()? {
        Ok(flight) => {
            flight.stop.map(|stop| format!("Nonlinear flight ends: {}.", words::Told(&stop, length)))
        }
        Err(error) => Some(format!("No nonlinear flight: {}.", words::Told(error, length))),
    }
}

/// What a tab draws, and where.
#[derive(Clone, Copy, Debug)]
struct Canvas<'a> {
    findings: &'a Rc<Findings>,
    /// Those of the pinned state.
    pinned: Option<&'a Rc<Findings>>,
    view: &'a ResponseView,
    palette: &'static Palette,
    /// What isn't shown.
    curtain: &'a Arc<Curtain>,
    rows: Rows,
    /// Where the legend goes if it fits.
    beside: Option<Rect>,
}

/// The key of pictures: they stay the same as long as it does.
#[derive(Clone, Debug)]
struct CacheKey {
    findings: Rc<Findings>,
    pinned: Option<Rc<Findings>>,
    nonlinear: bool,
    palette: &'static Palette,
    curtain: Arc<Curtain>,
}

impl CacheKey {
    fn of(canvas: Canvas<'_>) -> Self {
        let Canvas { findings, pinned, view, palette, curtain, .. } = canvas;
        let (nonlinear, curtain) = (view.shows_flight(), curtain.clone());
        Self { findings: findings.clone(), pinned: pinned.cloned(), nonlinear, palette, curtain }
    }
}

impl Canvas<'_> {
    /// A picture as it may be shown.
    fn veiled(&self, picture: PlotContent) -> PlotContent {
        if self.curtain.hides(Hidden::Curves) {
            picture.without_curves()
        } else {
            PlotContent { is_silent: self.curtain.hides(Hidden::Numbers), ..picture }
        }
    }
}

/// The very same findings: what follows from a scenario is found once.
impl PartialEq for CacheKey {
    fn eq(&self, other: &Self) -> bool {
        let same_pinned = match (&self.pinned, &other.pinned) {
            (Some(one), Some(other)) => Rc::ptr_eq(one, other),
            (one, other) => one.is_none() && other.is_none(),
        };
        Rc::ptr_eq(&self.findings, &other.findings)
            && same_pinned
            && self.nonlinear == other.nonlinear
            && self.palette == other.palette
            && self.curtain == other.curtain
    }
}

/// What was made of `key`; it is made again only where the key has changed.
fn kept<K: PartialEq, T>(held: &mut Option<(K, T)>, key: K, make: impl FnOnce() -> T) -> &mut T {
    if held.as_ref().is_some_and(|(of, _)| *of != key) {
        *held = None;
    }
    let (_, made) = held.get_or_insert_with(|| (key, make()));
    made
}

/// A line that says what is the matter.
fn note_ui(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).font(theme::small()).color(Palette::of(ui).bad));
}

/// A chooser of one output, by its id and its name.
fn output_ui(ui: &mut Ui, id: &str, name: &str, plane: Plane, output: &mut Output) {
    let now = Quantity::of(*output);
    let chooser = egui::ComboBox::from_id_salt(("output", id)).width(56.0).selected_text(symbol(ui, now));
    let chooser = chooser.show_ui(ui, |ui| {
        for &other in Output::of(plane) {
            let quantity = Quantity::of(other);
            let choice = ui.selectable_label(*output == other, line(ui, quantity));
            if choice.accessible_name(plain_line(quantity)).clicked() {
                *output = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, name, now.name);
}

/// A quantity's symbol, typeset.
fn symbol(ui: &Ui, quantity: Quantity) -> LayoutJob {
    Symbol::parse(quantity.symbol).job(theme::sizes(ui).inline_symbol, Palette::of(ui).text)
}

/// A quantity's symbol and its name.
fn line(ui: &Ui, quantity: Quantity) -> LayoutJob {
    let mut line = symbol(ui, quantity);
    let name = TextFormat::simple(theme::body(), Palette::of(ui).text);
    line.append(&format!(" · {}", quantity.name), 0.0, name);
    line
}

/// The same for screen readers.
fn plain_line(quantity: Quantity) -> String {
    format!("{} · {}", Symbol::parse(quantity.symbol).plain(), quantity.name)
}

#[cfg(test)]
mod tests {
    use super::kept;

    #[test]
    fn what_is_kept_is_made_again_when_its_key_changes_and_only_then() {
        let (mut held, mut made) = (None, 0);
        let keys = ["a", "a", "b", "b", "a"];
        let given = keys.map(|key| {
            *kept(&mut held, key, || {
                made += 1;
                key
            })
        });
        assert_eq!((given, made), (keys, 3));
    }
}
