//! How moving air enters: through the aerodynamic columns of the model, and where its derivatives are known through its gradient
//! along the aircraft as well.
//!
//! The aerodynamic forces feel the velocity relative to the air: u − u_g, w − w_g, v − v_g. The u, w and v columns of A are purely
//! aerodynamic (the kinematic U₀ and W₀ stand in the columns of the rates), so a gust enters by −A\[:, u\] and so on (Etkin,
//! *Dynamics of Atmospheric Flight*, §13.2).
//!
//! The air is a frozen field that the aircraft passes at V: ẇ_g = V ∂w_g/∂x. A point x ahead of the centre of gravity moves
//! relative to the air with w − q x − w_g − (∂w_g/∂x) x, which is a pitch rate of q + ẇ_g/V; with v + r x − v_g − (∂v_g/∂x) x it is
//! a yaw rate of r − v̇_g/V. So
//!
//! ```text
//! q_g = −ẇ_g/V,   r_g = +v̇_g/V,   and Ẇ terms feel ẇ − ẇ_g
//! ```
//!
//! Left out: the gradient across the span (p_g, and the r_g of u_g), the lag of lift behind the angle of attack (Küssner), and
//! the gradient of a gust with a sharp edge, which is not a number.

use nalgebra::Vector4;

use super::inputs::Input;
use super::response::Forcing;
use crate::flight::aircraft::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use crate::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use crate::flight::aircraft::states::{Lateral, Longitudinal};
use crate::flight::aircraft::study::DerivativeStudy;

/// The state that air moving along the flight stands in for, u_g \[m/s\] forward positive. None in the lateral plane.
pub fn air_along(plane: Plane) -> Vector4<f64> {
    match plane {
        Plane::Longitudinal => unit(Longitudinal::U.index()),
        Plane::Lateral => Vector4::zeros(),
    }
}

/// The state that air moving across the flight stands in for: w_g \[m/s\] downward positive, or v_g to the right positive.
pub fn air_across(plane: Plane) -> Vector4<f64> {
    match plane {
        Plane::Longitudinal => unit(Longitudinal::W.index()),
        Plane::Lateral => unit(Lateral::V.index()),
    }
}

fn unit(state: usize) -> Vector4<f64> {
    Vector4::ith(state, 1.0)
}

/// A gust: air that moves with the input in place of a state, and, with `penetration`, its gradient.
pub fn gust(model: &PlaneModel, air: Vector4<f64>, penetration: Vector4<f64>, input: Input) -> Forcing {
    Forcing { column: -(model.a * air), rate_column: penetration, air, input }
}

/// Column by which the rate of change of the cross gust enters, ẇ_g or v̇_g \[m/s²\], because nose and tail are in different air.
/// Zero where only matrices are known, since q and r stand there mixed with the kinematics.
pub fn penetration_column(plane: Plane, derivatives: Option<&DerivativeStudy>) -> Vector4<f64> {
    let Some(study) = derivatives else { return Vector4::zeros() };
    let column = match plane {
        Plane::Longitudinal => study.longitudinal.as_ref().map(|d| vertical(d, &study.trim)),
        Plane::Lateral => study.lateral.as_ref().map(|d| sideways(d, &study.trim)),
    };
    column.filter(|column| column.iter().all(|x| x.is_finite())).unwrap_or_else(Vector4::zeros)
}

fn vertical(d: &LongitudinalDerivatives, trim: &Trim) -> Vector4<f64> {
    // D ẇ = … + (Zq/V − Zẇ) ẇ_g,   q̇ = … + Mẇ ẇ + (Mq/V − Mẇ) ẇ_g,   D = 1 − Zẇ
    let heave = (d.z_q / trim.speed - d.z_wdot) / (1.0 - d.z_wdot);
    Vector4::new(d.x_q / trim.speed, heave, d.m_wdot * heave + d.m_q / trim.speed - d.m_wdot, 0.0)
}

fn sideways(d: &LateralDerivatives, trim: &Trim) -> Vector4<f64> {
    // r − v̇_g/V in place of r
    let d = d.primed();
    Vector4::new(-d.y_r, -d.l_r, -d.n_r, 0.0) / trim.speed
}
