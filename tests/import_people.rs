//! The same model as people write it down, copy it and change it: read to the last digit, or told why it isn't.

use std::collections::BTreeMap;

use eigenwing::content::import::review::Review;
use eigenwing::content::import::{FileBytes, review};
use eigenwing::content::{FILES, LengthUnit};
use eigenwing::export::{DisturbanceRequest, Source, Subject, take_along};
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::key::Keyed as _;
use nalgebra::Matrix4;

const ROWS: [[f64; 4]; 4] = [
    [-0.0451, 0.0362, 0.0, -9.80665],
    [-0.3695, -2.0232, 53.64, 0.0],
    [0.0063, -0.1639, -2.9857, 0.0],
    [0.0, 0.0, 1.0, 0.0],
];
const HEAD: &str = "% units: SI\n% speed: 53.64\n% states: u w q theta\n";
const A: &str = "[-0.0451 0.0362 0 -9.80665; -0.3695 -2.0232 53.64 0; 0.0063 -0.1639 -2.9857 0; 0 0 1 0]";

fn expected() -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| ROWS[i][j])
}

/// The rows with these signs between numbers and between rows.
fn rows(between: &str, behind: &str) -> String {
    ROWS.map(|row| row.map(|x| x.to_string()).join(between)).join(behind)
}

fn opened(name: &str, text: &str) -> Result<Review, String> {
    let fills = BTreeMap::from([("all".to_owned(), "suggested".to_owned())]);
    review(&[FileBytes { name, bytes: text.as_bytes() }], &fills).map_err(|error| error.to_string())
}

fn model(name: &str, text: &str, plane: Plane) -> PlaneModel {
    let found = opened(name, text).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
    let aircraft = found.aircraft().unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
    let models = aircraft.aircraft_model.models().unwrap_or_else(|error| panic!("{name}: {error}"));
    models.planes[plane].clone().unwrap_or_else(|| panic!("{name}: no {plane:?} model"))
}

fn told(name: &str, text: &str) -> String {
    let found = match opened(name, text) {
        Ok(found) => found,
        Err(error) => return error,
    };
    found.aircraft().map(|aircraft| aircraft.name).expect_err("it can't be used").to_string()
}

fn doubts(name: &str, text: &str) -> Vec<String> {
    opened(name, text).expect("it is read").doubts.iter().map(|doubt| doubt.told()).collect()
}

