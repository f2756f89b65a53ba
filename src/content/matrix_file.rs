//! The blocks of an aircraft file that holds bare matrices: A and B of one plane of motion or of both, each with its steady flight. States
//! beside the four stand behind them in A and B, named by `further_states`.

use nalgebra::DMatrix;

use super::aircraft::Particulars;
use super::reader::{Block, ContentError};
use super::units::UnitSystem;
use crate::flight::aircraft::aircraft_model::{AircraftModel, MatrixModel};
use crate::flight::aircraft::condition::STEEPEST_PATH;
use crate::flight::aircraft::further::{AppendedState, MOST_FURTHER};
use crate::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use crate::flight::aircraft::whole_model::{CommandMoves, with_further};
use crate::key::Keyed as _;

/// An aircraft from matrices: states u, w, q, θ and v, p, r, φ, inputs elevator, throttle and aileron, rudder.
pub(super) fn matrix_model(
    units: UnitSystem,
    longitudinal: Option<&mut Block<'_>>,
    lateral: Option<&mut Block<'_>>,
) -> Result<(AircraftModel, Particulars), ContentError> {
    let models = MatrixModel {
        longitudinal: longitudinal.map(|block| plane_model(block, units, Plane::Longitudinal)).transpose()?,
        lateral: lateral.map(|block| plane_model(block, units, Plane::Lateral)).transpose()?,
    };
    let speed = models.iter().flatten().next().map(|model| model.trim.speed);
    Ok((AircraftModel::Matrices(models), Particulars { speed, ..Particulars::default() }))
}

fn plane_model(block: &mut Block<'_>, units: UnitSystem, plane: Plane) -> Result<PlaneModel, ContentError> {
    let length = units.length();
    let mut angle = |key, most: f64| {
        let degrees: f64 = block.number(key)?;
        let angle = degrees.to_radians();
        if angle.abs() < most {
            Ok(angle)
        } else {
            Err(block.error(key, "expected an angle that can be flown at"))
        }
    };
    let (alpha0, gamma0) = (angle("alpha0_deg", 1.5)?, angle("gamma0_deg", STEEPEST_PATH)?);
    let trim = Trim {
        speed: block.positive("speed")? * length,
        alpha0,
        gamma0,
        gravity: block.positive("gravity")? * length,
    };
    let further = further_states(block, plane)?;
    let n = 4 + further.len();
    let Some(a) = block.optional_table("A", n, n)? else {
        return Err(block.error("A", format_args!("missing; expected {n} rows of {n} numbers")));
    };
    let kinematics = match plane {
        Plane::Longitudinal => [0.0, 0.0, 1.0, 0.0],
        // φ̇ = p + r tan θ₀
        Plane::Lateral => [0.0, 1.0, a[(3, 2)], 0.0],
    };
    if (0..n).any(|j| a[(3, j)] != kinematics.get(j).copied().unwrap_or(0.0)) {
        let said = match plane {
            Plane::Longitudinal => "0, 0, 1, 0: pitch rate is the rate of pitch angle",
            Plane::Lateral => "0, 1, tan θ₀, 0: roll rate is the rate of bank angle",
        };
        let row = if further.is_empty() { "the last row must be" } else { "the fourth row must begin with" };
        return Err(block.error("A", format_args!("{row} {said}")));
    }
    let b = block.optional_table("B", n, 2)?.unwrap_or_else(|| DMatrix::zeros(n, 2));
    // A_SI = T A T⁻¹,  B_SI = T B
    let of_four = match plane {
        Plane::Longitudinal => [length, length, 1.0, 1.0],
        Plane::Lateral => [length, 1.0, 1.0, 1.0],
    };
    let of_further = further.iter().map(|state| if state.is_length() { length } else { 1.0 });
    let scale: Vec<f64> = of_four.into_iter().chain(of_further).collect();
    let a = DMatrix::from_fn(n, n, |i, j| a[(i, j)] * (scale[i] / scale[j]));
    let b = DMatrix::from_fn(n, 2, |i, j| b[(i, j)] * scale[i]);
    with_further(plane, trim, further, &a, &b).map_err(|CommandMoves(control)| {
        let name = control.key();
        block
            .error("B", format_args!("{name} is a state: expected its column to be 0 in the first four rows"))
    })
}

/// The further states that a file names.
fn further_states(block: &mut Block<'_>, plane: Plane) -> Result<Vec<AppendedState>, ContentError> {
    let key = "further_states";
    let names = block.texts(key)?;
    if names.len() > MOST_FURTHER {
        let found = names.len();
        return Err(block.error(key, format_args!("expected at most {MOST_FURTHER} states, found {found}")));
    }
    let of_plane = |state: &AppendedState| state.plane().is_none_or(|of| of == plane);
    let known: Vec<AppendedState> = AppendedState::VALUES.iter().copied().filter(of_plane).collect();
    let mut states: Vec<AppendedState> = Vec::new();
    for name in names {
        let Some(&state) = known.iter().find(|state| state.key() == name) else {
            let known: Vec<String> = known.iter().map(|state| format!("\"{}\"", state.key())).collect();
            return Err(block.error(key, format_args!("expected {}, found \"{name}\"", known.join(" or "))));
        };
        if states.contains(&state) && !state.may_repeat() {
            return Err(block.error(key, format_args!("\"{name}\" stands there twice")));
        }
        states.push(state);
    }
    Ok(states)
}
