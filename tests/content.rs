//! Aircraft files: all read, a bad one says where and why, and nothing that a person can paste makes a panic.

use eigenwing::content::{Aircraft, FILES, embedded_aircraft};
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::derivatives::{LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES};
use eigenwing::flight::aircraft::plane::PlaneModel;
use eigenwing::flight::modes::eigen::eigen;
use proptest::prelude::*;

fn text_of(file: &str) -> &'static str {
    FILES.iter().find(|(name, _)| *name == file).expect("the file ships").1
}

fn planes(aircraft: &Aircraft) -> Vec<PlaneModel> {
    let models = aircraft.aircraft_model.models().expect("a file that reads has a steady flight");
    assert!(models.problems.is_empty());
    models.planes.longitudinal.into_iter().chain(models.planes.lateral).collect()
}

#[test]
fn every_file_reads() {
    let (aircraft, errors) = embedded_aircraft();
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(aircraft.len(), FILES.len());
    for one in &aircraft {
        assert!(planes(one).iter().all(|model| eigen(&model.a).is_ok()), "{}", one.key);
        assert!(one.speed() > 0.0);
    }
}

#[test]
fn every_asset_is_in_the_list_under_its_own_key() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/aircraft");
    let mut on_disk: Vec<String> = std::fs::read_dir(folder)
        .expect("the folder is there")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    let mut listed: Vec<String> = FILES.iter().map(|(file, _)| (*file).to_owned()).collect();
    on_disk.sort();
    listed.sort();
    assert_eq!(on_disk, listed);
    for (file, text) in FILES {
        let aircraft = Aircraft::from_toml(file, text).expect("it reads");
        assert_eq!(format!("{}.toml", aircraft.key), file);
    }
}

/// Replaces `from` by `to` in a file and returns the error's line, the line of `at`, and the whole message.
fn broken(file: &str, from: &str, to: &str, at: &str) -> (usize, usize, String) {
    let text = text_of(file);
    assert!(text.contains(from), "{file} has no {from:?}");
    let text = text.replacen(from, to, 1);
    let wanted = text.lines().position(|line| line.starts_with(at)).expect("the place is there") + 1;
    let error = Aircraft::from_toml("mine.toml", &text).expect_err(&format!("{from:?} → {to:?} must fail"));
    assert_eq!(error.file, "mine.toml");
    (error.line, wanted, error.to_string())
}

