//! What programs and people are told of a law: the mode that is flown alone, new trims, limits of the controls, stability along a sweep,
//! and the sentences of its loops.

#[expect(dead_code, reason = "each test needs some of it")]
mod import_files;

use std::sync::Arc;

use eigenwing::content::{LengthUnit, embedded_aircraft};
use eigenwing::export::{
    FlightOutcome, PlaneOutcome, ResponseReport, ResponseRequest, Scene, Signal, Source, Subject, Sweep,
    SweepRequest, analyse, respond, why,
};
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::feedback::analyse_loop;
use eigenwing::flight::feedback::damping_map::{best_gain, law_with, least_damping};
use eigenwing::flight::feedback::law::RATE;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::scenario::{Dimension, Parameter, Scenario, link};
use eigenwing::words;

fn scene(key: &str, set: &[(&str, f64)]) -> Scene {
    let set = set.iter().map(|&(key, value)| (key.to_owned(), value)).collect();
    Subject { set, ..Subject::listed(key) }.scene().expect("an aircraft of the list")
}

fn in_mode(scene: &Scene, plane: &str, mode: &str) -> ResponseReport {
    let [plane, disturbance, mode] = [plane, "mode", mode].map(|word| Some(word.to_owned()));
    respond(scene, &ResponseRequest { plane, disturbance, mode, ..ResponseRequest::default() })
        .expect("a motion")
}

/// How fast the motion of one mode dies away \[1/s\], from an output that it moves.
fn envelope(report: &ResponseReport, outputs: &[Signal], name: &str) -> f64 {
    let values = &outputs.iter().find(|signal| signal.name == name).expect("an output").values;
    let k = report.time.iter().position(|time| *time >= 0.2).expect("a sample");
    (values[k] / values[0]).ln() / report.time[k]
}

/// A mode is flown that has the name asked for: a real one dies away as its eigenvalue says, under the law and without.
#[test]
fn the_mode_that_is_flown_is_the_one_that_is_told() {
    let law = [("k.phi_da", -0.02), ("actuator", 0.1)];
    let flown = scene("navion", &law);
    let report = analyse(&flown).expect("an answer");
    let lateral = report.lateral.as_ref().and_then(PlaneOutcome::report).expect("lateral motion");
    let findings = Findings::of(Scenario { plane: Plane::Lateral, ..flown.scenario.clone() });
    let mut seen = 0;
    for mode in findings.flown_modes().iter().filter(|mode| !mode.is_oscillatory()) {
        let key = eigenwing::key::Keyed::key(mode.naming.name);
        let answer = in_mode(&flown, "lateral", key);
        assert_eq!(answer.mode_key, Some(key));
        let closed = answer.closed_loop.as_ref().expect("a law");
        let rate = envelope(&answer, &closed.outputs, "phi");
        assert!((rate - mode.lambda.re).abs() < 1e-6 * mode.lambda.norm(), "{key}: {rate} {}", mode.lambda);
        // The aircraft alone flies its own mode of that name, and stays at rest where it has none.
        match lateral.modes.iter().find(|own| own.key == key) {
            Some(own) => {
                assert!((envelope(&answer, &answer.outputs, "phi") - own.re).abs() < 1e-6, "{key}");
                assert!(answer.notices.is_empty());
            }
            None => {
                assert!(answer.outputs.iter().all(|output| output.values.iter().all(|value| *value == 0.0)));
                assert!(answer.notices[0].contains("The aircraft alone has no"), "{:?}", answer.notices);
            }
        }
        seen += 1;
    }
    assert!(seen >= 3, "{seen}");
}

#[test]
fn modes_under_a_law_are_known_by_key_and_number_and_others_are_refused_with_their_list() {
    let damped = scene("b747-cruise-etkin", &[("k.r_dr", 3.0), ("washout", 3.0), ("actuator", 0.1)]);
    let plane = Some("lateral".to_owned());
    let request = |mode: &str| ResponseRequest {
        plane: plane.clone(),
        disturbance: Some("mode".to_owned()),
        mode: Some(mode.to_owned()),
        ..ResponseRequest::default()
    };
    assert_eq!(respond(&damped, &request("washout")).expect("a mode").mode_key, Some("washout"));
    assert_eq!(respond(&damped, &request("5")).expect("a mode").mode_key, Some("rudder-actuator"));
    let refused = respond(&damped, &request("phugoid")).expect_err("a mode of the other plane").to_string();
    assert!(refused.contains("\"washout\""), "{refused}");
    assert!(respond(&damped, &request("6")).is_err());
}

