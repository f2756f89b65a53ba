//! What a view shows, as CSV: a head with units, every digit, an empty cell where there is no number. Units are SI, with feet for metres
//! where a person has chosen them.

use crate::export::closed_loop::LoopOutcome;
use crate::export::error::ExportError;
use crate::export::frequency::{FrequencyRequest, frequency, gain_unit};
use crate::export::metrics::MetricsReport;
use crate::export::mode::ModeReport;
use crate::export::plane::PlaneReport;
use crate::export::respond::{ResponseRequest, respond};
use crate::export::scene::Scene;
use crate::export::signal::Signal;
use crate::findings::Findings;
use crate::findings::measures::Measure;
use crate::key::Keyed as _;
use crate::scenario::{Parameter, Scenario, parameters};

/// Text from a head and rows.
fn csv(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let written = writer
        .write_record(head)
        .and_then(|()| rows.into_iter().try_for_each(|row| writer.write_record(row)));
    // Nothing can go wrong on the way into memory; and if it did, the text would end there.
    debug_assert!(written.is_ok());
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, |x| x.to_string())
}

fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// The modes of a plane as it flies: with all states of its source, and under the law where there is one.
fn flown(plane: &PlaneReport) -> Vec<&ModeReport> {
    match &plane.closed_loop {
        Some(LoopOutcome::Analysed(closed)) => closed.modes.iter().map(|mode| &mode.mode).collect(),
        Some(LoopOutcome::Failed { .. }) | None => plane.modes.iter().collect(),
    }
}

/// The pole map: every eigenvalue of the plane.
pub fn poles(plane: &PlaneReport) -> String {
    let rows = flown(plane).into_iter().flat_map(|mode| {
        let pole = |im: f64| vec![mode.key.to_owned(), mode.re.to_string(), im.to_string()];
        let conjugate = (mode.im > 0.0).then(|| pole(-mode.im));
        std::iter::once(pole(mode.im)).chain(conjugate)
    });
    csv(&["mode", "re [1/s]", "im [rad/s]"], rows)
}

/// The cards of the modes.
pub fn modes(plane: &PlaneReport) -> String {
    let head = [
        "mode",
        "name",
        "stability",
        "re [1/s]",
        "im [rad/s]",
        "natural_frequency [rad/s]",
        "damping_ratio",
        "period [s]",
        "time_to_half [s]",
        "time_to_double [s]",
        "reason",
    ];
    let rows = flown(plane).into_iter().map(|mode| {
        vec![
            mode.key.to_owned(),
            mode.name.to_owned(),
            mode.stability.to_owned(),
            mode.re.to_string(),
            mode.im.to_string(),
            optional(mode.natural_frequency),
            optional(mode.damping_ratio),
            optional(mode.period),
            optional(mode.time_to_half),
            optional(mode.time_to_double),
            mode.reason.clone(),
        ]
    });
    csv(&head, rows)
}

/// The motion over time: inputs, then every output.
pub fn response(scene: &Scene) -> Result<String, ExportError> {
    let request =
        ResponseRequest { nonlinear: Some(false), split: Some(false), ..ResponseRequest::default() };
    let report = respond(scene, &request)?;
    let without = report.inputs.iter().chain(&report.outputs);
    let closed = report.closed_loop.iter().flat_map(|closed| closed.controls.iter().chain(&closed.outputs));
    let signals: Vec<(&str, &Signal)> =
        without.map(|signal| ("", signal)).chain(closed.map(|signal| (" under the law", signal))).collect();
    let unit = |signal: &'_ Signal| scene.scenario.units.of_data(signal.unit);
    let names: Vec<String> = signals
        .iter()
        .map(|(how, signal)| heading(&format!("{}{how}", signal.name), unit(signal).1))
        .collect();
    let head: Vec<&str> = std::iter::once("time [s]").chain(names.iter().map(String::as_str)).collect();
    let rows = report.time.iter().enumerate().map(|(k, time)| {
        let value = |signal: &Signal| signal.values.get(k).map(|value| value / unit(signal).0);
        let values = signals.iter().map(|(_, signal)| optional(value(signal)));
        std::iter::once(time.to_string()).chain(values).collect()
    });
    Ok(csv(&head, rows))
}

