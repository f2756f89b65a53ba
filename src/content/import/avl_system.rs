//! AVL's system matrix (`.sys`): a line of names, then a row for each state, A and B parted by a bar. Several may follow one another.

use super::avl::control_unit;
use super::cases;
use super::scan;
use super::sheet::Sheet;
use super::system::System;
use crate::content::matrix::draft::{At, Draft, Entry, Problem, Rows};
use crate::content::matrix::state_names;
use crate::flight::aircraft::plane::Plane;

/// With four decimals an entry is known to half of the last.
const LARGEST_BAND: f64 = 5e-5;

/// A system as it is printed.
struct Printed<'t> {
    /// What stands above its names, as far as AVL's users write something there.
    title: &'t str,
    /// Line of its names.
    line: usize,
    states: Vec<String>,
    inputs: Vec<String>,
    /// Rows of A, and behind each that of B.
    rows: Rows,
}

/// Reads the system that counts.
pub(super) fn read(sheet: &mut Sheet, text: &str) -> Result<(), Problem> {
    let systems = systems(text)?;
    let words: Vec<String> = systems.iter().map(Printed::words).collect();
    let Some(k) = cases::chosen(sheet, "system matrix", &words, None)? else { return Ok(()) };
    let Some(system) = systems.into_iter().nth(k) else {
        return Err((
            1,
            "expected a line with the names of the states, u w q the v p r phi, found none".to_owned(),
        ));
    };
    system.check()?;
    let Printed { line, states, inputs, rows, .. } = system;
    let unit = control_unit(sheet)?;
    let n = states.len();
    let part = |from: usize, to: usize, factor: f64| -> Rows {
        let of = |row: &At<Vec<f64>>| row.value[from..to].iter().map(|entry| entry * factor).collect();
        rows.iter().map(|row| At { line: row.line, value: of(row) }).collect()
    };
    if !inputs.is_empty() && unit != 1.0 {
        sheet.remark(
            "Columns of B are read as by degrees, the unit of AVL’s control variable with a gain of 1.",
        );
    }
    sheet.remark(format!("A is printed with four decimals: an entry is known to ±{LARGEST_BAND} only."));
    let mut draft = Draft::default();
    draft.set("states", line, Entry::Names(states))?;
    draft.set("A", line + 1, Entry::Rows(part(0, n, 1.0)))?;
    if !inputs.is_empty() {
        draft.set("B", line + 1, Entry::Rows(part(n, n + inputs.len(), unit)))?;
        draft.set("inputs", line, Entry::Names(inputs))?;
    }
    sheet.matrices = Some(draft);
    Ok(())
}

/// Every system of the file.
fn systems(text: &str) -> Result<Vec<Printed<'_>>, Problem> {
    let mut systems: Vec<Printed<'_>> = Vec::new();
    let mut title = "";
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.trim();
        if text.is_empty() {
            continue;
        }
        if let Some(row) = scan::glued(&text.replace('|', " ")) {
            if let Some(system) = systems.last_mut() {
                system.rows.push(At { line, value: row });
            }
            continue;
        }
        let (states, inputs) = text.split_once('|').unwrap_or((text, ""));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let states = words(states);
        if states.len() >= 8 && states.starts_with(&["u", "w", "q"].map(str::to_owned)) {
            let inputs = words(inputs);
            systems.push(Printed { title, line, states, inputs, rows: Vec::new() });
            title = "";
        } else if systems.last().is_none_or(|system| system.rows.len() == system.states.len()) {
            title = text.trim_start_matches('#').trim();
        } else if !text.starts_with('#') {
            return Err((line, format!("expected a row of numbers, found “{text}”")));
        }
    }
    Ok(systems)
}

impl Printed<'_> {
    /// What tells it apart from others.
    fn words(&self) -> String {
        let n = self.states.len();
        let a: Option<Vec<Vec<f64>>> =
            self.rows.iter().map(|row| row.value.get(..n).map(<[f64]>::to_vec)).collect();
        let known: Option<Vec<_>> = state_names::meanings(&self.states).into_iter().collect();
        let told = a.zip(known).filter(|(a, _)| a.len() == n).and_then(|(a, meanings)| {
            let b = vec![Vec::new(); n];
            let system = System { names: self.states.clone(), meanings, inputs: Vec::new(), a, b };
            let states: Vec<usize> = system.plane(Plane::Longitudinal).into_iter().collect::<Option<_>>()?;
            cases::told_by_eigenvalues(&system.part(&states))
        });
        let title = if self.title.is_empty() { String::new() } else { format!("{}, ", self.title) };
        format!("{title}line {}: {}", self.line, told.unwrap_or_else(|| "not whole".to_owned()))
    }

    /// A row for each state, and in each row a number for each state and each input.
    fn check(&self) -> Result<(), Problem> {
        let (n, inputs) = (self.states.len(), self.inputs.len());
        let found = self.rows.len();
        let end = self.rows.last().map_or(self.line, |row| row.line);
        let is_short = |row: &At<Vec<f64>>| row.value.len() < n + inputs;
        if found < n {
            let last = self.rows.last().filter(|row| is_short(row));
            let last =
                last.map_or_else(String::new, |row| format!(", the last of {} numbers", row.value.len()));
            return Err((end, format!("the matrix is cut off: {n} states, {found} rows{last}")));
        }
        if let Some(row) = self.rows.get(n) {
            return Err((row.line, format!("expected {n} rows, one a state, found another one")));
        }
        let Some(row) = self.rows.iter().find(|row| row.value.len() != n + inputs) else { return Ok(()) };
        let found = row.value.len();
        if row.line == end && found < n + inputs {
            let problem =
                format!("the matrix is cut off: its last row has {found} numbers, not {}", n + inputs);
            return Err((end, problem));
        }
        Err((
            row.line,
            format!(
                "expected {n} numbers, one a state, and {inputs} behind them, one a control, found {found}"
            ),
        ))
    }
}
