//! A law of feedback as part of a scene: its parameters, links, measures and answers to other programs.

use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::export::{self, json};
use eigenwing::findings::Findings;
use eigenwing::findings::measures::{Measure, Reading};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::feedback::law::{SIGNALS, signals};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::motion::control_limits::NamedLimits;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::six_dof::SixDof;
use eigenwing::key::Keyed;
use eigenwing::scenario::{Page, Parameter, Scenario, View, link, parameters};
use eigenwing::words;
use serde_json::{Value, json};

fn aircraft(key: &str) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    Scenario::new(Arc::new(found.expect("it ships")))
}

fn with(key: &str, values: &[(&str, f64)]) -> Scenario {
    let mut scenario = aircraft(key);
    for (key, value) in values {
        let parameter = Parameter::find(key).expect("a row");
        let value = parameter.check(&scenario, *value).expect("it is accepted");
        parameter.set(&mut scenario, value);
    }
    scenario
}

fn read(scenario: &Scenario, key: &str) -> Option<f64> {
    match Measure::find(key).expect("a measure").read(&Findings::of(scenario.clone())) {
        Ok(Reading::Number(value)) => Some(value),
        _ => None,
    }
}

#[test]
fn every_gain_has_a_row_whose_key_names_what_is_measured_and_what_is_moved() {
    let controls = [["de", "dt"], ["da", "dr"]];
    let mut rows = 0;
    for plane in Plane::ALL {
        for (input, control) in controls[plane as usize].into_iter().enumerate() {
            for signal in 0..SIGNALS {
                let key = format!("k.{}_{control}", signals(plane)[signal].key());
                let row = Parameter::find(&key).unwrap_or_else(|| panic!("no row {key}"));
                assert_eq!((row.page, row.plane), (Some(Page::Feedback), Some(plane)), "{key}");
                let mut scenario = aircraft("navion");
                row.set(&mut scenario, 0.001);
                let law = &scenario.law.planes[plane];
                assert_eq!(law.gains()[input][signal], 0.001, "{key}");
                assert!(!scenario.law.is_open(plane));
                row.reset(&mut scenario);
                assert_eq!(scenario, aircraft("navion"));
                rows += 1;
            }
        }
    }
    let all = parameters().filter(|p| p.page == Some(Page::Feedback)).count();
    assert_eq!((rows, all), (20, 24));
}

#[test]
fn a_link_carries_the_law() {
    let (all, _) = embedded_aircraft();
    let all: Vec<_> = all.into_iter().map(Arc::new).collect();
    let text = "v=1&ac=b747-cruise-etkin&k.r_dr=0.5&washout=4&actuator=0.1&plane=lateral";
    let opened = link::read(text, &all).expect("aircraft");
    assert_eq!(opened.notices, []);
    let law = &opened.scenario.law;
    assert_eq!((law.planes.lateral.to_second[2], law.planes.lateral.washout, law.actuator), (0.5, 4.0, 0.1));
    let view = View::of(&opened.scenario);
    assert_eq!(link::write(&opened.scenario, &view, None), text);
    let pinned = link::write(&aircraft("navion"), &view, Some(&opened.scenario));
    assert!(pinned.contains("pin.k.r_dr=0.5"), "{pinned}");
}

/// Lists are joined by points, and the key of a gain has one.
#[test]
fn a_gain_can_be_offered_among_others() {
    let (all, _) = embedded_aircraft();
    let all: Vec<_> = all.into_iter().map(Arc::new).collect();
    let text = "v=1&ac=navion&offer=cm_alpha.k.q_de.k.h_de&lock=k.r_dr.aircraft";
    let opened = link::read(text, &all).expect("aircraft");
    assert_eq!(opened.notices, []);
    assert_eq!(opened.view.stage.offered, ["cm_alpha", "k.q_de", "k.h_de"]);
    let written = link::write(&opened.scenario, &opened.view, None);
    assert_eq!(link::read(&written, &all).expect("aircraft").view, opened.view, "{written}");
}

