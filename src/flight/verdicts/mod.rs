//! Verdicts on an aircraft: static stability, and handling qualities after MIL-F-8785C.
//!
//! `mil_f_8785c` holds the tables of the specification, `task` for what they are read, `handling_qualities` applies them to modes, and
//! `overall_level` finds the worst of them, `level_boundaries` draws them in the plane of λ.

pub mod handling_qualities;
pub mod level_boundaries;
pub mod mil_f_8785c;
pub mod overall_level;
pub mod static_stability;
pub mod task;
