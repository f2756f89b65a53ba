//! What a course shows of feedback, on aircraft that ship: dampers and turns, artificial stability, autopilots, and levels as a loop closes.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::findings::measures::{Absence, LoopQuantity, Measure, Reading};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::verdicts::handling_qualities::Level;
use eigenwing::scenario::link;

/// The findings of a link, all of which is used.
fn found(text: &str) -> Findings {
    let all: Vec<_> = embedded_aircraft().0.into_iter().map(Arc::new).collect();
    let opened = link::read(&format!("v=1&{text}"), &all).expect("aircraft");
    assert_eq!(opened.notices, [], "{text}");
    Findings::of(opened.scenario)
}

fn read(findings: &Findings, key: &str) -> Result<Reading, Absence> {
    Measure::find(key).expect("a measure").read(findings)
}

fn number(findings: &Findings, key: &str) -> f64 {
    match read(findings, key) {
        Ok(Reading::Number(value)) => value,
        other => panic!("{key}: {other:?}"),
    }
}

fn is_stable(findings: &Findings, key: &str) -> bool {
    read(findings, key) == Ok(Reading::Stability(Stability::Stable))
}

#[test]
fn a_yaw_damper_fights_the_steady_turn_and_a_washout_cures_it() {
    let boeing = "ac=b747-cruise-etkin&plane=lateral&lat.source=release&from_beta=0&from_phi=20&time=60";
    let [alone, fights, cured] =
        ["", "&k.r_dr=1", "&k.r_dr=1&washout=3"].map(|law| found(&format!("{boeing}{law}")));
    let zeta = |findings| number(findings, "dutch_roll.damping_ratio");
    assert!(zeta(&alone) < 0.04 && zeta(&fights) > 0.25 && zeta(&cured) > 0.2);
    let half = |findings| number(findings, "spiral.time_to_half");
    assert!(half(&fights) < 0.05 * half(&alone), "{} {}", half(&fights), half(&alone));
    assert!(half(&cured) > half(&alone), "{} {}", half(&cured), half(&alone));
    // A bank that is let go: after half a minute it is gone, or still there.
    let bank = |findings: &Findings| {
        let motion = findings.flown_motion().expect("a motion");
        let values = motion.values(Output::BankAngle);
        values[values.len() / 2] / values[0]
    };
    assert!(bank(&fights).abs() < 0.05, "{}", bank(&fights));
    assert!(bank(&cured) > 0.75 * bank(&alone) && bank(&alone) > 0.5, "{} {}", bank(&cured), bank(&alone));
    // While there is a turn the damper holds the rudder against it, and the washout lets go of it.
    let held = |findings: &Findings| {
        let response = findings.closed_motion_in(600).expect("a law");
        let (controls, states) = (response.controls[300][1], &response.states[300]);
        (controls / states[2]).abs()
    };
    assert!((held(&fights) - 1.0).abs() < 1e-9 && held(&cured) < 0.1, "{} {}", held(&fights), held(&cured));
}

#[test]
fn a_pitch_damper_never_stabilises_what_is_statically_unstable_and_a_vane_does() {
    let behind = "ac=navion&cg=18";
    let mut slower = number(&found(behind), "speed_divergence.time_to_double");
    for gain in [0.2, 1.0, 5.0] {
        let damped = found(&format!("{behind}&k.q_de={gain}"));
        let doubles = number(&damped, "speed_divergence.time_to_double");
        // Ever slower, and never stable: in the end there is no q to feed back.
        assert!(doubles > slower && !is_stable(&damped, "longitudinal.stability"), "{gain}: {doubles}");
        slower = doubles;
    }
    let with_vane = found(&format!("{behind}&k.alpha_de=0.5"));
    assert!(is_stable(&with_vane, "longitudinal.stability"));
    assert_eq!(read(&with_vane, "short_period.level"), Ok(Reading::Level(Level::One)));
    // The aircraft itself is what it was.
    assert_eq!(
        read(&with_vane, "longitudinal.static_stability"),
        Ok(Reading::Stability(Stability::Unstable))
    );
}

