//! Placing a pole: what is within reach is reached with the least change, what isn't is said, and no bound is left.

mod reference;

use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::inverse::{
    Adjustable, InverseError, Linearised, OutOfReach, Placement, place_pole,
};
use eigenwing::flight::modes::mode::{Mode, modes_of};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::sensitivity::entry_rate;
use nalgebra::{Complex, Matrix4};
use proptest::prelude::*;
use reference::{all_models, reference};

type Entry = (usize, usize);

const PITCH: [Entry; 3] = [(1, 1), (2, 1), (2, 2)];

/// A with other numbers in some places, which are the parameters.
fn with_values(mut a: Matrix4<f64>, entries: &[Entry], values: &[f64]) -> Linearised {
    for (&entry, value) in entries.iter().zip(values) {
        a[entry] = *value;
    }
    // Of an entry that is named twice the last value holds.
    let is_held = |k: usize| entries[k + 1..].contains(&entries[k]);
    let rate = |k: usize| if is_held(k) { Matrix4::zeros() } else { entry_rate(entries[k].0, entries[k].1) };
    Linearised { a, rates: (0..entries.len()).map(rate).collect() }
}

/// The Navion with some entries of A as parameters.
fn navion(entries: &[Entry]) -> (impl Fn(&[f64]) -> Option<Linearised>, Vec<Adjustable>) {
    with_entries(reference("navion_teper_sl").model(Plane::Longitudinal).a, entries, (0.2, 3.0))
}

/// Entries of `a` free between two factors, a scale being their present size.
fn with_entries(
    a: Matrix4<f64>,
    entries: &[Entry],
    factors: (f64, f64),
) -> (impl Fn(&[f64]) -> Option<Linearised>, Vec<Adjustable>) {
    let parameters = entries
        .iter()
        .map(|&entry| {
            let ends = [a[entry] * factors.0, a[entry] * factors.1];
            let (lower, upper) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            Adjustable { value: a[entry], lower, upper, scale: a[entry].abs().max(1e-6) }
        })
        .collect();
    let entries = entries.to_vec();
    let model = move |p: &[f64]| Some(with_values(a, &entries, p));
    (model, parameters)
}

fn mode(plane: Plane, a: &Matrix4<f64>, name: ModeName) -> Mode {
    let modes = modes_of(plane, a).expect("modes");
    modes.into_iter().find(|mode| mode.naming.name == name).expect("the mode")
}

fn assert_within(found: &Placement, parameters: &[Adjustable]) {
    assert_eq!(found.values.len(), parameters.len());
    for (value, p) in found.values.iter().zip(parameters) {
        assert!((p.lower..=p.upper).contains(value), "{value} left {p:?}");
    }
    assert!(found.change.is_finite() && found.lambda.norm().is_finite());
}

fn short_period() -> Complex<f64> {
    let a = reference("navion_teper_sl").model(Plane::Longitudinal).a;
    mode(Plane::Longitudinal, &a, ModeName::ShortPeriod).lambda
}

#[test]
fn reachable_targets_are_reached_with_the_least_change() {
    let (model, parameters) = navion(&PITCH);
    let from = short_period();
    let mut compared = 0;
    for (re, im) in [(0.0, 0.0), (-0.5, 0.0), (0.5, 0.3), (-0.3, -1.0), (0.8, 1.0)] {
        let to = from + Complex::new(re, im);
        let found = place_pole(&model, &parameters, from, to).expect("an answer");
        assert_within(&found, &parameters);
        assert_eq!(found.out_of_reach, None, "{found:?}");
        let a = model(&found.values).expect("a model").a;
        let reached = mode(Plane::Longitudinal, &a, ModeName::ShortPeriod).lambda;
        assert!((reached - to).norm() < 1e-9, "{reached} {to}");
        // Three parameters, two equations: with the first held a little beside the answer and the others solved for anew,
        // the change is larger.
        for factor in [0.97, 1.03] {
            let mut held = parameters.clone();
            let value = (found.values[0] * factor).clamp(held[0].lower, held[0].upper);
            let shift = (value - parameters[0].value) / parameters[0].scale;
            held[0] = Adjustable { value, lower: value, upper: value, ..held[0] };
            let other = place_pole(&model, &held, from, to).expect("an answer");
            if other.out_of_reach.is_none() {
                let change = other.change.hypot(shift);
                assert!(change >= found.change - 1e-9, "{change} {} at {to}", found.change);
                compared += 1;
            }
        }
    }
    assert!(compared >= 8, "{compared}");
}

