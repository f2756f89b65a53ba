//! Dryden turbulence: random gusts with the spectra of MIL-F-8785C (5 November 1980), §3.7.
//!
//! # The field
//!
//! The air's motion is a pattern frozen in space through which the aircraft flies at V, so a wave of Ω \[rad/m\] is met with
//! ω = Ω V. Gusts are velocities of the air: u_g forward (a tail wind is positive), v_g to the right, w_g downward. The
//! three are independent. Below 1000 ft the specification has u_g along the mean wind and w_g vertical; here all are taken
//! along and across the flight path (see [`super::gusts`]), as for level flight against or with the wind.
//!
//! Spectra, §3.7.1.2 (Dryden form), one-sided over Ω ≥ 0 so that σ² = ∫₀^∞ Φ(Ω) dΩ:
//!
//! ```text
//! Φ_u(Ω) = σ_u² (2 L_u/π) / (1 + (L_u Ω)²)
//! Φ_v(Ω) = σ_v² (L_v/π) (1 + 3 (L_v Ω)²) / (1 + (L_v Ω)²)²     and Φ_w alike
//! ```
//!
//! (MIL-HDBK-1797 writes 2 L_v for this L_v: the same spectra, other lengths. The lengths here are those of MIL-F-8785C.)
//!
//! # Gusts that turn
//!
//! A gust that changes along the aircraft acts as a rotation of the air. Air turning with (p, q, r) has at the distance x
//! ahead the velocity ω × (x, 0, 0) = (0, r x, −q x), and in a frozen field the gust met at a time t is w_g(V t), so
//! ∂w_g/∂x = ẇ_g/V. Therefore
//!
//! ```text
//! q_g = −∂w_g/∂x = −ẇ_g/V        r_g = ∂v_g/∂x = v̇_g/V
//! ```
//!
//! as in Etkin, *Dynamics of Atmospheric Flight* (1972), ch. 13. The aerodynamics see q − q_g = q + ẇ_g/V and r − r_g.
//! The same by the tail, which meets each gust l/V later: its downward wind is w_g − (l/V) ẇ_g, and less downward wind at
//! the tail is the flow that pitching nose up by ẇ_g/V would bring.
//!
//! (In the specification's own q_g and r_g the sign is free, as only spectra are asked for.)
//!
//! # Left out
//!
//! The roll rate p_g of gusts that change along the span (§3.7.5), and the filters by which §3.7.5 takes from q_g and r_g
//! what is shorter than the aircraft; the change of the turbulence along a flight path that climbs; the mean wind itself.

use std::f64::consts::{PI, SQRT_2, TAU};
use std::iter::repeat_with;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Most samples that are made; asked for more, there are this many.
pub const MOST_SAMPLES: usize = 1_000_000;

/// Largest intensity with which gusts are made \[m/s\]; beyond it there are none. It only keeps every number finite.
const LARGEST_INTENSITY: f64 = 1e9;

const FOOT: f64 = 0.3048;
const KNOT: f64 = 1852.0 / 3600.0;

/// How strong the turbulence is, in the words of MIL-F-8785C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// W₂₀ = 15 kt; aloft, the intensity exceeded with probability 10⁻².
    Light,
    /// W₂₀ = 30 kt; aloft, the intensity exceeded with probability 10⁻³.
    Moderate,
    /// W₂₀ = 45 kt; aloft, the intensity exceeded with probability 10⁻⁵.
    Severe,
}

impl Severity {
    /// Mean wind W₂₀ at 20 ft (6 m) above the ground \[m/s\] (Figure 9).
    pub const fn wind_at_20_ft(self) -> f64 {
        let knots = match self {
            Self::Light => 15.0,
            Self::Moderate => 30.0,
            Self::Severe => 45.0,
        };
        knots * KNOT
    }

