//! Where the poles came from while a person moved something.

use egui::{Key, Painter, Shape, Stroke, Ui};
use nalgebra::Complex;

use super::chart::Chart;
use super::marks;
use crate::flight::modes::Mode;
use crate::flight::naming::ModeName;
use crate::ui::theme::Palette;

/// Samples kept; of a longer way every second one is dropped.
const MOST: usize = 160;
/// A pole that has moved by less than this in a frame may be the same by another name \[points\].
const NEAR: f64 = 30.0;
/// A way shorter than this is none \[points\].
const SHORTEST: f32 = 4.0;

type Poles = Vec<(ModeName, Complex<f64>)>;

/// The way of the poles in the last drag, oldest first; the last sample is where they are.
#[derive(Debug, Default)]
pub struct Trail {
    samples: Vec<Poles>,
    /// When the drag began \[s\].
    press: Option<f64>,
}

impl Trail {
    /// Looks at the poles once a frame.
    ///
    /// A change under the pointer or an arrow key goes on with the trail; the first one of a new press begins it anew. Any
    /// other change — undone, reset, typed, another aircraft — ends it.
    pub fn observe(&mut self, ui: &Ui, modes: &[Mode]) {
        let now: Poles = modes.iter().map(|mode| (mode.naming.name, mode.lambda)).collect();
        if self.samples.last() == Some(&now) {
            return;
        }
        let (press, moving) = ui.input(|input| {
            let keys = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
            let by_key = keys.iter().any(|key| input.key_down(*key));
            (input.pointer.press_start_time(), input.pointer.any_down() || by_key)
        });
        if !moving {
            self.samples.clear();
        } else if press != self.press {
            self.press = press;
            let before = self.samples.pop();
            self.samples.clear();
            self.samples.extend(before);
        }
        self.samples.push(now);
        if self.samples.len() > MOST {
            let mut keep = false;
            self.samples.retain(|_| {
                keep = !keep;
                keep
            });
        }
    }

    /// Draws the way, the older the fainter, and a small cross where it began.
    pub fn draw(&self, painter: &Painter, chart: &Chart, palette: &Palette) {
        let ways = self.samples.len().saturating_sub(1);
        let mut shapes = Vec::new();
        for (k, pair) in self.samples.windows(2).enumerate() {
            let strength = 0.1 + 0.55 * (k + 1) as f32 / ways as f32;
            for (name, here) in &pair[1] {
                let Some(there) = before(&pair[0], *name, *here, NEAR * chart.per_point()) else { continue };
                let stroke = Stroke::new(2.0, palette.mode(*name).gamma_multiply(strength));
                for side in [|z: Complex<f64>| z, |z: Complex<f64>| z.conj()] {
                    for part in chart.clipped([side(there), side(*here)]) {
                        shapes.push(Shape::line(part, stroke));
                    }
                }
            }
        }
        painter.extend(shapes);
        let (Some(first), Some(last)) = (self.samples.first(), self.samples.last()) else { return };
        for (name, from) in first {
            let here = before(last, *name, *from, f64::INFINITY).unwrap_or(*from);
            if chart.position(*from).distance(chart.position(here)) > SHORTEST {
                let color = palette.mode(*name).gamma_multiply(0.45);
                marks::both(*from, |pole| marks::cross(painter, chart.position(pole), 4.0, 1.5, color));
            }
        }
    }
}

/// Where a pole was: that of the same name, or one that is so near that it has only been given another name.
fn before(poles: &Poles, name: ModeName, here: Complex<f64>, near: f64) -> Option<Complex<f64>> {
    let same = poles.iter().find(|(other, _)| *other == name).map(|(_, pole)| *pole);
    let distance = |pole: &Complex<f64>| (pole - here).norm();
    let nearest = || poles.iter().map(|(_, pole)| *pole).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    same.or_else(|| nearest().filter(|pole| distance(pole) <= near))
}
