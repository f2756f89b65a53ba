//! Why a pole that is dragged stops, or doesn't move at all; after a colon.

use std::fmt::{Display, Formatter, Result};

use crate::findings::{Obstacle, PlacementError};
use crate::scenario::Parameter;

impl Display for Obstacle {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Ends(parameters) if parameters.len() == 1 => {
                write!(f, "{} is at the end of its slider", list(parameters))
            }
            Self::Ends(parameters) => write!(f, "{} are at the ends of their sliders", list(parameters)),
            Self::Sign(parameters) => {
                let verb = if parameters.len() == 1 { "is" } else { "are" };
                write!(
                    f,
                    "{} {verb} at zero: with the other sign this would be no aircraft",
                    list(parameters)
                )
            }
            Self::RealAxis => {
                f.write_str("this pair would meet on the real axis and part into two real roots")
            }
            Self::Meeting => {
                f.write_str("here it meets another real root; beyond, the two are an oscillation")
            }
            Self::OnePath(parameter) => {
                let other = if parameter.is_gain() { "gain" } else { "derivative" };
                let only = plain(parameter);
                write!(f, "{only} alone moves this pole along one path: choose another {other} with it")
            }
            Self::Nearest(parameters) => write!(f, "no mix of {} brings this pole nearer", list(parameters)),
        }
    }
}

impl Display for PlacementError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::NothingChosen => f.write_str("no derivative is chosen for it to move"),
            Self::NoGainChosen => f.write_str("no gain is chosen for it to move"),
            Self::ShownOpen => {
                f.write_str("the loop is shown open, where no gain moves a pole; show it closed first")
            }
            Self::NothingMoves(parameters) if parameters.len() == 1 => {
                write!(f, "{} has no part in this mode: choose another", list(parameters))
            }
            Self::NothingMoves(parameters) => {
                write!(f, "{} have no part in this mode: choose others", list(parameters))
            }
            Self::Inverse(error) => error.fmt(f),
        }
    }
}

/// The symbol of a parameter without marks of notation.
fn plain(parameter: &Parameter) -> String {
    parameter.symbol.replace(['{', '}'], "")
}

/// "C_mα", "C_mα and C_mq", "C_mα, C_mq and C_Lα".
fn list(parameters: &[&'static Parameter]) -> String {
    let symbols: Vec<String> = parameters.iter().map(|parameter| plain(parameter)).collect();
    match symbols.as_slice() {
        [first @ .., before, last] => {
            first.iter().map(|symbol| format!("{symbol}, ")).collect::<String>()
                + &format!("{before} and {last}")
        }
        [only] => only.clone(),
        [] => String::new(),
    }
}
