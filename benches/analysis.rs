//! What one movement of a slider costs.

use criterion::{Criterion, criterion_group, criterion_main};
use eigenwing::flight::approximations::approximations;
use eigenwing::flight::eigen::{EigenError, eigen, eigenvalues};
use eigenwing::flight::handling_qualities::handling_qualities;
use eigenwing::flight::inputs::Input;
use eigenwing::flight::inverse::{Adjustable, place_pole};
use eigenwing::flight::locus::locus;
use eigenwing::flight::mil_f_8785c::{Category, Class};
use eigenwing::flight::modes::modes;
use eigenwing::flight::plane::{Plane, PlaneModel, Trim};
use eigenwing::flight::response::{Response, TimeGrid, respond};
use eigenwing::flight::sensitivity::entry_sensitivity;
use eigenwing::flight::static_stability::plane_static_stability;
use nalgebra::{Complex, Matrix4, Matrix4x2, Vector4};
use std::hint::black_box;

const GRID: TimeGrid = TimeGrid { duration: 60.0, steps: 1200 };
const STEP: Input = Input::Step { amplitude: 0.0175, start: 1.0 };
const PULSE: Input = Input::Pulse { amplitude: 0.0175, start: 1.0, duration: 0.33 };

/// The lesson's light aircraft, g in the unit of the other entries; the same numbers as in `compare_with_python_control.py`.
fn model() -> (Matrix4<f64>, Vector4<f64>) {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
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
    Ok((participation, respond(a, b, &STEP, GRID), respond(a, b, &PULSE, GRID)))
}

/// The Navion of Teper (NASA CR-96008), 176 ft/s at sea level, in SI.
fn navion(plane: Plane) -> PlaneModel {
    let rows = match plane {
        Plane::Longitudinal => [
            -0.0451,
            0.03607,
            0.0,
            -9.8066352,
            -0.3697,
            -2.0244,
            53.6448,
            0.0,
            0.0062647654,
            -0.12963902,
            -2.98574,
            0.0,
            0.0,
            0.0,
            1.0,
            0.0,
        ],
        Plane::Lateral => [
            -0.2543,
            0.0,
            -53.6448,
            9.8066352,
            -0.29792263,
            -8.402,
            2.193,
            0.0,
            0.083791905,
            -0.3498,
            -0.7605,
            0.0,
            0.0,
            1.0,
            0.0,
            0.0,
        ],
    };
    PlaneModel {
        plane,
        a: Matrix4::from_row_slice(&rows),
        b: Matrix4x2::zeros(),
        trim: Trim { speed: 53.6448, alpha0: 0.0, gamma0: 0.0, gravity: 9.8066352 },
    }
}

fn modal(criterion: &mut Criterion) {
    for (plane, name) in [(Plane::Longitudinal, "longitudinal"), (Plane::Lateral, "lateral")] {
        let model = navion(plane);
        let found = modes(&model).unwrap_or_default();
        let mut bench = |what: &str, run: &dyn Fn()| {
            criterion.bench_function(&format!("{name}/{what}"), |bench| bench.iter(run));
        };
        bench("modes", &|| drop(black_box(modes(black_box(&model)))));
        bench("sensitivities_16_entries", &|| {
            for mode in &found {
                for k in 0..16 {
                    let _ = black_box(entry_sensitivity(black_box(mode), k / 4, k % 4));
                }
            }
        });
        bench("approximations", &|| drop(black_box(approximations(black_box(&model), &found))));
        bench("handling_qualities", &|| {
            drop(black_box(handling_qualities(black_box(&model), &found, Class::I, Category::B)));
        });
        bench("static_stability", &|| {
            let _ = black_box(plane_static_stability(black_box(&model)));
        });
        let entry = |value: f64| {
            let mut a = model.a;
            a[(2, if plane == Plane::Longitudinal { 1 } else { 0 })] *= value;
            Some(a)
        };
        bench("locus_200", &|| drop(black_box(locus(plane, entry, (-1.0, 3.0), 1.0, 200))));
        bench("locus_60", &|| drop(black_box(locus(plane, entry, (-1.0, 3.0), 1.0, 60))));
        let entries = [(1, 0), (1, 1), (2, 0), (2, 1), (2, 2)];
        let parameters = entries.map(|e| {
            let value = model.a[e];
            let size = value.abs();
            Adjustable { value, lower: value - size, upper: value + size, scale: size }
        });
        let placed = |p: &[f64]| {
            let mut a = model.a;
            for (e, value) in entries.iter().zip(p) {
                a[*e] = *value;
            }
            Some(a)
        };
        let Some(from) = found.first().map(|mode| mode.lambda) else { continue };
        bench("place_pole_5_parameters", &|| {
            let _ = black_box(place_pole(placed, &parameters, from, from * Complex::new(1.1, 0.05)));
        });
    }
}

fn analysis(criterion: &mut Criterion) {
    let (a, b) = model();
    criterion.bench_function("eigen", |bench| bench.iter(|| eigen(black_box(&a))));
    criterion.bench_function("eigenvalues", |bench| bench.iter(|| eigenvalues(black_box(&a))));
    criterion.bench_function("respond_1201", |bench| bench.iter(|| respond(black_box(&a), &b, &STEP, GRID)));
    criterion.bench_function("slider_tick", |bench| bench.iter(|| slider_tick(black_box(&a), &b)));
}

criterion_group!(benches, analysis, modal);
criterion_main!(benches);
