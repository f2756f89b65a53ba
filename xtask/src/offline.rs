//! The page without a network: what `web/sw.js` is told of a built page.
//!
//! Why not Workbox, the well-kept tool for this: workbox-build 7.4 brings 323 packages (77 MB) into a build that needs no npm today, and
//! its precache is one cache that all versions share. What is wanted here is less: a list of files with their hashes, which the next
//! forty lines make, and a worker that fills one cache a version and reads from it, which is shorter than a configuration.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context as _, Result, ensure};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};

use crate::files;
use crate::project::Project;

/// The worker beside the page.
pub const WORKER: &str = "sw.js";

/// What a page has as its worker that is built to be looked at: it takes itself away, and what was kept.
pub const WORKER_OFF: &str = "sw-off.js";

/// Where the page holds the name of its version.
const PLACEHOLDER: &str = "EIGENWING-VERSION";

/// Endings of what needn't be kept: the pictures that a browser asks for as it installs the page, and types for programmers.
const NOT_KEPT: [&str; 2] = [".png", ".d.ts"];

/// Writes the worker of a built page, and the name of this version into the page.
pub fn write(project: &Project, page: &Path) -> Result<()> {
    let read = |path: &Path| std::fs::read(path).with_context(|| format!("cannot read {}", path.display()));
    let mut kept = BTreeMap::new();
    for file in files::below(page)? {
        let address = files::address(page, &file);
        if is_kept(&address) {
            kept.insert(address_of(&address), read(&file)?);
        }
    }
    let version = format!("{}-{}", project.locked_version("eigenwing")?, version(&kept));
    let index = kept.get_mut("./").context("the page has no index.html")?;
    *index = named(std::str::from_utf8(index)?, &version)?.into_bytes();
    std::fs::write(page.join("index.html"), index).context("cannot write index.html")?;
    let template = read(&project.root.join("web").join(WORKER))?;
    let worker = told(&version, &kept)? + std::str::from_utf8(&template)?;
    std::fs::write(page.join(WORKER), worker).with_context(|| format!("cannot write {WORKER}"))
}

fn is_kept(address: &str) -> bool {
    ![WORKER, WORKER_OFF].contains(&address) && !NOT_KEPT.iter().any(|ending| address.ends_with(ending))
}

/// The address of a file as it is asked for: a page in its folder by the folder, since hosts redirect `index.html` there.
fn address_of(path: &str) -> String {
    match path.strip_suffix("index.html") {
        Some("") => "./".to_owned(),
        Some(folder) if folder.ends_with('/') => folder.to_owned(),
        _ => path.to_owned(),
    }
}

/// A name that changes with any file.
fn version(kept: &BTreeMap<String, Vec<u8>>) -> String {
    let mut all = Sha256::new();
    for (path, content) in kept {
        all.update(path);
        all.update(Sha256::digest(content));
    }
    all.finalize().iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}

fn named(index: &str, version: &str) -> Result<String> {
    ensure!(index.matches(PLACEHOLDER).count() == 1, "index.html must hold {PLACEHOLDER} once");
    Ok(index.replace(PLACEHOLDER, version))
}

/// The first line of the worker.
fn told(version: &str, kept: &BTreeMap<String, Vec<u8>>) -> Result<String> {
    let hashes: BTreeMap<&str, String> = kept
        .iter()
        .map(|(path, content)| {
            (path.as_str(), format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(content))))
        })
        .collect();
    let [version, hashes] = [serde_json::to_string(version)?, serde_json::to_string(&hashes)?];
    Ok(format!("const VERSION = {version}, FILES = {hashes};\n"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{WORKER, address_of, is_kept, named, told, version, write};
    use crate::compress;
    use crate::project::Project;

    fn kept(text: &str) -> BTreeMap<String, Vec<u8>> {
        [("./".to_owned(), text.into()), ("lessons/a.md".to_owned(), "abc".into())].into()
    }

    #[test]
    fn any_change_of_a_file_is_another_version() {
        assert_eq!(version(&kept("x")), version(&kept("x")));
        assert_ne!(version(&kept("x")), version(&kept("y")));
        assert_eq!(version(&kept("x")).len(), 16);
    }

    #[test]
    fn the_page_holds_the_name_of_its_version_and_the_worker_the_hash_of_each_file() {
        let page = "<meta content=EIGENWING-VERSION name=eigenwing-version><p>";
        assert_eq!(named(page, "12").expect("a page"), "<meta content=12 name=eigenwing-version><p>");
        assert!(named("<p>", "12").is_err());
        // The hash of "abc" is the example of the standard.
        let line = told("12", &kept("x")).expect("a line");
        assert!(line.starts_with("const VERSION = \"12\", FILES = {\"./\":\"sha256-"), "{line}");
        assert!(
            line.contains("\"lessons/a.md\":\"sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=\""),
            "{line}"
        );
    }

    #[test]
    fn a_built_page_has_its_worker_and_its_compressed_files() {
        let page = std::env::temp_dir().join(format!("eigenwing-page-{}", std::process::id()));
        std::fs::create_dir_all(page.join("lessons")).expect("a folder");
        let put = |name: &str, text: &str| std::fs::write(page.join(name), text).expect("a file");
        put("index.html", "<meta content=EIGENWING-VERSION name=eigenwing-version>");
        put("lessons/a.md", &"A lesson. ".repeat(200));
        put("icon.png", "a picture");
        write(&Project::find(), &page).expect("a page");
        compress::write(&page).expect("a page");
        let read = |name: &str| std::fs::read_to_string(page.join(name)).expect("a text");
        let worker = read(WORKER);
        let (line, rest) = worker.split_once('\n').expect("lines");
        let version = line.split('"').nth(1).expect("a version");
        assert!(version.starts_with(concat!(env!("CARGO_PKG_VERSION"), "-")), "{version}");
        assert!(read("index.html").contains(version));
        assert!(line.contains("\"./\":") && line.contains("\"lessons/a.md\":") && !line.contains("png"));
        assert!(rest.contains("addEventListener(\"fetch\""));
        for ending in ["br", "gz"] {
            let packed =
                std::fs::metadata(page.join(format!("lessons/a.md.{ending}"))).expect("a file").len();
            assert!(packed < 200, "{packed} bytes of {ending}");
        }
        assert!(!page.join("icon.png.br").exists());
        std::fs::remove_dir_all(&page).expect("it is ours");
    }

    #[test]
    fn a_page_is_asked_for_by_its_folder() {
        for (path, address) in [
            ("index.html", "./"),
            ("example/index.html", "example/"),
            ("notes.html", "notes.html"),
            ("other-index.html", "other-index.html"),
        ] {
            assert_eq!(address_of(path), address);
        }
    }

    #[test]
    fn neither_the_worker_nor_pictures_for_installing_are_kept() {
        for path in ["sw.js", "sw-off.js", "screenshot.png", "icons/icon-192.png", "core/eigenwing-core.d.ts"]
        {
            assert!(!is_kept(path), "{path}");
        }
        for path in ["index.html", "core/eigenwing-core_bg.wasm", "lessons/glossary.toml", "notes.js"] {
            assert!(is_kept(path), "{path}");
        }
    }
}
