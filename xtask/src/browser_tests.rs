//! The tests in web/tests: the built page in real browsers, Chromium, Firefox and WebKitGTK.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};

use crate::chromium;
use crate::firefox;
use crate::package;
use crate::package_lesson;
use crate::packages;
use crate::process;
use crate::project::Project;
use crate::scripts;
use crate::webkit;

const OLDEST_NODE: u32 = 20;

/// A lesson for the tests of the single-file edition and of the package.
const SINGLE: &str = "single.md";

pub fn run(project: &Project) -> Result<()> {
    check_node()?;
    let chromium = chromium::find_or_install()?;
    let firefox = firefox::find_or_install()?;
    let webkit = webkit::find_or_install()?;
    let python = scripts::python()?;
    let web = project.root.join("web");

    packages::install(project)?;
    let package = package_lesson::build(project, &web.join("tests").join(SINGLE))?;
    let core = package::build_core(project)?;
    let single = project.target().join("single").join(SINGLE).with_extension("html");

    let mut tests = tests_in(&web.join("tests"))?;
    tests.extend(tests_in(&web.join("tests/firefox"))?);
    if webkit.is_some() {
        tests.extend(tests_in(&web.join("tests/webkit"))?);
    }
    process::run(
        Command::new("node")
            .current_dir(&web)
            .args(["--test", "--test-concurrency=1", "--test-reporter=spec"])
            .args(tests)
            .env("CHROMIUM", chromium)
            .env("FIREFOX", firefox)
            .env("MINIBROWSER", webkit.unwrap_or_default())
            .env("PYTHON", python)
            .env("CORE_PACKAGE", core)
            .env("SINGLE", single)
            .env("SCORM", package),
    )
}

/// The files of tests in a folder, named one by one: what `node --test` makes of a folder differs between its versions.
fn tests_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut tests = std::fs::read_dir(folder)
        .with_context(|| format!("cannot read {}", folder.display()))?
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<Vec<_>>>()?;
    tests.retain(|path| path.to_string_lossy().ends_with(".test.mjs"));
    tests.sort();
    ensure!(!tests.is_empty(), "{} holds no test", folder.display());
    Ok(tests)
}

/// Random use of the built page for so many minutes.
pub fn soak(project: &Project, minutes: u32, seed: u32) -> Result<()> {
    check_node()?;
    let chromium = chromium::find_or_install()?;
    ensure!(project.dist().join("index.html").is_file(), "there is no page yet: `cargo xtask build` first");
    packages::install(project)?;
    process::run(
        Command::new("node")
            .current_dir(project.root.join("web"))
            .args(["soak.mjs".to_owned(), minutes.to_string(), seed.to_string()])
            .env("CHROMIUM", chromium),
    )
}

fn check_node() -> Result<()> {
    const ADVICE: &str = "the browser tests need Node.js 20 or newer with npm, from https://nodejs.org";
    let version = process::output_of(Command::new("node").arg("--version")).context(ADVICE)?;
    let major =
        version.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse::<u32>().ok());
    ensure!(
        major.is_some_and(|major| major >= OLDEST_NODE),
        "this is Node.js {}, but {ADVICE}",
        version.trim()
    );
    Ok(())
}
