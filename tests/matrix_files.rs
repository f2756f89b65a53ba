//! Bare matrices from JSON, CSV and MATLAB text: every form of one model is the same model, and a mistake is one sentence
//! with its line.

use eigenwing::content::{Aircraft, MatrixFormat};
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::modes::mode::{Mode, modes};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::motion::frequency_response::{frequency_response, peaks, transfer};
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::response::DrivenSystem;
use nalgebra::{Matrix4, Matrix4x2, Vector4};

/// The Navion in metres (Teper, NASA CR-96008), rounded: what every form below says.
const A: [[f64; 4]; 4] = [
    [-0.0451, 0.0362, 0.0, -9.80665],
    [-0.3695, -2.0232, 53.64, 0.0],
    [0.0063, -0.1639, -2.9857, 0.0],
    [0.0, 0.0, 1.0, 0.0],
];
const B_ELEVATOR: [f64; 4] = [0.0, -8.59, -11.89, 0.0];

const JSON: &str = r#"{
  "name": "Navion, rounded",
  "units": "SI", "speed": 53.64,
  "states": ["u", "w", "q", "theta"],
  "inputs": ["elevator"],
  "A": [[-0.0451, 0.0362, 0, -9.80665],
        [-0.3695, -2.0232, 53.64, 0],
        [0.0063, -0.1639, -2.9857, 0],
        [0, 0, 1, 0]],
  "B": [[0], [-8.59], [-11.89], [0]]
}"#;

const CSV: &str = "\
# units: SI
speed,53.64

,u,w,q,theta,elevator
u,-0.0451,0.0362,0,-9.80665,0
w,-0.3695,-2.0232,53.64,0,-8.59
q,0.0063,-0.1639,-2.9857,0,-11.89
theta,0,0,1,0,0
";

const MATLAB: &str = "\
% Navion, rounded
% units: SI
clear; close all
U0 = 53.64;  g = 9.80665;
states = {'u','w','q','theta'};
inputs = {'elevator'};
A = [ -0.0451 0.0362 0 -9.80665
      -0.3695, -2.0232, ... the lift
      53.64, 0
      6.3e-3 -0.1639 -2.9857 0; 0 0 1 0 ];
B = [0 -8.59 -11.89 0]';
sys = ss(A, B, eye(4), 0);
";

fn read(text: &str, format: MatrixFormat) -> Result<Aircraft, String> {
    Aircraft::from_matrices("mine", text, format).map_err(|error| error.to_string())
}

fn model(text: &str, format: MatrixFormat) -> PlaneModel {
    let aircraft = read(text, format).expect("the file can be read");
    let AircraftModel::Matrices(aircraft_model) = aircraft.aircraft_model else {
        panic!("a study of matrices")
    };
    aircraft_model.longitudinal.or(aircraft_model.lateral).expect("one plane")
}

fn expected() -> (Matrix4<f64>, Matrix4x2<f64>) {
    let elevator = Vector4::from(B_ELEVATOR);
    (Matrix4::from_fn(|i, j| A[i][j]), Matrix4x2::from_columns(&[elevator, Vector4::zeros()]))
}

#[test]
fn the_three_forms_of_one_model_are_that_model() {
    for (text, format) in
        [(JSON, MatrixFormat::Json), (CSV, MatrixFormat::Csv), (MATLAB, MatrixFormat::Matlab)]
    {
        let model = model(text, format);
        assert_eq!((model.a, model.b), expected(), "{format:?}");
        assert_eq!((model.plane, model.trim.speed), (Plane::Longitudinal, 53.64));
    }
}

#[test]
fn matlab_states_may_be_named_in_a_comment_and_lines_may_end_as_on_windows() {
    let text = MATLAB
        .replace("states = {'u','w','q','theta'};", "% states: u w q theta")
        .replace("inputs = {'elevator'};", "% inputs = de")
        .replace('\n', "\r\n");
    assert_eq!(model(&text, MatrixFormat::Matlab).a, expected().0);
}

#[test]
fn a_comment_about_a_setting_is_only_a_comment() {
    let text = MATLAB
        .replace("% Navion, rounded", "% speed: 176 feet per second\n% states: x1 x2\n% A = the state matrix")
        .replace("% units: SI", "% units: feet at first\nunits = 'SI';");
    assert_eq!(model(&text, MatrixFormat::Matlab).trim.speed, 53.64);
}

