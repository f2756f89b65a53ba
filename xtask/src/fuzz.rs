//! The fuzz targets in `fuzz/`, each for some seconds, and the soak of random scenarios.
//!
//! libFuzzer with the coverage of LLVM that stable Rust has behind `-C passes`, so that no nightly toolchain is needed; cargo-fuzz asks for
//! one because of its address sanitizer, which finds nothing in a program without unsafe code. `cargo fuzz` works on the same folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail};

use crate::files;
use crate::process;
use crate::project::Project;
use crate::tools;

/// What LLVM is to count, as cargo-fuzz has it.
const COVERAGE: [&str; 5] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
];

/// A target, where its seeds lie, and by which ending its first byte chooses what they are.
struct Target {
    name: &'static str,
    seeds: &'static str,
    endings: &'static [&'static str],
}

const TARGETS: [Target; 7] = [
    Target { name: "links", seeds: "tests/links.txt", endings: &[] },
    Target { name: "aircraft", seeds: "assets/aircraft", endings: &[] },
    Target { name: "matrices", seeds: "tests/data/matrices", endings: &["m", "json", "csv", "py"] },
    Target { name: "lessons", seeds: "assets/lessons", endings: &[] },
    Target { name: "reports", seeds: "fuzz/corpus/reports", endings: &[] },
    Target {
        name: "importers",
        seeds: "tests/data/import",
        endings: &["st", "sys", "txt", "stab", "out", "xml", "json", "csv"],
    },
    Target { name: "requests", seeds: "fuzz/corpus/requests", endings: &[] },
];

/// One target or all of them, each for so many seconds.
pub fn run(project: &Project, wanted: Option<&str>, seconds: u64) -> Result<()> {
    let targets: Vec<&Target> =
        TARGETS.iter().filter(|target| wanted.is_none_or(|wanted| wanted == target.name)).collect();
    if targets.is_empty() {
        bail!("there is no such target; there are {}", TARGETS.map(|target| target.name).join(", "));
    }
    let folder = project.target().join("fuzz");
    let host = tools::host(project)?;
    process::run(
        cargo(project, "build")
            .args(["--release", "--quiet", "--target", &host, "--target-dir"])
            .arg(&folder)
            // Not the soak: only libFuzzer has what the coverage calls.
            .args(targets.iter().flat_map(|target| ["--bin", target.name]))
            .env("CARGO_ENCODED_RUSTFLAGS", COVERAGE.join("\u{1f}")),
    )?;
    for target in targets {
        println!("Fuzzing {} for {seconds} s", target.name);
        let kept = made(folder.join("corpus").join(target.name))?;
        let seeds = seeds(project, target, &folder)?;
        let artifacts = made(folder.join("artifacts"))?;
        let own = project.root.join("fuzz/corpus").join(target.name);
        let mut fuzz = Command::new(folder.join(&host).join("release").join(target.name));
        fuzz.current_dir(&folder)
            .args([
                "-verbosity=0",
                "-print_funcs=0",
                "-print_final_stats=1",
                "-timeout=20",
                "-rss_limit_mb=1024",
            ])
            .args(["-max_len=20000".to_owned(), format!("-max_total_time={seconds}")])
            .arg(format!("-artifact_prefix={}/{}-", artifacts.display(), target.name))
            .args([&kept, &seeds])
            .args(own.is_dir().then_some(own));
        let found = || format!("{} has found something: see {}", target.name, artifacts.display());
        process::run(&mut fuzz).with_context(found)?;
    }
    Ok(())
}

/// Random scenarios through the analysis, with a report.
pub fn soak(project: &Project, count: u64, seed: u64) -> Result<()> {
    process::run(
        cargo(project, "run")
            .args(["--release", "--quiet", "--no-default-features", "--bin=soak", "--target-dir"])
            .arg(project.target().join("soak"))
            .args(["--".to_owned(), count.to_string(), seed.to_string()]),
    )
}

fn cargo(project: &Project, command: &str) -> Command {
    let mut cargo = process::cargo(project);
    cargo.args([command, "--locked", "--manifest-path"]).arg(project.root.join("fuzz/Cargo.toml"));
    cargo
}

/// The folder of a target's seeds, as it reads them.
fn seeds(project: &Project, target: &Target, folder: &Path) -> Result<PathBuf> {
    let seeds = made(folder.join("seeds").join(target.name))?;
    let from = project.root.join(target.seeds);
    let texts: Vec<Vec<u8>> = if from.is_file() {
        let lines = std::fs::read_to_string(&from)?;
        lines.lines().map(|line| line.split(" -> ").next().unwrap_or_default().into()).collect()
    } else {
        files::below(&from)?
            .iter()
            .filter_map(|file| seed(target, file).transpose())
            .collect::<Result<_>>()?
    };
    for (number, text) in texts.iter().enumerate() {
        std::fs::write(seeds.join(number.to_string()), text)?;
    }
    Ok(seeds)
}

/// A file as a seed, behind the byte that chooses its form; none of a form that the target doesn't have.
fn seed(target: &Target, file: &Path) -> Result<Option<Vec<u8>>> {
    let content = std::fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    if target.endings.is_empty() {
        return Ok(Some(content));
    }
    let place = target.endings.iter().position(|ending| file.extension().is_some_and(|own| own == *ending));
    Ok(place.and_then(|place| u8::try_from(place).ok()).map(|place| [vec![place], content].concat()))
}

fn made(folder: PathBuf) -> Result<PathBuf> {
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    Ok(folder)
}
