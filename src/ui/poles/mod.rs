//! The pole map: eigenvalues in the complex plane, the slow ones a second time at their own scale.
//!
//! | file | in one line |
//! |---|---|
//! | `range` | what a map shows: fitted, or held where a person has brought it |
//! | `grid` | half planes, rays, arcs |
//! | `map` | one map and its labels |
//! | `marks`, `trail`, `boundaries` | what is drawn on it |
//! | `near` | what the pointer is near, and its card |
//! | `drag` | a pole under the hand |
//! | `choices` | what a person has asked for |
//!
//! A drag edits the scenario before anything of a frame is drawn ([`PoleMap::edit`]), so that sliders, poles and responses are
//! of one state.

mod boundaries;
mod choices;
mod drag;
mod grid;
mod map;
mod marks;
mod near;
mod range;
mod trail;

use std::rc::Rc;

use egui::accesskit::{Live, Role};
use egui::text::LayoutJob;
use egui::{
    Align2, Button, CursorIcon, Id, Key, Modifiers, Pos2, Rect, Response, RichText, Sense, Stroke,
    StrokeKind, TextFormat, Tooltip, Ui, UiBuilder, Vec2, WidgetInfo,
};
use nalgebra::Complex;

pub use choices::{Choices, shows_approximations, shows_levels};
pub use drag::DragPhase;
pub use marks::{both, cross, square};

use self::drag::{DraggedPole, Outcome, place};
use self::map::{CAPTION, Extras, Map, RememberedLabels};
use self::near::{Near, card_ui, near, nearest_pole, reach};
use self::range::MapRange;
use self::trail::Trail;
use super::chart::{Chart, PlotPoint};
use super::curtain::Curtain;
use super::symbol::Symbol;
use super::theme::{self, Palette};
use super::{arrow_keys, copy, finger};
use crate::few;
use crate::findings::Findings;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::locus::Locus;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::verdicts::level_boundaries::Boundary;
use crate::number::{eigenvalue, round_up};
use crate::scenario::view::Marks;
use crate::scenario::{Hidden, Page, Parameter, Scenario};
use crate::words;

/// Captions of the two maps, each for a wide, a narrow and the narrowest one.
const CAPTIONS: [[&str; 3]; 2] =
    [["All modes", "All modes", "All"], ["Slow modes, own scale", "Slow modes", "Slow"]];
/// A narrower map has room for its short caption only.
const NARROW: f32 = 230.0;
/// A narrower one for its shortest, beside the buttons.
const NARROWEST: f32 = 130.0;
/// A press of a zoom button or key.
const ZOOM_STEP: f64 = 1.5;
/// Fine steps of an arrow key over the height of a map; with Shift ten times as much.
const FINE_STEPS: f64 = 200.0;
const COARSE: f64 = 10.0;

/// What the pole map shows.
#[derive(Clone, Copy, Debug)]
pub struct PoleMapContent<'a> {
    /// What follows from the scenario on screen.
    pub findings: &'a Findings,
    /// The analysis of its plane.
    pub plane: &'a PlaneAnalysis,
    /// The modes of the pinned state.
    pub pinned: Option<&'a [Mode]>,
    /// What is marked beside the poles.
    pub marks: Marks,
    /// The slider that the person is at, and its path.
    pub locus: Option<(&'static Parameter, &'a Locus)>,
}

/// How a person looks at the poles.
#[derive(Debug, Default)]
pub struct PoleMap {
    /// What is asked for.
    pub choices: Choices,
    ranges: [MapRange; 2],
    trail: Trail,
    stood: [RememberedLabels; 2],
    held: Option<DraggedPole>,
    outcome: Option<Outcome>,
    /// Both maps as they were on screen in the last frame, where the pointer is.
    charts: Option<[Chart; 2]>,
}

fn ground_id(map: usize) -> Id {
    Id::unique(("pole map", map))
}

fn pole_id(mode: usize) -> Id {
    Id::unique(("pole", mode))
}

