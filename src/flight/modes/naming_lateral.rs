//! Names of the lateral–directional modes: Dutch roll, roll subsidence, spiral, and what becomes of them.

use smallvec::SmallVec;

use super::assignment::best_assignment;
use super::mode_name::{ModeName, Naming, UnnamedMode, naming};
use super::reason::{Fact, StateSet};
use super::stability::Stability;

/// A family of lateral–directional modes, or two families whose roots have met in one oscillation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    DutchRoll,
    Roll,
    Spiral,
    RollAndSpiral,
    /// A root of the Dutch roll with the spiral.
    YawAndSpiral,
    /// A root of the Dutch roll with the roll.
    YawAndRoll,
}

/// The families that two pairs, one pair and two real roots, or four real roots can be of, pairs first.
const TWO_PAIRS: [&[Family]; 2] = {
    use Family::{DutchRoll, RollAndSpiral};
    [&[DutchRoll, RollAndSpiral], &[RollAndSpiral, DutchRoll]]
};
const ONE_PAIR: [&[Family]; 7] = {
    use Family::{DutchRoll as D, Roll as R, RollAndSpiral, Spiral as S, YawAndRoll, YawAndSpiral};
    [
        &[D, R, S],
        &[D, S, R],
        &[RollAndSpiral, D, D],
        &[YawAndSpiral, R, D],
        &[YawAndSpiral, D, R],
        &[YawAndRoll, S, D],
        &[YawAndRoll, D, S],
    ]
};
const FOUR_ROOTS: [&[Family]; 12] = {
    use Family::{DutchRoll as D, Roll as R, Spiral as S};
    [
        &[R, S, D, D],
        &[R, D, S, D],
        &[R, D, D, S],
        &[S, R, D, D],
        &[D, R, S, D],
        &[D, R, D, S],
        &[S, D, R, D],
        &[D, S, R, D],
        &[D, D, R, S],
        &[S, D, D, R],
        &[D, S, D, R],
        &[D, D, S, R],
    ]
};

/// Shares of the states of the three families: v and r together, p, φ.
fn shares(mode: &UnnamedMode) -> [f64; 3] {
    [StateSet::SideslipAndYawRate, StateSet::RollRate, StateSet::BankAngle]
        .map(|states| states.share(&mode.participation))
}

/// How much of the roots of a mode the states of a family carry; where two families have met, one root is of each.
fn fit(mode: &UnnamedMode, family: Family) -> f64 {
    let roots = if mode.oscillates() { 2.0 } else { 1.0 };
    let [yaw, roll, bank] = shares(mode);
    match family {
        Family::DutchRoll => roots * yaw,
        Family::Roll => roots * roll,
        Family::Spiral => roots * bank,
        // Its states are shared evenly by the two roots.
        Family::RollAndSpiral => roots * (roll + bank),
        Family::YawAndSpiral => yaw + bank,
        Family::YawAndRoll => yaw + roll,
    }
}

pub(super) fn name_modes(modes: &[UnnamedMode]) -> SmallVec<[Naming; 4]> {
    let table: &[&[Family]] = match modes.len() {
        2 => &TWO_PAIRS,
        3 => &ONE_PAIR,
        _ => &FOUR_ROOTS,
    };
    let families = best_assignment(modes, table, fit);
    modes
        .iter()
        .zip(&families)
        .map(|(mode, &family)| explain(name(mode, family, modes, &families), mode, modes))
        .collect()
}

fn name(mode: &UnnamedMode, family: Family, modes: &[UnnamedMode], families: &[Family]) -> ModeName {
    let [yaw, roll, bank] = shares(mode);
    if mode.oscillates() {
        return match family {
            Family::DutchRoll if yaw >= roll + bank => ModeName::DutchRoll,
            Family::RollAndSpiral if roll + bank >= yaw => ModeName::CoupledRollSpiral,
            _ => ModeName::LateralOscillation,
        };
    }
    match family {
        Family::DutchRoll if yaw >= roll && yaw >= bank => yawing_root(mode, modes, families),
        Family::Roll if roll >= yaw && roll >= bank => {
            if mode.grows() {
                ModeName::RollDivergence
            } else {
                ModeName::RollSubsidence
            }
        }
        Family::Spiral if bank >= yaw && bank >= roll => ModeName::Spiral,
        _ => match (yaw >= roll && yaw >= bank, mode.grows()) {
            (true, true) => ModeName::DirectionalDivergence,
            (true, false) => ModeName::SideslipSubsidence,
            (false, true) => ModeName::LateralDivergence,
            (false, false) => ModeName::LateralSubsidence,
        },
    }
}

/// A real root of sideslip and yaw rate: one of the two that the Dutch roll has become, where both die away or both grow, or
/// else a subsidence or divergence of its own.
fn yawing_root(mode: &UnnamedMode, modes: &[UnnamedMode], families: &[Family]) -> ModeName {
    let mut others = modes.iter().zip(families).filter(|(other, family)| {
        **family == Family::DutchRoll && !other.oscillates() && other.lambda != mode.lambda
    });
    match others.next() {
        Some((other, _)) if other.grows() == mode.grows() => {
            if mode.lambda.re < other.lambda.re {
                ModeName::DutchRollMoreStableRoot
            } else {
                ModeName::DutchRollLessStableRoot
            }
        }
        _ if mode.grows() => ModeName::DirectionalDivergence,
        _ => ModeName::SideslipSubsidence,
    }
}

pub(super) fn explain(name: ModeName, mode: &UnnamedMode, modes: &[UnnamedMode]) -> Naming {
    let yawing = StateSet::SideslipAndYawRate;
    let (states, fact) = match name {
        ModeName::DutchRoll => (yawing, Fact::YawingAndRocking),
        ModeName::CoupledRollSpiral => (StateSet::RollRateAndBankAngle, Fact::RollMeetsSpiral),
        ModeName::LateralOscillation => (StateSet::LateralMix, Fact::LateralOscillation),
        ModeName::DutchRollMoreStableRoot => (yawing, Fact::DutchRollMoreStable),
        ModeName::DutchRollLessStableRoot => (yawing, Fact::DutchRollLessStable),
        ModeName::DirectionalDivergence => (yawing, Fact::DirectionDiverges),
        ModeName::SideslipSubsidence => (yawing, Fact::SideslipSubsides),
        ModeName::RollSubsidence => (StateSet::RollRate, Fact::RollRateDiesOut),
        ModeName::RollDivergence => (StateSet::RollRate, Fact::RollDriven),
        ModeName::LateralSubsidence => (StateSet::LateralMix, Fact::LateralSubsides),
        ModeName::LateralDivergence => (StateSet::LateralMix, Fact::LateralDiverges),
        _ => (
            StateSet::BankAngle,
            match mode.stability {
                Stability::Stable => Fact::BankDecays,
                Stability::Neutral => Fact::BankStays,
                Stability::Unstable if is_faster_than_the_roll(mode, modes) => Fact::BankDriven,
                Stability::Unstable => Fact::BankGrows,
            },
        ),
    };
    naming(name, mode, states, vec![fact])
}

/// Whether this root is farther from zero than every real root that dies away, of which there is one.
fn is_faster_than_the_roll(mode: &UnnamedMode, modes: &[UnnamedMode]) -> bool {
    modes.iter().any(|m| !m.oscillates() && !m.grows())
        && modes.iter().all(|m| m.oscillates() || m.grows() || m.lambda.norm() < mode.lambda.norm())
}
