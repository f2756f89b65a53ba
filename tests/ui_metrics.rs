//! The numbers of a motion are the same on the page and in the answers to other programs, for every aircraft.

mod page;

use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::{FILES, LengthUnit};
use eigenwing::export::{MetricsReport, PeakReport, ResponseRequest, Subject, respond};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::number::significant;
use eigenwing::scenario::{Dimension, Quantity};
use page::{Page, WIDE, app, open, page};

/// A disturbance as a link has it, and as a request has it.
const DISTURBANCES: [(&str, &str, Option<&str>); 8] = [
    ("lon.source=elevator&lon.shape=step", "elevator", Some("step")),
    ("lon.source=elevator&lon.shape=doublet", "elevator", Some("doublet")),
    ("lon.source=gust&lon.gust=1-cos", "vertical-gust", Some("1-cosine")),
    ("lon.source=turbulence", "turbulence", None),
    ("lat.source=aileron&lat.shape=step", "aileron", Some("step")),
    ("lat.source=rudder&lat.shape=pulse", "rudder", Some("pulse")),
    ("lat.source=turbulence", "turbulence", None),
    ("lat.source=release", "release", None),
];

/// What stands on the page, in the order of reading.
fn texts(page: &Page) -> Vec<String> {
    let text = |node: egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value()).unwrap_or_default()
    };
    page.query_all_by_role(Role::Label).map(text).collect()
}

/// The rows of the table as the report has them: name, unit, peak, when, and what comes after.
fn rows(metrics: &MetricsReport, outputs: &[Output], length: LengthUnit) -> Vec<Vec<String>> {
    let none = || "–".to_owned();
    let seconds = |time: Option<f64>| time.map_or_else(none, |t| format!("{} s", significant(t, 3)));
    let row = |(of, output): (&eigenwing::export::OutputMetricsReport, &Output)| {
        let Quantity { key, name, dimension, .. } = Quantity::of(*output);
        assert_eq!(of.name, key);
        let unit = dimension.in_si(length);
        let number = |si: Option<f64>| si.map_or_else(none, |si| significant(si / unit, 3));
        let (peak, at) = match (of.peak, of.beyond) {
            (Some(PeakReport { value, time }), None) => (number(Some(value)), seconds(Some(time))),
            (None, Some(value)) => (format!("beyond {}", number(Some(value))), String::new()),
            other => panic!("{key}: {other:?}"),
        };
        let mut row = vec![name.to_owned(), dimension.symbol(length).to_owned(), peak, at];
        if of.root_mean_square.is_some() {
            row.push(number(of.root_mean_square));
        } else {
            let overshoot = of.overshoot.map_or_else(none, |x| format!("{} %", significant(100.0 * x, 3)));
            row.extend([number(of.steady), seconds(of.rise_time), seconds(of.settling_time), overshoot]);
        }
        row
    };
    metrics.outputs.iter().zip(outputs).map(row).collect()
}

/// Compares the page with the answer to the same question; whether the aircraft has an answer.
fn compare(
    page: &mut Page,
    aircraft: &str,
    set: Option<(&str, f64)>,
    of: (&str, &str, Option<&str>),
) -> bool {
    let (in_link, disturbance, shape) = of;
    let plane = if in_link.starts_with("lon") { Plane::Longitudinal } else { Plane::Lateral };
    let name = if plane == Plane::Longitudinal { "longitudinal" } else { "lateral" };
    let subject = Subject {
        set: set.into_iter().map(|(key, value)| (key.to_owned(), value)).collect(),
        ..Subject::listed(aircraft)
    };
    let request = ResponseRequest {
        plane: Some(name.to_owned()),
        disturbance: Some(disturbance.to_owned()),
        shape: shape.map(str::to_owned),
        ..ResponseRequest::default()
    };
    let scene = subject.scene().expect("an aircraft of the list");
    let Ok(report) = respond(&scene, &request) else { return false };
    let set = set.map_or_else(String::new, |(key, value)| format!("&{key}={value}"));
    let link = format!("v=1&ac={aircraft}{set}&plane={}&{in_link}&time=60&tab=figures", &name[..3]);
    open(page, &link);
    assert_eq!(app(page).scenario().plane, plane);
    let length = app(page).scenario().aircraft.length_unit;
    let shown = texts(page);
    for row in rows(&report.metrics, Output::of(plane), length) {
        let at =
            shown.iter().position(|text| *text == row[0]).unwrap_or_else(|| panic!("{link}: no {}", row[0]));
        assert_eq!(&shown[at..at + row.len()], &row[..], "{link}");
    }
    let of_page = |metres: f64| metres / Dimension::Length.in_si(length);
    let MetricsReport { phugoid_swing, time_to_bank, control_anticipation, .. } = report.metrics;
    for (value, words) in [
        (phugoid_swing.map(of_page), "Height from the phugoid’s first turning point to its second: "),
        (time_to_bank, "30° of bank after "),
        (
            control_anticipation,
            "Control anticipation parameter CAP of this motion, the first pitch acceleration over the load factor at which the \
             short period settles: ",
        ),
    ] {
        let line = shown.iter().find_map(|text| text.strip_prefix(words));
        let number = line.and_then(|line| line.split(' ').next()).map(str::to_owned);
        assert_eq!(number, value.map(|value| significant(value, 3)), "{link}: {words}");
    }
    true
}

#[test]
fn page_and_answers_have_the_same_numbers_for_every_aircraft() {
    let mut page = page(WIDE);
    let mut compared = 0;
    for (file, _) in FILES {
        let aircraft = file.strip_suffix(".toml").expect("a file of an aircraft");
        for of in DISTURBANCES {
            compared += usize::from(compare(&mut page, aircraft, None, of));
        }
    }
    assert!(compared >= 100, "{compared}");
}

/// The Navion with little pitch stiffness leaves the linear model while its speed still grows.
#[test]
fn where_the_linear_model_ends_both_say_so() {
    let mut page = page(WIDE);
    assert!(compare(&mut page, "navion", Some(("cm_alpha", -0.25)), DISTURBANCES[0]));
    let shown = texts(&page);
    assert!(shown.iter().any(|text| text == "beyond 26.8"), "{shown:?}");
}
