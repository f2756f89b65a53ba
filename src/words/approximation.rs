//! The textbooks' approximations: what each is called, its formula, and what it leaves out.

use std::borrow::Cow;

use crate::flight::modes::approximations::{Approximation, ApproximationName, ModeValue};
use crate::number::{fixed, significant};
use crate::scenario::Notation;
use crate::words::notation;

/// The approximation, named after the one mode that it is of.
pub const fn name(name: ApproximationName, notation: Notation) -> &'static str {
    match (name, notation) {
        (ApproximationName::ShortPeriodTwoStates, Notation::Angles) => "two degrees of freedom (α, q)",
        (ApproximationName::PhugoidResidualised, Notation::Angles) => "quasi-steady α and q",
        (ApproximationName::DutchRollTwoStates, Notation::Angles) => "two degrees of freedom (β, r)",
        (name, _) => name_in_velocities(name),
    }
}

const fn name_in_velocities(name: ApproximationName) -> &'static str {
    match name {
        ApproximationName::ShortPeriodTwoStates => "two degrees of freedom (w, q)",
        ApproximationName::ShortPeriodPitchOnly => "one degree of freedom (pitch)",
        ApproximationName::PhugoidLanchester => "Lanchester",
        ApproximationName::PhugoidTwoStates => "two degrees of freedom (u, θ)",
        ApproximationName::PhugoidResidualised => "quasi-steady w and q",
        ApproximationName::PhugoidQuartic | ApproximationName::SpiralPolynomial => "from the quartic",
        ApproximationName::DutchRollTwoStates => "two degrees of freedom (v, r)",
        ApproximationName::DutchRollYawOnly => "one degree of freedom (yaw)",
        ApproximationName::RollDamping => "one degree of freedom (roll)",
        ApproximationName::SpiralWithGravity => "with gravity",
        ApproximationName::SpiralQuick => "Nelson",
    }
}

/// Its formula in the symbols of the sliders: without a prime those of the dimensional derivatives, with a prime those of A.
pub const fn formula(name: ApproximationName, notation: Notation) -> &'static str {
    match (name, notation) {
        (ApproximationName::ShortPeriodTwoStates, Notation::Angles) => {
            "ωₙ² = Z_α M_q/V − M_α,  2ζωₙ = −(Z_α/V + M_q + M_α\u{307})"
        }
        (ApproximationName::ShortPeriodPitchOnly, Notation::Angles) => {
            "ωₙ² = −M_α,  2ζωₙ = −(M_q + M_α\u{307})"
        }
        (ApproximationName::PhugoidResidualised, Notation::Angles) => {
            "ωₙ² = det Aᵣ,  2ζωₙ = −tr Aᵣ,  Aᵣ = A₁₁ − A₁₂ A₂₂⁻¹ A₂₁,  1 = (u, θ), 2 = (α, q)"
        }
        (ApproximationName::DutchRollTwoStates, Notation::Angles) => {
            "ωₙ² = N′_β + Y_β N′_r/V,  2ζωₙ = −(Y_β/V + N′_r)"
        }
        (ApproximationName::DutchRollYawOnly, Notation::Angles) => "ωₙ² = N′_β,  2ζωₙ = −N′_r",
        (ApproximationName::SpiralWithGravity, Notation::Angles) => {
            "λ = −(g/V)(L′_β N′_r − N′_β L′_r) / (L′_β (N′_p − g/V) − N′_β L′_p)"
        }
        (ApproximationName::SpiralQuick, Notation::Angles) => "λ = (L′_β N′_r − N′_β L′_r)/L′_β",
        (name, _) => formula_in_velocities(name),
    }
}

const fn formula_in_velocities(name: ApproximationName) -> &'static str {
    match name {
        ApproximationName::ShortPeriodTwoStates => "ωₙ² = Z_w M_q − V M_w,  2ζωₙ = −(Z_w + M_q + V M_ẇ)",
        ApproximationName::ShortPeriodPitchOnly => "ωₙ² = −V M_w,  2ζωₙ = −(M_q + V M_ẇ)",
        ApproximationName::PhugoidLanchester => "ωₙ = √2 g/V",
        ApproximationName::PhugoidTwoStates => "ωₙ² = −Z_u g/V,  ζ = −X_u/(2ωₙ)",
        ApproximationName::PhugoidResidualised => {
            "ωₙ² = det Aᵣ,  2ζωₙ = −tr Aᵣ,  Aᵣ = A₁₁ − A₁₂ A₂₂⁻¹ A₂₁,  1 = (u, θ), 2 = (w, q)"
        }
        ApproximationName::PhugoidQuartic => "ωₙ² = E/C,  2ζωₙ = D/C − B E/C²,  λ⁴ + Bλ³ + Cλ² + Dλ + E",
        ApproximationName::DutchRollTwoStates => "ωₙ² = V N′_v + Y_v N′_r,  2ζωₙ = −(Y_v + N′_r)",
        ApproximationName::DutchRollYawOnly => "ωₙ² = V N′_v,  2ζωₙ = −N′_r",
        ApproximationName::RollDamping => "λ = L′_p",
        ApproximationName::SpiralPolynomial => "λ = −E/D,  λ⁴ + Bλ³ + Cλ² + Dλ + E",
        ApproximationName::SpiralWithGravity => {
            "λ = −(g/V)(L′_v N′_r − N′_v L′_r) / (L′_v (N′_p − g/V) − N′_v L′_p)"
        }
        ApproximationName::SpiralQuick => "λ = (L′_v N′_r − N′_v L′_r)/L′_v",
    }
}

