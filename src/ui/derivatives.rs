//! The sliders: one row a derivative, grouped by what it multiplies.

use std::ops::RangeInclusive;

use egui::{
    Align, Button, Id, Label, Layout, Response, RichText, ScrollArea, Sense, Stroke, TextWrapMode, Ui,
    UiBuilder, Vec2,
};

use super::curtain::{Curtain, locked};
use super::explanation::{explained_by_tap, texts_ui, title_ui};
use super::follows::follows;
use super::number_field::{NumberField, number_field_ui};
use super::slider::ReferenceSlider;
use super::slider_search::{Filter, elsewhere, is_listed, search_ui};
use super::symbol::{Symbol, prose, symbol_ui};
use super::theme::{self, Palette};
use super::{copy, finger, influence, room, slider_search};
use crate::content::LengthUnit;
use crate::findings::{Findings, RowSensitivity};
use crate::flight::feedback::Law;
use crate::key::Keyed as _;
use crate::number::trimmed;
use crate::scenario::parameters::Group;
use crate::scenario::{Hidden, Lock, Page, Parameter, Scenario, Stage, Written, parameters};
use crate::words;

const SYMBOL_WIDTH: f32 = 52.0;
const FIELD_WIDTH: f32 = 68.0;
const RESET_WIDTH: f32 = 20.0;
const RESET_ALL: &str = "Reset all";
/// A narrower row of pages has a second line.
const SLIM: f32 = 330.0;
const RESET_ALL_WIDTH: f32 = 66.0;
/// Room for as many modes as there can be: a slider must not change its length where two roots meet.
const BARS_WIDTH: f32 = 4.0 * influence::BAR_WIDTH;
const COMPACT_FIELD: f32 = 44.0;
/// Of a row for a mouse, and of the field in it: low, so that the knobs are in sight below the coefficients.
const ROW_HEIGHT: f32 = 27.0;
const LOW_FIELD: f32 = 22.0;
/// Of the field below a unit.
const LOWEST_FIELD: f32 = 13.0;
/// In less height what stands above the sliders scrolls with them.
const ROOMY: f32 = 620.0;
/// Room for eight lines; a longer card scrolls.
const HELP_HEIGHT: f32 = 168.0;

/// How the rows are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// For a mouse, with the help card below.
    Dense,
    /// For fingers, without it.
    Touch,
}

/// Which sliders are on screen.
#[derive(Debug)]
pub struct Chosen<'a> {
    /// The page.
    pub page: &'a mut Page,
    /// Only those whose symbol or name has this in it, or what is said of them.
    pub search: &'a mut String,
    /// Only those that are offered.
    pub stage: &'a Stage,
    /// Key of a slider that was asked for elsewhere: it is brought into sight and gets the keyboard.
    pub asked: Option<&'static str>,
    /// Becomes true where the equations are asked for.
    pub equations: &'a mut bool,
    /// Becomes the slider over which something is to be charted.
    pub chart: &'a mut Option<&'static Parameter>,
}

