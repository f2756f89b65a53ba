//! The reason for a mode's name.

use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::reason::{Fact, StateSet};
use crate::number::significant;

/// Why a mode has its name: the participation that gave it, then each fact in a sentence.
pub fn reason(mode: &Mode) -> String {
    let facts = mode.naming.reason.facts.iter().map(|&fact| told(fact, mode));
    std::iter::once(participation(mode)).chain(facts).collect::<Vec<_>>().join(" ")
}

/// The share of the states that gave the name; where others have more, or several share a mode, that of all.
fn participation(mode: &Mode) -> String {
    let share = |states: StateSet| percent(states.share(&mode.participation));
    match mode.naming.reason.states {
        fast @ StateSet::AngleOfAttackAndPitchRate => {
            format!("α and q have {} of the participation.", share(fast))
        }
        slow @ StateSet::SpeedAndPitchAngle => {
            format!("Speed and pitch attitude have {} of the participation.", share(slow))
        }
        yaw @ StateSet::SideslipAndYawRate => {
            format!("Sideslip and yaw rate have {} of the participation.", share(yaw))
        }
        both @ StateSet::RollRateAndBankAngle => {
            format!("Roll rate and bank angle have {} of the participation.", share(both))
        }
        roll @ StateSet::RollRate => format!("Roll rate has {} of the participation.", share(roll)),
        bank @ StateSet::BankAngle => format!("Bank angle has {} of the participation.", share(bank)),
        StateSet::LongitudinalMix => format!(
            "α and q have {} of the participation, speed and pitch attitude {}.",
            share(StateSet::AngleOfAttackAndPitchRate),
            share(StateSet::SpeedAndPitchAngle)
        ),
        StateSet::LateralMix => format!(
            "Sideslip and yaw rate have {} of the participation, roll rate {}, bank angle {}.",
            share(StateSet::SideslipAndYawRate),
            share(StateSet::RollRate),
            share(StateSet::BankAngle)
        ),
        StateSet::Appended => appended(mode.naming.name, mode.naming.confidence),
    }
}

/// The share of the states beside the four that gave a mode its name.
fn appended(name: ModeName, share: f64) -> String {
    let subject = match name {
        ModeName::Height => "Height has",
        ModeName::Heading => "Heading has",
        ModeName::Position => "Position has",
        ModeName::Washout => "The washout has",
        ModeName::ElevatorActuator => "The elevator’s actuator has",
        ModeName::Engine => "The engine has",
        ModeName::AileronActuator => "The aileron’s actuator has",
        ModeName::RudderActuator => "The rudder’s actuator has",
        ModeName::FurtherState => "A further state has",
        ModeName::FurtherOscillation => "Further states have",
        _ => "States of the feedback have",
    };
    format!("{subject} {} of the participation.", percent(share))
}

/// A spiral that takes longer than this to double or halve is slow \[s\]: Level 1 in Category B, MIL-F-8785C §3.3.1.3.
const SLOW: f64 = 20.0;

fn told(fact: Fact, mode: &Mode) -> String {
    let sentence = match fact {
        Fact::SteadySpeed => "Speed hardly changes.",
        Fact::SpeedWithAlpha(ratio) => {
            return format!("Speed takes part: |u/V| is {} |α|.", times(ratio));
        }
        Fact::ShortPeriodFaster => {
            "The short period is overdamped: of its two real roots this is the faster."
        }
        Fact::ShortPeriodSlower => {
            "The short period is overdamped: of its two real roots this is the slower."
        }
        Fact::ShortPeriodBesideThirdOscillation => {
            "The short period no longer oscillates: this is its faster root. The other has met a root of the phugoid, and together \
             they are the third oscillatory mode."
        }
        Fact::ShortPeriodBesideDivergence => {
            "The short period no longer oscillates: of its two real roots this is the one that dies away, and the other grows."
        }
        Fact::PitchSubsides => "The angle of attack dies away without oscillating.",
        Fact::PitchDiverges => "The angle of attack grows without oscillating.",
        Fact::EnergyExchange => "Speed and height exchange energy at nearly constant α.",
        Fact::EnergyExchangeWithAlpha(ratio) => {
            return format!(
                "Speed and height exchange energy while α swings too: |α| is {} |θ|.",
                times(ratio)
            );
        }
        Fact::PhugoidFaster => "The phugoid no longer oscillates: of its two real roots this is the faster.",
        Fact::PhugoidSlower => "The phugoid no longer oscillates: of its two real roots this is the slower.",
        Fact::PhugoidBesideDivergence => {
            "The phugoid no longer oscillates: of its two real roots this is the one that dies away, and the other grows."
        }
        Fact::SpeedSubsides => "Speed and pitch attitude come back to trim without oscillating.",
        Fact::SpeedDiverges => "Speed and pitch attitude depart from trim without oscillating.",
        Fact::ThirdOscillation => {
            "A root of the short period and one of the phugoid oscillate together, so it is neither of the two."
        }
        Fact::YawingAndRocking => "The nose swings from side to side and the wings rock.",
        Fact::DutchRollMoreStable => {
            "The Dutch roll no longer oscillates: of its two real roots this is the more stable."
        }
        Fact::DutchRollLessStable => {
            "The Dutch roll no longer oscillates: of its two real roots this is the less stable."
        }
        Fact::SideslipSubsides => "Sideslip and yaw rate die away without oscillating.",
        Fact::DirectionDiverges => "It grows: the nose turns ever further out of the wind.",
        Fact::RollMeetsSpiral => "Roll subsidence and spiral have met and oscillate together.",
        Fact::LateralOscillation => {
            "A root of the Dutch roll has met the roll or the spiral: they oscillate together, so it is no Dutch roll."
        }
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
        Fact::LateralSubsides => "It dies away without oscillating.",
        Fact::LateralDiverges => "It grows without oscillating.",
        Fact::FeedbackTakesPart(share) => {
            return format!("States beside the four have {} of the whole.", percent(share));
        }
        Fact::MeetsFeedback => {
            "A root of the aircraft and one of the feedback have met and oscillate together."
        }
        Fact::FeedbackOscillates => "Roots of the feedback have met and oscillate together.",
        Fact::MeetsFurther => {
            "A root of the four states and one of a further state have met and oscillate together."
        }
        Fact::FurtherOscillates => "Roots of further states have met and oscillate together.",
        Fact::StaysWhereItIs => "Nothing brings it back: it stays where it is.",
        Fact::IsBroughtBack => "The feedback brings it back.",
        Fact::ComesBack => "It comes back by itself.",
        Fact::Departs => "It grows.",
        Fact::Followed => {
            "The shape is mixed: the name is that of the root it comes from as the gains rise from zero."
        }
        Fact::FollowedFromApart => {
            "The shape is mixed: the name is that of the root it comes from as the further states are coupled in."
        }
        Fact::MixedShape => "The shape is mixed, so the name is a matter of degree.",
    };
    sentence.to_owned()
}

/// A ratio of two amplitudes before the second: "0.30 ×".
fn times(ratio: f64) -> String {
    format!("{} ×", significant(ratio, 2))
}

/// A share as a person reads it: "99.7 %", "95 %".
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if (99.0..99.95).contains(&value) { format!("{value:.1} %") } else { format!("{value:.0} %") }
}
