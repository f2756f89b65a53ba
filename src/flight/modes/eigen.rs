//! Eigenvalues and eigenvectors of a real matrix, with an answer for every finite one.
//!
//! The road is LAPACK's `dgeev` (balance, Hessenberg, QR, eigenvectors of the triangle, back), bounded at every loop: a slider at
//! zero makes permutations, Jordan blocks and zero matrices, and a page must not wait for them.
//!
//! One road for two sizes: four states, which every movement of a slider asks for and whose size the compiler knows, and any number,
//! of models with states appended to the four.
//!
//! Sources: Golub & Van Loan, *Matrix Computations*, 4th ed. (GVL), §7; LAPACK routine names beside the functions.

use crate::few;
use nalgebra::{Complex, DefaultAllocator, OMatrix, OVector, U1, U4};

use super::schur::{Room, Size, Square, power_of_two, schur, triangle};

/// Eigenvalues with right and left eigenvectors of a real matrix A, of four states or of N.
///
/// The computed values are those of a matrix within rounding of A, but a defective one (a Jordan block of size m)
/// still moves by about (10⁻¹⁶)^(1/m) of its norm: that is the nature of the problem, not of the method.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen<N: Size = U4>
where
    DefaultAllocator: Room<N>,
{
    /// Eigenvalues λ \[1/s\], largest |λ| first; a conjugate pair is exact, adjacent, positive imaginary part first.
    pub values: OVector<Complex<f64>, N>,
    /// Column i: v with A v = λᵢ v and ‖v‖₂ = 1; real where λᵢ is real, conjugate columns for a conjugate pair.
    pub right: OMatrix<Complex<f64>, N, N>,
    /// Column i: l with lᴴ A = λᵢ lᴴ, that is Aᵀ l = λ̄ᵢ l, and ‖l‖₂ = 1; real or conjugate as `right`.
    pub left: OMatrix<Complex<f64>, N, N>,
}

/// Why a matrix has no eigenvalues to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EigenError {
    /// An entry is NaN or infinite, or an eigenvalue would be too large for a 64-bit number.
    NotFinite,
    /// The iteration used up its bound; no matrix is known that does this.
    NotConverged,
}

impl<N: Size> Eigen<N>
where
    DefaultAllocator: Room<N>,
{
    /// Share of each state in a mode: |vₖ lₖ| normalised to sum 1 (Pérez-Arriaga, Verghese & Schweppe 1982).
    ///
    /// Always finite shares, one a state. Where v and l have no state in common (an exactly defective matrix) the mean of |vₖ|² and
    /// |lₖ|² stands in: half where the mode shows, half where it is excited. A `mode` beyond the last means the last one.
    pub fn participation(&self, mode: usize) -> OVector<f64, N> {
        let mode = mode.min(self.values.len().saturating_sub(1));
        let (v, l) = (self.right.column(mode), self.left.column(mode));
        // pₖ = |vₖ| |lₖ| / Σ |vᵢ| |lᵢ|
        let products = v.zip_map(&l, |v, l| v.norm() * l.norm());
        let sum = products.sum();
        if sum > f64::MIN_POSITIVE {
            products / sum
        } else {
            v.zip_map(&l, |v, l| 0.5 * (v.norm_sqr() + l.norm_sqr()))
        }
    }
}

/// Eigenvalues and both sets of eigenvectors of `a`.
///
/// ‖A v − λ v‖ and ‖Aᵀ l − λ̄ l‖ stay below 10⁻¹²‖A‖. Balancing keeps small eigenvalues accurate but can spoil that
/// bound for badly scaled matrices (Watkins 2006): their vectors get a step of inverse iteration, and the few that it
/// does not mend (1 in 6,000 random ones with entries over 16 decades) are solved again without balancing, where small
/// eigenvalues are good to rounding of ‖A‖ only.
pub fn eigen<N: Size>(a: &Square<N>) -> Result<Eigen<N>, EigenError>
where
    DefaultAllocator: Room<N>,
{
    if !a.iter().all(|x| x.is_finite()) {
        return Err(EigenError::NotFinite);
    }
    let scale = power_of_two(a.amax());
    let unit = a / scale;
    let mut solved = solve(&unit, &Balance::of(&unit))?;
    if !solved.satisfies(&unit) {
        solved.refine(&unit);
        if !solved.satisfies(&unit) {
            solved = solve(&unit, &Balance::none(a))?;
        }
    }
    // Adding zero makes −0 a 0.
    solved.values.apply(|value| *value = *value * scale + Complex::from(0.0));
    let finite = |value: &Complex<f64>| value.re.is_finite() && value.im.is_finite();
    if solved.values.iter().all(finite) { Ok(solved) } else { Err(EigenError::NotFinite) }
}

