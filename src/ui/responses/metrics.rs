//! The numbers a course asks of the motion on screen, as a table.

use egui::{Grid, RichText, ScrollArea, Ui};

use super::curves::units;
use crate::findings::change::NewTrim;
use crate::findings::{Extreme, Findings, Metrics, OutputMetrics};
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::response_metrics::StepMetrics;
use crate::number::significant;
use crate::scenario::{Hidden, Scenario, Source};
use crate::ui::copy;
use crate::ui::curtain::Curtain;
use crate::ui::symbol::{Symbol, prose};
use crate::ui::theme::{self, Palette};
use crate::words;

/// A table of every output, and what concerns the whole motion.
pub fn metrics_ui(ui: &mut Ui, findings: &Findings, pinned: Option<&Findings>) {
    ScrollArea::vertical().id_salt("metrics").auto_shrink(false).show(ui, |ui| {
        let scenario = findings.scenario();
        let Some(metrics) = findings.flown_metrics() else { return };
        let is_named = !Curtain::of(ui).hides(Hidden::Names);
        let of_pinned = pinned.and_then(Findings::flown_metrics).into_iter();
        let of_pinned = of_pinned
            .flat_map(|pinned| of_the_whole(pinned, scenario, is_named))
            .map(|line| format!("{line} (pinned)"));
        for line in of_the_whole(metrics, scenario, is_named).into_iter().chain(of_pinned) {
            let sentence = ui.label(prose(&line, theme::body(), Palette::of(ui).text));
            copy::offer(ui, sentence.rect, &|| line.clone());
        }
        if !Curtain::of(ui).hides_influence()
            && let Some(trim) = NewTrim::of(findings)
        {
            let text = words::new_trim::sentence(&trim, findings.scenario().convention());
            ui.label(prose(&text, theme::body(), Palette::of(ui).text));
        }
        ui.add_space(4.0);
        table_ui(ui, findings.scenario(), metrics);
        let about = if in_turbulence(findings.scenario()) {
            "r.m.s.: root mean square of the change over the time shown, the measure of a motion without end or pattern."
        } else {
            "Rise: from 10 % to 90 % of the steady value. Settled: within 2 % of it for good. Both only after a step, \
             and where every mode dies away."
        };
        let beyond = metrics.steady_is_beyond.then_some(words::metrics::STEADY_BEYOND);
        for text in beyond.into_iter().chain([about]) {
            ui.label(RichText::new(text).font(theme::small()).color(Palette::of(ui).weak));
        }
    });
}

/// Whether the air is irregular: then only averages say something of the aircraft.
fn in_turbulence(scenario: &Scenario) -> bool {
    scenario.disturbance.choices[scenario.plane].source == Source::Turbulence
}

/// Metrics of the whole motion, a sentence each; where modes have no names, without those of one mode.
fn of_the_whole(metrics: &Metrics, scenario: &Scenario, is_named: bool) -> Vec<String> {
    let (plane, length) = (scenario.plane, scenario.length_unit());
    let digits = match plane {
        Plane::Longitudinal => 3,
        Plane::Lateral => 2,
    };
    let load = metrics.load_factor.map(|extreme| match extreme {
        Extreme::Peak { value, time } => words::metrics::largest_load_factor(plane, value, time, digits),
        Extreme::Beyond(value) => words::metrics::load_factor_beyond(plane, value, digits),
    });
    let swing = metrics
        .phugoid_swing
        .filter(|_| is_named)
        .map(|height| words::metrics::phugoid_swing(height, length, 3));
    let anticipation = metrics
        .control_anticipation
        .filter(|_| is_named)
        .map(|cap| words::metrics::control_anticipation(cap, 3));
    let banked = metrics.time_to_bank.map(|time| words::metrics::time_to_bank(time, 3));
    let lines = match plane {
        Plane::Longitudinal => [load, swing, anticipation],
        Plane::Lateral => [banked, load, None],
    };
    lines.into_iter().flatten().collect()
}

