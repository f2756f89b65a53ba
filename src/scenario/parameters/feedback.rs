//! The law of feedback: a gain from what is measured to each control, and the washouts and lags on the way. All are zero at first.

use super::{Extent, Group, Page, Parameter, Place};
use crate::flight::aircraft::plane::Plane;
use crate::flight::feedback::Law;
use crate::scenario::Dimension;

/// Where the rows of gains say that their sign is that of δ = +k y.
const OF_GAINS: &str =
    "δ = +k y: what is measured times the gain is added to the control, in its own positive sense.";

const fn gain(
    key: &'static str,
    symbol: &'static str,
    name: &'static str,
    (plane, group): (Plane, Group),
    (dimension, reach): (Dimension, f64),
    (meaning, sign): (&'static str, &'static str),
    of: fn(&mut Law) -> &mut f64,
) -> Parameter {
    Parameter {
        key,
        symbol,
        name,
        page: Some(Page::Feedback),
        plane: Some(plane),
        group,
        dimension,
        meaning,
        sign,
        origin: OF_GAINS,
        place: Place::Feedback(of),
        extent: Extent::Fixed { low: -reach, high: reach },
    }
}

const fn lag(
    key: &'static str,
    symbol: &'static str,
    name: &'static str,
    (plane, high): (Option<Plane>, f64),
    (meaning, sign, origin): (&'static str, &'static str, &'static str),
    of: fn(&mut Law) -> &mut f64,
) -> Parameter {
    Parameter {
        key,
        symbol,
        name,
        page: Some(Page::Feedback),
        plane,
        group: Group::Filters,
        dimension: Dimension::Time,
        meaning,
        sign,
        origin,
        place: Place::Feedback(of),
        extent: Extent::Fixed { low: 0.0, high },
    }
}

const ELEVATOR: (Plane, Group) = (Plane::Longitudinal, Group::Elevator);
const THROTTLE: (Plane, Group) = (Plane::Longitudinal, Group::Throttle);
const AILERON: (Plane, Group) = (Plane::Lateral, Group::Aileron);
const RUDDER: (Plane, Group) = (Plane::Lateral, Group::Rudder);

/// A gain of a rate \[s\], of an angle \[–\].
const OF_RATE: (Dimension, f64) = (Dimension::Time, 5.0);
const OF_ANGLE: (Dimension, f64) = (Dimension::Number, 5.0);

pub(super) const ROWS: [Parameter; 24] = [
    gain(
        "k.q_de",
        "k_{q→δe}",
        "gain of pitch rate to elevator",
        ELEVATOR,
        OF_RATE,
        (
            "Elevator for a unit of pitch rate: a pitch damper.",
            "Positive is against the rotation and damps the short period.",
        ),
        |law| &mut law.planes.longitudinal.to_first[2],
    ),
    gain(
        "k.alpha_de",
        "k_{α→δe}",
        "gain of angle of attack to elevator",
        ELEVATOR,
        OF_ANGLE,
        (
            "Elevator for a unit of angle of attack, as a vane feels it: artificial stability.",
            "Positive is nose down as α rises, as if the centre of gravity were further ahead.",
        ),
        |law| &mut law.planes.longitudinal.to_first[1],
    ),
    gain(
        "k.theta_de",
        "k_{θ→δe}",
        "gain of pitch angle to elevator",
        ELEVATOR,
        OF_ANGLE,
        (
            "Elevator for a unit of pitch angle: it holds the attitude.",
            "Positive brings the pitch angle back and quiets the phugoid.",
        ),
        |law| &mut law.planes.longitudinal.to_first[3],
    ),
    gain(
        "k.u_de",
        "k_{u→δe}",
        "gain of speed to elevator",
        ELEVATOR,
        (Dimension::AnglePerSpeed, 0.1),
        (
            "Elevator for a unit of speed.",
            "Negative raises the nose when it is fast, and so brings the speed back.",
        ),
        |law| &mut law.planes.longitudinal.to_first[0],
    ),
    gain(
        "k.h_de",
        "k_{h→δe}",
        "gain of height to elevator",
        ELEVATOR,
        (Dimension::AnglePerLength, 0.02),
        (
            "Elevator for a unit of height gained: it holds the height. Height becomes a state.",
            "Positive is nose down when it is high; alone it takes damping from the phugoid.",
        ),
        |law| &mut law.planes.longitudinal.to_first[4],
    ),
    gain(
        "k.q_dt",
        "k_{q→δt}",
        "gain of pitch rate to throttle",
        THROTTLE,
        (Dimension::Time, 2.0),
        ("Thrust for a unit of pitch rate.", "Positive adds thrust while the nose rises."),
        |law| &mut law.planes.longitudinal.to_second[2],
    ),
    gain(
        "k.alpha_dt",
        "k_{α→δt}",
        "gain of angle of attack to throttle",
        THROTTLE,
        (Dimension::Number, 2.0),
        ("Thrust for a unit of angle of attack.", "Positive adds thrust as α rises."),
        |law| &mut law.planes.longitudinal.to_second[1],
    ),
    gain(
        "k.theta_dt",
        "k_{θ→δt}",
        "gain of pitch angle to throttle",
        THROTTLE,
        (Dimension::Number, 2.0),
        (
            "Thrust for a unit of pitch angle.",
            "Positive adds thrust when the nose is high; 1 carries the weight along the path.",
        ),
        |law| &mut law.planes.longitudinal.to_second[3],
    ),
    gain(
        "k.u_dt",
        "k_{u→δt}",
        "gain of speed to throttle",
        THROTTLE,
        (Dimension::SharePerSpeed, 0.1),
        (
            "Thrust for a unit of speed: an autothrottle.",
            "Negative takes thrust away when it is fast: it holds the speed and damps the phugoid.",
        ),
        |law| &mut law.planes.longitudinal.to_second[0],
    ),
    gain(
        "k.h_dt",
        "k_{h→δt}",
        "gain of height to throttle",
        THROTTLE,
        (Dimension::SharePerLength, 0.02),
        (
            "Thrust for a unit of height gained. Height becomes a state.",
            "Negative takes thrust away when it is high.",
        ),
        |law| &mut law.planes.longitudinal.to_second[4],
    ),
    gain(
        "k.r_dr",
        "k_{r→δr}",
        "gain of yaw rate to rudder",
        RUDDER,
        OF_RATE,
        (
            "Rudder for a unit of yaw rate: a yaw damper.",
            "Positive is against the turn and damps the Dutch roll; without a washout it fights a steady turn too.",
        ),
        |law| &mut law.planes.lateral.to_second[2],
    ),
    gain(
        "k.beta_dr",
        "k_{β→δr}",
        "gain of sideslip to rudder",
        RUDDER,
        OF_ANGLE,
        (
            "Rudder for a unit of sideslip, as a vane feels it.",
            "Negative turns the nose into the wind, as a larger fin does; positive away from it.",
        ),
        |law| &mut law.planes.lateral.to_second[0],
    ),
    gain(
        "k.p_dr",
        "k_{p→δr}",
        "gain of roll rate to rudder",
        RUDDER,
        OF_RATE,
        (
            "Rudder for a unit of roll rate.",
            "Negative turns the nose towards the wing that goes down, positive away from it.",
        ),
        |law| &mut law.planes.lateral.to_second[1],
    ),
    gain(
        "k.phi_dr",
        "k_{φ→δr}",
        "gain of bank angle to rudder",
        RUDDER,
        OF_ANGLE,
        (
            "Rudder for a unit of bank angle.",
            "Positive turns the nose out of the turn, and brings the wings level by sideslip.",
        ),
        |law| &mut law.planes.lateral.to_second[3],
    ),
    gain(
        "k.psi_dr",
        "k_{ψ→δr}",
        "gain of heading to rudder",
        RUDDER,
        OF_ANGLE,
        (
            "Rudder for a unit of heading. Heading becomes a state.",
            "Positive turns the nose back to where it was.",
        ),
        |law| &mut law.planes.lateral.to_second[4],
    ),
    gain(
        "k.r_da",
        "k_{r→δa}",
        "gain of yaw rate to aileron",
        AILERON,
        OF_RATE,
        ("Aileron for a unit of yaw rate.", "Negative rolls out of the turn: it steadies the spiral."),
        |law| &mut law.planes.lateral.to_first[2],
    ),
    gain(
        "k.beta_da",
        "k_{β→δa}",
        "gain of sideslip to aileron",
        AILERON,
        OF_ANGLE,
        (
            "Aileron for a unit of sideslip, as a vane feels it.",
            "Negative rolls away from the wind, as dihedral does; positive takes dihedral away.",
        ),
        |law| &mut law.planes.lateral.to_first[0],
    ),
    gain(
        "k.p_da",
        "k_{p→δa}",
        "gain of roll rate to aileron",
        AILERON,
        OF_RATE,
        (
            "Aileron for a unit of roll rate: a roll damper.",
            "Negative is against the roll and makes the roll mode faster.",
        ),
        |law| &mut law.planes.lateral.to_first[1],
    ),
    gain(
        "k.phi_da",
        "k_{φ→δa}",
        "gain of bank angle to aileron",
        AILERON,
        OF_ANGLE,
        (
            "Aileron for a unit of bank angle: a wing leveller.",
            "Negative brings the wings level; roll and spiral meet as it grows.",
        ),
        |law| &mut law.planes.lateral.to_first[3],
    ),
    gain(
        "k.psi_da",
        "k_{ψ→δa}",
        "gain of heading to aileron",
        AILERON,
        OF_ANGLE,
        (
            "Aileron for a unit of heading: it holds the heading by banking. Heading becomes a state.",
            "Negative banks against the change of heading.",
        ),
        |law| &mut law.planes.lateral.to_first[4],
    ),
    lag(
        "washout",
        "T_w",
        "washout of the yaw rate",
        (Some(Plane::Lateral), 20.0),
        (
            "Time constant of the washout on the way of the yaw rate: what is slower is taken out, so that a steady turn isn’t felt. \
             Zero is none, and all of the yaw rate gets through.",
            "Longer lets slower motions through, and fights a turn for longer; the spiral keeps its own with any.",
            "s/(s + 1/T)",
        ),
        |law| &mut law.planes.lateral.washout,
    ),
    lag(
        "washout_q",
        "T_{wq}",
        "washout of the pitch rate",
        (Some(Plane::Longitudinal), 20.0),
        (
            "Time constant of the washout on the way of the pitch rate: what is slower is taken out, so that a steady pull-up isn’t felt. \
             Zero is none, and all of the pitch rate gets through.",
            "Longer lets slower motions through.",
            "s/(s + 1/T)",
        ),
        |law| &mut law.planes.longitudinal.washout,
    ),
    lag(
        "actuator",
        "τ_a",
        "lag of the actuators",
        (None, 1.0),
        (
            "Time constant by which elevator, aileron and rudder follow what the law asks for. Zero is none. The pilot’s own deflection is \
             beside it.",
            "Longer answers later: gains go less far before an oscillation grows.",
            "1/(τs + 1)",
        ),
        |law| &mut law.actuator,
    ),
    lag(
        "engine",
        "τ_e",
        "lag of the engine",
        (Some(Plane::Longitudinal), 10.0),
        (
            "Time constant by which thrust follows what the law asks for. Zero is none.",
            "Longer answers later.",
            "1/(τs + 1)",
        ),
        |law| &mut law.engine,
    ),
];
