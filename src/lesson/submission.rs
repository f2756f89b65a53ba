//! What a person hands in: a report, or links to the scenes of their tasks. Any bytes are one of these, or a reason why not.

use super::record::Records;

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
    let text = text(bytes);
    let text = text.trim();
    if text.is_empty() {
        return Err("the file is empty".to_owned());
    }
    if !text.starts_with('{') && !Records::are_in(text) {
        return Err("this is no report that the page has saved".to_owned());
    }
    Records::read(text).map_err(|error| format!("what the report carries is damaged: {error}"))
}

/// Text as programs for tables and mail leave it: UTF-8 with or without a mark, UTF-16 with one, or else one byte a letter.
pub(super) fn text(bytes: &[u8]) -> String {
    let wide = |rest: &[u8], read: fn([u8; 2]) -> u16| {
        let units = rest.chunks_exact(2).map(|pair| read([pair[0], pair[1]]));
        char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => text(rest),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        _ => String::from_utf8(bytes.to_vec())
            .unwrap_or_else(|_| bytes.iter().copied().map(char::from).collect()),
    }
}
