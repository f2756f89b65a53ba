//! The level of handling qualities as a whole, and for which class of aircraft and phase of flight it is judged.

use egui::{ComboBox, RichText, Ui};

use super::curtain::Curtain;
use super::mode_cards::tone;
use super::theme::{self, Palette};
use crate::findings::Findings;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::task::Task;
use crate::key::Keyed;
use crate::scenario::{Hidden, Lock};
use crate::words;

/// Shows the overall level of the aircraft, and lets a person choose the `task` it is judged for.
pub fn overall_level_ui(ui: &mut Ui, findings: &Findings, task: &mut Option<Task>) {
    let curtain = Curtain::of(ui);
    if curtain.hides(Hidden::Levels) {
        return;
    }
    // It names the mode that sets it, and on hover has its numbers.
    if let Some(overall) = findings.flown_level().filter(|_| !curtain.hides_sentences()) {
        let (color, _) = Palette::of(ui).verdict(overall.level.map_or(Stability::Unstable, tone));
        let text =
            RichText::new(words::verdict::overall(&overall)).font(theme::semibold(theme::sizes(ui).value));
        ui.label(text.color(color)).on_hover_text(words::verdict::sentence(overall.governing));
    }
    let choosers = |ui: &mut Ui| {
        // No wider than what they show, so that both stand in one row of a card.
        ui.spacing_mut().combo_width = 0.0;
        let mut class = task.map(|task| task.class);
        let shown = class.map_or("Levels: choose a class", words::verdict::class);
        choose(ui, "Class of aircraft", shown, &mut class, words::verdict::class_with_aircraft);
        let mut category = task.map(|task| task.category);
        if let Some(chosen) = category {
            let shown = words::verdict::category(chosen);
            choose(
                ui,
                "Category of flight phase",
                shown,
                &mut category,
                words::verdict::category_with_phases,
            );
        }
        if let Some(class) = class {
            let category = category.unwrap_or_else(|| Task::default().category);
            *task = Some(Task { class, category });
        }
    };
    curtain.lock_ui(ui, Lock::All, |ui| ui.horizontal_wrapped(choosers));
}

/// A list of values to choose from, named for a person who doesn't see it.
fn choose<T: Keyed>(
    ui: &mut Ui,
    name: &str,
    shown: &str,
    value: &mut Option<T>,
    words: impl Fn(T) -> &'static str,
) {
    let chooser = ComboBox::from_id_salt(name).selected_text(RichText::new(shown).font(theme::small()));
    let chooser = chooser.show_ui(ui, |ui| {
        for &choice in T::VALUES {
            ui.selectable_value(value, Some(choice), words(choice));
        }
    });
    theme::name_chooser(chooser, name, shown);
}
