//! What every rigid body and every flight must do, and what SciPy has them do.

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::inertia::Inertia;
use eigenwing::flight::motion::aerodynamics::Controls;
use eigenwing::flight::motion::flight_path::{Excitation, FlightPath};
use eigenwing::flight::motion::integrator::{Integrator, STEP_ERROR};
use eigenwing::flight::motion::response::TimeGrid;
use eigenwing::flight::motion::rigid_body::{Attitude, State};
use eigenwing::flight::motion::six_dof::{SixDof, Wind};
use nalgebra::{Vector3, Vector4};
use proptest::prelude::*;
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, TAU};

const G: f64 = 9.80665;

/// No plane of rotation that is special: three different moments of inertia and a product.
const TUMBLER: Inertia = Inertia { ix: 1400.0, iy: 2500.0, iz: 3300.0, ixz: 300.0 };

/// A body under gravity alone, for a time, at an error a step.
fn coast(inertia: Inertia, gravity: f64, state: State, duration: f64, step_error: f64) -> State {
    let rate =
        |_: f64, y: &[f64; 13]| State::from_array(*y).rate(&inertia, gravity, [0.0; 3], [0.0; 3]).to_array();
    let mut integrator = Integrator::new(rate, 0.0, duration, &state.to_array(), step_error).expect("time");
    while !integrator.is_done() {
        integrator.try_step().expect("a smooth motion can be followed");
    }
    State::from_array(integrator.state())
}

fn spinning(rates: [f64; 3]) -> State {
    State {
        velocity: [50.0, 3.0, -4.0],
        rates,
        attitude: Attitude::from_euler(0.3, 0.2, -0.5),
        position: [0.0; 3],
    }
}

/// h = I ω about the body axes [kg m²/s].
fn body_angular_momentum(inertia: &Inertia, [p, q, r]: [f64; 3]) -> [f64; 3] {
    let Inertia { ix, iy, iz, ixz } = *inertia;
    [ix * p - ixz * r, iy * q, iz * r - ixz * p]
}

fn kinetic(inertia: &Inertia, rates: [f64; 3]) -> f64 {
    0.5 * Vector3::from(body_angular_momentum(inertia, rates)).dot(&Vector3::from(rates))
}

fn angular_momentum(inertia: &Inertia, state: &State) -> Vector3<f64> {
    state.attitude.to_earth(body_angular_momentum(inertia, state.rates)).into()
}

/// ½V² + g h and ½ω·h of a body that turns about every four seconds. 10⁻⁹ in each of some 2,000 steps may add up to 2·10⁻⁶,
/// half as much again for a start that is not of that size.
#[test]
fn a_tumbling_body_without_air_keeps_its_energy_to_the_error_of_integration() {
    let start = spinning([1.2, 0.8, -0.6]);
    let energy = |state: &State| 0.5 * Vector3::from(state.velocity).norm_squared() + G * state.position[2];
    let error = |step_error: f64| {
        let end = coast(TUMBLER, G, start, 60.0, step_error);
        assert!(end.position[2] < -1e4, "it falls for a minute");
        let turning = kinetic(&TUMBLER, end.rates) / kinetic(&TUMBLER, start.rates) - 1.0;
        (energy(&end) / energy(&start) - 1.0).abs().max(turning.abs())
    };
    assert!(error(STEP_ERROR) < 3e-6, "{}", error(STEP_ERROR));
    // and the error is the integrator's: it falls with what a step may err
    let errors = [1e-5, 1e-7, 1e-9].map(error);
    assert!(errors[1] < errors[0] / 20.0 && errors[2] < errors[1] / 20.0, "{errors:?}");
}

/// Without air the centre of gravity flies a parabola, however the body tumbles.
#[test]
fn a_tumbling_body_flies_galileos_parabola() {
    let start = spinning([1.2, 0.8, -0.6]);
    let v = start.attitude.to_earth(start.velocity);
    let end = coast(TUMBLER, G, start, 10.0, STEP_ERROR);
    let want = [v[0] * 10.0, v[1] * 10.0, -v[2] * 10.0 - 0.5 * G * 100.0];
    for (got, want) in end.position.into_iter().zip(want) {
        assert!((got - want).abs() < 1e-5, "{got} should be {want}");
    }
}

