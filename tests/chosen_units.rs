//! The units that a person has chosen hold in what is taken along for people: LaTeX, data as CSV, the pictures of scripts. What a script
//! computes with stays SI.

use std::collections::BTreeMap;
use std::sync::Arc;

use eigenwing::content::import::{FileBytes, review};
use eigenwing::export::{DisturbanceRequest, Source, Subject, Target, take_along};
use eigenwing::findings::Findings;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::Scenario;

const FOOT: f64 = 0.3048;

fn text(link: &str, target: Target) -> String {
    let subject = Subject { source: Source::Link(link.to_owned()), ..Subject::listed("") };
    let scene = subject.scene().expect("a scene");
    assert!(scene.notices.is_empty(), "{link}: {:?}", scene.notices);
    take_along(&scene, target.key(), &DisturbanceRequest::default()).expect("it is taken along").text
}

/// The matrix of this name in LaTeX, every digit of it, out of the comments behind its rows.
fn matrix(latex: &str, name: &str) -> Vec<Vec<f64>> {
    let (_, rest) = latex.split_once(&format!("\n{name} = \\begin{{bmatrix}}\n")).expect("the matrix");
    let (rows, _) = rest.split_once("\\end{bmatrix}").expect("its end");
    let numbers = |row: &str| -> Vec<f64> {
        let (_, digits) = row.split_once(" % ").expect("every digit");
        digits.split(", ").map(|digits| digits.parse().expect("a number")).collect()
    };
    rows.lines().map(numbers).collect()
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{found} for {expected}");
}

#[test]
fn latex_in_feet_is_the_same_motion_and_reads_back_to_the_same_eigenvalues() {
    let latex = text("#v=1&ac=navion&units=ft", Target::Latex);
    let (a, b) = (matrix(&latex, "A"), matrix(&latex, "B"));
    // −g of its source, 32.174 ft/s².
    assert!((a[0][3] + 32.174).abs() < 1e-12 && latex.contains(" & -32.17 \\\\ % "), "{latex}");
    assert!(latex.contains("Units: ft/s, rad/s and rad"), "{latex}");
    let rows = |matrix: &[Vec<f64>]| {
        let row = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
        matrix.iter().map(row).collect::<Vec<_>>().join("; ")
    };
    let file = format!(
        "% units: ft-slug-s\n% speed: 176\n% states: u w q theta\n% inputs: elevator throttle\nA = [{}];\nB = [{}];\n",
        rows(&a),
        rows(&b)
    );
    let fills = BTreeMap::from([("all".to_owned(), "suggested".to_owned())]);
    let found =
        review(&[FileBytes { name: "navion.m", bytes: file.as_bytes() }], &fills).expect("it is read");
    let read = found.aircraft().expect("nothing is missing");
    let again = Findings::of(Scenario::new(Arc::new(read)));
    let shipped = Findings::of(Subject::listed("navion").scenario().expect("it ships"));
    assert_eq!((again.modes().len(), shipped.modes().len()), (2, 2));
    for (read, ours) in again.modes().iter().zip(shipped.modes()) {
        assert!((read.lambda - ours.lambda).norm() < 1e-12, "{} for {}", read.lambda, ours.lambda);
        assert_eq!(read.naming.name, ours.naming.name);
    }
    let model = |findings: &Findings| findings.plane().expect("it is analysed").model.clone();
    assert!((model(&again).b - model(&shipped).b).amax() < 1e-12);
}

/// x̃ = T x: Ã = T A T⁻¹ and B̃ = T B, in both planes and both notations.
#[test]
fn every_entry_of_latex_has_the_chosen_unit() {
    let speed = 53.6448;
    for (link, of_state, units) in [
        ("#v=1&ac=navion", [FOOT, FOOT, 1.0, 1.0], "ft/s, rad/s and rad"),
        ("#v=1&ac=navion&plane=lateral", [FOOT, 1.0, 1.0, 1.0], "ft/s, rad/s and rad"),
        ("#v=1&ac=navion&notation=alpha-beta", [FOOT, speed, 1.0, 1.0], "ft/s, rad/s and rad"),
        ("#v=1&ac=navion&notation=alpha-beta&plane=lateral", [speed, 1.0, 1.0, 1.0], "rad/s and rad"),
    ] {
        let si = text(&format!("{}&units=si", link.replace("&notation=alpha-beta", "")), Target::Latex);
        let chosen = text(&format!("{link}&units=ft"), Target::Latex);
        assert!(chosen.contains(&format!("Units: {units}; a throttle")), "{chosen}");
        let [(a, b), (a_si, b_si)] = [&chosen, &si].map(|text| (matrix(text, "A"), matrix(text, "B")));
        for i in 0..4 {
            for j in 0..4 {
                close(a[i][j], a_si[i][j] * of_state[j] / of_state[i]);
            }
            for j in 0..2 {
                close(b[i][j], b_si[i][j] / of_state[i]);
            }
        }
    }
}

fn table(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect::<Vec<_>>();
    let head = cells(reader.headers().expect("a head"));
    (head, reader.records().map(|record| cells(&record.expect("a row"))).collect())
}

