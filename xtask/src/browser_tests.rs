//! The tests in web/tests: the built page in a real browser.

use std::process::Command;

use anyhow::{Context as _, Result, ensure};

use crate::chromium;
use crate::packages;
use crate::process;
use crate::project::Project;

const OLDEST_NODE: u32 = 20;

pub fn run(project: &Project) -> Result<()> {
    check_node()?;
    let chromium = chromium::find_or_install()?;
    let web = project.root.join("web");

    packages::install(project)?;

    // Named one by one: what `node --test` makes of a folder differs between its versions.
    let mut tests = std::fs::read_dir(web.join("tests"))
        .context("cannot read web/tests")?
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<Vec<_>>>()?;
    tests.retain(|path| path.to_string_lossy().ends_with(".test.mjs"));
    tests.sort();
    ensure!(!tests.is_empty(), "web/tests holds no test");
    process::run(
        Command::new("node")
            .current_dir(&web)
            .args(["--test", "--test-concurrency=1", "--test-reporter=spec"])
            .args(tests)
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
