//! Which control is which, and in which unit states and controls are, in files of other programs; and that nothing is typed in vain.

#[expect(dead_code, reason = "each test needs some of it")]
mod import_files;

use std::collections::BTreeMap;

use eigenwing::content::import::review::{Field, Review};
use eigenwing::content::import::{FileBytes, review};
use eigenwing::flight::aircraft::plane::Plane::{self, Lateral, Longitudinal};
use import_files::{model, open, try_open};

fn text(name: &str) -> String {
    String::from_utf8(import_files::bytes(name)).expect("a text")
}

fn read(name: &str, text: &str, fills: &[&str]) -> Result<Review, String> {
    let split = |fill: &&str| {
        let (key, value) = fill.split_once('=').expect("key=value");
        (key.to_owned(), value.to_owned())
    };
    let fills: BTreeMap<String, String> = fills.iter().map(split).collect();
    review(&[FileBytes { name, bytes: text.as_bytes() }], &fills).map_err(|error| error.to_string())
}

fn opened(text: &str, fills: &[&str]) -> Review {
    read("log.txt", text, fills).unwrap_or_else(|error| panic!("{error}"))
}

fn inputs(review: &Review) -> &Field {
    let found: Vec<&Field> = review.fields.iter().filter(|field| field.key == "inputs").collect();
    assert_eq!(found.len(), 1, "{:#?}", review.fields);
    found[0]
}

fn column(review: &Review, plane: Plane, control: usize) -> [f64; 4] {
    let b = model(review, plane).b;
    std::array::from_fn(|i| b[(i, control)])
}

fn says(review: &Review, part: &str) {
    assert!(review.remarks.iter().any(|remark| remark.contains(part)), "{part}: {:#?}", review.remarks);
}

/// Elevator, aileron and rudder of the log, as it prints them.
const ELEVATOR: [f64; 4] = [0.0, -8.57909, -11.2021, 0.0];
const AILERON: [f64; 4] = [0.0, 28.9843, -0.221857, 0.0];
const RUDDER: [f64; 4] = [3.79413, 2.54854, -4.59744, 0.0];

#[test]
fn each_control_set_of_flow5_is_the_control_of_its_name() {
    let log = opened(&text("navion-flow5.txt"), &[]);
    assert_eq!(log.basis, "matrices", "flow5 prints no inertia");
    assert_eq!(inputs(&log).value.as_deref(), Some("Aileron, Elevator, Rudder"));
    assert_eq!(column(&log, Longitudinal, 0), ELEVATOR);
    assert_eq!(column(&log, Lateral, 0), AILERON);
    assert_eq!(column(&log, Lateral, 1), RUDDER);
    says(&log, "The set Aileron is read as the aileron, in radians.");
    // And in whatever order they come.
    let log = text("navion-flow5.txt");
    let turned = log.replace("Aileron", "@").replace("Rudder", "Aileron").replace('@', "Rudder");
    let turned = opened(&turned, &[]);
    assert_eq!(column(&turned, Lateral, 1), AILERON);
    assert_eq!(column(&turned, Lateral, 0), RUDDER);
}

#[test]
fn a_set_whose_name_means_no_control_is_asked_for() {
    let log = text("navion-flow5.txt").replace("set Elevator", "set Tail plane");
    let waiting = opened(&log, &[]);
    let field = inputs(&waiting);
    assert_eq!((field.value.as_deref(), field.required), (None, true));
    assert_eq!(field.meaning, "what the control sets Aileron, Tail plane, Rudder are, in this order");
    // It pitches, and nothing else is the elevator.
    assert_eq!(field.suggested.as_deref(), Some("Aileron, elevator, Rudder"));
    assert_eq!(waiting.aircraft, None);
    assert_eq!(column(&opened(&log, &["inputs=suggested"]), Longitudinal, 0), ELEVATOR);
    let left_out = opened(&log, &["inputs=aileron, flap, rudder"]);
    assert_eq!(column(&left_out, Longitudinal, 0), [0.0; 4]);
    assert_eq!(column(&left_out, Lateral, 1), RUDDER);
    says(&left_out, "flap is no control that these planes have here, and left out.");
    assert_eq!(
        read("log.txt", &log, &["inputs=aileron, rudder"]).expect_err("one is missing"),
        "log.txt, line 70: inputs: expected a name for each of the 3 control sets, found 2: aileron, rudder"
    );
    // A flap beside an elevator is not one, though it pitches.
    let flap = text("navion-flow5.txt").replace("set Rudder", "set Flap");
    assert_eq!(inputs(&opened(&flap, &[])).suggested.as_deref(), Some("Aileron, Elevator, rudder"));
}

