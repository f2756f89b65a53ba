//! What a stage locks stays as it is, whatever is done to the rest.

use std::sync::{Arc, LazyLock};

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Hidden, Lock, Parameter, Scenario, Source, Stage, parameters};
use proptest::prelude::*;
use proptest::sample::Index;

static AIRCRAFT: LazyLock<Vec<Arc<Aircraft>>> =
    LazyLock::new(|| embedded_aircraft().0.into_iter().map(Arc::new).collect());

/// What is stored of a parameter: of what follows from the rest, what is added to it.
fn own(parameter: &Parameter, scenario: &Scenario) -> f64 {
    parameter.added(scenario).unwrap_or_else(|| parameter.get(scenario))
}

fn apply(scenario: &mut Scenario, edits: &[(Index, f64)]) {
    let rows: Vec<&Parameter> = parameters().collect();
    for (row, fraction) in edits {
        let row = row.get(&rows);
        let range = row.range(scenario);
        let value = range.start() + fraction * (range.end() - range.start());
        if row.check(scenario, value).is_ok() {
            row.set(scenario, value);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_locked_stays_to_the_last_bit_and_the_rest_moves(
        of in any::<Index>(),
        first in prop::collection::vec((any::<Index>(), 0.0..1.0), 0..20),
        then in prop::collection::vec((any::<Index>(), 0.0..1.0), 1..30),
        locked in prop::collection::vec(any::<Index>(), 1..12),
        locks in prop::collection::vec(prop::sample::select(Lock::VALUES), 0..3),
    ) {
        let mut before = Scenario::new(of.get(&AIRCRAFT).clone());
        apply(&mut before, &first);
        let rows: Vec<&Parameter> = parameters().filter(|p| p.is_of_disturbance() || p.applies(&before)).collect();
        let mut stage = Stage::default().locking(locks);
        stage.locked = locked.iter().map(|index| index.get(&rows).key).collect();
        let mut moved = before.clone();
        apply(&mut moved, &then);
        moved.disturbance.choices[Plane::Longitudinal].source = Source::Throttle;
        let mut held = moved.clone();
        stage.hold(&before, &mut held);
        for row in rows {
            let wanted = if stage.locks_parameter(row) { &before } else { &moved };
            prop_assert_eq!(own(row, &held), own(row, wanted), "{}", row.key);
        }
        let of_source = if stage.locks_up(Lock::Disturbance) { &before } else { &moved };
        prop_assert_eq!(&held.disturbance.choices, &of_source.disturbance.choices);
        // Nothing is left to do.
        let once = held.clone();
        stage.hold(&before, &mut held);
        prop_assert!(once == held);
    }
}

#[test]
fn neither_another_aircraft_nor_the_other_plane_gets_round_a_lock() {
    let [navion, boeing] = ["navion", "b747-approach"]
        .map(|key| AIRCRAFT.iter().find(|aircraft| aircraft.key == key).expect("an aircraft").clone());
    let mut before = Scenario::new(navion);
    let cm_alpha = Parameter::find("cm_alpha").expect("a row");
    cm_alpha.set(&mut before, -0.9);
    let elsewhere = Scenario { plane: Plane::Lateral, ..before.with_aircraft(boeing) };
    let hold = |stage: Stage| {
        let mut now = elsewhere.clone();
        stage.hold(&before, &mut now);
        (now.aircraft.key.clone(), now.plane, cm_alpha.get(&now))
    };
    let of_boeing = cm_alpha.get(&elsewhere);
    assert_eq!(hold(Stage::default()), ("b747-approach".to_owned(), Plane::Lateral, of_boeing));
    let aircraft = Stage::default().locking(vec![Lock::Aircraft]);
    assert_eq!(hold(aircraft), ("navion".to_owned(), Plane::Lateral, -0.9));
    let unnamed = Stage::default().hiding(vec![Hidden::AircraftName]);
    assert_eq!(hold(unnamed), ("navion".to_owned(), Plane::Lateral, -0.9), "the list has names in it");
    let plane = Stage::default().locking(vec![Lock::Plane]);
    assert_eq!(hold(plane), ("b747-approach".to_owned(), Plane::Longitudinal, of_boeing));
}

#[test]
fn a_time_that_is_locked_follows_only_if_it_did() {
    let before = Scenario::new(AIRCRAFT[0].clone());
    let mut stage = Stage::default();
    stage.locked = vec!["time"];
    let mut now = before.clone();
    now.disturbance.follows = !before.disturbance.follows;
    stage.hold(&before, &mut now);
    assert_eq!(now.disturbance.follows, before.disturbance.follows);
}
