//! The rows and entries of the equations ẋ = A x + B δ.

use crate::findings::equations::CHANGE;
use crate::flight::aircraft::plane::Plane;
use crate::number::significant;
use crate::scenario::Notation;
use crate::words::sensitivity::NOTHING;

/// The heading of the equations.
pub const TITLE: &str = "Equations";

/// Above bare matrices.
pub const ONLY_NUMBERS: &str = "Numbers only: the source doesn't say what they are made of";

/// Beside the choosers, where the mode by which the entries are coloured is chosen.
pub const COLOURED_BY: &str = "Coloured by";

/// For no colours.
pub const NO_MODE: &str = "no mode";

/// Before the derivatives that an entry is made of, each of which leads to its slider.
pub const TO_SLIDERS: &str = "Sliders:";

/// What the last line is.
pub const POLYNOMIAL: &str = "The characteristic polynomial det(λI − A), whose roots are the poles, and its factors, one a mode: \
    λ² + 2ζωₙ λ + ωₙ² of a pair, λ − λ₁ of a real root λ₁. Coefficients in powers of 1/s";

/// Where two roots meet.
pub const NO_RATE: &str = "Two roots meet here, so no entry moves them at a finite rate.";

/// What a row is the equation of.
pub const fn row(plane: Plane, row: usize) -> &'static str {
    match (plane, row) {
        (Plane::Longitudinal, 0) => "Drag equation: forces along the x axis over the mass",
        (Plane::Longitudinal, 1) => "Lift equation: forces along the z axis, downward, over the mass",
        (Plane::Longitudinal, 2) => "Pitching moment over I_y",
        (Plane::Longitudinal, _) => "Kinematics: the pitch angle turns at the pitch rate, in every aircraft",
        (Plane::Lateral, 0) => "Side force equation: forces along the y axis, to the right, over the mass",
        (Plane::Lateral, 1) => "Rolling moment over I_x, with its share of the yawing moment by I_xz",
        (Plane::Lateral, 2) => "Yawing moment over I_z, with its share of the rolling moment by I_xz",
        (Plane::Lateral, _) => {
            "Kinematics: the bank angle turns at the roll rate, and in a climb with the yaw rate"
        }
    }
}

/// Symbols of the states and the inputs, in the order of the columns.
pub const fn columns(plane: Plane, notation: Notation) -> [&'static str; 6] {
    match (plane, notation) {
        (Plane::Longitudinal, Notation::Velocities) => ["u", "w", "q", "θ", "δ_e", "δ_t"],
        (Plane::Longitudinal, Notation::Angles) => ["u", "α", "q", "θ", "δ_e", "δ_t"],
        (Plane::Lateral, Notation::Velocities) => ["v", "p", "r", "φ", "δ_a", "δ_r"],
        (Plane::Lateral, Notation::Angles) => ["β", "p", "r", "φ", "δ_a", "δ_r"],
    }
}

/// Symbols of the rates, in the order of the rows.
pub fn rates(plane: Plane, notation: Notation) -> [String; 4] {
    let [first, second, third, fourth, ..] = columns(plane, notation);
    [first, second, third, fourth].map(|state| format!("{state}\u{307}"))
}

/// The place of an entry, for who can't see it: "A, row q dot, column w".
pub fn place(plane: Plane, notation: Notation, (row, column): (usize, usize)) -> String {
    let matrix = if column < 4 { "A" } else { "B" };
    let [of_row, of_column] = [row, column].map(|index| columns(plane, notation)[index].replace('_', ""));
    format!("{matrix}, row {of_row} dot, column {of_column}")
}

/// What the colours of the entries mean, of a mode by its name in a sentence.
pub fn legend(mode: &str) -> String {
    let change = significant(100.0 * CHANGE, 2);
    format!(
        "Colour and bar: how far {change} % of an entry move the pole of the {mode}. A full bar is a tenth of its \
         distance from the origin and more, no bar is no move."
    )
}

/// How far an entry moves a mode by its name in a sentence, of a strength over [`CHANGE`] of it.
pub fn strength(strength: f64, mode: &str) -> String {
    let change = significant(100.0 * CHANGE, 2);
    if strength < NOTHING {
        format!("it doesn't move the {mode}")
    } else {
        format!("{change} % of it move the {mode} by {} %", significant(100.0 * strength, 2))
    }
}

/// What is added to an entry by its own slider.
pub fn added(value: &str) -> String {
    format!("Δ = {value} is added by the sliders of this page")
}
