//! Steady flight: how fast, how high, how steep, and what lift that takes.

use thiserror::Error;

use super::atmosphere::{AtmosphereError, standard_air};
use super::coefficients::{Airframe, Coefficients};
use super::real::{Real, record};

/// Steepest flight path for which this page uses the equations of small disturbances \[rad\], 60°.
pub const STEEPEST_PATH: f64 = std::f64::consts::FRAC_PI_3;

/// The flight condition that a pilot chooses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightCondition<T = f64> {
    /// Geopotential altitude h \[m\].
    pub altitude: T,
    /// True airspeed V \[m/s\], positive.
    pub speed: T,
    /// Flight-path angle γ₀ \[rad\], climbing positive.
    pub gamma0: T,
}
record!(FlightCondition: altitude speed gamma0);

/// The steady flight in which a source gives its numbers. Changes are reckoned from here, so that at the reference
/// the source's own density, Mach number and C_L hold to the last digit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// The condition.
    pub condition: FlightCondition,
    /// Density ρ as the source has it \[kg/m³\].
    pub density: f64,
    /// Speed of sound as the source has it, V/M \[m/s\].
    pub sound_speed: f64,
    /// Angle of attack α₀ of the body x axis \[rad\]; it only turns inertias given in body axes.
    pub alpha0: f64,
    /// Mass for which the source gives C_L \[kg\].
    pub mass: f64,
    /// Acceleration of free fall g \[m/s²\] in the source's own rounding.
    pub gravity: f64,
}

/// How far from the reference the coefficients are taken to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Validity {
    /// Highest C_L before the stall.
    pub cl_max: f64,
    /// Lowest Mach number.
    pub mach_min: f64,
    /// Highest Mach number.
    pub mach_max: f64,
}

/// Why there is no such steady flight.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ConditionError {
    /// Speed zero, negative or not a number.
    NoSpeed {
        /// The speed asked for \[m/s\].
        speed: f64,
    },
    /// Too steep for these equations.
    TooSteep {
        /// The angle asked for \[°\].
        gamma0_deg: f64,
    },
    /// Outside the standard atmosphere.
    Altitude(#[from] AtmosphereError),
    /// Too slow: past the stall.
    Stall {
        /// C_L that would carry the weight.
        needed: f64,
        /// The largest there is.
        cl_max: f64,
        /// True airspeed \[m/s\].
        speed: f64,
    },
    /// Beyond the data.
    Mach {
        /// Mach number asked for.
        mach: f64,
        /// Lowest of the data.
        mach_min: f64,
        /// Highest of the data.
        mach_max: f64,
    },
    /// No angle of attack gives the lift.
    NoLiftSlope {
        /// The slope \[1/rad\].
        cl_alpha: f64,
    },
}

/// Steady flight, trimmed for lift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyFlight<T = f64> {
    /// The condition.
    pub condition: FlightCondition<T>,
    /// Density ρ \[kg/m³\].
    pub density: T,
    /// Mach number M.
    pub mach: T,
    /// Dynamic pressure q̄ = ½ ρ V² \[Pa\].
    pub dynamic_pressure: T,
    /// Trim lift coefficient C_L.
    pub cl: T,
    /// Change of the angle of attack from the reference \[rad\].
    pub alpha_change: T,
}

