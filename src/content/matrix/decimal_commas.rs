//! Commas that are decimal commas, as much of Europe writes them: told from those that part numbers by what else stands between these.

use std::borrow::Cow;

/// Rows of bare numbers with points: each comma stands between two digits, something else parts the numbers, and there is no point.
pub(super) fn in_rows(text: &str) -> Cow<'_, str> {
    let parted = |line: &str| line.split([';', '\t', ' ']).filter(|cell| !cell.is_empty()).count() >= 3;
    let are_decimal = text.contains(',')
        && !text.contains('.')
        && text.lines().all(all_between_digits)
        && text.lines().filter(|line| line.contains(',')).all(parted);
    if are_decimal { Cow::Owned(text.replace(',', ".")) } else { Cow::Borrowed(text) }
}

/// A script with points: somewhere numbers with commas are parted by blanks, and no number has a point.
pub(super) fn in_script(text: &str) -> Cow<'_, str> {
    let code = || text.lines().map(|line| line.split(['%', '#']).next().unwrap_or_default());
    let is_parted = |line: &str| {
        all_between_digits(line) && has(line, |between| !between.is_empty() && between.trim().is_empty())
    };
    let are_decimal = !code().any(|line| has(line, |between| between == "."))
        && code().any(|line| line.contains(',') && is_parted(line));
    if !are_decimal {
        return Cow::Borrowed(text);
    }
    let line = |line: &str| {
        let code = line.split(['%', '#']).next().unwrap_or_default();
        let mut plain = String::with_capacity(line.len() + 1);
        let mut characters = code.chars().peekable();
        let mut before = ' ';
        while let Some(c) = characters.next() {
            let is_decimal =
                c == ',' && before.is_ascii_digit() && characters.peek().is_some_and(char::is_ascii_digit);
            plain.push(if is_decimal { '.' } else { c });
            before = c;
        }
        plain + &line[code.len()..] + "\n"
    };
    Cow::Owned(text.lines().map(line).collect())
}

/// Whether each comma of a line has a digit on either side.
fn all_between_digits(line: &str) -> bool {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let parts: Vec<&str> = line.split(',').collect();
    parts.windows(2).all(|pair| is_digit(pair[0].chars().next_back()) && is_digit(pair[1].chars().next()))
}

/// Whether two numbers of a line have something between them of which this is true; a sign belongs to the number.
fn has(line: &str, is: impl Fn(&str) -> bool) -> bool {
    let mut rest = line;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        rest = rest[start..].trim_start_matches(|c: char| c.is_ascii_digit());
        let Some(next) = rest.find(|c: char| c.is_ascii_digit()) else { return false };
        if is(rest[..next].trim_end_matches(['-', '+'])) {
            return true;
        }
    }
    false
}
