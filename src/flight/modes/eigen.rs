//! Eigenvalues and eigenvectors of a real 4×4 matrix, with an answer for every finite matrix.
//!
//! The road is LAPACK's `dgeev` (balance, Hessenberg, QR, eigenvectors of the triangle, back), written out for 4×4
//! and bounded at every loop: a slider at zero makes permutations, Jordan blocks and zero matrices, and a page must
//! not wait for them.
//!
//! Sources: Golub & Van Loan, *Matrix Computations*, 4th ed. (GVL), §7; LAPACK routine names beside the functions.

use super::schur::{power_of_two, schur, triangle};
use nalgebra::{Complex, Matrix4, Vector4};

/// Eigenvalues with right and left eigenvectors of a real 4×4 matrix A.
///
/// The computed values are those of a matrix within rounding of A, but a defective one (a Jordan block of size m)
/// still moves by about (10⁻¹⁶)^(1/m) of its norm: that is the nature of the problem, not of the method.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen {
    /// Eigenvalues λ \[1/s\], largest |λ| first; a conjugate pair is exact, adjacent, positive imaginary part first.
    pub values: [Complex<f64>; 4],
    /// Column i: v with A v = λᵢ v and ‖v‖₂ = 1; real where λᵢ is real, conjugate columns for a conjugate pair.
    pub right: Matrix4<Complex<f64>>,
    /// Column i: l with lᴴ A = λᵢ lᴴ, that is Aᵀ l = λ̄ᵢ l, and ‖l‖₂ = 1; real or conjugate as `right`.
    pub left: Matrix4<Complex<f64>>,
}

/// Why a matrix has no eigenvalues to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EigenError {
    /// An entry is NaN or infinite, or an eigenvalue would be too large for a 64-bit number.
    NotFinite,
    /// The iteration used up its bound; no matrix is known that does this.
    NotConverged,
}

impl Eigen {
    /// Share of each state in a mode: |vₖ lₖ| normalised to sum 1 (Pérez-Arriaga, Verghese & Schweppe 1982).
    ///
    /// Always four finite shares. Where v and l have no state in common (an exactly defective matrix) the mean of |vₖ|² and
    /// |lₖ|² stands in: half where the mode shows, half where it is excited. A `mode` above 3 means the last one.
    pub fn participation(&self, mode: usize) -> [f64; 4] {
        let (v, l) = (self.right.column(mode.min(3)), self.left.column(mode.min(3)));
        // pₖ = |vₖ| |lₖ| / Σ |vᵢ| |lᵢ|
        let products: [f64; 4] = std::array::from_fn(|k| v[k].norm() * l[k].norm());
        let sum: f64 = products.iter().sum();
        if sum > f64::MIN_POSITIVE {
            products.map(|p| p / sum)
        } else {
            std::array::from_fn(|k| 0.5 * (v[k].norm_sqr() + l[k].norm_sqr()))
        }
    }
}

/// Eigenvalues and both sets of eigenvectors of `a`.
///
/// ‖A v − λ v‖ and ‖Aᵀ l − λ̄ l‖ stay below 10⁻¹²‖A‖. Balancing keeps small eigenvalues accurate but can spoil that
/// bound for badly scaled matrices (Watkins 2006): their vectors get a step of inverse iteration, and the few that it
/// does not mend (1 in 6,000 random ones with entries over 16 decades) are solved again without balancing, where small
/// eigenvalues are good to rounding of ‖A‖ only.
pub fn eigen(a: &Matrix4<f64>) -> Result<Eigen, EigenError> {
    if !a.iter().all(|x| x.is_finite()) {
        return Err(EigenError::NotFinite);
    }
    let scale = power_of_two(a.amax());
    let unit = a / scale;
    let mut solved = solve(&unit, &Balance::of(&unit))?;
    if !solved.satisfies(&unit) {
        solved.refine(&unit);
        if !solved.satisfies(&unit) {
            solved = solve(&unit, &Balance::none())?;
        }
    }
    // Adding zero makes −0 a 0.
    solved.values = solved.values.map(|value| value * scale + Complex::from(0.0));
    let finite = |value: &Complex<f64>| value.re.is_finite() && value.im.is_finite();
    if solved.values.iter().all(finite) { Ok(solved) } else { Err(EigenError::NotFinite) }
}

