//! The grid of a pole map: rays of equal damping ratio, arcs of equal natural frequency.

use egui_plot::{Line, LineStyle, PlotPoint, PlotPoints, PlotUi};

use super::theme::Palette;

/// Damping ratios of the rays.
pub const DAMPING_RATIOS: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

/// The part of the plane on screen, equal scales on both axes \[1/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Real part at the left edge.
    pub left: f64,
    /// Real part at the right edge.
    pub right: f64,
    /// Imaginary part at the top edge; the bottom is its negative.
    pub top: f64,
}

impl View {
    /// Distance of the farthest corner from the origin.
    fn reach(self) -> f64 {
        self.left.abs().max(self.right.abs()).hypot(self.top)
    }
}

/// Natural frequencies of the arcs \[rad/s\]: three to six round numbers up to the farther edge.
pub fn arc_frequencies(view: View) -> impl Iterator<Item = f64> {
    let edge = view.top.max(-view.left);
    let decade = 10_f64.powf((edge / 3.0).log10().floor());
    let digit = edge / 3.0 / decade;
    let step = decade
        * if digit < 2.0 {
            1.0
        } else if digit < 5.0 {
            2.0
        } else {
            5.0
        };
    let count = (view.reach() / step).floor().min(60.0) as usize;
    (1..=count).map(move |k| k as f64 * step)
}

/// Draws rays and arcs in the left half plane.
pub fn grid(plot: &mut PlotUi<'_>, view: View, palette: &Palette) {
    let dashed = |points: PlotPoints<'static>| {
        Line::new("", points)
            .color(palette.grid)
            .width(1.0)
            .style(LineStyle::dashed_loose())
            .allow_hover(false)
    };
    for zeta in DAMPING_RATIOS {
        // λ = ωₙ(−ζ ± j√(1 − ζ²))
        let (re, im) = (-zeta * view.reach(), (1.0 - zeta * zeta).sqrt() * view.reach());
        plot.line(dashed(PlotPoints::Owned(vec![
            PlotPoint::new(re, im),
            PlotPoint::new(0.0, 0.0),
            PlotPoint::new(re, -im),
        ])));
    }
    for wn in arc_frequencies(view) {
        let arc = |k: i32| {
            let angle = std::f64::consts::FRAC_PI_2 * (1.0 + f64::from(k) / 24.0);
            PlotPoint::new(wn * angle.cos(), wn * angle.sin())
        };
        plot.line(dashed(PlotPoints::Owned((0..=48).map(arc).collect())));
    }
}
