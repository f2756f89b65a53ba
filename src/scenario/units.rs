//! The units in which numbers are shown. Links, aircraft files, scripts, JSON and other programs keep SI whatever a person looks at.

use crate::content::LengthUnit;
use crate::key::keys;

/// The units that a person has chosen to read; time is in seconds and angles are in degrees in all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// Those of the aircraft's source where it has some of its own, otherwise SI.
    #[default]
    Source,
    /// Metres.
    Si,
    /// Feet.
    Feet,
}

keys! {
    Units {
        Source => "source",
        Si => "si" | "metres" | "m",
        Feet => "ft" | "feet",
    }
}

impl Units {
    /// Those that come after them, for a key.
    pub const fn next(self) -> Self {
        match self {
            Self::Source => Self::Si,
            Self::Si => Self::Feet,
            Self::Feet => Self::Source,
        }
    }

    /// The unit of length, of an aircraft whose source has this one.
    pub const fn length(self, of_source: LengthUnit) -> LengthUnit {
        match self {
            Self::Source => of_source,
            Self::Si => LengthUnit::Metre,
            Self::Feet => LengthUnit::Foot,
        }
    }

    /// One of the unit that stands for an SI unit among data, in SI, and its symbol: feet for metres where they are chosen; radians
    /// stay.
    pub fn of_data(self, si: &str) -> (f64, &str) {
        let foot = LengthUnit::Foot.metres();
        match (self, si) {
            (Self::Feet, "m") => (foot, "ft"),
            (Self::Feet, "m/s") => (foot, "ft/s"),
            (Self::Feet, "m/s²") => (foot, "ft/s²"),
            (Self::Feet, "1/m") => (1.0 / foot, "1/ft"),
            (Self::Feet, "1/(m·s)") => (1.0 / foot, "1/(ft·s)"),
            _ => (1.0, si),
        }
    }

    /// The unit of length of sentences among numbers that are in SI.
    pub const fn length_of_reports(self) -> LengthUnit {
        self.length(LengthUnit::Metre)
    }
}
