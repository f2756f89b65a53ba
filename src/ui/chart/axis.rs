//! Round numbers on an axis, with labels that have room.

use std::ops::RangeInclusive;

use crate::number::{fixed, nice_step, significant};

/// Between one label and the next \[points\].
const GAP: f32 = 8.0;
/// An axis has no more ticks than this.
const MOST: f64 = 60.0;

/// A round number on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Place on the axis; on one of decades the logarithm.
    pub value: f64,
    /// The number in words.
    pub label: String,
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Evenly, in steps of 1, 2 or 5 × 10ᵏ.
    #[default]
    Even,
    /// Evenly, in right angles: degrees.
    RightAngles,
    /// By powers of ten: places on the axis are logarithms to base ten.
    Decades,
}

/// Room for labels along an axis \[points\].
#[derive(Clone, Copy)]
pub struct Room<'a> {
    /// Length of the axis.
    pub length: f32,
    /// Least distance between ticks.
    pub apart: f32,
    /// Room that a label takes along the axis.
    pub extent: &'a dyn Fn(&str) -> f32,
    /// How far a label may reach beyond either end; negative where it must keep away from them.
    pub overhang: f32,
}

impl Scale {
    /// The round numbers in a range: as many as have room, three where there is any for them, and never fewer than two, since one is no scale.
    pub fn ticks(self, range: &RangeInclusive<f64>, room: Room<'_>) -> Vec<Tick> {
        match self {
            Self::Even => even(range, room),
            Self::RightAngles => right_angles(range, room).unwrap_or_else(|| even(range, room)),
            Self::Decades => decades(range, room),
        }
    }
}

impl Room<'_> {
    /// Where a value is on the axis \[points from its beginning\].
    fn place(&self, range: &RangeInclusive<f64>, value: f64) -> f32 {
        ((value - range.start()) / (range.end() - range.start())) as f32 * self.length
    }

    /// The ticks whose labels reach no farther over the ends than they may.
    fn fitting(&self, range: &RangeInclusive<f64>, mut ticks: Vec<Tick>) -> Vec<Tick> {
        ticks.retain(|tick| {
            let (at, half) = (self.place(range, tick.value), 0.5 * (self.extent)(&tick.label));
            range.contains(&tick.value)
                && at + self.overhang >= half
                && at + half <= self.length + self.overhang
        });
        ticks
    }

    /// Whether two of the ticks, or their labels, are too near to each other.
    fn is_crowded(&self, range: &RangeInclusive<f64>, ticks: &[Tick]) -> bool {
        ticks.windows(2).any(|pair| {
            let apart = self.place(range, pair[1].value) - self.place(range, pair[0].value);
            let halves = pair.iter().map(|tick| 0.5 * (self.extent)(&tick.label)).sum::<f32>();
            apart < self.apart.max(halves + GAP)
        })
    }
}

/// Multiples of a step in a range.
fn multiples(range: &RangeInclusive<f64>, step: f64) -> Vec<Tick> {
    let (first, last) = ((range.start() / step).ceil(), (range.end() / step).floor());
    let count = (last - first + 1.0).clamp(0.0, MOST) as usize;
    // Twelve tell the ticks of any plot apart: the smallest ranges shown are of some 1e-8.
    let decimals = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
    let label = |value: f64| {
        if value.abs() >= 1e5 {
            // As many digits as tell it from the next.
            let digits = (value.abs().log10().floor() - step.log10().floor()).clamp(1.0, 16.0) as usize + 1;
            significant(value, digits)
        } else {
            fixed(value, decimals)
        }
    };
    let values = (0..count).map(|k| (first + k as f64) * step);
    values.map(|value| Tick { value, label: label(value) }).collect()
}

fn even(range: &RangeInclusive<f64>, room: Room<'_>) -> Vec<Tick> {
    let span = (range.end() - range.start()).max(f64::MIN_POSITIVE);
    let of = |step: f64| room.fitting(range, multiples(range, step));
    // From coarse to fine; the next finer step than s is the largest of its kind below s.
    let mut step = nice_step(span);
    let mut chosen = of(step);
    for _ in 0..12 {
        step = nice_step(0.3 * step);
        let finer = of(step);
        let crowded = room.is_crowded(range, &finer);
        if crowded && chosen.len() >= 2 {
            // Two are read with effort: three or more are better, as long as their labels keep apart.
            let tight = Room { apart: 0.0, ..room };
            if chosen.len() < 3 && !tight.is_crowded(range, &finer) {
                chosen = finer;
            }
            break;
        }
        chosen = finer;
        if crowded && chosen.len() >= 2 {
            // There is hardly room for two.
            let last = chosen.len() - 1;
            chosen = chosen.into_iter().step_by(last).collect();
            break;
        }
    }
    chosen
}

/// Right angles, or half of one where there is no room for two; `None` where they are no scale.
fn right_angles(range: &RangeInclusive<f64>, room: Room<'_>) -> Option<Vec<Tick>> {
    let of = |step: f64| room.fitting(range, multiples(range, step));
    let roomy = |ticks: &Vec<Tick>| ticks.len() >= 2 && !room.is_crowded(range, ticks);
    [90.0, 180.0, 360.0, 45.0].into_iter().map(of).find(roomy)
}