/// Draws the pages and the groups of the one on screen; edits `scenario` in place.
///
/// Gives the key of the row that the person is at, with pointer or keyboard. A page that has no slider because nothing follows from
/// the scenario keeps those of the `last` findings from which something did, dimmed. What stands `above` the sliders scrolls with them
/// where there is little room.
pub fn derivatives_ui(
    ui: &mut Ui,
    scenario: &mut Scenario,
    Chosen { page, search, stage, asked, equations, chart }: Chosen<'_>,
    rows: Rows,
    (findings, last): (&Findings, &Findings),
    above: impl FnOnce(&mut Ui),
) -> Option<&'static str> {
    let is_slim = ui.available_width() < SLIM;
    let row = |ui: &mut Ui| {
        ui.spacing_mut().button_padding.x = 6.0;
        ui.spacing_mut().item_spacing.x = 2.0;
        Curtain::of(ui).lock_ui(ui, Lock::View, |ui| {
            for other in Page::ALL.into_iter().filter(|page| page.is_of(scenario)) {
                ui.selectable_value(page, other, words::sliders::page(other));
            }
        });
        if is_slim {
            reset_all_ui(ui, scenario);
        } else {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| reset_all_ui(ui, scenario));
        }
    };
    if is_slim {
        ui.horizontal_wrapped(row);
    } else {
        ui.horizontal(row);
    }
    let is_hidden = |wanted| !is_listed(wanted, scenario, *page, Filter { search, stage });
    if asked.and_then(Parameter::find).is_some_and(is_hidden) {
        search.clear();
    }
    *equations = search_ui(ui, search);
    let mut above = Some(above);
    if rows == Rows::Dense
        && ui.available_height() > ROOMY
        && let Some(above) = above.take()
    {
        above(ui);
    }
    let help = if rows == Rows::Dense { HELP_HEIGHT } else { 0.0 };
    let height = (ui.available_height() - help).max(120.0);
    let mut touched = None;
    let name = ("derivatives", page.key(), scenario.plane.key());
    let area = ScrollArea::vertical().max_height(height).auto_shrink([false, rows == Rows::Dense]);
    finger::scroll_area_ui(ui, name, area, |ui| {
        if rows == Rows::Dense {
            ui.spacing_mut().item_spacing.y = 0.0;
        }
        if let Some(above) = above.take() {
            above(ui);
        }
        let filter = Filter { search, stage };
        let listed = |scenario: &Scenario| parameters().any(|p| is_listed(p, scenario, *page, filter));
        if listed(scenario) {
            touched = groups_ui(ui, scenario, (*page, filter), rows, findings, (asked, chart));
        } else if parameters().any(|p| p.is_shown(scenario, *page)) || !listed(last.scenario()) {
            let text = if search.trim().is_empty() {
                let has_any = parameters().any(|p| p.is_shown(scenario, *page));
                if has_any { words::sliders::NOT_OFFERED } else { words::sliders::NONE }.to_owned()
            } else {
                let elsewhere = elsewhere(scenario, *page, filter);
                let equations = slider_search::equations(search).map(str::to_owned);
                let sentences = [Some(words::sliders::no_match(search.trim())), equations.or(elsewhere)];
                sentences.into_iter().flatten().collect::<Vec<_>>().join(" ")
            };
            ui.label(RichText::new(text).font(theme::small()));
        } else {
            ui.disable();
            groups_ui(ui, &mut last.scenario().clone(), (*page, filter), rows, last, (None, &mut None));
        }
        // It shrinks to what it holds, and so knows nothing of the room that is left.
        room::note(ui, ui.min_rect().height() - height);
    });
    touched
}

/// The groups of a page with their rows, as far as the search leaves them; gives the key of the row that the person is at.
fn groups_ui(
    ui: &mut Ui,
    scenario: &mut Scenario,
    (page, filter): (Page, Filter<'_>),
    rows: Rows,
    findings: &Findings,
    (asked, chart): (Option<&'static str>, &mut Option<&'static Parameter>),
) -> Option<&'static str> {
    let mut touched = None;
    for group in Group::DERIVATIVES {
        let shown = |p: &&Parameter| p.group == group && is_listed(p, scenario, page, filter);
        let group_rows: Vec<&'static Parameter> = parameters().filter(shown).collect();
        if group_rows.is_empty() {
            continue;
        }
        ui.add_space(4.0);
        group_ui(ui, scenario, group, &group_rows);
        for parameter in group_rows {
            let is_asked = asked == Some(parameter.key);
            if row_ui(ui, scenario, parameter, rows, findings, (is_asked, chart)) {
                touched = Some(parameter.key);
            }
        }
    }
    touched
}