/// The eigenvalues alone, at half the cost, in the order of [`Eigen::values`].
///
/// They are those of [`eigen`] to the bit, but for the few matrices that it solves again without balancing.
pub fn eigenvalues<N: Size>(a: &Square<N>) -> Result<OVector<Complex<f64>, N>, EigenError>
where
    DefaultAllocator: Room<N>,
{
    if !a.iter().all(|x| x.is_finite()) {
        return Err(EigenError::NotFinite);
    }
    let scale = power_of_two(a.amax());
    let unit = a / scale;
    let b = Balance::of(&unit).apply(&unit);
    let balanced_scale = power_of_two(b.amax());
    let (q, h) = schur(b / balanced_scale).ok_or(EigenError::NotConverged)?;
    let (_, t) = triangle(&q, &h);
    let mut diagonal = t.diagonal();
    few::sort_by(diagonal.as_mut_slice(), |x, y| y.norm().total_cmp(&x.norm()));
    let values = diagonal.map(|value| value * balanced_scale * scale + Complex::from(0.0));
    let finite = |value: &Complex<f64>| value.re.is_finite() && value.im.is_finite();
    if values.iter().all(finite) { Ok(values) } else { Err(EigenError::NotFinite) }
}

impl<N: Size> Eigen<N>
where
    DefaultAllocator: Room<N>,
{
    /// Whether ‖A v − λ v‖ and ‖Aᵀ l − λ̄ l‖ are below 10⁻¹³‖A‖ for every mode.
    fn satisfies(&self, a: &Square<N>) -> bool {
        let (allowed, a) = (1e-13 * a.norm(), a.map(Complex::from));
        (0..self.values.len()).filter(|&i| self.values[i].im >= 0.0).all(|i| {
            let (value, v, l) = (self.values[i], self.right.column(i), self.left.column(i));
            (&a * v - v * value).norm() <= allowed && (a.tr_mul(&l) - l * value.conj()).norm() <= allowed
        })
    }

    /// One step of inverse iteration for every vector: (A − λ) v' = v and (A − λ)ᴴ l' = l (LAPACK `dhsein`).
    fn refine(&mut self, a: &Square<N>) {
        // Half a rounding error beside λ, so that A − λ can be factored.
        let beside = Complex::from(0.5 * f64::EPSILON * a.norm());
        let ((rows, columns), values) = (a.shape_generic(), self.values.clone());
        for i in (0..values.len()).filter(|&i| values[i].im >= 0.0) {
            let shifted = a.map(Complex::from)
                - OMatrix::<_, N, N>::from_diagonal_element_generic(rows, columns, values[i] + beside);
            let v = shifted.clone().lu().solve(&self.right.column(i));
            let l = shifted.adjoint().lu().solve(&self.left.column(i));
            if let (Some(v), Some(l)) = (v, l) {
                self.set_vectors(i, values[i].im > 0.0, v, l);
            }
        }
    }

    /// Puts v and l, made unit vectors, into column i and if they are of a pair their conjugates into the next.
    fn set_vectors(
        &mut self,
        i: usize,
        pair: bool,
        v: OVector<Complex<f64>, N>,
        l: OVector<Complex<f64>, N>,
    ) {
        let (v, l) = (unit_vector(v, !pair), unit_vector(l, !pair));
        self.right.set_column(i, &v);
        self.left.set_column(i, &l);
        if pair && i + 1 < self.values.len() {
            self.right.set_column(i + 1, &v.conjugate());
            self.left.set_column(i + 1, &l.conjugate());
        }
    }
}

