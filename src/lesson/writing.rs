//! Something to write in one's own words: the fenced block `write`. It is kept and not judged, and nothing waits for it.

use super::prediction_file::text;
use super::text::Text;
use crate::content::ContentError;
use crate::content::reader::Block;

/// Something to write.
#[derive(Clone, Debug, PartialEq)]
pub struct Writing {
    /// What is asked.
    pub ask: Text,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// Reads something to write.
pub(super) fn read(file: &str, line: usize, block: &mut Block<'_>) -> Result<Writing, ContentError> {
    let ask = text(file, block, "ask")?;
    block.finish()?;
    Ok(Writing { ask, line })
}
