//! The last steps on a page that Trunk has built.
//!
//! The content security policy allows no inline script but Trunk's own, which starts the program.
//! Its text holds the hashed names of the files, so its hash is known only after a build.
//!
//! Trunk gives the program's preload an `integrity` that browsers ignore, and say so on every
//! start (crbug.com/981419); it is removed. Scripts and styles keep theirs.
//!
//! The program of a release page is made smaller by wasm-opt: its name keeps the hash of Trunk's output.
//!
//! Its worker is the one that takes itself away: only `cargo xtask build` makes pages that browsers keep. What Trunk serves may change
//! with the next edit.
//!
//! Beside a release page goes the core as a JavaScript module. Here, so that it is there however Trunk was
//! called, and Trunk puts all of it in place at once.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};

use crate::core_module;
use crate::offline;
use crate::packages;
use crate::page::WASM_OPT;
use crate::project::Project;

const PLACEHOLDER: &str = "INLINE-SCRIPT-HASHES";

/// Trunk's hook after a build.
pub fn finish(project: &Project) -> Result<()> {
    let staging = std::env::var_os("TRUNK_STAGING_DIR")
        .context("TRUNK_STAGING_DIR is not set; Trunk calls this as a hook")?;
    let staging = Path::new(&staging);
    let path = staging.join("index.html");
    let page = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let page = with_hashes(&without_ignored_integrity(&page))?;
    std::fs::write(&path, page).with_context(|| format!("cannot write {}", path.display()))?;
    let [worker, off] = [offline::WORKER, offline::WORKER_OFF].map(|name| staging.join(name));
    std::fs::copy(&off, worker).with_context(|| format!("cannot copy {}", off.display()))?;
    if std::env::var_os("TRUNK_PROFILE").is_some_and(|profile| profile == "release") {
        core_module::build(project, staging)?;
        if let Some(wasm_opt) = std::env::var_os(WASM_OPT) {
            for folder in [staging, &staging.join(core_module::FOLDERS[0])] {
                for program in programs(folder)? {
                    packages::optimise(Path::new(&wasm_opt), &program)?;
                }
            }
        }
    }
    Ok(())
}

/// The WebAssembly in a folder.
fn programs(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let files = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    Ok(files.into_iter().filter(|file| file.extension().is_some_and(|ending| ending == "wasm")).collect())
}

fn with_hashes(page: &str) -> Result<String> {
    ensure!(
        page.matches(PLACEHOLDER).count() == 1,
        "index.html must hold {PLACEHOLDER} once, in its content security policy"
    );
    let hashes = inline_scripts(page)
        .map(|script| format!("'sha256-{}'", BASE64_STANDARD.encode(Sha256::digest(script))))
        .collect::<Vec<_>>();
    ensure!(
        !hashes.is_empty(),
        "the built page holds no inline script; Trunk used to start the program with one"
    );
    Ok(page.replace(PLACEHOLDER, &hashes.join(" ")))
}

fn without_ignored_integrity(page: &str) -> String {
    let mut tags = page.split("<link");
    let before = tags.next().unwrap_or_default().to_owned();
    tags.fold(before, |page, tag| {
        let preload = tag.contains("as=fetch") || tag.contains("as=\"fetch\"");
        match tag.split_once(" integrity=") {
            Some((start, rest)) if preload => {
                let end = rest.find([' ', '>']).unwrap_or(rest.len());
                page + "<link" + start + &rest[end..]
            }
            _ => page + "<link" + tag,
        }
    })
}

/// The texts between `<script …>` and `</script>`. The page is Trunk's output, with tags in lower
/// case and none within comments.
fn inline_scripts(page: &str) -> impl Iterator<Item = &str> {
    page.split("<script")
        .skip(1)
        .filter_map(|rest| rest.split_once('>'))
        .filter_map(|(_, rest)| rest.split_once("</script>"))
        .map(|(script, _)| script)
        .filter(|script| !script.is_empty())
}

#[cfg(test)]
mod tests {
    use super::{with_hashes, without_ignored_integrity};

    #[test]
    fn every_inline_script_is_allowed_by_its_hash_and_no_other() {
        let page = "<meta content=\"script-src INLINE-SCRIPT-HASHES\">\
            <script src=a.js></script><script type=module>alert('Hello, world.');</script>";
        let finished = with_hashes(page).expect("the page is whole");
        // The example of the specification.
        assert!(finished.contains("script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='\">"));
    }

    #[test]
    fn only_the_preload_of_the_program_loses_its_integrity() {
        let page = "<link integrity=a rel=stylesheet><link as=fetch integrity=b rel=preload><p>";
        assert_eq!(
            without_ignored_integrity(page),
            "<link integrity=a rel=stylesheet><link as=fetch rel=preload><p>"
        );
    }

    #[test]
    fn a_page_without_a_place_for_the_hashes_is_refused() {
        assert!(with_hashes("<script>1</script>").is_err());
    }
}
