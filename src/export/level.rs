//! Levels of handling qualities.

use serde::Serialize;

use crate::flight::verdicts::handling_qualities::Verdict;
use crate::flight::verdicts::overall_level::OverallLevel;
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
    /// Keys of the modes that are judged.
    #[cfg_attr(test, ts(type = "Array<ModeKey>"))]
    pub modes: Vec<&'static str>,
    /// The level in words; null where the oscillation that the requirement is on is gone.
    pub level: Option<&'static str>,
    /// Key of the level.
    #[cfg_attr(test, ts(type = "LevelKey | null"))]
    pub level_key: Option<&'static str>,
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
            modes: verdict.modes.iter().map(|name| name.key()).collect(),
            level: verdict.level.map(words::verdict::level),
            level_key: verdict.level.map(Keyed::key),
            on_boundary: verdict.on_boundary,
            paragraph: verdict.criterion.paragraph(),
            table: words::verdict::source(verdict.criterion.source(verdict.task.category)),
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

/// The level of an aircraft as a whole.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "OverallLevel"))]
pub struct OverallLevelReport {
    /// The level in words; null where flight has something in it that no paragraph judges.
    pub level: Option<&'static str>,
    /// Key of the level.
    #[cfg_attr(test, ts(type = "LevelKey | null"))]
    pub level_key: Option<&'static str>,
    /// Key of the criterion that governs it.
    #[cfg_attr(test, ts(type = "CriterionKey"))]
    pub criterion_key: &'static str,
    /// Class of MIL-F-8785C that it is judged for.
    #[cfg_attr(test, ts(type = "AircraftClass"))]
    pub class: &'static str,
    /// Category of flight phase that it is judged for.
    #[cfg_attr(test, ts(type = "FlightPhase"))]
    pub category: &'static str,
    /// Keys of the modes that no paragraph judges: those that grow, and oscillations of the aircraft.
    #[cfg_attr(test, ts(type = "Array<ModeKey>"))]
    pub unjudged: Vec<&'static str>,
    /// The level and what sets it, in one sentence.
    pub sentence: String,
}

impl OverallLevelReport {
    /// An overall level as it is told.
    pub fn of(overall: &OverallLevel<'_>) -> Self {
        let task = overall.governing.task;
        Self {
            level: overall.level.map(words::verdict::level),
            level_key: overall.level.map(Keyed::key),
            criterion_key: overall.governing.criterion.key(),
            class: task.class.key(),
            category: task.category.key(),
            unjudged: overall.unjudged.iter().map(|name| name.key()).collect(),
            sentence: format!("{} ({})", words::verdict::overall(overall), words::verdict::task(task)),
        }
    }
}
