//! A system parted into its two planes of motion, each with the states that are kept beside its four, and what is left out of both. What
//! that costs is told by how far the eigenvalues move.

use super::further;
use super::part::Part;
use super::sheet::Sheet;
use super::system::{HARDLY, System, largest_shift, upper};
use crate::content::matrix::state_names::{control, plane_of_control};
use crate::flight::aircraft::plane::Plane;
use crate::number::{significant, trimmed};

/// How far an eigenvalue may move before it is more than a remark.
const MUCH: f64 = 0.05;
/// How far a kinematic row may be from whole numbers to be rounding, or a bank of a few minutes of arc.
const ROUNDING: f64 = 1e-4;

/// The planes that the system has all four states of.
pub(super) fn part(sheet: &mut Sheet, system: &System, line: usize) -> Vec<Part> {
    let mut parts = Vec::new();
    for plane in Plane::ALL {
        let found = system.plane(plane);
        let Some(states) = found.iter().copied().collect::<Option<Vec<usize>>>() else { continue };
        let Ok(states) = <[usize; 4]>::try_from(states) else { continue };
        parts.push(Part {
            plane,
            states,
            further: Vec::new(),
            a: system.part(&states),
            inputs: Vec::new(),
            b: Vec::new(),
        });
    }
    if parts.is_empty() {
        say_incomplete(sheet, system, line);
        return parts;
    }
    further::share_out(system, &mut parts);
    for part in &mut parts {
        let (inputs, columns) = controls(sheet, system, part);
        part.b = (0..4).map(|i| columns.iter().map(|column| column[part.states[i]]).collect()).collect();
        part.inputs = inputs;
    }
    let kept: Vec<usize> = parts.iter().flat_map(Part::all).collect();
    let left_out: Vec<usize> = (0..system.names.len()).filter(|k| !kept.contains(k)).collect();
    further::say_kept(sheet, system, &parts);
    say_left_out(sheet, system, &parts, &kept, &left_out);
    if parts.len() == 2 {
        say_coupling(sheet, system, &parts, &kept);
    }
    parts
}

/// The inputs that move the four states of a plane, and the column of each: of B, or of A where the control is a state with a lag of its
/// own.
fn controls(sheet: &mut Sheet, system: &System, part: &Part) -> (Vec<&'static str>, Vec<Vec<f64>>) {
    let mut found: Vec<&'static str> = Vec::new();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for further in &part.further {
        let (k, Some(key)) = (further.place, further.control()) else { continue };
        let lag = -system.a[k][k];
        let lag = if lag > 0.0 {
            format!(", which follows its command with {} s of lag", significant(1.0 / lag, 3))
        } else {
            String::new()
        };
        sheet
            .remark(format!("{} is a control{lag}: it is kept as a state beside the four.", system.names[k]));
        if further.command(system).is_none() && -system.a[k][k] > 0.0 {
            sheet.remark(format!(
                "No input commands {}; it is given one that it follows fully after a while.",
                system.names[k]
            ));
        }
        found.push(key);
        columns.push(system.a.iter().map(|row| row[k]).collect());
    }
    for (k, name) in system.inputs.iter().enumerate() {
        let Some(key) = control(name).filter(|key| plane_of_control(key) == part.plane) else { continue };
        let column: Vec<f64> = system.b.iter().map(|row| row[k]).collect();
        if found.contains(&key) {
            if part.states.iter().any(|&i| column[i] != 0.0) {
                sheet.remark(format!(
                    "What the input {name} does to the four states at once is left out: there is another {key}."
                ));
            }
            continue;
        }
        found.push(key);
        columns.push(column);
    }
    (found, columns)
}

/// The file has no plane of motion as a whole.
fn say_incomplete(sheet: &mut Sheet, system: &System, line: usize) {
    let names = |plane| match plane {
        Plane::Longitudinal => ["the speed u", "w or α", "the pitch rate q", "the pitch angle θ"],
        Plane::Lateral => ["v or β", "the roll rate p", "the yaw rate r", "the bank φ"],
    };
    let missing = |plane: Plane| -> Vec<&str> {
        system
            .plane(plane)
            .iter()
            .zip(names(plane))
            .filter(|(place, _)| place.is_none())
            .map(|(_, name)| name)
            .collect()
    };
    let plane =
        Plane::ALL.into_iter().min_by_key(|&plane| missing(plane).len()).unwrap_or(Plane::Longitudinal);
    let mut sentence = format!(
        "There are {} states, {}. A plane of motion has four: {} is missing.",
        system.names.len(),
        system.names.join(", "),
        missing(plane).join(" and ")
    );
    let [_, _, rate, angle] = system.plane(Plane::Longitudinal);
    if let (Plane::Longitudinal, Some(rate), Some(angle)) = (plane, rate, angle) {
        let factor = system.a[angle][rate];
        if factor != 1.0 {
            sentence.push_str(&format!(
                " And the row of θ says θ̇ = {} q, where pitch rate is the rate of pitch angle: θ̇ = q. Is the column of q in another unit of time?",
                trimmed(factor, 5)
            ));
        }
    }
    sheet.stop_on_line(line, "states", sentence, Vec::new());
}

