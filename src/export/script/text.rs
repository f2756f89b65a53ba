//! Numbers and lists as scripts of most languages write them: the shortest that reads back to the last bit.

use crate::number::shortest;

/// A number; zero without a sign.
pub fn number(x: f64) -> String {
    shortest(x + 0.0)
}

/// Numbers between brackets.
pub fn list(values: &[f64]) -> String {
    format!("[{}]", joined(values, ", "))
}

/// The same, as a row of a matrix.
pub fn row(values: &[f64]) -> String {
    list(values)
}

/// Numbers one after the other.
pub fn joined(values: &[f64], between: &str) -> String {
    values.iter().map(|x| number(*x)).collect::<Vec<_>>().join(between)
}

/// Rows between brackets, one a line.
pub fn matrix<R: AsRef<[f64]>>(rows: &[R]) -> String {
    let rows: Vec<String> = rows.iter().map(|values| format!("    {},\n", list(values.as_ref()))).collect();
    format!("[\n{}]", rows.concat())
}

/// Words in quotes, between brackets.
pub fn quoted(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    format!("[{}]", words.join(", "))
}

/// Settings as comments behind a mark, a line each: the importer of matrices reads them.
pub fn settings(settings: &[(&str, String)], mark: &str) -> String {
    settings.iter().map(|(key, value)| format!("{mark} {key}: {value}\n")).collect()
}
