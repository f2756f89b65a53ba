//! The packages from npm: of the browser tests, and Binaryen, which makes the release page smaller.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::Result;

use crate::process;
use crate::project::Project;

/// Installs what `web/package-lock.json` names, unless it is there.
pub fn install(project: &Project) -> Result<()> {
    if are_current(project) {
        return Ok(());
    }
    println!("Installing the packages of web/ (once, a few seconds)");
    process::run(npm().current_dir(project.root.join("web")).args(["ci", "--no-audit", "--no-fund"]))
}

/// The script of wasm-opt, installed; `None` where there is no npm to install it with.
///
/// From npm, because its version is pinned there and nothing has to be compiled; Debian's own, 108, makes a page that dies at start.
pub fn wasm_opt(project: &Project) -> Result<Option<PathBuf>> {
    if process::find_on_path(&[NPM]).is_none() {
        println!("Without npm the page isn't made as small as it could be (wasm-opt takes 7 % off)");
        return Ok(None);
    }
    install(project)?;
    Ok(Some(project.root.join("web/node_modules/binaryen/bin/wasm-opt")))
}

/// Makes a program smaller, in place.
pub fn optimise(wasm_opt: &Path, program: &Path) -> Result<()> {
    // Rust's own choice of features, and that of `.cargo/config.toml`.
    let features = [
        "bulk-memory",
        "mutable-globals",
        "nontrapping-float-to-int",
        "reference-types",
        "sign-ext",
        "multivalue",
        "simd",
    ];
    process::run(
        Command::new("node")
            .arg(wasm_opt)
            .arg("-Os")
            .args(features.map(|feature| format!("--enable-{feature}")))
            .args(["--output".as_ref(), program.as_os_str(), program.as_os_str()]),
    )
}

/// Packs a folder with a `package.json` for npm; the package lies beside the folder.
pub fn pack(folder: &Path) -> Result<()> {
    process::run(npm().current_dir(folder).args(["pack", "--silent", "--pack-destination", ".."]))
}

/// Whether every package is there in the version that `web/package.json` pins.
fn are_current(project: &Project) -> bool {
    let mut list = npm();
    list.current_dir(project.root.join("web")).args(["ls", "--silent"]);
    list.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

fn npm() -> Command {
    Command::new(NPM)
}
