//! The six equations of motion of a rigid body over a flat Earth at rest, and its attitude by a unit quaternion.
//!
//! Etkin & Reid, *Dynamics of Flight*, 3rd ed., ch. 4; quaternions after Stevens, Lewis & Johnson, *Aircraft Control and
//! Simulation*, 3rd ed., §1.8. Body axes *x* forward, *y* right, *z* down; Earth axes north, east, down, where north is
//! the direction of the trimmed flight. The equations hold at every attitude: Euler angles are only read off.

use crate::flight::aircraft::inertia::Inertia;
use crate::flight::aircraft::real::Real;

/// Attitude of the body as a quaternion that turns body axes into Earth axes. Only its direction counts; a unit one stays
/// one to the integrator's error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude<T = f64> {
    /// cos(μ/2) of the turn by the angle μ.
    pub w: T,
    /// The turn's axis times sin(μ/2), along x.
    pub x: T,
    /// Along y.
    pub y: T,
    /// Along z.
    pub z: T,
}

impl<T: Real> Attitude<T> {
    /// From bank φ, pitch θ and heading ψ \[rad\], turned in the order ψ, θ, φ.
    pub fn from_euler(phi: T, theta: T, psi: T) -> Self {
        let [(sin_phi, cos_phi), (sin_theta, cos_theta), (sin_psi, cos_psi)] =
            [phi, theta, psi].map(|angle| (angle * 0.5).sin_cos());
        Self {
            w: cos_phi * cos_theta * cos_psi + sin_phi * sin_theta * sin_psi,
            x: sin_phi * cos_theta * cos_psi - cos_phi * sin_theta * sin_psi,
            y: cos_phi * sin_theta * cos_psi + sin_phi * cos_theta * sin_psi,
            z: cos_phi * cos_theta * sin_psi - sin_phi * sin_theta * cos_psi,
        }
    }

    /// Bank φ, pitch θ and heading ψ \[rad\]: θ within ±90°, the others within ±180°.
    pub fn euler(&self) -> [T; 3] {
        let m = self.matrix();
        // sin θ = −m₃₁,  tan φ = m₃₂/m₃₃,  tan ψ = m₂₁/m₁₁; θ by atan2, which stands rounding at ±90°
        let level = (m[0][0] * m[0][0] + m[1][0] * m[1][0]).sqrt();
        [m[2][1].atan2(m[2][2]), (-m[2][0]).atan2(level), m[1][0].atan2(m[0][0])]
    }

    /// Rates φ̇ and θ̇ of bank and pitch that belong to a rate of the quaternion \[rad/s\]; not finite at θ = ±90°.
    pub fn euler_rates(&self, rate: &Self) -> [T; 2] {
        let n = self.square();
        // k, the Earth's z in body axes, and its rate: m₃₁ = 2(xz − wy)/n and so on
        let [k, product] = [self.down(), self.down_product(rate)];
        let n_rate = (self.w * rate.w + self.x * rate.x + self.y * rate.y + self.z * rate.z) * 2.0;
        let [x_rate, y_rate, z_rate] = [0, 1, 2].map(|i| (product[i] - k[i] * n_rate) / n);
        let level = k[1] * k[1] + k[2] * k[2];
        // φ = atan2(k_y, k_z),  sin θ = −k_x
        [(y_rate * k[2] - z_rate * k[1]) / level, -x_rate / level.sqrt()]
    }

    /// A vector of the body in Earth axes.
    pub fn to_earth(&self, body: [T; 3]) -> [T; 3] {
        self.matrix().map(|row| row[0] * body[0] + row[1] * body[1] + row[2] * body[2])
    }

    /// A vector of the Earth in body axes.
    pub fn to_body(&self, earth: [T; 3]) -> [T; 3] {
        let m = self.matrix();
        [0, 1, 2].map(|i| m[0][i] * earth[0] + m[1][i] * earth[1] + m[2][i] * earth[2])
    }

    /// The vertical, downward, as a unit vector in body axes: \[−sin θ, cos θ sin φ, cos θ cos φ\].
    pub fn down(&self) -> [T; 3] {
        let Self { w, x, y, z } = *self;
        let n = self.square();
        let squares = w * w - x * x - y * y + z * z;
        [(x * z - w * y) * 2.0 / n, (y * z + w * x) * 2.0 / n, squares / n]
    }