fn table_ui(ui: &mut Ui, scenario: &Scenario, metrics: &Metrics) {
    let palette = Palette::of(ui);
    let head = |ui: &mut Ui, text: &str| {
        ui.label(RichText::new(text).font(theme::semibold(theme::sizes(ui).small)).color(palette.weak));
    };
    let random = in_turbulence(scenario);
    let columns: &[&str] = if random { &["r.m.s."] } else { &["Steady", "Rise", "Settled", "Overshoot"] };
    let table = Grid::new("metrics").striped(true).spacing([18.0, 4.0]).show(ui, |ui| {
        for text in ["", "", "Peak", "at"].iter().chain(columns) {
            head(ui, text);
        }
        ui.end_row();
        for of_output in &metrics.outputs {
            let &OutputMetrics { output, extreme, steady, step, root_mean_square } = of_output;
            let (quantity, unit_symbol, unit) = units(output, scenario);
            let number = |si: Option<f64>| si.map_or_else(nothing, |si| significant(si / unit, 3));
            ui.label(Symbol::parse(quantity.symbol).job(theme::sizes(ui).symbol, palette.text))
                .accessible_name(quantity.name);
            ui.label(RichText::new(unit_symbol).font(theme::small()).color(palette.weak))
                .on_hover_text(quantity.name);
            let (most, time) = match extreme {
                Some(Extreme::Peak { value, time }) => {
                    (number(Some(value)), format!("{} s", significant(time, 3)))
                }
                Some(Extreme::Beyond(value)) => (format!("beyond {}", number(Some(value))), String::new()),
                None => (nothing(), String::new()),
            };
            ui.label(most);
            ui.label(time);
            if random {
                ui.label(number(root_mean_square));
            } else {
                ui.label(number(steady));
                step_ui(ui, step);
            }
            ui.end_row();
        }
    });
    copy::offer(ui, table.response.rect, &|| copied(scenario, metrics));
}

/// The table as a spreadsheet takes it, in the units on screen and with every digit.
fn copied(scenario: &Scenario, metrics: &Metrics) -> String {
    let random = in_turbulence(scenario);
    let columns: &[&str] =
        if random { &["r.m.s."] } else { &["steady", "rise [s]", "settled [s]", "overshoot [%]"] };
    let head: Vec<&str> = ["output", "unit", "peak", "at [s]"].iter().chain(columns).copied().collect();
    let row = |of_output: &OutputMetrics| {
        let &OutputMetrics { output, extreme, steady, step, root_mean_square } = of_output;
        let (quantity, unit_symbol, unit) = units(output, scenario);
        let cell = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
        let (most, time) = match extreme {
            Some(Extreme::Peak { value, time }) => (cell(Some(value / unit)), cell(Some(time))),
            Some(Extreme::Beyond(value)) => (format!("beyond {}", value / unit), String::new()),
            None => (String::new(), String::new()),
        };
        let rest = if random {
            vec![cell(root_mean_square.map(|value| value / unit))]
        } else {
            vec![
                cell(steady.map(|value| value / unit)),
                cell(step.and_then(|step| step.rise_time)),
                cell(step.map(|step| step.settling_time)),
                cell(step.map(|step| 100.0 * step.overshoot)),
            ]
        };
        let cells = [quantity.name.to_owned(), unit_symbol.to_owned(), most, time];
        let cells: Vec<String> = cells.into_iter().chain(rest).collect();
        copy::row(&cells.iter().map(String::as_str).collect::<Vec<_>>())
    };
    copy::row(&head) + &metrics.outputs.iter().map(row).collect::<String>()
}

/// What stands in a cell without a number.
fn nothing() -> String {
    "–".to_owned()
}

/// How fast a step is answered and how far over, in three cells.
fn step_ui(ui: &mut Ui, step: Option<StepMetrics>) {
    let seconds = |time: Option<f64>| time.map_or_else(nothing, |t| format!("{} s", significant(t, 3)));
    ui.label(seconds(step.and_then(|f| f.rise_time)));
    ui.label(seconds(step.map(|f| f.settling_time)));
    let overshoot = step.map(|f| f.overshoot);
    ui.label(overshoot.map_or_else(nothing, |share| format!("{} %", significant(100.0 * share, 3))));
}
