//! The log of a stability analysis of XFLR5 or flow5: mass, inertia, dimensional derivatives in stability axes, and the matrices.
//!
//! Forces are in newtons and moments in newton metres; they become derivatives over mass and inertia here. The log may hold the matrices
//! alone, and several analyses one after another.

use super::cases::{self, Line};
use super::control_sets::{self, ControlSet};
use super::fills::factor;
use super::quantities::quantity;
use super::review::{Basis, Field};
use super::scan::{Pair, numbers, pairs};
use super::sheet::Sheet;
use crate::content::matrix::draft::{At, Draft, Entry, Problem, Rows, number};
use crate::content::matrix::state_names::control;
use crate::flight::aircraft::coefficients::PlanarInertia;
use crate::flight::aircraft::plane::{ByPlane, Plane};
use crate::number::{significant, trimmed};

/// Force or moment by what, and our key: over the mass, or over a moment of inertia.
const DERIVATIVES: [(&str, &str, Over); 18] = [
    ("Xu", "Xu", Over::Mass),
    ("Xw", "Xw", Over::Mass),
    ("Zu", "Zu", Over::Mass),
    ("Zw", "Zw", Over::Mass),
    ("Zq", "Zq", Over::Mass),
    ("Mu", "Mu", Over::Pitch),
    ("Mw", "Mw", Over::Pitch),
    ("Mq", "Mq", Over::Pitch),
    ("Xq", "Xq", Over::Mass),
    ("Yv", "Yv", Over::Mass),
    ("Yp", "Yp", Over::Mass),
    ("Yr", "Yr", Over::Mass),
    ("Lv", "Lv", Over::Roll),
    ("Lp", "Lp", Over::Roll),
    ("Lr", "Lr", Over::Roll),
    ("Nv", "Nv", Over::Yaw),
    ("Np", "Np", Over::Yaw),
    ("Nr", "Nr", Over::Yaw),
];

/// What a control does to forces and moments, in the order in which a log prints it.
const BY_CONTROL: [&str; 6] = ["Xde", "Yde", "Zde", "Lde", "Mde", "Nde"];

/// The keys of that by our controls: X, Z, M of the elevator, and Y, L, N of aileron and rudder.
const OF_CONTROL: [(&str, [&str; 3]); 3] = [
    ("elevator", ["Xde", "Zde", "Mde"]),
    ("aileron", ["Yda", "Lda", "Nda"]),
    ("rudder", ["Ydr", "Ldr", "Ndr"]),
];

#[derive(Clone, Copy)]
enum Over {
    Mass,
    Roll,
    Pitch,
    Yaw,
}

const BASES: [(&str, &str); 2] =
    [("derivatives", "its derivatives, over mass and inertia"), ("matrices", "the matrices that it prints")];

/// The headings of what an analysis prints once, derivatives first.
const SECTIONS: [&str; 4] =
    ["longitudinal derivatives", "lateral derivatives", "longitudinal state matrix", "lateral state matrix"];

/// What may stand before them and is of the same analysis: words, and names of numbers.
const BEGINNINGS: [&str; 4] =
    ["for control position", "processing control value", "calculating plane for", "state matrices"];
const NUMBERS_BEFORE: [&str; 8] = ["Mass", "mass", "Alpha", "α", "VInf", "Vinf", "V∞", "V"];

/// The matrices of a log.
#[derive(Default)]
struct Matrices {
    longitudinal: Rows,
    lateral: Rows,
    controls: Vec<ControlSet>,
}

