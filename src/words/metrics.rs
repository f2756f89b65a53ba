//! Metrics of a motion as a whole, each in a sentence, with as many digits as wanted.

use crate::content::LengthUnit;
use crate::flight::aircraft::plane::Plane;
use crate::number::significant;
use crate::scenario::Dimension;

/// The largest change of the load factor \[g\], and when \[s\].
pub fn largest_load_factor(plane: Plane, value: f64, time: f64, digits: usize) -> String {
    let (value, time) = (significant(value, digits), significant(time, digits));
    match plane {
        Plane::Longitudinal => format!("Largest change of the normal load factor n_z: {value} g at {time} s"),
        Plane::Lateral => format!("Largest lateral load factor n_y: {value} g at {time} s"),
    }
}

/// The load factor \[g\] where the linear model ends, from where it goes on to grow.
pub fn load_factor_beyond(plane: Plane, value: f64, digits: usize) -> String {
    let value = significant(value, digits);
    match plane {
        Plane::Longitudinal => {
            format!(
                "Change of the normal load factor n_z: beyond {value} g, still growing where the linear model ends"
            )
        }
        Plane::Lateral => {
            format!("Lateral load factor n_y: beyond {value} g, still growing where the linear model ends")
        }
    }
}

/// Height between the first two turning points of the phugoid \[m\], in a unit of length.
pub fn phugoid_swing(height: f64, length: LengthUnit, digits: usize) -> String {
    let height = significant(height / Dimension::Length.in_si(length), digits);
    let unit = Dimension::Length.symbol(length);
    format!("Height from the phugoid’s first turning point to its second: {height} {unit}")
}

/// Time to 30° of bank \[s\].
pub fn time_to_bank(time: f64, digits: usize) -> String {
    format!("30° of bank after {} s", significant(time, digits))
}

/// The control anticipation parameter as the motion shows it \[rad/s² per g\], and why that of the specification is another.
pub fn control_anticipation(value: f64, digits: usize) -> String {
    format!(
        "Control anticipation parameter CAP of this motion, the first pitch acceleration over the load factor at which the \
         short period settles: {} rad/s² per g. MIL-F-8785C has ωₙ²/(n/α), which leaves out the lift of the elevator itself.",
        significant(value, digits)
    )
}

/// Why there are no steady values although every mode dies away.
pub const STEADY_BEYOND: &str =
    "No steady values: the motion leaves the range of the linear model on its way to them.";
