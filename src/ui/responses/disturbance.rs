//! The choosers of the disturbance: what moves, in which shape, and the numbers that size it.

use egui::{Button, ComboBox, RichText, Ui};

use crate::flight::modes::mode::Mode;
use crate::flight::motion::outputs::Output;
use crate::scenario::{Choice, Lock, Parameter, Scenario, Source};
use crate::ui::curtain::Curtain;
use crate::ui::derivatives;
use crate::ui::theme;
use crate::words;

/// Draws the choosers; edits the disturbance in place. `modes` are those that can be flown alone.
pub fn disturbance_ui(ui: &mut Ui, scenario: &mut Scenario, modes: &[Mode]) {
    let plane = scenario.plane;
    let law = scenario.law;
    let choice = &mut scenario.disturbance.choices[plane];
    let curtain = Curtain::of(ui);
    // A command that nothing listens to does nothing.
    let is_heard = |source: &Source| {
        source.command().is_none_or(|command| law.listens_to(plane, Output::commanded(command)))
    };
    curtain.lock_ui(ui, Lock::Disturbance, |ui| source_ui(ui, choice, Source::of(plane), is_heard));
    curtain.lock_ui(ui, Lock::Disturbance, |ui| shape_ui(ui, choice));
    if choice.source == Source::OneMode {
        curtain.lock_ui(ui, Lock::Disturbance, |ui| mode_ui(ui, choice, modes));
    }
    let keys = choice.parameters(plane);
    for parameter in keys.into_iter().chain(["times", "time"]).filter_map(Parameter::find) {
        derivatives::compact_ui(ui, scenario, parameter);
    }
    curtain.lock_ui(ui, Lock::Disturbance, |ui| follow_ui(ui, scenario));
}

/// Whether the time shown follows the motion: pressed out, it stays as it is; so it does once it is typed.
fn follow_ui(ui: &mut Ui, scenario: &mut Scenario) {
    let follows = &mut scenario.disturbance.follows;
    let button = ui.add(Button::selectable(*follows, RichText::new("Auto").font(theme::small())));
    let hover =
        "The time shown follows the slowest mode that this disturbance makes visible; a typed time stays";
    if button.accessible_name("Time shown follows the motion").on_hover_text(hover).clicked() {
        *follows = !*follows;
    }
}

fn source_ui(ui: &mut Ui, choice: &mut Choice, sources: &[Source], is_heard: impl Fn(&Source) -> bool) {
    let text = words::disturbance::source(choice.source);
    let chooser = ComboBox::from_id_salt("disturbance").selected_text(text).width(106.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for &source in sources {
            if choice.source != source && !is_heard(&source) {
                continue;
            }
            if ui.selectable_label(choice.source == source, words::disturbance::source(source)).clicked() {
                choice.source = source;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Disturbance", text);
}

fn shape_ui(ui: &mut Ui, choice: &mut Choice) {
    let Some(shape) = choice.shape() else { return };
    let chooser = ComboBox::from_id_salt("shape").selected_text(words::disturbance::shape(shape)).width(82.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for &other in choice.source.shapes() {
            if ui.selectable_label(shape == other, words::disturbance::shape(other)).clicked() {
                *choice.shape_mut() = other;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Shape of the disturbance", words::disturbance::shape(shape));
}

fn mode_ui(ui: &mut Ui, choice: &mut Choice, modes: &[Mode]) {
    let index = choice.mode.min(modes.len().saturating_sub(1));
    let curtain = Curtain::of(ui);
    let name = modes.get(index).map_or("", |mode| curtain.title(mode.naming.name));
    let chooser = ComboBox::from_id_salt("mode").selected_text(name).width(130.0);
    let chooser = chooser.show_ui(ui, |ui| {
        for i in curtain.order(modes) {
            if ui.selectable_label(i == index, curtain.title(modes[i].naming.name)).clicked() {
                choice.mode = i;
                ui.close();
            }
        }
    });
    theme::name_chooser(chooser, "Mode flown alone", name);
}
