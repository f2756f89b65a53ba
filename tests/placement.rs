//! Dragging a pole: the chosen derivatives and nothing else move it where it was wanted, or the sentence says why not.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::{Findings, Obstacle, Placed, PlacementError, by_strength};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::eigen::eigenvalues;
use eigenwing::flight::modes::mode::Mode;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::scenario::{Page, Parameter, Scenario, parameters};
use nalgebra::Complex;

/// Every aircraft in every plane that it has.
fn scenarios() -> Vec<Scenario> {
    let aircraft = embedded_aircraft().0.into_iter().map(Arc::new);
    aircraft
        .flat_map(|aircraft| Plane::ALL.map(|plane| Scenario { plane, ..Scenario::new(aircraft.clone()) }))
        .filter(|scenario| Findings::of(scenario.clone()).plane().is_some())
        .collect()
}

fn navion(plane: Plane) -> Scenario {
    let aircraft = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == "navion");
    Scenario { plane, ..Scenario::new(Arc::new(aircraft.expect("the Navion"))) }
}

fn mode(scenario: &Scenario, name: ModeName) -> Mode {
    let findings = Findings::of(scenario.clone());
    findings.modes().iter().find(|mode| mode.naming.name == name).cloned().expect("the mode")
}

fn place(scenario: &Scenario, mode: &Mode, to: Complex<f64>, keys: &[&str]) -> Placed {
    Findings::of(scenario.clone()).place_pole(mode, to, keys).expect("an answer")
}

/// Distance of the nearest pole as it flies.
fn nearest(scenario: &Scenario, to: Complex<f64>) -> f64 {
    if !scenario.law.is_open(scenario.plane) {
        let findings = Findings::of(scenario.clone());
        let distance = |mode: &Mode| (mode.lambda - to).norm().min((mode.lambda.conj() - to).norm());
        return findings.flown_modes().iter().map(distance).fold(f64::INFINITY, f64::min);
    }
    let models = scenario.edited.models().expect("models");
    let values =
        eigenvalues(&models.planes[scenario.plane].as_ref().expect("a model").a).expect("eigenvalues");
    values.iter().map(|lambda| (lambda - to).norm()).fold(f64::INFINITY, f64::min)
}

/// Two ways of a small move: outwards along the pole's own direction, and across it.
fn nudges(mode: &Mode) -> Vec<Complex<f64>> {
    let turns: &[Complex<f64>] = if mode.is_oscillatory() {
        &[Complex::new(1.02, 0.0), Complex::new(0.98, 0.0), Complex::new(1.0, 0.01), Complex::new(1.0, -0.01)]
    } else {
        &[Complex::new(1.02, 0.0), Complex::new(0.98, 0.0)]
    };
    turns.iter().map(|turn| mode.lambda * turn).collect()
}

/// The derivatives that a drag moves at first are enough for a small move of every mode, in every direction, of every
/// aircraft, on every page.
#[test]
fn the_first_choice_of_derivatives_can_nudge_every_mode_of_every_aircraft() {
    let mut failures = Vec::new();
    let mut tried = 0;
    for scenario in scenarios() {
        let findings = Findings::of(scenario.clone());
        for page in Page::ALL.into_iter().filter(|page| page.is_of(&scenario)) {
            for (i, mode) in findings.modes().iter().enumerate() {
                let keys = findings.movers(i, page);
                assert!(!keys.is_empty(), "{} {page:?} {:?}", scenario.aircraft.key, mode.naming.name);
                for to in nudges(mode) {
                    tried += 1;
                    let placed = findings.place_pole(mode, to, &keys).expect("an answer");
                    let what = format!("{} {page:?} {:?} {keys:?}", scenario.aircraft.key, mode.naming.name);
                    if let Some(obstacle) = &placed.obstacle {
                        failures.push(format!("{what}: {obstacle}"));
                    } else {
                        let miss = nearest(&placed.scenario, to);
                        assert!(miss <= 1e-4 * to.norm(), "{what}: {miss} from {to}");
                    }
                    let elsewhere = parameters().filter(|p| p.page == Some(page) && !keys.contains(&p.key));
                    for p in elsewhere {
                        let (before, after) = (p.get(&scenario), p.get(&placed.scenario));
                        assert!((before - after).abs() <= 1e-12 * before.abs(), "{what}: {} moved", p.key);
                    }
                }
            }
        }
    }
    assert!(failures.is_empty(), "{} of {tried}:\n{}", failures.len(), failures.join("\n"));
}

