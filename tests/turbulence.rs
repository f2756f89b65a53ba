//! Dryden turbulence against its definitions: lengths, intensities, spectra, correlations, and numbers made elsewhere.
//!
//! Seeds are fixed, so that nothing here is left to chance; bounds are five standard deviations of the estimate, of which
//! the derivation stands with each.

use std::f64::consts::{PI, TAU};

use eigenwing::flight::motion::turbulence::{Dryden, MOST_SAMPLES, Severity};
use nalgebra::Complex;
use serde::Deserialize;

const FOOT: f64 = 0.3048;
const AIR: Dryden = Dryden { speed: 50.0, scale: [500.0, 400.0, 150.0], intensity: [2.0, 1.5, 1.0] };

/// τ = L/V of a component [s].
fn tau(i: usize) -> f64 {
    AIR.scale[i] / AIR.speed
}

/// ρ(x) at x = |t|/τ: the cosine transform of the spectrum of §3.7.1.2.
fn correlation(i: usize, x: f64) -> f64 {
    if i == 0 { (-x).exp() } else { (-x).exp() * (1.0 - x / 2.0) }
}

/// ∫ρ² dt over all times [s]: a record of length T says as much of a variance as T/∫ρ² independent numbers do.
///
/// Longitudinal: 2τ ∫₀^∞ e^(−2x) dx = τ. Transverse: 2τ ∫₀^∞ e^(−2x) (1 − x/2)² dx = 5τ/8.
fn memory(i: usize) -> f64 {
    if i == 0 { tau(i) } else { 0.625 * tau(i) }
}

fn component(samples: &[[f64; 3]], i: usize) -> Vec<f64> {
    samples.iter().map(|gust| gust[i]).collect()
}

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    speed: f64,
    scale: [f64; 3],
    intensity: [f64; 3],
    dt: f64,
    seed: String,
    count: usize,
    samples: Vec<[f64; 3]>,
}

