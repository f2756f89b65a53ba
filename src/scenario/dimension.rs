//! How a quantity in SI is shown: its unit's symbol, and how much of the SI unit one of it is.

use std::f64::consts::PI;

use crate::content::LengthUnit;

/// The dimension of a shown quantity. With an aircraft's unit of length it gives a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// 1/s.
    PerSecond,
    /// 1/s².
    PerSecondSquared,
    /// 1/s⁴: det A.
    PerSecondFourth,
    /// Length over time, in the aircraft's unit of length.
    Speed,
    /// Length over time squared, in the aircraft's unit of length.
    Acceleration,
    /// 1/(length × time), in the aircraft's unit of length.
    PerLengthSecond,
    /// Speed of the air and of flight: in ft/s where lengths are in feet, otherwise in m/s.
    AirSpeed,
    /// Angle, radians inside and degrees on screen.
    Angle,
    /// Angle over time, rad/s inside and deg/s on screen.
    AngularRate,
    /// Load factor, in units of g.
    Load,
    /// Angular frequency, rad/s always.
    Frequency,
    /// Seconds.
    Time,
    /// No unit.
    Number,
    /// A whole number, without a unit.
    Count,
    /// Per radian: coefficients.
    PerRadian,
    /// A ratio, shown in per cent.
    Percent,
    /// A force as a share of the weight, shown in per cent of it.
    ShareOfWeight,
    /// A distance or a height: in feet where lengths are in feet, otherwise in metres.
    Length,
    /// 1/length, in the aircraft's unit of length.
    PerLength,
    /// Angle over speed, always in degrees per m/s: a gain.
    AnglePerSpeed,
    /// Angle over length, always in degrees per metre: a gain.
    AnglePerLength,
    /// A share of the weight over speed, always in per cent per m/s: a gain.
    SharePerSpeed,
    /// A share of the weight over length, always in per cent per metre: a gain.
    SharePerLength,
}

impl Dimension {
    /// One of the shown unit in SI.
    pub fn in_si(self, length: LengthUnit) -> f64 {
        match self {
            Self::PerSecond
            | Self::PerSecondSquared
            | Self::PerSecondFourth
            | Self::Time
            | Self::Frequency
            | Self::Load
            | Self::Number
            | Self::Count
            | Self::PerRadian => 1.0,
            Self::Percent | Self::ShareOfWeight | Self::SharePerSpeed | Self::SharePerLength => 0.01,
            Self::AirSpeed | Self::Length => match length {
                LengthUnit::Foot => length.metres(),
                LengthUnit::Metre | LengthUnit::HundredFeet => 1.0,
            },
            Self::Speed | Self::Acceleration => length.metres(),
            Self::PerLengthSecond | Self::PerLength => 1.0 / length.metres(),
            Self::Angle | Self::AngularRate | Self::AnglePerSpeed | Self::AnglePerLength => PI / 180.0,
        }
    }

    /// Symbol of the shown unit.
    pub fn symbol(self, length: LengthUnit) -> &'static str {
        match (self, length) {
            (Self::PerSecond, _) => "1/s",
            (Self::PerSecondSquared, _) => "1/s²",
            (Self::PerSecondFourth, _) => "1/s⁴",
            (Self::Speed | Self::AirSpeed, LengthUnit::Foot) => "ft/s",
            (Self::Speed, LengthUnit::Metre) | (Self::AirSpeed, _) => "m/s",
            (Self::Speed, LengthUnit::HundredFeet) => "100 ft/s",
            (Self::Acceleration, LengthUnit::Metre) => "m/s²",
            (Self::Acceleration, LengthUnit::Foot) => "ft/s²",
            (Self::Acceleration, LengthUnit::HundredFeet) => "100 ft/s²",
            (Self::PerLengthSecond, LengthUnit::Metre) => "1/(m·s)",
            (Self::PerLengthSecond, LengthUnit::Foot) => "1/(ft·s)",
            (Self::PerLengthSecond, LengthUnit::HundredFeet) => "1/(100 ft·s)",
            (Self::Angle, _) => "deg",
            (Self::AngularRate, _) => "deg/s",
            (Self::Frequency, _) => "rad/s",
            (Self::Load, _) => "g",
            (Self::Time, _) => "s",
            (Self::Number | Self::Count, _) => "",
            (Self::PerRadian, _) => "1/rad",
            (Self::Percent, _) => "%",
            (Self::ShareOfWeight, _) => "% of weight",
            (Self::Length, LengthUnit::Foot) => "ft",
            (Self::Length, _) => "m",
            (Self::PerLength, LengthUnit::Metre) => "1/m",
            (Self::PerLength, LengthUnit::Foot) => "1/ft",
            (Self::PerLength, LengthUnit::HundredFeet) => "1/(100 ft)",
            (Self::AnglePerSpeed, _) => "deg per m/s",
            (Self::AnglePerLength, _) => "deg/m",
            (Self::SharePerSpeed, _) => "% of weight per m/s",
            (Self::SharePerLength, _) => "% of weight per m",
        }
    }

    /// A value \[SI\] of text: a number alone is in SI, and a unit may stand behind it, the shown one (`16%`, `2deg`) or that of SI
    /// (`0.1 rad`).
    pub fn read(self, text: &str) -> Option<f64> {
        let text = text.trim().replace('−', "-");
        let shown = self.symbol(LengthUnit::Metre);
        // "% of weight" is written as "%", but a gain always with what it is per.
        let short = shown.replacen(" of weight", "", 1);
        let in_shown = self.in_si(LengthUnit::Metre);
        let units = [("", 1.0), ("si", 1.0), (self.si_symbol(), 1.0), (shown, in_shown), (&short, in_shown)];
        let in_unit = |(symbol, in_si): (&str, f64)| {
            let number: f64 = text.strip_suffix(symbol)?.trim_end().parse().ok()?;
            Some(number * in_si)
        };
        units.into_iter().find_map(in_unit)
    }

    /// Symbol of the SI unit, in which other programs give and get values.
    pub const fn si_symbol(self) -> &'static str {
        match self {
            Self::PerSecond => "1/s",
            Self::PerSecondSquared => "1/s²",
            Self::PerSecondFourth => "1/s⁴",
            Self::Speed | Self::AirSpeed => "m/s",
            Self::Acceleration => "m/s²",
            Self::PerLengthSecond => "1/(m·s)",
            Self::Angle => "rad",
            Self::AngularRate => "rad/s",
            Self::Time => "s",
            Self::Number | Self::Count | Self::Percent | Self::ShareOfWeight => "",
            Self::PerRadian => "1/rad",
            Self::Length => "m",
            Self::PerLength | Self::SharePerLength => "1/m",
            Self::AnglePerSpeed => "rad/(m/s)",
            Self::AnglePerLength => "rad/m",
            Self::SharePerSpeed => "1/(m/s)",
            Self::Load => "g",
            Self::Frequency => "rad/s",
        }
    }
}
