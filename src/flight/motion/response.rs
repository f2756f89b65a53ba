//! Response of ẋ = A x + b δ(t) + ḃ δ̇(t), exact at every sample.
//!
//! Over a time h with constant δ
//!
//! ```text
//! x(t + h) = Φ x(t) + Γ δ,     ⎡ Φ  Γ ⎤ = exp ⎛ ⎡ A  b ⎤ h ⎞
//!                              ⎣ 0  1 ⎦       ⎝ ⎣ 0  0 ⎦   ⎠
//! ```
//!
//! (Van Loan 1978, *Computing integrals involving the matrix exponential*). There is no integration step to choose. An input
//! that is smooth between its edges is integrated against the same exponential,
//!
//! ```text
//! x(t + h) = Φ x(t) + ∫₀ʰ e^{A(h − s)} (b δ(t + s) + ḃ δ̇(t + s)) ds,
//! ```
//!
//! by Gauss and Legendre's rule of six points, on parts of the step so short that its error is below rounding. No eigenvectors
//! are used, so repeated roots are no special case.

use nalgebra::{Matrix2, Matrix2x4, Matrix4, SMatrix, Vector2, Vector4};

use super::command::Command;
use super::inputs::Input;

/// Where a growing motion stops being shown: some |x| above this many m/s, rad/s, rad or m.
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

/// How the two coordinates of the path (see [`super::path_rates`]) follow from the states: ṗ = K x + P p.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PathRates {
    /// K.
    pub of_states: Matrix2x4<f64>,
    /// P.
    pub of_path: Matrix2<f64>,
}

/// One input and the columns by which it enters.
#[derive(Clone, Debug, PartialEq)]
pub struct Forcing {
    /// b: rates of the states for a unit of the input.
    pub column: Vector4<f64>,
    /// ḃ: rates of the states for a unit of the input's rate of change; zero for controls.
    pub rate_column: Vector4<f64>,
    /// Velocity of the air for a unit of the input, as the states u, w or v that it stands in for; zero for controls.
    pub air: Vector4<f64>,
    /// What it commands a law of feedback to; none of all else.
    pub command: Option<Command>,
    /// Which input of the plane it is, 0 or 1: where that is a state of the aircraft, it enters through its actuator. `None` for air.
    pub control: Option<usize>,
    /// The input in time.
    pub input: Input,
}

impl Forcing {
    /// An input that enters by a column alone.
    pub fn new(column: Vector4<f64>, input: Input) -> Self {
        Self {
            column,
            rate_column: Vector4::zeros(),
            air: Vector4::zeros(),
            command: None,
            control: None,
            input,
        }
    }

    /// A command, which moves nothing by itself.
    pub fn commanding(command: Command, input: Input) -> Self {
        Self { command: Some(command), ..Self::new(Vector4::zeros(), input) }
    }

    /// An input of the plane, 0 or 1, by its column.
    pub fn of_control(column: Vector4<f64>, control: usize, input: Input) -> Self {
        Self { control: Some(control), ..Self::new(column, input) }
    }

    pub(in crate::flight) fn is_finite(&self) -> bool {
        self.input.is_finite()
            && self.column.iter().chain(&self.rate_column).chain(&self.air).all(|x| x.is_finite())
    }
}

/// Linear equations of motion with all that drives them.
#[derive(Clone, Debug, PartialEq)]
pub struct DrivenSystem {
    /// State matrix A.
    pub a: Matrix4<f64>,
    /// The path that follows.
    pub path: PathRates,
    /// Inputs, acting together.
    pub forcings: Vec<Forcing>,
    /// State at t = 0.
    pub start: Vector4<f64>,
    /// Path at t = 0.
    pub start_path: Vector2<f64>,
}

impl DrivenSystem {
    /// Motion from rest under one input, without its path.
    pub fn from_rest(a: Matrix4<f64>, b: Vector4<f64>, input: Input) -> Self {
        Self {
            a,
            path: PathRates::default(),
            forcings: vec![Forcing::new(b, input)],
            start: Vector4::zeros(),
            start_path: Vector2::zeros(),
        }
    }
}

/// States at the samples of a [`TimeGrid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// Time between samples \[s\]; zero if there is only one.
    pub dt: f64,
    /// State vector \[u, w, q, θ\] or \[v, p, r, φ\] at t_k: finite and within [`CUT_LIMIT`], each of them.
    pub states: Vec<Vector4<f64>>,
    /// Coordinates of the path at t_k; likewise.
    pub path: Vec<Vector2<f64>>,
    /// Time \[s\] of the first sample left out because the motion had grown beyond [`CUT_LIMIT`] or could not be computed.
    pub cut_at: Option<f64>,
}

