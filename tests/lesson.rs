//! The lesson's model against python-control and SciPy (validation: the numbers are theirs, see the data file's source).

use eigenwing::flight::modes::eigen::{Eigen, eigen};
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{DrivenSystem, TimeGrid, respond, steady_state};
use nalgebra::{Matrix4, Vector4};
use serde::Deserialize;

#[derive(Deserialize)]
struct Golden {
    b: [f64; 4],
    neutral_gravity: f64,
    models: Vec<Model>,
}

#[derive(Deserialize)]
struct Model {
    name: String,
    a: [[f64; 4]; 4],
    modes: Vec<Mode>,
    step: Vec<StepSample>,
    pulse: Vec<PulseSample>,
}

#[derive(Deserialize)]
struct Mode {
    re: f64,
    im: f64,
    shape: [f64; 4],
    participation: [f64; 4],
}

#[derive(Deserialize)]
struct StepSample {
    t: f64,
    x: [f64; 4],
}

#[derive(Deserialize)]
struct PulseSample {
    index: usize,
    x: [f64; 4],
}

impl Golden {
    fn read() -> Self {
        serde_json::from_str(include_str!("data/lesson_golden.json")).expect("the data file reads")
    }

    fn b(&self) -> Vector4<f64> {
        self.b.into()
    }
}

impl Model {
    fn a(&self) -> Matrix4<f64> {
        Matrix4::from_fn(|i, j| self.a[i][j])
    }
}

fn solved(a: &Matrix4<f64>) -> Eigen {
    eigen(a).expect("a finite matrix has eigenvalues")
}

/// Relative to the value, or to 1e-9 where it is smaller: the smallest printed one is 2e-6 and zeros must be near zero.
fn assert_close(got: f64, want: f64, tolerance: f64, what: &str) {
    let error = (got - want).abs() / want.abs().max(1e-9);
    assert!(error <= tolerance, "{what}: {got} should be {want} (off by {error:.1e})");
}

fn assert_states(got: &Vector4<f64>, want: &[f64; 4], what: &str) {
    for (k, name) in ["u", "w", "q", "theta"].iter().enumerate() {
        assert_close(got[k], want[k], 1e-9, &format!("{what}, {name}"));
    }
}

#[test]
fn eigenvalues_are_scipys() {
    for model in Golden::read().models {
        let values = solved(&model.a()).values;
        for (pair, mode) in model.modes.iter().enumerate() {
            let value = values[2 * pair];
            assert_close(value.re, mode.re, 1e-10, &model.name);
            assert_close(value.im, mode.im, 1e-10, &model.name);
            assert_eq!(values[2 * pair + 1], value.conj());
        }
    }
}

#[test]
fn mode_shapes_and_participation_are_scipys() {
    for model in Golden::read().models {
        let solved = solved(&model.a());
        for (pair, mode) in model.modes.iter().enumerate() {
            let v = solved.right.column(2 * pair);
            for k in 0..4 {
                assert_close(v[k].norm() / v[3].norm(), mode.shape[k], 1e-9, &model.name);
                for column in [2 * pair, 2 * pair + 1] {
                    assert_close(solved.participation(column)[k], mode.participation[k], 1e-9, &model.name);
                }
            }
        }
    }
}

#[test]
fn the_step_response_is_python_controls() {
    let golden = Golden::read();
    let step = Input::Step { amplitude: 1.0, start: 0.0 };
    for model in &golden.models {
        for (steps, per_second) in [(60, 2.0), (3000, 100.0)] {
            let response = respond(
                &DrivenSystem::from_rest(model.a(), golden.b(), step.clone()),
                TimeGrid { duration: 30.0, steps },
            );
            assert_eq!(response.cut_at, None);
            for sample in &model.step {
                let index = (sample.t * per_second).round() as usize;
                assert_states(
                    &response.states[index],
                    &sample.x,
                    &format!("{} at {} s", model.name, sample.t),
                );
            }
        }
    }
}

#[test]
fn the_pulse_response_is_scipys_with_zero_order_hold() {
    let golden = Golden::read();
    let grid = TimeGrid { duration: 20.0, steps: 999 };
    let start = grid.time(50);
    let pulse = Input::Pulse { amplitude: 0.1, start, duration: grid.time(60) - start };
    for model in &golden.models {
        let response = respond(&DrivenSystem::from_rest(model.a(), golden.b(), pulse.clone()), grid);
        assert_eq!(response.states.len(), 1000);
        for sample in &model.pulse {
            assert_states(
                &response.states[sample.index],
                &sample.x,
                &format!("{} at {}", model.name, sample.index),
            );
        }
    }
}

#[test]
fn gravity_in_the_wrong_unit_does_not_change_the_steady_speed() {
    let golden = Golden::read();
    for (model, theta) in golden.models.iter().zip([-0.053_221_483_54, -1.621_437_122_87]) {
        let steady = steady_state(&model.a(), &golden.b()).expect("A is not singular");
        assert_states(&steady, &[10.025_489_155_7, -1.970_992_821_02, 0.0, theta], &model.name);
    }
}

#[test]
fn the_oscillation_turns_unstable_at_the_neutral_gravity() {
    let golden = Golden::read();
    let growth = |g: f64| {
        let mut a = golden.models[0].a();
        a[(0, 3)] = -g;
        solved(&a).values.iter().fold(f64::MIN, |largest, value| largest.max(value.re))
    };
    let (mut stable, mut unstable) = (0.322, 9.81);
    assert!(growth(stable) < 0.0 && growth(unstable) > 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (stable + unstable);
        if growth(middle) < 0.0 { stable = middle } else { unstable = middle }
    }
    assert_close(unstable, golden.neutral_gravity, 1e-10, "neutral gravity");
}

#[test]
fn the_unit_of_velocity_changes_no_eigenvalue() {
    // 100 ft/s = 30.48 m/s
    let unit = Matrix4::from_diagonal(&Vector4::new(30.48, 30.48, 1.0, 1.0));
    let inverse = Matrix4::from_diagonal(&Vector4::new(1.0 / 30.48, 1.0 / 30.48, 1.0, 1.0));
    for model in Golden::read().models {
        let (own, si) = (solved(&model.a()), solved(&(unit * model.a() * inverse)));
        for i in 0..4 {
            assert!((own.values[i] - si.values[i]).norm() < 1e-10, "{}", model.name);
            for k in 0..4 {
                assert_close(si.participation(i)[k], own.participation(i)[k], 1e-10, &model.name);
            }
        }
    }
}
