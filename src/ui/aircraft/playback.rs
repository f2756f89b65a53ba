//! Where a playback is: a time, and how it goes on. The motion is a function of that time, so it scrubs and never drifts.

use crate::scenario::view::Pace;

/// A playback.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playback {
    /// Time in the motion \[s\].
    pub time: f64,
    /// Where the motion ends \[s\].
    pub end: f64,
    /// Whether time goes on.
    pub is_playing: bool,
}

impl Playback {
    /// At the beginning of a motion of some length \[s\], at rest.
    pub fn new(end: f64) -> Self {
        let end = if end.is_finite() { end.max(0.0) } else { 0.0 };
        Self { time: 0.0, end, is_playing: false }
    }

    /// Goes on by so much real time \[s\].
    pub fn advance(&mut self, dt_real: f64, Pace { rate, is_looping }: Pace) {
        if !self.is_playing || !dt_real.is_finite() || dt_real <= 0.0 {
            return;
        }
        let time = self.time + dt_real * rate;
        if time < self.end {
            self.time = time;
        } else if is_looping && self.end > 0.0 {
            self.time = time.rem_euclid(self.end);
        } else {
            self.time = self.end;
            self.is_playing = false;
        }
    }

    /// Plays on, from the beginning where it was at its end; or pauses.
    pub fn toggle(&mut self) {
        if !self.is_playing && self.time >= self.end {
            self.time = 0.0;
        }
        self.is_playing = !self.is_playing && self.end > 0.0;
    }

    /// Goes to a time \[s\] within the motion.
    pub fn seek(&mut self, time: f64) {
        if time.is_finite() {
            self.time = time.clamp(0.0, self.end);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_goes_on_only_while_playing_and_stops_at_the_end() {
        let mut playback = Playback::new(10.0);
        let once = Pace { rate: 2.0, is_looping: false };
        playback.advance(3.0, once);
        assert_eq!(playback.time, 0.0);
        playback.toggle();
        playback.advance(3.0, once);
        assert_eq!(playback.time, 6.0);
        playback.advance(3.0, once);
        assert_eq!((playback.time, playback.is_playing), (10.0, false));
        playback.toggle();
        assert_eq!((playback.time, playback.is_playing), (0.0, true));
    }

    #[test]
    fn a_loop_begins_again_and_keeps_what_is_left_over() {
        let looping = Pace { rate: 1.0, is_looping: true };
        let mut playback = Playback { is_playing: true, ..Playback::new(10.0) };
        playback.seek(9.0);
        playback.advance(2.5, looping);
        assert!((playback.time - 1.5).abs() < 1e-12 && playback.is_playing);
        // Never hangs on an empty motion, nor takes a time that is none.
        let mut empty = Playback { is_playing: true, ..Playback::new(f64::NAN) };
        empty.advance(1.0, looping);
        empty.seek(f64::NAN);
        assert_eq!((empty.time, empty.is_playing), (0.0, false));
    }
}
