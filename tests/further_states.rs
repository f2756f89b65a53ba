//! States beside the four of a plane: heights, headings, positions, engines and actuators of an opened file are kept, named as what they
//! are, flown with the rest, and composed with a law.

#[expect(dead_code, reason = "each test needs some of it")]
mod import_files;

use std::collections::BTreeMap;
use std::sync::Arc;

use eigenwing::content::import::{FileBytes, review};
use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::export::json;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::further::AppendedState;
use eigenwing::flight::aircraft::plane::Plane::{self, Lateral, Longitudinal};
use eigenwing::flight::feedback::LoopAnalysis;
use eigenwing::flight::feedback::loop_response::respond_closed;
use eigenwing::flight::modes::mode_name::ModeName::{self, *};
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::experiment::{Channel, Start, forced};
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{TimeGrid, respond};
use eigenwing::scenario::{Parameter, Scenario, Source, View, link};
use import_files::{model, open};
use nalgebra::{Complex, DVector};
use serde_json::{Value, json};

fn scenario(aircraft: Aircraft) -> Scenario {
    Scenario::new(Arc::new(aircraft))
}

fn scenario_of_text(name: &str, text: &str) -> Scenario {
    let file = FileBytes { name, bytes: text.as_bytes() };
    let read = review(&[file], &BTreeMap::new()).expect("it is read");
    scenario(read.aircraft().unwrap_or_else(|error| panic!("{error}")))
}

fn whole(scenario: &Scenario, plane: Plane) -> LoopAnalysis {
    let findings = Findings::of(scenario.clone());
    let found = findings.closed_loop_of(plane).expect("there are states beside the four");
    found.as_ref().expect("it can be analysed").clone()
}

fn set(scenario: &mut Scenario, key: &str, value: f64) {
    let parameter = Parameter::find(key).expect("a row");
    parameter.set(scenario, value);
}

fn names(analysis: &LoopAnalysis) -> Vec<(ModeName, Stability)> {
    analysis.modes.iter().map(|mode| (mode.mode.naming.name, mode.mode.stability)).collect()
}

/// Each root of a pair and each real one against those expected, of a pair the upper one.
fn assert_roots(analysis: &LoopAnalysis, expected: &[(f64, f64)], what: &str) {
    assert_eq!(analysis.modes.len(), expected.len(), "{what}");
    for &(re, im) in expected {
        let away = |mode: &Complex<f64>| (mode - Complex::new(re, im)).norm();
        let near = analysis.modes.iter().map(|mode| away(&mode.mode.lambda)).fold(f64::INFINITY, f64::min);
        assert!(near <= 1e-10, "{what}: {re} {im} is {near} away");
    }
}

/// Expected by numpy 2.4.6, numpy.linalg.eigvals of the parts of the file's A.
#[test]
fn twelve_states_are_two_planes_with_a_mode_for_each_further_state() {
    use Stability::{Neutral, Stable, Unstable};
    let review = open(&["navion-twelve-states.m"], &[]);
    let scenario = scenario(import_files::aircraft(&review));
    let longitudinal = whole(&scenario, Longitudinal);
    assert_eq!(
        longitudinal.closed.appended.as_slice(),
        [AppendedState::Height, AppendedState::Engine, AppendedState::Elevator]
    );
    assert_roots(
        &longitudinal,
        &[
            (-12.5, 0.0),
            (-2.509644755026, 2.924141690392),
            (-0.8, 0.0),
            (-0.01739750982086, 0.219404598544),
            (8.452969323408e-5, 0.0),
        ],
        "longitudinal",
    );
    assert_eq!(
        names(&longitudinal),
        [
            (ShortPeriod, Stable),
            (Phugoid, Stable),
            (Height, Unstable),
            (ElevatorActuator, Stable),
            (Engine, Stable)
        ]
    );
    let lateral = whole(&scenario, Lateral);
    assert_roots(
        &lateral,
        &[(-8.43479724732, 0.0), (-0.486677489736, 2.33475540635), (-0.008747773208, 0.0), (0.0, 0.0)],
        "lateral",
    );
    assert_eq!(
        names(&lateral),
        [(DutchRoll, Stable), (RollSubsidence, Stable), (Spiral, Stable), (Heading, Neutral)]
    );
    // A heading that stays is no verdict on the flight.
    assert_eq!(lateral.dynamic_stability, Stable);
    let plane = review.eigenvalues.iter().find(|found| found.plane == "longitudinal").expect("it is there");
    assert_eq!((plane.values.len(), plane.with_further.len()), (4, 7));
    // What the coupling moves most, by numpy: −0.486677490 + 2.334755406i to −0.499922591 + 2.331937204i, 0.568 %.
    let coupling = "The two planes are parted. Together the eigenvalue −0.4867 ± 2.335j would be −0.4999 ± 2.332j: 0.57 %, the most that \
                    any moves.";
    assert!(review.remarks.iter().any(|remark| remark == coupling), "{:#?}", review.remarks);
}

