//! What a change of the aircraft did to each mode, and by which derivatives.
//!
//! ```text
//! sliders ──► derivatives, from and to ──► their parts in Δωₙ, Δζ and Δλ ──► the formula that has the change
//! ```
//!
//! | file | in one line |
//! |---|---|
//! | `compared` | the change of each mode |
//! | `subject` | what is followed along the way |
//! | `path` | the straight way from one aircraft to the other, and the part of each derivative in what changes along it |
//! | `formula` | the textbook formula that has the change, with the terms that it is made of |
//! | `new_trim` | where a control leads that stays deflected |

mod compared;
mod formula;
mod new_trim;
mod path;
mod subject;

pub use compared::{Cause, Change, Kind, ModeChange, Oscillation, SharedDamping, Shift, reference_of};
pub use formula::{Formula, Measured, Terms};
pub use new_trim::{Balance, NewTrim};
pub use path::{IXZ_OVER_IX, IXZ_OVER_IZ};
pub use subject::Moved;
