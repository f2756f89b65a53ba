//! Compressed files beside those of the page, for hosts that deliver them as they are: `.br` and `.gz`, each at its best.

use std::ffi::OsString;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::files;

/// What compressing makes smaller, by its ending.
const TEXT: [&str; 11] =
    ["css", "html", "js", "json", "md", "svg", "toml", "ts", "txt", "wasm", "webmanifest"];

/// Smaller files than this travel in one packet as they are [bytes].
const LEAST: usize = 1_000;

/// Writes the compressed files of a page.
pub fn write(page: &Path) -> Result<()> {
    for file in files::below(page)? {
        let is_text = file.extension().is_some_and(|ending| TEXT.iter().any(|text| *text == ending));
        let content = std::fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
        if is_text && content.len() >= LEAST {
            put(&beside(&file, "br"), &brotli(&content)?)?;
            put(&beside(&file, "gz"), &gzip(&content)?)?;
        }
    }
    Ok(())
}

/// Whether a file is the compressed form of another.
pub fn is_compressed(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending == "br" || ending == "gz")
}

/// Bytes of a file on its way to a reader: of its brotli form, where there is one.
pub fn length(file: &Path) -> Result<u64> {
    let compressed = beside(file, "br");
    let travels = if compressed.is_file() { &compressed } else { file };
    let metadata = travels.metadata().with_context(|| format!("cannot read {}", travels.display()))?;
    Ok(metadata.len())
}

fn beside(file: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(file);
    name.push(".");
    name.push(ending);
    name.into()
}

fn put(file: &Path, content: &[u8]) -> Result<()> {
    std::fs::write(file, content).with_context(|| format!("cannot write {}", file.display()))
}

fn brotli(content: &[u8]) -> Result<Vec<u8>> {
    let parameters =
        brotli::enc::BrotliEncoderParams { quality: 11, size_hint: content.len(), ..Default::default() };
    let mut compressed = Vec::new();
    brotli::BrotliCompress(&mut &content[..], &mut compressed, &parameters).context("brotli failed")?;
    Ok(compressed)
}

fn gzip(content: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(content)?;
    Ok(encoder.finish()?)
}
