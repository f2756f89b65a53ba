//! The table of adjustable quantities, walked to both ends for every aircraft.

use std::collections::HashSet;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::scenario::{DisturbanceKind, PARAMETERS, Parameter, Scenario, ValueError};

fn scenarios() -> Vec<Scenario> {
    embedded_aircraft().0.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft))).collect()
}

#[test]
fn keys_are_unique_and_every_row_says_what_it_is() {
    let keys: HashSet<_> = PARAMETERS.iter().map(|p| p.key).collect();
    assert_eq!(keys.len(), PARAMETERS.len());
    for p in &PARAMETERS {
        for text in [p.symbol, p.name, p.meaning, p.sign, p.origin] {
            assert!(!text.is_empty(), "{}", p.key);
        }
    }
}

#[test]
fn every_parameter_of_every_aircraft_can_be_taken_to_both_ends() {
    for scenario in scenarios() {
        for p in &PARAMETERS {
            let range = p.range(&scenario);
            assert!(range.start() < range.end(), "{} {}", scenario.aircraft.key, p.key);
            assert!(range.contains(&p.reference(&scenario)), "{} {}", scenario.aircraft.key, p.key);
            for kind in DisturbanceKind::ALL {
                for end in [*range.start(), *range.end()] {
                    let mut edited = scenario.clone();
                    edited.disturbance.kind = kind;
                    let value = p.check(&edited, end).expect("the end of a slider is accepted");
                    p.set(&mut edited, value);
                    assert_eq!(p.get(&edited), value);
                    let analysis = edited.analyse().expect("an analysis");
                    assert!(analysis.response.states.iter().all(|x| x.iter().all(|v| v.is_finite())));
                }
            }
        }
    }
}

#[test]
fn setting_one_parameter_moves_no_other() {
    for scenario in scenarios() {
        for p in &PARAMETERS {
            let mut edited = scenario.clone();
            p.set(&mut edited, *p.range(&scenario).end());
            for other in PARAMETERS.iter().filter(|other| other.key != p.key) {
                assert_eq!(other.get(&edited), other.get(&scenario), "{} moved {}", p.key, other.key);
            }
        }
    }
}

#[test]
fn what_cannot_be_used_is_refused_in_a_sentence() {
    let navion = &scenarios()[0];
    let m_w = Parameter::find("mw").expect("a row");
    assert!(matches!(m_w.parse(navion, "steep"), Err(ValueError::NotANumber(_))));
    assert!(matches!(m_w.parse(navion, ""), Err(ValueError::NotANumber(_))));
    for text in ["nan", "inf", "-inf"] {
        assert_eq!(m_w.parse(navion, text), Err(ValueError::NotFinite), "{text}");
    }
    let error = m_w.parse(navion, "1e9").expect_err("absurd");
    assert!(error.to_string().contains("1/(m·s)"), "{error}");
    let time = Parameter::find("time").expect("a row");
    assert!(time.parse(navion, "0").is_err() && time.parse(navion, "-5").is_err());
}

#[test]
fn a_typed_value_may_lie_beyond_the_slider_and_is_kept_as_it_is() {
    let navion = &scenarios()[0];
    let m_w = Parameter::find("mw").expect("a row");
    let beyond = 3.0 * m_w.range(navion).start();
    assert_eq!(m_w.check(navion, beyond), Ok(beyond));
}

#[test]
fn a_typographic_minus_and_a_decimal_comma_are_understood() {
    let navion = &scenarios()[0];
    let m_w = Parameter::find("mw").expect("a row");
    assert_eq!(m_w.parse(navion, " −0,25 "), Ok(-0.25));
}

#[test]
fn the_lesson_is_shown_in_the_numbers_that_are_printed() {
    let printed = scenarios().into_iter().find(|s| s.aircraft.key == "lesson-printed").expect("the lesson");
    let length = printed.aircraft.length_unit;
    for (key, value) in [
        ("xu", -0.045),
        ("zq", 1.76),
        ("mu", 0.191),
        ("mw", -3.96),
        ("g", 9.81),
        ("zde", -0.282),
        ("mde", -9.72),
    ] {
        let p = Parameter::find(key).expect("a row");
        let shown = p.get(&printed) / p.dimension.in_si(length);
        assert!((shown - value).abs() <= 1e-15 * value.abs() * 8.0, "{key}: {shown}");
    }
}
