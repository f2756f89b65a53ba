//! Digital DATCOM's output (`for006.dat`): tables over the angle of attack for each flight condition, by degree or by radian.
//!
//! The first character of a line is a control of the printer. CYB and CNB are printed once, in the first row, and hold for the others.
//! CN is the normal force; CNB is yaw.

use super::cases;
use super::sheet::Sheet;
use crate::content::matrix::draft::{Problem, number};
use crate::number::{significant, trimmed};

const STATIC: &str = "CHARACTERISTICS AT ANGLE OF ATTACK AND IN SIDESLIP";
const DYNAMIC: &str = "DYNAMIC DERIVATIVES (PER";
const CONTROLS: &str = "CHARACTERISTICS OF HIGH LIFT AND CONTROL DEVICES";

/// Our keys of the columns that are by an angle.
const STATIC_COLUMNS: [(&str, &str); 5] =
    [("CLA", "CL_alpha"), ("CMA", "Cm_alpha"), ("CYB", "CY_beta"), ("CNB", "Cn_beta"), ("CLB", "Cl_beta")];
const DYNAMIC_COLUMNS: [(&str, &str); 9] = [
    ("CLQ", "CL_q"),
    ("CMQ", "Cm_q"),
    ("CLAD", "CL_alphadot"),
    ("CMAD", "Cm_alphadot"),
    ("CLP", "Cl_p"),
    ("CYP", "CY_p"),
    ("CNP", "Cn_p"),
    ("CNR", "Cn_r"),
    ("CLR", "Cl_r"),
];
/// Columns whose first row holds for all.
const ONCE: [&str; 4] = ["CYB", "CNB", "CLQ", "CMQ"];

/// The middle of a number is no farther from that of its column's name, in half characters; half a column is more.
const FARTHEST: usize = 10;

/// A table over the angle of attack.
#[derive(Default)]
struct Table<'t> {
    columns: Vec<&'t str>,
    /// Line and its entries, `None` for a blank or NA.
    rows: Vec<(usize, Vec<Option<f64>>)>,
    by_degree: bool,
}

impl Table<'_> {
    fn entry(&self, k: usize, column: &str) -> Option<(f64, usize)> {
        let at = self.columns.iter().position(|known| *known == column)?;
        let row = if ONCE.contains(&column) && self.rows.get(k)?.1.get(at)?.is_none() { 0 } else { k };
        let (line, entries) = self.rows.get(row)?;
        Some(((*entries.get(at)?)?, *line))
    }

    fn by_radian(&self) -> f64 {
        if self.by_degree { 1_f64.to_degrees() } else { 1.0 }
    }
}

/// One flight condition with its tables.
struct Condition<'t> {
    line: usize,
    flight: Vec<f64>,
    in_feet: bool,
    statics: Table<'t>,
    dynamics: Table<'t>,
    /// C_L and Cm by the elevator \[1/rad\], with the line.
    elevator: Option<(f64, f64, usize)>,
    title: String,
}

