//! JSBSim's linearisation, as JSON and as the Scicoslab file that it writes. Feet and radians; controls count from −1 to 1.

use serde::Deserialize;

use super::sheet::Sheet;
use crate::content::matrix::draft::{At, Draft, Entry, Problem, number};

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

pub(super) fn read_json(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    let read: Linearisation = serde_json::from_str(text).map_err(|error| {
        let told = error.to_string();
        (error.line().max(1), told.split(" at line ").next().unwrap_or_default().to_owned())
    })?;
    let line = |key: &str| {
        let quoted = format!("\"{key}\"");
        text.lines().position(|line| line.contains(&quoted)).map_or(1, |k| k + 1)
    };
    let normalised = read.u_units.iter().any(|unit| unit == "norm");
    let feet = read.x_units.is_empty() || read.x_units.iter().any(|unit| unit.starts_with("ft"));
    let (line_a, line_b) = (line("A"), line("B"));
    system(sheet, read.x_names, read.u_names, &read.x0, (line_a, read.a), (line_b, read.b), feet)?;
    say_controls(sheet, normalised);
    Ok(())
}

pub(super) fn read_scicos(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    // x0, u0, A, B, C, D, each in brackets, rows ended by semicolons.
    let mut matrices: Vec<(usize, Vec<Vec<f64>>)> = Vec::new();
    let mut rest = text;
    let mut line = 1;
    while let Some(open) = rest.find('[') {
        line += rest[..open].matches('\n').count();
        let body = &rest[open + 1..];
        let Some(close) = body.find(']') else {
            return Err((line, "\"]\" is missing at the end of a matrix".to_owned()));
        };
        let mut rows = Vec::new();
        for (k, row) in body[..close].split(';').enumerate() {
            let words = row
                .split(|c: char| c.is_whitespace() || c == ',')
                .filter(|word| !word.is_empty() && *word != "..");
            let row: Option<Vec<f64>> = words.map(number).collect();
            rows.push(row.ok_or_else(|| (line + k, "expected a row of numbers".to_owned()))?);
        }
        matrices.push((line, rows));
        line += body[..close].matches('\n').count();
        rest = &body[close + 1..];
        if matrices.len() == 4 {
            break;
        }
    }
    let Ok([x0, _, a, b]) = <[_; 4]>::try_from(matrices) else {
        return Err((1, "expected x0, u0, A and B in brackets, as JSBSim writes them".to_owned()));
    };
    let mut states = STATES.map(str::to_owned).to_vec();
    for k in 0..a.1.len().saturating_sub(STATES.len()) {
        states.insert(4 + k, format!("Rpm{k}"));
    }
    let inputs =
        INPUTS[..b.1.first().map_or(0, Vec::len).min(INPUTS.len())].iter().map(|&name| name.to_owned());
    let x0: Vec<f64> = x0.1.iter().filter_map(|row| row.first().copied()).collect();
    sheet.remark("The file doesn’t name its states; the order is that of JSBSim: Vt, Alpha, Theta, Q, Beta, Phi, P, Psi, R, and the place.");
    system(sheet, states, inputs.collect(), &x0, a, b, true)?;
    say_controls(sheet, true);
    Ok(())
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
    x0: &[f64],
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
    let length = if feet { 0.3048 } else { 1.0 };
    if let Some(speed) = of("Vt") {
        sheet.find("speed", speed * length, line, &format!("x0: Vt = {speed}"));
    }
    if let Some(alpha) = of("Alpha") {
        sheet.find("alpha0_deg", alpha.to_degrees(), line, &format!("x0: Alpha = {alpha}"));
        if let Some(theta) = of("Theta") {
            let path = (theta - alpha).to_degrees();
            // A trim is found to a few digits.
            let path = if path.abs() < 1e-3 { 0.0 } else { path };
            sheet.find("gamma0_deg", path, line, &format!("x0: Theta − Alpha = {}", theta - alpha));
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
