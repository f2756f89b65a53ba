//! Light: a black screen, a spotlight round the pointer, and a magnifier.

use egui::emath::TSTransform;
use egui::{Color32, Id, LayerId, Order, Pos2, Sense, Stroke, Ui, WidgetInfo, accesskit::Role};

/// Radius of the spotlight over the height of the screen.
const SPOT: f32 = 0.17;
/// How dark it is beside the spotlight.
const DARK: u8 = 205;
/// How much larger what is magnified is.
const LARGER: f32 = 2.0;

/// A black screen. A screen reader hears that it is one.
pub fn blank_ui(ui: &Ui) {
    let rect = ui.content_rect();
    ui.painter().rect_filled(rect, 0.0, Color32::BLACK);
    let response = ui.interact(rect, Id::unique("black screen"), Sense::click());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Label, true, "The screen is black; any key brings it back")
    });
}

/// Darkens everything but what is round the pointer.
pub fn spotlight_ui(ui: &Ui) {
    let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
    let rect = ui.content_rect();
    let radius = SPOT * rect.height();
    let width = 2.0 * (rect.width() + rect.height());
    let painter = ui.ctx().layer_painter(LayerId::new(Order::Foreground, Id::unique("spotlight")));
    // A ring so wide that it covers all that is outside of it.
    painter.circle_stroke(at, radius + 0.5 * width, Stroke::new(width, Color32::from_black_alpha(DARK)));
    ui.request_repaint();
}

/// Shows the page larger about a place that stays where it is, or as it is.
pub fn magnify(ui: &Ui, about: Option<Pos2>) {
    let transform = about.map_or(TSTransform::IDENTITY, |at| TSTransform {
        scaling: LARGER,
        translation: at.to_vec2() * (1.0 - LARGER),
    });
    ui.ctx().set_transform_layer(ui.layer_id(), transform);
}
