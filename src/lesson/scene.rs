//! A scene of a lesson: a link, and where it stands.

use std::sync::Arc;

use crate::content::Aircraft;
use crate::scenario::link::{self, Opened};

/// A scene as a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// The link.
    pub link: String,
    /// Line of the file, counted from 1.
    pub line: usize,
}

impl Scene {
    /// What the link leads to; `None` only without a single aircraft.
    pub fn open(&self, aircraft: &[Arc<Aircraft>]) -> Option<Opened> {
        link::read(&self.link, aircraft)
    }
}
