//! The verdicts on a plane as a whole, and the warning of mixed units.

use std::borrow::Cow;

use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::{GravityCheck, Margins, PlaneAnalysis};
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::static_stability::{PlaneStaticStability, PlaneStiffness, Stiffness};
use crate::number::significant;
use crate::scenario::{Convention, Dimension, Notation};
use crate::words::{mode, notation};

/// Dynamic stability, with what grows.
pub fn dynamic_sentence(plane: &PlaneAnalysis) -> String {
    match plane.dynamic_stability {
        Stability::Stable => "Dynamically stable: every pole is in the left half-plane".to_owned(),
        Stability::Neutral => "Dynamically neutral: a pole sits on the boundary".to_owned(),
        Stability::Unstable => {
            let growing = plane.modes.iter().filter_map(|mode| {
                let (name, doubles) = (mode::in_a_sentence(mode.naming.name), mode.time_to_double()?);
                Some(format!("the {name} doubles every {} s", significant(doubles, 2)))
            });
            format!("Dynamically unstable: {}", growing.collect::<Vec<_>>().join(", "))
        }
    }
}

/// Dynamic stability alone.
pub const fn dynamic_alone(plane: &PlaneAnalysis) -> &'static str {
    match plane.dynamic_stability {
        Stability::Stable => "Dynamically stable",
        Stability::Neutral => "Dynamically neutral",
        Stability::Unstable => "Dynamically unstable",
    }
}

/// What dynamic stability means.
pub const DYNAMIC_MEANING: &str = "What happens in the end: whether every disturbance dies away, for which every pole must be left of the \
    imaginary axis.";

/// Static stability, with its numbers in the unit of length of the source, and what grows all the same.
pub fn static_sentence(plane: &PlaneAnalysis, margins: Option<Margins>, convention: Convention) -> String {
    let PlaneStaticStability { determinant, of_determinant, stiffness, is_plain, .. } =
        plane.static_stability;
    let stiffness_of = |stiffness: Stiffness| {
        let (unit, in_si) = unit_of_stiffness(plane.model.plane, convention);
        format!("{}\u{a0}{unit}", significant(stiffness.value / in_si, 3))
    };
    let mut readings = Vec::new();
    match stiffness {
        PlaneStiffness::Longitudinal { m_w, .. } => {
            let symbol = notation::prose("M_w", convention.notation);
            let m_w = stiffness_of(m_w);
            readings.push(if is_plain {
                format!("pitch stiffness {symbol} {m_w}")
            } else {
                format!("pitch stiffness {symbol} {m_w}, if M_u is zero")
            });
            if let Some(Margins { static_margin, manoeuvre_margin }) = margins {
                readings.push(format!("static margin {}", percent(static_margin)));
                readings.push(format!("manoeuvre margin {}", percent(manoeuvre_margin)));
            }
            let determinant = significant(determinant, 3);
            readings.push(match of_determinant {
                Stability::Stable => format!("det\u{a0}A\u{a0}=\u{a0}{determinant}\u{a0}1/s⁴\u{a0}>\u{a0}0"),
                Stability::Neutral => "det\u{a0}A\u{a0}≈\u{a0}0".to_owned(),
                Stability::Unstable => {
                    format!("det\u{a0}A\u{a0}=\u{a0}{determinant}\u{a0}1/s⁴\u{a0}<\u{a0}0")
                }
            });
        }
        PlaneStiffness::Lateral { n_v, l_v, .. } => {
            readings.push(format!("weathercock stability {}", stiffness_of(n_v)));
            readings.push(format!("dihedral effect {}", stiffness_of(l_v)));
            if !is_plain {
                readings.push("both with the product of inertia".to_owned());
            }
        }
    }
    let sentence = format!("{}: {}", static_alone(plane), readings.join(", "));
    match grows_all_the_same(plane) {
        Some(remark) => format!("{sentence}. {remark}"),
        None => sentence,
    }
}

/// How a stiffness \[1/(m s)\] of a plane is written, by w or v or by α or β: its unit, and what one of that is.
pub fn unit_of_stiffness(plane: Plane, convention: Convention) -> (&'static str, f64) {
    let Convention { length, notation, speed } = convention;
    match notation {
        Notation::Velocities => {
            (Dimension::PerLengthSecond.symbol(length), Dimension::PerLengthSecond.in_si(length))
        }
        Notation::Angles => (Dimension::PerSecondSquared.symbol(length), 1.0 / speed[plane]),
    }
}