/// A similarity B = D⁻¹ Pᵀ A P D that changes no eigenvalue: P puts `order[i]` at place i, D is diagonal.
struct Balance<N: Size>
where
    DefaultAllocator: Room<N>,
{
    order: OVector<usize, N>,
    d: OVector<f64, N>,
}

impl<N: Size> Balance<N>
where
    DefaultAllocator: Room<N>,
{
    /// That of a matrix which is left as it is.
    fn none(a: &Square<N>) -> Self {
        let rows = a.shape_generic().0;
        Self {
            order: OVector::from_fn_generic(rows, U1, |i, _| i),
            d: OVector::repeat_generic(rows, U1, 1.0),
        }
    }

    /// Permutation and power-of-two scaling that bring rows and columns to like size (LAPACK `dgebal`; GVL §7.5.7).
    ///
    /// As in James, Langou & Lowery (2014) the diagonal counts in the norms, or balancing can do harm.
    fn of(a: &Square<N>) -> Self {
        let Self { mut order, mut d } = Self::none(a);
        let mut b = a.clone();
        // A row (column) with nothing beside its diagonal holds an eigenvalue already: to the end (front) with it.
        let (mut lo, mut end) = (0, a.nrows());
        let alone =
            |b: &Square<N>, i: usize, lo: usize, end: usize| (lo..end).all(|j| j == i || b[(i, j)] == 0.0);
        while let Some(i) = (lo..end).rev().find(|&i| alone(&b, i, lo, end)) {
            end -= 1;
            swap(&mut b, &mut order, i, end);
        }
        while let Some(i) = (lo..end).find(|&i| alone(&b.transpose(), i, lo, end)) {
            swap(&mut b, &mut order, i, lo);
            lo += 1;
        }
        for _ in 0..60 {
            let mut settled = true;
            for i in lo..end {
                let c: f64 = (lo..end).map(|j| b[(j, i)].abs()).sum();
                let r: f64 = (lo..end).map(|j| b[(i, j)].abs()).sum();
                // f ≈ √(r/c), so that c f ≈ r/f
                let f = power_of_two(std::f64::consts::SQRT_2 * (r.sqrt() / c.sqrt()));
                let within = (1e-140..1e140).contains(&(d[i] * f));
                if within && c * f + r / f < 0.95 * (c + r) {
                    b.column_mut(i).scale_mut(f);
                    b.row_mut(i).unscale_mut(f);
                    d[i] *= f;
                    settled = false;
                }
            }
            if settled {
                break;
            }
        }
        Self { order, d }
    }

    fn apply(&self, a: &Square<N>) -> Square<N> {
        let (rows, columns) = a.shape_generic();
        // bᵢⱼ = aᵢⱼ dⱼ/dᵢ
        OMatrix::from_fn_generic(rows, columns, |i, j| {
            a[(self.order[i], self.order[j])] * (self.d[j] / self.d[i])
        })
    }
}

fn swap<N: Size>(b: &mut Square<N>, order: &mut OVector<usize, N>, i: usize, j: usize)
where
    DefaultAllocator: Room<N>,
{
    b.swap_rows(i, j);
    b.swap_columns(i, j);
    order.as_mut_slice().swap(i, j);
}