#[test]
fn a_malformed_file_names_file_line_field_and_what_was_expected() {
    let b747 = "b747-approach.toml";
    for (file, from, to, at, words) in [
        (
            b747,
            "CL_alpha = 5.7",
            "CL_alpha = \"5.7\"",
            "CL_alpha",
            "longitudinal.CL_alpha: expected a number, found a text",
        ),
        (b747, "CL_alpha = 5.7", "CL_alpha = nan", "CL_alpha", "expected a finite number"),
        (b747, "Cm_q = -20.8\n", "", "[longitudinal]", "longitudinal.Cm_q: missing; expected a number"),
        (
            b747,
            "Cm_q = -20.8",
            "Cm_qq = -20.8\nCm_q = -20.8",
            "Cm_qq",
            "longitudinal.Cm_qq: not a field of this table; expected: ",
        ),
        (
            b747,
            "rates = \"c/2V\"",
            "rates = \"c/3V\"",
            "rates",
            "rates: expected \"c/2V\" or \"c/V\", found \"c/3V\"",
        ),
        (b747, "angles = \"rad\"", "angles = \"deg\"", "angles", "angles: expected \"rad\""),
        (b747, "axes = \"stability\"", "axes = \"body\"", "axes", "axes: expected \"stability\""),
        (
            b747,
            "units = \"ft-slug-s\"",
            "units = 3",
            "units",
            "units: expected \"SI\" or \"ft-slug-s\", found a number",
        ),
        (
            b747,
            "speed = 279.1",
            "speed = -279.1",
            "speed",
            "flight.speed: expected a positive number, found -279.1",
        ),
        (
            b747,
            "speed = 279.1",
            "speed = 179.1",
            "CL = ",
            "longitudinal.CL: 1.108 does not carry the weight; expected about 2.69",
        ),
        (
            b747,
            "gravity = 32.174",
            "gravity = 9.81",
            "gravity",
            "flight.gravity: expected free fall in the file's own unit",
        ),
        (
            b747,
            "altitude = 0.0",
            "altitude = 90000",
            "altitude",
            "the altitude of 27432 m is outside the standard atmosphere",
        ),
        (
            b747,
            "weight = 564032.0",
            "weight = 0",
            "weight",
            "airframe.weight: expected a positive number, found 0",
        ),
        (
            b747,
            "Ixz = -2230000.0",
            "Ixz = 26e6",
            "Ixz",
            "airframe.Ixz: Ixz is 3.5251e7 kg m², but no body has |Ixz| ≥",
        ),
        (b747, "S = 5500.0", "S = inf", "S", "airframe.S: expected a finite number, found inf"),
        (b747, "[airframe]", "[airfame]", "#", "airframe: missing; expected a table [airframe]"),
        (
            b747,
            "mach = [0.15, 0.4]",
            "mach = [0.3, 0.4]",
            "mach = [",
            "validity.mach: expected two numbers around the flight's own Mach number 0.250",
        ),
        (
            b747,
            "mode = \"phugoid\"",
            "mode = \"fugoid\"",
            "mode = \"fugoid\"",
            "expected \"short period\" or \"phugoid\"",
        ),
        (
            b747,
            "key = \"b747-approach\"",
            "key = \"B 747\"",
            "key",
            "key: expected small letters, digits and hyphens",
        ),
        (
            b747,
            "class = \"III\"",
            "class = \"V\"",
            "class",
            "class: expected \"I\" or \"II\" or \"II-C\" or \"III\" or \"IV\", found \"V\"",
        ),
        (
            b747,
            "name = \"Boeing 747, approach\"",
            "name = \" \"",
            "name",
            "name: expected a text, found an empty one",
        ),
        (
            "cessna-172.toml",
            "status = \"unverified\"",
            "status = \"verified\"",
            "status",
            "longitudinal.status: \"verified\" needs published modes",
        ),
        (
            "a4d.toml",
            "form = \"primed\"",
            "form = \"double\"",
            "form",
            "lateral.form: expected \"primed\" or \"unprimed\"",
        ),
        ("a4d.toml", "Lbeta = -29.71\n", "", "[lateral]", "lateral.Lv: missing; expected a number"),
        (
            "a4d.toml",
            "alpha0_deg = 4.7",
            "alpha0_deg = 47",
            "alpha0_deg",
            "expected an angle of attack between −28° and 28°",
        ),
        ("lesson.toml", "u0 = 1.76", "u0 = 0", "u0", "longitudinal.u0: expected a positive number, found 0"),
        (
            "lesson.toml",
            "[0.0, 0.0, 1.0, 0.0]",
            "[0.0, 0.0, 2.0, 0.0]",
            "a = [",
            "the last row of A must be 0, 0, 1, 0",
        ),
        (
            "lesson.toml",
            "    [0.0, 0.0, 1.0, 0.0],\n",
            "",
            "a = [",
            "longitudinal.a: expected four rows of four numbers, found 3 rows",
        ),
        (
            "lesson.toml",
            "\"100 ft\"\n",
            "\"furlong\"\n",
            "length_unit",
            "length_unit: expected \"m\" or \"ft\" or \"100 ft\"",
        ),
    ] {
        let (line, wanted, message) = broken(file, from, to, at);
        assert!(message.contains(words), "{message}\nshould say\n{words}");
        assert_eq!(line, wanted, "{message}");
    }
}

#[test]
fn numbers_may_be_written_in_any_way_that_toml_has() {
    let text = text_of("b747-approach.toml");
    let other = text
        .replace("weight = 564032.0", "weight = 564_032")
        .replace("Ix = 14300000.0", "Ix = +14.3e6")
        .replace("S = 5500.0", "S = 0x157C");
    assert_ne!(text, other);
    let (a, b) = (Aircraft::from_toml("a", text), Aircraft::from_toml("b", &other));
    assert_eq!(a.expect("it reads"), b.expect("it reads too"));
}

#[test]
fn bad_toml_is_an_error_with_its_line() {
    let error = Aircraft::from_toml("mine.toml", "key = \"x\"\nname = = 3\n").expect_err("not TOML");
    assert_eq!((error.file.as_str(), error.line), ("mine.toml", 2));
    assert!(Aircraft::from_toml("empty.toml", "").is_err());
}

/// The number after `key = `, and the line with that number times `factor`.
fn scaled(line: &str, factor: f64) -> Option<String> {
    let (key, value) = line.split_once(" = ")?;
    let value: f64 = value.parse().ok()?;
    Some(format!("{key} = {:e}", value * factor))
}

/// A file in feet and slugs rewritten in SI, number by number.
fn in_si(text: &str) -> String {
    let (ft, lbf) = (0.3048_f64, 4.448_221_615_260_5);
    let power_of = |key: &str| {
        let longitudinal = LONGITUDINAL_DERIVATIVES.iter().map(|row| (row.field.key, row.length_power));
        let lateral = LATERAL_DERIVATIVES.iter().map(|row| (row.field.key, row.length_power));
        longitudinal.chain(lateral).find(|(known, _)| *known == key).map(|(_, power)| power)
    };
    let mut section = "";
    let mut lines = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            section = line;
        }
        let key = line.split(" = ").next().unwrap_or_default();
        let factor = match (section, key) {
            ("[flight]", "altitude" | "speed" | "gravity") => ft,
            ("[flight]", "density") => lbf / ft.powi(4),
            ("[airframe]", "b" | "c") => ft,
            ("[airframe]", "S") => ft * ft,
            ("[airframe]", "weight") => lbf,
            ("[airframe]", "Ix" | "Iy" | "Iz" | "Ixz") => lbf * ft,
            ("[longitudinal]" | "[lateral]", key) => ft.powi(power_of(key).unwrap_or(0)),
            _ => 1.0,
        };
        if line.starts_with("tail =") || line.starts_with("fin =") {
            continue; // only for the knobs
        }
        lines.push(scaled(line, factor).unwrap_or_else(|| line.to_owned()));
    }
    lines.join("\n").replace("units = \"ft-slug-s\"", "units = \"SI\"")
}

