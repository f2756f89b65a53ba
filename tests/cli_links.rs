//! Links on the command line and in requests: each is the scene that it opens on the page, in its own words and units, and what
//! else is asked for counts above it.

use std::process::{Command, Output};
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::export::json;
use eigenwing::scenario::{Parameter, link};
use serde_json::Value;

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_eigenwing-cli"))
        .args(arguments)
        .output()
        .expect("the command line starts")
}

/// What an answer says, and what is said beside it.
fn said(arguments: &[&str]) -> (String, String) {
    let Output { status, stdout, stderr } = run(arguments);
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).expect("a text"));
    assert!(status.success(), "{arguments:?}: {stderr}");
    (stdout, stderr)
}

/// What an answer says, with nothing beside it.
fn answer(arguments: &[&str]) -> String {
    let (answer, beside) = said(arguments);
    assert_eq!(beside, "", "{arguments:?}");
    answer
}

fn object(arguments: &[&str]) -> Value {
    serde_json::from_str(&answer(arguments)).expect("it is JSON")
}

fn fails(arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = run(arguments);
    assert_eq!((status.code(), stdout), (Some(1), Vec::new()), "{arguments:?}");
    String::from_utf8(stderr).expect("a text")
}

/// The scene that a link opens on the page.
fn open(text: &str) -> link::Opened {
    let aircraft: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    link::read(text, &aircraft).expect("there are aircraft")
}

#[test]
fn a_link_is_read_wherever_an_aircraft_is_in_its_own_units() {
    let link = "#v=1&ac=navion&cg=16&speed=60&cm_alpha=-0.5";
    let set = ["--set", "cg=0.16", "--set", "speed=60", "--set", "cm_alpha=-0.5"];
    for command in [
        &["analyse"][..],
        &["parameters"],
        &["measures"],
        &["why"],
        &["respond", "--steps", "5"],
        &["frequency", "--points", "5"],
        &["sweep", "--parameter", "mass", "--from", "0.9", "--to", "1.1", "--points", "3"],
        &["link"],
    ] {
        let json: &[&str] = &["--json"];
        let expected = answer(&[command, json, &["navion"], &set].concat());
        for asked in [
            &["--link", link][..],
            &[link],
            &[&link[1..]],
            &["--link", "https://example.org/flight/#v=1&ac=navion&cg=16&speed=60&cm_alpha=-0.5"],
            &[
                "--link",
                "#v=1&ac=navion",
                "--set",
                "cg=16%",
                "--set",
                "speed=60 m/s",
                "--set",
                "cm_alpha=−0.5",
            ],
        ] {
            assert_eq!(answer(&[command, json, asked].concat()), expected, "{command:?} {asked:?}");
        }
    }
}

#[test]
fn what_is_asked_beside_a_link_counts_above_it() {
    let link =
        "#v=1&ac=navion&cg=16&elevator=3&lon.shape=doublet&time=20&class=iii&flight=nonlinear&split=modes";
    let told =
        |more: &[&str]| object(&[&["respond", "--link", link, "--steps", "4", "--json"], more].concat());
    let plain = told(&[]);
    assert_eq!((&plain["disturbance"], &plain["shape"]), (&"elevator".into(), &"doublet".into()));
    assert_eq!(plain["time"][4], 20.0);
    let deflected = plain["inputs"][0]["values"].as_array().expect("values").iter().filter_map(Value::as_f64);
    assert!(deflected.clone().all(|x| x == 0.0), "the doublet falls between these samples");
    assert!(plain["nonlinear"]["outputs"].is_array() && plain["split"].is_array());
    let other = told(&[
        "--shape",
        "step",
        "--set",
        "elevator=2deg",
        "--set",
        "time=10",
        "--set",
        "cg=0",
        "--nonlinear=false",
        "--split=false",
    ]);
    assert_eq!((&other["shape"], &other["time"][4]), (&"step".into(), &10.0.into()));
    assert_eq!(other["inputs"][0]["values"][2], 2_f64.to_radians());
    assert!(other["nonlinear"].is_null() && other["split"].is_null() && other["set"]["cg"].is_null());
    // The size of another disturbance is no mistake of a link, but one of a person.
    assert_eq!(told(&["--disturbance", "gust"])["shape"], "1-cosine");
    let refused = fails(&["respond", "--link", link, "--set", "gust=4"]);
    assert!(
        refused.starts_with("error: gust (speed of the rising air) is no size of the disturbance"),
        "{refused}"
    );
    assert_eq!(object(&["analyse", "--link", link, "--json"])["aircraft"]["class"], "I");
    let levels = |more: &[&str]| answer(&[&["analyse", "--link", link], more].concat());
    assert_ne!(levels(&[]), levels(&["--class", "I"]));
}

