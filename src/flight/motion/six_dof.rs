//! Nonlinear flight in six degrees of freedom about a trim that it solves itself.
//!
//! ```text
//! edited model ──► aerodynamics, inertia, what was edited beyond ──► trim (Newton) ──► ẋ = f(x, δ, wind)
//!                                                                         └──► ∂f/∂x = A, ∂f/∂δ = B
//! ```
//!
//! Axes are those of the linear model: the stability axes of the trim for coefficients, those of the source, with α₀,
//! for dimensional derivatives. The linear model is the derivative of these equations at the trim, for every edit: what a
//! person added to derivatives and matrices beyond the coefficients enters as ΔA x + ΔB δ.
//!
//! Without lateral data the flight stays in its plane of symmetry. Bare matrices say nothing of flight far from the trim.

use nalgebra::{Matrix3, SMatrix, Vector3};
use thiserror::Error;

use super::aerodynamics::{Aerodynamics, Airflow, CoefficientLoads, Controls, DerivativeLoads};
use super::rigid_body::{Attitude, State};
use crate::flight::aircraft::aircraft_model::{
    AircraftModel, CoefficientModel, DerivativeModel, ModelError, Models,
};
use crate::flight::aircraft::edits::{EditedModel, MatrixOffsets};
use crate::flight::aircraft::inertia::Inertia;
use crate::flight::aircraft::plane::{ByPlane, Plane, Trim};
use crate::flight::aircraft::real::{Dual64, Real};

/// Largest acceleration that is left in the trim \[m/s² and rad/s²\].
pub const TRIM_RESIDUAL: f64 = 1e-10;

/// Newton's method needs two or three of these.
const MOST_TRIM_STEPS: usize = 30;

/// Steepest attitude of a trim \[rad\], 85°: bank and tan θ₀ lose their meaning at 90°.
const STEEPEST_ATTITUDE: f64 = 85.0 * std::f64::consts::PI / 180.0;

/// Farthest from the trim that an angle of attack or sideslip is believed \[rad\], 20°. Ours: about where a wing stalls
/// and a fin does too.
pub const WIDEST_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// An aircraft free to move in all six degrees of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct SixDof {
    /// The steady flight that the study names.
    pub trim: Trim,
    /// Forces and moments of the air and the engine.
    pub aerodynamics: Aerodynamics,
    /// Moments of inertia in the axes of the flight. Where a source has none, those of a sphere: no gyroscopic moments.
    pub inertia: Inertia,
    /// The trim as solved.
    pub steady: Steady,
    /// Where the aerodynamic model ends.
    pub limits: Limits,
    /// What a person added beyond the aerodynamics, where there is any: longitudinal, lateral.
    edits: Option<ByPlane<MatrixOffsets>>,
}

/// The trim as solved: what balances forces and moments, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steady<T = f64> {
    /// Angle of attack beyond the study's trim \[rad\], some 10⁻¹⁷.
    pub alpha: T,
    /// Elevator beyond the study's trim \[rad\], likewise.
    pub elevator: T,
    /// Thrust over mass \[m/s²\]; from dimensional derivatives, all that acts along x but gravity.
    pub thrust: T,
    /// Largest acceleration left \[m/s² or rad/s²\], at most [`TRIM_RESIDUAL`].
    pub residual: f64,
}

/// How far from its trim the aerodynamic model means anything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Angle of attack from the trim's \[rad\]: from the C_L of a stall upside down, −C_L,max, to that of the stall, by
    /// C_Lα; never more than [`WIDEST_ANGLE`].
    pub alpha: [f64; 2],
    /// Sideslip either way \[rad\], [`WIDEST_ANGLE`].
    pub beta: f64,
    /// Airspeed \[m/s\]: where the Mach number of the coefficients ends, or half the trim speed away.
    pub speed: [f64; 2],
    /// Speed of sound \[m/s\], where the limits of the airspeed are those of the Mach number.
    pub sound_speed: Option<f64>,
}

/// Inputs from outside at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs<T = f64> {
    /// Controls away from the trim.
    pub controls: Controls<T>,
    /// The air.
    pub wind: Wind<T>,
}

/// Motion of the air along and across the flight path of the trim, see [`super::gusts`]; these axes do not turn with the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wind<T = f64> {
    /// Velocity u_g, v_g, w_g \[m/s\].
    pub velocity: [T; 3],
    /// Its rate as the aircraft meets it \[m/s²\]: over V the gradient along the path. Zero at a sharp edge.
    pub rate: [T; 3],
}