/// Airspeed, flow angles, feet, and a place in radians; numpy 2.4.6.
#[test]
fn all_states_of_jsbsim_are_kept_and_named() {
    let review = open(&["navion-linearisation.json"], &[]);
    let scenario = scenario(import_files::aircraft(&review));
    let longitudinal = whole(&scenario, Longitudinal);
    let is_there = |name| longitudinal.modes.iter().any(|mode| mode.mode.naming.name == name);
    assert!([ShortPeriod, Phugoid, Height, Position].into_iter().all(is_there));
    for (re, im) in
        [(-2.509639431087, 2.591914730586), (-0.01716507326140, 0.212918498462), (1.093955531641e-4, 0.0)]
    {
        let away = |lambda: Complex<f64>| (lambda - Complex::new(re, im)).norm();
        let near = longitudinal.modes.iter().map(|mode| away(mode.mode.lambda)).fold(f64::INFINITY, f64::min);
        // θ̇ = q was rounded by 3e-9.
        assert!(near < 2e-8, "{re} {im}: {near}");
    }
    let heading = whole(&scenario, Lateral);
    let found = heading.modes.iter().find(|mode| mode.mode.naming.name == Heading).expect("a heading");
    assert_eq!((found.mode.stability, found.mode.lambda), (Stability::Neutral, Complex::from(0.0)));
}

/// Differences leave entries of 1e-8, by which heading and place would swing in half a year: three of them, all neutral.
#[test]
fn what_differences_leave_makes_no_heading_move() {
    let text = "% units: SI\n% speed: 50\n% states: v p r phi psi y x\n\
        A = [-0.25 0 -50 9.8 0 0 0; -0.3 -8.4 2.2 0 0 0 0; 0.08 -0.35 -0.76 0 0 0 0; 0 1 0 0 0 0 0; \
        0 0 1 0 1e-9 -3e-14 1e-15; 1 0 0 0 50 0 2e-8; 0 0 0 0 40 -1e-8 0];\n";
    let analysis = whole(&scenario_of_text("differences.m", text), Lateral);
    let path: Vec<(ModeName, Stability)> =
        names(&analysis).into_iter().filter(|(name, _)| matches!(name, Heading | Position)).collect();
    let neutral = |name| (name, Stability::Neutral);
    assert_eq!(path, [neutral(Heading), neutral(Position), neutral(Position)], "{:?}", names(&analysis));
    assert!(analysis.modes.iter().all(|mode| mode.mode.naming.name != FurtherOscillation));
    assert_eq!(analysis.dynamic_stability, Stability::Stable);
}

#[test]
fn height_and_place_that_nothing_depends_on_change_no_other_mode() {
    for file in ["07-boeing747-five-named.m", "navion.sys"] {
        let scenario = scenario(import_files::aircraft(&open(&[file], &["all=suggested"])));
        let findings = Findings::of(scenario);
        let analysis = findings.analysis().as_ref().expect("it flies");
        for open in analysis.planes.iter().flatten().flatten() {
            let closed = findings.closed_loop_of(open.model.plane).expect("more than four");
            let closed = closed.as_ref().expect("it can be analysed");
            for mode in &open.modes {
                let name = mode.naming.name;
                let same = closed.modes.iter().find(|other| other.mode.naming.name == name);
                let same = same.unwrap_or_else(|| panic!("{file}: no {name:?}"));
                assert!((same.mode.lambda - mode.lambda).norm() < 1e-9, "{file} {name:?}");
            }
            assert_eq!(closed.dynamic_stability, open.dynamic_stability, "{file}");
            assert_eq!(findings.modes_in_flight(open).len(), closed.modes.len(), "{file}");
        }
    }
}

const LAG: &str = "% units: SI\n% speed: 50\n% states: u alpha q theta de\n% inputs: elevator\n\
    A = [-0.05 4 0 -9.81 0; -0.007 -2 1 0 -0.16; 0 -8 -3 0 -11; 0 0 1 0 0; 0 0 0 0 -10];\nB = [0;0;0;0;10];\n";

