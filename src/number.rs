//! Numbers as a person reads them: significant digits and a true minus sign.

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

/// A number with a fixed number of decimals, with `−` for minus and never a minus zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| matches!(c, '0' | '.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
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
}
