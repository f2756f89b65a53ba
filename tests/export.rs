//! What other programs ask and read: that the answers are the analysis itself, and that nothing in them is no number.

use std::collections::BTreeMap;

use eigenwing::content::{FILES, MatrixFormat};
use eigenwing::export::{
    self, ExportError, PlaneOutcome, PlaneReport, Report, ResponseReport, ResponseRequest, Scene, Subject,
    Sweep, SweepRequest, json, list, parameters_of,
};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::key::Keyed;
use eigenwing::scenario::Source;
use serde_json::{Value, json};

fn keys() -> impl Iterator<Item = &'static str> {
    FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"))
}

fn analyse(subject: &Subject) -> Result<Report, ExportError> {
    export::analyse(&subject.scene()?)
}

fn respond(subject: &Subject, request: &ResponseRequest) -> Result<ResponseReport, ExportError> {
    export::respond(&subject.scene()?, request)
}

fn navion() -> Scene {
    Subject::listed("navion").scene().expect("the Navion")
}

fn plane(outcome: &Option<PlaneOutcome>) -> Option<&PlaneReport> {
    outcome.as_ref().and_then(PlaneOutcome::report)
}

/// A file of bare matrices that says what a report says.
fn as_matrices(report: &PlaneReport) -> String {
    json!({
        "units": "SI",
        "speed": report.trim.speed,
        "alpha0_deg": report.trim.alpha0.to_degrees(),
        "gamma0_deg": report.trim.gamma0.to_degrees(),
        "states": report.states,
        "inputs": report.inputs,
        "A": report.a,
        "B": report.b,
    })
    .to_string()
}

#[test]
fn the_matrices_of_a_report_read_back_give_the_same_modes() {
    for key in keys() {
        let report = analyse(&Subject::listed(key)).expect("an aircraft of the list");
        for original in [plane(&report.longitudinal), plane(&report.lateral)].into_iter().flatten() {
            let source = export::Source::Matrices {
                file: key.into(),
                text: as_matrices(original),
                format: MatrixFormat::Json,
            };
            let again = analyse(&Subject { source, ..Subject::listed(key) }).expect("bare matrices");
            let again = plane(&again.longitudinal).or(plane(&again.lateral)).expect("one plane");
            assert_eq!((again.a, again.b), (original.a, original.b), "{key}");
            assert_eq!(again.modes, original.modes, "{key}");
        }
    }
}

#[test]
fn the_eigenvalues_of_a_report_are_four_and_add_up_to_the_trace() {
    for key in keys() {
        let report = analyse(&Subject::listed(key)).expect("an aircraft of the list");
        for report in [plane(&report.longitudinal), plane(&report.lateral)].into_iter().flatten() {
            assert_eq!(report.eigenvalues.len(), 4);
            let [re, im] = [0, 1].map(|part| report.eigenvalues.iter().map(|l| l[part]).sum::<f64>());
            let trace: f64 = (0..4).map(|k| report.a[k][k]).sum();
            assert!((re - trace).abs() < 1e-12 * trace.abs() && im == 0.0, "{key}: {re} and {trace}");
        }
    }
}

/// A number that is none is written as null.
fn assert_no_null(value: &Value, path: &str) {
    match value {
        Value::Null => panic!("{path} is null"),
        Value::Array(list) => list.iter().for_each(|entry| assert_no_null(entry, path)),
        Value::Object(fields) => fields.iter().for_each(|(key, field)| {
            assert_no_null(field, &format!("{path}.{key}"));
        }),
        _ => {}
    }
}

/// A gain without which nothing follows a command.
const fn listening_gain(source: Source) -> Option<&'static str> {
    match source {
        Source::PitchCommand => Some("k.theta_de"),
        Source::SpeedCommand => Some("k.u_dt"),
        Source::HeightCommand => Some("k.h_de"),
        Source::BankCommand => Some("k.phi_da"),
        Source::YawRateCommand => Some("k.r_dr"),
        Source::HeadingCommand => Some("k.psi_da"),
        _ => None,
    }
}

#[test]
fn every_disturbance_of_every_aircraft_in_every_shape_gives_numbers() {
    for aircraft in list() {
        for &source in Source::VALUES {
            let name = source.key();
            let shapes: Vec<_> = source.shapes().iter().map(|shape| Some(shape.key())).collect();
            for shape in if shapes.is_empty() { vec![None] } else { shapes } {
                let request = ResponseRequest {
                    disturbance: Some(name.to_owned()),
                    shape: shape.map(str::to_owned),
                    steps: Some(20),
                    ..ResponseRequest::default()
                };
                // Short: an unoptimised build takes its time.
                let mut set = vec![("time".to_owned(), 4.0)];
                set.extend(listening_gain(source).map(|gain| (gain.to_owned(), 1e-3)));
                let response = respond(&Subject { set, ..Subject::listed(&aircraft.key) }, &request);
                let can_be = Plane::ALL.iter().any(|plane| {
                    let has_data = aircraft.planes.contains(&plane.key());
                    has_data && Source::of(*plane).contains(&source)
                });
                assert_eq!(response.is_ok(), can_be, "{} {name} {response:?}", aircraft.key);
                let Ok(response) = response else { continue };
                assert_eq!((response.disturbance, response.shape), (name, shape));
                assert!(response.outputs.iter().all(|signal| signal.values.len() == response.time.len()));
                let values = serde_json::to_value((&response.inputs, &response.outputs));
                assert_no_null(&values.expect("JSON"), &format!("{} {name}", aircraft.key));
            }
        }
    }
}

