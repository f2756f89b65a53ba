//! Answers as CSV: a head with units, every digit, an empty cell where there is no number.

use eigenwing::export::{
    AircraftReport, FlightOutcome, FlightReport, FrequencyReport, MeasureReport, MeasureValue,
    ParameterReport, PlaneOutcome, Report, ResponseReport, SplitOutcome, SweepPlane, SweepReport,
};

use crate::tables::heading;

/// Text from a head and rows.
fn csv<const N: usize>(head: [&str; N], rows: impl Iterator<Item = [String; N]>) -> String {
    records(head.map(str::to_owned), rows)
}

/// The same with as many columns as the head has.
pub fn records<R: IntoIterator<Item = String>>(head: R, mut rows: impl Iterator<Item = R>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let written = writer.write_record(head).and_then(|()| rows.try_for_each(|row| writer.write_record(row)));
    // Nothing can go wrong on the way into memory; and if it did, the text would end there.
    debug_assert!(written.is_ok());
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, |x| x.to_string())
}

pub fn list(list: &[AircraftReport]) -> String {
    let head = ["key", "name", "condition", "planes", "status", "source"];
    let row = |a: &AircraftReport| {
        let planes = a.planes.join(" ");
        let status = a.status.to_owned();
        [a.key.clone(), a.name.clone(), a.condition.clone(), planes, status, a.source.clone()]
    };
    csv(head, list.iter().map(row))
}

pub fn parameters(parameters: &[ParameterReport]) -> String {
    let head = ["key", "name", "plane", "value", "unit", "slider from", "slider to", "meaning"];
    let row = |p: &ParameterReport| {
        [
            p.key.to_owned(),
            p.name.to_owned(),
            p.plane.unwrap_or_default().to_owned(),
            p.value.to_string(),
            p.unit.to_owned(),
            p.slider[0].to_string(),
            p.slider[1].to_string(),
            p.meaning.to_owned(),
        ]
    };
    csv(head, parameters.iter().map(row))
}

/// A row for each mode.
pub fn analysis(report: &Report) -> String {
    let head = [
        "plane",
        "mode",
        "stability",
        "re [1/s]",
        "im [rad/s]",
        "natural_frequency [rad/s]",
        "damping_ratio",
        "damped_frequency [rad/s]",
        "period [s]",
        "time_to_half [s]",
        "time_to_double [s]",
        "time_constant [s]",
    ];
    let planes = [("longitudinal", &report.longitudinal), ("lateral", &report.lateral)];
    let reports = planes.into_iter().filter_map(|(name, plane)| {
        plane.as_ref().and_then(PlaneOutcome::report).map(|report| (name, report))
    });
    let rows = reports.flat_map(|(plane, report)| {
        report.modes.iter().map(move |mode| {
            [
                plane.to_owned(),
                mode.key.to_owned(),
                mode.stability.to_owned(),
                mode.re.to_string(),
                mode.im.to_string(),
                optional(mode.natural_frequency),
                optional(mode.damping_ratio),
                optional(mode.damped_frequency),
                optional(mode.period),
                optional(mode.time_to_half),
                optional(mode.time_to_double),
                optional(mode.time_constant),
            ]
        })
    });
    csv(head, rows)
}

/// A row for each sample; in every row a cell for each quantity, empty where it has no sample there.
pub fn response(report: &ResponseReport) -> String {
    let flight = report.nonlinear.as_ref().and_then(FlightOutcome::flight);
    let time = match flight {
        Some(flight) if flight.time.len() > report.time.len() => &flight.time,
        _ => &report.time,
    };
    // Until the linear answer is no longer that of the aircraft.
    let is_small = |time: &f64| report.small_until.is_none_or(|end| *time < end);
    let small: Vec<f64> = report.time.iter().map(|time| f64::from(u8::from(is_small(time)))).collect();
    let mut columns: Vec<(String, &[f64])> = vec![(heading("time", "s"), time)];
    for signal in report.inputs.iter().chain(&report.outputs) {
        columns.push((heading(signal.name, signal.unit), &signal.values));
    }
    let closed = report.closed_loop.as_ref();
    for signal in closed.into_iter().flat_map(|closed| closed.controls.iter().chain(&closed.outputs)) {
        columns.push((heading(&format!("{} under the law", signal.name), signal.unit), &signal.values));
    }
    // Without a law the controls are the inputs.
    let controls = |flight: &'_ FlightReport| if closed.is_some() { flight.controls.len() } else { 0 };
    for signal in flight
        .into_iter()
        .flat_map(|flight| flight.outputs.iter().chain(flight.controls.iter().take(controls(flight))))
    {
        columns.push((heading(&format!("{} nonlinear", signal.name), signal.unit), &signal.values));
    }
    for split in report.split.iter().flatten().filter_map(SplitOutcome::split) {
        let parts = split.parts.iter().map(|part| (part.mode_key, &part.values));
        for (mode, values) in parts.chain([("no-mode", &split.rest)]) {
            columns.push((heading(&format!("{} of {mode}", split.name), split.unit), values));
        }
    }
    columns.push(("small".to_owned(), &small));
    let mut lines = Vec::with_capacity(time.len() + 1);
    lines.push(columns.iter().map(|(head, _)| head.as_str()).collect::<Vec<_>>().join(","));
    for k in 0..time.len() {
        let row = columns.iter().map(|(_, values)| optional(values.get(k).copied()));
        lines.push(row.collect::<Vec<_>>().join(","));
    }
    lines.join("\n") + "\n"
}

