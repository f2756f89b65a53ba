//! Feedback: a law that moves the controls by what the aircraft does, and what becomes of its modes. Without a law it is the one model
//! of an aircraft whose source has states beside the four.
//!
//! ```text
//! law ──► closed_model: the four states, those of the source and of the law, ẋ = A x ──┬──► loop_modes (families, loop_naming)
//!                      (appended: what they are)                                       ├──► loop_response ──► loop_metrics
//!                                                                                      └──► loop_transfer ──► margins
//!     └──► loop_flight: the same law in nonlinear flight
//! ```
//!
//! | file | in one line |
//! |---|---|
//! | [`law`] | gains, washouts and lags, and their signs |
//! | [`appended`] | the states beside the four |
//! | [`closed_model`] | A of the whole |
//! | [`loop_modes`] | its modes, with the participation of every state |
//! | `families` | where each root comes from |
//! | `loop_naming` | the names of the modes |
//! | [`loop_response`] | its motion in time |
//! | [`loop_split`] | the same as the sum of its modes |
//! | [`loop_metrics`] | how fast, how far over and where to a step brings it |
//! | [`loop_flight`] | its nonlinear flight, within the limits of the controls |
//! | [`loop_transfer`] | the loop cut before an actuator, and the answer of the whole, over frequency |
//! | [`loop_curve`] | a loop with all that is drawn of it |
//! | [`margins`] | gain and phase margins, the peak of the sensitivity, Nyquist's count |
//! | [`damping_map`] | the damping over a gain and a washout |
//! | [`loop_analysis`] | all that follows, the one entry point |

pub mod appended;
pub mod closed_model;
pub mod damping_map;
mod families;
pub mod law;
pub mod loop_analysis;
pub mod loop_curve;
pub mod loop_flight;
pub mod loop_metrics;
pub mod loop_modes;
mod loop_naming;
pub mod loop_response;
pub mod loop_split;
pub mod loop_transfer;
pub mod margins;

pub use law::Law;
pub use loop_analysis::{LoopAnalysis, LoopError, analyse_loop};
