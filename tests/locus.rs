//! Root loci: the Navion's critical points, and what holds for every model.

mod reference;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::eigen::eigenvalues;
use eigenwing::flight::modes::locus::{Locus, MOST_EVALUATIONS, Sample, locus};
use eigenwing::flight::modes::mode_name::ModeName::{self, *};
use eigenwing::scenario::{Page, Scenario, parameters};
use nalgebra::{Complex, Matrix4};
use proptest::prelude::*;
use reference::{all_models, navion_with_m_w, reference, sweeps};
use std::cell::Cell;
use std::sync::Arc;

fn poles(locus: &Locus) -> Vec<(f64, [Complex<f64>; 4])> {
    locus.samples.iter().filter_map(|s| Some((s.parameter, four(s)?))).collect()
}

/// The poles of an aircraft without a law.
fn four(sample: &Sample) -> Option<[Complex<f64>; 4]> {
    sample.poles.as_ref().map(|poles| poles.as_slice().try_into().expect("four"))
}

/// The largest |λ − λ'| of a pole λ' of the locus and the solver's λ that is nearest to it, as a fraction of the largest |λ|.
///
/// Where two poles are apart by a gap, each is good to rounding times ρ/gap: the error times the gap is compared.
fn error(found: [Complex<f64>; 4], solved: [Complex<f64>; 4]) -> f64 {
    let radius = solved[0].norm().max(f64::MIN_POSITIVE);
    let error = |pole: Complex<f64>| {
        let mut distances = solved.map(|other| (other - pole).norm() / radius);
        distances.sort_by(f64::total_cmp);
        distances[0] * distances[1]
    };
    found.map(error).into_iter().fold(0.0, f64::max)
}

fn assert_laws(found: &Locus, model: impl Fn(f64) -> Option<Matrix4<f64>>) {
    assert!(found.evaluations <= MOST_EVALUATIONS);
    assert!(found.samples.windows(2).all(|pair| pair[0].parameter < pair[1].parameter));
    for sample in &found.samples {
        let exact = model(sample.parameter).and_then(|a| eigenvalues(&a).ok());
        assert_eq!(sample.poles.is_some(), exact.is_some());
        let (Some(poles), Some(exact)) = (four(sample), exact) else { continue };
        assert!(error(poles, exact.into()) < 1e-11, "{poles:?} {exact:?}");
        for pole in poles {
            let count = |v| poles.iter().filter(|&&x| x == v).count();
            assert_eq!(count(pole), count(pole.conj()), "{poles:?}");
        }
    }
}

/// Every slider of every aircraft: the poles that are followed are the solver's, and it is rarely asked.
#[test]
fn followed_poles_are_those_of_the_solver_for_every_slider_of_every_aircraft() {
    let (mut samples, mut solved, mut worst) = (0, 0, 0.0_f64);
    for aircraft in embedded_aircraft().0 {
        let planes =
            Plane::ALL.into_iter().filter(|plane| aircraft.plane_notes[*plane].is_some()).collect::<Vec<_>>();
        let mut scenario = Scenario::new(Arc::new(aircraft));
        for plane in planes {
            scenario.plane = plane;
            let sliders = parameters().filter(|p| Page::ALL.iter().any(|page| p.is_shown(&scenario, *page)));
            for slider in sliders {
                let model = |value: f64| {
                    let mut at = scenario.clone();
                    slider.set(&mut at, value);
                    Some(at.edited.models().ok()?.planes[plane].as_ref()?.a)
                };
                let range = slider.range(&scenario);
                let ends = (*range.start(), *range.end());
                let found = locus(plane, model, ends, slider.get(&scenario), 200);
                assert_laws(&found, model);
                for sample in &found.samples {
                    let Some(exact) = model(sample.parameter).and_then(|a| eigenvalues(&a).ok()) else {
                        continue;
                    };
                    let Some(poles) = four(sample) else { continue };
                    worst = worst.max(error(poles, exact.into()));
                    samples += 1;
                    // To the last bit only where it was the solver that was asked.
                    solved += usize::from(exact.iter().all(|value| poles.contains(value)));
                }
            }
        }
    }
    assert!(samples > 50_000, "{samples}");
    assert!(solved * 20 < samples, "{solved} of {samples}");
    assert!(worst < 1e-12, "{worst:e}");
}

/// The largest step of a branch in units of its own size, of a 500th of the largest pole at least.
fn coarsest(found: &Locus) -> f64 {
    let all = poles(found);
    let radius = all.iter().flat_map(|(_, poles)| poles).map(|pole| pole.norm()).fold(0.0, f64::max);
    let steps = all.windows(2).flat_map(|pair| {
        let (a, b) = (pair[0].1, pair[1].1);
        (0..4).map(move |i| (b[i] - a[i]).norm() / (0.5 * (a[i].norm() + b[i].norm())).max(2e-3 * radius))
    });
    steps.fold(0.0, f64::max)
}

