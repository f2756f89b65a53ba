//! Measures: their names, what they read in words, and why there is nothing to read.

use crate::content::LengthUnit;
use crate::findings::measures::{
    Absence, AircraftQuantity, LoopOf, LoopQuantity, Measure, Metric, ModeQuantity, PlaneQuantity, Reading,
};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::stability::Stability;
use crate::number::significant;
use crate::scenario::{Convention, Dimension, Quantity, Written};
use crate::words::{Told, mode, verdict};

/// A measure as the head of a column or the subject of a sentence.
pub fn name(measure: Measure) -> String {
    match measure {
        Measure::OfMode(name, quantity) => {
            format!("{} of the {}", of_mode(quantity), mode::in_a_sentence(name))
        }
        Measure::OfPlane(plane, quantity) => format!("{} of {}", of_plane(quantity), motion(plane)),
        Measure::OfLoop(of, quantity) => format!("{} of the {} loop", of_loop(quantity), control(of)),
        Measure::OfAircraft(quantity) => of_aircraft(quantity).to_owned(),
        Measure::OfOutput(output, metric) => {
            format!("{} of {}", of_output(metric), Quantity::of(output).name)
        }
        Measure::OfParameter(parameter) => parameter.name.to_owned(),
    }
}

/// A measure's symbol as the book writes it.
pub fn symbol(measure: Measure) -> &'static str {
    match measure {
        Measure::OfMode(_, quantity) => match quantity {
            ModeQuantity::RealPart => "σ",
            ModeQuantity::ImaginaryPart => "ω",
            ModeQuantity::NaturalFrequency => "ω_n",
            ModeQuantity::DampingRatio => "ζ",
            ModeQuantity::Period => "T",
            ModeQuantity::TimeToHalf => "t_½",
            ModeQuantity::TimeToDouble => "t_2",
            ModeQuantity::Cycles => "N",
            ModeQuantity::TimeConstant => "τ",
            ModeQuantity::Stability => "stability",
            ModeQuantity::Level => "level",
        },
        Measure::OfPlane(_, quantity) => match quantity {
            PlaneQuantity::Determinant => "det A",
            PlaneQuantity::Oscillations => "n",
            PlaneQuantity::Stability | PlaneQuantity::StaticStability => "stability",
        },
        Measure::OfLoop(_, quantity) => match quantity {
            LoopQuantity::GainMargin | LoopQuantity::GainReduction => "k",
            LoopQuantity::PhaseMargin => "φ_m",
            LoopQuantity::Crossover => "ω_c",
            LoopQuantity::SensitivityPeak => "M_s",
        },
        Measure::OfAircraft(quantity) => match quantity {
            AircraftQuantity::StaticMargin => "H_n",
            AircraftQuantity::ManoeuvreMargin => "H_m",
            AircraftQuantity::GravityRatio => "g/g_0",
            AircraftQuantity::Stability | AircraftQuantity::StaticStability => "stability",
            AircraftQuantity::Level => "level",
        },
        Measure::OfOutput(output, metric) => match metric {
            Metric::Peak | Metric::Steady => Quantity::of(output).symbol,
            Metric::PeakTime | Metric::RiseTime | Metric::SettlingTime => "t",
            Metric::Overshoot => "M_p",
        },
        Measure::OfParameter(parameter) => parameter.symbol,
    }
}

const fn of_mode(quantity: ModeQuantity) -> &'static str {
    match quantity {
        ModeQuantity::RealPart => "real part",
        ModeQuantity::ImaginaryPart => "imaginary part",
        ModeQuantity::NaturalFrequency => "natural frequency",
        ModeQuantity::DampingRatio => "damping ratio",
        ModeQuantity::Period => "period",
        ModeQuantity::TimeToHalf => "time to half",
        ModeQuantity::TimeToDouble => "time to double",
        ModeQuantity::Cycles => "cycles to half or double",
        ModeQuantity::TimeConstant => "time constant",
        ModeQuantity::Stability => "stability",
        ModeQuantity::Level => "level",
    }
}

const fn of_plane(quantity: PlaneQuantity) -> &'static str {
    match quantity {
        PlaneQuantity::Stability => "dynamic stability",
        PlaneQuantity::StaticStability => "static stability",
        PlaneQuantity::Determinant => "det A",
        PlaneQuantity::Oscillations => "number of oscillations",
    }
}

const fn of_loop(quantity: LoopQuantity) -> &'static str {
    match quantity {
        LoopQuantity::GainMargin => "gain margin",
        LoopQuantity::GainReduction => "gain reduction",
        LoopQuantity::PhaseMargin => "phase margin",
        LoopQuantity::Crossover => "crossover frequency",
        LoopQuantity::SensitivityPeak => "peak of the sensitivity",
    }
}

const fn control(of: LoopOf) -> &'static str {
    match of {
        LoopOf::Elevator => "elevator",
        LoopOf::Throttle => "throttle",
        LoopOf::Aileron => "aileron",
        LoopOf::Rudder => "rudder",
    }
}

