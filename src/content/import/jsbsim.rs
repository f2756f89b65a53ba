//! JSBSim's linearisation, as JSON and as the Scicoslab file that it writes. Feet and radians, unless the file says another unit of a
//! state; controls count from −1 to 1.

use serde::Deserialize;

use super::cases;
use super::sheet::Sheet;
use crate::content::matrix::draft::{At, Draft, Entry, Problem, number};
use crate::content::matrix::state_names::{self, Meaning, control};
use crate::number::trimmed;

/// The attributes of `FGLinearization`, written down as JSON.
#[derive(Deserialize)]
struct Linearisation {
    x_names: Vec<String>,
    #[serde(default)]
    x_units: Vec<String>,
    #[serde(default)]
    u_names: Vec<String>,
    #[serde(default)]
    u_units: Vec<String>,
    #[serde(default)]
    x0: Vec<f64>,
    #[serde(rename = "A")]
    a: Vec<Vec<f64>>,
    #[serde(rename = "B", default)]
    b: Vec<Vec<f64>>,
}

/// The states that the Scicoslab file has without naming them; an engine's speed stands behind Q where there is one.
const STATES: [&str; 12] =
    ["Vt", "Alpha", "Theta", "Q", "Beta", "Phi", "P", "Psi", "R", "Latitude", "Longitude", "Alt"];
const INPUTS: [&str; 4] = ["ThtlCmd", "DaCmd", "DeCmd", "DrCmd"];

/// What a number of a file is in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unit {
    /// A length, or one a second, and its unit in metres.
    Length(f64),
    Radians,
    Degrees,
    /// A control from −1 to 1.
    Normalised,
    /// Anything else, which stays as it is.
    Other,
}

/// Units by their names, without the time that they are over.
const UNITS: [(&str, Unit); 12] = [
    ("ft", Unit::Length(0.3048)),
    ("feet", Unit::Length(0.3048)),
    ("m", Unit::Length(1.0)),
    ("kt", Unit::Length(0.514_444_444_444_444_4)),
    ("kts", Unit::Length(0.514_444_444_444_444_4)),
    ("fps", Unit::Length(0.3048)),
    ("rad", Unit::Radians),
    ("radians", Unit::Radians),
    ("deg", Unit::Degrees),
    ("degrees", Unit::Degrees),
    ("°", Unit::Degrees),
    ("norm", Unit::Normalised),
];

impl Unit {
    fn read(name: &str) -> Option<Self> {
        let plain = name.trim().to_lowercase();
        let base = ["/s", "/sec"].iter().find_map(|end| plain.strip_suffix(end)).unwrap_or(&plain);
        UNITS.iter().find(|(known, _)| *known == base).map(|&(_, unit)| unit)
    }

    /// One of it, in radians or in the file's unit of length.
    fn size(self, length: f64) -> f64 {
        match self {
            Self::Length(metres) => metres / length,
            Self::Degrees => 1_f64.to_radians(),
            Self::Radians | Self::Normalised | Self::Other => 1.0,
        }
    }
}

/// The unit of each name; where the file has none, `usual`. An error for one that isn't known, unless `any` is right for its name.
fn units(
    (line, key): (usize, &str),
    names: &[String],
    told: &[String],
    usual: impl Fn(&str) -> Unit,
    any: impl Fn(&str) -> bool,
) -> Result<Vec<Unit>, Problem> {
    if told.is_empty() {
        return Ok(names.iter().map(|name| usual(name)).collect());
    }
    if told.len() != names.len() {
        let (expected, found) = (names.len(), told.len());
        return Err((
            line,
            format!("{key}: expected a unit for each of the {expected} names, found {found}"),
        ));
    }
    let unit = |(name, told): (&String, &String)| match Unit::read(told) {
        Some(unit) => Ok(unit),
        None if told.trim().is_empty() => Ok(usual(name)),
        None if any(name) => Ok(Unit::Other),
        None => Err((
            line,
            format!(
                "{key}: “{told}” of {name} is not a unit known here; known are ft, m, kt, rad and deg, alone or a second, and norm"
            ),
        )),
    };
    names.iter().zip(told).map(unit).collect()
}

