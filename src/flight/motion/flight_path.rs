//! A nonlinear flight: what moves the aircraft, and where it goes until its model ends.
//!
//! Control and wind may jump or kink at given times, and the integration begins anew at each. Between them every step's
//! error is kept below [`STEP_ERROR`] of each number, and of its unit. The flight stops, with a sentence, at
//! the moment it leaves the [`Limits`](super::six_dof::Limits) of the aerodynamic model. Under a law of feedback it tells where
//! the limits of the controls hold the law back.

use nalgebra::Vector4;

use super::aerodynamics::Controls;
use super::control_limits::Control;
use super::inputs::ON_A_SAMPLE;
use super::integrator::{Integrator, STEP_ERROR};
use super::response::{CUT_LIMIT, MOST_STEPS, TimeGrid};
use super::rigid_body::{Attitude, State};
use super::servos::{Asked, Bites, Moment, OWN, Servos, Way};
use super::six_dof::{Inputs, SixDof, Wind};
use crate::few;
use crate::flight::aircraft::plane::Plane;

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
    /// The law of feedback that moves the controls beside the pilot, if there is one.
    pub servos: Option<&'a Servos<'a>>,
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
    /// Where limits of the controls held the law back, in the order in which they began to; none without a law.
    pub bites: Vec<Bite>,
}

/// A time through which a limit holds a control back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bite {
    /// The control.
    pub control: Control,
    /// What of it is at its limit.
    pub limit: Limited,
    /// From when \[s\].
    pub from: f64,
    /// Until when, the end of the flight at the latest \[s\].
    pub until: f64,
}

/// What of a control is at its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// Its deflection: more is asked for than there is.
    Deflection,
    /// Its rate: it comes later than it should.
    Rate,
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
    /// The controls, with what the law moves, away from the trim.
    pub controls: Controls,
}

impl Sample {
    /// The two inputs of a plane.
    pub const fn inputs(&self, plane: Plane) -> [f64; 2] {
        let Controls { elevator, throttle, aileron, rudder } = self.controls;
        match plane {
            Plane::Longitudinal => [elevator, throttle],
            Plane::Lateral => [aileron, rudder],
        }
    }
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

/// States of the body.
const BODY: usize = 13;

/// States of the body and those of a law.
const WITH_LAW: usize = BODY + OWN;

impl SixDof {
    /// The flight from the trim, or from beside it, at the samples of a grid.
    pub fn fly(&self, excitation: &Excitation<'_>, grid: TimeGrid) -> FlightPath {
        match excitation.servos {
            None => Flying::<BODY>::new(self, excitation, grid).flown(),
            Some(_) => Flying::<WITH_LAW>::new(self, excitation, grid).flown(),
        }
    }
}

/// A flight under way; N numbers are integrated.
struct Flying<'a, const N: usize> {
    moved: Moved<'a>,
    grid: TimeGrid,
    /// Number of steps between samples that are asked for.
    steps: usize,
    /// Index of the last sample.
    last: usize,
    /// Steps of integration tried so far.
    tried: usize,
    /// Since when each limit holds its control back.
    biting: [[Option<f64>; 2]; 4],
    path: FlightPath,
}

/// What moves the aircraft.
#[derive(Clone, Copy)]
struct Moved<'a> {
    aircraft: &'a SixDof,
    excitation: &'a Excitation<'a>,
    ways: [Way; 4],
}

impl<'a, const N: usize> Flying<'a, N> {
    fn new(aircraft: &'a SixDof, excitation: &'a Excitation<'a>, grid: TimeGrid) -> Self {
        let steps = if grid.duration > 0.0 && grid.duration.is_finite() { grid.steps } else { 0 };
        let dt = if steps == 0 { 0.0 } else { grid.time(1) };
        let last = steps.min(MOST_STEPS);
        let samples = Vec::with_capacity(last + 1);
        Self {
            moved: Moved { aircraft, excitation, ways: Default::default() },
            grid,
            steps,
            last,
            tried: 0,
            biting: Default::default(),
            path: FlightPath { dt, samples, stop: None, bites: Vec::new() },
        }
    }

    fn flown(mut self) -> FlightPath {
        let end = self.grid.time(self.last.max(1));
        self.path.stop = match self.fly() {
            Err(stop) => Some(stop),
            Ok(()) => (self.steps > self.last)
                .then(|| Stop { time: self.grid.time(self.last), reason: Reason::TooFast }),
        };
        let end = self.path.stop.map_or(end, |stop| stop.time);
        self.bite(end, Default::default());
        self.path.bites.retain(|bite| bite.from < end);
        for bite in &mut self.path.bites {
            bite.until = bite.until.min(end);
        }
        few::sort_by(&mut self.path.bites, |a, b| a.from.total_cmp(&b.from));
        self.path
    }

