//! The sheet that is gone through before a file is used: what was read as what, what is missing, what looks wrong.

use serde::Serialize;

use crate::key::keys;

/// What a file holds and what stands in the way of using it.
///
/// Nothing in it is mended. A remedy is a value for a field, which counts once it is given as one.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "FileReview"))]
pub struct Review {
    /// Name of the file.
    pub file: String,
    /// Key of the form that it is in.
    pub format: &'static str,
    /// The form in words.
    pub format_name: &'static str,
    /// Title, as the file has it.
    pub title: String,
    /// What the aircraft is made of: `coefficients`, `derivatives` or `matrices`.
    pub basis: &'static str,
    /// Each number that was read, in the order of the file.
    pub read: Vec<Read>,
    /// Eigenvalues of the matrices that were read, by plane; empty where none were.
    pub eigenvalues: Vec<PlaneEigenvalues>,
    /// What was made of them, a sentence or two each: units, axes, signs turned, states left out, digits lost.
    pub remarks: Vec<String>,
    /// What can be filled in. The aircraft waits for those that are required.
    pub fields: Vec<Field>,
    /// What looks wrong.
    pub doubts: Vec<Doubt>,
    /// The aircraft as the text of an aircraft file; `None` while something is missing or stops it.
    pub aircraft: Option<String>,
}

/// A number as it stands in the file, and what it was taken for.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ReadQuantity"))]
pub struct Read {
    /// Line of the file, counted from 1; 0 where it follows from others.
    pub line: usize,
    /// As it stands there.
    pub text: String,
    /// Key of the quantity.
    pub key: String,
    /// The quantity in words.
    pub meaning: String,
    /// Its value in `unit`.
    pub value: Option<f64>,
    /// SI unit; degrees for angles of the trim.
    pub unit: &'static str,
}

/// Eigenvalues of a plane of motion in a file of matrices.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PlaneEigenvalues {
    /// Key of the plane.
    pub plane: &'static str,
    /// Real and imaginary part of each \[1/s\], of the four states.
    pub values: Vec<[f64; 2]>,
    /// The same with the further states that were kept; empty where there are none.
    pub with_further: Vec<[f64; 2]>,
}

/// Something that a person can fill in.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ReviewField"))]
pub struct Field {
    /// Its key, by which a value is given.
    pub key: String,
    /// What it is.
    pub meaning: String,
    /// Unit of its number; empty for a choice or a text.
    pub unit: &'static str,
    /// Least plausible value.
    pub low: Option<f64>,
    /// Greatest plausible value.
    pub high: Option<f64>,
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
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ReviewChoice"))]
pub struct Choice {
    /// The value.
    pub key: String,
    /// The value in words.
    pub words: String,
}

/// Something that looks wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ReviewDoubt"))]
pub struct Doubt {
    /// Its key.
    pub key: &'static str,
    /// Line of the file, counted from 1; 0 where it concerns the whole.
    pub line: usize,
    /// Whether the aircraft can be used all the same.
    pub stops: bool,
    /// A sentence with the numbers that show it.
    pub sentence: String,
    /// Values that mend it, where it is certain what is wrong.
    pub remedy: Vec<Remedy>,
}

/// A field and the value that mends something.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ReviewRemedy"))]
pub struct Remedy {
    /// Key of the field.
    pub key: String,
    /// The value.
    pub value: String,
}

/// What an aircraft is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Basis {
    Coefficients,
    Derivatives,
    Matrices,
    /// An aircraft file says so itself.
    OwnFile,
}

keys! {
    Basis {
        Coefficients => "coefficients",
        Derivatives => "derivatives",
        Matrices => "matrices",
        OwnFile => "aircraft-file",
    }
}

