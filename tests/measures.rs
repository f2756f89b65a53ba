//! The table of measures: keys that lead back to themselves, readings that agree with the analysis, and a reason wherever there is
//! nothing to read.
//!
//! `UPDATE_MEASURES=1 cargo test --no-default-features --test measures` writes docs/MEASURES.md anew.

use std::collections::BTreeSet;
use std::sync::Arc;

use eigenwing::content::{Aircraft, LengthUnit, embedded_aircraft};
use eigenwing::findings::Findings;
use eigenwing::findings::measures::{Absence, LoopOf, Measure, Metric, Reading};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::scenario::{Parameter, Scenario, parameters};
use eigenwing::words;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn listed(key: &str) -> Scenario {
    Scenario::new(aircraft().into_iter().find(|one| one.key == key).expect("it ships"))
}

fn read(findings: &Findings, key: &str) -> Result<Reading, Absence> {
    Measure::find(key).unwrap_or_else(|| panic!("{key} is a measure")).read(findings)
}

fn number(findings: &Findings, key: &str) -> f64 {
    match read(findings, key) {
        Ok(Reading::Number(value)) => value,
        other => panic!("{key}: {other:?}"),
    }
}

#[test]
fn every_key_leads_back_to_its_measure_and_no_two_are_the_same() {
    let mut keys = BTreeSet::new();
    for measure in Measure::all() {
        let key = measure.key();
        assert_eq!(Measure::find(&key), Some(measure), "{key}");
        assert!(!words::measure::name(measure).is_empty());
        assert!(
            key.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b"_.".contains(&b)),
            "{key}"
        );
        assert!(keys.insert(key.clone()), "{key} twice");
    }
    assert!(keys.len() > 400, "{}", keys.len());
    for wrong in [
        "",
        ".",
        "short_period",
        "short_period.",
        "damping_ratio",
        "short_period.colour",
        "peak.colour",
        "parameter.x",
    ] {
        assert!(Measure::find(wrong).is_none(), "{wrong:?}");
    }
    assert_eq!(Measure::find("Short-Period.Damping_Ratio"), Measure::find("short_period.damping_ratio"));
}

/// The Navion's modes as Nelson prints them (*Flight Stability and Automatic Control*, 2nd ed., §4.3), to their last digit.
#[test]
fn the_navion_reads_as_published() {
    let navion = Findings::of(listed("navion"));
    assert!((number(&navion, "short_period.natural_frequency") - 3.6).abs() < 0.05);
    assert!((number(&navion, "short_period.real_part") + 2.5).abs() < 0.05);
    assert!((number(&navion, "phugoid.period") - 29.5).abs() < 0.2);
    assert!((number(&navion, "static_margin") - 0.15383).abs() < 1e-5);
    assert!((number(&navion, "parameter.cm_alpha") + 0.683).abs() < 1e-12);
    assert_eq!(read(&navion, "stability"), Ok(Reading::Stability(Stability::Stable)));
    assert_eq!(read(&navion, "longitudinal.static_stability"), Ok(Reading::Stability(Stability::Stable)));
    assert_eq!(read(&navion, "level"), Ok(Reading::Level(Level::One)));
    assert_eq!(read(&navion, "dutch_roll.level"), Ok(Reading::Level(Level::One)));
    assert_eq!(read(&navion, "phugoid.time_to_double"), Err(Absence::DoesNotGrow(ModeName::Phugoid)));
    assert_eq!(read(&navion, "spiral.period"), Err(Absence::DoesNotOscillate(ModeName::Spiral)));
}

/// What the page, the command line and JavaScript tell of a motion is what its measures read.
#[test]
fn metrics_of_the_motion_are_those_of_the_findings() {
    let findings = Findings::of(listed("navion"));
    let metrics = findings.metrics().expect("a motion");
    for of_output in &metrics.outputs {
        let key = eigenwing::key::Keyed::key(of_output.output);
        let steady = Measure::find(&format!("steady.{key}")).expect("a measure").read(&findings);
        assert_eq!(steady.ok(), of_output.steady.map(Reading::Number), "{key}");
    }
    assert!(matches!(read(&findings, "peak.beta"), Err(Absence::OtherPlane(_))));
}

/// Along every slider of every aircraft: each measure is a finite number, a verdict, or absent with a reason; never a panic.
#[test]
fn every_measure_of_every_aircraft_is_finite_or_says_why_not() {
    let (mut read, mut absent) = (0, 0);
    for aircraft in aircraft() {
        let reference = Scenario::new(aircraft);
        for (i, parameter) in parameters().filter(|p| p.applies(&reference)).enumerate() {
            let range = parameter.range(&reference);
            let mut scenario = reference.clone();
            parameter.set(&mut scenario, if i % 2 == 0 { *range.start() } else { *range.end() });
            if i % 3 == 0 && scenario.aircraft.plane_notes[Plane::Lateral].is_some() {
                scenario.plane = Plane::Lateral;
            }
            let findings = Findings::of(scenario);
            for measure in Measure::all() {
                match measure.read(&findings) {
                    Ok(Reading::Number(value)) => {
                        assert!(value.is_finite(), "{}", measure.key());
                        read += 1;
                    }
                    Ok(_) => read += 1,
                    Err(absence) => {
                        let reason = words::measure::absence(&absence, LengthUnit::Metre);
                        assert!(reason.len() > 10 && !reason.ends_with('.'), "{reason}");
                        absent += 1;
                    }
                }
            }
        }
    }
    assert!(read > 20_000 && absent > 20_000, "{read}, {absent}");
}