    /// Piece by piece between the edges.
    fn fly(&mut self) -> Result<(), Stop> {
        let Excitation { longitudinal, lateral, edges, heading, position, servos, .. } =
            *self.moved.excitation;
        let displaced = self.moved.aircraft.displaced(longitudinal.into(), lateral.into());
        let [phi, theta, _] = displaced.attitude.euler();
        let attitude =
            if heading == 0.0 { displaced.attitude } else { Attitude::from_euler(phi, theta, heading) };
        let body = State { attitude, position, ..displaced }.to_array();
        let own = servos.map_or([0.0; OWN], |servos| servos.start);
        let mut y: [f64; N] = std::array::from_fn(|k| if k < BODY { body[k] } else { own[k - BODY] });
        let end = if self.last == 0 { 0.0 } else { self.grid.time(self.last) };
        let mut edges: Vec<f64> = edges.iter().copied().filter(|&t| t > 0.0 && t < end).collect();
        edges.push(end);
        edges.sort_by(f64::total_cmp);
        let mut start = 0.0;
        self.moved.settle(start, &mut y);
        self.arrive(start, &y)?;
        for edge in edges {
            if edge > start {
                y = self.piece(start, edge, y)?;
                self.moved.jump(edge, &y);
                self.arrive(edge, &y)?;
                start = edge;
            }
        }
        Ok(())
    }

    /// A piece without edges inside; where it ends.
    fn piece(&mut self, start: f64, end: f64, mut y: [f64; N]) -> Result<[f64; N], Stop> {
        // What holds at the end, and where it is rounded to be, belongs to the next piece.
        let last = (end - 4.0 * ON_A_SAMPLE * (end - start)).max(start);
        let mut from = start;
        // As far as nothing of the law turns, all of it in one.
        while let Some(turned) = self.stretch((from, end), (start, last), &mut y)? {
            let time = turned.clamp(start, last);
            self.moved.ways = self.moved.turned(time, &y);
            self.moved.settle(time, &mut y);
            if end - turned <= 16.0 * f64::EPSILON * end {
                break;
            }
            from = turned;
        }
        self.moved.settle(last, &mut y);
        Ok(y)
    }

    /// On from a time, to the end or to where a control of the law turns or meets a limit, whose time is the answer; `y` goes along. `within` are the
    /// first and the last time at which controls and air are asked for.
    fn stretch(
        &mut self,
        (from, end): (f64, f64),
        within: (f64, f64),
        y: &mut [f64; N],
    ) -> Result<Option<f64>, Stop> {
        let moved = self.moved;
        let at = |t: f64| t.clamp(within.0, within.1);
        let rate = |t: f64, y: &[f64; N]| moved.rate(at(t), y);
        let lost = |time: f64| Stop { time, reason: Reason::TooFast };
        let bites = moved.bites(at(from), y);
        self.bite(from, bites);
        let mut integrator = Integrator::new(rate, from, end, y, STEP_ERROR).ok_or(lost(from))?;
        while !integrator.is_done() {
            let before = integrator.time();
            self.tried += 1;
            let taken = integrator.try_step().filter(|_| self.tried <= MOST_INTEGRATION_STEPS);
            if !taken.ok_or(lost(before))? {
                continue;
            }
            let after = integrator.time();
            // Where a limit begins or ceases to hold a control there is a kink.
            let turns =
                |t: f64, y: &[f64; N]| moved.turned(at(t), y) != moved.ways || moved.bites(at(t), y) != bites;
            let turned = (moved.excitation.servos.is_some() && turns(after, &integrator.state()))
                .then(|| halved(before, after, |t| integrator.at(t).is_some_and(|y| turns(t, &y))));
            let until = turned.unwrap_or(after);
            let mut good = before;
            loop {
                // The next sample, or the end of the step after the last in it.
                let sample = self.next_sample().filter(|&time| time <= until && time < end);
                let time = sample.unwrap_or(until);
                let y = integrator.at(time).ok_or(lost(good))?;
                if reason(&moved, &y, at(time)).is_some() {
                    return Err(first(good, time, |t| {
                        integrator.at(t).and_then(|y| reason(&moved, &y, at(t)))
                    }));
                }
                if sample.is_none() {
                    break;
                }
                // A sample that is on the next edge but for rounding shows what holds from there on.
                let sample = sampled(&moved, &y, time).ok_or(lost(time))?;
                self.path.samples.push(sample);
                good = time;
            }
            if let Some(time) = turned {
                *y = integrator.at(time).ok_or(lost(time))?;
                return Ok(Some(time));
            }
        }
        *y = integrator.state();
        Ok(None)
    }

