//! The figures of the Navion in the forms in which other programs print them: each is the Navion again, to the digits printed.

mod import_files;

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane::{self, Lateral, Longitudinal};
use eigenwing::flight::aircraft::plane::PlaneModel;
use eigenwing::scenario::{Parameter, Scenario};
use import_files::{doubt, doubts, model, open, poles, remedy};
use nalgebra::Complex;

/// The Navion with a few of its numbers set.
fn navion(plane: Plane, set: &[(&str, f64)]) -> PlaneModel {
    let (all, _) = embedded_aircraft();
    let navion = all.into_iter().find(|aircraft| aircraft.key == "navion").expect("it ships");
    let mut scenario = Scenario::new(Arc::new(navion));
    for (key, value) in set {
        Parameter::find(key).expect("a parameter").set(&mut scenario, *value);
    }
    scenario.edited.models().expect("it flies").planes[plane].clone().expect("it has data")
}

/// Entries within a share of the largest of their row; derivatives by degree are printed with three digits fewer.
fn assert_near(found: &PlaneModel, expected: &PlaneModel, share: f64, of_b: f64) {
    for i in 0..4 {
        let size = expected.a.row(i).abs().max();
        for j in 0..4 {
            let apart = (found.a[(i, j)] - expected.a[(i, j)]).abs();
            assert!(apart <= share * size, "A({i}, {j}): {} for {}", found.a[(i, j)], expected.a[(i, j)]);
        }
        let size = expected.b.row(i).abs().max();
        for j in 0..2 {
            let apart = (found.b[(i, j)] - expected.b[(i, j)]).abs();
            assert!(apart <= of_b * size, "B({i}, {j}): {} for {}", found.b[(i, j)], expected.b[(i, j)]);
        }
    }
}

/// Mass, inertia and flight of the Navion's report, as they are typed.
const REPORT: [&str; 9] = [
    "mass=85.472 slug",
    "Ix=1048 slug ft2",
    "Iy=3000 slug ft2",
    "Iz=3530 slug ft2",
    "Ixz=0",
    "speed=176 ft/s",
    "altitude=0",
    "density=0.002378 slug/ft3",
    "gravity=32.174 ft/s2",
];

fn with<'f>(more: &[&'f str]) -> Vec<&'f str> {
    REPORT.iter().copied().chain(more.iter().copied()).collect()
}

#[test]
fn avl_derivatives_are_the_navion_without_what_avl_does_not_know() {
    for file in ["navion.st", "navion-scientific.st"] {
        // The report's inertia is about the axes of the flow.
        let review = open(&[file], &with(&["length_unit=ft", "CD_alpha=0.33", "alpha0_deg=0"]));
        assert_eq!(review.format, "avl-st");
        assert_eq!(review.title, "Navion");
        // AVL prints no downwash lag; a glued sign and E-format are read alike. Mass to five digits.
        for plane in [Longitudinal, Lateral] {
            assert_near(&model(&review, plane), &navion(plane, &[("cm_alphadot", 0.0)]), 2e-5, 5e-4);
        }
        assert!(review.remarks.iter().any(|remark| remark.contains("positive rudder turns the nose right")));
        // Clb Cnr / Clr Cnb is no Cnb.
        let yaw = review.read.iter().find(|read| read.key == "Cn_beta").expect("it is read");
        assert_eq!(yaw.value, Some(0.0701));
    }
}

#[test]
fn what_avl_leaves_out_is_asked_for_with_what_is_likely() {
    let review = open(&["navion.st"], &[]);
    let missing = |review: &eigenwing::content::import::review::Review| -> Vec<String> {
        review.fields.iter().filter(|field| field.value.is_none()).map(|field| field.key.clone()).collect()
    };
    // The geometry's unit first: without it no area is known.
    assert_eq!(missing(&review), ["length_unit", "mass", "Ix", "Iy", "Iz", "Ixz"]);
    let review = open(&["navion.st", "navion.mass"], &[]);
    assert_eq!(missing(&review), ["altitude", "speed", "CD_alpha"]);
    let suggested = |key: &str| {
        let field = review.fields.iter().find(|field| field.key == key).expect("it is asked for");
        field.suggested.as_ref().expect("it is likely").parse::<f64>().expect("a number")
    };
    // V = √(2 m g/(ρ S C_L))
    let level = (2.0 * 2750.0 * 0.453_592_37 * 9.80665 / (1.225 * 184.0 * 0.092_903_04 * 0.41_f64)).sqrt();
    assert!((suggested("speed") - level).abs() < 1e-9);
    assert!(suggested("altitude").abs() < 1.0);
    let all = open(&["navion.st", "navion.mass"], &["all=suggested"]);
    assert_eq!(missing(&all), [""; 0]);
    assert_eq!(poles(&all, Longitudinal).len(), 2);
}