/// All sliders back.
fn reset_all_ui(ui: &mut Ui, scenario: &mut Scenario) {
    let text = if ui.available_width() < RESET_ALL_WIDTH { "↺" } else { RESET_ALL };
    let reset = Button::new(RichText::new(text).font(theme::small()));
    let can = (scenario.is_edited() || scenario.law != Law::default()) && !Curtain::of(ui).locks(Lock::All);
    let reset = ui.add_enabled(can, reset).accessible_name(RESET_ALL);
    if reset.on_hover_text("All sliders back to their references").clicked() {
        *scenario = scenario.with_reference_model();
    }
}

/// The name of a group, and its reset where something in it has been edited.
fn group_ui(ui: &mut Ui, scenario: &mut Scenario, group: Group, rows: &[&'static Parameter]) {
    // For a finger as high as its reset from the start: it would push what is under the finger down.
    let height = if theme::is_for_fingers(ui) { ui.spacing().interact_size.y } else { 16.0 };
    let row = Vec2::new(ui.available_width(), height);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().button_padding.y = 0.0;
        theme::make_low(ui, 16.0);
        let title = RichText::new(words::sliders::group(group)).font(theme::semibold(theme::sizes(ui).small));
        theme::heading(ui, title.color(Palette::of(ui).weak), 3);
        let curtain = Curtain::of(ui);
        let free = || rows.iter().filter(|parameter| !curtain.locks_parameter(parameter));
        if free().any(|parameter| parameter.is_edited(scenario)) {
            let reset = theme::bare_button(ui, true, Button::new(RichText::new("↺").font(theme::small())));
            let reset = reset.accessible_name(format!("Reset the group {}", words::sliders::group(group)));
            if reset.on_hover_text("All of this group back to the reference").clicked() {
                for parameter in free() {
                    parameter.reset(scenario);
                }
            }
        }
    });
}

/// A parameter as its row shows it, in shown units.
struct Row {
    parameter: &'static Parameter,
    symbol: &'static str,
    name: String,
    value: f64,
    /// The value in words.
    shown: String,
    reference: f64,
    range: RangeInclusive<f64>,
    /// The part of it that exists, where that is not all.
    exists: Option<RangeInclusive<f64>>,
    /// What knobs and flight condition have made of the value.
    in_effect: Option<f64>,
    in_si: f64,
    unit: &'static str,
    unit_width: f32,
    height: f32,
}

impl Row {
    fn of(scenario: &Scenario, parameter: &'static Parameter, rows: Rows, findings: &Findings) -> Self {
        let convention = scenario.convention();
        let Written { symbol, unit, in_si, .. } = parameter.written(convention);
        let value = parameter.get(scenario) / in_si;
        let range = parameter.range(scenario);
        let in_effect = findings.coefficients().and_then(|c| parameter.in_effect(scenario, c));
        Self {
            parameter,
            symbol,
            name: format!("{} {}", parameter.name, Symbol::parse(symbol).plain()),
            value,
            shown: trimmed(value, 4),
            reference: parameter.reference(scenario) / in_si,
            range: range.start() / in_si..=range.end() / in_si,
            exists: findings
                .existing_range(parameter)
                .map(|range| range.start() / in_si..=range.end() / in_si),
            in_effect: in_effect.map(|si| si / in_si),
            in_si,
            unit,
            // Units of gains are long in metres too.
            unit_width: if convention.length == LengthUnit::Metre && parameter.page != Some(Page::Feedback) {
                44.0
            } else {
                66.0
            },
            height: if rows == Rows::Touch { theme::TOUCH_HEIGHT } else { ROW_HEIGHT },
        }
    }