    /// Looks at where a piece begins, and at the end of all; takes the sample there, if there is one.
    fn arrive(&mut self, time: f64, y: &[f64; N]) -> Result<(), Stop> {
        if let Some(reason) = reason(&self.moved, y, time) {
            return Err(Stop { time, reason });
        }
        if self.next_sample().is_some_and(|sample| sample <= time) {
            let sample = sampled(&self.moved, y, time);
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

    /// Notes which limits hold from a time on.
    fn bite(&mut self, time: f64, bites: Bites) {
        for control in Control::ALL {
            for limit in [Limited::Deflection, Limited::Rate] {
                let bites = bites[control as usize][limit as usize];
                let biting = &mut self.biting[control as usize][limit as usize];
                match *biting {
                    None if bites => *biting = Some(time),
                    Some(from) if !bites => {
                        *biting = None;
                        self.path.bites.push(Bite { control, limit, from, until: time });
                    }
                    None | Some(_) => {}
                }
            }
        }
    }
}

impl Moved<'_> {
    fn moment<const N: usize>(&self, time: f64, y: &[f64; N]) -> Moment<'_> {
        Moment {
            aircraft: self.aircraft,
            time,
            state: body(y),
            wind: (self.excitation.wind)(time),
            pilot: (self.excitation.controls)(time),
            own: std::array::from_fn(|k| y.get(BODY + k).copied().unwrap_or(0.0)),
            ways: self.ways,
        }
    }

    /// Controls and air.
    fn inputs<const N: usize>(&self, time: f64, y: &[f64; N]) -> Inputs {
        let moment = self.moment(time, y);
        let controls = match self.excitation.servos {
            Some(servos) => servos.controls(&moment, &servos.ask(&moment)),
            None => moment.pilot,
        };
        Inputs { controls, wind: moment.wind }
    }

    /// Rates of all numbers.
    fn rate<const N: usize>(&self, time: f64, y: &[f64; N]) -> [f64; N] {
        let moment = self.moment(time, y);
        let (controls, own) = match self.excitation.servos {
            Some(servos) => {
                let asked = servos.ask(&moment);
                (servos.controls(&moment, &asked), servos.rates(&moment, &asked))
            }
            None => (moment.pilot, [0.0; OWN]),
        };
        let body = self.aircraft.rate(&moment.state, &Inputs { controls, wind: moment.wind }).to_array();
        std::array::from_fn(|k| if k < BODY { body[k] } else { own[k - BODY] })
    }

    /// What a law says of a moment.
    fn of_law<const N: usize, T>(
        &self,
        time: f64,
        y: &[f64; N],
        of: impl FnOnce(&Servos<'_>, &Moment<'_>, &Asked) -> T,
    ) -> Option<T> {
        let servos = self.excitation.servos?;
        let moment = self.moment(time, y);
        let asked = servos.ask(&moment);
        Some(of(servos, &moment, &asked))
    }

    fn bites<const N: usize>(&self, time: f64, y: &[f64; N]) -> Bites {
        self.of_law(time, y, |servos, moment, asked| servos.bites(moment, asked)).unwrap_or_default()
    }

    fn turned<const N: usize>(&self, time: f64, y: &[f64; N]) -> [Way; 4] {
        let turned = self.of_law(time, y, |servos, moment, asked| {
            let inputs = Inputs { controls: servos.controls(moment, asked), wind: moment.wind };
            servos.turned(moment, asked, &self.aircraft.rate(&moment.state, &inputs))
        });
        turned.unwrap_or(self.ways)
    }

    /// At an edge.
    fn jump<const N: usize>(&mut self, time: f64, y: &[f64; N]) {
        self.ways =
            self.of_law(time, y, |servos, moment, asked| servos.jumped(moment, asked)).unwrap_or(self.ways);
    }

    /// Brings the states of controls that are there to where they are.
    fn settle<const N: usize>(&self, time: f64, y: &mut [f64; N]) {
        let own = self.of_law(time, y, |servos, moment, asked| servos.settled(moment, asked));
        let Some(own) = own else { return };
        for (k, x) in y.iter_mut().skip(BODY).enumerate() {
            *x = own[k];
        }
    }
}

fn body<const N: usize>(y: &[f64; N]) -> State {
    State::from_array(std::array::from_fn(|k| y[k]))
}

/// Why the flight may not go on from a state, if it may not.
fn reason<const N: usize>(moved: &Moved<'_>, y: &[f64; N], time: f64) -> Option<Reason> {
    let aircraft = moved.aircraft;
    let inputs = moved.inputs(time, y);
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
    let state = body(y);
    let Incidence { alpha, beta, speed, side } = Incidence::of(aircraft, &state, &inputs);
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

/// The first time between two at which something is so that is so at the second: by halving, to the last digit.
fn halved(mut before: f64, mut after: f64, mut is_so: impl FnMut(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (before + after);
        if !(before < middle && middle < after) {
            break;
        }
        if is_so(middle) { after = middle } else { before = middle }
    }
    after
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
fn sampled<const N: usize>(moved: &Moved<'_>, y: &[f64; N], time: f64) -> Option<Sample> {
    let (aircraft, inputs) = (moved.aircraft, moved.inputs(time, y));
    let state = body(y);
    let (longitudinal, lateral) = aircraft.displacement(&state);
    let Incidence { alpha, beta, speed, .. } = Incidence::of(aircraft, &state, &inputs);
    let rate = aircraft.rate(&state, &inputs);
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
        controls: inputs.controls,
    };
    // The rest follows from finite numbers by functions that stay finite.
    (sample.n_z.is_finite() && sample.n_y.is_finite()).then_some(sample)
}