const fn motion(plane: Plane) -> &'static str {
    match plane {
        Plane::Longitudinal => "longitudinal motion",
        Plane::Lateral => "lateral–directional motion",
    }
}

const fn of_aircraft(quantity: AircraftQuantity) -> &'static str {
    match quantity {
        AircraftQuantity::Stability => "dynamic stability",
        AircraftQuantity::StaticStability => "static stability",
        AircraftQuantity::StaticMargin => "static margin",
        AircraftQuantity::ManoeuvreMargin => "manoeuvre margin",
        AircraftQuantity::Level => "overall level",
        AircraftQuantity::GravityRatio => "gravity as a multiple of Earth’s",
    }
}

const fn of_output(metric: Metric) -> &'static str {
    match metric {
        Metric::Peak => "peak",
        Metric::PeakTime => "time of the peak",
        Metric::Steady => "steady value",
        Metric::RiseTime => "rise time",
        Metric::SettlingTime => "settling time",
        Metric::Overshoot => "overshoot",
    }
}

/// How a measure's number is written.
pub fn written(measure: Measure, convention: Convention) -> Written {
    match measure {
        Measure::OfParameter(parameter) => parameter.written(convention),
        _ => Written {
            symbol: symbol(measure),
            unit: measure.dimension().symbol(convention.length),
            in_si: measure.dimension().in_si(convention.length),
            factor: 1.0,
        },
    }
}

/// A measure's number \[SI\] as it is shown: three digits with their unit.
pub fn value(measure: Measure, value: f64, convention: Convention) -> String {
    let Written { unit, in_si, .. } = written(measure, convention);
    with_unit(&significant(value / in_si, 3), unit)
}

/// A reading with its unit.
pub fn reading(measure: Measure, reading: Reading, convention: Convention) -> String {
    match reading {
        Reading::Number(number) => value(measure, number, convention),
        Reading::Stability(stability) => word(stability).to_owned(),
        Reading::Level(level) => verdict::level(level).to_owned(),
    }
}

/// A number in SI as it is shown: three digits in the unit of its dimension.
pub fn number(dimension: Dimension, value: f64, length: LengthUnit) -> String {
    let shown = significant(value / dimension.in_si(length), 3);
    let unit = dimension.symbol(length);
    with_unit(&shown, unit)
}

/// A number with its unit; times it, where the unit begins with a number of its own: 0.88 × 100 ft/s.
pub fn with_unit(number: &str, unit: &str) -> String {
    match unit.chars().next() {
        None => number.to_owned(),
        // One over something is no factor.
        Some(first) if first.is_ascii_digit() && !unit.starts_with("1/") => {
            format!("{number}\u{a0}×\u{a0}{unit}")
        }
        Some(_) => format!("{number}\u{a0}{unit}"),
    }
}

/// A verdict on stability in one word.
pub const fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Neutral => "neutral",
        Stability::Unstable => "unstable",
    }
}

/// Why there is nothing to read, as a sentence without its full stop, in a unit of length.
pub fn absence(absence: &Absence, length: LengthUnit) -> String {
    match absence {
        Absence::Problem(problem) => Told(problem, length).to_string(),
        Absence::NoPlane(Plane::Longitudinal) => "the source has no data of longitudinal motion".to_owned(),
        Absence::NoPlane(Plane::Lateral) => "the source has no data of lateral–directional motion".to_owned(),
        Absence::NoMode(name) => format!("no mode is called {}", mode::in_a_sentence(*name)),
        Absence::DoesNotOscillate(name) => format!("the {} doesn’t oscillate", mode::in_a_sentence(*name)),
        Absence::Oscillates(name) => format!("the {} oscillates", mode::in_a_sentence(*name)),
        Absence::DoesNotGrow(name) => format!("the {} doesn’t grow", mode::in_a_sentence(*name)),
        Absence::DoesNotDieAway(name) => format!("the {} doesn’t die away", mode::in_a_sentence(*name)),
        Absence::NotJudged => "nothing judges it".to_owned(),
        Absence::NoLoop(of) => format!("the law doesn’t move the {}", control(*of)),
        Absence::NoMargin(quantity) => match quantity {
            LoopQuantity::GainMargin => "no higher gain makes the loop neutral",
            LoopQuantity::GainReduction => "no lower gain makes the loop neutral",
            LoopQuantity::PhaseMargin | LoopQuantity::Crossover => "the gain around the loop is 1 nowhere",
            LoopQuantity::SensitivityPeak => "the sensitivity is above 1 nowhere",
        }
        .to_owned(),
        Absence::NoCoefficients => "the source has no coefficients".to_owned(),
        Absence::NoParameter(parameter) => format!("the source has no {}", parameter.name),
        Absence::OtherPlane(output) => {
            format!("{} belongs to the other plane of motion", Quantity::of(*output).name)
        }
        Absence::NoMetric(Metric::Peak | Metric::PeakTime) => {
            "there is no peak while the disturbance is small".to_owned()
        }
        Absence::NoMetric(_) => "only a step that settles while it is small has one".to_owned(),
    }
}