pub(super) fn read(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    // The printer's controls stand in the first column, wherever a mail has moved it.
    let indent = |line: &str| line.len() - line.trim_start_matches(' ').len();
    let margin = text.lines().filter(|line| !line.trim().is_empty()).map(indent).min().unwrap_or(0);
    let lines: Vec<&str> = text.lines().map(|line| line.get(margin..).unwrap_or_default()).collect();
    let starts: Vec<usize> = (0..lines.len()).filter(|&k| lines[k].contains(STATIC)).collect();
    let mut conditions = Vec::new();
    for (k, &start) in starts.iter().enumerate() {
        let end = starts.get(k + 1).copied().unwrap_or(lines.len());
        conditions.extend(condition(&lines, start, end)?);
    }
    if conditions.is_empty() {
        return Err((1, format!("expected a table “{STATIC}” with numbers, found none")));
    }
    let Some((condition, row)) = chosen(sheet, &conditions)? else { return Ok(()) };
    sheet.review.title.clone_from(&condition.title);
    flight(sheet, condition);
    let Condition { statics, dynamics, .. } = condition;
    let of = |key: &str| statics.entry(row, key);
    if let Some((alpha, line)) = of("ALPHA") {
        sheet.find("alpha0_deg", alpha, line, "ALPHA");
    }
    for (column, key) in [("CL", "CL"), ("CD", "CD")] {
        if let Some((value, line)) = of(column) {
            sheet.find(key, value, line, column);
        }
    }
    for (table, columns) in [(statics, &STATIC_COLUMNS[..]), (dynamics, &DYNAMIC_COLUMNS[..])] {
        for &(column, key) in columns {
            if let Some((value, line)) = table.entry(row, column) {
                let unit = if table.by_degree { " per degree" } else { "" };
                sheet.find(
                    key,
                    value * table.by_radian(),
                    line,
                    &format!("{column} = {}{unit}", significant(value, 5)),
                );
            }
        }
    }
    drag_rise(sheet, statics, row);
    if let Some((lift, moment, line)) = condition.elevator {
        sheet.find("CL_de", lift, line, "D(CL) by DELTA, about 0");
        sheet.find("Cm_de", moment, line, "D(CM) by DELTA, about 0");
    }
    if statics.by_degree {
        sheet.remark("The derivatives are by degree in this file, and by radian here.");
    }
    sheet.remark(
        "Taken as in stability axes, rates over c/2V and b/2V, as the manual has them. DATCOM gives no CYr.",
    );
    Ok(())
}

/// The tables between two lines.
fn condition<'t>(lines: &[&'t str], start: usize, end: usize) -> Result<Option<Condition<'t>>, Problem> {
    let at = |from: usize, text: &str| (from..end).find(|&k| lines[k].contains(text));
    let Some(units) = at(start, "/SEC") else { return Ok(None) };
    let (Some(numbers), Some(heading)) = (lines.get(units + 1), at(start, "DERIVATIVE (PER")) else {
        return Ok(None);
    };
    let flight: Vec<f64> = body(numbers).split_whitespace().map_while(number).collect();
    let statics = table(lines, heading, end)?;
    let dynamics = at(start, DYNAMIC).map(|k| table(lines, k, end)).transpose()?.unwrap_or_default();
    let elevator = at(start, CONTROLS)
        .filter(|&k| below(lines, k + 1, end.min(k + 3)).iter().any(|line| line.contains("TAIL")))
        .and_then(|k| elevator(lines, k, end));
    // The last line before the head of the table is the case's name.
    let is_name = |line: &String| {
        let is_head = ["MACH", "NUMBER", "-----"].iter().any(|start| line.starts_with(start));
        !line.is_empty() && !is_head
    };
    let title = below(lines, start + 1, units).iter().map(|line| body(line).trim().to_owned()).rfind(is_name);
    Ok((!statics.rows.is_empty()).then(|| Condition {
        line: units + 2,
        flight,
        in_feet: lines[units].contains("FT/SEC"),
        statics,
        dynamics,
        elevator,
        title: title.unwrap_or_default(),
    }))
}

/// The lines between two; none where a cut file has them the other way round.
fn below<'l, 't>(lines: &'l [&'t str], from: usize, to: usize) -> &'l [&'t str] {
    lines.get(from..to).unwrap_or_default()
}

/// A line without the control of the printer at its beginning.
fn body(line: &str) -> &str {
    line.strip_prefix(['0', '1', '+']).unwrap_or(line)
}

/// The words of a line with the place of their middle, in half characters.
fn words(line: &str) -> Vec<(&str, usize)> {
    let mut words = Vec::new();
    let mut from = 0;
    for word in line.split_whitespace() {
        let start = line[from..].find(word).map_or(from, |at| from + at);
        from = start + word.len();
        words.push((word, start + from));
    }
    words
}

