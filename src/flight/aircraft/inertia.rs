//! Moments of inertia, and how a body turns under a moment.

use super::real::{Real, record};

/// Moments of inertia of a body with a plane of symmetry, about axes in that plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia<T = f64> {
    /// Ix \[kg m²\], positive.
    pub ix: T,
    /// Iy \[kg m²\], positive.
    pub iy: T,
    /// Iz \[kg m²\], positive.
    pub iz: T,
    /// Ixz = ∫ x z dm \[kg m²\], Ixz² < Ix Iz.
    pub ixz: T,
}
record!(Inertia: ix iy iz ixz);

impl Inertia {
    /// Angular acceleration ṗ, q̇, ṙ \[rad/s²\] from rates \[rad/s\] and moments L, M, N \[N m\] about the body axes
    /// (Etkin & Reid, eq. 4.7,2).
    pub fn angular_acceleration<T: Real>(&self, [p, q, r]: [T; 3], [l, m, n]: [T; 3]) -> [T; 3] {
        let Self { ix, iy, iz, ixz } = *self;
        // Ix ṗ − Ixz ṙ = L + (Iy − Iz) q r + Ixz p q
        let roll = l + q * r * (iy - iz) + p * q * ixz;
        // Iz ṙ − Ixz ṗ = N + (Ix − Iy) p q − Ixz q r
        let yaw = n + p * q * (ix - iy) - q * r * ixz;
        // Iy q̇ = M + (Iz − Ix) p r − Ixz (p² − r²)
        let pitch = m + p * r * (iz - ix) - (p * p - r * r) * ixz;
        let determinant = ix * iz - ixz * ixz;
        [(roll * iz + yaw * ixz) / determinant, pitch / iy, (roll * ixz + yaw * ix) / determinant]
    }

    /// The largest principal moment over the sum of the other two: below 1 in every body, 1 in one that is flat.
    pub fn flatness(&self) -> f64 {
        let Self { ix, iy, iz, ixz } = *self;
        // About x and z: ½ (Ix + Iz) ± ½ √((Ix − Iz)² + 4 Ixz²)
        let (sum, difference) = (ix + iz, (ix - iz).hypot(2.0 * ixz));
        let (large, small) = (0.5 * (sum + difference), 0.5 * (sum - difference));
        (iy / sum).max(large / (iy + small))
    }
}