#[test]
fn without_torque_the_angular_momentum_stands_still_in_earth_axes() {
    let start = spinning([1.2, 0.8, -0.6]);
    let before = angular_momentum(&TUMBLER, &start);
    for seconds in [1.0, 10.0, 60.0] {
        let end = coast(TUMBLER, 0.0, start, seconds, STEP_ERROR);
        let moved = (angular_momentum(&TUMBLER, &end) - before).norm() / before.norm();
        assert!(moved < 1e-6, "{moved} after {seconds} s");
        assert!((end.attitude.square() - 1.0).abs() < 1e-6, "{}", end.attitude.square());
    }
}

/// Goldstein, *Classical Mechanics*, 2nd ed., §5-6 and §5-7: seen from the body ω goes round its axis at Ω = p (I − C)/I,
/// seen from the Earth the axis goes round the angular momentum at h/I.
#[test]
fn a_spinning_symmetric_body_precesses_at_the_textbooks_rates() {
    let (c, i) = (800.0, 2000.0);
    let body = Inertia { ix: c, iy: i, iz: i, ixz: 0.0 };
    let (p, q) = (3.0, 0.4);
    let start = State { velocity: [0.0; 3], ..spinning([p, q, 0.0]) };
    let omega = p * (i - c) / i;
    for t in [0.5, 2.0, 7.0, 20.0] {
        let end = coast(body, 0.0, start, t, STEP_ERROR);
        let want = [p, q * (omega * t).cos(), -q * (omega * t).sin()];
        for (got, want) in end.rates.into_iter().zip(want) {
            assert!((got - want).abs() < 1e-7, "{got} should be {want} at {t} s");
        }
        let h = angular_momentum(&body, &start);
        let turn = nalgebra::Rotation3::new(h.normalize() * (h.norm() / i * t));
        let axis = |state: &State| Vector3::from(state.attitude.to_earth([1.0, 0.0, 0.0]));
        let apart = (axis(&end) - turn * axis(&start)).norm();
        assert!(apart < 1e-7, "the axis is {apart} away at {t} s");
    }
}

/// About the axis of the middle moment of inertia a body does not keep spinning: it turns over, again and again
/// (Landau & Lifshitz, *Mechanics*, §37); about the other two it stays.
#[test]
fn only_about_the_intermediate_axis_does_a_body_flip() {
    let body = Inertia { ix: 1000.0, iy: 2000.0, iz: 3000.0, ixz: 0.0 };
    let lowest = |axis: usize| {
        let mut rates = [0.01; 3];
        rates[axis] = 2.0;
        let start = State { velocity: [0.0; 3], ..spinning(rates) };
        (1..=60)
            .map(|t| coast(body, 0.0, start, f64::from(t) * 0.5, STEP_ERROR).rates[axis])
            .fold(2.0, f64::min)
    };
    assert!(lowest(0) > 1.99 && lowest(2) > 1.99);
    assert!(lowest(1) < -1.99, "{}", lowest(1));
    // at first it leaves as e^{λt}, λ = q √((Iy − Ix)(Iz − Iy)/(Ix Iz)): here p = p₀ cosh λt where r = 0
    let (tiny, lambda, t) = (1e-6, 2.0 * (1.0_f64 / 3.0).sqrt(), 4.0);
    let start = State { velocity: [0.0; 3], ..spinning([tiny, 2.0, 0.0]) };
    let p = coast(body, 0.0, start, t, 1e-13).rates[0];
    assert!((p / (tiny * (lambda * t).cosh()) - 1.0).abs() < 1e-5, "{p}");
}

