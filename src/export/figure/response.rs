//! The motion over time: the outputs that are shown on screen, one below the other.

use maud::{Markup, html};

use super::ink::{COLOURS, WEAK, n};
use super::plot::{Axis, LEFT, Plot, RIGHT, Scale, TOP, WIDTH, around, document};
use crate::export::scene::Scene;
use crate::findings::Findings;
use crate::flight::motion::outputs::Output;
use crate::scenario::Quantity;
use crate::words;

/// Height of a frame, and of the gap below it.
const HEIGHT: f64 = 78.0;
const GAP: f64 = 22.0;

/// The figure; `None` where nothing moves. Where the nonlinear flight is on screen it is dashed, and where the motion is no small
/// disturbance any more a line says so.
pub fn response(scene: &Scene, findings: &Findings) -> Option<String> {
    let motion = findings.flown_motion()?;
    let scenario = findings.scenario();
    let plane = scenario.plane;
    let length = scenario.length_unit();
    let duration = motion.experiment.grid.duration;
    let shown = &scene.view.response.shown[plane];
    let flight = if scene.view.response.nonlinear {
        findings.flight().and_then(|flight| flight.as_ref().ok())
    } else {
        None
    };
    let one = |(row, output): (usize, &Output)| -> Markup {
        let Quantity { symbol, name, dimension, .. } = Quantity::of(*output);
        let (unit, in_si) = (dimension.symbol(length), dimension.in_si(length));
        let values = motion.values(*output);
        let flown = flight.map_or_else(Vec::new, |flight| output.of_flight(&motion.model, flight));
        let small = values.iter().take(motion.small_samples());
        let range = around(small.chain(&flown).map(|x| x / in_si));
        let is_last = row + 1 == shown.len();
        let heading = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
        let plot = Plot {
            frame: [LEFT, TOP + row as f64 * (HEIGHT + GAP), WIDTH - LEFT - RIGHT, HEIGHT],
            axes: [
                Axis {
                    range: (0.0, duration),
                    scale: Scale::Even,
                    title: if is_last { "t [s]".to_owned() } else { String::new() },
                },
                Axis { range, scale: Scale::Even, title: format!("{name} {}{heading}", plain(symbol)) },
            ],
        };
        let over = |dt: f64, values: Vec<f64>| {
            values.into_iter().enumerate().map(move |(k, x)| (k as f64 * dt, x / in_si))
        };
        html! {
            (plot.clip())
            (plot.ground())
            @if let Some(time) = motion.small_until {
                @let ((x, top), (_, bottom)) = (plot.place((time, range.1)), plot.place((time, range.0)));
                line x1=(n(x)) x2=(n(x)) y1=(n(top)) y2=(n(bottom)) stroke=(WEAK) stroke-dasharray="3 2" {}
            }
            (plot.curve(over(motion.response.dt, values), COLOURS[0], ""))
            @if let Some(flight) = flight { (plot.curve(over(flight.dt, flown), COLOURS[1], "4 2")) }
        }
    };
    let drawn = html! { @for output in shown.iter().enumerate() { (one(output)) } };
    let aircraft = &scenario.aircraft;
    let mut about = words::disturbance::choice(&scenario.disturbance.choices[plane]);
    about += &super::how(findings);
    if flight.is_some() {
        about += "; linear, and nonlinear dashed";
    }
    let note = words::small_disturbance::sentence(motion, length).unwrap_or_default();
    let bottom = TOP + shown.len() as f64 * (HEIGHT + GAP) + 10.0;
    Some(document(bottom, &format!("{}: {}", aircraft.name, aircraft.condition), &about, &note, &drawn))
}

/// A symbol without the sign of its index, which is small enough to be read so.
pub fn plain(symbol: &str) -> String {
    symbol.replace(['_', '{', '}'], "")
}
