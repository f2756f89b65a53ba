//! Words for people: none in the mathematics, and each a whole phrase.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::{Scenario, parameters};
use eigenwing::words;

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).expect("a folder of the sources").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    files.into_iter().chain(folders.iter().flat_map(|folder| sources(folder))).collect()
}

/// The string literals of a file, without those in comments, in attributes and in its tests.
fn literals(code: &str) -> Vec<String> {
    let code = code.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = Vec::new();
    for line in code.lines().filter(|line| !line.trim_start().starts_with("#[")) {
        let mut rest = line;
        while let Some(start) = rest.find('"') {
            if rest[..start].contains("//") {
                break;
            }
            let after = &rest[start + 1..];
            let end = after.find('"').unwrap_or(after.len());
            found.push(after[..end].to_owned());
            rest = after.get(end + 1..).unwrap_or_default();
        }
    }
    found
}

/// What stands in files and links: `Cm_alpha`, `II-C`, `3.2.1.2`.
fn is_key(literal: &str) -> bool {
    literal.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c))
}

#[test]
fn flight_holds_keys_and_no_words() {
    let files = sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/flight"));
    let mut keys = 0;
    for file in files {
        for literal in literals(&fs::read_to_string(&file).expect("a source file")) {
            assert!(is_key(&literal), "{}: “{literal}”", file.display());
            keys += 1;
        }
    }
    assert!(keys > 50, "{keys}: the keys of the coefficients and derivatives are there");
}

/// Flight uses nothing that makes words of numbers, and nothing above it: of the rest of the library only the form of keys and the sorting of a few.
#[test]
fn flight_uses_nothing_but_itself() {
    for file in sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/flight")) {
        let code = fs::read_to_string(&file).expect("a source file");
        let is_beyond = |line: &&str| {
            line.contains("use crate::")
                && !["use crate::flight", "use crate::key::", "use crate::few;"]
                    .iter()
                    .any(|own| line.contains(own))
        };
        let beyond = code.lines().find(is_beyond);
        assert_eq!(beyond, None, "{}", file.display());
    }
}

/// Every sentence about the modes of every aircraft, with every slider at either end.
#[test]
fn what_is_said_of_a_mode_is_whole_sentences() {
    let mut told = 0;
    for aircraft in embedded_aircraft().0.into_iter().map(Arc::new) {
        let scenario = Scenario::new(aircraft);
        let ends = parameters().filter(|p| p.applies(&scenario)).flat_map(|p| {
            let range = p.range(&scenario);
            [*range.start(), *range.end()].map(|end| {
                let mut at_end = scenario.clone();
                p.set(&mut at_end, end);
                at_end
            })
        });
        for scenario in ends.chain([scenario.clone()]) {
            let Ok(analysis) = scenario.analyse() else { continue };
            for plane in Plane::ALL {
                let Some(Ok(plane)) = &analysis.planes[plane] else { continue };
                let reasons = plane.modes.iter().map(words::naming::reason);
                let verdicts = plane.levels.iter().map(words::verdict::sentence);
                for text in reasons.chain(verdicts) {
                    let starts = text.chars().next().is_some_and(|c| c.is_uppercase() || c == 'α');
                    assert!(starts && text.ends_with('.') && !text.contains(".."), "{text}");
                    assert!(!text.contains("  ") && !text.contains("NaN") && !text.contains("inf"), "{text}");
                    told += 1;
                }
            }
        }
    }
    assert!(told > 10_000, "{told}");
}

#[test]
fn a_unit_that_begins_with_a_number_is_multiplied() {
    use eigenwing::words::measure::with_unit;
    assert_eq!(with_unit("0.88", "100 ft/s"), "0.88\u{a0}×\u{a0}100 ft/s");
    assert_eq!(with_unit("26.8", "m/s"), "26.8\u{a0}m/s");
    assert_eq!(with_unit("0.7", ""), "0.7");
}
