//! Laws of feedback against python-control (`data/feedback`, made by `scripts/feedback_golden.py`), and what must hold of any.

mod franklin;
mod reference;

use std::collections::BTreeMap;

use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::feedback::appended::AppendedState;
use eigenwing::flight::feedback::closed_model::ClosedModel;
use eigenwing::flight::feedback::law::signals;
use eigenwing::flight::feedback::loop_response::respond_closed;
use eigenwing::flight::feedback::loop_transfer::{LoopTransfer, closed_frequency_response};
use eigenwing::flight::feedback::margins::LoopMargins;
use eigenwing::flight::feedback::{Law, LoopAnalysis, analyse_loop};
use eigenwing::flight::modes::eigen::{eigen, eigenvalues};
use eigenwing::flight::modes::mode::modes;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::path_rates::path_rates;
use eigenwing::flight::motion::response::{DrivenSystem, Forcing, TimeGrid, respond};
use franklin::franklin;
use nalgebra::{Complex, DMatrix, DVector, Vector2, Vector4};
use proptest::prelude::*;
use serde::Deserialize;

#[derive(Deserialize)]
struct Loops {
    cases: Vec<Case>,
}

/// An aircraft under a law.
#[derive(Deserialize)]
struct Case {
    name: String,
    aircraft: String,
    plane: String,
    gains: BTreeMap<String, f64>,
    washout: f64,
    actuator: f64,
    engine: f64,
    eigenvalues: Vec<[f64; 2]>,
    pilot: usize,
    times: Vec<f64>,
    outputs: Vec<[f64; 5]>,
    frequencies: Vec<f64>,
    answers: Vec<[[f64; 2]; 5]>,
    loops: BTreeMap<String, LoopData>,
}

#[derive(Deserialize)]
struct LoopData {
    poles: Vec<[f64; 2]>,
    values: Vec<[f64; 2]>,
    factors: Vec<[f64; 2]>,
    phases: Vec<[f64; 2]>,
    sensitivity: [f64; 2],
}

const INPUTS: [[&str; 2]; 2] = [["de", "dt"], ["da", "dr"]];
const SIGNALS: [[&str; 5]; 2] = [["u", "alpha", "q", "theta", "h"], ["beta", "p", "r", "phi", "psi"]];

impl Case {
    fn plane(&self) -> Plane {
        if self.plane == "lateral" { Plane::Lateral } else { Plane::Longitudinal }
    }

    fn model(&self) -> PlaneModel {
        let references = reference::references();
        references.iter().find(|of| of.id == self.aircraft).expect("a reference").model(self.plane())
    }

    fn law(&self) -> Law {
        let mut law = Law { actuator: self.actuator, engine: self.engine, ..Law::default() };
        let of_plane = &mut law.planes[self.plane()];
        of_plane.washout = self.washout;
        for (key, gain) in &self.gains {
            let (signal, input) = key.split_once('_').expect("a signal and an input");
            let signal = SIGNALS[self.plane() as usize].iter().position(|s| *s == signal).expect("known");
            let to_first = INPUTS[self.plane() as usize][0] == input;
            if to_first { of_plane.to_first[signal] = *gain } else { of_plane.to_second[signal] = *gain }
        }
        law
    }

    fn analysis(&self) -> LoopAnalysis {
        analyse_loop(&self.model(), &self.law(), None).expect("it can be analysed")
    }
}

fn cases() -> Vec<Case> {
    let file: Loops = serde_json::from_str(include_str!("data/feedback/loops.json")).expect("it reads");
    assert!(file.cases.len() >= 14);
    file.cases
}

fn complex([re, im]: [f64; 2]) -> Complex<f64> {
    Complex::new(re, im)
}

/// The largest distance of `found` from `expected`, each matched with the nearest that is left, relative to the largest of them.
fn distance(found: &[Complex<f64>], expected: &[[f64; 2]]) -> f64 {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    let mut left: Vec<Complex<f64>> = found.to_vec();
    let size = expected.iter().map(|x| complex(*x).norm()).fold(f64::MIN_POSITIVE, f64::max);
    let mut worst = 0.0_f64;
    for x in expected.iter().map(|x| complex(*x)) {
        let nearest = (0..left.len()).min_by(|&i, &j| (left[i] - x).norm().total_cmp(&(left[j] - x).norm()));
        worst = worst.max((left.swap_remove(nearest.expect("as many")) - x).norm() / size);
    }
    worst
}

