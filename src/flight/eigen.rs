//! Eigenvalues and eigenvectors of a real 4×4 matrix, with an answer for every finite matrix.
//!
//! The road is LAPACK's `dgeev` (balance, Hessenberg, QR, eigenvectors of the triangle, back), written out for 4×4
//! and bounded at every loop: a slider at zero makes permutations, Jordan blocks and zero matrices, and a page must
//! not wait for them.
//!
//! Sources: Golub & Van Loan, *Matrix Computations*, 4th ed. (GVL), §7; LAPACK routine names beside the functions.

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
    #[error("the motion cannot be computed: an entry of the state matrix is not a finite number, or is too large")]
    NotFinite,
    /// The iteration used up its bound; no matrix is known that does this.
    #[error("the eigenvalues of this state matrix could not be found: the iteration did not settle")]
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
/// ‖A v − λ v‖ and ‖Aᵀ l − λ̄ l‖ stay below 10⁻¹²‖A‖: balancing keeps small eigenvalues accurate but can spoil that bound
/// for rare, very badly scaled matrices (Watkins 2006), which are then solved again as they stand.
pub fn eigen(a: &Matrix4<f64>) -> Result<Eigen, EigenError> {
    if !a.iter().all(|x| x.is_finite()) {
        return Err(EigenError::NotFinite);
    }
    let scale = power_of_two(a.amax());
    let unit = a / scale;
    let mut solved = solve(&unit, &Balance::of(&unit))?;
    if solved.residual(&unit) > 1e-13 * unit.norm() {
        solved = solve(&unit, &Balance::none())?;
    }
    solved.values = solved.values.map(|value| value * scale);
    if solved.values.iter().all(|value| value.re.is_finite() && value.im.is_finite()) {
        Ok(solved)
    } else {
        Err(EigenError::NotFinite)
    }
}

/// The largest power of two not above `x` ≥ 0, or the smallest normal number: multiplying by it rounds nothing.
fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
}