/// Each column in feet is that in SI over 0.3048, the others are the same to the last bit.
fn compare(link: &str, target: Target, in_feet: &[(&str, &str, f64)]) {
    let (si_head, si) = table(&text(link, target));
    let (head, rows) = table(&text(&format!("{link}&units=ft"), target));
    assert_eq!((si_head.len(), si.len()), (head.len(), rows.len()));
    let (mut changed, mut numbers) = (Vec::new(), 0);
    for column in 0..head.len() {
        let factor = if head[column] == si_head[column] {
            None
        } else {
            let (_, _, factor) = *in_feet
                .iter()
                .find(|(before, after, _)| {
                    (*before, *after) == (si_head[column].as_str(), head[column].as_str())
                })
                .unwrap_or_else(|| panic!("{} became {}", si_head[column], head[column]));
            changed.push(&head[column]);
            numbers += si.iter().filter(|row| !row[column].is_empty()).count();
            Some(factor)
        };
        for (row, si) in rows.iter().zip(&si) {
            match factor {
                Some(_) if si[column].is_empty() => assert_eq!(row[column], ""),
                None => assert_eq!(row[column], si[column], "{}", head[column]),
                Some(factor) => close(
                    row[column].parse().expect("a number"),
                    si[column].parse::<f64>().expect("a number") * factor,
                ),
            }
        }
    }
    assert_eq!(changed.len(), in_feet.len(), "{head:?}");
    assert!(numbers > 20 * in_feet.len(), "{numbers}");
}

#[test]
fn data_have_the_chosen_units_in_their_heads_and_numbers() {
    compare(
        "#v=1&ac=navion&lon.source=vertical-gust",
        Target::Response,
        &[
            ("w_gust [m/s]", "w_gust [ft/s]", 1.0 / FOOT),
            ("u [m/s]", "u [ft/s]", 1.0 / FOOT),
            ("w [m/s]", "w [ft/s]", 1.0 / FOOT),
            ("x [m]", "x [ft]", 1.0 / FOOT),
            ("h [m]", "h [ft]", 1.0 / FOOT),
        ],
    );
    compare(
        "#v=1&ac=navion&lon.frequency_of=h",
        Target::Frequency,
        &[("gain of h by elevator [m per rad]", "gain of h by elevator [ft per rad]", 1.0 / FOOT)],
    );
    compare(
        "#v=1&ac=navion&lon.source=vertical-gust&lon.frequency_of=alpha",
        Target::Frequency,
        &[("gain of alpha by w_gust [rad per m/s]", "gain of alpha by w_gust [rad per ft/s]", FOOT)],
    );
    compare(
        "#v=1&ac=navion&lon.over=speed&lon.chart=parameter.m_w",
        Target::Chart,
        &[
            ("speed [m/s]", "speed [ft/s]", 1.0 / FOOT),
            ("parameter.m_w [1/(m·s)]", "parameter.m_w [1/(ft·s)]", FOOT),
        ],
    );
    // Nobody has chosen: the source is in feet, data are in SI.
    let (head, _) = table(&text("#v=1&ac=navion", Target::Response));
    assert!(head.contains(&"u [m/s]".to_owned()), "{head:?}");
}

#[test]
fn the_numbers_of_an_aircraft_and_of_a_motion_have_the_unit_that_stands_beside_them() {
    for (target, unit, numbers) in [(Target::Derivatives, 6, 4..6), (Target::Metrics, 1, 2..3)] {
        let link = "#v=1&ac=navion&lon.source=release&speed=60";
        let (_, si) = table(&text(link, target));
        let (_, feet) = table(&text(&format!("{link}&units=ft"), target));
        let mut changed = 0;
        for (row, si) in feet.iter().zip(&si) {
            let factor = match (si[unit].as_str(), row[unit].as_str()) {
                ("m" | "m/s" | "m/s²", "ft" | "ft/s" | "ft/s²") => 1.0 / FOOT,
                ("1/m" | "1/(m·s)", "1/ft" | "1/(ft·s)") => FOOT,
                (before, after) => {
                    assert_eq!(before, after, "{}", row[0]);
                    1.0
                }
            };
            changed += usize::from(factor != 1.0);
            for k in numbers.clone().filter(|&k| !si[k].is_empty()) {
                let number = |cell: &str| cell.parse::<f64>().expect("a number");
                close(number(&row[k]), number(&si[k]) * factor);
            }
        }
        assert!(changed >= 3, "{}: {changed}", target.key());
    }
}

/// A script computes in SI, so that its comparison with our numbers is one of the same numbers; it draws in the units of the page.
#[test]
fn scripts_compute_in_si_and_draw_in_the_chosen_units() {
    let link = "#v=1&ac=navion&lon.show=u.theta.h";
    let script = |units: &str| text(&format!("{link}&units={units}"), Target::Python);
    let (si, feet) = (script("si"), script("ft"));
    assert!(si.contains("(\"forward speed\", \"m/s\", 1)") && si.contains("(\"height gained\", \"m\", 1)"));
    assert!(feet.contains("(\"forward speed\", \"ft/s\", 3.28083989501312"), "{feet}");
    assert!(feet.contains("(\"height gained\", \"ft\", 3.28083989501312"), "{feet}");
    let matrices = |script: &str| {
        let (_, rest) = script.split_once("A = np.array(").expect("A");
        rest.split_once("aircraft = ").expect("the model").0.to_owned()
    };
    assert_eq!(matrices(&si), matrices(&feet));
    assert!(text(&format!("{link}&units=ft"), Target::Matlab).contains("'forward speed [ft/s]'"));
    assert_eq!(
        text(&format!("{link}&units=ft"), Target::Json),
        text(&format!("{link}&units=si"), Target::Json)
    );
}