/// Straight over the top: θ rises to 90° and falls again while bank and heading turn about by 180°.
#[test]
fn a_loop_passes_through_the_vertical_both_ways() {
    let start = State { attitude: Attitude::from_euler(0.0, 0.0, 0.0), ..spinning([0.0, 1.0, 0.0]) };
    let mut steepest = [0.0_f64; 2];
    for k in 0..=80 {
        let t = TAU * f64::from(k) / 80.0;
        let end = if k == 0 { start } else { coast(TUMBLER_WITHOUT_PRODUCT, 0.0, start, t, STEP_ERROR) };
        let [phi, theta, _] = end.attitude.euler();
        assert!((theta - t.sin().asin()).abs() < 2e-4, "θ is {theta} at {t} s");
        let over = t > FRAC_PI_2 + 0.01 && t < 3.0 * FRAC_PI_2 - 0.01;
        assert!((phi.abs() > 3.0) == over || (theta.abs() - FRAC_PI_2).abs() < 0.01, "φ is {phi} at {t} s");
        let nose = end.attitude.to_earth([1.0, 0.0, 0.0]);
        assert!((nose[0] - t.cos()).abs() < 1e-7 && (nose[2] + t.sin()).abs() < 1e-7);
        steepest = [steepest[0].min(theta), steepest[1].max(theta)];
    }
    assert!(steepest[0] < -1.57 && steepest[1] > 1.57);
}

const TUMBLER_WITHOUT_PRODUCT: Inertia = Inertia { ixz: 0.0, ..TUMBLER };

proptest! {
    #[test]
    fn attitude_gives_its_angles_back(phi in -3.1..3.1, theta in -1.55..1.55, psi in -3.1..3.1) {
        let attitude: Attitude = Attitude::from_euler(phi, theta, psi);
        for (got, want) in attitude.euler().into_iter().zip([phi, theta, psi]) {
            prop_assert!((got - want).abs() < 1e-12, "{got} should be {want}");
        }
        prop_assert!((attitude.square() - 1.0).abs() < 1e-15);
        let earth = attitude.to_earth([0.3, -0.7, 0.2]);
        let back = attitude.to_body(earth);
        for (got, want) in back.into_iter().zip([0.3, -0.7, 0.2]) {
            prop_assert!((got - want).abs() < 1e-14);
        }
    }

    /// φ̇ = p + tan θ (q sin φ + r cos φ) and θ̇ = q cos φ − r sin φ, read off the quaternion (Etkin & Reid, eq. 4.4,7).
    #[test]
    fn euler_rates_are_the_textbooks(
        phi in -3.1..3.1_f64, theta in -1.5..1.5_f64, psi in -3.1..3.1,
        p in -2.0..2.0, q in -2.0..2.0, r in -2.0..2.0, length in 0.5..2.0_f64,
    ) {
        let Attitude { w, x, y, z } = Attitude::from_euler(phi, theta, psi);
        let attitude = Attitude { w: w * length, x: x * length, y: y * length, z: z * length };
        let [phi_rate, theta_rate] = attitude.euler_rates(&attitude.rate([p, q, r]));
        let want = p + theta.tan() * (q * phi.sin() + r * phi.cos());
        prop_assert!((phi_rate - want).abs() < 1e-11 * (1.0 + want.abs()) / theta.cos(), "{phi_rate}, {want}");
        prop_assert!((theta_rate - (q * phi.cos() - r * phi.sin())).abs() < 1e-11 / theta.cos());
    }
}

fn golden() -> Value {
    serde_json::from_str(include_str!("data/flight_golden.json")).expect("the data file reads")
}

fn rows(of: &Value) -> Vec<[f64; 3]> {
    serde_json::from_value(of.clone()).expect("rows of three numbers")
}

fn assert_rows(what: &str, got: impl Iterator<Item = [f64; 3]>, want: &Value, allowed: f64) {
    let (got, want) = (got.collect::<Vec<_>>(), rows(want));
    assert_eq!(got.len(), want.len(), "{what}");
    for (k, (got, want)) in got.iter().zip(&want).enumerate() {
        let apart = (Vector3::from(*got) - Vector3::from(*want)).amax();
        assert!(apart < allowed, "{what}, row {k}: {got:?} should be {want:?}");
    }
}

