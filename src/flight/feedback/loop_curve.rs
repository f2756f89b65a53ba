//! A loop cut before its actuator, with all that is drawn and told of it.

use super::closed_model::ClosedModel;
use super::loop_transfer::LoopTransfer;
use super::margins::LoopMargins;
use crate::flight::motion::frequency_response::FrequencyPoint;
use crate::flight::motion::transfer_function::TransferFunction;

/// The loop of one input over frequency.
#[derive(Clone, Debug)]
pub struct LoopCurve {
    /// L.
    pub transfer: LoopTransfer,
    /// Its margins.
    pub margins: LoopMargins,
    /// L(jω), close enough that nothing is missed, from far below its slowest root to far above its fastest.
    pub points: Vec<FrequencyPoint>,
    /// L in factored form; `None` where its roots can't be had.
    pub function: Option<TransferFunction>,
}

impl LoopCurve {
    /// The loop of an input with the margins that it has; `None` where nothing is asked of it, or its roots can't be had.
    pub fn of(closed: &ClosedModel, input: usize, margins: LoopMargins) -> Option<Self> {
        let transfer = LoopTransfer::of(closed, input).ok()??;
        let (points, function) = (transfer.curve(), transfer.factored().ok());
        Some(Self { transfer, margins, points, function })
    }
}