/// Expected by the matrix exponential in numpy 2.4.6: a step of 0.01 rad at t = 0.
#[test]
fn a_step_goes_through_the_actuator_of_the_file() {
    let scenario = scenario_of_text("lag.m", LAG);
    let closed = whole(&scenario, Longitudinal).closed;
    let step = |amplitude| [(Channel::First, Input::Step { amplitude, start: 0.0 })];
    let forced = forced(&scenario.edited, &closed.model, &step(0.01), Start::Rest, &[]);
    let grid = TimeGrid { duration: 2.0, steps: 400 };
    let response = respond_closed(&closed, &forced, &DVector::zeros(closed.size()), grid);
    for (k, [u, alpha, q, theta, de]) in [
        (100, [0.005727591939, -0.004605355734, -0.020274988018, -0.005662556961, 0.00993262053]),
        (400, [0.231616432002, -0.008542771163, -0.013955621675, -0.030456182328, 0.009999999979]),
    ] {
        let expected = DVector::from_vec(vec![u, 50.0 * alpha, q, theta, de]);
        assert!((&response.states[k] - &expected).norm() < 1e-10, "{} {expected}", response.states[k]);
    }
    // The four states alone under the elevator's own course move the same.
    let course = Input::Samples {
        dt: response.dt,
        values: response.states.iter().map(|x| x[4]).collect::<Vec<f64>>().into(),
    };
    let none = || Input::Step { amplitude: 0.0, start: 0.0 };
    let alone = respond(&closed.with_courses(&forced, [none(), none()], |_| course.clone()), grid);
    for (x, whole) in alone.states.iter().zip(response.as_of_aircraft().states) {
        // Straight between the samples.
        assert!((x - whole).norm() < 1e-4 * 0.5, "{x} {whole}");
    }
}

/// An actuator in the file and one of the law are one thing, and so are their heights.
#[test]
fn a_law_composes_with_the_states_of_the_file() {
    let height = "% units: SI\n% speed: 50\n% states: u alpha q theta h\n% inputs: elevator\n\
        A = [-0.05 4 0 -9.81 0; -0.007 -2 1 0 0; 0 -8 -3 0 0; 0 0 1 0 0; 0 -50 0 50 0];\nB = [0;-0.16;-11;0;0];\n";
    let plain = "% units: SI\n% speed: 50\n% states: u alpha q theta\n% inputs: elevator\n\
        A = [-0.05 4 0 -9.81; -0.007 -2 1 0; 0 -8 -3 0; 0 0 1 0];\nB = [0;-0.16;-11;0];\n";
    let roots = |mut scenario: Scenario, law: &[(&str, f64)]| {
        law.iter().for_each(|(key, value)| set(&mut scenario, key, *value));
        let analysis = whole(&scenario, Longitudinal);
        assert!(analysis.closed.is_fed_back());
        let modes = analysis.modes.iter();
        modes.map(|mode| (mode.mode.naming.name, mode.mode.lambda)).collect::<Vec<_>>()
    };
    let compare = |one: &[(ModeName, Complex<f64>)], other: &[(ModeName, Complex<f64>)]| {
        assert_eq!(one.len(), other.len(), "{one:?} {other:?}");
        for ((name, x), (of, y)) in one.iter().zip(other) {
            assert!(name == of && (x - y).norm() < 1e-9, "{one:?} {other:?}");
        }
    };
    let damped = [("k.q_de", 0.3), ("actuator", 0.1)];
    // The law's own lag isn't added a second time, whatever it is.
    for lag in [0.0, 0.1, 0.5] {
        let of_file = roots(scenario_of_text("lag.m", LAG), &[damped[0], ("actuator", lag)]);
        compare(&of_file, &roots(scenario_of_text("plain.m", plain), &damped));
    }
    let held = [("k.h_de", 0.001), ("k.theta_de", 0.5)];
    compare(
        &roots(scenario_of_text("height.m", height), &held),
        &roots(scenario_of_text("plain.m", plain), &held),
    );
}