#[test]
fn forms_that_people_write_are_read_to_the_last_digit() {
    let b = "0\n-8.59\n-11.89\n0\n";
    let texts = [
        ("mat2str.txt", format!("{A}\n")),
        ("list.json", format!("[[{}]]", rows(",", "],["))),
        ("numpy.txt", format!("[[{}]]\n", rows(" ", "]\n ["))),
        ("sympy.txt", format!("Matrix([\n[{}]])\n", rows(", ", "],\n["))),
        ("sympy.py", format!("A = Matrix(4, 4, [{}])\n", rows(", ", ", "))),
        ("reshape.py", format!("A = np.array([{}]).reshape(4, 4)\n", rows(",", ","))),
        ("reshape-tuple.py", format!("A = np.array([[{}]]).reshape((4, 4))\n", rows(",", ","))),
        ("backslash.py", format!("A = np.array([[{}]])\n", rows(",", "], \\\n["))),
        ("glued.m", format!("A = [{}];\n", rows(" ", ";...\n"))),
        ("glued-numbers.m", format!("A = [{}];\n", rows("...\n ", ";"))),
        ("commas.m", format!("{HEAD}A = [{}];\n", rows(" ", ";\n")).replace('.', ",").replace("53,64\n", "53.64\n")),
        (
            "columns.m",
            "A =\n\n  Columns 1 through 3\n\n -0.0451 0.0362 0\n -0.3695 -2.0232 53.64\n 0.0063 -0.1639 -2.9857\n 0 0 1\n\n  Column 4\n\n \
             -9.80665\n 0\n 0\n 0\n"
                .to_owned(),
        ),
        ("below.txt", format!("{}\n\n{b}", rows(" ", "\n"))),
        ("below-flat.txt", format!("{}\n\n0 -8.59 -11.89 0\n", rows("\t", "\n"))),
        ("commented.txt", format!("{} % the row of theta\n", rows(" ", "\n"))),
        ("pipes.csv", format!("units|SI\nspeed|53.64\nu|w|q|theta\n{}\n", rows("|", "\n"))),
        ("labelled-pipes.csv", {
            let labels = ["u", "w", "q", "theta"];
            let row = |i: usize| format!("{}|{}", labels[i], ROWS[i].map(|x| x.to_string()).join("|"));
            format!("units|SI\nspeed|53.64\n|u|w|q|theta\n{}\n", [0, 1, 2, 3].map(row).join("\n"))
        }),
        ("excel.csv", format!("sep=;\nunits;SI\nspeed;53,64\nu;w;q;theta\n{}\n", rows(";", "\n")).replace('.', ",")),
        (
            "state-space.tex",
            format!(
                "\\[ \\dot{{\\mathbf{{x}}}} = \\begin{{bmatrix}} {} \\end{{bmatrix}}\\mathbf{{x}} + \\begin{{bmatrix}} 0 \\\\ -8.59 \\\\ -11.89 \\\\ 0 \
                 \\end{{bmatrix}} \\delta_e \\]\n",
                rows(" & ", " \\\\ ")
            ),
        ),
        (
            "vectors.tex",
            format!(
                "\\begin{{bmatrix}}\\dot u\\\\ \\dot w\\end{{bmatrix}} = \\begin{{bmatrix}} {} % as measured\n \
                 \\end{{bmatrix}}\\begin{{bmatrix}} u\\\\ w\\end{{bmatrix}}\n",
                rows(" & ", " \\\\ % a row\n")
            ),
        ),
        (
            "control.json",
            format!(
                "{{\"A\": [[{}]], \"B\": [[0],[-8.59],[-11.89],[0]], \"C\": [[1,0,0,0]], \"D\": [[0]], \"state_names\": [\"u\",\"w\",\"q\",\"theta\"],\n\
                 \"description\": \"from a report\"}}",
                rows(",", "],[")
            ),
        ),
        (
            "book.ipynb",
            format!(
                "{{\"cells\": [{{\"cell_type\": \"markdown\", \"source\": [\"A = what?\"]}}, {{\"cell_type\": \"code\", \"source\": [\"import numpy as np\\n\", \
                 \"A = np.array([[{}]])\"], \"outputs\": []}}], \"nbformat\": 4, \"metadata\": {{}}}}",
                rows(",", "],[")
            ),
        ),
        ("beside.m", format!("{HEAD}Alon = {A};\nC = [1 0 0 0;0 1 0 0;0 0 1 0;0 0 0 1];\nC(4, 4) = 0;\n")),
        ("changed-other.m", format!("{HEAD}A = {A};\nQ = [1 0 0; 0 1 0; 0 0 1];\nQ(1, 1) = 100;\nif A(1, 1) == 0, disp('x'), end\n")),
    ];
    for (name, text) in &texts {
        let model = model(name, text, Plane::Longitudinal);
        assert_eq!(model.a, expected(), "{name}");
        assert_eq!(model.trim.speed, 53.64, "{name}");
        let elevator = if text.contains("11.89") { -11.89 } else { 0.0 };
        assert_eq!(model.b[(2, 0)], elevator, "{name}");
    }
    assert_eq!(texts.len(), 24);
}

#[test]
fn rows_without_a_head_are_named_by_themselves() {
    let text = "beta -0.254 -1 0 0.1828\nr 4.495 -0.760 -0.350 0\np -15.98 2.19 -8.40 0\nphi 0 0 1 0\n";
    let found = model("rows.txt", &format!("% units: SI\n% speed: 53.64\n{text}"), Plane::Lateral);
    // v̇ = V β̇, in our order v, p, r, φ.
    assert!((found.a[(0, 2)] + 53.64).abs() < 1e-12 && (found.a[(1, 1)] + 8.4).abs() < 1e-12, "{}", found.a);
    // The same without any name: gravity in the row of β shows which plane it is.
    let bare = "% units: SI\n% speed: 53.64\nA = [-0.254 -1 0 0.1828; 4.495 -0.760 -0.350 0; -15.98 2.19 -8.40 0; 0 0 1 0];\n";
    assert!((model("bare.m", bare, Plane::Lateral).a - found.a).amax() < 1e-12);
}

