//! What holds for the response of every linear model.

use eigenwing::flight::modes::eigen::eigen;
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{
    CUT_LIMIT, DrivenSystem, MOST_STEPS, Response, TimeGrid, steady_state,
};
use nalgebra::{Matrix4, Vector4};
use proptest::prelude::*;

/// A light aircraft in SI units (the lesson's, g and velocities in one unit): stable, with a slow oscillation.
fn aircraft() -> (Matrix4<f64>, Vector4<f64>) {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -9.80665, -0.369, -2.02, 53.6448, 0.0, 0.006266, -0.12992, -2.98, 0.0, 0.0, 0.0,
        1.0, 0.0,
    ]);
    (a, Vector4::new(0.0, -8.595, -9.72, 0.0))
}

const GRID: TimeGrid = TimeGrid { duration: 30.0, steps: 600 };

fn step(amplitude: f64, start: f64) -> Input {
    Input::Step { amplitude, start }
}

fn respond(a: &Matrix4<f64>, b: &Vector4<f64>, input: &Input, grid: TimeGrid) -> Response {
    eigenwing::flight::motion::response::respond(&DrivenSystem::from_rest(*a, *b, input.clone()), grid)
}

fn run(input: &Input, grid: TimeGrid) -> Response {
    let (a, b) = aircraft();
    respond(&a, &b, input, grid)
}

/// Two responses, sample `stride * k` of the finer against sample k, relative to the largest motion.
fn assert_agree(finer: &Response, coarser: &Response, stride: usize) {
    let largest = coarser.states.iter().fold(0.0, |largest: f64, x| largest.max(x.amax()));
    for (k, x) in coarser.states.iter().enumerate() {
        let off = (finer.states[stride * k] - x).amax();
        assert!(off <= 1e-11 * largest, "sample {k}: off by {off:e} of {largest}");
    }
}

fn small_models() -> impl Strategy<Value = (Matrix4<f64>, Vector4<f64>)> {
    let entries = proptest::collection::vec(-1.0..1.0_f64, 20);
    entries.prop_map(|x| (Matrix4::from_row_slice(&x[..16]), Vector4::from_row_slice(&x[16..])))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn half_the_samples_are_the_same_motion((a, b) in small_models(), start in -1.0..6.0, duration in 0.0..3.0) {
        let pulse = Input::Pulse { amplitude: 1.0, start, duration };
        let finer = respond(&a, &b, &pulse, TimeGrid { duration: 6.0, steps: 80 });
        let coarser = respond(&a, &b, &pulse, TimeGrid { duration: 6.0, steps: 40 });
        prop_assert_eq!(finer.states.len(), 81);
        assert_agree(&finer, &coarser, 2);
    }

    #[test]
    fn the_motion_satisfies_its_equation((a, b) in small_models(), amplitude in -2.0..2.0) {
        // Central difference of five samples against A x + B δ; its error is x⁽⁵⁾ dt⁴/30.
        let grid = TimeGrid { duration: 2.0, steps: 1000 };
        let response = respond(&a, &b, &step(amplitude, 0.0), grid);
        let (x, h) = (&response.states, response.dt);
        for k in 2..x.len() - 2 {
            let slope = (x[k - 2] - x[k + 2] + (x[k + 1] - x[k - 1]) * 8.0) / (12.0 * h);
            let off = (slope - a * x[k] - b * amplitude).amax();
            prop_assert!(off <= 1e-9 * x[k].amax().max(10.0), "{off:e}");
        }
    }

    #[test]
    fn whatever_the_input_is_the_response_is_finite_or_cut(
        kind in 0..8_usize,
        numbers in proptest::collection::vec(prop_oneof![Just(0.0), -20.0..20.0, -1e300..1e300, any::<f64>()], 5),
        samples in proptest::collection::vec(prop_oneof![-1.0..1.0, any::<f64>()], 0..20),
        (time, rates) in (0.1..100.0, any::<bool>()),
    ) {
        let [amplitude, start, duration, from, to] = numbers[..] else { unreachable!("five numbers") };
        let input = match kind {
            0 => Input::Step { amplitude, start },
            1 => Input::Pulse { amplitude, start, duration },
            2 => Input::Doublet { amplitude, start, duration },
            3 => Input::ThreeTwoOneOne { amplitude, start, unit: duration },
            4 => Input::Sine { amplitude, start, duration, frequency: from },
            5 => Input::Sweep { amplitude, start, duration, from, to },
            6 => Input::OneMinusCosine { amplitude, start, duration },
            _ => Input::Samples { dt: duration, values: samples.into() },
        };
        let (a, b) = aircraft();
        let mut forced = DrivenSystem::from_rest(a, b, input);
        if rates {
            forced.forcings[0].rate_column = b;
        }
        let response = eigenwing::flight::motion::response::respond(&forced, TimeGrid { duration: time, steps: 60 });
        assert_honest(&response);
        prop_assert_eq!(response.states.len(), response.path.len());
        prop_assert!(response.cut_at.is_some() || response.states.len() == 61);
    }

    #[test]
    fn whatever_the_numbers_are_the_response_is_finite_or_cut(
        entries in proptest::collection::vec(prop_oneof![Just(0.0), -1e3..1e3, -1e300..1e300, any::<f64>()], 24),
        steps in 0..50_usize,
    ) {
        let (a, b) = (Matrix4::from_row_slice(&entries[..16]), Vector4::from_row_slice(&entries[16..20]));
        let input = Input::Pulse { amplitude: entries[20], start: entries[21], duration: entries[22] };
        let response = respond(&a, &b, &input, TimeGrid { duration: entries[23], steps });
        assert_honest(&response);
        prop_assert!(response.states.len() <= steps + 1);
    }
}

