//! The nonlinear flight through the same disturbance.

use serde::Serialize;

use super::signal::Signal;
use crate::flight::Experiment;
use crate::flight::analysis::PlaneAnalysis;
use crate::flight::motion::experiment::fly;
use crate::flight::motion::outputs::Output;
use crate::scenario::Scenario;

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
    pub(super) fn of(scenario: &Scenario, analysed: &PlaneAnalysis, experiment: &Experiment) -> Self {
        let flight = match fly(&scenario.edited, &analysed.model, &analysed.modes, experiment) {
            Ok(flight) => flight,
            Err(error) => return Self::Refused { error: error.to_string() },
        };
        let outputs = Output::of(experiment.plane).iter();
        Self::Flown(FlightReport {
            time: (0..flight.samples.len()).map(|k| experiment.grid.time(k)).collect(),
            outputs: outputs
                .map(|&output| Signal::of(output, output.of_flight(&analysed.model, &flight)))
                .collect(),
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