pub(super) fn read_json(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    let read: Result<Vec<Linearisation>, _> = match text.trim_start().starts_with('[') {
        true => serde_json::from_str(text),
        false => serde_json::Deserializer::from_str(text).into_iter().collect(),
    };
    let all = read.map_err(|error| {
        let told = error.to_string();
        let told = told.split(" at line ").next().unwrap_or_default();
        let told = if error.is_eof() {
            "the file is cut off: it ends in the middle of a linearisation"
        } else {
            told
        };
        (error.line().max(1), told.to_owned())
    })?;
    let words: Vec<String> = all.iter().map(Linearisation::words).collect();
    let Some(k) = cases::chosen(sheet, "linearisation", &words, None)? else { return Ok(()) };
    // Where the key of this one stands.
    let line = |key: &str| {
        let quoted = format!("\"{key}\"");
        text.lines().enumerate().filter(|(_, line)| line.contains(&quoted)).nth(k).map_or(1, |(k, _)| k + 1)
    };
    let Some(mut read) = all.into_iter().nth(k) else {
        return Err((1, "expected a linearisation, found none".to_owned()));
    };
    let is_rigid = |name: &str| {
        let meaning = state_names::meanings(&[name.to_owned()]);
        !matches!(meaning[..], [Some(Meaning::Engine | Meaning::Other | Meaning::Actuator(_)) | None])
    };
    let usual = |name: &str| if is_length(name) { Unit::Length(0.3048) } else { Unit::Radians };
    let of_states =
        units((line("x_units"), "x_units"), &read.x_names, &read.x_units, usual, |name| !is_rigid(name))?;
    if read.x_units.is_empty() {
        sheet.remark("The file names no units; they are those of JSBSim, feet and radians.");
    }
    let of_inputs = units(
        (line("u_units"), "u_units"),
        &read.u_names,
        &read.u_units,
        |_| Unit::Normalised,
        |name| control(name) == Some("throttle"),
    )?;
    let lengths: Vec<f64> = of_states
        .iter()
        .filter_map(|unit| if let Unit::Length(metres) = unit { Some(*metres) } else { None })
        .collect();
    let in_feet = lengths.is_empty() || lengths.contains(&0.3048);
    let length = if in_feet { 0.3048 } else { 1.0 };
    turn(&mut read, &of_states, &of_inputs, length);
    say_turned(sheet, "States", &read.x_names, &of_states, length);
    say_turned(sheet, "Controls", &read.u_names, &of_inputs, length);
    let is_normalised = read
        .u_names
        .iter()
        .zip(&of_inputs)
        .any(|(name, unit)| *unit == Unit::Normalised && control(name) != Some("throttle"));
    let x0: Vec<Told> = read.x0.iter().zip(of_states).map(|(&value, unit)| Told { value, unit }).collect();
    if !read.x0.is_empty() && read.x0.len() != read.x_names.len() {
        let (expected, found) = (read.x_names.len(), read.x0.len());
        return Err((line("x0"), format!("x0: expected {expected} numbers, one a state, found {found}")));
    }
    let (line_a, line_b) = (line("A"), line("B"));
    system(sheet, read.x_names, read.u_names, &x0, (line_a, read.a), (line_b, read.b), in_feet)?;
    say_controls(sheet, is_normalised);
    Ok(())
}

/// Whether a state of JSBSim is a speed or a height.
fn is_length(name: &str) -> bool {
    matches!(
        state_names::meanings(&[name.to_owned()])[..],
        [Some(Meaning::Airspeed | Meaning::Height | Meaning::Depth | Meaning::Rigid(_, "u" | "v" | "w"))]
    )
}

