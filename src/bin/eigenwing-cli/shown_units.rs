//! The units of tables: those of the answers, SI and radians, or feet and degrees. Files and programs always get SI.

use eigenwing::content::LengthUnit;
use eigenwing::export::ExportError;
use eigenwing::scenario::Units;
use eigenwing::words::Told;

use crate::input::InputError;

/// The units of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ShownUnits {
    /// SI and radians.
    #[default]
    Si,
    /// Feet and degrees.
    Feet,
}

impl ShownUnits {
    /// Those in which a scene is told.
    pub const fn of(units: Units) -> Self {
        match units {
            Units::Feet => Self::Feet,
            Units::Source | Units::Si => Self::Si,
        }
    }

    /// Why an answer can't be had.
    pub fn told(self, error: ExportError) -> InputError {
        match error {
            ExportError::AircraftModel(error) => InputError::Told(Told(&error, self.length()).to_string()),
            ExportError::Analysis(error) => InputError::Told(Told(&error, self.length()).to_string()),
            error => error.into(),
        }
    }

    /// The unit of length.
    pub const fn length(self) -> LengthUnit {
        match self {
            Self::Si => LengthUnit::Metre,
            Self::Feet => LengthUnit::Foot,
        }
    }

    /// One of the unit that stands for an SI unit, in SI, and its symbol.
    pub fn unit(self, si: &str) -> (f64, &str) {
        match (self, si) {
            (Self::Si, _) => (1.0, si),
            (Self::Feet, "rad") => (1_f64.to_radians(), "deg"),
            (Self::Feet, _) => Units::Feet.of_data(si),
        }
    }

    /// The same of an input or output of a motion: their radians a second are never a frequency.
    pub fn of_motion(self, si: &str) -> (f64, &str) {
        match (self, si) {
            (Self::Feet, "rad/s") => (1_f64.to_radians(), "deg/s"),
            _ => self.unit(si),
        }
    }
}
