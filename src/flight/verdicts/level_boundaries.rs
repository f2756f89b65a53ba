//! The limits of MIL-F-8785C as lines in the complex plane, where they can be drawn there.
//!
//! ζ is a ray, ωₙ an arc about the origin, σ a line parallel to the imaginary axis. ζ above 1, and limits on n/α, have no place
//! in the plane of one pair. The least ζωₙ of a Dutch roll that rolls much depends on its own ωₙ: drawn is that of the present one.

use std::f64::consts::LN_2;

use super::handling_qualities::{Level, load_factor_slope, phi_to_beta};
use super::mil_f_8785c::{
    Criterion, Levels, Quantity, Requirement, coupled_roll_spiral, dutch_roll, phugoid, roll_mode,
    short_period_damping, short_period_frequency, spiral,
};
use super::task::Task;
use crate::flight::aircraft::axes::StabilityAxes;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;

/// A line in the plane of λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// The rays of a damping ratio ζ, −1 < ζ < 1.
    DampingRatio(f64),
    /// The arc of a natural frequency ωₙ \[rad/s\].
    NaturalFrequency(f64),
    /// The vertical of a real part σ \[1/s\].
    RealPart(f64),
}

/// One limit of one criterion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// The criterion that sets it.
    pub criterion: Criterion,
    /// The best level that asks for it.
    pub level: Level,
    /// The worst level that asks for the same.
    pub to: Level,
    /// The limit, as the specification has it.
    pub requirement: Requirement,
    /// Where it lies.
    pub line: Line,
    /// Whether the level is on the side of larger ζ, ωₙ or σ.
    pub above: bool,
}

impl Boundary {
    /// Whether it is of a mode by this name.
    pub fn concerns(&self, name: ModeName) -> bool {
        self.criterion.concerns() == name
    }

    /// Whether it is set on a real root, so that it means something on the real axis only.
    pub fn is_of_real_root(&self) -> bool {
        matches!(self.criterion, Criterion::RollMode | Criterion::Spiral)
    }
}

/// The boundaries for the modes that an aircraft has, in the order of its modes and of the levels.
pub fn level_boundaries(model: &PlaneModel, modes: &[Mode], task: Task) -> Vec<Boundary> {
    let Task { class, category } = task;
    let slope = load_factor_slope(&StabilityAxes::of(model)).filter(|slope| *slope > 0.0);
    let mut boundaries = Vec::new();
    for mode in modes {
        let tables: Vec<(Criterion, Levels)> = match mode.naming.name {
            ModeName::ShortPeriod => vec![
                (Criterion::ShortPeriodDamping, short_period_damping(category)),
                (Criterion::ShortPeriodFrequency, short_period_frequency(class, category)),
            ],
            ModeName::Phugoid => vec![(Criterion::Phugoid, phugoid())],
            ModeName::DutchRoll => {
                let wn = mode.lambda.norm();
                let phi_rule = (wn * wn * phi_to_beta(model, mode).unwrap_or(0.0)).min(f64::MAX);
                vec![(Criterion::DutchRoll, dutch_roll(class, category, wn, phi_rule))]
            }
            ModeName::RollSubsidence => vec![(Criterion::RollMode, roll_mode(class, category))],
            ModeName::Spiral => vec![(Criterion::Spiral, spiral(category))],
            ModeName::CoupledRollSpiral => coupled_roll_spiral(category)
                .map(|levels| (Criterion::CoupledRollSpiral, levels))
                .into_iter()
                .collect(),
            _ => Vec::new(),
        };
        for (criterion, levels) in tables {
            add(&mut boundaries, criterion, &levels, slope);
        }
    }
    boundaries
}

fn add(boundaries: &mut Vec<Boundary>, criterion: Criterion, levels: &Levels, slope: Option<f64>) {
    for (level, requirements) in [Level::One, Level::Two, Level::Three].into_iter().zip(levels) {
        for &requirement in requirements {
            let Some((line, above)) = line(requirement, slope) else { continue };
            let same =
                |other: &&mut Boundary| other.criterion == criterion && other.requirement == requirement;
            if let Some(same) = boundaries.iter_mut().find(same) {
                same.to = level;
            } else {
                boundaries.push(Boundary { criterion, level, to: level, requirement, line, above });
            }
        }
    }
}

/// Where a limit lies, and whether what it allows is above it; `None` where the plane has no place for it.
fn line(requirement: Requirement, slope: Option<f64>) -> Option<(Line, bool)> {
    let Requirement { quantity, is_minimum, limit, .. } = requirement;
    Some(match quantity {
        Quantity::DampingRatio if limit.abs() < 1.0 => (Line::DampingRatio(limit), is_minimum),
        Quantity::NaturalFrequency => (Line::NaturalFrequency(limit), is_minimum),
        // CAP = ωₙ²/(n/α)
        Quantity::ControlAnticipation => (Line::NaturalFrequency((limit * slope?).sqrt()), is_minimum),
        // ζωₙ = −σ
        Quantity::DampingProduct => (Line::RealPart(-limit), !is_minimum),
        // τ = −1/σ: a longer one is further right
        Quantity::TimeConstant => (Line::RealPart(-1.0 / limit), is_minimum),
        // T₂ = ln 2/σ
        Quantity::TimeToDouble => (Line::RealPart(LN_2 / limit), !is_minimum),
        Quantity::DampingRatio | Quantity::LoadFactorSlope | Quantity::RollToSideslip => return None,
    })
}
