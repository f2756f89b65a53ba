//! A measure over a slider: the same numbers as a sweep has, found once, with what is stable and what the levels ask.

use std::rc::Rc;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::export::{Subject, Sweep, SweepRequest};
use eigenwing::findings::measures::Measure;
use eigenwing::findings::{Findings, MeasureChart};
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::scenario::view::ChartView;
use eigenwing::scenario::{Parameter, Scenario, parameters};
use serde_json::Value;

fn aircraft(key: &str) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    Scenario::new(Arc::new(found.expect("an aircraft of the list")))
}

fn row(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row")
}

fn measure(key: &str) -> Measure {
    Measure::find(key).expect("a measure")
}

fn with(mut scenario: Scenario, key: &str, value: f64) -> Scenario {
    row(key).set(&mut scenario, value);
    scenario
}

#[test]
fn a_chart_reads_what_a_sweep_reads() {
    for (over, key) in
        [("cg", "static_margin"), ("cm_alpha", "short_period.damping_ratio"), ("speed", "peak.alpha")]
    {
        let findings = Findings::of(aircraft("navion"));
        let chart = findings.chart(row(over), measure(key));
        assert!(chart.points.len() <= 60);
        let mut compared = 0;
        for point in chart.points.iter().step_by(3) {
            let request = SweepRequest {
                parameter: over.to_owned(),
                from: point.value,
                to: row(over).reference(findings.scenario()),
                points: 2,
                measures: vec![key.to_owned()],
            };
            let Ok(sweep) = Sweep::new(Subject::listed("navion").scene().expect("a scene"), &request) else {
                continue;
            };
            let swept = sweep.report().points.swap_remove(0);
            let swept = serde_json::to_value(swept.measures[0]).expect("JSON");
            assert_eq!(
                point.reading,
                swept.as_f64().or_else(|| swept.get("value").and_then(Value::as_f64)),
                "{over} {}",
                point.value
            );
            compared += 1;
        }
        assert!(compared > 4, "{over}");
    }
}

/// How far along it the slider stands changes nothing, nor does what the measure doesn't depend on.
#[test]
fn a_chart_stays_while_its_own_slider_moves() {
    let findings = Findings::of(aircraft("navion"));
    let (slider, of) = (row("cm_alpha"), measure("short_period.damping_ratio"));
    let chart = findings.chart(slider, of);
    let dragged = findings.after(with(aircraft("navion"), "cm_alpha", -0.3));
    assert!(Rc::ptr_eq(&chart, &dragged.chart(slider, of)));
    let harder = dragged.after(with(dragged.scenario().clone(), "elevator", 0.1));
    assert!(Rc::ptr_eq(&chart, &harder.chart(slider, of)));
    let faster = harder.after(with(harder.scenario().clone(), "speed", 60.0));
    assert!(*faster.chart(slider, of) != *chart);
    // The motion on screen depends on the stick.
    let peak = measure("peak.alpha");
    assert!(*harder.chart(slider, peak) != *dragged.chart(slider, peak));
}

#[test]
fn a_chart_tells_where_it_is_stable_and_what_the_levels_ask() {
    let findings = Findings::of(aircraft("navion"));
    let chart = findings.chart(row("cm_alpha"), measure("short_period.damping_ratio"));
    let parts: Vec<_> = chart.stabilities().collect();
    assert_eq!(parts.iter().map(|part| part.1).collect::<Vec<_>>(), [Stability::Stable, Stability::Unstable]);
    // C_mα = 0 is where det A changes its sign, found to a fortieth of a thirty-second of the slider.
    let (range, _) = &parts[0];
    let span = row("cm_alpha").range(findings.scenario());
    let (low, high) = (*span.start(), *span.end());
    assert!((0.0 - range.end()).abs() < 2.0 * (high - low) / 1024.0, "{range:?}");
    // Table IV, Category B: 0.30 to 2.00, 0.20 to 2.00, 0.15.
    let minima: Vec<(Level, f64)> = chart
        .limits()
        .into_iter()
        .filter(|(limit, _)| limit.is_minimum)
        .map(|(limit, _)| (limit.level, limit.value))
        .collect();
    assert_eq!(minima, [(Level::One, 0.3), (Level::Two, 0.2), (Level::Three, 0.15)]);
    // The short period is a pair of real roots before that.
    assert_eq!(chart.runs().count(), 1);
}

#[test]
fn ends_that_run_away_leave_the_rest_to_be_seen() {
    let findings = Findings::of(aircraft("navion"));
    let chart = findings.chart(row("cd"), measure("phugoid.time_to_half"));
    let values: Vec<f64> = chart.points.iter().filter_map(|point| point.reading).collect();
    let (low, high) = chart.range().expect("values");
    assert!(values.iter().any(|value| *value > high), "{high} {values:?}");
    let seen = values.iter().filter(|value| (low..=high).contains(value)).count();
    assert!(10 * seen >= 8 * values.len(), "{seen} of {}", values.len());
}

#[test]
fn every_measure_of_every_aircraft_can_be_charted_over_its_sliders() {
    let mut charts = 0;
    for (i, aircraft) in embedded_aircraft().0.into_iter().enumerate() {
        let scenario = Scenario::new(Arc::new(aircraft));
        let findings = Findings::of(scenario.clone());
        let sliders = parameters().filter(|p| ChartView::can_be_over(p, &scenario)).skip(i).step_by(9);
        for slider in sliders {
            for measure in Measure::all().filter(|m| MeasureChart::can_show(*m)).skip(i).step_by(31) {
                let chart = findings.chart(slider, measure);
                assert!(
                    chart.points.len() <= 60
                        && chart.points.windows(2).all(|pair| pair[0].value < pair[1].value)
                );
                assert!(chart.points.iter().filter_map(|point| point.reading).all(f64::is_finite));
                charts += 1;
            }
        }
    }
    assert!(charts > 400, "{charts}");
}
