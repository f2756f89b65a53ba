//! What one movement of a slider costs, whole and in parts.

use std::hint::black_box;
use std::sync::Arc;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::findings::change::Change;
use eigenwing::flight::aircraft::aircraft_model::{AircraftModel, MatrixModel};
use eigenwing::flight::aircraft::axes::StabilityAxes;
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use eigenwing::flight::feedback::closed_model::ClosedModel;
use eigenwing::flight::feedback::loop_transfer::LoopTransfer;
use eigenwing::flight::feedback::margins::LoopMargins;
use eigenwing::flight::feedback::{Law, analyse_loop};
use eigenwing::flight::modes::approximations::{DownwashLag, approximations};
use eigenwing::flight::modes::eigen::{eigen, eigenvalues};
use eigenwing::flight::modes::inverse::{Adjustable, Linearised, place_pole};
use eigenwing::flight::modes::locus::locus;
use eigenwing::flight::modes::mode::modes;
use eigenwing::flight::modes::sensitivity::{entry_rate, sensitivity};
use eigenwing::flight::motion::aerodynamics::Controls;
use eigenwing::flight::motion::control_limits::NamedLimits;
use eigenwing::flight::motion::flight_path::Excitation;
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{DrivenSystem, TimeGrid, respond};
use eigenwing::flight::motion::servos::{MEASURED, OWN, Servos};
use eigenwing::flight::motion::six_dof::{SixDof, Wind};
use eigenwing::flight::verdicts::handling_qualities::handling_qualities;
use eigenwing::flight::verdicts::mil_f_8785c::{Category, Class};
use eigenwing::flight::verdicts::static_stability::plane_static_stability;
use eigenwing::flight::verdicts::task::Task;
use eigenwing::flight::{Channel, Experiment, Start, analyse};
use eigenwing::scenario::{Page, Parameter, Scenario};
use nalgebra::{Complex, Matrix4, Matrix4x2, Vector4};

const GRID: TimeGrid = TimeGrid { duration: 60.0, steps: 1200 };
const STEP: Input = Input::Step { amplitude: 0.0175, start: 1.0 };

/// The lesson's light aircraft, g in the unit of the other entries; the same numbers as in `compare_with_python_control.py`.
fn lesson() -> PlaneModel {
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
    ]);
    let b = Matrix4x2::from_row_slice(&[0.0, 0.0, -0.282, 0.0, -9.72, 0.0, 0.0, 0.0]);
    let trim = Trim { speed: 1.76, alpha0: 0.0, gamma0: 0.0, gravity: 0.322 };
    PlaneModel { plane: Plane::Longitudinal, a, b, trim, further: None }
}

/// The first aircraft that ships, the Navion, from its coefficients.
fn navion() -> Option<Scenario> {
    embedded_aircraft().0.into_iter().next().map(|aircraft| Scenario::new(Arc::new(aircraft)))
}

fn whole(criterion: &mut Criterion) {
    let model = lesson();
    let (a, b) = (model.a, model.b.column(0).into_owned());
    let edited =
        EditedModel::new(AircraftModel::Matrices(MatrixModel { longitudinal: Some(model), lateral: None }));
    let experiment = Experiment {
        plane: Plane::Longitudinal,
        inputs: vec![(Channel::First, STEP)],
        start: Start::Rest,
        grid: GRID,
    };
    let forced = DrivenSystem::from_rest(a, b, STEP);
    criterion.bench_function("eigen", |bench| bench.iter(|| eigen(black_box(&a))));
    criterion.bench_function("respond_1201", |bench| bench.iter(|| respond(black_box(&forced), GRID)));
    // All that follows from a new matrix: named modes, verdicts, approximations, and a response of 1,201 points.
    criterion
        .bench_function("slider_tick", |bench| bench.iter(|| analyse(black_box(&edited), None, &experiment)));
    let Some(scenario) = navion() else { return };
    // Both planes from coefficients, with levels; then what the sliders of a page would do.
    criterion.bench_function("navion/analyse", |bench| bench.iter(|| black_box(&scenario).analyse()));
    criterion.bench_function("navion/sensitivities", |bench| {
        let analysed = || {
            let findings = Findings::of(scenario.clone());
            assert!(findings.is_analysed() || findings.plane().is_some());
            findings
        };
        bench.iter_batched(
            analysed,
            |findings| findings.sensitivities(Page::Coefficients).len(),
            BatchSize::SmallInput,
        );
    });
    // The path that a slider of a coefficient would send the poles along: coefficients, derivatives, A and its roots, 200 times.
    let findings = Findings::of(scenario.clone());
    for key in ["cm_alpha", "cl_alpha", "speed"] {
        let Some(parameter) = Parameter::find(key) else { continue };
        criterion.bench_function(&format!("navion/locus_200_{key}"), |bench| {
            bench.iter_batched(
                || Findings::of(scenario.clone()),
                |findings| findings.locus(parameter).evaluations,
                BatchSize::SmallInput,
            );
        });
        if findings.locus(parameter).evaluations < 100 {
            eprintln!("{key}: only {} points", findings.locus(parameter).evaluations);
        }
    }
    // Why the modes have moved, with all that follows from both states known: found once when the hand rests.
    for (key, value) in [("cm_q", -19.92), ("speed", 60.0), ("cg", 0.3)] {
        let Some(parameter) = Parameter::find(key) else { continue };
        let mut moved = scenario.clone();
        parameter.set(&mut moved, value);
        let [before, after] = [scenario.clone(), moved].map(Findings::of);
        criterion.bench_function(&format!("navion/why_{key}"), |bench| {
            bench.iter(|| Change::between(black_box(&before), black_box(&after)));
        });
    }
    // A pole under the hand, by the way through coefficients: near, and far beyond what the sliders can do.
    let Some(mode) = findings.modes().first() else { return };
    for (name, turn) in [("near", Complex::new(1.1, 0.05)), ("beyond", Complex::new(4.0, 1.0))] {
        criterion.bench_function(&format!("navion/drag_a_pole_{name}"), |bench| {
            bench.iter(|| findings.place_pole(mode, mode.lambda * turn, &["cm_alpha", "cm_q"]));
        });
    }
}

