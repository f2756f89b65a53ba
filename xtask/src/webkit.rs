//! WebKitGTK for one browser test: its driver, and the small browser that comes with its library.

use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::debian;
use crate::process;

const DRIVER: [&str; 1] = ["WebKitWebDriver"];

/// The browser that the driver starts; `None` where there is none, which is said.
pub fn find_or_install() -> Result<Option<PathBuf>> {
    let find = || process::find_on_path(&DRIVER).and_then(|_| browser_below(Path::new("/usr/lib")));
    if find().is_none() && debian::may_install() {
        println!("Installing Debian's webkit2gtk-driver (once, about a minute)");
        debian::install(&["webkit2gtk-driver", "xvfb"])?;
    }
    let browser = find();
    if browser.is_none() {
        println!("Without WebKitGTK its test is left out; on Debian: `sudo apt install webkit2gtk-driver`");
    }
    Ok(browser)
}

/// `<architecture>/webkit2gtk-<version>/MiniBrowser`.
fn browser_below(folder: &Path) -> Option<PathBuf> {
    let folders_in = |folder: &Path| {
        std::fs::read_dir(folder)
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| entry.path())
            .collect::<Vec<_>>()
    };
    let libraries = folders_in(folder).into_iter().flat_map(|architecture| folders_in(&architecture));
    let mut browsers: Vec<PathBuf> = libraries
        .filter(|library| {
            library.file_name().is_some_and(|name| name.to_string_lossy().starts_with("webkit2gtk-"))
        })
        .map(|library| library.join("MiniBrowser"))
        .filter(|browser| browser.is_file())
        .collect();
    browsers.sort();
    browsers.pop()
}
