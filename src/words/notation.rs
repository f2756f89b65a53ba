//! Sentences in the notation that a person has chosen: with the velocities w and v, or with the angles α and β.

use std::borrow::Cow;

use crate::flight::aircraft::plane::Plane;
use crate::scenario::{Convention, Notation, Parameter};

/// Derivatives by the velocities, and by the angles that stand for them.
const BY_ANGLES: [(&str, &str); 12] = [
    ("X_w", "X_α"),
    ("Z_w", "Z_α"),
    ("M_w", "M_α"),
    ("Z_ẇ", "Z_α\u{307}"),
    ("M_ẇ", "M_α\u{307}"),
    ("Y_v", "Y_β"),
    ("L_v", "L_β"),
    ("N_v", "N_β"),
    ("M′_w", "M′_α"),
    ("Z′_w", "Z′_α"),
    ("L′_v", "L′_β"),
    ("N′_v", "N′_β"),
];

/// Beside matrices in angles.
pub const STATES: &str = "α = w/V and β = v/V stand for w and v";

/// A sentence that names derivatives without their numbers.
pub fn prose(text: &str, notation: Notation) -> Cow<'_, str> {
    match notation {
        Notation::Velocities => text.into(),
        Notation::Angles => {
            let named = BY_ANGLES.iter().filter(|(by_velocity, _)| text.contains(by_velocity));
            named
                .fold(text.into(), |text, (by_velocity, by_angle)| text.replace(by_velocity, by_angle).into())
        }
    }
}

/// What a slider's number in angles is of that in velocities, which its meaning speaks of: "M_α = V M_w". `None` where both are one.
pub fn of_slider(parameter: &Parameter, convention: Convention) -> Option<String> {
    let (own, symbol) = (parameter.symbol, parameter.written(convention).symbol);
    let of_rate = match parameter.plane {
        Some(Plane::Lateral) => "In the equation of β\u{307} = v\u{307}/V",
        Some(Plane::Longitudinal) | None => "In the equation of α\u{307} = w\u{307}/V",
    };
    (symbol != own)
        .then(|| if symbol.ends_with("/V") { of_rate.to_owned() } else { format!("{symbol} = V {own}") })
}