#[test]
fn holding_the_height_destabilises_the_phugoid_and_an_inner_loop_of_pitch_angle_saves_it() {
    let cessna = "ac=cessna-172&lon.source=height-command&to_h=10&time=120";
    let mut before = number(&found(cessna), "phugoid.damping_ratio");
    for gain in [0.02, 0.05, 0.2] {
        let held = found(&format!("{cessna}&k.h_de={gain}"));
        let zeta = number(&held, "phugoid.damping_ratio");
        assert!(zeta < before, "{gain}: {zeta}");
        before = zeta;
    }
    assert!(before < 0.0);
    let saved = found(&format!("{cessna}&k.h_de=0.2&k.theta_de=1&k.q_de=0.3"));
    assert!(is_stable(&saved, "longitudinal.stability"));
    assert!((number(&saved, "steady.h") - 10.0).abs() < 1e-6);
    assert!(number(&saved, "rise_time.h") < 25.0 && number(&saved, "overshoot.h") < 0.01);
}

/// Below the speed of least drag more height asks for more thrust, which the elevator can't give.
#[test]
fn on_the_back_side_of_the_drag_curve_height_is_held_only_with_thrust() {
    let approach = "ac=b747-approach&k.h_de=0.05&k.theta_de=1";
    let without = found(approach);
    assert!(number(&without, "height.real_part") > 0.0 && !is_stable(&without, "longitudinal.stability"));
    assert!(is_stable(&found(&format!("{approach}&k.u_dt=-2")), "longitudinal.stability"));
}

#[test]
fn a_bank_is_held_quickly_by_its_angle_and_calmly_by_its_rate_too() {
    let navion = "ac=navion&plane=lateral&lat.source=bank-command&to_phi=20&actuator=0.1&time=8";
    let [slow, quick, calm] = ["&k.phi_da=-1", "&k.phi_da=-2", "&k.phi_da=-2&k.p_da=-0.2"]
        .map(|law| found(&format!("{navion}{law}")));
    let rise = |findings| number(findings, "rise_time.phi");
    let over = |findings| number(findings, "overshoot.phi");
    assert!(rise(&quick) < 0.7 * rise(&slow) && over(&quick) > 3.0 * over(&slow));
    assert!(rise(&calm) < 0.8 * rise(&slow) && over(&calm) < over(&slow));
    for findings in [&slow, &quick, &calm] {
        // A bank of twenty degrees, nearly.
        let steady = number(findings, "steady.phi").to_degrees();
        assert!((steady - 20.0).abs() < 0.2, "{steady}");
        let settled = number(findings, "settling_time.phi");
        assert!(settled > rise(findings) && settled < 8.0, "{settled}");
    }
}

#[test]
fn levels_get_better_as_the_loop_closes_and_worse_again_with_too_much_gain() {
    let level = |gain: f64| {
        let damped = found(&format!("ac=b747-fc9&plane=lateral&washout=3&actuator=0.1&k.r_dr={gain}"));
        match read(&damped, "dutch_roll.level") {
            Ok(Reading::Level(level)) => level,
            other => panic!("{gain}: {other:?}"),
        }
    };
    let levels = [0.0, 0.4, 1.5, 4.5, 5.0].map(level);
    assert_eq!(levels[0], Level::Three);
    assert_eq!(levels[2], Level::One);
    assert!(levels[0] > levels[1] && levels[1] > levels[2] && levels[2] < levels[4], "{levels:?}");
}

#[test]
fn margins_shrink_as_the_gain_grows_and_there_is_none_where_no_gain_is_too_much() {
    let of = |aircraft: &str, gain: f64| {
        found(&format!("ac={aircraft}&plane=lateral&washout=3&actuator=0.1&k.r_dr={gain}"))
    };
    let margin = |findings| number(findings, "rudder_loop.gain_margin");
    let peak = |findings| number(findings, "rudder_loop.sensitivity_peak");
    let (gentle, bold) = (of("b747-cruise-etkin", 1.0), of("b747-cruise-etkin", 4.0));
    assert!((margin(&gentle) / margin(&bold) - 4.0).abs() < 1e-6, "the same loop, four times as strong");
    assert!(peak(&bold) > 1.5 * peak(&gentle));
    // Of these two Boeings, differently measured, the loop of one bears any gain.
    assert_eq!(
        read(&of("b747-fc9", 1.0), "rudder_loop.gain_margin"),
        Err(Absence::NoMargin(LoopQuantity::GainMargin))
    );
}

#[test]
fn a_washout_and_an_actuator_have_modes_of_their_names() {
    let damped = found("ac=b747-fc9&plane=lateral&washout=10&actuator=0.05&k.r_dr=0.3");
    let names: Vec<ModeName> = damped.flown_modes().iter().map(|mode| mode.naming.name).collect();
    for name in [ModeName::DutchRoll, ModeName::Spiral, ModeName::Washout, ModeName::RudderActuator] {
        assert!(names.contains(&name), "{names:?}");
    }
}
