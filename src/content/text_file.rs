//! A text file as it comes from a person, from a folder beside the page, or out of the build.

use serde::{Deserialize, Serialize};

/// A text file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TextFile {
    /// Its name, without a folder.
    pub name: String,
    /// What is in it.
    pub text: String,
}

impl TextFile {
    /// A file of this name with this text.
    pub fn new(name: &str, text: &str) -> Self {
        Self { name: name.to_owned(), text: text.to_owned() }
    }

    /// A file as it was read; an error says which file is no text.
    pub fn from_bytes(name: &str, bytes: &[u8]) -> Result<Self, NotText> {
        let text = std::str::from_utf8(bytes).map_err(|_| NotText { name: name.to_owned() })?;
        Ok(Self::new(name, text))
    }
}

/// What is wrong with a file that isn't text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("“{name}” is no text file in UTF-8")]
pub struct NotText {
    name: String,
}
