//! What is watched of a motion, against what it means.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use eigenwing::flight::analysis::{Motion, STANDARD_GRAVITY};
use eigenwing::flight::modes::mode::{Mode, modes};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::motion::course::Course;
use eigenwing::flight::motion::frequency_response::{frequency_response, peaks, transfer};
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::response::{DrivenSystem, TimeGrid, respond};
use eigenwing::flight::motion::response_metrics::{
    control_anticipation, peak, phugoid_swing, root_mean_square, steady_output, step_metrics, time_to_bank,
};
use eigenwing::scenario::{START, Scenario, Shape, Source};
use eigenwing::words;
use nalgebra::{Matrix4, Matrix4x2, Vector4};

fn scenario(key: &str, plane: Plane, source: Source, shape: Shape) -> Scenario {
    let (aircraft, _) = embedded_aircraft();
    let found = aircraft.into_iter().find(|aircraft| aircraft.key == key).expect("an aircraft");
    let mut scenario = Scenario::new(Arc::new(found));
    scenario.plane = plane;
    let choice = &mut scenario.disturbance.choices[plane];
    choice.source = source;
    *choice.shape_mut() = shape;
    scenario
}

fn motion(scenario: &Scenario) -> (Motion, Vec<Mode>) {
    let analysis = scenario.analyse().expect("an analysis");
    let modes =
        analysis.planes[scenario.plane].as_ref().expect("data").as_ref().expect("modes").modes.clone();
    (analysis.motion.expect("a motion"), modes)
}

/// Trapezium rule from zero.
fn integral(rates: &[f64], dt: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let steps = rates.windows(2).map(|pair| {
        sum += 0.5 * dt * (pair[0] + pair[1]);
        sum
    });
    std::iter::once(0.0).chain(steps).collect()
}

fn assert_near(got: &[f64], want: &[f64], share: f64, what: &str) {
    let most = want.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (k, (got, want)) in got.iter().zip(want).enumerate() {
        assert!((got - want).abs() <= share * most, "{what} at {k}: {got} should be {want}");
    }
}

#[test]
fn height_is_the_integral_of_the_climb() {
    // Level, in stability axes, and diving in body axes.
    for key in ["navion", "bristol-f2b", "b747-fc9"] {
        let mut scenario = scenario(key, Plane::Longitudinal, Source::Elevator, Shape::Step);
        scenario.disturbance.sizes.time = 20.0;
        let (motion, _) = motion(&scenario);
        let trim = motion.model.trim;
        // h = V sin γ and the airspeed along the path is V + (U₀u + W₀w)/V
        let (gamma, u, w) = (
            motion.values(Output::PathAngle),
            motion.values(Output::ForwardSpeed),
            motion.values(Output::DownSpeed),
        );
        let rates: Vec<f64> = (0..u.len())
            .map(|k| {
                let along = (trim.u0() * u[k] + trim.w0() * w[k]) / trim.speed;
                trim.speed * trim.gamma0.cos() * gamma[k] + trim.gamma0.sin() * along
            })
            .collect();
        assert_near(&motion.values(Output::Height), &integral(&rates, motion.response.dt), 1e-4, key);
    }
}

#[test]
fn the_sideways_path_follows_heading_and_sideslip() {
    for key in ["navion", "bristol-f2b"] {
        let mut scenario = scenario(key, Plane::Lateral, Source::Rudder, Shape::Doublet);
        scenario.disturbance.sizes.time = 20.0;
        scenario.disturbance.sizes.part = 1.0;
        let (motion, _) = motion(&scenario);
        let trim = motion.model.trim;
        let (r, psi, v, phi) = (
            motion.values(Output::YawRate),
            motion.values(Output::Heading),
            motion.values(Output::SideSpeed),
            motion.values(Output::BankAngle),
        );
        let turning: Vec<f64> = r.iter().map(|r| r / trim.theta0().cos()).collect();
        assert_near(&psi, &integral(&turning, motion.response.dt), 1e-3, key);
        let sideways: Vec<f64> = (0..v.len())
            .map(|k| v[k] - trim.w0() * phi[k] + trim.speed * trim.gamma0.cos() * psi[k])
            .collect();
        assert_near(&motion.values(Output::Offset), &integral(&sideways, motion.response.dt), 1e-3, key);
    }
}

