//! The bar that plays, pauses and scrubs.

use egui::{Button, ComboBox, RichText, Ui, Vec2};

use super::playback::Playback;
use crate::number::fixed;
use crate::scenario::view::Pace;
use crate::ui::slider::ReferenceSlider;
use crate::ui::theme::{self, Palette};

/// From this width on the slider stands in one row with the buttons and is still long enough to find a moment by hand.
const ONE_ROW: f32 = 460.0;

/// The words for a rate.
fn rate_text(rate: f64) -> &'static str {
    const WORDS: [&str; Pace::RATES.len()] = ["1/8×", "¼×", "½×", "1×", "2×", "4×", "8×", "16×", "32×"];
    let known = Pace::RATES.iter().position(|known| *known == rate);
    known.map_or("1×", |i| WORDS[i])
}

/// Height of the bar: one row, or two where the slider needs one of its own.
pub fn transport_height(ui: &Ui) -> f32 {
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    if ui.available_width() < ONE_ROW { 2.0 * row } else { row }
}

/// The bar of a playback. Every control is reached by Tab and worked by Space, Enter and the arrow keys.
///
/// The caller advances the playback, and asks for frames while it plays.
pub fn transport_ui(ui: &mut Ui, playback: &mut Playback, pace: &mut Pace) {
    if ui.available_width() < ONE_ROW {
        slider_ui(ui, playback, ui.available_width());
        ui.horizontal(|ui| {
            buttons_ui(ui, playback);
            time_ui(ui, playback);
            pace_ui(ui, pace);
        });
    } else {
        ui.horizontal(|ui| {
            buttons_ui(ui, playback);
            // The words at their longest, the rates and the loop stand after the slider.
            let after = time_width(playback) + 62.0 + 36.0 + 4.0 * ui.spacing().item_spacing.x;
            slider_ui(ui, playback, ui.available_width() - after);
            time_ui(ui, playback);
            pace_ui(ui, pace);
        });
    }
}

fn buttons_ui(ui: &mut Ui, playback: &mut Playback) {
    let (sign, name) = if playback.is_playing { ("⏸", "Pause") } else { ("▶", "Play") };
    let color = Palette::of(ui).text;
    let play = Button::new(RichText::new(sign).color(color)).min_size([34.0, 0.0].into());
    if ui.add(play).accessible_name(name).on_hover_text(name).clicked() {
        playback.toggle();
    }
    if ui.button("⏮").accessible_name("Back to the start").on_hover_text("Back to the start").clicked() {
        playback.seek(0.0);
    }
}

fn slider_ui(ui: &mut Ui, playback: &mut Playback, width: f32) {
    let slider = ReferenceSlider {
        name: "Time of the playback in s",
        value_text: format!("{} s", fixed(playback.time, 2)),
        value: playback.time,
        range: 0.0..=playback.end.max(1e-3),
        reference: 0.0,
        exists: None,
        in_effect: None,
    };
    if let (_, Some(time)) = slider.show(ui, Vec2::new(width, ui.spacing().interact_size.y)) {
        playback.seek(time);
    }
}

/// Room for the words of the time at their longest, so that nothing beside them moves.
fn time_width(playback: &Playback) -> f32 {
    7.0 * (2.0 * fixed(playback.end, 1).len() as f32 + 5.0)
}

fn time_ui(ui: &mut Ui, playback: &Playback) {
    let words = format!("{} of {} s", fixed(playback.time, 1), fixed(playback.end, 0));
    let color = Palette::of(ui).weak;
    let galley = ui.painter().layout_no_wrap(words, theme::small(), color);
    let size = Vec2::new(time_width(playback), galley.size().y);
    let (place, _) = ui.allocate_exact_size(size, egui::Sense::hover());
    ui.painter().galley(place.min, galley, color);
}

fn pace_ui(ui: &mut Ui, pace: &mut Pace) {
    let chosen = rate_text(pace.rate);
    let chooser = ComboBox::from_id_salt("rate").selected_text(chosen).width(44.0).show_ui(ui, |ui| {
        for rate in Pace::RATES {
            ui.selectable_value(&mut pace.rate, rate, rate_text(rate));
        }
    });
    theme::name_chooser(chooser, "Speed of the playback", chosen);
    let name = "Begin again at the end";
    ui.toggle_value(&mut pace.is_looping, "⟳").accessible_name(name).on_hover_text(name);
}
