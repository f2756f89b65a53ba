//! The only cache: what follows from the scenario on screen, computed again only when the scenario has changed.

use crate::flight::{Analysis, AnalysisError};
use crate::scenario::Scenario;

/// A scenario and what follows from it.
#[derive(Debug, Default)]
pub struct Memo {
    of: Option<(Scenario, Result<Analysis, AnalysisError>)>,
    computations: u64,
}

impl Memo {
    /// Computes again if `scenario` is not the one of the last time, and gives what follows from it.
    pub fn refresh(&mut self, scenario: &Scenario) -> &Result<Analysis, AnalysisError> {
        if !self.is_of(scenario) {
            self.of = None;
        }
        let computations = &mut self.computations;
        let (_, analysis) = self.of.get_or_insert_with(|| {
            *computations += 1;
            (scenario.clone(), scenario.analyse())
        });
        analysis
    }

    /// Whether what it holds follows from `scenario`.
    pub fn is_of(&self, scenario: &Scenario) -> bool {
        self.of.as_ref().is_some_and(|(of, _)| of == scenario)
    }

    /// What followed at the last refresh.
    pub fn analysis(&self) -> Option<&Result<Analysis, AnalysisError>> {
        self.of.as_ref().map(|(_, analysis)| analysis)
    }

    /// How often it has computed, so that tests can see that nothing is computed twice.
    pub fn computations(&self) -> u64 {
        self.computations
    }
}