/// In level flight the load factor is the curvature of the path: n_z − 1 = V γ̇/g, felt along the normal.
#[test]
fn the_load_factor_is_the_curvature_of_the_path() {
    let mut scenario = scenario("navion", Plane::Longitudinal, Source::Elevator, Shape::Step);
    scenario.disturbance.sizes.time = 12.0;
    let (motion, _) = motion(&scenario);
    let (gamma, load, dt) =
        (motion.values(Output::PathAngle), motion.values(Output::NormalLoad), motion.response.dt);
    let trim = motion.model.trim;
    for k in 150..gamma.len() - 2 {
        let rate = (gamma[k - 2] - gamma[k + 2] + 8.0 * (gamma[k + 1] - gamma[k - 1])) / (12.0 * dt);
        let curvature = trim.speed * rate / trim.gravity;
        assert!((load[k] - curvature).abs() < 1e-6, "at {k}: {} should be {curvature}", load[k]);
    }
}

/// A banked turn without sideslip is felt straight down: n_y has no part of φ once v̇ and r balance it.
#[test]
fn in_steady_sideslip_the_seat_pushes_as_hard_as_the_bank_leans() {
    let mut scenario = scenario("navion", Plane::Lateral, Source::Release, Shape::Step);
    scenario.disturbance.sizes.released.lateral = [0.1, 0.0, 0.0, 0.0];
    let (motion, _) = motion(&scenario);
    // At release nothing turns yet: n_y g = Yv v, the force alone.
    let v = 0.1 * motion.model.trim.speed;
    let force = motion.model.a[(0, 0)] * v / motion.model.trim.gravity;
    assert!((motion.values(Output::SideLoad)[0] - force).abs() < 1e-12);
    assert!(force < 0.0, "wind from the right pushes to the left");
}

#[test]
fn in_a_sharp_gust_the_angle_of_attack_is_felt_at_once() {
    let scenario = scenario("navion", Plane::Longitudinal, Source::VerticalGust, Shape::Step);
    let (motion, _) = motion(&scenario);
    let first = ((START / motion.response.dt).round()) as usize;
    let felt = motion.values(Output::AngleOfAttack)[first];
    let speed = motion.model.trim.speed;
    assert!((felt - scenario.disturbance.sizes.vertical_gust / speed).abs() < 1e-12, "{felt}");
    // Lift at once: about V Zw w_g/(g V).
    let load = motion.values(Output::NormalLoad)[first];
    let expected =
        -motion.model.a[(1, 1)] * scenario.disturbance.sizes.vertical_gust / motion.model.trim.gravity;
    assert!((load - expected).abs() < 1e-12 && load > 0.3, "{load}");
}

/// After a long sine the motion is that of the frequency response: gain and phase, without any eigenvector or inverse.
#[test]
fn a_long_sine_ends_as_the_frequency_response_says() {
    for (key, plane, source, output) in [
        ("navion", Plane::Longitudinal, Source::Elevator, Output::PitchRate),
        ("navion", Plane::Longitudinal, Source::Elevator, Output::NormalLoad),
        ("a4d", Plane::Longitudinal, Source::VerticalGust, Output::AngleOfAttack),
        ("a4d", Plane::Lateral, Source::Rudder, Output::Sideslip),
        ("c47", Plane::Lateral, Source::SideGust, Output::SideLoad),
    ] {
        let mut scenario = scenario(key, plane, source, Shape::Sine);
        let sizes = &mut scenario.disturbance.sizes;
        (sizes.frequency, sizes.lasting, sizes.time) = (2.0, 3000.0, 300.0);
        let (motion, modes) = motion(&scenario);
        let row = output.row(&motion.model, &motion.forced);
        let gain = transfer(&motion.forced, &row, 0, 2.0).expect("a gain");
        let amplitude = match &motion.forced.forcings[0].input {
            Input::Sine { amplitude, .. } => *amplitude,
            other => unreachable!("{other:?}"),
        };
        let values = motion.values(output);
        let slowest = modes.iter().map(|mode| mode.lambda.re).fold(f64::MIN, f64::max);
        let left = (slowest * 298.0).exp();
        for (k, value) in values.iter().enumerate().skip(1150) {
            let t = k as f64 * motion.response.dt - START;
            let wanted = amplitude * (gain.norm() * (2.0 * t + gain.arg()).sin());
            let allowed = (40.0 * left + 1e-9) * amplitude.abs() * gain.norm();
            assert!((value - wanted).abs() <= allowed, "{key} {output:?} at {k}: {value} should be {wanted}");
        }
    }
}