#[test]
fn torque_free_motion_is_scipys() {
    let golden = &golden()["torque_free"];
    let start = State {
        velocity: [0.0; 3],
        rates: [0.4, 1.1, -0.3],
        attitude: Attitude::from_euler(0.0, 0.0, 0.0),
        position: [0.0; 3],
    };
    let states: Vec<State> = (0..=30)
        .map(|t| if t == 0 { start } else { coast(TUMBLER, 0.0, start, f64::from(t), STEP_ERROR) })
        .collect();
    assert_rows("ω", states.iter().map(|s| s.rates), &golden["rates"], 2e-7);
    let noses = states.iter().map(|s| s.attitude.to_earth([1.0, 0.0, 0.0]));
    assert_rows("nose", noses, &golden["nose"], 2e-7);
}

/// Eight seconds with all controls and wind: the error is that of some hundred steps of 10⁻⁹ each, in m/s, rad/s and m.
fn assert_is_scipys(golden: &Value) {
    let number = |of: &Value| of.as_f64().expect("a number");
    let aircraft = embedded_aircraft().0.into_iter().find(|one| one.key == "navion").expect("it ships");
    let AircraftModel::Coefficients(mut aircraft_model) = aircraft.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.coefficients.longitudinal.cl_alphadot = number(&golden["cl_alphadot"]);
    aircraft_model.airframe.thrust_exponent = number(&golden["thrust_exponent"]);
    aircraft_model.airframe.thrust_offset = number(&golden["thrust_offset"]);
    let gamma0 = number(&golden["gamma0"]);
    // The source's own C_L, 0.41, in the climb too.
    aircraft_model.reference.condition.gamma0 = gamma0;
    aircraft_model.condition.gamma0 = gamma0;
    let flight =
        SixDof::new(&EditedModel::new(AircraftModel::Coefficients(aircraft_model))).expect("it flies");
    let on = |t: f64, from: f64, name: &str| {
        if t >= from { number(&golden["controls"][name]) } else { 0.0 }
    };
    let controls = |t: f64| Controls {
        elevator: on(t, 1.0, "elevator"),
        throttle: 0.0,
        aileron: on(t, 2.0, "aileron"),
        rudder: on(t, 1.0, "rudder"),
    };
    let blowing: [f64; 3] = serde_json::from_value(golden["wind"].clone()).expect("three numbers");
    let wind = |t: f64| Wind { velocity: if t >= 3.0 { blowing } else { [0.0; 3] }, ..Wind::default() };
    let excitation = Excitation {
        controls: &controls,
        wind: &wind,
        edges: &[3.0, 1.0, 2.0],
        longitudinal: Vector4::zeros(),
        lateral: Vector4::zeros(),
        heading: 0.0,
        position: [0.0; 3],
        servos: None,
    };
    let FlightPath { samples, stop, .. } = flight.fly(&excitation, TimeGrid { duration: 8.0, steps: 16 });
    assert_eq!(stop, None);
    let v = flight.trim.speed;
    let velocity = samples.iter().map(|s| [v + s.longitudinal[0], s.lateral[0], s.longitudinal[1]]);
    assert_rows("velocity", velocity, &golden["velocity"], 1e-6);
    let rates = samples.iter().map(|s| [s.lateral[1], s.longitudinal[2], s.lateral[2]]);
    assert_rows("rates", rates, &golden["rates"], 1e-7);
    let nose = samples.iter().map(|s| s.attitude.to_earth([1.0, 0.0, 0.0]));
    assert_rows("nose", nose, &golden["nose"], 1e-7);
    assert_rows("position", samples.iter().map(|s| s.position), &golden["position"], 1e-5);
    let banked = samples.iter().map(|s| s.euler[0].abs()).fold(0.0, f64::max);
    assert!(banked > 0.2, "it is no small disturbance, {banked}");
}

#[test]
fn the_navions_flight_is_scipys() {
    assert_is_scipys(&golden()["navion"]);
}

/// Climbing behind a propeller on a low thrust line, with lift that goes with α̇.
#[test]
fn its_flight_with_another_engine_and_late_downwash_is_scipys() {
    assert_is_scipys(&golden()["navion_otherwise"]);
}
