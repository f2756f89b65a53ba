//! Answers as tables for people: four digits, units in the heads, a true minus sign.

use comfy_table::{Cell, CellAlignment, LineStyle, Table, TableStyle};
use eigenwing::export::{
    AircraftReport, LeastGainReport, LoopModeReport, LoopOutcome, LoopReport, MeasureReport, MeasureValue,
    ModeReport, ParameterReport, PlaneOutcome, PlaneReport, Report, StiffnessReport, SweepChange, SweepPlane,
    SweepReport, ValueReport, WhyReport,
};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::key::Keyed as _;
use eigenwing::number::significant;
use eigenwing::scenario::{Notation, Parameter};
use eigenwing::words;

use crate::shown_units::ShownUnits;

/// Digits of a number.
pub const DIGITS: usize = 4;

/// A line under the head, nothing else: numbers are read down the columns.
const STYLE: TableStyle = TableStyle::new().header_separator(LineStyle::none().fill('─').junction('─'));

/// Rows that a person reads; more are for `--csv`.
const ROWS: usize = 20;

pub fn number(x: f64) -> String {
    significant(x, DIGITS)
}

pub fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}

pub fn percent(value: Option<f64>) -> String {
    value.map_or_else(String::new, |x| format!("{} %", significant(100.0 * x, 3)))
}

/// σ ± jω.
fn eigenvalue(re: f64, im: f64) -> String {
    if im > 0.0 { format!("{} ± {}j", number(re), number(im)) } else { number(re) }
}

/// A table whose first `words` columns are words and the others numbers.
pub fn table(words: usize, head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut table = Table::new();
    table.load_style(STYLE);
    let cell = |(k, text): (usize, String)| {
        let side = if k < words { CellAlignment::Left } else { CellAlignment::Right };
        Cell::new(text).set_alignment(side)
    };
    table.set_header(head.iter().map(|&name| name.to_owned()).enumerate().map(cell));
    for row in rows {
        table.add_row(row.into_iter().enumerate().map(cell));
    }
    table.trim_fmt() + "\n"
}

/// Name and unit, for a head.
pub fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// The step by which so many rows become few enough to be read.
pub fn stride(rows: usize) -> usize {
    rows.saturating_sub(1).div_ceil(ROWS).max(1)
}

pub fn list(list: &[AircraftReport]) -> String {
    let row = |a: &AircraftReport| {
        let planes = if a.planes.len() == 2 { "both".to_owned() } else { a.planes.join("") };
        vec![a.key.clone(), a.name.clone(), a.condition.clone(), planes, a.status.to_owned()]
    };
    table(5, &["key", "aircraft", "condition", "planes", "modes"], list.iter().map(row))
}

pub fn parameters(parameters: &[ParameterReport], units: ShownUnits) -> String {
    let row = |p: &ParameterReport| {
        let (in_si, unit) = units.unit(p.unit);
        let [low, high] = p.slider;
        vec![
            p.key.to_owned(),
            p.name.to_owned(),
            unit.to_owned(),
            number(p.value / in_si),
            number(low / in_si),
            number(high / in_si),
        ]
    };
    table(3, &["key", "parameter", "unit", "value", "slider from", "to"], parameters.iter().map(row))
}

pub fn measures(measures: &[MeasureReport], units: ShownUnits) -> String {
    let row = |m: &MeasureReport| {
        let (in_si, unit) = units.unit(m.unit);
        let value = |value| measured(value, in_si);
        let value = m.absent.clone().unwrap_or_else(|| m.value.map_or_else(String::new, value));
        vec![m.key.clone(), m.name.clone(), unit.to_owned(), value]
    };
    table(3, &["key", "measure", "unit", "value"], measures.iter().map(row))
}

/// A number with four digits in a unit, or the key of a verdict.
fn measured(value: MeasureValue, in_si: f64) -> String {
    match value {
        MeasureValue::Number(x) => number(x / in_si),
        MeasureValue::Verdict(key) => key.to_owned(),
    }
}

