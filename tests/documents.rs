//! The documents: each scene that they name opens as it says.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::scenario::link;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The documents with their texts.
fn documents() -> Vec<(PathBuf, String)> {
    let entries = std::fs::read_dir(root().join("docs")).expect("the documents");
    let in_docs = entries.map(|entry| entry.expect("a file").path());
    let at_root = ["README.md", "ARCHITECTURE.md"].map(|name| root().join(name));
    let paths = in_docs.chain(at_root).filter(|path| path.extension().is_some_and(|ending| ending == "md"));
    paths.map(|path| (path.clone(), std::fs::read_to_string(path).expect("its text"))).collect()
}

#[test]
fn every_scene_of_a_document_opens_as_it_says() {
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    let mut count = 0;
    for (path, text) in documents() {
        // On a line of its own, or in backticks; one with an ellipsis is none to be opened.
        let pieces = text.split(['`', '\n']).map(str::trim);
        for scene in pieces.filter(|piece| piece.starts_with("#v=") && !piece.contains('…')) {
            count += 1;
            let opened = link::read(scene, &aircraft).expect("there are aircraft");
            assert_eq!(opened.notices, [], "{}: {scene}", path.display());
        }
    }
    assert!(count > 15, "{count}");
}

/// In nginx an unquoted `{` opens a block wherever it stands, also within a regular expression, and the server doesn't start.
#[test]
fn braces_within_words_of_the_host_are_quoted() {
    let text = std::fs::read_to_string(root().join("docs/hosting/nginx.conf")).expect("its text");
    let mut deep = 0;
    for line in text.lines().map(|line| line.split(" #").next().unwrap_or_default().trim()) {
        if line.starts_with('#') {
            continue;
        }
        let bare: String = line.split('"').step_by(2).collect();
        assert_eq!(line.matches('"').count() % 2, 0, "{line}");
        let (opens, closes) = (bare.matches('{').count(), bare.matches('}').count());
        assert!(opens == 0 || opens == 1 && bare.ends_with(" {"), "{line}");
        assert!(closes == 0 || bare == "}", "{line}");
        deep = deep + opens - closes;
    }
    assert_eq!(deep, 0, "as many blocks end as begin");
}
