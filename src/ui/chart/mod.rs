//! Charts: curves and marks over two axes, of the pole map and of every small plot.
//!
//! | file | in one line |
//! |---|---|
//! | `view` | between the plane of the data and the screen |
//! | `axis` | round numbers on an axis, with labels that never collide |
//! | `axis_range` | ranges that keep still while a person drags |
//! | `curve` | a curve, and what of it is needed on screen |
//! | `thin` | points left out that nobody would miss |
//! | `primitive` | lines, areas, dots and rectangles: all that a chart is drawn with |
//! | `plot` | a small plot: title, axes, curves, cursor |
//!
//! A chart is drawn in two steps: its data become a list of [`Primitive`]s in points of the screen, and [`paint`] draws the list.
//! Another painter can draw the same list to a file.

mod axis;
mod axis_range;
mod curve;
mod plot;
mod primitive;
mod thin;
mod view;

pub use axis::{Room, Scale, Tick};
pub use axis_range::AxisRange;
pub use curve::Curve;
pub use plot::{DOT, PlotContent, SAMPLE, SmallPlot, sample};
pub use primitive::{Pattern, Primitive, paint, spaced};
pub use view::{Chart, PlotPoint, View};
