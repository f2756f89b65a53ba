//! Everything that follows from a scenario: found once, and by one rule for everyone who asks.

use std::rc::Rc;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::{Extreme, Findings, Remark};
use eigenwing::flight::motion::outputs::Output;
use eigenwing::scenario::{Page, Parameter, Scenario, Source};

fn aircraft(key: &str) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    Scenario::new(Arc::new(found.expect("an aircraft of the list")))
}

fn row(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row")
}

fn with(mut scenario: Scenario, key: &str, value: f64) -> Scenario {
    row(key).set(&mut scenario, value);
    scenario
}

#[test]
fn nothing_is_computed_before_it_is_asked_for_and_nothing_twice() {
    let findings = Findings::of(aircraft("navion"));
    assert!(!findings.is_analysed());
    let same = |once: [*const (); 7], twice: [*const (); 7]| assert_eq!(once, twice);
    let results = || {
        [
            std::ptr::from_ref(findings.analysis()).cast(),
            findings.sensitivities(Page::Coefficients).as_ptr().cast(),
            std::ptr::from_ref(findings.metrics().expect("a motion")).cast(),
            std::ptr::from_ref(findings.flight().expect("a motion")).cast(),
            std::ptr::from_ref(findings.split(Output::Height).expect("a motion")).cast(),
            std::ptr::from_ref(findings.frequency(Output::PitchRate).expect("a motion")).cast(),
            findings.level_boundaries().as_ptr().cast(),
        ]
    };
    same(results(), results());
    assert!(findings.is_analysed());
}

/// The locus is that of the slider: how far along it the slider stands changes nothing, anything else does.
#[test]
fn a_locus_stays_while_its_own_slider_moves_and_only_then() {
    let findings = Findings::of(aircraft("navion"));
    let slider = row("cm_alpha");
    let locus = findings.locus(slider);
    let dragged = findings.after(with(aircraft("navion"), "cm_alpha", -0.3));
    assert!(Rc::ptr_eq(&locus, &dragged.locus(slider)));
    let longer = dragged.after(with(dragged.scenario().clone(), "time", 20.0));
    assert!(Rc::ptr_eq(&locus, &longer.locus(slider)));
    let faster = longer.after(with(longer.scenario().clone(), "speed", 60.0));
    assert!(*faster.locus(slider) != *locus);
}

#[test]
fn where_a_mode_grows_there_is_no_peak_over_frequency() {
    let stable = Findings::of(aircraft("navion"));
    assert!(stable.growing_mode().is_none());
    assert!(!stable.frequency(Output::PitchRate).expect("a response").peaks.is_empty());
    let growing = with(with(aircraft("navion"), "cm_q", 9.96), "cl_alpha", 2.0);
    let growing = Findings::of(growing);
    assert!(growing.growing_mode().is_some());
    let response = growing.frequency(Output::PitchRate).expect("a response");
    assert!(response.peaks.is_empty() && response.points.len() > 300);
}

/// However few frequencies are asked for, those are among the ones followed, and the peaks are the same.
#[test]
fn few_frequencies_have_the_peaks_of_many() {
    let findings = Findings::of(aircraft("b747-fc9"));
    let range = findings.frequency_range();
    let over = |count| findings.frequency_over(Output::PitchRate, range, count).expect("a response");
    let (few, many) = (over(5), over(401));
    assert_eq!((few.points.len(), many.points.len()), (5, 401));
    assert_eq!(few.peaks.len(), many.peaks.len());
    for (few, many) in few.peaks.iter().zip(&many.peaks) {
        assert!((few.frequency / many.frequency - 1.0).abs() < 1e-6, "{few:?} {many:?}");
    }
    for (k, point) in few.points.iter().enumerate() {
        assert!((point.frequency / many.points[100 * k].frequency - 1.0).abs() < 1e-12);
        assert!((point.phase - many.points[100 * k].phase).abs() < 1e-9, "{point:?}");
    }
}

/// A value that still grows where the linear model ends is no peak, and nothing is said of rise and overshoot.
#[test]
fn what_is_cut_off_is_no_peak_and_has_no_rise_time() {
    let findings = Findings::of(with(aircraft("navion"), "cm_alpha", -0.25));
    let end = findings.motion().and_then(|motion| motion.small_until).expect("it leaves the linear model");
    assert!(end < findings.scenario().disturbance.sizes.time);
    let metrics = findings.metrics().expect("a motion");
    let of = |output| metrics.outputs.iter().find(|of| of.output == output).expect("an output");
    assert!(matches!(of(Output::ForwardSpeed).extreme, Some(Extreme::Beyond(value)) if value > 26.0));
    assert!(matches!(of(Output::PitchAngle).extreme, Some(Extreme::Peak { time, .. }) if time < end));
    assert!(metrics.outputs.iter().all(|of| of.step.is_none()));
}

#[test]
fn root_mean_squares_are_of_turbulence_alone() {
    let mut scenario = aircraft("navion");
    let squares = |scenario: &Scenario| {
        let findings = Findings::of(scenario.clone());
        let metrics = findings.metrics().expect("a motion").clone();
        metrics.outputs.iter().filter(|of| of.root_mean_square.is_some_and(|x| x > 0.0)).count()
    };
    assert_eq!(squares(&scenario), 0);
    scenario.disturbance.choices.longitudinal.source = Source::Turbulence;
    assert_eq!(squares(&scenario), Output::of(scenario.plane).len());
}

#[test]
fn only_the_aircraft_of_two_unit_systems_has_a_remark() {
    for aircraft in embedded_aircraft().0 {
        let key = aircraft.key.clone();
        let remarks = Findings::of(Scenario::new(Arc::new(aircraft))).remarks();
        let is_mixed = matches!(remarks[..], [Remark::MixedUnits(_)]);
        assert_eq!(
            (is_mixed, remarks.len()),
            (key == "lesson-printed", usize::from(key == "lesson-printed")),
            "{key}"
        );
    }
}

/// At the ends of the part that exists there is a flight, and just outside there is none.
#[test]
fn the_part_of_a_slider_that_exists_ends_where_flight_does() {
    let scenario = aircraft("navion");
    let findings = Findings::of(scenario.clone());
    let mut cut = 0;
    for key in ["speed", "altitude", "mass", "cm_alpha"] {
        let parameter = Parameter::find(key).expect("a row");
        let whole = parameter.range(&scenario);
        let Some(exists) = findings.existing_range(parameter) else { continue };
        let step = (whole.end() - whole.start()) / 2000.0;
        let flies = |value: f64| with(scenario.clone(), key, value).analyse().is_ok();
        assert!(flies(*exists.start()) && flies(*exists.end()), "{key}");
        for (end, beyond) in [(*exists.start(), -step), (*exists.end(), step)] {
            assert!(!whole.contains(&(end + beyond)) || !flies(end + beyond), "{key} at {end}");
        }
        cut += 1;
    }
    assert!(cut >= 2, "{cut}");
    let cm_alpha = Parameter::find("cm_alpha").expect("a row");
    assert_eq!(findings.existing_range(cm_alpha), None);
}
