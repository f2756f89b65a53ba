//! AVL's stability derivatives (`.st`), with its mass file (`.mass`) beside them.
//!
//! Stability axes, rates over c/2V and b/2V, controls by the unit of the control variable. Lengths are in the unit of the geometry,
//! which only the mass file tells.

use super::cases::{self, Line};
use super::review::Field;
use super::scan::{Pair, pairs};
use super::sheet::Sheet;
use crate::content::matrix::draft::Problem;
use crate::content::matrix::state_names::control;
use crate::number::{significant, trimmed};

/// AVL's names of what an aircraft file has, in the order force or moment, by what.
const NAMES: [(&str, &str); 16] = [
    ("CLtot", "CL"),
    ("CDtot", "CD"),
    ("CLa", "CL_alpha"),
    ("CDa", "CD_alpha"),
    ("Cma", "Cm_alpha"),
    ("CLq", "CL_q"),
    ("Cmq", "Cm_q"),
    ("CYb", "CY_beta"),
    ("Clb", "Cl_beta"),
    ("Cnb", "Cn_beta"),
    ("CYp", "CY_p"),
    ("Clp", "Cl_p"),
    ("Cnp", "Cn_p"),
    ("CYr", "CY_r"),
    ("Clr", "Cl_r"),
    ("Cnr", "Cn_r"),
];

/// What a control of ours does, by AVL's force or moment.
const CONTROLS: [(&str, [(&str, &str); 3]); 3] = [
    ("elevator", [("CL", "CL_de"), ("CD", "CD_de"), ("Cm", "Cm_de")]),
    ("aileron", [("CY", "CY_da"), ("Cl", "Cl_da"), ("Cn", "Cn_da")]),
    ("rudder", [("CY", "CY_dr"), ("Cl", "Cl_dr"), ("Cn", "Cn_dr")]),
];

const LENGTHS: [(&str, &str, f64); 5] = [
    ("m", "metres", 1.0),
    ("ft", "feet", 0.3048),
    ("in", "inches", 0.0254),
    ("cm", "centimetres", 0.01),
    ("mm", "millimetres", 0.001),
];

const CONTROL_UNITS: [(&str, &str); 2] = [("deg", "degrees, a gain of 1"), ("rad", "radians")];

/// Reads the stability derivatives; the mass file was read before.
pub(super) fn read(sheet: &mut Sheet, text: &str, mass: Option<&MassFile>) -> Result<(), Problem> {
    let lines: Vec<(usize, &str)> = (1..).zip(text.lines()).collect();
    let Some(lines) = case(sheet, &lines)? else { return Ok(()) };
    if let Some(title) = lines.iter().find_map(|(_, line)| line.trim().strip_prefix("Configuration:")) {
        sheet.review.title = title.trim().to_owned();
    }
    let length = length_unit(sheet, mass)?;
    let unit = control_unit(sheet)?;
    let controls = control_names(lines);
    let mut x_reference = None;
    for &(line, text) in lines {
        // Clb Cnr / Clr Cnb = 2.4 is no Cnb.
        if text.contains(" / ") {
            continue;
        }
        for pair in pairs(text) {
            let Pair { name, value, text, .. } = pair;
            if let Some(&(_, key)) = NAMES.iter().find(|(known, _)| *known == name) {
                sheet.find(key, value, line, text);
            } else if let Some((key, factor)) = of_control(name, &controls).map(|key| (key, unit)) {
                sheet.find(key, value * factor, line, text);
            } else {
                match (name, length) {
                    ("Sref", Some(length)) => sheet.find("S", value * length * length, line, text),
                    ("Cref", Some(length)) => sheet.find("c", value * length, line, text),
                    ("Bref", Some(length)) => sheet.find("b", value * length, line, text),
                    ("Xref", _) => x_reference = Some(value),
                    ("Alpha", _) => sheet.find("alpha0_deg", value, line, text),
                    ("Mach", _) => sheet.find("mach", value, line, text),
                    ("e", _) => sheet.span_efficiency = Some(value),
                    ("CDvis", _) if value == 0.0 => {
                        let drag = "CDvis is 0: the drag is that of lift alone, without friction. The phugoid is damped by the whole \
                                    drag; type CD where you know it.";
                        sheet.warn("drag", drag, Vec::new());
                    }
                    _ => {}
                }
            }
        }
    }
    if sheet.finds("CL_alpha").is_none() {
        return Err((1, "expected AVL’s stability-axis derivatives, CLa = …, found none".to_owned()));
    }
    say_controls(sheet, &controls, unit);
    sheet.remark(
        "Stability axes; rates over c/2V and b/2V, as here. AVL knows no derivatives by speed or by the rate of α. Its MODE \
         menu adds the apparent mass and inertia of the air to those of the mass file; here none are added.");
    if let Some(mass) = mass {
        apply_mass(sheet, mass, x_reference);
    }
    Ok(())
}

