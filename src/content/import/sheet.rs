//! A review while it is being written: what a reader finds, what a person has typed, and what is still missing.

use super::fills::Fills;
use super::quantities::{Quantity, quantity};
use super::review::{Basis, Doubt, Field, Form, Read, Remedy, Review};
use crate::content::matrix::draft::Draft;
use crate::content::matrix::draft::Problem;
use crate::key::Keyed as _;
use crate::number::{significant, trimmed};

/// A number that a reader found.
#[derive(Clone, Copy, Debug)]
struct Found {
    key: &'static str,
    /// SI; degrees for angles of the trim.
    value: f64,
}

/// A review in the making.
#[derive(Debug)]
pub(super) struct Sheet {
    pub review: Review,
    pub fills: Fills,
    found: Vec<Found>,
    /// Matrices, where the file has them.
    pub matrices: Option<Draft>,
    /// Whether the moments of inertia are about body axes, and not about those of the steady flow.
    pub inertia_in_body_axes: bool,
    /// Oswald's factor of the wing, where the file has it.
    pub span_efficiency: Option<f64>,
}

impl Sheet {
    pub fn new(file: &str, form: Form, fills: Fills) -> Self {
        Self {
            review: Review {
                file: file.to_owned(),
                format: form.key(),
                format_name: form.name(),
                title: file.to_owned(),
                basis: Basis::Matrices.key(),
                read: Vec::new(),
                eigenvalues: Vec::new(),
                remarks: Vec::new(),
                fields: Vec::new(),
                doubts: Vec::new(),
                aircraft: None,
            },
            fills,
            found: Vec::new(),
            matrices: None,
            inertia_in_body_axes: true,
            span_efficiency: None,
        }
    }

    pub fn set_basis(&mut self, basis: Basis) {
        self.review.basis = basis.key();
    }

    /// Notes a number of the file, in SI; the first of a key counts.
    pub fn find(&mut self, key: &'static str, value: f64, line: usize, text: &str) {
        if self.finds(key).is_some() || !value.is_finite() {
            return;
        }
        self.found.push(Found { key, value });
        let (meaning, unit) = quantity(key).map_or(("", ""), |quantity| (quantity.meaning, quantity.unit));
        self.review.read.push(Read {
            line,
            text: text.split_whitespace().collect::<Vec<_>>().join(" "),
            key: key.to_owned(),
            meaning: meaning.to_owned(),
            value: Some(value),
            unit,
        });
    }

    /// The number that the file has for a key.
    pub fn finds(&self, key: &str) -> Option<f64> {
        self.found.iter().find(|found| found.key == key).map(|found| found.value)
    }

    /// Notes something of the file that is no number of the table.
    pub fn read_as(&mut self, line: usize, text: &str, key: &str, meaning: &str) {
        self.review.read.push(Read {
            line,
            text: text.to_owned(),
            key: key.to_owned(),
            meaning: meaning.to_owned(),
            value: None,
            unit: "",
        });
    }

    pub fn remark(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        if !self.review.remarks.contains(&sentence) {
            self.review.remarks.push(sentence);
        }
    }

    pub fn warn(&mut self, key: &'static str, sentence: impl Into<String>, remedy: Vec<Remedy>) {
        let doubt = Doubt { key, line: 0, stops: false, sentence: sentence.into(), remedy };
        if !self.review.doubts.contains(&doubt) {
            self.review.doubts.push(doubt);
        }
    }

    pub fn stop(&mut self, key: &'static str, sentence: impl Into<String>, remedy: Vec<Remedy>) {
        self.stop_on_line(0, key, sentence, remedy);
    }

    pub fn stop_on_line(
        &mut self,
        line: usize,
        key: &'static str,
        sentence: impl Into<String>,
        remedy: Vec<Remedy>,
    ) {
        self.review.doubts.push(Doubt { key, line, stops: true, sentence: sentence.into(), remedy });
    }

    /// Whether a field has no value yet.
    pub fn waits_for(&self, key: &str) -> bool {
        self.review.fields.iter().any(|field| field.key == key && field.value.is_none())
    }

