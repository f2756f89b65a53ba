//! The files of the course. In a browser they are fetched when a person asks for them, so that the first load is without them;
//! elsewhere they are part of the build.

use super::TextFile;

/// Names of the files, and outside a browser their texts.
macro_rules! files {
    ($($name:literal),* $(,)?) => {
        /// Names of the files: lessons in the order in which they are offered, lectures, the glossary, the references.
        pub const NAMES: &[&str] = &[$($name),*];

        /// The files as they were built in; `None` in a browser.
        #[cfg(not(target_arch = "wasm32"))]
        pub fn built_in() -> Option<Vec<TextFile>> {
            Some(vec![$(TextFile::new($name, include_str!(concat!("../../assets/lessons/", $name)))),*])
        }
    };
}

files! {
    "frames.md",
    "forces.md",
    "equations.md",
    "longitudinal.md",
    "lateral.md",
    "workshop.md",
    "loop.md",
    "hangar.md",
    "lecture-modes.md",
    "lecture-matrix.md",
    "glossary.toml",
    "references.toml",
}

/// The files as they were built in; `None` in a browser.
#[cfg(target_arch = "wasm32")]
pub fn built_in() -> Option<Vec<TextFile>> {
    None
}
