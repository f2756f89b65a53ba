//! What the pointer is near on a map, and the card that tells of it.

use egui::{Pos2, RichText, Ui};
use nalgebra::Complex;

use super::{PoleMapContent, boundaries, marks};
use crate::flight::modes::approximations::Approximation;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::verdicts::level_boundaries::Boundary;
use crate::number::{eigenvalue, significant};
use crate::scenario::{Hidden, Parameter, Written};
use crate::ui::chart::Chart;
use crate::ui::curtain::Curtain;
use crate::ui::mode_cards::numbers_ui;
use crate::ui::symbol::{Symbol, prose};
use crate::ui::theme::{self, Palette};
use crate::words;

/// How far from a pole it can be taken, with a mouse and with a finger \[points\].
const REACH: (f32, f32) = (24.0, 32.0);
/// The same of a mark, which lies among poles, and of a path.
const MARK_REACH: f32 = 12.0;
const PATH_REACH: f32 = 9.0;

/// Something on the map.
#[derive(Clone, Copy, Debug)]
pub enum Near<'a> {
    /// A pole: the index of its mode.
    Pole(usize),
    /// The mark of an approximation, with its root.
    Approximation(&'a Approximation, Complex<f64>),
    /// A boundary of levels.
    Level(Boundary),
    /// A point of the path of a slider.
    Path {
        /// The slider.
        parameter: &'static Parameter,
        /// Its value there \[SI\].
        value: f64,
        /// The pole there.
        lambda: Complex<f64>,
        /// Whose it is.
        name: Option<ModeName>,
    },
}

/// How near counts as at a pole, for what the person points with.
pub fn reach(ui: &Ui) -> f32 {
    if ui.input(|input| input.any_touches()) { REACH.1 } else { REACH.0 }
}

/// The nearest pole within reach: the index of its mode, whether it is the lower one of a pair, and its distance.
pub fn nearest_pole(chart: &Chart, modes: &[Mode], at: Pos2, reach: f32) -> Option<(usize, bool, f32)> {
    let distance = |lambda: Complex<f64>| chart.position(lambda).distance(at);
    let sides = modes
        .iter()
        .enumerate()
        .flat_map(|(i, mode)| [(i, false, distance(mode.lambda)), (i, true, distance(mode.lambda.conj()))]);
    sides.filter(|(_, _, d)| *d <= reach).min_by(|a, b| a.2.total_cmp(&b.2))
}

/// The pole or mark nearest to a point of the screen.
pub fn near<'a>(
    chart: &Chart,
    seen: &PoleMapContent<'a>,
    approximations: bool,
    boundaries: impl Iterator<Item = &'a Boundary>,
    at: Pos2,
    reach: f32,
) -> Option<Near<'a>> {
    let pole = nearest_pole(chart, &seen.plane.modes, at, reach);
    let distance =
        |root: Complex<f64>| chart.position(root).distance(at).min(chart.position(root.conj()).distance(at));
    let mark = marks::approximated(&seen.plane.approximations)
        .filter(|_| approximations)
        .map(|(approximation, root)| (approximation, root, distance(root)))
        .filter(|(_, _, d)| *d <= MARK_REACH)
        .min_by(|a, b| a.2.total_cmp(&b.2));
    match (pole, mark) {
        (Some((_, _, to_pole)), Some((approximation, root, d))) if d < to_pole => {
            Some(Near::Approximation(approximation, root))
        }
        (Some((i, ..)), _) => Some(Near::Pole(i)),
        (None, Some((approximation, root, _))) => Some(Near::Approximation(approximation, root)),
        (None, None) => on_path(chart, seen, at).or_else(|| on_boundary(chart, boundaries, at)),
    }
}

fn on_boundary<'a>(
    chart: &Chart,
    boundaries: impl Iterator<Item = &'a Boundary>,
    at: Pos2,
) -> Option<Near<'a>> {
    boundaries
        .map(|boundary| (boundary, boundaries::distance(boundary, chart, at)))
        .filter(|(_, distance)| *distance <= PATH_REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(boundary, _)| Near::Level(*boundary))
}