/// The table below a heading.
fn table<'t>(lines: &[&'t str], heading: usize, end: usize) -> Result<Table<'t>, Problem> {
    let mut table = Table { by_degree: lines[heading].contains("DEGREE"), ..Table::default() };
    let Some(head) = (heading..end.min(heading + 4)).find(|&k| lines[k].contains("ALPHA")) else {
        return Ok(table);
    };
    let columns = words(lines[head]);
    // The printer's control may stand before the first word.
    let columns: Vec<(&str, usize)> = columns
        .into_iter()
        .filter(|(word, _)| *word != "0")
        .map(|(word, place)| (body(word), place))
        .collect();
    table.columns = columns.iter().map(|(word, _)| *word).collect();
    for (k, line) in lines.iter().enumerate().take(end).skip(head + 1) {
        let found = words(line);
        match found.as_slice() {
            [] | [("0", _)] if table.rows.is_empty() => continue,
            [(first, _), ..] if line.starts_with(' ') && number(first).is_some() => {}
            _ => break,
        }
        let mut row = vec![None; columns.len()];
        let mut next = 0;
        let is_full = found.len() == columns.len();
        for (at, (word, place)) in found.into_iter().enumerate() {
            let nearest = (next..columns.len()).min_by_key(|&column| columns[column].1.abs_diff(place));
            let Some(column) = nearest.map(|column| if is_full { at } else { column }) else { break };
            if !is_full && columns[column].1.abs_diff(place) > FARTHEST {
                return Err((
                    k + 1,
                    format!(
                        "{word} is not below the name of a column; are the columns those that DATCOM has printed?"
                    ),
                ));
            }
            row[column] = number(word);
            next = column + 1;
        }
        table.rows.push((k + 1, row));
    }
    Ok(table)
}

/// What a tail flap does about its neutral position.
fn elevator(lines: &[&str], from: usize, end: usize) -> Option<(f64, f64, usize)> {
    let head = (from..end).find(|&k| lines[k].contains("DELTA") && lines[k].contains("D(CM)"))?;
    let rows =
        below(lines, head + 1, end).iter().skip_while(|line| line.trim().is_empty()).map_while(|line| {
            let row: Vec<f64> = line.split_whitespace().map_while(number).collect();
            (row.len() >= 3).then(|| [row[0], row[1], row[2]])
        });
    let rows: Vec<[f64; 3]> = rows.collect();
    let below = rows.iter().filter(|row| row[0] < 0.0).max_by(|x, y| x[0].total_cmp(&y[0]))?;
    let above = rows.iter().filter(|row| row[0] > 0.0).min_by(|x, y| x[0].total_cmp(&y[0]))?;
    let span = (above[0] - below[0]).to_radians();
    Some(((above[1] - below[1]) / span, (above[2] - below[2]) / span, head + 2))
}

