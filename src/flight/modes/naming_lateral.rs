//! Names of the lateral–directional modes: Dutch roll, roll subsidence, spiral, and what becomes of them.

use super::mode_name::{
    ModeName, Naming, Shape, faster_of_two_pairs, mean_share, naming, percent, real_roots_in_order,
};
use crate::number::significant;

/// Beside two real roots a pair is the Dutch roll, unless it holds less than this share of v and r …
///
/// On every reference aircraft, with any one derivative from −1 to 3 times its value, a pair beside two real roots
/// keeps at least 0.39; the Dutch roll that lost its stiffness is still the mode that was the Dutch roll.
const ROLLING_PAIR: f64 = 0.3;

/// … and the two real roots hold more than this share of them between them: then they are the Dutch roll, split.
const YAWING_ROOTS: f64 = 0.6;

/// Share of v and r, the states of the Dutch roll; p and φ, those of rolling, have the rest.
fn yaw_share(shape: &Shape) -> f64 {
    shape.participation[0] + shape.participation[2]
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
    let [_, p, _, phi] = shape.participation;
    let yaw = yaw_share(shape);
    let (yawing, rolling) = (percent(yaw), percent(1.0 - yaw));
    let four = if shapes.len() == 4 { " All four roots are real, told apart by their order." } else { "" };
    let (confidence, reason) = match name {
        ModeName::DutchRoll => (
            yaw,
            format!(
                "Sideslip and yaw rate carry {yawing} of it: the nose swings from side to side and the wings rock."
            ),
        ),
        ModeName::CoupledRollSpiral => (
            1.0 - yaw,
            format!(
                "Roll rate and bank angle carry {rolling} of it: roll subsidence and spiral have met and oscillate together."
            ),
        ),
        ModeName::DutchRollMoreStableRoot => (
            yaw,
            format!(
                "Sideslip and yaw rate carry {yawing} of it. The Dutch roll no longer oscillates: two real roots, this is the more stable.{four}"
            ),
        ),
        ModeName::DutchRollLessStableRoot if shape.grows() => (
            yaw,
            format!(
                "Sideslip and yaw rate carry {yawing} of it. The Dutch roll no longer oscillates: two real roots, and this one grows, the nose keeps swinging away.{four}"
            ),
        ),
        ModeName::DutchRollLessStableRoot => (
            yaw,
            format!(
                "Sideslip and yaw rate carry {yawing} of it. The Dutch roll no longer oscillates: two real roots, this is the less stable.{four}"
            ),
        ),
        ModeName::RollSubsidence if shape.grows() => (
            p,
            format!(
                "{}, and it grows: no longer a subsidence, the wing drives the roll on.{four}",
                carried(shape, 1)
            ),
        ),
        ModeName::RollSubsidence => {
            (p, format!("{}: a roll that dies out without oscillating.{four}", carried(shape, 1)))
        }
        _ if shape.grows() && is_faster_than_the_roll(shape, shapes) => (
            phi,
            format!(
                "{}, and it grows faster than a roll dies out: no longer a slow spiral, the wing drives it.{four}",
                carried(shape, 3)
            ),
        ),
        _ if shape.grows() => (
            phi,
            format!(
                "{}, and it grows: the turn tightens{}.{four}",
                carried(shape, 3),
                pace(shape, "doubling")
            ),
        ),
        _ => (phi, format!("{}: the wings come level{}.{four}", carried(shape, 3), pace(shape, "by half"))),
    };
    let reason = match neighbour(shape, shapes) {
        Some(ratio) => {
            format!("{reason} There are two oscillations; the faster is {ratio} times the slower in |λ|.")
        }
        None => reason,
    };
    naming(name, confidence, reason)
}

/// How much of a mode one of the states β, p, r, φ carries, and which carries more, if any does.
fn carried(shape: &Shape, state: usize) -> String {
    const STATES: [&str; 4] = ["Sideslip", "Roll rate", "Yaw rate", "Bank angle"];
    let share = |k: usize| shape.participation[k];
    let most = (0..4).max_by(|&i, &j| share(i).total_cmp(&share(j))).unwrap_or(state);
    let own = format!("{} carries {} of it", STATES[state], percent(share(state)));
    if share(most) <= share(state) {
        return own;
    }
    format!("{own}, {} even {}", STATES[most].to_lowercase(), percent(share(most)))
}

/// A spiral that takes longer than this to double or halve is slow \[s\]: Level 1 in Category B, MIL-F-8785C §3.3.1.3.
const SLOW: f64 = 20.0;

/// How fast a real root grows or dies away, as the end of a sentence.
fn pace(shape: &Shape, what: &str) -> String {
    let time = std::f64::consts::LN_2 / shape.lambda.re.abs();
    if time < SLOW { format!(", {what} every {} s", significant(time, 2)) } else { " slowly".to_owned() }
}

/// Whether this root is farther from zero than every real root that dies away, of which there is one.
fn is_faster_than_the_roll(shape: &Shape, shapes: &[Shape]) -> bool {
    shapes.iter().any(|s| !s.oscillates() && !s.grows())
        && shapes.iter().all(|s| s.oscillates() || s.grows() || s.lambda.norm() < shape.lambda.norm())
}

/// With two oscillations, the ratio of their |λ| in words.
fn neighbour(shape: &Shape, shapes: &[Shape]) -> Option<String> {
    let faster = faster_of_two_pairs(shapes)?;
    let (fast, slow) = (shapes[faster].lambda.norm(), shapes[1 - faster].lambda.norm());
    (shape.oscillates() && slow > 0.0).then(|| significant(fast / slow, 3))
}
