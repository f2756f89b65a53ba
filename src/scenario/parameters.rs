//! The one table of adjustable quantities. A row here is a slider, a name for screen readers, and a range
//! that tests walk to both ends.

use std::ops::RangeInclusive;

use thiserror::Error;

use super::{Dimension, Scenario};
use crate::flight::analysis::STANDARD_GRAVITY;
use crate::flight::linear::Longitudinal::{self, Q, Theta, U, W};

/// What a parameter multiplies or belongs to, in the order of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Column u of A.
    Speed,
    /// Column w of A.
    AngleOfAttack,
    /// Column q of A.
    PitchRate,
    /// Column θ of A.
    Attitude,
    /// The elevator column B.
    Elevator,
    /// The disturbance, not the aircraft.
    Disturbance,
}

impl Group {
    /// The groups of the derivatives pane, in its order.
    pub const DERIVATIVES: [Self; 5] =
        [Self::Speed, Self::AngleOfAttack, Self::PitchRate, Self::Attitude, Self::Elevator];

    /// The words on screen.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Speed => "Speed",
            Self::AngleOfAttack => "Angle of attack",
            Self::PitchRate => "Pitch rate",
            Self::Attitude => "Gravity",
            Self::Elevator => "Elevator",
            Self::Disturbance => "Disturbance",
        }
    }
}

/// Where a parameter lives in the scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    /// Entry of A.
    A(Longitudinal, Longitudinal),
    /// Entry of A that the book writes with a minus sign.
    MinusA(Longitudinal, Longitudinal),
    /// Entry of the elevator column.
    Elevator(Longitudinal),
    StepElevator,
    PulseElevator,
    PulseDuration,
    GustSpeed,
    Duration,
}

/// Range of a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Extent {
    /// From `low` to `high` times the size of the reference value, or of `floor` where that is larger.
    /// The floor is in units of 1/s or 1/s² and is taken times or over U₀ where the parameter's unit has a length.
    Relative { low: f64, high: f64, floor: f64 },
    /// From zero to five times standard gravity, and beyond where the reference itself is beyond.
    Gravity,
    /// Fixed, SI.
    Fixed { low: f64, high: f64 },
}

/// One adjustable quantity: a row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Short name, never changed once published.
    pub key: &'static str,
    /// Symbol as the book writes it, with `_` before a subscript.
    pub symbol: &'static str,
    /// Name in words, for screen readers and the help card.
    pub name: &'static str,
    /// Where it stands on the page.
    pub group: Group,
    /// Its dimension, for its unit.
    pub dimension: Dimension,
    /// What it means, in a sentence.
    pub meaning: &'static str,
    /// The sign that stabilises, or what the sign does.
    pub sign: &'static str,
    /// The part of the aircraft it comes from.
    pub origin: &'static str,
    place: Place,
    extent: Extent,
}

/// Why a value was refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ValueError {
    /// The text isn't a number.
    #[error("“{0}” is not a number; type one such as −0.35 or 2e-3")]
    NotANumber(String),
    /// NaN or infinite.
    #[error("only a finite number can be used here")]
    NotFinite,
    /// Beyond anything with a meaning.
    #[error("{value} is beyond anything meaningful here: {low} to {high} {unit} is accepted")]
    Absurd {
        /// The refused value, in the shown unit.
        value: String,
        /// Least accepted value, in the shown unit.
        low: String,
        /// Greatest accepted value, in the shown unit.
        high: String,
        /// The shown unit.
        unit: &'static str,
    },
}

/// A derivative may be typed up to this many times its slider's extent; beyond that it is a slip of the finger.
const TYPED_BEYOND: f64 = 100.0;