#[test]
fn what_a_set_does_to_the_other_plane_is_told() {
    let log = text("navion-flow5.txt");
    let silent = opened(&log, &[]);
    assert!(
        !silent.remarks.iter().any(|remark| remark.contains("motion is left out")),
        "{:#?}",
        silent.remarks
    );
    let aileron = "set Aileron __________\n       Longitudinal control matrix\n                  0\n                  0\n                  0";
    assert!(log.contains(aileron));
    let pitching = log.replace(aileron, &format!("{}-1.5", &aileron[..aileron.len() - 1]));
    says(
        &opened(&pitching, &[]),
        "What it does to the longitudinal motion is left out: at most 1.50 beside 29.0",
    );
}

#[test]
fn the_control_of_xflr5_is_the_elevator_unless_it_rolls_or_yaws() {
    let log = text("navion-xflr5.txt");
    let usual = opened(&log, &["basis=matrices"]);
    assert_eq!(inputs(&usual).value.as_deref(), Some("elevator"));
    says(&usual, "The control is read as the elevator, in radians; a set of several surfaces counts as one.");
    // Ailerons alone: they roll.
    let of_log = "Lateral control matrix\n                  0\n                  0";
    assert!(log.contains(of_log));
    let rolling = log.replace(of_log, "Lateral control matrix\n                  0\n                 30");
    let waiting = opened(&rolling, &["basis=matrices"]);
    assert_eq!(
        (inputs(&waiting).value.as_deref(), inputs(&waiting).suggested.as_deref()),
        (None, Some("aileron"))
    );
    let taken = opened(&rolling, &["basis=matrices", "inputs=aileron"]);
    assert_eq!(column(&taken, Lateral, 0)[1], 30.0);
    assert_eq!(column(&taken, Longitudinal, 0), [0.0; 4]);
    says(&taken, "What it does to the longitudinal motion is left out");
}

/// Without its matrices the log of flow5 has derivatives alone; the inertia that they are divided by is asked for.
#[test]
fn derivatives_by_named_sets_are_divided_by_the_inertia_that_is_typed() {
    let log = text("navion-flow5.txt");
    let end = log.find("Calculating eigenthings").expect("it is there");
    let waiting = opened(&log[..end], &[]);
    assert_eq!(waiting.basis, "derivatives");
    let missing: Vec<&str> =
        waiting.fields.iter().filter(|field| field.value.is_none()).map(|field| field.key.as_str()).collect();
    assert_eq!(missing, ["Ix", "Iy", "Iz", "Ixz"]);
    let inertia = ["Ix=1420.89721", "Iy=4067.45384", "Iz=4786.03736", "Ixz=0", "gravity=9.80664"];
    let found = opened(&log[..end], &inertia);
    // Five digits of a derivative.
    let near = |found: [f64; 4], expected: [f64; 4]| {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= 6e-5 * expected.abs(), "{found} {expected}");
        }
    };
    near(column(&found, Longitudinal, 0), ELEVATOR);
    near(column(&found, Lateral, 0), AILERON);
    near(column(&found, Lateral, 1), RUDDER);
    assert_eq!(inputs(&found).value.as_deref(), Some("Aileron, Elevator, Rudder"));
    // A mass that is typed is the one that forces are divided by.
    let log = text("navion-xflr5.txt");
    let of = |fills: &[&str]| {
        let log = opened(&log, fills);
        log.read.iter().find(|read| read.key == "Zw").and_then(|read| read.value).expect("it is read")
    };
    assert!((of(&["mass=2494.758036"]) / of(&[]) - 0.5).abs() < 1e-12);
}

