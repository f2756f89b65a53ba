//! Several cases in one file, one after another: a person says which of them counts.

use super::review::Field;
use super::sheet::Sheet;
use super::system::eigenvalues;
use crate::content::matrix::draft::Problem;
use crate::number::eigenvalue;

/// A line of a file with its number.
pub(super) type Line<'t> = (usize, &'t str);

/// The lines of each case. One begins where `begins_anew` says of a section, beside those that its case has had, that it is of the next;
/// and from the first line before it that `belongs` to what stands before the sections.
pub(super) fn parted<'s, 't>(
    lines: &'s [Line<'t>],
    section: impl Fn(&str) -> Option<usize>,
    begins_anew: impl Fn(usize, &[usize]) -> bool,
    belongs: impl Fn(&str) -> bool,
) -> Vec<&'s [Line<'t>]> {
    let mut starts = vec![0];
    let (mut seen, mut last) = (Vec::new(), 0);
    for (k, (_, text)) in lines.iter().enumerate() {
        let Some(section) = section(text) else { continue };
        if begins_anew(section, &seen) {
            starts.push((last + 1..k).find(|&k| belongs(lines[k].1)).unwrap_or(k));
            seen.clear();
        }
        seen.push(section);
        last = k;
    }
    (0..starts.len()).map(|k| &lines[starts[k]..starts.get(k + 1).copied().unwrap_or(lines.len())]).collect()
}

/// The place of the case that counts: the only one, or that which is chosen by its words. `None` while it isn't chosen.
pub(super) fn chosen(
    sheet: &mut Sheet,
    meaning: &str,
    words: &[String],
    suggestion: Option<(usize, String)>,
) -> Result<Option<usize>, Problem> {
    if words.len() < 2 {
        return Ok(Some(0));
    }
    let keys: Vec<String> = (1..=words.len()).map(|k| k.to_string()).collect();
    let choices: Vec<(&str, &str)> =
        keys.iter().zip(words).map(|(key, words)| (key.as_str(), words.as_str())).collect();
    let suggestion = suggestion.map(|(k, reason)| ((k + 1).to_string(), reason));
    let chosen = sheet.chosen(Field::choice("case", meaning, &choices), None, suggestion)?;
    Ok(chosen.and_then(|chosen| keys.iter().position(|key| *key == chosen)))
}

/// The eigenvalues of a matrix in words, of a pair the upper one: what tells two systems apart that say nothing else of themselves.
pub(super) fn told_by_eigenvalues(a: &[Vec<f64>]) -> Option<String> {
    let is_square = a.iter().all(|row| row.len() == a.len());
    let mut values = eigenvalues(a).filter(|_| is_square)?;
    values.retain(|value| value.im >= 0.0);
    values.sort_by(|x, y| y.norm().total_cmp(&x.norm()));
    let told: Vec<String> = values.into_iter().map(eigenvalue).collect();
    Some(format!("eigenvalues {}", told.join(", ")))
}
