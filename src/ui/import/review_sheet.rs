//! The review of a file, as the core tells it: see `content::import::review`.

use serde::Deserialize;

use crate::number::significant;

/// What a file holds, and what stands in the way of using it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct ReviewSheet {
    /// Name of the file.
    pub file: String,
    /// The form in words.
    pub format_name: String,
    /// Title, as the file has it.
    pub title: String,
    /// Each number that was read.
    pub read: Vec<Read>,
    /// Eigenvalues of the matrices that were read.
    pub eigenvalues: Vec<Eigenvalues>,
    /// What was made of them, in sentences.
    pub remarks: Vec<String>,
    /// What can be filled in.
    pub fields: Vec<Field>,
    /// What looks wrong.
    pub doubts: Vec<Doubt>,
    /// The aircraft as the text of an aircraft file; `None` while something is missing or stops it.
    pub aircraft: Option<String>,
}

/// A number as it stands in the file, and what it was taken for.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Read {
    /// Line of the file, counted from 1; 0 where it follows from others.
    pub line: usize,
    /// As it stands there.
    pub text: String,
    /// The quantity in words.
    pub meaning: String,
    /// Its value in `unit`.
    pub value: Option<f64>,
    /// Unit.
    pub unit: String,
}

/// Eigenvalues of a plane of motion.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Eigenvalues {
    /// Key of the plane.
    pub plane: String,
    /// Real and imaginary part of each \[1/s\].
    pub values: Vec<[f64; 2]>,
}

/// Something that a person can fill in.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Field {
    /// Its key.
    pub key: String,
    /// What it is.
    pub meaning: String,
    /// Unit of its number; empty for a choice or a text.
    pub unit: String,
    /// The values that it can have, where they are few.
    pub choices: Vec<Choice>,
    /// A value that is likely.
    pub suggested: Option<String>,
    /// Why that one.
    pub reason: Option<String>,
    /// The value that is used at present.
    pub value: Option<String>,
    /// Whether the aircraft waits for it.
    pub required: bool,
}

/// A value of a field.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
pub struct Choice {
    /// The value.
    pub key: String,
    /// The value in words.
    pub words: String,
}

/// Something that looks wrong.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Doubt {
    /// Whether the aircraft can't be used for it.
    pub stops: bool,
    /// A sentence with the numbers that show it.
    pub sentence: String,
    /// Values that mend it.
    pub remedy: Vec<Remedy>,
}

/// A field and the value that mends something.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
pub struct Remedy {
    /// Key of the field.
    pub key: String,
    /// The value.
    pub value: String,
}

impl Field {
    /// A value of the field in words, with its unit.
    pub fn words(&self, value: &str) -> String {
        let choice = self.choices.iter().find(|choice| choice.key == value);
        let number = value.parse().ok().filter(|_| !self.unit.is_empty()).map(|x: f64| significant(x, 5));
        let shown = number.as_deref().unwrap_or(value);
        choice.map_or_else(|| format!("{shown} {}", self.unit).trim_end().to_owned(), |it| it.words.clone())
    }

    /// What is likely, where something else or nothing is used at present.
    pub fn offered(&self) -> Option<&String> {
        let words = |text: &str| text.replace(',', " ").split_whitespace().collect::<Vec<_>>().join(" ");
        let now = self.value.as_deref().map(words);
        self.suggested.as_ref().filter(|suggested| now != Some(words(suggested)))
    }

    /// Whether the aircraft waits for it.
    pub fn is_missing(&self) -> bool {
        self.required && self.value.is_none()
    }
}

impl ReviewSheet {
    /// What a remedy does, in words.
    pub fn told(&self, remedy: &Remedy) -> String {
        match self.fields.iter().find(|field| field.key == remedy.key) {
            Some(field) => format!("{}: {}", field.meaning, field.words(&remedy.value)),
            None => format!("{}: {}", remedy.key, remedy.value),
        }
    }
}
