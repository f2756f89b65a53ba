//! A linear system with named states, as many as a file has: its rigid-body states, and what else it holds.

use nalgebra::{Complex, DMatrix, Schur};

use crate::content::matrix::state_names::Meaning;
use crate::flight::aircraft::plane::Plane;
use crate::number::eigenvalue;

/// ẋ = A x + B δ in the units of a file.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// The states as the file names them.
    pub names: Vec<String>,
    /// What they are.
    pub meanings: Vec<Meaning>,
    /// The inputs as the file names them.
    pub inputs: Vec<String>,
    pub a: Vec<Vec<f64>>,
    /// As many columns as inputs.
    pub b: Vec<Vec<f64>>,
}

impl System {
    /// Place of the first state that means one of these.
    pub fn place(&self, meanings: &[Meaning]) -> Option<usize> {
        self.meanings.iter().position(|meaning| meanings.contains(meaning))
    }

    /// Places of the four states of a plane, in the order of its state vector; `None` for each that is missing.
    pub fn plane(&self, plane: Plane) -> [Option<usize>; 4] {
        let rigid = |names: &[&'static str]| {
            let named: Vec<Meaning> = names.iter().map(|&name| Meaning::Rigid(plane, name)).collect();
            self.place(&named)
        };
        match plane {
            Plane::Longitudinal => [
                rigid(&["u"]).or_else(|| self.place(&[Meaning::Airspeed, Meaning::SpeedRatio])),
                rigid(&["w", "alpha"]),
                rigid(&["q"]),
                rigid(&["theta"]).or_else(|| self.place(&[Meaning::PathAngle])),
            ],
            Plane::Lateral => [rigid(&["v", "beta"]), rigid(&["p"]), rigid(&["r"]), rigid(&["phi"])],
        }
    }

    /// States in other units: x = s x′, so row k over s and column k times s.
    pub fn rescale(&mut self, k: usize, s: f64) {
        self.scale_row(k, 1.0 / s);
        for row in &mut self.a {
            row[k] *= s;
        }
    }

    /// The rate of one state in another unit.
    pub fn scale_row(&mut self, k: usize, s: f64) {
        self.a[k].iter_mut().chain(&mut self.b[k]).for_each(|entry| *entry *= s);
    }

    /// θ = γ + α in place of γ.
    pub fn pitch_for_path(&mut self, path: usize, alpha: usize) {
        let (of_alpha, inputs_of_alpha) = (self.a[alpha].clone(), self.b[alpha].clone());
        for (entry, added) in self.a[path].iter_mut().zip(of_alpha) {
            *entry += added;
        }
        for (entry, added) in self.b[path].iter_mut().zip(inputs_of_alpha) {
            *entry += added;
        }
        // γ = θ − α
        for row in &mut self.a {
            row[alpha] -= row[path];
        }
    }

    /// The part of A of these states.
    pub fn part(&self, kept: &[usize]) -> Vec<Vec<f64>> {
        kept.iter().map(|&i| kept.iter().map(|&j| self.a[i][j]).collect()).collect()
    }
}

/// Eigenvalues of a square matrix; `None` where they can't be found. Real and imaginary parts that are but rounding are zero.
pub(super) fn eigenvalues(a: &[Vec<f64>]) -> Option<Vec<Complex<f64>>> {
    if a.is_empty() || a.iter().flatten().any(|x| !x.is_finite() || x.abs() > 1e100) {
        return None;
    }
    let matrix = DMatrix::from_fn(a.len(), a.len(), |i, j| a[i][j]);
    let matrix = balanced(matrix);
    let rounding = ROUNDING * matrix.norm();
    let rounded = |part: f64| if part.abs() < rounding { 0.0 } else { part };
    let schur = Schur::try_new(matrix, f64::EPSILON, 10_000)?;
    let values: Vec<Complex<f64>> = schur
        .complex_eigenvalues()
        .iter()
        .map(|value| Complex::new(rounded(value.re), rounded(value.im)))
        .collect();
    values.iter().all(|value| value.re.is_finite() && value.im.is_finite()).then_some(values)
}

/// The same with rows and columns of like size: feet beside radians would cost digits.
fn balanced(mut a: DMatrix<f64>) -> DMatrix<f64> {
    let n = a.nrows();
    for _ in 0..20 {
        let mut changed = false;
        for k in 0..n {
            let column: f64 = (0..n).filter(|&i| i != k).map(|i| a[(i, k)].abs()).sum();
            let row: f64 = (0..n).filter(|&j| j != k).map(|j| a[(k, j)].abs()).sum();
            if column == 0.0 || row == 0.0 {
                continue;
            }
            // A power of two keeps every digit.
            let s = (row / column).sqrt().log2().round().exp2();
            if s.is_finite() && s > 0.0 && s != 1.0 {
                a.column_mut(k).scale_mut(s);
                a.row_mut(k).scale_mut(1.0 / s);
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    a
}

/// What a simple eigenvalue of a balanced matrix may be off, over the norm of the matrix.
const ROUNDING: f64 = 1e-14;

/// An eigenvalue alone and in company.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shift {
    pub alone: Complex<f64>,
    pub together: Complex<f64>,
    /// |Δλ| over |λ|.
    pub relative: f64,
}

/// How far one may move before it is worth a number.
pub(super) const HARDLY: f64 = 1e-4;

/// An eigenvalue in a sentence, the upper one of a pair.
pub(super) fn upper(lambda: Complex<f64>) -> String {
    eigenvalue(Complex::new(lambda.re, lambda.im.abs()))
}

/// The largest shift of an eigenvalue of the parts from those of the whole.
pub(super) fn largest_shift(parts: &[Vec<Vec<f64>>], whole: &[Vec<f64>]) -> Option<Shift> {
    let whole = eigenvalues(whole)?;
    let mut alone = Vec::new();
    for part in parts {
        alone.extend(eigenvalues(part)?);
    }
    // Near zero a shift is measured against a thousandth of a radian a second.
    let shift = |alone: Complex<f64>| {
        let distance = |other: &Complex<f64>| (other - alone).norm();
        let together = whole.iter().copied().min_by(|x, y| distance(x).total_cmp(&distance(y)))?;
        Some(Shift { alone, together, relative: distance(&together) / alone.norm().max(1e-3) })
    };
    alone.into_iter().filter_map(shift).max_by(|x, y| x.relative.total_cmp(&y.relative))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_of_badly_scaled_states_keep_their_digits() {
        // λ = −1, −2 and 0, once as they are and once with the second state in thousandths.
        for s in [1.0, 1e3, 1e-6] {
            let a = [vec![-1.0, 1.0 / s, 0.0], vec![0.0, -2.0, 0.0], vec![1.0, s, 0.0]];
            let mut values: Vec<f64> =
                eigenvalues(&a).expect("they are found").iter().map(|value| value.re).collect();
            values.sort_by(f64::total_cmp);
            for (value, expected) in values.iter().zip([-2.0, -1.0, 0.0]) {
                assert!((value - expected).abs() < 1e-9, "{s}: {values:?}");
            }
        }
    }
}
