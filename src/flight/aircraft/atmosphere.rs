//! The standard atmosphere to 20 km: International Standard Atmosphere, ISO 2533:1975, the same as the U.S. Standard
//! Atmosphere 1976 at these heights.
//!
//! Altitude is geopotential, as in the tables; at 20 km that is 63 m below the geometric height.

use thiserror::Error;

use super::real::Real;

/// Temperature at sea level T₀ \[K\].
const SEA_LEVEL_TEMPERATURE: f64 = 288.15;
/// Pressure at sea level p₀ \[Pa\].
const SEA_LEVEL_PRESSURE: f64 = 101_325.0;
/// Temperature lapse L of the troposphere \[K/m\].
const LAPSE: f64 = -0.0065;
/// Top of the troposphere \[m\].
const TROPOPAUSE: f64 = 11_000.0;
/// Specific gas constant of air R \[J/(kg K)\].
const GAS_CONSTANT: f64 = 287.052_87;
/// Standard acceleration of free fall g₀ \[m/s²\], part of the definition of the atmosphere.
const GRAVITY: f64 = 9.806_65;
/// Ratio of specific heats of air.
const HEAT_RATIO: f64 = 1.4;

/// Highest altitude of this model \[m\].
pub const CEILING: f64 = 20_000.0;

/// The air at one altitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air<T = f64> {
    /// Temperature T \[K\].
    pub temperature: T,
    /// Pressure p \[Pa\].
    pub pressure: T,
    /// Density ρ \[kg/m³\].
    pub density: T,
    /// Speed of sound a \[m/s\].
    pub sound_speed: T,
}

/// An altitude outside the model.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub struct AtmosphereError {
    /// The altitude asked for \[m\].
    pub altitude: f64,
}

/// The air at a geopotential altitude \[m\], from sea level to 20 km.
pub fn standard_air<T: Real>(altitude: T) -> Result<Air<T>, AtmosphereError> {
    if !(0.0..=CEILING).contains(&altitude.re()) {
        return Err(AtmosphereError { altitude: altitude.re() });
    }
    // T = T₀ + L h below the tropopause, constant above it
    let temperature = altitude.at_most(TROPOPAUSE) * LAPSE + SEA_LEVEL_TEMPERATURE;
    // p = p₀ (T/T₀)^(−g₀/(L R)), and above it p = p₁ e^(−g₀ (h − h₁)/(R T))
    let below =
        (temperature / SEA_LEVEL_TEMPERATURE).powf(-GRAVITY / (LAPSE * GAS_CONSTANT)) * SEA_LEVEL_PRESSURE;
    let above = (altitude - TROPOPAUSE).at_least(0.0);
    let pressure = below * (above * -GRAVITY / (temperature * GAS_CONSTANT)).exp();
    Ok(Air {
        temperature,
        pressure,
        // ρ = p/(R T)
        density: pressure / (temperature * GAS_CONSTANT),
        // a = √(γ R T)
        sound_speed: (temperature * (HEAT_RATIO * GAS_CONSTANT)).sqrt(),
    })
}
