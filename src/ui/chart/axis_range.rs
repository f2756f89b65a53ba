//! Ranges of axes that keep still while a person drags, and ease to where they should be afterwards.

use std::ops::RangeInclusive;

use egui::Ui;

/// Time constant of the easing \[s\].
const EASE: f32 = 0.12;

/// Part of the wanted range: nearer than this the axis has arrived.
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
