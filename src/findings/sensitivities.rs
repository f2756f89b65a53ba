//! How strongly each parameter of a page moves each mode.

use crate::few;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::sensitivity::{Sensitivity, sensitivity};
use crate::scenario::{Page, Parameter, Scenario, parameters};

/// A parameter that moves |λ| by less than this fraction for a notable change of its own doesn't move the pole.
pub(super) const STILL: f64 = 1e-6;

/// How one parameter moves the modes of the studied plane.
#[derive(Clone, Debug, PartialEq)]
pub struct RowSensitivity {
    /// Key of the parameter.
    pub key: &'static str,
    /// The change of the parameter that is meant \[SI\]: ten per cent more of its size, or a sixtieth of its slider where it is near zero.
    pub change: f64,
    /// One a mode, in the order of the analysis, per unit of the parameter.
    pub modes: Vec<Sensitivity>,
    /// Size of the move of each λ relative to |λ| for that change; `None` at a repeated root.
    pub strengths: Vec<Option<f64>>,
}

/// The sensitivities of every parameter on a page that the aircraft has.
pub(super) fn of_page(scenario: &Scenario, analysed: &PlaneAnalysis, page: Page) -> Vec<RowSensitivity> {
    parameters().filter(|p| p.is_shown(scenario, page)).filter_map(|p| row(scenario, analysed, p)).collect()
}

fn row(
    scenario: &Scenario,
    analysis: &PlaneAnalysis,
    parameter: &'static Parameter,
) -> Option<RowSensitivity> {
    let a_rate = parameter.matrix_rate(&scenario.edited, scenario.plane)?;
    let change = parameter.notable_change(scenario);
    let modes: Vec<Sensitivity> = analysis.modes.iter().map(|mode| sensitivity(mode, &a_rate)).collect();
    let strengths = strengths(&analysis.modes, &modes, change);
    Some(RowSensitivity { key: parameter.key, change, modes, strengths })
}

/// Size of the move of each λ relative to |λ| for a change of a parameter \[SI\]; `None` at a repeated root.
pub(super) fn strengths(modes: &[Mode], rates: &[Sensitivity], change: f64) -> Vec<Option<f64>> {
    let fastest = modes.iter().map(|mode| mode.lambda.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let strength = |(mode, sensitivity): (&Mode, &Sensitivity)| {
        let size = mode.lambda.norm().max(1e-3 * fastest);
        sensitivity.rate().map(|rate| (rate.lambda.norm() * change / size).min(f64::MAX))
    };
    modes.iter().zip(rates).map(strength).collect()
}

/// Keys of the rows that move a mode, the strongest first.
pub fn by_strength(rows: &[RowSensitivity], index: usize) -> Vec<&'static str> {
    let strength = |row: &RowSensitivity| row.strengths.get(index).copied().flatten();
    let mut moving: Vec<(&'static str, f64)> = rows
        .iter()
        // No strength: at a repeated root every row moves it.
        .map(|row| (row.key, strength(row).unwrap_or(f64::MAX)))
        .filter(|(_, strength)| *strength > STILL)
        .collect();
    few::sort_by(&mut moving, |a, b| b.1.total_cmp(&a.1));
    moving.into_iter().map(|(key, _)| key).collect()
}
