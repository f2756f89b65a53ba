//! The sliders that a scene offers, few and large.

use egui::{Align, Align2, Layout, Rect, Sense, Ui, UiBuilder, Vec2};

use crate::number::trimmed;
use crate::scenario::{Parameter, Part, Scenario, Stage, Written};
use crate::ui::curtain::Curtain;
use crate::ui::slider::ReferenceSlider;
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

/// No more of them are shown.
const MOST: usize = 4;
const ROW: f32 = 34.0;
/// From this width on two stand beside each other.
const BESIDE: f32 = 560.0;
const SYMBOL: (f32, f32) = (22.0, 66.0);
const VALUE: (f32, f32) = (16.0, 128.0);
const GAP: f32 = 18.0;

/// The sliders that a stage offers by name; of all of them none, which a room could not read.
pub fn offered(stage: &Stage, scenario: &Scenario) -> Vec<&'static Parameter> {
    if !stage.has(Part::Derivatives) {
        return Vec::new();
    }
    let named = stage.offered.iter().filter_map(|key| Parameter::find(key));
    named.filter(|parameter| parameter.applies(scenario)).take(MOST).collect()
}

/// Height that they need in a width.
pub fn sliders_height(count: usize, width: f32) -> f32 {
    count.div_ceil(across(width)) as f32 * ROW
}

fn across(width: f32) -> usize {
    if width >= BESIDE { 2 } else { 1 }
}

/// Draws them; gives the key of the one that the person is at.
pub fn sliders_ui(
    ui: &mut Ui,
    room: Rect,
    parameters: &[&'static Parameter],
    scenario: &mut Scenario,
) -> Option<&'static str> {
    let across = across(room.width()).min(parameters.len().max(1));
    let width = (room.width() + GAP) / across as f32 - GAP;
    let mut touched = None;
    for (number, parameter) in parameters.iter().enumerate() {
        let at = Vec2::new((number % across) as f32 * (width + GAP), (number / across) as f32 * ROW);
        let row = Rect::from_min_size(room.min + at, Vec2::new(width, ROW));
        if row_ui(ui, row, parameter, scenario) {
            touched = Some(parameter.key);
        }
    }
    touched
}

/// A slider with its symbol and its value. Says whether the person is at it.
fn row_ui(ui: &mut Ui, row: Rect, parameter: &'static Parameter, scenario: &mut Scenario) -> bool {
    let palette = Palette::of(ui);
    let Written { symbol, unit, in_si, .. } = parameter.written(scenario.convention());
    let value = parameter.get(scenario) / in_si;
    let shown = format!("{} {unit}", trimmed(value, 3)).trim_end().to_owned();
    let symbol = Symbol::parse(symbol);
    let galley = symbol.fitting(ui, SYMBOL.0, palette.text, SYMBOL.1 - 8.0);
    ui.painter().galley(row.left_center() - Vec2::new(0.0, 0.5 * galley.size().y), galley, palette.text);
    let font = theme::semibold(VALUE.0);
    ui.painter().text(row.right_center(), Align2::RIGHT_CENTER, &shown, font, palette.text);
    let middle = Rect::from_min_max(
        row.left_top() + Vec2::new(SYMBOL.1, 0.0),
        row.right_bottom() - Vec2::new(VALUE.1, 0.0),
    );
    let name = format!("{} {}", parameter.name, symbol.plain());
    if Curtain::of(ui).locks_parameter(parameter) {
        let place = ui.interact(row, egui::Id::unique(("locked for a room", parameter.key)), Sense::hover());
        place.widget_info(|| {
            egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, format!("{name}: {shown}"))
        });
        return false;
    }
    let range = parameter.range(scenario);
    let slider = ReferenceSlider {
        name: &name,
        value_text: shown,
        value,
        range: range.start() / in_si..=range.end() / in_si,
        reference: parameter.reference(scenario) / in_si,
        exists: None,
        in_effect: None,
    };
    let builder = UiBuilder::new()
        .id_salt(("slider for a room", parameter.key))
        .max_rect(middle)
        .layout(Layout::left_to_right(Align::Center));
    let (response, moved) = slider.show(&mut ui.new_child(builder), middle.size());
    if let Some(moved) = moved {
        if moved == slider.reference {
            parameter.reset(scenario);
        } else if let Ok(value) = parameter.check(scenario, moved * in_si) {
            parameter.set(scenario, value);
        }
    }
    response.hovered() || response.has_focus() || response.dragged()
}