#[test]
fn a_pole_that_is_there_already_changes_nothing() {
    let (model, parameters) = navion(&PITCH);
    let found = place_pole(model, &parameters, short_period(), short_period()).expect("an answer");
    assert!(found.change < 1e-9 && found.out_of_reach.is_none());
}

#[test]
fn with_m_w_alone_the_damping_rate_is_out_of_reach() {
    // M_w moves the short period up and down; σ = (Zw + Mq)/2 stays.
    let (model, parameters) = navion(&[(2, 1)]);
    let from = short_period();
    let found = place_pole(&model, &parameters, from, from + Complex::new(1.5, 1.5)).expect("an answer");
    assert_within(&found, &parameters);
    assert_eq!(found.out_of_reach, Some(OutOfReach::Both), "{found:?}");
    // The nearest point: what is left is at a right angle to the way the pole can go.
    let left = (from + Complex::new(1.5, 1.5)) - found.lambda;
    assert!((left.re - 1.5).abs() < 0.02 && left.im.abs() < 0.02, "{left}");
}

#[test]
fn bounds_stop_the_search_and_the_nearest_point_is_told() {
    let (model, mut parameters) = navion(&PITCH);
    for p in &mut parameters {
        (p.lower, p.upper) = (p.value - 0.1 * p.scale, p.value + 0.1 * p.scale);
    }
    let from = short_period();
    // Twice the frequency at the same damping.
    let found = place_pole(&model, &parameters, from, from * 2.0).expect("an answer");
    assert_within(&found, &parameters);
    assert_eq!(found.out_of_reach, Some(OutOfReach::Frequency), "{found:?}");
    assert!(found.values.iter().zip(&parameters).all(|(v, p)| *v == p.lower || *v == p.upper));
    assert!((found.lambda - from * 2.0).norm() < from.norm());
    // The same frequency without damping.
    let undamped = Complex::new(0.0, from.norm());
    let found = place_pole(&model, &parameters, from, undamped).expect("an answer");
    assert_eq!(found.out_of_reach, Some(OutOfReach::Damping), "{found:?}");
}

#[test]
fn a_grid_finds_nothing_nearer_than_the_nearest() {
    let (model, mut parameters) = navion(&[(2, 1), (2, 2)]);
    for p in &mut parameters {
        (p.lower, p.upper) = (p.value - 0.2 * p.scale, p.value + 0.2 * p.scale);
    }
    let from = short_period();
    for to in [from * 2.0, Complex::new(-1.0, 1.0), Complex::new(-5.0, 3.0), Complex::new(-2.0, 9.0)] {
        let found = place_pole(&model, &parameters, from, to).expect("an answer");
        let miss = (found.lambda - to).norm();
        for i in 0..=20 {
            for j in 0..=20 {
                let at = |p: &Adjustable, k: i32| p.lower + (p.upper - p.lower) * f64::from(k) / 20.0;
                let a = model(&[at(&parameters[0], i), at(&parameters[1], j)]).expect("a model").a;
                let other = mode(Plane::Longitudinal, &a, ModeName::ShortPeriod).lambda;
                assert!((other - to).norm() > miss - 1e-6, "{to}: {i} {j}");
            }
        }
    }
}

#[test]
fn real_roots_move_along_the_axis_and_do_not_leave_it() {
    let a = reference("navion_teper_sl").model(Plane::Lateral).a;
    let (model, parameters) = with_entries(a, &[(1, 0), (1, 2), (2, 0), (2, 2)], (0.5, 2.0));
    let spiral = mode(Plane::Lateral, &a, ModeName::Spiral).lambda;
    let to = Complex::from(0.01);
    let found = place_pole(&model, &parameters, spiral, to).expect("an answer");
    assert_within(&found, &parameters);
    assert_eq!(found.out_of_reach, None, "{found:?}");
    let reached = mode(Plane::Lateral, &model(&found.values).expect("a model").a, ModeName::Spiral).lambda;
    assert!((reached - to).norm() < 1e-9);
    let off = place_pole(&model, &parameters, spiral, Complex::new(-0.01, 0.5)).expect("an answer");
    assert_eq!(off.out_of_reach, Some(OutOfReach::OffTheAxis));
    let far = place_pole(&model, &parameters, spiral, Complex::from(7.0)).expect("an answer");
    assert_eq!(far.out_of_reach, Some(OutOfReach::RealRoot));
    assert_within(&far, &parameters);
}

