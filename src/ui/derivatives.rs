//! The sliders: one row a derivative, grouped by what it multiplies.

use egui::{Align, Button, Id, Layout, RichText, ScrollArea, Ui, UiBuilder, Vec2};

use super::number_field::number_field_ui;
use super::slider::ReferenceSlider;
use super::symbol::{Symbol, symbol_ui};
use super::theme::{self, Palette};
use crate::content::LengthUnit;
use crate::number::trimmed;
use crate::scenario::parameters::Group;
use crate::scenario::{PARAMETERS, Parameter, Scenario};

const SYMBOL_WIDTH: f32 = 58.0;
const FIELD_WIDTH: f32 = 68.0;
const RESET_WIDTH: f32 = 20.0;
const HELP_HEIGHT: f32 = 132.0;

/// How the rows are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// For a mouse, with the help card below.
    Dense,
    /// For fingers, without it.
    Touch,
}

/// Draws all groups; edits `scenario` in place. `explained` is the row that the help card speaks of.
pub fn derivatives_ui(ui: &mut Ui, scenario: &mut Scenario, rows: Rows, explained: &mut &'static str) {
    ui.horizontal(|ui| {
        theme::heading(ui, RichText::new("Derivatives").heading(), 2);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let reset = Button::new(RichText::new("Reset all").font(theme::small()));
            if ui.add_enabled(scenario.is_edited(), reset).clicked() {
                *scenario = scenario.with_reference_model();
            }
        });
    });
    let help = if rows == Rows::Dense { HELP_HEIGHT } else { 0.0 };
    let height = (ui.available_height() - help).max(120.0);
    ScrollArea::vertical()
        .id_salt("derivatives")
        .max_height(height)
        .auto_shrink([false, rows == Rows::Dense])
        .show(ui, |ui| {
            for group in Group::DERIVATIVES {
                ui.add_space(3.0);
                let title = RichText::new(group.text()).font(theme::semibold(11.5));
                theme::heading(ui, title.color(Palette::of(ui).weak), 3);
                for parameter in PARAMETERS.iter().filter(|p| p.group == group) {
                    if row_ui(ui, scenario, parameter, rows) {
                        *explained = parameter.key;
                    }
                }
            }
        });
    if rows == Rows::Dense
        && let Some(parameter) = Parameter::find(explained)
    {
        help_ui(ui, parameter);
    }
}

/// One row. Says whether the person is at it, with pointer or keyboard.
pub fn row_ui(ui: &mut Ui, scenario: &mut Scenario, parameter: &'static Parameter, rows: Rows) -> bool {
    let palette = Palette::of(ui);
    let length = scenario.aircraft.length_unit;
    let (in_si, unit) = (parameter.dimension.in_si(length), parameter.dimension.symbol(length));
    let si = parameter.get(scenario);
    let (value, reference) = (si / in_si, parameter.reference(scenario) / in_si);
    let range = parameter.range(scenario);
    let symbol = Symbol::parse(parameter.symbol);
    let name = format!("{} {}", parameter.name, symbol.plain());
    let shown = trimmed(value, 4);
    let mut new = None;
    let mut refusal = None;
    let mut at_it = false;

    let height = if rows == Rows::Touch { theme::TOUCH_HEIGHT } else { 28.0 };
    let row = ui.allocate_space(Vec2::new(ui.available_width(), height)).1;
    ui.scope_builder(UiBuilder::new().max_rect(row).layout(Layout::left_to_right(Align::Center)), |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let hovered = ui.rect_contains_pointer(row);
        if hovered {
            ui.painter().rect_filled(row, 4.0, palette.field);
        }
        symbol_ui(ui, &symbol, 16.0, palette.text, Some(SYMBOL_WIDTH));
        let unit_width = if length == LengthUnit::Metre { 44.0 } else { 66.0 };
        let rest = FIELD_WIDTH + unit_width + RESET_WIDTH + 5.0 * 4.0 + 8.0;
        let slider = ReferenceSlider {
            name: &name,
            value_text: format!("{shown} {unit}"),
            value,
            range: range.start() / in_si..=range.end() / in_si,
            reference,
        };
        let width = (ui.available_width() - rest).max(60.0);
        let (response, moved) = slider.show(ui, Vec2::new(width, height));
        at_it |= hovered || response.has_focus();
        new =
            moved.map(|value| if value == reference { parameter.reference(scenario) } else { value * in_si });

        let field = number_field_ui(
            ui,
            ui.scope_id().with(("number", parameter.key)),
            &format!("{name}, typed"),
            &shown,
            FIELD_WIDTH,
            |text| parameter.parse(scenario, text),
        );
        at_it |= field.response.has_focus();
        new = field.accepted.or(new);
        refusal = field.refusal;
        ui.allocate_ui_with_layout(
            Vec2::new(unit_width, height),
            Layout::left_to_right(Align::Center),
            |ui| {
                ui.set_min_width(unit_width);
                ui.label(RichText::new(unit).size(10.5).color(palette.weak));
            },
        );
        if si != parameter.reference(scenario) {
            let reset = ui.add(Button::new("↺").frame(false)).accessible_name(format!("Reset {name}"));
            if reset.on_hover_text("Back to the reference (Delete, or double-click the slider)").clicked() {
                new = Some(parameter.reference(scenario));
            }
        }
    });
    if let Some(refusal) = refusal {
        ui.label(RichText::new(format!("⚠ {refusal}")).font(theme::small()).color(palette.bad));
    }
    if let Some(value) = new
        && let Ok(value) = parameter.check(scenario, value)
    {
        parameter.set(scenario, value);
    }
    at_it
}

/// A number with its symbol and unit, without a slider: for the parameters of a disturbance.
pub fn compact_ui(ui: &mut Ui, scenario: &mut Scenario, parameter: &'static Parameter) {
    let palette = Palette::of(ui);
    let length = scenario.aircraft.length_unit;
    let (in_si, unit) = (parameter.dimension.in_si(length), parameter.dimension.symbol(length));
    let shown = trimmed(parameter.get(scenario) / in_si, 4);
    let field = ui
        .horizontal(|ui| {
            symbol_ui(ui, &Symbol::parse(parameter.symbol), 14.0, palette.text, None);
            let field = number_field_ui(
                ui,
                Id::unique(("disturbance", parameter.key)),
                &format!("{} in {unit}", parameter.name),
                &shown,
                44.0,
                |text| parameter.parse(scenario, text),
            );
            ui.label(RichText::new(unit).font(theme::small()).color(palette.weak));
            field
        })
        .inner;
    field.response.on_hover_text(format!("{} {}", parameter.meaning, parameter.sign));
    if let Some(refusal) = field.refusal {
        ui.label(RichText::new(format!("⚠ {refusal}")).font(theme::small()).color(palette.bad));
    }
    if let Some(value) = field.accepted {
        parameter.set(scenario, value);
    }
}

fn help_ui(ui: &mut Ui, parameter: &Parameter) {
    let palette = Palette::of(ui);
    ui.separator();
    let mut title = Symbol::parse(parameter.symbol).job(15.0, palette.text);
    title.append(
        &format!("  {}", parameter.name),
        0.0,
        egui::TextFormat::simple(theme::semibold(12.5), palette.text),
    );
    ui.label(title);
    for text in [parameter.meaning, parameter.sign] {
        ui.label(RichText::new(text).font(theme::small()).color(palette.weak));
    }
    ui.label(RichText::new(format!("From: {}", parameter.origin)).font(theme::small()).color(palette.weak));
}
