//! What can be watched of a motion: states, flow angles, path, attitude of the path and load factors, all linear in the
//! disturbance.

use std::f64::consts::TAU;

use nalgebra::{Vector2, Vector4};

use super::command::Command;
use super::flight_path::{FlightPath, Sample};
use super::response::{DrivenSystem, Response};
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::{Lateral, Longitudinal};
use crate::key::keys;

/// Something to watch, as a change from the steady flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Forward speed u \[m/s\], faster positive.
    ForwardSpeed,
    /// Velocity along z, w \[m/s\], downward positive.
    DownSpeed,
    /// Angle of attack relative to the air α \[rad\], wind from below positive: in a gust, of the gust as well.
    AngleOfAttack,
    /// Pitch rate q \[rad/s\], nose-up positive.
    PitchRate,
    /// Pitch angle θ \[rad\], nose-up positive.
    PitchAngle,
    /// Flight-path angle γ \[rad\], climbing positive; of the path over the Earth.
    PathAngle,
    /// Load factor normal to the flight path n_z, in units of g, felt pressed into the seat positive.
    NormalLoad,
    /// Height h \[m\] gained on the steady flight.
    Height,
    /// Distance x \[m\] gained on the steady flight.
    Distance,
    /// Sideways velocity v \[m/s\], to the right positive.
    SideSpeed,
    /// Sideslip relative to the air β \[rad\], wind from the right positive.
    Sideslip,
    /// Roll rate p \[rad/s\], right wing down positive.
    RollRate,
    /// Yaw rate r \[rad/s\], nose right positive.
    YawRate,
    /// Bank angle φ \[rad\], right wing down positive.
    BankAngle,
    /// Lateral load factor n_y, in units of g, pushed to the right positive.
    SideLoad,
    /// Heading ψ \[rad\], nose right positive.
    Heading,
    /// Sideways displacement y \[m\], to the right positive.
    Offset,
}

keys! {
    Output {
        ForwardSpeed => "u",
        AngleOfAttack => "alpha",
        PitchRate => "q",
        PitchAngle => "theta",
        PathAngle => "gamma",
        NormalLoad => "nz",
        Height => "h",
        Distance => "x",
        DownSpeed => "w",
        Sideslip => "beta",
        RollRate => "p",
        YawRate => "r",
        BankAngle => "phi",
        Heading => "psi",
        SideLoad => "ny",
        Offset => "y",
        SideSpeed => "v",
    }
}

/// An output as a sum: y = c · x + k · path + Σ (d δ + ḋ δ̇) over the inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputRow {
    /// c, of the states.
    pub states: Vector4<f64>,
    /// k, of the path.
    pub path: Vector2<f64>,
    /// (d, ḋ) of each input and its rate.
    pub inputs: Vec<(f64, f64)>,
}

impl Output {
    /// The states of a plane, in the order of the state vector.
    pub const fn states(plane: Plane) -> [Self; 4] {
        match plane {
            Plane::Longitudinal => [Self::ForwardSpeed, Self::DownSpeed, Self::PitchRate, Self::PitchAngle],
            Plane::Lateral => [Self::SideSpeed, Self::RollRate, Self::YawRate, Self::BankAngle],
        }
    }