#[test]
fn the_peaks_are_the_short_period_and_the_dutch_roll() {
    let peaks_of = |key, plane, source, output: Output| {
        let (motion, modes) = motion(&scenario(key, plane, source, Shape::Step));
        let row = output.row(&motion.model, &motion.forced);
        let points = frequency_response(&motion.forced, &row, 0, (0.01, 100.0), 400);
        let value = |frequency: f64| transfer(&motion.forced, &row, 0, frequency);
        (peaks(&value, &points, &modes), modes)
    };
    let (found, modes) = peaks_of("navion", Plane::Lateral, Source::Rudder, Output::Sideslip);
    let dutch = found.iter().find(|peak| peak.mode == ModeName::DutchRoll).expect("a Dutch-roll peak");
    let mode = modes.iter().find(|mode| mode.naming.name == ModeName::DutchRoll).expect("a Dutch roll");
    // A lightly damped pair peaks at ωₙ √(1 − 2ζ²).
    let (wn, zeta) = (mode.natural_frequency().expect("a pair"), mode.damping_ratio().expect("a pair"));
    assert!((dutch.frequency / (wn * (1.0 - 2.0 * zeta * zeta).sqrt()) - 1.0).abs() < 0.05);
    let (found, _) = peaks_of("navion", Plane::Longitudinal, Source::Elevator, Output::PitchRate);
    let names: Vec<ModeName> = found.iter().map(|peak| peak.mode).collect();
    assert_eq!(names, [ModeName::Phugoid, ModeName::ShortPeriod]);
}

/// A pitching motion by itself, θ̈ + 2ζωₙ θ̇ + ωₙ² θ = ωₙ² δ, beside u̇ = −u + δ, with a step of δ at 1 s.
fn on_paper(zeta: f64, wn: f64, amplitude: f64) -> (PlaneModel, Vec<Mode>, DrivenSystem) {
    #[rustfmt::skip]
    let a = Matrix4::new(
        -1.0,  0.0,              0.0,       0.0,
         0.0, -6.0,              0.0,       0.0,
         0.0,  0.0, -2.0 * zeta * wn, -wn * wn,
         0.0,  0.0,              1.0,       0.0,
    );
    let trim = Trim { speed: 10.0, alpha0: 0.0, gamma0: 0.0, gravity: STANDARD_GRAVITY };
    let model = PlaneModel { plane: Plane::Longitudinal, a, b: Matrix4x2::zeros(), trim, further: None };
    let modes = modes(&model).expect("modes");
    let column = Vector4::new(1.0, 0.0, wn * wn, 0.0);
    (model, modes, DrivenSystem::from_rest(a, column, Input::Step { amplitude, start: 1.0 }))
}

/// 1 − e^{−t} never goes beyond, rises in ln 9 and is settled at ln 50.
#[test]
fn a_motion_that_creeps_to_its_end_has_no_overshoot() {
    let (model, modes, forced) = on_paper(0.3, 2.0, 0.5);
    let row = Output::ForwardSpeed.row(&model, &forced);
    let figures = step_metrics(&model, &modes, &forced, &row, 1.0, 0.5).expect("figures");
    assert_eq!(figures.overshoot, 0.0);
    assert!((figures.rise_time.expect("it rises") - 9_f64.ln()).abs() < 1e-9);
    assert!((figures.settling_time - 50_f64.ln()).abs() < 1e-9, "{}", figures.settling_time);
}

