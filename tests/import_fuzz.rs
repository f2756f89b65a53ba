//! Files with parts cut out, doubled, exchanged and written over: whatever is in them, a reader ends with a review or a sentence, and
//! an aircraft that comes out of it can be shown.

use std::collections::BTreeMap;

use eigenwing::content::import::{FileBytes, review};
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;

/// Files of every form, with what is typed beside them.
const SEEDS: [(&str, &[(&str, &str)]); 19] = [
    (
        "navion.st",
        &[
            ("length_unit", "ft"),
            ("mass", "1247"),
            ("Ix", "1420"),
            ("Iy", "4067"),
            ("Iz", "4786"),
            ("all", "suggested"),
        ],
    ),
    ("navion-scientific.st", &[("all", "suggested")]),
    ("navion-two-cases.st", &[("case", "2"), ("length_unit", "ft")]),
    ("navion.sys", &[]),
    ("navion-xflr5.txt", &[]),
    ("01-xflr5-raw-log.txt", &[("speed", "8.6")]),
    (
        "navion.stab",
        &[
            ("case", "3"),
            ("units", "ft-slug-s"),
            ("ConGrp_1", "elevator"),
            ("mass", "1247"),
            ("Ix", "1420"),
            ("Iy", "4067"),
            ("Iz", "4786"),
            ("all", "suggested"),
        ],
    ),
    (
        "navion-datcom.out",
        &[
            ("case", "2"),
            ("mass", "1247"),
            ("Ix", "1420"),
            ("Iy", "4067"),
            ("Iz", "4786"),
            ("all", "suggested"),
        ],
    ),
    ("navion-linearisation.json", &[]),
    ("navion.sce", &[]),
    ("navion.py", &[]),
    ("navion-printed-by-numpy.txt", &[("units", "SI"), ("all", "suggested")]),
    ("17-printed-with-scale-factor.m", &[]),
    ("14-german-excel.csv", &[]),
    ("18-undamped-phugoid.json", &[]),
    ("navion-twelve-states.m", &[]),
    ("navion.tex", &[("all", "suggested")]),
    ("navion-printed-system.txt", &[("all", "suggested")]),
    ("navion.R", &[("all", "suggested")]),
];

fn bytes(name: &str) -> Vec<u8> {
    let path = format!("{}/tests/data/import/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Pieces that readers have rules about.
const PIECES: [&str; 36] = [
    "",
    "\n",
    " ",
    "=",
    "'",
    "\"",
    "[",
    "]",
    "[[",
    ";",
    ",",
    "...",
    "%{",
    "%}",
    "\"\"\"",
    "−",
    "-",
    "1e999",
    "NaN",
    "0",
    "D+02",
    "1.0e+03 *",
    "|",
    "\u{feff}",
    "é",
    "****",
    "0",
    "9999999999999999999999",
    "nrow=9999999",
    "\\begin{array}",
    "\\end{bmatrix}",
    "matrix(c(",
    "{{",
    ": matrix(",
    "&",
    "<StateSpace>",
];

/// One change of a file: where, how much is taken out, and what is put there.
#[derive(Clone, Debug)]
struct Change {
    at: f64,
    length: usize,
    piece: usize,
    /// Copies what was taken out to this place instead.
    copied_to: Option<f64>,
}

fn change() -> impl Strategy<Value = Change> {
    let copied = proptest::option::of(0.0..1.0_f64);
    (0.0..1.0_f64, prop_oneof![Just(0_usize), 1_usize..4, 1_usize..200], 0..PIECES.len(), copied)
        .prop_map(|(at, length, piece, copied_to)| Change { at, length, piece, copied_to })
}

fn changed(mut bytes: Vec<u8>, changes: &[Change]) -> Vec<u8> {
    for change in changes {
        let place = |share: f64, length: usize| ((share * length as f64) as usize).min(length);
        let start = place(change.at, bytes.len());
        let end = (start + change.length).min(bytes.len());
        let taken: Vec<u8> = bytes.splice(start..end, PIECES[change.piece].bytes()).collect();
        if let Some(to) = change.copied_to {
            let at = place(to, bytes.len());
            bytes.splice(at..at, taken);
        }
    }
    bytes
}

/// Opens a file; an aircraft that comes out has models with finite numbers, a fault has a line of the file.
fn check(name: &str, bytes: &[u8], fills: &[(&str, &str)]) -> bool {
    let fills: BTreeMap<String, String> =
        fills.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    match review(&[FileBytes { name, bytes }], &fills) {
        Ok(review) => match review.aircraft() {
            Ok(aircraft) => {
                let models = aircraft.aircraft_model.models().expect("an aircraft flies");
                for model in models.planes.iter().flatten() {
                    assert!(model.whole_a().iter().chain(&model.b).all(|x| x.is_finite()), "{name}");
                }
                true
            }
            Err(error) => {
                assert!(!error.problem.is_empty(), "{name} says nothing");
                false
            }
        },
        Err(error) => {
            let lines = bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r')).count() + 2;
            assert!(error.line >= 1 && error.line <= lines.max(2), "{name}: {error}");
            assert!(!error.problem.is_empty(), "{name} says nothing");
            false
        }
    }
}

#[test]
fn every_seed_that_says_enough_is_an_aircraft() {
    let ready = SEEDS.iter().filter(|(name, fills)| check(name, &bytes(name), fills)).count();
    // The second has no mass, the third neither.
    assert_eq!(ready, SEEDS.len() - 2);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_changed_file_panics(seed in 0..SEEDS.len(), changes in proptest::collection::vec(change(), 1..5)) {
        let (name, fills) = SEEDS[seed];
        check(name, &changed(bytes(name), &changes), fills);
    }
}

/// `cargo test --release --no-default-features --test import_fuzz -- --ignored`
#[test]
#[ignore = "takes minutes: a million files"]
fn no_file_of_a_million_panics() {
    let contents: Vec<Vec<u8>> = SEEDS.iter().map(|(name, _)| bytes(name)).collect();
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let changes = proptest::collection::vec(change(), 1..6);
    let mut ready = 0;
    for k in 0..1_000_000 {
        let tree = changes.new_tree(&mut runner).expect("changes can be made");
        let (name, fills) = SEEDS[k % SEEDS.len()];
        ready +=
            usize::from(check(name, &changed(contents[k % SEEDS.len()].clone(), &tree.current()), fills));
    }
    // Many changes are of blanks and digits.
    assert!(ready > 50_000, "{ready}");
}
