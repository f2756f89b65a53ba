//! What sizes a disturbance.

use super::{Extent, Group, Page, Parameter, Place};
use crate::scenario::{Dimension, Disturbance};

const fn row(
    key: &'static str,
    symbol: &'static str,
    name: &'static str,
    (dimension, low, high): (Dimension, f64, f64),
    (meaning, sign): (&'static str, &'static str),
    of: fn(&mut Disturbance) -> &mut f64,
) -> Parameter {
    Parameter {
        key,
        symbol,
        name,
        page: Page::Disturbance,
        plane: None,
        group: Group::Disturbance,
        dimension,
        meaning,
        sign,
        origin: "Your choice.",
        place: Place::Disturbance(of),
        extent: Extent::Fixed { low, high },
    }
}

pub(super) const ROWS: [Parameter; 9] = [
    row(
        "step",
        "δ_e",
        "elevator step",
        (Dimension::Angle, -0.35, 0.35),
        ("Elevator after the step, trailing edge down positive.", "Positive lowers the nose."),
        |d| &mut d.step_elevator,
    ),
    row(
        "pulse",
        "δ_e",
        "elevator pulse",
        (Dimension::Angle, -0.35, 0.35),
        ("Elevator during the pulse, trailing edge down positive.", "Positive lowers the nose."),
        |d| &mut d.pulse_elevator,
    ),
    row(
        "throttle",
        "δ_t",
        "throttle step",
        (Dimension::Percent, -0.2, 0.2),
        ("Change of thrust after the step, as a share of the weight.", "Positive pushes forward."),
        |d| &mut d.step_throttle,
    ),
    row(
        "aileron",
        "δ_a",
        "aileron pulse",
        (Dimension::Angle, -0.35, 0.35),
        ("Aileron during the pulse.", "Its sense is that of the aircraft's source."),
        |d| &mut d.pulse_aileron,
    ),
    row(
        "rudder",
        "δ_r",
        "rudder pulse",
        (Dimension::Angle, -0.35, 0.35),
        ("Rudder during the pulse, trailing edge left positive.", "Positive turns the nose left."),
        |d| &mut d.pulse_rudder,
    ),
    row(
        "pulse_for",
        "for",
        "length of the pulse",
        (Dimension::Time, 0.02, 10.0),
        ("How long the control is held.", "Positive."),
        |d| &mut d.pulse_duration,
    ),
    row(
        "gust",
        "w_g",
        "speed of the rising air",
        (Dimension::AirSpeed, -20.0, 20.0),
        ("Rising air that the aircraft flies into, upward positive.", "Positive lifts the aircraft."),
        |d| &mut d.gust_speed,
    ),
    row(
        "side_gust",
        "v_g",
        "speed of the air from the left",
        (Dimension::AirSpeed, -20.0, 20.0),
        (
            "Air that moves across the flight, to the right positive.",
            "Positive blows the aircraft to the right.",
        ),
        |d| &mut d.side_gust_speed,
    ),
    row(
        "time",
        "t",
        "time shown",
        (Dimension::Time, 2.0, 300.0),
        ("How long the motion is watched.", "Positive."),
        |d| &mut d.duration,
    ),
];
