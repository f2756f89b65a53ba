//! VSPAERO's stability file (`.stab`): one table for each angle of attack. Its unit of length is that of the model, which the file
//! doesn't tell.
//!
//! x aft and z up, with the moments CMl, CMm, CMn turned forward and down again. Rates are made dimensionless by b/2V and c/2V. Forces
//! CL and CD are along the flow; moments are about body axes and are turned into stability axes here.

use super::cases;
use super::review::Field;
use super::sheet::Sheet;
use crate::content::matrix::draft::{Problem, number};
use crate::content::units::UnitSystem;
use crate::number::trimmed;

const UNITS: [(&str, &str); 2] =
    [("SI", "metres, kilograms, seconds"), ("ft-slug-s", "feet, slugs, seconds")];
const GROUPS: [(&str, &str); 4] =
    [("none", "left out"), ("elevator", "elevator"), ("aileron", "aileron"), ("rudder", "rudder")];

/// A table of derivatives: rows by coefficient, columns by what it changes with.
#[derive(Default)]
struct Case<'t> {
    values: Vec<(&'t str, f64, usize, &'t str)>,
    columns: Vec<&'t str>,
    units: Vec<&'t str>,
    /// A row's name, its line, and its entries; `None` for one that is no number.
    rows: Vec<(&'t str, usize, Vec<Option<f64>>)>,
}

/// The rows of the table.
const ROWS: [&str; 12] = ["CFx", "CFy", "CFz", "CMx", "CMy", "CMz", "CL", "CD", "CS", "CMl", "CMm", "CMn"];

impl<'t> Case<'t> {
    fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|(known, ..)| *known == name).map(|&(_, value, ..)| value)
    }

    fn entry(&self, row: &str, column: &str) -> Option<(f64, usize)> {
        let k = self.columns.iter().position(|known| *known == column)?;
        let (_, line, numbers) = self.rows.iter().find(|(known, ..)| *known == row)?;
        Some(((*numbers.get(k)?)?, *line))
    }
}

pub(super) fn read(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    let cases = tables(text)?;
    let is_whole = |case: &Case<'_>| case.entry("CL", "Alpha").is_some();
    for case in cases.iter().filter(|case| !is_whole(case)) {
        if let Some((_, _, line, _)) = case.values.first() {
            sheet.remark(format!(
                "The table that begins on line {line} has no C_L by α, and is left out: is it cut off?"
            ));
        }
    }
    let cases: Vec<Case<'_>> = cases.into_iter().filter(is_whole).collect();
    if cases.is_empty() {
        return Err((
            1,
            "expected a table with the rows CL, CD, CMm and the columns Alpha, Beta, p, q, r, found none"
                .to_owned(),
        ));
    }
    let rho = cases[0].value("Rho_");
    let hint = rho.and_then(|rho| match rho {
        rho if (0.3..=1.5).contains(&rho) => {
            Some(("SI".to_owned(), format!("the density is {}", trimmed(rho, 4))))
        }
        rho if rho < 0.01 => Some(("ft-slug-s".to_owned(), format!("the density is {}", trimmed(rho, 4)))),
        _ => None,
    });
    let units = sheet.chosen(Field::choice("units", "unit system of the model", &UNITS), None, hint)?;
    let system = units.and_then(|units| {
        UnitSystem::NAMES.iter().find(|(name, _)| *name == units).map(|&(_, system)| system)
    });
    let Some(case) = chosen(sheet, &cases, system)? else { return Ok(()) };
    if let Some(system) = system {
        let length = system.length();
        for (name, key, factor) in [
            ("Sref_", "S", length * length),
            ("Cref_", "c", length),
            ("Bref_", "b", length),
            ("Rho_", "density", system.density()),
            ("Vinf_", "speed", length),
            ("AoA_", "alpha0_deg", 1.0),
            ("Mach_", "mach", 1.0),
        ] {
            if let Some(&(_, value, line, text)) = case.values.iter().find(|(known, ..)| *known == name) {
                sheet.find(key, value * factor, line, text);
            }
        }
    }
    let alpha = case.value("AoA_").unwrap_or(0.0).to_radians();
    longitudinal(sheet, case);
    lateral(sheet, case, alpha);
    controls(sheet, case, alpha)?;
    sheet.remark(
        "Rates over c/2V and b/2V, as here. CYβ is that of CFy, across the body: CS stands across the flow and has the drag in it. Rolling and \
         yawing moments were turned from body axes into stability axes.",
    );
    Ok(())
}

