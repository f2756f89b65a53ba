//! What a law of feedback is turned for: margins as measures, and the least gain that reaches a level.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::export::{LoopOutcome, PlaneOutcome, Source, Subject, analyse};
use eigenwing::findings::measures::{Absence, LoopOf, LoopQuantity, Measure, Reading};
use eigenwing::findings::{Findings, NoLeastGain};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode::Mode;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::verdicts::handling_qualities::{Level, Verdict};
use eigenwing::flight::verdicts::mil_f_8785c::Criterion;
use eigenwing::scenario::{Page, Parameter, Scenario, parameters};

fn with(key: &str, values: &[(&str, f64)]) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    let mut scenario = Scenario::new(Arc::new(found.expect("it ships")));
    for (key, value) in values {
        Parameter::find(key).expect("a row").set(&mut scenario, *value);
    }
    scenario
}

fn row(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row")
}

fn read(scenario: &Scenario, key: &str) -> Result<Reading, Absence> {
    Measure::find(key).expect("a measure").read(&Findings::of(scenario.clone()))
}

/// The worst level of a plane under the law, by its verdicts; `None` where something grows, or oscillates and is mostly of the aircraft,
/// that none of them judges, or where nothing is judged as the mode that every aircraft has.
fn worst(scenario: &Scenario, plane: Plane) -> Option<Level> {
    let findings = Findings::of(scenario.clone());
    let open = findings.analysis().as_ref().ok()?.planes[plane].as_ref()?.as_ref().ok()?;
    let closed = findings.closed_loop_of(plane).map(|closed| closed.as_ref().expect("it can be analysed"));
    let levels = closed.map_or(&open.levels, |closed| &closed.levels);
    let judged: Vec<&Verdict> = levels.iter().filter(|verdict| verdict.level.is_some()).collect();
    let is_judged = |mode: &Mode| judged.iter().any(|verdict| verdict.modes.contains(&mode.naming.name));
    let modes = findings.modes_in_flight(open);
    let strays = modes.into_iter().any(|mode| mode.stability == Stability::Unstable && !is_judged(mode));
    let swings = closed.is_some_and(|closed| {
        closed.modes.iter().any(|mode| {
            let of_aircraft: f64 = mode.participation[..4].iter().sum();
            mode.mode.is_oscillatory() && of_aircraft >= 0.5 && !is_judged(&mode.mode)
        })
    });
    let always: &[Criterion] = match plane {
        Plane::Longitudinal => &[Criterion::ShortPeriodDamping, Criterion::PitchDivergence],
        Plane::Lateral => &[Criterion::RollMode, Criterion::CoupledRollSpiral],
    };
    let is_whole = judged.iter().any(|verdict| always.contains(&verdict.criterion));
    let worst = judged.iter().filter_map(|verdict| verdict.level).max()?;
    (worst == Level::Beyond || (!strays && !swings && is_whole)).then_some(worst)
}

#[test]
fn margins_are_read_by_the_control_whose_loop_is_cut() {
    let damped = with("b747-cruise-etkin", &[("k.r_dr", 1.0), ("washout", 3.0), ("actuator", 0.1)]);
    let findings = Findings::of(damped.clone());
    let margins = findings.loop_margins(Plane::Lateral)[1].as_ref().expect("a rudder loop");
    let expected = [
        ("rudder_loop.gain_margin", margins.raise.map(|margin| margin.factor)),
        ("rudder_loop.gain_reduction", margins.lower.map(|margin| margin.factor)),
        ("rudder_loop.phase_margin", margins.phase.map(|margin| margin.angle)),
        ("Rudder-Loop.crossover", margins.phase.map(|margin| margin.frequency)),
        ("rudder_loop.sensitivity_peak", margins.sensitivity.map(|peak| peak.value)),
    ];
    assert!(expected[0].1.is_some_and(|factor| factor > 1.0));
    for (key, number) in expected {
        assert_eq!(read(&damped, key).ok(), number.map(Reading::Number), "{key}");
    }
    assert_eq!(read(&damped, "aileron_loop.gain_margin"), Err(Absence::NoLoop(LoopOf::Aileron)));
    assert_eq!(read(&damped, "elevator_loop.gain_margin"), Err(Absence::NoLoop(LoopOf::Elevator)));
    let gentle = with("navion", &[("k.q_de", 1e-3)]);
    let absent = Err(Absence::NoMargin(LoopQuantity::PhaseMargin));
    assert_eq!(read(&gentle, "elevator_loop.phase_margin"), absent);
}