/// States in radians and one unit of length: A(i, j) s(i)/s(j), and B likewise.
fn turn(read: &mut Linearisation, of_states: &[Unit], of_inputs: &[Unit], length: f64) {
    let size = |units: &[Unit], k: usize| units.get(k).map_or(1.0, |unit| unit.size(length));
    for (i, row) in read.a.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry *= size(of_states, i) / size(of_states, j);
        }
    }
    for (i, row) in read.b.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry *= size(of_states, i) / size(of_inputs, j);
        }
    }
}

fn say_turned(sheet: &mut Sheet, what: &str, names: &[String], units: &[Unit], length: f64) {
    let turned: Vec<&str> = names
        .iter()
        .zip(units)
        .filter(|(_, unit)| unit.size(length) != 1.0)
        .map(|(name, _)| name.as_str())
        .collect();
    if !turned.is_empty() {
        sheet.remark(format!(
            "{what} were turned into the units of the rest, radians for angles: {}.",
            turned.join(", ")
        ));
    }
}

impl Linearisation {
    /// What tells it from others.
    fn words(&self) -> String {
        let of = |name: &str| {
            let k = self.x_names.iter().position(|state| state.eq_ignore_ascii_case(name))?;
            let unit = self.x_units.get(k).map_or("", String::as_str);
            Some(format!("{name} {} {unit}", trimmed(*self.x0.get(k)?, 5)).trim_end().to_owned())
        };
        let told: Vec<String> = ["Vt", "Alpha", "Alt"].into_iter().filter_map(of).collect();
        if told.is_empty() { "without x0".to_owned() } else { told.join(", ") }
    }
}

/// A number of x0 with its unit.
#[derive(Clone, Copy, Debug)]
struct Told {
    value: f64,
    unit: Unit,
}

impl Told {
    fn degrees(self) -> f64 {
        if self.unit == Unit::Degrees { self.value } else { self.value.to_degrees() }
    }

    fn metres(self) -> f64 {
        if let Unit::Length(metres) = self.unit { self.value * metres } else { self.value }
    }
}

pub(super) fn read_scicos(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    // A linearisation begins with its trim, `name.x0=..`.
    let begins = |line: &str| {
        let name = line.split_once('=')?.0.trim().strip_suffix("x0")?;
        Some(name.trim_end_matches('.').to_owned())
    };
    let (mut starts, mut at) = (Vec::new(), 0);
    for (line, text) in (1..).zip(text.split_inclusive('\n')) {
        starts.extend(begins(text).map(|name| (at, line, name)));
        at += text.len();
    }
    let words: Vec<String> = starts.iter().map(|(_, line, name)| format!("{name}, line {line}")).collect();
    let Some(k) = cases::chosen(sheet, "linearisation", &words, None)? else { return Ok(()) };
    let (from, line) = starts.get(k).map_or((0, 1), |(at, line, _)| (*at, *line));
    let to = starts.get(k + 1).map_or(text.len(), |(at, ..)| *at);
    let [x0, _, a, b] = scicos_matrices(&text[from..to], line)?;
    let mut states = STATES.map(str::to_owned).to_vec();
    for k in 0..a.1.len().saturating_sub(STATES.len()) {
        states.insert(4 + k, format!("Rpm{k}"));
    }
    let inputs =
        INPUTS[..b.1.first().map_or(0, Vec::len).min(INPUTS.len())].iter().map(|&name| name.to_owned());
    let x0 = x0.1.iter().filter_map(|row| row.first().copied());
    let unit = |name: &String| if is_length(name) { Unit::Length(0.3048) } else { Unit::Radians };
    let x0: Vec<Told> = x0.zip(&states).map(|(value, name)| Told { value, unit: unit(name) }).collect();
    sheet.remark("The file doesn’t name its states; the order is that of JSBSim: Vt, Alpha, Theta, Q, Beta, Phi, P, Psi, R, and the place.");
    system(sheet, states, inputs.collect(), &x0, a, b, true)?;
    say_controls(sheet, true);
    Ok(())
}