/// The nearest point of the drawn path, between its samples too.
fn on_path(chart: &Chart, seen: &PoleMapContent<'_>, at: Pos2) -> Option<Near<'static>> {
    let (parameter, locus) = seen.locus?;
    let mut best: Option<(f32, f64, Complex<f64>, Option<ModeName>)> = None;
    for pair in locus.samples.windows(2) {
        let (Some(before), Some(after)) = (&pair[0].poles, &pair[1].poles) else { continue };
        for ((&from, &to), &name) in before.iter().zip(after).zip(&locus.names) {
            let (a, b) = (chart.position(from), chart.position(to));
            let way = b - a;
            let t = ((at - a).dot(way) / way.length_sq().max(1e-9)).clamp(0.0, 1.0);
            let distance = (a + t * way).distance(at);
            if distance <= PATH_REACH && best.is_none_or(|(d, ..)| distance < d) {
                let t = f64::from(t);
                let value = pair[0].parameter + t * (pair[1].parameter - pair[0].parameter);
                best = Some((distance, value, from + (to - from) * t, name));
            }
        }
    }
    best.map(|(_, value, lambda, name)| Near::Path { parameter, value, lambda, name })
}

/// What a card says.
pub fn card_ui(ui: &mut Ui, seen: &PoleMapContent<'_>, near: Near<'_>) {
    let (palette, curtain) = (Palette::of(ui), Curtain::of(ui));
    let title = |ui: &mut Ui, text: &str, name: ModeName| {
        ui.label(
            RichText::new(text).font(theme::semibold(theme::sizes(ui).name)).color(palette.mode_text(name)),
        );
    };
    match near {
        Near::Pole(index) => {
            let Some(mode) = seen.plane.modes.get(index) else { return };
            ui.set_width(212.0);
            title(ui, curtain.title(mode.naming.name), mode.naming.name);
            numbers_ui(ui, mode);
        }
        Near::Approximation(approximation, root) => {
            ui.set_max_width(300.0);
            let (name, notation) = (approximation.name.concerns(), seen.findings.scenario().notation);
            title(
                ui,
                &format!(
                    "≈ {}, {}",
                    words::mode::title(name),
                    words::approximation::name(approximation.name, notation)
                ),
                name,
            );
            let formula = words::approximation::formula(approximation.name, notation);
            ui.label(prose(formula, theme::body(), palette.text));
            ui.label(format!("λ = {} 1/s", shown(root)));
            ui.label(words::approximation::values(approximation, notation));
            let neglects = words::approximation::neglects(approximation.name, notation);
            ui.label(prose(&neglects, theme::small(), palette.weak));
        }
        Near::Level(boundary) => {
            let criterion = boundary.criterion;
            title(ui, &words::verdict::boundary(&boundary), criterion.concerns());
            let mode = words::mode::in_a_sentence(criterion.concerns());
            ui.label(if boundary.requirement.is_minimum {
                format!("At least that, for the {mode}.")
            } else {
                format!("At most that, for the {mode}.")
            });
            if let Some(task) = seen.findings.scenario().task {
                let source = format!(
                    "{}; {}",
                    words::verdict::citation(criterion, task.category),
                    words::verdict::task(task)
                );
                ui.label(RichText::new(source).font(theme::small()).color(palette.weak));
            }
        }
        Near::Path { parameter, value, lambda, name } => {
            let Written { symbol, unit, in_si, .. } =
                parameter.written(seen.findings.scenario().convention());
            let mut job = Symbol::parse(symbol).job(theme::sizes(ui).symbol, palette.text);
            let text =
                egui::TextFormat::simple(egui::FontId::proportional(theme::sizes(ui).name), palette.text);
            job.append(&format!(" = {} {unit}", significant(value / in_si, 3)), 0.0, text);
            ui.label(job);
            if let Some(name) = name {
                title(ui, curtain.title(name), name);
            }
            if !curtain.hides(Hidden::Numbers) {
                ui.label(format!("λ = {} 1/s", shown(lambda)));
            }
        }
    }
}

fn shown(root: Complex<f64>) -> String {
    eigenvalue(Complex::new(root.re, root.im.abs()))
}