/// What is left out beside the rigid-body states, and what difference that makes.
fn say_left_out(sheet: &mut Sheet, system: &System, parts: &[Part], kept: &[usize], left_out: &[usize]) {
    let mut feeding = Vec::new();
    let mut plain = Vec::new();
    for &k in left_out {
        let feeds = kept.iter().any(|&i| system.a[i][k] != 0.0);
        let told = format!("{} ({})", system.names[k], further::word(system.meanings[k]));
        if feeds { feeding.push((k, told)) } else { plain.push(told) }
    }
    match plain.as_slice() {
        [] => {}
        [one] => sheet
            .remark(format!("{one} is left out: nothing depends on it, so no eigenvalue of the rest moves.")),
        many => sheet.remark(format!(
            "{} are left out: nothing depends on them, so no eigenvalue of the rest moves.",
            many.join(", ")
        )),
    }
    let rigid = [system.part(kept)];
    let mut hardly = Vec::new();
    for (k, told) in feeding {
        // Each by itself, beside the states of the planes.
        let with: Vec<usize> = kept.iter().copied().chain([k]).collect();
        let Some(shift) = largest_shift(&rigid, &system.part(&with)) else {
            let sentence = format!("{told} is left out; what difference that makes could not be computed.");
            sheet.warn("left-out", sentence, Vec::new());
            continue;
        };
        if shift.relative < HARDLY {
            hardly.push(told);
            continue;
        }
        let sentence = format!(
            "{told} is left out. With it the eigenvalue {} would be {}: {} %, the most that any moves.",
            upper(shift.alone),
            upper(shift.together),
            significant(100.0 * shift.relative, 2)
        );
        if shift.relative > MUCH {
            sheet.warn("left-out", sentence, Vec::new())
        } else {
            sheet.remark(sentence)
        }
    }
    if !hardly.is_empty() {
        let verb = if hardly.len() == 1 { "is" } else { "are" };
        sheet.remark(format!(
            "{} {verb} left out: no eigenvalue moves by more than 0.01 %.",
            hardly.join(", ")
        ));
    }
    let controls: Vec<&str> = parts.iter().flat_map(|part| part.inputs.iter().copied()).collect();
    let unused: Vec<&str> = system
        .inputs
        .iter()
        .filter(|name| control(name).is_none_or(|key| !controls.contains(&key)))
        .map(String::as_str)
        .collect();
    if !unused.is_empty() {
        let verb = if unused.len() == 1 { "is no control" } else { "are no controls" };
        sheet.remark(format!("{} {verb} that these planes have here, and left out.", unused.join(", ")));
    }
}

/// How much the planes have to do with each other.
fn say_coupling(sheet: &mut Sheet, system: &System, parts: &[Part], kept: &[usize]) {
    let crosses = parts.iter().any(|part| {
        let all = part.all();
        let others = kept.iter().filter(|k| !all.contains(k));
        all.iter().any(|&i| others.clone().any(|&j| system.a[i][j] != 0.0))
    });
    if !crosses {
        sheet.remark("The two planes are parted: no entry of A couples them.");
        return;
    }
    let apart: Vec<Vec<Vec<f64>>> = parts.iter().map(|part| system.part(&part.all())).collect();
    let Some(shift) = largest_shift(&apart, &system.part(kept)) else {
        sheet.warn(
            "coupling",
            "The two planes are parted; how much that costs could not be computed.",
            Vec::new(),
        );
        return;
    };
    let sentence = format!(
        "The two planes are parted. Together the eigenvalue {} would be {}: {} %, the most that any moves.",
        upper(shift.alone),
        upper(shift.together),
        significant(100.0 * shift.relative, 2)
    );
    if shift.relative > MUCH {
        sheet.warn("coupling", sentence, Vec::new());
    } else {
        sheet.remark(sentence);
    }
}

/// θ̇ = q and φ̇ = p + r tan θ₀ to the last digit, where the file has them but for rounding; it is told.
pub(super) fn round_kinematics(sheet: &mut Sheet, plane: Plane, a: &mut [Vec<f64>]) {
    let (rate, free, symbol, name) = match plane {
        Plane::Longitudinal => (2, None, "θ̇ = q", "theta"),
        Plane::Lateral => (1, Some(2), "φ̇ = p + r tan θ₀", "phi"),
    };
    let expected = |j: usize| if j == rate { 1.0 } else { 0.0 };
    let off = |row: &[f64]| {
        let departures =
            row.iter().enumerate().filter(|(j, _)| Some(*j) != free).map(|(j, x)| (x - expected(j)).abs());
        departures.fold(0.0, f64::max)
    };
    let departure = off(&a[3]);
    if departure == 0.0 || departure > ROUNDING || departure.is_nan() {
        return;
    }
    for (j, entry) in a[3].iter_mut().enumerate().filter(|(j, _)| Some(*j) != free) {
        *entry = expected(j);
    }
    sheet.remark(format!(
        "The row of {name} is {} off {symbol}, and was rounded to it.",
        significant(departure, 2)
    ));
}
