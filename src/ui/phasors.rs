//! The shape of a mode as phasors: how large each quantity is beside the others, and how far ahead or behind it swings.

use egui::accesskit::Role;
use egui::{Align2, Color32, Pos2, Rect, RichText, Sense, Stroke, Ui, Vec2, WidgetInfo};
use nalgebra::Complex;

use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::flight::modes::Mode;
use crate::flight::plane::{Plane, PlaneModel};
use crate::number::{fixed, significant};

const SIZE: f32 = 112.0;
const RADIUS: f32 = 38.0;
/// Shorter arrows are told in numbers only.
const SHOWN: f64 = 0.1;

/// One arrow: symbol, and its size and phase beside the largest.
struct Phasor {
    symbol: &'static str,
    value: Complex<f64>,
}

/// Draws the arrows, and beside them the same in numbers.
pub fn phasors_ui(ui: &mut Ui, model: &PlaneModel, mode: &Mode, color: Color32) {
    let palette = Palette::of(ui);
    let phasors = phasors(model, mode);
    ui.horizontal(|ui| {
        let (rect, response) = ui.allocate_exact_size(Vec2::splat(SIZE), Sense::hover());
        let words: Vec<String> = phasors.iter().map(Phasor::words).collect();
        let words = format!("Shape of the {}: {}", mode.naming.name.text(), words.join("; "));
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words.as_str()));
        draw(ui, rect, &phasors, color);
        ui.vertical(|ui| {
            ui.add_space(10.0);
            for phasor in &phasors {
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 2.0;
                    super::symbol::symbol_ui(
                        ui,
                        &Symbol::parse(phasor.symbol),
                        13.0,
                        palette.text,
                        Some(34.0),
                    );
                    ui.label(RichText::new(phasor.numbers()).font(theme::small()));
                });
            }
        });
    });
    let note = if mode.is_oscillatory() {
        "Each arrow turns once a period: further counter-clockwise is earlier. Rates are over |λ|."
    } else {
        "A real mode: all move together, to one side or the other. Rates are over |λ|."
    };
    ui.label(RichText::new(note).font(theme::small()).color(palette.weak));
}

/// Speed over V, flow angle, rates over |λ| and attitude: all of one kind, so that their sizes can be compared.
fn phasors(model: &PlaneModel, mode: &Mode) -> Vec<Phasor> {
    let v = model.trim.speed;
    let rate = mode.lambda.norm().max(f64::MIN_POSITIVE);
    let (symbols, over) = match model.plane {
        Plane::Longitudinal => (["u/V", "α", "q/|λ|", "θ"], [v, v, rate, 1.0]),
        Plane::Lateral => (["β", "p/|λ|", "r/|λ|", "φ"], [v, rate, rate, 1.0]),
    };
    let raw: Vec<Complex<f64>> = mode.shape.iter().zip(over).map(|(x, over)| x / over).collect();
    let largest =
        raw.iter().copied().fold(Complex::from(0.0), |most, x| if x.norm() > most.norm() { x } else { most });
    let phasor = |(symbol, value): (&'static str, Complex<f64>)| {
        let value = value / largest;
        let finite = value.re.is_finite() && value.im.is_finite();
        Phasor { symbol, value: if finite { value } else { Complex::from(0.0) } }
    };
    symbols.into_iter().zip(raw).map(phasor).collect()
}

impl Phasor {
    fn numbers(&self) -> String {
        if self.value.norm() < 5e-4 {
            return "0".to_owned();
        }
        format!("{} ∠ {}°", significant(self.value.norm(), 2), fixed(self.value.arg().to_degrees(), 0))
    }

    fn words(&self) -> String {
        format!("{} {}", Symbol::parse(self.symbol).plain(), self.numbers())
    }
}

fn draw(ui: &Ui, rect: Rect, phasors: &[Phasor], color: Color32) {
    let palette = Palette::of(ui);
    let painter = ui.painter();
    let center = rect.center();
    let hairline = Stroke::new(1.0, palette.hairline);
    painter.circle_stroke(center, RADIUS, hairline);
    for (a, b) in [(Vec2::X, -Vec2::X), (Vec2::Y, -Vec2::Y)] {
        painter.line_segment([center + a * RADIUS, center + b * RADIUS], hairline);
    }
    let mut labels: Vec<Rect> = Vec::new();
    for phasor in phasors.iter().filter(|phasor| phasor.value.norm() >= SHOWN) {
        // Up on screen is the positive imaginary axis.
        let direction = Vec2::new(phasor.value.re as f32, -phasor.value.im as f32);
        let tip = center + direction * RADIUS;
        painter.arrow(center, tip - center, Stroke::new(2.0, color));
        let galley = painter.layout_job(Symbol::parse(phasor.symbol).job(12.0, palette.text));
        let place = label_place(center, direction, galley.size(), &labels);
        labels.push(place);
        painter.galley(place.min, galley, palette.text);
    }
    if phasors.iter().all(|phasor| phasor.value.norm() < SHOWN) {
        painter.text(center, Align2::CENTER_CENTER, "–", theme::small(), palette.weak);
    }
}

/// Beyond the tip, and further out or round where another label is already.
fn label_place(center: Pos2, direction: Vec2, size: Vec2, others: &[Rect]) -> Rect {
    let outward = direction.normalized();
    let at = |distance: f32, turn: f32| {
        let toward = egui::emath::Rot2::from_angle(turn) * outward;
        Rect::from_center_size(center + toward * (direction.length() * RADIUS + distance), size)
    };
    let tries =
        [(11.0, 0.0), (11.0, 0.35), (11.0, -0.35), (22.0, 0.0), (20.0, 0.5), (20.0, -0.5), (-14.0, 0.4)];
    let free = |place: &Rect| others.iter().all(|other| !other.intersects(*place));
    tries.into_iter().map(|(distance, turn)| at(distance, turn)).find(free).unwrap_or_else(|| at(11.0, 0.0))
}
