//! The names that modes can have, and what naming needs of a mode without one.

use nalgebra::Complex;

use super::reason::{Fact, Reason, StateSet};
use super::stability::Stability;

/// What a mode is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ModeName {
    /// Fast oscillation of angle of attack and pitch rate at nearly constant speed.
    ShortPeriod,
    /// The faster of two real roots that an overdamped short period has become.
    ShortPeriodFastRoot,
    /// The slower of two real roots that an overdamped short period has become.
    ShortPeriodSlowRoot,
    /// Oscillation of an aircraft that diverges in pitch, mixing all four states.
    ThirdOscillatory,
    /// Slow exchange of speed and height at nearly constant angle of attack.
    Phugoid,
    /// The faster of two real roots that the phugoid has become.
    PhugoidFastRoot,
    /// The slower of two real roots that the phugoid has become.
    PhugoidSlowRoot,
    /// A real root of pitch or speed that grows: the aircraft departs without oscillating.
    Divergence,
    /// Oscillation in yaw and sideslip, with the wings rocking.
    DutchRoll,
    /// The further left of two real roots that the Dutch roll has become.
    DutchRollMoreStableRoot,
    /// The further right of two real roots that the Dutch roll has become; growing, it is the directional divergence.
    DutchRollLessStableRoot,
    /// Oscillation that roll subsidence and spiral have become together: the lateral phugoid.
    CoupledRollSpiral,
    /// Fast dying away of a roll rate.
    RollSubsidence,
    /// Slow turning in or out of a banked turn.
    Spiral,
}

/// A name, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Naming {
    /// What the mode is called.
    pub name: ModeName,
    /// Share of the mode in the states that gave it its name, 0 to 1. Near ½ the name is a matter of degree.
    pub confidence: f64,
    /// Why.
    pub reason: Reason,
}

/// An unnamed mode as far as naming needs it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub lambda: Complex<f64>,
    pub participation: [f64; 4],
    pub stability: Stability,
}

impl Shape {
    pub fn oscillates(&self) -> bool {
        self.lambda.im > 0.0
    }

    pub fn grows(&self) -> bool {
        self.stability == Stability::Unstable
    }
}

/// The real roots among `shapes`, from left to right along the real axis.
pub(super) fn real_roots_in_order(shapes: &[Shape]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..shapes.len()).filter(|&i| !shapes[i].oscillates()).collect();
    order.sort_by(|&i, &j| shapes[i].lambda.re.total_cmp(&shapes[j].lambda.re));
    order
}

/// Of two oscillations, which is faster (the greater |λ|); `None` unless there are exactly two modes that both oscillate.
pub(super) fn faster_of_two_pairs(shapes: &[Shape]) -> Option<usize> {
    match shapes {
        [first, second] if first.oscillates() && second.oscillates() => {
            Some(usize::from(second.lambda.norm() > first.lambda.norm()))
        }
        _ => None,
    }
}

/// Mean of a share over the modes that oscillate, or over those that don't.
pub(super) fn mean_share(shapes: &[Shape], oscillating: bool, share: impl Fn(&Shape) -> f64) -> f64 {
    let shares: Vec<f64> = shapes.iter().filter(|s| s.oscillates() == oscillating).map(share).collect();
    shares.iter().sum::<f64>() / shares.len().max(1) as f64
}

/// Below this confidence the shape is mixed.
const MIXED: f64 = 0.65;

/// The name of `shape`, for the participation of `states` and the facts beside it.
pub(super) fn naming(name: ModeName, shape: &Shape, states: StateSet, mut facts: Vec<Fact>) -> Naming {
    // Shares that add up to one do so but for rounding.
    let confidence = states.share(&shape.participation).clamp(0.0, 1.0);
    if confidence < MIXED {
        facts.push(Fact::MixedShape);
    }
    Naming { name, confidence, reason: Reason { states, facts } }
}
