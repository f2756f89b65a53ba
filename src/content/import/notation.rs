//! Matrices as other programs write them, turned line for line into what the readers know: LaTeX, Mathematica, Maple, Maxima, R, Octave’s
//! files, what python-control and MATLAB print of a system, notebooks, tables with the names of their rows.
//!
//! What stands on a line stays on it, so that a complaint has its line.

use std::borrow::Cow;

use serde::Deserialize;

use crate::content::matrix::draft::{Problem, number, setting};
use crate::content::matrix::state_names;

/// The text in the words of MATLAB, or as it is. Rows that have other names than their columns are refused.
pub(super) fn plain(text: &str) -> Result<Cow<'_, str>, Problem> {
    let mut text = Cow::Borrowed(text);
    // Old Macs, and some spreadsheets, end a line so.
    if text.contains('\r') && !text.contains('\n') {
        text = text.replace('\r', "\n").into();
    }
    // Excel's own line about what parts the cells.
    if text.trim_start_matches('\u{feff}').starts_with("sep=") {
        text = text.split_once('\n').map_or(String::new(), |(_, rest)| format!("\n{rest}")).into();
    }
    for (is_there, turn) in TURNS {
        if is_there(&text) {
            text = turn(&text).into();
        }
    }
    if has_labels(&text) {
        text = without_labels(&text)?.into();
    }
    Ok(text)
}

type Turn = (fn(&str) -> bool, fn(&str) -> String);

const TURNS: [Turn; 8] = [
    (|text| text.contains("\"cells\"") && text.contains("\"nbformat\""), notebook),
    (|text| text.contains("\\begin{"), latex),
    (|text| text.starts_with("# Created by Octave"), octave_file),
    (|text| text.contains("<StateSpace"), python_control),
    (|text| text.contains("matrix(c("), r),
    (|text| text.contains(": matrix(") || text.contains(":matrix("), maxima),
    (|text| text.contains(":= Matrix(") || text.contains(":=Matrix("), |text| text.replace(":=", "=")),
    (|text| text.contains("{{") || text.contains("{ {"), mathematica),
];

/// The code of a notebook, without what it printed.
fn notebook(text: &str) -> String {
    #[derive(Deserialize)]
    struct Notebook {
        cells: Vec<Cell>,
    }
    #[derive(Deserialize)]
    struct Cell {
        cell_type: String,
        source: Source,
    }
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Source {
        Lines(Vec<String>),
        Text(String),
    }
    let Ok(notebook) = serde_json::from_str::<Notebook>(text) else { return text.to_owned() };
    let code = notebook.cells.into_iter().filter(|cell| cell.cell_type == "code");
    let sources = code.map(|cell| match cell.source {
        Source::Lines(lines) => lines.concat(),
        Source::Text(text) => text,
    });
    sources.collect::<Vec<_>>().join("\n\n")
}

/// `\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}`, with what is called so before it: `\mathbf{A} =`. Without a name of its own a square is
/// A, and what is no square B, as in ẋ = […] x + […] δ; what has no number is a vector of names.
fn latex(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some(start) = rest.find("\\begin{") {
        let (before, environment) = rest.split_at(start);
        let kind = environment[7..].split('}').next().unwrap_or_default();
        plain.push_str(&comments(before));
        let body = &environment[(8 + kind.len()).min(environment.len())..];
        let end = format!("\\end{{{kind}}}");
        let is_matrix = kind.ends_with("matrix") || kind == "array";
        let Some(close) = body.find(&end).filter(|_| is_matrix) else {
            rest = body;
            continue;
        };
        let mut inner = &body[..close];
        // The columns of an array: {cccc}.
        if kind == "array" {
            inner = inner.split_once('}').map_or(inner, |(_, rows)| rows);
        }
        let rows = latex_rows(inner);
        let cells = || rows.iter().flat_map(|row| row.split_whitespace());
        if cells().any(|cell| number(cell).is_some()) {
            let is_square = rows.iter().all(|row| row.split_whitespace().count() == rows.len());
            let name = latex_name(before).unwrap_or(if is_square { 'A' } else { 'B' });
            plain.push_str(&format!("\n{name} = [{}];", rows.join(";")));
        }
        // The lines stay as many.
        plain.push_str(&"\n".repeat(inner.matches('\n').count().saturating_sub(1)));
        rest = &body[close + end.len()..];
    }
    plain.push_str(&comments(rest));
    plain
}