impl PoleMap {
    /// Moves a pole of `scenario` that is dragged or moved by key; `findings` are those on screen.
    pub fn edit(
        &mut self,
        ui: &Ui,
        scenario: &mut Scenario,
        findings: &Rc<Findings>,
        page: Page,
    ) -> DragPhase {
        if ui.input(|input| input.pointer.any_pressed() || input.events.iter().any(is_key_press)) {
            self.outcome = None;
        }
        let Some(charts) = self.charts else {
            return DragPhase::Away;
        };
        if self.held.is_some() {
            return self.drag(ui, scenario, charts);
        }
        if findings.scenario() != scenario {
            return DragPhase::Away;
        }
        let page = page_of_drag(findings, page);
        let modes = findings.flown_modes();
        for (map, chart) in charts.iter().enumerate() {
            let taken = ui.ctx().read_response(ground_id(map)).filter(Response::drag_started);
            let Some(at) = taken.and_then(|_| ui.input(|input| input.pointer.press_origin())) else {
                continue;
            };
            let Some((index, lower, _)) = nearest_pole(chart, modes, at, reach(ui)) else { continue };
            let mode = modes[index].clone();
            let movers = self.choices.free_movers(ui, findings, index, page);
            let pole = if lower { mode.lambda.conj() } else { mode.lambda };
            let grip = at - chart.position(pole);
            self.choices.subject = Some(mode.naming.name);
            let start = findings.clone();
            self.held = Some(DraggedPole { map, start, mode, movers, page, grip, lower, wanted: None });
            return DragPhase::Takes;
        }
        let focused = (0..modes.len()).find(|&i| ui.memory(|memory| memory.has_focus(pole_id(i))));
        if let Some((index, by)) = focused.and_then(|index| Some((index, stepped(ui)?))) {
            let mode = &modes[index];
            let chart = charts[usize::from(slow_modes(modes).contains(&index))];
            let step = round_step((chart.view.top - chart.view.bottom) / FINE_STEPS);
            let movers = self.choices.free_movers(ui, findings, index, page);
            let (moved, outcome) = place(findings, mode, mode.lambda + by * step, (&movers, page));
            self.choices.subject = Some(mode.naming.name);
            self.outcome = Some(outcome);
            if let Some(moved) = moved {
                *scenario = moved;
            }
        }
        DragPhase::Away
    }

    /// Goes on with a drag.
    fn drag(&mut self, ui: &Ui, scenario: &mut Scenario, charts: [Chart; 2]) -> DragPhase {
        let Some(held) = &mut self.held else { return DragPhase::Away };
        let (pointer, down, escape) = ui.input_mut(|input| {
            let escape = input.consume_key(Modifiers::NONE, Key::Escape);
            (input.pointer.interact_pos(), input.pointer.any_down(), escape)
        });
        let start = held.start.scenario();
        // Another aircraft, another plane, an edit by someone else: not the pole that was taken.
        let other = scenario.aircraft != start.aircraft || scenario.plane != start.plane;
        if escape && !other {
            scenario.edited = start.edited.clone();
            scenario.law = start.law;
            self.outcome = None;
        }
        if escape || other {
            self.held = None;
            return DragPhase::LetsGo;
        }
        if let Some(pointer) = pointer {
            let wanted = held.wanted(&charts[held.map], pointer);
            if held.wanted != Some(wanted) {
                held.wanted = Some(wanted);
                let (moved, outcome) = place(&held.start, &held.mode, wanted, (&held.movers, held.page));
                self.outcome = Some(outcome);
                if let Some(moved) = moved {
                    scenario.edited = moved.edited;
                    scenario.law = moved.law;
                }
            }
        }
        if down {
            return DragPhase::Holds;
        }
        self.held = None;
        DragPhase::LetsGo
    }