/// The tables of the file, one after another.
fn tables(text: &str) -> Result<Vec<Case<'_>>, Problem> {
    let mut cases = vec![Case::default()];
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.trim();
        let words: Vec<&str> = text.split_whitespace().collect();
        // A table ends before the stars of the next, or where its head comes again without them.
        let is_head = matches!(words[..], ["Sref_", ..] | ["Coef", "Total", ..]);
        let has_rows = cases.last().is_some_and(|case| !case.rows.is_empty());
        if text.starts_with("****") || is_head && has_rows {
            cases.push(Case::default());
        }
        let Some(case) = cases.last_mut() else { continue };
        match words.as_slice() {
            ["Coef", "Total", rest @ ..] => {
                case.columns = std::iter::once("Total").chain(rest.iter().copied()).collect();
            }
            ["#", "-", units @ ..] => {
                case.units = std::iter::once("-").chain(units.iter().copied()).collect()
            }
            [name, value, ..] if name.ends_with('_') || name.ends_with("_Rate") => {
                if let Some(value) = number(value) {
                    case.values.push((name, value, line, text));
                }
            }
            [name, rest @ ..] if ROWS.contains(name) && !case.columns.is_empty() => {
                let (expected, found) = (case.columns.len(), rest.len());
                if found != expected {
                    let problem = format!("{name}: expected {expected} numbers, one a column, found {found}");
                    return Err((line, problem));
                }
                case.rows.push((name, line, rest.iter().map(|word| number(word)).collect()));
            }
            _ => {}
        }
    }
    Ok(cases)
}

/// The case of an angle of attack: the only one, or chosen. That whose lift carries the weight is suggested, where the mass is typed.
fn chosen<'c, 't>(
    sheet: &mut Sheet,
    tables: &'c [Case<'t>],
    system: Option<UnitSystem>,
) -> Result<Option<&'c Case<'t>>, Problem> {
    let label = |case: &Case<'_>| {
        let [alpha, cl] = [case.value("AoA_"), case.entry("CL", "Total").map(|(cl, _)| cl)]
            .map(|x| trimmed(x.unwrap_or(f64::NAN), 4));
        format!("α {alpha}°, C_L {cl}")
    };
    let labels: Vec<String> = tables.iter().map(label).collect();
    let needed = sheet.fills.number("mass", "kg").ok().flatten().zip(system).and_then(|(mass, system)| {
        let length = system.length();
        let (rho, v) = (tables[0].value("Rho_")? * system.density(), tables[0].value("Vinf_")? * length);
        let s = tables[0].value("Sref_")? * length * length;
        Some(mass * crate::flight::analysis::STANDARD_GRAVITY / (0.5 * rho * v * v * s))
    });
    let suggestion = needed.and_then(|needed| {
        let distance =
            |case: &Case<'_>| case.entry("CL", "Total").map_or(f64::INFINITY, |(cl, _)| (cl - needed).abs());
        let best =
            (0..tables.len()).min_by(|&i, &j| distance(&tables[i]).total_cmp(&distance(&tables[j])))?;
        let why =
            format!("its lift is the nearest to C_L = {}, which carries the weight", trimmed(needed, 3));
        Some((best, why))
    });
    let chosen = cases::chosen(sheet, "angle of attack", &labels, suggestion)?;
    Ok(chosen.and_then(|k| tables.get(k)))
}

fn longitudinal(sheet: &mut Sheet, case: &Case<'_>) {
    for (row, column, key) in [
        ("CL", "Total", "CL"),
        ("CD", "Total", "CD"),
        ("CL", "Alpha", "CL_alpha"),
        ("CD", "Alpha", "CD_alpha"),
        ("CMm", "Alpha", "Cm_alpha"),
        ("CL", "q", "CL_q"),
        ("CMm", "q", "Cm_q"),
        ("CL", "Mach", "CL_M"),
        ("CD", "Mach", "CD_M"),
        ("CMm", "Mach", "Cm_M"),
    ] {
        if let Some((value, line)) = case.entry(row, column) {
            sheet.find(key, value, line, &format!("{row} by {column}"));
        }
    }
}