/// A number beyond the modes that there are is told, not kept.
#[test]
fn a_link_to_a_mode_that_is_not_there_says_so() {
    let all: Vec<_> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    for (number, notices) in [(5, 0), (6, 1), (8, 1)] {
        let text = format!(
            "v=1&ac=b747-cruise-etkin&plane=lat&k.r_dr=3&washout=3&actuator=0.1&lat.source=mode&lat.mode={number}"
        );
        let opened = link::read(&text, &all).expect("an aircraft");
        assert_eq!(opened.notices.len(), notices, "{number}: {:?}", opened.notices);
    }
}

/// The new trim is of the aircraft alone: a law that moves the same control doesn't reach it.
#[test]
fn no_new_trim_is_told_under_a_law() {
    let told = |link: &str| {
        let subject = Subject { source: Source::Link(link.to_owned()), ..Subject::listed("") };
        why(&subject.scene().expect("a scene")).expect("an answer").new_trim
    };
    assert!(told("#v=1&ac=navion&elevator=-1").is_some_and(|told| told.contains("new trim")));
    assert_eq!(told("#v=1&ac=navion&k.theta_de=2&elevator=-1"), None);
    // A law of the other plane moves no elevator.
    assert!(told("#v=1&ac=navion&k.r_dr=1&elevator=-1").is_some());
}

/// What the pilot asks beyond the reach is held there, and told: with a law of the other plane, too.
#[test]
fn a_pilot_s_deflection_that_is_held_back_is_told() {
    let size =
        |k: f64| [("elevator_pulse", 0.35), ("part", 0.3), ("times", k), ("time", 2.0), ("k.r_dr", 0.5)];
    let request = ResponseRequest {
        disturbance: Some("elevator".to_owned()),
        shape: Some("pulse".to_owned()),
        nonlinear: Some(true),
        ..ResponseRequest::default()
    };
    for (times, bites) in [(1.0, 0), (2.0, 1)] {
        let report = respond(&scene("navion", &size(times)), &request).expect("a motion");
        let flight = report.nonlinear.as_ref().and_then(FlightOutcome::flight).expect("a flight");
        assert_eq!(flight.limits.len(), bites, "{:?}", flight.limits);
        if let Some(limit) = flight.limits.first() {
            assert_eq!((limit.control, limit.limit), ("elevator", "deflection"));
            assert!((limit.from - 1.0).abs() < 1e-6 && (limit.until - 1.3).abs() < 1e-6, "{limit:?}");
        }
    }
}

/// A height that stays where it is is no mode that makes flight neutral: the sweep says what the analysis says.
#[test]
fn a_sweep_tells_the_stability_that_the_analysis_tells() {
    let aircraft =
        import_files::aircraft(&import_files::open(&["07-boeing747-five-named.m"], &["all=suggested"]));
    let scene = Scene::from(Scenario::new(Arc::new(aircraft)));
    let gain = Parameter::find("k.theta_de").expect("a row");
    let request =
        SweepRequest { parameter: gain.key.to_owned(), from: -1.0, to: 0.5, points: 4, measures: Vec::new() };
    let swept = Sweep::new(scene.clone(), &request).expect("a sweep").report();
    let mut told = Vec::new();
    for point in &swept.points {
        let mut at = scene.clone();
        gain.set(&mut at.scenario, point.value);
        let findings = Findings::of(at.scenario.clone());
        let closed = findings.closed_loop_of(Plane::Longitudinal).expect("a further state");
        let expected = closed.as_ref().expect("it can be analysed").dynamic_stability;
        let found = point.longitudinal.as_ref().expect("a plane").dynamic_stability;
        assert_eq!(found, eigenwing::key::Keyed::key(expected), "{}", point.value);
        told.push(found);
    }
    assert!(told.contains(&"stable") && !told.contains(&"neutral"), "{told:?}");
}

