//! Names of modes, and their telling numbers.

use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::modes::stability::Stability;
use crate::number::{fixed, significant};

/// The name as a title.
pub const fn title(name: ModeName) -> &'static str {
    match name {
        ModeName::ShortPeriod => "Short period",
        ModeName::ShortPeriodFastRoot => "Short period, fast root",
        ModeName::ShortPeriodSlowRoot => "Short period, slow root",
        ModeName::ThirdOscillatory => "Third oscillatory mode",
        ModeName::Phugoid => "Phugoid",
        ModeName::PhugoidFastRoot => "Phugoid, fast root",
        ModeName::PhugoidSlowRoot => "Phugoid, slow root",
        ModeName::PitchSubsidence => "Pitch subsidence",
        ModeName::PitchDivergence => "Pitch divergence",
        ModeName::SpeedSubsidence => "Speed subsidence",
        ModeName::SpeedDivergence => "Speed divergence",
        ModeName::SideslipSubsidence => "Sideslip subsidence",
        ModeName::DirectionalDivergence => "Directional divergence",
        ModeName::LateralOscillation => "Lateral oscillation",
        ModeName::RollDivergence => "Roll divergence",
        ModeName::LateralSubsidence => "Lateral subsidence",
        ModeName::LateralDivergence => "Lateral divergence",
        ModeName::DutchRoll => "Dutch roll",
        ModeName::DutchRollMoreStableRoot => "Dutch roll, more stable root",
        ModeName::DutchRollLessStableRoot => "Dutch roll, less stable root",
        ModeName::CoupledRollSpiral => "Coupled roll–spiral",
        ModeName::RollSubsidence => "Roll subsidence",
        ModeName::Spiral => "Spiral",
        ModeName::Height => "Height",
        ModeName::Heading => "Heading",
        ModeName::Position => "Position",
        ModeName::Washout => "Washout",
        ModeName::ElevatorActuator => "Elevator actuator",
        ModeName::Engine => "Engine",
        ModeName::AileronActuator => "Aileron actuator",
        ModeName::RudderActuator => "Rudder actuator",
        ModeName::FeedbackOscillation => "Feedback oscillation",
        ModeName::FurtherState => "Further state",
        ModeName::FurtherOscillation => "Further oscillation",
    }
}

/// The name after an article within a sentence; "roll mode", since roll subsidence may grow too.
pub const fn in_a_sentence(name: ModeName) -> &'static str {
    match name {
        ModeName::ShortPeriod => "short period",
        ModeName::ShortPeriodFastRoot => "fast root of the short period",
        ModeName::ShortPeriodSlowRoot => "slow root of the short period",
        ModeName::ThirdOscillatory => "third oscillatory mode",
        ModeName::Phugoid => "phugoid",
        ModeName::PhugoidFastRoot => "fast root of the phugoid",
        ModeName::PhugoidSlowRoot => "slow root of the phugoid",
        ModeName::PitchSubsidence => "pitch subsidence",
        ModeName::PitchDivergence => "pitch divergence",
        ModeName::SpeedSubsidence => "speed subsidence",
        ModeName::SpeedDivergence => "speed divergence",
        ModeName::SideslipSubsidence => "sideslip subsidence",
        ModeName::DirectionalDivergence => "directional divergence",
        ModeName::LateralOscillation => "lateral oscillation",
        ModeName::RollDivergence => "roll divergence",
        ModeName::LateralSubsidence => "lateral subsidence",
        ModeName::LateralDivergence => "lateral divergence",
        ModeName::DutchRoll => "Dutch roll",
        ModeName::DutchRollMoreStableRoot => "more stable root of the Dutch roll",
        ModeName::DutchRollLessStableRoot => "less stable root of the Dutch roll",
        ModeName::CoupledRollSpiral => "coupled roll–spiral oscillation",
        ModeName::RollSubsidence => "roll mode",
        ModeName::Spiral => "spiral",
        ModeName::Height => "height mode",
        ModeName::Heading => "heading mode",
        ModeName::Position => "position mode",
        ModeName::Washout => "washout mode",
        ModeName::ElevatorActuator => "mode of the elevator’s actuator",
        ModeName::Engine => "mode of the engine",
        ModeName::AileronActuator => "mode of the aileron’s actuator",
        ModeName::RudderActuator => "mode of the rudder’s actuator",
        ModeName::FeedbackOscillation => "oscillation of the feedback",
        ModeName::FurtherState => "mode of a further state",
        ModeName::FurtherOscillation => "oscillation of further states",
    }
}

/// A mode whose name is hidden, by its place among the others.
pub const fn numbered(place: Option<usize>) -> &'static str {
    match place {
        Some(0) => "Mode 1",
        Some(1) => "Mode 2",
        Some(2) => "Mode 3",
        Some(3) => "Mode 4",
        Some(_) | None => "Another mode",
    }
}

/// The same after an article within a sentence.
pub const fn numbered_in_a_sentence(place: Option<usize>) -> &'static str {
    match place {
        Some(0) => "mode 1",
        Some(1) => "mode 2",
        Some(2) => "mode 3",
        Some(3) => "mode 4",
        Some(_) | None => "other mode",
    }
}

/// Damping and period of an oscillation, "ζ 0.69 · T 2.4 s"; the time to half or to double of a real root.
pub fn numbers(mode: &Mode) -> String {
    let numbers = plain_numbers(mode);
    if numbers.is_empty() {
        "neutral".to_owned()
    } else if mode.is_oscillatory() && mode.stability == Stability::Unstable {
        format!("{numbers} · unstable")
    } else {
        numbers
    }
}

/// The same without a verdict; nothing of a neutral root.
pub fn plain_numbers(mode: &Mode) -> String {
    match (mode.damping_ratio(), mode.period(), mode.time_to_half(), mode.time_to_double()) {
        (Some(zeta), Some(period), _, _) => {
            format!("ζ {} · T {} s", fixed(zeta, 2), significant(period, 3))
        }
        (_, _, Some(time), _) => format!("halves in {} s", significant(time, 2)),
        (_, _, _, Some(time)) => format!("doubles in {} s", significant(time, 2)),
        _ => String::new(),
    }
}

/// How the phasors of a mode are read.
pub const fn phasors(is_oscillatory: bool) -> &'static str {
    if is_oscillatory {
        "Each arrow turns once a period: further counter-clockwise is earlier. Rates are over |λ|."
    } else {
        "A real mode: all move together, to one side or the other. Rates are over |λ|."
    }
}