#[test]
fn every_example_of_the_documentation_can_be_read() {
    let page = include_str!("../docs/MATRICES.md");
    for (mark, format) in [
        ("```json\n", MatrixFormat::Json),
        ("```csv\n", MatrixFormat::Csv),
        ("```matlab\n", MatrixFormat::Matlab),
    ] {
        let (_, rest) = page.split_once(mark).expect("an example of each form");
        let (example, _) = rest.split_once("```").expect("an example ends");
        let speed = model(example, format).trim.speed;
        assert!((speed - 53.6).abs() < 0.1, "{speed}");
    }
}

/// ẋ = A x in other states, T x: T A T⁻¹ has the same eigenvalues and must come back as A.
#[test]
fn order_feet_degrees_and_angle_of_attack_come_back_to_the_same_model() {
    // File order [theta, alpha, u, q], feet and degrees: x_file = S x_SI
    let (degree, foot, speed) = (1_f64.to_radians(), 0.3048, 53.64);
    let order = [3, 1, 0, 2];
    let one_in_si = [degree, speed * degree, foot, degree];
    let (a, b) = expected();
    let row = |i: usize| {
        let entries: Vec<String> = (0..4)
            .map(|j| a[(order[i], order[j])] * one_in_si[j] / one_in_si[i])
            .map(|x| format!("{x:e}"))
            .collect();
        let of_b = b[(order[i], 0)] * degree / one_in_si[i];
        format!("{},{of_b:e}\n", entries.join(","))
    };
    let text = format!(
        "units,ft-slug-s\nangles,deg\nspeed,{}\ntheta,alpha,u,q,delta_e\n{}{}{}{}",
        speed / foot,
        row(0),
        row(1),
        row(2),
        row(3)
    );
    let model = model(&text, MatrixFormat::Csv);
    assert!((model.a - a).abs().max() < 1e-13 * a.abs().max(), "{}", model.a);
    assert!((model.b - b).abs().max() < 1e-13 * b.abs().max(), "{}", model.b);
}

#[test]
fn sideslip_angle_becomes_sideslip_velocity() {
    let text = "units,SI\nspeed,50\nbeta,p,r,phi,aileron,rudder\n\
        -0.25,0,-1,0.196,0,0.07\n-16,-8.4,2.2,0,29,2.6\n4.5,-0.35,-0.76,0,-0.22,-4.6\n0,1,0,0,0,0\n";
    let model = model(text, MatrixFormat::Csv);
    assert_eq!(model.plane, Plane::Lateral);
    // v = V β: L_v = L_β/V, the r entry of the first row is −V, and Y_δr is V times its starred form
    assert_eq!(model.a[(1, 0)], -16.0 * (1.0 / 50.0));
    assert_eq!((model.a[(0, 0)], model.a[(0, 2)]), (-0.25, -50.0));
    assert_eq!((model.b[(0, 1)], model.b[(1, 0)]), (0.07 * 50.0, 29.0));
}

