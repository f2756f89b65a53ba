//! What was left out of a link, in sentences for the person who opened it.

use std::fmt;

use super::super::{Parameter, ValueError};
use super::LONGEST;
use crate::content::Aircraft;

/// Something of a link that could not be used.
#[derive(Clone, Debug, PartialEq)]
pub enum Notice {
    /// The link says that it was made by a later version.
    Newer,
    /// The version can't be read.
    Version {
        /// What stands there.
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
    /// No such aircraft to compare with.
    Ghost {
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
        /// The words of the page.
        page: &'static str,
        /// Name of the aircraft.
        aircraft: String,
    },
}

impl Notice {
    pub(super) fn not_of(parameter: &Parameter, aircraft: &Aircraft) -> Self {
        Self::NotOf { name: parameter.name, aircraft: aircraft.name.clone() }
    }
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Newer => f.write_str(
                "This link was made by a newer version of Eigenwing: what this one doesn't know is left out.",
            ),
            Self::Version { text } => {
                write!(f, "The link's version “{text}” can't be read; it was opened as version 1.")
            }
            Self::TooLong => {
                write!(f, "The link is too long: all after its first {LONGEST} characters was left out.")
            }
            Self::Unknown { key } => write!(f, "“{key}” means nothing to this version and was left out."),
            Self::Twice { key } => {
                write!(f, "“{key}” stands in the link more than once: the last one counts.")
            }
            Self::Word { key, word } => {
                write!(f, "“{key}={word}” was left out: “{word}” isn't one of its words.")
            }
            Self::Value { key, name, error } => write!(f, "The {name} ({key}) was left out: {error}."),
            Self::NotOf { name, aircraft } => {
                write!(f, "The {name} was left out: the data of {aircraft} don't have it.")
            }
            Self::NoFlight { name } => {
                write!(f, "The {name} was left out: it follows from a steady flight, and this one can't be.")
            }
            Self::Aircraft { key, instead, edited } => {
                let changes = if *edited { ", without the changes made to it" } else { "" };
                write!(f, "There is no aircraft “{key}” here: this is {instead} instead{changes}.")
            }
            Self::Ghost { key } => {
                write!(f, "The pinned state was left out: there is no aircraft “{key}” here.")
            }
            Self::Plane { aircraft } => {
                write!(f, "Lateral motion was left out: {aircraft} has no data for it.")
            }
            Self::Page { page, aircraft } => {
                write!(f, "The page “{page}” was left out: {aircraft} doesn't have it.")
            }
        }
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
