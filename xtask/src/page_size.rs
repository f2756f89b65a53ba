//! The size of the page on its way to a reader, and of the JavaScript module beside it.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};

use crate::core_module;
use crate::project::Project;

/// The whole page, compressed with brotli at its highest quality, in bytes.
///
/// It weighs 1.30 MB today, a third of it egui's own text engine and fonts. The rest of the budget is for
/// import and export; on a line of 5 Mbit/s a full one would take 2.2 s to arrive.
const BUDGET: usize = 1_350_000;

/// The lessons, which are fetched when a person asks for them, likewise.
const LESSONS_BUDGET: usize = 400_000;

/// Their folder.
const LESSONS: &str = "lessons";

/// The module and its example, which the page doesn't load, likewise.
const CORE_BUDGET: usize = 300_000;

/// Prints tables of the files and fails if they outgrow their budgets.
pub fn check(project: &Project) -> Result<()> {
    let dist = project.dist();
    let mut files = Vec::new();
    collect_files(&dist, &mut files)?;
    files.sort();
    let of_core = core_module::FOLDERS.map(|folder| dist.join(folder));
    let (core, rest): (Vec<_>, Vec<_>) =
        files.into_iter().partition(|file| of_core.iter().any(|folder| file.starts_with(folder)));
    let (lessons, page): (Vec<_>, Vec<_>) =
        rest.into_iter().partition(|file| file.starts_with(dist.join(LESSONS)));
    check_budget(&dist, "page", &page, BUDGET)?;
    check_budget(&dist, "course", &lessons, LESSONS_BUDGET)?;
    check_budget(&dist, "JavaScript module", &core, CORE_BUDGET)
}

fn check_budget(dist: &Path, what: &str, files: &[PathBuf], budget: usize) -> Result<()> {
    ensure!(!files.is_empty(), "{} holds no {what}", dist.display());
    println!("{:>10} {:>10}  file", "bytes", "brotli");
    let (mut raw_total, mut compressed_total) = (0, 0);
    for file in files {
        let content = std::fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
        let compressed = compressed_size(&content)?;
        let name = file.strip_prefix(dist).unwrap_or(file);
        println!("{:>10} {compressed:>10}  {}", content.len(), name.display());
        raw_total += content.len();
        compressed_total += compressed;
    }
    println!("{raw_total:>10} {compressed_total:>10}  together; the budget is {budget}");
    ensure!(
        compressed_total <= budget,
        "the {what} has outgrown its budget by {} bytes",
        compressed_total - budget
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