/// The forms of files that can be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// An aircraft file of this program.
    AircraftFile,
    /// Matrices as JSON.
    Json,
    /// Matrices as a table.
    Table,
    /// Matrices as MATLAB, Octave or Python text.
    Script,
    /// Matrices as nothing but numbers.
    Numbers,
    /// AVL's stability derivatives.
    AvlStability,
    /// AVL's system matrix.
    AvlSystem,
    /// XFLR5's or flow5's log of a stability analysis.
    Xflr5,
    /// VSPAERO's stability file.
    Vspaero,
    /// Digital DATCOM's output.
    Datcom,
    /// JSBSim's linearisation as JSON.
    JsbsimJson,
    /// JSBSim's linearisation as a Scicoslab file.
    JsbsimScicos,
}

keys! {
    Form {
        AircraftFile => "aircraft-file",
        Json => "json",
        Table => "table",
        Script => "script",
        Numbers => "numbers",
        AvlStability => "avl-st",
        AvlSystem => "avl-sys",
        Xflr5 => "xflr5",
        Vspaero => "vspaero-stab",
        Datcom => "datcom",
        JsbsimJson => "jsbsim-json",
        JsbsimScicos => "jsbsim-scicos",
    }
}

impl Form {
    /// The form in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AircraftFile => "aircraft file of Eigenwing (TOML)",
            Self::Json => "matrices as JSON",
            Self::Table => "matrices as a table (CSV)",
            Self::Script => "matrices as MATLAB, Octave or Python text",
            Self::Numbers => "matrices as bare numbers",
            Self::AvlStability => "AVL stability derivatives (.st)",
            Self::AvlSystem => "AVL system matrix (.sys)",
            Self::Xflr5 => "XFLR5 or flow5 stability log",
            Self::Vspaero => "VSPAERO stability file (.stab)",
            Self::Datcom => "Digital DATCOM output",
            Self::JsbsimJson => "JSBSim linearisation (JSON)",
            Self::JsbsimScicos => "JSBSim linearisation (Scicoslab)",
        }
    }
}

impl Remedy {
    pub(super) fn new(key: &str, value: impl ToString) -> Self {
        Self { key: key.to_owned(), value: value.to_string() }
    }
}

impl Field {
    /// A field that is a choice among a few values.
    pub(super) fn choice(key: &str, meaning: &str, choices: &[(&str, &str)]) -> Self {
        Self {
            key: key.to_owned(),
            meaning: meaning.to_owned(),
            unit: "",
            low: None,
            high: None,
            choices: choices
                .iter()
                .map(|(key, words)| Choice { key: (*key).to_owned(), words: (*words).to_owned() })
                .collect(),
            suggested: None,
            reason: None,
            value: None,
            required: true,
        }
    }
}

impl Field {
    /// The field in a sentence about what is missing: its key, what it is, and what is likely.
    pub fn told(&self) -> String {
        let mut told = format!("{} ({}", self.key, self.meaning);
        if !self.unit.is_empty() {
            told.push_str(" in ");
            told.push_str(self.unit);
        }
        if !self.choices.is_empty() && self.choices.len() <= 6 {
            let keys: Vec<&str> = self.choices.iter().map(|choice| choice.key.as_str()).collect();
            told.push_str(": ");
            told.push_str(&keys.join(" or "));
        } else if let [first, .., last] = self.choices.as_slice() {
            told.push_str(&format!(": {} ({}) to {} ({})", first.key, first.words, last.key, last.words));
        }
        if let Some(suggested) = &self.suggested {
            told.push_str("; perhaps ");
            told.push_str(suggested);
        }
        told.push(')');
        told
    }
}

impl Doubt {
    /// The sentence with what would mend it.
    pub fn told(&self) -> String {
        let remedy: Vec<String> =
            self.remedy.iter().map(|remedy| format!("{}={}", remedy.key, remedy.value)).collect();
        if remedy.is_empty() {
            self.sentence.clone()
        } else {
            format!("{} It would fit with {}.", self.sentence, remedy.join(" and "))
        }
    }
}
