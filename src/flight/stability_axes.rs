//! The same motion in the stability axes of the trim, in which the books' approximations and criteria are written.

use nalgebra::{Matrix4, Vector4};

use super::plane::{Plane, PlaneModel, Trim};

/// The model with x along the steady velocity: a similarity A_s = T A T⁻¹, B_s = T B that changes no eigenvalue.
pub(super) fn in_stability_axes(model: &PlaneModel) -> PlaneModel {
    let trim = model.trim;
    if trim.alpha0 == 0.0 {
        return model.clone();
    }
    let (sin, cos) = trim.alpha0.sin_cos();
    let (t, inverse) = match model.plane {
        // [u; w]ₛ = [cos α₀, sin α₀; −sin α₀, cos α₀] [u; w]
        Plane::Longitudinal => (turn(0, 1, sin, cos), turn(0, 1, -sin, cos)),
        // [p; r]ₛ by the same turn, φₛ = φ cos θ₀/cos γ₀
        Plane::Lateral => {
            let bank = trim.theta0().cos() / trim.gamma0.cos();
            let scale = |k: f64| Matrix4::from_diagonal(&Vector4::new(1.0, 1.0, 1.0, k));
            (scale(bank) * turn(1, 2, sin, cos), turn(1, 2, -sin, cos) * scale(1.0 / bank))
        }
    };
    PlaneModel {
        plane: model.plane,
        a: t * model.a * inverse,
        b: t * model.b,
        trim: Trim { alpha0: 0.0, ..trim },
    }
}

fn turn(i: usize, j: usize, sin: f64, cos: f64) -> Matrix4<f64> {
    let mut t = Matrix4::identity();
    t[(i, i)] = cos;
    t[(j, j)] = cos;
    t[(i, j)] = sin;
    t[(j, i)] = -sin;
    t
}
