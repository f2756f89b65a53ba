//! What is under the pointer, copied by one key: a number, a table, a curve. What is drawn offers its text, and the smallest that the
//! pointer is on is taken.

use egui::{Context, Id, Rect, Ui};

/// What has been offered in a frame in which the key was pressed.
#[derive(Clone, Debug, Default)]
struct Offered {
    /// Area of the smallest, and its text.
    smallest: Option<(f32, String)>,
}

fn id() -> Id {
    Id::unique("copied by key")
}

/// Asks all that is drawn in this frame.
pub fn ask(ctx: &Context) {
    ctx.data_mut(|data| data.insert_temp(id(), Offered::default()));
}

/// Offers the text of what is drawn at a place.
pub fn offer(ui: &Ui, place: Rect, text: &dyn Fn() -> String) {
    let Some(offered) = ui.data(|data| data.get_temp::<Offered>(id())) else { return };
    let area = place.area();
    if !ui.rect_contains_pointer(place) || offered.smallest.is_some_and(|(least, _)| least <= area) {
        return;
    }
    let smallest = Some((area, text()));
    ui.data_mut(|data| data.insert_temp(id(), Offered { smallest }));
}

/// What is to be copied, at the end of the frame; `None` where nothing was asked for, and empty where nothing is there.
pub fn take(ctx: &Context) -> Option<String> {
    let offered = ctx.data_mut(|data| data.remove_temp::<Offered>(id()))?;
    Some(offered.smallest.map_or_else(String::new, |(_, text)| text))
}

/// Cells as a spreadsheet takes them.
pub fn row(cells: &[&str]) -> String {
    cells.join("\t") + "\n"
}
