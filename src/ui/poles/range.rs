//! What a map shows: fitted to its poles, or held where a person has zoomed or moved it to.

use egui::{Rect, Ui};
use nalgebra::Complex;

use super::chart::{Chart, View};
use crate::ui::axis_range::AxisRange;

/// A map can be brought this much nearer than fitted, and this much further away.
const NEAREST: f64 = 300.0;
const FARTHEST: f64 = 20.0;

/// The range of one map.
#[derive(Debug, Default)]
pub struct MapRange {
    x: AxisRange,
    y: AxisRange,
    /// Where a person has brought it; else it is fitted.
    held: Option<View>,
    /// Height of the fitted view \[1/s\].
    fitted_height: f64,
}

impl MapRange {
    /// What to draw now in `rect`: on the way to `wanted`, widened to the shape of `rect`, or where it is held.
    pub fn chart(&mut self, ui: &Ui, wanted: View, rect: Rect) -> Chart {
        let aspect = f64::from(rect.width() / rect.height().max(1.0));
        let width = wanted.right - wanted.left;
        let (left, top) = if width < 2.0 * wanted.top * aspect {
            (wanted.right - 2.0 * wanted.top * aspect, wanted.top)
        } else {
            (wanted.left, 0.5 * width / aspect)
        };
        self.fitted_height = 2.0 * top;
        if let Some(held) = self.held {
            let view = held.shaped(rect);
            self.x.hold(view.left..=view.right);
            self.y.hold(view.bottom..=view.top);
            return Chart { rect, view };
        }
        let x = self.x.toward(ui, left..=wanted.right);
        let y = self.y.toward(ui, -top..=top);
        let view = View { left: *x.start(), right: *x.end(), bottom: *y.start(), top: *y.end() };
        // One scale on both axes also while the one is on its way and the other there, and when the window changes.
        Chart { rect, view: view.shaped(rect) }
    }

    /// Whether it shows what its poles ask for.
    pub fn is_fitted(&self) -> bool {
        self.held.is_none()
    }

    /// Lets go of where it was held.
    pub fn fit(&mut self) {
        self.held = None;
    }

    /// Brings `chart` nearer by a factor, about a point of the plane.
    pub fn zoom(&mut self, chart: Chart, factor: f64, about: Complex<f64>) {
        let height = chart.view.top - chart.view.bottom;
        let factor =
            factor.clamp(height / (FARTHEST * self.fitted_height), NEAREST * height / self.fitted_height);
        if factor.is_finite() && factor > 0.0 {
            self.held = Some(chart.view.zoomed(factor, about));
        }
    }

    /// Moves what `chart` shows.
    pub fn pan(&mut self, chart: Chart, by: Complex<f64>) {
        // Zero stays within a few screens: nothing lies beyond.
        let moved = chart.view.moved(by);
        let far = FARTHEST * self.fitted_height;
        let on_map = |x: f64| x.abs() < far;
        if on_map(moved.left) && on_map(moved.right) && on_map(moved.bottom) && on_map(moved.top) {
            self.held = Some(moved);
        }
    }
}
