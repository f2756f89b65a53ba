//! Schur form of a real matrix: the iteration behind the eigenvalues, bounded and written out.
//!
//! nalgebra's own may run forever on the companion matrix of s⁴ + 1 and, with a limit, gives up on permutations; this one
//! takes LAPACK's exceptional shifts.

use nalgebra::allocator::Allocator;
use nalgebra::{Complex, DefaultAllocator, Dim, DimMin, OMatrix, OVector, U1};

/// Steps of the iteration for each eigenvalue; two or three are usual, LAPACK allows 30.
const MOST_STEPS: usize = 100;

/// Room for matrices and vectors of a size: of four states, which is known when the program is built, or of any.
pub trait Room<N: Dim>: Allocator<N, N> + Allocator<N> + Allocator<U1, N> {}

impl<N: Dim, A: Allocator<N, N> + Allocator<N> + Allocator<U1, N>> Room<N> for A {}

/// A square matrix of real numbers.
pub type Square<N> = OMatrix<f64, N, N>;

/// A size of matrices that are solved.
pub trait Size: DimMin<Self, Output = Self> {}

impl<N: DimMin<N, Output = N>> Size for N {}

/// Real Schur form H = Q T Qᵀ, T with 1×1 and 2×2 blocks on its diagonal (LAPACK `dhseqr`; GVL Algorithm 7.5.2).
pub(super) fn schur<N: Size>(mut h: Square<N>) -> Option<(Square<N>, Square<N>)>
where
    DefaultAllocator: Room<N>,
{
    let (n, (rows, columns)) = (h.nrows(), h.shape_generic());
    let mut q = OMatrix::identity_generic(rows, columns);
    for k in 0..n.saturating_sub(2) {
        clear_column(&mut h, &mut q, k, n - 1);
    }
    let norm = h.amax();
    let (mut hi, mut steps) = (n.checked_sub(1)?, 0);
    for _ in 0..MOST_STEPS * n {
        let mut lo = hi;
        while lo > 0 {
            // |hᵢ,ᵢ₋₁| ≤ ε(|hᵢᵢ| + |hᵢ₋₁,ᵢ₋₁|) counts as zero; beside a zero diagonal, or when slow, so does ε‖H‖.
            let near = h[(lo, lo)].abs() + h[(lo - 1, lo - 1)].abs();
            let strict = near > 0.0 && steps <= 40;
            if h[(lo, lo - 1)].abs() <= f64::EPSILON * if strict { near } else { norm } {
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
fn francis<N: Size>(h: &mut Square<N>, q: &mut Square<N>, lo: usize, hi: usize, exceptional: bool)
where
    DefaultAllocator: Room<N>,
{
    // The shifts are the eigenvalues of [x √w; √w y]; now and then others, for matrices that the usual ones leave as
    // they are (a permutation).
    let (mut x, mut y) = (h[(hi, hi)], h[(hi - 1, hi - 1)]);
    let mut w = h[(hi, hi - 1)] * h[(hi - 1, hi)];
    if exceptional {
        let s = h[(hi, hi - 1)].abs() + h[(hi - 1, hi - 2)].abs();
        (x, y, w) = (x + 0.75 * s, x + 0.75 * s, -0.4375 * s * s);
    }
    // First column of (H − s₁I)(H − s₂I), divided by h₂₁
    let (h11, h21) = (h[(lo, lo)], h[(lo + 1, lo)]);
    let mut bulge = OVector::zeros_generic(h.shape_generic().0, U1);
    bulge[lo] = ((x - h11) * (y - h11) - w) / h21 + h[(lo, lo + 1)];
    bulge[lo + 1] = h11 + h[(lo + 1, lo + 1)] - x - y;
    bulge[lo + 2] = h[(lo + 2, lo + 1)];
    reflect(h, q, bulge, lo);
    for k in lo..hi - 1 {
        // The bulge is three rows high.
        clear_column(h, q, k, hi.min(k + 3));
    }
}

/// Zeros in column k of H from row k + 2 to row `hi`.
fn clear_column<N: Size>(h: &mut Square<N>, q: &mut Square<N>, k: usize, hi: usize)
where
    DefaultAllocator: Room<N>,
{
    let x = OVector::from_fn_generic(
        h.shape_generic().0,
        U1,
        |i, _| {
            if i > k && i <= hi { h[(i, k)] } else { 0.0 }
        },
    );
    reflect(h, q, x, k + 1);
    (k + 2..=hi).for_each(|i| h[(i, k)] = 0.0);
}

/// H ← P H P and Q ← Q P, where P = I − 2uuᵀ/uᵀu takes `x` to ∓‖x‖ eₖ (Householder; GVL §5.1).
///
/// `x` is zero before place k.
fn reflect<N: Size>(h: &mut Square<N>, q: &mut Square<N>, x: OVector<f64, N>, k: usize)
where
    DefaultAllocator: Room<N>,
{
    if (k + 1..x.len()).all(|i| x[i] == 0.0) || !x.amax().is_finite() {
        return;
    }
    let size = power_of_two(x.amax());
    let mut u = x / size;
    u[k] += u.norm().copysign(u[k]);
    let tau = 2.0 / u.norm_squared();
    let row = u.transpose() * tau;
    *h -= &u * (u.tr_mul(h) * tau);
    *h -= (&*h * &u) * &row;
    *q -= (&*q * &u) * &row;
}

/// U and T of a complex Schur form.
type Triangle<N> = (OMatrix<Complex<f64>, N, N>, OMatrix<Complex<f64>, N, N>);

/// Complex Schur form U T Uᴴ from the real one: a rotation for each 2×2 block (MATLAB `rsf2csf`; LAPACK `dlanv2`).
///
/// The diagonal of T is exact where it matters: real, or λ above λ̄ with positive imaginary part.
pub(super) fn triangle<N: Size>(q: &Square<N>, h: &Square<N>) -> Triangle<N>
where
    DefaultAllocator: Room<N>,
{
    let n = h.nrows();
    let (mut u, mut t) = (q.map(Complex::from), h.map(Complex::from));
    for i in (0..n.saturating_sub(1)).filter(|&i| h[(i + 1, i)] != 0.0) {
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
        for j in 0..n {
            let (upper, lower) = (t[(i, j)], t[(i + 1, j)]);
            t[(i, j)] = x.conj() * upper + y * lower;
            t[(i + 1, j)] = x * lower - y * upper;
        }
        for m in [&mut t, &mut u] {
            for j in 0..n {
                let (left, right) = (m[(j, i)], m[(j, i + 1)]);
                m[(j, i)] = left * x + right * y;
                m[(j, i + 1)] = right * x.conj() - left * y;
            }
        }
        (t[(i, i)], t[(i + 1, i + 1)], t[(i + 1, i)]) = (first, second, Complex::from(0.0));
    }
    (u, t)
}

/// The largest power of two not above `x` ≥ 0, or the smallest normal number: multiplying by it rounds nothing.
pub(super) fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
}