/// The eigenvalues alone, at half the cost, in the order of [`Eigen::values`].
///
/// They are those of [`eigen`] to the bit, but for the few matrices that it solves again without balancing.
pub fn eigenvalues(a: &Matrix4<f64>) -> Result<[Complex<f64>; 4], EigenError> {
    if !a.iter().all(|x| x.is_finite()) {
        return Err(EigenError::NotFinite);
    }
    let scale = power_of_two(a.amax());
    let unit = a / scale;
    let b = Balance::of(&unit).apply(&unit);
    let balanced_scale = power_of_two(b.amax());
    let (q, h) = schur(b / balanced_scale).ok_or(EigenError::NotConverged)?;
    let (_, t) = triangle(&q, &h);
    let mut diagonal: [Complex<f64>; 4] = std::array::from_fn(|i| t[(i, i)]);
    diagonal.sort_by(|x, y| y.norm().total_cmp(&x.norm()));
    let values = diagonal.map(|value| value * balanced_scale * scale + Complex::from(0.0));
    let finite = |value: &Complex<f64>| value.re.is_finite() && value.im.is_finite();
    if values.iter().all(finite) { Ok(values) } else { Err(EigenError::NotFinite) }
}

impl Eigen {
    /// Whether ‖A v − λ v‖ and ‖Aᵀ l − λ̄ l‖ are below 10⁻¹³‖A‖ for every mode.
    fn satisfies(&self, a: &Matrix4<f64>) -> bool {
        let (allowed, a) = (1e-13 * a.norm(), a.map(Complex::from));
        (0..4).filter(|&i| self.values[i].im >= 0.0).all(|i| {
            let (value, v, l) = (self.values[i], self.right.column(i), self.left.column(i));
            (a * v - v * value).norm() <= allowed && (a.tr_mul(&l) - l * value.conj()).norm() <= allowed
        })
    }

    /// One step of inverse iteration for every vector: (A − λ) v' = v and (A − λ)ᴴ l' = l (LAPACK `dhsein`).
    fn refine(&mut self, a: &Matrix4<f64>) {
        // Half a rounding error beside λ, so that A − λ can be factored.
        let beside = Complex::from(0.5 * f64::EPSILON * a.norm());
        let values = self.values;
        for i in (0..4).filter(|&i| values[i].im >= 0.0) {
            let shifted = a.map(Complex::from) - Matrix4::from_diagonal_element(values[i] + beside);
            let v = shifted.lu().solve(&self.right.column(i));
            let l = shifted.adjoint().lu().solve(&self.left.column(i));
            if let (Some(v), Some(l)) = (v, l) {
                self.set_vectors(i, values[i].im > 0.0, v, l);
            }
        }
    }

    /// Puts v and l, made unit vectors, into column i and if they are of a pair their conjugates into the next.
    fn set_vectors(&mut self, i: usize, pair: bool, v: Vector4<Complex<f64>>, l: Vector4<Complex<f64>>) {
        let (v, l) = (unit_vector(v, !pair), unit_vector(l, !pair));
        self.right.set_column(i, &v);
        self.left.set_column(i, &l);
        if pair && i < 3 {
            self.right.set_column(i + 1, &v.conjugate());
            self.left.set_column(i + 1, &l.conjugate());
        }
    }
}

/// A similarity B = D⁻¹ Pᵀ A P D that changes no eigenvalue: P puts `order[i]` at place i, D is diagonal.
struct Balance {
    order: [usize; 4],
    d: [f64; 4],
}

impl Balance {
    fn none() -> Self {
        Self { order: [0, 1, 2, 3], d: [1.0; 4] }
    }

