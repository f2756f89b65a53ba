//! Motion of an aircraft under a law, exact at every sample by the same means as without one (see
//! [`response`](crate::flight::motion::response)): the path is two more states.

use nalgebra::{Complex, DMatrix, DVector, Vector2, Vector4};

use super::closed_model::ClosedModel;
use super::loop_modes::LoopMode;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::response::{
    CUT_LIMIT, DrivenSystem, Forcing, MOST_PARTS, MOST_STEPS, NODES, PART, Response, TimeGrid, march,
};

/// States of a motion under a law at the samples of a [`TimeGrid`].
#[derive(Clone, Debug, PartialEq)]
pub struct LoopResponse {
    /// Time between samples \[s\]; zero if there is only one.
    pub dt: f64,
    /// The four states of the aircraft and those appended at t_k: finite and within [`CUT_LIMIT`], each of them.
    pub states: Vec<DVector<f64>>,
    /// Coordinates of the path at t_k; likewise.
    pub path: Vec<Vector2<f64>>,
    /// What the law moves each control by at t_k, in the unit of the input.
    pub controls: Vec<Vector2<f64>>,
    /// Time \[s\] of the first sample left out.
    pub cut_at: Option<f64>,
}

impl LoopResponse {
    /// The same of the aircraft's four states.
    pub fn as_of_aircraft(&self) -> Response {
        Response {
            dt: self.dt,
            states: self.states.iter().map(|x| Vector4::from_fn(|k, _| x[k])).collect(),
            path: self.path.clone(),
            cut_at: self.cut_at,
        }
    }
}

impl LoopMode {
    /// Whether the part of this mode reaches a share of the whole in one of the aircraft's states at the samples of a motion. All do
    /// where it can't be told from another.
    pub fn shows(&self, response: &LoopResponse, share: f64) -> bool {
        let overlap = self.adjoint.dotc(&self.shape);
        // x = Σ v (lᴴx)/(lᴴv), a conjugate pair twice the real part
        let twice = if self.mode.is_oscillatory() { 2.0 } else { 1.0 };
        let (mut parts, mut whole) = ([0.0_f64; 4], [0.0_f64; 4]);
        for x in &response.states {
            let coordinate = self.adjoint.dotc(&x.map(Complex::from)) / overlap;
            for k in 0..4 {
                parts[k] = parts[k].max((twice * (self.shape[k] * coordinate).re).abs());
                whole[k] = whole[k].max(x[k].abs());
            }
        }
        !overlap.norm().is_normal() || (0..4).any(|k| whole[k] > 0.0 && parts[k] >= share * whole[k])
    }
}

/// Motion of the aircraft of `forced` under a law, from a state of all.
///
/// `forced` drives the four states; its own start counts only for the path.
pub fn respond_closed(
    closed: &ClosedModel,
    forced: &DrivenSystem,
    start: &DVector<f64>,
    grid: TimeGrid,
) -> LoopResponse {
    let n = closed.size();
    let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
    let dt = if steps == 0 { 0.0 } else { grid.time(1) };
    let mut at = DVector::zeros(n + 2);
    let startable = start.iter().chain(&forced.start_path).all(|x| x.abs() <= CUT_LIMIT);
    if startable {
        at.rows_mut(0, n).copy_from(start);
        at.rows_mut(n, 2).copy_from(&forced.start_path);
    }
    let samples = steps.min(MOST_STEPS) + 1;
    let mut kept = vec![at.clone()];
    kept.reserve(samples);
    let mut cut_at = None;
    if !startable || !forced.forcings.iter().all(Forcing::is_finite) {
        cut_at = (steps > 0).then_some(dt);
    } else {
        let system = System::of(closed, forced);
        let edges = forced.forcings.iter().flat_map(|forcing| forcing.input.edges()).collect();
        cut_at = march(
            edges,
            grid,
            at,
            |length| Step::over(&system, length),
            |step, from, t| step.advance(&system, from, t),
            |place: &DVector<f64>| {
                let within = place.iter().all(|value| value.abs() <= CUT_LIMIT);
                if within {
                    kept.push(place.clone());
                }
                within
            },
        )
        .or(cut_at);
    }
    let states: Vec<DVector<f64>> = kept.iter().map(|place| place.rows(0, n).into_owned()).collect();
    let rows = closed.controls();
    let felt: Vec<Vector2<f64>> = forced.forcings.iter().map(|forcing| closed.felt(forcing)).collect();
    let control = |input: usize, x: &DVector<f64>, t: f64| {
        let (row, at_once) = &rows[input];
        let parts = forced.forcings.iter().zip(&felt);
        let of_air: f64 = parts.map(|(forcing, felt)| felt[input] * forcing.input.at(t)).sum();
        row.tr_dot(x) + if *at_once { of_air } else { 0.0 }
    };
    let of_sample = |(k, x): (usize, &DVector<f64>)| {
        let t = k as f64 * dt;
        Vector2::new(control(0, x, t), control(1, x, t))
    };
    let controls = states.iter().enumerate().map(of_sample).collect();
    let path = kept.iter().map(|place| Vector2::new(place[n], place[n + 1])).collect();
    LoopResponse { dt, states, path, controls, cut_at }
}

/// ẋ = A x + Σ (b δ + ḃ δ̇), the path among the states.
struct System<'a> {
    a: DMatrix<f64>,
    driven: Vec<(&'a Input, DVector<f64>, DVector<f64>)>,
}