/// Reads one analysis of the log; whether its derivatives are what the aircraft is made of.
pub(super) fn read(sheet: &mut Sheet, text: &str) -> Result<bool, Problem> {
    let lines: Vec<Line<'_>> = (1..).zip(text.lines()).collect();
    let analyses = analyses(&lines);
    let words: Vec<String> = analyses.iter().map(|lines| words(lines)).collect();
    let chosen = cases::chosen(sheet, "analysis", &words, None)?;
    let Some(&lines) = chosen.and_then(|k| analyses.get(k)) else { return Ok(false) };
    let of = |name: &str| numbered(lines).find(|(_, pair)| pair.name == name);
    if let Some((line, pair)) = speed(lines) {
        let text = pair.text.rsplit("...").next().unwrap_or_default();
        sheet.find("speed", pair.value * unit(line, "m/s", &pair)?, line, text);
    }
    if let Some((line, pair)) = of("Mass").or_else(|| of("mass")) {
        sheet.find("mass", pair.value * unit(line, "kg", &pair)?, line, pair.text);
    }
    for (name, key) in [("Isxx", "Ix"), ("Isyy", "Iy"), ("Iszz", "Iz"), ("Isxz", "Ixz")] {
        if let Some((line, pair)) = of(name) {
            sheet.find(key, pair.value, line, pair.text);
        }
    }
    if let Some((_, pair)) = of("Alpha") {
        sheet.remark(format!(
            "Stability axes, x along the steady flow; α = {}° of the body.",
            trimmed(pair.value, 4)
        ));
    }
    let matrices = matrices(lines)?;
    let has_matrices = !matrices.longitudinal.is_empty() || !matrices.lateral.is_empty();
    let has_derivatives = of("Xu").is_some() && of("Mq").is_some();
    if !has_matrices && !has_derivatives {
        return Err((
            1,
            "expected the derivatives or the state matrices of a stability analysis, found neither"
                .to_owned(),
        ));
    }
    let is_whole = has_derivatives && sheet.finds("mass").is_some() && sheet.finds("Iy").is_some();
    let basis = if has_matrices && is_whole {
        let mut field = Field::choice("basis", "what the aircraft is made of", &BASES);
        field.required = false;
        sheet.chosen(field, Some("derivatives"), None)?.unwrap_or_default()
    } else if has_matrices {
        "matrices".to_owned()
    } else {
        "derivatives".to_owned()
    };
    if basis == "matrices" {
        sheet.matrices = draft(sheet, matrices)?;
        return Ok(false);
    }
    let is_read = derivatives(sheet, lines)?;
    compare(sheet, &matrices);
    Ok(is_read)
}

/// Every pair of a name and a number, with its line.
fn numbered<'l, 't>(lines: &'l [Line<'t>]) -> impl Iterator<Item = (usize, Pair<'t>)> + 'l {
    lines.iter().flat_map(|&(line, text)| pairs(text).into_iter().map(move |pair| (line, pair)))
}

/// The speed of flight; flow5 comes to it in several steps, of which the last counts.
fn speed<'t>(lines: &[Line<'t>]) -> Option<(usize, Pair<'t>)> {
    let of = |names: &[&str]| {
        let is_it = |(_, pair): &(usize, Pair<'_>)| {
            names.contains(&pair.name.rsplit("...").next().unwrap_or_default())
        };
        numbered(lines).filter(is_it).last()
    };
    of(&["VInf", "Vinf", "V∞"]).or_else(|| of(&["V"]))
}

/// The unit behind a number in SI.
fn unit(line: usize, of: &str, pair: &Pair<'_>) -> Result<f64, Problem> {
    let name = pair.unit.split_whitespace().next().unwrap_or(of);
    factor(of, name)
        .ok_or_else(|| (line, format!("{}: {name} is not a unit known here; expected {of}", pair.name)))
}

/// The analyses of a log. One begins where a section comes again, or derivatives come behind matrices.
fn analyses<'s, 't>(lines: &'s [Line<'t>]) -> Vec<&'s [Line<'t>]> {
    let section = |text: &str| {
        let text = text.to_lowercase();
        SECTIONS.iter().position(|section| text.contains(section))
    };
    let begins_anew = |section: usize, seen: &[usize]| {
        seen.contains(&section) || section < 2 && seen.iter().any(|seen| *seen >= 2)
    };
    cases::parted(lines, section, begins_anew, begins)
}

