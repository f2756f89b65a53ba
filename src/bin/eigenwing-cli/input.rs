//! Files that are named on the command line: only here is anything read.

use std::path::{Path, PathBuf};

use eigenwing::content::MatrixFormat;
use eigenwing::export::{ExportError, Source, Subject};
use eigenwing::scenario::Scenario;
use thiserror::Error;

use crate::arguments::SubjectArguments;

/// Error that ends the program, in one line.
#[derive(Debug, Error)]
pub enum InputError {
    #[error(transparent)]
    Export(#[from] ExportError),
    #[error("cannot read {}: {error}", .path.display())]
    Unreadable { path: PathBuf, error: std::io::Error },
    #[error("{} is not a text: byte {offset} is not UTF-8", .path.display())]
    NotText { path: PathBuf, offset: usize },
    /// The faults of lessons, one a line.
    #[error("{0}")]
    Lessons(String),
    #[error("{}: expected a name that ends in .json, .csv or .m", .0.display())]
    UnknownFormat(PathBuf),
}

impl SubjectArguments {
    /// The aircraft that is asked about, with what is set on it.
    pub fn read(&self) -> Result<Scenario, InputError> {
        let source = match (&self.matrix, &self.aircraft) {
            (Some(path), _) => matrices(path)?,
            (None, Some(name)) if name.ends_with(".toml") => {
                Source::Toml { file: name.clone(), text: text_of(Path::new(name))? }
            }
            // A forgotten --matrix: no aircraft of the list has such a name.
            (None, Some(name)) if MatrixFormat::of_file(name).is_some() => matrices(Path::new(name))?,
            (None, name) => Source::Listed(name.clone().unwrap_or_default()),
        };
        Ok(Subject {
            source,
            set: self.set.clone(),
            class: self.class.clone(),
            category: self.category.clone(),
        }
        .scenario()?)
    }
}

fn matrices(path: &Path) -> Result<Source, InputError> {
    let file = path.display().to_string();
    let format = MatrixFormat::of_file(&file).ok_or_else(|| InputError::UnknownFormat(path.to_owned()))?;
    Ok(Source::Matrices { text: text_of(path)?, file, format })
}

/// The text of a file.
pub fn text_of(path: &Path) -> Result<String, InputError> {
    let bytes =
        std::fs::read(path).map_err(|error| InputError::Unreadable { path: path.to_owned(), error })?;
    String::from_utf8(bytes).map_err(|error| InputError::NotText {
        path: path.to_owned(),
        offset: error.utf8_error().valid_up_to(),
    })
}
