//! Experiments: what disturbs an aircraft and for how long it is watched, the same for linear and nonlinear flight.

use nalgebra::{Vector2, Vector4};

use super::aerodynamics::Controls;
use super::command::Command;
use super::flight_path::{Excitation, FlightPath};
use super::gusts::{air_across, air_along, gust, rate_columns};
use super::inputs::Input;
use super::modal_decomposition::single_mode;
use super::path_rates::path_rates;
use super::response::{DrivenSystem, Forcing, TimeGrid};
use super::servos::Servos;
use super::six_dof::{SixDof, SixDofError, Wind};
use crate::flight::aircraft::edits::EditedModel;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::{Lateral, Longitudinal};
use crate::flight::modes::mode::Mode;

/// Where a disturbance enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// The first input of the plane \[rad\]: elevator, trailing edge down positive, or aileron, right one up positive.
    First,
    /// The second: throttle as a fraction of the weight, or rudder \[rad\], trailing edge left positive.
    Second,
    /// Air moving along the flight path \[m/s\], u_g forward positive; it does nothing in the linear lateral plane.
    AirAlong,
    /// Air moving across the flight path \[m/s\]: w_g downward positive, or v_g to the right positive.
    AirAcross,
    /// What a law of feedback is told to bring the aircraft to; without a law it does nothing.
    Command(Command),
}

/// The state in which a motion begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// Steady flight.
    Rest,
    /// Away from it: \[u, α, q, θ\] or \[β, p, r, φ\], SI and radians.
    Released([f64; 4]),
    /// In one mode alone.
    Mode {
        /// Its place in the order of the modes; the last one where there are fewer.
        index: usize,
        /// Size of its flow angle or attitude, whichever is the larger \[rad\].
        amplitude: f64,
    },
}

/// Disturbances that act together, and the time for which the motion is watched.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// The plane that they disturb.
    pub plane: Plane,
    /// Where each enters, and its shape in time.
    pub inputs: Vec<(Channel, Input)>,
    /// How it begins.
    pub start: Start,
    /// The samples at which the motion is wanted.
    pub grid: TimeGrid,
}

/// The linear equations of a plane with what drives them; `modes` are those of the model, of which one may be the start.
pub fn forced(
    edited: &EditedModel,
    model: &PlaneModel,
    inputs: &[(Channel, Input)],
    start: Start,
    modes: &[Mode],
) -> DrivenSystem {
    let (plane, alpha0) = (model.plane, model.trim.alpha0);
    let of_rate = || rate_columns(plane, edited.derivatives().ok().flatten().as_ref());
    let forcing = |(channel, input): &(Channel, Input)| {
        let input = input.clone();
        match channel {
            Channel::First => Forcing::of_control(model.b.column(0).into_owned(), 0, input),
            Channel::Second => Forcing::of_control(model.b.column(1).into_owned(), 1, input),
            Channel::AirAlong => gust(model, air_along(plane, alpha0), of_rate()[0], input),
            Channel::AirAcross => gust(model, air_across(plane, alpha0), of_rate()[1], input),
            Channel::Command(command) => Forcing::commanding(*command, input),
        }
    };
    let (start, start_path) = initial(model, start, modes);
    DrivenSystem {
        a: model.a,
        path: path_rates(model),
        forcings: inputs.iter().map(forcing).collect(),
        start,
        start_path,
    }
}

/// The same experiment in nonlinear flight, all six degrees of freedom, from the aircraft's own trim. `model` and `modes` are of
/// the linear model, in which the start is told.
pub fn fly(
    edited: &EditedModel,
    model: &PlaneModel,
    modes: &[Mode],
    experiment: &Experiment,
) -> Result<FlightPath, SixDofError> {
    let aircraft = SixDof::new(edited)?;
    Ok(fly_from(&aircraft, initial(model, experiment.start, modes), experiment, None))
}

/// The flight of an aircraft from a state and a place on the path of its plane, with a law of feedback or without.
pub fn fly_from(
    aircraft: &SixDof,
    (start, path): (Vector4<f64>, Vector2<f64>),
    experiment: &Experiment,
    servos: Option<&Servos<'_>>,
) -> FlightPath {
    let inputs = &experiment.inputs;
    let of = |channel: Channel, t: f64| -> f64 {
        inputs.iter().filter(|(of, _)| *of == channel).map(|(_, input)| input.at(t)).sum()
    };
    let rate_of = |channel: Channel, t: f64| -> f64 {
        inputs.iter().filter(|(of, _)| *of == channel).map(|(_, input)| input.rate(t)).sum()
    };
    let plane = experiment.plane;
    let controls = |t: f64| {
        let (first, second) = (of(Channel::First, t), of(Channel::Second, t));
        match plane {
            Plane::Longitudinal => Controls { elevator: first, throttle: second, ..Controls::default() },
            Plane::Lateral => Controls { aileron: first, rudder: second, ..Controls::default() },
        }
    };
    let wind = |t: f64| {
        let [along, across] = [Channel::AirAlong, Channel::AirAcross].map(|channel| of(channel, t));
        let [along_rate, rate] = [Channel::AirAlong, Channel::AirAcross].map(|channel| rate_of(channel, t));
        match plane {
            Plane::Longitudinal => Wind { velocity: [along, 0.0, across], rate: [along_rate, 0.0, rate] },
            Plane::Lateral => Wind { velocity: [along, across, 0.0], rate: [along_rate, rate, 0.0] },
        }
    };
    let edges: Vec<f64> = inputs.iter().flat_map(|(_, input)| input.edges()).collect();
    let none = Vector4::zeros();
    let (longitudinal, lateral, heading, position) = match plane {
        Plane::Longitudinal => (start, none, 0.0, [path[0], 0.0, path[1]]),
        Plane::Lateral => (none, start, path[0], [0.0, path[1], 0.0]),
    };
    let excitation = Excitation {
        controls: &controls,
        wind: &wind,
        edges: &edges,
        longitudinal,
        lateral,
        heading,
        position,
        servos,
    };
    aircraft.fly(&excitation, experiment.grid)
}

/// State and path at t = 0.
fn initial(model: &PlaneModel, start: Start, modes: &[Mode]) -> (Vector4<f64>, Vector2<f64>) {
    let at_rest = (Vector4::zeros(), Vector2::zeros());
    match start {
        Start::Rest => at_rest,
        Start::Released([first, second, third, fourth]) => {
            let speed = model.trim.speed;
            let state = match model.plane {
                Plane::Longitudinal => Vector4::new(first, second * speed, third, fourth),
                Plane::Lateral => Vector4::new(first * speed, second, third, fourth),
            };
            (state, Vector2::zeros())
        }
        Start::Mode { index, amplitude } => {
            let mode = modes.get(index).or(modes.last());
            mode.map_or(at_rest, |mode| single_mode(mode, angles(model), &path_rates(model), amplitude))
        }
    }
}

/// Rows that read the flow angle and the attitude off the states: w/V and θ, or v/V and φ.
pub fn angles(model: &PlaneModel) -> [Vector4<f64>; 2] {
    let (flow, attitude) = match model.plane {
        Plane::Longitudinal => (Longitudinal::W.index(), Longitudinal::Theta.index()),
        Plane::Lateral => (Lateral::V.index(), Lateral::Phi.index()),
    };
    [Vector4::ith(flow, 1.0 / model.trim.speed), Vector4::ith(attitude, 1.0)]
}
