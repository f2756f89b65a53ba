//! An aircraft in steady flight: from the numbers of a source to the linear models of both planes.
//!
//! ```text
//! coefficients, knobs ──► condition (trim) ──► derivatives ──► plane: ẋ = A x + B δ
//!        aircraft_model: the three ways in which a source gives an aircraft, and the chain between them
//!        edits: what a person adds to derivatives and matrices beyond them
//!        further, whole_model: states beside the four of a plane, where a source has them, and A of all
//! ```
//!
//! Every function of the chain takes any [`real::Real`]: with `f64` it gives A, with dual numbers ∂A/∂p exactly.

pub mod aircraft_model;
pub mod atmosphere;
pub mod axes;
pub mod coefficients;
pub mod condition;
pub mod derivatives;
pub mod edits;
pub mod further;
pub mod inertia;
pub mod knobs;
pub mod plane;
pub mod real;
pub mod states;
pub mod whole_model;
