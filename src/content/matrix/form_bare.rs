//! Matrices as nothing but numbers, with or without brackets: what is copied out of a terminal or a table. The first rows are A; columns
//! beyond a square are B.

use std::borrow::Cow;

use super::draft::{At, Draft, Entry, Problem, number, setting_in_comment};
use super::state_names;

pub(in crate::content) fn read(text: &str) -> Result<Draft, Problem> {
    let mut draft = Draft::default();
    let mut rows: Vec<At<Vec<f64>>> = Vec::new();
    let is_nested = text.contains("[[") || text.contains("[ [");
    let mut is_open = false;
    let text =
        &*if has_decimal_commas(text) { Cow::Owned(text.replace(',', ".")) } else { Cow::Borrowed(text) };
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.trim();
        // Julia tells the kind of what it prints: 4×4 Matrix{Float64}:
        if text.contains('×') && text.ends_with("}:") {
            continue;
        }
        let comment = text.strip_prefix(['#', '%']).or(Some(text)).filter(|text| text.contains([':', '=']));
        if let Some((key, entry)) = comment.and_then(setting_in_comment) {
            draft.set(key, line, entry)?;
            continue;
        }
        if text.is_empty() || text.starts_with(['#', '%']) {
            continue;
        }
        let cells = cells(text);
        if rows.is_empty() && cells.len() > 2 && cells.iter().all(|cell| state_names::is_known(cell)) {
            let inputs = cells.iter().skip(4).filter(|cell| !state_names::is_further(cell)).count();
            let (states, inputs) = cells.split_at(cells.len() - inputs);
            let named = |cells: &[&str]| Entry::Names(cells.iter().map(|&cell| cell.to_owned()).collect());
            draft.set("states", line, named(states))?;
            if !inputs.is_empty() {
                draft.set("inputs", line, named(inputs))?;
            }
            continue;
        }
        let numbers: Option<Vec<f64>> = cells.iter().map(|cell| number(cell)).collect();
        let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) else {
            return Err((line, format!("expected a row of numbers, found \"{}\"", shortened(text))));
        };
        match rows.last_mut() {
            // numpy breaks a long row.
            Some(row) if is_nested && is_open => row.value.extend(numbers),
            _ => rows.push(At { line, value: numbers }),
        }
        is_open = !text.contains(']');
    }
    let line = rows.first().map_or(1, |row| row.line);
    if rows.is_empty() {
        return Err((1, "expected rows of numbers, found none".to_owned()));
    }
    let states = rows.len();
    let inputs = rows[0].value.len().saturating_sub(states);
    if inputs > 0 && rows.iter().all(|row| row.value.len() == states + inputs) {
        let b =
            rows.iter_mut().map(|row| At { line: row.line, value: row.value.split_off(states) }).collect();
        draft.set("B", line, Entry::Rows(b))?;
    }
    draft.set("A", line, Entry::Rows(rows))?;
    Ok(draft)
}

/// Whether commas are those of decimals: each between two digits, other things between the numbers, and no point anywhere.
fn has_decimal_commas(text: &str) -> bool {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let of_line = |line: &str| {
        let mut parts = line.split(',').peekable();
        let mut all = true;
        while let Some(part) = parts.next() {
            if let Some(next) = parts.peek() {
                all &= is_digit(part.chars().next_back()) && is_digit(next.chars().next());
            }
        }
        all
    };
    let parted = |line: &str| line.split([';', '\t', ' ']).filter(|cell| !cell.is_empty()).count() >= 3;
    text.contains(',')
        && !text.contains('.')
        && text.lines().all(of_line)
        && text.lines().filter(|line| line.contains(',')).all(parted)
}

/// The words of a line without its brackets.
fn cells(text: &str) -> Vec<&str> {
    text.trim_start_matches("array(")
        .trim_start_matches("matrix(")
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
