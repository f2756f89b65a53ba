//! The map of the damping over gain and washout, on the yaw damper of Franklin, Powell and Emami-Naeini's example 10.2, and the findings
//! that keep it.

mod franklin;

use std::rc::Rc;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::feedback::damping_map::{
    DampingMap, best_gain, law_with, least_damping, place_of, washout_at,
};
use eigenwing::flight::feedback::{Law, analyse_loop};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::scenario::{Parameter, Scenario};
use franklin::franklin;

fn law() -> Law {
    Law { actuator: 0.1, ..Law::default() }
}

/// The numbers of the textbook case, as python-control has them.
#[test]
fn the_best_gain_with_a_washout_and_without_is_that_of_the_textbook_case() {
    let model = franklin();
    for (washout, gain, damping, spiral) in [(0.0, 2.65, 0.479, -0.331), (3.0, 2.32, 0.273, -0.004)] {
        let (found, reached) = best_gain(&model, &law(), 1, washout, [0.0, 5.0]).expect("roots");
        assert!((found - gain).abs() < 0.01, "{washout} s: k = {found}");
        assert!((reached - damping).abs() < 5e-4, "{washout} s: ζ = {reached}");
        let best = law_with(&law(), &model, 1, found, washout);
        let closed = analyse_loop(&model, &best, None).expect("it can be analysed");
        let spirals = closed.modes.iter().filter(|mode| mode.mode.naming.name == ModeName::Spiral);
        let root = spirals.map(|mode| mode.mode.lambda.re).next().expect("a spiral");
        assert!((root - spiral).abs() < 5e-3, "{washout} s: spiral {root}");
    }
}

#[test]
fn where_every_gain_takes_damping_away_the_best_is_none() {
    let model = franklin();
    // Against its sense the damper drives the Dutch roll.
    let (gain, damping) = best_gain(&model, &law(), 1, 3.0, [-5.0, 0.0]).expect("roots");
    assert_eq!((gain, Some(damping)), (0.0, least_damping(&model, &law())));
}

#[test]
fn a_map_holds_the_damping_of_each_of_its_laws_and_its_lines_pass_between_them() {
    let model = franklin();
    let map = DampingMap::of(&model, &law(), (1, 5.0), (40, 20)).expect("roots");
    assert_eq!((map.gains.len(), map.places.len(), map.reach()), (41, 22, 5.0));
    assert!(map.levels.is_empty() && map.bound_of(Level::One).is_empty());
    for (row, place) in map.places.iter().enumerate() {
        for (column, gain) in map.gains.iter().enumerate() {
            let of = law_with(&law(), &model, 1, *gain, washout_at(*place));
            assert_eq!(Some(map.damping[row][column]), least_damping(&model, &of));
        }
    }
    for value in [0.1, 0.2, 0.3] {
        let line = map.damped_by(value);
        assert!(line.len() > 10, "{value}: {}", line.len());
        for (gain, place) in line.into_iter().flatten() {
            let of = law_with(&law(), &model, 1, gain, washout_at(place));
            let damping = least_damping(&model, &of).expect("roots");
            // Straight within a square of the map; beyond the longest washout a place means it or none.
            let between = place > place_of(20.0);
            assert!(between || (damping - value).abs() < 0.02, "{value} at {gain}, {place}: {damping}");
        }
    }
}

#[test]
fn every_washout_of_the_map_is_at_its_place_and_the_longest_of_all_is_none() {
    for washout in [0.1, 0.7, 3.0, 20.0, 0.0] {
        assert!((washout_at(place_of(washout)) - washout).abs() < 1e-12, "{washout}");
    }
    assert!(place_of(0.0) > place_of(20.0));
    assert_eq!(washout_at(9.0), 0.0);
}

fn scenario(values: &[(&str, f64)]) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == "b747-cruise-etkin");
    let mut scenario = Scenario::new(Arc::new(found.expect("it ships")));
    scenario.plane = Plane::Lateral;
    set(&mut scenario, values);
    scenario
}

fn set(scenario: &mut Scenario, values: &[(&str, f64)]) {
    for (key, value) in values {
        Parameter::find(key).expect("a row").set(scenario, *value);
    }
}

#[test]
fn the_map_is_kept_while_its_point_moves_and_made_again_for_another_aircraft() {
    let first = Findings::of(scenario(&[("k.r_dr", 1.0), ("washout", 3.0), ("actuator", 0.1)]));
    assert_eq!(first.mapped_input(0), Some(1));
    let map = first.damping_map(1, 2.0, false).expect("a map");
    let mut moved = first.scenario().clone();
    set(&mut moved, &[("k.r_dr", 0.4), ("washout", 0.0)]);
    let second = first.after(moved.clone());
    assert!(Rc::ptr_eq(&map, &second.damping_map(1, 2.0, true).expect("the same")));
    set(&mut moved, &[("actuator", 0.3)]);
    let third = second.after(moved);
    let other = third.damping_map(1, 2.0, true).expect("another");
    assert!(!Rc::ptr_eq(&map, &other) && other.gains.len() < map.gains.len());
    // A coarse one is refined as soon as there is time.
    assert!(third.damping_map(1, 2.0, false).expect("a fine one").gains.len() == map.gains.len());
}

#[test]
fn levels_have_limits_where_the_aircraft_has_a_class() {
    let findings = Findings::of(scenario(&[("k.r_dr", 1.0), ("washout", 3.0), ("actuator", 0.1)]));
    assert!(findings.scenario().task.is_some());
    let rows = findings.damping_map(1, 4.0, false).expect("a map").places.len();
    // One washout after the other, so that no frame takes long.
    assert_eq!((0..rows + 5).filter(|_| findings.judge_map()).count(), rows);
    let map = findings.damping_map(1, 4.0, false).expect("the same");
    // Damping buys Level 2, and the map shows where; the roll mode, which the rudder doesn't quicken, keeps it from Level 1.
    assert!(!map.bound_of(Level::Two).is_empty());
    assert!(map.levels.iter().flatten().all(|level| *level != Some(Level::One)));
    let open = Findings::of(scenario(&[]));
    assert_eq!(open.mapped_input(0), None);
    assert!(open.loop_curve(1).is_none());
}

#[test]
fn a_loop_over_frequency_has_the_gain_one_at_the_crossover_of_its_phase_margin() {
    let findings = Findings::of(scenario(&[("k.r_dr", 3.0), ("washout", 3.0), ("actuator", 0.1)]));
    let curve = findings.loop_curve(1).expect("the rudder is driven");
    let margin = curve.margins.phase.expect("a crossover");
    let value = curve.transfer.over_frequency(margin.frequency).expect("no pole there");
    assert!((value.norm() - 1.0).abs() < 1e-9);
    assert!(curve.points.iter().is_sorted_by(|a, b| a.frequency < b.frequency));
    let function = curve.function.as_ref().expect("roots");
    assert_eq!(function.poles.len(), 6);
    assert!(findings.loop_curve(0).is_none() && findings.loop_curve(2).is_none());
}