/// Powers of ten; where there are fewer than two, their double and fivefold too, and where not even those are two, round numbers.
fn decades(range: &RangeInclusive<f64>, room: Room<'_>) -> Vec<Tick> {
    let (first, last) = (range.start().floor().max(-12.0) as i32, range.end().floor().min(12.0) as i32);
    let within = |digits: &[f64], every: u32| -> Vec<Tick> {
        let powers = (first..=last).filter(|power| power.unsigned_abs().is_multiple_of(every));
        let all = powers.flat_map(|power| digits.iter().map(move |digit| digit * 10_f64.powi(power)));
        room.fitting(
            range,
            all.map(|value| Tick { value: value.log10(), label: significant(value, 1) }).collect(),
        )
    };
    let powers = (1..=24).map(|every| within(&[1.0], every));
    let roomy = |ticks: &Vec<Tick>| ticks.len() >= 2 && !room.is_crowded(range, ticks);
    powers.chain([within(&[1.0, 2.0, 5.0], 1)]).find(roomy).unwrap_or_else(|| {
        let [low, high] = [range.start(), range.end()].map(|end| 10_f64.powf(end.clamp(-12.0, 12.0)));
        let ticks = multiples(&(low..=high), nice_step(0.25 * (high - low)));
        let ticks = ticks.into_iter().filter(|tick| tick.value > 0.0);
        room.fitting(range, ticks.map(|tick| Tick { value: tick.value.log10(), ..tick }).collect())
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Figures of 10 points.
    fn extent(label: &str) -> f32 {
        6.0 * label.chars().count() as f32
    }

    fn labels(scale: Scale, range: RangeInclusive<f64>, length: f32) -> String {
        let room = Room { length, apart: 30.0, extent: &extent, overhang: 14.0 };
        let ticks = scale.ticks(&range, room);
        ticks.iter().map(|tick| tick.label.as_str()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn a_time_axis_is_divided_finely_enough_to_read_a_period() {
        assert_eq!(labels(Scale::Even, 0.0..=80.0, 157.0), "0 20 40 60 80");
        assert_eq!(labels(Scale::Even, 0.0..=60.0, 157.0), "0 20 40 60");
        assert_eq!(labels(Scale::Even, 0.0..=10.0, 157.0), "0 2 4 6 8 10");
        assert_eq!(labels(Scale::Even, 0.0..=1.0, 157.0), "0.0 0.2 0.4 0.6 0.8 1.0");
    }

    #[test]
    fn where_there_is_room_for_three_labels_there_are_three() {
        // Upward, of labels 10 points high, that would rather be 24 apart.
        let upward = |range: RangeInclusive<f64>| {
            let room = Room { length: 123.0, apart: 24.0, extent: &|_| 10.0, overhang: 1.0 };
            Scale::Even.ticks(&range, room).into_iter().map(|tick| tick.label).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(upward(-4.5..=7.0), "−4 −2 0 2 4 6");
        // Zero has no room at the very bottom.
        assert_eq!(upward(-0.2..=12.0), "2 4 6 8 10");
        assert_eq!(upward(-1.0..=12.0), "0 5 10");
    }

    #[test]
    fn phases_are_divided_into_right_angles() {
        assert_eq!(labels(Scale::RightAngles, -290.0..=10.0, 290.0), "−270 −180 −90 0");
        assert_eq!(labels(Scale::RightAngles, -1200.0..=0.0, 290.0), "−1080 −900 −720 −540 −360 −180 0");
        assert_eq!(labels(Scale::RightAngles, -100.0..=-40.0, 290.0), "−90 −45");
        assert_eq!(labels(Scale::RightAngles, -3.0..=2.0, 290.0), "−3 −2 −1 0 1 2");
    }

    #[test]
    fn frequencies_are_divided_into_decades() {
        assert_eq!(labels(Scale::Decades, -2.0..=1.0, 260.0), "0.01 0.1 1 10");
        assert_eq!(labels(Scale::Decades, -6.0..=6.0, 200.0), "1e−6 0.001 1 1000 1e6");
        assert_eq!(labels(Scale::Decades, -0.5..=0.6, 260.0), "0.5 1 2");
        assert_eq!(labels(Scale::Decades, 0.35..=0.45, 260.0), "2.4 2.6 2.8");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Ticks of any range that a plot can have, on an axis of any length.
        #[test]
        fn an_axis_has_two_labels_at_least_that_differ_and_where_there_is_room_are_apart(
            low in -1.0..1.0_f64,
            size in 0.01..2.0_f64,
            power in -9..9_i32,
            length in 20.0..900.0_f32,
        ) {
            let unit = 10_f64.powi(power);
            let range = low * unit..=(low + size) * unit;
            let room = Room { length, apart: 28.0, extent: &|_| 12.0, overhang: 6.0 };
            let ticks = Scale::Even.ticks(&range, room);
            prop_assert!(ticks.len() >= 2, "{} of them", ticks.len());
            prop_assert!(length < 130.0 || ticks.len() >= 3, "{ticks:?}");
            // For the third label they may come nearer, but none touches another.
            let tight = Room { apart: 0.0, ..room };
            prop_assert!(length < 130.0 || !tight.is_crowded(&range, &ticks), "{ticks:?}");
            for pair in ticks.windows(2) {
                prop_assert!(pair[0].value < pair[1].value);
                prop_assert!(power < -6 || pair[0].label != pair[1].label, "{} twice", pair[0].label);
            }
        }
    }
}
