//! Matrices as nothing but numbers, with or without brackets: what is copied out of a terminal or a table. The first rows are A; columns
//! beyond a square are B, and so are rows below it.

use super::decimal_commas;
use super::draft::{At, Draft, Entry, Problem, number, setting_in_comment};
use super::state_names;

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let mut draft = Draft::default();
    let mut rows: Vec<At<Vec<f64>>> = Vec::new();
    let is_nested = text.contains("[[") || text.contains("[ [");
    let mut is_open = false;
    let has_brackets = text.contains('[');
    let text = &*decimal_commas::in_rows(text);
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.trim();
        // Julia tells the kind of what it prints: 4×4 Matrix{Float64}:
        if text.contains('×') && text.ends_with("}:") {
            continue;
        }
        let whole_line = Some(text).filter(|text| text.contains([':', '=']));
        let (text, comment) = match text.split_once(['#', '%']) {
            Some((text, comment)) => (text, Some(comment)),
            None => (text, whole_line),
        };
        if let Some((key, entry)) = comment.and_then(setting_in_comment) {
            draft.set(key, line, entry)?;
            if comment == whole_line {
                continue;
            }
        }
        // Rows that share a line: [1 2; 3 4], or [[1, 2], [3, 4]].
        let parts: Vec<&str> = if is_nested {
            text.split_inclusive(']').collect()
        } else if has_brackets {
            text.split(';').collect()
        } else {
            vec![text]
        };
        for part in parts {
            let cells = cells(part);
            if cells.is_empty() {
                is_open &= !part.contains(']');
                continue;
            }
            if rows.is_empty() && cells.len() > 2 && cells.iter().all(|cell| state_names::is_known(cell)) {
                set_names(&mut draft, line, &cells)?;
                continue;
            }
            let numbers: Option<Vec<f64>> = cells.iter().map(|cell| number(cell)).collect();
            let Some(numbers) = numbers else {
                return Err((line, format!("expected a row of numbers, found \"{}\"", shortened(text))));
            };
            match rows.last_mut() {
                // numpy breaks a long row.
                Some(row) if is_nested && is_open => row.value.extend(numbers),
                _ => rows.push(At { line, value: numbers }),
            }
            is_open = !part.contains(']');
        }
    }
    let line = rows.first().map_or(1, |row| row.line);
    if rows.is_empty() {
        return Err((1, "expected rows of numbers, found none".to_owned()));
    }
    let columns = rows[0].value.len();
    let below = rows.iter().position(|row| row.value.len() != columns).unwrap_or(columns);
    if columns >= 3 && rows.len() > columns && below == columns {
        // What stands below a square: B, as it is or as one row of numbers.
        let b = rows.split_off(columns);
        if b.len() == columns && b.iter().all(|row| row.value.len() == columns) {
            let problem = "expected the rows of A and, below them, those of B; these are two square matrices: give each its name, A = […]";
            return Err((b[0].line, problem.to_owned()));
        }
        draft.set("B", b[0].line, Entry::Rows(b))?;
    }
    let states = rows.len();
    let inputs = columns.saturating_sub(states);
    if inputs > 0 && rows.iter().all(|row| row.value.len() == columns) {
        let b =
            rows.iter_mut().map(|row| At { line: row.line, value: row.value.split_off(states) }).collect();
        draft.set("B", line, Entry::Rows(b))?;
    }
    draft.set("A", line, Entry::Rows(rows))?;
    Ok(draft)
}

/// A line of names above the numbers: states, and behind them inputs.
fn set_names(draft: &mut Draft, line: usize, cells: &[&str]) -> Result<(), Problem> {
    let inputs = cells.iter().skip(4).filter(|cell| !state_names::is_further(cell)).count();
    let (states, inputs) = cells.split_at(cells.len() - inputs);
    let named = |cells: &[&str]| Entry::Names(cells.iter().map(|&cell| cell.to_owned()).collect());
    draft.set("states", line, named(states))?;
    if inputs.is_empty() { Ok(()) } else { draft.set("inputs", line, named(inputs)) }
}

/// The words of a line without its brackets.
fn cells(text: &str) -> Vec<&str> {
    let text = text.trim();
    let call = ["array(", "matrix(", "Matrix("].into_iter().find(|call| text.starts_with(call));
    text[call.map_or(0, str::len)..]
        .split(|c: char| {
            c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '(' | ')' | '{' | '}' | '|')
        })
        .filter(|cell| !cell.is_empty())
        .collect()
}

/// The beginning of a line, fit to be quoted.
fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(24).collect();
    if text.chars().nth(24).is_some() {
        short.push('…');
    }
    short
}
