//! Inputs of a response: the shape in time of a control or of a gust, with exact switching times.

use std::f64::consts::PI;
use std::sync::Arc;

/// Shape of a control or gust input in time \[rad, m/s or a fraction\]; zero before `start`.
///
/// A number that is not finite is not mended here: [`respond`](super::response::respond) then gives no motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// `amplitude` from `start` on.
    Step {
        /// Value while on, in the unit of the input, with its sign.
        amplitude: f64,
        /// Time of the edge \[s\].
        start: f64,
    },
    /// `amplitude` from `start` until `start + duration`, then zero again.
    Pulse {
        /// Value while on.
        amplitude: f64,
        /// Time of the first edge \[s\].
        start: f64,
        /// Time between the edges \[s\]; the pulse is empty where this is not positive.
        duration: f64,
    },
    /// `amplitude` for `duration`, then −`amplitude` for as long.
    Doublet {
        /// Value of the first half.
        amplitude: f64,
        /// Time of the first edge \[s\].
        start: f64,
        /// Length of each half \[s\].
        duration: f64,
    },
    /// `amplitude` for three units of time, then −, +, − for two, one and one: the 3-2-1-1 of flight tests, which excites a
    /// broad band of frequencies.
    ThreeTwoOneOne {
        /// Value of the first part.
        amplitude: f64,
        /// Time of the first edge \[s\].
        start: f64,
        /// The unit of time \[s\].
        unit: f64,
    },
    /// `amplitude` · sin ω(t − start) for `duration`.
    Sine {
        /// Largest value.
        amplitude: f64,
        /// Time at which it begins \[s\].
        start: f64,
        /// How long it lasts \[s\]; may be infinite.
        duration: f64,
        /// Angular frequency ω \[rad/s\].
        frequency: f64,
    },
    /// A sine whose angular frequency rises evenly from `from` to `to` during `duration`.
    Sweep {
        /// Largest value.
        amplitude: f64,
        /// Time at which it begins \[s\].
        start: f64,
        /// How long it lasts \[s\].
        duration: f64,
        /// Angular frequency at the start \[rad/s\].
        from: f64,
        /// Angular frequency at the end \[rad/s\].
        to: f64,
    },
    /// The discrete gust ½ `amplitude` (1 − cos 2π(t − start)/duration) (MIL-F-8785C §3.7.3 and CS-25.341 use its halves).
    OneMinusCosine {
        /// Value at the crest.
        amplitude: f64,
        /// Time at which it begins \[s\].
        start: f64,
        /// From calm to calm \[s\].
        duration: f64,
    },
    /// Samples joined by straight lines, the first at t = 0, the last one held.
    Samples {
        /// Time between the samples \[s\], positive.
        dt: f64,
        /// The samples.
        values: Arc<[f64]>,
    },
}

impl Input {
    /// Value at time t \[s\]: at an edge, the value from then on.
    pub fn at(&self, t: f64) -> f64 {
        match *self {
            Self::Sine { amplitude, start, duration, frequency } if on(t, start, duration) => {
                amplitude * (frequency * (t - start)).sin()
            }
            Self::Sweep { amplitude, start, duration, from, to } if on(t, start, duration) => {
                // φ = ω₁τ + (ω₂ − ω₁) τ²/2T
                let tau = t - start;
                amplitude * (from * tau + (to - from) * tau * tau / (2.0 * duration)).sin()
            }
            Self::OneMinusCosine { amplitude, start, duration } if on(t, start, duration) => {
                0.5 * amplitude * (1.0 - (2.0 * PI * (t - start) / duration).cos())
            }
            Self::Samples { dt, ref values } => {
                let (k, fraction) = sample(t, dt);
                let Some(&last) = values.last() else { return 0.0 };
                let at = |k: usize| values.get(k).copied().unwrap_or(last);
                at(k) + fraction * (at(k + 1) - at(k))
            }
            _ => self
                .switches()
                .into_iter()
                .flatten()
                .take_while(|&(time, _)| time <= t)
                .last()
                .map_or(0.0, |(_, value)| value),
        }
    }