#[test]
fn a_level_follows_from_the_class_that_is_chosen() {
    let lesson = Findings::of(listed("lesson"));
    assert_eq!(read(&lesson, "level"), Err(Absence::NotJudged));
    let mut judged = listed("lesson");
    judged.task = Some(Default::default());
    assert!(matches!(read(&Findings::of(judged), "level"), Ok(Reading::Level(_))));
    let mut behind = listed("navion");
    Parameter::find("cg").expect("a row").set(&mut behind, 0.16);
    let behind = Findings::of(behind);
    assert_eq!(read(&behind, "level"), Ok(Reading::Level(Level::Three)));
    assert!(number(&behind, "static_margin") < 0.0);
}

/// What the documentation says of measures, made from their table.
fn documentation() -> String {
    use eigenwing::key::Keyed as _;
    let mut text = "# Measures\n\n\
        What can be read of a scene, by keys that never change: `eigenwing-cli measures navion` lists them with their values,\n\
        `eigenwing-cli sweep navion --parameter cg --from 0 --to 0.2 --measure static_margin --measure phugoid.period` draws them over a\n\
        parameter, and a lesson names them in its goals and numbers. Numbers are SI and radians; a verdict is a key, `stable` or\n\
        `level-2`; where there is nothing to read, the reason is told.\n\n\
        Written by `UPDATE_MEASURES=1 cargo test --no-default-features --test measures`; the same test fails when it is out of date.\n\n\
        | key | what | unit |\n|---|---|---|\n"
        .to_owned();
    let mut row = |key: &str, name: &str, unit: &str| {
        text += &format!("| `{key}` | {name} | {} |\n", if unit.is_empty() { "–" } else { unit });
    };
    for measure in Measure::all() {
        let (key, name, unit) =
            (measure.key(), words::measure::name(measure), measure.dimension().si_symbol());
        match measure {
            Measure::OfMode(mode, _) if mode != ModeName::ShortPeriod => {}
            Measure::OfMode(..) => {
                let quantity = key.split_once('.').map_or("", |(_, quantity)| quantity);
                row(&format!("MODE.{quantity}"), &name.replace("of the short period", "of a mode"), unit);
            }
            Measure::OfLoop(LoopOf::Elevator, _) => {
                row(
                    &key.replace("elevator_loop", "LOOP"),
                    &name.replace("the elevator loop", "a loop"),
                    unit,
                );
            }
            Measure::OfLoop(..) | Measure::OfOutput(..) | Measure::OfParameter(_) => {}
            Measure::OfAircraft(_) | Measure::OfPlane(..) => row(&key, &name, unit),
        }
    }
    for metric in Metric::VALUES {
        let name = words::measure::name(Measure::OfOutput(Output::PitchRate, *metric))
            .replace("pitch rate", "an output");
        let unit = match metric {
            Metric::Peak | Metric::Steady => "that of the output",
            Metric::PeakTime | Metric::RiseTime | Metric::SettlingTime => "s",
            Metric::Overshoot => "",
        };
        row(&format!("{}.OUTPUT", metric.key()), &name, unit);
    }
    row("parameter.KEY", "the value of a parameter, by its key in links", "SI");
    let modes: Vec<String> =
        ModeName::VALUES.iter().map(|name| format!("`{}`", name.key().replace('-', "_"))).collect();
    let outputs: Vec<String> = Output::VALUES.iter().map(|output| format!("`{}`", output.key())).collect();
    let loops: Vec<String> = LoopOf::VALUES.iter().map(|of| format!("`{}`", of.key())).collect();
    text += &format!("\nMODE is one of {}.\n\nOUTPUT is one of {}.\n", modes.join(", "), outputs.join(", "));
    text + &format!(
        "\nLOOP is one of {}: the loop of a control that a law of feedback moves, cut before its actuator.\n",
        loops.join(", ")
    )
}

#[test]
fn the_documentation_is_made_from_the_table() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/MEASURES.md");
    let text = documentation();
    if std::env::var_os("UPDATE_MEASURES").is_some() {
        std::fs::write(path, &text).expect("the documentation can be written to");
    }
    let written = std::fs::read_to_string(path).expect("the documentation is there");
    assert!(written == text, "docs/MEASURES.md is out of date; run with UPDATE_MEASURES=1");
}
