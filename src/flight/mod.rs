//! The mathematics of small disturbances about steady flight, and of large ones: numbers in, numbers out.
//!
//! # Conventions
//!
//! | | |
//! |---|---|
//! | units | SI and radians, everywhere in this module |
//! | axes | body-fixed, *x* forward, *y* right, *z* down; stability axes where the trim angle of attack is zero |
//! | *u* | perturbation of forward speed \[m/s\], faster positive |
//! | *w* | perturbation of velocity along *z* \[m/s\], downward positive; α ≈ w/U₀ |
//! | *q* | pitch rate \[rad/s\], nose-up positive |
//! | *θ* | pitch angle \[rad\], nose-up positive |
//! | *v* | perturbation of velocity along *y* \[m/s\], to the right positive; β ≈ v/V |
//! | *p*, *r* | roll rate and yaw rate \[rad/s\], right wing down and nose right positive |
//! | *φ* | bank angle \[rad\], right wing down positive |
//! | *δe* | elevator \[rad\], trailing edge down positive; it pitches the nose down, so M_δe < 0 |
//! | *δt* | throttle: more thrust, as a fraction of the weight where a source says nothing of its engine |
//! | *δr* | rudder \[rad\], trailing edge left positive; it turns the nose left, so N_δr < 0 |
//! | *δa* | aileron \[rad\], in the sense of the source: see the sign of L_δa |
//! | *ψ* | heading \[rad\], nose right positive |
//! | λ | eigenvalue σ ± jω \[1/s\]; σ > 0 grows |
//!
//! Nothing here reads a clock, a file or a global, and no function panics or returns a number that a view
//! cannot show.

pub mod aerodynamics;
pub mod analysis;
pub mod approximations;
pub mod atmosphere;
pub mod axes;
pub mod coefficients;
pub mod condition;
pub mod derivatives;
pub mod edits;
pub mod eigen;
pub mod experiment;
pub mod figures;
pub mod flight_path;
pub mod frequency_response;
pub mod gusts;
pub mod handling_qualities;
pub mod inputs;
pub mod integrator;
pub mod inverse;
pub mod knobs;
mod least_change;
pub mod level_boundaries;
pub mod locus;
pub mod mil_f_8785c;
pub mod modal_sum;
pub mod modes;
pub mod naming;
mod naming_lateral;
mod naming_longitudinal;
pub mod outputs;
pub mod path;
pub mod plane;
pub mod real;
pub mod response;
pub mod rigid_body;
mod schur;
pub mod second_order;
pub mod sensitivity;
pub mod six_dof;
pub mod states;
pub mod static_stability;
pub mod study;
pub mod turbulence;

pub use analysis::{Analysis, AnalysisError, analyse};
pub use experiment::{Channel, Experiment, Start};
