//! Inputs of a response: elevator or gust, piecewise constant, with exact switching times.

/// Shape of a control or gust input in time \[rad or m/s\]; zero before `start`.
///
/// A number that is not finite is not mended here: [`respond`](super::response::respond) then gives no motion.
#[derive(Clone, Copy, Debug, PartialEq)]
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
        /// Value while on, in the unit of the input, with its sign.
        amplitude: f64,
        /// Time of the first edge \[s\].
        start: f64,
        /// Time between the edges \[s\]; the pulse is empty where this is not positive.
        duration: f64,
    },
}

impl Input {
    /// Value at time t \[s\]: at an edge, the value from then on.
    pub fn at(&self, t: f64) -> f64 {
        self.switches().take_while(|&(time, _)| time <= t).last().map_or(0.0, |(_, value)| value)
    }

    /// The edges in order: (time \[s\], value from then on). Before the first the input is zero.
    pub fn switches(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let edges = match *self {
            Self::Step { amplitude, start } => [Some((start, amplitude)), None],
            Self::Pulse { duration, .. } if duration <= 0.0 => [None, None],
            Self::Pulse { amplitude, start, duration } => {
                [Some((start, amplitude)), Some((start + duration, 0.0))]
            }
        };
        edges.into_iter().flatten()
    }

    /// Whether every number that describes the input is finite.
    pub fn is_finite(&self) -> bool {
        self.switches().all(|(time, value)| time.is_finite() && value.is_finite())
    }
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
    }

    #[test]
    fn a_pulse_without_duration_is_no_input() {
        let pulse = Input::Pulse { amplitude: 1.0, start: 1.0, duration: 0.0 };
        assert_eq!(pulse.at(1.0), 0.0);
        assert_eq!(pulse.switches().count(), 0);
    }
}
