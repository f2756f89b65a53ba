//! The numbers a course asks of the motion on screen.

use egui::{Grid, RichText, ScrollArea, Ui};

use super::studied::{Studied, units};
use crate::flight::aircraft::plane::Plane;
use crate::flight::motion::course::Course;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response_metrics::{
    StepFigures, control_anticipation, peak, phugoid_swing, root_mean_square, steady_output, step_figures,
    time_to_bank,
};
use crate::number::significant;
use crate::scenario::{START, Source};
use crate::ui::symbol::Symbol;
use crate::ui::theme::{self, Palette};

/// A table of every output, and what concerns the whole motion.
pub fn figures_ui(ui: &mut Ui, studied: Studied<'_>, ghost: Option<Studied<'_>>) {
    ScrollArea::vertical().id_salt("figures").auto_shrink(false).show(ui, |ui| {
        let mut lines = whole(studied);
        if let Some(ghost) = ghost {
            lines.extend(whole(ghost).into_iter().map(|line| format!("{line} (pinned)")));
        }
        for line in lines {
            ui.label(line);
        }
        ui.add_space(4.0);
        table_ui(ui, studied);
        let about = if in_turbulence(studied) {
            "r.m.s.: root mean square of the change over the time shown, the measure of a motion without end or pattern."
        } else {
            "Rise: from 10 % to 90 % of the steady value. Settled: within 2 % of it for good. Both only after a step, \
             and where every mode dies away."
        };
        ui.label(RichText::new(about).font(theme::small()).color(Palette::of(ui).weak));
    });
}

/// Whether the air is irregular: then only averages say something of the aircraft.
fn in_turbulence(studied: Studied<'_>) -> bool {
    studied.scenario.disturbance.choices[studied.plane()].source == Source::Turbulence
}

/// The values of an output as long as the disturbance is small.
fn small_values(studied: Studied<'_>, output: Output) -> Vec<f64> {
    let mut values = studied.motion.values(output);
    values.truncate(studied.small());
    values
}

/// What concerns the whole motion, as long as it is a small disturbance: a sentence each.
fn whole(studied: Studied<'_>) -> Vec<String> {
    let Studied { motion, scenario, .. } = studied;
    let random = in_turbulence(studied);
    // Let go or in one mode the disturbance is there from the first.
    let from = if scenario.disturbance.choices[studied.plane()].shape().is_some() { START } else { 0.0 };
    let course = course(studied);
    let row = |output: Output| output.row(&motion.model, &motion.forced);
    let mut lines = Vec::new();
    match studied.plane() {
        Plane::Longitudinal => {
            if let Some((time, load)) = peak(&course, &row(Output::NormalLoad)) {
                lines.push(format!(
                    "Largest change of load factor: {} g at {} s",
                    significant(load, 3),
                    significant(time, 3)
                ));
            }
            let swing = phugoid_swing(&motion.model, studied.modes, &motion.forced, &row(Output::Height));
            if let Some(swing) = swing.filter(|_| !random) {
                lines.push(format!("Phugoid, first swing of the height: {} m", significant(swing, 3)));
            }
            let elevator = scenario.disturbance.choices.longitudinal.source == Source::Elevator;
            let parameter =
                control_anticipation(&motion.model, studied.modes, &motion.forced, 0).filter(|_| elevator);
            if let Some(parameter) = parameter {
                lines.push(format!(
                    "Control anticipation parameter, from this response: {} rad/s² per g",
                    significant(parameter, 3)
                ));
            }
        }
        Plane::Lateral => {
            let banked = time_to_bank(&course, &row(Output::BankAngle), from);
            if let Some(time) = banked.filter(|_| !random) {
                lines.push(format!("30° of bank after {} s", significant(time, 3)));
            }
            if let Some((time, load)) = peak(&course, &row(Output::SideLoad)) {
                lines.push(format!(
                    "Largest lateral load factor: {} g at {} s",
                    significant(load, 2),
                    significant(time, 3)
                ));
            }
        }
    }
    lines
}

/// The motion of the time shown, as long as it is a small disturbance.
fn course(studied: Studied<'_>) -> Course<'_> {
    let motion = studied.motion;
    Course::new(&motion.model, &motion.forced, studied.modes, motion.experiment.grid.duration)
}

fn table_ui(ui: &mut Ui, studied: Studied<'_>) {
    let palette = Palette::of(ui);
    let motion = studied.motion;
    let course = course(studied);
    let amplitude = match motion.forced.forcings.first().map(|forcing| &forcing.input) {
        Some(Input::Step { amplitude, .. }) => Some(*amplitude),
        _ => None,
    };
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| significant(value, 3));
    let head = |ui: &mut Ui, text: &str| {
        ui.label(RichText::new(text).font(theme::semibold(theme::sizes(ui).small)).color(palette.weak));
    };
    let random = in_turbulence(studied);
    let columns: &[&str] = if random { &["r.m.s."] } else { &["Steady", "Rise", "Settled", "Overshoot"] };
    Grid::new("figures").striped(true).spacing([18.0, 4.0]).show(ui, |ui| {
        for text in ["", "", "Peak", "at"].iter().chain(columns) {
            head(ui, text);
        }
        ui.end_row();
        for &output in Output::of(studied.plane()) {
            let (quantity, unit_symbol, unit) = units(output, studied.scenario);
            let row = output.row(&motion.model, &motion.forced);
            let most = peak(&course, &row);
            ui.label(Symbol::parse(quantity.symbol).job(theme::sizes(ui).symbol, palette.text))
                .accessible_name(quantity.name);
            ui.label(RichText::new(unit_symbol).font(theme::small()).color(palette.weak))
                .on_hover_text(quantity.name);
            // What is largest where the linear model ends goes on to grow, nobody knows how far.
            let grows = course.small_until.is_some_and(|end| most.is_some_and(|(time, _)| time >= end));
            let least = if grows { "beyond " } else { "" };
            ui.label(format!("{least}{}", number(most.map(|(_, value)| value / unit))));
            let time = most.filter(|_| !grows).map(|(time, _)| format!("{} s", significant(time, 3)));
            ui.label(time.unwrap_or_default());
            if random {
                ui.label(number(root_mean_square(&small_values(studied, output)).map(|value| value / unit)));
                ui.end_row();
                continue;
            }
            let steady =
                amplitude.and_then(|size| steady_output(studied.modes, &row, &motion.forced, 0, size));
            let figures = steady.and_then(|steady| {
                step_figures(&motion.model, studied.modes, &motion.forced, &row, START, steady)
            });
            // Beside the motion this is rounding.
            let steady = steady.map(|value| {
                let size = most.map_or(0.0, |(_, most)| most.abs());
                if value.abs() <= 1e-9 * size { 0.0 } else { value }
            });
            ui.label(number(steady.map(|value| value / unit)));
            step_ui(ui, figures);
            ui.end_row();
        }
    });
}

/// How fast a step is answered and how far over, in three cells.
fn step_ui(ui: &mut Ui, figures: Option<StepFigures>) {
    let none = || "–".to_owned();
    let seconds = |time: Option<f64>| time.map_or_else(none, |t| format!("{} s", significant(t, 3)));
    ui.label(seconds(figures.and_then(|f| f.rise_time)));
    ui.label(seconds(figures.map(|f| f.settling_time)));
    let overshoot = figures.map(|f| f.overshoot);
    ui.label(overshoot.map_or_else(none, |share| format!("{} %", significant(100.0 * share, 3))));
}