impl Eigen {
    /// The largest ‖A v − λ v‖ or ‖Aᵀ l − λ̄ l‖.
    fn residual(&self, a: &Matrix4<f64>) -> f64 {
        let (a, mut largest) = (a.map(Complex::from), 0.0_f64);
        for (i, &value) in self.values.iter().enumerate().filter(|(_, value)| value.im >= 0.0) {
            let (v, l) = (self.right.column(i), self.left.column(i));
            largest = largest.max((a * v - v * value).norm());
            largest = largest.max((a.transpose() * l - l * value.conj()).norm());
        }
        largest
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
        let alone = |b: &Matrix4<f64>, i: usize, lo: usize, end: usize| (lo..end).all(|j| j == i || b[(i, j)] == 0.0);
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
        Matrix4::from_fn(|i, j| a[(self.order[i], self.order[j])] / self.d[i] * self.d[j])
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
    let mut solved = Eigen { values: places.map(|k| t[(k, k)] * scale), right: Matrix4::zeros(), left: Matrix4::zeros() };
    for (column, &k) in places.iter().enumerate() {
        let (v, l) = if t[(k, k)].im < 0.0 && column > 0 {
            (solved.right.column(column - 1).conjugate(), solved.left.column(column - 1).conjugate())
        } else {
            let (y, w) = (u * right_vector(&t, k), u * left_vector(&t, k));
            let (mut v, mut l) = (Vector4::zeros(), Vector4::zeros());
            for i in 0..4 {
                // v = P D y,  l = P D⁻¹ w
                v[balance.order[i]] = y[i] * balance.d[i];
                l[balance.order[i]] = w[i] / balance.d[i];
            }
            let real = t[(k, k)].im == 0.0;
            (unit_vector(v, real), unit_vector(l, real))
        };
        solved.right.set_column(column, &v);
        solved.left.set_column(column, &l);
    }
    Ok(solved)
}

/// Real Schur form H = Q T Qᵀ, T with 1×1 and 2×2 blocks on its diagonal (LAPACK `dhseqr`; GVL Algorithm 7.5.2).
fn schur(mut h: Matrix4<f64>) -> Option<(Matrix4<f64>, Matrix4<f64>)> {
    let mut q = Matrix4::identity();
    for k in 0..2 {
        clear_column(&mut h, &mut q, k, 3);
    }
    let norm = h.amax();
    let (mut hi, mut steps) = (3, 0);
    for _ in 0..160 {
        let mut lo = hi;
        while lo > 0 {
            // |hᵢ,ᵢ₋₁| ≤ ε(|hᵢᵢ| + |hᵢ₋₁,ᵢ₋₁|) counts as zero; beside a zero diagonal, or when slow, so does ε‖H‖.
            let near = h[(lo, lo)].abs() + h[(lo - 1, lo - 1)].abs();
            let size = if near == 0.0 || steps > 40 { norm } else { near };
            if h[(lo, lo - 1)].abs() <= f64::EPSILON * size {
                h[(lo, lo - 1)] = 0.0;
                break;
            }
            lo -= 1;
        }
        if hi - lo >= 2 {
            steps += 1;
            francis(&mut h, &mut q, lo, hi, steps % 10 == 0);
        } else if lo == 0 {
            return Some((q, h));
        } else {
            (hi, steps) = (lo - 1, 0);
        }
    }
    None
}

/// One implicit double-shift QR step on rows `lo..=hi` (LAPACK `dlahqr`, EISPACK `hqr`; GVL Algorithm 7.5.1).
fn francis(h: &mut Matrix4<f64>, q: &mut Matrix4<f64>, lo: usize, hi: usize, exceptional: bool) {
    // The shifts are the eigenvalues of [x √w; √w y]; now and then others, for matrices that the usual ones leave as
    // they are (a permutation).
    let (x, y, w) = if exceptional {
        let s = h[(hi, hi - 1)].abs() + h[(hi - 1, hi - 2)].abs();
        (h[(hi, hi)] + 0.75 * s, h[(hi, hi)] + 0.75 * s, -0.4375 * s * s)
    } else {
        (h[(hi, hi)], h[(hi - 1, hi - 1)], h[(hi, hi - 1)] * h[(hi - 1, hi)])
    };
    // First column of (H − s₁I)(H − s₂I), divided by h₂₁
    let (h11, h21) = (h[(lo, lo)], h[(lo + 1, lo)]);
    let mut bulge = Vector4::zeros();
    bulge[lo] = ((x - h11) * (y - h11) - w) / h21 + h[(lo, lo + 1)];
    bulge[lo + 1] = h11 + h[(lo + 1, lo + 1)] - x - y;
    bulge[lo + 2] = h[(lo + 2, lo + 1)];
    reflect(h, q, bulge, lo);
    for k in lo..hi - 1 {
        clear_column(h, q, k, hi);
    }
}

/// Zeros in column k of H from row k + 2 to row `hi`.
fn clear_column(h: &mut Matrix4<f64>, q: &mut Matrix4<f64>, k: usize, hi: usize) {
    let x = Vector4::from_fn(|i, _| if i > k && i <= hi { h[(i, k)] } else { 0.0 });
    reflect(h, q, x, k + 1);
    (k + 2..=hi).for_each(|i| h[(i, k)] = 0.0);
}

/// H ← P H P and Q ← Q P, where P = I − 2uuᵀ/uᵀu takes `x` to ∓‖x‖ eₖ (Householder; GVL §5.1).
///
/// `x` is zero before place k.
fn reflect(h: &mut Matrix4<f64>, q: &mut Matrix4<f64>, x: Vector4<f64>, k: usize) {
    if (k + 1..4).all(|i| x[i] == 0.0) || !x.amax().is_finite() {
        return;
    }
    let mut u = x / power_of_two(x.amax());
    u[k] += u.norm().copysign(u[k]);
    let tau = 2.0 / u.norm_squared();
    *h -= u * (u.tr_mul(h) * tau);
    *h -= (*h * u) * (u.transpose() * tau);
    *q -= (*q * u) * (u.transpose() * tau);
}

/// Complex Schur form U T Uᴴ from the real one: a rotation for each 2×2 block (MATLAB `rsf2csf`; LAPACK `dlanv2`).
///
/// The diagonal of T is exact where it matters: real, or λ above λ̄ with positive imaginary part.
fn triangle(q: &Matrix4<f64>, h: &Matrix4<f64>) -> (Matrix4<Complex<f64>>, Matrix4<Complex<f64>>) {
    let (mut u, mut t) = (q.map(Complex::from), h.map(Complex::from));
    for i in (0..3).filter(|&i| h[(i + 1, i)] != 0.0) {
        let (a, b, c, d) = (h[(i, i)], h[(i, i + 1)], h[(i + 1, i)], h[(i + 1, i + 1)]);
        // λ = d + z,  z = p ± √(p² + b c),  p = (a − d)/2
        let p = 0.5 * (a - d);
        let size = p.abs().max(b.abs()).max(c.abs());
        let discriminant = (p / size) * p + (b / size) * c;
        let root = size.sqrt() * discriminant.abs().sqrt();
        let z = if discriminant >= 0.0 { Complex::from(p + root.copysign(p)) } else { Complex::new(p, root) };
        let (first, second) = if z.im > 0.0 {
            (Complex::new(d + p, root), Complex::new(d + p, -root))
        } else if z.re == 0.0 {
            (Complex::from(d), Complex::from(d))
        } else {
            (d + z, Complex::from(d - (b / z.re) * c))
        };
        // (z, c) is the block's eigenvector for λ = d + z; G takes it to the first axis.
        let length = z.re.hypot(z.im).hypot(c);
        let (x, y) = (z / length, Complex::from(c / length));
        for j in 0..4 {
            let (upper, lower) = (t[(i, j)], t[(i + 1, j)]);
            t[(i, j)] = x.conj() * upper + y * lower;
            t[(i + 1, j)] = x * lower - y * upper;
        }
        for m in [&mut t, &mut u] {
            for j in 0..4 {
                let (left, right) = (m[(j, i)], m[(j, i + 1)]);
                m[(j, i)] = left * x + right * y;
                m[(j, i + 1)] = right * x.conj() - left * y;
            }
        }
        (t[(i, i)], t[(i + 1, i + 1)], t[(i + 1, i)]) = (first, second, Complex::from(0.0));
    }
    (u, t)
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

/// v/‖v‖ without overflow; for a real eigenvalue v is real but for rounding, and only its real (or imaginary) part kept.
fn unit_vector(v: Vector4<Complex<f64>>, real: bool) -> Vector4<Complex<f64>> {
    let largest = v.iter().map(|x| x.re.abs().max(x.im.abs())).fold(0.0, f64::max);
    let mut v = v.map(|x| x / power_of_two(largest));
    if real {
        let (re, im) = (v.map(|x| x.re), v.map(|x| x.im));
        v = if re.norm() >= im.norm() { re } else { im }.map(Complex::from);
    }
    v.unscale(v.norm())
}
