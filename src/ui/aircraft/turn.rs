//! The aircraft turned by hand: what is drawn over it, and the sliders that turn it.

use egui::{Align, Button, Label, Layout, RichText, Ui, Vec2};

use super::labels::Words;
use super::overlays::OverlayPainter;
use super::picture::Axis;
use crate::scenario::view::{Overlays, Turn};
use crate::ui::slider::ReferenceSlider;
use crate::ui::symbol::{Symbol, prose, symbol_ui};
use crate::ui::theme::{self, Palette};
use crate::words;

/// A ring around an axis goes this far \[rad\], and stands at this share of the axis.
const RING: f32 = 5.0;
const RING_AT: f32 = 0.66;
/// From this width on the sliders stand beside each other.
const BESIDE: f32 = 560.0;
/// In less width a sentence has a line more.
const SLIM: f32 = 360.0;
const COLUMN_GAP: f32 = 18.0;
const SYMBOL_WIDTH: f32 = 18.0;
const VALUE_WIDTH: f32 = 40.0;
/// Height of a slider and of a line of the sentence \[points\].
const SLIDER: f32 = 22.0;
const LINE: f32 = 15.0;

impl OverlayPainter<'_> {
    /// Both sets of axes, a ring around each axis of the body as the right hand turns, the three angles.
    pub(super) fn turned(&mut self, overlays: &Overlays) {
        self.earth_axes();
        self.angles();
        if overlays.stability_axes {
            self.stability_axes();
        }
        for (k, axis) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
            let color = self.palette.axes[k];
            let (symbol, name) = words::turn::about(k);
            self.ring(axis, RING_AT, RING, color);
            self.axis(axis, color, (symbol, Words::Name(name)));
        }
    }
}

/// Height of the controls.
pub fn turn_height(ui: &Ui) -> f32 {
    let gap = ui.spacing().item_spacing.y;
    let rows = if ui.available_width() < BESIDE { 3.0 } else { 1.0 };
    rows * (slider_height(ui) + gap) + chip_height(ui) + gap + sentence_height(ui) + gap
}

fn slider_height(ui: &Ui) -> f32 {
    if theme::is_for_fingers(ui) { theme::TOUCH_HEIGHT } else { SLIDER }
}

fn chip_height(ui: &Ui) -> f32 {
    if theme::is_for_fingers(ui) { theme::TOUCH_HEIGHT } else { SLIDER }
}

fn sentence_height(ui: &Ui) -> f32 {
    let lines = if ui.available_width() < SLIM { 4.0 } else { 3.0 };
    lines * LINE * theme::sizes(ui).small / 11.5
}

/// Three sliders in the order in which they turn, what axes and angles mean, and the way back to none. `explained` is the symbol that
/// a sentence is said of.
pub fn turn_ui(ui: &mut Ui, turn: &mut Turn, explained: &mut &'static str) {
    let Turn { psi, theta, phi } = turn;
    let angles = [psi, theta, phi].into_iter().zip(words::turn::ANGLES).zip(Turn::LARGEST);
    if ui.available_width() < BESIDE {
        for angle in angles {
            let room = Vec2::new(ui.available_width(), slider_height(ui));
            angle_ui(ui, angle, room);
        }
    } else {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = COLUMN_GAP;
            let room = Vec2::new((ui.available_width() - 2.0 * COLUMN_GAP) / 3.0, slider_height(ui));
            for angle in angles {
                angle_ui(ui, angle, room);
            }
        });
    }
    chips_ui(ui, turn, explained);
    let room = Vec2::new(ui.available_width(), sentence_height(ui));
    ui.allocate_ui_with_layout(room, Layout::top_down(Align::Min), |ui| {
        ui.set_min_height(room.y);
        let sentence = words::turn::sentence(explained).unwrap_or_default();
        ui.add(Label::new(prose(sentence, theme::small(), Palette::of(ui).text)));
    });
}

/// An angle in whole degrees.
fn angle_ui(ui: &mut Ui, ((angle, (symbol, name)), largest): ((&mut i16, (&str, &str)), i16), room: Vec2) {
    ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Center), |ui| {
        theme::make_low(ui, SLIDER);
        ui.spacing_mut().item_spacing.x = 6.0;
        let text = format!("{}°", angle.to_string().replace('-', "−"));
        let palette = Palette::of(ui);
        symbol_ui(ui, &Symbol::parse(symbol), theme::sizes(ui).symbol, palette.text, Some(SYMBOL_WIDTH));
        let slider = ReferenceSlider {
            name,
            value_text: text.clone(),
            value: f64::from(*angle),
            range: f64::from(-largest)..=f64::from(largest),
            reference: 0.0,
            exists: None,
            in_effect: None,
        };
        let width = (ui.available_width() - VALUE_WIDTH - ui.spacing().item_spacing.x).max(40.0);
        let (response, moved) = slider.show(ui, Vec2::new(width, room.y));
        response.on_hover_text(name);
        if let Some(moved) = moved {
            *angle = moved.round() as i16;
        }
        ui.label(RichText::new(text).font(theme::small()));
    });
}

/// What can be explained, and the way back.
fn chips_ui(ui: &mut Ui, turn: &mut Turn, explained: &mut &'static str) {
    ui.horizontal(|ui| {
        theme::make_low(ui, SLIDER);
        ui.spacing_mut().button_padding = Vec2::new(if theme::is_for_fingers(ui) { 8.0 } else { 5.0 }, 1.0);
        ui.spacing_mut().item_spacing.x = 1.0;
        let palette = Palette::of(ui);
        for symbol in words::turn::EXPLAINED {
            let is_on = *explained == symbol;
            let color = if is_on { palette.on_strong } else { palette.text };
            let parsed = Symbol::parse(symbol);
            let chip = Button::selectable(is_on, parsed.job(theme::sizes(ui).inline_symbol, color));
            let chip = ui.add(chip).accessible_name(format!("What {} means", parsed.plain()));
            if chip.clicked() || chip.hovered() {
                *explained = symbol;
            }
        }
        let reset = Button::new(RichText::new("↺").font(theme::small()));
        let reset = ui.add_enabled(*turn != Turn::default(), reset).accessible_name(words::turn::RESET);
        if reset.on_hover_text(words::turn::RESET).clicked() {
            *turn = Turn::default();
        }
    });
}
