//! What one movement of a slider costs.

use criterion::{Criterion, criterion_group, criterion_main};
use eigenwing::flight::edits::Edited;
use eigenwing::flight::eigen::eigen;
use eigenwing::flight::inputs::Input;
use eigenwing::flight::plane::{Plane, PlaneModel, Trim};
use eigenwing::flight::response::{TimeGrid, respond};
use eigenwing::flight::study::{MatrixStudy, Study};
use eigenwing::flight::{Channel, Experiment, analyse};
use nalgebra::{Matrix4, Matrix4x2};
use std::hint::black_box;

const GRID: TimeGrid = TimeGrid { duration: 60.0, steps: 1200 };
const STEP: Input = Input::Step { amplitude: 0.0175, start: 1.0 };

/// The lesson's light aircraft, g in the unit of the other entries; the same numbers as in `compare_with_python_control.py`.
fn model() -> PlaneModel {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
    ]);
    let b = Matrix4x2::from_row_slice(&[0.0, 0.0, -0.282, 0.0, -9.72, 0.0, 0.0, 0.0]);
    let trim = Trim { speed: 1.76, alpha0: 0.0, gamma0: 0.0, gravity: 0.322 };
    PlaneModel { plane: Plane::Longitudinal, a, b, trim }
}

fn analysis(criterion: &mut Criterion) {
    let model = model();
    let (a, b) = (model.a, model.b.column(0).into_owned());
    let edited = Edited::new(Study::Matrices(MatrixStudy { longitudinal: Some(model), lateral: None }));
    let experiment =
        Experiment { plane: Plane::Longitudinal, channel: Channel::First, input: STEP, grid: GRID };
    criterion.bench_function("eigen", |bench| bench.iter(|| eigen(black_box(&a))));
    criterion.bench_function("respond_1201", |bench| bench.iter(|| respond(black_box(&a), &b, &STEP, GRID)));
    // All that follows from a new matrix: named modes, verdicts, and a response of 1,201 points.
    criterion
        .bench_function("slider_tick", |bench| bench.iter(|| analyse(black_box(&edited), None, &experiment)));
}

criterion_group!(benches, analysis);
criterion_main!(benches);
