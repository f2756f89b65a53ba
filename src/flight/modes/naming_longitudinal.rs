//! Names of the longitudinal modes: short period, phugoid, and what becomes of them.

use super::mode_name::{
    ModeName, Naming, Shape, faster_of_two_pairs, mean_share, naming, percent, real_roots_in_order,
};

/// Share of w and q, the states of the short period; u and θ have the rest.
fn short_period_share(shape: &Shape) -> f64 {
    shape.participation[1] + shape.participation[2]
}

pub(super) fn name_modes(shapes: &[Shape]) -> Vec<Naming> {
    let short_period = short_period_members(shapes);
    let order = real_roots_in_order(shapes);
    // The further left of the real roots of one family is the faster, as long as both die away.
    let leftmost =
        |of_short_period: bool| order.iter().copied().find(|&i| short_period[i] == of_short_period);
    let diverges = |shape: &Shape| !shape.oscillates() && shape.grows();
    let diverging = shapes.iter().any(diverges);

    let names: Vec<ModeName> = (0..shapes.len())
        .map(|i| {
            let shape = &shapes[i];
            match (short_period[i], shape.oscillates()) {
                _ if diverges(shape) => ModeName::Divergence,
                (true, true) => ModeName::ShortPeriod,
                (true, false) if leftmost(true) == Some(i) => ModeName::ShortPeriodFastRoot,
                (true, false) => ModeName::ShortPeriodSlowRoot,
                (false, true) if diverging => ModeName::ThirdOscillatory,
                (false, true) => ModeName::Phugoid,
                (false, false) if leftmost(false) == Some(i) => ModeName::PhugoidFastRoot,
                (false, false) => ModeName::PhugoidSlowRoot,
            }
        })
        .collect();
    names.iter().zip(shapes).map(|(&name, shape)| explain(name, shape, &names)).collect()
}

/// Which modes make up the short period.
///
/// Two oscillations: the faster. Four real roots: the two further left. One oscillation and two real roots: whichever is
/// richer in w and q, the pair weighed against the two roots together.
fn short_period_members(shapes: &[Shape]) -> Vec<bool> {
    if let Some(faster) = faster_of_two_pairs(shapes) {
        return (0..shapes.len()).map(|i| i == faster).collect();
    }
    if shapes.len() == 3 {
        let pair_is_short_period =
            mean_share(shapes, true, short_period_share) >= mean_share(shapes, false, short_period_share);
        return shapes.iter().map(|s| s.oscillates() == pair_is_short_period).collect();
    }
    let order = real_roots_in_order(shapes);
    let members = &order[..order.len() / 2];
    (0..shapes.len()).map(|i| members.contains(&i)).collect()
}

/// α is called nearly constant only where it carries less than this.
const STILL: f64 = 0.05;

fn explain(name: ModeName, shape: &Shape, names: &[ModeName]) -> Naming {
    let short_period_share = short_period_share(shape);
    let fast = percent(short_period_share);
    let slow = percent(1.0 - short_period_share);
    let (confidence, reason) = match name {
        ModeName::ShortPeriod => {
            (short_period_share, format!("α and q carry {fast} of it while speed hardly changes."))
        }
        ModeName::ShortPeriodFastRoot if !names.contains(&ModeName::ShortPeriodSlowRoot) => {
            let other = if names.contains(&ModeName::ThirdOscillatory) {
                "has met a root of the phugoid: together they are the third oscillatory mode"
            } else {
                "grows: it is the divergence"
            };
            (
                short_period_share,
                format!(
                    "α and q carry {fast} of it. The short period no longer oscillates: of its two real roots this is the faster, the other {other}."
                ),
            )
        }
        ModeName::ShortPeriodFastRoot => (
            short_period_share,
            format!(
                "α and q carry {fast} of it. The short period is overdamped: two real roots, this is the faster."
            ),
        ),
        ModeName::ShortPeriodSlowRoot => (
            short_period_share,
            format!(
                "α and q carry {fast} of it. The short period is overdamped: two real roots, this is the slower."
            ),
        ),
        ModeName::PhugoidFastRoot => (
            1.0 - short_period_share,
            format!(
                "Speed and pitch attitude carry {slow} of it. The phugoid no longer oscillates: two real roots, this is the faster."
            ),
        ),
        ModeName::PhugoidSlowRoot => (
            1.0 - short_period_share,
            format!(
                "Speed and pitch attitude carry {slow} of it. The phugoid no longer oscillates: two real roots, this is the slower."
            ),
        ),
        ModeName::ThirdOscillatory => (
            1.0 - short_period_share,
            format!(
                "An oscillation beside a real root that grows: neither phugoid nor short period (α and q {fast}, speed and attitude {slow})."
            ),
        ),
        ModeName::Divergence if short_period_share >= 0.5 => (
            short_period_share,
            format!("A real root that grows, with α and q carrying {fast} of it: the nose keeps going."),
        ),
        ModeName::Divergence => {
            let left = if shape.participation[3] > shape.participation[0] { "attitude" } else { "speed" };
            (
                1.0 - short_period_share,
                format!(
                    "A real root that grows, with speed and pitch attitude carrying {slow} of it: the aircraft keeps leaving its {left}."
                ),
            )
        }
        _ if shape.participation[1] < STILL => (
            1.0 - short_period_share,
            format!("Speed and pitch attitude carry {slow} of it: they trade energy at nearly constant α."),
        ),
        _ => (
            1.0 - short_period_share,
            format!(
                "Speed and pitch attitude carry {slow} of it: they trade energy, and α, with {}, swings along.",
                percent(shape.participation[1])
            ),
        ),
    };
    naming(name, confidence, reason)
}
