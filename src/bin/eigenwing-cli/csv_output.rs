//! Answers as CSV: a head with units, every digit, an empty cell where there is no number.

use eigenwing::export::{
    AircraftReport, ParameterReport, PlaneOutcome, Report, ResponseReport, SweepPlane, SweepReport,
};

/// Text from a head and rows.
fn csv<const N: usize>(head: [&str; N], mut rows: impl Iterator<Item = [String; N]>) -> String {
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

/// One row a mode.
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
                mode.name.to_owned(),
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

/// One row a sample.
pub fn response(report: &ResponseReport) -> String {
    let signals: Vec<_> = report.inputs.iter().chain(&report.outputs).collect();
    let heading = |name: &str, unit: &str| {
        if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
    };
    let mut lines = Vec::with_capacity(report.time.len() + 1);
    let mut head = vec![heading("time", "s")];
    head.extend(signals.iter().map(|signal| heading(signal.name, signal.unit)));
    lines.push(head.join(","));
    for (k, time) in report.time.iter().enumerate() {
        let values = signals.iter().map(|signal| signal.values.get(k).copied());
        let row: Vec<String> = std::iter::once(Some(*time)).chain(values).map(optional).collect();
        lines.push(row.join(","));
    }
    lines.join("\n") + "\n"
}

/// One row a point and mode: modes come and go along a sweep, so they are no columns.
pub fn sweep(report: &SweepReport) -> String {
    let value = if report.unit.is_empty() {
        report.parameter.to_owned()
    } else {
        format!("{} [{}]", report.parameter, report.unit)
    };
    let head = [
        value.as_str(),
        "plane",
        "mode",
        "re [1/s]",
        "im [rad/s]",
        "natural_frequency [rad/s]",
        "damping_ratio",
        "static_stability",
        "dynamic_stability",
        "determinant [1/s^4]",
        "error",
    ];
    let rows = report.points.iter().flat_map(|point| {
        let at = point.value.to_string();
        let error = point.error.iter().map({
            let at = at.clone();
            move |error| {
                let mut row: [String; 11] = Default::default();
                (row[0], row[10]) = (at.clone(), error.clone());
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

fn rows_of(at: &str, name: &str, plane: &SweepPlane) -> Vec<[String; 11]> {
    let row = |mode: &eigenwing::export::SweepMode| {
        [
            at.to_owned(),
            name.to_owned(),
            mode.name.to_owned(),
            mode.re.to_string(),
            mode.im.to_string(),
            optional(mode.natural_frequency),
            optional(mode.damping_ratio),
            plane.static_stability.to_owned(),
            plane.dynamic_stability.to_owned(),
            plane.determinant.to_string(),
            String::new(),
        ]
    };
    plane.modes.iter().map(row).collect()
}
