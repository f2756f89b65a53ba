//! The log of a stability analysis of XFLR5 or flow5: mass, inertia, dimensional derivatives in stability axes, and the matrices.
//!
//! Forces are in newtons and moments in newton metres; they become derivatives over mass and inertia here. The log may hold the matrices
//! alone, and several analyses one after another.

use super::review::Field;
use super::scan::{numbers, pairs};
use super::sheet::Sheet;
use crate::content::matrix::draft::{At, Draft, Entry, Problem};
use crate::flight::aircraft::coefficients::PlanarInertia;
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

/// What a control does, longitudinal.
const OF_CONTROL: [(&str, &str, Over); 3] =
    [("Xde", "Xde", Over::Mass), ("Zde", "Zde", Over::Mass), ("Mde", "Mde", Over::Pitch)];

#[derive(Clone, Copy)]
enum Over {
    Mass,
    Roll,
    Pitch,
    Yaw,
}

const BASES: [(&str, &str); 2] =
    [("derivatives", "its derivatives, over mass and inertia"), ("matrices", "the matrices that it prints")];

/// The four matrices of a log.
#[derive(Default)]
struct Matrices {
    longitudinal: Vec<At<Vec<f64>>>,
    lateral: Vec<At<Vec<f64>>>,
    longitudinal_control: Vec<At<Vec<f64>>>,
    lateral_control: Vec<At<Vec<f64>>>,
}

/// Reads one analysis of the log; whether its derivatives are what the aircraft is made of.
pub(super) fn read(sheet: &mut Sheet, text: &str) -> Result<bool, Problem> {
    let lines: Vec<(usize, &str)> = (1..).zip(text.lines()).collect();
    let lines = case(sheet, &lines)?;
    let mut numbers_of = Vec::new();
    for &(line, text) in lines {
        numbers_of.extend(pairs(text).into_iter().map(|pair| (line, pair)));
    }
    let of = |name: &str| {
        numbers_of
            .iter()
            .find(|(_, pair)| pair.name == name)
            .map(|(line, pair)| (*line, pair.value, pair.text))
    };
    let speed = numbers_of
        .iter()
        .find(|(_, pair)| matches!(pair.name.rsplit("...").next(), Some("VInf" | "Vinf" | "V")));
    if let Some((line, pair)) = speed {
        sheet.find("speed", pair.value, *line, pair.text.rsplit("...").next().unwrap_or_default());
    }
    for (name, key) in [("Mass", "mass"), ("Isxx", "Ix"), ("Isyy", "Iy"), ("Iszz", "Iz"), ("Isxz", "Ixz")] {
        if let Some((line, value, text)) = of(name) {
            sheet.find(key, value, line, text);
        }
    }
    if let Some((_, pair)) = numbers_of.iter().find(|(_, pair)| pair.name == "Alpha") {
        sheet.remark(format!(
            "Stability axes, x along the steady flow; α = {}° of the body.",
            trimmed(pair.value, 4)
        ));
    }
    let matrices = matrices(lines)?;
    let has_matrices = !matrices.longitudinal.is_empty() || !matrices.lateral.is_empty();
    let has_derivatives = of("Xu").is_some()
        && of("Mq").is_some()
        && sheet.finds("mass").is_some()
        && sheet.finds("Iy").is_some();
    if !has_matrices && !has_derivatives {
        return Err((
            1,
            "expected the derivatives or the state matrices of a stability analysis, found neither"
                .to_owned(),
        ));
    }
    let basis = if has_matrices && has_derivatives {
        let mut field = Field::choice("basis", "what the aircraft is made of", &BASES);
        field.required = false;
        sheet.chosen(field, Some("derivatives"), None)?.unwrap_or_default()
    } else if has_derivatives {
        "derivatives".to_owned()
    } else {
        "matrices".to_owned()
    };
    if basis == "matrices" {
        sheet.matrices = Some(draft(sheet, matrices)?);
        return Ok(false);
    }
    derivatives(sheet, &of);
    compare(sheet, &matrices);
    Ok(true)
}

/// The lines of one analysis.
fn case<'s, 't>(sheet: &mut Sheet, lines: &'s [(usize, &'t str)]) -> Result<&'s [(usize, &'t str)], Problem> {
    let starts: Vec<usize> =
        (0..lines.len()).filter(|&k| lines[k].1.contains("Calculation for control position")).collect();
    if starts.len() < 2 {
        return Ok(lines);
    }
    let titles: Vec<(String, &str)> =
        starts.iter().enumerate().map(|(k, &start)| ((k + 1).to_string(), lines[start].1.trim())).collect();
    let choices: Vec<(&str, &str)> = titles.iter().map(|(key, words)| (key.as_str(), *words)).collect();
    let chosen = sheet.chosen(Field::choice("case", "analysis", &choices), None, None)?;
    let k = chosen.and_then(|chosen| chosen.parse::<usize>().ok()).unwrap_or(1).clamp(1, starts.len()) - 1;
    Ok(&lines[starts[k]..starts.get(k + 1).copied().unwrap_or(lines.len())])
}

