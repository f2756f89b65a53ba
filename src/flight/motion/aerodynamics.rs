//! What the air and the engine do to an aircraft, near a trim and some way beyond.
//!
//! From coefficients: dynamic pressure and Mach number follow the airspeed, C_L, C_D and C_Y act along the stability axes of
//! the moment (turned with α, not with β), drag is the parabola of [`at_lift`](crate::flight::aircraft::condition::at_lift), thrust goes
//! with Vⁿ along the *x* axis of the trim. From dimensional derivatives: forces are linear in the disturbances.
//! Either way the first derivative at the trim is the linear model's. Density is that of the trim's altitude, for
//! A knows no altitude.

use crate::flight::aircraft::coefficients::{Airframe, LateralCoefficients, LongitudinalCoefficients};
use crate::flight::aircraft::condition::SteadyFlight;
use crate::flight::aircraft::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use crate::flight::aircraft::inertia::Inertia;
use crate::flight::aircraft::plane::Trim;
use crate::flight::aircraft::real::Real;

/// Controls as they stand away from the trim: elevator δe \[rad\], throttle δt, aileron δa and rudder δr \[rad\], with the
/// signs of [`crate::flight`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Controls<T = f64> {
    /// δe \[rad\], trailing edge down positive.
    pub elevator: T,
    /// δt, more thrust positive.
    pub throttle: T,
    /// δa \[rad\], right aileron up positive.
    pub aileron: T,
    /// δr \[rad\], trailing edge left positive.
    pub rudder: T,
}

/// Motion through the air, in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airflow<T = f64> {
    /// Velocity less that of the air \[m/s\].
    pub velocity: [T; 3],
    /// Rates p, q, r \[rad/s\].
    pub rates: [T; 3],
}

/// Forces over mass and moments over the inertia of their axis, in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads<T = f64> {
    /// X/m, Y/m, Z/m \[m/s²\].
    pub force: [T; 3],
    /// L/Ix, M/Iy, N/Iz \[rad/s²\].
    pub moment: [T; 3],
    /// The terms that depend on u̇ and ẇ.
    pub lag: Lag<T>,
}

/// Loads in proportion to a rate s = a u̇ + b ẇ: the downwash that reaches the tail late.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag<T = f64> {
    /// a and b.
    pub of: [T; 2],
    /// X/m and Z/m for s = 1.
    pub force: [T; 2],
    /// M/Iy for s = 1.
    pub moment: T,
}

/// Loads about one trim.
#[expect(clippy::large_enum_variant, reason = "there is one of it at a time")]
#[derive(Clone, Debug, PartialEq)]
pub enum Aerodynamics {
    /// From coefficients.
    Coefficients(CoefficientLoads),
    /// Linear, from dimensional derivatives.
    Derivatives(DerivativeLoads),
}

impl Aerodynamics {
    /// The loads; `thrust` is that of the trim over the mass \[m/s²\].
    pub fn loads<T: Real>(&self, air: &Airflow<T>, controls: &Controls<T>, thrust: T) -> Loads<T> {
        match self {
            Self::Coefficients(model) => model.loads(air, controls, thrust),
            Self::Derivatives(model) => model.loads(air, controls, thrust),
        }
    }

    /// Whether it knows lateral forces.
    pub const fn has_lateral(&self) -> bool {
        match self {
            Self::Coefficients(model) => model.lateral.is_some(),
            Self::Derivatives(model) => model.lateral.is_some(),
        }
    }
}

/// Loads from coefficients, in the stability axes of the trim.
#[derive(Clone, Debug, PartialEq)]
pub struct CoefficientLoads {
    /// Mass, geometry and engine, with the knobs applied.
    pub airframe: Airframe,
    /// Inertia in the same axes.
    pub inertia: Inertia,
    /// The steady flight.
    pub flight: SteadyFlight,
    /// Longitudinal coefficients there.
    pub longitudinal: LongitudinalCoefficients,
    /// Lateral coefficients there.
    pub lateral: Option<LateralCoefficients>,
    /// g \[m/s²\] in the source's rounding.
    pub gravity: f64,
}

