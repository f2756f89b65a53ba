//! The reason for a mode's name, as data.

/// States of one plane whose participation together gives a mode its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateSet {
    /// w (as α) and q: the short period.
    AngleOfAttackAndPitchRate,
    /// u and θ: the phugoid.
    SpeedAndPitchAngle,
    /// v (as β) and r: the Dutch roll.
    SideslipAndYawRate,
    /// p and φ: what roll subsidence and spiral are together.
    RollRateAndBankAngle,
    /// p: roll subsidence.
    RollRate,
    /// φ: the spiral.
    BankAngle,
}

impl StateSet {
    /// Places of the states in the state vector of their plane.
    pub const fn states(self) -> &'static [usize] {
        match self {
            Self::AngleOfAttackAndPitchRate => &[1, 2],
            Self::SpeedAndPitchAngle => &[0, 3],
            Self::SideslipAndYawRate => &[0, 2],
            Self::RollRateAndBankAngle => &[1, 3],
            Self::RollRate => &[1],
            Self::BankAngle => &[3],
        }
    }

    /// Their part in a mode, 0 to 1, from the participation of all four states.
    pub fn share(self, participation: &[f64; 4]) -> f64 {
        self.states().iter().map(|&k| participation[k]).sum()
    }
}

/// The reason for a name: the states that gave it, and the facts beside them in the order in which they are told.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// States whose share of the mode is the confidence in the name.
    pub states: StateSet,
    /// Facts about this mode among the others.
    pub facts: Vec<Fact>,
}

/// One fact about a mode, told in one sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fact {
    /// Speed takes hardly any part in a short period.
    SteadySpeed,
    /// One of two real roots of the short period, the faster.
    ShortPeriodFaster,
    /// One of two real roots of the short period, the slower.
    ShortPeriodSlower,
    /// A real root of the short period whose partner is part of the third oscillatory mode.
    ShortPeriodBesideThirdOscillation,
    /// A real root of the short period whose partner grows.
    ShortPeriodBesideDivergence,
    /// Exchange of speed and height with little change of α.
    EnergyExchange,
    /// Exchange of speed and height in which α takes part.
    EnergyExchangeWithAlpha,
    /// One of two real roots of the phugoid, the faster.
    PhugoidFaster,
    /// One of two real roots of the phugoid, the slower.
    PhugoidSlower,
    /// An oscillation beside a real root that grows.
    OscillationBesideDivergence,
    /// A real root that grows, of angle of attack and pitch rate.
    PitchDivergence,
    /// A real root that grows, of speed and pitch attitude.
    SpeedDivergence,
    /// Yaw and sideslip with rolling.
    YawingAndRocking,
    /// One of two real roots of the Dutch roll, the further left.
    DutchRollMoreStable,
    /// One of two real roots of the Dutch roll, the further right.
    DutchRollLessStable,
    /// One of two real roots of the Dutch roll, which grows.
    DirectionalDivergence,
    /// Roll subsidence and spiral as one oscillation.
    RollMeetsSpiral,
    /// A roll rate that dies out.
    RollRateDiesOut,
    /// A roll rate that grows.
    RollDriven,
    /// A bank angle that grows faster than a roll rate dies out.
    BankDriven,
    /// A bank angle that grows.
    BankGrows,
    /// A bank angle that stays.
    BankStays,
    /// A bank angle that dies away.
    BankDecays,
    /// No root of the plane oscillates, so that order tells them apart.
    FourRealRoots,
    /// Two oscillations, and the ratio of the greater |λ| to the smaller.
    TwoOscillations(f64),
    /// A participation too evenly spread for a certain name.
    MixedShape,
}