/// Response of a linear motion to its inputs.
///
/// An edge of an input between samples is met exactly: the step is split there. A start that is not finite counts as rest, and
/// the motion is cut at once.
pub fn respond(forced: &DrivenSystem, grid: TimeGrid) -> Response {
    let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
    let dt = if steps == 0 { 0.0 } else { grid.time(1) };
    let startable = forced.start.iter().chain(&forced.start_path).all(|x| x.abs() <= CUT_LIMIT);
    let mut at = Place { x: Vector4::zeros(), path: Vector2::zeros() };
    if startable {
        at = Place { x: forced.start, path: forced.start_path };
    }
    let samples = steps.min(MOST_STEPS) + 1;
    let mut response =
        Response { dt, states: Vec::with_capacity(samples), path: Vec::with_capacity(samples), cut_at: None };
    response.states.push(at.x);
    response.path.push(at.path);
    if !startable || !forced.forcings.iter().all(Forcing::is_finite) {
        response.cut_at = (steps > 0).then_some(dt);
        return response;
    }
    let edges = forced.forcings.iter().flat_map(|forcing| forcing.input.edges()).collect();
    response.cut_at = march(
        edges,
        grid,
        at,
        |length| Step::over(forced, length),
        |step, from, t| step.advance(forced, from, t),
        |place| {
            // Written so that NaN is outside too.
            let within = place.x.iter().chain(&place.path).all(|value| value.abs() <= CUT_LIMIT);
            if within {
                response.states.push(place.x);
                response.path.push(place.path);
            }
            within
        },
    );
    response
}

/// Goes from sample to sample of a grid whose first is kept already, and meets every edge of the inputs between two exactly: the step
/// is split there. `over` makes the step of a length, `advance` takes it from a place at a time, `keep` keeps a place or says that the
/// motion ends before it; then its time is the answer.
pub(in crate::flight) fn march<P, S>(
    mut edges: Vec<f64>,
    grid: TimeGrid,
    start: P,
    over: impl Fn(f64) -> S,
    advance: impl Fn(&S, &P, f64) -> P,
    mut keep: impl FnMut(&P) -> bool,
) -> Option<f64> {
    let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
    if steps == 0 {
        return None;
    }
    let dt = grid.time(1);
    // An edge this near to a sample is on it: the times of both are rounded.
    let near = 1e-9 * dt;
    edges.retain(|&edge| edge > near && edge < grid.duration);
    edges.sort_by(f64::total_cmp);
    let mut edges = edges.into_iter().peekable();
    let whole = over(dt);
    let mut at = start;
    for k in 1..=steps {
        let (mut t, next) = (grid.time(k - 1), grid.time(k));
        while edges.next_if(|&edge| edge <= t + near).is_some() {}
        if edges.peek().is_some_and(|&edge| edge < next - near) {
            while let Some(edge) = edges.next_if(|&edge| edge < next - near) {
                if edge > t {
                    at = advance(&over(edge - t), &at, t);
                    t = edge;
                }
            }
            at = advance(&over(next - t), &at, t);
        } else {
            at = advance(&whole, &at, t);
        }
        if k > MOST_STEPS || !keep(&at) {
            return Some(next);
        }
    }
    None
}

/// State that a constant unit input leads to, −A⁻¹ B; it is reached only if every mode decays. `None` if A is singular.
pub fn steady_state(a: &Matrix4<f64>, b: &Vector4<f64>) -> Option<Vector4<f64>> {
    a.full_piv_lu().solve(&-b).filter(|x| x.iter().all(|value| value.is_finite()))
}

/// State and path at one time, or what an input adds to them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub x: Vector4<f64>,
    pub path: Vector2<f64>,
}

/// Motion over a length of time.
pub(super) struct Step {
    phi: Matrix4<f64>,
    /// What the states and the path at the beginning add to the path at the end.
    path_of_states: Matrix2x4<f64>,
    path_of_path: Matrix2<f64>,
    length: f64,
    gains: Vec<Gain>,
}

/// What one forcing does during a step.
enum Gain {
    /// Γ, for an input that is constant meanwhile.
    Held(Place),
    /// For a smooth input, at each node: its time from the beginning, and what a unit of the input and of its rate add.
    Smooth(Vec<(f64, Place, Place)>),
}

