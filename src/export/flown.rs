//! The nonlinear flight through the same disturbance.

use serde::Serialize;

use super::signal::Signal;
use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::motion::flight_path::FlightPath;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::response::TimeGrid;
use crate::flight::motion::six_dof::SixDofError;

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
    /// Early end of the flight; null where it flew to the end.
    pub stop: Option<StopReport>,
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
    pub(super) fn of(flight: Result<FlightPath, SixDofError>, model: &PlaneModel, grid: TimeGrid) -> Self {
        let flight = match flight {
            Ok(flight) => flight,
            Err(error) => return Self::Refused { error: error.to_string() },
        };
        let outputs = Output::of(model.plane).iter();
        Self::Flown(FlightReport {
            time: (0..flight.samples.len()).map(|k| grid.time(k)).collect(),
            outputs: outputs.map(|&output| Signal::of(output, output.of_flight(model, &flight))).collect(),
            stop: flight.stop.map(|stop| StopReport { time: stop.time, sentence: stop.to_string() }),
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
