//! A mode, or the two real roots it has become, as one second-order motion λ² + 2ζωₙλ + ωₙ² = 0.

use super::mode::Mode;
use super::mode_name::ModeName;

/// ωₙ and ζ of a pair of roots, oscillating (ζ < 1) or not (ζ ≥ 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondOrder {
    /// Undamped natural frequency ωₙ = √(λ₁λ₂) \[rad/s\].
    pub natural_frequency: f64,
    /// Damping ratio ζ = −(λ₁ + λ₂)/(2ωₙ), negative when growing.
    pub damping_ratio: f64,
}

impl SecondOrder {
    /// From λ² + d λ + k = 0, where d = 2ζωₙ \[1/s\] and k = ωₙ² \[1/s²\]; `None` where k ≤ 0: there is no frequency.
    pub fn of(d: f64, k: f64) -> Option<Self> {
        let natural_frequency = k.sqrt();
        let damping_ratio = d / (2.0 * natural_frequency);
        (natural_frequency > 0.0 && natural_frequency.is_finite() && damping_ratio.is_finite())
            .then_some(Self { natural_frequency, damping_ratio })
    }
}

/// The names of one oscillation and of the two real roots it parts into.
type Family = [ModeName; 3];

/// The short period and its roots.
pub const SHORT_PERIOD: Family =
    [ModeName::ShortPeriod, ModeName::ShortPeriodFastRoot, ModeName::ShortPeriodSlowRoot];
/// The phugoid and its roots.
pub const PHUGOID: Family = [ModeName::Phugoid, ModeName::PhugoidFastRoot, ModeName::PhugoidSlowRoot];
/// The Dutch roll and its roots.
pub const DUTCH_ROLL: Family =
    [ModeName::DutchRoll, ModeName::DutchRollMoreStableRoot, ModeName::DutchRollLessStableRoot];

/// The motion of one family of names among `modes`: of its pair, or of its two real roots together.
///
/// `None` where the family is not there, is split with one root grown into a divergence, or has roots on both sides of zero.
pub fn second_order(modes: &[Mode], [pair, one, other]: Family) -> Option<SecondOrder> {
    let find = |name: ModeName| modes.iter().find(|mode| mode.naming.name == name);
    if let Some(mode) = find(pair) {
        let wn = mode.lambda.norm();
        return (wn > 0.0)
            .then(|| SecondOrder { natural_frequency: wn, damping_ratio: -mode.lambda.re / wn });
    }
    let (one, other) = (find(one)?.lambda.re, find(other)?.lambda.re);
    SecondOrder::of(-(one + other), one * other)
}
