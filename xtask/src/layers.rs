//! Proof that the core builds without a user interface: none of its crates is in the tree.

use anyhow::{Result, ensure};

use crate::process;
use crate::project::Project;

/// Crates that the core must not depend on, by the start of their names.
const NOT_IN_THE_CORE: [&str; 13] = [
    "accesskit",
    "clap",
    "comfy-table",
    "eframe",
    "egui",
    "emath",
    "epaint",
    "glow",
    "indicatif",
    "js-sys",
    "wasm-bindgen",
    "web-sys",
    "winit",
];

/// Fails if the core depends on a user-interface crate, for any target.
pub fn check(project: &Project) -> Result<()> {
    let tree = process::output_of(process::cargo(project).args([
        "tree",
        "--package=eigenwing",
        "--no-default-features",
        "--edges=normal",
        "--target=all",
        "--prefix=none",
        "--format={p}",
    ]))?;
    let mut crates: Vec<&str> = tree.lines().filter_map(|line| line.split_whitespace().next()).collect();
    crates.sort_unstable();
    crates.dedup();
    let unwanted: Vec<&str> = crates
        .iter()
        .copied()
        .filter(|name| NOT_IN_THE_CORE.iter().any(|start| name.starts_with(start)))
        .collect();
    ensure!(unwanted.is_empty(), "the core must not depend on {}", unwanted.join(", "));
    println!("The core builds from {} crates, none of them for a user interface", crates.len() - 1);
    Ok(())
}