    /// Rate of change at time t \[per s\] where the input is smooth; zero for what changes at edges only.
    pub fn rate(&self, t: f64) -> f64 {
        match *self {
            Self::Sine { amplitude, start, duration, frequency } if on(t, start, duration) => {
                amplitude * frequency * (frequency * (t - start)).cos()
            }
            Self::Sweep { amplitude, start, duration, from, to } if on(t, start, duration) => {
                let tau = t - start;
                let slope = (to - from) / duration;
                amplitude * (from + slope * tau) * (from * tau + 0.5 * slope * tau * tau).cos()
            }
            Self::OneMinusCosine { amplitude, start, duration } if on(t, start, duration) => {
                amplitude * PI / duration * (2.0 * PI * (t - start) / duration).sin()
            }
            Self::Samples { dt, ref values } => {
                let (k, _) = sample(t, dt);
                values.get(k..k + 2).map_or(0.0, |pair| (pair[1] - pair[0]) / dt)
            }
            _ => 0.0,
        }
    }

    /// Times at which the input or its rate jumps, in order \[s\].
    pub fn edges(&self) -> impl Iterator<Item = f64> + '_ {
        let (dt, count) = match self {
            Self::Samples { dt, values } => (*dt, values.len()),
            _ => (0.0, 0),
        };
        let ends = match *self {
            Self::Sine { start, duration, .. }
            | Self::Sweep { start, duration, .. }
            | Self::OneMinusCosine { start, duration, .. } => {
                let end = start + duration;
                [Some(start), (end < f64::INFINITY).then_some(end)]
            }
            _ => [None; 2],
        };
        let switches = self.switches().into_iter().flatten().map(|(time, _)| time);
        switches.chain(ends.into_iter().flatten()).chain((0..count).map(move |k| k as f64 * dt))
    }

    /// Whether the input is constant from one edge to the next.
    pub const fn is_constant_between_edges(&self) -> bool {
        matches!(
            self,
            Self::Step { .. } | Self::Pulse { .. } | Self::Doublet { .. } | Self::ThreeTwoOneOne { .. }
        )
    }

    /// The highest angular frequency in it between edges \[rad/s\], not negative.
    pub fn highest_frequency(&self) -> f64 {
        match *self {
            Self::Sine { frequency, .. } => frequency.abs(),
            Self::Sweep { from, to, .. } => from.abs().max(to.abs()),
            Self::OneMinusCosine { duration, .. } => (2.0 * PI / duration).abs(),
            _ => 0.0,
        }
    }

    /// Whether every number that describes the input is finite; a sine may last for ever.
    pub fn is_finite(&self) -> bool {
        let finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
        match *self {
            Self::Step { amplitude, start } => finite(&[amplitude, start]),
            Self::Pulse { amplitude, start, duration: length }
            | Self::Doublet { amplitude, start, duration: length }
            | Self::OneMinusCosine { amplitude, start, duration: length }
            | Self::ThreeTwoOneOne { amplitude, start, unit: length } => finite(&[amplitude, start, length]),
            Self::Sine { amplitude, start, duration, frequency } => {
                finite(&[amplitude, start, frequency]) && !duration.is_nan()
            }
            Self::Sweep { amplitude, start, duration, from, to } => {
                finite(&[amplitude, start, duration, from, to])
            }
            Self::Samples { dt, ref values } => dt.is_finite() && dt > 0.0 && finite(values),
        }
    }

    /// The values of an input that is constant between edges: (time \[s\], value from then on), in order.
    fn switches(&self) -> [Option<(f64, f64)>; 5] {
        let mut edges = [None; 5];
        let mut put = |parts: &[(f64, f64)], start: f64| {
            // (length, value) of each part
            let mut time = start;
            for (edge, &(length, value)) in edges.iter_mut().zip(parts) {
                *edge = Some((time, value));
                time += length;
            }
        };
        match *self {
            Self::Step { amplitude, start } => put(&[(0.0, amplitude)], start),
            Self::Pulse { amplitude, start, duration } if duration > 0.0 => {
                put(&[(duration, amplitude), (0.0, 0.0)], start);
            }
            Self::Doublet { amplitude, start, duration } if duration > 0.0 => {
                put(&[(duration, amplitude), (duration, -amplitude), (0.0, 0.0)], start);
            }
            Self::ThreeTwoOneOne { amplitude: a, start, unit } if unit > 0.0 => {
                put(&[(3.0 * unit, a), (2.0 * unit, -a), (unit, a), (unit, -a), (0.0, 0.0)], start);
            }
            _ => {}
        }
        edges
    }
}

