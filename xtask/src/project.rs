//! The project's folder, and the versions that its Cargo.lock pins.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};

/// Rust's name of what a browser runs.
pub const WASM_TARGET: &str = "wasm32-unknown-unknown";

pub struct Project {
    pub root: PathBuf,
}

impl Project {
    /// The folder above xtask's own.
    pub fn find() -> Self {
        let xtask = std::env::var_os("CARGO_MANIFEST_DIR")
            .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
        let root = xtask.parent().map_or_else(PathBuf::new, Path::to_path_buf);
        Self { root }
    }

    /// The folder that cargo builds into.
    pub fn target(&self) -> PathBuf {
        std::env::var_os("CARGO_TARGET_DIR")
            .map_or_else(|| self.root.join("target"), |folder| self.root.join(folder))
    }

    /// The built page.
    pub fn dist(&self) -> PathBuf {
        self.root.join("dist")
    }

    /// The version of a package in Cargo.lock.
    pub fn locked_version(&self, package: &str) -> Result<String> {
        let path = self.root.join("Cargo.lock");
        let text =
            std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        version_in_lockfile(&text, package).with_context(|| format!("Cargo.lock names no package {package}"))
    }
}

fn version_in_lockfile(lockfile: &str, package: &str) -> Option<String> {
    let lockfile: toml::Table = lockfile.parse().ok()?;
    let version = lockfile
        .get("package")?
        .as_array()?
        .iter()
        .find(|entry| entry.get("name").and_then(toml::Value::as_str) == Some(package))?
        .get("version")?
        .as_str()?;
    Some(version.to_owned())
}

#[cfg(test)]
mod tests {
    use super::version_in_lockfile;

    #[test]
    fn a_version_is_found_by_the_exact_package_name() {
        let lockfile = "version = 4\n\
            [[package]]\nname = \"wasm-bindgen-macro\"\nversion = \"0.2.1\"\n\
            [[package]]\nname = \"wasm-bindgen\"\nversion = \"0.2.130\"\n";
        assert_eq!(version_in_lockfile(lockfile, "wasm-bindgen").as_deref(), Some("0.2.130"));
        assert_eq!(version_in_lockfile(lockfile, "wasm"), None);
    }
}
