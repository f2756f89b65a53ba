//! Why a value was refused.

use std::fmt::{Display, Formatter, Result};

use crate::scenario::ValueError;

/// For the person who typed it: a sentence of its own.
pub fn sentence(error: &ValueError) -> String {
    match error {
        ValueError::NotANumber(text) => {
            format!("“{text}” is not a number; type one such as −0.35 or 2e-3.")
        }
        ValueError::NotFinite => "Only a finite number can be used here.".to_owned(),
        ValueError::NotWhole => "Only a whole number can be used here.".to_owned(),
        ValueError::Absurd { .. } => format!("{error}."),
    }
}

/// After a colon.
impl Display for ValueError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::NotANumber(text) => write!(f, "“{text}” is not a number"),
            Self::NotFinite => f.write_str("only a finite number can be used here"),
            Self::NotWhole => f.write_str("only a whole number can be used here"),
            Self::Absurd { value, low, high, unit: "" } => {
                write!(f, "{value} is beyond anything meaningful here: {low} to {high} is accepted")
            }
            Self::Absurd { value, low, high, unit } => {
                write!(f, "{value} is beyond anything meaningful here: {low} to {high} {unit} is accepted")
            }
        }
    }
}
