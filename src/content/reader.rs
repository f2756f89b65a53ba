//! TOML read so that every complaint names the file, the line, the field and what was expected.
//!
//! Total: any text gives a value or a [`ContentError`].

use nalgebra::DMatrix;
use thiserror::Error;
use toml::de::{DeTable, DeValue};

use crate::key::Keyed;

/// A file that could not be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}, line {line}: {problem}")]
pub struct ContentError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// The fault, and what was expected instead.
    pub problem: String,
}

/// A table of a file, and which of its keys were asked for.
#[derive(Debug)]
pub(crate) struct Block<'t> {
    file: &'t str,
    text: &'t str,
    /// Dotted name with a dot at its end; empty for the file itself.
    path: String,
    /// Line on which it starts, for errors about a missing key.
    start: usize,
    table: &'t DeTable<'t>,
    asked: Vec<&'t str>,
}

/// Reads `text` and hands its tables to `read`.
pub(crate) fn with_file<T>(
    file: &str,
    text: &str,
    read: impl FnOnce(&mut Block<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    let parsed = DeTable::parse(text).map_err(|error| ContentError {
        file: file.to_owned(),
        line: line_of(text, error.span().map_or(0, |span| span.start)),
        problem: error.message().to_owned(),
    })?;
    let table = parsed.get_ref();
    read(&mut Block { file, text, path: String::new(), start: 0, table, asked: Vec::new() })
}

/// The line of a byte, counted from 1.
pub(crate) fn line_of(text: &str, offset: usize) -> usize {
    text.bytes().take(offset).filter(|&byte| byte == b'\n').count() + 1
}

const fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

fn as_number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix()).ok().map(|i| i as f64),
        DeValue::Float(x) => x.as_str().parse().ok(),
        _ => None,
    }
}

impl<'t> Block<'t> {
    /// An error at a key, or at the head of the block where the key is missing.
    pub fn error(&self, key: &str, problem: impl std::fmt::Display) -> ContentError {
        let offset = self.entry(key).map_or(self.start, |(start, _)| start);
        ContentError {
            file: self.file.to_owned(),
            line: line_of(self.text, offset),
            problem: format!("{}{key}: {problem}", self.path),
        }
    }

    /// An error about the block as a whole.
    pub fn error_here(&self, problem: impl std::fmt::Display) -> ContentError {
        let name = self.path.trim_end_matches('.');
        let problem = if name.is_empty() { problem.to_string() } else { format!("[{name}]: {problem}") };
        ContentError { file: self.file.to_owned(), line: line_of(self.text, self.start), problem }
    }

    fn entry(&self, key: &str) -> Option<(usize, &'t DeValue<'t>)> {
        self.table
            .iter()
            .find(|(name, _)| name.get_ref() == key)
            .map(|(name, value)| (name.span().start, value.get_ref()))
    }

    fn ask(&mut self, key: &'t str) -> Option<&'t DeValue<'t>> {
        self.asked.push(key);
        self.entry(key).map(|(_, value)| value)
    }

    /// Whether the key is there.
    pub fn has(&self, key: &str) -> bool {
        self.entry(key).is_some()
    }

    fn missing(&self, key: &str, expected: &str) -> ContentError {
        self.error(key, format_args!("missing; expected {expected}"))
    }

    fn wrong(&self, key: &str, expected: &str, found: &DeValue<'_>) -> ContentError {
        self.error(key, format_args!("expected {expected}, found {}", kind(found)))
    }

