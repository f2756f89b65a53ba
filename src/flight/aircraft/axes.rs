//! The same motion in other axes and units: exact changes of variables, which change no eigenvalue.

use nalgebra::{Matrix4, Vector4};

use super::plane::{Plane, PlaneModel, Trim};

/// A model in the stability axes of its trim, x along the steady velocity: what the textbooks' formulas are written in.
///
/// A formula that takes this type can't be given body axes.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityAxes(PlaneModel);

impl StabilityAxes {
    /// The model turned into its stability axes.
    pub fn of(model: &PlaneModel) -> Self {
        Self(in_axes_at(model, 0.0))
    }

    /// The model.
    pub const fn model(&self) -> &PlaneModel {
        &self.0
    }
}

/// The model in body axes whose x axis stands at an angle of attack α₀ \[rad\] to the steady velocity:
/// A₂ = T A T⁻¹ and B₂ = T B.
pub fn in_axes_at(model: &PlaneModel, alpha0: f64) -> PlaneModel {
    let trim = Trim { alpha0, ..model.trim };
    // Turn about y from the old x axis down to the new one.
    let (sin, cos) = (model.trim.alpha0 - alpha0).sin_cos();
    let (t, inverse) = match model.plane {
        // [u; w]₂ = [cos, sin; −sin, cos] [u; w];  q and θ are the same
        Plane::Longitudinal => (rotation(0, 1, sin, cos), rotation(0, 1, -sin, cos)),
        // [p; r]₂ = the same turn;  φ₂ cos θ₂ = φ cos θ₁: both are the turn about the horizontal of the flight path
        Plane::Lateral => {
            let bank = model.trim.theta0().cos() / trim.theta0().cos();
            let scale = |k: f64| Matrix4::from_diagonal(&Vector4::new(1.0, 1.0, 1.0, k));
            (scale(bank) * rotation(1, 2, sin, cos), rotation(1, 2, -sin, cos) * scale(1.0 / bank))
        }
    };
    PlaneModel { plane: model.plane, a: t * model.a * inverse, b: t * model.b, trim, further: None }
}

fn rotation(i: usize, j: usize, sin: f64, cos: f64) -> Matrix4<f64> {
    let mut t = Matrix4::identity();
    t[(i, i)] = cos;
    t[(j, j)] = cos;
    t[(i, j)] = sin;
    t[(j, i)] = -sin;
    t
}