#[test]
fn the_figures_of_a_second_order_step_are_the_textbooks() {
    // y = 1 − e^{−ζωt} (cos ω_d t + ζ/√(1−ζ²) sin ω_d t), ζ = 0.3, ωₙ = 2: overshoot e^{−πζ/√(1−ζ²)} = 37.23 %
    let (zeta, wn) = (0.3_f64, 2.0);
    let wd = wn * (1.0 - zeta * zeta).sqrt();
    let y = |t: f64| {
        1.0 - (-zeta * wn * t).exp() * ((wd * t).cos() + zeta / (1.0 - zeta * zeta).sqrt() * (wd * t).sin())
    };
    let (model, modes, forced) = on_paper(zeta, wn, 0.5);
    let row = Output::PitchAngle.row(&model, &forced);
    let figures = step_metrics(&model, &modes, &forced, &row, 1.0, 0.5).expect("figures");
    let expected = (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
    assert!((figures.overshoot - expected).abs() < 1e-9, "{} {expected}", figures.overshoot);
    let course = Course::new(&model, &forced, &modes, 20.0);
    let (time, value) = peak(&course, &row).expect("a peak");
    assert!(
        (value / 0.5 - 1.0 - expected).abs() < 1e-9 && (time - 1.0 - std::f64::consts::PI / wd).abs() < 1e-5
    );
    // Rise by its own equation: first times at which y is 0.1 and 0.9.
    let first = |level: f64| {
        let (mut low, mut high) = (0.0, std::f64::consts::PI / wd);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if y(middle) < level { low = middle } else { high = middle }
        }
        low
    };
    let rise = first(0.9) - first(0.1);
    assert!((figures.rise_time.expect("it rises") - rise).abs() < 1e-9);
    // Settled: no later time is outside, the one before is.
    let settled = figures.settling_time;
    let outside = |t: f64| (y(t) - 1.0).abs() > 0.02;
    assert!(outside(settled - 1e-6) && (0..90_000).all(|k| !outside(settled + 1e-9 + 1e-4 * f64::from(k))));
}

fn course<'a>(motion: &'a Motion, modes: &[Mode]) -> Course<'a> {
    Course::new(&motion.model, &motion.forced, modes, motion.experiment.grid.duration)
}

/// Peak and its time, rise, settling and overshoot of every output.
fn figures(scenario: &Scenario) -> Vec<(Output, [f64; 2], Option<[f64; 3]>)> {
    let (motion, modes) = motion(scenario);
    let of = |&output: &Output| {
        let row = output.row(&motion.model, &motion.forced);
        let (time, value) = peak(&course(&motion, &modes), &row).expect("a peak");
        let amplitude = motion.forced.forcings[0].input.at(START);
        let steady = steady_output(&modes, &row, &motion.forced, 0, amplitude);
        let figures = steady
            .and_then(|steady| step_metrics(&motion.model, &modes, &motion.forced, &row, START, steady));
        let of_step = figures.map(|f| [f.rise_time.unwrap_or(-1.0), f.settling_time, f.overshoot]);
        (output, [time, value], of_step)
    };
    Output::of(scenario.plane).iter().map(of).collect()
}

/// By a fine grid on its own: 0.0969 rad/s at 1.200 s, however much is shown; 300 s in 1,200 steps see 0.0626.
#[test]
fn a_peak_is_the_motions_own_whatever_is_shown() {
    for time in [5.0, 60.0, 300.0] {
        let mut scenario = scenario("navion", Plane::Lateral, Source::Aileron, Shape::Pulse);
        scenario.disturbance.sizes.time = time;
        let (_, [at, peak], _) =
            figures(&scenario).into_iter().find(|(of, ..)| *of == Output::RollRate).expect("p");
        assert!((peak - 0.096_94).abs() < 5e-6 && (at - 1.2).abs() < 1e-6, "{time} s: {peak} at {at}");
    }
    let mut shorter = scenario("navion", Plane::Longitudinal, Source::Elevator, Shape::Pulse);
    shorter.disturbance.sizes.time = 61.7;
    let mut longer = shorter.clone();
    longer.disturbance.sizes.time = 300.0;
    for ((output, of_shorter, _), (_, of_longer, _)) in figures(&shorter).into_iter().zip(figures(&longer)) {
        // The path has no peak but its end.
        if matches!(output, Output::Height | Output::Distance) {
            continue;
        }
        for (a, b) in of_shorter.into_iter().zip(of_longer) {
            assert!((a - b).abs() <= 1e-6 * b.abs(), "{output:?}: {a} {b}");
        }
    }
}