impl Parameter {
    /// The row with this key.
    pub fn find(key: &str) -> Option<&'static Self> {
        PARAMETERS.iter().find(|p| p.key == key)
    }

    /// Its value \[SI\].
    pub fn get(&self, scenario: &Scenario) -> f64 {
        let model = &scenario.model;
        let disturbance = &scenario.disturbance;
        match self.place {
            Place::A(row, column) => model.a[(row.index(), column.index())],
            Place::MinusA(row, column) => -model.a[(row.index(), column.index())],
            Place::Elevator(row) => model.b_elevator[row.index()],
            Place::StepElevator => disturbance.step_elevator,
            Place::PulseElevator => disturbance.pulse_elevator,
            Place::PulseDuration => disturbance.pulse_duration,
            Place::GustSpeed => disturbance.gust_speed,
            Place::Duration => disturbance.duration,
        }
    }

    /// Sets it to a value \[SI\] that [`Self::check`] has accepted.
    pub fn set(&self, scenario: &mut Scenario, value: f64) {
        let model = &mut scenario.model;
        let disturbance = &mut scenario.disturbance;
        *match self.place {
            Place::A(row, column) => &mut model.a[(row.index(), column.index())],
            Place::MinusA(row, column) => {
                model.a[(row.index(), column.index())] = -value;
                return;
            }
            Place::Elevator(row) => &mut model.b_elevator[row.index()],
            Place::StepElevator => &mut disturbance.step_elevator,
            Place::PulseElevator => &mut disturbance.pulse_elevator,
            Place::PulseDuration => &mut disturbance.pulse_duration,
            Place::GustSpeed => &mut disturbance.gust_speed,
            Place::Duration => &mut disturbance.duration,
        } = value;
    }

    /// Its value in the aircraft's file, or at the start for a disturbance \[SI\].
    pub fn reference(&self, scenario: &Scenario) -> f64 {
        self.get(&Scenario::new(scenario.aircraft.clone()))
    }

    /// The physical range of its slider \[SI\]. A typed value may lie outside.
    pub fn range(&self, scenario: &Scenario) -> RangeInclusive<f64> {
        let reference = self.reference(scenario);
        match self.extent {
            Extent::Relative { low, high, floor } => {
                let u0 = scenario.aircraft.longitudinal.u0;
                let floor = match self.dimension {
                    Dimension::Speed | Dimension::Acceleration => floor * u0,
                    Dimension::PerLengthSecond => floor / u0,
                    _ => floor,
                };
                let size = reference.abs().max(floor);
                low * size..=high * size
            }
            Extent::Gravity => 0.0..=(5.0 * STANDARD_GRAVITY).max(1.25 * reference),
            Extent::Fixed { low, high } => low..=high,
        }
    }

    /// Accepts or refuses a value \[SI\] that was typed or came from outside.
    pub fn check(&self, scenario: &Scenario, value: f64) -> Result<f64, ValueError> {
        if !value.is_finite() {
            return Err(ValueError::NotFinite);
        }
        let range = self.range(scenario);
        let accepted = match self.extent {
            Extent::Fixed { .. } => range,
            Extent::Relative { .. } | Extent::Gravity => {
                let reach = TYPED_BEYOND * range.start().abs().max(range.end().abs());
                -reach..=reach
            }
        };
        if accepted.contains(&value) {
            return Ok(value);
        }
        let unit = scenario.aircraft.length_unit;
        let shown = |si: f64| crate::number::significant(si / self.dimension.in_si(unit), 4);
        Err(ValueError::Absurd {
            value: shown(value),
            low: shown(*accepted.start()),
            high: shown(*accepted.end()),
            unit: self.dimension.symbol(unit),
        })
    }

    /// Reads typed text in the shown unit; `−` counts as minus and a comma as a decimal point.
    pub fn parse(&self, scenario: &Scenario, text: &str) -> Result<f64, ValueError> {
        let plain = text.trim().replace('−', "-").replace(',', ".");
        let shown: f64 = plain.parse().map_err(|_| ValueError::NotANumber(text.trim().to_owned()))?;
        self.check(scenario, shown * self.dimension.in_si(scenario.aircraft.length_unit))
    }
}

