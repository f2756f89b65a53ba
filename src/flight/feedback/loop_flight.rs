//! Nonlinear flight under a law: the same gains, washouts and lags, in both planes, with the limits of the controls.

use nalgebra::Vector4;

use super::appended::AppendedState;
use super::law::{Law, SIGNALS, signals};
use super::loop_analysis::LoopAnalysis;
use crate::flight::aircraft::edits::EditedModel;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::modes::mode::Mode;
use crate::flight::motion::control_limits::{ControlLimit, NamedLimits};
use crate::flight::motion::experiment::{Channel, Experiment, Start, fly_from, forced};
use crate::flight::motion::flight_path::FlightPath;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::servos::{MEASURED, OWN, Servos};
use crate::flight::motion::six_dof::{SixDof, SixDofError};

/// The linear motion beside which a flight is flown: where it begins is told there.
#[derive(Clone, Copy)]
pub struct Beside<'a> {
    /// The model without the law.
    pub model: &'a PlaneModel,
    /// Its modes.
    pub modes: &'a [Mode],
    /// The analysis of its plane under the law; `None` where nothing is fed back there.
    pub closed: Option<&'a LoopAnalysis>,
}

/// An experiment in nonlinear flight under a law, from the aircraft's own trim.
pub fn fly_closed(
    edited: &EditedModel,
    law: &Law,
    limits: &NamedLimits,
    beside: Beside<'_>,
    experiment: &Experiment,
) -> Result<FlightPath, SixDofError> {
    let aircraft = SixDof::new(edited)?;
    let Beside { model, modes, closed } = beside;
    let open = forced(edited, model, &[], experiment.start, modes);
    let (mut start, mut path, mut own) = (open.start, open.start_path, [0.0; OWN]);
    if let (Some(closed), Start::Mode { .. }) = (closed, experiment.start) {
        let (whole, of_mode) = closed.start(&open, experiment.start);
        start = Vector4::from_fn(|k, _| whole[k]);
        path = of_mode;
        for (state, value) in closed.closed.appended.iter().zip(whole.iter().skip(4)) {
            match place(*state) {
                Place::Path(coordinate) => path[coordinate] = *value,
                Place::Own(k) => own[k] = *value,
                Place::None => {}
            }
        }
    }
    let commands = commands(experiment);
    let servos = servos(law, limits.or_usual(&aircraft), own, &commands);
    Ok(fly_from(&aircraft, (start, path), experiment, Some(&servos)))
}

/// A law in the terms of nonlinear flight.
fn servos<'a>(
    law: &Law,
    limits: [ControlLimit; 4],
    start: [f64; OWN],
    commands: &'a dyn Fn(f64) -> [f64; MEASURED],
) -> Servos<'a> {
    let planes = &law.planes;
    let mut gains = [[0.0; MEASURED]; 4];
    for (plane, first) in [(Plane::Longitudinal, 0), (Plane::Lateral, 2)] {
        for (input, of_input) in planes[plane].gains().into_iter().enumerate() {
            let from = SIGNALS * plane as usize;
            gains[first + input][from..from + SIGNALS].copy_from_slice(of_input);
        }
    }
    let ([elevator, throttle], [aileron, rudder]) = (law.lags(Plane::Longitudinal), law.lags(Plane::Lateral));
    Servos {
        gains,
        washouts: [planes.longitudinal.washout, planes.lateral.washout],
        lags: [elevator, throttle, aileron, rudder],
        limits,
        commands,
        start,
    }
}

/// What is commanded at a time, in the order of what is measured.
fn commands(experiment: &Experiment) -> impl Fn(f64) -> [f64; MEASURED] + '_ {
    let from = SIGNALS * experiment.plane as usize;
    move |time| {
        let mut commands = [0.0; MEASURED];
        for (channel, input) in &experiment.inputs {
            let Channel::Command(command) = channel else { continue };
            let output = Output::commanded(*command);
            let signal = signals(experiment.plane).iter().position(|signal| *signal == output);
            if let Some(signal) = signal {
                commands[from + signal] += input.at(time);
            }
        }
        commands
    }
}

/// Where a state of a law is in nonlinear flight.
enum Place {
    /// A coordinate of the path.
    Path(usize),
    /// One of the law's own.
    Own(usize),
    /// Nowhere: bare matrices have no nonlinear flight.
    None,
}

const fn place(state: AppendedState) -> Place {
    match state {
        AppendedState::Heading | AppendedState::Distance => Place::Path(0),
        AppendedState::Height | AppendedState::Offset => Place::Path(1),
        AppendedState::PitchRateWashout => Place::Own(0),
        AppendedState::YawRateWashout => Place::Own(1),
        AppendedState::Elevator => Place::Own(2),
        AppendedState::Throttle => Place::Own(3),
        AppendedState::Aileron => Place::Own(4),
        AppendedState::Rudder => Place::Own(5),
        AppendedState::Engine | AppendedState::Other => Place::None,
    }
}
