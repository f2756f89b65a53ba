//! The browser for the tests: $CHROMIUM, one on the PATH, or Debian's.

use std::path::PathBuf;

use anyhow::{Result, bail, ensure};

use crate::debian;
use crate::process;

const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/// A Chromium, which is installed first where that can be done without asking.
pub fn find_or_install() -> Result<PathBuf> {
    if let Some(chromium) = std::env::var_os("CHROMIUM").map(PathBuf::from) {
        ensure!(chromium.is_file(), "CHROMIUM is {}, and there is no such file", chromium.display());
        return Ok(chromium);
    }
    if let Some(chromium) = process::find_on_path(&NAMES) {
        return Ok(chromium);
    }
    if debian::may_install() {
        println!("Installing Debian's chromium (once, about a minute)");
        debian::install(&["chromium", "fonts-dejavu-core"])?;
        if let Some(chromium) = process::find_on_path(&NAMES) {
            return Ok(chromium);
        }
    }
    bail!(
        "the browser tests need Chromium: `sudo apt install chromium`, or name one in the environment variable CHROMIUM"
    )
}
