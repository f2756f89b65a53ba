//! The glossary and the references, which all lessons share.

use std::collections::BTreeMap;

use crate::content::ContentError;
use crate::content::reader::with_file;

/// The glossary and the references.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shelf {
    /// Words by their keys.
    pub glossary: BTreeMap<String, Entry>,
    /// References by their keys.
    pub references: BTreeMap<String, Reference>,
}

/// A word and its sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The word.
    pub word: String,
    /// What it means.
    pub says: String,
}

/// A book or report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Who wrote it.
    pub author: String,
    /// Its title.
    pub title: String,
    /// Where and when it appeared.
    pub published: String,
}

impl Shelf {
    /// Reads `glossary.toml` and `references.toml`.
    pub fn read(glossary: &str, references: &str) -> Result<Self, ContentError> {
        let glossary = with_file("glossary.toml", glossary, |file| {
            let mut entries = BTreeMap::new();
            for key in file.names() {
                let mut block = file.block(key)?;
                let entry = Entry { word: block.text("word")?, says: block.text("says")? };
                block.finish()?;
                entries.insert(key.to_owned(), entry);
            }
            Ok(entries)
        })?;
        let references = with_file("references.toml", references, |file| {
            let mut entries = BTreeMap::new();
            for key in file.names() {
                let mut block = file.block(key)?;
                let entry = Reference {
                    author: block.text("author")?,
                    title: block.text("title")?,
                    published: block.text("published")?,
                };
                block.finish()?;
                entries.insert(key.to_owned(), entry);
            }
            Ok(entries)
        })?;
        Ok(Self { glossary, references })
    }
}
