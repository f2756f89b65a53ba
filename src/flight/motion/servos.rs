//! Controls that follow what is measured, in nonlinear flight: gains, washouts and lags, with limits of deflection and rate.
//!
//! ```text
//! v = Σ k (y − command)             what the law asks for, both planes; held within what the pilot leaves of the reach
//! δ̇ = (v − δ)/τ                     behind an actuator, no faster than its rate
//! δ = v                             without a lag, as long as v is no faster than the rate; else δ goes after v at the rate
//! control = pilot + δ               within its reach
//! ```
//!
//! The pilot's own deflection is as it is told, at once if it is told so: only its reach ends.

use super::aerodynamics::Controls;
use super::control_limits::{Control, ControlLimit};
use super::rigid_body::State;
use super::six_dof::{SixDof, Wind};
use crate::flight::aircraft::real::{Dual64, Real};

/// How many quantities are measured: u, α, q, θ, h and β, p, r, φ, ψ, as changes from the steady flight.
pub const MEASURED: usize = 10;

/// How many states the law has: the slow parts of q and r, and the four controls.
pub const OWN: usize = 6;

/// Place of a rate among what is measured, and of its washout among the states of the law.
const WASHED: [(usize, usize); 2] = [(2, 0), (7, 1)];

/// Place of the first control among the states of the law.
const FIRST: usize = 2;

/// So long may a control be behind, or ahead of, what is asked for and still count as there \[s, at its rate\].
const THERE: f64 = 1e-9;

/// A law of both planes with the limits of the controls.
#[derive(Clone, Copy)]
pub struct Servos<'a> {
    /// Gain of each measured quantity to each control, as [`Control::ALL`].
    pub gains: [[f64; MEASURED]; 4],
    /// Time constants of the washouts of q and r \[s\]; zero is none.
    pub washouts: [f64; 2],
    /// Lag on the way to each control \[s\]; zero is none.
    pub lags: [f64; 4],
    /// Limits of each control.
    pub limits: [ControlLimit; 4],
    /// What each measured quantity is commanded to at a time; constant between the edges of the excitation.
    pub commands: &'a dyn Fn(f64) -> [f64; MEASURED],
    /// States of the law at t = 0; of a control without a lag it follows.
    pub start: [f64; OWN],
}

/// How a control without a lag goes with what is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Way {
    /// It is there.
    #[default]
    There,
    /// It goes after it at its rate, up (1) or down (−1).
    After(f64),
}

/// What holds a control back: the end of its reach, or its rate.
pub(super) type Bites = [[bool; 2]; 4];

/// A moment of a flight: time, state of the body, air, what the pilot does, and the states of the law.
pub(super) struct Moment<'m> {
    pub aircraft: &'m SixDof,
    pub time: f64,
    pub state: State,
    pub wind: Wind,
    pub pilot: Controls,
    pub own: [f64; OWN],
    pub ways: [Way; 4],
}

/// What is asked for at a moment.
pub(super) struct Asked {
    /// What the pilot does.
    held: [f64; 4],
    /// The same as far as the reach goes.
    pilot: [f64; 4],
    /// How far each rate is from what its washout holds \[rad/s\].
    filled: [f64; 2],
    asked: [f64; 4],
    within: [f64; 4],
}

