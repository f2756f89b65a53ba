//! Pairs of a name and a number in the printed logs of other programs: `CLa =   7.299206    CLb =-10.1`.

use crate::content::matrix::draft::number;

/// A name, what stands behind its equals sign, and the number that this begins with.
#[derive(Clone, Debug)]
pub(super) struct Pair<'t> {
    pub name: &'t str,
    pub value: f64,
    /// The pair as it stands in the text.
    pub text: &'t str,
    /// What follows the number, up to the next name.
    pub unit: &'t str,
}

/// Every pair of a line. A name is the word before the equals sign.
pub(super) fn pairs(line: &str) -> Vec<Pair<'_>> {
    let mut pairs = Vec::new();
    let mut from = 0;
    for (at, _) in line.match_indices('=') {
        if at < from {
            continue;
        }
        let before = line[from..at].trim_end();
        let start = before
            .rfind(char::is_whitespace)
            .map_or(0, |blank| blank + before[blank..].chars().next().map_or(1, char::len_utf8));
        let name = &before[start..];
        let behind = &line[at + 1..];
        let digits = behind.trim_start();
        let skipped = behind.len() - digits.len();
        let length = number_length(digits);
        let Some(value) = number(&digits[..length]) else { continue };
        let end = at + 1 + skipped + length;
        let rest = &line[end..];
        let unit = rest.find("  ").map_or(rest, |blank| &rest[..blank]).trim();
        pairs.push(Pair { name, value, text: line[from + start..end].trim(), unit });
        from = end;
    }
    pairs
}

/// What stands behind an equals sign and was to be a number: the stars of Fortran for one that is too wide, or no number at all.
pub(super) fn unreadable(line: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    for (at, _) in line.match_indices('=') {
        let name = line[..at].split_whitespace().next_back().unwrap_or_default();
        let word = line[at + 1..].split_whitespace().next().unwrap_or_default();
        let plain = word.trim_start_matches(['+', '-']).to_lowercase();
        if plain.starts_with("**") || plain.starts_with("nan") || plain.starts_with("inf") {
            found.push((name, word));
        }
    }
    found
}

/// A text with commas in its numbers as one with points, where it has more of those; `None` where it needs none.
pub(super) fn decimal_points(text: &str) -> Option<String> {
    let letters: Vec<char> = text.chars().collect();
    let between = |sign: char| {
        letters
            .windows(3)
            .filter(move |w| w[0].is_ascii_digit() && w[1] == sign && w[2].is_ascii_digit())
            .count()
    };
    if between(',') <= between('.') {
        return None;
    }
    let digit = |k: Option<usize>| k.and_then(|k| letters.get(k)).is_some_and(char::is_ascii_digit);
    let turned = letters
        .iter()
        .enumerate()
        .map(|(k, &c)| if c == ',' && digit(k.checked_sub(1)) && digit(Some(k + 1)) { '.' } else { c });
    Some(turned.collect())
}

/// A sign, digits with a point, an exponent.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = usize::from(text.starts_with(['+', '-']));
    end += digits(end);
    if bytes.get(end) == Some(&b'.') {
        end += 1;
        end += digits(end);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E' | b'd' | b'D')) {
        let mut at = end + 1;
        at += usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
        let exponent = digits(at);
        if exponent > 0 {
            end = at + exponent;
        }
    }
    end
}

/// The numbers of a line that holds nothing else.
pub(super) fn numbers(line: &str) -> Option<Vec<f64>> {
    let numbers: Option<Vec<f64>> = line.split_whitespace().map(number).collect();
    numbers.filter(|numbers| !numbers.is_empty())
}

/// The same where a column is full, and the number in it touches the one before: `0.0000-1249.8599`.
pub(super) fn glued(line: &str) -> Option<Vec<f64>> {
    let mut parted = String::with_capacity(line.len());
    for word in line.split_whitespace() {
        parted.push(' ');
        let mut before = ' ';
        for (at, c) in word.char_indices() {
            // A sign behind a digit begins the exponent of Fortran, `1.5-101`, unless a point follows.
            let is_next = c == '-' && before.is_ascii_digit() && word[at..].contains('.');
            if is_next {
                parted.push(' ');
            }
            parted.push(c);
            before = c;
        }
    }
    numbers(&parted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_touch_are_parted_and_exponents_are_not() {
        assert_eq!(glued(" 0.0000-1249.8599  -0.1535E-01 0.000"), Some(vec![0.0, -1249.8599, -0.01535, 0.0]));
        assert_eq!(glued("u w q"), None);
    }

    #[test]
    fn commas_are_points_where_there_are_more_of_them() {
        assert_eq!(
            decimal_points("CLa =   4,44    Cma = -0,683, 2").as_deref(),
            Some("CLa =   4.44    Cma = -0.683, 2")
        );
        assert_eq!(decimal_points("a = 1.5, b = 2.5 (1,2)"), None);
        assert_eq!(
            unreadable(" CLa = ******** Cma =-NaN Cmq = 3 info = x"),
            [("CLa", "********"), ("Cma", "-NaN")]
        );
    }

    #[test]
    fn pairs_are_read_with_glued_signs_and_exponents() {
        let line = " y  mom. Cm |    Cma =  -1.884644    Cmb =-10.1  CLd01 = -0.17402146E-01  Mass= 0.185 kg";
        let found: Vec<(&str, f64)> = pairs(line).iter().map(|pair| (pair.name, pair.value)).collect();
        assert_eq!(found, [("Cma", -1.884644), ("Cmb", -10.1), ("CLd01", -0.017402146), ("Mass", 0.185)]);
        assert_eq!(pairs(line)[3].unit, "kg");
        assert_eq!(pairs("= 3").len(), 1);
        assert_eq!(pairs("é=é = 3 =")[0].name, "é=é");
    }
}