#[test]
fn a_link_chooses_plane_output_and_mode_until_something_else_is_asked_for() {
    let link = "#v=1&ac=navion&plane=lateral&lat.source=mode&lat.mode=dutch-roll&lat.frequency_of=phi";
    let motion = object(&["respond", link, "--steps", "2", "--json"]);
    assert_eq!((&motion["plane"], &motion["mode_key"]), (&"lateral".into(), &"dutch-roll".into()));
    assert_eq!(object(&["respond", link, "--mode", "3", "--steps", "2", "--json"])["mode_key"], "spiral");
    let response = object(&["frequency", link, "--points", "2", "--json"]);
    assert_eq!((&response["output"]["name"], &response["input"]["name"]), (&"phi".into(), &"aileron".into()));
    let turbulent = "#v=1&ac=navion&lon.source=turbulence";
    assert_eq!(object(&["frequency", turbulent, "--points", "2", "--json"])["disturbance"], "vertical-gust");
    let asked = ["frequency", link, "--disturbance", "rudder", "--output", "r", "--points", "2", "--json"];
    assert_eq!(object(&asked)["output"]["name"], "r");
}

#[test]
fn what_of_a_link_cannot_be_used_is_a_note_and_stands_in_the_answer() {
    let link = "#v=1&ac=navion&cg=900&wings=3&lon.source=gale";
    let expected = [
        "The shift of the centre of gravity (cg) was left out",
        "“lon.source=gale” was left out",
        "“wings” means nothing to this version",
    ];
    for command in [
        &["analyse", "--json"][..],
        &["why", "--json"],
        &["respond", "--steps=2", "--json"],
        &["frequency", "--points=2", "--json"],
        &["sweep", "--parameter=mass", "--from=0.9", "--to=1.1", "--points=2", "--json"],
        &["link", "--json"],
    ] {
        let (answer, beside) = said(&[command, &[link]].concat());
        let answer: Value = serde_json::from_str(&answer).expect("it is JSON");
        let notices: Vec<&str> =
            answer["notices"].as_array().expect("notices").iter().filter_map(Value::as_str).collect();
        assert_eq!(notices.len(), 3, "{notices:?}");
        for (notice, expected) in notices.iter().zip(expected) {
            assert!(notice.starts_with(expected), "{notice}");
            assert!(beside.contains(&format!("note: {notice}\n")), "{beside}");
        }
        assert_eq!(beside.lines().count(), 3, "{beside}");
    }
    // Tables, CSV and lists have no room for them.
    for command in [&["parameters", "--json"][..], &["measures"], &["analyse", "--csv"]] {
        assert_eq!(said(&[command, &[link]].concat()).1.lines().count(), 3);
    }
}

