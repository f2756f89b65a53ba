//! The core as a JavaScript module beside the page, and the example page that uses it.

use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result};

use crate::process;
use crate::project::{Project, WASM_TARGET};

/// The module's folder beside the page, and that of its example.
pub const FOLDERS: [&str; 2] = ["core", "example"];

/// The module's own name.
pub const NAME: &str = "eigenwing-core";

/// Builds `core/` and `example/` in a folder with a built page, with the wasm-bindgen that Trunk found on the PATH.
pub fn build(project: &Project, page: &Path) -> Result<()> {
    let [core, example] = FOLDERS.map(|folder| page.join(folder));
    build_module(project, &core, Path::new("wasm-bindgen"))?;
    copy_folder(&project.root.join("web/example"), &example)
}

/// Builds the module's three files in a folder.
pub fn build_module(project: &Project, folder: &Path, wasm_bindgen: &Path) -> Result<()> {
    process::run(
        process::cargo(project)
            .args(["build", "--quiet", "--locked", "--release", "--target", WASM_TARGET])
            .args(["--no-default-features", "--features=javascript"])
            .arg(format!("--bin={NAME}")),
    )?;
    let program = project.target().join(WASM_TARGET).join("release").join(format!("{NAME}.wasm"));
    process::run(
        Command::new(wasm_bindgen).args(["--target", "web", "--out-dir"]).arg(folder).arg(&program),
    )?;
    // For those who link it with other WebAssembly, and none of its business.
    remove(&folder.join(format!("{NAME}_bg.wasm.d.ts")))
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