impl Servos<'_> {
    /// Whether the law moves a control.
    fn moves(&self, control: usize) -> bool {
        self.gains[control].iter().any(|gain| *gain != 0.0)
    }

    /// Whether a control is at once what is asked for, as far as its rate lets it.
    fn is_direct(&self, control: usize) -> bool {
        self.moves(control) && self.lags[control] == 0.0
    }

    /// What is asked for at a moment.
    pub(super) fn ask(&self, moment: &Moment<'_>) -> Asked {
        let held = as_array(&moment.pilot);
        let pilot = [0, 1, 2, 3].map(|i| held[i].clamp(self.limits[i].range[0], self.limits[i].range[1]));
        let errors = self.errors(moment.aircraft, moment.time, &moment.state, &moment.wind);
        let filled = WASHED.map(|(signal, z)| errors[signal] - moment.own[z]);
        let asked = self.asked(errors, &moment.own);
        let within = [0, 1, 2, 3].map(|i| self.within(i, asked[i], pilot[i]));
        Asked { held, pilot, filled, asked, within }
    }

    /// Each control, away from the trim.
    pub(super) fn controls(&self, moment: &Moment<'_>, asked: &Asked) -> Controls {
        let [elevator, throttle, aileron, rudder] = [0, 1, 2, 3].map(|i| {
            let own = moment.own[FIRST + i];
            let moved = match moment.ways[i] {
                _ if !self.moves(i) => 0.0,
                Way::There if self.lags[i] == 0.0 => asked.within[i],
                Way::There | Way::After(_) => own,
            };
            let [low, high] = self.limits[i].range;
            (asked.pilot[i] + moved).clamp(low, high)
        });
        Controls { elevator, throttle, aileron, rudder }
    }

    /// Rates of the states of the law.
    pub(super) fn rates(&self, moment: &Moment<'_>, asked: &Asked) -> [f64; OWN] {
        let mut rates = [0.0; OWN];
        for (k, time) in self.washouts.into_iter().enumerate() {
            // ż = (y − z)/T
            rates[k] = if time == 0.0 { 0.0 } else { asked.filled[k] / time };
        }
        for i in 0..4 {
            let fastest = self.limits[i].rate;
            rates[FIRST + i] = match moment.ways[i] {
                Way::After(sense) => sense * fastest,
                Way::There if self.is_direct(i) || !self.moves(i) => 0.0,
                Way::There => self.wanted(i, moment, asked).clamp(-fastest, fastest),
            };
        }
        rates
    }

    /// The rate that an actuator would have without a limit.
    fn wanted(&self, control: usize, moment: &Moment<'_>, asked: &Asked) -> f64 {
        (asked.within[control] - moment.own[FIRST + control]) / self.lags[control]
    }

    /// Where limits hold a control back.
    pub(super) fn bites(&self, moment: &Moment<'_>, asked: &Asked) -> Bites {
        [0, 1, 2, 3].map(|i| {
            let [low, high] = self.limits[i].range;
            // The reach holds the pilot back, or the law in what the pilot leaves of it.
            let reached = asked.pilot[i] + if self.moves(i) { asked.asked[i] } else { 0.0 };
            let is_held = asked.held[i] != asked.pilot[i];
            let slow = match moment.ways[i] {
                Way::After(_) => true,
                Way::There if self.is_direct(i) || !self.moves(i) => false,
                Way::There => self.wanted(i, moment, asked).abs() > self.limits[i].rate,
            };
            [is_held || !(low..=high).contains(&reached), slow]
        })
    }

    /// How controls without a lag go on from a moment: those that what is asked for runs away from go after it, and those that have
    /// met it are there. `rate` is that of the body.
    pub(super) fn turned(&self, moment: &Moment<'_>, asked: &Asked, rate: &State) -> [Way; 4] {
        if (0..4).all(|i| !self.is_direct(i)) {
            return moment.ways;
        }
        let speeds = self.speeds(moment, asked, rate);
        let mut ways = moment.ways;
        for (i, way) in ways.iter_mut().enumerate().filter(|(i, _)| self.is_direct(*i)) {
            let fastest = self.limits[i].rate;
            *way = match *way {
                Way::There if speeds[i].abs() > fastest * (1.0 + THERE) => Way::After(speeds[i].signum()),
                Way::After(sense) if sense * (asked.within[i] - moment.own[FIRST + i]) < -THERE * fastest => {
                    Way::There
                }
                other => other,
            };
        }
        ways
    }

    /// The same where something jumps: a control goes after what has jumped away.
    pub(super) fn jumped(&self, moment: &Moment<'_>, asked: &Asked) -> [Way; 4] {
        let mut ways = moment.ways;
        for (i, way) in ways.iter_mut().enumerate().filter(|(i, _)| self.is_direct(*i)) {
            let left = asked.within[i] - moment.own[FIRST + i];
            let fastest = self.limits[i].rate;
            *way = if fastest.is_finite() && left.abs() > THERE * fastest {
                Way::After(left.signum())
            } else {
                Way::There
            };
        }
        ways
    }

    /// States of the law in which controls that are there stand where they are.
    pub(super) fn settled(&self, moment: &Moment<'_>, asked: &Asked) -> [f64; OWN] {
        let mut own = moment.own;
        for i in (0..4).filter(|&i| self.is_direct(i) && moment.ways[i] == Way::There) {
            own[FIRST + i] = asked.within[i];
        }
        own
    }

    /// How fast what is asked of each control changes \[per s\], by automatic differentiation along the motion.
    fn speeds(&self, moment: &Moment<'_>, asked: &Asked, rate: &State) -> [f64; 4] {
        let (y, y_rate) = (moment.state.to_array(), rate.to_array());
        let state = State::from_array(std::array::from_fn(|k| Dual64::new(y[k], y_rate[k])));
        let Wind { velocity, rate } = moment.wind;
        let wind = Wind {
            velocity: [0, 1, 2].map(|k| Dual64::new(velocity[k], rate[k])),
            rate: rate.map(Dual64::from),
        };
        let own_rates = self.rates(moment, asked);
        let own = std::array::from_fn(|k| Dual64::new(moment.own[k], own_rates[k]));
        let errors = self.errors(moment.aircraft, Dual64::new(moment.time, 1.0), &state, &wind);
        let moving = self.asked(errors, &own);
        [0, 1, 2, 3].map(|i| self.within(i, moving[i], asked.pilot[i]).eps)
    }

    /// How far what is measured is from what is commanded.
    fn errors<T: Real>(&self, aircraft: &SixDof, time: T, state: &State<T>, wind: &Wind<T>) -> [T; MEASURED] {
        let ([u, ..], [p, q, r]) = (state.velocity, state.rates);
        let trim = &aircraft.trim;
        let alpha0 = trim.alpha0 + aircraft.steady.alpha;
        let [u_air, v_air, w_air] = aircraft.through_air(state, wind);
        let [phi, theta, psi] = state.attitude.euler();
        let alpha = w_air.atan2(u_air) - alpha0;
        let beta = v_air.atan2((u_air * u_air + w_air * w_air).sqrt());
        let height = state.position[2] - time * (trim.speed * trim.gamma0.sin());
        let pitch = theta - (trim.theta0() + aircraft.steady.alpha);
        let measured = [u - trim.speed * alpha0.cos(), alpha, q, pitch, height, beta, p, r, phi, psi];
        let commands = (self.commands)(time.re());
        let mut errors = std::array::from_fn(|k| measured[k] - commands[k]);
        // The shorter way round.
        for angle in &mut errors[8..] {
            let turns = (angle.re() / std::f64::consts::TAU).round();
            *angle -= turns * std::f64::consts::TAU;
        }
        errors
    }

    /// What the law asks of each control, before any limit.
    fn asked<T: Real>(&self, mut errors: [T; MEASURED], own: &[T; OWN]) -> [T; 4] {
        for (k, (signal, z)) in WASHED.into_iter().enumerate() {
            if self.washouts[k] != 0.0 {
                errors[signal] -= own[z];
            }
        }
        self.gains.map(|gains| gains.iter().zip(errors).map(|(gain, error)| error * *gain).sum())
    }

    /// What of it the reach lets through beside the pilot.
    fn within<T: Real>(&self, control: usize, asked: T, pilot: f64) -> T {
        let [low, high] = self.limits[control].range;
        asked.at_least(low - pilot).at_most(high - pilot)
    }
}

/// The controls in the order of [`Control::ALL`].
pub fn as_array(controls: &Controls) -> [f64; 4] {
    let Controls { elevator, throttle, aileron, rudder } = *controls;
    Control::ALL.map(|control| match control {
        Control::Elevator => elevator,
        Control::Throttle => throttle,
        Control::Aileron => aileron,
        Control::Rudder => rudder,
    })
}