/// A sweep with a column for each measure.
pub fn measured_sweep(report: &SweepReport, units: ShownUnits) -> String {
    let of_measures: Vec<(f64, &str)> =
        report.measures.iter().map(|measure| units.unit(measure.unit)).collect();
    let (in_si, unit) = units.unit(report.unit);
    let columns =
        report.measures.iter().zip(&of_measures).map(|(measure, (_, unit))| heading(&measure.key, unit));
    let head: Vec<String> = std::iter::once(heading(report.parameter, unit)).chain(columns).collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let rows = report.points.iter().map(|point| {
        let values = point.measures.iter().zip(&of_measures);
        let values =
            values.map(|(value, (in_si, _))| value.map_or_else(String::new, |value| measured(value, *in_si)));
        std::iter::once(number(point.value / in_si)).chain(values).collect()
    });
    format!("{}\n{}", report.aircraft.name, table(0, &head, rows))
}

pub fn analysis(report: &Report, units: ShownUnits, notation: Notation) -> String {
    let aircraft = &report.aircraft;
    let mut text = format!("{}: {} ({})\n", aircraft.name, aircraft.condition, report.status_now);
    for (key, value) in &report.set {
        let si = Parameter::find(key).map_or("", |parameter| parameter.dimension.si_symbol());
        let (in_si, unit) = units.unit(si);
        let unit = if units == ShownUnits::Si { "" } else { unit };
        text += format!("{key} = {} {unit}", number(*value / in_si)).trim_end();
        text += "\n";
    }
    for note in &aircraft.notes {
        text += &format!("Note: {note}\n");
    }
    for (name, outcome) in [("Longitudinal", &report.longitudinal), ("Lateral–directional", &report.lateral)]
    {
        match outcome {
            Some(PlaneOutcome::Analysed(plane)) => text += &plane_text(name, plane, units, notation),
            Some(PlaneOutcome::Failed { error }) => text += &format!("\n{name}: {error}\n"),
            None => {}
        }
    }
    if let Some(overall) = &report.overall_level {
        let planes = [&report.longitudinal, &report.lateral].into_iter().flatten();
        let closed: Vec<&LoopOutcome> =
            planes.filter_map(PlaneOutcome::report).filter_map(|plane| plane.closed_loop.as_ref()).collect();
        let is_fed_back =
            |closed: &&LoopOutcome| !matches!(closed, LoopOutcome::Analysed(closed) if !closed.feedback);
        let which = if closed.iter().any(is_fed_back) {
            "Handling qualities without the law"
        } else if closed.is_empty() {
            "Handling qualities"
        } else {
            "Handling qualities of the four states"
        };
        text += &format!("\n{which}: {}\n", overall.sentence);
    }
    if let (Some(of_static), Some(of_manoeuvre)) = (report.static_margin, report.manoeuvre_margin) {
        text += &format!(
            "\nStatic margin {} of the chord, manoeuvre margin {}\n",
            percent(Some(of_static)),
            percent(Some(of_manoeuvre))
        );
    }
    if report.gravity_is_plausible == Some(false) {
        text += "\nGravity and speed of this model can't belong to one system of units\n";
    }
    text
}

/// Why the modes have moved, mode by mode.
pub fn why(report: &WhyReport) -> String {
    let since = if report.since == "pinned" { words::change::SINCE_PIN } else { words::change::SINCE_FILE };
    let mut text = format!("{}: {}\n", report.name, since.to_lowercase());
    for plane in &report.planes {
        text += &format!("\nMoved: {}\n", plane.sentence);
        for mode in &plane.modes {
            text += &format!("{}: {}\n", mode.name, mode.sentences.join(" "));
        }
    }
    if let Some(trim) = &report.new_trim {
        text += &format!("\n{trim}\n");
    }
    text
}