/// The lines of one run case; `None` while it isn't chosen.
fn case<'s, 't>(sheet: &mut Sheet, lines: &'s [Line<'t>]) -> Result<Option<&'s [Line<'t>]>, Problem> {
    let cases = cases::parted(
        lines,
        |text| text.contains("Stability-axis derivatives").then_some(0),
        |_, seen| !seen.is_empty(),
        |text| {
            ["Vortex Lattice Output", "Configuration:", "Sref", "Run case:", "Alpha ="]
                .iter()
                .any(|beginning| text.contains(beginning))
        },
    );
    let words = |lines: &&[Line<'_>]| {
        let alpha = lines.iter().flat_map(|(_, line)| pairs(line)).find(|pair| pair.name == "Alpha");
        let name =
            lines.iter().find_map(|(_, line)| line.trim().strip_prefix("Run case:")).unwrap_or("").trim();
        let alpha = alpha.map_or(f64::NAN, |pair| pair.value);
        format!("{name}, α {}°", trimmed(alpha, 4))
    };
    let words: Vec<String> = cases.iter().map(words).collect();
    Ok(cases::chosen(sheet, "run case", &words, None)?.and_then(|k| cases.get(k).copied()))
}

/// The geometry's unit of length in metres: of the mass file, or chosen.
fn length_unit(sheet: &mut Sheet, mass: Option<&MassFile>) -> Result<Option<f64>, Problem> {
    if let Some(mass) = mass {
        return Ok(Some(mass.length));
    }
    let choices = LENGTHS.map(|(key, words, _)| (key, words));
    let field =
        Field::choice("length_unit", "unit of length of the geometry; AVL’s file doesn’t say it", &choices);
    let chosen = sheet.chosen(field, None, None)?;
    Ok(chosen
        .and_then(|chosen| LENGTHS.iter().find(|(key, ..)| *key == chosen))
        .map(|&(_, _, metres)| metres))
}

/// How many of a control variable's unit make a radian.
pub(super) fn control_unit(sheet: &mut Sheet) -> Result<f64, Problem> {
    let mut field = Field::choice("control_unit", "unit of the control variables", &CONTROL_UNITS);
    field.required = false;
    let chosen = sheet.chosen(field, Some("deg"), None)?;
    Ok(if chosen.as_deref() == Some("rad") { 1.0 } else { 1_f64.to_degrees() })
}

/// The numbers of the controls by their names: `elevator     d4`.
fn control_names(lines: &[(usize, &str)]) -> Vec<(String, usize)> {
    let number = |word: &str| word.strip_prefix('d')?.parse::<usize>().ok();
    for (_, line) in lines.iter().filter(|(_, line)| !line.contains('=')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let named: Vec<(String, usize)> = words
            .windows(2)
            .filter_map(|pair| {
                number(pair[0]).is_none().then(|| Some((pair[0].to_owned(), number(pair[1])?)))?
            })
            .collect();
        if !named.is_empty() {
            return named;
        }
    }
    Vec::new()
}

/// Our key of a derivative by a control: `Cmd4`, `Cmd04`.
fn of_control(name: &str, controls: &[(String, usize)]) -> Option<&'static str> {
    let (force, number) = name.split_once('d')?;
    let number: usize = number.parse().ok()?;
    let (name, _) = controls.iter().find(|(_, known)| *known == number)?;
    let meant = control(name)?;
    let (_, derivatives) = CONTROLS.iter().find(|(key, _)| *key == meant)?;
    derivatives.iter().find(|(known, _)| *known == force).map(|&(_, key)| key)
}

fn say_controls(sheet: &mut Sheet, controls: &[(String, usize)], unit: f64) {
    let is_ours = |name: &str| control(name).is_some_and(|key| key != "throttle");
    let left_out: Vec<&str> =
        controls.iter().map(|(name, _)| name.as_str()).filter(|name| !is_ours(name)).collect();
    if !left_out.is_empty() {
        sheet.remark(format!("Controls that have no place here are left out: {}.", left_out.join(", ")));
    }
    if controls.len() > left_out.len() && unit != 1.0 {
        sheet.remark("Derivatives by controls are read as by degrees, the unit of AVL’s control variable with a gain of 1.");
    }
}

/// What a mass file says, SI.
#[derive(Clone, Debug)]
pub(super) struct MassFile {
    /// The geometry's unit of length in metres.
    pub length: f64,
    pub mass: f64,
    /// Ix, Iy, Iz, Ixz about the centre of gravity.
    pub inertia: [f64; 4],
    /// Centre of gravity along x, in the geometry's unit.
    pub x: f64,
    pub gravity: Option<f64>,
    pub density: Option<f64>,
}

