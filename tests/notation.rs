//! The notation in α and β: another name for the same motion. Its matrices are T A T⁻¹, its numbers those of the sliders, and what is
//! written of them is true.

use std::sync::Arc;

use eigenwing::content::{LengthUnit, embedded_aircraft};
use eigenwing::export::{DisturbanceRequest, Source, Subject, take_along};
use eigenwing::findings::Findings;
use eigenwing::findings::equations::{COLUMNS, ROWS, STATES};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Convention, Notation, Page, Parameter, Scenario, Units, link, parameters};
use eigenwing::words;
use nalgebra::{DMatrix, Matrix4};

mod every_plane;
mod franklin;

use every_plane::scenarios;

fn in_angles(scenario: &Scenario) -> Scenario {
    Scenario { notation: Notation::Angles, ..scenario.clone() }
}

fn set(scenario: &mut Scenario, key: &str, value: f64) {
    Parameter::find(key).expect("a row").set(scenario, value);
}

#[test]
fn the_matrices_are_those_of_the_angles_and_have_the_same_eigenvalues() {
    let mut compared = 0;
    for scenario in scenarios() {
        let findings = Findings::of(in_angles(&scenario));
        let Some(equations) = findings.equations() else { continue };
        let model = &findings.plane().expect("it is analysed").model;
        let v = model.trim.speed;
        let t = match scenario.plane {
            Plane::Longitudinal => DMatrix::from_diagonal(&[1.0, 1.0 / v, 1.0, 1.0].to_vec().into()),
            Plane::Lateral => DMatrix::from_diagonal(&[1.0 / v, 1.0, 1.0, 1.0].to_vec().into()),
        };
        let inverse = t.clone().try_inverse().expect("no speed is infinite");
        let (a, b) = (&t * model.a * inverse, &t * model.b);
        for row in 0..ROWS {
            for column in 0..COLUMNS {
                let expected = if column < STATES { a[(row, column)] } else { b[(row, column - STATES)] };
                let is = equations.value(row, column);
                assert!((is - expected).abs() <= 1e-14 * expected.abs(), "{row} {column}: {is}, {expected}");
            }
        }
        // Another solver, of the matrix as it is written.
        let written = Matrix4::from_fn(|row, column| equations.value(row, column));
        let eigenvalues = written.complex_eigenvalues();
        let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
        for mode in findings.modes() {
            let nearest =
                eigenvalues.iter().map(|value| (value - mode.lambda).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-6 * largest, "{} {}", scenario.aircraft.key, mode.lambda);
        }
        compared += 1;
    }
    assert!(compared > 25, "{compared}");
}

/// Franklin, Powell and Emami-Naeini print their example with β: from the model in v its numbers come back.
#[test]
fn a_printed_matrix_in_beta_comes_back() {
    let model = franklin::franklin();
    let speed = model.trim.speed;
    let convention = Convention {
        notation: Notation::Angles,
        speed: eigenwing::flight::aircraft::plane::ByPlane { longitudinal: 1.0, lateral: speed },
        ..Convention::SI
    };
    let entry = |row, column| model.a[(row, column)] * convention.of_entry(Plane::Lateral, row, column);
    // ṗ by β, ṙ by β, β̇ by r, β̇ by φ
    for (row, column, printed) in
        [(1, 0, -3.05), (2, 0, 0.598), (0, 2, -0.9968), (0, 3, 0.0415), (0, 0, -0.0558)]
    {
        assert!((entry(row, column) - printed).abs() < 1e-12, "{row} {column}");
    }
    let rudder = model.b[(0, 1)] * convention.of_entry(Plane::Lateral, 0, 5);
    assert!((rudder - 0.0073).abs() < 1e-15, "{rudder}");
}

#[test]
fn what_is_written_of_an_entry_gives_its_value_also_with_everything_moved() {
    let mut compared = 0;
    for mut scenario in scenarios() {
        for (key, value) in [
            ("z_wdot", 0.31),
            ("m_wdot", -0.02),
            ("x_q", 0.7),
            ("z_q", -3.0),
            ("y_p", 0.4),
            ("y_r", 0.9),
            ("a_uw", 0.2),
            ("a_wq", 70.0),
            ("b_w_de", -4.0),
        ] {
            set(&mut scenario, key, value);
        }
        let findings = Findings::of(in_angles(&scenario));
        let Some(equations) = findings.equations() else { continue };
        for (row, column) in (0..ROWS).flat_map(|row| (0..COLUMNS).map(move |column| (row, column))) {
            let Some(form) = equations.form(row, column) else { continue };
            let made = form.value(&|atom| equations.atom(findings.scenario(), atom)).expect("a value");
            let (made, is) = (made + equations.added(row, column), equations.value(row, column));
            let key = &scenario.aircraft.key;
            assert!((made - is).abs() <= 1e-12 * (1.0 + is.abs()), "{key} {row} {column}: {made} for {is}");
            compared += 1;
        }
    }
    assert!(compared > 20 * ROWS * COLUMNS, "{compared}");
}

