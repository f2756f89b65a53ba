//! Packages to publish, in `target/packages`: the core for npm, and the command line as an archive with its manual and completions.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::core_module;
use crate::packages;
use crate::process;
use crate::project::Project;
use crate::tools::{self, Tool};

/// What every package holds beside its own files.
const NOTES: [&str; 3] = ["CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT"];

/// The program of the command line.
const CLI: &str = "eigenwing-cli";

/// Shells that completions are written for, and the files that they look for.
const COMPLETIONS: [(&str, &str); 4] = [
    ("bash", "eigenwing-cli.bash"),
    ("zsh", "_eigenwing-cli"),
    ("fish", "eigenwing-cli.fish"),
    ("powershell", "_eigenwing-cli.ps1"),
];

/// Builds both packages.
pub fn build(project: &Project) -> Result<()> {
    for package in [build_core(project)?, build_cli(project)?] {
        println!("A package is {}", package.display());
    }
    Ok(())
}

/// Builds the package of the core for npm, and says where it is.
pub fn build_core(project: &Project) -> Result<PathBuf> {
    tools::add_wasm_target(project)?;
    let folder = emptied(packages_folder(project).join(core_module::NAME))?;
    let wasm_bindgen = Tool::wasm_bindgen(project)?.installed(project)?.join("wasm-bindgen");
    core_module::build_module(project, &folder, &wasm_bindgen)?;
    let wasm_opt = packages::wasm_opt(project)?;
    ensure!(wasm_opt.is_some(), "the package of the core is made with npm, from https://nodejs.org");
    if let Some(wasm_opt) = wasm_opt {
        packages::optimise(&wasm_opt, &folder.join(format!("{}_bg.wasm", core_module::NAME)))?;
    }
    let version = project.locked_version("eigenwing")?;
    put(&folder.join("package.json"), &description(&version))?;
    copy(&project.root.join("web/node.js"), &folder.join("node.js"))?;
    copy(&project.root.join("docs/JAVASCRIPT.md"), &folder.join("README.md"))?;
    copy_notes(project, &folder)?;
    packages::pack(&folder)?;
    Ok(folder.with_file_name(format!("{}-{version}.tgz", core_module::NAME)))
}

/// What npm is told of the package.
fn description(version: &str) -> String {
    let name = core_module::NAME;
    // As text: the conditions of "exports" are tried in the order in which they stand, and the last holds for everyone.
    format!(
        r#"{{
  "name": "{name}",
  "version": "{version}",
  "description": "Flight dynamics of small disturbances: eigenvalues, named modes with reasons, responses, handling qualities",
  "keywords": ["flight dynamics", "stability derivatives", "eigenvalues", "phugoid", "Dutch roll", "handling qualities"],
  "license": "MIT OR Apache-2.0",
  "type": "module",
  "sideEffects": false,
  "exports": {{
    ".": {{ "types": "./{name}.d.ts", "node": "./node.js", "default": "./{name}.js" }},
    "./program": "./{name}_bg.wasm"
  }}
}}
"#
    )
}

/// Builds the archive of the command line for this machine, and says where it is.
fn build_cli(project: &Project) -> Result<PathBuf> {
    process::run(
        process::cargo(project)
            .args(["build", "--locked", "--profile=cli", "--no-default-features", "--features=cli"])
            .arg(format!("--bin={CLI}")),
    )?;
    let file = PathBuf::from(CLI).with_extension(std::env::consts::EXE_EXTENSION);
    let program = project.target().join("cli").join(&file);
    let (version, machine) = (project.locked_version("eigenwing")?, tools::host(project)?);
    let name = format!("{CLI}-{version}-{machine}");
    let folder = emptied(packages_folder(project).join(&name))?;
    copy(&program, &folder.join(file))?;
    copy_notes(project, &folder)?;
    let manual = emptied(folder.join("man"))?;
    process::run(Command::new(&program).arg("manual").arg(manual))?;
    let completions = emptied(folder.join("completions"))?;
    for (shell, file) in COMPLETIONS {
        let text = process::output_of(Command::new(&program).args(["completions", shell]))?;
        put(&completions.join(file), &text)?;
    }
    let archive = packages_folder(project).join(format!("{name}.tar.gz"));
    let written =
        std::fs::File::create(&archive).with_context(|| format!("cannot write {}", archive.display()))?;
    let mut tar = tar::Builder::new(GzEncoder::new(written, Compression::best()));
    tar.append_dir_all(&name, &folder).with_context(|| format!("cannot pack {}", folder.display()))?;
    tar.into_inner()?.finish()?;
    Ok(archive)
}

fn packages_folder(project: &Project) -> PathBuf {
    project.target().join("packages")
}

fn copy_notes(project: &Project, folder: &Path) -> Result<()> {
    NOTES.iter().try_for_each(|name| copy(&project.root.join(name), &folder.join(name)))
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    std::fs::copy(from, to).map(|_| ()).with_context(|| format!("cannot copy {}", from.display()))
}

fn put(file: &Path, text: &str) -> Result<()> {
    std::fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))
}

/// A folder with nothing in it.
fn emptied(folder: PathBuf) -> Result<PathBuf> {
    if folder.exists() {
        std::fs::remove_dir_all(&folder).with_context(|| format!("cannot empty {}", folder.display()))?;
    }
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    Ok(folder)
}
