//! A nonlinear flight: what moves the aircraft, and where it goes until its model ends.
//!
//! Control and wind may jump or kink at given times, and the integration begins anew at each. Between them every step's
//! error is kept below [`STEP_ERROR`] of each number, and of its unit. The flight stops, with a sentence, at
//! the moment it leaves the [`Limits`](super::six_dof::Limits) of the aerodynamic model.

use nalgebra::Vector4;

use super::aerodynamics::Controls;
use super::inputs::ON_A_SAMPLE;
use super::integrator::{Integrator, STEP_ERROR};
use super::response::{CUT_LIMIT, MOST_STEPS, TimeGrid};
use super::rigid_body::{Attitude, State};
use super::six_dof::{Inputs, SixDof, Wind};

/// Steps of integration beyond these are not tried.
pub const MOST_INTEGRATION_STEPS: usize = 20_000;

/// So far beyond a limit is not beyond it: a trim may stand on a limit, to rounding \[rad, or of the speed\].
const ROUNDING: f64 = 1e-9;

/// Controls, air and initial states that move an aircraft out of its trim.
#[derive(Clone, Copy)]
pub struct Excitation<'a> {
    /// Controls away from the trim at a time \[s\].
    pub controls: &'a dyn Fn(f64) -> Controls,
    /// The air at a time.
    pub wind: &'a dyn Fn(f64) -> Wind,
    /// Times \[s\] at which either jumps or kinks, in any order; at a jump the value is that from then on.
    pub edges: &'a [f64],
    /// Where it begins, away from the trim: \[u, w, q, θ\].
    pub longitudinal: Vector4<f64>,
    /// Likewise \[v, p, r, φ\].
    pub lateral: Vector4<f64>,
    /// Heading ψ at which it begins \[rad\], zero along the trimmed flight.
    pub heading: f64,
    /// Where it begins: north, east and up \[m\].
    pub position: [f64; 3],
}

/// A nonlinear flight at the samples of a [`TimeGrid`].
#[derive(Clone, Debug, PartialEq)]
pub struct FlightPath {
    /// Time between samples \[s\]; zero if there is only one.
    pub dt: f64,
    /// The samples from t = 0, every number finite; fewer than asked for if the flight stopped, none if it could not begin.
    pub samples: Vec<Sample>,
    /// Where and why it stopped.
    pub stop: Option<Stop>,
}

/// An aircraft in flight at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Away from the trim, \[u, w, q, θ\] as in the linear model.
    pub longitudinal: Vector4<f64>,
    /// Away from the trim, \[v, p, r, φ\] as in the linear model.
    pub lateral: Vector4<f64>,
    /// Attitude, a unit quaternion.
    pub attitude: Attitude,
    /// Bank φ, pitch θ and heading ψ \[rad\], not less the trim's; θ within ±90°, heading zero in the trim.
    pub euler: [f64; 3],
    /// Position north (along the trimmed flight), east and up \[m\] from where steady flight is at t = 0.
    pub position: [f64; 3],
    /// Angle of attack through the air, away from the trim's \[rad\].
    pub alpha: f64,
    /// Sideslip β through the air \[rad\], wind from the right positive.
    pub beta: f64,
    /// Airspeed \[m/s\].
    pub airspeed: f64,
    /// Load factor n_z across the trimmed flight path: lift over weight, 1 in level trim.
    pub n_z: f64,
    /// Load factor n_y, to the right positive.
    pub n_y: f64,
}

/// Where a flight stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Time \[s\].
    pub time: f64,
    /// Why.
    pub reason: Reason,
}

/// Why a flight stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// Angle of attack away from the trim's, at a limit \[rad\].
    AngleOfAttack(f64),
    /// Sideslip at a limit \[rad\].
    Sideslip(f64),
    /// Mach number at a limit.
    Mach(f64),
    /// Airspeed at a limit, half the trim speed away \[m/s\].
    Airspeed(f64),
    /// Out of the plane of symmetry, without lateral data.
    NoLateralData,
    /// Too fast for [`MOST_INTEGRATION_STEPS`], so stiff that the integrator gives up, or beyond all bounds.
    TooFast,
    /// A control or the wind is not a finite number.
    Input,
}

