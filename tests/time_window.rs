//! The time shown follows the slowest mode that the disturbance makes visible, or stays as it is set.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode::Mode;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::scenario::{Parameter, Scenario, Shape, Source};

fn scenarios() -> impl Iterator<Item = Scenario> {
    embedded_aircraft().0.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft)))
}

fn aircraft(key: &str) -> Scenario {
    scenarios().find(|scenario| scenario.aircraft.key == key).expect("an aircraft of the list")
}

/// The period of a mode that oscillates \[s\].
fn period(scenario: &Scenario, name: ModeName) -> Option<f64> {
    let findings = Findings::of(scenario.clone());
    findings.modes().iter().find(|mode| mode.naming.name == name).and_then(Mode::period)
}

fn time_shown(scenario: &Scenario) -> f64 {
    Findings::of(scenario.clone()).time_shown()
}

fn set(scenario: &mut Scenario, key: &str, value: f64) {
    Parameter::find(key).expect("a row").set(scenario, value);
}

fn with_time(mut scenario: Scenario, time: f64) -> Scenario {
    scenario.disturbance.sizes.time = time;
    scenario
}

#[test]
fn the_page_opens_with_a_minute_and_the_navions_phugoid_in_it() {
    let scenario = aircraft("navion");
    assert!(scenario.disturbance.follows);
    assert_eq!(time_shown(&scenario), 60.0);
    let period = period(&scenario, ModeName::Phugoid).expect("a period");
    assert!((1.5..3.0).contains(&(60.0 / period)), "a phugoid of {period} s");
}

/// Whatever was shown before, one and a half to four periods of the phugoid that a step of the elevator always excites.
#[test]
fn after_an_elevator_step_the_phugoid_is_seen_whatever_the_time_before() {
    let mut seen = 0;
    for scenario in scenarios() {
        let Some(period) = period(&scenario, ModeName::Phugoid) else { continue };
        for before in [2.0, 30.0, 60.0, 300.0] {
            let time = time_shown(&with_time(scenario.clone(), before));
            // 240 s are the most that a mode is given.
            let least = (1.5 * period).min(150.0);
            let key = &scenario.aircraft.key;
            assert!(
                time >= least && time <= 4.1 * period,
                "{key}: {time} s from {before} s, period {period} s"
            );
            seen += 1;
        }
    }
    assert!(seen >= 40, "{seen}");
}

/// A release in sideslip hardly leaves the Navion banked; a pulse of the rudder turns it, and the spiral takes that back.
#[test]
fn a_mode_that_the_disturbance_hardly_excites_does_not_lengthen_the_time() {
    let mut scenario = aircraft("navion");
    scenario.plane = Plane::Lateral;
    let after_rudder = time_shown(&scenario);
    scenario.disturbance.choices.lateral.source = Source::Release;
    let after_release = time_shown(&scenario);
    let period = period(&scenario, ModeName::DutchRoll).expect("a period");
    assert!(after_release < 4.0 * period, "{after_release} s, Dutch roll of {period} s");
    assert!(after_rudder > 3.0 * after_release, "{after_rudder} s and {after_release} s");
}

/// A sine that ends after the slowest mode has been seen is seen to its end.
#[test]
fn the_disturbance_is_seen_to_its_end() {
    for lasting in [150.0, 300.0] {
        let mut scenario = aircraft("navion");
        scenario.disturbance.choices.longitudinal.control_shape = Shape::Sine;
        set(&mut scenario, "lasting", lasting);
        let time = time_shown(&with_time(scenario, 2.0));
        assert!(time >= lasting.min(299.0) && time <= 300.0, "{time} s of {lasting} s");
    }
}

#[test]
fn following_twice_changes_nothing() {
    for scenario in scenarios() {
        for plane in Plane::ALL {
            let scenario = Scenario { plane, ..scenario.clone() };
            if scenario.aircraft.plane_notes[plane].is_some() {
                let settled = time_shown(&scenario);
                let scenario = with_time(scenario, settled);
                assert_eq!(time_shown(&scenario), settled, "{} {plane:?}", scenario.aircraft.key);
            }
        }
    }
}

/// The speed down and up by ten per cent in twenty steps, as a slider under the hand.
#[test]
fn while_a_slider_goes_and_comes_back_the_time_changes_once_each_way_at_most() {
    let speed = Parameter::find("speed").expect("a row");
    let (mut ways, mut still) = (0, 0);
    for aircraft in scenarios().filter(|scenario| speed.applies(scenario)).step_by(2) {
        for plane in Plane::ALL {
            if aircraft.aircraft.plane_notes[plane].is_none() {
                continue;
            }
            let mut scenario = Scenario { plane, ..aircraft.clone() };
            scenario.disturbance.sizes.time = time_shown(&scenario);
            let reference = speed.get(&scenario);
            let mut changes = 0;
            for step in (0..=10).chain((0..10).rev()) {
                speed.set(&mut scenario, reference * (1.0 - 0.01 * f64::from(step)));
                // Beyond what the source says of the air there is nothing to follow: the time stays.
                let before = scenario.disturbance.sizes.time;
                scenario.disturbance.sizes.time = time_shown(&scenario);
                changes += usize::from(scenario.disturbance.sizes.time != before);
            }
            assert!(changes <= 2, "{} {plane:?}: {changes} changes", scenario.aircraft.key);
            ways += 1;
            still += usize::from(changes == 0);
        }
    }
    // A function of the scene has its places of change; they are rare.
    assert!(ways >= 6 && still * 2 >= ways, "still in {still} of {ways}");
}

#[test]
fn a_time_that_is_set_stays() {
    let mut scenario = aircraft("b747-approach");
    set(&mut scenario, "time", 12.0);
    assert!(!scenario.disturbance.follows);
    assert_eq!(time_shown(&scenario), 12.0);
    scenario.disturbance.follows = true;
    assert!(time_shown(&scenario) > 60.0);
}

/// The lesson's matrices have no throttle: nothing moves, so nothing says how long to look.
#[test]
fn where_nothing_moves_the_time_stays() {
    let mut scenario = aircraft("lesson");
    scenario.disturbance.choices.longitudinal.source = Source::Throttle;
    assert_eq!(Findings::of(scenario.clone()).time_to_see(), None);
    assert_eq!(time_shown(&with_time(scenario, 7.0)), 7.0);
}
