//! Dimensional derivatives: forces over mass and moments over inertia for a unit of each state or input, SI.
//!
//! The names are those of McRuer, Ashkenas & Graham, *Aircraft Dynamics and Automatic Control* (1973), and Nelson,
//! *Flight Stability and Automatic Control*, 2nd ed., ch. 3. Axes are those of the trim they are used
//! with: body axes where its α₀ is not zero.

use nalgebra::{Matrix4, Matrix4x2};

use super::coefficients::{Airframe, Field, LateralCoefficients, LongitudinalCoefficients, PlanarInertia};
use super::condition::SteadyFlight;
use super::plane::{Plane, PlaneModel, Trim};
use super::real::{Real, record};

/// Longitudinal derivatives, forces over m and moments over Iy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LongitudinalDerivatives<T = f64> {
    /// Speed damping Xu \[1/s\], negative: faster means more drag.
    pub x_u: T,
    /// Xw \[1/s\].
    pub x_w: T,
    /// Xq \[m/s\], small and usually left out.
    pub x_q: T,
    /// Elevator drag X_δe \[m/s²\].
    pub x_de: T,
    /// Throttle X_δt \[m/s²\], forward positive.
    pub x_dt: T,
    /// Zu \[1/s\], negative: faster lifts.
    pub z_u: T,
    /// Heave damping Zw \[1/s\], negative.
    pub z_w: T,
    /// Z_ẇ, without dimension.
    pub z_wdot: T,
    /// Zq \[m/s\].
    pub z_q: T,
    /// Elevator lift Z_δe \[m/s²\], negative: trailing edge down lifts.
    pub z_de: T,
    /// Throttle Z_δt \[m/s²\], downward positive.
    pub z_dt: T,
    /// Speed stability Mu \[1/(m s)\]; negative is tuck.
    pub m_u: T,
    /// Pitch stiffness Mw \[1/(m s)\], negative: a gust that raises α is met by a nose-down moment.
    pub m_w: T,
    /// M_ẇ \[1/m\], negative with a tail aft.
    pub m_wdot: T,
    /// Pitch damping Mq \[1/s\], negative.
    pub m_q: T,
    /// Elevator power M_δe \[1/s²\], negative: trailing edge down pitches the nose down.
    pub m_de: T,
    /// Throttle M_δt \[1/s²\], nose-up positive.
    pub m_dt: T,
}
record!(LongitudinalDerivatives:
    x_u x_w x_q x_de x_dt z_u z_w z_wdot z_q z_de z_dt m_u m_w m_wdot m_q m_de m_dt
);

/// Lateral derivatives by sideslip velocity v, forces over m and moments over Ix and Iz, unprimed.
///
/// Unprimed: L is the rolling moment over Ix, as if Ixz were zero; the coupling enters in [`lateral_model`] only.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LateralDerivatives<T = f64> {
    /// Side force Yv \[1/s\], negative.
    pub y_v: T,
    /// Yp \[m/s\].
    pub y_p: T,
    /// Yr \[m/s\].
    pub y_r: T,
    /// Y_δa \[m/s²\].
    pub y_da: T,
    /// Y_δr \[m/s²\], positive.
    pub y_dr: T,
    /// Dihedral effect Lv \[1/(m s)\], negative.
    pub l_v: T,
    /// Roll damping Lp \[1/s\], negative.
    pub l_p: T,
    /// Lr \[1/s\], positive.
    pub l_r: T,
    /// Aileron power L_δa \[1/s²\], positive: the right aileron up rolls right wing down.
    pub l_da: T,
    /// L_δr \[1/s²\].
    pub l_dr: T,
    /// Weathercock stability Nv \[1/(m s)\], positive.
    pub n_v: T,
    /// Np \[1/s\].
    pub n_p: T,
    /// Yaw damping Nr \[1/s\], negative.
    pub n_r: T,
    /// N_δa \[1/s²\].
    pub n_da: T,
    /// Rudder power N_δr \[1/s²\], negative.
    pub n_dr: T,
    /// Ixz/Ix in the axes of the derivatives; zero where a source gives primed derivatives and no inertia.
    pub ixz_over_ix: T,
    /// Ixz/Iz in the axes of the derivatives.
    pub ixz_over_iz: T,
}
record!(LateralDerivatives:
    y_v y_p y_r y_da y_dr l_v l_p l_r l_da l_dr n_v n_p n_r n_da n_dr ixz_over_ix ixz_over_iz
);