/// The derivative of the equations at the trim: states \[u, w, q, θ, v, p, r, φ\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian {
    /// By the states.
    pub a: SMatrix<f64, 8, 8>,
    /// By elevator, throttle, aileron, rudder.
    pub b: SMatrix<f64, 8, 4>,
    /// By the wind u_g, v_g, w_g.
    pub wind: SMatrix<f64, 8, 3>,
    /// By its rate.
    pub wind_rate: SMatrix<f64, 8, 3>,
}

/// Why an aircraft cannot be flown.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SixDofError {
    /// There is no such aircraft or no such steady flight.
    AircraftModel(#[from] ModelError),
    /// Only A and B are known.
    Matrices,
    /// Only lateral data.
    NoLongitudinal,
    /// Ixz without Ix, Iy and Iz.
    NoInertia,
    /// No speed, or no level to bank from.
    Trim {
        /// Airspeed \[m/s\].
        speed: f64,
        /// θ₀ \[°\].
        theta_deg: f64,
    },
    /// Newton's method did not get there.
    NoBalance {
        /// The acceleration that is left \[m/s² or rad/s²\].
        residual: f64,
    },
}

impl SixDof {
    /// An edited study, ready to fly from its trim.
    pub fn new(edited: &EditedModel) -> Result<Self, SixDofError> {
        let models = healthy(edited.models()?)?;
        let (aerodynamics, inertia, limits, trim, own) = match &edited.aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => from_coefficients(aircraft_model)?,
            AircraftModel::Derivatives(_) => match edited.derivatives()? {
                Some(aircraft_model) => from_derivatives(&aircraft_model)?,
                None => return Err(SixDofError::NoLongitudinal),
            },
            AircraftModel::Matrices(_) => return Err(SixDofError::Matrices),
        };
        let theta0 = trim.theta0();
        // Written so that NaN is outside too.
        if !(trim.speed > 0.0 && trim.speed.is_finite() && theta0.abs() <= STEEPEST_ATTITUDE) {
            return Err(SixDofError::Trim { speed: trim.speed, theta_deg: theta0.to_degrees() });
        }
        let beyond = |plane: Plane| match (&models.planes[plane], &own.planes[plane]) {
            (Some(edited), Some(own)) => MatrixOffsets { a: edited.a - own.a, b: edited.b - own.b },
            _ => MatrixOffsets::default(),
        };
        let edits = ByPlane::from_fn(beyond);
        let edits = (edits != ByPlane::default()).then_some(edits);
        let mut flight = Self { trim, aerodynamics, inertia, steady: Steady::default(), limits, edits };
        flight.steady = flight.balance()?;
        Ok(flight)
    }

    /// The state in the trim, displaced by \[u, w, q, θ\] and \[v, p, r, φ\] \[m/s, rad/s, rad\].
    pub fn displaced<T: Real>(&self, [u, w, q, theta]: [T; 4], [v, p, r, phi]: [T; 4]) -> State<T> {
        let still = self.standing(T::from(self.steady.alpha));
        let [u0, _, w0] = still.velocity;
        let pitch = theta + (self.trim.theta0() + self.steady.alpha);
        State {
            velocity: [u0 + u, v, w0 + w],
            rates: [p, q, r],
            attitude: Attitude::from_euler(phi, pitch, T::from(0.0)),
            position: still.position,
        }
    }

    /// How far a state is from the trim, as [`SixDof::displaced`] takes it.
    pub fn displacement(&self, state: &State) -> ([f64; 4], [f64; 4]) {
        let ([u, v, w], [p, q, r]) = (state.velocity, state.rates);
        let [phi, theta, _] = state.attitude.euler();
        let (sin, cos) = (self.trim.alpha0 + self.steady.alpha).sin_cos();
        let speed = self.trim.speed;
        let pitch = theta - (self.trim.theta0() + self.steady.alpha);
        ([u - speed * cos, w - speed * sin, q, pitch], [v, p, r, phi])
    }

    /// The throttle that makes the thrust of the steady flight, in the unit of the throttle, where coefficients give the drag and
    /// the engine; what takes all of it away is its negative.
    pub fn steady_throttle(&self) -> Option<f64> {
        let Aerodynamics::Coefficients(loads) = &self.aerodynamics else { return None };
        let throttle = self.steady.thrust * loads.airframe.mass / loads.airframe.thrust_per_throttle;
        (throttle.is_finite() && throttle > 0.0).then_some(throttle)
    }

    /// The equations of motion: the rate of every number of the state.
    pub fn rate<T: Real>(&self, state: &State<T>, inputs: &Inputs<T>) -> State<T> {
        let Steady { alpha, elevator, thrust, residual } = self.steady;
        let steady =
            Steady { alpha: alpha.into(), elevator: elevator.into(), thrust: thrust.into(), residual };
        self.rate_about(state, inputs, &steady)
    }

    /// Velocity through the air in body axes \[m/s\].
    pub fn through_air<T: Real>(&self, state: &State<T>, wind: &Wind<T>) -> [T; 3] {
        let [u_g, v_g, w_g] = self.to_body(state, wind.velocity);
        let [u, v, w] = state.velocity;
        [u - u_g, v - v_g, w - w_g]
    }

    /// What is given along and across the flight path of the trim, in the axes of the body.
    fn to_body<T: Real>(&self, state: &State<T>, vector: [T; 3]) -> [T; 3] {
        let path = Attitude::from_euler(T::from(0.0), T::from(self.trim.gamma0), T::from(0.0));
        state.attitude.to_body(path.to_earth(vector))
    }

    /// All forces but gravity over the mass, in body axes \[m/s²\], from a state and its rate.
    pub fn specific_force(&self, state: &State, rate: &State) -> [f64; 3] {
        let ([u, v, w], [p, q, r]) = (state.velocity, state.rates);
        let turning = [q * w - r * v, r * u - p * w, p * v - q * u];
        let down = state.attitude.down();
        // f = V̇ + ω × V − g
        [0, 1, 2].map(|i| rate.velocity[i] + turning[i] - self.trim.gravity * down[i])
    }

    fn rate_about<T: Real>(&self, state: &State<T>, inputs: &Inputs<T>, steady: &Steady<T>) -> State<T> {
        let ([p, q, r], wind) = (state.rates, &inputs.wind);
        let [u_air, v_air, w_air] = self.to_body(state, wind.velocity);
        let [u_rate, v_rate, w_rate] = self.to_body(state, wind.rate);
        // Nose and tail in different air: q + ẇ_n/V with ẇ_n normal to the path, and r − v̇_g/V about this normal
        let (sin, cos) = self.trim.alpha0.sin_cos();
        let [pitching, yawing] = [w_rate * cos - u_rate * sin, v_rate].map(|rate| rate / self.trim.speed);
        let rates = [p + yawing * sin, q + pitching, r - yawing * cos];
        let air = Airflow { velocity: self.through_air(state, wind), rates };
        let elevator = inputs.controls.elevator + steady.elevator;
        let controls = Controls { elevator, ..inputs.controls };
        let loads = self.aerodynamics.loads(&air, &controls, steady.thrust);
        let Inertia { ix, iy, iz, .. } = self.inertia;
        let [l, m, n] = loads.moment;
        let mut rate = state.rate(&self.inertia, self.trim.gravity, loads.force, [l * ix, m * iy, n * iz]);
        // The rate of the velocity through the air, in axes that turn with ω: V̇ − V̇_g + ω × V_g
        let u_met = rate.velocity[0] - u_rate + (q * w_air - r * v_air);
        let w_met = rate.velocity[2] - w_rate + (p * v_air - q * u_air);
        // s = a u̇ + b ẇ with u̇ = u̇₀ + X_s s, ẇ = ẇ₀ + Z_s s:  s = (a u̇₀ + b ẇ₀)/(1 − a X_s − b Z_s)
        let lag = &loads.lag;
        let ([a, b], [x, z]) = (lag.of, lag.force);
        let met = a * u_met + b * w_met;
        let s = met / (-(a * x + b * z) + 1.0);
        rate.velocity[0] += x * s;
        rate.velocity[2] += z * s;
        rate.rates[1] += lag.moment * s;
        if let Some(edits) = &self.edits {
            self.add_edits(edits, &air, state, &inputs.controls, &mut rate);
        }
        rate
    }

    /// Adds ΔA x + ΔB δ. The attitude enters by the direction of gravity, (sin θ − sin θ₀)/cos θ₀ for θ and
    /// cos θ sin φ/cos θ₀ for φ, which has no jump upside down. An edit of the θ̇ or φ̇ row turns the attitude beside the
    /// body's own rates.
    fn add_edits<T: Real>(
        &self,
        edits: &ByPlane<MatrixOffsets>,
        air: &Airflow<T>,
        state: &State<T>,
        controls: &Controls<T>,
        rate: &mut State<T>,
    ) {
        let ([u, v, w], [p, q, r]) = (air.velocity, air.rates);
        let (sin, cos) = self.trim.theta0().sin_cos();
        let down = state.attitude.down();
        let theta = (-down[0] - sin) / cos;
        let x = [u - self.trim.u0(), w - self.trim.w0(), q, theta];
        let [du, dw, dq, turn_q] = product(&edits.longitudinal, x, [controls.elevator, controls.throttle]);
        let x = [v, p, r, down[1] / cos];
        let [dv, dp, dr, turn_p] = product(&edits.lateral, x, [controls.aileron, controls.rudder]);
        let turned = state.attitude.rate([p + turn_p, q + turn_q, r]);
        *rate = State {
            velocity: [rate.velocity[0] + du, rate.velocity[1] + dv, rate.velocity[2] + dw],
            rates: [rate.rates[0] + dp, rate.rates[1] + dq, rate.rates[2] + dr],
            attitude: turned,
            position: rate.position,
        };
    }

    /// Straight flight along the path with an angle of attack beyond α₀.
    fn standing<T: Real>(&self, alpha: T) -> State<T> {
        let zero = T::from(0.0);
        let (sin, cos) = (alpha + self.trim.alpha0).sin_cos();
        State {
            velocity: [cos * self.trim.speed, zero, sin * self.trim.speed],
            rates: [zero; 3],
            attitude: Attitude::from_euler(zero, alpha + self.trim.theta0(), zero),
            position: [zero; 3],
        }
    }

    /// Angle of attack, elevator and thrust for which nothing accelerates, by Newton's method from no thrust at all.
    ///
    /// The step is the shortest that does it, Jᵀ (J Jᵀ)⁻¹, with J by automatic differentiation: an aircraft whose elevator
    /// does nothing is still in balance where nothing is asked of it.
    fn balance(&self) -> Result<Steady, SixDofError> {
        let mut y = Vector3::zeros();
        let mut best = Steady { residual: f64::INFINITY, ..Steady::default() };
        for _ in 0..MOST_TRIM_STEPS {
            let left = self.unbalanced(y.map(Dual64::from)).map(|x| x.re);
            let residual = left.amax();
            // Beyond what is asked for, on to where rounding ends it.
            if residual.is_nan() || residual >= best.residual {
                break;
            }
            let [alpha, elevator, thrust] = y.into();
            best = Steady { alpha, elevator, thrust, residual };
            let column = |j: usize| {
                let mut moved = y.map(Dual64::from);
                moved[j].eps = 1.0;
                self.unbalanced(moved).map(|x| x.eps)
            };
            let jacobian = Matrix3::from_columns(&[column(0), column(1), column(2)]);
            let mut normal = jacobian * jacobian.transpose();
            normal += Matrix3::identity() * (1e-14 * normal.trace());
            let Some(inverse) = normal.try_inverse() else { break };
            y -= jacobian.transpose() * inverse * left;
        }
        let residual = best.residual;
        if residual <= TRIM_RESIDUAL { Ok(best) } else { Err(SixDofError::NoBalance { residual }) }
    }

    /// u̇, ẇ and q̇ in straight flight with an angle of attack, elevator and thrust.
    fn unbalanced(&self, y: Vector3<Dual64>) -> Vector3<Dual64> {
        let steady = Steady { alpha: y[0], elevator: y[1], thrust: y[2], residual: 0.0 };
        let rate = self.rate_about(&self.standing(steady.alpha), &Inputs::resting(), &steady);
        Vector3::new(rate.velocity[0], rate.velocity[2], rate.rates[1])
    }

    /// The derivative of the equations at the trim, by automatic differentiation through the quaternion and all.
    pub fn jacobian(&self) -> Jacobian {
        let column = |j: usize| -> [f64; 8] {
            let mut seeds = [Dual64::from(0.0); 18];
            seeds[j].eps = 1.0;
            let [u, w, q, theta, v, p, r, phi, elevator, throttle, aileron, rudder, winds @ ..] = seeds;
            let [u_g, v_g, w_g, rates @ ..] = winds;
            let state = self.displaced([u, w, q, theta], [v, p, r, phi]);
            let controls = Controls { elevator, throttle, aileron, rudder };
            let wind = Wind { velocity: [u_g, v_g, w_g], rate: rates };
            let rate = self.rate(&state, &Inputs { controls, wind });
            let ([du, dv, dw], [dp, dq, dr]) = (rate.velocity, rate.rates);
            let [dphi, dtheta] = state.attitude.euler_rates(&rate.attitude);
            [du, dw, dq, dtheta, dv, dp, dr, dphi].map(|x| x.eps)
        };
        Jacobian {
            a: SMatrix::from_columns(&[0, 1, 2, 3, 4, 5, 6, 7].map(|j| column(j).into())),
            b: SMatrix::from_columns(&[8, 9, 10, 11].map(|j| column(j).into())),
            wind: SMatrix::from_columns(&[12, 13, 14].map(|j| column(j).into())),
            wind_rate: SMatrix::from_columns(&[15, 16, 17].map(|j| column(j).into())),
        }
    }
}

