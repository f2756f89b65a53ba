//! A measure over the range of a slider.

use maud::html;

use super::ink::{COLOURS, WEAK, n};
use super::letters::{self, Align};
use super::plot::{Axis, LEFT, Plot, RIGHT, Scale, TOP, WIDTH, document};
use super::response::plain;
use crate::export::scene::Scene;
use crate::findings::measures::{Measure, Reading};
use crate::findings::{Findings, MeasureChart};
use crate::flight::modes::stability::Stability;
use crate::scenario::Parameter;
use crate::words;

/// Height of the frame.
const HEIGHT: f64 = 240.0;
/// The ground where the motion isn't stable.
const UNSTABLE: &str = "#fdf1ec";

/// The chart that is on screen: the curve, its pinned twin dashed, limits of levels, lines of one's own, and where it is now.
pub fn chart(
    scene: &Scene,
    findings: &Findings,
    (parameter, measure): (&'static Parameter, Measure),
) -> String {
    let scenario = findings.scenario();
    let convention = scenario.convention();
    let chart = findings.chart(parameter, measure);
    let pinned = scene.pinned.clone().map(Findings::of).map(|pinned| pinned.chart(parameter, measure));
    let (over, of) = (parameter.written(convention), words::measure::written(measure, convention));
    let (x_si, y_si) = (over.in_si, of.in_si);
    let own: Vec<f64> =
        scene.view.response.chart[scenario.plane].lines.iter().map(|line| line / y_si).collect();
    let ends = [chart.points.first(), chart.points.last()].map(|point| point.map_or(0.0, |p| p.value / x_si));
    let ranges = [Some(&chart), pinned.as_ref()].into_iter().flatten().filter_map(|chart| chart.range());
    let shown = ranges.map(|(low, high)| (low / y_si, high / y_si)).chain(own.iter().map(|y| (*y, *y)));
    let (low, high) = shown.reduce(|all, one| (all.0.min(one.0), all.1.max(one.1))).unwrap_or((0.0, 1.0));
    let span = if high > low { high - low } else { high.abs().max(1.0) };
    let title = |symbol: &str, name: &str, unit: &str| {
        let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
        format!("{name} {}{unit}", plain(symbol))
    };
    let plot = Plot {
        frame: [LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT],
        axes: [
            Axis {
                range: (ends[0], ends[1]),
                scale: Scale::Even,
                title: title(over.symbol, parameter.name, over.unit),
            },
            Axis {
                range: (low - 0.08 * span, high + 0.08 * span),
                scale: Scale::Even,
                title: title(of.symbol, &words::measure::name(measure), of.unit),
            },
        ],
    };
    let [_, top, _, height] = plot.frame;
    let unstable = || chart.stabilities().filter(|(_, stability)| *stability != Stability::Stable);
    let curves = |chart: &MeasureChart, colour: &str, dashes: &str| {
        html! {
            @for run in chart.runs() {
                (plot.curve(run.iter().filter_map(|p| Some((p.value / x_si, p.reading? / y_si))), colour, dashes))
            }
        }
    };
    let limits = chart.limits();
    let limits: Vec<_> = limits
        .iter()
        .filter(|(_, line)| {
            line.iter().any(|(_, y)| (low - 0.08 * span..=high + 0.08 * span).contains(&(y / y_si)))
        })
        .collect();
    let across = |y: f64| [(ends[0], y), (ends[1], y)].into_iter();
    let now = parameter.get(scenario) / x_si;
    let reading = match measure.read(findings) {
        Ok(Reading::Number(number)) => Some(number / y_si),
        _ => None,
    };
    let drawn = html! {
        (plot.clip())
        @for (part, _) in unstable() {
            @let ((from, _), (to, _)) = (plot.place((part.start() / x_si, low)), plot.place((part.end() / x_si, low)));
            rect x=(n(from)) y=(n(top)) width=(n(to - from)) height=(n(height)) fill=(UNSTABLE) {}
        }
        (plot.ground())
        @for (limit, line) in &limits {
            (plot.curve(line.iter().map(|(x, y)| (x / x_si, y / y_si)), COLOURS[2], "5 3"))
            @if let Some((x, y)) = line.last() {
                @let (x, y) = plot.place((x / x_si, y / y_si));
                (letters::words((x - 3.0, y - 3.0), Align::End, COLOURS[2], words::chart::limit(limit.level)))
            }
        }
        @for line in &own { (plot.curve(across(*line), COLOURS[3], "1.5 2.5")) }
        @if let Some(pinned) = &pinned { (curves(pinned, WEAK, "4 2")) }
        (curves(&chart, COLOURS[0], ""))
        @if let Some(y) = reading {
            @let (x, y) = plot.place((now, y));
            circle cx=(n(x)) cy=(n(y)) r="3.5" fill=(COLOURS[1]) {}
        }
    };
    let aircraft = &scenario.aircraft;
    let mut note = match measure.read(findings) {
        Ok(reading) => words::chart::now(
            &words::measure::reading(measure, reading, convention),
            &plain(over.symbol),
            &words::measure::with_unit(&crate::number::trimmed(now, 4), over.unit),
        ),
        Err(absence) => words::chart::no_reading(&absence, convention.length),
    };
    note += ".";
    if unstable().next().is_some() {
        note += " Shaded: not stable.";
    }
    if pinned.is_some() {
        note += " Dashed: the pinned state.";
    }
    let about = words::chart::title(measure, parameter.name);
    document(
        TOP + HEIGHT + 32.0,
        &format!("{}: {}", aircraft.name, aircraft.condition),
        &about,
        &note,
        &drawn,
    )
}
