//! The aircraft at one moment, against the motion that it is a moment of.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::scenario::{Parameter, Scenario, Source};

fn scenarios() -> impl Iterator<Item = Scenario> {
    let (aircraft, _) = embedded_aircraft();
    aircraft.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft)))
}

/// The four forces add up to nothing in steady flight, whatever its speed, its climb or the aircraft's weight.
#[test]
fn in_steady_flight_the_four_forces_are_in_balance() {
    let mut balanced = 0;
    for aircraft in scenarios() {
        for (key, share) in [("speed", 1.0), ("speed", 1.1), ("mass", 1.05), ("climb", 0.0)] {
            let mut scenario = aircraft.clone();
            let Some(parameter) = Parameter::find(key).filter(|p| p.applies(&scenario)) else { continue };
            parameter.set(&mut scenario, parameter.get(&aircraft) * share);
            let findings = Findings::of(scenario);
            let Some(flown) = findings.trajectory(false) else { continue };
            let forces = flown.pose(0.5, 1.0).forces;
            for axis in 0..3 {
                let sum: f64 = forces.iter().map(|force| force[axis]).sum();
                assert!(sum.abs() < 1e-12, "{} {key}: {sum} along axis {axis}", aircraft.aircraft.key);
            }
            balanced += 1;
        }
    }
    assert!(balanced >= 10, "{balanced}");
}

/// Where a source gives neither mass nor drag too.
#[test]
fn every_aircraft_has_its_lift_and_its_weight() {
    let mut without_drag = 0;
    for scenario in scenarios() {
        let findings = Findings::of(scenario.clone());
        let flown = findings.trajectory(false).expect("a motion");
        let size = |force: [f64; 3]| force.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [lift, weight, thrust, drag] = flown.pose(0.5, 1.0).forces.map(size);
        let key = &scenario.aircraft.key;
        assert!((lift - weight).abs() < 0.02 * weight && weight > 0.5, "{key}: {lift} {weight}");
        assert!((thrust - drag).abs() < 0.15 * weight && drag > 0.01, "{key}: {thrust} {drag}");
        without_drag += usize::from(!flown.is_drag_known());
    }
    assert!(without_drag >= 5, "{without_drag}");
}

#[test]
fn more_weight_needs_more_lift() {
    let mut scenario = scenarios().next().expect("the Navion");
    let weight = |scenario: &Scenario| {
        let findings = Findings::of(scenario.clone());
        let flown = findings.trajectory(false).expect("a motion");
        let [lift, weight, ..] = flown.pose(0.5, 1.0).forces;
        assert!((lift[2] + weight[2]).abs() < 0.02);
        weight.iter().map(|x| x * x).sum::<f64>().sqrt()
    };
    let before = weight(&scenario);
    let mass = Parameter::find("mass").expect("a knob");
    let heavier = 1.1 * mass.get(&scenario);
    mass.set(&mut scenario, heavier);
    assert!((weight(&scenario) / before - 1.1).abs() < 1e-9);
}

#[test]
fn before_the_disturbance_it_flies_on_as_trimmed() {
    for scenario in scenarios() {
        let findings = Findings::of(scenario);
        let flown = findings.trajectory(false).expect("a motion");
        let (pose, motion) = (flown.pose(0.9, 1.0), flown.motion);
        for (place, level) in pose.position.into_iter().zip(pose.steady_position) {
            assert!((place - level).abs() < 1e-9);
        }
        // θ = γ + α, of the fuselage as of the path.
        assert!((pose.attitude[1] - motion.model.trim.gamma0 - pose.alpha).abs() < 1e-12);
        assert_eq!((pose.beta, pose.deflections), (0.0, [0.0; 3]));
    }
}

/// Linear or nonlinear, small enough, it is in the same place.
#[test]
fn the_nonlinear_flight_of_a_small_disturbance_is_seen_in_the_same_place() {
    let mut scenario = scenarios().next().expect("the Navion");
    for plane in Plane::ALL {
        scenario.plane = plane;
        scenario.disturbance.sizes.times = 0.01;
        scenario.disturbance.sizes.time = 10.0;
        let findings = Findings::of(scenario.clone());
        assert!(findings.flight().is_some_and(Result::is_ok));
        let [linear, nonlinear] = [false, true].map(|on| findings.trajectory(on).expect("a motion"));
        for t in [0.0, 1.03, 3.333, 9.99] {
            let (a, b) = (linear.pose(t, 1.0), nonlinear.pose(t, 1.0));
            for (a, b) in
                a.attitude.into_iter().chain(a.position).zip(b.attitude.into_iter().chain(b.position))
            {
                assert!((a - b).abs() < 2e-3, "{plane:?} at {t}: {a} and {b}");
            }
        }
    }
}

