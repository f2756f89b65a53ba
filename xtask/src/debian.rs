//! Debian's packages, where they can be installed without asking.

use std::process::Command;

use anyhow::Result;

use crate::process;

/// Root on a machine with apt.
pub fn may_install() -> bool {
    process::find_on_path(&["apt-get"]).is_some()
        && process::output_of(Command::new("id").arg("-u")).is_ok_and(|id| id.trim() == "0")
}

/// Installs packages and what they need, nothing else.
pub fn install(packages: &[&str]) -> Result<()> {
    process::run(Command::new("apt-get").args(["update", "-qq"]))?;
    process::run(
        Command::new("apt-get")
            .args(["install", "-qq", "--yes", "--no-install-recommends"])
            .args(packages)
            .env("DEBIAN_FRONTEND", "noninteractive"),
    )
}
