//! Two plots, one above the other, over one horizontal axis with one cursor.

use egui::{Sense, Ui, Vec2};

use crate::ui::chart::{PlotContent, SmallPlot};
use crate::ui::derivatives::Rows;
use crate::ui::theme;

/// Least height of both plots, where they can be read by a mouse, and by a finger.
const LEAST: (f32, f32) = (190.0, 300.0);
/// How much of it the upper one has.
const UPPER: f32 = 0.53;

/// Both plots, and where the cursor is.
#[derive(Debug, Default)]
pub struct Stack {
    plots: [SmallPlot; 2],
    /// Place under the pointer.
    hovered: Option<f64>,
}

impl Stack {
    /// Draws the plots over the room there is, but for a strip of this height.
    pub fn show(&mut self, ui: &mut Ui, pictures: &mut [PlotContent; 2], rows: Rows, below: f32) {
        let free = ui.available_height() - below;
        let height = match rows {
            Rows::Touch => LEAST.1,
            Rows::Dense if theme::is_for_a_room(ui) => free,
            Rows::Dense => free.max(LEAST.0),
        };
        let (area, _) = ui.allocate_exact_size(Vec2::new(ui.available_width(), height), Sense::hover());
        let split = area.top() + (UPPER * height).round();
        let before = self.hovered;
        let mut hovered = None;
        let [upper, lower] = &mut self.plots;
        let [above, under] = pictures;
        above.is_above = true;
        for (plot, picture, place) in
            [(upper, above, area.with_max_y(split)), (lower, under, area.with_min_y(split))]
        {
            hovered = plot.show(ui, place, picture, before).or(hovered);
        }
        self.hovered = hovered;
        if before != hovered {
            // Both have the cursor in the next frame.
            ui.request_repaint();
        }
    }
}
