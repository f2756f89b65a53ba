//! Files that are named on the command line: only here is anything read.

use std::path::{Path, PathBuf};

use eigenwing::content::FILES;
use eigenwing::content::import::{self, FileBytes, review::Review};
use eigenwing::export::{DisturbanceRequest, ExportError, Scene, Source, Subject};
use eigenwing::scenario::link::is_link;
use thiserror::Error;

use crate::arguments::{DisturbanceArguments, FillArguments, SubjectArguments};

/// Error that ends the program, in one line.
#[derive(Debug, Error)]
pub enum InputError {
    #[error(transparent)]
    Export(#[from] ExportError),
    #[error("cannot read {}: {error}", .path.display())]
    Unreadable { path: PathBuf, error: std::io::Error },
    #[error("cannot write {}: {error}", .path.display())]
    Unwritable { path: PathBuf, error: std::io::Error },
    #[error("{} is not a text: byte {offset} is not UTF-8", .path.display())]
    NotText { path: PathBuf, offset: usize },
    /// In the units of the table.
    #[error("{0}")]
    Told(String),
    /// Bytes would be signs that steer the terminal.
    #[error("a picture can't be printed on a terminal: give it a file, --output {file}")]
    OnTerminal { file: String },
    #[error("the figure can't be drawn as a picture: {0}")]
    Picture(String),
    #[error("only figures become pictures: {} would be {kind}", .path.display())]
    NoPicture { path: PathBuf, kind: &'static str },
    /// The faults of lessons, one a line.
    #[error("{0}")]
    Lessons(String),
}

impl SubjectArguments {
    /// The scene that is asked about: an aircraft with what is set on it, or a link. What of a link can't be used is said at once.
    pub fn read(&self) -> Result<Scene, InputError> {
        let mut scene = self.subject()?.scene()?;
        scene.scenario.notation = self.notation.unwrap_or(scene.scenario.notation);
        scene.notices.iter().for_each(|notice| eprintln!("note: {notice}"));
        Ok(scene)
    }

    fn subject(&self) -> Result<Subject, InputError> {
        let name = self.link.as_ref().or(self.aircraft.as_ref());
        let source = match (&self.matrix, name) {
            (Some(path), _) => self.fills.source(path)?,
            (None, Some(link)) if self.link.is_some() || is_link(link) => Source::Link(link.clone()),
            // No aircraft of the list has a name with such a sign; another one may be that of a file all the same.
            (None, Some(name)) if name.contains(['.', '/', '\\']) || is_file(name) => {
                self.fills.source(Path::new(name))?
            }
            (None, name) => Source::Listed(name.cloned().unwrap_or_default()),
        };
        let is_file = matches!(source, Source::Toml { .. });
        if !is_file && (!self.fills.fill.is_empty() || self.fills.mass_file.is_some()) {
            return Err(InputError::Told(
                "--fill and --mass-file belong to a file that is opened".to_owned(),
            ));
        }
        Ok(Subject {
            source,
            set: self.set.clone(),
            class: self.class.clone(),
            category: self.category.clone(),
        })
    }
}

impl FillArguments {
    /// The review of a file, with what was typed beside it.
    pub fn review(&self, path: &Path) -> Result<Review, InputError> {
        let name = path.display().to_string();
        let bytes = bytes_of(path)?;
        let named = |path: &PathBuf| Ok::<_, InputError>((path.display().to_string(), bytes_of(path)?));
        let mass = self.mass_file.as_ref().map(named).transpose()?;
        let mut files = vec![FileBytes { name: &name, bytes: &bytes }];
        files.extend(mass.as_ref().map(|(name, bytes)| FileBytes { name, bytes }));
        let fills = self.fill.iter().cloned().collect();
        Ok(import::review(&files, &fills).map_err(ExportError::from)?)
    }

    /// The aircraft of a file, or in one sentence what stands in its way.
    fn source(&self, path: &Path) -> Result<Source, InputError> {
        let review = self.review(path)?;
        Ok(Source::Toml { text: review.text().map_err(ExportError::from)?.to_owned(), file: review.file })
    }
}

/// Whether a name that the list doesn't have is that of a file here.
fn is_file(name: &str) -> bool {
    let is_listed = FILES.iter().any(|(file, _)| file.strip_suffix(".toml") == Some(name));
    !is_listed && Path::new(name).is_file()
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, InputError> {
    std::fs::read(path).map_err(|error| InputError::Unreadable { path: path.to_owned(), error })
}

impl DisturbanceArguments {
    /// The disturbance that is asked for.
    pub fn request(&self) -> DisturbanceRequest {
        DisturbanceRequest {
            plane: self.plane.clone(),
            disturbance: self.disturbance.clone(),
            shape: self.shape.clone(),
            mode: self.mode.clone(),
            nonlinear: self.nonlinear,
            split: self.split,
        }
    }
}

/// Writes a file, over whatever is in it.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), InputError> {
    std::fs::write(path, content).map_err(|error| InputError::Unwritable { path: path.to_owned(), error })
}

/// The text of a file.
pub fn text_of(path: &Path) -> Result<String, InputError> {
    String::from_utf8(bytes_of(path)?).map_err(|error| InputError::NotText {
        path: path.to_owned(),
        offset: error.utf8_error().valid_up_to(),
    })
}