    /// The slider over all the room that the rest of the row leaves; gives the value that it is set to \[SI\].
    fn slider_ui(&self, ui: &mut Ui, scenario: &Scenario, findings: &Findings) -> (Response, Option<f64>) {
        let Self { unit, shown, .. } = self;
        let rest = FIELD_WIDTH + self.unit_width + BARS_WIDTH + RESET_WIDTH + 6.0 * 4.0 + 8.0;
        let slider = ReferenceSlider {
            name: &self.name,
            value_text: match self.in_effect {
                Some(moved) => format!("{shown} {unit}, {} in effect", trimmed(moved, 4)),
                None => format!("{shown} {unit}").trim_end().to_owned(),
            },
            value: self.value,
            range: self.range.clone(),
            reference: self.reference,
            exists: self.exists.clone(),
            in_effect: self.in_effect,
        };
        let width = (ui.available_width() - rest).max(60.0);
        let (mut response, moved) = slider.show(ui, Vec2::new(width, self.height));
        if response.has_focus()
            && let Some(follows) = follows(findings, &Curtain::of(ui), self.sensitivity(findings))
        {
            let told = format!("{}: {follows}", slider.value_text);
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(told));
        }
        if let Some(moved) = self.in_effect {
            let moved = trimmed(moved, 4);
            response = response
                .on_hover_text(format!("{moved} with the knobs and the flight condition as they are"));
        }
        // The reference itself, to the last bit.
        let in_si = |value| {
            if value == self.reference { self.parameter.reference(scenario) } else { value * self.in_si }
        };
        (response, moved.map(in_si))
    }

    /// What knobs and flight condition have made of the value, where that is seen to be another.
    fn moved(&self) -> Option<String> {
        let differs = |moved: &f64| trimmed(*moved, 3) != trimmed(self.value, 3);
        self.in_effect.filter(differs).map(|moved| trimmed(moved, 3))
    }

    /// The value in effect, large, and its unit. Where knobs have moved it, what the slider sets stands small below the unit.
    fn value_ui(&self, ui: &mut Ui, scenario: &Scenario) -> NumberField {
        let sizes = theme::sizes(ui);
        let Some(moved) = self.moved() else {
            let field = self.field_ui(ui, scenario, (FIELD_WIDTH, sizes.name));
            self.column_ui(ui, self.unit_width, |ui| unit_ui(ui, self.unit));
            return field;
        };
        let color = Palette::of(ui).warning;
        self.column_ui(ui, FIELD_WIDTH, |ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let text = RichText::new(&moved).font(theme::semibold(sizes.name)).color(color);
                ui.label(text).on_hover_text(format!(
                    "In effect, as the knobs and the flight condition make it. The slider sets {}.",
                    self.shown
                ));
            });
        });
        let column = |ui: &mut Ui| {
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                if !self.unit.is_empty() {
                    unit_ui(ui, self.unit);
                }
                theme::make_low(ui, LOWEST_FIELD);
                self.field_ui(ui, scenario, (self.unit_width, sizes.unit))
            })
            .inner
        };
        self.column_ui(ui, self.unit_width, column)
    }

    /// The name and the value of what can't be moved, in the places of its slider and its field.
    fn locked_ui(&self, ui: &mut Ui, scenario: &Scenario) {
        let Self { parameter, shown, unit, .. } = self;
        let sizes = theme::sizes(ui);
        let (weak, text) = (Palette::of(ui).weak, Palette::of(ui).text);
        let rest = FIELD_WIDTH + self.unit_width + BARS_WIDTH + RESET_WIDTH + 6.0 * 4.0 + 8.0;
        let width = (ui.available_width() - rest).max(60.0);
        let told = format!("{}: {shown} {unit}", self.name);
        self.column_ui(ui, width, |ui| {
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            let name = RichText::new(parameter.name).font(theme::small()).color(weak);
            let label = locked(ui.label(name));
            ui.ctx().accesskit_node_builder(label.id, |node| {
                node.set_label(told.as_str());
                node.set_description(words::view::LOCKED);
            });
        });
        let value = self.moved().unwrap_or_else(|| trimmed(parameter.get(scenario) / self.in_si, 4));
        self.column_ui(ui, FIELD_WIDTH, |ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                locked(ui.label(RichText::new(value).size(sizes.name).color(text)));
            });
        });
        self.column_ui(ui, self.unit_width, |ui| unit_ui(ui, unit));
    }

    fn field_ui(&self, ui: &mut Ui, scenario: &Scenario, form: (f32, f32)) -> NumberField {
        let id = Id::unique(("number", self.parameter.key));
        let name = format!("{}, typed", self.name);
        number_field_ui(ui, id, &name, &self.shown, form, |text| self.parameter.parse(scenario, text))
    }

    /// A part of the row with a width of its own.
    fn column_ui<R>(&self, ui: &mut Ui, width: f32, contents: impl FnOnce(&mut Ui) -> R) -> R {
        let (place, _) = ui.allocate_exact_size(Vec2::new(width, self.height), Sense::hover());
        let builder = UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center));
        let ui = &mut ui.new_child(builder);
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        contents(ui)
    }

    /// How it moves each mode.
    fn bars_ui(&self, ui: &mut Ui, findings: &Findings) {
        let (bars, response) = ui.allocate_exact_size(Vec2::new(BARS_WIDTH, self.height), Sense::hover());
        let curtain = Curtain::of(ui);
        if let Some(row) = self.sensitivity(findings).filter(|_| !curtain.hides(Hidden::Reasons)) {
            influence::paint_bars(ui, row, findings.flown_modes(), bars);
            if let Some(words) = self.influence(findings, &curtain) {
                response.on_hover_text(words);
            }
        }
    }

    fn sensitivity<'a>(&self, findings: &'a Findings) -> Option<&'a RowSensitivity> {
        let sensitivities = findings.sensitivities(self.parameter.page?);
        sensitivities.iter().find(|row| row.key == self.parameter.key)
    }

    /// How it moves each mode, in words, where that isn't hidden.
    fn influence(&self, findings: &Findings, curtain: &Curtain) -> Option<String> {
        let row = self.sensitivity(findings).filter(|_| !curtain.hides_influence())?;
        Some(words::sensitivity::of_row(row, findings.flown_modes(), (self.in_si, self.unit)))
    }

    /// The way back, where the value has been edited.
    fn reset_ui(&self, ui: &mut Ui, scenario: &mut Scenario) {
        if self.parameter.is_edited(scenario) {
            let reset = theme::bare_button(ui, true, Button::new("↺"));
            let reset = reset.accessible_name(format!("Reset {}", self.name));
            if reset.on_hover_text("Back to the reference (Delete, or double-click the slider)").clicked() {
                self.parameter.reset(scenario);
            }
        }
    }
}

