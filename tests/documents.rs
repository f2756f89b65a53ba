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
