//! A lesson in a link, and the step of it: `lesson=longitudinal&step=3`.

use super::notice::{Notice, quoted};
use super::pieces::Pieces;
use super::words;

/// Longest address of a lesson \[characters\].
const LONGEST_ADDRESS: usize = 200;

/// Steps of a lesson are fewer than this.
const MOST_STEPS: usize = 1000;

/// A lesson, and the step of it that is open.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LessonPlace {
    /// Key of a lesson that ships (`longitudinal`), or the path of a file beside the page (`class/week-3.md`).
    pub address: String,
    /// The step, counted from 0.
    pub step: usize,
    /// Whether the link has no scene of its own, so that the step's is opened.
    pub begins: bool,
}

/// Keys that make no scene.
const NOT_OF_SCENES: [&str; 5] = ["v", "lesson", LessonPlace::STEP, words::PRESENT, words::LOOK];

impl LessonPlace {
    /// The key of its step.
    pub const STEP: &str = "step";

    /// The pieces of a link, with an `&` before each.
    pub fn in_link(&self) -> String {
        format!("&lesson={}&step={}", self.address, self.step + 1)
    }

    /// The address of a file that a person has brought, by its name: whatever can't stand in a link is a hyphen.
    pub fn address_of(name: &str) -> String {
        let plain = |c: char| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '-' };
        let name: String = name.chars().map(plain).take(LONGEST_ADDRESS - 2).collect();
        if name.starts_with('.') || name.is_empty() { format!("-{name}") } else { name }
    }

    /// Whether text can be the address of a lesson: a key, or a path below the page's own folder. Never another site.
    pub fn is_address(text: &str) -> bool {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-/".contains(c);
        !text.is_empty()
            && text.len() <= LONGEST_ADDRESS
            && text.chars().all(is_plain)
            && text.split('/').all(|name| !name.is_empty() && !name.starts_with('.'))
    }

    /// Takes its pieces out of a link, before any other.
    pub(super) fn read(pieces: &mut Pieces) -> Option<Self> {
        let begins = !pieces.has_other_than(&NOT_OF_SCENES);
        let address = pieces.take_as("lesson", |text| Self::is_address(text).then(|| text.to_owned()));
        let step = pieces.take_as(Self::STEP, |text| {
            text.parse::<usize>().ok().filter(|step| (1..=MOST_STEPS).contains(step))
        });
        match (address, step) {
            (Some(address), step) => Some(Self { address, step: step.unwrap_or(1) - 1, begins }),
            (None, Some(step)) => {
                let word = quoted(&step.to_string());
                pieces.notices.push(Notice::Word { key: quoted(Self::STEP), word });
                None
            }
            (None, None) => None,
        }
    }
}