/// A dimensional derivative by its key, with the power of length in its unit for conversion.
#[derive(Clone, Copy, Debug)]
pub struct DimensionalField<T> {
    /// Key, meaning of `required`, and place.
    pub field: Field<T>,
    /// Power of length in its unit: 1 for m/s and m/s², −1 for 1/(m s), 0 for 1/s.
    pub length_power: i32,
}

const fn row<T>(
    key: &'static str,
    required: bool,
    length_power: i32,
    of: fn(&mut T) -> &mut f64,
) -> DimensionalField<T> {
    DimensionalField { field: Field { key, required, of }, length_power }
}

/// Every longitudinal derivative by its key.
pub const LONGITUDINAL_DERIVATIVES: [DimensionalField<LongitudinalDerivatives>; 17] = [
    row("Xu", true, 0, |d| &mut d.x_u),
    row("Xw", true, 0, |d| &mut d.x_w),
    row("Xq", false, 1, |d| &mut d.x_q),
    row("Xde", false, 1, |d| &mut d.x_de),
    row("Xdt", false, 1, |d| &mut d.x_dt),
    row("Zu", true, 0, |d| &mut d.z_u),
    row("Zw", true, 0, |d| &mut d.z_w),
    row("Zwdot", false, 0, |d| &mut d.z_wdot),
    row("Zq", false, 1, |d| &mut d.z_q),
    row("Zde", false, 1, |d| &mut d.z_de),
    row("Zdt", false, 1, |d| &mut d.z_dt),
    row("Mu", false, -1, |d| &mut d.m_u),
    row("Mw", true, -1, |d| &mut d.m_w),
    row("Mwdot", false, -1, |d| &mut d.m_wdot),
    row("Mq", true, 0, |d| &mut d.m_q),
    row("Mde", true, 0, |d| &mut d.m_de),
    row("Mdt", false, 0, |d| &mut d.m_dt),
];

/// Every lateral derivative by its key; the two inertia ratios come from the airframe.
pub const LATERAL_DERIVATIVES: [DimensionalField<LateralDerivatives>; 15] = [
    row("Yv", true, 0, |d| &mut d.y_v),
    row("Yp", false, 1, |d| &mut d.y_p),
    row("Yr", false, 1, |d| &mut d.y_r),
    row("Yda", false, 1, |d| &mut d.y_da),
    row("Ydr", false, 1, |d| &mut d.y_dr),
    row("Lv", true, -1, |d| &mut d.l_v),
    row("Lp", true, 0, |d| &mut d.l_p),
    row("Lr", true, 0, |d| &mut d.l_r),
    row("Lda", false, 0, |d| &mut d.l_da),
    row("Ldr", false, 0, |d| &mut d.l_dr),
    row("Nv", true, -1, |d| &mut d.n_v),
    row("Np", true, 0, |d| &mut d.n_p),
    row("Nr", true, 0, |d| &mut d.n_r),
    row("Nda", false, 0, |d| &mut d.n_da),
    row("Ndr", false, 0, |d| &mut d.n_dr),
];

impl<T: Real> LongitudinalDerivatives<T> {
    /// From coefficients in stability axes (Nelson, ch. 3; McRuer, Ashkenas & Graham, ch. 4; thrust terms after
    /// Etkin & Reid, ch. 5, to first order in the thrust line's offset).
    pub fn from_coefficients(
        c: &LongitudinalCoefficients<T>,
        airframe: &Airframe<T>,
        flight: &SteadyFlight<T>,
    ) -> Self {
        let (v, q_bar, mach) = (flight.condition.speed, flight.dynamic_pressure, flight.mach);
        let Airframe { mass, s, c: chord, iy, .. } = *airframe;
        let (force, moment) = (q_bar * s / mass, q_bar * s * chord / iy);
        let half_time = T::from(chord) / (v * 2.0);
        // T = D + W sin γ₀, so C_T = C_D + C_L tan γ₀; Cm_T = C_T z_T/c̄, balanced by the air
        let c_t = c.cd + c.cl * flight.condition.gamma0.tan();
        let cm_t = c_t * airframe.thrust_offset / chord;
        let n = airframe.thrust_exponent;
        let (zero, throttle) = (T::from(0.0), T::from(airframe.thrust_per_throttle));
        Self {
            // Xu = −(q̄S/mV)(2 C_D + M C_D_M − n C_T)
            x_u: -force / v * (c.cd * 2.0 + mach * c.cd_m - c_t * n),
            // Xw = (q̄S/mV)(C_L − C_Dα)
            x_w: force / v * (c.cl - c.cd_alpha),
            x_q: zero,
            // X_δe = −(q̄S/m) C_Dδe
            x_de: -force * c.cd_de,
            // X_δt = T_δt/m
            x_dt: throttle / mass,
            // Zu = −(q̄S/mV)(2 C_L + M C_L_M)
            z_u: -force / v * (c.cl * 2.0 + mach * c.cl_m),
            // Zw = −(q̄S/mV)(C_Lα + C_D)
            z_w: -force / v * (c.cl_alpha + c.cd),
            // Zẇ = −(q̄S/mV)(c̄/2V) C_Lα̇
            z_wdot: -force / v * half_time * c.cl_alphadot,
            // Zq = −(q̄S/m)(c̄/2V) C_Lq
            z_q: -force * half_time * c.cl_q,
            // Z_δe = −(q̄S/m) C_Lδe
            z_de: -force * c.cl_de,
            z_dt: zero,
            // Mu = (q̄Sc̄/IyV)(M Cm_M + (n − 2) Cm_T)
            m_u: moment / v * (mach * c.cm_m + cm_t * (n - 2.0)),
            // Mw = (q̄Sc̄/IyV) Cmα
            m_w: moment / v * c.cm_alpha,
            // Mẇ = (q̄Sc̄/IyV)(c̄/2V) Cmα̇
            m_wdot: moment / v * half_time * c.cm_alphadot,
            // Mq = (q̄Sc̄/Iy)(c̄/2V) Cmq
            m_q: moment * half_time * c.cm_q,
            // M_δe = (q̄Sc̄/Iy) Cmδe
            m_de: moment * c.cm_de,
            // M_δt = T_δt z_T/Iy
            m_dt: throttle * airframe.thrust_offset / iy,
        }
    }
}

