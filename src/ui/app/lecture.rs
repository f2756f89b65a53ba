//! A lecture on the page: made of links, and told to the window of its notes.

use egui::Ui;

use super::App;
use super::course::FileRequest;
use crate::content::TextFile;
use crate::scenario::Hidden;
use crate::scenario::link::LessonPlace;
use crate::ui::present::{Cue, Deck, DeckWish};
use crate::words;

impl App {
    /// The sheet of a lecture from links, where it is open.
    pub(super) fn deck_ui(&mut self, ui: &Ui) {
        let Some(deck) = &mut self.panes.deck else { return };
        let (wish, is_wanted) = deck.show(ui, &self.aircraft, self.panes.has_files);
        let (list, named) = (deck.list.clone(), deck.file.clone());
        if let Some(wish) = wish {
            let name = named.unwrap_or_else(|| self.free_name(&list.title));
            if let Some(deck) = &mut self.panes.deck {
                deck.file = Some(name.clone());
            }
            let file = TextFile::new(&name, &list.to_lesson());
            if wish == DeckWish::Save {
                self.panes.file_requests.push(FileRequest::Save(file.clone()));
            }
            // Kept on this device, as every lesson of one's own.
            let place = LessonPlace { address: name, step: 0, begins: true };
            self.open_own(&[file], place, true);
            self.view.presents |= wish == DeckWish::Present;
        }
        if !is_wanted || wish == Some(DeckWish::Present) {
            self.panes.deck = None;
        }
        if wish.is_some() || !is_wanted {
            ui.request_repaint();
        }
    }

    /// Opens the sheet with the links of a text.
    pub(super) fn open_links(&mut self, text: &str) {
        self.panes.deck.get_or_insert_with(Deck::default).take(text, &self.aircraft);
    }

    /// A name after a title for the file of a lesson, which none on this device has: nothing is written over.
    fn free_name(&self, title: &str) -> String {
        // Room for the number and the ending.
        let name: String = title.trim().to_lowercase().chars().take(100).collect();
        let name = if name.is_empty() { "lecture" } else { &name };
        let numbered = |number: usize| match number {
            1 => LessonPlace::address_of(&format!("{name}.md")),
            _ => LessonPlace::address_of(&format!("{name}-{number}.md")),
        };
        let is_free = |name: &String| !self.records.lessons.contains_key(name);
        (1..).map(numbered).find(is_free).unwrap_or_else(|| numbered(1))
    }

    /// What the notes of the lecture show; nothing while there is none.
    pub fn cue(&self) -> Option<Cue> {
        let lecture = self.presentation()?;
        let of_lesson = self
            .session()
            .and_then(|session| Cue::of(lecture, session.steps(), session.start(), &self.aircraft));
        Some(of_lesson.unwrap_or_else(|| {
            let is_told = !self.view.stage.hides(Hidden::AircraftName);
            let name = if is_told { &self.scenario.aircraft.name } else { words::view::AN_AIRCRAFT };
            Cue::alone(name, lecture)
        }))
    }

    /// Ends the lecture, as when the screen is no longer full.
    pub fn end_lecture(&mut self) {
        self.view.presents = false;
    }

    /// Says a sentence on the page, and to a screen reader.
    pub fn tell(&mut self, sentence: &str) {
        self.share.tell(sentence);
    }
}