#[test]
fn units_behind_the_numbers_of_a_log_count() {
    let log = text("navion-flow5.txt");
    let speed = |text: &str| {
        let log = opened(text, &[]);
        log.read.iter().find(|read| read.key == "speed").and_then(|read| read.value).expect("it is read")
    };
    assert_eq!(speed(&log), 53.645);
    assert!((speed(&log.replace("53.645 m/s", "193.122 km/h")) - 53.645).abs() < 1e-9);
    let error = read("log.txt", &log.replace("53.645 m/s", "53.645 leagues"), &[]).expect_err("no unit");
    assert_eq!(error, "log.txt, line 2: V∞: leagues is not a unit known here; expected m/s");
    // Of several steps to the speed the last counts.
    assert_eq!(speed(&log.replace("53.645 m/s", "50.000 m/s\n      V∞ = 53.645 m/s")), 53.645);
}

/// The same linearisation with angles and rates in degrees, controls too: A, B and the trim are the same.
#[test]
fn degrees_of_a_linearisation_are_turned_into_radians() {
    let [radians, degrees] =
        ["navion-linearisation.json", "navion-linearisation-degrees.json"].map(|file| open(&[file], &[]));
    for plane in [Longitudinal, Lateral] {
        let [expected, found] = [&radians, &degrees].map(|review| model(review, plane));
        assert_eq!(found.trim, expected.trim);
        let (a, expected_a) = (found.whole_a(), expected.whole_a());
        assert!((&a - &expected_a).abs().max() <= 1e-12 * expected_a.abs().max(), "{}", a - expected_a);
        assert!(
            (found.b - expected.b).abs().max() <= 1e-12 * expected.b.abs().max(),
            "{}",
            found.b - expected.b
        );
    }
    says(
        &degrees,
        "States were turned into the units of the rest, radians for angles: Alpha, Theta, Q, Beta, Phi, P, Psi, R, Latitude, Longitude.",
    );
    says(
        &degrees,
        "Controls were turned into the units of the rest, radians for angles: DaCmd, DeCmd, DrCmd.",
    );
    let norm = |review: &Review| {
        review.remarks.iter().any(|remark| remark.starts_with("Controls count from −1 to 1"))
    };
    assert!(norm(&radians) && !norm(&degrees));
}

#[test]
fn a_trim_in_degrees_is_the_angle_of_the_file() {
    let text = text("navion-linearisation-degrees.json");
    let climbing = text.replace("\"x0\": [176.0, 0.0, 0.0", "\"x0\": [176.0, 2.3, 5.3");
    assert_ne!(text, climbing);
    let review = opened(&climbing, &[]);
    let of = |key: &str| review.read.iter().find(|read| read.key == key).and_then(|read| read.value);
    assert_eq!(of("alpha0_deg"), Some(2.3));
    assert!((of("gamma0_deg").expect("it climbs") - 3.0).abs() < 1e-12);
    assert!(!review.doubts.iter().any(|doubt| doubt.key == "range"), "{:#?}", review.doubts);
}

#[test]
fn units_of_a_linearisation_that_make_no_sense_are_refused() {
    let text = text("navion-linearisation.json");
    let error = |from: &str, to: &str| {
        let broken = text.replacen(from, to, 1);
        assert_ne!(broken, text);
        read("a.json", &broken, &[]).expect_err("it makes no sense")
    };
    assert!(
        error("\"ft/s\"", "\"furlong\"").contains("x_units: “furlong” of Vt is not a unit known here"),
        "{}",
        error("\"ft/s\"", "\"furlong\"")
    );
    assert!(
        error("  \"ft/s\",\n", "").contains("x_units: expected a unit for each of the 12 names, found 11")
    );
    assert!(
        error("  176.0,\n", "").contains("x0: expected 12 numbers, one a state, found 11"),
        "{}",
        error("  176.0,\n", "")
    );
}

