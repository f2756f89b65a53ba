//! What matters of a curve: which way it starts, whether and how often it swings, and where it ends. Never how far two curves are
//! apart, since nobody draws a scale from memory.

/// Which way a curve goes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Up.
    Up,
    /// Down.
    Down,
    /// It stays.
    None,
}

/// Where a curve ends, against where it began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Above.
    Above,
    /// Where it began.
    Back,
    /// Below.
    Below,
    /// Farther out than ever before.
    Away,
}

/// What matters of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Features {
    /// Which way it goes first.
    pub first: Direction,
    /// How often it turns.
    pub turns: usize,
    /// Where it ends.
    pub ends: End,
}

/// A swing smaller than this share of the whole height is a tremor of the hand.
const TREMOR: f64 = 0.1;

/// An end nearer than this share of the whole height to the beginning is back there.
const BACK: f64 = 0.15;

impl Features {
    /// Of values at equal steps of time.
    pub fn of(values: &[f64]) -> Self {
        let finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        let (low, high) = finite.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
            (low.min(value), high.max(value))
        });
        let height = high - low;
        let (Some(&start), Some(&end)) = (finite.first(), finite.last()) else {
            return Self { first: Direction::None, turns: 0, ends: End::Back };
        };
        if height.is_nan() || height <= 0.0 {
            return Self { first: Direction::None, turns: 0, ends: End::Back };
        }
        let extremes = extremes(&finite, TREMOR * height);
        let first = match extremes.get(1) {
            Some(&next) if next > start => Direction::Up,
            Some(_) => Direction::Down,
            None => Direction::None,
        };
        // The beginning and the end are no turns.
        let turns = extremes.len().saturating_sub(2);
        let farthest = finite.iter().map(|value| (value - start).abs()).fold(0.0, f64::max);
        let ends = if turns > 1 && (end - start).abs() >= 0.95 * farthest {
            End::Away
        } else if (end - start).abs() <= BACK * height {
            End::Back
        } else if end > start {
            End::Above
        } else {
            End::Below
        };
        Self { first, turns, ends }
    }

    /// Whether it swings: it turns at least twice.
    pub const fn oscillates(self) -> bool {
        self.turns >= 2
    }

    /// Whether it swings as another does: about as often, within one turn or a third.
    pub fn swings_like(self, other: Self) -> bool {
        let apart = self.turns.abs_diff(other.turns);
        self.oscillates() == other.oscillates() && (apart <= 1 || 3 * apart <= self.turns.max(other.turns))
    }
}

/// The beginning, the turning points that are more than `tremor` from each other, and the end.
fn extremes(values: &[f64], tremor: f64) -> Vec<f64> {
    let Some((&first, rest)) = values.split_first() else { return Vec::new() };
    let mut extremes = vec![first];
    let (mut low, mut high) = (first, first);
    // The way of the last swing: none yet, up or down.
    let mut rises: Option<bool> = None;
    for &value in rest {
        low = low.min(value);
        high = high.max(value);
        match rises {
            None if value - low > tremor && high == value => {
                rises = Some(true);
            }
            None if high - value > tremor && low == value => {
                rises = Some(false);
            }
            Some(true) if high - value > tremor => {
                extremes.push(high);
                (rises, low) = (Some(false), value);
            }
            Some(false) if value - low > tremor => {
                extremes.push(low);
                (rises, high) = (Some(true), value);
            }
            _ => {}
        }
    }
    match rises {
        Some(true) => extremes.push(high),
        Some(false) => extremes.push(low),
        None => {}
    }
    extremes
}
