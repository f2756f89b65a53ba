//! Programs the build needs, each of one exact version, in a folder of their own: they never clash
//! with what is installed already, and every clone of the project shares them.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context as _, Result, bail};
use etcetera::BaseStrategy as _;

use crate::process;
use crate::project::{Project, WASM_TARGET};

pub struct Tool {
    package: &'static str,
    version: String,
    /// Whether the package is built with its own lockfile.
    locked: bool,
    /// Roughly how long installing takes on two cores.
    minutes: u32,
}

impl Tool {
    /// The newest Trunk that the project's Rust can build.
    pub fn trunk() -> Self {
        Self { package: "trunk", version: "0.22.0-beta.1".to_owned(), locked: true, minutes: 8 }
    }

    /// The command line must be of the very version that the program is linked with.
    pub fn wasm_bindgen(project: &Project) -> Result<Self> {
        Ok(Self {
            package: "wasm-bindgen-cli",
            version: project.locked_version("wasm-bindgen")?,
            // Its lockfile names a crate version that was withdrawn.
            locked: false,
            minutes: 4,
        })
    }

    pub fn cargo_deny() -> Self {
        Self { package: "cargo-deny", version: CARGO_DENY_VERSION.to_owned(), locked: true, minutes: 6 }
    }

    /// The folder with the tool's program, which is installed first if it is missing.
    pub fn installed(&self, project: &Project) -> Result<PathBuf> {
        let root = tools_folder()?.join(format!("{}-{}", self.package, self.version));
        let bin = root.join("bin");
        // Cargo begins with an empty list and writes into it last, so a half-finished installation isn't taken for a whole one.
        let list = std::fs::read_to_string(root.join(".crates.toml")).unwrap_or_default();
        if list.contains(self.package) {
            return Ok(bin);
        }
        println!(
            "Installing {} {} into {} (once, about {} minutes on two cores)",
            self.package,
            self.version,
            root.display(),
            self.minutes
        );
        let mut install = process::cargo(project);
        install.args(["install", "--quiet", "--root"]).arg(&root).args(["--version", &self.version]);
        if self.locked {
            install.arg("--locked");
        }
        install.arg(self.package);
        // The tool's own build has nothing to do with the project's settings, and it is soon over:
        // Trunk's own profile would take a third longer, half of it on one core.
        install
            .env_remove("CARGO_TARGET_DIR")
            .env_remove("RUSTFLAGS")
            .env("CARGO_PROFILE_RELEASE_LTO", "off")
            .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
            .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1");
        process::run(&mut install)?;
        Ok(bin)
    }
}

/// Rust's name of the machine that programs are built for.
pub fn host(project: &Project) -> Result<String> {
    let told = process::output_of(rustc(project).arg("--version").arg("--verbose"))?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc doesn't tell its host")?.to_owned())
}

fn rustc(project: &Project) -> Command {
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    rustc.current_dir(&project.root);
    rustc
}

/// Adds Rust's WebAssembly target if it is missing.
pub fn add_wasm_target(project: &Project) -> Result<()> {
    let sysroot = process::output_of(rustc(project).args(["--print", "sysroot"]))?;
    let library = PathBuf::from(sysroot.trim()).join("lib/rustlib").join(WASM_TARGET);
    if library.is_dir() {
        return Ok(());
    }
    if process::find_on_path(&["rustup"]).is_none() {
        bail!(
            "Rust's target {WASM_TARGET} is missing, and so is rustup, which would add it: install Rust from https://rustup.rs"
        );
    }
    println!("Adding Rust's target {WASM_TARGET} (once, about half a minute)");
    process::run(Command::new("rustup").current_dir(&project.root).args(["target", "add", WASM_TARGET]))
}

/// The PATH with these folders in front.
pub fn path_with(folders: Vec<PathBuf>) -> Result<std::ffi::OsString> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::join_paths(folders.into_iter().chain(std::env::split_paths(&path)))
        .context("a folder's name cannot be put on the PATH")
}

/// The folder of all tools, in the user's cache.
pub fn tools_folder() -> Result<PathBuf> {
    let base = etcetera::choose_base_strategy().context("this user has no home folder")?;
    Ok(base.cache_dir().join("eigenwing"))
}

const CARGO_DENY_VERSION: &str = "0.20.2";
