//! What a parameter means: below the sliders, and where its symbol is tapped or clicked.

use egui::accesskit::Role;
use egui::{Popup, PopupCloseBehavior, Rect, Response, ScrollArea, Sense, Ui, Vec2, WidgetInfo};

use super::curtain::Curtain;
use super::symbol::{Symbol, prose};
use super::theme::{self, Palette};
use crate::scenario::{Convention, Hidden, Parameter};
use crate::words;

/// Of what a tap on a symbol opens.
const CARD_WIDTH: f32 = 420.0;

/// What a tap on a symbol opens, or a click. For who has a mouse it is neither a stop of the Tab key nor a button that is read out, of
/// which every row would have one: the card below the sliders tells the same, and the tab of the chart chooses its slider.
pub(super) fn explained_by_tap(ui: &Ui, symbol: &Response, name: &str, card: impl FnOnce(&mut Ui)) {
    let place = Rect::from_center_size(
        symbol.rect.center(),
        symbol.rect.size().max(Vec2::splat(ui.spacing().interact_size.y)),
    );
    let is_button = theme::is_for_fingers(ui);
    let sense = if is_button { Sense::click() } else { Sense::CLICK };
    let button = ui.interact(place, symbol.id.with("explained"), sense);
    if is_button {
        let label = format!("What {name} means");
        button.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), &label));
    }
    theme::focus_ring(ui, &button);
    let width = (ui.content_rect().width() - 48.0).min(CARD_WIDTH);
    Popup::from_toggle_button_response(&button).close_behavior(PopupCloseBehavior::CloseOnClick).show(|ui| {
        ui.set_max_width(width);
        card(ui);
    });
}

/// The card below the sliders: what one of them means.
pub fn help_ui(ui: &mut Ui, key: &str, convention: Convention) {
    let Some(parameter) = Parameter::find(key) else { return };
    ui.separator();
    title_ui(ui, parameter, convention);
    ScrollArea::vertical()
        .id_salt("help")
        .auto_shrink(false)
        .show(ui, |ui| texts_ui(ui, parameter, convention));
}

/// Symbol and name.
pub(super) fn title_ui(ui: &mut Ui, parameter: &Parameter, convention: Convention) {
    let palette = Palette::of(ui);
    let mut title =
        Symbol::parse(parameter.written(convention).symbol).job(theme::sizes(ui).title_symbol, palette.text);
    title.append(
        &format!("  {}", parameter.name),
        0.0,
        egui::TextFormat::simple(theme::semibold(theme::sizes(ui).name), palette.text),
    );
    ui.label(title);
}

/// Meaning, sign and origin.
pub(super) fn texts_ui(ui: &mut Ui, parameter: &Parameter, convention: Convention) {
    let palette = Palette::of(ui);
    // Its sign says which mode it stiffens and damps, and here and there its meaning does.
    let tells_modes = !Curtain::of(ui).hides_any(&[Hidden::Names, Hidden::Reasons]);
    for text in [parameter.meaning, parameter.sign].into_iter().filter(|_| tells_modes) {
        ui.label(prose(text, theme::small(), palette.weak));
    }
    if !parameter.origin.is_empty() {
        ui.label(prose(&format!("From: {}", parameter.origin), theme::small(), palette.weak));
    }
    if let Some(sentence) = words::notation::of_slider(parameter, convention) {
        ui.label(prose(&sentence, theme::small(), palette.weak));
    }
}