/// A minute of nonlinear flight: an elevator step and a rudder kick, 1,201 samples.
fn nonlinear(criterion: &mut Criterion) {
    let ready = navion().map(|scenario| (SixDof::new(&scenario.edited), scenario));
    let Some((Ok(flight), scenario)) = ready else { return };
    let controls = |t: f64| Controls {
        elevator: if t >= 1.0 { -0.0175 } else { 0.0 },
        rudder: if (1.0..2.0).contains(&t) { 0.05 } else { 0.0 },
        ..Controls::default()
    };
    let excitation = Excitation {
        controls: &controls,
        wind: &|_| Wind::default(),
        edges: &[1.0, 2.0],
        longitudinal: Vector4::zeros(),
        lateral: Vector4::zeros(),
        heading: 0.0,
        position: [0.0; 3],
        servos: None,
    };
    criterion.bench_function("navion/six_dof_trim", |bench| {
        bench.iter(|| SixDof::new(black_box(&scenario.edited)));
    });
    criterion.bench_function("navion/fly_60_s", |bench| {
        bench.iter(|| black_box(&flight).fly(&excitation, GRID));
    });
    let mut gains = [[0.0; MEASURED]; 4];
    // Yaw rate to rudder, pitch rate to elevator.
    (gains[3][7], gains[0][2]) = (1.0, 0.3);
    let servos = Servos {
        gains,
        washouts: [0.0, 3.0],
        lags: [0.1; 4],
        limits: NamedLimits::default().or_usual(&flight),
        commands: &|_| [0.0; MEASURED],
        start: [0.0; OWN],
    };
    let under_law = Excitation { servos: Some(&servos), ..excitation };
    criterion.bench_function("navion/fly_60_s under a law", |bench| {
        bench.iter(|| black_box(&flight).fly(&under_law, GRID));
    });
}

fn parts(criterion: &mut Criterion) {
    let Some(models) = navion().and_then(|scenario| scenario.edited.models().ok()) else { return };
    for (plane, name) in [(Plane::Longitudinal, "longitudinal"), (Plane::Lateral, "lateral")] {
        let Some(model) = &models.planes[plane] else { continue };
        let (found, stability_axes) = (modes(model).unwrap_or_default(), StabilityAxes::of(model));
        let mut bench = |what: &str, run: &dyn Fn()| {
            criterion.bench_function(&format!("{name}/{what}"), |bench| bench.iter(run));
        };
        bench("modes", &|| drop(black_box(modes(black_box(model)))));
        bench("sensitivities_16_entries", &|| {
            for mode in &found {
                for k in 0..16 {
                    let _ = black_box(sensitivity(black_box(mode), &entry_rate(k / 4, k % 4)));
                }
            }
        });
        bench("approximations", &|| {
            drop(black_box(approximations(black_box(&stability_axes), DownwashLag::default(), &found)))
        });
        bench("handling_qualities", &|| {
            drop(black_box(handling_qualities(
                black_box(model),
                &found,
                Task { class: Class::I, category: Category::B },
            )));
        });
        bench("static_stability", &|| {
            let _ = black_box(plane_static_stability(black_box(&stability_axes), None));
        });
        let entry = |value: f64| {
            let mut a = model.a;
            a[(2, if plane == Plane::Longitudinal { 1 } else { 0 })] *= value;
            Some(a)
        };
        bench("locus_200", &|| drop(black_box(locus(plane, entry, (-1.0, 3.0), 1.0, 200))));
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
            Some(Linearised { a, rates: entries.map(|(i, j)| entry_rate(i, j)).to_vec() })
        };
        let Some(from) = found.first().map(|mode| mode.lambda) else { continue };
        bench("place_pole_5_parameters", &|| {
            let _ = black_box(place_pole(placed, &parameters, from, from * Complex::new(1.1, 0.05)));
        });
    }
}

/// A yaw damper with washout and actuator, six states, and what a law appends at most, eight.
fn feedback(criterion: &mut Criterion) {
    let Some(models) = navion().and_then(|scenario| scenario.edited.models().ok()) else { return };
    let Some(model) = &models.planes.lateral else { return };
    let mut law = Law { actuator: 0.1, ..Law::default() };
    law.planes.lateral.washout = 3.0;
    law.planes.lateral.to_second[2] = 0.5;
    let six = law;
    law.planes.lateral.to_first[4] = -0.2;
    for (states, law) in [(6, six), (8, law)] {
        let Ok(closed) = ClosedModel::new(model, &law) else { continue };
        assert_eq!(closed.size(), states);
        let mut bench = |what: &str, run: &dyn Fn()| {
            criterion.bench_function(&format!("feedback/{what} of {states} states"), |bench| bench.iter(run));
        };
        bench("eigensystem", &|| drop(black_box(eigen(black_box(&closed.a)))));
        bench("eigenvalues", &|| drop(black_box(eigenvalues(black_box(&closed.a)))));
        bench("analyse_loop", &|| drop(black_box(analyse_loop(model, black_box(&law), None))));
        bench("margins", &|| {
            let transfer = LoopTransfer::of(black_box(&closed), 1);
            let _ = black_box(transfer.map(|transfer| transfer.map(|of| LoopMargins::of(&of))));
        });
    }
}

criterion_group!(benches, whole, nonlinear, parts, feedback);
criterion_main!(benches);