    /// Permutation and power-of-two scaling that bring rows and columns to like size (LAPACK `dgebal`; GVL §7.5.7).
    ///
    /// As in James, Langou & Lowery (2014) the diagonal counts in the norms, or balancing can do harm.
    fn of(a: &Matrix4<f64>) -> Self {
        let Self { mut order, mut d } = Self::none();
        let mut b = *a;
        // A row (column) with nothing beside its diagonal holds an eigenvalue already: to the end (front) with it.
        let (mut lo, mut end) = (0, 4);
        let alone =
            |b: &Matrix4<f64>, i: usize, lo: usize, end: usize| (lo..end).all(|j| j == i || b[(i, j)] == 0.0);
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

    fn apply(&self, a: &Matrix4<f64>) -> Matrix4<f64> {
        // bᵢⱼ = aᵢⱼ dⱼ/dᵢ
        Matrix4::from_fn(|i, j| a[(self.order[i], self.order[j])] * (self.d[j] / self.d[i]))
    }
}

fn swap(b: &mut Matrix4<f64>, order: &mut [usize; 4], i: usize, j: usize) {
    b.swap_rows(i, j);
    b.swap_columns(i, j);
    order.swap(i, j);
}

/// Schur form of the balanced matrix, its eigenvectors, and the way back (LAPACK `dgeev`).
fn solve(a: &Matrix4<f64>, balance: &Balance) -> Result<Eigen, EigenError> {
    let b = balance.apply(a);
    let scale = power_of_two(b.amax());
    let (q, h) = schur(b / scale).ok_or(EigenError::NotConverged)?;
    let (u, t) = triangle(&q, &h);
    let mut places = [0, 1, 2, 3];
    // The sort is stable and |λ| = |λ̄| to the bit, so pairs stay together.
    places.sort_by(|&i, &j| t[(j, j)].norm().total_cmp(&t[(i, i)].norm()));
    let mut solved =
        Eigen { values: places.map(|k| t[(k, k)] * scale), right: Matrix4::zeros(), left: Matrix4::zeros() };
    for (column, &k) in places.iter().enumerate() {
        let im = solved.values[column].im;
        if im < 0.0 {
            continue; // the conjugate, written with its partner
        }
        let y = u * rescaled(right_vector(&t, k));
        let w = u * rescaled(left_vector(&t, k));
        let (mut v, mut l) = (Vector4::zeros(), Vector4::zeros());
        for i in 0..4 {
            // v = P D y,  l = P D⁻¹ w
            v[balance.order[i]] = y[i] * balance.d[i];
            l[balance.order[i]] = w[i] / balance.d[i];
        }
        solved.set_vectors(column, im > 0.0, v, l);
    }
    Ok(solved)
}

/// λᵢ − λₖ, moved off zero: equal eigenvalues get vectors that are independent where the matrix has them, else parallel.
fn gap(t: &Matrix4<Complex<f64>>, i: usize, k: usize) -> Complex<f64> {
    let gap = t[(i, i)] - t[(k, k)];
    // 10⁻⁷⁰ ‖T‖: three divisions by it stay far below overflow, the error it makes far below rounding.
    let least = (f64::EPSILON * t[(k, k)].norm()).max(1e-70);
    if gap.norm() < least { Complex::from(least) } else { gap }
}

/// y with T y = λₖ y by back substitution (LAPACK `ztrevc`).
fn right_vector(t: &Matrix4<Complex<f64>>, k: usize) -> Vector4<Complex<f64>> {
    let mut y = Vector4::zeros();
    y[k] = Complex::from(1.0);
    for i in (0..k).rev() {
        // (tᵢᵢ − λ) yᵢ = −Σⱼ tᵢⱼ yⱼ
        let sum: Complex<f64> = (i + 1..=k).map(|j| t[(i, j)] * y[j]).sum();
        y[i] = -sum / gap(t, i, k);
    }
    y
}

/// w with wᴴ T = λₖ wᴴ by forward substitution (LAPACK `ztrevc`).
fn left_vector(t: &Matrix4<Complex<f64>>, k: usize) -> Vector4<Complex<f64>> {
    let mut w = Vector4::zeros();
    w[k] = Complex::from(1.0);
    for i in k + 1..4 {
        // w̄ᵢ (tᵢᵢ − λ) = −Σⱼ w̄ⱼ tⱼᵢ
        let sum: Complex<f64> = (k..i).map(|j| t[(j, i)].conj() * w[j]).sum();
        w[i] = -sum / gap(t, i, k).conj();
    }
    w
}

/// v divided by a power of two, so that its largest part is between 1 and 2.
fn rescaled(v: Vector4<Complex<f64>>) -> Vector4<Complex<f64>> {
    let size = power_of_two(v.iter().map(|x| x.re.abs().max(x.im.abs())).fold(0.0, f64::max));
    v.map(|x| x / size)
}

/// v/‖v‖; for a real eigenvalue v is real but for rounding, and only its real (or imaginary) part kept.
fn unit_vector(v: Vector4<Complex<f64>>, real: bool) -> Vector4<Complex<f64>> {
    let mut v = rescaled(v);
    if real {
        let (re, im) = (v.map(|x| x.re), v.map(|x| x.im));
        v = if re.norm() >= im.norm() { re } else { im }.map(Complex::from);
    }
    v.unscale(v.norm())
}
