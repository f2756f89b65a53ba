//! A motion as tables for people: samples, metrics, and what else was asked for.

use eigenwing::export::{FlightOutcome, MetricsReport, ResponseReport, Signal, SplitOutcome, SplitReport};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::key::Keyed;
use eigenwing::words::metrics as words;

use crate::shown_units::ShownUnits;
use crate::tables::{DIGITS, heading, number, optional, percent, stride, table};

/// Columns of a motion that fit side by side; more are for `--csv`.
const OUTPUTS: usize = 5;

pub fn response(report: &ResponseReport, units: ShownUnits) -> String {
    let disturbance: Vec<&str> =
        [Some(report.disturbance), report.shape, report.mode].into_iter().flatten().collect();
    let mut text = format!("{}: {}, {}\n", report.aircraft.name, report.plane, disturbance.join(" "));
    text += &samples(&report.time, report.inputs.iter().chain(report.outputs.iter().take(OUTPUTS)), units);
    if let Some(sentence) = &report.small_limit {
        text += &format!("{sentence}.\n");
    }
    if let Some(time) = report.cut_at {
        text +=
            &format!("Cut at {} s, where the linear motion is too large to mean anything.\n", number(time));
    }
    text += &metrics(report.plane, &report.metrics, units);
    if let Some(closed) = &report.closed_loop {
        text += "\nUnder the law\n";
        let signals = closed.controls.iter().chain(closed.outputs.iter().take(OUTPUTS - 1));
        text += &samples(&report.time, signals, units);
        text += &metrics(report.plane, &closed.metrics, units);
    }
    match &report.nonlinear {
        Some(FlightOutcome::Flown(flight)) => {
            text += "\nNonlinear flight\n";
            text += &samples(&flight.time, flight.outputs.iter().take(OUTPUTS), units);
            for sentence in &flight.limit_sentences {
                text += &format!("{sentence}.\n");
            }
            if let Some(stop) = &flight.stop {
                text += &format!("Nonlinear flight ends: {}.\n", stop.sentence);
            }
        }
        Some(FlightOutcome::Refused { error }) => text += &format!("\nNo nonlinear flight: {error}.\n"),
        None => {}
    }
    text + &report.split.as_deref().map_or_else(String::new, |split| parts(split, units))
}

/// A row a sample, as many as can be read.
fn samples<'a>(time: &[f64], signals: impl Iterator<Item = &'a Signal>, units: ShownUnits) -> String {
    let signals: Vec<&Signal> = signals.collect();
    let heads: Vec<String> = std::iter::once(heading("time", "s"))
        .chain(signals.iter().map(|signal| heading(signal.name, units.of_motion(signal.unit).1)))
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let step = stride(time.len());
    let column = |signal: &&'a Signal| {
        (signal.values.as_slice(), largest(&signal.values), units.of_motion(signal.unit).0)
    };
    let columns: Vec<(&[f64], f64, f64)> = signals.iter().map(column).collect();
    let rows = (0..time.len()).step_by(step).map(|k| {
        let cell = |&(values, most, in_si): &(&[f64], f64, f64)| {
            optional(values.get(k).map(|x| unless_rounding(*x, most) / in_si))
        };
        std::iter::once(optional(time.get(k).copied())).chain(columns.iter().map(cell)).collect()
    });
    let mut text = table(0, &heads, rows);
    if step > 1 {
        text += &format!(
            "Every {step}th of {} samples; --csv and --json give all, of more outputs.\n",
            time.len()
        );
    }
    text
}

/// A row an output, and what concerns the whole motion.
fn metrics(plane: &str, metrics: &MetricsReport, units: ShownUnits) -> String {
    let seconds = |time: Option<f64>| time.map_or_else(String::new, |t| format!("{} s", number(t)));
    let is_random = metrics.outputs.iter().any(|of| of.root_mean_square.is_some());
    let rows = metrics.outputs.iter().map(|of| {
        let (in_si, unit) = units.of_motion(of.unit);
        // What is still growing where the linear model ends is no peak.
        let beyond = of.beyond.map(|value| format!("beyond {}", number(value / in_si)));
        let peak = beyond.unwrap_or_else(|| optional(of.peak.map(|peak| peak.value / in_si)));
        let mut row = vec![heading(of.name, unit), peak, seconds(of.peak.map(|peak| peak.time))];
        row.extend(if is_random {
            vec![optional(of.root_mean_square.map(|x| x / in_si))]
        } else {
            vec![
                optional(of.steady.map(|x| x / in_si)),
                seconds(of.rise_time),
                seconds(of.settling_time),
                percent(of.overshoot),
            ]
        });
        row
    });
    let columns: &[&str] = if is_random { &["r.m.s."] } else { &["steady", "rise", "settled", "overshoot"] };
    let head: Vec<&str> = ["output", "peak", "at"].iter().chain(columns).copied().collect();
    let mut text = format!("\n{}", table(1, &head, rows));
    let plane = Plane::by_key(plane).unwrap_or(Plane::Longitudinal);
    let lines = [
        metrics.load_factor_beyond.map(|value| words::load_factor_beyond(plane, value, DIGITS)),
        metrics.peak_load_factor.map(|peak| words::largest_load_factor(plane, peak.value, peak.time, DIGITS)),
        metrics.time_to_bank.map(|time| words::time_to_bank(time, DIGITS)),
        metrics.phugoid_swing.map(|height| words::phugoid_swing(height, units.length(), DIGITS)),
        metrics.control_anticipation.map(|cap| words::control_anticipation(cap, DIGITS)),
        metrics.steady_is_beyond.then(|| words::STEADY_BEYOND.to_owned()),
    ];
    for line in lines.into_iter().flatten() {
        text += &format!("{line}\n");
    }
    text
}

/// Largest values of the parts of the modes: a row for each output, a column for each mode.
fn parts(outcomes: &[SplitOutcome], units: ShownUnits) -> String {
    let splits: Vec<&SplitReport> = outcomes.iter().filter_map(SplitOutcome::split).collect();
    let mut text = String::new();
    if let Some(first) = splits.first() {
        let modes = first.parts.iter().map(|part| part.mode);
        let head: Vec<&str> = ["largest part"].into_iter().chain(modes).chain(["no mode"]).collect();
        let rows = splits.iter().map(|split| {
            let all = split.parts.iter().map(|part| &part.values).chain([&split.rest]);
            let peaks: Vec<f64> = all.map(|values| largest(values)).collect();
            let most = largest(&peaks);
            let (in_si, unit) = units.of_motion(split.unit);
            let mut row = vec![heading(split.name, unit)];
            row.extend(peaks.iter().map(|peak| number(unless_rounding(*peak, most) / in_si)));
            row
        });
        text += &format!("\n{}", table(1, &head, rows));
    }
    for outcome in outcomes {
        if let SplitOutcome::Refused { name, error } = outcome {
            text += &format!("{name} is not split: {error}.\n");
        }
    }
    text
}

/// The value farthest from zero, with its sign.
fn largest(values: &[f64]) -> f64 {
    values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
}

/// A value so much smaller than the others that it is zero but for rounding, as zero.
fn unless_rounding(x: f64, others: f64) -> f64 {
    if x.abs() <= 1e-12 * others.abs() { 0.0 } else { x }
}