impl CoefficientLoads {
    fn loads<T: Real>(&self, air: &Airflow<T>, controls: &Controls<T>, thrust: T) -> Loads<T> {
        let Self { airframe, inertia, flight, longitudinal: c, .. } = self;
        let ([u, v, w], [p, q, r]) = (air.velocity, air.rates);
        let v0 = flight.condition.speed;
        let in_plane = (u * u + w * w).sqrt();
        let speed = (u * u + v * v + w * w).sqrt();
        let (alpha, beta) = (w.atan2(u), v.atan2(in_plane));
        let (sin, cos) = (w / in_plane, u / in_plane);
        let speed_ratio = speed / v0;
        let mach_change = (speed_ratio - 1.0) * flight.mach;
        // q̄S/m and the time c̄/2V
        let force = speed * speed * (0.5 * flight.density * airframe.s / airframe.mass);
        let chord_time = T::from(0.5 * airframe.c) / speed;
        let pitch_rate = q * chord_time;

        // C_D on the parabola of C_L(α): C_D₁ + C_Dα Δα + k (C_Lα Δα)², k = C_Dα/(2 C_L C_Lα)
        let by_alpha = alpha * c.cl_alpha;
        let slope = c.cl * c.cl_alpha;
        let k = if slope == 0.0 { 0.0 } else { c.cd_alpha / (2.0 * slope) };
        let cl_static = by_alpha + mach_change * c.cl_m;
        let cl = cl_static + pitch_rate * c.cl_q + controls.elevator * c.cl_de + c.cl;
        let cd = alpha * c.cd_alpha
            + by_alpha * by_alpha * k
            + mach_change * c.cd_m
            + controls.elevator * c.cd_de
            + c.cd;
        let cm = alpha * c.cm_alpha
            + pitch_rate * c.cm_q
            + mach_change * c.cm_m
            + controls.elevator * c.cm_de
            + self.cm_trim();
        let (lift, drag) = (force * cl, force * cd);
        // (T₁ + T_δt δt)(V/V₀)ⁿ
        let thrust = (thrust + controls.throttle * (airframe.thrust_per_throttle / airframe.mass))
            * speed_ratio.powf(airframe.thrust_exponent);
        let [rest_x, rest_z] = self.remainder();
        let per_iy = airframe.mass / inertia.iy;

        let (mut side, mut roll, mut yaw) = (T::from(0.0), T::from(0.0), T::from(0.0));
        if let Some(l) = &self.lateral {
            let span_time = T::from(0.5 * airframe.b) / speed;
            let (p, r) = (p * span_time, r * span_time);
            // as in at_lift: Cl_r and Cn_p go with C_L/4 and −C_L/8
            let (cl_r, cn_p) = (cl_static * 0.25 + l.cl_r, -cl_static * 0.125 + l.cn_p);
            let (da, dr) = (controls.aileron, controls.rudder);
            let moment = force * (airframe.mass * airframe.b);
            side = force * (beta * l.cy_beta + p * l.cy_p + r * l.cy_r + da * l.cy_da + dr * l.cy_dr);
            roll = moment * (beta * l.cl_beta + p * l.cl_p + r * cl_r + da * l.cl_da + dr * l.cl_dr);
            yaw = moment * (beta * l.cn_beta + p * cn_p + r * l.cn_r + da * l.cn_da + dr * l.cn_dr);
        }
        let lag_lift = force * chord_time * c.cl_alphadot;
        Loads {
            // X = T − D cos α + L sin α,  Z = −D sin α − L cos α
            force: [thrust - drag * cos + lift * sin + rest_x, side, -drag * sin - lift * cos + rest_z],
            // M = q̄Sc̄ Cm + T z_T
            moment: [
                roll / inertia.ix,
                (force * cm * airframe.c + thrust * airframe.thrust_offset) * per_iy,
                yaw / inertia.iz,
            ],
            // α̇ = (u ẇ − w u̇)/(u² + w²)
            lag: Lag {
                of: [-sin / in_plane, cos / in_plane],
                force: [lag_lift * sin, -lag_lift * cos],
                moment: force * chord_time * (c.cm_alphadot * airframe.c * per_iy),
            },
        }
    }

    /// Cm of the air that balances the thrust line in the trim: −C_T z_T/c̄.
    fn cm_trim(&self) -> f64 {
        let c = &self.longitudinal;
        let c_t = c.cd + c.cl * self.flight.condition.gamma0.tan();
        -c_t * self.airframe.thrust_offset / self.airframe.c
    }

    /// What the source's rounded C_L leaves of the weight over the mass, along x and z \[m/s²\]: up to 1.5 % of g (the
    /// Navion's 0.41 for 0.406). It is vertical in the trim, of constant size, and turns with the body, so that it is in
    /// no derivative.
    pub fn remainder(&self) -> [f64; 2] {
        let (c, flight) = (&self.longitudinal, &self.flight);
        let lift = flight.dynamic_pressure * self.airframe.s / self.airframe.mass * c.cl;
        let (gamma0, g) = (flight.condition.gamma0, self.gravity);
        let missing = g * gamma0.cos() - lift;
        [missing * gamma0.tan(), -missing]
    }
}

/// Loads linear in the disturbances, in the axes of their source.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeLoads {
    /// The steady flight.
    pub trim: Trim,
    /// Longitudinal derivatives.
    pub longitudinal: LongitudinalDerivatives,
    /// Lateral derivatives, unprimed.
    pub lateral: Option<LateralDerivatives>,
}

impl DerivativeLoads {
    fn loads<T: Real>(&self, air: &Airflow<T>, controls: &Controls<T>, thrust: T) -> Loads<T> {
        let ([u, v, w], [p, q, r]) = (air.velocity, air.rates);
        let d = &self.longitudinal;
        let (u, w) = (u - self.trim.u0(), w - self.trim.w0());
        let Controls { elevator: de, throttle: dt, aileron: da, rudder: dr } = *controls;
        let (mut side, mut roll, mut yaw) = (T::from(0.0), T::from(0.0), T::from(0.0));
        if let Some(d) = &self.lateral {
            side = v * d.y_v + p * d.y_p + r * d.y_r + da * d.y_da + dr * d.y_dr;
            roll = v * d.l_v + p * d.l_p + r * d.l_r + da * d.l_da + dr * d.l_dr;
            yaw = v * d.n_v + p * d.n_p + r * d.n_r + da * d.n_da + dr * d.n_dr;
        }
        let x = u * d.x_u + w * d.x_w + q * d.x_q + de * d.x_de + dt * d.x_dt;
        let z = u * d.z_u + w * d.z_w + q * d.z_q + de * d.z_de + dt * d.z_dt;
        // Z of the trim carries the weight
        let weight = self.trim.gravity * self.trim.theta0().cos();
        Loads {
            force: [x + thrust, side, z - weight],
            moment: [roll, u * d.m_u + w * d.m_w + q * d.m_q + de * d.m_de + dt * d.m_dt, yaw],
            // Zẇ ẇ and Mẇ ẇ
            lag: Lag {
                of: [T::from(0.0), T::from(1.0)],
                force: [T::from(0.0), T::from(d.z_wdot)],
                moment: T::from(d.m_wdot),
            },
        }
    }
}
