//! The way of a measure to what is wanted of it, as a bar: from where it comes, where it is, and where it is to go.

use egui::accesskit::Role;
use egui::{Pos2, Rect, Sense, Stroke, Ui, Vec2, WidgetInfo};

use crate::lesson::Progress;
use crate::ui::theme::Palette;

const HEIGHT: f32 = 16.0;
const WIDEST: f32 = 320.0;
/// Room beside the outermost mark, as a share of what lies between the marks.
const MARGIN: f64 = 0.12;
/// What is wanted is at least so wide.
const NARROWEST: f32 = 4.0;

/// Draws the bar: a tick where it began, a dot where it is, and a field where it is to be.
pub fn way_ui(ui: &mut Ui, progress: &Progress, start: f64, now: f64, wanted: (f64, f64)) {
    let palette = Palette::of(ui);
    let (rect, response) =
        ui.allocate_exact_size(Vec2::new(ui.available_width().min(WIDEST), HEIGHT), Sense::HOVER);
    let percent = (100.0 * progress.share).round();
    response.widget_info(|| {
        WidgetInfo::labeled(Role::ProgressIndicator, true, format!("{percent} % of the way"))
    });
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_numeric_value(percent);
        node.set_min_numeric_value(0.0);
        node.set_max_numeric_value(100.0);
    });
    let ends = [start, now, wanted.0, wanted.1].into_iter().filter(|end| end.is_finite());
    let (low, high) =
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), end| (low.min(end), high.max(end)));
    let margin = (MARGIN * (high - low)).max(1e-12);
    let x = |value: f64| {
        let share = ((value - low + margin) / (high - low + 2.0 * margin)).clamp(0.0, 1.0);
        rect.left() + share as f32 * rect.width()
    };
    let (middle, painter) = (rect.center().y, ui.painter());
    painter.hline(rect.x_range(), middle, Stroke::new(3.0, palette.hairline));
    let (from, to) = (x(wanted.0), x(wanted.1));
    let wider = (0.5 * (NARROWEST - (to - from))).max(0.0);
    let field = Rect::from_x_y_ranges(from - wider..=to + wider, middle - 6.0..=middle + 6.0);
    painter.rect_filled(field, 3.0, palette.good_ground);
    painter.rect_stroke(field, 3.0, Stroke::new(1.0, palette.good), egui::StrokeKind::Inside);
    let (begun, is) = (x(start), x(now));
    let color = if progress.met { palette.good } else { palette.accent };
    painter.hline(begun.min(is)..=begun.max(is), middle, Stroke::new(3.0, color));
    painter.vline(begun, middle - 6.0..=middle + 6.0, Stroke::new(1.5, palette.pinned));
    painter.circle_filled(Pos2::new(is, middle), 5.0, color);
}