/// Every gain that the answer calls good is, every other isn't, and nearer to zero than the least there is none.
#[test]
fn the_least_gain_is_the_nearest_to_zero_that_reaches_the_level() {
    let (mut found, mut nowhere) = (0, 0);
    for aircraft in ["b747-cruise-etkin", "b747-approach"] {
        for row in parameters().filter(|row| row.page == Some(Page::Feedback) && row.is_gain()) {
            let scenario = with(aircraft, &[("washout", 3.0), ("actuator", 0.1)]);
            let plane = row.plane.expect("a gain is of a plane");
            let at = |gain: f64| {
                let mut moved = scenario.clone();
                row.set(&mut moved, gain);
                worst(&moved, plane).is_some_and(|level| level == Level::One)
            };
            match Findings::of(scenario.clone()).least_gain(row, Level::One) {
                Ok(least) => {
                    assert!(at(least.gain), "{aircraft} {}", row.key);
                    assert!(least.ranges.is_sorted_by(|a, b| a[1] < b[0]), "{:?}", least.ranges);
                    if least.gain != 0.0 {
                        assert!(!at(least.gain * (1.0 - 1e-6)), "{aircraft} {}", row.key);
                    }
                    for k in 0..=20 {
                        let share = f64::from(k) / 20.0;
                        let range = row.range(&scenario);
                        let gain = range.start() + share * (range.end() - range.start());
                        let told = least.ranges.iter().any(|range| (range[0]..=range[1]).contains(&gain));
                        assert_eq!(told, at(gain), "{aircraft} {} {gain} {:?}", row.key, least.ranges);
                    }
                    found += 1;
                }
                Err(NoLeastGain::Nowhere { best }) => {
                    assert!(best.is_none_or(|(level, _)| level > Level::One));
                    nowhere += 1;
                }
                Err(other) => panic!("{aircraft} {}: {other:?}", row.key),
            }
        }
    }
    assert!(found > 10 && nowhere > 5, "{found}, {nowhere}");
}

#[test]
fn the_gains_that_reach_a_level_needn_t_lie_together() {
    let mut apart = 0;
    for (aircraft, lag) in [("b747-approach", 0.1), ("b747-fc8", 0.1), ("navion", 1.0), ("c47", 1.0)] {
        let scenario = with(aircraft, &[("actuator", lag), ("washout", 3.0)]);
        for row in parameters().filter(|row| row.page == Some(Page::Feedback) && row.is_gain()) {
            let plane = row.plane.expect("a gain is of a plane");
            let Ok(least) = Findings::of(scenario.clone()).least_gain(row, Level::One) else { continue };
            let at = |gain: f64| {
                let mut moved = scenario.clone();
                row.set(&mut moved, gain);
                worst(&moved, plane) == Some(Level::One)
            };
            for pair in least.ranges.windows(2) {
                // Just beyond the end of the one, and at the beginning of the other.
                let beyond = pair[0][1] + 1e-3 * (pair[1][0] - pair[0][1]);
                let found = [pair[0][1], beyond, pair[1][0]].map(at);
                assert_eq!(found, [true, false, true], "{aircraft} {} {pair:?}", row.key);
                apart += 1;
            }
        }
    }
    assert!(apart > 0);
}

#[test]
fn what_is_no_gain_or_isn_t_judged_has_no_least_gain() {
    let findings = Findings::of(with("navion", &[]));
    for key in ["washout", "actuator", "cm_alpha", "elevator"] {
        assert_eq!(findings.least_gain(row(key), Level::One), Err(NoLeastGain::NotAGain), "{key}");
    }
    let unjudged = Findings::of(with("lesson", &[]));
    assert_eq!(unjudged.least_gain(row("k.q_de"), Level::One), Err(NoLeastGain::NotJudged));
    // Level 1 without any gain: none is needed.
    let good = findings.least_gain(row("k.q_de"), Level::One).expect("the Navion is Level 1");
    assert_eq!(good.gain, 0.0);
}

/// Programs get the number that the page finds, and a reason where there is none.
#[test]
fn answers_tell_the_least_of_each_gain_at_work() {
    let link = "#v=1&ac=b747-approach&plane=lat&k.r_dr=1&k.p_da=0.1&washout=3&actuator=0.1";
    let scene =
        Subject { source: Source::Link(link.to_owned()), ..Subject::listed("") }.scene().expect("a scene");
    let report = analyse(&scene).expect("an answer");
    let lateral = report.lateral.as_ref().and_then(PlaneOutcome::report).expect("lateral motion");
    let Some(LoopOutcome::Analysed(closed)) = &lateral.closed_loop else { panic!("no loop") };
    let keys: Vec<&str> = closed.least_gains.iter().map(|least| least.gain).collect();
    assert_eq!(keys.len(), 2, "{keys:?}");
    let findings = Findings::of(scene.scenario.clone());
    for least in &closed.least_gains {
        let found = findings.least_gain(row(least.gain), Level::One);
        assert_eq!(least.least, found.as_ref().ok().map(|found| found.gain), "{}", least.gain);
        assert_eq!(least.reason.is_some(), found.is_err(), "{}: one of the two", least.gain);
    }
    let longitudinal =
        report.longitudinal.as_ref().and_then(PlaneOutcome::report).expect("longitudinal motion");
    assert!(longitudinal.closed_loop.is_none(), "nothing is fed back there");
}
