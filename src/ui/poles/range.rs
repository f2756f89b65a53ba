//! What a map shows: fitted to its poles, or held where a person has zoomed or moved it to.

use egui::{Pos2, Rect, Ui, Vec2};

use crate::ui::chart::{AxisRange, Chart, PlotPoint, View};

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
    /// What it showed last.
    shown: Option<View>,
    /// Height of the fitted view \[1/s\].
    fitted_height: f64,
}

impl MapRange {
    /// What to draw now in `rect`: on the way to `wanted`, widened to the shape of `rect`, or where it is held. While a pole is
    /// dragged the map keeps `still`: the pole is under the pointer, and must not run away from it.
    pub fn chart(&mut self, ui: &Ui, wanted: View, rect: Rect, still: bool) -> Chart {
        let fitted = widened(wanted, rect);
        self.fitted_height = fitted.top - fitted.bottom;
        let view = match (self.held, self.shown) {
            (Some(held), _) => held.shaped(rect),
            (None, Some(shown)) if still => shown.shaped(rect),
            (None, _) => {
                let x = self.x.toward(ui, fitted.left..=fitted.right);
                let y = self.y.toward(ui, fitted.bottom..=fitted.top);
                // One scale on both axes also while the one is on its way and the other there.
                let [left, right] = [*x.start(), *x.end()];
                widened(View { left, right, bottom: *y.start(), top: *y.end() }, rect)
            }
        };
        if self.held.is_some() || still {
            self.x.hold(view.left..=view.right);
            self.y.hold(view.bottom..=view.top);
        }
        self.shown = Some(view);
        Chart { rect, view }
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
    pub fn zoom(&mut self, chart: Chart, factor: f64, about: PlotPoint) {
        let height = chart.view.top - chart.view.bottom;
        let factor =
            factor.clamp(height / (FARTHEST * self.fitted_height), NEAREST * height / self.fitted_height);
        if factor.is_finite() && factor > 0.0 {
            self.held = Some(chart.view.zoomed(factor, about));
        }
    }

    /// What two fingers do: `centre` is where they are, `by` how far that has gone, `factor` how far they have parted.
    pub fn pinch(&mut self, chart: Chart, centre: Pos2, by: Vec2, factor: f64) {
        self.pan(chart, chart.across(-by));
        let chart = Chart { view: self.held.unwrap_or(chart.view), ..chart };
        self.zoom(chart, factor, chart.at(centre));
    }

    /// Moves what `chart` shows.
    pub fn pan(&mut self, chart: Chart, by: PlotPoint) {
        // Zero stays within a few screens: nothing lies beyond.
        let moved = chart.view.moved(by);
        let far = FARTHEST * self.fitted_height;
        let on_map = |x: f64| x.abs() < far;
        if on_map(moved.left) && on_map(moved.right) && on_map(moved.bottom) && on_map(moved.top) {
            self.held = Some(moved);
        }
    }
}

/// A view that holds all of `view` and has the shape of `rect`: more on the left, or above and below.
fn widened(view: View, rect: Rect) -> View {
    let aspect = f64::from(rect.width() / rect.height().max(1.0));
    let width = view.right - view.left;
    let top = view.top.max(-view.bottom);
    if width < 2.0 * top * aspect {
        View { left: view.right - 2.0 * top * aspect, bottom: -top, top, ..view }
    } else {
        let top = 0.5 * width / aspect;
        View { bottom: -top, top, ..view }
    }
}