#[test]
fn measures_read_what_flies() {
    let open = aircraft("b747-cruise-etkin");
    let damped = with("b747-cruise-etkin", &[("k.r_dr", 1.0), ("washout", 3.0), ("actuator", 0.1)]);
    let zeta = |scenario: &Scenario| read(scenario, "dutch_roll.damping_ratio").expect("a Dutch roll");
    assert!(zeta(&open) < 0.1 && zeta(&damped) > 2.0 * zeta(&open), "{} {}", zeta(&open), zeta(&damped));
    // The spiral keeps its own with a washout, and loses it without.
    let fights = with("b747-cruise-etkin", &[("k.r_dr", 1.0), ("actuator", 0.1)]);
    let spiral = |scenario: &Scenario| read(scenario, "spiral.real_part").expect("a spiral");
    assert!((spiral(&damped) / spiral(&open) - 1.0).abs() < 0.5, "{}", spiral(&damped));
    assert!(spiral(&fights) < 5.0 * spiral(&open), "{}", spiral(&fights));
    assert_eq!(read(&open, "washout.real_part"), None);
    let gently = with("b747-cruise-etkin", &[("k.r_dr", 0.3), ("washout", 10.0)]);
    assert!(read(&gently, "washout.real_part").expect("a washout") < 0.0);
    assert_eq!(read(&damped, "parameter.k.r_dr"), Some(1.0));
    assert!(read(&damped, "rudder_actuator.real_part").expect("an actuator") < -5.0);
    // The other plane flies on as it did.
    assert_eq!(read(&open, "phugoid.period"), read(&damped, "phugoid.period"));
}

#[test]
fn the_analysis_of_the_aircraft_stays_beside_that_under_the_law() {
    let (open, damped) = (aircraft("navion"), with("navion", &[("k.q_de", 0.2), ("k.h_de", 1e-4)]));
    let [of_open, of_damped] = [&open, &damped].map(|scenario| Findings::of((*scenario).clone()));
    assert!(of_open.closed_loop().is_none());
    assert_eq!(of_open.analysis(), of_damped.analysis());
    let closed = of_damped.closed_loop().expect("a law").as_ref().expect("it can be analysed");
    assert_eq!(closed.closed.size(), 5);
    assert!(closed.modes.iter().any(|mode| mode.mode.naming.name == ModeName::Height));
    let [elevator, throttle] = of_damped.loop_margins(Plane::Longitudinal);
    assert!(elevator.is_some() && throttle.is_none());
    for mode in &closed.modes {
        let reason = words::naming::reason(&mode.mode);
        assert!(reason.ends_with('.') && reason.len() > 20, "{reason}");
    }
}

