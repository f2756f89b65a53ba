//! Why a control that stays deflected leads to another steady flight.

use crate::content::LengthUnit;
use crate::findings::change::{Balance, NewTrim};
use crate::number::significant;
use crate::scenario::{Convention, Dimension, Notation, Source};
use crate::words::measure::number;

/// A term below this fraction of the largest isn't told.
const MINOR: f64 = 0.03;

/// Where the control leads, and what is in balance there, in one or two sentences.
pub fn sentence(trim: &NewTrim, convention: Convention) -> String {
    let length = convention.length;
    let NewTrim { source, speed, alpha, gamma, moment, lift, .. } = trim;
    let [speed, alpha, gamma] = [
        signed(Dimension::AirSpeed, *speed, length),
        signed(Dimension::Angle, *alpha, length),
        signed(Dimension::Angle, *gamma, length),
    ];
    let control = if *source == Source::Throttle { "δt" } else { "δe" };
    let largest =
        [moment.speed, moment.attack, moment.control].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    if *source == Source::Throttle && largest * 20.0 < lift.speed.abs().max(lift.attack.abs()).max(1e-3) {
        return format!(
            "A new thrust is a new path: it makes no pitching moment, so α stays (Δα = {alpha}), and with it the speed (Δu = {speed}); \
             the weight takes up the thrust along a path that climbs by Δγ = {gamma}."
        );
    }
    let of_attack = match convention.notation {
        Notation::Velocities => ["M_w w", "Z_w w"],
        Notation::Angles => ["M_α α", "Z_α α"],
    };
    let (in_si, unit) = match length {
        LengthUnit::Foot => (Dimension::Acceleration.in_si(length), Dimension::Acceleration.symbol(length)),
        LengthUnit::Metre | LengthUnit::HundredFeet => (1.0, "m/s²"),
    };
    let what = if *source == Source::Throttle { "thrust" } else { "elevator" };
    format!(
        "A new {what} is a new trim: the pitching moments balance again at Δα = {alpha} ({}\u{a0}1/s²), and there the lift carries the weight \
         only at another speed, Δu = {speed} ({}\u{a0}{unit}).",
        balance(moment, 1.0, ["M_u u", of_attack[0], "weight", &format!("M_{control} {control}")]),
        balance(lift, in_si, ["Z_u u", of_attack[1], "weight", &format!("Z_{control} {control}")]),
    )
}

fn signed(dimension: Dimension, value: f64, length: LengthUnit) -> String {
    format!("{}{}", if value >= 0.0 { "+" } else { "" }, number(dimension, value, length))
}

/// "M_w w + M_δe δe = −0.146 + 0.146", in units of so much in SI.
fn balance(balance: &Balance, in_si: f64, symbols: [&str; 4]) -> String {
    let terms = [balance.speed, balance.attack, balance.attitude, balance.control].map(|term| term / in_si);
    let largest = terms.iter().fold(0.0, |largest: f64, term| largest.max(term.abs()));
    let told: Vec<(&str, f64)> =
        symbols.into_iter().zip(terms).filter(|(_, term)| term.abs() > MINOR * largest).collect();
    let symbols: Vec<&str> = told.iter().map(|(symbol, _)| *symbol).collect();
    let mut numbers = String::new();
    for (_, term) in &told {
        numbers += &match (numbers.is_empty(), *term < 0.0) {
            (true, _) => significant(*term, 3),
            (false, true) => format!(" − {}", significant(-term, 3)),
            (false, false) => format!(" + {}", significant(*term, 3)),
        };
    }
    format!("{} = {numbers}", symbols.join(" + "))
}