/// The matrices below their headings.
fn matrices(lines: &[(usize, &str)]) -> Result<Matrices, Problem> {
    let mut found = Matrices::default();
    let mut current: Option<&mut Vec<At<Vec<f64>>>> = None;
    for &(line, text) in lines {
        let heading = text.trim().trim_matches('_').to_lowercase();
        if heading.contains("state matrix") || heading.contains("control matrix") {
            let is_control = heading.contains("control matrix");
            current = match (heading.contains("lateral"), is_control) {
                (false, false) => Some(&mut found.longitudinal),
                (true, false) => Some(&mut found.lateral),
                (false, true) => Some(&mut found.longitudinal_control),
                (true, true) => Some(&mut found.lateral_control),
            };
            // Of several the first counts.
            current = current.filter(|rows| rows.is_empty());
            continue;
        }
        match (numbers(text), &mut current) {
            (Some(row), Some(rows)) => rows.push(At { line, value: row }),
            (None, Some(rows)) if !rows.is_empty() || !text.trim().is_empty() => current = None,
            _ => {}
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
    Ok(found)
}

/// The matrices as one system of both planes.
fn draft(sheet: &mut Sheet, matrices: Matrices) -> Result<Draft, Problem> {
    let mut planes = Vec::new();
    for (names, rows, control) in [
        (["u", "w", "q", "theta"], matrices.longitudinal, matrices.longitudinal_control),
        (["v", "p", "r", "phi"], matrices.lateral, matrices.lateral_control),
    ] {
        if !rows.is_empty() {
            planes.push((names, rows, control));
        }
    }
    let n = 4 * planes.len();
    let (mut names, mut a, mut b) = (Vec::new(), Vec::new(), Vec::new());
    let mut columns = Vec::new();
    for (k, (states, rows, control)) in planes.into_iter().enumerate() {
        names.extend(states.map(str::to_owned));
        let is_longitudinal = states[0] == "u";
        let has_control =
            control.len() == 4 && control.iter().all(|row| row.value.len() == control[0].value.len());
        let wanted = if is_longitudinal { "elevator" } else { "aileron" };
        if has_control && is_longitudinal {
            columns.push((
                k,
                control.iter().map(|row| row.value.first().copied().unwrap_or(0.0)).collect::<Vec<_>>(),
                wanted,
            ));
            if control[0].value.len() > 1 {
                sheet.remark("The first control is read as the elevator, the others are left out.");
            } else {
                sheet.remark("The control is read as the elevator, in radians.");
            }
        }
        for row in rows {
            let mut wide = vec![0.0; n];
            wide[4 * k..4 * k + 4].copy_from_slice(&row.value);
            a.push(At { line: row.line, value: wide });
        }
    }
    let line = a.first().map_or(1, |row| row.line);
    for (i, row) in a.iter().enumerate() {
        let value =
            columns.iter().map(|(k, column, _)| if i / 4 == *k { column[i % 4] } else { 0.0 }).collect();
        b.push(At { line: row.line, value });
    }
    let mut draft = Draft::default();
    draft.set("states", line, Entry::Names(names))?;
    draft.set("units", line, Entry::Text("SI".to_owned()))?;
    draft.set("A", line, Entry::Rows(a))?;
    if !columns.is_empty() {
        draft.set(
            "inputs",
            line,
            Entry::Names(columns.iter().map(|(.., name)| (*name).to_owned()).collect()),
        )?;
        draft.set("B", line, Entry::Rows(b))?;
    }
    Ok(draft)
}

fn derivatives<'t>(sheet: &mut Sheet, of: &impl Fn(&str) -> Option<(usize, f64, &'t str)>) {
    let by = |sheet: &Sheet, over: Over| {
        sheet.finds(match over {
            Over::Mass => "mass",
            Over::Roll => "Ix",
            Over::Pitch => "Iy",
            Over::Yaw => "Iz",
        })
    };
    for (name, key, over) in DERIVATIVES.into_iter().chain(OF_CONTROL) {
        if let (Some((line, value, text)), Some(by)) = (of(name), by(sheet, over)) {
            sheet.find(key, value / by, line, text);
        }
    }
    sheet.inertia_in_body_axes = false;
    sheet.remark("Stability axes; forces were divided by the mass, moments by the moments of inertia about the same axes.");
    if sheet.finds("Mde").is_some() {
        sheet.remark(
            "The control is read as the elevator, in radians; a set of several surfaces counts as one.",
        );
    }
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