    /// Intensity σ \[m/s\] above 2000 ft (§3.7.2.2), from Figure 7, p. 49, by straight lines between readings at
    /// [`FIGURE_7_HEIGHTS`]; held beyond them.
    fn intensity_aloft(self, height_ft: f64) -> f64 {
        // [ft/s]
        let readings = match self {
            Self::Light => [6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0],
            Self::Moderate => [8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2, 2.7, 0.0, 0.0, 0.0],
            Self::Severe => [15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1, 12.1, 7.9, 6.2, 5.1],
        };
        let mut sigma = readings[0];
        for (heights, values) in FIGURE_7_HEIGHTS.windows(2).zip(readings.windows(2)) {
            let along = ((height_ft - heights[0]) / (heights[1] - heights[0])).clamp(0.0, 1.0);
            sigma += along * (values[1] - values[0]);
        }
        sigma * FOOT
    }
}

/// Heights \[ft\] at which Figure 7 is read, as tabulated by JSBSim (FGWinds.cpp).
const FIGURE_7_HEIGHTS: [f64; 12] =
    [500.0, 1750.0, 3750.0, 7500.0, 15e3, 25e3, 35e3, 45e3, 55e3, 65e3, 75e3, 80e3];

/// Turbulence of the Dryden form as an aircraft meets it. Each array is for \[u_g, v_g, w_g\].
///
/// A gust whose length or intensity is not positive and finite (or at a speed that is not) is still air: zero everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dryden {
    /// True airspeed V \[m/s\], positive.
    pub speed: f64,
    /// Scale lengths L_u, L_v, L_w \[m\], positive.
    pub scale: [f64; 3],
    /// Intensities σ_u, σ_v, σ_w, the standard deviations \[m/s\].
    pub intensity: [f64; 3],
}

impl Dryden {
    /// Turbulence at a height above the ground \[m\], met at a true airspeed V \[m/s\].
    ///
    /// Up to 1000 ft by §3.7.3.4 (Figures 10 and 11, from 10 ft up; below, and for a height that is no number, as at 10 ft),
    /// from 2000 ft by §3.7.2. Between, the specification has no rule for joining the two; lengths and intensities go in a
    /// straight line with height, as in the Dryden blocks of the Aerospace Blockset (MathWorks) and in JSBSim.
    pub fn at(height: f64, speed: f64, severity: Severity) -> Self {
        let height_ft = (height / FOOT).max(10.0);
        let low = low_altitude(height_ft.min(1000.0), severity);
        let high = high_altitude(height_ft.max(2000.0), severity);
        let along = ((height_ft - 1000.0) / 1000.0).clamp(0.0, 1.0);
        let between = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + along * (b[i] - a[i]));
        Self { speed, scale: between(low.0, high.0), intensity: between(low.1, high.1) }
    }

    /// Gusts \[u_g, v_g, w_g\] \[m/s\] at t = 0, Δt, 2 Δt, …, for turbulence that has always been there.
    ///
    /// Exact whatever Δt \[s\] is: the samples are normally distributed with the autocorrelation of the spectra. The same
    /// seed gives the same numbers everywhere, up to the last digit of exp, ln, cos; a longer series begins as a shorter
    /// one. At most [`MOST_SAMPLES`]; all zero if Δt is not positive and finite.
    pub fn samples(&self, seed: u64, dt: f64, count: usize) -> Vec<[f64; 3]> {
        let count = count.min(MOST_SAMPLES);
        let of = |i: usize, unit: fn(f64, u64, u64, usize) -> Vec<f64>| match self.rate(i) {
            Some(rate) if dt > 0.0 && dt.is_finite() => {
                // From some r on, samples have nothing to do with each other: e^(−r) is 0, and so must be r e^(−r).
                unit((rate * dt).min(1e3), seed, i as u64, count)
            }
            _ => vec![0.0; count],
        };
        let (u, v, w) = (of(0, longitudinal), of(1, transverse), of(2, transverse));
        let [sigma_u, sigma_v, sigma_w] = self.intensity;
        // Where the air is still its intensity need not be a number.
        let scaled = |sigma: f64, x: f64| if x == 0.0 { 0.0 } else { sigma * x };
        (0..count).map(|k| [scaled(sigma_u, u[k]), scaled(sigma_v, v[k]), scaled(sigma_w, w[k])]).collect()
    }

    /// One-sided spectrum of u_g over ω ≥ 0 \[(m/s)²/(rad/s)\]: its integral is σ_u². Zero if ω is not a number.
    pub fn spectrum_u(&self, omega: f64) -> f64 {
        // Φ_u(ω) = Φ_u(Ω = ω/V)/V = σ_u² (2 τ/π) / (1 + (τω)²),  τ = L_u/V
        self.spectrum(0, omega, |x2| 2.0 / (1.0 + x2))
    }

    /// One-sided spectrum of v_g over ω ≥ 0 \[(m/s)²/(rad/s)\]: its integral is σ_v². Zero if ω is not a number.
    pub fn spectrum_v(&self, omega: f64) -> f64 {
        self.spectrum(1, omega, transverse_shape)
    }

    /// One-sided spectrum of w_g over ω ≥ 0 \[(m/s)²/(rad/s)\]: its integral is σ_w². Zero if ω is not a number.
    pub fn spectrum_w(&self, omega: f64) -> f64 {
        self.spectrum(2, omega, transverse_shape)
    }

    /// σ² (τ/π) shape((τω)²)
    fn spectrum(&self, i: usize, omega: f64, shape: fn(f64) -> f64) -> f64 {
        let value = self
            .rate(i)
            .map_or(0.0, |rate| self.intensity[i].powi(2) / (PI * rate) * shape((omega / rate).powi(2)));
        if value.is_finite() { value } else { 0.0 }
    }

    /// 1/τ = V/L \[1/s\] of a gust; `None` in still air.
    fn rate(&self, i: usize) -> Option<f64> {
        let rate = self.speed / self.scale[i];
        let moves = |x: f64| x > 0.0 && x.is_finite();
        let air = moves(self.speed) && moves(self.scale[i]) && moves(rate);
        (air && self.intensity[i] > 0.0 && self.intensity[i] <= LARGEST_INTENSITY).then_some(rate)
    }
}

