//! The natural modes of a linear model: how they are found, named, moved and approximated.
//!
//! ```text
//! A ──► schur, eigen ──► mode (λ, shape, participation) ──► naming (name and reason)
//!                          │
//!                          ├──► sensitivity: ∂λ/∂p;  locus: the path of λ along p;  inverse: which p puts λ there
//!                          └──► second_order, approximations: what a textbook says of the same mode
//! ```
//!
//! `schur` and `eigen` solve a matrix of any size; modes of more than four states are named by the feedback that appends them.

pub mod approximations;
mod assignment;
pub mod eigen;
pub mod inverse;
mod least_change;
pub mod locus;
pub mod mode;
pub mod mode_name;
pub(in crate::flight) mod naming;
mod naming_lateral;
mod naming_longitudinal;
pub mod quartic;
pub mod reason;
mod schur;
pub mod second_order;
pub mod sensitivity;
pub mod stability;
