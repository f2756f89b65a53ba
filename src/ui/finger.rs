//! One finger on something that stands where a page scrolls: up and down it scrolls, sideways and by a tap it works on the thing.
//! Two fingers always work on the thing, and so does a mouse.
//!
//! egui gives a drag to the topmost widget that senses one, whatever its direction. Here the widget gives an upright one on,
//! to the scroll area around it, which then follows the finger and rolls out as for any other drag.

use super::{room, theme};
use egui::{AsIdSalt, Id, IdSalt, MultiTouchInfo, Response, ScrollArea, Ui, UiBuilder, UiStackInfo};

/// Under this name a `Ui` tells what scrolls when a finger goes up or down in it.
const TAG: &str = "scrolled by finger";

/// What the scroll area that was drawn last has, for what stands beside it and is to scroll it too.
pub fn last_background(ui: &Ui) -> Option<Id> {
    ui.data(|data| data.get_temp(Id::unique(TAG)))
}

/// A vertical scroll area that follows a finger wherever it begins, and shows what the keyboard reaches in it.
pub fn scroll_area_ui<R>(
    ui: &mut Ui,
    name: impl AsIdSalt,
    area: ScrollArea,
    contents: impl FnOnce(&mut Ui) -> R,
) -> R {
    let name = IdSalt::new(name);
    // As egui names it; the tests by touch would notice if it were otherwise.
    let background = ui.make_persistent_id(IdSalt::new(name)).with("area");
    let contents = |ui: &mut Ui| {
        let inner = scrolls_ui(ui, Some(background), contents);
        show_focus(ui);
        inner
    };
    let shown = area.id_salt(name).show(ui, contents);
    room::note(ui, shown.content_size.y - shown.inner_rect.height());
    ui.data_mut(|data| data.insert_temp(Id::unique(TAG), background));
    shown.inner
}

/// Something in which a finger going up or down scrolls what `background` is of.
pub fn scrolls_ui<R>(ui: &mut Ui, background: Option<Id>, contents: impl FnOnce(&mut Ui) -> R) -> R {
    let info = background.map_or_else(UiStackInfo::default, |background| {
        UiStackInfo::default().with_tag_value(TAG, background)
    });
    ui.scope_builder(UiBuilder::new().ui_stack_info(info), contents).inner
}

/// Scrolls to what the keyboard has just reached, where that is out of sight. What the pointer presses stays under it.
fn show_focus(ui: &Ui) {
    if ui.input(|input| input.pointer.any_down() || input.pointer.any_released()) {
        return;
    }
    let reached = ui.memory(|memory| memory.focused().filter(|&id| !memory.had_focus_last_frame(id)));
    let Some(widget) = reached.and_then(|id| ui.ctx().read_response(id)) else { return };
    let is_here = widget.layer_id == ui.layer_id() && ui.min_rect().contains(widget.rect.center());
    if is_here && !ui.clip_rect().contains_rect(widget.rect) && widget.interact_rect != widget.rect {
        ui.scroll_to_rect(widget.rect.expand(ui.spacing().item_spacing.y), None);
    }
}

/// What a finger going up or down here would drag, if there is anything to scroll.
fn background(ui: &Ui) -> Option<Id> {
    let tagged = ui.stack().iter().find_map(|node| node.tags().get_downcast::<Id>(TAG).copied());
    tagged.filter(|&id| ui.ctx().read_response(id).is_some())
}

/// Whether what points at a widget works on it in this frame: a mouse; a finger that has tapped it or draws along it, or
/// anywhere where nothing scrolls. To be asked once a frame, before anything else of the response is used.
pub fn works_on(ui: &Ui, response: &Response) -> bool {
    if !ui.input(|input| input.any_touches()) {
        // A finger that has just left has tapped; what it had drawn along has been let go. One that has just come may be told as a
        // pointer first, and as a finger only in the next frame: until it moves it may be going to scroll.
        let may_be_finger = theme::is_for_fingers(ui) || ui.input(|input| input.has_touch_screen());
        return !may_be_finger || response.dragged() || response.clicked() || response.double_clicked();
    }
    let Some(background) = background(ui) else { return true };
    let upright = ui.input(|input| {
        let way = input.pointer.latest_pos().zip(input.pointer.press_origin()).map(|(to, from)| to - from);
        input.multi_touch().is_none() && way.is_some_and(|way| way.y.abs() > way.x.abs())
    });
    if response.drag_started() && upright {
        ui.ctx().set_dragged_id(background);
        return false;
    }
    // A tap may be over before its touch is told to have ended.
    response.dragged() || response.clicked()
}

/// What two fingers do on a widget; they take it away from what scrolls.
pub fn pinch(ui: &Ui, response: &Response) -> Option<MultiTouchInfo> {
    let pinch = ui.input(|input| input.multi_touch())?;
    if !response.interact_rect.contains(pinch.start_pos) {
        return None;
    }
    if background(ui).is_some_and(|background| ui.ctx().is_being_dragged(background)) {
        ui.ctx().set_dragged_id(response.id);
    }
    Some(pinch)
}
