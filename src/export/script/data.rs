//! What a view shows, as CSV: a head with units, SI, every digit, an empty cell where there is no number.

use crate::export::closed_loop::LoopOutcome;
use crate::export::error::ExportError;
use crate::export::frequency::{FrequencyRequest, frequency};
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
    let names: Vec<String> =
        signals.iter().map(|(how, signal)| heading(&format!("{}{how}", signal.name), signal.unit)).collect();
    let head: Vec<&str> = std::iter::once("time [s]").chain(names.iter().map(String::as_str)).collect();
    let rows = report.time.iter().enumerate().map(|(k, time)| {
        let values = signals.iter().map(|(_, signal)| optional(signal.values.get(k).copied()));
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
        let numbers = [
            of.peak.map(|peak| peak.value),
            of.peak.map(|peak| peak.time),
            of.beyond,
            of.steady,
            of.rise_time,
            of.settling_time,
            of.overshoot,
            of.root_mean_square,
        ];
        [of.name, of.unit].map(str::to_owned).into_iter().chain(numbers.map(optional)).collect()
    });
    Some(csv(&head, rows))
}

/// Gain and phase of the output that the view is of.
pub fn bode(scene: &Scene) -> Result<String, ExportError> {
    let report = frequency(scene, &FrequencyRequest::default())?;
    let gain =
        heading(&format!("gain of {} by {}", report.output.name, report.input.name), &report.gain_unit);
    let mut columns = vec![
        ("frequency [rad/s]".to_owned(), &report.frequency),
        (gain.clone(), &report.gain),
        ("phase [rad]".to_owned(), &report.phase),
    ];
    if let Some(closed) = &report.closed_loop {
        columns.push((format!("{gain} under the law"), &closed.gain));
        columns.push(("phase [rad] under the law".to_owned(), &closed.phase));
    }
    let rows = (0..report.frequency.len())
        .map(|k| columns.iter().map(|(_, values)| optional(values.get(k).copied())).collect());
    let head: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    Ok(csv(&head, rows))
}

/// A measure over the range of a slider.
pub fn chart(findings: &Findings, (parameter, measure): (&'static Parameter, Measure)) -> String {
    let chart = findings.chart(parameter, measure);
    let rows = chart.points.iter().map(|point| {
        let stability = point.stability.map_or("", |stability| stability.key());
        vec![point.value.to_string(), optional(point.reading), stability.to_owned()]
    });
    let head = [
        heading(parameter.key, parameter.dimension.si_symbol()),
        heading(&measure.key(), measure.dimension().si_symbol()),
    ];
    csv(&[&head[0], &head[1], "stability"], rows)
}

/// Every number of the aircraft: coefficients, knobs, derivatives, entries of A and B, now and in its file.
pub fn derivatives(findings: &Findings) -> String {
    let scenario = findings.scenario();
    let reference = Scenario::new(scenario.aircraft.clone());
    let row = |p: &'static Parameter| {
        vec![
            p.key.to_owned(),
            p.page.map_or("", |page| page.key()).to_owned(),
            p.plane.map_or("", |plane| plane.key()).to_owned(),
            p.name.to_owned(),
            p.get(scenario).to_string(),
            p.get(&reference).to_string(),
            p.dimension.si_symbol().to_owned(),
            p.meaning.to_owned(),
        ]
    };
    let of_aircraft = parameters().filter(|p| !p.is_of_disturbance() && p.applies(scenario));
    csv(
        &["key", "page", "plane", "name", "value", "value in its file", "unit", "meaning"],
        of_aircraft.map(row),
    )
}