    /// The rate of n k, k as [`Attitude::down`] and n = |quaternion|².
    fn down_product(&self, rate: &Self) -> [T; 3] {
        let (a, b) = (self, rate);
        let squares = a.w * b.w - a.x * b.x - a.y * b.y + a.z * b.z;
        [
            (b.x * a.z + a.x * b.z - b.w * a.y - a.w * b.y) * 2.0,
            (b.y * a.z + a.y * b.z + b.w * a.x + a.w * b.x) * 2.0,
            squares * 2.0,
        ]
    }

    /// Rate of the quaternion while the body turns at ω = p, q, r \[rad/s\].
    pub fn rate(&self, [p, q, r]: [T; 3]) -> Self {
        let Self { w, x, y, z } = *self;
        // q̇ = ½ q ⊗ (0, ω)
        Self {
            w: (-x * p - y * q - z * r) * 0.5,
            x: (w * p + y * r - z * q) * 0.5,
            y: (w * q + z * p - x * r) * 0.5,
            z: (w * r + x * q - y * p) * 0.5,
        }
    }

    /// The same direction as a unit quaternion.
    pub fn normalised(&self) -> Self {
        let length = self.square().sqrt();
        Self { w: self.w / length, x: self.x / length, y: self.y / length, z: self.z / length }
    }

    /// Sum of the squares of its four numbers, 1 for a unit quaternion.
    pub fn square(&self) -> T {
        self.w * self.w + self.x * self.x + self.y * self.y + self.z * self.z
    }

    /// Rows of the matrix that turns body axes into Earth axes, whatever the length of the quaternion.
    fn matrix(&self) -> [[T; 3]; 3] {
        let Self { w, x, y, z } = *self;
        let twice = T::from(2.0) / self.square();
        let one = T::from(1.0);
        [
            [one - (y * y + z * z) * twice, (x * y - w * z) * twice, (x * z + w * y) * twice],
            [(x * y + w * z) * twice, one - (x * x + z * z) * twice, (y * z - w * x) * twice],
            [(x * z - w * y) * twice, (y * z + w * x) * twice, one - (x * x + y * y) * twice],
        ]
    }
}

/// Everything that moves, or its rate in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T = f64> {
    /// Velocity over the ground u, v, w in body axes \[m/s\].
    pub velocity: [T; 3],
    /// Rates p, q, r about the body axes \[rad/s\].
    pub rates: [T; 3],
    /// Attitude.
    pub attitude: Attitude<T>,
    /// Position north, east and up \[m\].
    pub position: [T; 3],
}

impl<T: Real> State<T> {
    /// All thirteen numbers, for an integrator.
    pub fn to_array(&self) -> [T; 13] {
        let ([u, v, w], [p, q, r], Attitude { w: q0, x, y, z }) = (self.velocity, self.rates, self.attitude);
        let [north, east, up] = self.position;
        [u, v, w, p, q, r, q0, x, y, z, north, east, up]
    }

    /// The inverse of [`State::to_array`].
    pub fn from_array([u, v, w, p, q, r, q0, x, y, z, north, east, up]: [T; 13]) -> Self {
        Self {
            velocity: [u, v, w],
            rates: [p, q, r],
            attitude: Attitude { w: q0, x, y, z },
            position: [north, east, up],
        }
    }

    /// The six equations with their kinematics: the rate of the state under a specific force, all but gravity \[m/s²\],
    /// and a moment \[N m\], both in body axes (Etkin & Reid, eqs. 4.7,1 to 4.7,4).
    pub fn rate(&self, inertia: &Inertia, gravity: f64, force: [T; 3], moment: [T; 3]) -> Self {
        let ([u, v, w], [p, q, r]) = (self.velocity, self.rates);
        let [gx, gy, gz] = self.attitude.down().map(|k| k * gravity);
        let [x, y, z] = force;
        let [north, east, down] = self.attitude.to_earth(self.velocity);
        Self {
            // V̇ = F/m + g − ω × V
            velocity: [x + gx - (q * w - r * v), y + gy - (r * u - p * w), z + gz - (p * v - q * u)],
            rates: inertia.angular_acceleration(self.rates, moment),
            attitude: self.attitude.rate(self.rates),
            position: [north, east, -down],
        }
    }
}
