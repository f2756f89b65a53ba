//! Where the poles came from while a person moved something.

use egui::{Event, Key, Painter, Rect, Shape, Stroke, Ui};
use nalgebra::Complex;

use super::marks;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::mode_name::ModeName;
use crate::ui::chart::Chart;
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
    /// A change under the pointer, an arrow key or a screen reader goes on with the trail; the first one of a new press begins it anew. Any
    /// other change — undone, reset, typed, another aircraft — ends it.
    pub fn observe(&mut self, ui: &Ui, modes: &[Mode]) {
        let now: Poles = modes.iter().map(|mode| (mode.naming.name, mode.lambda)).collect();
        if self.samples.last() == Some(&now) {
            return;
        }
        let (press, moving) = ui.input(|input| {
            let keys = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
            let by_key = keys.iter().any(|key| input.key_down(*key));
            // What a screen reader sets, it sets step by step.
            let by_reader =
                input.events.iter().any(|event| matches!(event, Event::AccessKitActionRequest(_)));
            (input.pointer.press_start_time(), input.pointer.any_down() || by_key || by_reader)
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

    /// Where the way began; nothing where nothing has moved.
    pub fn began(&self) -> &[(ModeName, Complex<f64>)] {
        self.samples.first().filter(|_| self.samples.len() > 1).map_or(&[], Vec::as_slice)
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
                    let ends = [there, *here].map(|pole| chart.position(side(pole)));
                    if chart.rect.expand(3.0).intersects(Rect::from_two_pos(ends[0], ends[1])) {
                        shapes.push(Shape::line_segment(ends, stroke));
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

#[cfg(test)]
mod tests {
    use egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput};
    use nalgebra::Matrix4;

    use super::*;
    use crate::flight::aircraft::plane::Plane;
    use crate::flight::modes::mode::modes_of;

    /// A light aircraft with another pitch stiffness, g in the unit of the other entries.
    fn modes(m_w: f64) -> Vec<Mode> {
        let a = Matrix4::from_row_slice(&[
            -0.045, 0.036, 0.0, -0.322, -0.369, -2.02, 1.76, 0.0, 0.191, m_w, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
        ]);
        modes_of(Plane::Longitudinal, &a).expect("modes")
    }

    struct DragPhase(Context, f64);

    impl DragPhase {
        /// One frame with the button pressed, let go, or left as it is.
        fn frame(&mut self, pressed: Option<bool>, trail: &mut Trail, m_w: f64) -> usize {
            self.1 += 0.02;
            let button = |pressed| Event::PointerButton {
                pos: Pos2::ZERO,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            };
            let events = pressed.map(button).into_iter().collect();
            let input = RawInput { time: Some(self.1), events, ..RawInput::default() };
            let output = self.0.run_ui(input, |ui| trail.observe(ui, &modes(m_w)));
            { output }.textures_delta.clear();
            trail.samples.len()
        }
    }

    #[test]
    fn a_drag_leaves_a_trail_that_the_next_drag_begins_anew_and_any_other_change_ends() {
        let (mut hand, mut trail) = (DragPhase(Context::default(), 0.0), Trail::default());
        assert_eq!(hand.frame(None, &mut trail, -3.0), 1);
        assert_eq!(hand.frame(Some(true), &mut trail, -3.1), 2);
        assert_eq!(hand.frame(None, &mut trail, -3.2), 3);
        assert_eq!(hand.frame(None, &mut trail, -3.2), 3, "nothing moved");
        assert_eq!(hand.frame(Some(false), &mut trail, -3.2), 3, "it stays after the drag");
        assert_eq!(hand.frame(Some(true), &mut trail, -3.2), 3, "and until something moves");
        assert_eq!(hand.frame(None, &mut trail, -3.3), 2, "from where the poles were");
        assert_eq!(hand.frame(Some(false), &mut trail, -3.3), 2);
        assert_eq!(hand.frame(None, &mut trail, -3.0), 1, "undone");
    }

    #[test]
    fn a_long_drag_keeps_its_beginning_and_a_bounded_number_of_samples() {
        let (mut hand, mut trail) = (DragPhase(Context::default(), 0.0), Trail::default());
        hand.frame(None, &mut trail, -3.0);
        let first = trail.samples[0].clone();
        hand.frame(Some(true), &mut trail, -3.001);
        for k in 2..1000 {
            assert!(hand.frame(None, &mut trail, -3.0 - 0.001 * f64::from(k)) <= MOST);
        }
        assert_eq!(trail.samples[0], first);
        assert!(trail.samples.len() > MOST / 2);
    }
}