    fn finite(&self, key: &str, value: &DeValue<'_>) -> Result<f64, ContentError> {
        let number = as_number(value).ok_or_else(|| self.wrong(key, "a number", value))?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.error(key, format_args!("expected a finite number, found {number}")))
        }
    }

    /// A finite number, if the key is there.
    pub fn optional_number(&mut self, key: &'t str) -> Result<Option<f64>, ContentError> {
        self.ask(key).map(|value| self.finite(key, value)).transpose()
    }

    /// A finite number.
    pub fn number(&mut self, key: &'t str) -> Result<f64, ContentError> {
        self.optional_number(key)?.ok_or_else(|| self.missing(key, "a number"))
    }

    /// A positive number, if the key is there.
    pub fn optional_positive(&mut self, key: &'t str) -> Result<Option<f64>, ContentError> {
        match self.optional_number(key)? {
            Some(x) if x <= 0.0 => {
                Err(self.error(key, format_args!("expected a positive number, found {x}")))
            }
            other => Ok(other),
        }
    }

    /// A positive number.
    pub fn positive(&mut self, key: &'t str) -> Result<f64, ContentError> {
        self.optional_positive(key)?.ok_or_else(|| self.missing(key, "a positive number"))
    }

    /// A text that is not empty, if the key is there.
    pub fn optional_text(&mut self, key: &'t str) -> Result<Option<String>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(None) };
        match value.as_str().map(str::trim) {
            Some(text) if !text.is_empty() => Ok(Some(text.to_owned())),
            Some(_) => Err(self.error(key, "expected a text, found an empty one")),
            None => Err(self.wrong(key, "a text in quotes", value)),
        }
    }

    /// A text that is not empty.
    pub fn text(&mut self, key: &'t str) -> Result<String, ContentError> {
        self.optional_text(key)?.ok_or_else(|| self.missing(key, "a text in quotes"))
    }

    /// The line of a key, or of the head of the block where the key is missing.
    pub fn line(&self, key: &str) -> usize {
        line_of(self.text, self.entry(key).map_or(self.start, |(start, _)| start))
    }

    /// A list of texts that are not empty; none where the key is missing.
    pub fn texts(&mut self, key: &'t str) -> Result<Vec<String>, ContentError> {
        let expected = "a list of texts in quotes";
        let Some(value) = self.ask(key) else { return Ok(Vec::new()) };
        let list = value.as_array().ok_or_else(|| self.wrong(key, expected, value))?;
        list.iter()
            .map(|entry| match entry.get_ref().as_str().map(str::trim) {
                Some(text) if !text.is_empty() => Ok(text.to_owned()),
                Some(_) => Err(self.error(key, format_args!("expected {expected}, found an empty one"))),
                None => Err(self.wrong(key, expected, entry.get_ref())),
            })
            .collect()
    }

    /// Yes or no, if the key is there.
    pub fn optional_flag(&mut self, key: &'t str) -> Result<Option<bool>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(None) };
        value.as_bool().map(Some).ok_or_else(|| self.wrong(key, "true or false", value))
    }

    /// A number as its text, or a text that is not empty, if the key is there; `expected` says so in words.
    pub fn optional_number_or_text(
        &mut self,
        key: &'t str,
        expected: &str,
    ) -> Result<Option<String>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(None) };
        match value {
            DeValue::String(_) => self.optional_text(key),
            DeValue::Integer(_) | DeValue::Float(_) => Ok(Some(self.finite(key, value)?.to_string())),
            other => Err(self.wrong(key, expected, other)),
        }
    }

    /// The names of the entries, which are all asked for by this.
    pub fn names(&self) -> Vec<&'t str> {
        self.table.keys().map(|key| key.get_ref().as_ref()).collect()
    }

    /// The meaning of one word out of a few, if the key is there.
    pub fn optional_choice<T: Copy>(
        &mut self,
        key: &'t str,
        choices: &[(&str, T)],
    ) -> Result<Option<T>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(None) };
        let found = value.as_str().and_then(|text| choices.iter().find(|(name, _)| *name == text));
        found.map(|(_, choice)| Some(*choice)).ok_or_else(|| match value.as_str() {
            Some(text) => self.error(key, format_args!("expected {}, found \"{text}\"", one_of(choices))),
            None => self.wrong(key, &one_of(choices), value),
        })
    }

    /// The meaning of one word out of a few.
    pub fn choice<T: Copy>(&mut self, key: &'t str, choices: &[(&str, T)]) -> Result<T, ContentError> {
        self.optional_choice(key, choices)?.ok_or_else(|| self.missing(key, &one_of(choices)))
    }

    /// The value of one key out of a list of them, if the entry is there.
    pub fn optional_key<T: Keyed>(&mut self, key: &'t str) -> Result<Option<T>, ContentError> {
        let choices: Vec<(&str, T)> = T::VALUES.iter().map(|&value| (value.key(), value)).collect();
        self.optional_choice(key, &choices)
    }

    /// The value of one key out of a list of them.
    pub fn key<T: Keyed>(&mut self, key: &'t str) -> Result<T, ContentError> {
        let choices: Vec<(&str, T)> = T::VALUES.iter().map(|&value| (value.key(), value)).collect();
        self.choice(key, &choices)
    }

    /// A list of finite numbers.
    pub fn numbers(&mut self, key: &'t str) -> Result<Vec<f64>, ContentError> {
        match self.ask(key) {
            Some(value) => self.list(key, value),
            None => Err(self.missing(key, "a list of numbers")),
        }
    }

    fn list(&self, key: &str, value: &DeValue<'_>) -> Result<Vec<f64>, ContentError> {
        let list = value.as_array().ok_or_else(|| self.wrong(key, "a list of numbers", value))?;
        list.iter().map(|entry| self.finite(key, entry.get_ref())).collect()
    }

    /// Exactly N finite numbers.
    pub fn row<const N: usize>(&mut self, key: &'t str) -> Result<[f64; N], ContentError> {
        let list = self.numbers(key)?;
        let found = list.len();
        list.try_into().map_err(|_| self.error(key, format_args!("expected {N} numbers, found {found}")))
    }

    /// Four rows of four finite numbers.
    pub fn matrix(&mut self, key: &'t str) -> Result<[[f64; 4]; 4], ContentError> {
        let expected = "four rows of four numbers";
        let rows = self.optional_rows(key, expected)?.ok_or_else(|| self.missing(key, expected))?;
        let found = rows.len();
        rows.try_into().map_err(|_| self.error(key, format_args!("expected {expected}, found {found} rows")))
    }

    /// Rows of N finite numbers, if the key is there; `expected` says so in words.
    pub fn optional_rows<const N: usize>(
        &mut self,
        key: &'t str,
        expected: &str,
    ) -> Result<Option<Vec<[f64; N]>>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(None) };
        let rows = value.as_array().ok_or_else(|| self.wrong(key, expected, value))?;
        rows.iter()
            .map(|row| {
                let list = self.list(key, row.get_ref())?;
                let found = list.len();
                list.try_into().map_err(|_| {
                    self.error(key, format_args!("expected {expected}, found a row of {found} numbers"))
                })
            })
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// `rows` rows of `columns` finite numbers, if the key is there.
    pub fn optional_table(
        &mut self,
        key: &'t str,
        rows: usize,
        columns: usize,
    ) -> Result<Option<DMatrix<f64>>, ContentError> {
        let expected = format!("{rows} rows of {columns} numbers");
        let Some(value) = self.ask(key) else { return Ok(None) };
        let list = value.as_array().ok_or_else(|| self.wrong(key, &expected, value))?;
        if list.len() != rows {
            return Err(self.error(key, format_args!("expected {expected}, found {} rows", list.len())));
        }
        let mut table = DMatrix::zeros(rows, columns);
        for (i, row) in list.iter().enumerate() {
            let row = self.list(key, row.get_ref())?;
            if row.len() != columns {
                let found = row.len();
                return Err(
                    self.error(key, format_args!("expected {expected}, found a row of {found} numbers"))
                );
            }
            for (j, entry) in row.into_iter().enumerate() {
                table[(i, j)] = entry;
            }
        }
        Ok(Some(table))
    }

    /// A table inside, if the key is there.
    pub fn optional_block(&mut self, key: &'t str) -> Result<Option<Block<'t>>, ContentError> {
        let path = format!("{}{key}.", self.path);
        let Some(value) = self.ask(key) else { return Ok(None) };
        let start = self.entry(key).map_or(self.start, |(start, _)| start);
        match value.as_table() {
            Some(table) => Ok(Some(Block { path, start, table, asked: Vec::new(), ..*self })),
            None => Err(self.wrong(key, "a table", value)),
        }
    }

    /// A table inside.
    pub fn block(&mut self, key: &'t str) -> Result<Block<'t>, ContentError> {
        self.optional_block(key)?.ok_or_else(|| self.missing(key, &format!("a table [{}{key}]", self.path)))
    }

    /// The tables of a list inside; none where the key is missing.
    pub fn blocks(&mut self, key: &'t str) -> Result<Vec<Block<'t>>, ContentError> {
        let Some(value) = self.ask(key) else { return Ok(Vec::new()) };
        let list = value.as_array().ok_or_else(|| self.wrong(key, "a list of tables", value))?;
        list.iter()
            .map(|entry| match entry.get_ref() {
                DeValue::Table(table) => Ok(Block {
                    path: format!("{}{key}.", self.path),
                    start: entry.span().start,
                    table,
                    asked: Vec::new(),
                    ..*self
                }),
                other => Err(self.wrong(key, "a list of tables", other)),
            })
            .collect()
    }

    /// An error for the first key that nothing asked for: a misspelt one must not be passed over.
    pub fn finish(&self) -> Result<(), ContentError> {
        let stranger = self.table.keys().find(|key| !self.asked.contains(&key.get_ref().as_ref()));
        match stranger {
            Some(key) => {
                let known = self.asked.join(", ");
                Err(self.error(key.get_ref(), format_args!("not a field of this table; expected: {known}")))
            }
            None => Ok(()),
        }
    }
}

fn one_of<T>(choices: &[(&str, T)]) -> String {
    let names: Vec<String> = choices.iter().map(|(name, _)| format!("\"{name}\"")).collect();
    names.join(" or ")
}