/// Three lumps, the tail given as half of it and half a foot too low.
#[test]
fn a_mass_file_is_summed_about_its_centre_of_gravity() {
    let review = open(&["navion.st", "navion.mass"], &[]);
    let of = |key: &str| {
        review.read.iter().find(|read| read.key == key).and_then(|read| read.value).expect("it is read")
    };
    let (pound, foot) = (0.453_592_37, 0.3048);
    assert!((of("mass") - 2750.0 * pound).abs() < 1e-9);
    // x̄ = (2000 · 7.03 + 550 · 8.03 + 200 · 18.03)/2750 = 8.03, z̄ = −0.47, for the tail is 0.5 − 0.97 up
    let unit = pound * foot * foot;
    assert!((of("Ix") - 32_000.0 * unit).abs() < 1e-6);
    assert!((of("Iy") - (61_500.0 + 2000.0 + 200.0 * 100.0) * unit).abs() < 1e-6);
    assert!((of("Iz") - (85_000.0 + 2000.0 + 200.0 * 100.0) * unit).abs() < 1e-6);
    assert!(of("Ixz").abs() < 1e-6);
    assert_eq!(doubts(&review), [""; 0]);
}

#[test]
fn several_run_cases_are_asked_for() {
    let review = open(&["navion-two-cases.st", "navion.mass"], &[]);
    let field = review.fields.iter().find(|field| field.key == "case").expect("it is asked for");
    let words: Vec<&str> = field.choices.iter().map(|choice| choice.words.as_str()).collect();
    assert_eq!((words, &field.value), (vec!["slow, α 5.5°", "cruise, α 0.6°"], &None));
    let second = open(&["navion-two-cases.st", "navion.mass"], &["case=2", "all=suggested"]);
    let alone = open(&["navion.st", "navion.mass"], &["all=suggested"]);
    assert_eq!(model(&second, Longitudinal), model(&alone, Longitudinal));
}

/// Four decimals of A, so the eigenvalues are right within the band that half of the last makes.
#[test]
fn avl_system_matrix_tells_its_trim_and_both_planes() {
    let review = open(&["navion.sys"], &[]);
    assert_eq!(review.format, "avl-sys");
    assert_eq!(doubts(&review), [""; 0]);
    for plane in [Longitudinal, Lateral] {
        let (found, expected) = (model(&review, plane), navion(plane, &[]));
        // B is by degree, with five digits.
        assert!((found.a - expected.a).abs().max() <= 5.1e-5, "{}", found.a - expected.a);
        assert!((found.trim.speed - 53.6448).abs() < 1e-4);
    }
    let elevator = model(&review, Longitudinal).b[(2, 0)];
    assert!((elevator + 11.0566774).abs() < 5e-4, "{elevator}");
    assert!(review.remarks.iter().any(|remark| remark.starts_with(
        "x (place), z (height), y (place) are kept as states beside the four: nothing else depends on them"
    )));
    assert!(review.remarks.contains(&"The two planes are parted: no entry of A couples them.".to_owned()));
}

#[test]
fn an_xflr5_log_is_its_derivatives_over_mass_and_inertia_or_its_matrices() {
    let expected = [navion(Longitudinal, &[("cm_alphadot", 0.0)]), navion(Lateral, &[])];
    let by_derivatives = open(&["navion-xflr5.txt"], &["gravity=32.174 ft/s2"]);
    assert_eq!((by_derivatives.basis, doubts(&by_derivatives)), ("derivatives", vec![]));
    let by_matrices = open(&["navion-xflr5.txt"], &["basis=matrices"]);
    assert_eq!(by_matrices.basis, "matrices");
    for (review, share) in [(&by_derivatives, 2e-5), (&by_matrices, 2e-5)] {
        let a = [model(review, Longitudinal).a, model(review, Lateral).a];
        for (a, expected) in a.iter().zip(&expected) {
            for i in 0..4 {
                let size = expected.a.row(i).abs().max();
                assert!((a.row(i) - expected.a.row(i)).abs().max() <= share * size, "{a} {}", expected.a);
            }
        }
        let elevator = model(review, Longitudinal).b[(2, 0)];
        assert!((elevator + 11.2020593).abs() < 1e-3, "{elevator}");
    }
    assert!(
        by_derivatives
            .remarks
            .iter()
            .any(|remark| remark.starts_with("The matrices that the log prints follow from its derivatives"))
    );
}

