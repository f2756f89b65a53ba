//! The shape of a mode as phasors: how large each quantity is beside the others, and how far ahead or behind it swings.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Align2, Color32, Galley, Pos2, Rect, RichText, Sense, Stroke, Ui, Vec2, WidgetInfo};
use nalgebra::Complex;

use super::curtain::Curtain;
use super::labels::{Place, Placement, Wanted, draw_leader};
use super::symbol::Symbol;
use super::theme::{self, Palette};
use crate::flight::aircraft::plane::{Plane, PlaneModel};
use crate::flight::modes::mode::Mode;
use crate::number::fixed;
use crate::words;

/// Room for the arrows and their symbols.
const SIZE: Vec2 = Vec2::new(118.0, 108.0);
const RADIUS: f32 = 30.0;
/// Cost of a leader beside its length: rather than that a symbol stands far aside.
const LEADER: f32 = 30.0;
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
            format!("Shape of the {}: {}", Curtain::of(ui).in_a_sentence(mode.naming.name), words.join("; "));
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
    let note = words::mode::phasors(mode.is_oscillatory());
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
    let size = theme::sizes(ui).small_symbol;
    let labels: Vec<(Vec2, Arc<Galley>)> = directions
        .into_iter()
        .map(|(phasor, direction)| {
            painter.arrow(center, direction * RADIUS, Stroke::new(2.0, color));
            let job = Symbol::parse(phasor.symbol).job(size, palette.text);
            (direction, painter.layout_job(job))
        })
        .collect();
    let wanted: Vec<(Vec2, Vec2)> =
        labels.iter().map(|(direction, galley)| (*direction, galley.size())).collect();
    for ((_, galley), place) in labels.into_iter().zip(label_places(rect, &wanted)) {
        let Some(place) = place else { continue };
        if let Some(leader) = place.leader {
            draw_leader(painter, leader, palette);
        }
        painter.galley(place.rect.min, galley, palette.text);
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

/// Places for symbols of given sizes inside `room`, each beyond the tip of its arrow or further round.
fn label_places(room: Rect, arrows: &[(Vec2, Vec2)]) -> Vec<Option<Place>> {
    let mut placement = Placement::new(room);
    for (direction, _) in arrows {
        along(room.center(), *direction).for_each(|piece| placement.keep_clear(piece));
    }
    let place = |&(direction, size): &(Vec2, Vec2)| {
        let wanted = Wanted {
            own: vec![room.center() + direction * RADIUS],
            others: Vec::new(),
            half: Rect::EVERYTHING,
            sizes: vec![size],
            first: 0,
            towards: Some(direction.normalized()),
            leader: LEADER,
        };
        placement.label(&wanted, None, true).map(|(place, _)| place)
    };
    arrows.iter().map(place).collect()
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
            let pieces: Vec<Rect> = arrows.iter().flat_map(|to| along(room.center(), *to)).collect();
            let wanted: Vec<(Vec2, Vec2)> = arrows.into_iter().map(|to| (to, size)).collect();
            let places: Vec<Rect> =
                label_places(room, &wanted).into_iter().flatten().map(|place| place.rect).collect();
            assert_eq!(places.len(), 4, "{step}°");
            for (i, place) in places.iter().enumerate() {
                assert!(room.contains_rect(*place), "{step}°: {place}");
                let others = pieces.iter().chain(&places[i + 1..]);
                assert_eq!(others.copied().find(|other| other.intersects(*place)), None, "{step}°: {place}");
            }
        }
    }
}
