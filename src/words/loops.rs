//! Loops of a law: their margins, Nyquist's count, and the map of gain and washout.

use crate::flight::feedback::margins::{GainMargin, LoopMargins, PhaseMargin, SensitivityPeak};
use crate::flight::modes::stability::Stability;
use crate::number::significant;

/// How far the gain of the loop may be changed, or has to be where it isn't stable.
pub fn gain_margin(margins: &LoopMargins, is_stable: bool) -> String {
    let told = |margin: GainMargin| {
        let GainMargin { factor, frequency } = margin;
        let factor_words = if factor > 1.0 {
            format!("×{}", significant(factor, 3))
        } else {
            format!("÷{}", significant(1.0 / factor, 3))
        };
        let decibels = significant(20.0 * factor.log10(), 3);
        format!("{factor_words} ({decibels} dB) at {} rad/s", significant(frequency, 3))
    };
    let told: Vec<String> = [margins.raise, margins.lower].into_iter().flatten().map(told).collect();
    match (told.is_empty(), is_stable) {
        (true, true) => "Gain margin: without bound".to_owned(),
        (true, false) => "No other gain makes it neutral".to_owned(),
        (false, true) => format!("Gain margin: {}", told.join(" and ")),
        (false, false) => format!("Neutral with the gain {}", told.join(" or ")),
    }
}

/// How far the phase of the loop may be changed, or has to be where it isn't stable.
pub fn phase_margin(margin: Option<PhaseMargin>, is_stable: bool) -> String {
    let Some(PhaseMargin { angle, frequency }) = margin else {
        let told = if is_stable {
            "Phase margin: without bound, |L| crosses 1 nowhere"
        } else {
            "No phase makes it stable, |L| crosses 1 nowhere"
        };
        return told.to_owned();
    };
    let degrees = significant(angle.abs().to_degrees(), 3);
    let side = if angle < 0.0 { " of lead" } else { "" };
    let at = significant(frequency, 3);
    if is_stable {
        format!("Phase margin: {degrees}°{side} at {at} rad/s")
    } else {
        format!("Neutral with a phase of {degrees}°{side} more at {at} rad/s")
    }
}

/// How near L comes to −1.
pub fn sensitivity(peak: Option<SensitivityPeak>) -> String {
    match peak {
        Some(SensitivityPeak { value, frequency }) => format!(
            "Sensitivity peak: {} at {} rad/s ({} from −1)",
            significant(value, 3),
            significant(frequency, 3),
            significant(1.0 / value, 3)
        ),
        None => "Sensitivity peak: 1".to_owned(),
    }
}

/// Nyquist's count: clockwise turns around −1, growing roots of the loop cut, and what the closed loop is.
pub fn nyquist(turns: Option<i32>, growing: usize, closed: Stability) -> String {
    let Some(turns) = turns else {
        let told = match closed {
            Stability::Stable => "The turns about −1 can’t be counted; the closed loop is stable",
            Stability::Neutral => "L goes through −1: the closed loop is neutral",
            Stability::Unstable => "The turns about −1 can’t be counted; the closed loop is unstable",
        };
        return told.to_owned();
    };
    let count = turns.unsigned_abs();
    let plural = if count == 1 { "" } else { "s" };
    let sense = match turns {
        0 => "",
        1.. => " clockwise",
        _ => " counter-clockwise",
    };
    let poles = if growing == 1 { "pole" } else { "poles" };
    let closed_growing = i64::from(turns) + growing as i64;
    let verdict = match closed {
        Stability::Stable => "stable".to_owned(),
        Stability::Neutral => "neutral".to_owned(),
        Stability::Unstable => format!("unstable, {closed_growing} closed"),
    };
    format!("{count} turn{plural}{sense} about −1, {growing} unstable {poles} of the loop cut: {verdict}")
}

/// The damping here, and the best with the same washout: both as (gain, damping ratio), 1 where nothing oscillates.
pub fn map(here: (f64, f64), washout: f64, best: (f64, f64)) -> String {
    let of = |(gain, damping): (f64, f64)| {
        let damping =
            if damping < 1.0 { format!("ζ = {}", significant(damping, 3)) } else { "none".to_owned() };
        format!("{damping} at k = {}", significant(gain, 3))
    };
    let with = if washout > 0.0 {
        format!("with a washout of {} s", significant(washout, 3))
    } else {
        "without washout".to_owned()
    };
    format!("Least damped oscillation: {}; best {with}: {}", of(here), of(best))
}
