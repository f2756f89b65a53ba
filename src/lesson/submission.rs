//! What a person hands in: a report, or links to the scenes of their tasks. Any bytes are one of these, or a reason why not.

use super::record::Records;
use crate::content::import::decode;

/// What was handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct Submission {
    /// Where it stands: a file, or a line of a table.
    pub source: String,
    /// Whose it is, where that is told beside it.
    pub name: Option<String>,
    /// The work, or why there is none, as the end of a sentence.
    pub work: Result<Work, String>,
}

/// A person's work.
#[derive(Clone, Debug, PartialEq)]
pub enum Work {
    /// All that they have done.
    Report(Records),
    /// Links to scenes, in the order in which they were handed in.
    Links(Vec<String>),
}

impl Submission {
    /// A report as it was saved by the page.
    pub fn report(source: &str, bytes: &[u8]) -> Self {
        Self { source: source.to_owned(), name: None, work: report(bytes).map(Work::Report) }
    }
}

fn report(bytes: &[u8]) -> Result<Records, String> {
    let none = || "this is no report that the page has saved".to_owned();
    let (text, _) = decode(bytes).ok_or_else(none)?;
    let text = text.trim();
    if text.is_empty() {
        return Err("the file is empty".to_owned());
    }
    if !text.starts_with('{') && !Records::are_in(text) {
        return Err(none());
    }
    Records::read(text).map_err(|error| format!("what the report carries is damaged: {error}"))
}
