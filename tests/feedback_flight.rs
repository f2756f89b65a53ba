//! Nonlinear flight under laws of feedback: SciPy's numbers where limits bite, and the linear loop as disturbances get small.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::control_limits::{Control, NamedLimits};
use eigenwing::flight::motion::flight_path::{Bite, FlightPath, Limited};
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::servos::as_array;
use eigenwing::key::Keyed;
use eigenwing::scenario::{Parameter, Scenario, Shape, Source};
use eigenwing::words;
use nalgebra::{Vector3, Vector4};
use serde::Deserialize;

fn with(key: &str, values: &[(&str, f64)]) -> Scenario {
    let found = embedded_aircraft().0.into_iter().find(|aircraft| aircraft.key == key);
    let mut scenario = Scenario::new(Arc::new(found.expect("it ships")));
    set(&mut scenario, values);
    scenario
}

fn set(scenario: &mut Scenario, values: &[(&str, f64)]) {
    for (key, value) in values {
        Parameter::find(key).unwrap_or_else(|| panic!("{key}")).set(scenario, *value);
    }
}

/// Put through a disturbance.
fn disturbed(mut scenario: Scenario, plane: Plane, source: Source, shape: Shape) -> Scenario {
    scenario.plane = plane;
    let choice = &mut scenario.disturbance.choices[plane];
    choice.source = source;
    if source.command().is_none() && choice.shape().is_some() {
        *choice.shape_mut() = shape;
    }
    scenario
}

fn flown(scenario: &Scenario, steps: usize) -> FlightPath {
    let findings = Findings::of(scenario.clone());
    findings.flight_in(steps).expect("a motion").expect("it flies")
}

#[derive(Deserialize)]
struct Golden {
    flights: Vec<Flight>,
}

#[derive(Deserialize)]
struct Flight {
    name: String,
    gains: std::collections::BTreeMap<String, f64>,
    washouts: [f64; 2],
    lags: [f64; 4],
    limits: [[f64; 2]; 4],
    rates: [Option<f64>; 4],
    pilot: Option<(String, f64, f64, f64)>,
    command: Option<(String, f64, f64)>,
    times: Vec<f64>,
    velocity: Vec<[f64; 3]>,
    rates_of_turn: Vec<[f64; 3]>,
    nose: Vec<[f64; 3]>,
    position: Vec<[f64; 3]>,
    controls: Vec<[f64; 4]>,
    bites: Vec<(String, String, f64, f64)>,
}

impl Flight {
    fn scenario(&self) -> Scenario {
        let mut scenario = with("navion", &[]);
        let short = |control: &str| match control {
            "elevator" => "de",
            "throttle" => "dt",
            "aileron" => "da",
            _ => "dr",
        };
        for (key, gain) in &self.gains {
            let (signal, control) = key.split_once('.').expect("a signal and a control");
            set(&mut scenario, &[(&format!("k.{signal}_{}", short(control)), *gain)]);
        }
        let [elevator, throttle, aileron, rudder] = self.lags;
        assert!(elevator == aileron && aileron == rudder, "one lag of all actuators");
        set(
            &mut scenario,
            &[
                ("washout_q", self.washouts[0]),
                ("washout", self.washouts[1]),
                ("actuator", elevator),
                ("engine", throttle),
            ],
        );
        let mut aircraft = (*scenario.aircraft).clone();
        aircraft.limits = NamedLimits { ranges: self.limits.map(Some), rates: self.rates };
        scenario.aircraft = Arc::new(aircraft);
        match (&self.pilot, &self.command) {
            (Some((control, size, from, until)), None) => {
                assert_eq!((control.as_str(), *from), ("rudder", 1.0));
                set(&mut scenario, &[("rudder", *size), ("part", until - from)]);
                scenario = disturbed(scenario, Plane::Lateral, Source::Rudder, Shape::Pulse);
            }
            (None, Some((signal, size, from))) => {
                assert_eq!(*from, 1.0);
                set(&mut scenario, &[(&format!("to_{signal}"), *size)]);
                let (plane, source) = match signal.as_str() {
                    "phi" => (Plane::Lateral, Source::BankCommand),
                    _ => (Plane::Longitudinal, Source::PitchCommand),
                };
                scenario = disturbed(scenario, plane, source, Shape::Step);
            }
            other => panic!("{other:?}"),
        }
        set(&mut scenario, &[("time", *self.times.last().expect("times"))]);
        scenario
    }
}