/// Lengths \[m\] and intensities \[m/s\] at 10 to 1000 ft, §3.7.3.4.
fn low_altitude(height_ft: f64, severity: Severity) -> ([f64; 3], [f64; 3]) {
    let ground = 0.177 + 0.000823 * height_ft;
    // L_w = h,  L_u = L_v = h/(0.177 + 0.000823 h)^1.2
    let (l_w, l_u) = (height_ft, height_ft / ground.powf(1.2));
    // σ_w = 0.1 W₂₀,  σ_u = σ_v = σ_w/(0.177 + 0.000823 h)^0.4
    let sigma_w = 0.1 * severity.wind_at_20_ft();
    let sigma_u = sigma_w / ground.powf(0.4);
    ([l_u, l_u, l_w].map(|l| l * FOOT), [sigma_u, sigma_u, sigma_w])
}

/// Lengths \[m\] and intensities \[m/s\] from 2000 ft up, where the turbulence is alike in all directions, §3.7.2.1–2.
fn high_altitude(height_ft: f64, severity: Severity) -> ([f64; 3], [f64; 3]) {
    ([1750.0 * FOOT; 3], [severity.intensity_aloft(height_ft); 3])
}

fn transverse_shape(x2: f64) -> f64 {
    // (1 + 3x²)/(1 + x²)², divided so that nothing overflows
    (1.0 + 3.0 * x2) / (1.0 + x2) / (1.0 + x2)
}

/// Samples with variance 1 of τ ẋ = −x + noise, at steps r = Δt/τ.
fn longitudinal(r: f64, seed: u64, stream: u64, count: usize) -> Vec<f64> {
    // x(t + Δt) = e^(−r) x(t) + √(1 − e^(−2r)) n
    let (keep, kick) = ((-r).exp(), remainder(1, 2.0 * r).sqrt());
    let mut x = 0.0;
    let normals = normal_pairs(seed, stream).flatten().take(count);
    let step = |(k, n): (usize, f64)| {
        x = if k == 0 { n } else { keep * x + kick * n };
        x
    };
    normals.enumerate().map(step).collect()
}