/// The rows between `\begin` and `\end`, without comments and what only sets the type; the last may be empty.
fn latex_rows(inner: &str) -> Vec<String> {
    let without_comment = |line: &str| {
        let end = line.match_indices('%').map(|(at, _)| at).find(|&at| !line[..at].ends_with('\\'));
        line[..end.unwrap_or(line.len())].to_owned()
    };
    let text = inner.lines().map(without_comment).collect::<Vec<_>>().join(" ");
    let times = ["\\cdot", "\\times"]
        .map(|sign| [format!(" {sign} 10^{{"), format!("{sign} 10^{{"), format!("{sign}10^{{")]);
    let text = times.iter().flatten().fold(text, |text, times| text.replace(times, "e"));
    let text = text
        .replace("\\\\", ";")
        .replace("{,}", ".")
        .replace("\\hline", " ")
        .replace("\\,", "")
        .replace("\\!", "");
    let text: String =
        text.chars().map(|c| if matches!(c, '&' | '$' | '{' | '}') { ' ' } else { c }).collect();
    text.split(';').map(|row| row.trim().to_owned()).filter(|row| !row.is_empty()).collect()
}

/// The capital that is the last sign before an equals sign: the last letter of `\mathbf{A} =`.
fn latex_name(before: &str) -> Option<char> {
    let (name, _) = before.lines().next_back()?.rsplit_once('=')?;
    name.chars().rfind(|c| c.is_alphanumeric()).filter(char::is_ascii_uppercase)
}

/// Every line as a comment.
fn comments(text: &str) -> String {
    text.split_inclusive('\n').map(|line| format!("% {}", line.trim_start_matches(['%', ' ']))).collect()
}

