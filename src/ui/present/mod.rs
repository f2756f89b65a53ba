//! Presenting: one scene fills the screen, for a room to look at.
//!
//! | file | in one line |
//! |---|---|
//! | `keys` | what the keys of a presenter and of a clicker ask for |
//! | `screen` | how large type is on a screen, and where words and panes stand |
//! | `words` | what is written on a slide |
//! | `setting` | words set in a size and a width, before they have a place |
//! | `modes`, `sliders` | the modes, and the sliders that are offered, large |
//! | `deck` | the sheet on which a lecture is made of links |
//! | `kept` | what was done on the slides, as text that outlives a reload |
//! | `notes` | what the window of the notes shows |
//! | `light` | a black screen, a spotlight, a magnifier |

mod deck;
mod kept;
mod keys;
mod light;
mod modes;
mod notes;
mod screen;
mod setting;
mod sliders;
mod words;

use std::collections::{BTreeMap, BTreeSet};

pub use deck::{Deck, DeckWish};
pub use keys::{SHEET, Stroke, strokes};
pub use light::{blank_ui, magnify, spotlight_ui};
pub use modes::modes_ui;
pub use notes::Cue;
pub use screen::{Arranged, Content, Plots, arranged, panes, places, zoom};
pub use setting::{Measured, Pressed};
pub use sliders::{offered, sliders_height, sliders_ui};
pub use words::{Asked, Told, pieces};

use crate::scenario::{Hidden, Stage};

/// A lecture as it stands. Nothing of it goes into the records of the person.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Presentation {
    /// Where the lesson was opened from; empty where a scene is shown alone.
    pub address: String,
    /// The slide on screen, counted from 0: the step of the lesson.
    pub slide: usize,
    /// How many slides there are.
    pub count: usize,
    /// When it began, by the clock of the page \[s\].
    pub started: f64,
    /// Whether the screen is black.
    pub is_blank: bool,
    /// Whether the time since the start is on screen.
    pub shows_clock: bool,
    /// The place that is magnified.
    pub magnified: Option<egui::Pos2>,
    /// What was done on each slide that has been on screen.
    pub slides: BTreeMap<usize, Slide>,
}

/// What was done on one slide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slide {
    /// How many of its questions have been answered for the room.
    pub revealed: usize,
    /// Hands that were counted, by question, and for each choice of it.
    pub hands: BTreeMap<usize, Vec<u32>>,
    /// Whether names and numbers are hidden or shown against what the scene says.
    pub veil: Option<bool>,
    /// Wrong choices whose reasons are on screen.
    pub reasons: BTreeSet<usize>,
}

/// Most choices that hands are counted for.
pub const MOST_CHOICES: usize = 9;

impl Presentation {
    /// What was done on the slide on screen.
    pub fn current(&self) -> Option<&Slide> {
        self.slides.get(&self.slide)
    }

    /// The same, to be changed.
    pub fn current_mut(&mut self) -> &mut Slide {
        self.slides.entry(self.slide).or_default()
    }

    /// How many questions of the slide on screen have been answered.
    pub fn revealed(&self) -> usize {
        self.current().map_or(0, |slide| slide.revealed)
    }

    /// Hands that were counted for each choice of a question of the slide on screen.
    pub fn hands(&self, question: usize) -> &[u32] {
        self.current().and_then(|slide| slide.hands.get(&question)).map_or(&[], Vec::as_slice)
    }

    /// Counts a hand for a choice, or takes one away.
    pub fn count_hand(&mut self, question: usize, choice: usize, adds: bool) {
        if choice >= MOST_CHOICES {
            return;
        }
        let hands = self.current_mut().hands.entry(question).or_default();
        if hands.len() <= choice {
            hands.resize(choice + 1, 0);
        }
        hands[choice] = if adds { hands[choice].saturating_add(1) } else { hands[choice].saturating_sub(1) };
    }

    /// A stage as the room sees it: all of it once it `is_revealed`, and with names and numbers as the presenter wants them.
    pub fn stage(&self, stage: &Stage, is_revealed: bool) -> Stage {
        let veil = self.current().and_then(|slide| slide.veil);
        let of_scene = stage.hidden().iter().filter(|_| !is_revealed).copied();
        let hidden = match veil {
            None => of_scene.collect(),
            Some(true) => of_scene.chain(VEILED).collect(),
            Some(false) => of_scene.filter(|hidden| !VEILED.contains(hidden)).collect(),
        };
        stage.clone().hiding(hidden)
    }

    /// Hides names and numbers, or shows them where one of them is hidden.
    pub fn turn_veil(&mut self, stage: &Stage, is_revealed: bool) {
        let now = self.stage(stage, is_revealed);
        let is_veiled = VEILED.into_iter().any(|hidden| now.hides(hidden));
        self.current_mut().veil = Some(!is_veiled);
    }
}

/// What a presenter hides and shows by key.
const VEILED: [Hidden; 2] = [Hidden::Names, Hidden::Numbers];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_are_shown_and_hidden_whatever_the_scene_says_and_nothing_else_is() {
        let stage = Stage::default().hiding(vec![Hidden::Names, Hidden::Curves]);
        let mut lecture = Presentation::default();
        let hidden =
            |lecture: &Presentation, revealed: bool| lecture.stage(&stage, revealed).hidden().to_vec();
        assert_eq!(hidden(&lecture, false), [Hidden::Names, Hidden::Curves]);
        assert_eq!(hidden(&lecture, true), []);
        lecture.turn_veil(&stage, false);
        assert_eq!(hidden(&lecture, false), [Hidden::Curves]);
        lecture.turn_veil(&stage, false);
        assert_eq!(hidden(&lecture, false), [Hidden::Names, Hidden::Numbers, Hidden::Curves]);
        assert_eq!(hidden(&lecture, true), VEILED);
    }

    #[test]
    fn hands_are_counted_taken_away_and_never_less_than_none() {
        let mut lecture = Presentation::default();
        for adds in [true, true, true, false] {
            lecture.count_hand(0, 2, adds);
        }
        lecture.count_hand(0, 0, false);
        lecture.count_hand(0, MOST_CHOICES, true);
        assert_eq!((lecture.hands(0), lecture.hands(1)), (&[0, 0, 2][..], &[][..]));
    }
}
