//! The text of an aircraft file, written key by key. Every number keeps its last bit.

use toml::Value;

/// A text in the making.
#[derive(Debug, Default)]
pub(super) struct AircraftText(String);

impl AircraftText {
    /// The head of every file: what it is, and from where.
    pub fn new(title: &str, condition: &str, source: &str, remarks: &[String]) -> Self {
        let mut text = Self::default();
        text.word("key", "file");
        text.word("name", title);
        text.word("condition", condition);
        text.word("source", source);
        if !remarks.is_empty() {
            text.word("note", &remarks.join(" "));
        }
        text
    }

    pub fn word(&mut self, key: &str, word: &str) {
        let shown: String = word.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let word = if shown.trim().is_empty() { "–" } else { shown.trim() };
        self.line(key, &Value::String(word.to_owned()).to_string());
    }

    pub fn number(&mut self, key: &str, value: f64) {
        self.line(key, &number(value));
    }

    pub fn optional(&mut self, key: &str, value: Option<f64>) {
        if let Some(value) = value {
            self.number(key, value);
        }
    }

    pub fn rows<'r>(&mut self, key: &str, rows: impl Iterator<Item = Vec<f64>> + 'r) {
        let rows: Vec<String> = rows.map(|row| list(row.into_iter())).collect();
        self.line(key, &format!("[{}]", rows.join(", ")));
    }

    pub fn words(&mut self, key: &str, words: &[&str]) {
        let words: Vec<String> =
            words.iter().map(|word| Value::String((*word).to_owned()).to_string()).collect();
        self.line(key, &format!("[{}]", words.join(", ")));
    }

    pub fn list(&mut self, key: &str, row: &[f64]) {
        self.line(key, &list(row.iter().copied()));
    }

    pub fn block(&mut self, name: &str) {
        self.0.push_str("\n[");
        self.0.push_str(name);
        self.0.push_str("]\n");
    }

    /// The status of a plane whose numbers come from elsewhere.
    pub fn unverified(&mut self) {
        self.word("status", "unverified");
        self.word("status_reason", "Read from a file: there are no published modes to compare with.");
    }

    fn line(&mut self, key: &str, value: &str) {
        self.0.push_str(key);
        self.0.push_str(" = ");
        self.0.push_str(value);
        self.0.push('\n');
    }

    pub fn finish(self) -> String {
        self.0
    }
}

fn list(numbers: impl Iterator<Item = f64>) -> String {
    format!("[{}]", numbers.map(number).collect::<Vec<_>>().join(", "))
}

/// The shortest digits that are read as this very number.
fn number(value: f64) -> String {
    format!("{value:?}")
}