#[test]
fn a_log_whose_matrices_are_not_those_of_its_derivatives_is_told() {
    let text = String::from_utf8(import_files::bytes("navion-xflr5.txt")).expect("a text");
    // A moment of inertia that is almost zero.
    let broken = text.replace("Isxx=    1420.89", "Isxx=    0.00000142089");
    assert_ne!(broken, text);
    let file = eigenwing::content::import::FileBytes { name: "log.txt", bytes: broken.as_bytes() };
    let review = eigenwing::content::import::review(&[file], &Default::default()).expect("it is read");
    let found = doubt(&review, "log");
    assert!(found.sentence.contains("are not those of its derivatives"), "{}", found.sentence);
    assert_eq!(remedy(found), ["basis=matrices"]);
}

#[test]
fn vspaero_tables_are_chosen_by_angle_of_attack_and_turned_into_stability_axes() {
    let open_case = |case: &str| {
        let groups = ["ConGrp_1=elevator", "ConGrp_2=aileron", "ConGrp_3=rudder"];
        let fills = ["units=ft-slug-s", case];
        open(&["navion.stab"], &with(&[&fills[..], &groups[..]].concat()))
    };
    let waiting = open(&["navion.stab"], &[]);
    let labels = |review: &eigenwing::content::import::review::Review| -> Vec<String> {
        let field = review.fields.iter().find(|field| field.key == "case").expect("it is asked for");
        field.choices.iter().map(|choice| choice.words.clone()).collect()
    };
    assert_eq!(labels(&waiting), ["α −2°, C_L 0.14", "α 0°, C_L 0.3", "α 4°, C_L 0.41"]);
    // Of the mass that is typed follows the lift, and of the lift the case.
    let suggested = open_case("case=suggested");
    assert_eq!(
        suggested.fields.iter().find(|field| field.key == "case").and_then(|field| field.value.as_deref()),
        Some("3")
    );
    let review = open_case("case=3");
    for (plane, key) in [(Longitudinal, "cm_alphadot"), (Lateral, "cl_q")] {
        let mut expected = navion(plane, &[(key, 0.0)]);
        let found = model(&review, plane);
        // Inertia is typed about body axes, here 4° from those of the flow.
        expected.trim = found.trim;
        if plane == Longitudinal {
            assert_near(&found, &expected, 2e-5, 2e-5);
        }
    }
    // The derivatives, turned back, are those of the report, to the digits of the table.
    for (key, expected) in [
        ("Cl_beta", -0.074),
        ("Cn_beta", 0.0701),
        ("Cl_p", -0.41),
        ("Cn_p", -0.0575),
        ("Cl_r", 0.107),
        ("Cn_r", -0.125),
        ("CY_beta", -0.564),
        ("Cn_dr", -0.0717),
    ] {
        let found =
            review.read.iter().find(|read| read.key == key).and_then(|read| read.value).expect("it is read");
        assert!((found - expected).abs() < 2e-7, "{key}: {found}");
    }
}

#[test]
fn datcom_tables_are_read_per_degree_and_per_radian() {
    let by_radian = open(&["navion-datcom.out"], &with(&["case=2"]));
    let by_degree = open(&["navion-datcom-per-degree.out"], &with(&["case=2"]));
    let expected = navion(Longitudinal, &[]);
    for (review, share) in [(&by_radian, 1e-3), (&by_degree, 1e-3)] {
        let found = model(review, Longitudinal);
        for i in 0..4 {
            let size = expected.a.row(i).abs().max();
            // The tables have four digits.
            assert!(
                (found.a.row(i) - expected.a.row(i)).abs().max() <= share * size,
                "{} {}",
                found.a,
                expected.a
            );
        }
        let lateral = model(review, Lateral);
        let right = navion(Lateral, &[]);
        assert!((lateral.a - right.a).abs().max() <= 5e-3, "{} {}", lateral.a, right.a);
    }
    // CYB and CNB stand in the first row only.
    let of = |key: &str| by_radian.read.iter().find(|read| read.key == key).and_then(|read| read.value);
    assert_eq!([of("CY_beta"), of("Cn_beta"), of("Cl_beta")], [Some(-0.564), Some(0.0701), Some(-0.074)]);
    // NA is missing.
    let stalled = open(&["navion-datcom.out"], &with(&["case=4"]));
    assert!(stalled.fields.iter().any(|field| field.key == "Cm_alpha" && field.value.is_none()));
}