#[test]
fn one_mode_alone_is_chosen_by_its_key_or_its_name() {
    let request = |mode: &str| ResponseRequest {
        disturbance: Some("mode".to_owned()),
        mode: Some(mode.to_owned()),
        ..ResponseRequest::default()
    };
    let navion = Subject::listed("navion");
    let response = respond(&navion, &request("short-period")).expect("a mode of the Navion");
    assert_eq!((response.mode_key, response.mode), (Some("short-period"), Some("Short period")));
    assert_eq!(response.inputs.len(), 0);
    for name in ["Short period", "short period"] {
        assert_eq!(respond(&navion, &request(name)).expect("the same mode").outputs, response.outputs);
    }
    let told = respond(&navion, &request("Dutch roll")).map_err(|error| error.to_string());
    let sentence = "there is no mode \"Dutch roll\" here; expected \"short-period\", \"phugoid\"";
    assert_eq!(told, Err(sentence.to_owned()));
    let lateral = ResponseRequest { plane: Some("lateral".to_owned()), ..request("Dutch roll") };
    assert_eq!(respond(&navion, &lateral).map(|response| response.plane), Ok("lateral"));
}

/// Links had other words for the same disturbances before there were keys.
#[test]
fn the_words_of_links_are_read_in_requests_too() {
    for (plane, disturbance, shape, keys) in [
        ("lon", "gust", "1-cos", ("longitudinal", "vertical-gust", Some("1-cosine"))),
        ("lon", "head_gust", "step", ("longitudinal", "head-gust", Some("step"))),
        ("lat", "rudder", "3211", ("lateral", "rudder", Some("3-2-1-1"))),
    ] {
        let [plane, disturbance, shape] = [plane, disturbance, shape].map(|word| Some(word.to_owned()));
        let request = ResponseRequest { plane, disturbance, shape, ..ResponseRequest::default() };
        let response = respond(&Subject::listed("navion"), &request).expect("a motion");
        assert_eq!((response.plane, response.disturbance, response.shape), keys);
    }
}

/// A key for programs beside every name for people.
#[test]
fn what_has_a_name_has_a_key_beside_it() {
    let report = analyse(&Subject::listed("navion")).expect("it flies");
    let lateral = report.lateral.as_ref().and_then(PlaneOutcome::report).expect("its plane");
    let modes: Vec<(&str, &str)> = lateral.modes.iter().map(|mode| (mode.key, mode.name)).collect();
    let expected =
        [("dutch-roll", "Dutch roll"), ("roll-subsidence", "Roll subsidence"), ("spiral", "Spiral")];
    assert_eq!(modes, expected);
    let level = &lateral.levels[0];
    assert_eq!((level.criterion_key, level.criterion), ("dutch-roll", "Dutch roll"));
    assert_eq!((level.level_key, level.level), (Some("level-1"), Some("Level 1")));
    let approximation = &lateral.approximations[0];
    assert_eq!((approximation.key, approximation.mode_key), ("dutch-roll-two-states", "dutch-roll"));
    let sweep = Sweep::new(
        navion(),
        &SweepRequest {
            parameter: "cm_alpha".to_owned(),
            from: -0.8,
            to: -0.4,
            points: 2,
            measures: Vec::new(),
        },
    );
    let points = sweep.expect("a sweep").report().points;
    let first = points[0].longitudinal.as_ref().expect("its plane").modes[0];
    assert_eq!((first.key, first.name), ("short-period", "Short period"));
}

#[test]
fn every_parameter_can_be_set_to_the_value_it_is_told_to_have() {
    for key in ["navion", "nt33a", "lesson"] {
        let subject = Subject::listed(key);
        let told = parameters_of(&subject.scenario().expect("an aircraft of the list"));
        assert!(told.len() > 10);
        let set = told.iter().map(|p| (p.key.to_owned(), p.value)).collect();
        let (report, again) = (analyse(&subject), analyse(&Subject { set, ..subject }));
        let (report, again) = (report.expect("as it is"), again.expect("as it is told"));
        assert_eq!(again.longitudinal, report.longitudinal, "{key}");
        assert_eq!(again.lateral, report.lateral, "{key}");
    }
}