fn plane_text(name: &str, plane: &PlaneReport, units: ShownUnits, notation: Notation) -> String {
    let (in_si, unit) = match notation {
        Notation::Velocities => units.unit("1/(m·s)"),
        Notation::Angles => (1.0 / plane.trim.speed, "1/s²"),
    };
    let (of_static, of_dynamic) = (&plane.static_stability, plane.dynamic_stability);
    let mut text = format!(
        "\n{name}: dynamically {of_dynamic}, statically {} (det A = {} 1/s⁴)\n",
        of_static.verdict,
        number(of_static.determinant)
    );
    let stiffness = match of_static.stiffness {
        StiffnessReport::Longitudinal { pitch_stiffness, .. } => {
            format!("Pitch stiffness M_w = {} {unit}\n", number(pitch_stiffness / in_si))
        }
        StiffnessReport::Lateral { weathercock_stiffness, dihedral_effect, .. } => {
            let [yaw, roll] = [weathercock_stiffness, dihedral_effect].map(|x| number(x / in_si));
            if of_static.plain_derivatives {
                format!("Weathercock stability N_v = {yaw} {unit}, dihedral effect L_v = {roll} {unit}\n")
            } else {
                format!(
                    "Weathercock stability N′_v = {yaw} {unit}, dihedral effect L′_v = {roll} {unit}; \
                     the primes include the product of inertia\n"
                )
            }
        }
    };
    text += &words::notation::prose(&stiffness, notation);
    text += &modes(plane.modes.iter());
    for mode in &plane.modes {
        text += &format!("{}: {}\n", mode.name, mode.reason);
    }
    for level in &plane.levels {
        text += &format!("{}: {}\n", level.criterion, level.sentence);
    }
    let head = ["approximation", "formula", "ωₙ or λ", "error", "ζ", "error"];
    let approximations = plane.approximations.iter().map(|a| {
        let (main, zeta) = match a.value {
            Some(ValueReport::SecondOrder { natural_frequency, damping_ratio }) => {
                (Some(natural_frequency), damping_ratio)
            }
            Some(ValueReport::Root { root }) => (Some(root), None),
            None => (None, None),
        };
        vec![
            format!("{}, {}", a.mode, a.name),
            a.formula.to_owned(),
            optional(main),
            percent(a.error),
            optional(zeta),
            percent(a.damping_error),
        ]
    });
    text += &table(2, &head, approximations);
    match &plane.closed_loop {
        Some(LoopOutcome::Analysed(closed)) => text + &closed_text(name, closed),
        Some(LoopOutcome::Failed { error }) => text + &format!("\n{name} under the law: {error}\n"),
        None => text,
    }
}

fn modes<'a>(modes: impl Iterator<Item = &'a ModeReport>) -> String {
    let head = ["mode", "λ [1/s]", "ωₙ [rad/s]", "ζ", "T [s]", "t½ [s]", "t₂ [s]"];
    let row = |mode: &ModeReport| {
        vec![
            mode.name.to_owned(),
            eigenvalue(mode.re, mode.im),
            optional(mode.natural_frequency),
            optional(mode.damping_ratio),
            optional(mode.period),
            optional(mode.time_to_half),
            optional(mode.time_to_double),
        ]
    };
    table(1, &head, modes.map(row))
}

/// A lag, or a lead where it is negative.
fn phase_margin(angle: f64) -> String {
    let lead = if angle < 0.0 { " lead" } else { "" };
    number(angle.to_degrees().abs()) + lead
}