fn lateral(sheet: &mut Sheet, case: &Case<'_>, alpha: f64) {
    let (sin, cos) = alpha.sin_cos();
    for (column, keys) in [
        ("Beta", ["CY_beta", "Cl_beta", "Cn_beta"]),
        ("p", ["CY_p", "Cl_p", "Cn_p"]),
        ("r", ["CY_r", "Cl_r", "Cn_r"]),
    ] {
        let body = |row: &str| {
            let of = |column: &str| case.entry(row, column).map(|(value, _)| value);
            // ∂/∂pˢ = cos α ∂/∂p + sin α ∂/∂r,  ∂/∂rˢ = −sin α ∂/∂p + cos α ∂/∂r
            match column {
                "p" => Some(cos * of("p")? + sin * of("r")?),
                "r" => Some(cos * of("r")? - sin * of("p")?),
                other => of(other),
            }
        };
        let line = case.entry("CMl", column).map_or(0, |(_, line)| line);
        if let (Some(y), Some(l), Some(n)) = (body("CFy"), body("CMl"), body("CMn")) {
            let [y_key, l_key, n_key] = keys;
            let text = |row: &str| format!("{row} by {column}");
            sheet.find(y_key, y, line, &text("CFy"));
            // Clˢ = Cl cos α + Cn sin α,  Cnˢ = −Cl sin α + Cn cos α
            sheet.find(l_key, l * cos + n * sin, line, &text("CMl"));
            sheet.find(n_key, n * cos - l * sin, line, &text("CMn"));
        }
    }
}

/// The groups of controls, whose names the file doesn't tell.
fn controls(sheet: &mut Sheet, case: &Case<'_>, alpha: f64) -> Result<(), Problem> {
    let (sin, cos) = alpha.sin_cos();
    for (k, group) in case.columns.iter().enumerate().filter(|(_, name)| name.starts_with("ConGrp")) {
        let mut field = Field::choice(group, "what this group of controls is", &GROUPS);
        field.required = false;
        let chosen = sheet.chosen(field, Some("none"), None)?.unwrap_or_default();
        let factor = if case.units.get(k) == Some(&"deg") { 1_f64.to_degrees() } else { 1.0 };
        let of = |row: &str| case.entry(row, group).map(|(value, line)| (value * factor, line));
        let keys = match chosen.as_str() {
            "elevator" => ["Cm_de", "CMm"],
            "aileron" => ["Cl_da", "CMl"],
            "rudder" => ["Cn_dr", "CMn"],
            _ => continue,
        };
        if sheet.finds(keys[0]).is_some() {
            sheet.remark(format!("{group} is left out: another group is the {chosen} already."));
            continue;
        }
        if of(keys[1]).is_none() {
            let sentence = format!(
                "{group} is to be the {chosen}, and its column has no number in the row {}.",
                keys[1]
            );
            sheet.stop("controls", sentence, Vec::new());
            continue;
        }
        match chosen.as_str() {
            "elevator" => {
                for (row, key) in [("CL", "CL_de"), ("CD", "CD_de"), ("CMm", "Cm_de")] {
                    if let Some((value, line)) = of(row) {
                        sheet.find(key, value, line, &format!("{row} by {group}"));
                    }
                }
            }
            "aileron" | "rudder" => {
                let keys = if chosen == "aileron" {
                    ["CY_da", "Cl_da", "Cn_da"]
                } else {
                    ["CY_dr", "Cl_dr", "Cn_dr"]
                };
                if let (Some((y, line)), Some((l, _)), Some((n, _))) = (of("CFy"), of("CMl"), of("CMn")) {
                    for (key, value) in keys.into_iter().zip([y, l * cos + n * sin, n * cos - l * sin]) {
                        sheet.find(key, value, line, group);
                    }
                }
            }
            _ => {}
        }
    }
    Ok(())
}
