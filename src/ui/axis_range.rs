//! Ranges of axes that keep still while a person drags, and ease to where they should be afterwards.

use std::ops::RangeInclusive;

use egui::Ui;

/// Time constant of the easing \[s\].
const EASE: f32 = 0.12;

/// Of the wanted range; nearer than this the axis is there.
const ARRIVED: f64 = 2e-3;

/// The range of one axis as it is on screen.
#[derive(Clone, Debug, Default)]
pub struct AxisRange {
    shown: Option<(f64, f64)>,
}

impl AxisRange {
    /// The range to draw now, on its way to `wanted`.
    ///
    /// While a pointer button is down it keeps still, and grows only as far as what is shown would leave it; with reduced
    /// motion it jumps. Asks for another frame only until it has arrived.
    pub fn toward(&mut self, ui: &Ui, wanted: RangeInclusive<f64>) -> RangeInclusive<f64> {
        let (low, high) = wanted.into_inner();
        let Some((shown_low, shown_high)) = self.shown else {
            self.shown = Some((low, high));
            return low..=high;
        };
        let (low, high) = if ui.input(|input| input.pointer.any_down()) {
            (low.min(shown_low), high.max(shown_high))
        } else {
            (low, high)
        };
        let span = (high - low).max(shown_high - shown_low);
        let distance = (low - shown_low).abs().max((high - shown_high).abs());
        let next = if distance <= ARRIVED * span || ui.style().animation_time == 0.0 {
            (low, high)
        } else {
            ui.request_repaint();
            let step = f64::from(1.0 - (-ui.input(|input| input.stable_dt).min(0.1) / EASE).exp());
            (shown_low + step * (low - shown_low), shown_high + step * (high - shown_high))
        };
        self.shown = Some(next);
        next.0..=next.1
    }

    /// Takes a range at once: one that a person has brought it to.
    pub fn hold(&mut self, range: RangeInclusive<f64>) {
        self.shown = Some(range.into_inner());
    }
}

/// The smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 × 10ᵏ that is not less than `value`, which must be positive.
///
/// Ranges made of such numbers stay the same through small changes of what they hold.
pub fn round_up(value: f64) -> f64 {
    let decade = 10_f64.powf(value.log10().floor());
    [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]
        .into_iter()
        .map(|step| step * decade)
        .find(|&round| round >= value * (1.0 - 1e-12))
        .unwrap_or(10.0 * decade)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_up_is_never_less_and_never_a_third_more() {
        for value in [1e-9, 0.0031, 0.99, 1.0, 1.2, 4.9, 7.1, 9.99, 123.0, 6.5e8] {
            let round = round_up(value);
            assert!(round >= value * (1.0 - 1e-12) && round <= 1.34 * value, "{value} → {round}");
        }
    }
}
