//! The units in which numbers are shown. Links, files and programs keep SI whatever a person looks at.

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

    /// The unit of length of sentences among numbers that are in SI.
    pub const fn length_of_reports(self) -> LengthUnit {
        self.length(LengthUnit::Metre)
    }
}
