//! Published modes of every aircraft, each with its source in the aircraft's file (validation).
//!
//! `UPDATE_VALIDATION=1 cargo test --no-default-features --test textbook` writes docs/VALIDATION.md anew.

mod published;

use std::fmt::Write as _;

use eigenwing::content::aircraft::{PlaneNotes, Quantity};
use eigenwing::content::{Aircraft, Status, embedded_aircraft};
use eigenwing::flight::aircraft::plane::Plane;
use published::{Comparison, compare};

const PLANES: [Plane; 2] = Plane::ALL;

fn all() -> Vec<Aircraft> {
    let (aircraft, errors) = embedded_aircraft();
    assert!(errors.is_empty(), "{}", errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"));
    aircraft
}

fn comparisons(aircraft: &Aircraft, plane: Plane) -> Option<(&PlaneNotes, Vec<Comparison>)> {
    let models = aircraft.aircraft_model.models().expect("every shipped aircraft has a steady flight");
    assert!(models.problems.is_empty(), "{}: {:?}", aircraft.key, models.problems);
    let notes = aircraft.plane_notes[plane].as_ref()?;
    let model = match plane {
        Plane::Longitudinal => models.planes.longitudinal,
        Plane::Lateral => models.planes.lateral,
    };
    let model = model.expect("a plane with notes has a model");
    Some((notes, compare(&model, &notes.published).expect("the model has eigenvalues")))
}

fn find(key: &str) -> Aircraft {
    all().into_iter().find(|aircraft| aircraft.key == key).expect("the aircraft ships")
}

#[test]
fn every_verified_plane_reproduces_every_published_number() {
    let mut numbers = 0;
    for aircraft in all() {
        for plane in PLANES {
            let Some((notes, comparisons)) = comparisons(&aircraft, plane) else { continue };
            if notes.status == Status::Verified {
                for comparison in &comparisons {
                    assert!(comparison.is_reproduced(), "{} {comparison:?}", aircraft.key);
                }
                numbers += comparisons.len();
            }
        }
    }
    assert!(numbers >= 85, "only {numbers} numbers were compared");
}

#[test]
fn only_the_near_tuck_phugoid_of_flight_condition_7_needs_its_rounding_band() {
    let mut wide = Vec::new();
    for aircraft in all() {
        for plane in PLANES {
            let Some((notes, comparisons)) = comparisons(&aircraft, plane) else { continue };
            let beyond = |c: &&Comparison| c.relative_error().is_none_or(|error| error.abs() > 0.03);
            if notes.status == Status::Verified && comparisons.iter().any(|c| beyond(&c)) {
                wide.push((aircraft.key.clone(), plane));
            }
        }
    }
    assert_eq!(wide, [("b747-fc7".to_owned(), Plane::Longitudinal)]);
}

#[test]
fn the_etkin_cruise_agrees_with_its_recalled_eigenvalues_to_half_a_percent() {
    let aircraft = find("b747-cruise-etkin");
    for plane in PLANES {
        let (notes, comparisons) = comparisons(&aircraft, plane).expect("both planes");
        assert_eq!(notes.status, Status::Unverified);
        assert_eq!(comparisons.len(), 4);
        assert!(comparisons.iter().all(|c| c.relative_error().is_some_and(|error| error.abs() < 0.005)));
    }
}

/// The quoted lateral eigenvalues belong to other constants than the listed ones, which give an unstable spiral.
#[test]
fn the_citations_lateral_constants_disagree_with_its_quoted_eigenvalues() {
    let citation = find("citation");
    let (notes, comparisons) = comparisons(&citation, Plane::Lateral).expect("it has lateral data");
    assert_eq!(notes.status, Status::Unverified);
    assert!(comparisons.iter().all(|c| !c.is_reproduced()));
    let spiral = comparisons.last().and_then(|c| c.computed).expect("a spiral root");
    assert!(spiral > 0.0);
}

#[test]
fn every_needed_aircraft_ships_with_its_status() {
    for (key, verified) in [
        ("navion", true),
        ("b747-approach", true),
        ("b747-fc9", true),
        ("b747-fc8", true),
        ("b747-fc10", true),
        ("a4d", true),
        ("nt33a", true),
        ("x15", true),
        ("c47", true),
        ("bristol-f2b", true),
        ("navion-nelson", false),
        ("b747-cruise-etkin", false),
        ("cessna-172", false),
        ("cherokee-180", false),
        ("lesson", false),
        ("lesson-printed", false),
    ] {
        let aircraft = find(key);
        assert_eq!(aircraft.status == Status::Verified, verified, "{key}");
        assert!(!aircraft.status_reason.is_empty() && !aircraft.source.is_empty());
        assert_eq!(aircraft.plane_notes.lateral.is_some(), !key.starts_with("lesson"), "{key}");
    }
}

/// One rule for all: what was quoted from memory verifies nothing, be it the data or the modes.
#[test]
fn nothing_from_memory_is_verified() {
    let mut quoted = Vec::new();
    for aircraft in all() {
        for plane in PLANES {
            let Some(notes) =
                aircraft.plane_notes[plane].as_ref().filter(|notes| notes.status_reason.contains("memory"))
            else {
                continue;
            };
            assert_eq!(notes.status, Status::Unverified, "{}", aircraft.key);
            quoted.push(aircraft.key.clone());
        }
    }
    quoted.dedup();
    assert_eq!(quoted, ["navion-nelson", "b747-cruise-etkin"]);
}

#[test]
fn a_spiral_that_diverges_in_the_report_diverges_here() {
    for key in ["b747-fc8", "b747-fc10", "c47", "bristol-f2b"] {
        let (_, comparisons) = comparisons(&find(key), Plane::Lateral).expect("it has lateral data");
        assert!(comparisons.last().and_then(|c| c.computed).is_some_and(|root| root > 0.0), "{key}");
    }
}

/// Four figures, like most of the sources.
fn figures(x: f64) -> String {
    let digits = (3.0 - x.abs().log10().floor()).clamp(0.0, 8.0) as usize;
    format!("{x:.digits$}").replace('-', "−")
}

/// What laws of feedback were checked against, which has no published table.
const FEEDBACK: &str = "\n\
    Laws of feedback are checked against other programs, since no book prints enough digits:\n\n\
    | what | against | to |\n|---|---|---|\n\
    | eigenvalues, motions, frequency responses and margins of 14 closed loops of five aircraft, washouts and lags included | python-control (`tests/scripts/feedback_golden.py`) | 10⁻⁹ |\n\
    | nonlinear flights whose controls meet limits of deflection and rate, with a lag and without, and when they do | SciPy, DOP853 with events, from equations of its own (`tests/scripts/closed_flight_golden.py`) | 5·10⁻⁶ m/s, 10⁻⁶ rad, 0.5 ms |\n\
    | the same flights as disturbances and commands get small | the linear closed loop | second order in the size |\n";

fn validation() -> String {
    let mut text = String::from(
        "# Published and computed modes\n\n\
         Written by `UPDATE_VALIDATION=1 cargo test --no-default-features --test textbook`; the same test fails when it is \
         out of date.\nThe published numbers and their sources are in `assets/aircraft/*.toml`. A plane is *verified* when \
         its numbers and its published modes were\nboth read, in the source or in a transcription of it, nothing from memory, and every \
         published number is within 3 %, or within the band\nthat half a unit of the last printed digit of every \
         input allows (marked †).\n\n| aircraft | numbers | worst error |\n|---|---|---|\n",
    );
    let mut detail = String::new();
    for aircraft in all() {
        let mut errors = Vec::new();
        for plane in PLANES {
            let Some((notes, comparisons)) = comparisons(&aircraft, plane) else { continue };
            let (status, name) = match (notes.status, plane) {
                (Status::Verified, Plane::Longitudinal) => ("verified", "longitudinal"),
                (Status::Verified, Plane::Lateral) => ("verified", "lateral"),
                (Status::Unverified, Plane::Longitudinal) => ("unverified", "longitudinal"),
                (Status::Unverified, Plane::Lateral) => ("unverified", "lateral"),
            };
            let _ = write!(
                detail,
                "\n## {}, {}: {name}, {status}\n\n{}\n\nSource: {}\n",
                aircraft.name, aircraft.condition, notes.status_reason, notes.source
            );
            if comparisons.is_empty() {
                continue;
            }
            detail.push_str("\n| mode | quantity | published | computed | error |\n|---|---|---|---|---|\n");
            for c in &comparisons {
                let symbol = match c.published.quantity {
                    Quantity::NaturalFrequency => "ωn, rad/s",
                    Quantity::DampingRatio => "ζ",
                    Quantity::Root => "λ, 1/s",
                };
                let error = c.relative_error().unwrap_or(f64::NAN);
                let mark = match c.published.rounding_band {
                    Some(_) => " †",
                    None if c.is_reproduced() => "",
                    None => " ✗",
                };
                let _ = writeln!(
                    detail,
                    "| {} | {symbol} | {} | {} | {}{mark} |",
                    c.published.mode.name(),
                    figures(c.published.value),
                    c.computed.map_or_else(|| "none".to_owned(), figures),
                    format!("{:+.2} %", 100.0 * error)
                        .replace('-', "−")
                        .replace("+0.00", "0.00")
                        .replace("−0.00", "0.00"),
                );
                errors.push((error.abs(), mark));
            }
        }
        let worst = errors.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0));
        let worst = worst.map_or_else(
            || "none published".to_owned(),
            |(error, mark)| format!("{:.2} %{mark}", 100.0 * error),
        );
        let _ = writeln!(text, "| {}, {} | {} | {worst} |", aircraft.name, aircraft.condition, errors.len());
    }
    text + FEEDBACK + &detail
}

#[test]
fn the_validation_table_is_current() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/VALIDATION.md");
    let text = validation();
    if std::env::var_os("UPDATE_VALIDATION").is_some() {
        std::fs::create_dir_all(concat!(env!("CARGO_MANIFEST_DIR"), "/docs")).expect("docs can be made");
        std::fs::write(path, &text).expect("the table can be written");
    }
    let written = std::fs::read_to_string(path).unwrap_or_default();
    assert!(written == text, "docs/VALIDATION.md is out of date; run with UPDATE_VALIDATION=1");
}
