//! The law of feedback on the page: whether its loop is shown closed or open, and what is said of that.

use egui::containers::menu::MenuButton;
use egui::{Align, Button, Color32, Label, Layout, RichText, Sense, TextFormat, Ui, Vec2};

use super::curtain::Curtain;
use super::poles::{cross, out_of_sight, square};
use super::symbol::{Symbol, prose};
use super::theme::{self, Palette};
use crate::findings::{Findings, LeastGain};
use crate::flight::verdicts::handling_qualities::Level;
use crate::number::{eigenvalue, significant};
use crate::scenario::{Hidden, Lock, Page, Parameter, Scenario, Written, parameters};
use crate::words;

/// Height of the row that tells poles apart.
const ROW: f32 = 16.0;

/// Above the gains: whether the loop is shown closed or open, once there is one.
pub fn switch_ui(ui: &mut Ui, findings: &Findings, shows_open: &mut bool) {
    let palette = Palette::of(ui);
    let scenario = findings.scenario();
    if scenario.law.is_open(scenario.plane) {
        let text = words::feedback::NOTHING_FED_BACK;
        ui.label(RichText::new(text).font(theme::small()).color(palette.weak));
        return;
    }
    let choices = [
        (false, words::feedback::CLOSED, words::feedback::CLOSED_MEANING),
        (true, words::feedback::OPEN, words::feedback::OPEN_MEANING),
    ];
    ui.horizontal(|ui| {
        ui.label(RichText::new("Loop").font(theme::small()).color(palette.weak));
        Curtain::of(ui).lock_ui(ui, Lock::View, |ui| {
            for (is_open, name, meaning) in choices {
                let button = Button::selectable(*shows_open == is_open, name);
                let button = ui.add(button).accessible_name(format!("{name} loop"));
                if button.on_hover_text(meaning).clicked() {
                    *shows_open = is_open;
                }
            }
        });
    });
}

/// What came of the search for a least gain, of the scenario that it left.
#[derive(Debug)]
pub struct LeastGainSaid {
    scenario: Scenario,
    text: String,
}

impl LeastGainSaid {
    /// Brings a gain to the least with which its plane is at Level 1, or tells why none is.
    pub fn of(findings: &Findings, scenario: &mut Scenario, gain: &'static Parameter) -> Self {
        let found = findings.least_gain(gain, Level::One);
        if let Ok(LeastGain { gain: least, .. }) = &found {
            gain.set(scenario, *least);
        }
        let Written { symbol, unit, in_si, .. } = gain.written(scenario.convention());
        let shown = |value: f64| format!("{} {unit}", significant(value / in_si, 3)).trim_end().to_owned();
        let symbol = Symbol::parse(symbol).plain();
        let text = format!("{symbol}: {}", words::feedback::least_gain(&found, shown));
        Self { scenario: scenario.clone(), text }
    }
}

/// A list of gains, of which the least for Level 1 is looked for; gives the one that is chosen. What was found last stands below.
pub fn least_gain_ui(
    ui: &mut Ui,
    findings: &Findings,
    said: Option<&LeastGainSaid>,
) -> Option<&'static Parameter> {
    let curtain = Curtain::of(ui);
    let scenario = findings.scenario();
    if curtain.hides(Hidden::Levels) {
        return None;
    }
    let is_free =
        |p: &&'static Parameter| p.is_gain() && p.is_shown(scenario, Page::Feedback) && curtain.frees(p);
    let mut chosen = None;
    let list = |ui: &mut Ui| {
        for gain in parameters().filter(is_free) {
            let palette = Palette::of(ui);
            let mut job = Symbol::parse(gain.symbol).job(theme::sizes(ui).symbol, palette.text);
            let name = TextFormat::simple(theme::small(), palette.weak);
            job.append(&format!("  {}", gain.name), 0.0, name);
            if ui.add(Button::new(job).frame_when_inactive(false)).accessible_name(gain.name).clicked() {
                chosen = Some(gain);
                ui.close();
            }
        }
    };
    let is_judged = scenario.task.is_some();
    ui.add_enabled_ui(is_judged, |ui| {
        let text = RichText::new(words::feedback::LEAST_GAIN).font(theme::small());
        let (button, _) = MenuButton::from_button(Button::new(text)).ui(ui, list);
        let button = button.accessible_name(words::feedback::LEAST_GAIN_NAME);
        button
            .on_hover_text(words::feedback::LEAST_GAIN_MEANING)
            .on_disabled_hover_text(words::feedback::NOT_JUDGED);
    });
    if let Some(said) =
        said.filter(|said| said.scenario.law == scenario.law && said.scenario.edited == scenario.edited)
    {
        ui.label(prose(&said.text, theme::small(), Palette::of(ui).text));
    }
    chosen
}

/// Which poles are which, above a map that has both; nothing where it has one kind.
pub fn legend_ui(ui: &mut Ui, findings: &Findings) {
    if findings.poles_of_other().is_empty() {
        return;
    }
    let palette = Palette::of(ui);
    let [shown, other] = words::feedback::legend(findings.is_opened(), findings.is_fed_back());
    let curtain = Curtain::of(ui);
    let row = Vec2::new(ui.available_width(), ROW);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        theme::make_low(ui, ROW);
        ui.spacing_mut().item_spacing.x = 5.0;
        let mut entry = |text: &str, draw: &dyn Fn(&Ui, egui::Pos2)| {
            let (place, _) = ui.allocate_exact_size(Vec2::splat(12.0), Sense::hover());
            draw(ui, place.center());
            ui.label(RichText::new(text).font(theme::small()).color(palette.weak));
            ui.add_space(8.0);
        };
        entry(shown, &|ui, at| cross(ui.painter(), at, 4.5, 2.0, palette.text));
        entry(other, &|ui, at| square(ui.painter(), at, palette.pinned));
        if curtain.hides(Hidden::Numbers) {
            return;
        }
        for mode in out_of_sight(findings.flown_modes()) {
            let name = mode.naming.name;
            let text = format!("{} {} 1/s", curtain.title(name), eigenvalue(mode.lambda));
            let text = RichText::new(text).font(theme::small()).color(palette.mode_text(name));
            ui.add(Label::new(text).truncate()).on_hover_text(words::feedback::OUT_OF_SIGHT);
        }
    });
}

/// Whether what is shown flies under a law, where there is one; a law that can't be analysed says so.
pub fn told_ui(ui: &mut Ui, findings: &Findings) {
    let palette = Palette::of(ui);
    let say = |ui: &mut Ui, text: &str, color: Color32| {
        ui.label(RichText::new(text).font(theme::small()).color(color));
    };
    if let Some(error) = findings.loop_problem() {
        say(ui, &words::feedback::problem(error), palette.bad);
    } else if findings.is_opened() && !findings.poles_of_other().is_empty() {
        say(ui, words::feedback::SHOWN_OPEN, palette.warning);
    } else if findings.law_flown().is_some() && !Curtain::of(ui).hides(Hidden::Verdicts) {
        let text =
            if findings.is_fed_back() { words::feedback::UNDER_LAW } else { words::feedback::WITH_FURTHER };
        say(ui, text, palette.weak);
    }
}

/// Says of what is drawn next that neither law nor further states change it, where they fly.
pub fn without_law_ui(ui: &mut Ui, findings: &Findings) {
    if findings.flies_otherwise() {
        let text = RichText::new(words::feedback::alone(findings.is_fed_back())).font(theme::small());
        ui.label(text.color(Palette::of(ui).warning));
    }
}
