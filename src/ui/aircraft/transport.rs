//! The bar that plays, pauses and scrubs.

use egui::{Button, ComboBox, RichText, Ui, Vec2};

use super::playback::{Playback, RATES};
use crate::number::fixed;
use crate::scenario::view::Pace;
use crate::ui::slider::ReferenceSlider;
use crate::ui::theme::{self, Palette};

/// Narrower than this the slider has no use.
const NARROWEST: f32 = 40.0;
/// From this width on the end of the motion is told.
const ROOMY: f32 = 330.0;

/// The words for a rate.
fn rate_text(rate: f64) -> &'static str {
    match RATES.iter().position(|known| *known == rate) {
        Some(0) => "¼×",
        Some(1) => "½×",
        Some(3) => "2×",
        Some(4) => "4×",
        _ => "1×",
    }
}

/// The bar of a playback. Every control is reached by Tab and worked by Space, Enter and the arrow keys.
///
/// The caller advances the playback, and asks for frames while it plays.
pub fn transport_ui(ui: &mut Ui, playback: &mut Playback, pace: &mut Pace) {
    let palette = Palette::of(ui);
    ui.horizontal(|ui| {
        let (sign, name) = if playback.is_playing { ("⏸", "Pause") } else { ("▶", "Play") };
        let play = Button::new(RichText::new(sign).color(palette.text)).min_size([34.0, 0.0].into());
        if ui.add(play).accessible_name(name).on_hover_text(name).clicked() {
            playback.toggle();
        }
        if ui.button("⏮").accessible_name("Back to the start").on_hover_text("Back to the start").clicked()
        {
            playback.seek(0.0);
        }

        // In a narrow pane the end of the motion is not told: the slider shows how far away it is.
        let digits = fixed(playback.end, 1).len() as f32;
        let (words, width) = if ui.available_width() < ROOMY {
            (format!("{} s", fixed(playback.time, 1)), 7.0 * (digits + 2.0))
        } else {
            let words = format!("{} of {} s", fixed(playback.time, 1), fixed(playback.end, 0));
            (words, 7.0 * (2.0 * digits + 5.0))
        };
        let color = palette.weak;
        let galley = ui.painter().layout_no_wrap(words, theme::small(), color);
        // The words at their longest, the rates and the loop stand after the slider.
        let after = width + 56.0 + 36.0 + 4.0 * ui.spacing().item_spacing.x;
        let slider = ReferenceSlider {
            name: "Time of the playback in s",
            value_text: format!("{} s", fixed(playback.time, 2)),
            value: playback.time,
            range: 0.0..=playback.end.max(1e-3),
            reference: 0.0,
            in_effect: None,
        };
        let size = Vec2::new((ui.available_width() - after).max(NARROWEST), ui.spacing().interact_size.y);
        if let (_, Some(time)) = slider.show(ui, size) {
            playback.seek(time);
        }
        let (place, _) = ui.allocate_exact_size([width, galley.size().y].into(), egui::Sense::hover());
        ui.painter().galley(place.min, galley, color);

        let chosen = rate_text(pace.rate);
        let chooser = ComboBox::from_id_salt("rate").selected_text(chosen).width(38.0).show_ui(ui, |ui| {
            for rate in RATES {
                ui.selectable_value(&mut pace.rate, rate, rate_text(rate));
            }
        });
        theme::name_chooser(chooser, "Speed of the playback", chosen);
        let name = "Begin again at the end";
        ui.toggle_value(&mut pace.is_looping, "⟳").accessible_name(name).on_hover_text(name);
    });
}
