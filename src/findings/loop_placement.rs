//! A pole that gains are to place: the model under the law, which goes straight with each of them.

use nalgebra::{DMatrix, Dyn};

use super::Findings;
use super::loop_sensitivities::model_of;
use super::sensitivities::STILL;
use crate::flight::feedback::closed_model::{ClosedModel, appended_by};
use crate::flight::modes::eigen::eigenvalues;
use crate::flight::modes::inverse::{Choice, Linearised, Solved};
use crate::flight::modes::locus::Poles;
use crate::flight::modes::mode::Mode;
use crate::scenario::{Parameter, Scenario};

/// A model with gains to be chosen: A = A₀ + Σ (k − k₀) G.
pub(super) struct GainedModel {
    a: DMatrix<f64>,
    /// ∂A/∂k of each gain.
    rates: Vec<DMatrix<f64>>,
    /// The gains as they are.
    gains: Vec<f64>,
}

impl Findings {
    /// Whether a gain moves the pole of a mode that flies.
    pub(super) fn gain_moves(&self, mode: &Mode, parameter: &Parameter) -> bool {
        let index = self.flown_modes().iter().position(|other| other.naming.name == mode.naming.name);
        let rows = parameter.page.map_or(&[][..], |page| self.sensitivities(page));
        let row = rows.iter().find(|row| row.key == parameter.key);
        let strength = index.zip(row).and_then(|(index, row)| row.strengths.get(index).copied());
        // Where two roots meet there is no rate, and every change moves them.
        strength.is_some_and(|strength| strength.is_none_or(|strength| strength > STILL))
    }

    /// The model under the law, with the states of gains that are zero at present; `None` where it can't be had.
    pub(super) fn gained(&self, gains: &[&'static Parameter]) -> Option<GainedModel> {
        let scenario = self.scenario();
        let model = model_of(scenario)?;
        let mut with_all = scenario.clone();
        for gain in gains.iter().filter(|gain| gain.get(scenario) == 0.0) {
            gain.set(&mut with_all, gain.notable_change(scenario));
        }
        let states = appended_by(&with_all.law, &model);
        let a = |of: &Scenario| Some(ClosedModel::with(&model, &of.law, states.clone()).ok()?.a);
        let now = a(scenario)?;
        let rate = |gain: &&'static Parameter| {
            // A goes straight with a gain, so that any step does.
            let step = gain.notable_change(scenario);
            let mut moved = scenario.clone();
            gain.set(&mut moved, gain.get(scenario) + step);
            Some((a(&moved)? - &now) / step)
        };
        let rates = gains.iter().map(rate).collect::<Option<_>>()?;
        Some(GainedModel { rates, gains: gains.iter().map(|gain| gain.get(scenario)).collect(), a: now })
    }
}

impl GainedModel {
    fn at(&self, gains: &[f64]) -> DMatrix<f64> {
        let mut a = self.a.clone();
        for ((rate, before), gain) in self.rates.iter().zip(&self.gains).zip(gains) {
            a += rate * (gain - before);
        }
        a
    }

    /// The poles with these gains.
    pub fn poles(&self, gains: &[f64]) -> Option<Poles> {
        Some(eigenvalues(&self.at(gains)).ok()?.iter().copied().collect())
    }

    /// The same, and how the one that is meant moves with each.
    pub fn solved(&self, gains: &[f64], choice: Choice<'_>) -> Option<Solved> {
        Linearised::<Dyn> { a: self.at(gains), rates: self.rates.clone() }.solved(choice)
    }
}