/// All eigenvalues of modes, both of each pair.
fn both(analysis: &LoopAnalysis) -> Vec<Complex<f64>> {
    let of = |lambda: Complex<f64>| std::iter::once(lambda).chain((lambda.im > 0.0).then(|| lambda.conj()));
    analysis.modes.iter().flat_map(|mode| of(mode.mode.lambda)).collect()
}

#[test]
fn eigenvalues_under_a_law_are_those_of_python_control() {
    for case in cases() {
        let error = distance(&both(&case.analysis()), &case.eigenvalues);
        assert!(error < 1e-9, "{}: {error:e}", case.name);
    }
}

/// The equations of an aircraft that its pilot drives from rest.
fn driven(model: &PlaneModel, pilot: usize, amplitude: f64) -> DrivenSystem {
    let input = Input::Step { amplitude, start: 0.0 };
    DrivenSystem {
        a: model.a,
        path: path_rates(model),
        forcings: vec![Forcing::new(model.b.column(pilot).into_owned(), input)],
        start: Vector4::zeros(),
        start_path: Vector2::zeros(),
    }
}

#[test]
fn motions_under_a_law_are_those_of_python_control() {
    let mut compared = 0;
    for case in cases() {
        let (model, analysis) = (case.model(), case.analysis());
        let forced = driven(&model, case.pilot, 0.01);
        let grid = TimeGrid { duration: *case.times.last().expect("times"), steps: case.times.len() - 1 };
        let response =
            respond_closed(&analysis.closed, &forced, &DVector::zeros(analysis.closed.size()), grid);
        assert_eq!(response.states.len() < case.times.len(), response.cut_at.is_some());
        for (signal, output) in signals(case.plane()).into_iter().enumerate() {
            let row = output.row(&model, &forced);
            let shown = || case.outputs.iter().take(response.states.len());
            let largest = shown().map(|y| y[signal].abs()).fold(f64::MIN_POSITIVE, f64::max);
            for (k, expected) in shown().enumerate() {
                let four = Vector4::from_fn(|i, _| response.states[k][i]);
                let found = row.states.dot(&four) + row.path.dot(&response.path[k]);
                let error = (found - expected[signal]).abs() / largest;
                assert!(error < 1e-9, "{} {output:?} at {k} s: {found} {}", case.name, expected[signal]);
                compared += 1;
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

#[test]
fn answers_over_frequency_are_those_of_python_control() {
    for case in cases() {
        let (model, analysis) = (case.model(), case.analysis());
        let forced = driven(&model, case.pilot, 1.0);
        for (signal, output) in signals(case.plane()).into_iter().enumerate() {
            for (frequency, expected) in case.frequencies.iter().zip(&case.answers) {
                let points = closed_frequency_response(&analysis.closed, &forced, output, 0, &[*frequency]);
                let expected = complex(expected[signal]);
                let error = (points[0].value - expected).norm() / expected.norm();
                assert!(error < 1e-9, "{} {output:?} at {frequency} rad/s: {error:e}", case.name);
            }
        }
    }
}

#[test]
fn loops_and_their_margins_are_those_of_python_control() {
    let mut compared = 0;
    for case in cases() {
        let analysis = case.analysis();
        for (input, name) in INPUTS[case.plane() as usize].into_iter().enumerate() {
            let transfer = LoopTransfer::of(&analysis.closed, input).expect("eigenvalues");
            assert_eq!(transfer.is_some(), case.loops.contains_key(name), "{} {name}", case.name);
            let (Some(transfer), Some(data)) = (transfer, case.loops.get(name)) else { continue };
            let what = format!("{} {name}", case.name);
            assert!(distance(&transfer.poles, &data.poles) < 1e-9, "{what}");
            for (frequency, expected) in case.frequencies.iter().zip(&data.values) {
                let found = transfer.over_frequency(*frequency).expect("no pole there");
                let error = (found - complex(*expected)).norm() / complex(*expected).norm();
                assert!(error < 1e-9, "{what}: L({frequency}j) {error:e}");
            }
            let margins = LoopMargins::of(&transfer);
            let close = |found: f64, expected: f64| (found - expected).abs() <= 1e-9 * expected.abs();
            let at_rest =
                transfer.over_frequency(0.0).filter(|value| value.re < 0.0).map(|value| -1.0 / value.re);
            let factors = || data.factors.iter().map(|[factor, _]| *factor).chain(at_rest);
            let raise = factors().filter(|factor| *factor > 1.0).min_by(f64::total_cmp);
            let lower = factors().filter(|factor| *factor < 1.0).max_by(f64::total_cmp);
            for (found, expected) in [(margins.raise, raise), (margins.lower, lower)] {
                assert_eq!(found.is_some(), expected.is_some(), "{what}: {found:?} {expected:?}");
                if let (Some(found), Some(expected)) = (found, expected) {
                    assert!(close(found.factor, expected), "{what}: {found:?} {expected}");
                    compared += 1;
                }
            }
            let phase = data.phases.iter().min_by(|a, b| a[0].abs().total_cmp(&b[0].abs()));
            assert_eq!(margins.phase.is_some(), phase.is_some(), "{what}: {:?} {phase:?}", margins.phase);
            if let (Some(found), Some([angle, frequency])) = (margins.phase, phase) {
                assert!(
                    close(found.angle, *angle) && close(found.frequency, *frequency),
                    "{what}: {found:?}"
                );
                compared += 1;
            }
            assert_eq!(margins.sensitivity.is_some(), data.sensitivity[0] > 1.0, "{what}");
            if let Some(found) = margins.sensitivity {
                // A maximum is flat: its place is good to the root of its value's error.
                assert!(close(found.value, data.sensitivity[0]), "{what}: {found:?} {:?}", data.sensitivity);
                assert!((found.frequency / data.sensitivity[1] - 1.0).abs() < 1e-5, "{what}: {found:?}");
            }
            assert_eq!(margins.turns, Some(more_growing(&transfer)), "{what}");
        }
    }
    assert!(compared > 20, "{compared}");
}

/// Growing roots of the closed loop less those of the loop cut.
fn more_growing(transfer: &LoopTransfer) -> i32 {
    let all = || transfer.poles.iter().chain(&transfer.closed_poles);
    let radius = all().map(|pole| pole.norm()).fold(0.0, f64::max);
    let growing = |poles: &[Complex<f64>]| poles.iter().filter(|pole| pole.re > 1e-9 * radius).count() as i32;
    growing(&transfer.closed_poles) - growing(&transfer.poles)
}

#[derive(Deserialize)]
struct Matrices {
    matrices: Vec<MatrixData>,
}

#[derive(Deserialize)]
struct MatrixData {
    name: String,
    a: Vec<Vec<f64>>,
    eigenvalues: Vec<[f64; 2]>,
}

#[test]
fn eigenvalues_of_five_to_twelve_states_are_those_of_lapack() {
    let file: Matrices =
        serde_json::from_str(include_str!("data/feedback/eigenvalues.json")).expect("it reads");
    assert!(file.matrices.len() >= 40);
    for MatrixData { name, a, eigenvalues: expected } in &file.matrices {
        let n = a.len();
        let a = DMatrix::from_fn(n, n, |i, j| a[i][j]);
        let solved = eigen(&a).expect("it converges");
        // Simple roots; the badly scaled are as good as their balanced matrix.
        let error = distance(solved.values.as_slice(), expected);
        assert!(error < 1e-11, "{name}: {error:e}");
        assert!(distance(eigenvalues(&a).expect("likewise").as_slice(), expected) < 1e-11, "{name}");
        let long = a.map(Complex::from);
        for i in 0..n {
            let (value, v, l) = (solved.values[i], solved.right.column(i), solved.left.column(i));
            assert!((&long * v - v * value).norm() <= 1e-12 * a.norm(), "{name} {i}");
            assert!((long.tr_mul(&l) - l * value.conj()).norm() <= 1e-12 * a.norm(), "{name} {i}");
        }
    }
}

#[test]
fn a_law_without_gains_leaves_the_aircraft_as_it_is() {
    for reference in reference::references() {
        for plane in Plane::ALL {
            let model = reference.model(plane);
            let mut law = Law { actuator: 0.1, engine: 2.0, ..Law::default() };
            law.planes[plane].washout = 3.0;
            assert!(law.is_open(plane));
            let closed = ClosedModel::new(&model, &law).expect("finite");
            assert_eq!(closed.a, DMatrix::from_fn(4, 4, |i, j| model.a[(i, j)]));
            // The states are there where a gain is about to leave zero; the aircraft's modes are the same with them.
            let appended = [AppendedState::of_path(plane), AppendedState::washout(plane)]
                .into_iter()
                .chain(AppendedState::controls(plane))
                .collect();
            let closed = ClosedModel::with(&model, &law, appended).expect("finite");
            let found = eigenvalues(&closed.a).expect("it converges");
            let open = modes(&model).expect("it converges");
            for mode in &open {
                let nearest = found.iter().map(|x| (x - mode.lambda).norm()).fold(f64::INFINITY, f64::min);
                // The neutral heading is a second root at zero beside a slow spiral.
                assert!(
                    nearest <= 1e-10 * model.a.norm().max(1.0),
                    "{} {:?}",
                    reference.id,
                    mode.naming.name
                );
            }
        }
    }
}

fn yaw_damper(gain: f64, washout: f64) -> Law {
    let mut law = Law { actuator: 0.1, ..Law::default() };
    law.planes.lateral.to_second[2] = gain;
    law.planes.lateral.washout = washout;
    law
}

/// Damping ratio of the Dutch roll and the root of the spiral.
fn dutch_roll_and_spiral(gain: f64, washout: f64) -> (f64, f64) {
    let analysis = analyse_loop(&franklin(), &yaw_damper(gain, washout), None).expect("it can be analysed");
    let find =
        |name: ModeName| &analysis.modes.iter().find(|m| m.mode.naming.name == name).expect("there").mode;
    let pairs = analysis.modes.iter().filter(|mode| mode.mode.is_oscillatory());
    let least = pairs.filter_map(|mode| mode.mode.damping_ratio()).fold(f64::INFINITY, f64::min);
    (least, find(ModeName::Spiral).lambda.re)
}

/// The largest damping ratio over the gain, the gain, and the spiral there.
fn best(washout: f64) -> (f64, f64, f64) {
    let of = |k: i32| f64::from(k) * 0.01;
    let zeta = |k: &i32| dutch_roll_and_spiral(of(*k), washout).0;
    let k = (50..400).max_by(|a, b| zeta(a).total_cmp(&zeta(b))).expect("gains");
    let (zeta, spiral) = dutch_roll_and_spiral(of(k), washout);
    (zeta, of(k), spiral)
}

#[test]
fn the_yaw_damper_of_the_textbook_has_its_numbers() {
    let round = |x: f64, digits: i32| (x * 10_f64.powi(digits)).round() / 10_f64.powi(digits);
    let (zeta, gain, spiral) = best(0.0);
    assert_eq!((round(zeta, 3), gain, round(spiral, 3)), (0.479, 2.65, -0.331));
    let (zeta, gain, spiral) = best(3.0);
    assert_eq!((round(zeta, 3), gain, round(spiral, 3)), (0.273, 2.32, -0.004));
    for (gain, zeta, spiral) in [(1.0, 0.221, -0.121), (2.0, 0.416, -0.249)] {
        let found = dutch_roll_and_spiral(gain, 0.0);
        assert_eq!((round(found.0, 3), round(found.1, 3)), (zeta, spiral));
    }
    assert_eq!(round(dutch_roll_and_spiral(1.0, 3.0).0, 3), 0.188);
}

#[test]
fn states_of_the_law_have_modes_with_their_names() {
    let mut law = yaw_damper(1.0, 3.0);
    law.planes.lateral.to_first[4] = 1e-3;
    let analysis = analyse_loop(&franklin(), &law, None).expect("it can be analysed");
    let names: Vec<ModeName> = analysis.modes.iter().map(|mode| mode.mode.naming.name).collect();
    use ModeName::{AileronActuator, DutchRoll, Heading, RollSubsidence, RudderActuator, Spiral, Washout};
    assert_eq!(names, [DutchRoll, RollSubsidence, Spiral, Heading, Washout, AileronActuator, RudderActuator]);
    for mode in &analysis.modes {
        assert!((mode.participation.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!((mode.mode.participation.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

/// Actuators of one lag begin at one root: only the states of a mode tell whose it is.
#[test]
fn of_actuators_of_one_lag_each_mode_is_named_after_its_own() {
    use AppendedState::{Aileron, Rudder};
    use ModeName::{AileronActuator, RudderActuator};
    let mut told = 0;
    for reference in reference::references() {
        for (signal, gain, washout) in (0..5)
            .flat_map(|signal| [(-0.5, 0.0), (0.5, 0.0), (0.5, 3.0)].map(|(gain, to)| (signal, gain, to)))
        {
            let mut law = yaw_damper(1e-3, washout);
            law.planes.lateral.to_first[signal] = gain;
            let model = reference.model(Plane::Lateral);
            let analysis = analyse_loop(&model, &law, None).expect("it can be analysed");
            let share = |name: ModeName, state: AppendedState| {
                let mode = analysis.modes.iter().find(|mode| mode.mode.naming.name == name)?;
                let place = analysis.closed.appended.iter().position(|appended| *appended == state)?;
                Some(mode.participation[4 + place])
            };
            let shares = [
                (AileronActuator, Aileron),
                (RudderActuator, Rudder),
                (AileronActuator, Rudder),
                (RudderActuator, Aileron),
            ]
            .map(|(name, state)| share(name, state));
            let [Some(a), Some(b), Some(c), Some(d)] = shares else { continue };
            assert!(a + b >= c + d, "{} {signal} {gain} {washout}: {shares:?}", reference.id);
            told += 1;
        }
    }
    assert!(told > 50, "{told}");
}

/// A name may change along a gain only where the number of pairs does, or where two shapes exchange their states.
#[test]
fn names_do_not_flicker_along_any_gain() {
    let mut changes = 0;
    for reference in reference::references().into_iter().step_by(4) {
        for plane in Plane::ALL {
            for (input, signal) in (0..2).flat_map(|input| (0..5).map(move |signal| (input, signal))) {
                let model = reference.model(plane);
                for sign in [-1.0, 1.0] {
                    let mut before: Option<Vec<ModeName>> = None;
                    let mut changed = Vec::new();
                    for k in 1..=100 {
                        let mut law = Law { actuator: 0.1, engine: 1.0, ..Law::default() };
                        law.planes[plane].washout = 3.0;
                        let size = [0.01, 2.0, 2.0, 2.0, 0.01][signal];
                        let of_plane = &mut law.planes[plane];
                        let gains = if input == 0 { &mut of_plane.to_first } else { &mut of_plane.to_second };
                        gains[signal] = sign * size * f64::from(k) / 100.0;
                        let analysis = analyse_loop(&model, &law, None).expect("it can be analysed");
                        let names: Vec<ModeName> =
                            analysis.modes.iter().map(|m| m.mode.naming.name).collect();
                        if before.as_ref().is_some_and(|before| *before != names) {
                            changed.push((k, names.clone()));
                        }
                        before = Some(names);
                    }
                    let what = format!("{} {plane:?} {input} {signal} {sign}", reference.id);
                    assert!(changed.len() <= 8, "{what}: {changed:?}");
                    // Back and forth within a few steps is a flicker.
                    for pair in changed.windows(3) {
                        let [a, _, c] = pair else { continue };
                        assert!(a.1 != c.1 || c.0 - a.0 > 4, "{what}: {pair:?}");
                    }
                    changes += changed.len();
                }
            }
        }
    }
    assert!(changes > 20, "{changes}");
}

/// δ = +k y: against the turn, against the pitch, towards more stiffness.
#[test]
fn positive_gains_work_as_they_are_said_to() {
    let references = reference::references();
    let navion = references.iter().find(|of| of.id == "navion_teper_sl").expect("it is there");
    let rate = |plane: Plane, input: usize, signal: usize, row: usize, column: usize| {
        let model = navion.model(plane);
        let mut law = Law::default();
        let of_plane = &mut law.planes[plane];
        if input == 0 {
            of_plane.to_first[signal] = 0.1
        } else {
            of_plane.to_second[signal] = 0.1
        }
        let closed = ClosedModel::new(&model, &law).expect("finite");
        closed.a[(row, column)] - model.a[(row, column)]
    };
    let (lon, lat) = (Plane::Longitudinal, Plane::Lateral);
    // Yaw rate to the rudder and pitch rate to the elevator damp; α to the elevator stiffens.
    assert!(rate(lat, 1, 2, 2, 2) < 0.0);
    assert!(rate(lon, 0, 2, 2, 2) < 0.0);
    assert!(rate(lon, 0, 1, 2, 1) < 0.0);
    // Roll rate to the aileron drives the roll on, speed to the throttle the speed.
    assert!(rate(lat, 0, 1, 1, 1) > 0.0);
}

#[test]
fn a_vane_feels_a_gust_at_once() {
    let references = reference::references();
    let model = references[0].model(Plane::Lateral);
    let mut law = Law::default();
    law.planes.lateral.to_second[0] = 0.5;
    let closed = ClosedModel::new(&model, &law).expect("finite");
    let air = Vector4::new(1.0, 0.0, 0.0, 0.0);
    let mut gust = Forcing::new(-(model.a * air), Input::Step { amplitude: 1.0, start: 0.0 });
    gust.air = air;
    // Air that moves to the right as fast as the aircraft is to it as no air at all: β is zero, and the law doesn't move.
    let [column, _] = closed.columns(&gust);
    let along = &closed.a * DVector::from_row_slice(&[1.0, 0.0, 0.0, 0.0]);
    assert!((column + along).norm() < 1e-12);
}

/// The aircraft alone, driven by what its controls did under the law, does what it did under the law.
#[test]
fn a_motion_under_a_law_is_that_of_the_aircraft_with_its_controls_moved_so() {
    for case in cases() {
        let (model, analysis) = (case.model(), case.analysis());
        let forced = driven(&model, case.pilot, 0.01);
        let grid = TimeGrid { duration: 4.0, steps: 4000 };
        let response =
            respond_closed(&analysis.closed, &forced, &DVector::zeros(analysis.closed.size()), grid);
        let samples = |i: usize| Input::Samples {
            dt: response.dt,
            values: response.controls.iter().map(|controls| controls[i]).collect(),
        };
        let none = |_| Input::Step { amplitude: 0.0, start: 0.0 };
        let whole = analysis.closed.with_courses(&forced, [samples(0), samples(1)], none);
        let alone = respond(&whole, grid);
        let largest = response.states.iter().map(|x| x.rows(0, 4).norm()).fold(0.0, f64::max);
        for (x, four) in alone.states.iter().zip(response.as_of_aircraft().states) {
            // Straight between samples: the error is that of the second derivative.
            assert!((x - four).norm() <= 1e-4 * largest, "{}", case.name);
        }
    }
}

#[test]
fn the_steady_turn_is_what_a_yaw_damper_without_washout_fights() {
    let steady_rudder = |washout: f64| {
        let analysis =
            analyse_loop(&franklin(), &yaw_damper(1.0, washout), None).expect("it can be analysed");
        let closed = &analysis.closed;
        // What the law asks of the rudder in a turn at a yaw rate of 1 rad/s that has gone on for long: the washout is full.
        let mut x = DVector::zeros(closed.size());
        x[2] = 1.0;
        if let Some(k) = closed.appended.iter().position(|state| *state == AppendedState::YawRateWashout) {
            x[4 + k] = 1.0;
        }
        (closed.asked.row(1) * x)[0]
    };
    assert_eq!(steady_rudder(0.0), 1.0);
    assert_eq!(steady_rudder(3.0), 0.0);
}

fn any_law(plane: Plane) -> impl Strategy<Value = Law> {
    let gain = || prop_oneof![2 => Just(0.0), 3 => -2.0..2.0_f64];
    let gains = || [gain(), gain(), gain(), gain(), gain()];
    let lag = || prop_oneof![1 => Just(0.0), 2 => 0.02..2.0_f64];
    (gains(), gains(), lag(), lag(), lag()).prop_map(move |(first, second, washout, actuator, engine)| {
        let mut law = Law { actuator, engine, ..Law::default() };
        let of_plane = &mut law.planes[plane];
        // Speed and height are in metres.
        let sized = |gains: [f64; 5]| match plane {
            Plane::Longitudinal => [gains[0] * 0.01, gains[1], gains[2], gains[3], gains[4] * 0.01],
            Plane::Lateral => gains,
        };
        (of_plane.to_first, of_plane.to_second, of_plane.washout) = (sized(first), sized(second), washout);
        law
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// Nyquist: turns around −1 are growing roots of the closed loop less those of the loop cut.
    #[test]
    fn the_turns_around_minus_one_are_the_growing_roots_that_closing_adds(
        which in 0..16_usize,
        (plane, law) in prop_oneof![Just(Plane::Longitudinal), Just(Plane::Lateral)]
            .prop_flat_map(|plane| (Just(plane), any_law(plane))),
    ) {
        let model = reference::references()[which].model(plane);
        let closed = ClosedModel::new(&model, &law).expect("finite");
        for input in 0..2 {
            let Some(transfer) = LoopTransfer::of(&closed, input).expect("eigenvalues") else { continue };
            let radius = transfer.poles.iter().chain(&transfer.closed_poles).map(|pole| pole.norm()).fold(0.0, f64::max);
            // Beside the axis it is a matter of rounding which side a root is on.
            let all = || transfer.poles.iter().chain(&transfer.closed_poles);
            let decided = all().all(|pole| pole.re.abs() > 1e-7 * radius || pole.norm() < 1e-12 * radius);
            if decided {
                let margins = LoopMargins::of(&transfer);
                prop_assert_eq!(margins.turns, Some(more_growing(&transfer)), "{:?} {:?}", law, transfer);
            }
        }
    }

    #[test]
    fn every_law_has_modes_that_are_finite_and_named(
        which in 0..16_usize,
        (plane, law) in prop_oneof![Just(Plane::Longitudinal), Just(Plane::Lateral)]
            .prop_flat_map(|plane| (Just(plane), any_law(plane))),
    ) {
        let model = reference::references()[which].model(plane);
        let analysis = analyse_loop(&model, &law, None).expect("it can be analysed");
        let n = analysis.closed.size();
        prop_assert_eq!(both(&analysis).len(), n);
        for mode in &analysis.modes {
            prop_assert!(mode.shape.iter().chain(mode.adjoint.iter()).all(|x| x.re.is_finite() && x.im.is_finite()));
            prop_assert_eq!(mode.participation.len(), n);
            prop_assert!((0.0..=1.0).contains(&mode.mode.naming.confidence));
            prop_assert!(mode.mode.stability != Stability::Neutral || mode.mode.lambda.re == 0.0);
        }
    }
}

#[test]
fn load_factors_under_a_law_are_the_accelerations_of_the_motion() {
    // n_y of the aircraft whose rudder the law moves: the side force of the rudder is in it.
    let model = franklin();
    let analysis = analyse_loop(&model, &yaw_damper(1.0, 3.0), None).expect("it can be analysed");
    let forced = driven(&model, 1, 0.01);
    let of =
        |output: Output| closed_frequency_response(&analysis.closed, &forced, output, 0, &[2.0])[0].value;
    let s = Complex::new(0.0, 2.0);
    let trim = &model.trim;
    // f_y = v̇ + U₀ r − g φ
    let expected = (of(Output::SideSpeed) * s + of(Output::YawRate) * trim.u0()
        - of(Output::BankAngle) * trim.gravity)
        / trim.gravity;
    assert!((of(Output::SideLoad) - expected).norm() < 1e-9 * expected.norm());
}
