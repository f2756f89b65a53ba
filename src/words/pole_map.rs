//! What a sighted person sees on a pole map: pairs and real poles, how quick and how damped they are, and which way they have gone.

use nalgebra::Complex;

use crate::flight::modes::mode::Mode;
use crate::flight::modes::stability::Stability;
use crate::number::significant;

/// From this natural frequency on a swing is quick, and from this rate on a real root \[1/s\].
const QUICK: f64 = 1.0;
/// Damping ratios from which on a swing is lightly, well and heavily damped.
const DAMPED: [f64; 3] = [0.05, 0.3, 0.9];
/// Who has gone less than this share of the distance from the origin stands where they stood.
const STILL: f64 = 0.02;

/// The poles as they lie; without numbers where these are hidden, without a word on damping and growth where verdicts are.
pub fn seen<'a>(
    modes: impl IntoIterator<Item = &'a Mode>,
    tells_numbers: bool,
    tells_verdicts: bool,
) -> String {
    let (pairs, real): (Vec<&Mode>, Vec<&Mode>) = modes.into_iter().partition(|mode| mode.is_oscillatory());
    let each = |mode: &&Mode| {
        let quick = if mode.lambda.norm() >= QUICK { "quick" } else { "slow" };
        let how = if tells_verdicts { format!(" and {}", damping(mode)) } else { String::new() };
        let place = if tells_numbers { format!(" at {}", place(mode)) } else { String::new() };
        format!("one {quick}{how}{place}")
    };
    let group = |modes: &[&Mode], one: &str, many: &str| {
        let each: Vec<String> = modes.iter().map(each).collect();
        let count = match modes.len() {
            0 => return None,
            1 => one.to_owned(),
            count => format!("{} {many}", counted(count)),
        };
        Some(format!("{count}, {}", each.join(", ")))
    };
    let groups = [group(&pairs, "One pair", "pairs"), group(&real, "One real pole", "real poles")];
    groups.into_iter().flatten().collect::<Vec<_>>().join(". ")
}

/// Which way a pole has gone since it stood elsewhere; nothing where it has hardly gone.
pub fn moved(mode: &Mode, before: Complex<f64>) -> Option<&'static str> {
    let gone = mode.lambda - Complex::new(before.re, before.im.abs());
    let far = |part: f64| part.abs() > STILL * mode.lambda.norm().max(before.norm());
    Some(match (far(gone.re), far(gone.im), gone.re > 0.0, gone.im > 0.0) {
        (true, true, true, true) => "right and up",
        (true, true, true, false) => "right and down",
        (true, true, false, true) => "left and up",
        (true, true, false, false) => "left and down",
        (true, false, true, _) => "right",
        (true, false, false, _) => "left",
        (false, true, _, true) => "up",
        (false, true, _, false) => "down",
        (false, false, ..) => return None,
    })
}

/// The telling numbers of a mode as they are read aloud.
pub fn aloud(mode: &Mode) -> String {
    let frequency = format!("{} radians a second", significant(mode.lambda.norm(), 2));
    match (mode.damping_ratio(), mode.time_to_half(), mode.time_to_double()) {
        (Some(ratio), ..) => format!("{frequency}, damping ratio {}", significant(ratio, 2)),
        (_, Some(time), _) => format!("halves in {} s", significant(time, 2)),
        (_, _, Some(time)) => format!("doubles in {} s", significant(time, 2)),
        _ => "neutral".to_owned(),
    }
}

fn damping(mode: &Mode) -> &'static str {
    match (mode.stability, mode.damping_ratio()) {
        (Stability::Unstable, _) => "growing",
        (Stability::Neutral, _) => "neutral",
        (Stability::Stable, None) => "fading",
        (Stability::Stable, Some(ratio)) => match DAMPED.iter().filter(|least| ratio >= **least).count() {
            0 => "hardly damped",
            1 => "lightly damped",
            2 => "well damped",
            _ => "heavily damped",
        },
    }
}

fn place(mode: &Mode) -> String {
    let re = significant(mode.lambda.re, 3);
    if mode.is_oscillatory() { format!("{re} ± {}i", significant(mode.lambda.im.abs(), 3)) } else { re }
}

fn counted(count: usize) -> String {
    match count {
        2 => "Two".to_owned(),
        3 => "Three".to_owned(),
        4 => "Four".to_owned(),
        count => count.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::findings::Findings;
    use crate::flight::aircraft::plane::Plane;
    use crate::scenario::Scenario;

    fn modes(key: &str, plane: Plane) -> Vec<Mode> {
        let aircraft = crate::content::embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
        let mut scenario = Scenario::new(aircraft.expect("it ships").into());
        scenario.plane = plane;
        Findings::of(scenario).modes().to_vec()
    }

    #[test]
    fn poles_are_told_as_they_are_seen() {
        let longitudinal = modes("navion", Plane::Longitudinal);
        assert_eq!(
            seen(&longitudinal, true, true),
            "Two pairs, one quick and well damped at −2.51 ± 2.59i, one slow and lightly damped at −0.0171 ± 0.213i"
        );
        assert_eq!(seen(&longitudinal, false, false), "Two pairs, one quick, one slow");
        let lateral = modes("b747-fc8", Plane::Lateral);
        let seen = seen(&lateral, false, true);
        assert!(seen.starts_with("One pair, one slow and lightly damped. Two real poles, "), "{seen}");
        assert!(seen.contains("one slow and growing"), "{seen}");
    }

    #[test]
    fn a_pole_goes_left_right_up_down_or_nowhere() {
        let modes = modes("navion", Plane::Longitudinal);
        let from = |re: f64, im: f64| moved(&modes[0], modes[0].lambda - Complex::new(re, im));
        assert_eq!(from(1.0, 0.0), Some("right"));
        assert_eq!(from(-1.0, -1.0), Some("left and down"));
        assert_eq!(from(0.0, 1.0), Some("up"));
        assert_eq!(from(0.01, 0.01), None);
    }
}
