//! Every check and test, in order, each announced and timed.

use std::time::{Duration, Instant};

use anyhow::{Context as _, Result};

use crate::process::{cargo, run};
use crate::project::Project;
use crate::{browser_tests, layers, page, page_size, scripts};

struct Stage {
    name: &'static str,
    run: fn(&Project) -> Result<()>,
}

/// The quick ones, and those that fail most often, come first.
const STAGES: [Stage; 11] = [
    Stage { name: "format", run: check_format },
    Stage { name: "layers", run: layers::check },
    Stage { name: "core tests", run: test_core },
    Stage { name: "exported scripts", run: scripts::run },
    Stage { name: "user-interface tests", run: test_ui },
    Stage { name: "lints of the core alone", run: lint_core },
    Stage { name: "lints of everything", run: lint_everything },
    Stage { name: "lints of the web application", run: lint_web },
    Stage { name: "release page", run: page::build },
    Stage { name: "page size", run: page_size::check },
    Stage { name: "browser tests", run: browser_tests::run },
];

/// Runs all stages, stopping at the first that fails.
pub fn run_all(project: &Project) -> Result<()> {
    let start = Instant::now();
    let mut times = Vec::new();
    for (number, stage) in (1..).zip(&STAGES) {
        println!("\n==> {number}/{} {}", STAGES.len(), stage.name);
        let stage_start = Instant::now();
        (stage.run)(project).with_context(|| format!("{} failed", stage.name))?;
        let time = stage_start.elapsed();
        println!("<== {} in {}", stage.name, shown(time));
        times.push((stage.name, time));
    }
    println!();
    for (name, time) in times {
        println!("{:>9}  {name}", shown(time));
    }
    println!("All {} stages of the tests passed in {}.", STAGES.len(), shown(start.elapsed()));
    Ok(())
}

fn check_format(project: &Project) -> Result<()> {
    run(cargo(project).args(["fmt", "--all", "--check"]))
}

fn test_core(project: &Project) -> Result<()> {
    // With the command line, so that the core is compiled for tests once.
    run(cargo(project).args(["test", "--locked", "--no-default-features", "--features=cli"]))?;
    run(cargo(project).args(["test", "--locked", "--package=xtask"]))
}

fn test_ui(project: &Project) -> Result<()> {
    run(cargo(project)
        .args(["test", "--locked", "--no-default-features"])
        .args(["--features=ui-tests", "--test=ui*"]))?;
    run(cargo(project).args(["test", "--locked", "--package=egui-dom-mirror"]))
}

/// Finds what is unused or missing without a user interface.
fn lint_core(project: &Project) -> Result<()> {
    lint(project, &["--all-targets", "--no-default-features"])
}

fn lint_everything(project: &Project) -> Result<()> {
    lint(project, &["--workspace", "--all-targets", "--features=ui-tests"])
}

/// Reads the code that is compiled for the browser only.
fn lint_web(project: &Project) -> Result<()> {
    crate::tools::add_wasm_target(project)?;
    let what = ["--bin=eigenwing", "--bin=eigenwing-core", "--features=javascript"];
    lint(project, &[&what[..], &["--target=wasm32-unknown-unknown"]].concat())
}

fn lint(project: &Project, what: &[&str]) -> Result<()> {
    run(cargo(project).args(["clippy", "--locked"]).args(what).args(["--", "--deny=warnings"]))
}

/// Seconds, or minutes and seconds.
fn shown(time: Duration) -> String {
    let seconds = time.as_secs();
    if seconds < 60 {
        format!("{:.1} s", time.as_secs_f64())
    } else {
        format!("{} min {:02} s", seconds / 60, seconds % 60)
    }
}
