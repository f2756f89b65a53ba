//! The table of adjustable quantities, walked to both ends for every aircraft.

use std::collections::HashSet;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::{Page, Parameter, Scenario, Source, ValueError, parameters};
use eigenwing::words;

fn scenarios() -> Vec<Scenario> {
    embedded_aircraft().0.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft))).collect()
}

/// The rows that an aircraft has.
fn rows(scenario: &Scenario) -> Vec<&'static Parameter> {
    parameters().filter(|p| p.applies(scenario)).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs()).max(1e-9)
}

#[test]
fn keys_are_unique_and_every_row_says_what_it_is() {
    let keys: HashSet<_> = parameters().map(|p| p.key).collect();
    assert_eq!(keys.len(), parameters().count());
    for p in parameters() {
        for text in [p.symbol, p.name, p.meaning, p.sign] {
            assert!(!text.is_empty(), "{}", p.key);
        }
        assert_eq!(p.origin.is_empty(), p.is_of_disturbance(), "{}", p.key);
        assert!(p.sign.contains(' '), "{}: \u{201c}{}\u{201d} says nothing", p.key, p.sign);
    }
}

#[test]
fn names_tell_the_rows_of_a_page_apart() {
    for page in Page::ALL {
        for plane in Plane::ALL {
            let mut names = HashSet::new();
            let shown = |p: &&Parameter| p.page == Some(page) && p.plane.is_none_or(|of| of == plane);
            for p in parameters().filter(shown) {
                assert!(names.insert(p.name), "{page:?} {plane:?}: {}", p.name);
            }
        }
    }
}

/// What can't be flown says so in a sentence; whatever is drawn is finite.
#[test]
fn every_parameter_of_every_aircraft_can_be_taken_to_both_ends() {
    let (mut analysed, mut ends) = (0, 0);
    for scenario in scenarios() {
        for p in rows(&scenario) {
            let range = p.range(&scenario);
            let what = format!("{} {}", scenario.aircraft.key, p.key);
            assert!(range.start() < range.end(), "{what}");
            assert!(
                range.contains(&p.reference(&scenario)),
                "{what}: {} in {range:?}",
                p.reference(&scenario)
            );
            for end in [*range.start(), *range.end()] {
                let mut edited = scenario.clone();
                edited.plane = p.plane.unwrap_or(Plane::Longitudinal);
                let value = p.check(&edited, end).expect("the end of a slider is accepted");
                p.set(&mut edited, value);
                ends += 1;
                analysed += usize::from(has_finite_motion(&edited, &what));
            }
        }
    }
    assert!(100 * analysed >= 99 * ends, "{analysed} of {ends} ends have a motion");
}

/// Whether there is a motion, which then is finite; where the scenario can't be flown, the error is a sentence.
fn has_finite_motion(scenario: &Scenario, what: &str) -> bool {
    match scenario.analyse() {
        Ok(analysis) => {
            let mut states = analysis.motion.iter().flat_map(|motion| &motion.response.states);
            assert!(states.all(|x| x.iter().all(|v| v.is_finite())), "{what}");
            analysis.motion.is_some()
        }
        Err(error) => {
            assert!(error.to_string().len() > 20, "{what}: {error}");
            false
        }
    }
}

#[test]
fn every_disturbance_of_every_aircraft_has_a_response() {
    for scenario in scenarios() {
        for plane in Plane::ALL {
            let has_data = scenario.aircraft.plane_notes[plane].is_some();
            for &source in Source::of(plane) {
                let mut edited = scenario.clone();
                edited.plane = plane;
                edited.disturbance.choices[plane].source = source;
                for shape in source.shapes().iter().copied().map(Some).chain([None]) {
                    if let Some(shape) = shape {
                        *edited.disturbance.choices[plane].shape_mut() = shape;
                    }
                    let choice = edited.disturbance.choices[plane];
                    let name = words::disturbance::choice(&choice);
                    assert_eq!(has_finite_motion(&edited, &name), has_data, "{name}");
                    for key in choice.parameters(plane) {
                        assert!(Parameter::find(key).is_some(), "{key}");
                    }
                }
            }
        }
    }
}