    /// Draws both maps side by side.
    pub fn show(&mut self, ui: &mut Ui, seen: PoleMapContent<'_>) {
        let palette = Palette::of(ui);
        let modes = &seen.plane.modes;
        self.trail.observe(ui, modes);
        let (rect, _) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
        copy::offer(ui, rect, &|| {
            let row = |mode: &Mode| {
                let name = words::mode::title(mode.naming.name);
                copy::row(&[name, &mode.lambda.re.to_string(), &mode.lambda.im.to_string()])
            };
            let rows: Vec<String> = modes.iter().map(row).collect();
            copy::row(&["mode", "re [1/s]", "im [rad/s]"]) + &rows.concat()
        });
        let (left, right) = places(ui, rect);
        let slow = slow_modes(modes);
        let fast: Vec<usize> = (0..modes.len()).filter(|i| !slow.contains(i)).collect();
        let all = in_sight(modes);
        let before = seen.pinned.unwrap_or_default();
        let slow_before = slow_modes(before).into_iter().map(|i| before[i].lambda).collect();
        let all_before = before.iter().map(|mode| mode.lambda).collect();
        let other = seen.findings.poles_of_other();
        let maps = [
            Map { captions: CAPTIONS[0], rect: left, ranged: all, home: fast, modes, pinned: all_before },
            Map {
                captions: CAPTIONS[1],
                rect: right,
                ranged: slow.clone(),
                home: slow,
                modes,
                pinned: slow_before,
            },
        ];
        let held_on = self.held.as_ref().map(|held| held.map);
        let charts: [Chart; 2] = std::array::from_fn(|i| {
            self.ranges[i].chart(ui, maps[i].wanted_view(), maps[i].plot_rect(), held_on == Some(i))
        });
        self.charts = Some(charts);

        let poles: Vec<Response> =
            maps.iter().zip(&charts).flat_map(|(map, chart)| poles_ui(ui, map, chart)).collect();
        let [_, of_other] = words::feedback::legend(seen.findings.is_opened(), seen.findings.is_fed_back());
        let curtain = Curtain::of(ui);
        let grounds: [Response; 2] = std::array::from_fn(|i| {
            let description = maps[i].describe(&curtain, self.trail.began(), (of_other, &other));
            self.ground_ui(ui, i, &maps[i], charts[i], modes, &description)
        });
        let boundaries = if seen.marks.levels { seen.findings.level_boundaries() } else { &[] };
        let pointed = self.pointed(ui, &grounds, &charts, &maps, &seen, boundaries);
        let focused = poles.iter().position(Response::has_focus).and_then(|k| {
            let order = maps.iter().zip(&charts).flat_map(|(map, chart)| on_map(map, chart));
            order.collect::<Vec<usize>>().get(k).copied()
        });
        let lit = match (&self.held, &pointed) {
            (Some(held), _) => modes.iter().position(|mode| mode.naming.name == held.mode.naming.name),
            (None, Some((_, Near::Pole(i)))) => Some(*i),
            _ => focused,
        };
        let sentence = self.outcome.as_ref().and_then(|outcome| outcome.sentence(&curtain));
        let taken =
            sentence.as_ref().map(|sentence| sentence_ui(ui, sentence, charts[0].rect, palette, false));
        for (i, (map, chart)) in maps.iter().zip(&charts).enumerate() {
            let extras = Extras {
                trail: &self.trail,
                approximations: seen.marks.approximations,
                boundaries,
                other: &other,
                held: self.held.as_ref().filter(|held| held.map == i),
                outcome: self.outcome.as_ref(),
                lit,
                inset: (i == 0).then_some(charts[1].view),
                taken: taken.filter(|_| i == 0),
            };
            map.draw(ui, palette, chart, &seen, extras, &mut self.stood[i]);
        }
        for response in poles.iter().filter(|response| response.has_focus()) {
            ui.painter().circle_stroke(response.rect.center(), 13.0, Stroke::new(2.0, palette.accent));
        }
        if let Some(sentence) = sentence {
            sentence_ui(ui, &sentence, charts[0].rect, palette, true);
        }
        if self.held.is_none() {
            let by_focus = poles.iter().find(|response| response.has_focus()).zip(focused);
            if let Some((map, near)) = pointed {
                let anchor = grounds[map].hover_pos().unwrap_or(grounds[map].rect.center());
                card(&grounds[map], Rect::from_center_size(anchor, Vec2::splat(24.0)), &seen, near);
            } else if let Some((response, index)) = by_focus {
                card(response, response.rect, &seen, Near::Pole(index));
            }
        }
    }

