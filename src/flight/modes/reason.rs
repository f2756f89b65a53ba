//! The reason for a mode's name, as data.

use crate::flight::aircraft::states::{Lateral, Longitudinal};

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
    /// Whichever of (w, q) and (u, θ) has more, where neither family fits.
    LongitudinalMix,
    /// Whichever of (v, r), p and φ has most, where no family fits.
    LateralMix,
    /// The state beside the four that a mode is named after, or all of those: none of these.
    Appended,
}

impl StateSet {
    /// The sets of a plane of which one has most where a mode mixes; this set alone elsewhere.
    pub const fn parts(self) -> &'static [Self] {
        match self {
            Self::AngleOfAttackAndPitchRate => &[Self::AngleOfAttackAndPitchRate],
            Self::SpeedAndPitchAngle => &[Self::SpeedAndPitchAngle],
            Self::SideslipAndYawRate => &[Self::SideslipAndYawRate],
            Self::RollRateAndBankAngle => &[Self::RollRateAndBankAngle],
            Self::RollRate => &[Self::RollRate],
            Self::BankAngle => &[Self::BankAngle],
            Self::LongitudinalMix => &[Self::AngleOfAttackAndPitchRate, Self::SpeedAndPitchAngle],
            Self::LateralMix => &[Self::SideslipAndYawRate, Self::RollRate, Self::BankAngle],
            Self::Appended => &[Self::Appended],
        }
    }

    /// Their part in a mode, 0 to 1, from the participation of all four states; of a mix, that of the largest part.
    pub fn share(self, participation: &[f64; 4]) -> f64 {
        let of = |states: &[usize]| states.iter().map(|&k| participation[k]).sum::<f64>();
        match self {
            Self::AngleOfAttackAndPitchRate => of(&[Longitudinal::W.index(), Longitudinal::Q.index()]),
            Self::SpeedAndPitchAngle => of(&[Longitudinal::U.index(), Longitudinal::Theta.index()]),
            Self::SideslipAndYawRate => of(&[Lateral::V.index(), Lateral::R.index()]),
            Self::RollRateAndBankAngle => of(&[Lateral::P.index(), Lateral::Phi.index()]),
            Self::RollRate => of(&[Lateral::P.index()]),
            Self::BankAngle => of(&[Lateral::Phi.index()]),
            Self::Appended => 0.0,
            Self::LongitudinalMix | Self::LateralMix => {
                self.parts().iter().map(|part| part.share(participation)).fold(0.0, f64::max)
            }
        }
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
    /// Speed takes part in a short period: |u/V| over |α|.
    SpeedWithAlpha(f64),
    /// One of two real roots of the short period, the faster.
    ShortPeriodFaster,
    /// One of two real roots of the short period, the slower.
    ShortPeriodSlower,
    /// A real root of the short period whose partner is part of the third oscillatory mode.
    ShortPeriodBesideThirdOscillation,
    /// A real root of the short period whose partner grows.
    ShortPeriodBesideDivergence,
    /// A real root of angle of attack and pitch rate that dies away.
    PitchSubsides,
    /// A real root of angle of attack and pitch rate that grows.
    PitchDiverges,
    /// Exchange of speed and height with little change of α.
    EnergyExchange,
    /// Exchange of speed and height in which α takes part: |α| over |θ|.
    EnergyExchangeWithAlpha(f64),
    /// One of two real roots of the phugoid, the faster.
    PhugoidFaster,
    /// One of two real roots of the phugoid, the slower.
    PhugoidSlower,
    /// A real root of the phugoid whose partner grows.
    PhugoidBesideDivergence,
    /// A real root of speed and pitch angle that dies away.
    SpeedSubsides,
    /// A real root of speed and pitch angle that grows.
    SpeedDiverges,
    /// An oscillation that mixes the states of short period and phugoid.
    ThirdOscillation,
    /// Yaw and sideslip with rolling.
    YawingAndRocking,
    /// One of two real roots of the Dutch roll, the further left.
    DutchRollMoreStable,
    /// One of two real roots of the Dutch roll, the further right.
    DutchRollLessStable,
    /// A real root of sideslip and yaw rate that dies away.
    SideslipSubsides,
    /// A real root of sideslip and yaw rate that grows.
    DirectionDiverges,
    /// Roll subsidence and spiral as one oscillation.
    RollMeetsSpiral,
    /// An oscillation that mixes the states of Dutch roll, roll and spiral.
    LateralOscillation,
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
    /// A real root of several lateral states that dies away.
    LateralSubsides,
    /// A real root of several lateral states that grows.
    LateralDiverges,
    /// States beside the four take part in a mode of the aircraft: their share, 0 to 1.
    FeedbackTakesPart(f64),
    /// A root of the aircraft and one of the feedback have met in one oscillation.
    MeetsFeedback,
    /// States of the feedback oscillate among themselves.
    FeedbackOscillates,
    /// A root of the four states and one of a further state have met in one oscillation.
    MeetsFurther,
    /// Further states oscillate among themselves.
    FurtherOscillates,
    /// What was left stays: nothing brings it back.
    StaysWhereItIs,
    /// It is brought back.
    IsBroughtBack,
    /// It comes back without a law.
    ComesBack,
    /// It grows.
    Departs,
    /// The shape is mixed: the name is that of the root it comes from as the gains of a law rise from zero.
    Followed,
    /// The shape is mixed: the name is that of the root it comes from as what couples the further states rises from zero.
    FollowedFromApart,
    /// A participation too evenly spread for a certain name.
    MixedShape,
}
