//! Names of the longitudinal modes: short period, phugoid, and what becomes of them.

use super::mode_name::{
    ModeName, Naming, Shape, faster_of_two_pairs, mean_share, naming, real_roots_in_order,
};
use super::reason::{Fact, StateSet};
use crate::flight::aircraft::states::Longitudinal::W;

/// Share of w and q, the states of the short period; u and θ have the rest.
fn short_period_share(shape: &Shape) -> f64 {
    StateSet::AngleOfAttackAndPitchRate.share(&shape.participation)
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
    let fast = StateSet::AngleOfAttackAndPitchRate;
    let slow = StateSet::SpeedAndPitchAngle;
    let (states, fact) = match name {
        ModeName::ShortPeriod => (fast, Fact::SteadySpeed),
        ModeName::ShortPeriodFastRoot if names.contains(&ModeName::ShortPeriodSlowRoot) => {
            (fast, Fact::ShortPeriodFaster)
        }
        ModeName::ShortPeriodFastRoot if names.contains(&ModeName::ThirdOscillatory) => {
            (fast, Fact::ShortPeriodBesideThirdOscillation)
        }
        ModeName::ShortPeriodFastRoot => (fast, Fact::ShortPeriodBesideDivergence),
        ModeName::ShortPeriodSlowRoot => (fast, Fact::ShortPeriodSlower),
        ModeName::PhugoidFastRoot => (slow, Fact::PhugoidFaster),
        ModeName::PhugoidSlowRoot => (slow, Fact::PhugoidSlower),
        ModeName::ThirdOscillatory => (slow, Fact::OscillationBesideDivergence),
        ModeName::Divergence if short_period_share(shape) >= 0.5 => (fast, Fact::PitchDivergence),
        ModeName::Divergence => (slow, Fact::SpeedDivergence),
        _ if shape.participation[W.index()] < STILL => (slow, Fact::EnergyExchange),
        _ => (slow, Fact::EnergyExchangeWithAlpha),
    };
    naming(name, shape, states, vec![fact])
}