/// Twelve states in feet: airspeed and flow angles, heading, place and a height that thins the air a little.
#[test]
fn jsbsim_is_parted_into_both_planes_with_what_its_height_does() {
    for file in ["navion-linearisation.json", "navion.sce"] {
        let review = open(&[file], &[]);
        assert!(review.format.starts_with("jsbsim"));
        for plane in [Longitudinal, Lateral] {
            let (found, expected) = (model(&review, plane), navion(plane, &[]));
            assert!((found.a - expected.a).abs().max() < 1e-8, "{file}: {}", found.a - expected.a);
        }
        let told = |part: &str| review.remarks.iter().any(|remark| remark.contains(part));
        assert!(
            told("Alt (height) is kept as a state beside the four. With it alone the eigenvalue"),
            "{:#?}",
            review.remarks
        );
        assert!(
            told("Psi (heading) are kept as states beside the four: nothing else"),
            "{:#?}",
            review.remarks
        );
        assert!(
            told("The row of theta is 3.0e−9 off θ̇ = q, and was rounded to it."),
            "{:#?}",
            review.remarks
        );
        assert!(told("Controls count from −1 to 1 in JSBSim"), "{:#?}", review.remarks);
        // A travel of 0.5.
        assert!((model(&review, Longitudinal).b[(2, 0)] + 0.5 * 11.056677).abs() < 1e-5);
    }
}

#[test]
fn python_text_and_printed_arrays_are_read() {
    let expected = navion(Longitudinal, &[]);
    let script = open(&["navion.py"], &[]);
    let found = model(&script, Longitudinal);
    assert_eq!((found.a, found.b), (expected.a, expected.b));
    let printed = open(&["navion-printed-by-numpy.txt"], &["units=SI", "all=suggested"]);
    assert!((model(&printed, Longitudinal).a - expected.a).abs().max() < 1e-8);
}

/// δe as a state with a lag of 0.1 s, and V, γ in place of u, θ.
#[test]
fn a_control_with_a_lag_is_kept_and_path_angle_becomes_pitch_angle() {
    let text = "% units: SI\n% speed: 50\n% states: u alpha q theta de\n% inputs: elevator\n\
        A = [-0.05 4 0 -9.81 0; -0.007 -2 1 0 -0.16; 0 -8 -3 0 -11; 0 0 1 0 0; 0 0 0 0 -10];\nB = [0;0;0;0;10];\n";
    let file = eigenwing::content::import::FileBytes { name: "lag.m", bytes: text.as_bytes() };
    let review = eigenwing::content::import::review(&[file], &Default::default()).expect("it is read");
    assert_eq!(
        review.remarks[0],
        "de is a control, which follows its command with 0.100 s of lag: it is kept as a state beside the four."
    );
    assert_eq!(model(&review, Longitudinal).b[(2, 0)], -11.0);

    // θ = γ + α: γ̇ = θ̇ − α̇
    let by_path = "% units: SI\n% speed: 50\n% states: V gamma q alpha\n\
        A = [-0.05 -9.81 0 -5.81; 0.007 0 0 2; 0 0 -3 -8; -0.007 0 1 -2];\n";
    let file = eigenwing::content::import::FileBytes { name: "path.m", bytes: by_path.as_bytes() };
    let path = eigenwing::content::import::review(&[file], &Default::default()).expect("it is read");
    let [one, other] = [&review, &path].map(|review| poles(review, Longitudinal));
    assert!(
        one.iter().zip(&other).all(|(x, y): (&Complex<f64>, &Complex<f64>)| (x - y).norm() < 1e-9),
        "{one:?} {other:?}"
    );
}

#[test]
fn an_aircraft_of_a_file_is_the_same_to_the_last_bit_when_its_text_is_opened_again() {
    for (files, fills) in [
        (&["navion.sys"][..], &[][..]),
        (&["navion-linearisation.json"], &[]),
        (&["navion-xflr5.txt"], &[]),
        (&["navion.st", "navion.mass"], &["all=suggested"]),
        (&["12-vant-consistent.csv"], &[]),
    ] {
        let review = open(files, fills);
        let text = review.text().expect("it is ready");
        let file = eigenwing::content::import::FileBytes { name: "again.toml", bytes: text.as_bytes() };
        let again = eigenwing::content::import::review(&[file], &Default::default()).expect("it is read");
        assert_eq!(again.format, "aircraft-file");
        assert_eq!(
            import_files::aircraft(&again).aircraft_model,
            import_files::aircraft(&review).aircraft_model
        );
        assert_eq!(again.text().ok(), review.text().ok());
    }
}
