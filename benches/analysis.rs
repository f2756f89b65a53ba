//! What one movement of a slider costs.

use criterion::{Criterion, criterion_group, criterion_main};
use eigenwing::flight::eigen::eigen;
use eigenwing::flight::inputs::Input;
use eigenwing::flight::linear::LongitudinalModel;
use eigenwing::flight::response::{TimeGrid, respond};
use eigenwing::flight::{Channel, Experiment, analyse};
use nalgebra::{Matrix4, Vector4};
use std::hint::black_box;

const GRID: TimeGrid = TimeGrid { duration: 60.0, steps: 1200 };
const STEP: Input = Input::Step { amplitude: 0.0175, start: 1.0 };

/// The lesson's light aircraft, g in the unit of the other entries; the same numbers as in `compare_with_python_control.py`.
fn model() -> LongitudinalModel {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
    ]);
    LongitudinalModel { a, b_elevator: Vector4::new(0.0, -0.282, -9.72, 0.0), u0: 1.76 }
}

fn analysis(criterion: &mut Criterion) {
    let model = model();
    let (a, b) = (model.a, model.b_elevator);
    let experiment = Experiment { channel: Channel::Elevator, input: STEP, grid: GRID };
    criterion.bench_function("eigen", |bench| bench.iter(|| eigen(black_box(&a))));
    criterion.bench_function("respond_1201", |bench| bench.iter(|| respond(black_box(&a), &b, &STEP, GRID)));
    // All that follows from a new matrix: named modes, verdicts, and a response of 1,201 points.
    criterion.bench_function("slider_tick", |bench| bench.iter(|| analyse(black_box(&model), &experiment)));
}

criterion_group!(benches, analysis);
criterion_main!(benches);
