//! Transfer functions in factored form against python-control and SciPy (`data/transfer_functions.json`, made by
//! `scripts/transfer_golden.py`), and against the frequency response.

mod reference;

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::path_rates::path_rates;
use eigenwing::flight::motion::response::{DrivenSystem, Forcing};
use eigenwing::flight::motion::transfer_function::{StateSpace, TransferFunction};
use eigenwing::key::Keyed as _;
use eigenwing::scenario::{Parameter, Scenario, Source};
use eigenwing::words::transfer_function::{fraction, zeros_on_the_right};
use nalgebra::{Complex, Vector2, Vector4};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    aircraft: String,
    plane: String,
    input: String,
    output: String,
    gain: f64,
    zeros: Vec<[f64; 2]>,
}

#[test]
fn gain_and_zeros_of_six_aircraft_are_those_of_python_control() {
    let file: File =
        serde_json::from_str(include_str!("data/transfer_functions.json")).expect("the data file reads");
    let mut compared = 0;
    for case in &file.cases {
        let plane = Plane::by_key(&case.plane).expect("a plane");
        let model = reference::reference(&case.aircraft).model(plane);
        let input = usize::from(matches!(case.input.as_str(), "throttle" | "rudder"));
        let step = Input::Step { amplitude: 1.0, start: 0.0 };
        let forced = DrivenSystem {
            a: model.a,
            path: path_rates(&model),
            forcings: vec![Forcing::new(model.b.column(input).into_owned(), step)],
            start: Vector4::zeros(),
            start_path: Vector2::zeros(),
        };
        let row = Output::by_key(&case.output).expect("an output").row(&model, &forced);
        let found = StateSpace::of(&forced, &row, 0).expect("an input").factored().expect("roots");
        let what = format!("{} {} by {}", case.aircraft, case.output, case.input);
        assert!((found.gain / case.gain - 1.0).abs() < 1e-7, "{what}: {} {}", found.gain, case.gain);
        assert_eq!(found.zeros.len(), case.zeros.len(), "{what}: {:?}", found.zeros);
        let mut left = found.zeros.clone();
        let largest = case.zeros.iter().map(|[re, im]| re.hypot(*im)).fold(1.0, f64::max);
        for [re, im] in &case.zeros {
            let expected = Complex::new(*re, *im);
            let near = |k: &usize| (left[*k] - expected).norm();
            let k = (0..left.len()).min_by(|a, b| near(a).total_cmp(&near(b))).expect("as many");
            // Two zeros at one place are good to half the digits.
            let tolerance = if expected.norm() < 1e-5 { 1e-5 } else { 1e-8 * largest };
            assert!(near(&k) <= tolerance, "{what}: {expected} {:?}", found.zeros);
            left.swap_remove(k);
            compared += 1;
        }
    }
    assert!(compared > 250, "{compared}");
}

/// K ∏(s − z) / ∏(s − p).
fn value(function: &TransferFunction, s: Complex<f64>) -> Complex<f64> {
    let product = |roots: &[Complex<f64>]| roots.iter().map(|root| s - root).product::<Complex<f64>>();
    product(&function.zeros) * function.gain / product(&function.poles)
}

