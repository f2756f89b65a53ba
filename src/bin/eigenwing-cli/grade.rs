//! What a class has handed in, read and graded; every file is a line of the table, whatever is in it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::export::{ClassSource, class_answers};
use eigenwing::lesson::{Grade, Grader, Lesson, Submission, links_table};
use indicatif::{ProgressBar, ProgressStyle};

use crate::arguments::{Format, GradeArguments};
use crate::input::{InputError, text_of};
use crate::{grade_table, json};

/// Folders are searched so deep.
const DEEPEST: usize = 4;

/// As many are graded before a bar could be seen.
const SOON_DONE: usize = 50;

/// The grades, as they are printed. Writes the page of the answers, where one is wanted.
pub fn grade(arguments: &GradeArguments) -> Result<String, InputError> {
    let GradeArguments { lesson, reports, page, names, output } = arguments;
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    let read = Lesson::read(&lesson.display().to_string(), &text_of(lesson)?);
    let lesson = read.map_err(|error| InputError::Lessons(error.to_string()))?;
    let mut files = Vec::new();
    for path in reports {
        find(path, DEEPEST, &mut files)?;
    }
    let submissions: Vec<Submission> = files.iter().flat_map(|path| submissions(path)).collect();
    let grader = Grader::new(&lesson, &aircraft);
    let bar = bar(submissions.len());
    let grades: Vec<Grade> =
        submissions.iter().map(|submission| grader.grade(submission)).inspect(|_| bar.inc(1)).collect();
    bar.finish_and_clear();
    let grades = grader.finish(grades);
    if let Some(path) = page {
        let text = class_answers(&ClassSource {
            grader: &grader,
            grades: &grades,
            aircraft: &aircraft,
            names: *names,
        });
        std::fs::write(path, text).map_err(|error| InputError::Unwritable { path: path.clone(), error })?;
    }
    Ok(match output.format() {
        Format::Table => grade_table::table(&grades),
        Format::Json => json(&grades),
        Format::Csv => grade_table::csv(&grades),
    })
}

/// The files of a path: itself, or all in the folder and below it, in the order of their names; hidden ones aren't anybody's.
fn find(path: &Path, deep: usize, files: &mut Vec<PathBuf>) -> Result<(), InputError> {
    let unreadable = |error| InputError::Unreadable { path: path.to_owned(), error };
    if !std::fs::metadata(path).map_err(unreadable)?.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    let entries: Result<Vec<_>, _> = std::fs::read_dir(path).map_err(unreadable)?.collect();
    let mut paths: Vec<PathBuf> =
        entries.map_err(unreadable)?.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    let is_hidden =
        |path: &PathBuf| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
    for path in paths.iter().filter(|path| !is_hidden(path)) {
        if deep > 0 || path.is_file() {
            find(path, deep.saturating_sub(1), files)?;
        }
    }
    Ok(())
}

/// What is in a file: a report, or the table of a form. One that can't be read is a submission too.
fn submissions(path: &Path) -> Vec<Submission> {
    let source = path.display().to_string();
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    match std::fs::read(path) {
        Ok(bytes) if matches!(&*ending, "csv" | "tsv" | "txt") => links_table(&source, &bytes),
        Ok(bytes) => vec![Submission::report(&source, &bytes)],
        Err(error) => {
            vec![Submission { source, name: None, work: Err(format!("it can’t be read: {error}")) }]
        }
    }
}

fn bar(count: usize) -> ProgressBar {
    if count <= SOON_DONE {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos} of {len} reports, {eta} left");
    // Draws on the error output, and only if that is a terminal.
    ProgressBar::new(count as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
