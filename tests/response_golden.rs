//! Responses against python-control: `data/responses.json`, made by `scripts/response_golden.py`.

use std::collections::BTreeMap;

use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{DrivenSystem, Forcing, PathRates, Response, TimeGrid, respond};
use nalgebra::{Matrix4, Vector2, Vector4};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    disagreement: BTreeMap<String, f64>,
    models: Vec<Model>,
}

/// One aircraft in one plane.
#[derive(Deserialize)]
struct Model {
    id: String,
    plane: String,
    a: [[f64; 4]; 4],
    columns: BTreeMap<String, [f64; 4]>,
    rate_columns: BTreeMap<String, [f64; 4]>,
    grid: Grid,
    samples: Vec<usize>,
    runs: Vec<Run>,
}

#[derive(Deserialize)]
struct Grid {
    duration: f64,
    steps: usize,
}

#[derive(Deserialize)]
struct Run {
    input: InputData,
    #[serde(default)]
    rate: bool,
    x0: Option<[f64; 4]>,
    states: Vec<[f64; 4]>,
}

/// What fields a kind of input has is described in the file.
#[derive(Debug, Deserialize)]
struct InputData {
    kind: String,
    column: Option<String>,
    #[serde(default)]
    amplitude: f64,
    #[serde(default)]
    start: f64,
    duration: Option<f64>,
    #[serde(default)]
    omega: f64,
    #[serde(default)]
    omega_end: f64,
    #[serde(default)]
    dt: f64,
    #[serde(default)]
    values: Vec<f64>,
}

impl InputData {
    /// The input itself; none where the motion is only let go.
    fn input(&self) -> Option<Input> {
        let &Self { amplitude, start, omega: frequency, omega_end, dt, .. } = self;
        let lasting = self.duration.unwrap_or(f64::INFINITY);
        Some(match self.kind.as_str() {
            "step" => Input::Step { amplitude, start },
            "pulse" => Input::Pulse { amplitude, start, duration: lasting },
            "doublet" => Input::Doublet { amplitude, start, duration: lasting },
            "3-2-1-1" => Input::ThreeTwoOneOne { amplitude, start, unit: lasting },
            "sine" => Input::Sine { amplitude, start, duration: lasting, frequency },
            "sweep" => Input::Sweep { amplitude, start, duration: lasting, from: frequency, to: omega_end },
            "one_minus_cosine" => Input::OneMinusCosine { amplitude, start, duration: lasting },
            "samples" => Input::Samples { dt, values: self.values.as_slice().into() },
            "release" | "mode" => return None,
            other => panic!("an unknown kind of input, {other}"),
        })
    }
}

fn file() -> File {
    serde_json::from_str(include_str!("data/responses.json")).expect("the data file reads")
}

fn response(model: &Model, run: &Run) -> Response {
    let forcing = run.input.input().map(|input| {
        let name = run.input.column.as_ref().expect("a column");
        let rate_column = if run.rate { model.rate_columns[name].into() } else { Vector4::zeros() };
        Forcing { rate_column, ..Forcing::new(model.columns[name].into(), input) }
    });
    let forced = DrivenSystem {
        a: Matrix4::from_fn(|i, j| model.a[i][j]),
        path: PathRates::default(),
        forcings: forcing.into_iter().collect(),
        start: run.x0.unwrap_or_default().into(),
        start_path: Vector2::zeros(),
    };
    respond(&forced, TimeGrid { duration: model.grid.duration, steps: model.grid.steps })
}

/// How far a response is off, of the largest value that the state has in the run.
fn disagreement(model: &Model, run: &Run, response: &Response) -> f64 {
    assert_eq!(run.states.len(), model.samples.len());
    let off = (0..4).map(|i| {
        let peak = run.states.iter().fold(0.0, |peak: f64, x| peak.max(x[i].abs()));
        assert!(peak > 0.0);
        let pairs = model.samples.iter().zip(&run.states);
        pairs.map(|(&k, x)| (response.states[k][i] - x[i]).abs() / peak).fold(0.0, f64::max)
    });
    off.fold(0.0, f64::max)
}

#[test]
fn responses_are_those_of_python_control() {
    // The file is good to 1e-11 of the peak (see below); 600 products with a Φ of rounded numbers lose as little, 3e-12 as seen.
    // A wrong edge of a microsecond shows.
    let mut compared = BTreeMap::new();
    for model in &file().models {
        for run in &model.runs {
            let off = disagreement(model, run, &response(model, run));
            assert!(off <= 1e-8, "{} {}, {:?}: off by {off:e}", model.id, model.plane, run.input);
            *compared.entry(run.input.kind.clone()).or_insert(0) += 1;
        }
    }
    println!("{compared:?}");
    assert_eq!(compared.values().sum::<usize>(), 316);
    assert_eq!(compared.len(), 10, "{compared:?}");
    for (kind, runs) in &compared {
        assert!(*runs >= 10, "{kind}: only {runs}");
    }
}

#[test]
fn two_methods_agree_on_every_kind_of_input_in_the_file() {
    let file = file();
    for (kind, off) in &file.disagreement {
        // The Runge–Kutta integration of the second method errs by as much of a state that hardly moves.
        assert!(*off < 2e-11, "{kind}: {off:e}");
    }
    for run in file.models.iter().flat_map(|model| &model.runs) {
        assert!(file.disagreement.contains_key(&run.input.kind), "{:?}", run.input);
    }
}
