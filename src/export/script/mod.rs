//! What is taken along in the languages of other programs, one file a target.
//!
//! | file | in one line |
//! |---|---|
//! | `study` | what a script says, in no language yet |
//! | `text` | numbers and lists as most languages write them |
//! | `python` | a script for python-control |
//! | `notebook` | the same as a Jupyter notebook |
//! | `matlab` | a script for MATLAB and GNU Octave |
//! | `latex` | matrices and modes for a report |
//! | `aircraft_files` | the aircraft, to be opened again |
//! | `data` | what a view shows, as CSV |
//! | `levels` | levels of handling qualities by paragraph |
//! | `jsbsim` | the aircraft for JSBSim |

pub(super) mod aircraft_files;
pub(super) mod data;
pub(super) mod jsbsim;
pub(super) mod latex;
pub(super) mod levels;
pub(super) mod matlab;
pub(super) mod notebook;
pub(super) mod python;
pub(super) mod study;
mod text;