/// The numbers of the motion as it flies, a row an output; `None` where nothing moves.
pub fn metrics(findings: &Findings) -> Option<String> {
    let metrics = MetricsReport::of(findings.flown_metrics()?);
    let head = [
        "output",
        "unit",
        "peak",
        "peak_time [s]",
        "beyond",
        "steady",
        "rise_time [s]",
        "settling_time [s]",
        "overshoot",
        "root_mean_square",
    ];
    let rows = metrics.outputs.into_iter().map(|of| {
        let (in_si, unit) = findings.scenario().units.of_data(of.unit);
        let shown = |value: Option<f64>| value.map(|value| value / in_si);
        let numbers = [
            shown(of.peak.map(|peak| peak.value)),
            of.peak.map(|peak| peak.time),
            shown(of.beyond),
            shown(of.steady),
            of.rise_time,
            of.settling_time,
            of.overshoot,
            shown(of.root_mean_square),
        ];
        [of.name, unit].map(str::to_owned).into_iter().chain(numbers.map(optional)).collect()
    });
    Some(csv(&head, rows))
}

/// Gain and phase of the output that the view is of.
pub fn bode(scene: &Scene) -> Result<String, ExportError> {
    let report = frequency(scene, &FrequencyRequest::default())?;
    let [of, by] = [report.output.unit, report.input.unit].map(|unit| scene.scenario.units.of_data(unit));
    let (in_si, unit) = (of.0 / by.0, gain_unit(of.1, by.1));
    let gain = heading(&format!("gain of {} by {}", report.output.name, report.input.name), &unit);
    let mut columns = vec![
        ("frequency [rad/s]".to_owned(), &report.frequency, 1.0),
        (gain.clone(), &report.gain, in_si),
        ("phase [rad]".to_owned(), &report.phase, 1.0),
    ];
    if let Some(closed) = &report.closed_loop {
        columns.push((format!("{gain} under the law"), &closed.gain, in_si));
        columns.push(("phase [rad] under the law".to_owned(), &closed.phase, 1.0));
    }
    let rows = (0..report.frequency.len()).map(|k| {
        let value = |values: &[f64], in_si: f64| values.get(k).map(|value| value / in_si);
        columns.iter().map(|(_, values, in_si)| optional(value(values, *in_si))).collect()
    });
    let head: Vec<&str> = columns.iter().map(|(name, ..)| name.as_str()).collect();
    Ok(csv(&head, rows))
}

/// A measure over the range of a slider.
pub fn chart(findings: &Findings, (parameter, measure): (&'static Parameter, Measure)) -> String {
    let chart = findings.chart(parameter, measure);
    let [(over, over_unit), (of, of_unit)] = [parameter.dimension, measure.dimension()]
        .map(|dimension| findings.scenario().units.of_data(dimension.si_symbol()));
    let rows = chart.points.iter().map(|point| {
        let stability = point.stability.map_or("", |stability| stability.key());
        let reading = point.reading.map(|reading| reading / of);
        vec![(point.value / over).to_string(), optional(reading), stability.to_owned()]
    });
    let head = [heading(parameter.key, over_unit), heading(&measure.key(), of_unit)];
    csv(&[&head[0], &head[1], "stability"], rows)
}

/// Every number of the aircraft: coefficients, knobs, derivatives, entries of A and B, now and in its file.
pub fn derivatives(findings: &Findings) -> String {
    let scenario = findings.scenario();
    let reference = Scenario::new(scenario.aircraft.clone());
    let row = |p: &'static Parameter| {
        let (in_si, unit) = scenario.units.of_data(p.dimension.si_symbol());
        vec![
            p.key.to_owned(),
            p.page.map_or("", |page| page.key()).to_owned(),
            p.plane.map_or("", |plane| plane.key()).to_owned(),
            p.name.to_owned(),
            (p.get(scenario) / in_si).to_string(),
            (p.get(&reference) / in_si).to_string(),
            unit.to_owned(),
            p.meaning.to_owned(),
        ]
    };
    let of_aircraft = parameters().filter(|p| !p.is_of_disturbance() && p.applies(scenario));
    csv(
        &["key", "page", "plane", "name", "value", "value in its file", "unit", "meaning"],
        of_aircraft.map(row),
    )
}
