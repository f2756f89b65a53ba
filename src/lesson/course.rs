//! Lessons in their order, with the glossary and the references that they share.

use std::rc::Rc;

use super::{Lesson, Shelf};
use crate::content::{ContentError, TextFile};

/// Lessons in the order in which they are offered.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// Each as it was read.
    pub lessons: Vec<Rc<Lesson>>,
    /// What they share.
    pub shelf: Rc<Shelf>,
    /// Why a file can't be used, one error a file.
    pub errors: Vec<ContentError>,
}

impl Course {
    /// Reads the files that belong together: any number of lessons (`.md`), `glossary.toml`, `references.toml`. What can't be read
    /// gives its error, and the rest is there.
    pub fn read(files: &[TextFile]) -> Self {
        let mut course = Self::default();
        let text = |name: &str| files.iter().find(|file| file.name == name).map_or("", |file| &file.text);
        match Shelf::read(text("glossary.toml"), text("references.toml")) {
            Ok(shelf) => course.shelf = Rc::new(shelf),
            Err(error) => course.errors.push(error),
        }
        for file in files.iter().filter(|file| file.name.ends_with(".md")) {
            match Lesson::read(&file.name, &file.text) {
                Ok(lesson) => course.lessons.push(Rc::new(lesson)),
                Err(error) => course.errors.push(error),
            }
        }
        course
    }

    /// The same lessons, with words and references of another where these have none of their own.
    pub fn with_shelf(mut self, other: &Shelf) -> Self {
        let mut shelf = other.clone();
        shelf.glossary.extend(self.shelf.glossary.clone());
        shelf.references.extend(self.shelf.references.clone());
        self.shelf = Rc::new(shelf);
        self
    }

    /// The lesson of a key, with its place.
    pub fn find(&self, key: &str) -> Option<(usize, &Rc<Lesson>)> {
        self.lessons.iter().enumerate().find(|(_, lesson)| lesson.key() == key)
    }
}
