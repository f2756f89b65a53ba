//! Where limits of the controls hold a law of feedback back, in sentences.

use crate::flight::motion::control_limits::Control;
use crate::flight::motion::flight_path::{Bite, Limited};
use crate::number::fixed;

/// Times told of each limit; of more it is said how many.
const TOLD: usize = 3;

/// The name of a control within a sentence.
pub const fn control(control: Control) -> &'static str {
    match control {
        Control::Elevator => "elevator",
        Control::Throttle => "throttle",
        Control::Aileron => "aileron",
        Control::Rudder => "rudder",
    }
}

/// A sentence, without its full stop, for each limit that is met: when, and what comes of it: "The aileron is at its limit of rate
/// from 1.00 to 1.32 s, 1.78 to 2.50 s: it comes later than the law asks".
pub fn sentences(bites: &[Bite]) -> Vec<String> {
    let mut sentences = Vec::new();
    for of in Control::ALL {
        for limit in [Limited::Deflection, Limited::Rate] {
            let times: Vec<&Bite> =
                bites.iter().filter(|bite| bite.control == of && bite.limit == limit).collect();
            if times.is_empty() {
                continue;
            }
            let (what, so) = match limit {
                Limited::Deflection => ("deflection", "the law asks for more than there is"),
                Limited::Rate => ("rate", "it comes later than the law asks"),
            };
            let spans: Vec<String> = times.iter().take(TOLD).map(|bite| span(bite)).collect();
            let more = match times.len().saturating_sub(TOLD) {
                0 => String::new(),
                1 => " and once more".to_owned(),
                more => format!(" and {more} times more"),
            };
            let name = control(of);
            sentences
                .push(format!("The {name} is at its limit of {what} from {}{more}: {so}", spans.join(", ")));
        }
    }
    sentences
}

fn span(bite: &Bite) -> String {
    format!("{} to {} s", fixed(bite.from, 2), fixed(bite.until, 2))
}