/// An answer about another aircraft would be a wrong answer.
#[test]
fn a_link_to_no_aircraft_and_text_that_is_no_link_are_errors() {
    assert_eq!(
        fails(&["analyse", "#v=1&ac=navoin"]),
        "error: there is no aircraft \"navoin\" in the list; did you mean \"navion\"?\n"
    );
    for text in ["", "navion", "https://example.org/", "#", "speed=60"] {
        let told = fails(&["analyse", "--link", text]);
        let expected = "error: expected a link such as \"#v=1&ac=navion&speed=60\", found ";
        assert_eq!(told, format!("{expected}\"{text}\"\n"));
    }
    let both = run(&["analyse", "navion", "--link", "#v=1"]);
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn the_pinned_state_of_a_link_is_what_why_compares_with() {
    let told = object(&["why", "#v=1&ac=navion&cm_q=-20&pin.ac=navion&pin.cm_q=-15", "--json"]);
    let edit = &told["planes"][0]["edits"][0];
    assert_eq!(
        (&edit["key"], &edit["from"], &edit["to"]),
        (&"cm_q".into(), &(-15.0).into(), &(-20.0).into())
    );
    assert_eq!((&told["since"], told["notices"].as_array().map(Vec::len)), (&"pinned".into(), Some(0)));
    // With another aircraft nothing is compared.
    let (told, _) = said(&["why", "#v=1&ac=navion&cm_q=-20&pin.ac=x15", "--json"]);
    let told: Value = serde_json::from_str(&told).expect("it is JSON");
    assert_eq!((&told["since"], &told["planes"][0]["edits"][0]["from"]), (&"file".into(), &(-9.96).into()));
    assert_eq!(
        told["notices"][0],
        "The pinned state is another aircraft: this one is compared with its own source instead."
    );
}

#[test]
fn a_link_is_written_from_what_a_person_types_and_opens_as_it_says() {
    let typed = [
        "link",
        "navion",
        "--set",
        "cg=16%",
        "--set",
        "elevator=2deg",
        "--set",
        "time=90",
        "--shape",
        "3211",
    ];
    assert_eq!(answer(&typed), "#v=1&ac=navion&cg=16&lon.shape=3-2-1-1&elevator=2&time=90\n");
    let lateral =
        ["link", "b747-approach", "--disturbance", "side_gust", "--nonlinear", "--set", "side_gust=5"];
    let link = "#v=1&ac=b747-approach&plane=lateral&lat.source=side-gust&side_gust=5&flight=nonlinear";
    assert_eq!(answer(&lateral), format!("{link}\n"));
    let with_address = [&lateral[..], &["--address", "https://example.org/flight/#old"]].concat();
    assert_eq!(answer(&with_address), format!("https://example.org/flight/{link}\n"));
    let opened = open(link);
    assert_eq!(opened.notices, []);
    assert_eq!(Parameter::find("side_gust").expect("a row").get(&opened.scenario), 5.0);

    // A link is taken up with all that stands in it, lesson and stage too.
    let lesson = "#v=1&ac=navion&cm_q=-20&stage=poles.modes&hide=names&pin.ac=navion&lesson=hangar&step=3";
    assert_eq!(answer(&["link", lesson]), format!("{lesson}\n"));
    assert_eq!(open(answer(&["link", lesson, "--set", "cm_q=-9.96"]).trim()).pinned, open(lesson).pinned);

    // An aircraft of a file travels in the link.
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/matrices/lesson.json");
    let own = answer(&["link", file]);
    assert!(own.starts_with("#v=1&own=") && own.trim().ends_with("&ac=file"), "{own}");
    assert_eq!(answer(&["analyse", own.trim(), "--csv"]), answer(&["analyse", file, "--csv"]));
    assert_eq!(fails(&["link", "lesson", "--plane", "lat"]), "error: lesson has no lateral data\n");
}

/// The JavaScript module is these functions.
#[test]
fn requests_in_json_take_a_link_as_the_command_line_does() {
    let link = "#v=1&ac=navion&plane=lat&speed=60&oops=1";
    let request = format!(r#"{{"link": "{link}", "set": {{"mass": 1.1}}"#);
    let from_request = |text: Result<String, _>| -> Value {
        let text = text.unwrap_or_else(|error: eigenwing::export::ExportError| panic!("{error}"));
        serde_json::from_str(&text).expect("JSON")
    };
    let typed = |arguments: &[&str]| -> Value {
        let (text, _) = said(&[arguments, &["--link", link, "--set", "mass=1.1", "--json"]].concat());
        serde_json::from_str(&text).expect("JSON")
    };
    assert_eq!(from_request(json::analyse(&format!("{request}}}"))), typed(&["analyse"]));
    assert_eq!(
        from_request(json::respond(&format!("{request}, \"steps\": 3}}"))),
        typed(&["respond", "--steps=3"])
    );
    assert_eq!(
        from_request(json::link(&format!("{request}, \"disturbance\": \"gust\"}}"))),
        typed(&["link", "--disturbance=gust"])
    );
    assert_eq!(
        from_request(json::link(&format!("{request}}}")))["notices"][0],
        "“oops” means nothing to this version and was left out."
    );
    let both =
        json::analyse(r##"{"link": "#v=1", "aircraft": "navion"}"##).map_err(|error| error.to_string());
    assert!(both.is_err_and(|told| told.starts_with("expected one of aircraft, link, toml and matrices")));
}

#[test]
fn a_value_may_have_its_unit_behind_it() {
    let value = |setting: &str| {
        let (key, _) = setting.split_once('=').expect("KEY=VALUE");
        let told = object(&["parameters", "navion", "--set", setting, "--json"]);
        let row =
            told.as_array().expect("rows").iter().find(|row| row["key"] == key).expect("the row").clone();
        row["value"].as_f64().expect("a number")
    };
    for (setting, expected) in [
        ("cg=0.16", 0.16),
        ("cg=16%", 0.16),
        ("cg=16 %", 0.16),
        ("cg=0.16si", 0.16),
        ("throttle=5%", 0.05),
        ("throttle=5 % of weight", 0.05),
        ("gamma=−3deg", -3_f64.to_radians()),
        ("gamma=-0.05rad", -0.05),
        ("speed=60m/s", 60.0),
        ("altitude=1.5e3m", 1500.0),
        ("cm_alpha=-0.5", -0.5),
    ] {
        let found = value(setting);
        assert!((found - expected).abs() < 1e-12, "{setting}: {found}");
    }
    for setting in ["cg=16deg", "speed=100ft/s", "cg=%", "gamma=3 degrees"] {
        let Output { status, stderr, .. } = run(&["parameters", "navion", "--set", setting]);
        assert_eq!(status.code(), Some(2), "{setting}");
        assert!(String::from_utf8_lossy(&stderr).contains("is not a number"), "{setting}");
    }
}
