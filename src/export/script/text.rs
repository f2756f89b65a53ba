//! Numbers and lists as scripts of most languages write them: the shortest that reads back to the last bit.

use crate::content::LengthUnit;
use crate::flight::aircraft::plane::Trim;
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

/// What the importer of matrices must know to read A and B again, as comments behind a mark, a line each; in this unit of length.
pub fn settings(trim: &Trim, length: LengthUnit, mark: &str) -> String {
    let units = match length {
        LengthUnit::Metre => "SI",
        LengthUnit::Foot => "ft-slug-s",
        // No file says so.
        LengthUnit::HundredFeet => return String::new(),
    };
    let angles = [("alpha0_deg", trim.alpha0), ("gamma0_deg", trim.gamma0)];
    let angles = angles.into_iter().filter(|(_, angle)| *angle != 0.0);
    let angles = angles.map(|(key, angle)| format!("{mark} {key}: {}\n", number(angle.to_degrees())));
    format!(
        "{mark} units: {units}\n{mark} speed: {}\n{}",
        number(trim.speed / length.metres()),
        angles.collect::<String>()
    )
}