#[test]
fn each_parameter_set_together_with_what_follows_from_it_ends_at_its_value() {
    // Speed moves M_w, whichever of the two is named first.
    let set: BTreeMap<&str, f64> = BTreeMap::from([("m_w", -0.1), ("speed", 60.0), ("a_qq", -3.0)]);
    for order in [["m_w", "speed", "a_qq"], ["a_qq", "speed", "m_w"]] {
        let set = order.iter().map(|key| ((*key).to_owned(), set[key])).collect();
        let subject = Subject { set, ..Subject::listed("navion") };
        let told = parameters_of(&subject.scenario().expect("a flight"));
        let told: BTreeMap<&str, f64> = told.iter().map(|p| (p.key, p.value)).collect();
        for (key, wanted) in [("m_w", -0.1), ("speed", 60.0), ("a_qq", -3.0)] {
            assert!((told[key] - wanted).abs() < 1e-12, "{key} is {}", told[key]);
        }
    }
}

#[test]
fn a_sweep_finds_the_static_boundary_where_the_determinant_is_zero() {
    let request =
        SweepRequest { parameter: "a_qw".to_owned(), from: -0.2, to: 0.13, points: 12, measures: Vec::new() };
    let sweep = Sweep::new(navion(), &request).expect("a sweep");
    let change = &sweep.report().changes[0];
    assert_eq!((change.plane, change.stability), ("longitudinal", "static"));
    assert_eq!((change.from, change.to), ("stable", "unstable"));
    // det A = g (Z_u A_qw − Z_w A_qu) in level flight, stability axes
    let report = analyse(&Subject::listed("navion")).expect("the Navion");
    let a = plane(&report.longitudinal).expect("its plane").a;
    let boundary = a[1][1] * a[2][0] / a[1][0];
    assert!(change.between[0] < boundary && boundary < change.between[1]);
    assert!((change.at - boundary).abs() < 1e-9, "{} and {boundary}", change.at);
}

#[test]
fn a_sweep_has_both_its_ends_and_leaves_out_the_plane_that_does_not_move() {
    let request =
        SweepRequest { parameter: "cn_r".to_owned(), from: -0.4, to: -0.1, points: 4, measures: Vec::new() };
    let report = Sweep::new(navion(), &request).expect("a sweep").report();
    let values: Vec<f64> = report.points.iter().map(|point| point.value).collect();
    assert_eq!((values[0], values[3], values.len()), (-0.4, -0.1, 4));
    assert!(report.points.iter().all(|point| point.longitudinal.is_none() && point.lateral.is_some()));
}

#[test]
fn a_request_in_json_gives_what_the_functions_give() {
    let answer: Value = serde_json::from_str(
        &json::analyse(r#"{"aircraft": "navion", "set": {"cg": 0.1}}"#).expect("an answer"),
    )
    .expect("JSON");
    let subject = Subject { set: vec![("cg".to_owned(), 0.1)], ..Subject::listed("navion") };
    // Not assert_eq: nobody reads two of these.
    assert!(answer == serde_json::to_value(analyse(&subject).expect("a report")).expect("JSON"));
    let toml = json!({ "toml": FILES[0].1, "steps": 4 }).to_string();
    let listed = r#"{"aircraft": "navion", "steps": 4}"#;
    assert_eq!(json::respond(&toml), json::respond(listed));
    let sweep = r#"{"aircraft": "navion", "parameter": "cg", "from": 0, "to": 0.2, "points": 2}"#;
    assert!(json::sweep(sweep).expect("a sweep").contains("\"changes\":["));
    assert!(json::list().expect("a list").starts_with("[{\"key\":\"navion\""));
}

#[test]
fn a_request_that_makes_no_sense_is_told_so_in_a_sentence() {
    for (request, sentence) in [
        ("", "the request can't be read: EOF while parsing a value at line 1 column 0"),
        ("{}", "the request names no aircraft; expected aircraft, link, toml or matrices"),
        (r#"{"aircraft": 7}"#, "the request can't be read: invalid type: integer `7`, expected a string"),
        (
            r#"{"aircraft": "navion", "sett": {}}"#,
            "the request can't be read: unknown field `sett`, there are no fields",
        ),
        (
            r#"{"aircraft": "navion", "toml": ""}"#,
            "expected one of aircraft, link, toml and matrices, toml also beside a link, and format beside matrices only",
        ),
        (r#"{"matrices": ""}"#, "format: missing; expected \"json\", \"csv\" or \"m\" beside matrices"),
        (
            r#"{"matrices": "", "format": "xls"}"#,
            "format: expected \"json\", \"csv\" or \"m\", found \"xls\"",
        ),
        (
            r#"{"aircraft": "navion", "set": {"cg": null}}"#,
            "the request can't be read: invalid type: null, expected f64",
        ),
    ] {
        assert_eq!(json::analyse(request).map_err(|error| error.to_string()), Err(sentence.to_owned()));
    }
}
