//! Schur form of a real 4×4 matrix: the iteration behind the eigenvalues, bounded and written out.
//!
//! nalgebra's own may run forever on the companion matrix of s⁴ + 1 and, with a limit, gives up on permutations; this one
//! takes LAPACK's exceptional shifts.

use nalgebra::{Complex, Matrix4, Vector4};

/// Real Schur form H = Q T Qᵀ, T with 1×1 and 2×2 blocks on its diagonal (LAPACK `dhseqr`; GVL Algorithm 7.5.2).
pub(super) fn schur(mut h: Matrix4<f64>) -> Option<(Matrix4<f64>, Matrix4<f64>)> {
    let mut q = Matrix4::identity();
    for k in 0..2 {
        clear_column(&mut h, &mut q, k, 3);
    }
    let norm = h.amax();
    let (mut hi, mut steps) = (3, 0);
    for _ in 0..300 {
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
fn francis(h: &mut Matrix4<f64>, q: &mut Matrix4<f64>, lo: usize, hi: usize, exceptional: bool) {
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
pub(super) fn triangle(q: &Matrix4<f64>, h: &Matrix4<f64>) -> (Matrix4<Complex<f64>>, Matrix4<Complex<f64>>) {
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

/// The largest power of two not above `x` ≥ 0, or the smallest normal number: multiplying by it rounds nothing.
pub(super) fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
}