/// Golden-section search has no better answer than looking everywhere, on both sides of zero.
#[test]
fn the_best_gain_is_the_best_of_the_whole_slider_from_any_law() {
    let mut compared = 0;
    for (key, gain, washout) in [
        ("b747-cruise-etkin", 0.5, 3.0),
        ("b747-approach", 1.0, 3.0),
        ("navion", -0.2, 0.0),
        ("c47", 0.1, 1.0),
    ] {
        let set = [("k.r_dr", gain), ("washout", washout), ("actuator", 0.1)];
        let findings = Findings::of(Scenario { plane: Plane::Lateral, ..scene(key, &set).scenario });
        let row = Parameter::find("k.r_dr").expect("a row");
        let range = row.range(findings.scenario());
        let range = [*range.start(), *range.end()];
        let (best, damping) = findings.best_gain(1, range).expect("roots");
        assert!((range[0]..=range[1]).contains(&best), "{key}: {best}");
        let (law, model) = (findings.scenario().law, &findings.plane().expect("lateral motion").model);
        let of = |gain: f64| least_damping(model, &law_with(&law, model, 1, gain, washout)).expect("roots");
        assert_eq!(of(best), damping);
        // More roots that grow without oscillating are no price for damping.
        let growing = |gain: f64| {
            let closed =
                analyse_loop(model, &law_with(&law, model, 1, gain, washout), None).expect("likewise");
            closed
                .modes
                .iter()
                .filter(|m| !m.mode.is_oscillatory() && m.mode.stability == Stability::Unstable)
                .count()
        };
        let usual = growing(0.0);
        assert!(growing(best) <= usual, "{key}: {best}");
        for k in 0..=500 {
            let gain = range[0] + (range[1] - range[0]) * f64::from(k) / 500.0;
            let better = of(gain) > damping + 1e-4 && growing(gain) <= usual;
            assert!(!better, "{key}: {gain} damps {} and {best} only {damping}", of(gain));
            compared += 1;
        }
        // No law that is tried is beyond the range.
        let short = [0.0, 0.4 * best.max(0.1)];
        let (within, _) = best_gain(model, &law, 1, washout, short).expect("roots");
        assert!((short[0]..=short[1]).contains(&within), "{key}: {within} of {short:?}");
        assert!(law.planes.lateral.to_second[RATE] == gain);
    }
    assert!(compared > 2000, "{compared}");
}

#[test]
fn sentences_of_loops_are_true_of_loops_that_are_not_stable_and_of_counts_that_fail() {
    let unstable = scene("c47", &[("k.p_da", -0.01)]);
    let findings = Findings::of(Scenario { plane: Plane::Lateral, ..unstable.scenario });
    let closed = findings.closed_loop().expect("a law").as_ref().expect("it can be analysed");
    assert_eq!(closed.dynamic_stability, Stability::Unstable);
    let margins = findings.loop_margins(Plane::Lateral)[0].expect("an aileron loop");
    assert_eq!(margins.phase, None);
    let told = words::loops::phase_margin(margins.phase, false);
    assert_eq!(told, "No phase makes it stable, |L| crosses 1 nowhere");
    assert!(words::loops::phase_margin(None, true).contains("without bound"));
    for (stability, word) in [(Stability::Stable, "stable"), (Stability::Unstable, "unstable")] {
        let told = words::loops::nyquist(None, 0, stability);
        assert_eq!(told, format!("The turns about −1 can’t be counted; the closed loop is {word}"));
    }
    assert!(words::loops::nyquist(None, 0, Stability::Neutral).contains("goes through −1"));
    let told = words::loops::map((0.5, 1.0), 0.0, (0.2, 0.7));
    assert_eq!(
        told,
        "Least damped oscillation: none at k = 0.500; best without washout: ζ = 0.700 at k = 0.200"
    );
}

/// "deg" is no unit of a gain that is degrees per m/s.
#[test]
fn a_gain_is_read_with_its_whole_unit_or_in_si() {
    for (dimension, text, value) in [
        (Dimension::AnglePerSpeed, "0.1deg", None),
        (Dimension::AnglePerSpeed, "180 deg per m/s", Some(std::f64::consts::PI)),
        (Dimension::AnglePerSpeed, "0.1 rad/(m/s)", Some(0.1)),
        (Dimension::AnglePerLength, "0.1deg", None),
        (Dimension::SharePerSpeed, "5%", None),
        (Dimension::SharePerSpeed, "5 % per m/s", Some(0.05)),
        (Dimension::SharePerLength, "5 %", None),
        (Dimension::SharePerLength, "5 % of weight per m", Some(0.05)),
        (Dimension::ShareOfWeight, "5%", Some(0.05)),
        (Dimension::ShareOfWeight, "5 % of weight", Some(0.05)),
        (Dimension::Angle, "2deg", Some(2.0_f64.to_radians())),
    ] {
        let read = dimension.read(text);
        assert_eq!(read.is_some(), value.is_some(), "{dimension:?} {text}: {read:?}");
        assert!(read.zip(value).is_none_or(|(a, b)| (a - b).abs() < 1e-12), "{dimension:?} {text}: {read:?}");
        assert!(dimension.read(&format!("1 {}", dimension.symbol(LengthUnit::Metre))).is_some());
    }
}