/// A matrix and the line on which it begins.
type LineAndRows = (usize, Vec<Vec<f64>>);

/// x0, u0, A and B, each in brackets, rows ended by semicolons, with their lines.
fn scicos_matrices(text: &str, first_line: usize) -> Result<[LineAndRows; 4], Problem> {
    let mut matrices: Vec<(usize, Vec<Vec<f64>>)> = Vec::new();
    let mut rest = text;
    let mut line = first_line;
    while let Some(open) = rest.find('[') {
        line += rest[..open].matches('\n').count();
        let body = &rest[open + 1..];
        let Some(close) = body.find(']') else {
            return Err((line, "\"]\" is missing at the end of a matrix".to_owned()));
        };
        let mut rows = Vec::new();
        let mut row_line = line;
        for row in body[..close].split(';') {
            let words = row
                .split(|c: char| c.is_whitespace() || c == ',')
                .filter(|word| !word.is_empty() && *word != "..");
            let numbers: Option<Vec<f64>> = words.map(number).collect();
            row_line += row.matches('\n').count();
            rows.push(numbers.ok_or_else(|| (row_line, "expected a row of numbers".to_owned()))?);
        }
        matrices.push((line, rows));
        line += body[..close].matches('\n').count();
        rest = &body[close + 1..];
        if matrices.len() == 4 {
            break;
        }
    }
    let found = matrices.len();
    matrices.try_into().map_err(|_| {
        (line, format!("expected x0, u0, A and B in brackets, as JSBSim writes them, found {found} of them"))
    })
}

fn say_controls(sheet: &mut Sheet, normalised: bool) {
    if normalised {
        sheet.remark("Controls count from −1 to 1 in JSBSim: a radian of elevator, aileron or rudder here is its whole travel there.");
    }
}

fn system(
    sheet: &mut Sheet,
    states: Vec<String>,
    inputs: Vec<String>,
    x0: &[Told],
    (line, a): (usize, Vec<Vec<f64>>),
    (line_b, b): (usize, Vec<Vec<f64>>),
    feet: bool,
) -> Result<(), Problem> {
    if a.len() != states.len() {
        return Err((line, format!("A: expected {} rows, one a state, found {}", states.len(), a.len())));
    }
    let of = |name: &str| {
        states.iter().position(|state| state.eq_ignore_ascii_case(name)).and_then(|k| x0.get(k)).copied()
    };
    if let Some(speed) = of("Vt") {
        sheet.find("speed", speed.metres(), line, &format!("x0: Vt = {}", speed.value));
    }
    if let Some(alpha) = of("Alpha") {
        sheet.find("alpha0_deg", alpha.degrees(), line, &format!("x0: Alpha = {}", alpha.value));
        if let Some(theta) = of("Theta") {
            let path = match theta.unit == alpha.unit {
                true => Told { value: theta.value - alpha.value, ..alpha }.degrees(),
                false => theta.degrees() - alpha.degrees(),
            };
            // A trim is found to a few digits.
            let path = if path.abs() < 1e-3 { 0.0 } else { path };
            sheet.find(
                "gamma0_deg",
                path,
                line,
                &format!("x0: Theta − Alpha = {}", theta.value - alpha.value),
            );
        }
    }
    let rows = |line: usize, rows: Vec<Vec<f64>>| {
        Entry::Rows(rows.into_iter().map(|value| At { line, value }).collect())
    };
    let mut draft = Draft::default();
    draft.set("units", line, Entry::Text(if feet { "ft-slug-s" } else { "SI" }.to_owned()))?;
    draft.set("states", line, Entry::Names(states))?;
    draft.set("A", line, rows(line, a))?;
    if !b.is_empty() && !inputs.is_empty() {
        draft.set("inputs", line_b, Entry::Names(inputs))?;
        draft.set("B", line_b, rows(line_b, b))?;
    }
    sheet.matrices = Some(draft);
    Ok(())
}
