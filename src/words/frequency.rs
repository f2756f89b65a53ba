//! Frequency responses.

use crate::flight::modes::mode_name::ModeName;
use crate::words::mode;

/// Why no steady oscillation answers a sine where a mode grows.
pub fn growing(name: ModeName) -> String {
    format!(
        "The {} grows: no steady oscillation ever answers a sine. The curves are only the transfer function at s = jω.",
        mode::in_a_sentence(name)
    )
}

/// A gain without a local maximum.
pub const NO_PEAK: &str = "No peak: no oscillation of this output stands out.";

/// A local maximum of the gain, with its unit, at an angular frequency \[rad/s\]; `None` where it has no bound.
pub fn peak(name: ModeName, gain: Option<&str>, frequency: &str) -> String {
    let name = mode::title(name);
    match gain {
        Some(gain) => format!("{name} peak: {gain} at {frequency} rad/s"),
        None => format!("{name} peak: without bound at {frequency} rad/s"),
    }
}
