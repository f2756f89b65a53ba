//! Integration of ẏ = f(t, y) where f is smooth: the Runge–Kutta pair of Dormand & Prince, order 5 with error control by
//! order 4 and an interpolant between the steps (*J. Comput. Appl. Math.* 6, 1980; Hairer, Nørsett & Wanner, *Solving
//! Ordinary Differential Equations I*, §II.4–6), from the crate `differential-equations`.

use differential_equations::interpolate::Interpolation;
use differential_equations::methods::{DormandPrince, ExplicitRungeKutta, Ordinary};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status;

/// Error that a step may make in each number y: this much of its size, and this much in its unit.
///
/// The step's error is estimated from the pair, and its root mean square over the numbers kept below. Errors of the steps
/// add up as the motion lets them: a flight of 8 s agrees with SciPy to 10⁻⁶ m/s and 10⁻⁷ rad, a body that tumbles for a
/// minute gains some 10⁻⁶ of its energy (`tests/six_dof_laws.rs`).
pub const STEP_ERROR: f64 = 1e-9;

/// Longest step \[s\], so that no excursion is stepped over.
const LONGEST_STEP: f64 = 0.5;

/// First step tried \[s\], short beside every motion of an aircraft; the error estimate takes over from there.
const FIRST_STEP: f64 = 1e-3;

/// Shortest step \[s\]: what wants less cannot be followed.
const SHORTEST_STEP: f64 = 1e-10;

/// An integration from one time to another, step by step.
pub struct Integrator<F, const N: usize> {
    system: System<F>,
    method: ExplicitRungeKutta<Ordinary, DormandPrince, f64, [f64; N], 5, 7, 7>,
    end: f64,
}

struct System<F>(F);

impl<F: Fn(f64, &[f64; N]) -> [f64; N], const N: usize> ODE<f64, [f64; N]> for System<F> {
    fn diff(&self, t: f64, y: &[f64; N], rate: &mut [f64; N]) {
        *rate = (self.0)(t, y);
    }
}

impl<F: Fn(f64, &[f64; N]) -> [f64; N], const N: usize> Integrator<F, N> {
    /// At `start`, where `y` is; `end` is later. Each step may err by `step_error`, as with [`STEP_ERROR`]. `None` if there is
    /// no time between them.
    pub fn new(rate: F, start: f64, end: f64, y: &[f64; N], step_error: f64) -> Option<Self> {
        let first = FIRST_STEP.min(end - start);
        let mut method = ExplicitRungeKutta::dopri5()
            .rtol(step_error)
            .atol(step_error)
            .h0(first)
            .h_max(LONGEST_STEP)
            .max_steps(usize::MAX);
        let system = System(rate);
        method.init(&system, start, end, y).ok()?;
        Some(Self { system, method, end })
    }

    /// Time reached \[s\].
    pub fn time(&self) -> f64 {
        self.method.t()
    }

    /// Where y is there.
    pub fn state(&self) -> [f64; N] {
        *self.method.y()
    }

    /// Whether the end is reached, to the rounding of the times.
    pub fn is_done(&self) -> bool {
        self.end - self.time() <= 4.0 * f64::EPSILON * self.end.abs()
    }

    /// Tries one step: whether it was taken, or else is to be tried again shorter; `None` if there is no step short enough.
    pub fn try_step(&mut self) -> Option<bool> {
        let left = self.end - self.method.t();
        let last = self.method.h() >= left;
        if last {
            self.method.set_h(left);
        }
        if !last && self.method.h() < SHORTEST_STEP {
            return None;
        }
        self.method.step(&self.system).ok()?;
        Some(!matches!(self.method.status(), Status::RejectedStep))
    }

    /// y at a time within the last step; its order is one less than that of the step.
    pub fn at(&mut self, t: f64) -> Option<[f64; N]> {
        self.method.interpolate(t).ok()
    }
}