#[test]
fn both_planes_of_a_script_are_one_aircraft() {
    let lateral = "[-0.254 0 -53.64 9.80665; -0.298 -8.40 2.19 0; 0.0838 -0.350 -0.760 0; 0 1 0 0]";
    let text = format!(
        "% units: SI\n% speed: 53.64\nA_lon = {A};\nB_lon = [0; -8.59; -11.89; 0];\nA_lat = {lateral};\nB_lat = [0 3.8; 28.98 2.55; -0.22 -4.6; 0 0];\n"
    );
    let longitudinal = model("both.m", &text, Plane::Longitudinal);
    assert_eq!((longitudinal.a, longitudinal.b[(2, 0)]), (expected(), -11.89));
    let lateral = model("both.m", &text, Plane::Lateral);
    assert_eq!((lateral.a[(1, 1)], lateral.b[(1, 0)], lateral.b[(2, 1)]), (-8.4, 28.98, -4.6));
    let remarks = opened("both.m", &text).expect("it is read").remarks.join("\n");
    assert!(remarks.contains("A_lon and A_lat are read as the two planes of one aircraft"), "{remarks}");
    // Two of the same plane are not.
    let twice = format!("{HEAD}A1 = {A};\nA2 = {A};\n");
    assert_eq!(
        told("twice.m", &twice),
        "twice.m, line 4: A1 and A2 could each be A; give the one that is meant the name A"
    );
}

#[test]
fn an_input_in_a_unit_of_its_own_counts_in_radians() {
    let table = |head: &str, b: [f64; 2]| {
        format!(
            "units,SI\nspeed,53.64\n,u,w,q,theta,{head}\nu,-0.0451,0.0362,0,-9.80665,0\nw,-0.3695,-2.0232,53.64,0,{}\nq,0.0063,-0.1639,-2.9857,0,{}\n\
             theta,0,0,1,0,0\n",
            b[0], b[1]
        )
    };
    for (head, factor) in
        [("elevator", 1.0), ("elevator [deg]", 180.0 / std::f64::consts::PI), ("elevator (rad)", 1.0)]
    {
        let found = model("a.csv", &table(head, [-0.15, -0.2]), Plane::Longitudinal);
        assert!((found.b[(2, 0)] + 0.2 * factor).abs() < 1e-12, "{head}: {}", found.b);
    }
    let found = model("a.csv", &table("throttle [%]", [-0.15, -0.2]), Plane::Longitudinal);
    assert!((found.b[(2, 1)] + 20.0).abs() < 1e-12, "{}", found.b);
}

#[test]
fn a_control_with_a_row_of_its_own_is_a_state() {
    let text = "units,SI\nspeed,53.64\n,u,w,q,theta,de,elevator\nu,-0.0451,0.0362,0,-9.80665,0,0\nw,-0.3695,-2.0232,53.64,0,-8.59,0\n\
                q,0.0063,-0.1639,-2.9857,0,-11.89,0\ntheta,0,0,1,0,0,0\nde,0,0,0,0,-10,10\n";
    let found = model("lag.csv", text, Plane::Longitudinal);
    let further = found.further.as_ref().expect("a state beside the four");
    assert_eq!(further.states.len(), 1);
    assert_eq!(found.a, expected());
}

#[test]
fn what_was_changed_or_disagrees_is_told_with_its_line() {
    let script = |rest: &str| format!("{HEAD}A = {A};\n{rest}\n");
    let changed = "is changed here after it was given; nothing is computed, so give it as it is in the end";
    for (name, text, line, sentence) in [
        ("entry.m", script("A(3,2) = -0.5;"), 5, format!("A {changed}")),
        ("rows.m", script("x = 1;\nA([1 2], :) = [1 2 3 4; 5 6 7 8];"), 6, format!("A {changed}")),
        ("entry.py", script("A[2,1] = -0.5"), 5, format!("A {changed}")),
        ("scaled.py", script("A *= 2"), 5, format!("A {changed}")),
        ("speed.m", script("V = 60; V *= 2;"), 5, format!("V {changed}")),
        ("stranger.m", format!("{HEAD}F = {A};\nF(1,1) = 3;\n"), 5, format!("F {changed}")),
        (
            "order.txt",
            "        v      p     r    phi\nv  -0.254  0  -53.64 9.80665\nr  0.0838 -0.350 -0.760 0\np  -0.298 -8.40 2.19 0\nphi 0 1 0 0\n".to_owned(),
            3,
            "expected the row of p here, in the order of the columns, found that of r".to_owned(),
        ),
        (
            "two.txt",
            format!("{0}\n\n{0}\n", rows(" ", "\n")),
            6,
            "expected the rows of A and, below them, those of B; these are two square matrices: give each its name, A = […]".to_owned(),
        ),
        (
            "points.m",
            "A = [1.2.3 4];\n".to_owned(),
            1,
            "expected a number, found \"1.2.3\"".to_owned(),
        ),
        ("cases.json", format!("[{{\"A\": [[{}]]}}]", rows(",", "],[")), 1, "this is a list of several models; open one of them, an object with \"A\"".to_owned()),
        (
            "slip.json",
            "{\"spede\": 30}".to_owned(),
            1,
            "\"spede\" is no key known here; expected units, angles, speed or u0, alpha0_deg, gamma0_deg, name, states, inputs, A and B".to_owned(),
        ),
        (
            "flat.json",
            "{\"A\": [1.5, 2]}".to_owned(),
            1,
            "invalid type: floating point `1.5`, expected a list".to_owned(),
        ),
        (
            "short.py",
            "A = np.array([1, 2, 3]).reshape(2, 2)\n".to_owned(),
            1,
            "A: expected 2 rows of 2 numbers, found 3 numbers".to_owned(),
        ),
        (
            "theta.m",
            script("").replace("0 0 1 0]", "0 0 57.3 0]"),
            4,
            "A: row of theta: expected 1 for q and 0 for u, w and theta, for pitch rate is the rate of pitch angle; is the order of the states right?".to_owned(),
        ),
    ] {
        assert_eq!(told(name, &text), format!("{name}, line {line}: {sentence}"));
    }
}