/// Schur form of the balanced matrix, its eigenvectors, and the way back (LAPACK `dgeev`).
fn solve<N: Size>(a: &Square<N>, balance: &Balance<N>) -> Result<Eigen<N>, EigenError>
where
    DefaultAllocator: Room<N>,
{
    let b = balance.apply(a);
    let scale = power_of_two(b.amax());
    let (q, h) = schur(b / scale).ok_or(EigenError::NotConverged)?;
    let (u, t) = triangle(&q, &h);
    let (rows, columns) = a.shape_generic();
    let mut places = OVector::<usize, N>::from_fn_generic(rows, U1, |i, _| i);
    // The sort is stable and |λ| = |λ̄| to the bit, so pairs stay together.
    few::sort_by(places.as_mut_slice(), |&i, &j| t[(j, j)].norm().total_cmp(&t[(i, i)].norm()));
    let mut solved = Eigen {
        values: places.map(|k| t[(k, k)] * scale),
        right: OMatrix::zeros_generic(rows, columns),
        left: OMatrix::zeros_generic(rows, columns),
    };
    // 10⁻⁷⁰ ‖T‖ of four states: three divisions by it stay far below overflow, the error it makes far below rounding. Of more states as
    // much more that a chain of them all stays a number.
    let least = LEAST_CHAIN.powf(1.0 / a.nrows() as f64);
    for (column, &k) in places.iter().enumerate() {
        let im = solved.values[column].im;
        if im < 0.0 {
            continue; // the conjugate, written with its partner
        }
        let y = &u * rescaled(right_vector(&t, k, least));
        let w = &u * rescaled(left_vector(&t, k, least));
        let zero = || OVector::zeros_generic(rows, U1);
        let (mut v, mut l) = (zero(), zero());
        for i in 0..a.nrows() {
            // v = P D y,  l = P D⁻¹ w
            v[balance.order[i]] = y[i] * balance.d[i];
            l[balance.order[i]] = w[i] / balance.d[i];
        }
        solved.set_vectors(column, im > 0.0, v, l);
    }
    Ok(solved)
}

/// The least product of gaps that a chain of all states may divide by.
const LEAST_CHAIN: f64 = 1e-280;

/// λᵢ − λₖ, moved off zero: equal eigenvalues get vectors that are independent where the matrix has them, else parallel.
fn gap<N: Size>(t: &OMatrix<Complex<f64>, N, N>, i: usize, k: usize, least: f64) -> Complex<f64>
where
    DefaultAllocator: Room<N>,
{
    let gap = t[(i, i)] - t[(k, k)];
    let least = (f64::EPSILON * t[(k, k)].norm()).max(least);
    if gap.norm() < least { Complex::from(least) } else { gap }
}

/// y with T y = λₖ y by back substitution (LAPACK `ztrevc`).
fn right_vector<N: Size>(t: &OMatrix<Complex<f64>, N, N>, k: usize, least: f64) -> OVector<Complex<f64>, N>
where
    DefaultAllocator: Room<N>,
{
    let mut y = OVector::zeros_generic(t.shape_generic().0, U1);
    y[k] = Complex::from(1.0);
    for i in (0..k).rev() {
        // (tᵢᵢ − λ) yᵢ = −Σⱼ tᵢⱼ yⱼ
        let sum: Complex<f64> = (i + 1..=k).map(|j| t[(i, j)] * y[j]).sum();
        y[i] = -sum / gap(t, i, k, least);
    }
    y
}

/// w with wᴴ T = λₖ wᴴ by forward substitution (LAPACK `ztrevc`).
fn left_vector<N: Size>(t: &OMatrix<Complex<f64>, N, N>, k: usize, least: f64) -> OVector<Complex<f64>, N>
where
    DefaultAllocator: Room<N>,
{
    let mut w = OVector::zeros_generic(t.shape_generic().0, U1);
    w[k] = Complex::from(1.0);
    for i in k + 1..t.nrows() {
        // w̄ᵢ (tᵢᵢ − λ) = −Σⱼ w̄ⱼ tⱼᵢ
        let sum: Complex<f64> = (k..i).map(|j| t[(j, i)].conj() * w[j]).sum();
        w[i] = -sum / gap(t, i, k, least).conj();
    }
    w
}

/// v divided by a power of two, so that its largest part is between 1 and 2.
fn rescaled<N: Size>(v: OVector<Complex<f64>, N>) -> OVector<Complex<f64>, N>
where
    DefaultAllocator: Room<N>,
{
    let size = power_of_two(v.iter().map(|x| x.re.abs().max(x.im.abs())).fold(0.0, f64::max));
    v.map(|x| x / size)
}

/// v/‖v‖; for a real eigenvalue v is real but for rounding, and only its real (or imaginary) part kept.
fn unit_vector<N: Size>(v: OVector<Complex<f64>, N>, real: bool) -> OVector<Complex<f64>, N>
where
    DefaultAllocator: Room<N>,
{
    let mut v = rescaled(v);
    if real {
        let (re, im) = (v.map(|x| x.re), v.map(|x| x.im));
        v = if re.norm() >= im.norm() { re } else { im }.map(Complex::from);
    }
    v.unscale(v.norm())
}