#[test]
fn the_factors_make_the_frequency_response_of_every_aircraft_output_and_input() {
    let mut compared = 0;
    for aircraft in embedded_aircraft().0 {
        let aircraft = Arc::new(aircraft);
        for source in Source::VALUES.iter().copied().filter(|source| !source.shapes().is_empty()) {
            for plane in Plane::ALL {
                let mut scenario = Scenario::new(aircraft.clone());
                scenario.plane = plane;
                scenario.disturbance.choices[plane].source = source;
                for (key, value) in [("k.q_de", 0.3), ("k.r_dr", 0.5), ("washout", 3.0), ("actuator", 0.1)] {
                    let parameter = Parameter::find(key).expect("a row");
                    parameter.set(&mut scenario, value);
                }
                let findings = Findings::of(scenario);
                for &output in Output::of(plane) {
                    let Some(response) = findings.frequency_over(output, (0.01, 100.0), 9) else { continue };
                    let at: Vec<f64> = response.points.iter().map(|point| point.frequency).collect();
                    let closed = findings.closed_frequency_at(output, &at).unwrap_or_default();
                    let under =
                        findings.closed_state_space(output).map(|whole| whole.factored().expect("roots"));
                    let open = response.function.as_ref().expect("roots");
                    let both = [(Some(open), &response.points), (under.as_ref(), &closed)];
                    for (function, points) in both {
                        let Some(function) = function else { continue };
                        let most = points.iter().map(|p| p.value.norm()).fold(0.0, f64::max);
                        for point in points {
                            let found = value(function, Complex::new(0.0, point.frequency));
                            // Beside a zero little is left of large numbers.
                            let error = (found - point.value).norm();
                            assert!(
                                error <= 1e-6 * point.value.norm() + 1e-9 * most,
                                "{} {source:?} {output:?} at {}: {found} {}",
                                aircraft.key,
                                point.frequency,
                                point.value
                            );
                            compared += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(compared > 5000, "{compared}");
}

fn function(gain: f64, zeros: &[(f64, f64)], poles: &[(f64, f64)]) -> TransferFunction {
    let roots = |all: &[(f64, f64)]| all.iter().map(|(re, im)| Complex::new(*re, *im)).collect();
    TransferFunction { gain, zeros: roots(zeros), poles: roots(poles) }
}

#[test]
fn factors_are_written_with_frequency_and_damping_the_slowest_first() {
    let of = function(
        -12.0,
        &[(-2.0, 0.0), (0.0, 0.0), (0.25, 0.0)],
        &[(-3.0, 4.0), (-3.0, -4.0), (0.0, 0.5), (0.0, -0.5)],
    );
    let line = fraction(&of, 1.0).line();
    assert_eq!(line, "−12.00 s (s − 0.250) (s + 2.00) / [(s² + 0.500²) (s² + 2·0.600·5.00 s + 5.00²)]");
    let sentence = zeros_on_the_right(&of).expect("one");
    assert!(sentence.starts_with("A zero lies in the right half-plane, at s = 0.25"), "{sentence}");
    assert!(sentence.ends_with("a step is answered the wrong way first"), "{sentence}");
}

#[test]
fn zeros_on_the_right_are_said_to_mislead_the_phase_where_they_turn_no_answer_around() {
    let pair = function(1.0, &[(0.3, 2.0), (0.3, -2.0)], &[(-1.0, 0.0); 3]);
    let sentence = zeros_on_the_right(&pair).expect("a pair");
    assert!(sentence.starts_with("Zeros lie") && sentence.contains("phase"), "{sentence}");
    assert_eq!(zeros_on_the_right(&function(1.0, &[(-1.0, 0.0)], &[(-2.0, 0.0)])), None);
}

#[test]
fn crossovers_are_where_the_gain_is_one_and_where_the_phase_is_half_a_turn() {
    // Three lags 1/(s + 1) and a gain of 4: |G| = 1 at √(4^{2/3} − 1), half a turn at √3.
    let points = (0..=400).map(|k| {
        let frequency = 10_f64.powf(-1.0 + f64::from(k) / 200.0);
        let value = Complex::new(1.0, frequency).powi(-3) * 4.0;
        let phase = -3.0 * frequency.atan();
        eigenwing::flight::motion::frequency_response::FrequencyPoint { frequency, value, phase }
    });
    let response = eigenwing::findings::FrequencyResponse {
        points: points.collect(),
        peaks: Vec::new(),
        function: None,
    };
    let [gain] = response.gain_crossovers()[..] else { panic!("one crossover") };
    assert!((gain / (4_f64.powf(2.0 / 3.0) - 1.0).sqrt() - 1.0).abs() < 1e-4, "{gain}");
    let [(frequency, phase)] = response.phase_crossovers()[..] else { panic!("one crossover") };
    assert!((frequency / 3_f64.sqrt() - 1.0).abs() < 1e-4 && phase == -std::f64::consts::PI, "{frequency}");
}

#[test]
fn an_input_that_does_not_reach_an_output_has_the_gain_zero() {
    let model = reference::reference("navion_teper_sl").model(Plane::Longitudinal);
    let step = Input::Step { amplitude: 1.0, start: 0.0 };
    let forced = DrivenSystem::from_rest(model.a, Vector4::zeros(), step);
    let row = Output::PitchRate.row(&model, &forced);
    let found = StateSpace::of(&forced, &row, 0).expect("an input").factored().expect("roots");
    assert_eq!((found.gain, found.zeros.len(), found.poles.len()), (0.0, 0, 4));
}