#[test]
fn a_mistake_is_one_sentence_with_its_line() {
    use MatrixFormat::{Csv, Json, Matlab};
    let cases = [
        ("", Json, "mine, line 1: the file is empty; expected the matrices A and B"),
        (
            &JSON.replace("\"SI\"", "\"metric\""),
            Json,
            "mine, line 3: units: expected \"SI\" (metres) or \"ft-slug-s\" (feet), found \"metric\"",
        ),
        (
            &JSON.replace("\"units\": \"SI\", ", ""),
            Json,
            "mine, line 1: units: missing; expected \"SI\" (metres) or \"ft-slug-s\" (feet)",
        ),
        (
            &JSON.replace("\"speed\": 53.64,", ""),
            Json,
            "mine, line 1: speed: missing; expected the true airspeed, a positive number",
        ),
        (
            &JSON.replace("53.64,\n", "-53.64,\n"),
            Json,
            "mine, line 3: speed: expected a positive number, found -53.64",
        ),
        (
            &JSON.replace("\"theta\"", "\"pitch\""),
            Json,
            "mine, line 4: states: \"pitch\" is not a state known here; expected u, w (or alpha), q, theta, or v (or beta), p, r, phi",
        ),
        (
            &JSON.replace("\"theta\"", "\"alpha\""),
            Json,
            "mine, line 4: states: \"w\" and \"alpha\" are the same state",
        ),
        (
            &JSON.replace("[0, 0, 1, 0]]", "[0, 0, 1]]"),
            Json,
            "mine, line 6: A: expected 4 numbers in row 4, found 3",
        ),
        (
            &JSON.replace("[0, 0, 1, 0]]", "[0, 0, 0, 1]]"),
            Json,
            "mine, line 6: A: row of theta: expected 1 for q and 0 for u, w and theta, for pitch rate is the rate of pitch angle; is the order of the states right?",
        ),
        (&JSON.replace("53.64, 0]", "NaN, 0]"), Json, "mine, line 7: expected value"),
        (
            &JSON.replace("\"elevator\"", "\"rudder\""),
            Json,
            "mine, line 5: inputs: expected elevator or throttle beside these states, found \"rudder\"",
        ),
        (
            &JSON.replace("\"inputs\"", "\"input\""),
            Json,
            "mine, line 5: \"input\" is no key known here; expected units, angles, speed or u0, alpha0_deg, gamma0_deg, name, states, inputs, A and B",
        ),
        (
            &CSV.replace("q,0.0063,", "q,"),
            Csv,
            "mine, line 7: expected 5 numbers, one a state and input, found 4",
        ),
        (
            &CSV.replace("53.64,0,", "NaN,0,"),
            Csv,
            "mine, line 6: A: expected a finite number in row 2, found NaN",
        ),
        (&CSV.replace("53.64,0,", "fast,0,"), Csv, "mine, line 6: expected a number, found \"fast\""),
        (
            &CSV.replace("w,-0.3695", "q,-0.3695"),
            Csv,
            "mine, line 6: expected the row of w here, found \"q\"",
        ),
        (
            &CSV.replace("theta,0,0,1,0,0\n", ""),
            Csv,
            "mine, line 5: A: expected 4 rows, one a state, found 3",
        ),
        (
            "units,SI\nspeed,50\n",
            Csv,
            "mine, line 1: expected a row with the names of the states and inputs, found none",
        ),
        (
            &MATLAB.replace("53.64, 0\n", "W0, 0\n"),
            Matlab,
            "mine, line 9: A: expected plain numbers or quoted names, found \"W0\"; nothing is computed here",
        ),
        (
            &MATLAB.replace("0 0 1 0 ];", "0 0 1 0"),
            Matlab,
            "mine, line 11: A: expected plain numbers or quoted names, found \"B\"; nothing is computed here",
        ),
        (
            &MATLAB.replace("A = [", "M = ["),
            Matlab,
            "mine, line 1: A: missing; expected a line that begins with \"A = [\"",
        ),
        (
            &MATLAB.replace("'u','w','q','theta'", "'u','w','q'"),
            Matlab,
            "mine, line 5: states: expected four of one plane of motion, u, w (or alpha), q, theta, or v (or beta), p, r, phi; found 3",
        ),
        (
            &MATLAB.replace("U0 = 53.64;", "U0 = 53.64; U0 = 54;"),
            Matlab,
            "mine, line 4: u0: given twice, first on line 4",
        ),
    ];
    let told = cases.map(|(text, format, _)| read(text, format).err().unwrap_or_default());
    assert_eq!(told.each_ref().map(String::as_str), cases.map(|(_, _, sentence)| sentence));
}

#[test]
fn no_cut_or_changed_file_panics() {
    for (text, format) in
        [(JSON, MatrixFormat::Json), (CSV, MatrixFormat::Csv), (MATLAB, MatrixFormat::Matlab)]
    {
        for end in 0..text.len() {
            for inserted in ["", "'", "[", "\"", "...", "−", "1e999", ","] {
                let changed = format!("{}{inserted}{}", &text[..end], &text[end + 1..]);
                if let Ok(aircraft) = read(&changed, format) {
                    let models = aircraft.aircraft_model.models().expect("bare matrices are models");
                    assert!(models.problems.is_empty());
                }
                let _ = read(&text[..end], format);
            }
        }
    }
}

fn good(text: &str, format: MatrixFormat) -> Aircraft {
    read(text, format).expect("it reads")
}

/// As this program prints its numbers, and as a PDF gives them.
#[test]
fn a_true_minus_sign_is_a_minus_wherever_numbers_are_good() {
    let dashed = |text: &str| {
        let mut dashed = text.replace("-0", "−0").replace("-1", "−1").replace("-2", "−2").replace("-9", "−9");
        dashed = dashed.replace("-8", "−8");
        assert_ne!(dashed, text);
        dashed
    };
    for (text, format) in [(JSON, MatrixFormat::Json), (CSV, MatrixFormat::Csv)] {
        assert_eq!(
            good(&dashed(text), format).aircraft_model,
            good(text, format).aircraft_model,
            "{format:?}"
        );
    }
    let matlab = "% units: SI\n% speed: 53.64\n% states: u w q theta\nA = [ −0.0451  0.0362   0      −9.80665\n\
                  −0.3695 −2.0232  53.64    0\n 0.0063 −1.639e−1  −2.9857  0\n 0 0 1 0 ];\n";
    let hyphens = matlab.replace('−', "-");
    assert_eq!(
        good(matlab, MatrixFormat::Matlab).aircraft_model,
        good(&hyphens, MatrixFormat::Matlab).aircraft_model
    );
}

