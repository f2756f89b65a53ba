//! What was left out of a link, in sentences for the person who opened it.

use super::super::{Page, Parameter, ValueError};
use crate::content::Aircraft;

/// Something of a link that could not be used.
#[derive(Clone, Debug, PartialEq)]
pub enum Notice {
    /// The link says that it was made by a later version.
    Newer,
    /// The version can't be read.
    Version {
        /// The text of the version.
        text: String,
    },
    /// The link is longer than any scene.
    TooLong,
    /// A part without `=`, or with a key that this version doesn't have.
    Unknown {
        /// The key.
        key: String,
    },
    /// A key more than once.
    Twice {
        /// The key.
        key: String,
    },
    /// A word that the key doesn't have.
    Word {
        /// The key.
        key: String,
        /// The word.
        word: String,
    },
    /// A word that the lists of a key don't have.
    WordOfList {
        /// The key.
        key: String,
        /// The list.
        list: String,
        /// The word.
        word: String,
        /// A word like it that they have.
        nearest: Option<String>,
    },
    /// A number that can't be used.
    Value {
        /// The key.
        key: String,
        /// Name of the parameter.
        name: &'static str,
        /// Why.
        error: ValueError,
    },
    /// A parameter that the aircraft's data don't have.
    NotOf {
        /// Name of the parameter.
        name: &'static str,
        /// Name of the aircraft.
        aircraft: String,
    },
    /// A value of something that follows from a flight that can't be.
    NoFlight {
        /// Name of the parameter.
        name: &'static str,
    },
    /// No such aircraft.
    Aircraft {
        /// Its key.
        key: String,
        /// Name of the one that stands in.
        instead: String,
        /// Whether the link had changes to it.
        edited: bool,
    },
    /// An aircraft in the link itself that can't be read.
    Own {
        /// What is wrong with it.
        problem: String,
        /// Name of the one that stands in.
        instead: String,
    },
    /// No such aircraft to compare with.
    Pinned {
        /// Its key.
        key: String,
    },
    /// Lateral motion of an aircraft without data for it.
    Plane {
        /// Name of the aircraft.
        aircraft: String,
    },
    /// A page of sliders that the aircraft doesn't have.
    Page {
        /// The page.
        page: Page,
        /// Name of the aircraft.
        aircraft: String,
    },
}

impl Notice {
    /// The same without the name of an aircraft, which is hidden: `instead` stands for it.
    pub fn unnamed(mut self, instead: &str) -> Self {
        let (Self::NotOf { aircraft: name, .. }
        | Self::Aircraft { instead: name, .. }
        | Self::Own { instead: name, .. }
        | Self::Plane { aircraft: name }
        | Self::Page { aircraft: name, .. }) = &mut self
        else {
            return self;
        };
        instead.clone_into(name);
        self
    }

    pub(super) fn not_of(parameter: &Parameter, aircraft: &Aircraft) -> Self {
        Self::NotOf { name: parameter.name, aircraft: aircraft.name.clone() }
    }
}

/// Longest piece of a link that is quoted \[characters\].
const QUOTED: usize = 24;

/// A piece of a link, fit to be shown: short, and without characters that no font has.
pub(super) fn quoted(text: &str) -> String {
    let shown = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '·' };
    let mut short: String = text.chars().take(QUOTED).map(shown).collect();
    if text.chars().nth(QUOTED).is_some() {
        short.push('…');
    }
    short
}
