//! The size of the page on its way to a reader, and of the JavaScript module beside it.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};

use crate::compress;
use crate::core_module;
use crate::files;
use crate::project::Project;

/// The whole page, compressed with brotli at its highest quality, in bytes.
///
/// It weighs 1.48 MB today, a third of it egui's own text engine and fonts; 1.30 before lectures, homework, embedding and a
/// person's own aircraft came, 1.39 before feedback with its loops, charts of sweeps and further states. Readers and writers of
/// files are in the JavaScript module, which is fetched when they are asked for. On a line of 5 Mbit/s a full budget takes 2.4 s
/// to arrive, once: then the page is kept.
const BUDGET: u64 = 1_500_000;

/// The lessons, which are fetched when a person asks for them, likewise.
const LESSONS_BUDGET: u64 = 400_000;

/// Their folder.
const LESSONS: &str = "lessons";

/// The module and its example, likewise, which the page loads only where a file is opened or something is taken along. It is that
/// much since loops, nonlinear flight under a law, charts, pages of paper and other programs' notations are in it; 572 kB before the
/// outlines of the letters of figures and the forms of matrices that people write, 613 kB with them.
const CORE_BUDGET: u64 = 640_000;

/// Prints tables of the files and fails if they outgrow their budgets.
pub fn check(project: &Project) -> Result<()> {
    let dist = project.dist();
    let mut files = files::below(&dist)?;
    files.retain(|file| !is_beside(file));
    let of_core = core_module::FOLDERS.map(|folder| dist.join(folder));
    let (core, rest): (Vec<_>, Vec<_>) =
        files.into_iter().partition(|file| of_core.iter().any(|folder| file.starts_with(folder)));
    let (lessons, page): (Vec<_>, Vec<_>) =
        rest.into_iter().partition(|file| file.starts_with(dist.join(LESSONS)));
    check_budget(&dist, "page", &page, BUDGET)?;
    check_budget(&dist, "course", &lessons, LESSONS_BUDGET)?;
    check_budget(&dist, "JavaScript module", &core, CORE_BUDGET)
}

/// Files for who has no WebGL, and the switch of the host.
const BESIDE: [&str; 4] = ["plain.html", "plain.css", "plain.js", "sw-off.js"];

/// Whether a browser that draws the page doesn't load a file: the compressed form of another, a picture for who installs the page, or
/// what only some need.
fn is_beside(file: &Path) -> bool {
    let name = file.file_name().and_then(|name| name.to_str());
    compress::is_compressed(file) || name.is_some_and(|name| name.ends_with(".png") || BESIDE.contains(&name))
}

fn check_budget(dist: &Path, what: &str, files: &[PathBuf], budget: u64) -> Result<()> {
    ensure!(!files.is_empty(), "{} holds no {what}", dist.display());
    println!("{:>10} {:>10}  file", "bytes", "brotli");
    let (mut raw_total, mut compressed_total) = (0, 0);
    for file in files {
        let raw = file.metadata().with_context(|| format!("cannot read {}", file.display()))?.len();
        let compressed = compress::length(file)?;
        println!("{raw:>10} {compressed:>10}  {}", files::address(dist, file));
        raw_total += raw;
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