fn golden() -> Vec<Flight> {
    let golden: Golden = serde_json::from_str(include_str!("data/feedback/flights.json")).expect("it reads");
    assert_eq!(golden.flights.len(), 3);
    golden.flights
}

/// Eight seconds through kinks, where controls meet their limits, in m/s, rad/s, m and rad: what SciPy's events and our own leave.
#[test]
fn saturated_flights_are_those_of_scipy() {
    for flight in golden() {
        let scenario = flight.scenario();
        let path = flown(&scenario, flight.times.len() - 1);
        assert_eq!((path.stop, path.samples.len()), (None, flight.times.len()), "{}", flight.name);
        let v = scenario.aircraft.speed();
        let apart = |got: [f64; 3], want: [f64; 3]| (Vector3::from(got) - Vector3::from(want)).amax();
        let mut worst = [0.0_f64; 5];
        for (k, s) in path.samples.iter().enumerate() {
            let controls = as_array(&s.controls);
            let of_controls = (0..4).map(|i| (controls[i] - flight.controls[k][i]).abs()).fold(0.0, f64::max);
            let apart = [
                apart([v + s.longitudinal[0], s.lateral[0], s.longitudinal[1]], flight.velocity[k]),
                apart([s.lateral[1], s.longitudinal[2], s.lateral[2]], flight.rates_of_turn[k]),
                apart(s.attitude.to_earth([1.0, 0.0, 0.0]), flight.nose[k]),
                apart(s.position, flight.position[k]),
                of_controls,
            ];
            // At the moment of a jump, before and after it are both right.
            let jumps = flight.pilot.as_ref().is_some_and(|p| [p.2, p.3].contains(&flight.times[k]));
            for i in 0..if jumps { 4 } else { 5 } {
                worst[i] = worst[i].max(apart[i]);
            }
        }
        let allowed = [5e-6, 2e-6, 2e-7, 2e-5, 1e-6];
        assert!((0..5).all(|i| worst[i] < allowed[i]), "{}: {worst:?}", flight.name);
    }
}

/// The script looks every 0.2 ms.
#[test]
fn limits_bite_when_scipy_says_so() {
    let mut compared = 0;
    for flight in golden() {
        let path = flown(&flight.scenario(), 32);
        let found: Vec<(String, &str, f64, f64)> = path.bites.iter().map(told).collect();
        assert_eq!(found.len(), flight.bites.len(), "{}: {found:?} {:?}", flight.name, flight.bites);
        for (found, (control, limit, from, until)) in found.iter().zip(&flight.bites) {
            assert_eq!((found.0.as_str(), found.1), (control.as_str(), limit.as_str()), "{}", flight.name);
            assert!(
                (found.2 - from).abs() < 5e-4 && (found.3 - until).abs() < 5e-4,
                "{found:?} {from} {until}"
            );
            compared += 1;
        }
        let sentences = words::limits::sentences(&path.bites);
        assert!(!sentences.is_empty() && sentences.iter().all(|of| of.starts_with("The ")), "{sentences:?}");
    }
    assert!(compared > 8, "{compared}");
}

fn told(bite: &Bite) -> (String, &'static str, f64, f64) {
    let limit = match bite.limit {
        Limited::Deflection => "deflection",
        Limited::Rate => "rate",
    };
    (words::limits::control(bite.control).to_owned(), limit, bite.from, bite.until)
}

