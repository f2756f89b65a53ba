//! The names that modes can have, and what naming needs of a mode without one.

use nalgebra::Complex;

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

impl ModeName {
    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ShortPeriod => "Short period",
            Self::ShortPeriodFastRoot => "Short period, fast root",
            Self::ShortPeriodSlowRoot => "Short period, slow root",
            Self::ThirdOscillatory => "Third oscillatory mode",
            Self::Phugoid => "Phugoid",
            Self::PhugoidFastRoot => "Phugoid, fast root",
            Self::PhugoidSlowRoot => "Phugoid, slow root",
            Self::Divergence => "Divergence",
            Self::DutchRoll => "Dutch roll",
            Self::DutchRollMoreStableRoot => "Dutch roll, more stable root",
            Self::DutchRollLessStableRoot => "Dutch roll, less stable root",
            Self::CoupledRollSpiral => "Coupled roll–spiral",
            Self::RollSubsidence => "Roll subsidence",
            Self::Spiral => "Spiral",
        }
    }

    /// The name as it stands within a sentence: "short period", but "Dutch roll"; "roll mode", which may grow too.
    pub fn in_a_sentence(self) -> String {
        match self {
            Self::RollSubsidence => "roll mode".to_owned(),
            _ if self.text().starts_with("Dutch") => self.text().to_owned(),
            _ => self.text().to_lowercase(),
        }
    }
}

/// A name, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Naming {
    /// What the mode is called.
    pub name: ModeName,
    /// Share of the mode in the states that gave it its name, 0 to 1. Near ½ the name is a matter of degree.
    pub confidence: f64,
    /// The reason in one or two sentences, with its numbers.
    pub reason: String,
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

/// The naming itself, with a word of caution where the shape is mixed.
pub(super) fn naming(name: ModeName, confidence: f64, reason: String) -> Naming {
    // Shares that add up to one do so but for rounding.
    let confidence = confidence.clamp(0.0, 1.0);
    let reason = if confidence < 0.65 {
        format!("{reason} The shape is mixed, so the name is a matter of degree.")
    } else {
        reason
    };
    Naming { name, confidence, reason }
}

/// A share as a person reads it: "99.7 %", "95 %".
pub(super) fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if (99.0..99.95).contains(&value) { format!("{value:.1} %") } else { format!("{value:.0} %") }
}
