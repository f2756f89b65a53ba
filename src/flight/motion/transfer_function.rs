//! Transfer function of one input to one output in factored form: G(s) = K ∏(s − zᵢ) / ∏(s − pᵢ).
//!
//! The poles are the eigenvalues of A. The zeros are the values of s at which the output stays at rest while states and input move,
//! the generalised eigenvalues of Rosenbrock's system matrix
//!
//! ```text
//! ⎡A − s  b⎤ ⎡x⎤
//! ⎣  c    d⎦ ⎣δ⎦ = 0
//! ```
//!
//! Where d is not zero, they are the eigenvalues of A − b c/d. Where it is, the state that c reads is turned by a reflection into the
//! first; it has to stay at rest, so that its own equation is what the rest of the states have to keep: a smaller system of the same form
//! (Emami-Naeini & Van Dooren, "Computation of zeros of linear multivariable systems", Automatica 18, 1982).

use nalgebra::{Complex, DMatrix, DVector, RowDVector, Vector2};

use super::outputs::OutputRow;
use super::response::{DrivenSystem, PathRates};
use crate::flight::modes::eigen::{EigenError, eigenvalues};

/// A number below this fraction of those that it is made of is what rounding left of a zero.
const ROUNDING: f64 = 1e-11;
/// A root nearer to zero than this fraction of the largest is at zero, as a mode is neutral.
const NEUTRAL_FRACTION: f64 = 1e-9;

/// Linear equations from one input to one output: ẋ = A x + b δ + ḃ δ̇, y = c x + d δ + ḋ δ̇.
#[derive(Clone, Debug, PartialEq)]
pub struct StateSpace {
    /// A.
    pub a: DMatrix<f64>,
    /// b.
    pub b: DVector<f64>,
    /// ḃ, of the input's rate of change.
    pub b_rate: DVector<f64>,
    /// c.
    pub c: RowDVector<f64>,
    /// (d, ḋ).
    pub direct: (f64, f64),
}

/// A transfer function in factored form.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransferFunction {
    /// K, output over input in SI; zero where the input doesn't reach the output.
    pub gain: f64,
    /// Zeros \[1/s\], both of each pair.
    pub zeros: Vec<Complex<f64>>,
    /// Poles \[1/s\], both of each pair.
    pub poles: Vec<Complex<f64>>,
}

impl StateSpace {
    /// The aircraft from its forcing with index `input` to an output; `None` where there is no such input.
    pub fn of(forced: &DrivenSystem, row: &OutputRow, input: usize) -> Option<Self> {
        let forcing = forced.forcings.get(input)?;
        let dynamic = |column: &[f64]| DVector::from_column_slice(column);
        let four = Self {
            a: DMatrix::from_column_slice(4, 4, forced.a.as_slice()),
            b: dynamic(forcing.column.as_slice()),
            b_rate: dynamic(forcing.rate_column.as_slice()),
            c: RowDVector::from_row_slice(row.states.as_slice()),
            direct: *row.inputs.get(input)?,
        };
        Some(four.with_path(&forced.path, row.path, [None; 2]))
    }

    /// The same with a sum of the coordinates of the path in the output. They become states, unless they are among them already, at
    /// the places `known`.
    pub fn with_path(mut self, path: &PathRates, of: Vector2<f64>, known: [Option<usize>; 2]) -> Self {
        let coupling = path.of_path[(1, 0)];
        let mut places = known;
        let needed = [of[0] != 0.0 || of[1] * coupling != 0.0, of[1] != 0.0];
        for k in (0..2).filter(|&k| needed[k]) {
            let place = places[k].unwrap_or_else(|| {
                let n = self.a.nrows();
                self.a.resize_mut(n + 1, n + 1, 0.0);
                self.a.view_mut((n, 0), (1, 4)).copy_from(&path.of_states.row(k));
                if let Some(first) = places[0].filter(|_| k == 1) {
                    self.a[(n, first)] = coupling;
                }
                self.b.resize_vertically_mut(n + 1, 0.0);
                self.b_rate.resize_vertically_mut(n + 1, 0.0);
                self.c.resize_horizontally_mut(n + 1, 0.0);
                n
            });
            places[k] = Some(place);
            self.c[place] += of[k];
        }
        self
    }