/// Steady flight with lift equal to W cos γ₀.
///
/// C_L is the source's, times how much more lift is needed: C_L = W cos γ₀/(q̄ S) up to the source's rounding. The
/// pitching moment is taken to be trimmed by the elevator.
pub fn steady_flight<T: Real>(
    condition: &FlightCondition<T>,
    reference: &Reference,
    validity: &Validity,
    airframe: &Airframe<T>,
    coefficients: &Coefficients<T>,
) -> Result<SteadyFlight<T>, ConditionError> {
    let FlightCondition { altitude, speed, gamma0 } = *condition;
    if !(speed.re().is_finite() && speed > 0.0) {
        return Err(ConditionError::NoSpeed { speed: speed.re() });
    }
    if gamma0.re().is_nan() || gamma0.abs() > STEEPEST_PATH {
        return Err(ConditionError::TooSteep { gamma0_deg: gamma0.re().to_degrees() });
    }
    let (air, air0) = (standard_air(altitude)?, standard_air(reference.condition.altitude)?);
    let density_ratio = air.density / air0.density;
    let speed_ratio = speed / reference.condition.speed;
    let density = density_ratio * reference.density;
    // C_L/C_L₀ = (m/m₀)(cos γ/cos γ₀)/((ρ/ρ₀)(V/V₀)²)
    let c = &coefficients.longitudinal;
    let weight_ratio = airframe.mass / reference.mass;
    let path_ratio = gamma0.cos() / reference.condition.gamma0.cos();
    let cl = c.cl * (weight_ratio * path_ratio / (density_ratio * speed_ratio * speed_ratio));
    if cl.re().is_nan() || cl > validity.cl_max {
        let (needed, speed) = (cl.re(), speed.re());
        return Err(ConditionError::Stall { needed, cl_max: validity.cl_max, speed });
    }
    let mach = speed / ((air.sound_speed / air0.sound_speed) * reference.sound_speed);
    if !(validity.mach_min..=validity.mach_max).contains(&mach.re()) {
        let Validity { mach_min, mach_max, .. } = *validity;
        return Err(ConditionError::Mach { mach: mach.re(), mach_min, mach_max });
    }
    // C_Lα Δα + C_L_M ΔM = ΔC_L
    let lift_by_alpha = (cl - c.cl) - c.cl_m * (mach - reference.mach());
    let alpha_change = if lift_by_alpha.is_constantly(0.0) {
        T::from(0.0)
    } else if c.cl_alpha > 1e-3 {
        lift_by_alpha / c.cl_alpha
    } else {
        return Err(ConditionError::NoLiftSlope { cl_alpha: c.cl_alpha.re() });
    };
    let dynamic_pressure = density * 0.5 * speed * speed;
    Ok(SteadyFlight { condition: *condition, density, mach, dynamic_pressure, cl, alpha_change })
}

impl Reference {
    /// Mach number of the reference.
    pub fn mach(&self) -> f64 {
        self.condition.speed / self.sound_speed
    }
}

/// The coefficients at another lift and Mach number, stability axes; at the reference they are unchanged to the bit.
///
/// The drag is parabolic, C_D = C_D0 + k C_L² with k from C_Dα = 2 k C_L C_Lα (Etkin & Reid §5.1); Cl_r and Cn_p follow C_L
/// (Nelson, Table 3.4). Other coefficients keep their values: how they change with Mach number and angle of attack is not in the
/// data.
pub fn at_lift<T: Real>(
    c: &Coefficients<T>,
    flight: &SteadyFlight<T>,
    reference: &Reference,
) -> Coefficients<T> {
    let mut moved = *c;
    let (l, m) = (&c.longitudinal, &mut moved.longitudinal);
    let cl_change = flight.cl - l.cl;
    m.cl = flight.cl;
    // k = C_Dα/(2 C_L C_Lα);  C_D = C_D₁ + k (C_L² − C_L₁²) + C_D_M ΔM;  C_Dα = C_Dα₁ C_L/C_L₁
    if l.cl * l.cl_alpha != 0.0 {
        let k = l.cd_alpha / (l.cl * 2.0 * l.cl_alpha);
        m.cd += k * (flight.cl * flight.cl - l.cl * l.cl);
        m.cd_alpha *= flight.cl / l.cl;
    }
    m.cd += l.cd_m * (flight.mach - reference.mach());
    if let Some(lateral) = &mut moved.lateral {
        // Cl_r = C_L/4 + fin,  Cn_p = −C_L/8 + fin
        lateral.cl_r += cl_change / 4.0;
        lateral.cn_p -= cl_change / 8.0;
    }
    moved
}
