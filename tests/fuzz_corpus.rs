//! What the fuzz targets of `fuzz/` assert, of what they have found once and of the files that they start from.

use std::path::Path;

#[path = "../fuzz/src/lib.rs"]
mod targets;

/// A target: it is given bytes, and asserts what must hold of them.
type FuzzTarget = fn(&[u8]);

/// The contents of the files in a folder of the repository.
fn files(folder: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let Ok(entries) = std::fs::read_dir(&folder) else { return Vec::new() };
    entries.map(|entry| std::fs::read(entry.expect("an entry").path()).expect("a file")).collect()
}

#[test]
fn every_target_holds_of_its_corpus() {
    let targets: [(&str, FuzzTarget); 7] = [
        ("links", targets::links),
        ("aircraft", targets::aircraft),
        ("matrices", targets::matrices),
        ("lessons", targets::lessons),
        ("reports", targets::reports),
        ("importers", targets::importers),
        ("requests", targets::requests),
    ];
    let mut count = 0;
    for (name, target) in targets {
        for file in files(&format!("fuzz/corpus/{name}")) {
            target(&file);
            count += 1;
        }
    }
    assert!(count >= 11, "{count} files");
}

#[test]
fn every_target_holds_of_whole_files() {
    let count = |folder: &str, targets: &[FuzzTarget]| {
        let files = files(folder);
        files.iter().for_each(|file| targets.iter().for_each(|target| target(file)));
        files.len()
    };
    assert!(count("assets/aircraft", &[targets::aircraft]) >= 18);
    assert!(count("assets/lessons", &[targets::lessons, targets::reports]) >= 8);
    let import = files("tests/data/import");
    for file in &import {
        for form in 0..8_u8 {
            targets::importers(&[&[form], &file[..]].concat());
            targets::matrices(&[&[form], &file[..]].concat());
        }
    }
    assert!(import.len() >= 15);
}
