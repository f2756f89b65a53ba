//! How much higher the page would have to be to show all that it holds: noted by everything that scrolls, for the page around a
//! frame, which can make it so high.

use egui::{Context, Id, Order, Ui};

/// Forgets what was noted, as a frame begins.
pub fn begin(ctx: &Context) {
    ctx.data_mut(|data| data.remove::<f32>(id()));
}

/// Notes that something on the page, but not in a sheet over it, is higher than its room by so much \[points\]; lower where it is
/// negative.
pub fn note(ui: &Ui, missing: f32) {
    // What shrinks to what it holds is neither: it notes for itself.
    if missing == 0.0 || ui.layer_id().order != Order::Background {
        return;
    }
    ui.data_mut(|data| {
        let most = data.get_temp_mut_or(id(), missing);
        *most = most.max(missing);
    });
}

/// The most that is missing, if anything scrolls.
pub fn missing(ctx: &Context) -> Option<f32> {
    ctx.data(|data| data.get_temp(id()))
}

fn id() -> Id {
    Id::unique("missing height")
}