/// Finite, within the limit, and either complete or cut.
fn assert_honest(response: &Response) {
    assert!(!response.states.is_empty());
    assert!(response.dt.is_finite());
    assert!(response.states.iter().all(|x| x.iter().all(|value| value.abs() <= CUT_LIMIT)));
}

#[test]
fn no_input_is_no_motion() {
    for input in [step(0.0, 0.0), Input::Pulse { amplitude: 1.0, start: 1.0, duration: 0.0 }, step(1.0, 31.0)]
    {
        let response = run(&input, GRID);
        assert_eq!(response.states.len(), 601);
        assert!(response.states.iter().all(|x| *x == Vector4::zeros()));
        assert_eq!(response.cut_at, None);
    }
}

#[test]
fn nothing_moves_before_the_edge_and_something_right_after() {
    for (start, last_still) in [(1.0, 20), (1.01, 20), (0.99, 19)] {
        let response = run(&step(0.01, start), GRID);
        let still = response.states.iter().take_while(|x| **x == Vector4::zeros()).count();
        assert_eq!(still, last_still + 1, "edge at {start}");
    }
}

#[test]
fn the_response_is_linear_in_the_amplitude() {
    let (one, three) = (run(&step(0.01, 1.0), GRID), run(&step(-0.03, 1.0), GRID));
    let scaled = Response { states: one.states.iter().map(|x| x * -3.0).collect(), ..one };
    assert_agree(&three, &scaled, 1);
}

#[test]
fn a_pulse_is_a_step_less_a_delayed_step() {
    // Edges on samples, between samples, and both in one step.
    for (start, duration) in [(1.0, 2.0), (1.013, 2.171), (1.013, 0.004), (0.0, 0.02)] {
        let pulse = run(&Input::Pulse { amplitude: 0.01, start, duration }, GRID);
        let (first, second) = (run(&step(0.01, start), GRID), run(&step(0.01, start + duration), GRID));
        let states = first.states.iter().zip(&second.states).map(|(x, y)| x - y).collect();
        assert_agree(&pulse, &Response { states, ..first }, 1);
    }
}

#[test]
fn an_edge_between_samples_is_exact() {
    // On the fine grid 1.013 s and 3.184 s are samples.
    let pulse = Input::Pulse { amplitude: 0.01, start: 1.013, duration: 2.171 };
    let fine = run(&pulse, TimeGrid { duration: 30.0, steps: 30_000 });
    assert_agree(&fine, &run(&pulse, GRID), 50);
    assert_agree(&fine, &run(&pulse, TimeGrid { duration: 30.0, steps: 4 }), 7500);
}