#[test]
fn one_mode_alone_is_exaggerated_by_the_stated_round_factor_and_nothing_else_is() {
    for aircraft in scenarios() {
        for plane in Plane::ALL {
            let mut scenario = aircraft.clone();
            scenario.plane = plane;
            if let Some(usual) = Findings::of(scenario.clone()).trajectory(false) {
                assert_eq!(usual.exaggeration(), 1.0);
            }
            scenario.disturbance.choices[plane].source = Source::OneMode;
            scenario.disturbance.sizes.mode = 0.01;
            let findings = Findings::of(scenario);
            let Some(flown) = findings.trajectory(false) else { continue };
            let factor = flown.exaggeration();
            let output = if plane == Plane::Longitudinal { Output::AngleOfAttack } else { Output::Sideslip };
            let [once, large] = [1.0, factor].map(|factor| {
                let pose = flown.pose(0.3, factor);
                if plane == Plane::Longitudinal { pose.alpha } else { pose.beta }
            });
            let trim = flown.pose(0.3, 0.0);
            let trim = if plane == Plane::Longitudinal { trim.alpha } else { trim.beta };
            assert!(((large - trim) - factor * (once - trim)).abs() < 1e-12, "{output:?}");
            assert!(flown.moments(0.3).iter().all(|moment| moment.size.abs() <= 1.0));
            assert_eq!(flown.moments(0.3).len(), if plane == Plane::Longitudinal { 2 } else { 4 });
        }
    }
}

/// What damps turns against its rate, what restores turns against its angle, in a stable aircraft.
#[test]
fn damping_moments_act_against_the_rates_they_damp() {
    let mut scenario = scenarios().next().expect("the Navion");
    scenario.plane = Plane::Lateral;
    scenario.disturbance.choices.lateral.source = Source::OneMode;
    let findings = Findings::of(scenario);
    let flown = findings.trajectory(false).expect("a motion");
    for t in [0.1, 0.7, 1.3] {
        let pose = flown.pose(t, 1.0);
        for moment in flown.moments(t).iter().filter(|moment| moment.damps) {
            assert!(moment.size * pose.rates[moment.axis] <= 0.0, "{} at {t}", moment.symbol);
        }
        let weathercock = flown.moments(t)[0].size;
        assert!(weathercock * pose.beta >= 0.0, "the nose turns into the wind");
    }
}

/// A linear motion is flown while it is a small disturbance; the nonlinear one goes on.
#[test]
fn the_aircraft_stays_at_the_last_small_state() {
    let mut scenario = scenarios().next().expect("the Navion");
    let cm_alpha = Parameter::find("cm_alpha").expect("a coefficient");
    cm_alpha.set(&mut scenario, 0.5);
    let findings = Findings::of(scenario);
    let flown = findings.trajectory(false).expect("a motion");
    let end = flown.motion.small_until.expect("it diverges");
    assert!(flown.flown_until() < end && end - flown.flown_until() < 0.1 && end < flown.end());
    let [before, last, after] =
        [0.5 * end, flown.flown_until(), flown.end()].map(|time| flown.pose(time, 1.0));
    assert!(before != last && last == after);
    assert!(last.attitude[1].abs() < 1.2 && (last.alpha - before.alpha).abs() < 0.5, "{last:?}");
    assert_eq!(flown.path(flown.end(), 3.0, 1.0), flown.path(flown.flown_until(), 3.0, 1.0));
    let flown = findings.trajectory(true).expect("a flight");
    assert_eq!(flown.flown_until(), flown.end());
}

#[test]
fn the_whole_path_begins_and_ends_with_the_motion_and_is_as_long_as_the_flight() {
    let scenario = scenarios().next().expect("the Navion");
    let findings = Findings::of(scenario);
    let flown = findings.trajectory(false).expect("a motion");
    let path = flown.whole_path(1.0);
    let (first, last) = (path[0], path[path.len() - 1]);
    assert_eq!(first, flown.pose(0.0, 1.0).position);
    assert_eq!(last, flown.pose(flown.end(), 1.0).position);
    let flown_straight = flown.motion.model.trim.speed * flown.end();
    assert!((2.0 * flown.path_reach(1.0) / flown_straight - 1.0).abs() < 0.2, "{}", flown.path_reach(1.0));
}

/// So that the x axis of stability axes lies along it.
#[test]
fn before_anything_disturbs_it_the_angle_of_attack_is_that_of_the_steady_flight() {
    let mut tilted = 0;
    for scenario in scenarios() {
        let findings = Findings::of(scenario);
        let Some(flown) = findings.trajectory(false) else { continue };
        let alpha = flown.steady_alpha();
        assert!((flown.pose(0.0, 1.0).alpha - alpha).abs() < 1e-12, "{}", flown.scenario.aircraft.key);
        tilted += usize::from(alpha.abs() > 0.01);
    }
    assert!(tilted > 5, "{tilted}");
}