    /// What the pointer is near, and on which map.
    fn pointed<'a>(
        &mut self,
        ui: &Ui,
        grounds: &[Response; 2],
        charts: &[Chart; 2],
        maps: &[Map<'_>; 2],
        seen: &PoleMapContent<'a>,
        boundaries: &'a [Boundary],
    ) -> Option<(usize, Near<'a>)> {
        let map = grounds.iter().position(|ground| ground.hover_pos().is_some())?;
        let at = grounds[map].hover_pos()?;
        let here = maps[map].boundaries(boundaries);
        let near = near(&charts[map], seen, seen.marks.approximations, here, at, reach(ui))?;
        if let Near::Pole(index) = near {
            ui.set_cursor_icon(if self.held.is_some() { CursorIcon::Grabbing } else { CursorIcon::Grab });
            self.choices.subject = Some(seen.plane.modes[index].naming.name);
        }
        Some((map, near))
    }

    /// The ground of a map: what zooms and pans it, and the way back.
    fn ground_ui(
        &mut self,
        ui: &mut Ui,
        i: usize,
        map: &Map<'_>,
        chart: Chart,
        modes: &[Mode],
        description: &str,
    ) -> Response {
        let range = &mut self.ranges[i];
        let middle = chart.at(chart.rect.center());
        buttons_ui(ui, map, range, chart, middle);
        let ground = ui.interact(chart.rect, ground_id(i), Sense::click_and_drag());
        ground.widget_info(|| WidgetInfo::labeled(Role::Image, true, description));
        let pole = |at: Option<Pos2>| at.and_then(|at| nearest_pole(&chart, modes, at, reach(ui)));
        let pinch = finger::pinch(ui, &ground);
        // A finger on a pole has taken it by now, whichever way it goes.
        let held = self.held.is_some() || finger::works_on(ui, &ground);
        if let Some(pinch) = pinch {
            range.pinch(chart, pinch.center_pos, pinch.translation_delta, f64::from(pinch.zoom_delta));
        } else if let Some(at) = ground.hover_pos() {
            let factor = f64::from(ui.input(|input| input.zoom_delta()));
            if factor != 1.0 {
                range.zoom(chart, factor, chart.at(at));
            }
        }
        if ground.dragged() && held && self.held.is_none() && pinch.is_none() {
            range.pan(chart, chart.across(-ground.drag_motion()));
        }
        if ground.clicked() {
            match pole(ground.interact_pointer_pos()) {
                // A tap: its card stays until another place is tapped.
                Some((index, ..)) => ui.memory_mut(|memory| memory.request_focus(pole_id(index))),
                None => ground.request_focus(),
            }
        }
        if ground.double_clicked() && pole(ground.interact_pointer_pos()).is_none() {
            range.fit();
        }
        if ground.has_focus() {
            ui.painter().rect_stroke(
                chart.rect.expand(1.0),
                4.0,
                Stroke::new(1.0, Palette::of(ui).accent),
                StrokeKind::Outside,
            );
            ui.input(|input| {
                if input.key_pressed(Key::Plus) || input.key_pressed(Key::Equals) {
                    range.zoom(chart, ZOOM_STEP, middle);
                } else if input.key_pressed(Key::Minus) {
                    range.zoom(chart, 1.0 / ZOOM_STEP, middle);
                } else if input.key_pressed(Key::Num0) || input.key_pressed(Key::Home) {
                    range.fit();
                }
            });
        }
        ground
    }
}

/// The page whose parameters the drag of a pole moves: under a law the gains.
pub fn page_of_drag(findings: &Findings, page: Page) -> Page {
    if findings.flies_otherwise() { Page::Feedback } else { page }
}

fn is_key_press(event: &egui::Event) -> bool {
    matches!(event, egui::Event::Key { pressed: true, .. })
}