/// Far targets in every direction: whatever comes of it, no slider leaves its range, the pole is no farther from the target than
/// it was, and what falls short has a sentence.
#[test]
fn a_wild_drag_of_any_mode_of_any_aircraft_stays_within_the_sliders_and_is_explained() {
    for scenario in scenarios() {
        let findings = Findings::of(scenario.clone());
        let page = Page::of(&scenario);
        for (i, mode) in findings.modes().iter().enumerate() {
            let keys = findings.movers(i, page);
            for turn in [Complex::new(4.0, 0.0), Complex::new(-2.0, 0.0), Complex::new(0.5, 2.0)] {
                let to = mode.lambda * turn;
                let placed = findings.place_pole(mode, to, &keys).expect("an answer");
                let what = format!("{} {:?} to {to}", scenario.aircraft.key, mode.naming.name);
                for key in &keys {
                    let p = Parameter::find(key).expect("a row");
                    let (value, range) = (p.get(&placed.scenario), p.range(&scenario));
                    let room = 1e-9 * (range.end() - range.start());
                    assert!(
                        (range.start() - room..=range.end() + room).contains(&value),
                        "{what}: {key} {value}"
                    );
                }
                let (miss, before) =
                    ((placed.lambda - placed.wanted).norm(), (mode.lambda - placed.wanted).norm());
                assert!(miss <= before * (1.0 + 1e-9), "{what}: {miss} was {before}");
                assert!(
                    nearest(&placed.scenario, placed.lambda) <= 1e-9 * mode.lambda.norm().max(1.0),
                    "{what}"
                );
                assert_eq!(placed.obstacle.is_some(), miss > 1e-4 * placed.lambda.norm(), "{what}");
                if let Some(obstacle) = placed.obstacle {
                    let sentence = obstacle.to_string();
                    assert!(sentence.len() > 20 && !sentence.contains(['{', '}']), "{what}: {sentence}");
                }
            }
        }
    }
}

#[test]
fn a_slider_at_its_end_is_named() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    let placed = place(&scenario, &short_period, short_period.lambda * 4.0, &["cm_alpha", "cm_q"]);
    let Some(Obstacle::Ends(ends)) = &placed.obstacle else { panic!("{:?}", placed.obstacle) };
    assert!(ends.iter().any(|p| p.key == "cm_alpha"));
    for p in ends {
        let (value, range) = (p.get(&placed.scenario), p.range(&scenario));
        assert!(value == *range.start() || value == *range.end(), "{}: {value}", p.key);
    }
    let sentence = placed.obstacle.expect("an obstacle").to_string();
    assert!(sentence.contains("C_mα") && sentence.contains(" at the end"), "{sentence}");
}

#[test]
fn a_pair_dragged_to_the_real_axis_stays_a_pair_and_says_what_it_would_become() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    let to = Complex::from(short_period.lambda.re);
    let placed = place(&scenario, &short_period, to, &["cm_alpha", "cm_q"]);
    assert_eq!(placed.obstacle, Some(Obstacle::RealAxis));
    assert!(placed.lambda.im > 0.0 && placed.lambda.im < 0.1 * short_period.lambda.im, "{}", placed.lambda);
}

#[test]
fn a_target_in_the_lower_half_is_that_of_the_conjugate() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    let to = short_period.lambda * 1.05;
    let at = |to| place(&scenario, &short_period, to, &["cm_alpha", "cm_q"]).scenario;
    assert_eq!(at(to), at(to.conj()));
}

#[test]
fn a_real_root_is_dragged_along_the_real_axis_only() {
    let scenario = navion(Plane::Lateral);
    let roll = mode(&scenario, ModeName::RollSubsidence);
    let to = Complex::new(1.1 * roll.lambda.re, 3.0);
    let placed = place(&scenario, &roll, to, &["croll_p"]);
    assert_eq!((placed.obstacle, placed.lambda.im), (None, 0.0));
    assert!((placed.lambda.re - to.re).abs() < 1e-6);
}

#[test]
fn one_derivative_moves_a_pair_along_one_path() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    // M_α moves the short period up and down; σ stays.
    let to = short_period.lambda + Complex::new(0.5, 0.3);
    let placed = place(&scenario, &short_period, to, &["cm_alpha"]);
    let sentence = placed.obstacle.expect("an obstacle").to_string();
    assert!(sentence.starts_with("C_mα alone"), "{sentence}");
}

#[test]
fn derivatives_that_have_no_part_in_a_mode_or_are_not_there_are_refused() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    let findings = Findings::of(scenario);
    let refusal =
        |keys: &[&str]| findings.place_pole(&short_period, short_period.lambda, keys).expect_err("refusal");
    assert_eq!(refusal(&[]), PlacementError::NothingChosen);
    assert_eq!(refusal(&["no such key"]), PlacementError::NothingChosen);
    let sentence = refusal(&["cm_de", "cn_beta"]).to_string();
    assert_eq!(sentence, "C_mδe and C_nβ have no part in this mode: choose others");
}

#[test]
fn back_at_the_start_every_derivative_is_what_it_was() {
    for scenario in scenarios() {
        let findings = Findings::of(scenario.clone());
        let page = Page::of(&scenario);
        for (i, mode) in findings.modes().iter().enumerate() {
            let keys = findings.movers(i, page);
            let placed = findings.place_pole(mode, mode.lambda, &keys).expect("an answer");
            assert_eq!(placed.scenario, scenario, "{} {:?}", scenario.aircraft.key, mode.naming.name);
        }
    }
}

