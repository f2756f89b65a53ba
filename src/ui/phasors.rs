//! The shape of a mode as phasors: how large each quantity is beside the others, and how far ahead or behind it swings.

use egui::accesskit::Role;
use egui::{Align2, Color32, Pos2, Rect, RichText, Sense, Stroke, Ui, Vec2, WidgetInfo};
use nalgebra::Complex;

use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::modes::mode::Mode;
use crate::number::fixed;
use crate::words;

/// Room for the arrows and their symbols.
const SIZE: Vec2 = Vec2::new(118.0, 108.0);
const RADIUS: f32 = 30.0;
/// Between the tip of an arrow and its symbol.
const GAP: f32 = 4.0;
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
        let (rect, response) = ui.allocate_exact_size(SIZE, Sense::hover());
        let words: Vec<String> = phasors.iter().map(Phasor::words).collect();
        let words =
            format!("Shape of the {}: {}", words::mode::in_a_sentence(mode.naming.name), words.join("; "));
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
                        theme::sizes(ui).inline_symbol,
                        palette.text,
                        Some(28.0),
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
        if self.value.norm() < 5e-3 {
            return "0".to_owned();
        }
        let degrees = self.value.arg().to_degrees().round();
        // Half a turn either way is one direction.
        let degrees = if degrees == -180.0 { 180.0 } else { degrees };
        format!("{} ∠ {}°", fixed(self.value.norm(), 2), fixed(degrees, 0))
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
    // Up on screen is the positive imaginary axis.
    let directions: Vec<(&Phasor, Vec2)> = phasors
        .iter()
        .filter(|phasor| phasor.value.norm() >= SHOWN)
        .map(|phasor| (phasor, Vec2::new(phasor.value.re as f32, -phasor.value.im as f32)))
        .collect();
    let mut taken: Vec<Rect> = Vec::new();
    for (_, direction) in &directions {
        painter.arrow(center, *direction * RADIUS, Stroke::new(2.0, color));
        taken.extend(along(center, *direction));
    }
    for (phasor, direction) in directions {
        let galley =
            painter.layout_job(Symbol::parse(phasor.symbol).job(theme::sizes(ui).small_symbol, palette.text));
        let place = label_place(rect, direction, galley.size(), &taken);
        taken.push(place);
        painter.galley(place.min, galley, palette.text);
    }
    if phasors.iter().all(|phasor| phasor.value.norm() < SHOWN) {
        painter.text(center, Align2::CENTER_CENTER, "–", theme::small(), palette.weak);
    }
}

/// Where an arrow lies, in pieces: its head is wider than its shaft.
fn along(center: Pos2, direction: Vec2) -> impl Iterator<Item = Rect> {
    let length = direction.length() * RADIUS;
    let pieces = (length / 4.0).ceil().max(1.0) as usize;
    (0..=pieces).map(move |k| {
        let at = k as f32 / pieces as f32;
        let width = if (1.0 - at) * length < 0.3 * length { 8.0 } else { 3.0 };
        Rect::from_center_size(center + direction * (at * RADIUS), Vec2::splat(width))
    })
}

/// Inside `room`, beyond the tip, further round or out where another symbol or an arrow already is.
fn label_place(room: Rect, direction: Vec2, size: Vec2, taken: &[Rect]) -> Rect {
    let at = |turn: f32, further: f32| {
        let toward = egui::emath::Rot2::from_angle(turn) * direction.normalized();
        let beyond = 0.5 * (size.x * toward.x.abs() + size.y * toward.y.abs()) + GAP + further;
        let middle = room.center() + direction * RADIUS + toward * beyond;
        let inner = room.shrink2(0.5 * size);
        Rect::from_center_size(middle.clamp(inner.min, inner.max), size)
    };
    let turns = [0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.2, -2.2];
    let tries = [0.0, 7.0, 14.0, 24.0].into_iter().flat_map(|further| turns.map(|turn| (turn, further)));
    let overlap = |place: &Rect| -> f32 {
        taken
            .iter()
            .map(|other| place.intersect(*other))
            .filter(|common| common.is_positive())
            .map(|c| c.area())
            .sum()
    };
    let places = tries.map(|(turn, further)| at(turn, further));
    places.min_by(|a, b| overlap(a).total_cmp(&overlap(b))).unwrap_or_else(|| at(0.0, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_lie_on_no_arrow_on_no_other_symbol_and_inside_their_room() {
        let room = Rect::from_min_size(Pos2::new(10.0, 20.0), SIZE);
        let size = Vec2::new(25.0, 16.0);
        // Four arrows of other lengths in directions all around, also where two or three nearly agree.
        for step in 0..360 {
            let angle =
                |k: usize| (step as f32 + [0.0, 3.0, 94.0, 187.0][k] * (1 + step % 2) as f32).to_radians();
            let arrows: Vec<Vec2> =
                (0..4).map(|k| [1.0, 0.96, 0.52, 0.13][k] * Vec2::angled(angle(k))).collect();
            let mut taken: Vec<Rect> = arrows.iter().flat_map(|to| along(room.center(), *to)).collect();
            for to in arrows {
                let place = label_place(room, to, size, &taken);
                assert!(room.expand(0.01).contains_rect(place), "{step}°: {place}");
                let other = taken.iter().find(|other| other.shrink(0.01).intersects(place));
                assert_eq!(other, None, "{step}°: {place}");
                taken.push(place);
            }
        }
    }
}