/// Gauss–Legendre nodes and weights on (0, 1), six points (Abramowitz & Stegun, Table 25.4, moved from (−1, 1)).
pub(in crate::flight) const NODES: [(f64, f64); 6] = [
    (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_55, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// A part of a smooth step is at most this long in units of 1/(|λ| + ω): the rule's error is then
/// 2¹³ (6!)⁴/(13 (12!)³) ≈ 2·10⁻¹² of the twelfth derivative's scale, for the very fastest of it.
pub(in crate::flight) const PART: f64 = 2.0;

/// Parts beyond these are not made; an input so fast that it would need more has no meaning for an aircraft.
pub(in crate::flight) const MOST_PARTS: f64 = 200.0;

impl Step {
    /// Without an edge of any input inside.
    pub fn over(forced: &DrivenSystem, length: f64) -> Self {
        let transition = transition(forced, None, length);
        let gains = forced.forcings.iter().map(|forcing| {
            if forcing.input.is_constant_between_edges() {
                Gain::Held(column(&self::transition(forced, Some(&forcing.column), length)))
            } else {
                Gain::Smooth(smooth_gain(forced, forcing, length))
            }
        });
        Self {
            phi: transition.fixed_view::<4, 4>(0, 0).into_owned(),
            path_of_states: transition.fixed_view::<2, 4>(4, 0).into_owned(),
            path_of_path: transition.fixed_view::<2, 2>(4, 4).into_owned(),
            length,
            gains: gains.collect(),
        }
    }

    /// From a place at time t.
    pub fn advance(&self, forced: &DrivenSystem, from: &Place, t: f64) -> Place {
        let mut to = Place {
            x: self.phi * from.x,
            path: self.path_of_states * from.x + self.path_of_path * from.path,
        };
        for (gain, forcing) in self.gains.iter().zip(&forced.forcings) {
            match gain {
                // In the middle, so that rounding puts no edge on the wrong side.
                Gain::Held(place) => to.add(place, forcing.input.at(t + 0.5 * self.length)),
                Gain::Smooth(nodes) => {
                    for (after, of_value, of_rate) in nodes {
                        to.add(of_value, forcing.input.at(t + after));
                        to.add(of_rate, forcing.input.rate(t + after));
                    }
                }
            }
        }
        to
    }
}

impl Place {
    fn add(&mut self, other: &Self, times: f64) {
        self.x += other.x * times;
        self.path += other.path * times;
    }
}

fn smooth_gain(forced: &DrivenSystem, forcing: &Forcing, length: f64) -> Vec<(f64, Place, Place)> {
    let fastest = speed_of(&forced.a) + forcing.input.highest_frequency();
    // At least one; NaN makes one too, and the motion is then cut.
    let parts = (fastest * length / PART).ceil().clamp(1.0, MOST_PARTS).max(1.0);
    let part = length / parts;
    let mut nodes = Vec::with_capacity(NODES.len() * parts as usize);
    for k in 0..parts as usize {
        for (node, weight) in NODES {
            let after = (k as f64 + node) * part;
            let onward = transition(forced, None, length - after) * (weight * part);
            let carried = |b: &Vector4<f64>| Place {
                x: onward.fixed_view::<4, 4>(0, 0) * b,
                path: onward.fixed_view::<2, 4>(4, 0) * b,
            };
            nodes.push((after, carried(&forcing.column), carried(&forcing.rate_column)));
        }
    }
    nodes
}

/// A bound on the largest |λ| that is near it: ‖A⁸‖^⅛ (Gelfand).
fn speed_of(a: &Matrix4<f64>) -> f64 {
    let scale = a.norm();
    if !(scale > 0.0 && scale.is_finite()) {
        return 0.0;
    }
    let square = (a / scale) * (a / scale);
    let fourth = square * square;
    scale * (fourth * fourth).norm().powf(0.125)
}

/// States, path and one constant input, together.
type Block = SMatrix<f64, 7, 7>;

/// exp of the block of states, path and, if there is one, a column, over a length of time.
fn transition(forced: &DrivenSystem, column: Option<&Vector4<f64>>, length: f64) -> Block {
    let mut block = Block::zeros();
    block.fixed_view_mut::<4, 4>(0, 0).copy_from(&forced.a);
    block.fixed_view_mut::<2, 4>(4, 0).copy_from(&forced.path.of_states);
    block.fixed_view_mut::<2, 2>(4, 4).copy_from(&forced.path.of_path);
    if let Some(column) = column {
        block.fixed_view_mut::<4, 1>(0, 6).copy_from(column);
    }
    exponential(&(block * length))
}

fn column(block: &Block) -> Place {
    Place {
        x: block.fixed_view::<4, 1>(0, 6).into_owned(),
        path: block.fixed_view::<2, 1>(4, 6).into_owned(),
    }
}

/// e^M by scaling, a diagonal Padé approximant of degree 6, and squaring (Golub & Van Loan, Algorithm 9.3.1).
///
/// With ‖M/2ˢ‖ ≤ ½ the approximant is that of a matrix within 4·10⁻¹⁶ of M. At most 1,025 squarings; what overflows, or was
/// not finite, comes back as entries that are not finite. (nalgebra's `exp` squares 2⁶⁴ times for an infinite entry.)
fn exponential(m: &Block) -> Block {
    let norm = m.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    if !(norm.is_finite() && m.iter().all(|x| x.is_finite())) {
        return Block::from_element(f64::NAN);
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
    let (square, identity) = (scaled * scaled, Block::identity());
    let fourth = square * square;
    let even =
        identity + square * (5.0 / 44.0) + fourth * (1.0 / 792.0) + square * fourth * (1.0 / 665_280.0);
    let odd = scaled * (identity * 0.5 + square * (1.0 / 66.0) + fourth * (1.0 / 15_840.0));
    let Some(mut result) = (even - odd).lu().solve(&(even + odd)) else {
        return Block::from_element(f64::NAN);
    };
    for _ in 0..squarings {
        result *= result;
    }
    result
}