/// The same plane under its law and with the further states of its source.
fn closed_text(name: &str, closed: &LoopReport) -> String {
    let states = closed.states.get(4..).unwrap_or_default().join(", ");
    let whole = if closed.feedback { "under the law".to_owned() } else { format!("with {states}") };
    let mut text = format!("\n{name} {whole}: dynamically {}\n", closed.dynamic_stability);
    text += &modes(closed.modes.iter().map(|mode| &mode.mode));
    for LoopModeReport { mode, .. } in &closed.modes {
        text += &format!("{}: {}\n", mode.name, mode.reason);
    }
    for level in &closed.levels {
        text += &format!("{}: {}\n", level.criterion, level.sentence);
    }
    let head =
        ["loop", "gain ×", "gain ÷", "phase margin [deg]", "crossover [rad/s]", "sensitivity", "at [rad/s]"];
    let margins = closed.loops.iter().map(|margins| {
        vec![
            margins.control.to_owned(),
            optional(margins.raise),
            optional(margins.lower.map(f64::recip)),
            margins.phase_margin.map_or_else(String::new, phase_margin),
            optional(margins.crossover),
            optional(margins.sensitivity_peak),
            optional(margins.sensitivity_frequency),
        ]
    });
    if !closed.loops.is_empty() {
        text += &table(1, &head, margins);
    }
    for LeastGainReport { gain, unit, least, reason } in &closed.least_gains {
        text += &match (least, reason) {
            (Some(least), _) => {
                format!("Least {gain} for Level 1: {} {unit}", number(*least)).trim_end().to_owned()
            }
            (None, reason) => format!("{gain}: {}", reason.as_deref().unwrap_or_default()),
        };
        text += "\n";
    }
    text
}

pub fn sweep(report: &SweepReport, units: ShownUnits) -> String {
    let (in_si, unit) = units.unit(report.unit);
    let value = heading(report.parameter, unit);
    let head = [value.as_str(), "mode", "λ [1/s]", "ωₙ [rad/s]", "ζ", "stability"];
    let modes = swept_planes(report, in_si).flat_map(|(at, _, plane)| sweep_rows(&at, plane));
    let mut text = format!("{}\n{}", report.aircraft.name, table(2, &head, modes));
    let head = [value.as_str(), "motion", "det A [1/s⁴]", "static stability", "dynamic stability"];
    let planes = swept_planes(report, in_si).map(|(at, motion, plane)| {
        let SweepPlane { static_stability, dynamic_stability, determinant, .. } = plane;
        let words = [*static_stability, *dynamic_stability].map(str::to_owned);
        [at, motion.to_owned(), number(*determinant)].into_iter().chain(words).collect()
    });
    text += &format!("\n{}", table(2, &head, planes));
    for point in &report.points {
        if let Some(error) = &point.error {
            text +=
                &format!("At {}: {error}\n", format!("{} {unit}", number(point.value / in_si)).trim_end());
        }
    }
    for SweepChange { plane, stability, at, from, to, .. } in &report.changes {
        let at = format!("{} {unit}", number(*at / in_si));
        let (plane, from, to) = (Plane::by_key(plane), Stability::by_key(from), Stability::by_key(to));
        let (Some(plane), Some(from), Some(to)) = (plane, from, to) else { continue };
        text += &words::sweep::change(at.trim_end(), plane, *stability == "static", from, to);
        text += "\n";
    }
    text
}

/// Every plane at every point, with the value there and the name of the plane.
fn swept_planes(
    report: &SweepReport,
    in_si: f64,
) -> impl Iterator<Item = (String, &'static str, &SweepPlane)> {
    report.points.iter().flat_map(move |point| {
        let planes = [("longitudinal", &point.longitudinal), ("lateral", &point.lateral)];
        let at = number(point.value / in_si);
        planes.into_iter().filter_map(move |(name, plane)| Some((at.clone(), name, plane.as_ref()?)))
    })
}

fn sweep_rows(at: &str, plane: &SweepPlane) -> Vec<Vec<String>> {
    let row = |mode: &eigenwing::export::SweepMode| {
        vec![
            at.to_owned(),
            mode.name.to_owned(),
            eigenvalue(mode.re, mode.im),
            optional(mode.natural_frequency),
            optional(mode.damping_ratio),
            mode.stability.to_owned(),
        ]
    };
    plane.modes.iter().map(row).collect()
}