/// Notes that columns can't hold: what they mean from some time on, why some of those asked for aren't there, or end early.
pub fn response_notes(report: &ResponseReport) -> Vec<String> {
    let split = report.split.iter().flatten().filter_map(|outcome| match outcome {
        SplitOutcome::Refused { name, error } => Some(format!("{name} is not split: {error}")),
        SplitOutcome::Split(_) => None,
    });
    let flight = report.nonlinear.as_ref().and_then(|outcome| match outcome {
        FlightOutcome::Refused { error } => Some(format!("no nonlinear flight: {error}")),
        FlightOutcome::Flown(flight) => {
            flight.stop.as_ref().map(|stop| format!("the nonlinear flight ends: {}", stop.sentence))
        }
    });
    let limits = report.nonlinear.as_ref().and_then(FlightOutcome::flight).into_iter();
    let limits = limits.flat_map(|flight| flight.limit_sentences.iter().cloned());
    report.small_limit.clone().into_iter().chain(split).chain(limits).chain(flight).collect()
}

/// A row for each frequency.
pub fn frequency(report: &FrequencyReport) -> String {
    let gain = heading("gain", &report.gain_unit);
    let values = report.frequency.iter().zip(&report.gain).zip(&report.phase);
    let row = |((frequency, gain), phase): ((&f64, &f64), &f64)| [frequency, gain, phase].map(f64::to_string);
    csv(["frequency [rad/s]", gain.as_str(), "phase [rad]"], values.map(row))
}

pub fn measures(measures: &[MeasureReport]) -> String {
    let row = |m: &MeasureReport| {
        let value = m.value.map_or_else(String::new, measured);
        [m.key.clone(), m.name.clone(), m.unit.to_owned(), value, m.absent.clone().unwrap_or_default()]
    };
    csv(["key", "name", "unit", "value", "absent"], measures.iter().map(row))
}

/// A number with every digit, or the key of a verdict.
fn measured(value: MeasureValue) -> String {
    match value {
        MeasureValue::Number(x) => x.to_string(),
        MeasureValue::Verdict(key) => key.to_owned(),
    }
}

/// A row for each point, with a column for each measure.
pub fn measured_sweep(report: &SweepReport) -> String {
    let columns = report.measures.iter().map(|measure| heading(&measure.key, measure.unit));
    let head: Vec<String> = std::iter::once(heading(report.parameter, report.unit)).chain(columns).collect();
    let rows = report.points.iter().map(|point| {
        let values = point.measures.iter().map(|value| value.map_or_else(String::new, measured));
        std::iter::once(point.value.to_string()).chain(values).collect::<Vec<_>>()
    });
    records(head, rows)
}

/// A row for each point and mode: modes come and go along a sweep, so they are no columns. What stands between the plane and the
/// mode is of the plane.
pub fn sweep(report: &SweepReport) -> String {
    let value = heading(report.parameter, report.unit);
    let head = [
        value.as_str(),
        "plane",
        "static_stability",
        "dynamic_stability",
        "determinant [1/s^4]",
        "mode",
        "stability",
        "re [1/s]",
        "im [rad/s]",
        "natural_frequency [rad/s]",
        "damping_ratio",
        "error",
    ];
    let rows = report.points.iter().flat_map(|point| {
        let at = point.value.to_string();
        let error = point.error.iter().map({
            let at = at.clone();
            move |error| {
                let mut row: [String; 12] = Default::default();
                (row[0], row[11]) = (at.clone(), error.clone());
                row
            }
        });
        let planes = [("longitudinal", &point.longitudinal), ("lateral", &point.lateral)];
        let modes = planes.into_iter().flat_map(move |(name, plane)| {
            let at = at.clone();
            plane.iter().flat_map(move |plane| rows_of(&at, name, plane))
        });
        modes.chain(error)
    });
    csv(head, rows)
}

fn rows_of(at: &str, name: &str, plane: &SweepPlane) -> Vec<[String; 12]> {
    let row = |mode: &eigenwing::export::SweepMode| {
        [
            at.to_owned(),
            name.to_owned(),
            plane.static_stability.to_owned(),
            plane.dynamic_stability.to_owned(),
            plane.determinant.to_string(),
            mode.key.to_owned(),
            mode.stability.to_owned(),
            mode.re.to_string(),
            mode.im.to_string(),
            optional(mode.natural_frequency),
            optional(mode.damping_ratio),
            String::new(),
        ]
    };
    plane.modes.iter().map(row).collect()
}