    /// The same with the sense of the input turned where `sign` is negative.
    pub fn with_sign(mut self, sign: f64) -> Self {
        self.b *= sign;
        self.b_rate *= sign;
        self.direct = (self.direct.0 * sign, self.direct.1 * sign);
        self
    }

    /// G(s); `None` at a pole.
    pub fn at(&self, s: Complex<f64>) -> Option<Complex<f64>> {
        let mut system = self.a.map(|x| Complex::from(-x));
        (0..system.nrows()).for_each(|k| system[(k, k)] += s);
        let driven = self.b.map(Complex::from) + self.b_rate.map(Complex::from) * s;
        let x = system.lu().solve(&driven)?;
        let (d, of_rate) = self.direct;
        let value = self.c.map(Complex::from).tr_dot(&x) + s * of_rate + d;
        (value.re.is_finite() && value.im.is_finite()).then_some(value)
    }

    /// G(jω) at a frequency \[rad/s\].
    pub fn over_frequency(&self, frequency: f64) -> Option<Complex<f64>> {
        self.at(Complex::new(0.0, frequency))
    }

    /// The factored form.
    pub fn factored(&self) -> Result<TransferFunction, EigenError> {
        let mut poles = eigenvalues(&self.a)?.as_slice().to_vec();
        // With z = x − ḃ δ for the states: ż = A z + (b + A ḃ) δ,   y = c z + (d + c ḃ) δ + ḋ δ̇
        let b = &self.b + &self.a * &self.b_rate;
        let (d, of_rate) = (self.direct.0 + self.c.tr_dot(&self.b_rate), self.direct.1);
        let (gain, mut zeros) = zeros(self.a.clone(), b, self.c.clone(), d, of_rate)?;
        let largest = poles.iter().chain(&zeros).map(|root| root.norm()).fold(0.0, f64::max);
        for root in poles.iter_mut().chain(&mut zeros) {
            if root.norm() <= NEUTRAL_FRACTION * largest {
                *root = Complex::default();
            }
        }
        Ok(TransferFunction { gain, zeros, poles })
    }
}

impl TransferFunction {
    /// Zeros in the right half-plane, of each pair the upper one.
    pub fn zeros_on_the_right(&self) -> impl Iterator<Item = Complex<f64>> {
        self.zeros.iter().copied().filter(|zero| zero.re > 0.0 && zero.im >= 0.0)
    }
}

/// The factor K and the zeros of c (s − A)⁻¹ b + d + ḋ s.
fn zeros(
    mut a: DMatrix<f64>,
    mut b: DVector<f64>,
    mut c: RowDVector<f64>,
    mut d: f64,
    of_rate: f64,
) -> Result<(f64, Vec<Complex<f64>>), EigenError> {
    if of_rate != 0.0 {
        // The input is one more state, δ̇ = −(c x + d δ)/ḋ.
        let n = a.nrows();
        let mut whole = a.resize(n + 1, n + 1, 0.0);
        whole.view_mut((0, n), (n, 1)).copy_from(&b);
        whole.view_mut((n, 0), (1, n)).copy_from(&(c / -of_rate));
        whole[(n, n)] = -d / of_rate;
        return Ok((of_rate, eigenvalues(&whole)?.as_slice().to_vec()));
    }
    let mut gain = 1.0;
    // What is given is meant, however small.
    let (mut no_d, mut no_c) = (0.0, 0.0);
    loop {
        let n = a.nrows();
        if d.abs() > no_d {
            let held = if n == 0 { Vec::new() } else { eigenvalues(&(a - b * c / d))?.as_slice().to_vec() };
            return Ok((gain * d, held));
        }
        let size = c.norm();
        if n == 0 || size <= no_c || b.norm() == 0.0 {
            return Ok((0.0, Vec::new()));
        }
        // The reflection that takes c to ∓‖c‖ along the first axis.
        let mut v = c.transpose();
        let sign = if v[0] < 0.0 { -1.0 } else { 1.0 };
        v[0] += sign * size;
        let reflection = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
        let turned = &reflection * a * &reflection;
        let entering = reflection * b;
        gain *= -sign * size;
        (no_d, no_c) = (ROUNDING * entering.norm(), ROUNDING * turned.norm());
        d = entering[0];
        c = turned.view((0, 1), (1, n - 1)).row(0).into_owned();
        b = entering.rows(1, n - 1).into_owned();
        a = turned.view((1, 1), (n - 1, n - 1)).into_owned();
    }
}