/// The condition and the row of its table.
fn chosen<'c, 't>(
    sheet: &mut Sheet,
    conditions: &'c [Condition<'t>],
) -> Result<Option<(&'c Condition<'t>, usize)>, Problem> {
    let cases: Vec<(&Condition<'t>, usize)> = conditions
        .iter()
        .flat_map(|condition| (0..condition.statics.rows.len()).map(move |row| (condition, row)))
        .collect();
    let shown = |x: Option<f64>| x.map_or_else(|| "–".to_owned(), |x| trimmed(x, 4));
    let label = |(condition, row): &(&Condition<'_>, usize)| {
        let of = |column| condition.statics.entry(*row, column).map(|(value, _)| value);
        let unit = if condition.in_feet { "ft" } else { "m" };
        let [mach, altitude] = [0, 1].map(|k| shown(condition.flight.get(k).copied()));
        format!("Mach {mach}, {altitude} {unit}, α {}°, C_L {}", shown(of("ALPHA")), shown(of("CL")))
    };
    let labels: Vec<String> = cases.iter().map(label).collect();
    let mass = sheet.fills.number("mass", "kg").ok().flatten();
    let suggestion = mass.and_then(|mass| {
        let apart = |(condition, row): &(&Condition<'_>, usize)| {
            let (cl, needed) =
                (condition.statics.entry(*row, "CL").map(|(cl, _)| cl), condition.lift_for(mass));
            cl.zip(needed).map_or(f64::INFINITY, |(cl, needed)| (cl - needed).abs())
        };
        let best = (0..cases.len()).min_by(|&i, &j| apart(&cases[i]).total_cmp(&apart(&cases[j])))?;
        let needed = cases[best].0.lift_for(mass)?;
        let why =
            format!("its lift is the nearest to C_L = {}, which carries the weight", trimmed(needed, 3));
        Some((best, why))
    });
    let chosen = cases::chosen(sheet, "flight condition and angle of attack", &labels, suggestion)?;
    Ok(chosen.and_then(|k| cases.get(k).copied()))
}

impl Condition<'_> {
    const fn length(&self) -> f64 {
        if self.in_feet { 0.3048 } else { 1.0 }
    }

    /// ρ = p/(R T), where pressure and temperature are printed \[kg/m³\].
    fn density(&self) -> Option<f64> {
        let [_, _, _, p, t, ..] = self.flight[..] else { return None };
        // lbf/ft² and °R, or N/m² and K
        let (pascal, kelvin) = if self.in_feet { (p * 47.880_258_980_335_84, t / 1.8) } else { (p, t) };
        let density = pascal / (287.052_87 * kelvin);
        (self.is_whole() && density.is_finite() && density > 0.0).then_some(density)
    }

    /// Whether nothing of the line of the flight condition is blank.
    fn is_whole(&self) -> bool {
        self.flight.len() == 11
    }

    /// C_L that carries a mass \[kg\].
    fn lift_for(&self, mass: f64) -> Option<f64> {
        let [_, _, v, _, _, _, s, ..] = self.flight[..] else { return None };
        let (v, s) = (v * self.length(), s * self.length() * self.length());
        Some(mass * crate::flight::analysis::STANDARD_GRAVITY / (0.5 * self.density()? * v * v * s))
    }
}

fn flight(sheet: &mut Sheet, condition: &Condition<'_>) {
    let (flight, line, length) = (&condition.flight, condition.line, condition.length());
    if let Some(&mach) = flight.first() {
        sheet.find("mach", mach, line, "MACH NUMBER");
    }
    if condition.is_whole() {
        sheet.find("altitude", flight[1] * length, line, "ALTITUDE");
        sheet.find("speed", flight[2] * length, line, "VELOCITY");
    }
    if let Some(density) = condition.density() {
        sheet.find("density", density, line, "PRESSURE over R and TEMPERATURE");
    }
    // The reference dimensions are the last five.
    if let [.., s, c, b, _, _] = flight[..] {
        sheet.find("S", s * length * length, line, "REF. AREA");
        sheet.find("c", c * length, line, "REFERENCE LENGTH LONG.");
        sheet.find("b", b * length, line, "REFERENCE LENGTH LAT.");
    }
}

/// C_Dα from the drag of the neighbouring angles.
fn drag_rise(sheet: &mut Sheet, statics: &Table<'_>, row: usize) {
    let of = |k: usize, column: &str| statics.entry(k, column).map(|(value, _)| value);
    let (low, high) = (row.saturating_sub(1), (row + 1).min(statics.rows.len().saturating_sub(1)));
    let rise = (|| {
        Some((of(high, "CD")? - of(low, "CD")?) / (of(high, "ALPHA")? - of(low, "ALPHA")?).to_radians())
    })();
    if let Some(rise) = rise.filter(|rise| rise.is_finite()) {
        sheet.find("CD_alpha", rise, statics.rows[row].0, "CD over ALPHA, between the neighbours");
    }
}
