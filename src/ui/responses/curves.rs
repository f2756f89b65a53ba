//! The motion of a scenario as curves in shown units.

use std::ops::RangeInclusive;

use egui::Color32;

use crate::findings::Findings;
use crate::flight::Channel;
use crate::flight::aircraft::plane::Plane;
use crate::flight::analysis::Motion;
use crate::flight::motion::flight_path::Sample;
use crate::flight::motion::inputs::Input;
use crate::flight::motion::modal_decomposition::{ModalDecomposition, SplitError};
use crate::flight::motion::outputs::Output;
use crate::scenario::{Dimension, Quantity, Scenario};
use crate::ui::chart::{Curve, Pattern, PlotPoint};
use crate::ui::curtain::Curtain;
use crate::ui::theme::Palette;
use crate::words;

/// An output as a curve of time.
pub fn linear(
    findings: &Findings,
    output: Output,
    unit: f64,
    pattern: Pattern,
    color: Color32,
) -> Option<Curve> {
    let name = if pattern == Pattern::Full { "linear" } else { "pinned" };
    let motion = findings.flown_motion()?;
    Some(timed(motion, name, &motion.values(output), unit, pattern, color))
}

/// One output over another, in their units, with every sample divided into `parts`.
pub fn portrait(
    findings: &Findings,
    parts: usize,
    (across, upward): (Output, Output),
    (across_unit, upward_unit): (f64, f64),
    pattern: Pattern,
    color: Color32,
) -> Option<Curve> {
    let name = if pattern == Pattern::Full { "linear" } else { "pinned" };
    let motion = findings.flown_motion_in(findings.flown_motion()?.experiment.grid.steps * parts)?;
    let values = motion.values(across).into_iter().zip(motion.values(upward));
    let points = values.map(|(x, y)| PlotPoint::new(x / across_unit, y / upward_unit)).collect();
    Some(Curve::new(name, points, color, pattern).faded_after(motion.small_samples()).directed())
}

/// The path over the Earth, with every sample divided into `parts`: of longitudinal motion the height gained over the distance
/// flown, of lateral motion the displacement to the right \[m\].
pub fn path(findings: &Findings, parts: usize, pattern: Pattern, color: Color32) -> Option<Curve> {
    let name = if pattern == Pattern::Full { "linear" } else { "pinned" };
    let motion = findings.flown_motion_in(findings.flown_motion()?.experiment.grid.steps * parts)?;
    let (ahead, aside) = match motion.model.plane {
        Plane::Longitudinal => (Some(motion.values(Output::Distance)), motion.values(Output::Height)),
        Plane::Lateral => (None, motion.values(Output::Offset)),
    };
    let steady = motion.model.trim.speed * motion.model.trim.gamma0.cos() * motion.response.dt;
    let flown = |k: usize| k as f64 * steady + ahead.as_ref().map_or(0.0, |ahead| ahead[k]);
    let points = aside.iter().enumerate().map(|(k, aside)| PlotPoint::new(flown(k), *aside)).collect();
    Some(Curve::new(name, points, color, pattern).faded_after(motion.small_samples()).directed())
}

/// The ground as a level line over a range, where the motion goes below it.
pub fn ground(
    findings: &Findings,
    across: RangeInclusive<f64>,
    unit: f64,
    palette: &Palette,
) -> Option<Curve> {
    let height = findings.ground()? / unit;
    let points = [*across.start(), *across.end()].map(|x| PlotPoint::new(x, height)).to_vec();
    Some(Curve::new("sea level", points, palette.warning, Pattern::Dashed))
}

/// An output of the nonlinear flight as a curve of time, where there is one.
pub fn nonlinear(findings: &Findings, output: Output, unit: f64, palette: &Palette) -> Option<Curve> {
    let flight = findings.flight()?.as_ref().ok()?;
    let values = output.of_flight(&findings.flown_motion()?.model, flight).into_iter().enumerate();
    let points: Vec<PlotPoint> =
        values.map(|(k, value)| PlotPoint::new(k as f64 * flight.dt, value / unit)).collect();
    Some(Curve::new("nonlinear", points, palette.nonlinear, Pattern::Dotted))
}

/// The parts of the modes of an output, each in its colour.
pub fn parts(
    findings: &Findings,
    output: Output,
    unit: f64,
    (palette, curtain): (&Palette, &Curtain),
) -> Result<Vec<Curve>, SplitError> {
    let (Some(motion), Some(split)) = (findings.flown_motion(), findings.flown_split(output)) else {
        return Ok(Vec::new());
    };
    let ModalDecomposition { parts, rest } = &split?;
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let whole = parts.iter().map(|part| largest(part)).fold(0.0, f64::max);
    let part = |name, values: &[f64], color| timed(motion, name, values, unit, Pattern::Filled, color);
    let of_mode = |index: usize| {
        let (mode, values) = (findings.flown_modes().get(index)?, parts.get(index)?);
        Some(part(curtain.title(mode.naming.name), values, palette.mode(mode.naming.name)))
    };
    let mut curves: Vec<Curve> =
        curtain.order(findings.flown_modes()).into_iter().filter_map(of_mode).collect();
    // Rounding is no part.
    if largest(rest) > 1e-6 * whole {
        curves.push(part("no mode: input and drift", rest, palette.pinned));
    }
    Ok(curves)
}

