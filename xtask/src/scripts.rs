//! The exported scripts in the programs that they are for: Python with python-control, GNU Octave with its package control.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context as _, Result, bail};

use crate::debian;
use crate::process;
use crate::project::Project;
use crate::tools::tools_folder;

/// What the Python scripts import, each of one version, so that every machine runs the same.
const PACKAGES: [&str; 4] = ["control==0.10.2", "matplotlib==3.11.2", "numpy==2.4.6", "scipy==1.17.1"];

/// Runs every exported script, each of which compares its numbers with ours.
pub fn run(project: &Project) -> Result<()> {
    let (python, octave) = (python()?, octave()?);
    process::run(
        process::cargo(project)
            .args(["test", "--locked", "--no-default-features", "--features=cli", "--test=export_scripts"])
            .args(["--", "--ignored"])
            .env("EIGENWING_PYTHON", python)
            .env("EIGENWING_OCTAVE", octave),
    )
}

/// A Python of its own with the packages, made first if it isn't there.
pub fn python() -> Result<PathBuf> {
    const ADVICE: &str = "the exported scripts are tested with Python 3.11 or newer with venv and pip: on Debian `sudo apt install python3-venv`";
    let folder = tools_folder()?.join(format!("python-{}", PACKAGES.join("-").replace("==", "-")));
    let python = if cfg!(windows) { folder.join("Scripts/python.exe") } else { folder.join("bin/python") };
    if has_packages(&python) {
        return Ok(python);
    }
    let system = process::find_on_path(&["python3", "python"]).context(ADVICE)?;
    println!("Installing {} into {} (once, about a minute)", PACKAGES.join(", "), folder.display());
    process::run(Command::new(system).args(["-m", "venv", "--clear"]).arg(&folder)).context(ADVICE)?;
    process::run(
        Command::new(&python)
            .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
            .args(PACKAGES),
    )
    .context(ADVICE)?;
    Ok(python)
}

fn has_packages(python: &Path) -> bool {
    let import = ["-c", "import control, matplotlib.pyplot, numpy, scipy.integrate"];
    python.is_file() && succeeds(Command::new(python).args(import).env("MPLBACKEND", "Agg"))
}

/// GNU Octave with its package control, installed first where that can be done without asking.
fn octave() -> Result<PathBuf> {
    const NAMES: [&str; 2] = ["octave-cli", "octave"];
    let found = || process::find_on_path(&NAMES).filter(|octave| has_control(octave));
    if let Some(octave) = found() {
        return Ok(octave);
    }
    if debian::may_install() {
        println!("Installing Debian's octave and octave-control (once, about two minutes, 270 MB)");
        debian::install(&["octave", "octave-control"])?;
        if let Some(octave) = found() {
            return Ok(octave);
        }
    }
    bail!(
        "the exported MATLAB scripts are tested in GNU Octave with its package control: `sudo apt install octave octave-control`"
    )
}

fn has_control(octave: &Path) -> bool {
    succeeds(Command::new(octave).args(["--no-init-file", "--quiet", "--eval", "pkg load control"]))
}

fn succeeds(command: &mut Command) -> bool {
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}
