//! How moving air enters: through the aerodynamic columns of the model, and where its derivatives are known through its gradient
//! along the aircraft as well.
//!
//! The aerodynamic forces feel the velocity relative to the air: u − u_g, w − w_g, v − v_g. The u, w and v columns of A are purely
//! aerodynamic (the kinematic U₀ and W₀ stand in the columns of the rates), so a gust enters by −A\[:, u\] and so on (Etkin,
//! *Dynamics of Atmospheric Flight*, §13.2).
//!
//! # Axes
//!
//! Gusts blow along and across the flight path of the trim, whatever axes a source prints its numbers in: u_g along the steady
//! velocity, w_g normal to it, downward. In axes at an angle of attack α₀ they are
//!
//! ```text
//! ⎡ u ⎤   ⎡ cos α₀  −sin α₀ ⎤ ⎡ u_g ⎤
//! ⎣ w ⎦ = ⎣ sin α₀   cos α₀ ⎦ ⎣ w_g ⎦
//! ```
//!
//! # Gradient
//!
//! The air is a frozen field that the aircraft passes at V: ẇ_g = V ∂w_g/∂x with x along the path. A point x ahead of the centre
//! of gravity moves relative to the air with w − q x − w_g − (∂w_g/∂x) x, which is a pitch rate of q + ẇ_g/V; with
//! v + r x − v_g − (∂v_g/∂x) x it is a yaw rate of r − v̇_g/V about the normal to the path. So
//!
//! ```text
//! q_g = −ẇ_g/V,   r_g = +v̇_g/V,   and Ẇ terms feel ẇ less that of the air
//! ```
//!
//! and the air that turns with r_g about the normal to the path turns with p_g = −r_g sin α₀ about x and r_g cos α₀ about z.
//!
//! Left out: the gradient across the span (p_g, and the r_g of u_g), the lag of lift behind the angle of attack (Küssner), and
//! the gradient of a gust with a sharp edge, which is not a number.

use nalgebra::Vector4;

use super::inputs::Input;
use super::response::Forcing;
use crate::flight::aircraft::aircraft_model::DerivativeModel;
use crate::flight::aircraft::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use crate::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use crate::flight::aircraft::states::Lateral;

/// The states that air moving along the flight path stands in for, u_g = 1 m/s forward. None in the lateral plane.
pub fn air_along(plane: Plane, alpha0: f64) -> Vector4<f64> {
    let (sin, cos) = alpha0.sin_cos();
    match plane {
        Plane::Longitudinal => Vector4::new(cos, sin, 0.0, 0.0),
        Plane::Lateral => Vector4::zeros(),
    }
}

/// The states that air moving across the flight path stands in for: w_g = 1 m/s downward, or v_g = 1 m/s to the right.
pub fn air_across(plane: Plane, alpha0: f64) -> Vector4<f64> {
    let (sin, cos) = alpha0.sin_cos();
    match plane {
        Plane::Longitudinal => Vector4::new(-sin, cos, 0.0, 0.0),
        Plane::Lateral => Vector4::ith(Lateral::V.index(), 1.0),
    }
}

/// A gust: air that moves with the input in place of states, and the column of its rate of change.
pub fn gust(model: &PlaneModel, air: Vector4<f64>, rate_column: Vector4<f64>, input: Input) -> Forcing {
    Forcing { rate_column, air, ..Forcing::new(-(model.a * air), input) }
}

/// Columns by which the rates of change of air along and across the flight path enter \[per m/s²\]: because nose and tail are in
/// different air, and because Ẇ terms feel it. Zero where only matrices are known, since q and r stand there mixed with the
/// kinematics.
pub fn rate_columns(plane: Plane, derivatives: Option<&DerivativeModel>) -> [Vector4<f64>; 2] {
    let still = [Vector4::zeros(); 2];
    let Some(aircraft_model) = derivatives else { return still };
    let columns = match plane {
        Plane::Longitudinal => {
            aircraft_model.longitudinal.as_ref().map(|d| longitudinal(d, &aircraft_model.trim))
        }
        Plane::Lateral => {
            aircraft_model.lateral.as_ref().map(|d| [Vector4::zeros(), sideways(d, &aircraft_model.trim)])
        }
    };
    columns.filter(|columns| columns.iter().flatten().all(|x| x.is_finite())).unwrap_or(still)
}

fn longitudinal(d: &LongitudinalDerivatives, trim: &Trim) -> [Vector4<f64>; 2] {
    // D ẇ = … + Zq q_met − Zẇ ẇ_air,   q̇ = … + Mẇ ẇ + Mq q_met − Mẇ ẇ_air,   D = 1 − Zẇ
    let met = |q: f64, w_rate: f64| {
        let heave = (d.z_q * q - d.z_wdot * w_rate) / (1.0 - d.z_wdot);
        Vector4::new(d.x_q * q, heave, d.m_wdot * (heave - w_rate) + d.m_q * q, 0.0)
    };
    // Along: ẇ_air = u̇_g sin α₀, and nothing turns. Across: ẇ_air = ẇ_g cos α₀, q_met = ẇ_g/V.
    let (sin, cos) = trim.alpha0.sin_cos();
    [met(0.0, sin), met(1.0 / trim.speed, cos)]
}

fn sideways(d: &LateralDerivatives, trim: &Trim) -> Vector4<f64> {
    // r − (v̇_g/V) cos α₀ in place of r, p + (v̇_g/V) sin α₀ in place of p
    let d = d.primed();
    let (sin, cos) = trim.alpha0.sin_cos();
    let turned = |of_p: f64, of_r: f64| (of_p * sin - of_r * cos) / trim.speed;
    Vector4::new(turned(d.y_p, d.y_r), turned(d.l_p, d.l_r), turned(d.n_p, d.n_r), 0.0)
}