#[test]
fn every_mode_of_every_reference_aircraft_can_be_nudged() {
    for (id, model) in all_models() {
        let entries: Vec<Entry> =
            (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).filter(|&entry| model.a[entry] != 0.0).collect();
        let (at, parameters) = with_entries(model.a, &entries, (0.5, 1.5));
        for mode in modes_of(model.plane, &model.a).expect("modes") {
            let to = mode.lambda * Complex::new(1.05, if mode.is_oscillatory() { 0.03 } else { 0.0 });
            let found = place_pole(&at, &parameters, mode.lambda, to).expect("an answer");
            assert_within(&found, &parameters);
            assert_eq!(found.out_of_reach, None, "{id} {:?}: {found:?}", mode.naming.name);
            assert!((found.lambda - to).norm() < 1e-9 * to.norm().max(1.0));
            assert!(found.evaluations < 5000, "{id}: {}", found.evaluations);
        }
    }
}

#[test]
fn questions_that_make_no_sense_are_errors() {
    let (model, parameters) = navion(&PITCH);
    let ask = |change: fn(&mut Adjustable)| {
        let mut parameters = parameters.clone();
        change(&mut parameters[1]);
        place_pole(&model, &parameters, short_period(), short_period()).err()
    };
    assert_eq!(ask(|_| ()), None);
    assert_eq!(ask(|p| p.scale = 0.0), Some(InverseError::Question));
    assert_eq!(ask(|p| p.lower = p.upper), Some(InverseError::Question));
    assert_eq!(ask(|p| p.value = f64::NAN), Some(InverseError::Question));
    assert_eq!(ask(|p| p.upper = f64::INFINITY), Some(InverseError::Question));
    let nowhere = place_pole(&model, &parameters, short_period(), Complex::new(f64::NAN, 0.0));
    assert_eq!(nowhere, Err(InverseError::Question));
    assert_eq!(place_pole(|_| None, &parameters, short_period(), short_period()), Err(InverseError::NoModel));
    // No parameters: nothing can be done, and that is an answer.
    let found = place_pole(|_| model(&[-2.0, -0.13, -3.0]), &[], short_period(), Complex::new(-1.0, 1.0));
    assert!(found.expect("an answer").out_of_reach.is_some());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_question_has_an_answer_within_the_bounds(
        a in proptest::collection::vec(-5.0..5.0_f64, 16),
        entries in proptest::collection::vec((0..4_usize, 0..4_usize, 0.0..2.0_f64, 0.0..2.0_f64, prop_oneof![Just(1.0), 1e-6..1e3_f64]), 0..6),
        from in (-5.0..5.0_f64, -5.0..5.0_f64),
        to in (-8.0..8.0_f64, -8.0..8.0_f64),
        hole in prop_oneof![Just(f64::INFINITY), 0.0..5.0_f64],
    ) {
        let a = Matrix4::from_row_slice(&a);
        let parameters: Vec<Adjustable> = entries.iter().map(|&(i, j, below, above, scale)| {
            let value = a[(i, j)];
            Adjustable { value, lower: value - below, upper: value + above, scale }
        }).collect();
        let places: Vec<Entry> = entries.iter().map(|entry| (entry.0, entry.1)).collect();
        let model = |p: &[f64]| Some(with_values(a, &places, p)).filter(|found| found.a[(0, 0)].abs() < hole);
        let (from, to) = (Complex::new(from.0, from.1), Complex::new(to.0, to.1));
        match place_pole(model, &parameters, from, to) {
            Ok(found) => {
                assert_within(&found, &parameters);
                prop_assert!(found.evaluations < 40_000);
                let upper = Complex::new(to.re, to.im.abs());
                if found.out_of_reach.is_none() {
                    prop_assert!((found.lambda - upper).norm() < 1e-9);
                }
                // never farther than at the start
                let values = eigenwing::flight::modes::eigen::eigen(&a).expect("finite").values;
                let here = Complex::new(from.re, from.im.abs());
                let pole = values.iter().filter(|v| v.im >= 0.0).min_by(|x, y| (**x - here).norm().total_cmp(&(**y - here).norm())).expect("a pole");
                prop_assert!((found.lambda - upper).norm() <= (pole - upper).norm() * (1.0 + 1e-9) + 1e-9);
            }
            Err(error) => prop_assert_eq!(error, InverseError::NoModel),
        }
    }
}