#[test]
fn a_step_before_the_start_acts_from_the_start() {
    assert!(run(&step(0.01, -5.0), GRID) == run(&step(0.01, 0.0), GRID));
}

#[test]
fn a_stable_aircraft_settles_at_minus_a_inverse_b() {
    let (a, elevator) = aircraft();
    let gust = -a.column(1);
    for b in [elevator, gust.into_owned()] {
        let response = respond(&a, &b, &step(0.01, 0.0), TimeGrid { duration: 2000.0, steps: 100 });
        let steady = steady_state(&a, &b).expect("A is not singular") * 0.01;
        let last = response.states[100];
        assert!((last - steady).amax() <= 1e-10 * steady.amax(), "{last} should be {steady}");
    }
}

#[test]
fn a_steady_vertical_gust_only_carries_the_aircraft_along() {
    // A w = A[:, w]: after a gust w_g the aircraft sinks with the air and all else is as before.
    let (a, _) = aircraft();
    let steady = steady_state(&a, &-a.column(1)).expect("A is not singular");
    assert!((steady - Vector4::new(0.0, 1.0, 0.0, 0.0)).amax() < 1e-12, "{steady}");
}

#[test]
fn a_singular_model_has_no_steady_state() {
    assert_eq!(steady_state(&Matrix4::zeros(), &Vector4::x()), None);
}

#[test]
fn a_growing_motion_is_cut_at_the_limit() {
    let (mut a, b) = aircraft();
    // Nose-up moment that grows with angle of attack: a divergence.
    a[(2, 1)] = 0.5;
    let growth =
        eigen(&a).expect("finite").values.iter().fold(f64::MIN, |largest, value| largest.max(value.re));
    assert!(growth > 1.0);
    let response = respond(&a, &b, &step(0.01, 0.0), TimeGrid { duration: 600.0, steps: 6000 });
    assert_honest(&response);
    let cut = response.cut_at.expect("it grows beyond the limit");
    assert!((cut - response.dt * response.states.len() as f64).abs() < 1e-9);
    let (last, next) = (response.states[response.states.len() - 1].amax(), (growth * response.dt).exp());
    assert!(last * next > 0.99 * CUT_LIMIT && last <= CUT_LIMIT);
}

#[test]
fn numbers_that_are_not_finite_are_cut_at_the_first_sample() {
    let (a, b) = aircraft();
    let (mut bad_a, mut bad_b) = (a, b);
    bad_a[(0, 0)] = f64::NAN;
    bad_b[1] = f64::INFINITY;
    let step = step(1.0, 0.0);
    let late = Input::Pulse { amplitude: f64::NAN, start: 1.0, duration: 1.0 };
    for (a, b, input) in
        [(bad_a, b, step.clone()), (a, bad_b, step.clone()), (a * -1e300, b, step), (a, b, late)]
    {
        let response = respond(&a, &b, &input, GRID);
        assert_eq!(response.states.len(), 1);
        assert_eq!(response.cut_at, Some(response.dt));
    }
}

#[test]
fn a_grid_without_time_has_only_the_start() {
    for grid in [
        TimeGrid { duration: 0.0, steps: 10 },
        TimeGrid { duration: -1.0, steps: 10 },
        TimeGrid { duration: f64::NAN, steps: 10 },
        TimeGrid { duration: f64::INFINITY, steps: 10 },
        TimeGrid { duration: 10.0, steps: 0 },
    ] {
        let response = run(&step(1.0, 0.0), grid);
        assert_eq!((response.states.len(), response.dt, response.cut_at), (1, 0.0, None));
    }
}

#[test]
fn too_many_steps_are_cut_not_taken() {
    let response = run(&step(0.01, 0.0), TimeGrid { duration: 30.0, steps: usize::MAX });
    assert_eq!(response.states.len(), MOST_STEPS + 1);
    assert!(response.cut_at.is_some());
}
