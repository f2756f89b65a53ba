//! Response of ẋ = A x + B δ(t) from rest, exact at every sample for inputs that are constant between edges.
//!
//! There is no integration step to choose: over a time h with constant δ,
//!
//! ```text
//! x(t + h) = Φ x(t) + Γ δ,     ⎡ Φ  Γ ⎤ = exp ⎛ ⎡ A  B ⎤ h ⎞
//!                              ⎣ 0  1 ⎦       ⎝ ⎣ 0  0 ⎦   ⎠
//! ```
//!
//! (Van Loan 1978, *Computing integrals involving the matrix exponential*).

use super::inputs::Input;
use nalgebra::{Matrix4, Matrix5, Vector4};

/// Where a growing motion stops being shown: some |x| above this many m/s, rad/s or rad.
///
/// Far above anything a small-disturbance model means (an unstable lesson reaches some 10³), far below overflow.
pub const CUT_LIMIT: f64 = 1e9;

/// Steps beyond these are not taken; the response is cut there.
pub const MOST_STEPS: usize = 100_000;

/// When the response is wanted: t_k = k · duration / steps, for k = 0, 1, … steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeGrid {
    /// Time of the last sample \[s\]. Where it is not positive and finite there is only the sample at t = 0.
    pub duration: f64,
    /// Number of steps, one less than the number of samples.
    pub steps: usize,
}

impl TimeGrid {
    /// Time of sample k \[s\].
    pub fn time(&self, k: usize) -> f64 {
        // k · duration first: then t = 1 s falls on 1.0, not beside it, wherever the grid allows.
        k as f64 * self.duration / self.steps as f64
    }
}

/// States at the samples of a [`TimeGrid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// Time between samples \[s\]; zero if there is only one.
    pub dt: f64,
    /// State vector \[u, w, q, θ\] at t_k, from rest at t = 0: finite and within [`CUT_LIMIT`], each of them.
    pub states: Vec<Vector4<f64>>,
    /// Time \[s\] of the first sample left out because the motion had grown beyond [`CUT_LIMIT`] or could not be computed.
    pub cut_at: Option<f64>,
}

/// Response of ẋ = A x + B δ(t), x(0) = 0, to an input that is zero before t = 0.
///
/// An edge between samples is met exactly: its step is split there.
pub fn respond(a: &Matrix4<f64>, b: &Vector4<f64>, input: &Input, grid: TimeGrid) -> Response {
    let rest = Vector4::zeros();
    let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
    let dt = if steps == 0 { 0.0 } else { grid.time(1) };
    let mut response = Response { dt, states: Vec::with_capacity(steps.min(MOST_STEPS) + 1), cut_at: None };
    response.states.push(rest);
    if !input.is_finite() {
        response.cut_at = (steps > 0).then_some(dt);
        return response;
    }
    let whole = Hold::over(a, b, dt);
    let mut edges = input.switches().skip_while(|&(time, _)| time <= 0.0).peekable();
    let (mut x, mut delta) = (rest, input.at(0.0));
    for k in 1..=steps {
        let (mut t, next) = (grid.time(k - 1), grid.time(k));
        if edges.peek().is_some_and(|&(time, _)| time < next) {
            while let Some((time, value)) = edges.next_if(|&(time, _)| time < next) {
                x = Hold::over(a, b, time - t).advance(&x, delta);
                (t, delta) = (time, value);
            }
            x = Hold::over(a, b, next - t).advance(&x, delta);
        } else {
            x = whole.advance(&x, delta);
        }
        // An edge on the sample acts from the next step on.
        while let Some((_, value)) = edges.next_if(|&(time, _)| time == next) {
            delta = value;
        }
        // Written so that NaN is outside too.
        let within = x.iter().all(|value| value.abs() <= CUT_LIMIT);
        if !within || k > MOST_STEPS {
            response.cut_at = Some(next);
            break;
        }
        response.states.push(x);
    }
    response
}

/// State that a constant unit input leads to, −A⁻¹ B; it is reached only if every mode decays. `None` if A is singular.
pub fn steady_state(a: &Matrix4<f64>, b: &Vector4<f64>) -> Option<Vector4<f64>> {
    a.full_piv_lu().solve(&-b).filter(|x| x.iter().all(|value| value.is_finite()))
}

/// Motion over a time with constant input.
struct Hold {
    phi: Matrix4<f64>,
    gamma: Vector4<f64>,
}

impl Hold {
    fn over(a: &Matrix4<f64>, b: &Vector4<f64>, h: f64) -> Self {
        let mut block = Matrix5::zeros();
        block.fixed_view_mut::<4, 4>(0, 0).copy_from(a);
        block.fixed_view_mut::<4, 1>(0, 4).copy_from(b);
        let block = exponential(&(block * h));
        Self {
            phi: block.fixed_view::<4, 4>(0, 0).into_owned(),
            gamma: block.fixed_view::<4, 1>(0, 4).into_owned(),
        }
    }

    fn advance(&self, x: &Vector4<f64>, delta: f64) -> Vector4<f64> {
        self.phi * x + self.gamma * delta
    }
}

/// e^M by scaling, a diagonal Padé approximant of degree 6, and squaring (Golub & Van Loan, Algorithm 9.3.1).
///
/// With ‖M/2ˢ‖ ≤ ½ the approximant is that of a matrix within 4·10⁻¹⁶ of M. At most 1,025 squarings; what overflows, or was
/// not finite, comes back as entries that are not finite. (nalgebra's `exp` squares 2⁶⁴ times for an infinite entry.)
fn exponential(m: &Matrix5<f64>) -> Matrix5<f64> {
    let norm = m.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    if !(norm.is_finite() && m.iter().all(|x| x.is_finite())) {
        return Matrix5::from_element(f64::NAN);
    }
    let mut squarings = 0;
    let mut scaled = *m;
    let mut left = norm;
    while left > 0.5 {
        left *= 0.5;
        scaled *= 0.5;
        squarings += 1;
    }
    // N = Σ cⱼ Mʲ, D = Σ cⱼ (−M)ʲ, cⱼ = cⱼ₋₁ (q − j + 1)/(j (2q − j + 1)); even powers E, odd powers O: (E − O) e^M = E + O
    let (square, identity) = (scaled * scaled, Matrix5::identity());
    let fourth = square * square;
    let even =
        identity + square * (5.0 / 44.0) + fourth * (1.0 / 792.0) + square * fourth * (1.0 / 665_280.0);
    let odd = scaled * (identity * 0.5 + square * (1.0 / 66.0) + fourth * (1.0 / 15_840.0));
    let Some(mut result) = (even - odd).lu().solve(&(even + odd)) else {
        return Matrix5::from_element(f64::NAN);
    };
    for _ in 0..squarings {
        result *= result;
    }
    result
}
