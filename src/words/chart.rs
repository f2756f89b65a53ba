//! A measure over a slider.

use crate::content::LengthUnit;
use crate::findings::measures::{Absence, Measure};
use crate::flight::verdicts::handling_qualities::Level;
use crate::words::measure;

/// What is charted, as the subject of a figure.
pub fn title(of: Measure, over: &str) -> String {
    format!("{} over {over}", measure::name(of))
}

/// The reading as things are, with the value of the slider.
pub fn now(reading: &str, symbol: &str, value: &str) -> String {
    format!("Now {reading} at {symbol} = {value}")
}

/// Why there is no reading as things are.
pub fn no_reading(absence: &Absence, length: LengthUnit) -> String {
    format!("No reading now: {}", measure::absence(absence, length))
}

/// A key that no measure has.
pub fn unknown(key: &str) -> String {
    format!("There is no measure “{key}” that could be charted")
}

/// A limit of a level.
pub const fn limit(level: Level) -> &'static str {
    match level {
        Level::One => "limit of Level 1",
        Level::Two => "limit of Level 2",
        Level::Three | Level::Beyond => "limit of Level 3",
    }
}

/// The button that charts something over a slider.
pub const OVER_THIS: &str = "Chart a measure over this slider";

/// In place of the chart where the plane has no slider.
pub const NO_SLIDER: &str = "There is no slider to chart anything over";