impl<'a> System<'a> {
    fn of(closed: &ClosedModel, forced: &'a DrivenSystem) -> Self {
        let n = closed.size();
        let mut a = DMatrix::zeros(n + 2, n + 2);
        a.view_mut((0, 0), (n, n)).copy_from(&closed.a);
        a.view_mut((n, 0), (2, 4)).copy_from(&forced.path.of_states);
        a.view_mut((n, n), (2, 2)).copy_from(&forced.path.of_path);
        let driven = forced.forcings.iter().map(|forcing| {
            let [column, rate] = closed.columns(forcing).map(|column| column.resize_vertically(n + 2, 0.0));
            (&forcing.input, column, rate)
        });
        Self { a, driven: driven.collect() }
    }
}

/// Motion over a length of time.
struct Step {
    phi: DMatrix<f64>,
    length: f64,
    gains: Vec<Gain>,
}

/// What one forcing does during a step.
enum Gain {
    /// Γ, for an input that is constant meanwhile.
    Held(DVector<f64>),
    /// For a smooth input, at each node: its time from the beginning, and what a unit of the input and of its rate add.
    Smooth(Vec<(f64, DVector<f64>, DVector<f64>)>),
}

impl Step {
    fn over(system: &System<'_>, length: f64) -> Self {
        let gains = system.driven.iter().map(|(input, column, rate_column)| {
            if input.is_constant_between_edges() {
                Gain::Held(held_gain(&system.a, column, length))
            } else {
                Gain::Smooth(smooth_gain(&system.a, input, [column, rate_column], length))
            }
        });
        Self { phi: exponential(&(&system.a * length)), length, gains: gains.collect() }
    }

    fn advance(&self, system: &System<'_>, from: &DVector<f64>, t: f64) -> DVector<f64> {
        let mut to = &self.phi * from;
        for (gain, (input, ..)) in self.gains.iter().zip(&system.driven) {
            match gain {
                // In the middle, so that rounding puts no edge on the wrong side.
                Gain::Held(gain) => to.axpy(input.at(t + 0.5 * self.length), gain, 1.0),
                Gain::Smooth(nodes) => {
                    for (after, of_value, of_rate) in nodes {
                        to.axpy(input.at(t + after), of_value, 1.0);
                        to.axpy(input.rate(t + after), of_rate, 1.0);
                    }
                }
            }
        }
        to
    }
}

/// Γ = ∫₀ʰ e^{As} b ds, the last column of the exponential of ⎡A b; 0 0⎤ h.
fn held_gain(a: &DMatrix<f64>, column: &DVector<f64>, length: f64) -> DVector<f64> {
    let n = a.nrows();
    let mut block = a.clone().resize(n + 1, n + 1, 0.0);
    block.view_mut((0, n), (n, 1)).copy_from(column);
    exponential(&(block * length)).view((0, n), (n, 1)).column(0).into_owned()
}

fn smooth_gain(
    a: &DMatrix<f64>,
    input: &Input,
    [column, rate_column]: [&DVector<f64>; 2],
    length: f64,
) -> Vec<(f64, DVector<f64>, DVector<f64>)> {
    let fastest = speed_of(a) + input.highest_frequency();
    let parts = (fastest * length / PART).ceil().clamp(1.0, MOST_PARTS).max(1.0);
    let part = length / parts;
    let mut nodes = Vec::with_capacity(NODES.len() * parts as usize);
    for k in 0..parts as usize {
        for (node, weight) in NODES {
            let after = (k as f64 + node) * part;
            let onward = exponential(&(a * (length - after))) * (weight * part);
            nodes.push((after, &onward * column, &onward * rate_column));
        }
    }
    nodes
}

/// A bound on the largest |λ| that is near it: ‖A⁸‖^⅛ (Gelfand).
fn speed_of(a: &DMatrix<f64>) -> f64 {
    let scale = a.norm();
    if !(scale > 0.0 && scale.is_finite()) {
        return 0.0;
    }
    let square = (a / scale) * (a / scale);
    let fourth = &square * &square;
    scale * (&fourth * &fourth).norm().powf(0.125)
}

/// e^M by scaling, a diagonal Padé approximant of degree 6, and squaring, as of four states: at most 1,025 squarings, and what
/// overflows or was not finite comes back as entries that are not finite.
pub(super) fn exponential(m: &DMatrix<f64>) -> DMatrix<f64> {
    let n = m.nrows();
    let nothing = || DMatrix::from_element(n, n, f64::NAN);
    let norm = m.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    if !(norm.is_finite() && m.iter().all(|x| x.is_finite())) {
        return nothing();
    }
    let (mut squarings, mut scaled, mut left) = (0, m.clone(), norm);
    while left > 0.5 {
        left *= 0.5;
        scaled *= 0.5;
        squarings += 1;
    }
    let (square, identity) = (&scaled * &scaled, DMatrix::<f64>::identity(n, n));
    let fourth = &square * &square;
    let even =
        &identity + &square * (5.0 / 44.0) + &fourth * (1.0 / 792.0) + &square * &fourth * (1.0 / 665_280.0);
    let odd = &scaled * (identity * 0.5 + square * (1.0 / 66.0) + fourth * (1.0 / 15_840.0));
    let Some(mut result) = (&even - &odd).lu().solve(&(even + odd)) else { return nothing() };
    for _ in 0..squarings {
        result = &result * &result;
    }
    result
}
