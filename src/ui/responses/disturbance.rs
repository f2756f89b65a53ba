//! The choosers of the disturbance: what moves, in which shape, and the numbers that size it.

use egui::{Button, ComboBox, RichText, Ui};

use crate::flight::modes::Mode;
use crate::scenario::{Choice, Parameter, Scenario, Source};
use crate::ui::axis_range::round_up;
use crate::ui::derivatives;
use crate::ui::theme;

/// Draws the choosers; edits the disturbance in place. `modes` are those that can be flown alone.
pub fn disturbance_ui(ui: &mut Ui, scenario: &mut Scenario, modes: &[Mode]) {
    let plane = scenario.plane;
    let choice = scenario.disturbance.choice_mut(plane);
    source_ui(ui, choice, Source::of(plane));
    shape_ui(ui, choice);
    if choice.source == Source::OneMode {
        mode_ui(ui, choice, modes);
    }
    let keys = choice.parameters(plane);
    for parameter in keys.into_iter().chain(["times", "time"]).filter_map(Parameter::find) {
        derivatives::compact_ui(ui, scenario, parameter);
    }
    fit_ui(ui, scenario, modes);
}

/// Shows as much time as the slowest mode takes.
fn fit_ui(ui: &mut Ui, scenario: &mut Scenario, modes: &[Mode]) {
    let slowest = modes.iter().map(seen_in).fold(0.0, f64::max);
    let button = ui.add_enabled(slowest > 0.0, Button::new(RichText::new("Fit").font(theme::small())));
    let hover = "As much time as the slowest mode takes to be seen";
    if button.accessible_name("Fit the time shown to the slowest mode").on_hover_text(hover).clicked() {
        scenario.disturbance.sizes.time = slowest;
    }
}

/// A round time in which three periods of a mode, or most of its dying away or growing, are seen \[s\].
pub fn seen_in(mode: &Mode) -> f64 {
    let periods = mode.period().map_or(0.0, |period| 3.0 * period);
    let halves = 5.0 * mode.time_to_half().or(mode.time_to_double()).unwrap_or(60.0);
    let wanted = if periods > 0.0 { periods.max(halves.min(2.0 * periods)) } else { halves };
    round_up(wanted.clamp(2.0, 240.0))
}

fn source_ui(ui: &mut Ui, choice: &mut Choice, sources: &[Source]) {
    let text = choice.source.text();
    let chooser = ComboBox::from_id_salt("disturbance").selected_text(text).width(106.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for &source in sources {
            if ui.selectable_label(choice.source == source, source.text()).clicked() {
                choice.source = source;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Disturbance", text);
}

fn shape_ui(ui: &mut Ui, choice: &mut Choice) {
    let Some(shape) = choice.shape() else { return };
    let chooser = ComboBox::from_id_salt("shape").selected_text(shape.text()).width(82.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for &other in choice.source.shapes() {
            if ui.selectable_label(shape == other, other.text()).clicked() {
                *choice.shape_mut() = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Shape of the disturbance", shape.text());
}

fn mode_ui(ui: &mut Ui, choice: &mut Choice, modes: &[Mode]) {
    let index = choice.mode.min(modes.len().saturating_sub(1));
    let name = modes.get(index).map_or("", |mode| mode.naming.name.text());
    let chooser = ComboBox::from_id_salt("mode").selected_text(name).width(130.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for (i, mode) in modes.iter().enumerate() {
            if ui.selectable_label(i == index, mode.naming.name.text()).clicked() {
                choice.mode = i;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Mode flown alone", name);
}