/// Beside samples a hundredth of a second apart, of steps, pulses, sines and gusts: no sample is beyond the peak, none is far from it.
#[test]
fn no_sample_is_beyond_the_peak() {
    for (key, plane, source, shape) in [
        ("navion", Plane::Longitudinal, Source::Elevator, Shape::Step),
        ("x15", Plane::Lateral, Source::Aileron, Shape::Doublet),
        ("a4d", Plane::Longitudinal, Source::VerticalGust, Shape::OneMinusCosine),
        ("b747-approach", Plane::Lateral, Source::Rudder, Shape::ThreeTwoOneOne),
        ("citation", Plane::Longitudinal, Source::HeadGust, Shape::Sine),
        ("navion", Plane::Lateral, Source::Turbulence, Shape::Step),
    ] {
        let mut scenario = scenario(key, plane, source, shape);
        scenario.disturbance.sizes.time = 20.0;
        let (motion, modes) = motion(&scenario);
        let fine = respond(&motion.forced, TimeGrid { duration: 20.0, steps: 2000 });
        assert_eq!(motion.small_until, None, "{key}");
        for &output in Output::of(plane) {
            let row = output.row(&motion.model, &motion.forced);
            let (_, value) = peak(&course(&motion, &modes), &row).expect("a peak");
            let most = row.of(&motion.forced, &fine).fold(0.0, |most: f64, x| most.max(x.abs()));
            let size = value.abs();
            assert!(size >= most * (1.0 - 1e-9), "{key} {output:?}: {size} below {most}");
            // At an edge the sample is the value after it.
            assert!(size <= most * 1.05 + 1e-12, "{key} {output:?}: {size} beyond {most}");
        }
    }
}

/// As found by other means: the envelope of the phugoid takes far longer than what is shown.
#[test]
fn settled_is_what_stays_settled() {
    for (key, output, expected) in [
        ("navion", Output::PitchAngle, 305.6),
        ("navion", Output::ForwardSpeed, 223.7),
        ("b747-approach", Output::ForwardSpeed, 2207.0),
    ] {
        let mut settled = Vec::new();
        for time in [20.0, 60.0, 300.0] {
            let mut scenario = scenario(key, Plane::Longitudinal, Source::Elevator, Shape::Step);
            scenario.disturbance.sizes.time = time;
            let (_, _, of_step) = figures(&scenario).into_iter().find(|(of, ..)| *of == output).expect("it");
            settled.push(of_step.expect("figures")[1]);
        }
        assert!((settled[0] - expected).abs() < 5e-4 * expected, "{key} {output:?}: {settled:?}");
        assert!(settled.iter().all(|time| (time - settled[0]).abs() < 1e-6), "{key} {output:?}: {settled:?}");
        // By brute force: the last of samples 0.05 s apart that is outside.
        let (motion, modes) = motion(&scenario(key, Plane::Longitudinal, Source::Elevator, Shape::Step));
        let row = output.row(&motion.model, &motion.forced);
        let steady = steady_output(&modes, &row, &motion.forced, 0, 1_f64.to_radians()).expect("stable");
        let long = respond(&motion.forced, TimeGrid { duration: 4000.0, steps: 80_000 });
        let last =
            row.of(&motion.forced, &long).enumerate().filter(|(_, y)| (y / steady - 1.0).abs() > 0.02).last();
        let time = last.expect("it begins outside").0 as f64 * long.dt - START;
        assert!((settled[0] - time).abs() <= long.dt, "{key} {output:?}: {} {time}", settled[0]);
    }
}

