//! The colours of figures, and how a number of the drawing is written.

/// Colours of curves and poles, in order: told apart by people who see few colours, and by their darkness in print.
pub const COLOURS: [&str; 5] = ["#0072b2", "#d55e00", "#008a65", "#b04a84", "#8c5e00"];
/// Words, but those that are looked past.
pub const TEXT: &str = "#1f2d3a";
/// Lines behind curves.
pub const GRID: &str = "#dce3ea";
/// What is looked past: axes through zero, what is pinned, limits.
pub const WEAK: &str = "#788694";

/// A number of the drawing: hundredths of a point.
pub fn n(x: f64) -> String {
    let x = (100.0 * x).round() / 100.0 + 0.0;
    x.to_string()
}