/// One row. Says whether the person is at it, with pointer or keyboard.
fn row_ui(
    ui: &mut Ui,
    scenario: &mut Scenario,
    parameter: &'static Parameter,
    rows: Rows,
    findings: &Findings,
    (is_asked, chart): (bool, &mut Option<&'static Parameter>),
) -> bool {
    let palette = Palette::of(ui);
    let row = Row::of(scenario, parameter, rows, findings);
    let place = ui.allocate_space(Vec2::new(ui.available_width(), row.height)).1;
    let builder = UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center));
    let drawn = ui.scope_builder(builder, |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let hovered = ui.rect_contains_pointer(place);
        if hovered {
            ui.painter().rect_filled(place, 4.0, palette.field);
        } else if rows == Rows::Dense {
            // A column of numbers reads better without boxes; a box shows under the mouse and with the focus.
            ui.visuals_mut().widgets.inactive.bg_stroke = Stroke::NONE;
        }
        theme::make_low(ui, LOW_FIELD);
        let symbol = Symbol::parse(row.symbol);
        let name = symbol_ui(ui, &symbol, theme::sizes(ui).row_symbol, palette.text, Some(SYMBOL_WIDTH));
        explained_by_tap(ui, &name, &row.name, |ui| {
            if rows == Rows::Touch {
                // There is no room for the card below the sliders, and no pointer that rests on the bars.
                title_ui(ui, parameter, scenario.convention());
                texts_ui(ui, parameter, scenario.convention());
                if let Some(influence) = row.influence(findings, &Curtain::of(ui)) {
                    ui.label(prose(&influence, theme::small(), palette.text));
                }
            }
            if !Curtain::of(ui).locks(Lock::View) && ui.button(words::chart::OVER_THIS).clicked() {
                *chart = Some(parameter);
            }
        });
        if Curtain::of(ui).locks_parameter(parameter) {
            row.locked_ui(ui, scenario);
            row.bars_ui(ui, findings);
            return (None, None, hovered);
        }
        let (slider, moved) = row.slider_ui(ui, scenario, findings);
        if is_asked {
            slider.request_focus();
            slider.scroll_to_me(Some(Align::Center));
        }
        let field = row.value_ui(ui, scenario);
        row.bars_ui(ui, findings);
        row.reset_ui(ui, scenario);
        let at_it = hovered || slider.has_focus() || field.response.has_focus();
        (field.accepted.or(moved), field.refusal, at_it)
    });
    let (new, refusal, at_it) = drawn.inner;
    copy::offer(ui, place, &|| {
        format!("{} = {} {}", Symbol::parse(row.symbol).plain(), row.shown, row.unit).trim_end().to_owned()
    });
    if let Some(refusal) = refusal {
        refusal.show(ui);
    }
    if let Some(value) = new.and_then(|value| parameter.check(scenario, value).ok()) {
        parameter.set_or_reset(scenario, value);
    }
    at_it
}

