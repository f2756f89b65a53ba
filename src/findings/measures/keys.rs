//! The keys of measures, and the measures by their keys.

use super::{AircraftQuantity, LoopOf, LoopQuantity, Measure, Metric, ModeQuantity, PlaneQuantity};
use crate::flight::aircraft::plane::Plane;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::motion::outputs::Output;
use crate::key::Keyed;
use crate::scenario::Parameter;

/// The subject of parameters.
const PARAMETER: &str = "parameter";

impl Measure {
    /// Its key.
    pub fn key(self) -> String {
        match self {
            Self::OfMode(name, quantity) => format!("{}.{}", underscored(name.key()), quantity.key()),
            Self::OfPlane(plane, quantity) => format!("{}.{}", plane.key(), quantity.key()),
            Self::OfLoop(of, quantity) => format!("{}.{}", of.key(), quantity.key()),
            Self::OfAircraft(quantity) => quantity.key().to_owned(),
            Self::OfOutput(output, metric) => format!("{}.{}", metric.key(), output.key()),
            Self::OfParameter(parameter) => format!("{PARAMETER}.{}", parameter.key),
        }
    }

    /// The measure by a key, or by another spelling of it: case doesn't matter, nor hyphens for underscores.
    pub fn find(key: &str) -> Option<Self> {
        let Some((subject, quantity)) = key.split_once('.') else {
            return AircraftQuantity::by_key(key).map(Self::OfAircraft);
        };
        if subject == PARAMETER {
            return Parameter::find(quantity).map(Self::OfParameter);
        }
        if let Some(metric) = Metric::by_key(subject) {
            return Some(Self::OfOutput(Output::by_key(quantity)?, metric));
        }
        if let Some(plane) = Plane::by_key(subject) {
            return Some(Self::OfPlane(plane, PlaneQuantity::by_key(quantity)?));
        }
        if let Some(of) = LoopOf::by_key(subject) {
            return Some(Self::OfLoop(of, LoopQuantity::by_key(quantity)?));
        }
        Some(Self::OfMode(ModeName::by_key(subject)?, ModeQuantity::by_key(quantity)?))
    }
}

fn underscored(key: &str) -> String {
    key.replace('-', "_")
}