impl MassFile {
    /// Reads the masses, each about its own centre of gravity, and adds them up.
    pub fn read(text: &str) -> Result<Self, Problem> {
        let (mut length, mut unit_mass) = (1.0, 1.0);
        // The units that g and ρ are in: those in which Lunit and Munit are given.
        let (mut named_length, mut named_mass) = (1.0, 1.0);
        let (mut gravity, mut density) = (None, None);
        let (mut factors, mut added) = ([1.0; 10], [0.0; 10]);
        let mut items: Vec<[f64; 10]> = Vec::new();
        for (line, text) in (1..).zip(text.lines()) {
            let text = text.split(['#', '!']).next().unwrap_or_default();
            if let Some(Pair { name, value, unit, .. }) = pairs(text).into_iter().next() {
                let metres =
                    LENGTHS.iter().find(|(key, ..)| *key == unit).map_or(1.0, |&(_, _, metres)| metres);
                let kilograms = match unit {
                    "g" => 1e-3,
                    "lb" | "lbm" => 0.453_592_37,
                    "slug" | "slugs" => 14.593_902_937_206_364,
                    _ => 1.0,
                };
                match name {
                    "Lunit" => (length, named_length) = (value * metres, metres),
                    "Munit" => (unit_mass, named_mass) = (value * kilograms, kilograms),
                    "g" => gravity = Some(value),
                    "rho" => density = Some(value),
                    _ => {}
                }
                continue;
            }
            let text = text.trim();
            let (mark, numbers) = match text.strip_prefix(['*', '+']) {
                Some(rest) => (text.chars().next(), rest),
                None => (None, text),
            };
            if numbers.trim().is_empty() {
                continue;
            }
            let row = super::scan::numbers(&numbers.replace(',', " ")).ok_or_else(|| {
                (line, format!("expected a row of numbers, mass x y z Ixx Iyy Izz, found “{numbers}”"))
            })?;
            let fill = |usual: f64| {
                let mut all = [usual; 10];
                all.iter_mut().zip(&row).for_each(|(place, x)| *place = *x);
                all
            };
            match mark {
                Some('*') => factors = fill(1.0),
                Some(_) => added = fill(0.0),
                None if row.len() >= 4 => {
                    let row = fill(0.0);
                    items.push(std::array::from_fn(|k| row[k] * factors[k] + added[k]));
                }
                None => {
                    return Err((
                        line,
                        format!("expected mass, x, y and z at least, found {} numbers", row.len()),
                    ));
                }
            }
        }
        let mass: f64 = items.iter().map(|item| item[0]).sum();
        if !(mass.is_finite() && mass > 0.0) {
            return Err((1, "the masses of the file add up to no positive number".to_owned()));
        }
        let centre = |axis: usize| items.iter().map(|item| item[0] * item[axis]).sum::<f64>() / mass;
        let [x, y, z] = [centre(1), centre(2), centre(3)];
        let mut inertia = [0.0; 4];
        for item in &items {
            let [m, dx, dy, dz] = [item[0], item[1] - x, item[2] - y, item[3] - z];
            // Ix = Σ Ixx + m (y² + z²), …; columns 4, 5, 6 are Ixx, Iyy, Izz, and 8 is Ixz
            inertia[0] += item[4] + m * (dy * dy + dz * dz);
            inertia[1] += item[5] + m * (dx * dx + dz * dz);
            inertia[2] += item[6] + m * (dx * dx + dy * dy);
            // x aft and z up: both turned, so that x z keeps its sign.
            inertia[3] += item[8] + m * dx * dz;
        }
        let unit = unit_mass * length * length;
        Ok(Self {
            length,
            mass: mass * unit_mass,
            inertia: inertia.map(|x| x * unit),
            x,
            gravity: gravity.map(|g| g * named_length),
            density: density.map(|rho| rho * named_mass / (named_length * named_length * named_length)),
        })
    }
}

fn apply_mass(sheet: &mut Sheet, file: &MassFile, x_reference: Option<f64>) {
    sheet.find("mass", file.mass, 0, "sum of the mass file");
    for (key, value) in ["Ix", "Iy", "Iz", "Ixz"].into_iter().zip(file.inertia) {
        sheet.find(key, value, 0, "mass file, about the centre of gravity");
    }
    if let Some(gravity) = file.gravity {
        sheet.find("gravity", gravity, 0, "g of the mass file");
    }
    if let Some(density) = file.density {
        sheet.find("density", density, 0, "rho of the mass file");
    }
    if let (Some(reference), Some(chord)) = (x_reference, sheet.finds("c")) {
        let apart = (file.x - reference) * file.length / chord;
        if apart.abs() > 0.005 {
            sheet.warn(
                "centre-of-gravity",
                format!(
                    "The derivatives are about Xref = {}, the centre of the masses is at {}: {} % of the chord apart. Run AVL about the \
                     centre of gravity.",
                    significant(reference, 5),
                    significant(file.x, 5),
                    trimmed(100.0 * apart, 3)
                ),
                Vec::new(),
            );
        }
    }
}
