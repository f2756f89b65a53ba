//! Names of the lateral–directional modes: Dutch roll, roll subsidence, spiral, and what becomes of them.

use super::mode_name::{
    ModeName, Naming, Shape, faster_of_two_pairs, mean_share, naming, real_roots_in_order,
};
use super::reason::{Fact, StateSet};
use super::stability::Stability;

/// Beside two real roots a pair is the Dutch roll, unless it holds less than this share of v and r …
///
/// On every reference aircraft, with any one derivative from −1 to 3 times its value, a pair beside two real roots
/// keeps at least 0.39; the Dutch roll that lost its stiffness is still the mode that was the Dutch roll.
const ROLLING_PAIR: f64 = 0.3;

/// … and the two real roots hold more than this share of them between them: then they are the Dutch roll, split.
const YAWING_ROOTS: f64 = 0.6;

/// Share of v and r, the states of the Dutch roll; p and φ, those of rolling, have the rest.
fn yaw_share(shape: &Shape) -> f64 {
    StateSet::SideslipAndYawRate.share(&shape.participation)
}

pub(super) fn name_modes(shapes: &[Shape]) -> Vec<Naming> {
    let names = match shapes.len() {
        2 => two_pairs(shapes),
        3 => one_pair(shapes),
        _ => four_roots(shapes),
    };
    shapes.iter().zip(names).map(|(shape, name)| explain(name, shape, shapes)).collect()
}

/// Two oscillations: the faster is the Dutch roll, the slower roll and spiral coupled.
fn two_pairs(shapes: &[Shape]) -> Vec<ModeName> {
    let faster = faster_of_two_pairs(shapes).unwrap_or(0);
    (0..shapes.len())
        .map(|i| if i == faster { ModeName::DutchRoll } else { ModeName::CoupledRollSpiral })
        .collect()
}

/// One oscillation and two real roots.
fn one_pair(shapes: &[Shape]) -> Vec<ModeName> {
    let order = real_roots_in_order(shapes);
    let split = mean_share(shapes, true, yaw_share) < ROLLING_PAIR
        && mean_share(shapes, false, yaw_share) > YAWING_ROOTS;
    let leftmost = order.first().copied();
    let roll = if roll_is_on_the_right(shapes, &order) { order.last().copied() } else { leftmost };
    (0..shapes.len())
        .map(|i| match (shapes[i].oscillates(), leftmost == Some(i)) {
            (true, _) if split => ModeName::CoupledRollSpiral,
            (true, _) => ModeName::DutchRoll,
            (false, true) if split => ModeName::DutchRollMoreStableRoot,
            (false, false) if split => ModeName::DutchRollLessStableRoot,
            (false, _) if roll == Some(i) => ModeName::RollSubsidence,
            (false, _) => ModeName::Spiral,
        })
        .collect()
}

/// Roll is the greater |λ| of two real roots, so the left one, unless both grow because the wing drives the roll.
///
/// A root that grows fast beside one that dies away slowly keeps its name: the spiral may become a driven roll without
/// meeting another root, and its reason says so.
fn roll_is_on_the_right(shapes: &[Shape], order: &[usize]) -> bool {
    order.iter().all(|&i| shapes[i].grows())
}

/// Four real roots, named by their order and by how many grow.
///
/// Without directional stiffness the Dutch roll parts into ±√−N'β, with the spiral near zero between the two:
/// from left to right roll, Dutch roll, spiral, Dutch roll. With two that grow the spiral may have crossed zero, or the
/// Dutch roll have parted where it grows already, with the spiral left of both its roots: of the two in the middle the
/// spiral is the one with less sideslip and yaw rate. With none that grows it is the one nearest zero.
fn four_roots(shapes: &[Shape]) -> Vec<ModeName> {
    use ModeName::{
        DutchRollLessStableRoot as Less, DutchRollMoreStableRoot as More, RollSubsidence, Spiral,
    };
    let order = real_roots_in_order(shapes);
    let share = |k: usize| order.get(k).map_or(0.0, |&i| yaw_share(&shapes[i]));
    let growing = shapes.iter().filter(|s| s.grows()).count();
    let in_order = match growing {
        0 => [RollSubsidence, More, Less, Spiral],
        1 => [RollSubsidence, More, Spiral, Less],
        _ if share(1) < share(2) => [RollSubsidence, Spiral, More, Less],
        _ => [RollSubsidence, More, Spiral, Less],
    };
    let mut names = vec![Spiral; shapes.len()];
    for (&i, name) in order.iter().zip(in_order) {
        names[i] = name;
    }
    names
}

fn explain(name: ModeName, shape: &Shape, shapes: &[Shape]) -> Naming {
    let yawing = StateSet::SideslipAndYawRate;
    let (states, fact) = match name {
        ModeName::DutchRoll => (yawing, Fact::YawingAndRocking),
        ModeName::CoupledRollSpiral => (StateSet::RollRateAndBankAngle, Fact::RollMeetsSpiral),
        ModeName::DutchRollMoreStableRoot => (yawing, Fact::DutchRollMoreStable),
        ModeName::DutchRollLessStableRoot if shape.grows() => (yawing, Fact::DirectionalDivergence),
        ModeName::DutchRollLessStableRoot => (yawing, Fact::DutchRollLessStable),
        ModeName::RollSubsidence if shape.grows() => (StateSet::RollRate, Fact::RollDriven),
        ModeName::RollSubsidence => (StateSet::RollRate, Fact::RollRateDiesOut),
        _ if shape.grows() && is_faster_than_the_roll(shape, shapes) => {
            (StateSet::BankAngle, Fact::BankDriven)
        }
        _ => (
            StateSet::BankAngle,
            match shape.stability {
                Stability::Stable => Fact::BankDecays,
                Stability::Neutral => Fact::BankStays,
                Stability::Unstable => Fact::BankGrows,
            },
        ),
    };
    let four = (shapes.len() == 4).then_some(Fact::FourRealRoots);
    let two = ratio_of_two_pairs(shapes).map(Fact::TwoOscillations);
    naming(name, shape, states, [Some(fact), four, two].into_iter().flatten().collect())
}

/// Whether this root is farther from zero than every real root that dies away, of which there is one.
fn is_faster_than_the_roll(shape: &Shape, shapes: &[Shape]) -> bool {
    shapes.iter().any(|s| !s.oscillates() && !s.grows())
        && shapes.iter().all(|s| s.oscillates() || s.grows() || s.lambda.norm() < shape.lambda.norm())
}

/// With two oscillations, the greater |λ| over the smaller.
fn ratio_of_two_pairs(shapes: &[Shape]) -> Option<f64> {
    let faster = faster_of_two_pairs(shapes)?;
    let (fast, slow) = (shapes[faster].lambda.norm(), shapes[1 - faster].lambda.norm());
    (slow > 0.0).then(|| fast / slow)
}