/// Whether a line stands before the sections of an analysis.
fn begins(text: &str) -> bool {
    let small = text.to_lowercase();
    BEGINNINGS.iter().any(|beginning| small.contains(beginning))
        || pairs(text)
            .iter()
            .any(|pair| NUMBERS_BEFORE.contains(&pair.name.rsplit("...").next().unwrap_or_default()))
}

/// What tells an analysis from others.
fn words(lines: &[Line<'_>]) -> String {
    let mut words = Vec::new();
    let position = lines.iter().find_map(|(_, text)| {
        let (_, position) =
            text.split_once("control position").or_else(|| text.split_once("control value="))?;
        number(position)
    });
    words.extend(position.map(|position| format!("control position {}", trimmed(position, 4))));
    words.extend(speed(lines).map(|(_, pair)| format!("V {} {}", trimmed(pair.value, 4), pair.unit)));
    let alpha = numbered(lines).find(|(_, pair)| pair.name.ends_with("Alpha") || pair.name.ends_with('α'));
    words.extend(alpha.map(|(_, pair)| format!("α {}°", trimmed(pair.value, 4))));
    if words.is_empty() {
        let whole = matrices(lines).ok();
        let a = whole.map(|found| {
            let rows = if found.longitudinal.is_empty() { found.lateral } else { found.longitudinal };
            rows.into_iter().map(|row| row.value).collect::<Vec<_>>()
        });
        words.extend(a.and_then(|a| cases::told_by_eigenvalues(&a)));
    }
    let line = lines.iter().find(|(_, text)| !text.trim().is_empty()).map_or(1, |(line, _)| *line);
    if words.is_empty() { format!("line {line}") } else { format!("line {line}: {}", words.join(", ")) }
}

/// Where a row of numbers belongs.
#[derive(Clone, Copy)]
enum Below {
    State(Plane),
    Control(Plane),
}

/// Control matrices as they are printed: a name, and for each plane a column for each control.
struct Printed {
    name: Option<String>,
    line: usize,
    planes: ByPlane<Rows>,
}

/// The matrices below their headings.
fn matrices(lines: &[Line<'_>]) -> Result<Matrices, Problem> {
    let mut found = Matrices::default();
    let mut sets: Vec<Printed> = Vec::new();
    let mut below: Option<Below> = None;
    for &(line, text) in lines {
        let heading = text.trim().trim_matches('_').trim();
        let small = heading.to_lowercase();
        let plane = if small.contains("lateral") { Plane::Lateral } else { Plane::Longitudinal };
        let is_new = |set: &Printed| !set.planes[plane].is_empty();
        if small.contains("control matrices") {
            let name = heading.split_once(" set ").map(|(_, name)| name.trim().to_owned());
            let name = name.filter(|name| !name.is_empty());
            sets.push(Printed { name, line, planes: ByPlane::default() });
            below = None;
        } else if small.contains("control matrix") {
            if sets.last().is_none_or(is_new) {
                sets.push(Printed { name: None, line, planes: ByPlane::default() });
            }
            below = Some(Below::Control(plane));
        } else if small.contains("state matrix") {
            below = Some(Below::State(plane));
        } else if let (Some(value), Some(place)) = (numbers(text), below) {
            let rows = match (place, sets.last_mut()) {
                (Below::Control(plane), Some(set)) => &mut set.planes[plane],
                (Below::State(Plane::Lateral), _) => &mut found.lateral,
                _ => &mut found.longitudinal,
            };
            rows.push(At { line, value });
        } else if !text.trim().is_empty() {
            let started = match (below, sets.last()) {
                (Some(Below::State(Plane::Longitudinal)), _) => Some(&found.longitudinal),
                (Some(Below::State(Plane::Lateral)), _) => Some(&found.lateral),
                (Some(Below::Control(plane)), Some(set)) => Some(&set.planes[plane]),
                _ => None,
            };
            if started.is_some_and(|rows| rows.len() < 4) {
                return Err((line, format!("expected four rows of numbers, found “{}”", text.trim())));
            }
            below = None;
        }
    }
    for rows in [&found.longitudinal, &found.lateral] {
        if let Some(row) = rows.iter().find(|row| row.value.len() != 4 || rows.len() != 4) {
            return Err((
                row.line,
                format!(
                    "expected four rows of four numbers, found {} in this one of {}",
                    row.value.len(),
                    rows.len()
                ),
            ));
        }
    }
    for set in sets {
        found.controls.extend(set.columns()?);
    }
    Ok(found)
}

impl Printed {
    /// A set for each column.
    fn columns(&self) -> Result<Vec<ControlSet>, Problem> {
        let planes = Plane::ALL.map(|plane| &self.planes[plane]);
        let count = planes.iter().flat_map(|rows| rows.iter()).map(|row| row.value.len()).max().unwrap_or(0);
        for rows in planes.into_iter().filter(|rows| !rows.is_empty()) {
            let last = rows.last().map_or(self.line, |row| row.line);
            if rows.len() != 4 {
                return Err((last, format!("expected a control matrix of four rows, found {}", rows.len())));
            }
            if let Some(row) = rows.iter().find(|row| row.value.len() != count) {
                let found = row.value.len();
                return Err((row.line, format!("expected {count} numbers, one a control, found {found}")));
            }
        }
        let column = |plane: Plane, k: usize| {
            let rows = &self.planes[plane];
            std::array::from_fn(|i| rows.get(i).and_then(|row| row.value.get(k)).copied().unwrap_or(0.0))
        };
        let set = |k| ControlSet {
            name: self.name.clone(),
            line: self.line,
            longitudinal: column(Plane::Longitudinal, k),
            lateral: column(Plane::Lateral, k),
        };
        Ok((0..count).map(set).collect())
    }
}

/// The matrices as one system of both planes; `None` while it isn't said what the controls are.
fn draft(sheet: &mut Sheet, matrices: Matrices) -> Result<Option<Draft>, Problem> {
    let Matrices { longitudinal, lateral, controls } = matrices;
    let Some(inputs) = control_sets::named(sheet, &controls)? else { return Ok(None) };
    let mut planes = Vec::new();
    for (plane, names, rows) in [
        (Plane::Longitudinal, ["u", "w", "q", "theta"], longitudinal),
        (Plane::Lateral, ["v", "p", "r", "phi"], lateral),
    ] {
        if !rows.is_empty() {
            planes.push((plane, names, rows));
        }
    }
    let n = 4 * planes.len();
    let (mut names, mut a, mut b) = (Vec::new(), Vec::new(), Vec::new());
    for (k, (plane, states, rows)) in planes.into_iter().enumerate() {
        names.extend(states.map(str::to_owned));
        for (i, row) in rows.into_iter().enumerate() {
            let of_set = |set: &ControlSet| match plane {
                Plane::Longitudinal => set.longitudinal[i],
                Plane::Lateral => set.lateral[i],
            };
            b.push(At { line: row.line, value: controls.iter().map(of_set).collect() });
            let mut wide = vec![0.0; n];
            wide[4 * k..4 * k + 4].copy_from_slice(&row.value);
            a.push(At { line: row.line, value: wide });
        }
    }
    let line = a.first().map_or(1, |row| row.line);
    let mut draft = Draft::default();
    draft.set("states", line, Entry::Names(names))?;
    draft.set("units", line, Entry::Text("SI".to_owned()))?;
    draft.set("A", line, Entry::Rows(a))?;
    if !inputs.is_empty() {
        draft.set("inputs", line, Entry::Names(inputs))?;
        draft.set("B", line, Entry::Rows(b))?;
    }
    Ok(Some(draft))
}

/// The derivatives, over mass and inertia; whether everything that they are divided by is known.
fn derivatives(sheet: &mut Sheet, lines: &[Line<'_>]) -> Result<bool, Problem> {
    sheet.set_basis(Basis::Derivatives);
    let of = |name: &str| numbered(lines).find(|(_, pair)| pair.name == name);
    let mut divisors = Vec::new();
    for key in ["mass", "Ix", "Iy", "Iz"] {
        divisors.push(divisor(sheet, key)?);
    }
    if sheet.finds("Ixz").is_none() {
        sheet.needed(
            "Ixz",
            Some((0.0, "a symmetric mass fore and aft; it is small in most aircraft".to_owned())),
        )?;
    }
    let [Some(mass), Some(ix), Some(iy), Some(iz)] = divisors[..] else { return Ok(false) };
    let by = |over: Over| match over {
        Over::Mass => mass,
        Over::Roll => ix,
        Over::Pitch => iy,
        Over::Yaw => iz,
    };
    for (name, key, over) in DERIVATIVES {
        if let Some((line, pair)) = of(name) {
            sheet.find(key, pair.value / by(over), line, pair.text);
        }
    }
    let printed = by_control(lines);
    if let Some((_, line, values)) = printed.iter().find(|(_, _, values)| values.contains(&None)) {
        let found = values.iter().flatten().count();
        let problem =
            format!("expected six derivatives by a control, Xde to Nde, found {found}; is the log cut off?");
        return Err((*line, problem));
    }
    let sets: Vec<ControlSet> = printed
        .iter()
        .map(|(name, line, values)| {
            let [x, y, z, l, m, n] = values.map(|value| value.map_or(0.0, |(value, ..)| value));
            ControlSet {
                name: name.clone(),
                line: *line,
                longitudinal: [x / mass, z / mass, m / iy, 0.0],
                lateral: [y / mass, l / ix, n / iz, 0.0],
            }
        })
        .collect();
    sheet.inertia_in_body_axes = false;
    sheet.remark("Stability axes; forces were divided by the mass, moments by the moments of inertia about the same axes.");
    let Some(names) = control_sets::named(sheet, &sets)? else { return Ok(false) };
    for ((name, (_, _, values)), set) in names.iter().zip(printed).zip(&sets) {
        let Some((_, keys)) = OF_CONTROL.iter().find(|(key, _)| control(name) == Some(*key)) else {
            sheet.remark(format!("{name} is no control that these planes have here, and left out."));
            continue;
        };
        if keys.iter().any(|key| sheet.finds(key).is_some()) {
            sheet.remark(format!("{name} is left out: another set is the same control."));
            continue;
        }
        let [x, y, z, l, m, n] = values;
        let is_elevator = keys[0] == "Xde";
        let (printed, rates) =
            if is_elevator { ([x, z, m], set.longitudinal) } else { ([y, l, n], set.lateral) };
        for ((key, printed), rate) in keys.iter().zip(printed).zip(rates) {
            if let Some((_, line, text)) = printed {
                sheet.find(key, rate, line, text);
            }
        }
    }
    Ok(true)
}

/// What forces or moments are divided by: as typed, as printed, or asked for.
fn divisor(sheet: &mut Sheet, key: &'static str) -> Result<Option<f64>, Problem> {
    let unit = quantity(key).map_or("", |quantity| quantity.unit);
    match sheet.fills.number(key, unit).map_err(|problem| (1, problem))?.or(sheet.finds(key)) {
        Some(value) => Ok(Some(value)),
        None => sheet.needed(key, None),
    }
}

/// A number of the log, its line and its text.
type Number<'t> = (f64, usize, &'t str);

/// The derivatives by each set of controls: its name, where it has one, its line, and its numbers in the order of [`BY_CONTROL`].
fn by_control<'t>(lines: &[Line<'t>]) -> Vec<(Option<String>, usize, [Option<Number<'t>>; 6])> {
    let mut sets: Vec<(Option<String>, usize, [Option<Number<'t>>; 6])> = Vec::new();
    let (mut is_below, mut name) = (false, None);
    for &(line, text) in lines {
        let plain = text.trim();
        if plain.to_lowercase().contains("control derivatives") {
            is_below = !plain.to_lowercase().contains("calculating");
            continue;
        }
        let found = pairs(text);
        let of_control = found
            .iter()
            .find_map(|pair| Some((BY_CONTROL.iter().position(|known| *known == pair.name)?, pair)));
        let Some((place, pair)) = of_control else {
            name = (is_below && !plain.is_empty() && found.is_empty()).then(|| plain.to_owned());
            continue;
        };
        if place == 0 || sets.is_empty() {
            sets.push((name.take(), line, [None; 6]));
        }
        if let Some((_, _, values)) = sets.last_mut() {
            values[place] = Some((pair.value, line, pair.text));
        }
    }
    sets
}

/// The matrices that the log prints, beside those that follow from its derivatives.
fn compare(sheet: &mut Sheet, matrices: &Matrices) {
    let found = |key: &str| sheet.finds(key);
    let mut worst: Option<(f64, &str, f64, f64)> = None;
    let mut beside = |name: &'static str, printed: Option<f64>, made: Option<f64>| {
        let (Some(printed), Some(made)) = (printed, made) else { return };
        let apart = (printed - made).abs() / printed.abs().max(made.abs()).max(1e-6);
        if apart.is_nan() || worst.is_none_or(|(most, ..)| apart > most) {
            worst = Some((apart, name, printed, made));
        }
    };
    let entry =
        |rows: &[At<Vec<f64>>], i: usize, j: usize| rows.get(i).and_then(|row| row.value.get(j)).copied();
    for (name, key, i, j) in
        [("A(u, u)", "Xu", 0, 0), ("A(w, w)", "Zw", 1, 1), ("A(q, w)", "Mw", 2, 1), ("A(q, q)", "Mq", 2, 2)]
    {
        beside(name, entry(&matrices.longitudinal, i, j), found(key));
    }
    let inertia =
        found("Ix").zip(found("Iz")).zip(found("Ixz")).map(|((ix, iz), ixz)| PlanarInertia { ix, iz, ixz });
    if let Some(PlanarInertia { ix, iz, ixz }) = inertia {
        let c = 1.0 - ixz * ixz / (ix * iz);
        // L′ = (L + (Ixz/Ix) N)/(1 − Ixz²/(Ix Iz)), and likewise N′
        let roll = |l: &str, n: &str| Some((found(l)? + ixz / ix * found(n)?) / c);
        let yaw = |l: &str, n: &str| Some((found(n)? + ixz / iz * found(l)?) / c);
        beside("A(p, p)", entry(&matrices.lateral, 1, 1), roll("Lp", "Np"));
        beside("A(p, v)", entry(&matrices.lateral, 1, 0), roll("Lv", "Nv"));
        beside("A(r, v)", entry(&matrices.lateral, 2, 0), yaw("Lv", "Nv"));
        beside("A(r, r)", entry(&matrices.lateral, 2, 2), yaw("Lr", "Nr"));
    }
    let Some((apart, name, printed, made)) = worst else { return };
    let numbers = format!(
        "{name} is {} as printed, and {} from the derivatives",
        significant(printed, 5),
        significant(made, 5)
    );
    if apart > 0.01 || apart.is_nan() {
        sheet.warn(
            "log",
            format!("The log’s matrices are not those of its derivatives: {numbers}. Is a moment of inertia zero or printed with few digits?"),
            vec![super::review::Remedy::new("basis", "matrices")],
        );
    } else {
        sheet.remark(format!(
            "The matrices that the log prints follow from its derivatives: at worst {numbers}."
        ));
    }
}
