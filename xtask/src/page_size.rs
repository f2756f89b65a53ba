//! What the page weighs on its way to a reader.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};

use crate::project::Project;

/// The whole page, compressed with brotli at its highest quality, in bytes.
const BUDGET: usize = 1_200_000;

/// Prints a table of the page's files and fails if they outgrow the budget.
pub fn check(project: &Project) -> Result<()> {
    let dist = project.dist();
    let mut files = Vec::new();
    collect_files(&dist, &mut files)?;
    ensure!(!files.is_empty(), "{} is empty", dist.display());
    files.sort();

    println!("{:>10} {:>10}  file", "bytes", "brotli");
    let (mut raw_total, mut compressed_total) = (0, 0);
    for file in &files {
        let content = std::fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
        let compressed = compressed_size(&content)?;
        let name = file.strip_prefix(&dist).unwrap_or(file);
        println!("{:>10} {compressed:>10}  {}", content.len(), name.display());
        raw_total += content.len();
        compressed_total += compressed;
    }
    println!("{raw_total:>10} {compressed_total:>10}  together; the budget is {BUDGET}");
    ensure!(
        compressed_total <= BUDGET,
        "the page has outgrown its budget by {} bytes",
        compressed_total - BUDGET
    );
    Ok(())
}

fn collect_files(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let entries = std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        if path.is_dir() {
            collect_files(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

fn compressed_size(content: &[u8]) -> Result<usize> {
    let parameters =
        brotli::enc::BrotliEncoderParams { quality: 11, size_hint: content.len(), ..Default::default() };
    brotli::BrotliCompress(&mut &content[..], &mut std::io::sink(), &parameters).context("brotli failed")
}