#[test]
fn the_same_aircraft_in_feet_and_in_metres_has_the_same_matrices() {
    let mut count = 0;
    for (file, text) in FILES.iter().filter(|(_, text)| text.contains("units = \"ft-slug-s\"")) {
        let (us, si) = (Aircraft::from_toml(file, text), Aircraft::from_toml(file, &in_si(text)));
        let (us, si) = (us.expect("it reads"), si.expect("it reads in SI"));
        for (us, si) in planes(&us).iter().zip(planes(&si)) {
            for (x, y) in us.a.iter().chain(&us.b).zip(si.a.iter().chain(&si.b)) {
                assert!((x - y).abs() <= 1e-10 * y.abs().max(1e-6), "{file}: {x} and {y}");
            }
        }
        count += 1;
    }
    assert!(count >= 12);
}

#[test]
fn the_units_of_the_matrix_change_no_eigenvalue() {
    // A_US = T⁻¹ A T with T = diag(0.3048, …)
    for (file, text) in FILES {
        for model in planes(&Aircraft::from_toml(file, text).expect("it reads")) {
            let lengths = match model.plane {
                eigenwing::flight::aircraft::plane::Plane::Longitudinal => [0.3048, 0.3048, 1.0, 1.0],
                eigenwing::flight::aircraft::plane::Plane::Lateral => [0.3048, 1.0, 1.0, 1.0],
            };
            let us = nalgebra::Matrix4::from_fn(|i, j| model.a[(i, j)] / lengths[i] * lengths[j]);
            let (si, us) = (eigen(&model.a).expect("it solves"), eigen(&us).expect("it solves"));
            for (x, y) in si.values.iter().zip(&us.values) {
                assert!((x - y).norm() <= 1e-9 * y.norm().max(1e-3), "{file}: {x} and {y}");
            }
        }
    }
}

#[test]
fn rates_with_c_over_v_are_half_as_large() {
    let text = text_of("b747-approach.toml");
    let halved = text
        .replace("rates = \"c/2V\"", "rates = \"c/V\"")
        .replace("CL_alphadot = 6.7", "CL_alphadot = 3.35")
        .replace("Cm_alphadot = -3.2", "Cm_alphadot = -1.6")
        .replace("CL_q = 5.4", "CL_q = 2.7")
        .replace("Cm_q = -20.8", "Cm_q = -10.4");
    let (a, b) = (Aircraft::from_toml("a", text), Aircraft::from_toml("b", &halved));
    assert_eq!(a.expect("it reads").aircraft_model, b.expect("it reads").aircraft_model);
}

fn check(text: &str) {
    if let Ok(aircraft) = Aircraft::from_toml("mutated.toml", text) {
        let models = aircraft.aircraft_model.models();
        let models = models.expect("a file is only read when it has a steady flight");
        for model in models.planes.longitudinal.iter().chain(&models.planes.lateral) {
            assert!(model.a.iter().chain(&model.b).all(|x| x.is_finite()));
        }
        assert!(
            matches!(aircraft.aircraft_model, AircraftModel::Matrices(_))
                || aircraft.particulars.speed.is_some()
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_changed_byte_makes_a_panic(file in 0..FILES.len(), at: prop::sample::Index, byte: u8) {
        let mut bytes = FILES[file].1.as_bytes().to_vec();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        check(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_changed_digit_makes_a_panic(file in 0..FILES.len(), at: prop::sample::Index, byte in "[-0-9e.+]") {
        let mut bytes = FILES[file].1.as_bytes().to_vec();
        let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        bytes[digits[at.index(digits.len())]] = byte.as_bytes()[0];
        check(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_missing_end_makes_a_panic(file in 0..FILES.len(), at: prop::sample::Index) {
        let bytes = FILES[file].1.as_bytes();
        check(&String::from_utf8_lossy(&bytes[..at.index(bytes.len())]));
    }

    #[test]
    fn no_text_makes_a_panic(text in any::<String>()) {
        check(&text);
    }
}

/// The list tells what an aircraft is and how it flies; what becomes of its modes is for a student to find.
#[test]
fn names_and_flight_conditions_give_no_answer_away() {
    for aircraft in embedded_aircraft().0 {
        let told = format!("{} {}", aircraft.name, aircraft.condition).to_lowercase();
        for answer in
            ["diverge", "damp", "stable", "tuck", "spiral", "phugoid", "period", "roll", "gravity as"]
        {
            assert!(!told.contains(answer), "{told}");
        }
    }
}
