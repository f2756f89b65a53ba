//! What is done with bytes from outside: each function reads them as one kind of file, and asserts what must hold of whatever comes out.

#![forbid(unsafe_code)]

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use eigenwing::content::import::{self, FileBytes};
use eigenwing::content::{Aircraft, MatrixFormat, embedded_aircraft};
use eigenwing::export::json;
use eigenwing::lesson::{Lesson, LinksList, Records, Submission, links_table};
use eigenwing::scenario::link::{self, Opened};
use eigenwing::scenario::{Scenario, parameters};

static AIRCRAFT: LazyLock<Vec<Arc<Aircraft>>> =
    LazyLock::new(|| embedded_aircraft().0.into_iter().map(Arc::new).collect());

/// Files of other programs, by the names that decide between forms.
const NAMES: [&str; 8] = ["a.st", "a.sys", "a.txt", "a.stab", "a.out", "a.xml", "a.json", "a.csv"];

/// A link opens a scene with finite numbers, which comes back as it was from the link that is written of it.
pub fn links(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let Some(opened) = link::read(&text, &AIRCRAFT) else { return };
    for scenario in [Some(&opened.scenario), opened.pinned.as_ref()].into_iter().flatten() {
        for parameter in parameters() {
            let value = parameter.added(scenario).unwrap_or_else(|| parameter.get(scenario));
            assert!(value.is_finite(), "{} = {value}", parameter.key);
        }
        flies_or_says_why(scenario);
    }
    let written = link::write(&opened.scenario, &opened.view, opened.pinned.as_ref());
    let Some(Opened { scenario, view, pinned, .. }) = link::read(&written, &AIRCRAFT) else {
        panic!("{written} doesn't open")
    };
    // An aircraft that is too long for a link stays out of it.
    if written.contains("own=") || AIRCRAFT.iter().any(|known| known.key == opened.scenario.aircraft.key) {
        assert_eq!(
            (&scenario, &view, &pinned),
            (&opened.scenario, &opened.view, &opened.pinned),
            "{written}"
        );
    }
}

/// The text of an aircraft file.
pub fn aircraft(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    match Aircraft::own("a.toml", &text) {
        Ok(aircraft) => flies_or_says_why(&Scenario::new(Arc::new(aircraft))),
        Err(error) => assert!(!error.problem.is_empty()),
    }
}

/// The text of matrices in each of its forms, which the first byte chooses.
pub fn matrices(bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else { return };
    let text = String::from_utf8_lossy(rest);
    let name = ["a.m", "a.json", "a.csv", "a.py"][usize::from(*first) % 4];
    let Some(format) = MatrixFormat::of_file(name) else { return };
    match Aircraft::from_matrices(name, &text, format) {
        Ok(aircraft) => flies_or_says_why(&Scenario::new(Arc::new(aircraft))),
        Err(error) => assert!(!error.problem.is_empty()),
    }
}

/// The text of a lesson, or of a list of links that becomes one.
pub fn lessons(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    if let Err(error) = Lesson::read("a.md", &text) {
        assert!(!error.problem.is_empty());
    }
    if let Ok(list) = LinksList::read(&text, &AIRCRAFT) {
        list.to_lesson();
    }
}

/// What was handed in: a report, records as they are stored, a table of links.
pub fn reports(bytes: &[u8]) {
    Submission::report("a.html", bytes);
    links_table("a.csv", bytes);
    if let Ok(records) = Records::read(&String::from_utf8_lossy(bytes)) {
        assert!(Records::read(&records.to_json()).is_ok());
    }
}

/// A file of another program, whose name the first byte chooses; once as it is, once with everything that is suggested.
pub fn importers(bytes: &[u8]) {
    let Some((first, bytes)) = bytes.split_first() else { return };
    let name = NAMES[usize::from(*first) % NAMES.len()];
    for fills in [BTreeMap::new(), [("all".to_owned(), "suggested".to_owned())].into()] {
        match import::review(&[FileBytes { name, bytes }], &fills).map(|review| review.aircraft()) {
            Ok(Ok(aircraft)) => flies_or_says_why(&Scenario::new(Arc::new(aircraft))),
            Ok(Err(error)) | Err(error) => assert!(!error.problem.is_empty()),
        }
    }
}

/// A request to the JavaScript module, whose function the first byte chooses.
pub fn requests(bytes: &[u8]) {
    let functions = [
        json::parameters,
        json::measures,
        json::analyse,
        json::link,
        json::take_along,
        json::respond,
        json::frequency,
    ];
    let Some((first, rest)) = bytes.split_first() else { return };
    let request = String::from_utf8_lossy(rest);
    match functions[usize::from(*first) % functions.len()](&request) {
        Ok(answer) => assert!(serde_json::from_str::<serde_json::Value>(&answer).is_ok()),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Every number that follows from a scenario is one.
fn flies_or_says_why(scenario: &Scenario) {
    let Ok(analysis) = scenario.analyse() else { return };
    for plane in analysis.planes.iter().flatten().flatten() {
        for mode in &plane.modes {
            assert!(mode.lambda.re.is_finite() && mode.lambda.im.is_finite());
        }
    }
}