#[test]
fn setting_a_parameter_gives_its_value_and_resetting_takes_it_back() {
    for scenario in scenarios() {
        for p in rows(&scenario) {
            let range = p.range(&scenario);
            let value = 0.3 * range.start() + 0.7 * range.end();
            let mut edited = scenario.clone();
            p.set(&mut edited, value);
            if p.applies(&edited) {
                assert!(
                    close(p.get(&edited), value),
                    "{} {}: {}",
                    scenario.aircraft.key,
                    p.key,
                    p.get(&edited)
                );
            }
            p.reset(&mut edited);
            assert_eq!(edited, scenario, "{} {}", scenario.aircraft.key, p.key);
        }
    }
}

#[test]
fn setting_one_parameter_moves_no_other_of_its_page() {
    for scenario in scenarios() {
        for p in rows(&scenario) {
            let mut edited = scenario.clone();
            p.set(&mut edited, *p.range(&scenario).end());
            let others = rows(&edited).into_iter().filter(|other| other.page == p.page && other.key != p.key);
            for other in others {
                let (after, before) = (other.get(&edited), other.get(&scenario));
                assert!(close(after, before), "{} moved {}", p.key, other.key);
            }
        }
    }
}

/// An edit of a derivative stays while a coefficient before it moves.
#[test]
fn an_edit_further_down_stays_while_what_it_follows_from_moves() {
    let navion = &scenarios()[0];
    let find = |key| Parameter::find(key).expect("a row");
    let (m_w, cm_alpha) = (find("m_w"), find("cm_alpha"));
    let mut edited = navion.clone();
    m_w.set(&mut edited, 1.5 * m_w.get(navion));
    let offset = m_w.get(&edited) - m_w.get(navion);
    cm_alpha.set(&mut edited, 2.0 * cm_alpha.get(navion));
    assert!(close(m_w.get(&edited), 2.0 * m_w.get(navion) + offset));
    assert!(close(m_w.reference(&edited), 2.0 * m_w.get(navion)));
}

#[test]
fn what_cannot_be_used_is_refused_in_a_sentence() {
    let navion = &scenarios()[0];
    let m_w = Parameter::find("a_qw").expect("a row");
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
    let m_w = Parameter::find("a_qw").expect("a row");
    let beyond = 3.0 * m_w.range(navion).start();
    assert_eq!(m_w.check(navion, beyond), Ok(beyond));
}

#[test]
fn a_typographic_minus_and_a_decimal_comma_are_understood() {
    let navion = &scenarios()[0];
    let m_w = Parameter::find("a_qw").expect("a row");
    assert_eq!(m_w.parse(navion, " −0,25 "), Ok(-0.25));
}

#[test]
fn the_lesson_is_shown_in_the_numbers_that_are_printed() {
    let printed = scenarios().into_iter().find(|s| s.aircraft.key == "lesson-printed").expect("the lesson");
    let length = printed.aircraft.length_unit;
    for (key, value) in [
        ("a_uu", -0.045),
        ("a_wq", 1.76),
        ("a_qu", 0.191),
        ("a_qw", -3.96),
        ("g", 9.81),
        ("b_w_de", -0.282),
        ("b_q_de", -9.72),
    ] {
        let p = Parameter::find(key).expect("a row");
        let shown = p.get(&printed) / p.dimension.in_si(length);
        assert!((shown - value).abs() <= 1e-15 * value.abs() * 8.0, "{key}: {shown}");
    }
}

#[test]
fn the_number_of_a_sample_is_whole() {
    let navion = &scenarios()[0];
    let seed = Parameter::find("seed").expect("a row");
    assert_eq!(seed.parse(navion, "7"), Ok(7.0));
    assert_eq!(seed.parse(navion, "1.5"), Err(ValueError::NotWhole));
}
