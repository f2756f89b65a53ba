//! Where a motion is no small disturbance any more, and by which limit.

use crate::content::LengthUnit;
use crate::flight::analysis::Motion;
use crate::flight::motion::outputs::Output;
use crate::flight::motion::small_disturbance::{LARGEST_SPEED, SmallLimit};
use crate::number::{significant, trimmed};
use crate::scenario::Quantity;
use crate::words::measure;

/// The moment and the limit, in a sentence; `None` where the disturbance stays small.
pub fn sentence(motion: &Motion, length: LengthUnit) -> Option<String> {
    let (time, limit) = (motion.small_until?, limit_passed(motion.outgrown()?, length));
    Some(format!("After {} s the disturbance is no longer small: {limit}", significant(time, 3)))
}

/// Why the aircraft flies no further than to there; `None` where the disturbance stays small.
pub fn aircraft_stays(motion: &Motion, length: LengthUnit) -> Option<String> {
    Some(format!("{}. The aircraft stays where it was.", sentence(motion, length)?))
}

/// The limit that was passed, with its number in the unit of length of the source.
fn limit_passed(SmallLimit { output, limit }: SmallLimit, length: LengthUnit) -> String {
    let Quantity { symbol, dimension, .. } = Quantity::of(output);
    let number = trimmed(limit / dimension.in_si(length), 3);
    let number = measure::with_unit(&number, dimension.symbol(length));
    match output {
        Output::ForwardSpeed => {
            let share = trimmed(100.0 * LARGEST_SPEED, 3);
            format!("{symbol} is more than {number}, {share} % of the flight speed")
        }
        _ => format!("{symbol} is more than {number}"),
    }
}