/// The steps that arrow keys ask for.
fn stepped(ui: &Ui) -> Option<Complex<f64>> {
    let steps = ui.input(|input| {
        let presses = |key| input.num_presses(key) as f64;
        let steps = Complex::new(
            presses(Key::ArrowRight) - presses(Key::ArrowLeft),
            presses(Key::ArrowUp) - presses(Key::ArrowDown),
        );
        if input.modifiers.shift { steps * COARSE } else { steps }
    });
    (steps.norm() > 0.0).then_some(steps)
}

/// Steps in round numbers, so that a pole goes along readable values.
fn round_step(step: f64) -> f64 {
    round_up(step.max(f64::MIN_POSITIVE))
}

/// Indices of the modes below the widest gap between one |λ| and the next: those that the fast ones would crowd together.
fn slow_modes(modes: &[Mode]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..modes.len()).collect();
    let size = |i: usize| modes[i].lambda.norm();
    few::sort_by(&mut sorted, |&a, &b| size(a).total_cmp(&size(b)));
    let gap = |pair: &[usize]| size(pair[1]) / size(pair[0]).max(f64::MIN_POSITIVE);
    let widest = sorted.windows(2).enumerate().max_by(|a, b| gap(a.1).total_cmp(&gap(b.1)));
    let count = widest.map_or(1, |(i, _)| i + 1);
    sorted.truncate(count);
    sorted
}

/// An actuator is so much faster than all else, beside which nothing else would be seen.
const MUCH_FASTER: f64 = 3.0;

/// Indices of the modes that the map of all is made for.
fn in_sight(modes: &[Mode]) -> Vec<usize> {
    let is_slow = |mode: &&Mode| !is_of_actuator(mode);
    let largest = modes.iter().filter(is_slow).map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
    let is_far = |mode: &Mode| is_of_actuator(mode) && mode.lambda.norm() > MUCH_FASTER * largest;
    (0..modes.len()).filter(|i| !is_far(&modes[*i])).collect()
}

/// The modes that lie beyond what the maps are made for.
pub fn out_of_sight(modes: &[Mode]) -> impl Iterator<Item = &Mode> {
    let seen = in_sight(modes);
    modes.iter().enumerate().filter(move |(i, _)| !seen.contains(i)).map(|(_, mode)| mode)
}

const fn is_of_actuator(mode: &Mode) -> bool {
    matches!(
        mode.naming.name,
        ModeName::ElevatorActuator | ModeName::Engine | ModeName::AileronActuator | ModeName::RudderActuator
    )
}

/// The modes that are reached by keyboard on a map as it is zoomed.
fn on_map(map: &Map<'_>, chart: &Chart) -> Vec<usize> {
    let visible = |i: &usize| chart.rect.contains(chart.position(map.modes[*i].lambda));
    map.home.iter().copied().filter(visible).collect()
}

/// The poles, one after the other, for the keyboard: the pointer finds them by the ground.
fn poles_ui(ui: &Ui, map: &Map<'_>, chart: &Chart) -> Vec<Response> {
    let pole = |i: usize| {
        let mode = &map.modes[i];
        let size = Vec2::splat(2.0 * marks::CROSS + 4.0);
        let place = Rect::from_center_size(chart.position(mode.lambda), size);
        let response = ui.interact(place, pole_id(i), Sense::focusable_noninteractive());
        let curtain = Curtain::of(ui);
        let title = curtain.title(mode.naming.name);
        let name = if curtain.hides(Hidden::Numbers) {
            format!("{title} pole")
        } else {
            format!("{title} pole, {} 1/s", eigenvalue(mode.lambda))
        };
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_description("Arrow keys move it, with Shift further; Escape ends.");
        });
        if response.has_focus() {
            arrow_keys::keep(ui, &response);
        }
        response
    };
    on_map(map, chart).into_iter().map(pole).collect()
}

