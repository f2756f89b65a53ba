//! The packages from npm: of the browser tests, and Binaryen, which makes the release page smaller.

use std::path::{Path, PathBuf};
use std::process::Command;

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
    // Rust's own choice of features, which every browser with WebGL 2 has.
    let features = [
        "bulk-memory",
        "mutable-globals",
        "nontrapping-float-to-int",
        "reference-types",
        "sign-ext",
        "multivalue",
    ];
    process::run(
        Command::new("node")
            .arg(wasm_opt)
            .arg("-Os")
            .args(features.map(|feature| format!("--enable-{feature}")))
            .args(["--output".as_ref(), program.as_os_str(), program.as_os_str()]),
    )
}

/// npm keeps a copy of the lockfile that it installed from.
fn are_current(project: &Project) -> bool {
    let modified = |file: &str| {
        std::fs::metadata(project.root.join("web").join(file)).and_then(|file| file.modified()).ok()
    };
    match (modified("node_modules/.package-lock.json"), modified("package-lock.json")) {
        (Some(installed), Some(wanted)) => installed >= wanted,
        _ => false,
    }
}

const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

fn npm() -> Command {
    Command::new(NPM)
}