#[test]
fn a_speed_in_knots_and_a_wrong_sign_are_named() {
    let with =
        |speed: &str, a: &str| format!("% units: SI\n% speed: {speed}\n% states: u w q theta\nA = {a};\n");
    assert_eq!(doubts("right.m", &with("53.64", A)), [""; 0]);
    for (speed, words, mended) in [
        ("104.27", "knots", "53.6411"),
        ("120", "miles an hour", "53.6448"),
        ("193.1", "kilometres an hour", "53.6389"),
        ("176", "feet a second", "53.6448"),
    ] {
        let found = doubts("speed.m", &with(speed, A));
        let [sentence] = found.as_slice() else { panic!("{speed}: {found:?}") };
        assert!(
            sentence.ends_with(&format!(": the speed is in {words}. It would fit with speed={mended}.")),
            "{sentence}"
        );
    }
    let turned = doubts("gravity.m", &with("53.64", &A.replace("-9.80665", "9.80665")));
    let [sentence] = turned.as_slice() else { panic!("{turned:?}") };
    assert_eq!(
        *sentence,
        "A(u, θ) is 9.807 m/s², where −g cos θ₀ is −9.807 m/s², and A(w, q) is 53.64 m/s, where U₀ is 53.64 m/s: A(u, θ) has the wrong sign. \
         Here x points forward, y to the right and z down; turn the states that count the other way."
    );
}

/// Rounding is never shown as a number: a motion without damping has none.
#[test]
fn eigenvalues_that_are_zero_but_for_rounding_are_zero() {
    let found = opened(
        "undamped.m",
        &format!("{HEAD}A = [0 0.02 0 -9.80665; -0.4 -2 53.64 0; 0 0 -3 0; 0 0 1 0];\n"),
    )
    .expect("it is read");
    let values = &found.eigenvalues[0].values;
    let least = values
        .iter()
        .flatten()
        .copied()
        .filter(|part| *part != 0.0)
        .map(f64::abs)
        .fold(f64::INFINITY, f64::min);
    assert!(least > 1e-6, "{values:?}");
}

/// What is taken along can be brought back, from a paper too, to the digits that stand in it.
#[test]
fn scripts_notebooks_and_papers_of_this_program_are_read_again() {
    let mut compared = 0;
    for (file, _) in FILES {
        for plane in Plane::ALL {
            let link = format!("#v=1&ac={}&plane={}", file.trim_end_matches(".toml"), plane.key());
            let scene = Subject { source: Source::Link(link.clone()), ..Subject::listed("") }
                .scene()
                .expect("a scene");
            let models = scene.scenario.aircraft.aircraft_model.models().expect("it flies");
            let Some(flown) = &models.planes[plane] else { continue };
            for (target, name, digits) in [
                ("python", "a.py", 1e-15),
                ("matlab", "a.m", 1e-15),
                ("notebook", "a.ipynb", 1e-15),
                ("latex", "a.tex", 5e-4),
            ] {
                // The lesson's matrix is in hundreds of feet, which no file can say.
                if target == "latex" && scene.scenario.length_unit() == LengthUnit::HundredFeet {
                    continue;
                }
                let text = take_along(&scene, target, &DisturbanceRequest::default()).expect("a file").text;
                let again = model(name, &text, plane);
                let off =
                    (again.a - flown.a).zip_map(&flown.a, |off, a| off.abs() / a.abs().max(1e-6)).amax();
                assert!(off <= digits, "{link} {target}: {off}\n{}\n{}", again.a, flown.a);
                compared += 1;
            }
        }
    }
    assert!(compared > 100, "{compared}");
}
