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
//! | *δa* | aileron \[rad\], right one up positive; it rolls right wing down, so L_δa > 0 |
//! | *ψ* | heading \[rad\], nose right positive |
//! | λ | eigenvalue σ ± jω \[1/s\]; σ > 0 grows |
//!
//! # Rooms
//!
//! | room | what | uses |
//! |---|---|---|
//! | [`aircraft`] | from the numbers of a source to A and B | – |
//! | [`modes`] | eigenvalues, their names, what moves them, what textbooks say of them | `aircraft` |
//! | [`verdicts`] | static stability and handling qualities | the rooms above |
//! | [`motion`] | disturbances, and the answers to them in time and over frequency | `aircraft`, `modes` |
//! | [`feedback`] | a law that moves the controls, and the modes, motions and margins under it | the rooms above |
//! | [`analysis`] | the one entry point | all of them |
//!
//! Nothing here reads a clock, a file or a global, and no function panics or returns a number that a view
//! cannot show.

pub mod aircraft;
pub mod analysis;
pub mod feedback;
pub mod modes;
pub mod motion;
pub mod verdicts;

pub use analysis::{Analysis, AnalysisError, analyse};
pub use motion::experiment::{Channel, Experiment, Start};