/// Static stability alone.
pub fn static_alone(plane: &PlaneAnalysis) -> &'static str {
    let PlaneStaticStability { verdict, stiffness, .. } = plane.static_stability;
    match stiffness {
        PlaneStiffness::Longitudinal { .. } => match verdict {
            Stability::Stable => "Statically stable in pitch",
            Stability::Neutral => "Statically neutral in pitch",
            Stability::Unstable => "Statically unstable in pitch",
        },
        PlaneStiffness::Lateral { n_v, l_v, .. } => {
            match (verdict, n_v.verdict == verdict, l_v.verdict == verdict) {
                (Stability::Stable, _, _) => "Statically stable in yaw and roll",
                (Stability::Neutral, true, true) => "Statically neutral in yaw and roll",
                (Stability::Neutral, true, false) => "Statically neutral in yaw",
                (Stability::Neutral, false, _) => "Statically neutral in roll",
                (Stability::Unstable, true, true) => "Statically unstable in yaw and roll",
                (Stability::Unstable, true, false) => "Statically unstable in yaw",
                (Stability::Unstable, false, _) => "Statically unstable in roll",
            }
        }
    }
}

/// What has to be said beside the stiffness where a real root grows: which, and what det A has to do with it.
fn grows_all_the_same(plane: &PlaneAnalysis) -> Option<String> {
    let PlaneStaticStability { verdict, of_determinant, stiffness, .. } = plane.static_stability;
    let growing: Vec<&str> = plane
        .modes
        .iter()
        .filter(|mode| !mode.is_oscillatory() && mode.stability == Stability::Unstable)
        .map(|mode| mode::in_a_sentence(mode.naming.name))
        .collect();
    let names = growing.join(" and the ");
    let [first, ..] = growing.as_slice() else { return None };
    match (stiffness, verdict, of_determinant) {
        (PlaneStiffness::Longitudinal { .. }, Stability::Unstable, Stability::Stable)
            if growing.len() > 1 =>
        {
            Some(format!("det A is positive since two real roots grow, the {names}"))
        }
        (_, Stability::Unstable, _) => None,
        (PlaneStiffness::Longitudinal { .. }, _, _) => {
            Some(format!("Yet the {names} grows: the terms of speed make det A negative"))
        }
        (PlaneStiffness::Lateral { .. }, _, _) if growing.len() == 1 => {
            Some(format!("Yet the {first} grows"))
        }
        (PlaneStiffness::Lateral { .. }, _, _) => Some(format!("Yet the {names} grow")),
    }
}

fn percent(share: f64) -> String {
    format!("{}\u{a0}%", significant(100.0 * share, 3))
}

/// What static stability means in a plane.
pub fn static_meaning(stability: &PlaneStaticStability, notation: Notation) -> Cow<'static, str> {
    let meaning = match stability.stiffness {
        PlaneStiffness::Longitudinal { .. } => {
            "Which way the first pitching moment points: a nose that is lifted must come down again, M_w < 0. It turns with the \
             centre of gravity at the neutral point, where the static margin is zero. det A is the product of the four \
             eigenvalues, and has the terms of speed in it too: where it is negative, a real root grows. Where it is positive \
             nothing is proved, since two real roots may grow together."
        }
        PlaneStiffness::Lateral { .. } => {
            "Which way the first moments of a sideslip point. In yaw the nose must turn into the wind: weathercock stability is \
             positive. In roll the wings must roll away from it: dihedral effect is negative. Whether a bank dies away is another \
             question, which the card of the spiral answers."
        }
    };
    notation::prose(meaning, notation)
}

/// The warning that gravity and speed don't belong to one system of units.
pub fn mixed_units(gravity: GravityCheck) -> String {
    let ratio = gravity.rate / gravity.expected_rate;
    let (rate, expected) = (significant(gravity.rate, 2), significant(gravity.expected_rate, 2));
    let ratio_shown = significant(ratio, 3);
    if ratio > 1.0 {
        format!(
            "Gravity and speed don't belong to one unit system: g/U₀ = {rate} 1/s, where Earth's gravity at this speed gives \
             {expected} 1/s. Gravity is {ratio_shown} times too strong."
        )
    } else {
        format!(
            "Gravity and speed don't belong to one unit system: g/U₀ = {rate} 1/s, where Earth's gravity at this speed gives \
             {expected} 1/s. Gravity is {ratio_shown} of what it is on Earth."
        )
    }
}
