//! Responses against python-control: `data/responses.json`, made by `scripts/response_golden.py`.

use std::collections::BTreeMap;

use eigenwing::flight::inputs::Input;
use eigenwing::flight::response::{Response, TimeGrid, respond};
use nalgebra::{Matrix4, Vector4};
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
}

impl InputData {
    /// The input itself, `None` for a kind that is not yet offered.
    fn input(&self) -> Option<Input> {
        let &Self { amplitude, start, duration, .. } = self;
        match (self.kind.as_str(), duration) {
            ("step", _) => Some(Input::Step { amplitude, start }),
            ("pulse", Some(duration)) => Some(Input::Pulse { amplitude, start, duration }),
            _ => None,
        }
    }
}

fn file() -> File {
    serde_json::from_str(include_str!("data/responses.json")).expect("the data file reads")
}

/// The motion of a run, `None` for what is not yet offered.
fn response(model: &Model, run: &Run) -> Option<Response> {
    if run.rate || run.x0.is_some() {
        return None;
    }
    let input = run.input.input()?;
    let column = run.input.column.as_ref().and_then(|name| model.columns.get(name)).expect("a column");
    let a = Matrix4::from_fn(|i, j| model.a[i][j]);
    let grid = TimeGrid { duration: model.grid.duration, steps: model.grid.steps };
    Some(respond(&a, &Vector4::from(*column), &input, grid))
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
            let Some(response) = response(model, run) else { continue };
            let off = disagreement(model, run, &response);
            assert!(off <= 1e-8, "{} {}, {:?}: off by {off:e}", model.id, model.plane, run.input);
            *compared.entry(run.input.kind.clone()).or_insert(0) += 1;
        }
    }
    // Five aircraft, two planes, three columns.
    assert_eq!(compared, BTreeMap::from([("pulse".to_owned(), 30), ("step".to_owned(), 30)]));
}

#[test]
fn two_methods_agree_on_every_kind_of_input_in_the_file() {
    let file = file();
    for (kind, off) in &file.disagreement {
        assert!(*off < 1e-11, "{kind}: {off:e}");
    }
    for run in file.models.iter().flat_map(|model| &model.runs) {
        assert!(file.disagreement.contains_key(&run.input.kind), "{:?}", run.input);
    }
}
