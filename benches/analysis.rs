//! What one movement of a slider costs.

use criterion::{Criterion, criterion_group, criterion_main};
use eigenwing::flight::eigen::{EigenError, eigen};
use eigenwing::flight::inputs::Input;
use eigenwing::flight::response::{Response, TimeGrid, respond};
use nalgebra::{Matrix4, Vector4};
use std::hint::black_box;

const GRID: TimeGrid = TimeGrid {
    duration: 60.0,
    steps: 1200,
};
const STEP: Input = Input::Step {
    amplitude: 0.0175,
    start: 1.0,
};
const PULSE: Input = Input::Pulse {
    amplitude: 0.0175,
    start: 1.0,
    duration: 0.33,
};

/// The lesson's light aircraft, g in the unit of the other entries; the same numbers as in `compare_with_python_control.py`.
fn model() -> (Matrix4<f64>, Vector4<f64>) {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0,
        1.0, 0.0,
    ]);
    (a, Vector4::new(0.0, -0.282, -9.72, 0.0))
}

/// All that follows from a new matrix: modes with participation, and two responses of 1,201 points.
fn slider_tick(
    a: &Matrix4<f64>,
    b: &Vector4<f64>,
) -> Result<([[f64; 4]; 4], Response, Response), EigenError> {
    let modes = eigen(a)?;
    let participation = std::array::from_fn(|mode| modes.participation(mode));
    Ok((
        participation,
        respond(a, b, &STEP, GRID),
        respond(a, b, &PULSE, GRID),
    ))
}

fn analysis(criterion: &mut Criterion) {
    let (a, b) = model();
    criterion.bench_function("eigen", |bench| bench.iter(|| eigen(black_box(&a))));
    criterion.bench_function("respond_1201", |bench| {
        bench.iter(|| respond(black_box(&a), &b, &STEP, GRID))
    });
    criterion.bench_function("slider_tick", |bench| {
        bench.iter(|| slider_tick(black_box(&a), &b))
    });
}

criterion_group!(benches, analysis);
criterion_main!(benches);