impl<T: Real> Inputs<T> {
    /// Nothing but the trim.
    pub fn resting() -> Self {
        let zero = T::from(0.0);
        let controls = Controls { elevator: zero, throttle: zero, aileron: zero, rudder: zero };
        Self { controls, wind: Wind { velocity: [zero; 3], rate: [zero; 3] } }
    }
}

/// ΔA x + ΔB δ.
fn product<T: Real>(edit: &MatrixOffsets, x: [T; 4], delta: [T; 2]) -> [T; 4] {
    [0, 1, 2, 3].map(|i| {
        let by_states = (0..4).map(|j| x[j] * edit.a[(i, j)]);
        let by_inputs = (0..2).map(|j| delta[j] * edit.b[(i, j)]);
        by_states.chain(by_inputs).sum()
    })
}

/// The models, or why a plane that has data has none.
fn healthy(models: Models) -> Result<Models, ModelError> {
    match models.problems.first() {
        Some(problem) => Err(*problem),
        None => Ok(models),
    }
}

type Parts = (Aerodynamics, Inertia, Limits, Trim, Models);

fn from_coefficients(aircraft_model: &CoefficientModel) -> Result<Parts, SixDofError> {
    let derived = aircraft_model.derive()?;
    let own = healthy(derived.derivatives.models())?;
    let DerivativeModel { trim, inertia, .. } = derived.derivatives;
    let inertia = inertia.ok_or(SixDofError::NoInertia)?;
    let (airframe, flight) = (derived.airframe, derived.flight);
    let c = derived.coefficients.longitudinal;
    let sound_speed = flight.condition.speed / flight.mach;
    let validity = aircraft_model.validity;
    // C_L + C_Lα Δα = ±C_L,max
    let stall = |cl: f64| {
        let alpha = (cl - c.cl) / c.cl_alpha;
        if c.cl_alpha > 1e-3 { alpha.clamp(-WIDEST_ANGLE, WIDEST_ANGLE) } else { WIDEST_ANGLE.copysign(cl) }
    };
    let limits = Limits {
        alpha: [stall(-validity.cl_max), stall(validity.cl_max)],
        beta: WIDEST_ANGLE,
        speed: [validity.mach_min * sound_speed, validity.mach_max * sound_speed],
        sound_speed: Some(sound_speed),
    };
    let aerodynamics = Aerodynamics::Coefficients(CoefficientLoads {
        airframe,
        inertia,
        flight,
        longitudinal: c,
        lateral: derived.coefficients.lateral,
        gravity: trim.gravity,
    });
    Ok((aerodynamics, inertia, limits, trim, own))
}

fn from_derivatives(aircraft_model: &DerivativeModel) -> Result<Parts, SixDofError> {
    let own = healthy(aircraft_model.models())?;
    let DerivativeModel { trim, inertia, longitudinal, lateral } = aircraft_model.clone();
    let longitudinal = longitudinal.ok_or(SixDofError::NoLongitudinal)?;
    let couples = lateral.is_some_and(|d| d.ixz_over_ix != 0.0 || d.ixz_over_iz != 0.0);
    let inertia = match inertia {
        Some(inertia) => inertia,
        None if couples => return Err(SixDofError::NoInertia),
        None => Inertia { ix: 1.0, iy: 1.0, iz: 1.0, ixz: 0.0 },
    };
    let limits = Limits {
        alpha: [-WIDEST_ANGLE, WIDEST_ANGLE],
        beta: WIDEST_ANGLE,
        speed: [0.5 * trim.speed, 1.5 * trim.speed],
        sound_speed: None,
    };
    let aerodynamics = Aerodynamics::Derivatives(DerivativeLoads { trim, longitudinal, lateral });
    Ok((aerodynamics, inertia, limits, trim, own))
}