impl<T: Real> LateralDerivatives<T> {
    /// From coefficients in stability axes with the inertia in the same axes (Nelson, ch. 3).
    pub fn from_coefficients(
        c: &LateralCoefficients<T>,
        airframe: &Airframe<T>,
        inertia: &PlanarInertia<T>,
        flight: &SteadyFlight<T>,
    ) -> Self {
        let (v, q_bar) = (flight.condition.speed, flight.dynamic_pressure);
        let Airframe { mass, s, b, .. } = *airframe;
        let force = q_bar * s / mass;
        let (roll, yaw) = (q_bar * s * b / inertia.ix, q_bar * s * b / inertia.iz);
        let half_time = T::from(b) / (v * 2.0);
        Self {
            // Yv = (q̄S/mV) CYβ,  Yp = (q̄S/m)(b/2V) CYp
            y_v: force / v * c.cy_beta,
            y_p: force * half_time * c.cy_p,
            y_r: force * half_time * c.cy_r,
            y_da: force * c.cy_da,
            y_dr: force * c.cy_dr,
            // Lv = (q̄Sb/IxV) Clβ,  Lp = (q̄Sb/Ix)(b/2V) Clp
            l_v: roll / v * c.cl_beta,
            l_p: roll * half_time * c.cl_p,
            l_r: roll * half_time * c.cl_r,
            l_da: roll * c.cl_da,
            l_dr: roll * c.cl_dr,
            // Nv = (q̄Sb/IzV) Cnβ,  Np = (q̄Sb/Iz)(b/2V) Cnp
            n_v: yaw / v * c.cn_beta,
            n_p: yaw * half_time * c.cn_p,
            n_r: yaw * half_time * c.cn_r,
            n_da: yaw * c.cn_da,
            n_dr: yaw * c.cn_dr,
            ixz_over_ix: inertia.ixz / inertia.ix,
            ixz_over_iz: inertia.ixz / inertia.iz,
        }
    }

    /// From derivatives that are printed primed, the product of inertia already in them, so that it enters once:
    /// L = L′ − (Ixz/Ix) N′ and N = N′ − (Ixz/Iz) L′, the inverse of [`LateralDerivatives::primed`].
    pub fn from_primed(primed: &Self) -> Self {
        primed.with_product_of_inertia(-1.0, T::from(1.0))
    }

    /// The same with primed L′ and N′: L′ = (L + (Ixz/Ix) N) G, N′ = (N + (Ixz/Iz) L) G, G = 1/(1 − Ixz²/(Ix Iz))
    /// (McRuer, Ashkenas & Graham, ch. 4).
    pub fn primed(&self) -> Self {
        self.with_product_of_inertia(1.0, (T::from(1.0) - self.ixz_over_ix * self.ixz_over_iz).recip())
    }