#[test]
fn what_a_file_calls_by_no_known_name_is_kept_as_a_state_of_its_own() {
    let text = "% units: SI\n% speed: 50\n% states: u alpha q theta wg\n% inputs: elevator\n\
        A = [-0.05 4 0 -9.81 0; -0.007 -2 1 0 -0.04; 0 -8 -3 0 -0.1; 0 0 1 0 0; 0 0 0 0 -0.7];\nB = [0;-0.1;-11;0;0];\n";
    let file = FileBytes { name: "gust.m", bytes: text.as_bytes() };
    let read = review(&[file], &BTreeMap::new()).expect("it is read");
    assert_eq!(read.remarks[0], "“wg” is no state known here, and is kept as a state of its own.");
    let analysis = whole(&scenario(read.aircraft().expect("an aircraft")), Longitudinal);
    let found =
        analysis.modes.iter().find(|mode| mode.mode.naming.name == FurtherState).expect("it is named");
    assert!((found.mode.lambda.re + 0.7).abs() < 1e-12);
    // Where a plane is short of a state, a strange name is more likely to be that.
    let short = text.replace("theta wg", "thata h");
    let file = FileBytes { name: "gust.m", bytes: short.as_bytes() };
    let read = review(&[file], &BTreeMap::new()).expect("it is read");
    assert!(read.aircraft().expect_err("no plane").problem.starts_with("“thata” is not a state known here"));
}

#[test]
fn further_states_travel_in_files_links_and_json_to_the_last_bit() {
    for file in ["navion-twelve-states.m", "navion-linearisation.json", "07-boeing747-five-named.m"] {
        let review = open(&[file], &[]);
        let scenario = scenario(import_files::aircraft(&review));
        let again = Aircraft::own(file, review.text().expect("an aircraft")).expect("it is read");
        assert_eq!(again.aircraft_model, scenario.aircraft.aircraft_model, "{file}");
        let text = link::write(&scenario, &View::of(&scenario), None);
        assert!(text.len() < 2000, "{file}: {}", text.len());
        let ships: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
        let opened = link::read(&text, &ships).expect("there are aircraft");
        assert_eq!(opened.scenario.aircraft.aircraft_model, scenario.aircraft.aircraft_model, "{file}");
    }
}

/// A mode that is there has its place in a link; one that isn't is told.
#[test]
fn each_mode_has_its_place_in_a_link() {
    let review = open(&["navion-twelve-states.m"], &[]);
    let mut scenario = scenario(import_files::aircraft(&review));
    let ships: Vec<Arc<Aircraft>> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    let choice = |scenario: &Scenario| scenario.disturbance.choices[Longitudinal];
    scenario.disturbance.choices[Longitudinal].source = Source::OneMode;
    let count = Findings::of(scenario.clone()).flown().expect("it flies").modes.len();
    assert!(count > 4, "{count}");
    for mode in 0..16 {
        scenario.disturbance.choices[Longitudinal].mode = mode;
        let text = link::write(&scenario, &View::of(&scenario), None);
        let opened = link::read(&text, &ships).expect("there are aircraft");
        if mode < count {
            assert_eq!((choice(&opened.scenario), opened.notices), (choice(&scenario), vec![]), "{text}");
        } else {
            assert_eq!(opened.notices.len(), 1, "{text}");
        }
    }
    for none in ["0", "17", "+3", "03"] {
        let opened =
            link::read(&format!("v=1&ac=navion&lon.mode={none}"), &ships).expect("there are aircraft");
        assert_eq!(opened.notices.len(), 1, "{none}");
    }
}

#[test]
fn answers_to_programs_have_the_whole_model_beside_the_four() {
    let review = open(&["navion-twelve-states.m"], &[]);
    let request = json!({ "toml": review.text().expect("an aircraft") });
    let answer = json::analyse(&request.to_string());
    let answer: Value = serde_json::from_str(&answer.expect("an answer")).expect("JSON");
    let plane = &answer["longitudinal"];
    assert_eq!(plane["whole"]["states"], json!(["u", "w", "q", "theta", "h", "engine", "elevator"]));
    assert_eq!(plane["whole"]["a"][4], json!([0.0, -1.0, 0.0, 53.64, 0.0, 0.0, 0.0]));
    assert_eq!(plane["whole"]["b"][6], json!([12.5, 0.0]));
    assert_eq!(plane["closed_loop"]["feedback"], json!(false));
    let names: Vec<&Value> =
        plane["closed_loop"]["modes"].as_array().expect("modes").iter().map(|mode| &mode["key"]).collect();
    assert_eq!(names, ["short-period", "phugoid", "height", "elevator-actuator", "engine"]);
}