const LATERAL: &str = "units,SI\nspeed,15.0217778\nalpha0_deg,8.79\n,beta,p,r,phi\nbeta,-0.1159,0.152813,-0.988255,0.645382\n\
                       p,-29.893804,-12.319098,4.109427,0\nr,9.800289,-1.301559,-0.144123,0\nphi,0,1,0.154629,0\n";

/// A small unmanned aircraft: its first row as the rate of an angle, as it should be, and multiplied by the speed; and a 747 in
/// feet that are called metres.
#[test]
fn units_that_cannot_be_are_told_of_lateral_matrices_too() {
    assert_eq!(good(LATERAL, MatrixFormat::Csv).notes, Vec::<String>::new());
    let times_speed = LATERAL
        .replace("beta,-0.1159,0.152813,-0.988255,0.645382", "beta,-0.1159,2.295528,-14.845348,9.694782");
    let [note] = good(&times_speed, MatrixFormat::Csv).notes.try_into().expect("one remark");
    assert!(note.contains("row of v under the name of β") && note.contains("15.0 times"), "{note}");
    let feet = "units,SI\nspeed,660\n,v,p,r,phi\nv,-0.0829,0,-660,32.2\np,-0.0068939,-1.7,0.172,0\n\
                r,0.0051212,-0.0654,-0.0893,0\nphi,0,1,0,0\n";
    let [note] = good(feet, MatrixFormat::Csv).notes.try_into().expect("one remark");
    assert!(note.contains("A(v, φ) is 32.20 m/s², where g cos θ₀ is 9.807 m/s²"), "{note}");
    assert_eq!(good(&feet.replace("SI", "ft-slug-s"), MatrixFormat::Csv).notes, Vec::<String>::new());
}

fn modes_in(aircraft: &Aircraft, plane: Plane) -> Vec<Mode> {
    let models = aircraft.aircraft_model.models().expect("models");
    modes(models.planes[plane].as_ref().expect("data")).expect("modes")
}

/// Both moments by sideslip forgotten: λ = 0, which is neither slow nor a rounding.
#[test]
fn a_root_at_zero_is_zero_and_the_bank_stays() {
    let text = "units,ft-slug-s\nspeed,660\n,v,p,r,phi\nv,-0.0829,0,-660,32.2\np,0,-1.7,0.172,0\nr,0,-0.0654,-0.0893,0\nphi,0,1,0,0\n";
    let modes = modes_in(&good(text, MatrixFormat::Csv), Plane::Lateral);
    let neutral: Vec<&Mode> = modes.iter().filter(|mode| mode.stability == Stability::Neutral).collect();
    assert_eq!(neutral.len(), 1);
    assert_eq!((neutral[0].lambda.re, neutral[0].lambda.im), (0.0, 0.0));
    let reason = eigenwing::words::naming::reason(neutral[0]);
    assert!(reason.contains("stays as it is") && !reason.contains("come level"), "{reason}");
}

/// λ = ±0.2828 j: ζ is 0, and the resonance has no bound.
#[test]
fn an_undamped_phugoid_has_no_damping_and_a_peak_without_bound() {
    let text = r#"{"units": "SI", "speed": 50, "states": ["u", "w", "q", "theta"], "inputs": ["elevator"],
        "A": [[0, 0, 0, -10], [-0.2368, -2, 50, 0], [0.04, -0.2, -3, 0], [0, 0, 1, 0]], "B": [[0], [0], [-10], [0]]}"#;
    let aircraft = good(text, MatrixFormat::Json);
    let modes = modes_in(&aircraft, Plane::Longitudinal);
    let phugoid = modes.iter().find(|mode| mode.naming.name == ModeName::Phugoid).expect("a phugoid");
    assert_eq!((phugoid.lambda.re, phugoid.damping_ratio()), (0.0, Some(0.0)));
    assert!((phugoid.lambda.im - 0.282_843).abs() < 1e-6);
    let model = aircraft.aircraft_model.models().expect("models").planes.longitudinal.expect("data");
    let unit = Input::Step { amplitude: 1.0, start: 0.0 };
    let forced = DrivenSystem::from_rest(model.a, model.b.column(0).into_owned(), unit);
    let row = Output::PitchAngle.row(&model, &forced);
    let points = frequency_response(&forced, &row, 0, (0.01, 100.0), 400);
    let value = |frequency: f64| transfer(&forced, &row, 0, frequency);
    let found = peaks(&value, &points, &modes);
    let peak = found.iter().find(|peak| peak.mode == ModeName::Phugoid).expect("its peak");
    assert_eq!((peak.gain, peak.frequency), (None, phugoid.lambda.im));
}
