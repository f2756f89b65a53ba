//! Least-squares steps of two equations in many bounded unknowns, for [`super::inverse`].
//!
//! With two equations the normal equations in the space of the equations are 2×2: d = Jᵀ(J Jᵀ + μI)⁻¹ r. Bounds are kept by an
//! active set: what would leave its bounds is put on the bound and the rest solved again.

use nalgebra::{Matrix2, Vector2};

/// Bounds of every unknown; zero lies within all of them.
pub(super) struct Bounds(Vec<(f64, f64)>);

impl Bounds {
    pub fn new(bounds: impl Iterator<Item = (f64, f64)>) -> Self {
        Self(bounds.collect())
    }

    /// Lower and upper bound of unknown k.
    pub fn of(&self, k: usize) -> (f64, f64) {
        self.0.get(k).copied().unwrap_or((0.0, 0.0))
    }

    /// `y` with everything outside its bounds put on them.
    pub fn clamped(&self, y: impl Iterator<Item = f64>) -> Vec<f64> {
        y.zip(&self.0).map(|(y, (lower, upper))| y.max(*lower).min(*upper)).collect()
    }
}

/// The step d that makes ‖J d − r‖² + μ‖d‖² least with y + d within the bounds; J has the columns `rates`.
pub(super) fn damped_step(
    rates: &[Vector2<f64>],
    r: &Vector2<f64>,
    damping: f64,
    y: &[f64],
    bounds: &Bounds,
) -> Vec<f64> {
    let room: Vec<(f64, f64)> =
        y.iter().enumerate().map(|(k, y)| (bounds.of(k).0 - y, bounds.of(k).1 - y)).collect();
    bounded(rates, r, damping, &room)
}

/// The unknowns z of least Σz² with J z = r + J y, to first order where λ is wanted, within the bounds.
pub(super) fn least_change(rates: &[Vector2<f64>], r: &Vector2<f64>, y: &[f64], bounds: &Bounds) -> Vec<f64> {
    let here: Vector2<f64> = rates.iter().zip(y).map(|(rate, y)| rate * *y).sum();
    bounded(rates, &(r + here), 0.0, &bounds.0)
}

/// z of least ‖J z − b‖² + μ‖z‖² (of least ‖z‖ on J z = b if μ = 0) with `room` the bounds of each.
fn bounded(rates: &[Vector2<f64>], b: &Vector2<f64>, damping: f64, room: &[(f64, f64)]) -> Vec<f64> {
    let n = rates.len();
    // Where an unknown is held: on its lower (−1) or upper (1) bound, or free (0).
    let mut held = vec![0_i8; n];
    let mut z = vec![0.0; n];
    let value = |k: usize, held: i8| if held < 0 { room[k].0 } else { room[k].1 };
    for _ in 0..3 * n + 1 {
        let mut rest = *b;
        let mut gram = Matrix2::zeros();
        for k in 0..n {
            match held[k] {
                0 => gram += rates[k] * rates[k].transpose(),
                side => rest -= rates[k] * value(k, side),
            }
        }
        // zₖ = Jₖᵀ ν,  (J Jᵀ + μ) ν = b
        let multiplier = solve_2x2(gram, damping, &rest);
        for k in 0..n {
            z[k] = if held[k] == 0 { rates[k].dot(&multiplier) } else { value(k, held[k]) };
        }
        // The one furthest outside goes onto its bound …
        let outside = |k: usize| (room[k].0 - z[k]).max(z[k] - room[k].1);
        let worst = (0..n).filter(|&k| held[k] == 0).max_by(|&i, &j| outside(i).total_cmp(&outside(j)));
        if let Some(k) = worst.filter(|&k| outside(k) > 0.0) {
            held[k] = if z[k] < room[k].0 { -1 } else { 1 };
            continue;
        }
        // … and if none is, one that is held against its will comes free.
        let pull = |k: usize| f64::from(held[k]) * (value(k, held[k]) - rates[k].dot(&multiplier));
        let freed = (0..n)
            .filter(|&k| held[k] != 0 && pull(k) > 1e-9 * (room[k].1 - room[k].0))
            .max_by(|&i, &j| pull(i).total_cmp(&pull(j)));
        match freed {
            Some(k) => held[k] = 0,
            None => break,
        }
    }
    z.iter().zip(room).map(|(z, (lower, upper))| z.max(*lower).min(*upper)).collect()
}

/// (G + damping)⁻¹ r for the 2×2 matrix G = Σ rates·ratesᵀ; zero where G has no size.
fn solve_2x2(gram: Matrix2<f64>, damping: f64, r: &Vector2<f64>) -> Vector2<f64> {
    // A ridge at rounding keeps a row of zeros (a real root has no imaginary part) from dividing by zero.
    let ridge = damping + 1e-15 * gram.trace();
    let m = gram + Matrix2::identity() * ridge;
    let det = m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)];
    let x = Vector2::new(m[(1, 1)] * r.x - m[(0, 1)] * r.y, m[(0, 0)] * r.y - m[(1, 0)] * r.x) / det;
    if x.x.is_finite() && x.y.is_finite() { x } else { Vector2::zeros() }
}