#[test]
fn the_rows_come_by_strength_and_without_those_that_move_nothing() {
    let scenario = navion(Plane::Longitudinal);
    let findings = Findings::of(scenario);
    let rows = findings.sensitivities(Page::Coefficients);
    let keys = by_strength(rows, 0);
    let strength = |key: &str| rows.iter().find(|row| row.key == key).expect("a row").strengths[0];
    assert!(keys.windows(2).all(|pair| strength(pair[0]) >= strength(pair[1])));
    assert!(!keys.contains(&"cm_de") && keys.contains(&"cm_alpha"), "{keys:?}");
}

/// Dragged towards the origin, the short period would part on the real axis; there the phugoid is near, which must not be
/// taken for it.
#[test]
fn a_pair_that_would_part_on_the_way_stops_and_no_other_mode_takes_its_place() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    for to in
        [Complex::new(0.1, 0.01), Complex::new(-0.02, 0.2), Complex::new(0.0, 0.0), Complex::new(-6.0, 0.1)]
    {
        let placed = place(&scenario, &short_period, to, &["cm_alpha", "cm_q"]);
        assert!(placed.obstacle.is_some(), "{to}");
        let now = mode(&placed.scenario, ModeName::ShortPeriod).lambda;
        assert!((now - placed.lambda).norm() < 1e-9, "{to}: {now} {}", placed.lambda);
        let phugoid = mode(&placed.scenario, ModeName::Phugoid);
        assert!(phugoid.lambda.norm() < 0.5 * now.norm(), "{to}: {} {now}", phugoid.lambda);
    }
}

/// Less damping than a short period has without any of C_mq is asked for: it stops where C_mq is zero, and says so. What is beyond
/// already may stay beyond.
#[test]
fn no_drag_gives_a_derivative_the_sign_that_no_aircraft_has() {
    let scenario = navion(Plane::Longitudinal);
    let short_period = mode(&scenario, ModeName::ShortPeriod);
    let wanted = Complex::new(-0.4, short_period.lambda.im);
    let placed = place(&scenario, &short_period, wanted, &["cm_alpha", "cm_q"]);
    let pitch_damping = Parameter::find("cm_q").expect("a row");
    assert!(pitch_damping.get(&placed.scenario) <= 0.0 && pitch_damping.get(&placed.scenario) > -0.01);
    assert_eq!(placed.obstacle, Some(Obstacle::Sign(vec![pitch_damping])));
    let sentence = placed.obstacle.expect("a reason").to_string();
    assert_eq!(sentence, "C_mq is at zero: with the other sign this would be no aircraft");
    let mut beyond = scenario.clone();
    pitch_damping.set(&mut beyond, 5.0);
    let driven = mode(&beyond, ModeName::ShortPeriod);
    let to = driven.lambda * Complex::new(1.02, 0.0);
    let placed = place(&beyond, &driven, to, &["cm_alpha", "cm_q"]);
    assert_eq!(placed.obstacle, None);
    assert!(pitch_damping.get(&placed.scenario) > 0.0);
}

/// Under a law with washout and actuator too: the pole goes where it is wanted, by the gains alone, and the aircraft stays as it is.
#[test]
fn gains_place_the_poles_of_a_closed_loop() {
    let mut placed_poles = 0;
    for (key, law, gains) in [
        ("b747-cruise-etkin", &[("k.r_dr", 0.8), ("actuator", 0.1)][..], ["k.r_dr", "k.beta_dr"]),
        (
            "b747-cruise-etkin",
            &[("k.r_dr", 0.8), ("washout", 4.0), ("actuator", 0.1)],
            ["k.r_dr", "k.beta_dr"],
        ),
        ("navion", &[("k.q_de", 0.1), ("actuator", 0.05)], ["k.q_de", "k.alpha_de"]),
        // One that comes in with a state of its own.
        ("navion", &[("k.theta_de", 0.3)], ["k.theta_de", "k.h_de"]),
    ] {
        let found = scenarios().into_iter().find(|scenario| scenario.aircraft.key == key);
        let mut scenario = found.expect("an aircraft");
        let of_gain = |key: &str| Parameter::find(key).expect("a row");
        scenario.plane = of_gain(gains[0]).plane.expect("a plane");
        for (key, value) in law {
            of_gain(key).set(&mut scenario, *value);
        }
        let findings = Findings::of(scenario.clone());
        let pair = findings.flown_modes().iter().find(|mode| mode.is_oscillatory()).expect("a pair");
        for turn in [Complex::new(1.03, 0.0), Complex::new(1.0, 0.02), Complex::new(0.98, -0.01)] {
            let to = pair.lambda * turn;
            let placed = findings.place_pole(pair, to, &gains).expect("an answer");
            assert_eq!(placed.obstacle, None, "{key} {to}");
            assert!(nearest(&placed.scenario, to) < 1e-4 * to.norm(), "{key} {to}");
            assert_eq!(placed.scenario.edited, scenario.edited);
            placed_poles += 1;
        }
    }
    assert_eq!(placed_poles, 12);
}