#[test]
fn the_steady_value_is_where_the_step_ends() {
    let mut scenario = scenario("navion", Plane::Longitudinal, Source::Elevator, Shape::Step);
    scenario.disturbance.sizes.time = 300.0;
    let (motion, modes) = motion(&scenario);
    for output in [Output::ForwardSpeed, Output::AngleOfAttack, Output::PitchAngle, Output::PathAngle] {
        let row = output.row(&motion.model, &motion.forced);
        let steady = steady_output(&modes, &row, &motion.forced, 0, scenario.disturbance.sizes.elevator);
        let end = *motion.values(output).last().expect("samples");
        // The phugoid has halved 7 times.
        let most = peak(&course(&motion, &modes), &row).expect("a peak").1.abs();
        assert!((end - steady.expect("stable")).abs() < 0.02 * most, "{output:?}");
    }
    let row = Output::Height.row(&motion.model, &motion.forced);
    assert_eq!(steady_output(&modes, &row, &motion.forced, 0, 1.0), None, "a path has no end");
}

/// CAP by the response beside CAP by the formula of the specification, ωₙ²/(n/α): the lift of the elevator itself apart, the same.
#[test]
fn control_anticipation_by_the_response_is_that_of_the_specification() {
    for key in ["navion", "a4d", "cherokee-180"] {
        let (motion, modes) = motion(&scenario(key, Plane::Longitudinal, Source::Elevator, Shape::Step));
        let seen = control_anticipation(&motion.model, &modes, &motion.forced, 0).expect("a short period");
        let mode =
            modes.iter().find(|mode| mode.naming.name == ModeName::ShortPeriod).expect("a short period");
        let load_per_alpha = -motion.model.a[(1, 1)] * motion.model.trim.speed / motion.model.trim.gravity;
        let formula = mode.natural_frequency().expect("a pair").powi(2) / load_per_alpha;
        assert!((seen / formula - 1.0).abs() < 0.12, "{key}: {seen} beside {formula}");
    }
}

/// A conservative phugoid trades g h for V u: the swing of the height is that of the speed times V/g.
#[test]
fn the_phugoid_swings_in_height_as_in_speed() {
    let scenario = scenario("navion", Plane::Longitudinal, Source::Elevator, Shape::Step);
    let (motion, modes) = motion(&scenario);
    let swing = |output: Output| {
        phugoid_swing(&motion.model, &modes, &motion.forced, &output.row(&motion.model, &motion.forced))
    };
    let (of_height, of_speed) =
        (swing(Output::Height).expect("a swing"), swing(Output::ForwardSpeed).expect("a swing"));
    assert!((of_height - 58.97).abs() < 0.02, "{of_height} m");
    // The height turns half a swing before the speed does, when it was greater by e^{πζ/√(1 − ζ²)}.
    let zeta = modes[1].damping_ratio().expect("a phugoid");
    let earlier = (std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
    let traded = of_speed * earlier * motion.model.trim.speed / STANDARD_GRAVITY;
    assert!((of_height / traded - 1.0).abs() < 0.02, "{of_height} m beside {traded} m");
}

/// Over whole periods a sine of amplitude a has a/√2, a constant added to it adds its square; no size runs over.
#[test]
fn the_root_mean_square_is_that_of_a_sine_at_any_size() {
    for size in [1.0, 3e-200, 1e300] {
        let values: Vec<f64> =
            (0..400).map(|k| size * (0.5 + (f64::from(k) * std::f64::consts::TAU / 100.0).sin())).collect();
        let expected = size * 0.75_f64.sqrt();
        let found = root_mean_square(&values).expect("values");
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} beside {expected}");
    }
    assert_eq!((root_mean_square(&[0.0; 3]), root_mean_square(&[])), (Some(0.0), None));
    assert_eq!(root_mean_square(&[-2.0]), Some(2.0), "of the population: one value is its own");
}

