//! Every slider of every aircraft anywhere at once: the analysis is total, finite and closed under conjugation.

use std::cell::Cell;
use std::sync::{Arc, LazyLock};

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode::Mode;
use eigenwing::scenario::{Page, Parameter, Scenario, parameters};
use eigenwing::words;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

static SCENARIOS: LazyLock<Vec<Scenario>> = LazyLock::new(|| {
    embedded_aircraft().0.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft))).collect()
});

/// Where a slider may stand, as a fraction of its range; the ends, the middle and the reference more often than chance has it.
fn place() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![3 => Just(None), 1 => Just(Some(0.0)), 1 => Just(Some(1.0)), 3 => (0.0..=1.0).prop_map(Some)]
}

fn numbers(mode: &Mode) -> impl Iterator<Item = f64> {
    let derived = [
        mode.natural_frequency(),
        mode.damping_ratio(),
        mode.period(),
        mode.time_to_half(),
        mode.time_to_double(),
        mode.cycles(),
        mode.time_constant(),
    ];
    [mode.lambda.re, mode.lambda.im]
        .into_iter()
        .chain(mode.participation)
        .chain(derived.into_iter().flatten())
}

#[test]
fn the_analysis_is_total_and_finite() {
    let cases = 300;
    let (analysed, planes) = (Cell::new(0), Cell::new(0));
    let inputs = (0..SCENARIOS.len(), prop::collection::vec(place(), parameters().count()));
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    let outcome = TestRunner::new(config).run(&inputs, |(which, places)| {
        let mut scenario = SCENARIOS[which].clone();
        for (p, place) in parameters().zip(places) {
            if let Some(fraction) = place.filter(|_| p.applies(&scenario)) {
                let range = p.range(&scenario);
                let value = range.start() + fraction * (range.end() - range.start());
                if let Ok(value) = p.check(&scenario, value) {
                    p.set(&mut scenario, value);
                }
            }
        }
        for plane in Plane::ALL {
            if scenario.aircraft.plane_notes[plane].is_none() {
                continue;
            }
            scenario.plane = plane;
            let findings = Findings::of(scenario.clone());
            planes.set(planes.get() + 1);
            match findings.analysis() {
                Err(error) => prop_assert!(error.to_string().len() > 20),
                Ok(analysis) => {
                    if findings.plane().is_some() {
                        analysed.set(analysed.get() + 1);
                        assert_whole(&findings)?;
                    }
                    let states = analysis.motion.iter().flat_map(|motion| &motion.response.states);
                    prop_assert!(states.flat_map(|x| x.iter()).all(|x| x.is_finite()));
                }
            }
        }
        Ok(())
    });
    outcome.expect("a total and finite analysis");
    let (analysed, planes) = (analysed.get(), planes.get());
    assert!(10 * analysed > 7 * planes, "{analysed} of {planes} planes have modes");
}

/// All four roots, and finite numbers in all that follows from them.
fn assert_whole(findings: &Findings) -> Result<(), TestCaseError> {
    let Some(of_plane) = findings.plane() else { return Ok(()) };
    let roots: usize = of_plane.modes.iter().map(|mode| if mode.is_oscillatory() { 2 } else { 1 }).sum();
    prop_assert_eq!(roots, 4);
    prop_assert!(of_plane.modes.iter().flat_map(numbers).all(f64::is_finite));
    for verdict in &of_plane.levels {
        prop_assert!(!words::verdict::sentence(verdict).contains("NaN"));
    }
    for row in findings.sensitivities(Page::Coefficients) {
        prop_assert!(row.strengths.iter().flatten().all(|x| x.is_finite()), "{}", row.key);
    }
    let path = findings.locus(Parameter::find("a_ww").expect("a row"));
    let mut poles = path.samples.iter().filter_map(|s| s.poles.as_ref()).flatten();
    prop_assert!(poles.all(|l| l.re.is_finite() && l.im.is_finite()));
    Ok(())
}
