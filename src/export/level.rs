//! Levels of handling qualities.

use serde::Serialize;

use crate::flight::verdicts::handling_qualities::Verdict;
use crate::key::Keyed;
use crate::words;

/// A level of handling qualities.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Level"))]
pub struct LevelReport {
    /// The criterion in words.
    pub criterion: &'static str,
    /// Key of the criterion.
    #[cfg_attr(test, ts(type = "CriterionKey"))]
    pub criterion_key: &'static str,
    /// The level in words.
    pub level: &'static str,
    /// Key of the level.
    #[cfg_attr(test, ts(type = "LevelKey"))]
    pub level_key: &'static str,
    /// Whether a value equals a limit to three digits.
    pub on_boundary: bool,
    /// Paragraph of MIL-F-8785C.
    pub paragraph: &'static str,
    /// Its table or figure, and page.
    pub table: String,
    /// The values judged.
    pub values: Vec<JudgedReport>,
    /// The verdict with the limit that governs it, in one sentence.
    pub sentence: String,
}

/// A value that was judged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "JudgedValue"))]
pub struct JudgedReport {
    /// Its symbol.
    pub symbol: &'static str,
    /// The value.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
}

impl LevelReport {
    /// A verdict as it is told.
    pub fn of(verdict: &Verdict) -> Self {
        Self {
            criterion: words::verdict::criterion(verdict.criterion),
            criterion_key: verdict.criterion.key(),
            level: words::verdict::level(verdict.level),
            level_key: verdict.level.key(),
            on_boundary: verdict.on_boundary,
            paragraph: verdict.criterion.paragraph(),
            table: words::verdict::source(verdict.criterion.source(verdict.category)),
            values: verdict
                .values
                .iter()
                .map(|&(quantity, value)| JudgedReport {
                    symbol: words::verdict::symbol(quantity),
                    value,
                    unit: words::verdict::unit(quantity),
                })
                .collect(),
            sentence: words::verdict::sentence(verdict),
        }
    }
}
