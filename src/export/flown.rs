//! The nonlinear flight through the same disturbance.

use serde::Serialize;

use super::signal::Signal;
use crate::content::LengthUnit;
use crate::flight::Channel;
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::motion::flight_path::{Bite, FlightPath, Limited};
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::TimeGrid;
use crate::flight::motion::six_dof::SixDofError;
use crate::scenario::Quantity;
use crate::words::{self, Told};

/// A nonlinear flight, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum FlightOutcome {
    /// The flight.
    Flown(FlightReport),
    /// Refusal: the aircraft can't be flown.
    Refused {
        /// Reason, in one sentence.
        error: String,
    },
}

/// A nonlinear flight in six degrees of freedom.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Flight"))]
pub struct FlightReport {
    /// Times of its samples \[s\]: those of the linear motion until it stops, and on where that is cut.
    pub time: Vec<f64>,
    /// Outputs, as changes from the steady flight, in the order of the linear motion's.
    pub outputs: Vec<Signal>,
    /// Controls of the plane away from the steady flight, with what a law of feedback moves, at these times.
    pub controls: Vec<Signal>,
    /// Where limits of the controls hold a law back, or the pilot under one; none without a law.
    pub limits: Vec<LimitReport>,
    /// The same in sentences, one a limit.
    pub limit_sentences: Vec<String>,
    /// Early end of the flight; null where it flew to the end.
    pub stop: Option<StopReport>,
}

/// A time through which a limit holds a control back.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "AtLimit"))]
pub struct LimitReport {
    /// Key of the control.
    pub control: &'static str,
    /// `deflection` or `rate`.
    pub limit: &'static str,
    /// From when \[s\].
    pub from: f64,
    /// Until when \[s\].
    pub until: f64,
}

/// Early end of a flight.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Stop"))]
pub struct StopReport {
    /// Time \[s\].
    pub time: f64,
    /// Reason with the time, in one sentence.
    pub sentence: String,
}

impl FlightOutcome {
    /// The flight as it is told, at the times of `grid`; `model` is the linear one.
    pub(super) fn of(
        flight: Result<FlightPath, SixDofError>,
        model: &PlaneModel,
        grid: TimeGrid,
        length: LengthUnit,
    ) -> Self {
        let flight = match flight {
            Ok(flight) => flight,
            Err(error) => return Self::Refused { error: Told(&error, length).to_string() },
        };
        let outputs = Output::of(model.plane).iter();
        Self::Flown(FlightReport {
            time: (0..flight.samples.len()).map(|k| grid.time(k)).collect(),
            outputs: outputs.map(|&output| Signal::of(output, output.of_flight(model, &flight))).collect(),
            controls: [(0, Channel::First), (1, Channel::Second)]
                .map(|of| control(&flight, model.plane, of))
                .into(),
            limits: flight.bites.iter().map(LimitReport::of).collect(),
            limit_sentences: words::limits::sentences(&flight.bites),
            stop: flight
                .stop
                .map(|stop| StopReport { time: stop.time, sentence: Told(&stop, length).to_string() }),
        })
    }

    /// The flight, if there is one.
    pub fn flight(&self) -> Option<&FlightReport> {
        match self {
            Self::Flown(flight) => Some(flight),
            Self::Refused { .. } => None,
        }
    }
}

/// A control at the samples.
fn control(flight: &FlightPath, plane: Plane, (input, channel): (usize, Channel)) -> Signal {
    let Quantity { key, dimension, .. } = Quantity::of_input(plane, channel);
    let values = flight.samples.iter().map(|sample| sample.inputs(plane)[input]).collect();
    Signal { name: key, unit: dimension.si_symbol(), values }
}

impl LimitReport {
    fn of(bite: &Bite) -> Self {
        let Bite { control, limit, from, until } = *bite;
        let limit = match limit {
            Limited::Deflection => "deflection",
            Limited::Rate => "rate",
        };
        Self { control: words::limits::control(control), limit, from, until }
    }
}
