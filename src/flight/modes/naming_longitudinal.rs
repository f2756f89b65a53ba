//! Names of the longitudinal modes: short period, phugoid, and what becomes of them.

use smallvec::SmallVec;

use super::assignment::best_assignment;
use super::mode_name::{ModeName, Naming, UnnamedMode, naming};
use super::reason::{Fact, StateSet};

/// A family of longitudinal modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    ShortPeriod,
    Phugoid,
    /// A root of each, met in one oscillation.
    Both,
}

/// The families that two pairs, one pair and two real roots, or four real roots can be of, pairs first.
const TWO_PAIRS: [&[Family]; 2] = {
    use Family::{Phugoid as P, ShortPeriod as S};
    [&[S, P], &[P, S]]
};
const ONE_PAIR: [&[Family]; 4] = {
    use Family::{Both, Phugoid as P, ShortPeriod as S};
    [&[S, P, P], &[P, S, S], &[Both, S, P], &[Both, P, S]]
};
const FOUR_ROOTS: [&[Family]; 6] = {
    use Family::{Phugoid as P, ShortPeriod as S};
    [&[S, S, P, P], &[S, P, S, P], &[S, P, P, S], &[P, S, S, P], &[P, S, P, S], &[P, P, S, S]]
};

/// Share of w and q, the states of the short period; u and θ have the rest.
fn fast_share(mode: &UnnamedMode) -> f64 {
    StateSet::AngleOfAttackAndPitchRate.share(&mode.participation)
}

/// How much of the roots of a mode the states of a family carry; in `Both`, one root is of each.
fn fit(mode: &UnnamedMode, family: Family) -> f64 {
    let roots = if mode.oscillates() { 2.0 } else { 1.0 };
    match family {
        Family::ShortPeriod => roots * fast_share(mode),
        Family::Phugoid => roots * (1.0 - fast_share(mode)),
        Family::Both => 1.0,
    }
}

pub(super) fn name_modes(modes: &[UnnamedMode]) -> SmallVec<[Naming; 4]> {
    let table: &[&[Family]] = match modes.len() {
        2 => &TWO_PAIRS,
        3 => &ONE_PAIR,
        _ => &FOUR_ROOTS,
    };
    let families = best_assignment(modes, table, fit);
    let names: SmallVec<[ModeName; 4]> =
        modes.iter().zip(&families).map(|(mode, &family)| name(mode, family, modes, &families)).collect();
    modes.iter().zip(&names).map(|(mode, &name)| explain(name, mode, modes, &names)).collect()
}

fn name(mode: &UnnamedMode, family: Family, modes: &[UnnamedMode], families: &[Family]) -> ModeName {
    let is_fast = fast_share(mode) >= 0.5;
    let fits = match family {
        Family::ShortPeriod => is_fast,
        Family::Phugoid => !is_fast,
        Family::Both => false,
    };
    if mode.oscillates() {
        return match family {
            Family::ShortPeriod if fits => ModeName::ShortPeriod,
            // A phugoid beside a real root of speed has lost a root of its own to it.
            Family::Phugoid if fits && !has_slow_root(modes, families) => ModeName::Phugoid,
            _ => ModeName::ThirdOscillatory,
        };
    }
    if mode.grows() {
        return if is_fast { ModeName::PitchDivergence } else { ModeName::SpeedDivergence };
    }
    // The further left of two real roots that don't grow dies away faster.
    let is_faster = modes.iter().zip(families).all(|(other, &of)| {
        of != family || other.oscillates() || other.grows() || mode.lambda.re <= other.lambda.re
    });
    match (family, fits) {
        (Family::ShortPeriod, true) if is_faster => ModeName::ShortPeriodFastRoot,
        (Family::ShortPeriod, true) => ModeName::ShortPeriodSlowRoot,
        (Family::Phugoid, true) if is_faster => ModeName::PhugoidFastRoot,
        (Family::Phugoid, true) => ModeName::PhugoidSlowRoot,
        _ if is_fast => ModeName::PitchSubsidence,
        _ => ModeName::SpeedSubsidence,
    }
}

/// Whether a real root that was given to the short period is more of speed and pitch angle.
fn has_slow_root(modes: &[UnnamedMode], families: &[Family]) -> bool {
    modes
        .iter()
        .zip(families)
        .any(|(mode, &family)| family == Family::ShortPeriod && !mode.oscillates() && fast_share(mode) < 0.5)
}

/// α counts as nearly constant where its amplitude is less than this fraction of that of θ, and speed as steady where that
/// of u/V is less than this fraction of that of α.
const STILL: f64 = 0.1;

pub(super) fn explain(
    name: ModeName,
    mode: &UnnamedMode,
    modes: &[UnnamedMode],
    names: &[ModeName],
) -> Naming {
    let fast = StateSet::AngleOfAttackAndPitchRate;
    let slow = StateSet::SpeedAndPitchAngle;
    let diverges = modes.iter().any(|other| !other.oscillates() && other.grows());
    let alone = |root: ModeName| !names.contains(&root);
    let (states, fact) = match name {
        ModeName::ShortPeriod => (
            fast,
            mode.amplitudes.and_then(|amplitudes| match amplitudes.speed_to_alpha() {
                ratio if ratio < STILL => Some(Fact::SteadySpeed),
                ratio => ratio.is_finite().then_some(Fact::SpeedWithAlpha(ratio)),
            }),
        ),
        ModeName::ShortPeriodFastRoot if alone(ModeName::ShortPeriodSlowRoot) => (
            fast,
            if names.contains(&ModeName::ThirdOscillatory) {
                Some(Fact::ShortPeriodBesideThirdOscillation)
            } else if diverges {
                Some(Fact::ShortPeriodBesideDivergence)
            } else {
                None
            },
        ),
        ModeName::ShortPeriodFastRoot => (fast, Some(Fact::ShortPeriodFaster)),
        ModeName::ShortPeriodSlowRoot => (fast, Some(Fact::ShortPeriodSlower)),
        ModeName::PitchSubsidence => (fast, Some(Fact::PitchSubsides)),
        ModeName::PitchDivergence => (fast, Some(Fact::PitchDiverges)),
        ModeName::PhugoidFastRoot if alone(ModeName::PhugoidSlowRoot) => {
            (slow, diverges.then_some(Fact::PhugoidBesideDivergence))
        }
        ModeName::PhugoidFastRoot => (slow, Some(Fact::PhugoidFaster)),
        ModeName::PhugoidSlowRoot => (slow, Some(Fact::PhugoidSlower)),
        ModeName::SpeedSubsidence => (slow, Some(Fact::SpeedSubsides)),
        ModeName::SpeedDivergence => (slow, Some(Fact::SpeedDiverges)),
        ModeName::ThirdOscillatory => (StateSet::LongitudinalMix, Some(Fact::ThirdOscillation)),
        _ => (
            slow,
            mode.amplitudes.and_then(|amplitudes| match amplitudes.alpha_to_theta() {
                ratio if ratio < STILL => Some(Fact::EnergyExchange),
                ratio => ratio.is_finite().then_some(Fact::EnergyExchangeWithAlpha(ratio)),
            }),
        ),
    };
    naming(name, mode, states, fact.into_iter().collect())
}
