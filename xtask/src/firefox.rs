//! Firefox for the browser tests, and the screen that nobody looks at: $FIREFOX, one on the PATH, or Debian's.

use std::path::PathBuf;

use anyhow::{Result, bail, ensure};

use crate::debian;
use crate::process;

const NAMES: [&str; 2] = ["firefox-esr", "firefox"];
const SCREEN: [&str; 1] = ["Xvfb"];

/// A Firefox with a screen to draw on, both installed first where that can be done without asking.
pub fn find_or_install() -> Result<PathBuf> {
    let named = std::env::var_os("FIREFOX").map(PathBuf::from);
    if let Some(firefox) = &named {
        ensure!(firefox.is_file(), "FIREFOX is {}, and there is no such file", firefox.display());
    }
    let find = || named.clone().or_else(|| process::find_on_path(&NAMES));
    if (find().is_none() || process::find_on_path(&SCREEN).is_none()) && debian::may_install() {
        println!("Installing Debian's firefox-esr and xvfb (once, about a minute)");
        debian::install(&["firefox-esr", "xvfb", "libgl1-mesa-dri", "libegl1", "fonts-dejavu-core"])?;
    }
    match find() {
        Some(firefox) if process::find_on_path(&SCREEN).is_some() => Ok(firefox),
        _ => bail!(
            "the browser tests need Firefox and Xvfb: `sudo apt install firefox-esr xvfb`, or name a Firefox in the \
             environment variable FIREFOX"
        ),
    }
}