const TYPED: [&str; 14] = [
    "mass=85.472 slug",
    "Ix=1048 slug ft2",
    "Iy=3000 slug ft2",
    "Iz=3530 slug ft2",
    "Ixz=0",
    "speed=176 ft/s",
    "altitude=0",
    "density=0.002378 slug/ft3",
    "gravity=32.174 ft/s2",
    "units=ft-slug-s",
    "case=3",
    "ConGrp_1=elevator",
    "ConGrp_2=aileron",
    "ConGrp_3=rudder",
];

#[test]
fn what_is_typed_and_nothing_asks_for_is_refused() {
    let with = |more: &[&'static str]| [&TYPED[..], more].concat();
    let stab =
        |more: &[&'static str]| try_open(&["navion.stab"], &with(more)).map_err(|error| error.to_string());
    assert!(stab(&[]).is_ok_and(|review| review.aircraft.is_some()));
    for (fill, told) in [
        ("ConGrp_4=elevator", "nothing in this file waits for “ConGrp_4”"),
        ("basis=matrices", "nothing in this file waits for “basis”"),
        ("length_unit=ft", "nothing in this file waits for “length_unit”"),
        ("Zw=-2", "nothing in this file waits for “Zw”"),
        ("hight=3", "nothing in this file waits for “hight”"),
        ("mach=suggested", "mach: nothing is suggested for it here; expected a value"),
        ("all=yes", "all: expected “suggested”, found “yes”"),
    ] {
        let error = stab(&[fill]).expect_err(fill);
        assert!(error.contains(told), "{error}");
    }
    // An aircraft file has everything.
    let own = open(&["navion.sys"], &[]).text().expect("it is ready").to_owned();
    assert_eq!(
        read("own.toml", &own, &["mass=3"]).expect_err("nothing asks"),
        "own.toml, line 1: nothing in this file waits for “mass”"
    );
}

/// What is asked for later may be typed at once, in any order.
#[test]
fn a_field_that_appears_only_after_another_is_filled_takes_what_was_typed_before() {
    for count in 0..TYPED.len() {
        let review = try_open(&["navion.stab"], &TYPED[..count]);
        assert!(review.is_ok(), "{count}: {}", review.expect_err("it is none"));
    }
    // Groups are asked for once a case is chosen, the row of sideslip once the states have a name.
    assert!(open(&["navion.stab"], &["ConGrp_1=elevator"]).aircraft.is_none());
}

/// Two groups that are the same control are no sum, and one whose column holds no numbers is no control.
#[test]
fn a_group_of_controls_that_cannot_be_read_is_told() {
    let with = |more: &[&'static str]| [&TYPED[..12], more].concat();
    let twice = open(&["navion.stab"], &with(&["ConGrp_2=elevator"]));
    says(&twice, "ConGrp_2 is left out: another group is the elevator already.");
    let empty = text("navion.stab").replace("-0.8700000", "nan");
    let review = read("a.stab", &empty, &with(&[])).expect("it is read");
    let told: Vec<&str> =
        review.doubts.iter().filter(|doubt| doubt.stops).map(|doubt| doubt.sentence.as_str()).collect();
    assert_eq!(told, ["ConGrp_1 is to be the elevator, and its column has no number in the row CMm."]);
}

#[test]
fn a_second_file_that_is_no_mass_file_is_refused() {
    let error = |files: &[&str]| try_open(files, &[]).expect_err("one of them is for nothing").to_string();
    assert_eq!(
        error(&["navion.st", "navion.sys"]),
        "navion.sys, line 1: this is no mass file of AVL (Lunit, Munit, rows of masses); another file is opened alone"
    );
    assert_eq!(
        error(&["navion.sys", "navion.mass"]),
        "navion.sys, line 1: this is AVL system matrix (.sys); a mass file belongs to AVL’s derivatives (ST) only"
    );
}
