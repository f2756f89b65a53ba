//! What was left out of a link, for the person who opened it.

use std::fmt::{Display, Formatter, Result};

use super::sliders;
use crate::scenario::link::{LONGEST, Notice};

impl Display for Notice {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
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
            Self::WordOfList { key, list, word, nearest: None } => {
                write!(f, "“{key}={list}” was left out: “{word}” isn't one of its words.")
            }
            Self::WordOfList { key, list, word, nearest: Some(nearest) } => write!(
                f,
                "“{key}={list}” was left out: “{word}” isn't one of its words (did you mean “{nearest}”?)."
            ),
            Self::Value { key, name, error } => write!(f, "The {name} ({key}) was left out: {error}."),
            Self::NotOf { name, aircraft } => {
                write!(f, "The {name} was left out: the data of {aircraft} don't have it.")
            }
            Self::NoFlight { name } => {
                write!(f, "The {name} was left out: it follows from a steady flight, and this one can't be.")
            }
            Self::Aircraft { key, instead, edited: false } => {
                write!(f, "There is no aircraft “{key}” here: this is {instead} instead.")
            }
            Self::Aircraft { key, instead, edited: true } => write!(
                f,
                "There is no aircraft “{key}” here: this is {instead} instead, without the changes made to it."
            ),
            Self::Own { problem, instead } => write!(
                f,
                "The aircraft in the link can't be read, {problem}: this is {instead} instead, without the changes made to it."
            ),
            Self::Pinned { key } => {
                write!(f, "The pinned state was left out: there is no aircraft “{key}” here.")
            }
            Self::Plane { aircraft } => {
                write!(f, "Lateral motion was left out: {aircraft} has no data for it.")
            }
            Self::Page { page, aircraft } => {
                let page = sliders::page(*page);
                write!(f, "The page “{page}” was left out: {aircraft} doesn't have it.")
            }
        }
    }
}
