//! The reason for a mode's name.

use crate::flight::modes::mode::Mode;
use crate::flight::modes::reason::{Fact, StateSet};
use crate::number::significant;

/// Why a mode has its name: the participation that gave it, then each fact in a sentence.
pub fn reason(mode: &Mode) -> String {
    let facts = mode.naming.reason.facts.iter().map(|&fact| told(fact, mode));
    std::iter::once(participation(mode)).chain(facts).collect::<Vec<_>>().join(" ")
}

/// The share of the states that gave the name; where one state gave it and another has more, that of both.
fn participation(mode: &Mode) -> String {
    const LATERAL: [&str; 4] = ["sideslip", "roll rate", "yaw rate", "bank angle"];
    let states = mode.naming.reason.states;
    let share = percent(states.share(&mode.participation));
    let most = (0..4).max_by(|&i, &j| mode.participation[i].total_cmp(&mode.participation[j])).unwrap_or(0);
    let (other, more) = (LATERAL[most], percent(mode.participation[most]));
    let is_outweighed = !states.states().contains(&most);
    match states {
        StateSet::AngleOfAttackAndPitchRate => format!("α and q have {share} of the participation."),
        StateSet::SpeedAndPitchAngle => {
            format!("Speed and pitch attitude have {share} of the participation.")
        }
        StateSet::SideslipAndYawRate => format!("Sideslip and yaw rate have {share} of the participation."),
        StateSet::RollRateAndBankAngle => {
            format!("Roll rate and bank angle have {share} of the participation.")
        }
        StateSet::RollRate if is_outweighed => {
            format!("Roll rate has {share} of the participation, {other} {more}.")
        }
        StateSet::RollRate => format!("Roll rate has {share} of the participation."),
        StateSet::BankAngle if is_outweighed => {
            format!("Bank angle has {share} of the participation, {other} {more}.")
        }
        StateSet::BankAngle => format!("Bank angle has {share} of the participation."),
    }
}

/// A spiral that takes longer than this to double or halve is slow \[s\]: Level 1 in Category B, MIL-F-8785C §3.3.1.3.
const SLOW: f64 = 20.0;

fn told(fact: Fact, mode: &Mode) -> String {
    let sentence = match fact {
        Fact::SteadySpeed => "Speed hardly changes.",
        Fact::ShortPeriodFaster => {
            "The short period is overdamped: of its two real roots this is the faster."
        }
        Fact::ShortPeriodSlower => {
            "The short period is overdamped: of its two real roots this is the slower."
        }
        Fact::ShortPeriodBesideThirdOscillation => {
            "The short period no longer oscillates: of its two real roots this is the faster. The other has met a root of the \
             phugoid, and together they are the third oscillatory mode."
        }
        Fact::ShortPeriodBesideDivergence => {
            "The short period no longer oscillates: of its two real roots this is the faster. The other grows: it is the divergence."
        }
        Fact::EnergyExchange => "Speed and height exchange energy at nearly constant α.",
        Fact::EnergyExchangeWithAlpha => {
            let share = percent(mode.participation[1]);
            return format!("Speed and height exchange energy, and α takes part with {share}.");
        }
        Fact::PhugoidFaster => "The phugoid no longer oscillates: of its two real roots this is the faster.",
        Fact::PhugoidSlower => "The phugoid no longer oscillates: of its two real roots this is the slower.",
        Fact::OscillationBesideDivergence => {
            "It oscillates beside a real root that grows, so it is neither phugoid nor short period."
        }
        Fact::PitchDivergence => "A pitch divergence: the angle of attack grows without oscillating.",
        Fact::SpeedDivergence => {
            "A speed divergence: speed and pitch attitude depart from trim without oscillating."
        }
        Fact::YawingAndRocking => "The nose swings from side to side and the wings rock.",
        Fact::DutchRollMoreStable => {
            "The Dutch roll no longer oscillates: of its two real roots this is the more stable."
        }
        Fact::DutchRollLessStable => {
            "The Dutch roll no longer oscillates: of its two real roots this is the less stable."
        }
        Fact::DirectionalDivergence => {
            "The Dutch roll no longer oscillates: of its two real roots this one grows. It is a directional divergence: the nose \
             turns ever further out of the wind."
        }
        Fact::RollMeetsSpiral => "Roll subsidence and spiral have met and oscillate together.",
        Fact::RollRateDiesOut => "The roll rate dies out without oscillating.",
        Fact::RollDriven => "It grows, so it is no subsidence: the wing drives the roll.",
        Fact::BankDriven => {
            "It grows faster than a roll rate dies out, so it is no slow spiral: the wing drives the roll."
        }
        Fact::BankGrows => match mode.time_to_double() {
            Some(time) if time < SLOW => {
                let time = significant(time, 2);
                return format!("The turn tightens: the bank angle doubles every {time} s.");
            }
            _ => "The turn tightens slowly.",
        },
        Fact::BankStays => "The bank angle stays as it is.",
        Fact::BankDecays => match mode.time_to_half() {
            Some(time) if time < SLOW => {
                let time = significant(time, 2);
                return format!("The wings come level: the bank angle halves every {time} s.");
            }
            _ => "The wings come level slowly.",
        },
        Fact::FourRealRoots => "All four roots are real and told apart by their order.",
        Fact::TwoOscillations(ratio) => {
            let ratio = significant(ratio, 3);
            return format!(
                "There are two oscillations: the faster has {ratio} times the |λ| of the slower."
            );
        }
        Fact::MixedShape => "The shape is mixed, so the name is a matter of degree.",
    };
    sentence.to_owned()
}

/// A share as a person reads it: "99.7 %", "95 %".
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if (99.0..99.95).contains(&value) { format!("{value:.1} %") } else { format!("{value:.0} %") }
}
