//! The equations ẋ = A x + B δ of the plane on screen, as one would write them on a board: entries and what they are made of, how
//! strongly each moves a mode, the characteristic polynomial and its factors.

mod forms;

use crate::flight::aircraft::aircraft_model::DerivativeModel;
use crate::flight::aircraft::edits::{EditedModel, MatrixOffsets};
use crate::flight::aircraft::plane::Plane;
use crate::flight::aircraft::states::Lateral::V;
use crate::flight::aircraft::states::Longitudinal::{U, W};
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::quartic::polynomial;
use crate::flight::modes::sensitivity::{entry_rate, sensitivity};
use crate::scenario::{Convention, Dimension, Page, Parameter, Scenario, parameters};

pub use forms::{Atom, Form};

/// Rows of A and B.
pub const ROWS: usize = 4;
/// Columns of A, and then those of B.
pub const COLUMNS: usize = 6;
/// Columns of A alone.
pub const STATES: usize = 4;

/// The change of an entry that its strength is told for, over the entry itself.
pub const CHANGE: f64 = 0.1;

/// The equations of one plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    /// The plane.
    pub plane: Plane,
    /// How they are written.
    pub convention: Convention,
    /// Entries of A and, in the last two columns, of B \[SI\], in the notation.
    values: [[f64; COLUMNS]; ROWS],
    /// Added by a person to the entries themselves.
    offsets: MatrixOffsets,
    /// What the entries are made of; `None` where the source has bare matrices.
    derived: Option<DerivativeModel>,
    /// a₃, a₂, a₁, a₀ of the characteristic polynomial λ⁴ + a₃λ³ + a₂λ² + a₁λ + a₀ \[1/s to 1/s⁴\].
    pub polynomial: [f64; 4],
    /// Its factors, one a mode in the order of the modes.
    pub factors: Vec<Factor>,
    /// One a mode.
    strengths: Vec<Strengths>,
}

/// How strongly each entry of A moves one mode.
type Strengths = [[Option<f64>; STATES]; ROWS];

/// A factor of the characteristic polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor {
    /// λ + c of a real root.
    Root {
        /// c = −λ \[1/s\].
        c: f64,
    },
    /// λ² + 2ζωₙλ + ωₙ² of a pair.
    Pair {
        /// 2ζωₙ = −(λ + λ̄) \[1/s\].
        damping: f64,
        /// ωₙ² = λ λ̄ \[1/s²\].
        stiffness: f64,
    },
}

impl Factor {
    fn of(mode: &Mode) -> Self {
        if mode.is_oscillatory() {
            Self::Pair { damping: -2.0 * mode.lambda.re, stiffness: mode.lambda.norm_sqr() }
        } else {
            Self::Root { c: -mode.lambda.re }
        }
    }
}

impl Equations {
    /// The equations of an analysed plane of an aircraft.
    pub(super) fn of(edited: &EditedModel, analysed: &PlaneAnalysis, convention: Convention) -> Self {
        let PlaneAnalysis { model, modes, .. } = analysed;
        let value = |row: usize, column: usize| {
            let entry = match column.checked_sub(STATES) {
                Some(input) => model.b[(row, input)],
                None => model.a[(row, column)],
            };
            entry * convention.of_entry(model.plane, row, column)
        };
        Self {
            plane: model.plane,
            convention,
            values: std::array::from_fn(|row| std::array::from_fn(|column| value(row, column))),
            offsets: edited.offsets.matrices[model.plane],
            derived: edited.derivatives().ok().flatten(),
            polynomial: polynomial(&model.a),
            factors: modes.iter().map(Factor::of).collect(),
            strengths: modes.iter().map(|mode| strengths(analysed, mode)).collect(),
        }
    }

    /// The value of an entry \[SI\]; columns 4 and 5 are those of B.
    pub fn value(&self, row: usize, column: usize) -> f64 {
        self.values.get(row).and_then(|row| row.get(column)).copied().unwrap_or_default()
    }

    /// The slider of an entry, and −1 where the slider's symbol has the other sign; `None` where the entry is fixed by kinematics or
    /// has no slider of its own.
    pub fn slider(&self, row: usize, column: usize) -> Option<(&'static Parameter, f64)> {
        parameters().find_map(|parameter| match parameter.entry()? {
            (plane, r, c, sign) if (plane, r, c) == (self.plane, row, column) => Some((parameter, sign)),
            _ => None,
        })
    }

