//! The nonlinear flight through the same disturbance.

use serde::Serialize;

use super::respond::Signal;
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
    /// Why the aircraft can't be flown.
    Refused {
        /// In one sentence.
        error: String,
    },
}

/// A nonlinear flight in six degrees of freedom.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Flight"))]
pub struct FlightReport {
    /// Times of its samples \[s\]: those of the linear motion until it stops, and on where that is cut.
    pub time: Vec<f64>,
    /// What moves, as a change from the steady flight, in the order of the linear motion's outputs.
    pub outputs: Vec<Signal>,
    /// Where and why it stopped; null where it flew to the end.
    pub stop: Option<StopReport>,
}

/// Where a flight stopped.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Stop"))]
pub struct StopReport {
    /// When \[s\].
    pub time: f64,
    /// Why, with the time, in one sentence.
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