impl SixDof {
    /// The flight from the trim, or from beside it, at the samples of a grid.
    pub fn fly(&self, excitation: &Excitation<'_>, grid: TimeGrid) -> FlightPath {
        let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
        let dt = if steps == 0 { 0.0 } else { grid.time(1) };
        let last = steps.min(MOST_STEPS);
        let path = FlightPath { dt, samples: Vec::with_capacity(last + 1), stop: None };
        let mut flying = Flying { aircraft: self, excitation, grid, last, tried: 0, path };
        flying.path.stop = match flying.fly() {
            Err(stop) => Some(stop),
            Ok(()) => (steps > last).then(|| Stop { time: grid.time(last), reason: Reason::TooFast }),
        };
        flying.path
    }
}

/// A flight under way.
struct Flying<'a> {
    aircraft: &'a SixDof,
    excitation: &'a Excitation<'a>,
    grid: TimeGrid,
    /// Index of the last sample.
    last: usize,
    /// Steps of integration tried so far.
    tried: usize,
    path: FlightPath,
}

impl Flying<'_> {
    /// Piece by piece between the edges.
    fn fly(&mut self) -> Result<(), Stop> {
        let Excitation { longitudinal, lateral, edges, heading, position, .. } = *self.excitation;
        let displaced = self.aircraft.displaced(longitudinal.into(), lateral.into());
        let [phi, theta, _] = displaced.attitude.euler();
        let attitude =
            if heading == 0.0 { displaced.attitude } else { Attitude::from_euler(phi, theta, heading) };
        let mut y = State { attitude, position, ..displaced }.to_array();
        let end = if self.last == 0 { 0.0 } else { self.grid.time(self.last) };
        let mut edges: Vec<f64> = edges.iter().copied().filter(|&t| t > 0.0 && t < end).collect();
        edges.push(end);
        edges.sort_by(f64::total_cmp);
        let mut start = 0.0;
        self.arrive(start, &y)?;
        for edge in edges {
            if edge > start {
                y = self.piece(start, edge, y)?;
                self.arrive(edge, &y)?;
                start = edge;
            }
        }
        Ok(())
    }

    /// A piece without edges inside; where it ends.
    fn piece(&mut self, start: f64, end: f64, y: [f64; 13]) -> Result<[f64; 13], Stop> {
        let (aircraft, excitation) = (self.aircraft, self.excitation);
        // What holds at the end, and where it is rounded to be, belongs to the next piece.
        let last = (end - 4.0 * ON_A_SAMPLE * (end - start)).max(start);
        let inputs = |t: f64| inputs(excitation, t.clamp(start, last));
        let rate = |t: f64, y: &[f64; 13]| aircraft.rate(&State::from_array(*y), &inputs(t)).to_array();
        let lost = |time: f64| Stop { time, reason: Reason::TooFast };
        let mut integrator = Integrator::new(rate, start, end, &y, STEP_ERROR).ok_or(lost(start))?;
        while !integrator.is_done() {
            let before = integrator.time();
            self.tried += 1;
            let taken = integrator.try_step().filter(|_| self.tried <= MOST_INTEGRATION_STEPS);
            if !taken.ok_or(lost(before))? {
                continue;
            }
            let after = integrator.time();
            let mut good = before;
            loop {
                // The next sample, or the end of the step after the last in it.
                let sample = self.next_sample().filter(|&time| time <= after && time < end);
                let time = sample.unwrap_or(after);
                let y = integrator.at(time).ok_or(lost(good))?;
                if reason(aircraft, &y, &inputs(time)).is_some() {
                    return Err(first(good, time, |t| {
                        integrator.at(t).and_then(|y| reason(aircraft, &y, &inputs(t)))
                    }));
                }
                if sample.is_none() {
                    break;
                }
                // A sample that is on the next edge but for rounding shows what holds from there on.
                let sample = sampled(aircraft, &y, &self::inputs(excitation, time)).ok_or(lost(time))?;
                self.path.samples.push(sample);
                good = time;
            }
        }
        Ok(integrator.state())
    }

    /// Looks at where a piece begins, and at the end of all; takes the sample there, if there is one.
    fn arrive(&mut self, time: f64, y: &[f64; 13]) -> Result<(), Stop> {
        let inputs = inputs(self.excitation, time);
        if let Some(reason) = reason(self.aircraft, y, &inputs) {
            return Err(Stop { time, reason });
        }
        if self.next_sample().is_some_and(|sample| sample <= time) {
            let sample = sampled(self.aircraft, y, &inputs);
            self.path.samples.push(sample.ok_or(Stop { time, reason: Reason::TooFast })?);
        }
        Ok(())
    }

    /// Time of the next sample, if one is left \[s\].
    fn next_sample(&self) -> Option<f64> {
        let k = self.path.samples.len();
        let time = if k == 0 { 0.0 } else { self.grid.time(k) };
        (k <= self.last).then_some(time)
    }
}