    /// The outputs of a plane, states first.
    pub const fn of(plane: Plane) -> &'static [Self] {
        match plane {
            Plane::Longitudinal => &[
                Self::ForwardSpeed,
                Self::AngleOfAttack,
                Self::PitchRate,
                Self::PitchAngle,
                Self::PathAngle,
                Self::NormalLoad,
                Self::Height,
                Self::Distance,
                Self::DownSpeed,
            ],
            Plane::Lateral => &[
                Self::Sideslip,
                Self::RollRate,
                Self::YawRate,
                Self::BankAngle,
                Self::Heading,
                Self::SideLoad,
                Self::Offset,
                Self::SideSpeed,
            ],
        }
    }

    /// The plane in which it moves.
    pub const fn plane(self) -> Plane {
        match self {
            Self::ForwardSpeed
            | Self::DownSpeed
            | Self::AngleOfAttack
            | Self::PitchRate
            | Self::PitchAngle
            | Self::PathAngle
            | Self::NormalLoad
            | Self::Height
            | Self::Distance => Plane::Longitudinal,
            Self::SideSpeed
            | Self::Sideslip
            | Self::RollRate
            | Self::YawRate
            | Self::BankAngle
            | Self::SideLoad
            | Self::Heading
            | Self::Offset => Plane::Lateral,
        }
    }

    /// What a command is of.
    pub const fn commanded(command: Command) -> Self {
        match command {
            Command::Speed => Self::ForwardSpeed,
            Command::PitchAngle => Self::PitchAngle,
            Command::Height => Self::Height,
            Command::YawRate => Self::YawRate,
            Command::BankAngle => Self::BankAngle,
            Command::Heading => Self::Heading,
        }
    }

    /// The output as a sum over states, path and inputs. An output of the other plane is zero.
    pub fn row(self, model: &PlaneModel, forced: &DrivenSystem) -> OutputRow {
        let trim = &model.trim;
        let (u0, w0, v) = (trim.u0(), trim.w0(), trim.speed);
        let mut row = OutputRow {
            states: Vector4::zeros(),
            path: Vector2::zeros(),
            inputs: vec![(0.0, 0.0); forced.forcings.len()],
        };
        if self.plane() != model.plane {
            return row;
        }
        use Lateral::{P, Phi, R, V};
        use Longitudinal::{Q, Theta, U, W};
        match self {
            Self::ForwardSpeed => row.states[U.index()] = 1.0,
            Self::DownSpeed => row.states[W.index()] = 1.0,
            Self::PitchRate => row.states[Q.index()] = 1.0,
            Self::PitchAngle => row.states[Theta.index()] = 1.0,
            Self::SideSpeed => row.states[V.index()] = 1.0,
            Self::RollRate => row.states[P.index()] = 1.0,
            Self::YawRate => row.states[R.index()] = 1.0,
            Self::BankAngle => row.states[Phi.index()] = 1.0,
            Self::Distance | Self::Heading => row.path[0] = 1.0,
            Self::Height | Self::Offset => row.path[1] = 1.0,
            Self::AngleOfAttack => {
                // α = ((w − w_g) U₀ − (u − u_g) W₀)/V²
                row.states = Vector4::new(-w0, u0, 0.0, 0.0) / (v * v);
                row.subtract_air(forced);
            }
            Self::Sideslip => {
                // β = (v − v_g)/V
                row.states[V.index()] = 1.0 / v;
                row.subtract_air(forced);
            }
            Self::PathAngle => {
                // γ = θ − (w U₀ − u W₀)/V²: how the path climbs, whatever the air does
                row.states = Vector4::new(w0, -u0, 0.0, v * v) / (v * v);
            }
            Self::NormalLoad => {
                // Across the trimmed flight path: n_z = (f_x sin α₀ − f_z cos α₀)/g with
                // f_x = u̇ + W₀ q + g cos θ₀ θ,   f_z = ẇ − U₀ q + g sin θ₀ θ
                let (sin, cos) = trim.alpha0.sin_cos();
                row.add_rate(forced, U.index(), sin);
                row.add_rate(forced, W.index(), -cos);
                row.states[Q.index()] += w0 * sin + u0 * cos;
                let (sin_theta, cos_theta) = trim.theta0().sin_cos();
                row.states[Theta.index()] += trim.gravity * (cos_theta * sin - sin_theta * cos);
                row.scale(1.0 / trim.gravity);
            }
            Self::SideLoad => {
                // f_y = v̇ + U₀ r − W₀ p − g cos θ₀ φ,   n_y = f_y/g
                row.add_rate(forced, V.index(), 1.0);
                row.states[R.index()] += u0;
                row.states[P.index()] -= w0;
                row.states[Phi.index()] -= trim.gravity * trim.theta0().cos();
                row.scale(1.0 / trim.gravity);
            }
        }
        row
    }
}

impl Output {
    /// The same of a nonlinear flight at its samples, as a change from the steady flight of `model`.
    pub fn of_flight(self, model: &PlaneModel, flight: &FlightPath) -> Vec<f64> {
        let samples = flight.samples.iter().enumerate();
        let mut values: Vec<f64> =
            samples.map(|(k, sample)| self.of_sample(model, sample, k as f64 * flight.dt)).collect();
        if matches!(self, Self::Heading | Self::BankAngle) {
            // Round and round: the same angle, on the turn nearest to the last.
            for k in 1..values.len() {
                values[k] += TAU * ((values[k - 1] - values[k]) / TAU).round();
            }
        }
        values
    }