/// A slider, its entry and the entry's unit are one, in both notations and all units.
#[test]
fn a_slider_of_the_matrix_has_the_number_and_the_unit_of_its_entry() {
    let mut compared = 0;
    for scenario in scenarios() {
        for notation in Notation::VALUES {
            for units in Units::VALUES {
                let shown = Scenario { notation: *notation, units: *units, ..scenario.clone() };
                let findings = Findings::of(shown.clone());
                let Some(equations) = findings.equations() else { continue };
                for (row, column) in (0..ROWS).flat_map(|row| (0..COLUMNS).map(move |column| (row, column))) {
                    let Some((parameter, sign)) = equations.slider(row, column) else { continue };
                    if !parameter.applies(&shown) {
                        continue;
                    }
                    let written = parameter.written(shown.convention());
                    let dimension = equations.dimension(row, column);
                    let length = shown.length_unit();
                    assert_eq!(written.unit, dimension.symbol(length), "{} {notation:?}", parameter.key);
                    let of_slider = sign * parameter.get(&shown) / written.in_si;
                    let of_entry = equations.value(row, column) / dimension.in_si(length);
                    assert!((of_slider - of_entry).abs() <= 1e-12 * of_entry.abs(), "{}", parameter.key);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

#[test]
fn a_typed_number_is_read_in_the_unit_that_is_shown() {
    let navion = scenarios().remove(0);
    for parameter in parameters().filter(|p| p.page == Some(Page::Dimensional)) {
        let mut scenario = in_angles(&navion);
        if !parameter.applies(&scenario) {
            continue;
        }
        let in_si = parameter.written(scenario.convention()).in_si;
        let wanted = 0.5 * parameter.range(&scenario).end();
        let value = parameter.parse(&scenario, &format!("{:e}", wanted / in_si)).expect("it is accepted");
        parameter.set(&mut scenario, value);
        let is = parameter.get(&scenario);
        assert!((is - wanted).abs() <= 1e-12 * wanted.abs(), "{}: {is} for {wanted}", parameter.key);
    }
}

/// Nelson, Flight Stability and Automatic Control, 2nd edition, examples 4.2 and 5.2: of the Navion he prints M_α = −8.8 1/s²
/// and N_β = 4.55 1/s².
#[test]
fn the_navion_has_nelsons_stiffness_in_angles() {
    let aircraft = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == "navion");
    let scenario = in_angles(&Scenario::new(Arc::new(aircraft.expect("the Navion"))));
    for (key, printed, tolerance) in [("m_w", -8.8, 0.1), ("n_v", 4.55, 0.1)] {
        let parameter = Parameter::find(key).expect("a row");
        let written = parameter.written(scenario.convention());
        let shown = parameter.get(&scenario) / written.in_si;
        assert_eq!(written.unit, "1/s²");
        assert!((shown - printed).abs() < tolerance, "{key}: {shown}");
    }
}

#[test]
fn a_link_carries_it_as_a_view_and_nothing_of_the_motion_changes() {
    let (aircraft, _) = embedded_aircraft();
    let aircraft: Vec<_> = aircraft.into_iter().map(Arc::new).collect();
    let opened = link::read("v=1&ac=navion&notation=alpha-beta", &aircraft).expect("a link");
    assert_eq!(opened.scenario.notation, Notation::Angles);
    assert!(opened.notices.is_empty());
    let written = link::write(&opened.scenario, &opened.view, None);
    assert!(written.contains("notation=alpha-beta"), "{written}");
    let plain = link::read("v=1&ac=navion", &aircraft).expect("a link").scenario;
    let lambdas = |scenario: &Scenario| -> Vec<_> {
        Findings::of(scenario.clone()).modes().iter().map(|mode| mode.lambda).collect()
    };
    assert_eq!(lambdas(&plain), lambdas(&opened.scenario));
}

#[test]
fn scripts_and_documents_name_the_angles_and_carry_their_numbers() {
    let text = |link: &str, target: &str| {
        let source = Source::Link(link.to_owned());
        let scene = Subject { source, ..Subject::listed("") }.scene().expect("a scene");
        take_along(&scene, target, &DisturbanceRequest::default()).expect("a file").text
    };
    let python = text("v=1&ac=navion&notation=alpha-beta", "python");
    assert!(python.contains(r#"states = ["u", "alpha", "q", "theta"]"#), "{python}");
    assert!(python.contains(words::notation::STATES));
    let latex = text("v=1&ac=navion&plane=lateral&notation=alpha-beta", "latex");
    assert!(latex.contains(r"\Delta \beta"), "{latex}");
    // Our own file of matrices stays in w and v, whatever a person looks at.
    let [plain, angles] = ["", "&notation=alpha-beta"].map(|notation| {
        let json = text(&format!("v=1&ac=navion{notation}"), "json");
        json.lines().filter(|line| !line.contains("notation=")).collect::<Vec<_>>().join("\n")
    });
    assert_eq!(plain, angles);
}

#[test]
fn sentences_speak_of_the_derivatives_that_are_shown() {
    for scenario in scenarios() {
        let shown = in_angles(&scenario);
        let findings = Findings::of(shown.clone());
        let Some(plane) = findings.plane() else { continue };
        let sentence = words::stability::static_sentence(plane, None, shown.convention());
        assert!(sentence.contains("1/s²") && !sentence.contains("M_w"), "{sentence}");
        let forgotten = ["X_w", "Z_w", "M_w", "M_ẇ", "Y_v", "L′_v", "N′_v"];
        for approximation in &plane.approximations {
            let told = [
                words::approximation::formula(approximation.name, Notation::Angles).to_owned(),
                words::approximation::neglects(approximation.name, Notation::Angles).into_owned(),
                words::approximation::name(approximation.name, Notation::Angles).to_owned(),
            ];
            for text in told {
                assert!(!forgotten.iter().any(|symbol| text.contains(symbol)), "{text}");
                assert!(!text.contains("(w,") && !text.contains("(v,"), "{text}");
            }
        }
    }
    let m_w = Parameter::find("m_w").expect("a row");
    let navion = in_angles(&scenarios().remove(0));
    assert_eq!(words::notation::of_slider(m_w, navion.convention()).as_deref(), Some("M_α = V M_w"));
    assert_eq!(words::notation::of_slider(m_w, Convention::SI), None);
    assert_eq!(Convention::SI.length, LengthUnit::Metre);
}