/// The largest difference from the linear loop in the plane's states, velocities over V, of a disturbance so many times as large.
fn difference(scenario: &Scenario, times: f64) -> f64 {
    let mut scenario = scenario.clone();
    set(&mut scenario, &[("times", times)]);
    let findings = Findings::of(scenario);
    let path = findings.flight_in(240).expect("a motion").expect("it flies");
    assert_eq!(path.stop, None);
    let linear = findings.closed_motion_in(240).expect("a law");
    assert_eq!(path.samples.len(), linear.states.len());
    let plane = findings.scenario().plane;
    let v = findings.scenario().aircraft.speed();
    let apart = |k: usize| {
        let four = match plane {
            Plane::Longitudinal => path.samples[k].longitudinal,
            Plane::Lateral => path.samples[k].lateral,
        };
        let left = four - Vector4::from_fn(|i, _| linear.states[k][i]);
        let scale = match plane {
            Plane::Longitudinal => [v, v, 1.0, 1.0],
            Plane::Lateral => [v, 1.0, 1.0, 1.0],
        };
        (0..4).map(|i| (left[i] / scale[i]).abs()).fold(0.0, f64::max)
    };
    (0..path.samples.len()).map(apart).fold(0.0, f64::max)
}

/// What the first order leaves is of second order or higher, with washouts and lags and without, and where what is asked for jumps.
#[test]
fn the_error_of_the_linear_loop_falls_as_the_square_of_the_amplitude() {
    use Plane::{Lateral, Longitudinal};
    type Case = (&'static str, &'static [(&'static str, f64)], Plane, Source, Shape);
    let cases: [Case; 9] = [
        (
            "b747-cruise-etkin",
            &[("k.r_dr", 1.0), ("washout", 3.0), ("actuator", 0.1)],
            Lateral,
            Source::Rudder,
            Shape::Pulse,
        ),
        (
            "b747-cruise-etkin",
            &[("k.r_dr", 1.0), ("k.phi_da", -0.5)],
            Lateral,
            Source::BankCommand,
            Shape::Step,
        ),
        (
            "navion",
            &[("k.q_de", 0.3), ("k.alpha_de", 0.5)],
            Longitudinal,
            Source::VerticalGust,
            Shape::OneMinusCosine,
        ),
        ("navion", &[("k.alpha_de", 0.5)], Longitudinal, Source::VerticalGust, Shape::Step),
        (
            "navion",
            &[("k.psi_da", -0.5), ("k.phi_da", -0.5), ("actuator", 0.05)],
            Lateral,
            Source::HeadingCommand,
            Shape::Step,
        ),
        (
            "b747-approach",
            &[
                ("k.theta_de", 1.0),
                ("k.q_de", 1.0),
                ("k.h_de", 1e-3),
                ("k.u_dt", -0.02),
                ("actuator", 0.1),
                ("engine", 2.0),
            ],
            Longitudinal,
            Source::HeightCommand,
            Shape::Step,
        ),
        (
            "cessna-172",
            &[("k.theta_de", 1.0), ("k.u_dt", -0.05)],
            Longitudinal,
            Source::PitchCommand,
            Shape::Step,
        ),
        (
            "nt33a",
            &[("k.beta_dr", -0.5), ("k.r_dr", 0.5), ("washout", 2.0)],
            Lateral,
            Source::SideGust,
            Shape::Step,
        ),
        ("a4d", &[("k.r_dr", 0.5), ("washout", 2.0)], Lateral, Source::YawRateCommand, Shape::Step),
    ];
    for (key, law, plane, source, shape) in cases {
        let mut scenario = disturbed(with(key, law), plane, source, shape);
        set(
            &mut scenario,
            &[
                ("time", 12.0),
                ("to_h", 10.0),
                ("to_phi", 0.1),
                ("to_theta", 0.03),
                ("to_r", 0.03),
                ("to_psi", 0.1),
                ("gust", 2.0),
                ("side_gust", 3.0),
                ("rudder", 0.1),
            ],
        );
        let [large, small] = [1.0, 0.1].map(|times| difference(&scenario, times));
        let slope = (large / small).ln() / 10_f64.ln();
        assert!(slope > 1.85, "{key}, {source:?}: slope {slope} from {large} and {small}");
        assert!(large < 0.05, "{key}, {source:?}: {large}");
    }
}

#[test]
fn a_law_without_gains_flies_bit_for_bit_as_none() {
    for (key, plane, source) in [
        ("navion", Plane::Longitudinal, Source::Elevator),
        ("b747-cruise-etkin", Plane::Lateral, Source::SideGust),
        ("nt33a", Plane::Lateral, Source::Aileron),
    ] {
        let plain = disturbed(with(key, &[("time", 10.0)]), plane, source, Shape::Doublet);
        let mut lagged = plain.clone();
        set(&mut lagged, &[("washout", 3.0), ("washout_q", 2.0), ("actuator", 0.1), ("engine", 1.0)]);
        assert_eq!(flown(&plain, 100), flown(&lagged, 100), "{key}");
        assert_eq!(flown(&plain, 100).bites, []);
    }
}

/// Next to no gain is next to no law, although the law then has its own states.
#[test]
fn a_vanishing_law_flies_as_none() {
    let plain = disturbed(with("navion", &[("time", 10.0)]), Plane::Lateral, Source::Rudder, Shape::Pulse);
    let mut law = plain.clone();
    set(&mut law, &[("k.r_dr", 1e-12), ("washout", 3.0), ("actuator", 0.1)]);
    let [plain, law] = [plain, law].map(|scenario| flown(&scenario, 100));
    for (a, b) in plain.samples.iter().zip(&law.samples) {
        assert!((a.lateral - b.lateral).amax() < 1e-6 && (a.longitudinal - b.longitudinal).amax() < 1e-6);
    }
}

/// A law of the other plane moves its controls as soon as the flight leaves the plane of symmetry.
#[test]
fn the_laws_of_both_planes_fly_at_once() {
    let mut banked = disturbed(
        with("navion", &[("k.h_de", 2e-3), ("k.q_de", 0.3)]),
        Plane::Lateral,
        Source::Release,
        Shape::Step,
    );
    set(&mut banked, &[("from_phi", 0.5), ("from_beta", 0.0), ("time", 8.0)]);
    let path = flown(&banked, 80);
    let elevator = path.samples.iter().map(|sample| sample.controls.elevator.abs()).fold(0.0, f64::max);
    let rudder = path.samples.iter().map(|sample| sample.controls.rudder.abs()).fold(0.0, f64::max);
    assert!(elevator > 1e-3 && rudder == 0.0, "{elevator} {rudder}");
}

#[test]
fn a_trajectory_shows_the_controls_of_the_law_and_where_they_are_at_their_limits() {
    let mut scenario = disturbed(
        with("navion", &[("k.r_dr", 4.0), ("actuator", 0.1)]),
        Plane::Lateral,
        Source::Rudder,
        Shape::Pulse,
    );
    set(&mut scenario, &[("rudder", 0.35), ("part", 1.0), ("time", 8.0)]);
    let findings = Findings::of(scenario);
    let flight = findings.trajectory(true).expect("a flight");
    assert!(flight.bites().iter().any(|bite| bite.control == Control::Rudder), "{:?}", flight.bites());
    let linear = findings.trajectory(false).expect("a motion");
    assert_eq!(linear.bites(), []);
    // After the pilot's pulse the law alone moves the rudder.
    for trajectory in [flight, linear] {
        let most = (21..80)
            .map(|k| trajectory.pose(0.1 * f64::from(k), 1.0).deflections[2].abs())
            .fold(0.0, f64::max);
        assert!(most > 1e-3 && most < 0.524, "{most}");
    }
}

#[test]
fn a_step_of_a_command_is_followed_as_the_steady_gain_of_the_loop_says() {
    // From rest to the commanded pitch angle: with a gain of pitch angle alone a part of it stays missing.
    let commanded = |gain: f64| {
        let mut scenario = disturbed(
            with("navion", &[("k.theta_de", gain), ("k.q_de", 0.5)]),
            Plane::Longitudinal,
            Source::PitchCommand,
            Shape::Step,
        );
        set(&mut scenario, &[("to_theta", 0.02), ("time", 60.0)]);
        Findings::of(scenario)
    };
    let mut before = 0.0;
    for gain in [0.5, 1.0, 2.0] {
        let findings = commanded(gain);
        let metrics = findings.flown_metrics().expect("a motion");
        let of = metrics.outputs.iter().find(|of| of.output == Output::PitchAngle).expect("there");
        let steady = of.steady.expect("it is stable");
        // More gain leaves less missing.
        assert!(steady > before && steady < 0.02, "{gain}: {steady}");
        before = steady;
        // The motion goes there, and its numbers are those of its samples.
        let motion = findings.flown_motion().expect("a motion");
        let values = motion.values(Output::PitchAngle);
        let mut long = findings.scenario().clone();
        set(&mut long, &[("time", 300.0)]);
        let end = *Findings::of(long)
            .flown_motion()
            .expect("a motion")
            .values(Output::PitchAngle)
            .last()
            .expect("samples");
        assert!((end - steady).abs() < 1e-5, "{end} {steady}");
        let step = of.step.expect("it is stable");
        let most = values.iter().copied().fold(0.0, f64::max);
        assert!(
            (most / steady - 1.0 - step.overshoot).abs() < 2e-3 || step.overshoot == 0.0,
            "{most} {step:?}"
        );
        // The open motion doesn't hear it.
        assert!(findings.motion().expect("a motion").values(Output::PitchAngle).iter().all(|x| *x == 0.0));
    }
}

/// Every command of every aircraft: what is listened to moves, and all numbers are finite.
#[test]
fn commands_of_every_aircraft_are_followed_or_not_heard() {
    let mut followed = 0;
    for found in embedded_aircraft().0 {
        let key = found.key.clone();
        for (gain, value, plane, source) in [
            ("k.theta_de", 0.5, Plane::Longitudinal, Source::PitchCommand),
            ("k.u_dt", -0.01, Plane::Longitudinal, Source::SpeedCommand),
            ("k.h_de", 1e-4, Plane::Longitudinal, Source::HeightCommand),
            ("k.phi_da", -0.5, Plane::Lateral, Source::BankCommand),
            ("k.r_dr", 0.5, Plane::Lateral, Source::YawRateCommand),
            ("k.psi_dr", 0.2, Plane::Lateral, Source::HeadingCommand),
        ] {
            let scenario = disturbed(with(&key, &[]), plane, source, Shape::Step);
            let output = Output::commanded(source.command().expect("a command"));
            if !Parameter::find(gain).expect("a row").applies(&scenario) {
                continue;
            }
            let findings = Findings::of(scenario.clone());
            assert!(findings.flown_motion().is_none_or(|m| m.values(output).iter().all(|x| *x == 0.0)));
            let mut closed = scenario;
            set(&mut closed, &[(gain, value), ("washout", 3.0), ("time", 20.0)]);
            assert!(closed.law.listens_to(plane, output));
            let findings = Findings::of(closed);
            let motion = findings.flown_motion().expect("a motion");
            let values = motion.values(output);
            assert!(values.iter().all(|x| x.is_finite()), "{key} {}", source.key());
            if motion.model.b.iter().any(|x| *x != 0.0) && values.iter().any(|x| *x != 0.0) {
                followed += 1;
            }
            let metrics = findings.flown_metrics().expect("a motion");
            assert!(metrics.outputs.iter().filter_map(|of| of.steady).all(f64::is_finite));
        }
    }
    assert!(followed > 60, "{followed}");
}