#[test]
fn the_navions_locus_meets_where_its_poles_do() {
    let model = |factor: f64| Some(navion_with_m_w(factor));
    let calls = Cell::new(0);
    let counted = |factor: f64| {
        calls.set(calls.get() + 1);
        model(factor)
    };
    let found = locus(Plane::Longitudinal, counted, (-1.0, 2.0), 1.0, 200);
    assert_eq!(calls.get(), found.evaluations);
    assert_laws(&found, model);
    let mut critical: Vec<f64> =
        sweeps().changes_in_number_of_complex_pairs.iter().map(|change| change.factor).collect();
    critical.sort_by(f64::total_cmp);
    assert_eq!(found.meetings.len(), critical.len(), "{:?}", found.meetings);
    for ((low, high), critical) in found.meetings.iter().zip(critical) {
        // within 0.1 % of the range, and the source's 5e-5
        assert!(
            high - low < 3e-3 && (*low - 5e-5..=*high + 5e-5).contains(&critical),
            "{low} {high} {critical}"
        );
    }
    let mut names: Vec<ModeName> = found.names.iter().flatten().copied().collect();
    names.sort();
    assert_eq!(names, [ShortPeriod, ShortPeriod, Phugoid, Phugoid]);
    // All of NumPy's poles lie on it.
    for point in sweeps().m_w.iter().filter(|p| p.factor >= -1.0) {
        let at = locus(Plane::Longitudinal, model, (point.factor, 2.0), point.factor, 60);
        for pole in point.eigs.iter().map(reference::pole) {
            let nearest = poles(&at)[0].1.iter().map(|p| (p - pole).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-8);
        }
    }
    assert!(coarsest(&found) < 0.5, "{}", coarsest(&found));
}

#[test]
fn branches_of_a_pair_stay_conjugate_while_it_oscillates() {
    let found = locus(Plane::Longitudinal, |f| Some(navion_with_m_w(f)), (0.3, 2.0), 1.0, 200);
    for (_, poles) in poles(&found) {
        for name in [ShortPeriod, Phugoid] {
            let pair: Vec<_> = (0..4).filter(|&b| found.names[b] == Some(name)).map(|b| poles[b]).collect();
            assert!(pair.len() == 2 && pair[0] == pair[1].conj());
        }
    }
}

#[test]
fn a_model_that_ends_leaves_a_gap_and_no_panic() {
    let model = |f: f64| (!(0.4..=0.6).contains(&f)).then(|| navion_with_m_w(f));
    let found = locus(Plane::Longitudinal, model, (0.0, 1.0), 0.5, 200);
    assert_laws(&found, model);
    assert_eq!(found.names.as_slice(), [None; 4]);
    assert!(found.samples.iter().any(|s| s.poles.is_none()));
    let edge = found.samples.windows(2).find(|p| p[1].poles.is_none()).map(|p| p[0].parameter);
    assert!((edge.expect("an edge") - 0.4).abs() < 0.01);
}

#[test]
fn ranges_of_every_kind_have_an_answer() {
    let model = |f: f64| Some(navion_with_m_w(f));
    for range in [(1.0, 1.0), (2.0, -1.0), (0.0, f64::MIN_POSITIVE)] {
        let found = locus(Plane::Longitudinal, model, range, 1.0, 100);
        assert_laws(&found, model);
        assert!(!found.samples.is_empty());
    }
    for range in [(f64::NAN, 1.0), (0.0, f64::INFINITY), (-f64::MAX, f64::MAX)] {
        assert!(locus(Plane::Longitudinal, model, range, 1.0, 100).samples.is_empty());
    }
    assert!(poles(&locus(Plane::Lateral, |_| None, (0.0, 1.0), 0.5, 200)).is_empty());
}

#[test]
fn loci_of_every_reference_aircraft_are_continuous() {
    for (id, model) in all_models() {
        for (i, j) in [(1, 0), (1, 1), (2, 1)] {
            let at = |factor: f64| {
                let mut a = model.a;
                a[(i, j)] *= factor;
                Some(a)
            };
            let found = locus(model.plane, at, (-1.0, 3.0), 1.0, 200);
            assert_laws(&found, at);
            assert!(found.names.iter().all(Option::is_some), "{id}");
            let coarsest = coarsest(&found);
            assert!(coarsest < 0.5, "{id} {i}{j}: {coarsest}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_locus_obeys_the_laws(a in proptest::collection::vec(-5.0..5.0_f64, 16), b in proptest::collection::vec(prop_oneof![Just(0.0), -5.0..5.0_f64, -1e300..1e300_f64], 16), low in -2.0..0.0_f64, width in 0.0..4.0_f64, reference in -3.0..3.0_f64, most in 0..1000_usize) {
        let model = |p: f64| Some(Matrix4::from_row_slice(&a) + Matrix4::from_row_slice(&b) * p);
        let found = locus(Plane::Lateral, model, (low, low + width), reference, most);
        assert_laws(&found, model);
    }
}

#[test]
fn the_reference_is_a_sample_and_its_branches_carry_the_names() {
    let model = reference("navion_teper_sl").model(Plane::Lateral);
    let at = |f: f64| {
        let mut a = model.a;
        a[(2, 0)] *= f;
        Some(a)
    };
    let found = locus(Plane::Lateral, at, (-0.25, 2.0), 1.0, 60);
    let here = found.samples.iter().find(|s| s.parameter == 1.0).and_then(four).expect("a sample");
    for (pole, name) in here.iter().zip(found.names) {
        let expected = match name.expect("a name") {
            DutchRoll => Complex::new(-0.486767, pole.im.signum() * 2.334799),
            RollSubsidence => Complex::from(-8.434514),
            _ => Complex::from(-0.0087513),
        };
        assert!((pole - expected).norm() < 1e-5);
    }
}
