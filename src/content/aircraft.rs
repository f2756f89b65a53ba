//! One aircraft in one flight condition, as its file has it.

use nalgebra::{Matrix4, Vector4};
use serde::Deserialize;
use thiserror::Error;

use crate::flight::linear::{Longitudinal, LongitudinalModel};

/// An aircraft in one flight condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Aircraft {
    /// Short name for links and tests, never changed once published.
    pub key: String,
    /// Name on screen.
    pub name: String,
    /// Flight condition in words.
    pub condition: String,
    /// Unit of length in which its numbers are shown, that of its source.
    pub length_unit: LengthUnit,
    /// Whether its modes were checked against published ones.
    pub status: Status,
    /// Why the status is what it is, in a sentence or two.
    pub status_reason: String,
    /// Where every number comes from.
    pub source: String,
    /// Its longitudinal model, SI.
    pub longitudinal: LongitudinalModel,
}

/// Whether an aircraft's modes were checked against published ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// Every published number is reproduced.
    Verified,
    /// Something is open; the reason says what.
    Unverified,
}

/// A unit of length in which an aircraft's source gives its numbers; time is in seconds, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub enum LengthUnit {
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Hundred feet, the hidden unit of the lesson's matrix.
    #[serde(rename = "100 ft")]
    HundredFeet,
}

impl LengthUnit {
    /// One of this unit in metres.
    pub const fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            // 1 ft = 0.3048 m, exactly
            Self::HundredFeet => 30.48,
        }
    }

    /// Its symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::HundredFeet => "100 ft",
        }
    }
}

/// A file that could not be read as an aircraft.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}, line {line}: {problem}")]
pub struct ContentError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// What is wrong and what was expected.
    pub problem: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AircraftFile {
    key: String,
    name: String,
    condition: String,
    length_unit: LengthUnit,
    status: Status,
    status_reason: String,
    source: String,
    longitudinal: LongitudinalFile,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LongitudinalFile {
    u0: f64,
    a: [[f64; 4]; 4],
    b_elevator: [f64; 4],
}

impl Aircraft {
    /// Reads one aircraft from TOML text and converts it to SI; `file` is its name for messages.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, ContentError> {
        let read: AircraftFile = toml::from_str(text).map_err(|error| ContentError {
            file: file.to_owned(),
            line: error.span().map_or(1, |span| line_of(text, span.start)),
            problem: error.message().to_owned(),
        })?;
        let longitudinal =
            read.longitudinal.to_si(read.length_unit).map_err(|(field, problem)| ContentError {
                file: file.to_owned(),
                line: text.lines().position(|line| line.trim_start().starts_with(field)).map_or(1, |i| i + 1),
                problem,
            })?;
        Ok(Self {
            key: read.key,
            name: read.name,
            condition: read.condition,
            length_unit: read.length_unit,
            status: read.status,
            status_reason: read.status_reason,
            source: read.source,
            longitudinal,
        })
    }
}

impl LongitudinalFile {
    /// A_SI = T A T⁻¹, B_SI = T B with T = diag(l, l, 1, 1) and l the unit of length in metres.
    ///
    /// An error is the field and a sentence.
    fn to_si(&self, unit: LengthUnit) -> Result<LongitudinalModel, (&'static str, String)> {
        let numbers = self.a.iter().flatten().chain(&self.b_elevator);
        if let Some(number) = numbers.copied().find(|x| !x.is_finite()) {
            return Err(("a", format!("every entry of A and B must be a finite number, not {number}")));
        }
        if !(self.u0.is_finite() && self.u0 > 0.0) {
            return Err(("u0", format!("the trim speed u0 must be a positive number, not {}", self.u0)));
        }
        let theta = Longitudinal::Theta.index();
        if self.a[theta] != [0.0, 0.0, 1.0, 0.0] {
            return Err((
                "a",
                "the last row of A must be 0, 0, 1, 0: pitch rate is the rate of pitch angle".to_owned(),
            ));
        }
        let l = unit.metres();
        let scale = Vector4::new(l, l, 1.0, 1.0);
        Ok(LongitudinalModel {
            a: Matrix4::from_fn(|i, j| self.a[i][j] * (scale[i] / scale[j])),
            b_elevator: Vector4::from(self.b_elevator).component_mul(&scale),
            u0: self.u0 * l,
        })
    }
}

fn line_of(text: &str, offset: usize) -> usize {
    text.bytes().take(offset).filter(|&byte| byte == b'\n').count() + 1
}