    /// L + (Ixz/Ix) N and N + (Ixz/Iz) L, times G; with `sign` −1 the Ixz terms are taken away.
    fn with_product_of_inertia(&self, sign: f64, g: T) -> Self {
        let (ix, iz) = (self.ixz_over_ix * sign, self.ixz_over_iz * sign);
        let roll = |l: T, n: T| (l + ix * n) * g;
        let yaw = |l: T, n: T| (n + iz * l) * g;
        Self {
            l_v: roll(self.l_v, self.n_v),
            l_p: roll(self.l_p, self.n_p),
            l_r: roll(self.l_r, self.n_r),
            l_da: roll(self.l_da, self.n_da),
            l_dr: roll(self.l_dr, self.n_dr),
            n_v: yaw(self.l_v, self.n_v),
            n_p: yaw(self.l_p, self.n_p),
            n_r: yaw(self.l_r, self.n_r),
            n_da: yaw(self.l_da, self.n_da),
            n_dr: yaw(self.l_dr, self.n_dr),
            ..*self
        }
    }
}

/// ẋ = A x + B δ, x = \[u, w, q, θ\], δ = \[δe, δt\] (McRuer, Ashkenas & Graham, ch. 4, with the ẇ terms solved).
///
/// ```text
///     ⎡ Xu            Xw            Xq − W₀             −g cos θ₀      ⎤
/// A = ⎢ Zu/D          Zw/D          (U₀ + Zq)/D         −g sin θ₀/D    ⎥    D = 1 − Zẇ
///     ⎢ Mu + Mẇ Zu/D  Mw + Mẇ Zw/D  Mq + Mẇ (U₀ + Zq)/D  −Mẇ g sin θ₀/D ⎥
///     ⎣ 0             0             1                    0             ⎦
/// ```
///
/// Entries are not finite where D is zero.
pub fn longitudinal_model<T: Real>(d: &LongitudinalDerivatives<T>, trim: &Trim<T>) -> PlaneModel<T> {
    let (u0, w0, g) = (trim.u0(), trim.w0(), trim.gravity);
    let (zero, one) = (T::from(0.0), T::from(1.0));
    let (sin, cos) = trim.theta0().sin_cos();
    // D ẇ = Zu u + Zw w + (U₀ + Zq) q − g sin θ₀ θ + Zδ δ
    let denominator = one - d.z_wdot;
    let [w_u, w_w, w_q, w_theta] = [d.z_u, d.z_w, u0 + d.z_q, sin * -g].map(|z| z / denominator);
    let [w_de, w_dt] = [d.z_de, d.z_dt].map(|z| z / denominator);
    #[rustfmt::skip]
    let a = Matrix4::new(
        d.x_u,                d.x_w,                d.x_q - w0,           cos * -g,
        w_u,                  w_w,                  w_q,                  w_theta,
        d.m_u + d.m_wdot*w_u, d.m_w + d.m_wdot*w_w, d.m_q + d.m_wdot*w_q, d.m_wdot*w_theta,
        zero,                 zero,                 one,                  zero,
    );
    #[rustfmt::skip]
    let b = Matrix4x2::new(
        d.x_de,                 d.x_dt,
        w_de,                   w_dt,
        d.m_de + d.m_wdot*w_de, d.m_dt + d.m_wdot*w_dt,
        zero,                   zero,
    );
    PlaneModel { plane: Plane::Longitudinal, a, b, trim: *trim, further: None }
}

/// ẋ = A x + B δ, x = \[v, p, r, φ\], δ = \[δa, δr\] (McRuer, Ashkenas & Graham, ch. 4; primes as in
/// [`LateralDerivatives::primed`]).
///
/// ```text
///     ⎡ Yv   Yp + W₀   Yr − U₀   g cos θ₀ ⎤
/// A = ⎢ L′v  L′p       L′r       0        ⎥
///     ⎢ N′v  N′p       N′r       0        ⎥
///     ⎣ 0    1         tan θ₀    0        ⎦
/// ```
pub fn lateral_model<T: Real>(d: &LateralDerivatives<T>, trim: &Trim<T>) -> PlaneModel<T> {
    let (zero, one) = (T::from(0.0), T::from(1.0));
    let (u0, w0, theta0) = (trim.u0(), trim.w0(), trim.theta0());
    let d = d.primed();
    #[rustfmt::skip]
    let a = Matrix4::new(
        d.y_v, d.y_p + w0, d.y_r - u0,   theta0.cos() * trim.gravity,
        d.l_v, d.l_p,      d.l_r,        zero,
        d.n_v, d.n_p,      d.n_r,        zero,
        zero,  one,        theta0.tan(), zero,
    );
    #[rustfmt::skip]
    let b = Matrix4x2::new(
        d.y_da, d.y_dr,
        d.l_da, d.l_dr,
        d.n_da, d.n_dr,
        zero,   zero,
    );
    PlaneModel { plane: Plane::Lateral, a, b, trim: *trim, further: None }
}