/// Whether a smooth input is on; empty where its duration is not positive.
fn on(t: f64, start: f64, duration: f64) -> bool {
    t >= start && t < start + duration
}

/// Part of a sample's interval: a time so near before a sample counts as on it, since times that are the same on paper are rounded.
pub const ON_A_SAMPLE: f64 = 1e-9;

/// Sample at or before t, from the first one on, and the fraction of the way to the next.
fn sample(t: f64, dt: f64) -> (usize, f64) {
    let position = (t / dt).max(0.0);
    // Beyond what memory holds the last sample is held anyway.
    let k = (position + ON_A_SAMPLE).floor().min(u32::MAX as f64);
    (k as usize, (position - k).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::Input;

    #[test]
    fn an_edge_belongs_to_what_follows() {
        let step = Input::Step { amplitude: 0.1, start: 1.0 };
        assert_eq!([0.999, 1.0, 50.0].map(|t| step.at(t)), [0.0, 0.1, 0.1]);
        let pulse = Input::Pulse { amplitude: -0.1, start: 1.0, duration: 0.5 };
        assert_eq!([0.999, 1.0, 1.499, 1.5].map(|t| pulse.at(t)), [0.0, -0.1, -0.1, 0.0]);
        let doublet = Input::Doublet { amplitude: 1.0, start: 1.0, duration: 0.5 };
        assert_eq!([0.9, 1.0, 1.5, 1.9, 2.0].map(|t| doublet.at(t)), [0.0, 1.0, -1.0, -1.0, 0.0]);
    }

    #[test]
    fn the_3_2_1_1_is_that_and_leaves_a_net_push_of_one_unit() {
        let input = Input::ThreeTwoOneOne { amplitude: 1.0, start: 0.0, unit: 1.0 };
        let values: Vec<f64> = (0..8).map(|k| input.at(f64::from(k) + 0.5)).collect();
        assert_eq!(values, [1.0, 1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 0.0]);
        assert_eq!(values.iter().sum::<f64>(), 1.0);
    }

    #[test]
    fn an_input_without_duration_is_no_input() {
        for input in [
            Input::Pulse { amplitude: 1.0, start: 1.0, duration: 0.0 },
            Input::Doublet { amplitude: 1.0, start: 1.0, duration: -1.0 },
            Input::ThreeTwoOneOne { amplitude: 1.0, start: 1.0, unit: 0.0 },
            Input::Sine { amplitude: 1.0, start: 1.0, duration: 0.0, frequency: 1.0 },
            Input::Sweep { amplitude: 1.0, start: 1.0, duration: 0.0, from: 1.0, to: 2.0 },
            Input::OneMinusCosine { amplitude: 1.0, start: 1.0, duration: 0.0 },
            Input::Samples { dt: 1.0, values: [].into() },
        ] {
            for t in [0.0, 1.0, 1.5] {
                assert_eq!((input.at(t), input.rate(t)), (0.0, 0.0), "{input:?} at {t}");
            }
        }
    }

    #[test]
    fn the_rate_is_the_slope() {
        let smooth = [
            Input::Sine { amplitude: 2.0, start: 0.5, duration: f64::INFINITY, frequency: 3.0 },
            Input::Sweep { amplitude: 2.0, start: 0.5, duration: 4.0, from: 1.0, to: 9.0 },
            Input::OneMinusCosine { amplitude: 2.0, start: 0.5, duration: 3.0 },
            Input::Samples { dt: 0.5, values: [0.0, 1.0, -1.0, 4.0, 2.0, 1.0].into() },
        ];
        for input in &smooth {
            for t in [0.7, 1.1, 1.9, 2.3] {
                let h = 1e-6;
                let slope = (input.at(t + h) - input.at(t - h)) / (2.0 * h);
                assert!((slope - input.rate(t)).abs() < 1e-6, "{input:?} at {t}");
            }
        }
    }

    #[test]
    fn a_one_minus_cosine_gust_crests_in_its_middle_and_ends_in_calm() {
        let gust = Input::OneMinusCosine { amplitude: 3.0, start: 1.0, duration: 2.0 };
        assert_eq!([0.5, 1.0, 2.0, 3.0].map(|t| gust.at(t)), [0.0, 0.0, 3.0, 0.0]);
    }
}