fn timed(
    motion: &Motion,
    name: &'static str,
    values: &[f64],
    unit: f64,
    pattern: Pattern,
    color: Color32,
) -> Curve {
    let dt = motion.response.dt;
    let point = |(k, value): (usize, &f64)| PlotPoint::new(k as f64 * dt, value / unit);
    let points = values.iter().enumerate().map(point).collect();
    Curve::new(name, points, color, pattern).faded_after(motion.small_samples())
}

/// The inputs as they are, their edges upright, with the symbol of each and the dimension of all; none where nothing moves.
pub fn inputs(findings: &Findings, palette: &Palette) -> Option<(Vec<&'static str>, Dimension, Vec<Curve>)> {
    let experiment = &findings.flown_motion()?.experiment;
    let length = findings.scenario().length_unit();
    let end = experiment.grid.duration;
    let mut shown = None;
    let mut symbols = Vec::new();
    let mut curves = Vec::new();
    for (i, (channel, input)) in experiment.inputs.iter().enumerate() {
        let Quantity { symbol, name, dimension, .. } = Quantity::of_input(experiment.plane, *channel);
        let unit = Quantity::input_sign(experiment.plane, *channel) * dimension.in_si(length);
        let mut times: Vec<f64> = (0..=experiment.grid.steps).map(|k| experiment.grid.time(k)).collect();
        for edge in input.edges().filter(|&edge| edge > 0.0 && edge < end) {
            // On either side of it, so that it stands upright.
            times.extend([edge - 1e-9 * end, edge]);
        }
        times.sort_by(f64::total_cmp);
        let points: Vec<PlotPoint> =
            times.into_iter().map(|t| PlotPoint::new(t, input.at(t) / unit)).collect();
        let (color, pattern) =
            if i == 0 { (palette.text, Pattern::Full) } else { (palette.weak, Pattern::Dashed) };
        curves.push(Curve::new(name, points, color, pattern));
        symbols.push(symbol);
        shown.get_or_insert(dimension);
    }
    shown.map(|dimension| (symbols, dimension, curves))
}

/// What a law of feedback moves each control by, with its symbol and dimension; none of a control that it leaves alone. Of a
/// `nonlinear` flight, what its limits leave of it too.
pub fn by_law(
    findings: &Findings,
    nonlinear: bool,
    palette: &Palette,
) -> Vec<(&'static str, Dimension, Vec<Curve>)> {
    let Some(motion) = findings.flown_motion() else { return Vec::new() };
    let plane = motion.model.plane;
    let channels = [Channel::First, Channel::Second].into_iter().zip(words::feedback::moved(plane));
    let flight = if nonlinear { findings.flight().and_then(|flight| flight.as_ref().ok()) } else { None };
    let curve = |(input, (channel, (symbol, name))): (&Input, (Channel, (&'static str, &'static str)))| {
        let dimension = Quantity::of_input(plane, channel).dimension;
        let values: Vec<f64> =
            (0..motion.response.states.len()).map(|k| input.at(k as f64 * motion.response.dt)).collect();
        let unit = dimension.in_si(findings.scenario().length_unit());
        let is_moved = values.iter().any(|value| *value != 0.0);
        let drawn = || timed(motion, name, &values, unit, Pattern::Full, palette.text);
        let limited = flight.map(|flight| {
            let places = &motion.experiment.inputs;
            let by_pilot = |t: f64| -> f64 {
                places.iter().filter(|(of, _)| *of == channel).map(|(_, input)| input.at(t)).sum()
            };
            let moved = |(k, sample): (usize, &Sample)| {
                let t = k as f64 * flight.dt;
                PlotPoint::new(
                    t,
                    (sample.inputs(plane)[usize::from(channel == Channel::Second)] - by_pilot(t)) / unit,
                )
            };
            let points = flight.samples.iter().enumerate().map(moved).collect();
            Curve::new("nonlinear", points, palette.nonlinear, Pattern::Dotted)
        });
        is_moved.then(|| (symbol, dimension, std::iter::once(drawn()).chain(limited).collect()))
    };
    motion.by_law.iter().flatten().zip(channels).filter_map(curve).collect()
}

/// An output as it is written, its unit's symbol, and one of that unit in SI.
pub fn units(output: Output, scenario: &Scenario) -> (Quantity, &'static str, f64) {
    let quantity = Quantity::of(output);
    let length = scenario.length_unit();
    (quantity, quantity.dimension.symbol(length), quantity.dimension.in_si(length))
}
