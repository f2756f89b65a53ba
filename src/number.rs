//! Numbers as a person reads them: significant digits, a true minus sign, round steps.

use nalgebra::Complex;

/// A number with `digits` significant digits, with `−` for minus and an exponent only where digits would run away.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = value.abs().log10().floor();
    let text = if (-4.0..6.0).contains(&exponent) {
        let decimals = (digits as f64 - 1.0 - exponent).max(0.0) as usize;
        format!("{value:.decimals$}")
    } else {
        let decimals = digits.saturating_sub(1);
        format!("{value:.decimals$e}")
    };
    text.replace('-', "−")
}

/// Like [`significant`], without zeros at the end: "1", "0.2", "5.73".
pub fn trimmed(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The shortest text that reads back to the last bit, with `-` for minus, for files and links; an exponent only where that is shorter.
pub fn shortest(value: f64) -> String {
    let (plain, scientific) = (value.to_string(), format!("{value:e}"));
    if scientific.len() < plain.len() { scientific } else { plain }
}

/// A number with a fixed number of decimals, with `−` for minus and never a minus zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| matches!(c, '0' | '.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

/// An eigenvalue, or a pair of them by its upper one: "−2.51 ± 2.59j".
pub fn eigenvalue(lambda: Complex<f64>) -> String {
    let re = significant(lambda.re, 4);
    if lambda.im > 0.0 { format!("{re} ± {}j", significant(lambda.im, 4)) } else { re }
}

/// The smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 × 10ᵏ that is not less than `value`, which must be positive.
///
/// Ranges made of such numbers stay the same through small changes of what they hold.
pub fn round_up(value: f64) -> f64 {
    let decade = 10_f64.powf(value.log10().floor());
    [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]
        .into_iter()
        .map(|step| step * decade)
        .find(|&round| round >= value * (1.0 - 1e-12))
        .unwrap_or(10.0 * decade)
}

/// The smallest of 1, 2, 5 × 10ᵏ that is not less than `least`, which must be positive: a step of which people count multiples.
pub fn nice_step(least: f64) -> f64 {
    let power = least.log10().floor() as i32;
    // Divided by a whole number, 5 × 10⁻³ is the nearest number to 0.005.
    let scaled = |digit: f64| {
        if power < 0 { digit / 10_f64.powi(-power) } else { digit * 10_f64.powi(power) }
    };
    let steps = [1.0, 2.0, 5.0].map(scaled);
    steps.into_iter().find(|step| *step >= least * (1.0 - 1e-12)).unwrap_or(scaled(10.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_are_kept_and_minus_is_a_minus_sign() {
        assert_eq!(significant(-9.80665, 4), "−9.807");
        assert_eq!(significant(0.0062647654, 4), "0.006265");
        assert_eq!(significant(1763.5, 3), "1764");
        assert_eq!(significant(2.5e-7, 3), "2.50e−7");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(trimmed(1.0, 4), "1");
        assert_eq!(trimmed(-120.0, 4), "−120");
        assert_eq!(trimmed(0.25, 4), "0.25");
    }

    #[test]
    fn fixed_decimals_have_no_minus_zero() {
        assert_eq!(fixed(-0.0001, 2), "0.00");
        assert_eq!(fixed(-0.14657, 3), "−0.147");
    }

    #[test]
    fn a_step_is_one_two_or_five_times_a_power_of_ten() {
        for (least, step) in
            [(1.0, 1.0), (1.1, 2.0), (2.5, 5.0), (5.1, 10.0), (0.003, 0.005), (0.02, 0.02), (70.0, 100.0)]
        {
            assert_eq!(nice_step(least), step);
        }
    }

    #[test]
    fn rounding_up_is_never_less_and_never_a_third_more() {
        for value in [1e-9, 0.0031, 0.99, 1.0, 1.2, 4.9, 7.1, 9.99, 123.0, 6.5e8] {
            let round = round_up(value);
            assert!(round >= value * (1.0 - 1e-12) && round <= 1.34 * value, "{value} → {round}");
        }
    }
}