    /// The same at a time \[s\], straight between the samples.
    pub fn of_flight_at(self, model: &PlaneModel, flight: &FlightPath, t: f64) -> f64 {
        let last = flight.samples.len().saturating_sub(1);
        let position = if flight.dt > 0.0 { (t / flight.dt).clamp(0.0, last as f64) } else { 0.0 };
        let k = position as usize;
        let at = |k: usize| {
            flight.samples.get(k).map_or(0.0, |sample| self.of_sample(model, sample, k as f64 * flight.dt))
        };
        let (before, after) = (at(k), at((k + 1).min(last)));
        let mut change = after - before;
        if matches!(self, Self::Heading | Self::BankAngle) {
            // The shorter way round.
            change -= TAU * (change / TAU).round();
        }
        before + position.fract() * change
    }

    /// At one sample, time t \[s\], as a change from the steady flight of `model`.
    fn of_sample(self, model: &PlaneModel, sample: &Sample, t: f64) -> f64 {
        let trim = &model.trim;
        let [phi, theta, psi] = sample.euler;
        let [u, w, q, _] = sample.longitudinal.into();
        let [v, p, r, _] = sample.lateral.into();
        let [north, east, up] = sample.position;
        match self {
            Self::ForwardSpeed => u,
            Self::DownSpeed => w,
            Self::AngleOfAttack => sample.alpha,
            Self::PitchRate => q,
            Self::PitchAngle => theta - trim.theta0(),
            Self::PathAngle => {
                let velocity = [trim.u0() + u, v, trim.w0() + w];
                let [ahead, across, down] = sample.attitude.to_earth(velocity);
                (-down).atan2(ahead.hypot(across)) - trim.gamma0
            }
            Self::NormalLoad => sample.n_z - trim.gamma0.cos(),
            Self::Height => up - trim.speed * trim.gamma0.sin() * t,
            Self::Distance => north - trim.speed * trim.gamma0.cos() * t,
            Self::SideSpeed => v,
            Self::Sideslip => sample.beta,
            Self::RollRate => p,
            Self::YawRate => r,
            Self::BankAngle => phi,
            Self::SideLoad => sample.n_y,
            Self::Heading => psi,
            Self::Offset => east,
        }
    }
}

impl OutputRow {
    /// The rate of a state, from its equation, times a factor.
    fn add_rate(&mut self, forced: &DrivenSystem, state: usize, factor: f64) {
        self.states += forced.a.row(state).transpose() * factor;
        for (input, forcing) in self.inputs.iter_mut().zip(&forced.forcings) {
            input.0 += forcing.column[state] * factor;
            input.1 += forcing.rate_column[state] * factor;
        }
    }

    /// For a flow angle: what is felt is the velocity relative to the air.
    fn subtract_air(&mut self, forced: &DrivenSystem) {
        for (input, forcing) in self.inputs.iter_mut().zip(&forced.forcings) {
            input.0 -= self.states.dot(&forcing.air);
        }
    }

    fn scale(&mut self, factor: f64) {
        self.states *= factor;
        for input in &mut self.inputs {
            *input = (input.0 * factor, input.1 * factor);
        }
    }

    /// Its values at the samples of a response to `forced`.
    pub fn of<'a>(
        &'a self,
        forced: &'a DrivenSystem,
        response: &'a Response,
    ) -> impl Iterator<Item = f64> + 'a {
        response.states.iter().zip(&response.path).enumerate().map(move |(k, (x, path))| {
            self.states.dot(x) + self.path.dot(path) + self.direct(forced, k as f64 * response.dt)
        })
    }

    /// The part that the inputs make at once, without the aircraft having moved, at time t \[s\].
    pub fn direct(&self, forced: &DrivenSystem, t: f64) -> f64 {
        let parts = self.inputs.iter().zip(&forced.forcings);
        parts
            .filter(|((d, of_rate), _)| *d != 0.0 || *of_rate != 0.0)
            .map(|((d, of_rate), forcing)| d * forcing.input.at(t) + of_rate * forcing.input.rate(t))
            .sum()
    }
}
