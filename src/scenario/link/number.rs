//! Numbers of a link: the shortest that read back exactly.

use super::super::ValueError;
use super::notice::quoted;
use crate::number::shortest;

/// After a number that is in SI where the key's unit is another: `0.1si` is 0.1 rad.
const SI: &str = "si";

/// A value \[SI\] in a unit, or in SI where that is shorter or the unit can't give it to the last bit.
pub(super) fn write(value: f64, unit: f64) -> String {
    if unit == 1.0 {
        return shortest(value);
    }
    // Division and multiplication round: the number that gives the value is this one or one beside it.
    let near = value / unit;
    [near, near.next_down(), near.next_up(), near.next_down().next_down(), near.next_up().next_up()]
        .into_iter()
        .filter(|x| x * unit == value)
        .map(shortest)
        .chain([shortest(value) + SI])
        .min_by_key(String::len)
        .unwrap_or_default()
}

/// A value \[SI\] from a number in a unit.
pub(super) fn read(text: &str, unit: f64) -> Result<f64, ValueError> {
    let (digits, unit) = text.strip_suffix(SI).map_or((text, unit), |digits| (digits, 1.0));
    let number: f64 =
        digits.trim().replace('−', "-").parse().map_err(|_| ValueError::NotANumber(quoted(text)))?;
    Ok(number * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREE: f64 = std::f64::consts::PI / 180.0;

    #[test]
    fn numbers_are_as_short_as_they_can_be() {
        for (value, unit, text) in [
            (60.0, 1.0, "60"),
            (-0.683, 1.0, "-0.683"),
            (1e-17, 1.0, "1e-17"),
            (25.0 * DEGREE, DEGREE, "25"),
            (1_f64.to_radians(), DEGREE, "1"),
            (0.1, DEGREE, "0.1si"),
            (57.0 * 0.01, 0.01, "57"),
            (1.1, 0.01, "110"),
        ] {
            assert_eq!(write(value, unit), text);
            assert_eq!(read(text, unit), Ok(value));
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in ["", "si", "abc", "1,5", "0x10", "--1", "1e"] {
            assert!(matches!(read(text, 1.0), Err(ValueError::NotANumber(_))), "{text}");
        }
    }
}