/// Samples with variance 1 of the filter (1 + √3 τs)/(1 + τs)², at steps r = Δt/τ.
fn transverse(r: f64, seed: u64, stream: u64, count: usize) -> Vec<f64> {
    // τ ẋ₁ = −x₁ + noise,  τ ẋ₂ = x₁ − x₂,  y = (√3 x₁ + (1 − √3) x₂)/√2, as 1 + √3 τs = √3 (1 + τs) + (1 − √3)
    //
    //     ⎡ 1  ½ ⎤                      ⎡ 1  0 ⎤                   1 ⎡ 2 P₁(2r)   P₂(2r) ⎤
    // P = ⎢      ⎥ (stationary), Φ = e⁻ʳ⎢      ⎥,  Q = P − Φ P Φᵀ = ― ⎢                   ⎥
    //     ⎣ ½  ½ ⎦                      ⎣ r  1 ⎦                   2 ⎣ P₂(2r)     P₃(2r) ⎦
    let keep = (-r).exp();
    let (q11, q12, q22) = (remainder(1, 2.0 * r), 0.5 * remainder(2, 2.0 * r), 0.5 * remainder(3, 2.0 * r));
    // Q = C Cᵀ (Cholesky)
    let c11 = q11.sqrt();
    let c21 = if c11 > 0.0 { q12 / c11 } else { 0.0 };
    let c22 = (q22 - c21 * c21).max(0.0).sqrt();
    let [mut x1, mut x2] = [0.0; 2];
    let step = |(k, [n1, n2]): (usize, [f64; 2])| {
        [x1, x2] = if k == 0 {
            // P = C Cᵀ with the rows of C (1, 0) and (½, ½)
            [n1, 0.5 * (n1 + n2)]
        } else {
            [keep * x1 + c11 * n1, keep * (r * x1 + x2) + c21 * n1 + c22 * n2]
        };
        let root3 = 3_f64.sqrt();
        (root3 * x1 + (1.0 - root3) * x2) / SQRT_2
    };
    normal_pairs(seed, stream).take(count).enumerate().map(step).collect()
}

/// Pₙ(y) = 1 − e^(−y) Σ_{k<n} yᵏ/k!, what is left of the exponential series, to full relative precision for small y too.
fn remainder(n: u32, y: f64) -> f64 {
    let terms = |from: u32, to: u32| {
        // yᵏ/k! one from the other
        let mut term = 1.0;
        let mut sum = 0.0;
        for k in 0..to {
            if k > 0 {
                term *= y / f64::from(k);
            }
            if k >= from {
                sum += term;
            }
        }
        sum
    };
    // The difference would cancel; 1/24! is below the last digit.
    if y < 1.0 { (-y).exp() * terms(n, n + 20) } else { 1.0 - (-y).exp() * terms(0, n) }
}

/// Pairs of independent numbers of the standard normal distribution (Box & Muller 1958), without end.
///
/// Every pair takes two numbers of the generator: a last digit of ln or cos that differs between machines stays one, where
/// a method that rejects would lose step.
fn normal_pairs(seed: u64, stream: u64) -> impl Iterator<Item = [f64; 2]> {
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let mut generator = ChaCha8Rng::from_seed(key);
    generator.set_stream(stream);
    repeat_with(move || {
        // Multiples of 2⁻⁵³ in [0, 1)
        let [a, b] = [(); 2].map(|()| (generator.next_u64() >> 11) as f64 / (1_u64 << 53) as f64);
        // n₁, n₂ = √(−2 ln(1 − a)) (cos 2πb, sin 2πb)
        let radius = (-2.0 * (1.0 - a).ln()).sqrt();
        [radius * (TAU * b).cos(), radius * (TAU * b).sin()]
    })
}
