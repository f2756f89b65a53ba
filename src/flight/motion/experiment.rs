//! Experiments: what disturbs an aircraft and for how long it is watched, the same for linear and nonlinear flight.

use nalgebra::Vector4;

use super::aerodynamics::Controls;
use super::flight_path::{Excitation, FlightPath};
use super::gusts::{air_across, air_along, gust, penetration_column};
use super::inputs::Input;
use super::modal_sum::single_mode;
use super::path_rates::path_rates;
use super::response::{Forced, Forcing, TimeGrid};
use super::six_dof::{SixDof, SixDofError, Wind};
use crate::flight::aircraft::edits::Edited;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::aircraft::states::{Lateral, Longitudinal};
use crate::flight::modes::mode::Mode;

/// Where a disturbance enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// The first input of the plane \[rad\]: elevator, trailing edge down positive, or aileron in the source's sense.
    First,
    /// The second: throttle as a fraction of the weight, or rudder \[rad\], trailing edge left positive.
    Second,
    /// Air moving along the flight \[m/s\], u_g forward positive; it does nothing in the linear lateral plane.
    AirAlong,
    /// Air moving across the flight \[m/s\]: w_g downward positive, or v_g to the right positive.
    AirAcross,
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
    edited: &Edited,
    model: &PlaneModel,
    inputs: &[(Channel, Input)],
    start: Start,
    modes: &[Mode],
) -> Forced {
    let plane = model.plane;
    let forcing = |(channel, input): &(Channel, Input)| {
        let input = input.clone();
        match channel {
            Channel::First => Forcing::new(model.b.column(0).into_owned(), input),
            Channel::Second => Forcing::new(model.b.column(1).into_owned(), input),
            Channel::AirAlong => gust(model, air_along(plane), Vector4::zeros(), input),
            Channel::AirAcross => {
                let derivatives = edited.derivatives().ok().flatten();
                gust(model, air_across(plane), penetration_column(plane, derivatives.as_ref()), input)
            }
        }
    };
    Forced {
        a: model.a,
        path: path_rates(model),
        forcings: inputs.iter().map(forcing).collect(),
        start: initial_state(model, start, modes),
    }
}

/// The same experiment in nonlinear flight, all six degrees of freedom, from the aircraft's own trim. `model` and `modes` are of
/// the linear model, in which the start is told.
pub fn fly(
    edited: &Edited,
    model: &PlaneModel,
    modes: &[Mode],
    experiment: &Experiment,
) -> Result<FlightPath, SixDofError> {
    let aircraft = SixDof::new(edited)?;
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
        let (along, across, rate) =
            (of(Channel::AirAlong, t), of(Channel::AirAcross, t), rate_of(Channel::AirAcross, t));
        match plane {
            Plane::Longitudinal => Wind { velocity: [along, 0.0, across], rate: [0.0, 0.0, rate] },
            Plane::Lateral => Wind { velocity: [along, across, 0.0], rate: [0.0, rate, 0.0] },
        }
    };
    let edges: Vec<f64> = inputs.iter().flat_map(|(_, input)| input.edges()).collect();
    let start = initial_state(model, experiment.start, modes);
    let (longitudinal, lateral) = match plane {
        Plane::Longitudinal => (start, Vector4::zeros()),
        Plane::Lateral => (Vector4::zeros(), start),
    };
    let excitation = Excitation { controls: &controls, wind: &wind, edges: &edges, longitudinal, lateral };
    Ok(aircraft.fly(&excitation, experiment.grid))
}

fn initial_state(model: &PlaneModel, start: Start, modes: &[Mode]) -> Vector4<f64> {
    match start {
        Start::Rest => Vector4::zeros(),
        Start::Released([first, second, third, fourth]) => {
            let speed = model.trim.speed;
            match model.plane {
                Plane::Longitudinal => Vector4::new(first, second * speed, third, fourth),
                Plane::Lateral => Vector4::new(first * speed, second, third, fourth),
            }
        }
        Start::Mode { index, amplitude } => {
            let mode = modes.get(index).or(modes.last());
            mode.map_or_else(Vector4::zeros, |mode| single_mode(mode, angles(model), amplitude))
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
