//! Arrow keys that a widget takes for itself while it has the focus, so that they don't move the focus on.

use egui::{EventFilter, FocusDirection, Id, Response, Ui};

/// To be called in every frame in which the widget has the focus.
///
/// egui locks the arrow keys from the second frame on only. One that is pressed sooner would work on the widget and take the
/// focus away from it.
pub fn keep(ui: &Ui, response: &Response) {
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|memory| {
        memory.set_focus_lock_filter(response.id, arrows);
        memory.move_focus(FocusDirection::None);
    });
    ui.data_mut(|data| data.insert_temp(owner(), response.id));
}

/// Whether the widget that has the focus is worked by arrow keys, and so has no use for Space.
pub fn are_of(ui: &Ui, focused: Id) -> bool {
    ui.data(|data| data.get_temp::<Id>(owner())) == Some(focused)
}

fn owner() -> Id {
    Id::unique("worked by arrow keys")
}
