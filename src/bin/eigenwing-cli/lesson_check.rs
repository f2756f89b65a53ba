//! The check of lessons: every fault with its file and line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::lesson::{Lesson, Shelf};

use crate::input::{InputError, text_of};

/// Says which lessons hold, or every fault of those that don't.
pub fn check(files: &[PathBuf]) -> Result<String, InputError> {
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    let (mut said, mut faults) = (String::new(), Vec::new());
    for path in files {
        let file = path.display().to_string();
        let shelf = Shelf::read(&beside(path, "glossary.toml")?, &beside(path, "references.toml")?);
        let found = match (shelf, Lesson::read(&file, &text_of(path)?)) {
            (Ok(shelf), Ok(lesson)) => lesson.check(&aircraft, &shelf),
            (Err(error), _) | (_, Err(error)) => vec![error],
        };
        if found.is_empty() {
            said.push_str(&format!("{file}: holds what it promises\n"));
        }
        faults.extend(found.iter().map(ToString::to_string));
    }
    if faults.is_empty() { Ok(said) } else { Err(InputError::Lessons(faults.join("\nerror: "))) }
}

/// A file in the folder of another; empty where there is none, so that a lesson can stand alone.
fn beside(path: &Path, name: &str) -> Result<String, InputError> {
    let beside = path.with_file_name(name);
    if beside.exists() { text_of(&beside) } else { Ok(String::new()) }
}
