//! Files of systems of any size and numbers, opened, taken along as an aircraft file and as bare matrices, and opened again: the same
//! aircraft to the last bit.

use std::collections::BTreeMap;

use eigenwing::content::import::review::Review;
use eigenwing::content::import::{FileBytes, review};
use eigenwing::export::{DisturbanceRequest, Scene, Source, Subject, take_along};
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::key::Keyed as _;
use proptest::prelude::*;

/// A system as a file has it: names, and numbers for each.
#[derive(Clone, Debug)]
struct File {
    states: Vec<String>,
    inputs: Vec<String>,
    a: Vec<Vec<f64>>,
    b: Vec<Vec<f64>>,
    units: &'static str,
    angles: &'static str,
    trim: [f64; 3],
}

impl File {
    fn text(&self) -> String {
        let file = serde_json::json!({
            "name": "Own aircraft",
            "units": self.units,
            "angles": self.angles,
            "speed": self.trim[0],
            "alpha0_deg": self.trim[1],
            "gamma0_deg": self.trim[2],
            "states": self.states,
            "inputs": self.inputs,
            "A": self.a,
            "B": self.b,
        });
        file.to_string()
    }
}

const FOUR: [[&str; 4]; 4] = [
    ["u", "w", "q", "theta"],
    ["V", "alpha", "q", "theta"],
    ["v", "p", "r", "phi"],
    ["beta", "p", "r", "phi"],
];
const FURTHER: [&str; 10] = ["h", "z", "psi", "x", "y", "rpm", "de", "thr", "da", "sensor"];
const INPUTS: [&str; 4] = ["elevator", "throttle", "aileron", "rudder"];

/// Numbers of all sizes, some of them zero, whose digits fill all of their places.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 5 => -3.0..3.0, 3 => -400.0..400.0, 1 => -1e-4..1e-4]
}

fn file() -> impl Strategy<Value = File> {
    let planes = prop_oneof![
        Just(vec![0]),
        Just(vec![1]),
        Just(vec![2]),
        Just(vec![3]),
        Just(vec![0, 2]),
        Just(vec![1, 3]),
    ];
    let further = proptest::sample::subsequence(FURTHER.to_vec(), 0..=6);
    let units = proptest::sample::select(vec!["SI", "ft-slug-s"]);
    let angles = proptest::sample::select(vec!["rad", "deg", "crad"]);
    let trim = (20.0..300.0, -10.0..15.0, -20.0..20.0);
    let numbers = proptest::collection::vec(number(), 14 * 18);
    (planes, further, units, angles, trim, numbers).prop_map(
        |(planes, further, units, angles, trim, numbers)| {
            let four = planes.iter().flat_map(|&k| FOUR[k]);
            let states: Vec<String> = four.chain(further).map(str::to_owned).collect();
            let n = states.len();
            let mut a: Vec<Vec<f64>> = (0..n).map(|i| numbers[i * 14..i * 14 + n].to_vec()).collect();
            for (k, &plane) in planes.iter().enumerate() {
                // θ̇ = q, φ̇ = p + r tan θ₀
                let (row, is_lateral) = (4 * k + 3, plane >= 2);
                let tangent = if is_lateral { 0.125 * numbers[row] } else { 0.0 };
                a[row] = (0..n)
                    .map(|j| f64::from(u8::from(j == 4 * k + if is_lateral { 1 } else { 2 })))
                    .collect();
                if is_lateral {
                    a[row][4 * k + 2] = tangent;
                }
            }
            let b = (0..n).map(|i| numbers[14 * 14 + 4 * i..14 * 14 + 4 * i + 4].to_vec()).collect();
            let inputs = INPUTS.map(str::to_owned).to_vec();
            File { states, inputs, a, b, units, angles, trim: [trim.0, trim.1, trim.2] }
        },
    )
}

fn opened(name: &str, text: &str) -> Review {
    let file = FileBytes { name, bytes: text.as_bytes() };
    review(&[file], &BTreeMap::new()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn planes(review: &Review) -> Vec<PlaneModel> {
    let aircraft = review.aircraft().unwrap_or_else(|error| panic!("{error}\n{review:#?}"));
    let models = aircraft.aircraft_model.models().expect("it flies");
    Plane::ALL.into_iter().filter_map(|plane| models.planes[plane].clone()).collect()
}

fn scene(text: &str) -> Scene {
    let source = Source::Toml { file: "own.toml".to_owned(), text: text.to_owned() };
    Subject { source, ..Subject::listed("") }.scene().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The text of a scene in another form.
fn taken(scene: &Scene, target: &str, plane: Option<&str>) -> String {
    let request = DisturbanceRequest { plane: plane.map(str::to_owned), ..DisturbanceRequest::default() };
    take_along(scene, target, &request).unwrap_or_else(|error| panic!("{target}: {error}")).text
}

fn check(review: &Review) -> Result<usize, TestCaseError> {
    let Ok(text) = review.text() else { return Ok(0) };
    let models = planes(review);
    let scene = scene(text);
    let toml = taken(&scene, "toml", None);
    prop_assert_eq!(&toml, text);
    for name in ["again.toml", "pasted text"] {
        let again = opened(name, &toml);
        prop_assert_eq!(again.format, "aircraft-file");
        prop_assert_eq!(again.text().ok(), Some(text));
        prop_assert_eq!(planes(&again), models.clone());
    }
    for model in &models {
        let json = taken(&scene, "json", Some(model.plane.key()));
        let again = opened("again.json", &json);
        prop_assert_eq!(planes(&again), vec![model.clone()], "{}", json);
    }
    Ok(models.iter().map(|model| model.further_states().len()).sum())
}

#[test]
fn what_was_opened_is_the_same_to_the_last_bit_when_it_is_taken_along_and_opened_again() {
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 400,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let (ready, further) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    let run = runner.run(&file(), |file| {
        let review = opened("own.json", &file.text());
        ready.set(ready.get() + usize::from(review.aircraft.is_some()));
        further.set(further.get() + check(&review)?);
        Ok(())
    });
    run.unwrap_or_else(|error| panic!("{error}"));
    assert!(ready.get() > 200 && further.get() > 400, "{} {}", ready.get(), further.get());
}