/// Every adjustable quantity, in the order of the page.
pub const PARAMETERS: [Parameter; 16] = [
    Parameter {
        key: "xu",
        symbol: "X_u",
        name: "speed damping",
        group: Group::Speed,
        dimension: Dimension::PerSecond,
        meaning: "Forward force for a unit of extra speed: drag grows with speed and slows the aircraft down.",
        sign: "Negative damps the phugoid.",
        origin: "Drag and thrust.",
        place: Place::A(U, U),
        extent: Extent::Relative { low: -6.0, high: 3.0, floor: 0.01 },
    },
    Parameter {
        key: "zu",
        symbol: "Z_u",
        name: "lift due to speed",
        group: Group::Speed,
        dimension: Dimension::PerSecond,
        meaning: "Downward force for a unit of extra speed: more speed, more lift.",
        sign: "Negative gives the phugoid its stiffness.",
        origin: "Wing lift.",
        place: Place::A(W, U),
        extent: Extent::Relative { low: -3.0, high: 1.0, floor: 0.05 },
    },
    Parameter {
        key: "mu",
        symbol: "M_u",
        name: "speed stability",
        group: Group::Speed,
        dimension: Dimension::PerLengthSecond,
        meaning: "Nose-up moment for a unit of extra speed.",
        sign: "Negative lets the nose drop as speed grows: tuck.",
        origin: "Compressibility, thrust line, and the Mẇ term where the source has one.",
        place: Place::A(Q, U),
        extent: Extent::Relative { low: -4.0, high: 6.0, floor: 0.1 },
    },
    Parameter {
        key: "xw",
        symbol: "X_w",
        name: "forward force due to angle of attack",
        group: Group::AngleOfAttack,
        dimension: Dimension::PerSecond,
        meaning: "Forward force for a unit of downward speed: lift tilts forward, drag grows.",
        sign: "Either sign; it moves the phugoid only a little.",
        origin: "Lift less the growth of drag with angle of attack.",
        place: Place::A(U, W),
        extent: Extent::Relative { low: -4.0, high: 4.0, floor: 0.02 },
    },
    Parameter {
        key: "zw",
        symbol: "Z_w",
        name: "heave damping",
        group: Group::AngleOfAttack,
        dimension: Dimension::PerSecond,
        meaning: "Downward force for a unit of downward speed: a higher angle of attack lifts.",
        sign: "Negative damps the short period; positive is a wing beyond its stall.",
        origin: "Lift slope of the wing.",
        place: Place::A(W, W),
        extent: Extent::Relative { low: -3.0, high: 1.0, floor: 0.3 },
    },
    Parameter {
        key: "mw",
        symbol: "M_w",
        name: "pitch stiffness",
        group: Group::AngleOfAttack,
        dimension: Dimension::PerLengthSecond,
        meaning: "Nose-up moment for a unit of downward speed. Negative: a gust that raises the nose makes a moment that lowers it.",
        sign: "Negative is statically stable and stiffens the short period.",
        origin: "Tail, and the centre of gravity ahead of the neutral point.",
        place: Place::A(Q, W),
        extent: Extent::Relative { low: -4.0, high: 2.0, floor: 0.5 },
    },
    Parameter {
        key: "zq",
        symbol: "Z_q + U_0",
        name: "speed along the path plus lift due to pitch rate",
        group: Group::PitchRate,
        dimension: Dimension::Speed,
        meaning: "How fast turning the nose turns into angle of attack: the flight speed, plus a little lift of the tail.",
        sign: "Positive: the speed itself.",
        origin: "Flight speed; the tail adds Zq.",
        place: Place::A(W, Q),
        extent: Extent::Relative { low: 0.0, high: 2.0, floor: 1.0 },
    },
    Parameter {
        key: "mq",
        symbol: "M_q",
        name: "pitch damping",
        group: Group::PitchRate,
        dimension: Dimension::PerSecond,
        meaning: "Nose-up moment for a unit of pitch rate: a turning tail meets its own wind.",
        sign: "Negative damps the short period.",
        origin: "Tail, by its distance squared; the Mẇ term where the source has one.",
        place: Place::A(Q, Q),
        extent: Extent::Relative { low: -4.0, high: 1.5, floor: 0.3 },
    },
    Parameter {
        key: "g",
        symbol: "g cos θ_0",
        name: "gravity along the path",
        group: Group::Attitude,
        dimension: Dimension::Acceleration,
        meaning: "Weight pulls back when the nose rises. With speed and height trading places, this is what makes a phugoid.",
        sign: "Positive. It must be in the unit of the speeds.",
        origin: "Weight and the angle of the flight path.",
        place: Place::MinusA(U, Theta),
        extent: Extent::Gravity,
    },
    Parameter {
        key: "zde",
        symbol: "Z_δe",
        name: "elevator lift",
        group: Group::Elevator,
        dimension: Dimension::Acceleration,
        meaning: "Downward force for a radian of elevator, trailing edge down.",
        sign: "Negative: trailing edge down lifts the tail. It moves no pole.",
        origin: "Elevator area.",
        place: Place::Elevator(W),
        extent: Extent::Relative { low: -4.0, high: 2.0, floor: 0.02 },
    },
    Parameter {
        key: "mde",
        symbol: "M_δe",
        name: "elevator power",
        group: Group::Elevator,
        dimension: Dimension::PerSecondSquared,
        meaning: "Nose-up moment for a radian of elevator, trailing edge down.",
        sign: "Negative: trailing edge down lowers the nose. It moves no pole.",
        origin: "Elevator area times its distance.",
        place: Place::Elevator(Q),
        extent: Extent::Relative { low: -3.0, high: 1.0, floor: 1.0 },
    },
    Parameter {
        key: "step",
        symbol: "δ_e",
        name: "elevator step",
        group: Group::Disturbance,
        dimension: Dimension::Angle,
        meaning: "Elevator after the step, trailing edge down positive.",
        sign: "Positive lowers the nose.",
        origin: "The pilot.",
        place: Place::StepElevator,
        extent: Extent::Fixed { low: -0.35, high: 0.35 },
    },
    Parameter {
        key: "pulse",
        symbol: "δ_e",
        name: "elevator pulse",
        group: Group::Disturbance,
        dimension: Dimension::Angle,
        meaning: "Elevator during the pulse, trailing edge down positive.",
        sign: "Positive lowers the nose.",
        origin: "The pilot.",
        place: Place::PulseElevator,
        extent: Extent::Fixed { low: -0.35, high: 0.35 },
    },
    Parameter {
        key: "pulse_for",
        symbol: "for",
        name: "length of the pulse",
        group: Group::Disturbance,
        dimension: Dimension::Time,
        meaning: "How long the elevator is held.",
        sign: "Positive.",
        origin: "The pilot.",
        place: Place::PulseDuration,
        extent: Extent::Fixed { low: 0.02, high: 10.0 },
    },
    Parameter {
        key: "gust",
        symbol: "w_g",
        name: "speed of the rising air",
        group: Group::Disturbance,
        dimension: Dimension::AirSpeed,
        meaning: "Rising air that the aircraft flies into, upward positive.",
        sign: "Positive lifts the aircraft.",
        origin: "The weather.",
        place: Place::GustSpeed,
        extent: Extent::Fixed { low: -20.0, high: 20.0 },
    },
    Parameter {
        key: "time",
        symbol: "t",
        name: "time shown",
        group: Group::Disturbance,
        dimension: Dimension::Time,
        meaning: "How long the motion is watched.",
        sign: "Positive.",
        origin: "You.",
        place: Place::Duration,
        extent: Extent::Fixed { low: 2.0, high: 300.0 },
    },
];