#[test]
fn the_four_states_stay_editable_and_move_the_whole() {
    let review = open(&["navion-twelve-states.m"], &[]);
    let mut scenario = scenario(import_files::aircraft(&review));
    set(&mut scenario, "a_qw", -0.3);
    let found = whole(&scenario, Longitudinal);
    assert_eq!(found.closed.a[(2, 1)], -0.3);
    // The elevator behind its actuator moves the aircraft by its column of B.
    set(&mut scenario, "b_q_de", -5.0);
    assert_eq!(whole(&scenario, Longitudinal).closed.a[(2, 6)], -5.0);
}

#[test]
fn a_file_of_feet_is_the_same_aircraft_as_one_of_metres() {
    let a = "[-0.05 0.08 0 -32.174 2e-5 0; -0.14 -2 164 0 1e-4 -0.5; 0 -0.0488 -3 0 0 -11; 0 0 1 0 0 0; 0 -1 0 164 0 0; 0 0 0 0 0 -10]";
    let feet = format!(
        "% units: ft-slug-s\n% speed: 164\n% states: u w q theta h de\n% inputs: elevator\nA = {a};\nB = [0;0;0;0;0;10];\n"
    );
    let metres = feet
        .replace("ft-slug-s", "SI")
        .replace("u w q theta h de", "u[ft/s] w[ft/s] q theta h[ft] de")
        .replace("164\n", "49.9872\n");
    let of = |text: &str| {
        let file = FileBytes { name: "a.m", bytes: text.as_bytes() };
        let read = review(&[file], &BTreeMap::new()).expect("it is read");
        model(&read, Longitudinal).whole_a()
    };
    let (feet, metres) = (of(&feet), of(&metres));
    assert!((&feet - &metres).amax() < 1e-9, "{feet} {metres}");
    assert!((feet[(4, 3)] - 49.9872).abs() < 1e-9 && feet[(4, 1)] == -1.0);
}

#[test]
fn an_aircraft_file_says_what_is_wrong_with_its_further_states() {
    let text = |states: &str, a: &str, b: &str| {
        format!(
            "key = \"file\"\nname = \"A\"\ncondition = \"B\"\nsource = \"C\"\nbasis = \"matrices\"\nunits = \"SI\"\nangles = \"rad\"\n\
             [longitudinal]\nstatus = \"unverified\"\nstatus_reason = \"D\"\nspeed = 50.0\nalpha0_deg = 0.0\ngamma0_deg = 0.0\n\
             gravity = 9.8\nfurther_states = [{states}]\nA = [{a}]\nB = [{b}]\n"
        )
    };
    let rows = "[-0.05, 0.08, 0, -9.8, 0], [-0.14, -2, 50, 0, -8], [0, -0.16, -3, 0, -11], [0, 0, 1, 0, 0], [0, 0, 0, 0, -10]";
    let columns = "[0, 0], [0, 0], [0, 0], [0, 0], [10, 0]";
    let read = |text: &str| Aircraft::from_toml("file.toml", text);
    let found = read(&text("\"elevator\"", rows, columns)).expect("it is read");
    let AircraftModel::Matrices(planes) = &found.aircraft_model else { panic!("matrices") };
    let model = planes.longitudinal.as_ref().expect("it is there");
    assert_eq!((model.b[(2, 0)], model.whole_b(0)[2], model.whole_b(0)[4]), (-11.0, 0.0, 10.0));
    for (text, expected) in [
        (text("\"rudder\"", rows, columns), "longitudinal.further_states: expected \"h\" or \"x\" or"),
        (text("\"h\", \"h\"", rows, columns), "longitudinal.further_states: \"h\" stands there twice"),
        (text("\"h\", \"x\"", rows, columns), "longitudinal.A: expected 6 rows of 6 numbers, found 5 rows"),
        (
            text("\"elevator\"", rows, "[0, 0], [0, 0], [1, 0], [0, 0], [10, 0]"),
            "longitudinal.B: elevator is a state: expected its column to be 0 in the first four rows",
        ),
        (
            text("\"elevator\"", &rows.replace("[0, 0, 1, 0, 0]", "[0, 0, 1, 0, 2]"), columns),
            "longitudinal.A: the fourth row must begin with 0, 0, 1, 0: pitch rate is the rate of pitch angle",
        ),
    ] {
        let problem = read(&text).expect_err("it is refused").problem;
        assert!(problem.starts_with(expected), "{problem}");
    }
}
