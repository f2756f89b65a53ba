//! The yaw damper of a textbook: Franklin, Powell and Emami-Naeini, example 10.2.

use eigenwing::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use nalgebra::{Matrix4, Matrix4x2, Vector4};

/// The matrices of Franklin, Powell and Emami-Naeini's example 10.2 (Mach 0.8, 40,000 ft), whose sideslip is an angle.
pub fn franklin() -> PlaneModel {
    let (speed, gravity) = (235.9, 9.81);
    let a = Matrix4::new(
        -0.0558, -0.9968, 0.0802, 0.0415, 0.598, -0.115, -0.0318, 0.0, -3.05, 0.388, -0.465, 0.0, 0.0,
        0.0805, 1.0, 0.0,
    );
    // [β, r, p, φ] ↦ [v, p, r, φ]
    let order = [0, 2, 1, 3];
    let size = |i: usize| if i == 0 { speed } else { 1.0 };
    let b = Vector4::new(0.0073, -0.475, 0.153, 0.0);
    PlaneModel {
        plane: Plane::Lateral,
        a: Matrix4::from_fn(|i, j| a[(order[i], order[j])] * size(i) / size(j)),
        b: Matrix4x2::from_fn(|i, j| if j == 1 { b[order[i]] * size(i) } else { 0.0 }),
        trim: Trim { speed, alpha0: 0.0, gamma0: 0.0, gravity },
        further: None,
    }
}