#[test]
fn thirty_degrees_of_bank_come_when_the_curve_crosses_them() {
    let mut scenario = scenario("navion", Plane::Lateral, Source::Aileron, Shape::Step);
    scenario.disturbance.sizes.aileron = 0.1;
    scenario.disturbance.sizes.time = 10.0;
    let (motion, modes) = motion(&scenario);
    let row = Output::BankAngle.row(&motion.model, &motion.forced);
    let time = time_to_bank(&course(&motion, &modes), &row, START).expect("it banks");
    // An aircraft that banks for as long as this stands at 30° then.
    let long = respond(&motion.forced, TimeGrid { duration: START + time, steps: 100 });
    let end = row.of(&motion.forced, &long).last().expect("samples");
    assert!((end.abs() - 30_f64.to_radians()).abs() < 1e-9, "{end}");
    scenario.disturbance.sizes.time = 1.5;
    let (motion, modes) = self::motion(&scenario);
    assert_eq!(time_to_bank(&course(&motion, &modes), &row, START), None, "not within the time shown");
}

/// The air doesn't change when more of it is shown, and the same number is always the same air.
#[test]
fn turbulence_is_the_same_air_however_long_it_is_watched() {
    let mut scenario = scenario("b747-fc9", Plane::Longitudinal, Source::Turbulence, Shape::Step);
    let (short, _) = motion(&scenario);
    scenario.disturbance.sizes.time = 120.0;
    let (long, _) = motion(&scenario);
    let (short, long) = (short.values(Output::AngleOfAttack), long.values(Output::AngleOfAttack));
    assert_near(&long[..short.len()], &short, 1e-9, "the first minute");
    scenario.disturbance.sizes.seed = 2.0;
    assert!(motion(&scenario).0.values(Output::AngleOfAttack)[..600] != long[..600]);
}

/// Linear: twice the air is twice the motion, and the factor on all disturbances is such a factor.
#[test]
fn twice_the_disturbance_is_twice_the_motion() {
    for (plane, sources) in
        [(Plane::Longitudinal, Source::of(Plane::Longitudinal)), (Plane::Lateral, Source::of(Plane::Lateral))]
    {
        for &source in sources {
            let mut scenario = scenario("a4d", plane, source, Shape::Step);
            scenario.disturbance.choices[plane].control_shape = Shape::Doublet;
            let (once, _) = motion(&scenario);
            scenario.disturbance.sizes.times = 2.0;
            let (twice, _) = motion(&scenario);
            for &output in Output::of(plane) {
                let doubled: Vec<f64> = once.values(output).iter().map(|x| 2.0 * x).collect();
                assert_near(&twice.values(output), &doubled, 1e-9, words::disturbance::source(source));
            }
        }
    }
}

/// Small enough, the nonlinear flight shows every output that the linear motion shows: the same sign, unit and meaning.
#[test]
fn every_output_of_a_small_nonlinear_flight_is_the_linear_one() {
    for key in ["navion", "bristol-f2b", "b747-fc9", "x15"] {
        for plane in Plane::ALL {
            for &source in Source::of(plane) {
                let mut scenario = scenario(key, plane, source, Shape::Step);
                scenario.disturbance.choices[plane].control_shape = Shape::Doublet;
                scenario.disturbance.choices[plane].gust_shape = Shape::OneMinusCosine;
                scenario.disturbance.sizes.times = 1e-3;
                scenario.disturbance.sizes.time = 8.0;
                let findings = Findings::of(scenario);
                let Some(motion) = findings.motion() else { continue };
                let flight = findings.flight().and_then(|flight| flight.as_ref().ok()).expect("a flight");
                assert_eq!(flight.stop, None, "{key} {source:?}");
                for &output in Output::of(plane) {
                    let linear = motion.values(output);
                    let flown = output.of_flight(&motion.model, flight);
                    // The integrator's 1e-9 a step, of a path of some kilometres, is the floor: what hardly moves can't be told from it.
                    let floor = match output {
                        Output::Distance | Output::Height | Output::Offset => 3e-5,
                        _ => 3e-7,
                    };
                    let most = linear.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                    for (k, (flown, linear)) in flown.iter().zip(&linear).enumerate() {
                        let off = (flown - linear).abs();
                        assert!(
                            off <= 5e-3 * most + floor,
                            "{key} {source:?} {output:?} at {k}: {flown:e} should be {linear:e} of {most:e}"
                        );
                    }
                }
            }
        }
    }
}