/// Places of the two maps: beside each other, or for a room one above the other where that is larger.
fn places(ui: &Ui, rect: Rect) -> (Rect, Rect) {
    if theme::is_for_a_room(ui) && rect.height() > 1.1 * rect.width() {
        let split = rect.top() + (0.55 * rect.height()).round();
        let upper = Rect::from_min_max(rect.min, Pos2::new(rect.max.x, split - 3.0));
        return (upper, Rect::from_min_max(Pos2::new(rect.min.x, split + 3.0), rect.max));
    }
    let split = rect.left() + (0.6 * rect.width()).round();
    let left = Rect::from_min_max(rect.min, Pos2::new(split - 5.0, rect.max.y));
    (left, Rect::from_min_max(Pos2::new(split + 5.0, rect.min.y), rect.max))
}

/// Zoom in and out, and back where that is not where the map is.
fn buttons_ui(ui: &mut Ui, map: &Map<'_>, range: &mut MapRange, chart: Chart, middle: PlotPoint) {
    // A finger could not hit them: two fingers do as well.
    let for_mouse = !theme::is_for_fingers(ui) && !theme::is_for_a_room(ui);
    let row = Rect::from_min_size(map.rect.min, Vec2::new(map.rect.width(), CAPTION - 1.0));
    let layout = egui::Layout::right_to_left(egui::Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(row).layout(layout), |ui| {
        ui.spacing_mut().item_spacing.x = 1.0;
        let narrow = map.rect.width() < NARROWEST;
        let is_for_a_room = theme::is_for_a_room(ui);
        ui.spacing_mut().button_padding = Vec2::new(if narrow { 4.0 } else { 6.0 }, 0.0);
        ui.spacing_mut().interact_size.y = CAPTION - 1.0;
        let weak = Palette::of(ui).weak;
        let mut pressed = |text: &str, does: &str| {
            let button = Button::new(RichText::new(text).font(theme::small()).color(weak));
            let response = ui
                .add(button.frame_when_inactive(false))
                .accessible_name(format!("{does}, {}", map.captions[0]));
            response.on_hover_text(does).clicked()
        };
        if for_mouse && pressed("+", "Zoom in") {
            range.zoom(chart, ZOOM_STEP, middle);
        }
        if for_mouse && pressed("−", "Zoom out") {
            range.zoom(chart, 1.0 / ZOOM_STEP, middle);
        }
        if !range.is_fitted() && !is_for_a_room && pressed("Fit", "Show all again") {
            range.fit();
        }
    });
}

/// Why a pole can't follow, at the foot of a map; gives its place, and draws it only where `draw` says so.
fn sentence_ui(ui: &mut Ui, sentence: &str, map: Rect, palette: &Palette, draw: bool) -> Rect {
    let margin = Vec2::new(8.0, 5.0);
    let width = map.width() - 12.0 - 2.0 * margin.x;
    let mut job = LayoutJob::default();
    job.wrap.max_width = width;
    for (i, word) in sentence.split(' ').enumerate() {
        let text = |text: &str, job: &mut LayoutJob| {
            job.append(text, 0.0, TextFormat::simple(theme::small(), palette.warning));
        };
        text(if i > 0 { " " } else { "" }, &mut job);
        // A symbol may have a comma or a stop behind it.
        let symbol = word.trim_end_matches([',', '.', ':']);
        if symbol.contains('_') {
            Symbol::parse(symbol).append_to(&mut job, theme::sizes(ui).inline_symbol, palette.warning);
            text(&word[symbol.len()..], &mut job);
        } else {
            text(word, &mut job);
        }
    }
    let galley = ui.painter().layout_job(job);
    let size = galley.size() + 2.0 * margin;
    let place = Align2::LEFT_BOTTOM.anchor_size(map.left_bottom() + Vec2::new(6.0, -6.0), size);
    if draw {
        ui.painter().rect_filled(place, 6.0, palette.warning_ground);
        ui.painter().galley(place.min + margin, galley, palette.warning);
        let response = ui.interact(place, Id::unique("pole sentence"), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, sentence));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_live(Live::Polite));
    }
    place
}

/// A card beside `anchor`.
fn card(of: &Response, anchor: Rect, seen: &PoleMapContent<'_>, near: Near<'_>) {
    Tooltip::always_open(of.ctx.clone(), of.layer_id, of.id, anchor)
        .gap(6.0)
        .show(|ui| card_ui(ui, seen, near));
}
