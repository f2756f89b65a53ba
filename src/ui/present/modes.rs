//! The modes for a room: of each its name and what is told of it, large.

use egui::{CornerRadius, Rect, RichText, Ui, UiBuilder, Vec2};

use crate::findings::Findings;
use crate::flight::modes::mode::Mode;
use crate::flight::modes::stability::Stability;
use crate::key::Keyed as _;
use crate::number::significant;
use crate::scenario::Hidden;
use crate::ui::curtain::Curtain;
use crate::ui::theme::{self, Palette};
use crate::words;

/// Least width and height of a mode \[points\].
const LEAST: Vec2 = Vec2::new(190.0, 74.0);
const GAP: f32 = 10.0;
/// So much larger they are where there is room.
const LARGEST: f32 = 1.8;
const NAME: f32 = 18.0;
const NUMBERS: f32 = 15.0;

/// Draws the modes over all the room there is; those that have none are left out.
pub fn modes_ui(ui: &mut Ui, findings: &Findings) {
    let Some(plane) = findings.flown() else { return };
    let curtain = Curtain::of(ui);
    let palette = Palette::of(ui);
    if !curtain.hides(Hidden::Verdicts) {
        let (color, _) = palette.verdict(plane.dynamic_stability);
        let text = words::stability::dynamic_alone(plane);
        ui.label(RichText::new(text).font(theme::semibold(NUMBERS)).color(color));
        ui.add_space(4.0);
    }
    let room = ui.available_rect_before_wrap();
    let order = curtain.order(&plane.modes);
    let across = ((room.width() + GAP) / (LEAST.x + GAP)).floor().clamp(1.0, 2.0) as usize;
    let down = order.len().div_ceil(across).max(1);
    let height = ((room.height() + GAP) / down as f32 - GAP).clamp(LEAST.y, LARGEST * LEAST.y);
    let size = Vec2::new((room.width() + GAP) / across as f32 - GAP, height);
    for (place, index) in order.into_iter().enumerate() {
        let at = Vec2::new((place % across) as f32, (place / across) as f32) * (size + Vec2::splat(GAP));
        let card = Rect::from_min_size(room.min + at, size);
        if card.bottom() <= room.bottom() + 1.0 {
            card_ui(ui, card, &plane.modes[index]);
        }
    }
}

fn card_ui(ui: &mut Ui, card: Rect, mode: &Mode) {
    let (curtain, palette) = (Curtain::of(ui), Palette::of(ui));
    let larger = (card.height() / LEAST.y).min(card.width() / LEAST.x).clamp(1.0, LARGEST);
    let color = palette.mode(mode.naming.name);
    let bar = Rect::from_min_size(card.min, Vec2::new(5.0, card.height()));
    ui.painter().rect_filled(card, CornerRadius::same(6), palette.field);
    ui.painter().rect_filled(bar, CornerRadius { nw: 6, sw: 6, ne: 0, se: 0 }, color);
    let inner = card.shrink2(larger * Vec2::new(12.0, 6.0));
    let ui = &mut ui
        .new_child(UiBuilder::new().id_salt(("mode for a room", mode.naming.name.key())).max_rect(inner));
    let name = RichText::new(curtain.title(mode.naming.name)).font(theme::semibold(larger * NAME));
    theme::heading(ui, name.color(palette.mode_text(mode.naming.name)), 3);
    let lines = [curtain.numbers(mode), growth(mode).filter(|_| !curtain.hides(Hidden::Numbers))];
    for line in lines.into_iter().flatten() {
        ui.label(RichText::new(line).size(larger * NUMBERS).color(palette.text));
    }
}

/// How fast an oscillation fades or grows; of a real root its numbers have it.
fn growth(mode: &Mode) -> Option<String> {
    let seconds = |time: f64| significant(time, 2);
    match mode.stability {
        _ if !mode.is_oscillatory() => None,
        Stability::Unstable => mode.time_to_double().map(|time| format!("doubles in {} s", seconds(time))),
        _ => mode.time_to_half().map(|time| format!("halves in {} s", seconds(time))),
    }
}
