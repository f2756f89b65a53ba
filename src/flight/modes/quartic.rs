//! The characteristic polynomial, and its roots from a good guess: what following poles takes, at a tenth of the solver's cost.
//!
//! λ⁴ + Bλ³ + Cλ² + Dλ + E = (λ² + b₁λ + c₁)(λ² + b₂λ + c₂) by Newton's method in b₁ and c₁, all in real numbers (Bairstow 1914;
//! Press et al., *Numerical Recipes*, 3rd ed., §9.5). Whatever factors it comes to, their roots are those of the polynomial. Where a
//! root of one factor meets one of the other it doesn't settle, and there is no answer: that is for [`eigenvalues`](super::eigen).

use crate::few;
use std::ops::Range;

use nalgebra::{Complex, Matrix4};

/// Steps of Newton's method; three or four are usual.
const MOST_STEPS: usize = 10;

/// The factors are found where their product is the polynomial to this fraction of the terms of each coefficient.
const FOUND: f64 = 1e-14;

/// Largest entries whose fourth powers are numbers.
const SIZES: Range<f64> = 1e-60..1e60;

/// B, C, D, E of the characteristic polynomial λ⁴ + Bλ³ + Cλ² + Dλ + E by principal minors, whose terms are the same in all units.
pub fn polynomial(a: &Matrix4<f64>) -> [f64; 4] {
    // The minor of two rows and two columns
    let minor = |[i, j]: [usize; 2], [k, l]: [usize; 2]| a[(i, k)] * a[(j, l)] - a[(i, l)] * a[(j, k)];
    let two = |i, j| minor([i, j], [i, j]);
    // Expanded along the first row
    let three = |i, j, k| {
        a[(i, i)] * two(j, k) - a[(i, j)] * minor([j, k], [i, k]) + a[(i, k)] * minor([j, k], [i, j])
    };
    // Expanded along the first two rows (Laplace)
    let four = |columns: [usize; 2], others: [usize; 2]| minor([0, 1], columns) * minor([2, 3], others);
    let determinant =
        four([0, 1], [2, 3]) - four([0, 2], [1, 3]) + four([0, 3], [1, 2]) + four([1, 2], [0, 3])
            - four([1, 3], [0, 2])
            + four([2, 3], [0, 1]);
    [
        -a.trace(),
        two(0, 1) + two(0, 2) + two(0, 3) + two(1, 2) + two(1, 3) + two(2, 3),
        -(three(0, 1, 2) + three(0, 1, 3) + three(0, 2, 3) + three(1, 2, 3)),
        determinant,
    ]
}

/// The roots of the characteristic polynomial of `a`, sought from those of a similar matrix; the largest first, pairs adjacent with the
/// positive imaginary part first. `None` where Newton's method doesn't settle.
pub(super) fn roots_near(a: &Matrix4<f64>, guess: &[Complex<f64>; 4]) -> Option<[Complex<f64>; 4]> {
    if !SIZES.contains(&a.amax()) {
        return None;
    }
    let [b, c, d, e] = polynomial(a);
    let (mut b1, mut c1) = slow_factor(guess);
    for _ in 0..MOST_STEPS {
        let b2 = b - b1;
        let c2 = c - c1 - b1 * b2;
        // What is left of D and E
        let (rest_d, rest_e) = (d - b1 * c2 - b2 * c1, e - c1 * c2);
        let terms = c.abs() + c1.abs() + (b1 * b2).abs();
        let found_d = rest_d.abs() <= FOUND * (d.abs() + b1.abs() * terms + (b2 * c1).abs());
        if found_d && rest_e.abs() <= FOUND * (e.abs() + c1.abs() * terms) {
            let ([x, y], [z, w]) = (quadratic_roots(b1, c1), quadratic_roots(b2, c2));
            let mut roots = [x, y, z, w];
            few::sort_by(&mut roots, |x, y| y.norm_sqr().total_cmp(&x.norm_sqr()));
            return Some(roots);
        }
        // [c₂ − c₁ + b₁(b₁ − b₂), b₂ − b₁; c₁(b₁ − b₂), c₂ − c₁] [Δb₁; Δc₁] = [rest of D; rest of E]
        let (db, dc) = (b1 - b2, c2 - c1);
        let corner = dc + b1 * db;
        let determinant = corner * dc + c1 * db * db;
        (b1, c1) = (
            b1 + (rest_d * dc + rest_e * db) / determinant,
            c1 + (rest_e * corner - rest_d * c1 * db) / determinant,
        );
    }
    None
}

/// b and c of (λ − λ₁)(λ − λ₂) = λ² + bλ + c for the slower of two pairs of roots; real roots are paired in their order.
fn slow_factor(roots: &[Complex<f64>; 4]) -> (f64, f64) {
    let mut slow = (0.0, f64::INFINITY);
    let mut single: Option<f64> = None;
    for root in roots {
        let factor = if root.im > 0.0 {
            (-2.0 * root.re, root.norm_sqr())
        } else if root.im < 0.0 {
            continue;
        } else if let Some(other) = single.take() {
            (-(other + root.re), other * root.re)
        } else {
            single = Some(root.re);
            continue;
        };
        if factor.1.abs() < slow.1.abs() {
            slow = factor;
        }
    }
    slow
}

/// The roots of λ² + bλ + c.
fn quadratic_roots(b: f64, c: f64) -> [Complex<f64>; 2] {
    let half = -0.5 * b;
    let discriminant = half * half - c;
    if discriminant < 0.0 {
        let im = (-discriminant).sqrt();
        return [Complex::new(half, im), Complex::new(half, -im)];
    }
    // The product of the two is c, which loses no digits.
    let large = half + discriminant.sqrt().copysign(half);
    let small = if large == 0.0 { 0.0 } else { c / large };
    [Complex::from(large), Complex::from(small)]
}