fn unit_ui(ui: &mut Ui, unit: &str) {
    let text = RichText::new(unit).size(theme::sizes(ui).unit).color(Palette::of(ui).weak);
    // A long one in two lines.
    ui.add(Label::new(text).wrap());
}

/// A number with its symbol and unit, without a slider: for the parameters of a disturbance.
pub fn compact_ui(ui: &mut Ui, scenario: &mut Scenario, parameter: &'static Parameter) {
    let palette = Palette::of(ui);
    let convention = scenario.convention();
    let Written { symbol, unit, in_si, .. } = parameter.written(convention);
    let shown = trimmed(parameter.get(scenario) / in_si, 4);
    let symbol = Symbol::parse(symbol);
    // Its width beforehand, so that a row that wraps keeps it together.
    let symbol_width = symbol.galley(ui, theme::sizes(ui).symbol, palette.text).size().x;
    let unit_width = ui.painter().layout_no_wrap(unit.to_owned(), theme::small(), palette.weak).size().x;
    let width = symbol_width + COMPACT_FIELD + unit_width + 3.0 * ui.spacing().item_spacing.x + 16.0;
    let size = Vec2::new(width, ui.spacing().interact_size.y);
    let is_locked = Curtain::of(ui).locks_parameter(parameter);
    let name =
        if unit.is_empty() { parameter.name.to_owned() } else { format!("{} in {unit}", parameter.name) };
    let row = ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        let about = symbol_ui(ui, &symbol, theme::sizes(ui).symbol, palette.text, None);
        if theme::is_for_fingers(ui) {
            explained_by_tap(ui, &about, &name, |ui| {
                title_ui(ui, parameter, convention);
                texts_ui(ui, parameter, convention);
            });
        }
        if is_locked {
            ui.disable();
        }
        let field = number_field_ui(
            ui,
            Id::unique(("disturbance", parameter.key)),
            &name,
            &shown,
            (COMPACT_FIELD, theme::sizes(ui).name),
            |text| parameter.parse(scenario, text),
        );
        ui.label(RichText::new(unit).font(theme::small()).color(palette.weak));
        field
    });
    // Over its symbol and unit too: "×" alone says little.
    let hover = format!("{name}: {} {}", parameter.meaning, parameter.sign);
    let hover = prose(&hover, theme::body(), palette.text);
    let field = row.inner;
    if !field.response.hovered() {
        row.response.on_hover_text(hover.clone());
    }
    field.response.on_hover_text(hover).on_disabled_hover_text(words::view::LOCKED);
    if let Some(refusal) = field.refusal {
        // In a row of its own, not between the fields.
        ui.end_row();
        refusal.show(ui);
        ui.end_row();
    }
    if let Some(value) = field.accepted {
        parameter.set(scenario, value);
    }
}
