//! Gain and phase over frequency.

use maud::html;

use super::ink::COLOURS;
use super::plot::{Axis, LEFT, Plot, RIGHT, Scale, TOP, WIDTH, around, document};
use crate::export::scene::Scene;
use crate::findings::Findings;
use crate::scenario::Quantity;
use crate::words;

/// Height of a frame.
const HEIGHT: f64 = 130.0;
/// Between the frames.
const GAP: f64 = 22.0;

/// The figure of the output on screen; `None` where nothing moves.
pub fn frequency(scene: &Scene, findings: &Findings) -> Option<String> {
    let scenario = findings.scenario();
    let output = scene.view.response.frequency_of[scenario.plane];
    let flies = findings.flies_otherwise() && !findings.is_opened();
    let closed = if flies { findings.closed_frequency(output) } else { None };
    let points = &closed.or_else(|| findings.frequency(output))?.points;
    let (of, by) = (Quantity::of(output), Quantity::of_input(scenario.plane, scenario.driven_channel()));
    let length = scenario.length_unit();
    let unit = |quantity: &Quantity| quantity.dimension.symbol(length);
    let factor = by.dimension.in_si(length) / of.dimension.in_si(length);
    let gains =
        || points.iter().map(|point| (point.value.norm() * factor).log10()).filter(|gain| gain.is_finite());
    let (low, high) =
        gains().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let range = if low <= high { (low.floor(), high.ceil().max(low.floor() + 1.0)) } else { (-1.0, 1.0) };
    let frequencies = findings.frequency_range();
    let across = |title: &str| Axis {
        range: (frequencies.0.log10(), frequencies.1.log10()),
        scale: Scale::Decades,
        title: title.to_owned(),
    };
    let frame = |top: f64| [LEFT, top, WIDTH - LEFT - RIGHT, HEIGHT];
    let per = match (unit(&of), unit(&by)) {
        ("", "") => String::new(),
        (of, "") => format!(" [{of}]"),
        (of, by) => format!(" [{of} per {by}]"),
    };
    let gain = Plot {
        frame: frame(TOP),
        axes: [across(""), Axis { range, scale: Scale::Decades, title: format!("gain{per}") }],
    };
    let degrees =
        |point: &crate::flight::motion::frequency_response::FrequencyPoint| point.phase.to_degrees();
    let phase = Plot {
        frame: frame(TOP + HEIGHT + GAP),
        axes: [
            across("ω [rad/s]"),
            Axis {
                range: around(points.iter().map(degrees)),
                scale: Scale::Angles,
                title: "phase [deg]".to_owned(),
            },
        ],
    };
    let drawn = html! {
        (gain.clip()) (phase.clip())
        (gain.ground())
        (gain.curve(points.iter().map(|p| (p.frequency.log10(), (p.value.norm() * factor).log10())), COLOURS[0], ""))
        (phase.ground())
        (phase.curve(points.iter().map(|p| (p.frequency.log10(), degrees(p))), COLOURS[0], ""))
    };
    let aircraft = &scenario.aircraft;
    let about = format!("{} by {}{}", of.name, by.name, super::how(findings));
    let note =
        findings.growing_mode().map(|mode| words::frequency::growing(mode.naming.name)).unwrap_or_default();
    let bottom = TOP + 2.0 * HEIGHT + GAP + 32.0;
    Some(document(bottom, &format!("{}: {}", aircraft.name, aircraft.condition), &about, &note, &drawn))
}