/// The terms and motions that it leaves out, in a sentence.
pub fn neglects(name: ApproximationName, notation: Notation) -> Cow<'static, str> {
    if let (ApproximationName::PhugoidResidualised, Notation::Angles) = (name, notation) {
        return "The time that α and q take: they follow u and θ at once.".into();
    }
    notation::prose(neglected(name), notation)
}

const fn neglected(name: ApproximationName) -> &'static str {
    match name {
        ApproximationName::ShortPeriodTwoStates => "Changes of speed: u is held at zero.",
        ApproximationName::ShortPeriodPitchOnly => {
            "Changes of speed and all heaving (Z_w): the aircraft turns about a point that flies straight on."
        }
        ApproximationName::PhugoidLanchester => {
            "Drag, any change of angle of attack, compressibility (M_u, and Z_u beyond −2g/V)."
        }
        ApproximationName::PhugoidTwoStates => {
            "Any change of angle of attack: the moment with speed (M_u) and the lift and drag it brings."
        }
        ApproximationName::PhugoidResidualised => "The time that w and q take: they follow u and θ at once.",
        ApproximationName::PhugoidQuartic => "Powers of the slow roots beside the fast ones.",
        ApproximationName::DutchRollTwoStates => {
            "Rolling: p and φ are held at zero. The primes include the product of inertia."
        }
        ApproximationName::DutchRollYawOnly => {
            "Rolling and sideways motion (Y_v): the aircraft turns about a point that flies straight on. The primes include the \
             product of inertia."
        }
        ApproximationName::RollDamping => {
            "Sideslip and yaw: the aircraft rolls about its x axis only. The prime includes the product of inertia."
        }
        ApproximationName::SpiralPolynomial => "Powers of the slow root beside the fast ones.",
        ApproximationName::SpiralWithGravity => {
            "Powers of the slow root, the side force Y_v and the slope of the flight path: level flight only. The primes include \
             the product of inertia."
        }
        ApproximationName::SpiralQuick => {
            "Roll damping and N′_p, which make the spiral 3 to 40 times slower: in level flight only its sign is right. \
             The primes include the product of inertia."
        }
    }
}

/// Relative error from which on an approximation is none.
pub const BEYOND_USE: f64 = 1.0;

/// The numbers of an approximation beside those of the exact mode: "two degrees of freedom (w, q): ωₙ 3.60 rad/s, exact 3.61, −0.2 %; ζ …".
pub fn values(approximation: &Approximation, notation: Notation) -> String {
    let name = name(approximation.name, notation);
    let beside = |symbol: &str, unit: &str, given: f64, exact: Option<f64>, error: Option<f64>| {
        let exact = exact.map_or_else(String::new, |exact| format!(", exact {}", significant(exact, 3)));
        let error = match error {
            Some(error) if error.abs() <= BEYOND_USE => format!(", {}", signed_percent(error)),
            Some(_) => ": does not apply here".to_owned(),
            None => String::new(),
        };
        format!("{symbol} {}{unit}{exact}{error}", significant(given, 3))
    };
    let error = approximation.error();
    let values = match (approximation.value, approximation.exact) {
        (None, _) => "gives nothing here".to_owned(),
        (Some(ModeValue::Root(given)), exact) => {
            let exact = exact.and_then(|exact| match exact {
                ModeValue::Root(root) => Some(root),
                ModeValue::SecondOrder { .. } => None,
            });
            beside("λ", " 1/s", given, exact, error)
        }
        (Some(ModeValue::SecondOrder { natural_frequency, damping_ratio }), exact) => {
            let (exact_frequency, exact_damping) = match exact {
                Some(ModeValue::SecondOrder { natural_frequency, damping_ratio }) => {
                    (Some(natural_frequency), damping_ratio)
                }
                Some(ModeValue::Root(_)) | None => (None, None),
            };
            let frequency = beside("ωₙ", " rad/s", natural_frequency, exact_frequency, error);
            let damping =
                damping_ratio.map(|zeta| beside("ζ", "", zeta, exact_damping, approximation.damping_error()));
            [Some(frequency), damping].into_iter().flatten().collect::<Vec<_>>().join("; ")
        }
    };
    format!("{name}: {values}")
}

/// A relative error in per cent, with its sign.
pub fn signed_percent(error: f64) -> String {
    let percent = 100.0 * error;
    let decimals = if percent.abs() < 10.0 { 1 } else { 0 };
    format!("{}{}\u{a0}%", if error >= 0.0 { "+" } else { "" }, fixed(percent, decimals))
}