/// `# name: A`, its type and size, and its rows.
fn octave_file(text: &str) -> String {
    let line = |line: &str| match line.strip_prefix("# name:") {
        Some(name) => format!("{} =\n", name.trim()),
        None if line.starts_with('#') => "\n".to_owned(),
        None => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

/// `States (4): ['u', 'w', 'q', 'theta']`, and `A = [[…]`.
fn python_control(text: &str) -> String {
    let line = |line: &str| {
        let named = |word: &str, key: &str| {
            let list = line.trim_start().strip_prefix(word)?.split_once(':')?.1;
            Some(format!("{key} = {}\n", list.trim()))
        };
        named("States (", "states").or_else(|| named("Inputs (", "inputs")).unwrap_or_else(|| {
            if line.contains("<StateSpace") || line.starts_with("Outputs") {
                "\n".to_owned()
            } else {
                format!("{line}\n")
            }
        })
    };
    text.lines().map(line).collect()
}

/// `A <- matrix(c(1, 2, 3, 4), nrow = 2, byrow = TRUE)`; without `byrow` R goes down the columns.
fn r(text: &str) -> String {
    const START: &str = "matrix(c(";
    let mut plain = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(START) {
        plain.push_str(&rest[..start].replace("<-", "="));
        let inner = &rest[start + START.len()..];
        let Some((values, told)) = inner.split_once(')') else {
            rest = &rest[start..];
            break;
        };
        let options = told.split(')').next().unwrap_or_default();
        let values: Vec<&str> = values.split(',').map(str::trim).filter(|value| !value.is_empty()).collect();
        let option = |name: &str| {
            let value = options
                .split(',')
                .find_map(|option| option.split_once('=').filter(|(key, _)| key.trim() == name));
            value.map(|(_, value)| value.trim())
        };
        // More rows or columns than numbers there can't be.
        let sizes = 1..=values.len();
        let size = |name: &str| {
            option(name).and_then(|value| value.parse::<usize>().ok()).filter(|size| sizes.contains(size))
        };
        let rows =
            size("nrow").or_else(|| size("ncol").map(|columns| values.len() / columns)).unwrap_or(1).max(1);
        let columns = values.len() / rows;
        let by_row = option("byrow").is_some_and(|value| value.starts_with('T'));
        let at = |i: usize, j: usize| {
            values.get(if by_row { i * columns + j } else { j * rows + i }).copied().unwrap_or("")
        };
        let row = |i: usize| (0..columns).map(|j| at(i, j)).collect::<Vec<_>>().join(" ");
        plain.push_str(&format!("[{}]", (0..rows).map(row).collect::<Vec<_>>().join("; ")));
        let lines = inner.len() - told.len() + options.len();
        plain.push_str(&"\n".repeat(inner[..lines].matches('\n').count()));
        rest = told.get(options.len() + 1..).unwrap_or_default();
    }
    plain.push_str(rest);
    plain
}

/// `A: matrix([1, 2], [3, 4])$`.
fn maxima(text: &str) -> String {
    let line = |line: &str| {
        let turned = line.replacen(": matrix(", " = [", 1).replacen(":matrix(", " = [", 1);
        turned.replace(")$", "];").replace(");", "];")
    };
    text.lines().map(|text| line(text) + "\n").collect()
}

/// `A = {{1, 2.5*^-3}, {3, 4}};`.
fn mathematica(text: &str) -> String {
    text.replace(":=", "=").replace("*^", "e").replace('{', "[").replace('}', "]")
}

/// The cells of a line, without the strokes between them.
fn cells(line: &str) -> Vec<&str> {
    line.split(|c: char| c.is_whitespace() || c == '|').filter(|cell| !cell.is_empty()).collect()
}

/// A row that begins with its name: at least one number behind a name of a state, or of one that MATLAB gives, `x1`.
fn labelled(line: &str) -> Option<(&str, Vec<&str>)> {
    if line.contains([',', ';', '=', '[', '\t']) {
        return None;
    }
    let cells = cells(line);
    let (label, numbers) = cells.split_first()?;
    let is_row = is_name(label) && !numbers.is_empty() && numbers.iter().all(|cell| number(cell).is_some());
    is_row.then(|| (*label, numbers.to_vec()))
}

fn is_name(word: &str) -> bool {
    let of_matlab = word.strip_prefix(['x', 'u', 'y']).is_some_and(|place| place.parse::<u8>().is_ok());
    of_matlab || state_names::is_known(word)
}

/// A line of names above such rows.
fn head(line: &str) -> Option<Vec<&str>> {
    let names = cells(line);
    let is_head = !line.contains([',', ';', '=', '[', '\t'])
        && !names.is_empty()
        && names.iter().all(|name| is_name(name));
    is_head.then_some(names)
}

fn has_labels(text: &str) -> bool {
    text.lines().filter(|line| labelled(line).is_some_and(|(_, numbers)| numbers.len() >= 3)).count() >= 3
}

/// Rows without their names; the names above the first become settings, those above the second the inputs. Where nothing stands above
/// them the names of the rows are those of the states.
fn without_labels(text: &str) -> Result<String, Problem> {
    let mut plain = String::new();
    let mut name = String::new();
    // The states in the order of the columns, where these are named, and of the rows of A.
    let mut columns: Vec<&str> = Vec::new();
    let mut rows: Vec<&str> = Vec::new();
    // The row of the matrix that is being read.
    let mut place = 0;
    let is_given = |names: &[&str]| names.iter().all(|name| state_names::is_known(name));
    for (number, line) in (1..).zip(text.lines()) {
        if let Some((key, value)) = line.split_once('|').filter(|(key, _)| setting(key.trim()).is_some()) {
            plain.push_str(&format!("% {}: {}", key.trim(), value.trim()));
        } else if let Some((label, numbers)) = labelled(line) {
            let of_a = matches!(name.as_str(), "" | "A");
            let expected = if of_a { &columns } else { &rows };
            if let Some(expected) =
                expected.get(place).filter(|expected| is_given(&[label, *expected]) && **expected != label)
            {
                let problem = format!(
                    "expected the row of {expected} here, in the order of the columns, found that of {label}"
                );
                return Err((number, problem));
            }
            if of_a {
                rows.push(label);
            }
            place += 1;
            plain.push_str(&numbers.join(" "));
            let is_last = of_a && columns.is_empty() && rows.len() >= 3 && rows.len() == numbers.len();
            if is_last && is_given(&rows) {
                plain.push_str(&format!(" % states: {}", rows.join(" ")));
            }
        } else if let Some(names) = head(line) {
            place = 0;
            match name.as_str() {
                "" | "A" if is_given(&names) => {
                    plain.push_str(&format!("% states: {}", names.join(" ")));
                    columns = names;
                }
                "B" if is_given(&names) => plain.push_str(&format!("% inputs: {}", names.join(" "))),
                _ => {}
            }
        } else if !line.chars().all(|c| matches!(c, '|' | '-' | ':' | ' ')) {
            if let Some((before, "")) =
                line.trim().split_once('=').map(|(name, value)| (name.trim(), value.trim()))
            {
                before.clone_into(&mut name);
                place = 0;
            }
            plain.push_str(line);
        }
        plain.push('\n');
    }
    Ok(plain)
}
