//! The check of lessons: every fault with its file and line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft, lessons};
use eigenwing::lesson::{Course, Lesson, Shelf, said};

use crate::input::{InputError, text_of};

/// Says which lessons hold, or every fault of those that don't.
pub fn check(files: &[PathBuf]) -> Result<String, InputError> {
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    // Words and references of the course are there without a file beside the lesson, as on the page.
    let course = Course::read(&lessons::built_in().unwrap_or_default());
    let (mut said, mut faults) = (String::new(), Vec::new());
    for path in files {
        let file = path.display().to_string();
        let shelf = Shelf::read(&beside(path, "glossary.toml")?, &beside(path, "references.toml")?);
        let (found, of_lecture) = match (shelf, Lesson::read(&file, &text_of(path)?)) {
            (Ok(shelf), Ok(lesson)) => {
                let own = Course { shelf: shelf.into(), ..Course::default() };
                (lesson.check(&aircraft, &own.with_shelf(&course.shelf).shelf), of_lecture(&lesson))
            }
            (Err(error), _) | (_, Err(error)) => (vec![error], String::new()),
        };
        if found.is_empty() {
            said.push_str(&format!("{file}: holds what it promises{of_lecture}\n"));
        }
        faults.extend(found.iter().map(ToString::to_string));
    }
    if faults.is_empty() { Ok(said) } else { Err(InputError::Lessons(faults.join("\nerror: "))) }
}

/// How long a lecture takes; nothing of any other lesson.
fn of_lecture(lesson: &Lesson) -> String {
    if !lesson.lecture {
        return String::new();
    }
    let slides = match lesson.steps.len() {
        1 => "one slide".to_owned(),
        count => format!("{count} slides"),
    };
    let untimed = lesson.steps.iter().filter(|step| step.minutes().is_none()).count();
    match (lesson.minutes(), untimed) {
        (None, _) => format!("; a lecture of {slides}, without minutes"),
        (Some(minutes), 0) => format!("; a lecture of {} in {slides}", said::minutes(minutes)),
        (Some(minutes), untimed) => {
            format!(
                "; a lecture of {} in {slides}, {untimed} of them without minutes",
                said::minutes(minutes)
            )
        }
    }
}

/// A file in the folder of another; empty where there is none, so that a lesson can stand alone.
fn beside(path: &Path, name: &str) -> Result<String, InputError> {
    let beside = path.with_file_name(name);
    if beside.exists() { text_of(&beside) } else { Ok(String::new()) }
}
