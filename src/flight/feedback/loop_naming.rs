//! Names of modes of a model with states beside the four, from the roots that they come from.
//!
//! The reason tells the share of the aircraft's states in it, of all four that of those that give such a mode its name without a law;
//! where that isn't most of it, that the root was followed.

use smallvec::SmallVec;

use super::closed_model::ClosedModel;
use super::families::Family;
use crate::flight::modes::mode_name::{MIXED, ModeName, Naming, UnnamedMode};
use crate::flight::modes::naming::explained;
use crate::flight::modes::reason::{Fact, Reason, StateSet};
use crate::flight::modes::stability::Stability;

/// States beside the four are told of a mode of the aircraft from this share on.
const TOLD: f64 = 0.1;

/// A mode without a name.
#[derive(Clone, Debug)]
pub(super) struct Unnamed {
    /// As it shows in the four states.
    pub rigid: UnnamedMode,
    /// Participation of every state.
    pub participation: Vec<f64>,
    /// The families of its roots: of a pair that of the upper and of the lower, else that of its root twice.
    pub families: [Family; 2],
}

/// The names of all modes of a model, in the order of the modes.
pub(super) fn name_modes(closed: &ClosedModel, modes: &[Unnamed]) -> Vec<Naming> {
    let names: Vec<ModeName> = modes.iter().map(|mode| name(closed, mode, modes)).collect();
    let is_of_aircraft =
        |mode: &Unnamed| !mode.families.iter().any(|family| matches!(family, Family::Appended(_)));
    let rigid: SmallVec<[(UnnamedMode, ModeName); 4]> = modes
        .iter()
        .zip(&names)
        .filter(|(mode, _)| is_of_aircraft(mode))
        .map(|(mode, name)| (mode.rigid, *name))
        .collect();
    let mut explained = explained(closed.model.plane, &rigid).into_iter();
    let is_fed_back = closed.is_fed_back();
    let reason = |(mode, name): (&Unnamed, &ModeName)| {
        let of_aircraft = if is_of_aircraft(mode) { explained.next() } else { None };
        of_aircraft.map_or_else(
            || of_appended(*name, mode, is_fed_back),
            |naming| with_share(naming, mode, is_fed_back),
        )
    };
    modes.iter().zip(&names).map(reason).collect()
}

fn name(closed: &ClosedModel, mode: &Unnamed, modes: &[Unnamed]) -> ModeName {
    use Family::{Appended, DutchRoll, Lateral, Phugoid, Roll, ShortPeriod, Spiral};
    if mode.rigid.oscillates() {
        return match mode.families {
            [Appended(_), _] | [_, Appended(_)] if closed.is_fed_back() => ModeName::FeedbackOscillation,
            [Appended(_), _] | [_, Appended(_)] => ModeName::FurtherOscillation,
            [ShortPeriod, ShortPeriod] => ModeName::ShortPeriod,
            [Phugoid, Phugoid] => ModeName::Phugoid,
            [ShortPeriod | Phugoid, _] => ModeName::ThirdOscillatory,
            [DutchRoll, DutchRoll] => ModeName::DutchRoll,
            [Roll | Spiral, Roll | Spiral] => ModeName::CoupledRollSpiral,
            _ => ModeName::LateralOscillation,
        };
    }
    let family = mode.families[0];
    let grows = mode.rigid.grows();
    let mut others = modes.iter().filter(|other| {
        !std::ptr::eq(*other, mode)
            && !other.rigid.oscillates()
            && other.families[0] == family
            && other.rigid.grows() == grows
    });
    // The further left of two roots of one family that both die away or both grow.
    let other = others.next();
    let is_left = other.is_none_or(|other| mode.rigid.lambda.re < other.rigid.lambda.re);
    match (family, grows) {
        (ShortPeriod, true) => ModeName::PitchDivergence,
        (ShortPeriod, false) if is_left => ModeName::ShortPeriodFastRoot,
        (ShortPeriod, false) => ModeName::ShortPeriodSlowRoot,
        (Phugoid, true) => ModeName::SpeedDivergence,
        (Phugoid, false) if is_left => ModeName::PhugoidFastRoot,
        (Phugoid, false) => ModeName::PhugoidSlowRoot,
        (DutchRoll, true) if other.is_none() => ModeName::DirectionalDivergence,
        (DutchRoll, false) if other.is_none() => ModeName::SideslipSubsidence,
        (DutchRoll, _) if is_left => ModeName::DutchRollMoreStableRoot,
        (DutchRoll, _) => ModeName::DutchRollLessStableRoot,
        (Roll, true) => ModeName::RollDivergence,
        (Roll, false) => ModeName::RollSubsidence,
        (Spiral, _) => ModeName::Spiral,
        (Lateral, true) => ModeName::LateralDivergence,
        (Lateral, false) => ModeName::LateralSubsidence,
        (Appended(k), _) => closed.appended.get(k).map_or(ModeName::FurtherState, |state| state.mode()),
    }
}

/// The naming of a root of an appended state, or of an oscillation with one.
fn of_appended(name: ModeName, mode: &Unnamed, is_fed_back: bool) -> Naming {
    let all: f64 = mode.participation.iter().skip(4).sum();
    let (share, fact) = match mode.families {
        [Family::Appended(_), Family::Appended(_)] if mode.rigid.oscillates() => {
            (all, Some(if is_fed_back { Fact::FeedbackOscillates } else { Fact::FurtherOscillates }))
        }
        _ if mode.rigid.oscillates() => {
            (all, Some(if is_fed_back { Fact::MeetsFeedback } else { Fact::MeetsFurther }))
        }
        [Family::Appended(k), _] => {
            let share = mode.participation.get(4 + k).copied().unwrap_or(0.0);
            (share, of_root(name, mode.rigid.stability, is_fed_back))
        }
        _ => (all, None),
    };
    let confidence = share.clamp(0.0, 1.0);
    let mut facts: Vec<Fact> = fact.into_iter().collect();
    if confidence < MIXED && !mode.rigid.oscillates() {
        facts.push(followed(is_fed_back));
    }
    Naming { name, confidence, reason: Reason { states: StateSet::Appended, facts } }
}

const fn followed(is_fed_back: bool) -> Fact {
    if is_fed_back { Fact::Followed } else { Fact::FollowedFromApart }
}

fn of_root(name: ModeName, stability: Stability, is_fed_back: bool) -> Option<Fact> {
    let returns = matches!(name, ModeName::Height | ModeName::Heading | ModeName::Position);
    match stability {
        Stability::Stable if returns && is_fed_back => Some(Fact::IsBroughtBack),
        Stability::Stable => returns.then_some(Fact::ComesBack),
        Stability::Neutral => Some(Fact::StaysWhereItIs),
        Stability::Unstable => Some(Fact::Departs),
    }
}

/// A naming of the aircraft's modes, with what the states beside the four have of it.
fn with_share(mut naming: Naming, mode: &Unnamed, is_fed_back: bool) -> Naming {
    for fact in &mut naming.reason.facts {
        if *fact == Fact::MixedShape {
            *fact = followed(is_fed_back);
        }
    }
    let others: f64 = mode.participation.iter().skip(4).sum();
    if others >= TOLD {
        naming.reason.facts.push(Fact::FeedbackTakesPart(others));
    }
    naming
}