fn inputs(excitation: &Excitation<'_>, time: f64) -> Inputs {
    Inputs { controls: (excitation.controls)(time), wind: (excitation.wind)(time) }
}

/// Why the flight may not go on from a state, if it may not.
fn reason(aircraft: &SixDof, y: &[f64; 13], inputs: &Inputs) -> Option<Reason> {
    let Controls { elevator, throttle, aileron, rudder } = inputs.controls;
    let Wind { velocity, rate } = inputs.wind;
    let given = [elevator, throttle, aileron, rudder].into_iter().chain(velocity).chain(rate);
    if !given.into_iter().all(f64::is_finite) {
        return Some(Reason::Input);
    }
    // Written so that NaN is outside too.
    if !y.iter().all(|x| x.abs() <= CUT_LIMIT) {
        return Some(Reason::TooFast);
    }
    let state = State::from_array(*y);
    let Incidence { alpha, beta, speed, side } = Incidence::of(aircraft, &state, inputs);
    let limits = &aircraft.limits;
    let [slowest, fastest] = [limits.speed[0] * (1.0 - ROUNDING), limits.speed[1] * (1.0 + ROUNDING)];
    if !(slowest..=fastest).contains(&speed) {
        return Some(limits.sound_speed.map_or(Reason::Airspeed(speed), |sound| Reason::Mach(speed / sound)));
    }
    if !(limits.alpha[0] - ROUNDING..=limits.alpha[1] + ROUNDING).contains(&alpha) {
        return Some(Reason::AngleOfAttack(alpha));
    }
    if !(-limits.beta..=limits.beta).contains(&beta) {
        return Some(Reason::Sideslip(beta));
    }
    let [p, _, r] = state.rates;
    let out_of_plane = [side, p, r, state.attitude.down()[1], aileron, rudder].iter().any(|x| x.abs() > 1e-9);
    (out_of_plane && !aircraft.aerodynamics.has_lateral()).then_some(Reason::NoLateralData)
}

/// The stop that is first found between a time without reason to stop and one with: by halving, to the last digit.
fn first(mut good: f64, mut bad: f64, mut reason: impl FnMut(f64) -> Option<Reason>) -> Stop {
    let mut why = reason(bad).unwrap_or(Reason::TooFast);
    for _ in 0..60 {
        let middle = 0.5 * (good + bad);
        match reason(middle) {
            Some(reason) => (bad, why) = (middle, reason),
            None => good = middle,
        }
    }
    Stop { time: bad, reason: why }
}

/// Motion through the air, as it is limited and shown.
struct Incidence {
    alpha: f64,
    beta: f64,
    speed: f64,
    side: f64,
}

impl Incidence {
    fn of(aircraft: &SixDof, state: &State, inputs: &Inputs) -> Self {
        let [u, v, w] = aircraft.through_air(state, &inputs.wind);
        let in_plane = u.hypot(w);
        Self {
            alpha: w.atan2(u) - aircraft.trim.alpha0 - aircraft.steady.alpha,
            beta: v.atan2(in_plane),
            speed: in_plane.hypot(v),
            side: v,
        }
    }
}

/// What is shown of a state; `None` if a number of it is not finite.
fn sampled(aircraft: &SixDof, y: &[f64; 13], inputs: &Inputs) -> Option<Sample> {
    let state = State::from_array(*y);
    let (longitudinal, lateral) = aircraft.displacement(&state);
    let Incidence { alpha, beta, speed, .. } = Incidence::of(aircraft, &state, inputs);
    let rate = aircraft.rate(&state, inputs);
    let [x, y, z] = aircraft.specific_force(&state, &rate);
    let (sin, cos) = aircraft.trim.alpha0.sin_cos();
    let g = aircraft.trim.gravity;
    let sample = Sample {
        longitudinal: longitudinal.into(),
        lateral: lateral.into(),
        attitude: state.attitude.normalised(),
        euler: state.attitude.euler(),
        position: state.position,
        alpha,
        beta,
        airspeed: speed,
        // z across the trimmed flight path: −x sin α₀ + z cos α₀
        n_z: (x * sin - z * cos) / g,
        n_y: y / g,
    };
    // The rest follows from finite numbers by functions that stay finite.
    (sample.n_z.is_finite() && sample.n_y.is_finite()).then_some(sample)
}