    /// Whether the aircraft waits for something.
    pub fn waits(&self) -> bool {
        self.review.fields.iter().any(|field| field.required && field.value.is_none())
            || self.review.doubts.iter().any(|doubt| doubt.stops)
    }

    /// The value of a quantity: as typed, or as read. One that no aircraft has is told.
    pub fn value(&mut self, key: &'static str) -> Result<Option<f64>, Problem> {
        let Some(quantity) = quantity(key) else { return Ok(None) };
        let typed = self.fills.number(key, quantity.unit).map_err(|problem| (1, problem))?;
        let read = self.finds(key);
        if let (Some(typed), Some(read)) = (typed, read) {
            let unit = quantity.unit;
            self.remark(format!(
                "{key}: {} {unit} was typed; the file has {} {unit}.",
                trimmed(typed, 6),
                trimmed(read, 6)
            ));
        }
        let value = typed.or(read);
        if let Some(value) = value {
            self.judge(quantity, value);
        }
        Ok(value)
    }

    /// A value that is outside what any aircraft has.
    fn judge(&mut self, quantity: &Quantity, value: f64) {
        let Quantity { key, meaning, unit, low, high } = *quantity;
        if !(low..=high).contains(&value) {
            let [value, low, high] = [value, low, high].map(|x| trimmed(x, 4));
            self.warn(
                "range",
                format!("{key} ({meaning}) is {value} {unit}; aircraft have between {low} and {high}")
                    .replace("  ", " ")
                    .trim_end()
                    .to_owned()
                    + ".",
                Vec::new(),
            );
        }
    }

    /// The value of a quantity without which there is no aircraft; where it is missing, a field with what is likely.
    pub fn needed(
        &mut self,
        key: &'static str,
        suggestion: Option<(f64, String)>,
    ) -> Result<Option<f64>, Problem> {
        if let Some(value) = self.value(key)? {
            return Ok(Some(value));
        }
        let Some(&Quantity { meaning, unit, low, high, .. }) = quantity(key) else { return Ok(None) };
        let suggestion = suggestion.filter(|(value, _)| value.is_finite());
        let taken = suggestion.clone().filter(|_| self.fills.takes_suggestion(key));
        if let Some((value, reason)) = &taken {
            self.remark(format!("{key}: {} {unit} is taken: {reason}.", significant(*value, 5)));
        }
        self.review.fields.push(Field {
            key: key.to_owned(),
            meaning: meaning.to_owned(),
            unit,
            low: Some(low),
            high: Some(high),
            choices: Vec::new(),
            suggested: suggestion.as_ref().map(|(value, _)| value.to_string()),
            reason: suggestion.map(|(_, reason)| reason),
            value: taken.as_ref().map(|(value, _)| value.to_string()),
            required: true,
        });
        Ok(taken.map(|(value, _)| value))
    }

    /// The value of a choice: as typed, as `read`, or the suggestion where it is taken.
    pub fn chosen(
        &mut self,
        mut field: Field,
        read: Option<&str>,
        suggestion: Option<(String, String)>,
    ) -> Result<Option<String>, Problem> {
        // What was asked once has its answer.
        if let Some(asked) = self.review.fields.iter().find(|asked| asked.key == field.key) {
            return Ok(asked.value.clone());
        }
        let typed = self.fills.text(&field.key);
        let is_choice =
            |value: &str| field.choices.is_empty() || field.choices.iter().any(|choice| choice.key == value);
        if let Some(typed) = typed.as_deref().filter(|typed| !is_choice(typed)) {
            let known: Vec<&str> = field.choices.iter().map(|choice| choice.key.as_str()).collect();
            return Err((1, format!("{}: expected one of {}, found “{typed}”", field.key, known.join(", "))));
        }
        let mut value = typed.or_else(|| read.map(str::to_owned));
        if value.is_none()
            && let Some((suggested, reason)) = &suggestion
            && self.fills.takes_suggestion(&field.key)
        {
            self.remark(format!("{}: {suggested} is taken: {reason}.", field.key));
            value = Some(suggested.clone());
        }
        field.value.clone_from(&value);
        (field.suggested, field.reason) = suggestion.unzip();
        self.review.fields.push(field);
        Ok(value)
    }
}