#[test]
fn a_seed_gives_the_numbers_that_another_program_makes_of_it() {
    let file: File = serde_json::from_str(include_str!("data/turbulence.json")).expect("the data file reads");
    assert_eq!(file.cases.len(), 3);
    for case in file.cases {
        let air = Dryden { speed: case.speed, scale: case.scale, intensity: case.intensity };
        let ours = air.samples(case.seed.parse().expect("a whole number"), case.dt, case.count);
        assert_eq!(ours.len(), case.samples.len());
        for (k, (ours, theirs)) in ours.iter().zip(&case.samples).enumerate() {
            for i in 0..3 {
                // Both components of the noise have full relative precision, so this holds at any step.
                let off = (ours[i] - theirs[i]).abs();
                assert!(off <= 1e-12 * air.intensity[i], "dt {}, sample {k}.{i}: off by {off:e}", case.dt);
            }
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_gusts_and_a_longer_series_begins_alike() {
    let (short, long) = (AIR.samples(7, 0.1, 100), AIR.samples(7, 0.1, 1000));
    assert!(short == long[..100]);
    for other in [0, 6, 8, 7 << 32] {
        assert!(AIR.samples(other, 0.1, 100).iter().zip(&short).all(|(a, b)| (0..3).all(|i| a[i] != b[i])));
    }
}

#[test]
fn the_standard_deviation_is_the_intensity() {
    // Var(s²) = 2 σ⁴ ∫ρ²/T; T = 100,000 s makes that 1.4 % of σ² for u, less for the others.
    let (dt, count) = (0.5, 200_000);
    for seed in 1..=4 {
        let samples = AIR.samples(seed, dt, count);
        for i in 0..3 {
            let x = component(&samples, i);
            let variance = x.iter().map(|x| x * x).sum::<f64>() / count as f64;
            let bound = 5.0 * (2.0 * memory(i) / (dt * count as f64)).sqrt();
            assert!(bound < 0.08);
            let off = variance / AIR.intensity[i].powi(2) - 1.0;
            assert!(off.abs() < bound, "seed {seed}, component {i}: variance off by {off}, allowed {bound}");
        }
    }
}

#[test]
fn the_first_sample_is_as_strong_as_any() {
    // 2000 seeds: independent numbers, so Var(s²) = 2 σ⁴/2000.
    let seeds = 2000;
    for i in 0..3 {
        let variance =
            (0..seeds).map(|seed| AIR.samples(seed, 0.1, 1)[0][i].powi(2)).sum::<f64>() / seeds as f64;
        let off = variance / AIR.intensity[i].powi(2) - 1.0;
        assert!(off.abs() < 5.0 * (2.0 / seeds as f64).sqrt(), "component {i}: off by {off}");
    }
}

#[test]
fn gusts_are_normally_distributed() {
    // 20 τ apart they are independent; the mean of n has the variance 1/n, that of n⁴, which is 3, has 96/n.
    let count = 200_000;
    let samples = AIR.samples(3, 20.0 * tau(0), count);
    for i in 0..3 {
        let n = component(&samples, i).into_iter().map(|x| x / AIR.intensity[i]).collect::<Vec<_>>();
        let mean = |power: i32| n.iter().map(|n| n.powi(power)).sum::<f64>() / count as f64;
        assert!(mean(1).abs() < 5.0 / (count as f64).sqrt());
        assert!((mean(4) - 3.0).abs() < 5.0 * (96.0 / count as f64).sqrt());
    }
}

#[test]
fn gusts_forget_themselves_as_the_spectrum_says() {
    // The variance of the estimated correlation is at most 2 ∫ρ²/T (Bartlett), with T = 200,000 s.
    let (dt, count) = (0.25, 800_000);
    let samples = AIR.samples(11, dt, count);
    for i in 0..3 {
        let x = component(&samples, i);
        let bound = 5.0 * (2.0 * memory(i) / (dt * count as f64)).sqrt();
        assert!(bound < 0.051);
        for lag in [1, 2, 4, 8, 16, 32, 64, 128] {
            let products = x.iter().zip(&x[lag..]).map(|(a, b)| a * b).sum::<f64>();
            let estimate = products / (count - lag) as f64 / AIR.intensity[i].powi(2);
            let off = estimate - correlation(i, lag as f64 * dt / tau(i));
            assert!(off.abs() < bound, "component {i}, lag {lag}: off by {off}, allowed {bound}");
        }
    }
}

#[test]
fn short_steps_are_as_small_as_the_spectrum_says() {
    // E (x(t + Δt) − x(t))² = 2 σ² (1 − ρ(Δt)); the steps are nearly independent (white noise drives them), so the estimate
    // varies by √(2/n). An Euler step, or the gain of one filter for the other, is off by far more.
    let (dt, count) = (1e-4, 200_000);
    let samples = AIR.samples(5, dt, count);
    for i in 0..3 {
        let x = component(&samples, i);
        let square = x.windows(2).map(|x| (x[1] - x[0]).powi(2)).sum::<f64>() / (count - 1) as f64;
        let expected = 2.0 * AIR.intensity[i].powi(2) * (1.0 - correlation(i, dt / tau(i)));
        assert!((square / expected - 1.0).abs() < 5.0 * (2.0 / count as f64).sqrt());
    }
}

#[test]
fn components_and_seeds_have_nothing_to_do_with_each_other() {
    // Var of the mean product is σ²σ² ∫ρρ'/T, at most √(∫ρ² ∫ρ'²)/T.
    let (dt, count) = (0.5, 200_000);
    let (one, two) = (AIR.samples(1, dt, count), AIR.samples(2, dt, count));
    for (a, b, i, j) in
        [(&one, &one, 0, 1), (&one, &one, 0, 2), (&one, &one, 1, 2), (&one, &two, 0, 0), (&one, &two, 2, 2)]
    {
        let (x, y) = (component(a, i), component(b, j));
        let bound = 5.0 * ((memory(i) * memory(j)).sqrt() / (dt * count as f64)).sqrt();
        assert!(bound < 0.051);
        for lag in [0, 1, 10] {
            let mean = x.iter().zip(&y[lag..]).map(|(x, y)| x * y).sum::<f64>() / (count - lag) as f64;
            let correlation = mean / (AIR.intensity[i] * AIR.intensity[j]);
            assert!(correlation.abs() < bound, "{i} and {j} at lag {lag}: {correlation}, allowed {bound}");
        }
    }
}

#[test]
fn spectra_have_the_shape_of_dryden_at_any_step() {
    for (dt, seed) in [(0.1, 21), (0.4, 22)] {
        let samples = AIR.samples(seed, dt, SEGMENT * SEGMENTS);
        let spectra: [fn(&Dryden, f64) -> f64; 3] =
            [Dryden::spectrum_u, Dryden::spectrum_v, Dryden::spectrum_w];
        for (i, spectrum) in spectra.into_iter().enumerate() {
            let estimate = welch(&component(&samples, i), dt);
            let d_omega = TAU / (SEGMENT as f64 * dt);
            // What a sampled signal shows: all frequencies that look alike at this step, together. Above
            // k = 50 they leave out 2/(50 π²) = 0.4 % where it is most, at the highest bin.
            let folded = |omega: f64| {
                (-50..=50).map(|k| spectrum(&AIR, (omega + f64::from(k) * TAU / dt).abs())).sum::<f64>()
            };
            let mut first = 2;
            while 2 * first <= SEGMENT / 2 {
                let bins = first..2 * first;
                let n = bins.len() as f64;
                let ratio = bins.map(|k| estimate[k] / folded(k as f64 * d_omega)).sum::<f64>() / n;
                // Mean of n bins over K segments; through the window, bins at distance 1 and 2 have the correlations
                // (2/3)² and (1/6)² of their powers.
                let neighbours = 1.0 + 2.0 * (4.0 / 9.0) * (n - 1.0) / n + 2.0 / 36.0 * (n - 2.0) / n;
                // 1 % for what the window makes of a curved spectrum within its four bins.
                let bound = 5.0 * (neighbours / (n * SEGMENTS as f64)).sqrt() + 0.01;
                assert!(bound < 0.41);
                assert!((ratio - 1.0).abs() < bound, "dt {dt}, {i}, bins from {first}: {ratio}, {bound}");
                first *= 2;
            }
        }
    }
}

#[test]
fn spectra_are_those_of_the_specification() {
    // Φ_u(0) = σ² 2L/(πV), Φ_v(0) = σ² L/(πV); at Ω = 1/L: half of that, and (1 + 3)/4 = 1 of that.
    let (u, v) = (4.0 * 2.0 * 500.0 / (PI * 50.0), 2.25 * 400.0 / (PI * 50.0));
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
    near(AIR.spectrum_u(0.0), u);
    near(AIR.spectrum_u(0.1), u / 2.0);
    near(AIR.spectrum_v(0.0), v);
    near(AIR.spectrum_v(0.125), v);
    near(AIR.spectrum_w(0.0), 150.0 / (PI * 50.0));
    // σ² = ∫Φ dω, by ω = tan x and the midpoint rule, which is exact for such functions of sin and cos.
    for (spectrum, sigma) in
        [(Dryden::spectrum_u as fn(&Dryden, f64) -> f64, 2.0_f64), (Dryden::spectrum_w, 1.0)]
    {
        let steps = 4000;
        let dx = PI / 2.0 / f64::from(steps);
        let total = (0..steps).map(|k| {
            let x = (f64::from(k) + 0.5) * dx;
            spectrum(&AIR, x.tan()) * dx / x.cos().powi(2)
        });
        assert!((total.sum::<f64>() / sigma.powi(2) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn lengths_and_intensities_are_those_of_the_specification() {
    let air = |feet: f64, severity| Dryden::at(feet * FOOT, 50.0, severity);
    let assert_near = |ours: f64, theirs: f64, what: &str| {
        assert!((ours / theirs - 1.0).abs() < 1e-6, "{what}: {ours} for {theirs}");
    };
    // §3.7.3.4 worked out apart, at 10, 100, 500 and 1000 ft: L_u = L_v [ft], σ_u/σ_w.
    for (feet, length, ratio) in [
        (10.0, 75.639_11, 1.962_978_2),
        (100.0, 505.169_33, 1.715_848_7),
        (500.0, 944.657_21, 1.236_236_1),
        (1000.0, 1000.0, 1.0),
    ] {
        for (severity, knots) in
            [(Severity::Light, 15.0), (Severity::Moderate, 30.0), (Severity::Severe, 45.0)]
        {
            let Dryden { scale, intensity, .. } = air(feet, severity);
            assert_near(scale[0], length * FOOT, "L_u");
            assert_near(scale[1], length * FOOT, "L_v");
            assert_near(scale[2], feet * FOOT, "L_w");
            assert_near(intensity[2], 0.1 * knots * 0.514_444_444, "σ_w");
            assert_near(intensity[0], intensity[2] * ratio, "σ_u");
            assert_near(intensity[1], intensity[0], "σ_v");
        }
    }
    // §3.7.2.1, and Figure 7 at heights where it is read: 10⁻², 10⁻³, 10⁻⁵.
    for (feet, sigmas) in [
        (3750.0, [7.4, 10.6, 23.0]),
        (15_000.0, [4.6, 8.0, 22.1]),
        (35_000.0, [0.4, 5.0, 16.0]),
        (80_000.0, [0.0, 0.0, 5.1]),
        (200_000.0, [0.0, 0.0, 5.1]),
    ] {
        for (severity, sigma) in
            [Severity::Light, Severity::Moderate, Severity::Severe].into_iter().zip(sigmas)
        {
            let Dryden { scale, intensity, .. } = air(feet, severity);
            assert!(scale.iter().all(|l| (l - 533.4).abs() < 1e-9), "{scale:?}");
            assert!(intensity.iter().all(|s| (s - sigma * FOOT).abs() < 1e-9), "{feet} ft: {intensity:?}");
        }
    }
}

#[test]
fn lengths_are_those_that_textbooks_round_to() {
    // Beard & McLain, *Small Unmanned Aircraft*, Table 4.1: 200, 200, 50 m at 50 m; 533 m, all three, at 600 m.
    // At 600 m = 1969 ft the way to 1750 ft has 3 % of 750 ft left.
    let (low, high) =
        (Dryden::at(50.0, 25.0, Severity::Light).scale, Dryden::at(600.0, 25.0, Severity::Light).scale);
    for (ours, theirs) in low.into_iter().chain(high).zip([200.0, 200.0, 50.0, 533.0, 533.0, 533.0]) {
        assert!((ours / theirs - 1.0_f64).abs() < 0.02, "{ours} for {theirs}");
    }
}

#[test]
fn nothing_jumps_with_height() {
    for severity in [Severity::Light, Severity::Moderate, Severity::Severe] {
        let mut last = Dryden::at(0.0, 50.0, severity);
        for k in 1..30_000 {
            let next = Dryden::at(f64::from(k), 50.0, severity);
            for i in 0..3 {
                // Steepest: L_u near the ground, 11 m a metre; σ_u of severe turbulence there, 0.03 m/s a metre.
                assert!((next.scale[i] - last.scale[i]).abs() < 12.0, "{k} m");
                assert!((next.intensity[i] - last.intensity[i]).abs() < 0.04, "{k} m");
            }
            last = next;
        }
    }
}

#[test]
fn half_way_between_the_two_models_is_the_mean_of_both() {
    let at = |feet: f64| Dryden::at(feet * FOOT, 50.0, Severity::Severe);
    let (low, middle, high) = (at(1000.0), at(1500.0), at(2000.0));
    for i in 0..3 {
        assert!((middle.scale[i] - 1375.0 * FOOT).abs() < 1e-9);
        assert!((middle.intensity[i] - 0.5 * (low.intensity[i] + high.intensity[i])).abs() < 1e-12);
    }
}

#[test]
fn whatever_the_numbers_are_gusts_are_finite() {
    let odd =
        [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-320, 1e-300, 1e-9, 1.0, 1e9, 1e308];
    let finite = |air: &Dryden, dt: f64| {
        let samples = air.samples(1, dt, 20);
        assert_eq!(samples.len(), 20);
        assert!(samples.iter().flatten().all(|x| x.is_finite()), "{air:?} {dt}");
        for omega in odd {
            let all = [air.spectrum_u(omega), air.spectrum_v(omega), air.spectrum_w(omega)];
            assert!(all.iter().all(|x| x.is_finite() && *x >= 0.0), "{air:?} {omega}: {all:?}");
        }
    };
    for x in odd {
        for y in odd {
            finite(&Dryden::at(x, y, Severity::Severe), 0.1);
            for dt in odd {
                finite(&Dryden { speed: x, scale: [y; 3], intensity: [1.0; 3] }, dt);
                finite(&Dryden { speed: 50.0, scale: [x; 3], intensity: [y; 3] }, dt);
            }
        }
    }
}

#[test]
fn without_speed_or_time_the_air_is_still() {
    let still = |air: Dryden, dt: f64| air.samples(1, dt, 5) == [[0.0; 3]; 5];
    assert!(!still(AIR, 0.1));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(still(Dryden { speed: bad, ..AIR }, 0.1));
        assert!(still(AIR, bad));
        let only_w = Dryden { scale: [bad, bad, 150.0], ..AIR }.samples(1, 0.1, 5);
        assert!(only_w.iter().all(|gust| gust[0] == 0.0 && gust[1] == 0.0 && gust[2] != 0.0));
    }
    assert!(AIR.samples(1, 0.1, 0).is_empty());
    assert_eq!(AIR.samples(1, 0.0, usize::MAX).len(), MOST_SAMPLES);
}

const SEGMENT: usize = 2048;
const SEGMENTS: usize = 128;

/// One-sided power spectral density over ω by Bartlett's and Welch's method: Hann's window, segments that do not overlap.
fn welch(x: &[f64], dt: f64) -> Vec<f64> {
    let window: Vec<f64> = (0..SEGMENT).map(|k| (PI * k as f64 / SEGMENT as f64).sin().powi(2)).collect();
    let power: f64 = window.iter().map(|w| w * w).sum();
    let roots: Vec<_> =
        (0..SEGMENT / 2).map(|k| Complex::from_polar(1.0, -TAU * k as f64 / SEGMENT as f64)).collect();
    let mut density = vec![0.0; SEGMENT / 2];
    for segment in x.chunks_exact(SEGMENT) {
        let windowed = segment.iter().zip(&window).map(|(x, w)| Complex::new(x * w, 0.0)).collect();
        for (density, x) in density.iter_mut().zip(fourier(windowed, &roots)) {
            // Two-sided over f: |X|² Δt/Σw²; twice that for one side, over 2π for ω.
            *density += x.norm_sqr() * dt / power / PI / SEGMENTS as f64;
        }
    }
    density
}

/// Discrete Fourier transform of 2ⁿ numbers, halved until one is left (Cooley & Tukey); `roots` are e^(−2πjk/[`SEGMENT`]).
fn fourier(x: Vec<Complex<f64>>, roots: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let n = x.len();
    if n == 1 {
        return x;
    }
    let half = |from: usize| fourier(x.iter().skip(from).step_by(2).copied().collect(), roots);
    let (even, odd) = (half(0), half(1));
    let turned = |k: usize| odd[k] * roots[k * SEGMENT / n];
    (0..n / 2).map(|k| even[k] + turned(k)).chain((0..n / 2).map(|k| even[k] - turned(k))).collect()
}
