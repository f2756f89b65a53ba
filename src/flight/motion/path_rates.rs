//! The path over the Earth that follows from the states: two coordinates a plane, linear in the disturbance.

use nalgebra::{Matrix2, Matrix2x4};

use super::response::PathRates;
use crate::flight::aircraft::plane::{Plane, PlaneModel};

/// Coordinates of the path, in the order of [`super::response::Response::path`].
///
/// | plane | first | second |
/// |---|---|---|
/// | longitudinal | Δx, distance gained on the steady flight \[m\], forward | Δh, height gained on it \[m\], upward |
/// | lateral | ψ, heading \[rad\], nose right positive | y, sideways displacement \[m\], to the right |
///
/// From the Euler kinematics with the trim's θ₀ and α₀ (Etkin & Reid, *Dynamics of Flight*, 3rd ed., §4.9), first order:
///
/// ```text
/// Δẋ = u cos θ₀ + w sin θ₀ − V sin γ₀ θ        ψ̇ = r / cos θ₀
/// Δḣ = u sin θ₀ − w cos θ₀ + V cos γ₀ θ        ẏ = v − W₀ φ + V cos γ₀ ψ
/// ```
pub fn path_rates(model: &PlaneModel) -> PathRates {
    let trim = &model.trim;
    let (sin, cos) = trim.theta0().sin_cos();
    let (climb, ahead) = (trim.speed * trim.gamma0.sin(), trim.speed * trim.gamma0.cos());
    #[rustfmt::skip]
    let rates = match model.plane {
        Plane::Longitudinal => PathRates {
            of_states: Matrix2x4::new(
                cos, sin,  0.0, -climb,
                sin, -cos, 0.0, ahead,
            ),
            of_path: Matrix2::zeros(),
        },
        Plane::Lateral => PathRates {
            of_states: Matrix2x4::new(
                0.0, 0.0, 1.0 / cos, 0.0,
                1.0, 0.0, 0.0,       -trim.w0(),
            ),
            of_path: Matrix2::new(
                0.0,   0.0,
                ahead, 0.0,
            ),
        },
    };
    rates
}
