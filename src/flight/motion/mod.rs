//! Motion in time: what disturbs an aircraft, and how it answers, linearly and in six degrees of freedom.
//!
//! ```text
//! inputs, gusts, turbulence ──► experiment ──┬──► response (linear, exact) ──► outputs, modal_decomposition, course, response_metrics
//!                                            │                 frequency_response: the same over frequency
//!                                            │                 transfer_function: the same by its zeros and poles
//!                                            └──► six_dof ──► flight_path (rigid_body, aerodynamics, servos, integrator)
//! ```
//!
//! `small_disturbance` tells how far the linear answer means anything.

pub mod aerodynamics;
pub mod command;
pub mod control_limits;
pub mod course;
pub mod experiment;
pub mod flight_path;
pub mod frequency_response;
pub mod gusts;
pub mod inputs;
pub mod integrator;
pub mod modal_decomposition;
pub mod outputs;
pub mod path_rates;
pub mod response;
pub mod response_metrics;
pub mod rigid_body;
pub mod servos;
pub mod six_dof;
pub mod small_disturbance;
pub mod transfer_function;
pub mod turbulence;
