//! The core as a JavaScript module beside the page, and the example page that uses it.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};

use crate::process;
use crate::project::Project;

/// The module's folder beside the page, and that of its example.
pub const FOLDERS: [&str; 2] = ["core", "example"];

const NAME: &str = "eigenwing-core";

/// Builds `core/` and `example/` in a folder with a built page. Of the wasm-bindgen on the PATH, as Trunk found it there.
pub fn build(project: &Project, page: &Path) -> Result<()> {
    let target = "wasm32-unknown-unknown";
    process::run(
        process::cargo(project)
            .args(["build", "--quiet", "--locked", "--release", "--target", target])
            .args(["--no-default-features", "--features=javascript"])
            .arg(format!("--bin={NAME}")),
    )?;
    let program = target_folder(project).join(target).join("release").join(format!("{NAME}.wasm"));
    let [core, example] = FOLDERS.map(|folder| page.join(folder));
    process::run(
        Command::new("wasm-bindgen").args(["--target", "web", "--out-dir"]).arg(&core).arg(&program),
    )?;
    // For those who link it with other WebAssembly, and none of its business.
    remove(&core.join(format!("{NAME}_bg.wasm.d.ts")))?;
    copy_folder(&project.root.join("web/example"), &example)
}

/// Where cargo puts what it builds.
fn target_folder(project: &Project) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| project.root.join("target"), |folder| project.root.join(folder))
}

fn remove(file: &Path) -> Result<()> {
    std::fs::remove_file(file).with_context(|| format!("cannot remove {}", file.display()))
}

fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    std::fs::create_dir_all(to).with_context(|| format!("cannot make {}", to.display()))?;
    let entries = std::fs::read_dir(from).with_context(|| format!("cannot read {}", from.display()))?;
    for entry in entries {
        let file = entry?.path();
        let name = file.file_name().context("a file without a name")?;
        std::fs::copy(&file, to.join(name)).with_context(|| format!("cannot copy {}", file.display()))?;
    }
    Ok(())
}
