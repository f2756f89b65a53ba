//! Licences, sources and bans of all dependencies, by the rules in deny.toml.

use anyhow::Result;

use crate::process;
use crate::project::Project;
use crate::tools::{self, Tool};

/// Runs cargo-deny. Advisories are left out: their database is a repository of its own, which
/// builds without a network cannot have.
pub fn check(project: &Project) -> Result<()> {
    let cargo_deny = Tool::cargo_deny().installed(project)?;
    process::run(process::cargo(project).env("PATH", tools::path_with(vec![cargo_deny])?).args([
        "deny",
        "--workspace",
        "check",
        "bans",
        "licenses",
        "sources",
    ]))
}