    /// How an entry is made; `None` where the source has bare matrices, of which only the numbers are known.
    pub fn form(&self, row: usize, column: usize) -> Option<Form> {
        self.derived.as_ref().map(|_| forms::form(self.plane, row, column, self.convention.notation))
    }

    /// What a person has added to an entry itself \[SI\].
    pub fn added(&self, row: usize, column: usize) -> f64 {
        let MatrixOffsets { a, b } = &self.offsets;
        let added = match column.checked_sub(STATES) {
            Some(input) => b.get((row, input)),
            None => a.get((row, column)),
        };
        added.copied().unwrap_or_default() * self.convention.of_entry(self.plane, row, column)
    }

    /// The value of what entries are made of \[SI\], in the notation.
    pub fn atom(&self, scenario: &Scenario, atom: Atom) -> Option<f64> {
        atom.value(scenario, self.derived.as_ref()?, self.convention)
    }

    /// Size of the move of a mode's λ relative to |λ| when an entry changes by [`CHANGE`] of itself; `None` at a repeated root. An entry
    /// of B moves none.
    pub fn strength(&self, mode: usize, row: usize, column: usize) -> Option<f64> {
        if column >= STATES {
            return Some(0.0);
        }
        *self.strengths.get(mode)?.get(row)?.get(column)?
    }

    /// The sliders that an entry is made of, on the page of dimensional derivatives.
    pub fn derivatives(&self, row: usize, column: usize) -> Vec<&'static Parameter> {
        let of_atom = |atom| match atom {
            Atom::Derivative(key) => Parameter::find(key),
            Atom::Heave => Parameter::find("z_wdot"),
            _ => None,
        };
        let mut found: Vec<&'static Parameter> = Vec::new();
        let atoms = self.form(row, column).map(|form| form.atoms()).unwrap_or_default();
        for parameter in atoms.into_iter().filter_map(of_atom) {
            if parameter.page == Some(Page::Dimensional) && !found.contains(&parameter) {
                found.push(parameter);
            }
        }
        found
    }

    /// The dimension of an entry: of a rate over a state, lengths being in the first states only.
    pub fn dimension(&self, row: usize, column: usize) -> Dimension {
        let is_angle_of_flow = |index: usize| self.convention.angle(self.plane) == Some(index);
        let has_length = |index: usize| match self.plane {
            Plane::Longitudinal => index == U.index() || index == W.index() && !is_angle_of_flow(index),
            Plane::Lateral => index == V.index() && !is_angle_of_flow(index),
        };
        let is_angle = |index: usize| index + 1 == STATES || is_angle_of_flow(index);
        match (has_length(row), is_angle(row)) {
            (true, _) if column >= STATES || is_angle(column) => Dimension::Acceleration,
            (true, _) if has_length(column) => Dimension::PerSecond,
            (true, _) => Dimension::Speed,
            // φ̇ and θ̇ of an angular rate
            (false, true) if column < STATES && !has_length(column) && !is_angle(column) => Dimension::Number,
            (false, true) if has_length(column) => Dimension::PerLength,
            (false, true) => Dimension::PerSecond,
            (false, false) if has_length(column) => Dimension::PerLengthSecond,
            (false, false) if column >= STATES || is_angle(column) => Dimension::PerSecondSquared,
            (false, false) => Dimension::PerSecond,
        }
    }
}

/// |∂λ/∂aᵢⱼ| |aᵢⱼ| for the change that is told, over |λ|.
fn strengths(PlaneAnalysis { model, modes, .. }: &PlaneAnalysis, mode: &Mode) -> Strengths {
    let fastest = modes.iter().map(|mode| mode.lambda.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let size = mode.lambda.norm().max(1e-3 * fastest);
    let strength = |row: usize, column: usize| {
        let rate = sensitivity(mode, &entry_rate(row, column)).rate()?;
        Some((rate.lambda.norm() * CHANGE * model.a[(row, column)].abs() / size).min(f64::MAX))
    };
    std::array::from_fn(|row| std::array::from_fn(|column| strength(row, column)))
}