fn answer(of: fn(&str) -> Result<String, export::ExportError>, request: Value) -> Value {
    let text = of(&request.to_string()).expect("an answer");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn other_programs_are_told_both_loops() {
    let set = json!({ "k.r_dr": 1.0, "washout": 3.0, "actuator": 0.1 });
    let report = answer(json::analyse, json!({ "aircraft": "b747-cruise-etkin", "set": set }));
    let (lateral, longitudinal) = (&report["lateral"], &report["longitudinal"]);
    assert!(longitudinal["closed_loop"].is_null());
    let closed = &lateral["closed_loop"];
    assert_eq!(closed["states"], json!(["v", "p", "r", "phi", "r-washout", "rudder"]));
    assert_eq!(closed["a"].as_array().expect("rows").len(), 6);
    let zeta = |plane: &Value| {
        let modes = plane["modes"].as_array().expect("modes");
        let dutch = modes.iter().find(|mode| mode["key"] == "dutch-roll").expect("a Dutch roll");
        dutch["damping_ratio"].as_f64().expect("it oscillates")
    };
    assert!(zeta(closed) > 2.0 * zeta(lateral));
    let of_loop = &closed["loops"][0];
    assert_eq!((&of_loop["control"], &of_loop["turns"]), (&json!("rudder"), &json!(0)));
    assert!(of_loop["raise"].as_f64().expect("a gain margin") > 1.0);

    let request =
        json!({ "aircraft": "b747-cruise-etkin", "set": set, "disturbance": "rudder", "steps": 100 });
    let motion = answer(json::respond, request);
    let closed = &motion["closed_loop"];
    assert_eq!(closed["outputs"].as_array().map(Vec::len), motion["outputs"].as_array().map(Vec::len));
    let last = |signals: &Value, name: &str| {
        let signals = signals.as_array().expect("signals");
        let signal = signals.iter().find(|signal| signal["name"] == name).expect("there");
        signal["values"]
            .as_array()
            .expect("values")
            .iter()
            .filter_map(Value::as_f64)
            .fold(0.0, |most, x| f64::max(most, x.abs()))
    };
    assert!(last(&closed["outputs"], "r") < last(&motion["outputs"], "r"));
    assert!(last(&closed["controls"], "rudder") > 0.0 && last(&closed["controls"], "aileron") == 0.0);

    let request =
        json!({ "aircraft": "b747-cruise-etkin", "set": set, "disturbance": "rudder", "output": "beta" });
    let frequency = answer(json::frequency, request);
    let most =
        |gains: &Value| gains.as_array().expect("gains").iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert!(most(&frequency["closed_loop"]["gain"]) < 0.5 * most(&frequency["gain"]));

    let sweep = json!({ "aircraft": "b747-cruise-etkin", "parameter": "k.r_dr", "from": 0.0, "to": 2.0, "points": 5 });
    let sweep = answer(json::sweep, sweep);
    let points = sweep["points"].as_array().expect("points");
    let damping: Vec<f64> = points.iter().map(|point| zeta(&point["lateral"])).collect();
    assert!(damping.is_sorted() && damping[4] > damping[0], "{damping:?}");
    assert!(points.iter().all(|point| point["longitudinal"].is_null()));
}

#[test]
fn other_programs_are_told_how_a_command_is_followed_and_where_limits_bite() {
    let law = json!({ "k.phi_da": -5.0, "actuator": 0.1, "to_phi": 0.7, "time": 6.0 });
    let request = json!({ "aircraft": "navion", "set": law, "disturbance": "bank-command", "nonlinear": true, "steps": 300 });
    let motion = answer(json::respond, request.clone());
    assert_eq!((&motion["plane"], &motion["shape"]), (&json!("lateral"), &json!("step")));
    assert_eq!(motion["inputs"][0]["name"], "phi_command");
    let flight = &motion["nonlinear"];
    let limits = flight["limits"].as_array().expect("limits");
    assert!(limits.iter().all(|limit| limit["control"] == "aileron"), "{limits:?}");
    for kind in ["deflection", "rate"] {
        let first = limits.iter().find(|limit| limit["limit"] == kind).expect("it is met");
        assert!(first["from"].as_f64() < first["until"].as_f64());
    }
    let sentences = flight["limit_sentences"].as_array().expect("sentences");
    assert_eq!(sentences.len(), 2);
    assert!(
        sentences[0]
            .as_str()
            .is_some_and(|text| text.starts_with("The aileron is at its limit of deflection from 1.00 to"))
    );
    let most = |signal: &Value| {
        let values = signal["values"].as_array().expect("values").iter().filter_map(Value::as_f64);
        values.fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    // Behind its lag nearly 25 degrees, and what the linear law asks for.
    let (flown, linear) = (most(&flight["controls"][0]), most(&motion["closed_loop"]["controls"][0]));
    assert!((24.5..=25.0).contains(&flown.to_degrees()) && linear > 2.0, "{flown} {linear}");

    let gentle = json!({ "k.phi_da": -1.0, "k.p_da": -0.1, "actuator": 0.1, "to_phi": 0.2 });
    let motion =
        answer(json::respond, json!({ "aircraft": "navion", "set": gentle, "disturbance": "bank-command" }));
    let figures = motion["closed_loop"]["metrics"]["outputs"].as_array().expect("figures");
    let of_bank = figures.iter().find(|of| of["name"] == "phi").expect("a bank angle");
    for (key, expected) in
        [("steady", 0.1994), ("rise_time", 0.5697), ("overshoot", 0.035), ("settling_time", 3.205)]
    {
        let found = of_bank[key].as_f64().expect(key);
        assert!((found / expected - 1.0).abs() < 0.01, "{key}: {found}");
    }
    assert!(motion["metrics"]["outputs"][0]["peak"]["value"].as_f64().is_none_or(|peak| peak == 0.0));

    let deaf = json!({ "aircraft": "navion", "disturbance": "bank-command" }).to_string();
    let error = json::respond(&deaf).expect_err("nothing listens").to_string();
    assert!(error.contains("k.phi_da or k.phi_dr"), "{error}");
}

#[test]
fn a_file_may_name_the_limits_of_its_controls() {
    let text = include_str!("../assets/aircraft/navion.toml");
    let read = |limits: &str| Aircraft::from_toml("navion.toml", &format!("{text}\n[limits]\n{limits}\n"));
    let aircraft =
        read("elevator_deg = [-20, 12]\nrudder_rate_deg = 40\nthrottle = [-0.1, 0.2]").expect("it reads");
    let limits = aircraft.limits;
    assert_eq!(limits.ranges[0], Some([-20_f64.to_radians(), 12_f64.to_radians()]));
    assert_eq!((limits.ranges[1], limits.rates[3]), (Some([-0.1, 0.2]), Some(40_f64.to_radians())));
    let flown = SixDof::new(&Scenario::new(Arc::new(aircraft)).edited).expect("it flies");
    let [elevator, throttle, aileron, _] = limits.or_usual(&flown);
    assert_eq!((elevator.range[1], elevator.rate), (12_f64.to_radians(), 60_f64.to_radians()));
    assert_eq!((throttle.range, aileron.range[0]), ([-0.1, 0.2], -25_f64.to_radians()));
    for (wrong, told) in [
        ("elevator_deg = [5, 12]", "zero between them"),
        ("elevator_rate_deg = -3", "elevator_rate_deg"),
        ("flaps = 3", "flaps"),
    ] {
        let error = read(wrong).expect_err(wrong).to_string();
        assert!(error.contains(told), "{error}");
    }
    // The usual thrust goes from none to twice that of the steady flight: the Navion's drag over its weight.
    let usual = NamedLimits::default().or_usual(&flown)[1].range;
    assert!((usual[1] - 0.05 / 0.41).abs() < 2e-3 && usual[0] == -usual[1], "{usual:?}");
}

#[test]
fn the_gains_of_every_aircraft_can_be_taken_to_both_ends() {
    let mut analysed = 0;
    for found in embedded_aircraft().0 {
        let scenario = Scenario::new(Arc::new(found));
        let gains = parameters().filter(|p| p.page == Some(Page::Feedback) && p.applies(&scenario));
        for p in gains {
            for end in [*p.range(&scenario).start(), *p.range(&scenario).end()] {
                let mut moved = scenario.clone();
                moved.law.actuator = 0.1;
                moved.law.planes.lateral.washout = 3.0;
                p.set(&mut moved, end);
                let findings = Findings::of(moved);
                for plane in Plane::ALL {
                    if let Some(closed) = findings.closed_loop_of(plane) {
                        let closed = closed.as_ref().expect("it can be analysed");
                        assert!(closed.modes.iter().all(|mode| mode.mode.lambda.re.is_finite()), "{}", p.key);
                        analysed += 1;
                    }
                }
            }
        }
    }
    assert!(analysed > 500, "{analysed}");
}

/// The root locus of a course: from the roots of the aircraft, and those of the law that come in with it, through those under the law.
#[test]
fn the_path_of_a_gain_goes_from_the_poles_without_it_through_those_with_it() {
    let mut seen = 0;
    for (key, gain, others) in [
        ("b747-cruise-etkin", "k.r_dr", vec![("washout", 3.0), ("actuator", 0.1)]),
        ("navion", "k.q_de", vec![("actuator", 0.05)]),
        ("navion", "k.h_de", vec![("k.theta_de", 0.5)]),
    ] {
        let start = with(key, &others);
        let row = Parameter::find(gain).expect("a row");
        let mut scenario = start.clone();
        scenario.plane = row.plane.expect("a plane");
        let locus = Findings::of(scenario.clone()).locus(row);
        for sample in &locus.samples {
            row.set(&mut scenario, sample.parameter);
            let findings = Findings::of(scenario.clone());
            let Some(Ok(closed)) = findings.closed_loop() else { continue };
            let poles = sample.poles.as_ref().expect("it can be had");
            assert!(poles.len() >= closed.closed.size());
            let size = closed.modes.iter().map(|mode| mode.mode.lambda.norm()).fold(0.0, f64::max);
            for mode in &closed.modes {
                let lambda = mode.mode.lambda;
                let nearest = poles.iter().map(|pole| (pole - lambda).norm()).fold(f64::INFINITY, f64::min);
                // Near a meeting rounding moves a root by its square root.
                assert!(nearest < 1e-6 * size, "{key} {gain} {}: {lambda} {poles:?}", sample.parameter);
                seen += 1;
            }
        }
        assert!(locus.names.iter().all(Option::is_some), "{:?}", locus.names);
        let has = |name| locus.names.contains(&Some(name));
        assert!(has(if key == "navion" { ModeName::ShortPeriod } else { ModeName::DutchRoll }));
    }
    assert!(seen > 1500, "{seen}");
}

/// Every output is the sum of its modes and of what the input does at once; a mode that flies alone is all of its motion.
#[test]
fn a_motion_under_a_law_is_the_sum_of_its_modes() {
    let (all, _) = embedded_aircraft();
    let all: Vec<_> = all.into_iter().map(Arc::new).collect();
    let law = "k.r_dr=0.4&k.p_da=-0.2&washout=4&actuator=0.1";
    let mut alone = 0;
    for disturbance in
        ["lat.source=aileron&lat.shape=pulse", "lat.source=mode&lat.mode=1", "lat.source=mode&lat.mode=4"]
    {
        let link = format!("v=1&ac=b747-cruise-etkin&plane=lateral&{law}&{disturbance}");
        let findings = Findings::of(link::read(&link, &all).expect("aircraft").scenario);
        let motion = findings.flown_motion().expect("a motion");
        let flown = motion.experiment.inputs.is_empty();
        for &output in Output::of(Plane::Lateral) {
            let whole = motion.values(output);
            let split = findings.flown_split(output).expect("a motion").expect("simple roots");
            assert_eq!(split.parts.len(), findings.flown_modes().len());
            let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let size = split.parts.iter().map(|part| largest(part)).fold(largest(&whole), f64::max);
            for (k, value) in whole.iter().enumerate() {
                let sum: f64 = split.parts.iter().map(|part| part[k]).sum::<f64>() + split.rest[k];
                assert!((sum - value).abs() <= 1e-12 * size, "{link} {output:?}");
            }
            // A real root begins its path at zero, which is no part of it.
            if flown && ![Output::Heading, Output::Offset].contains(&output) {
                let index = findings.scenario().disturbance.choices[Plane::Lateral].mode;
                let own = largest(&split.parts[index]);
                assert!(own > 0.0 && largest(&split.rest) < 1e-9 * own, "{link} {output:?}");
                for (i, part) in split.parts.iter().enumerate().filter(|(i, _)| *i != index) {
                    assert!(largest(part) < 1e-9 * own, "{link} {output:?}: mode {i} has a part");
                }
                alone += 1;
            }
        }
    }
    assert!(alone >= 10, "{alone}");
}
