//! The equations as they are written: true of the matrices that are computed, of every aircraft and after any edit.

use eigenwing::findings::Findings;
use eigenwing::findings::equations::{COLUMNS, Factor, ROWS, STATES};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::{Convention, Parameter, Scenario};
use nalgebra::{Complex, Matrix4};

mod every_plane;

use every_plane::scenarios;

fn named(key: &str) -> Scenario {
    scenarios().into_iter().find(|scenario| scenario.aircraft.key == key).expect("an aircraft of the list")
}

fn set(scenario: &mut Scenario, key: &str, value: f64) {
    Parameter::find(key).expect("a row").set(scenario, value);
}

/// How many entries were compared.
fn compare(scenario: Scenario) -> usize {
    let findings = Findings::of(scenario);
    let Some(equations) = findings.equations() else { return 0 };
    let mut compared = 0;
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let Some(form) = equations.form(row, column) else { continue };
            let key = &findings.scenario().aircraft.key;
            let made = form
                .value(&|atom| equations.atom(findings.scenario(), atom))
                .expect("everything has a value");
            let (made, is) = (made + equations.added(row, column), equations.value(row, column));
            // Sums are written in another order than they are computed, so they round differently.
            assert!((made - is).abs() <= 1e-12 * (1.0 + is.abs()), "{key} {row} {column}: {made} for {is}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn what_is_written_of_an_entry_gives_its_value_in_every_aircraft() {
    let compared: usize = scenarios().into_iter().map(compare).sum();
    assert!(compared > 20 * ROWS * COLUMNS, "{compared}");
}

#[test]
fn it_still_does_with_every_derivative_and_entry_moved() {
    for mut scenario in [named("navion"), named("b747-approach"), named("b747-fc9")] {
        for plane in Plane::ALL {
            scenario.plane = plane;
            for (key, value) in [
                ("z_wdot", 0.31),
                ("m_wdot", -0.02),
                ("x_q", 0.7),
                ("z_q", -3.0),
                ("m_u", 0.001),
                ("y_p", 0.4),
                ("y_r", 0.9),
                ("l_r", 0.7),
                ("a_uw", 0.2),
                ("a_pr", 0.5),
                ("b_q_de", -4.0),
            ] {
                set(&mut scenario, key, value);
            }
            assert_eq!(compare(scenario.clone()), ROWS * COLUMNS);
        }
    }
}

#[test]
fn bare_matrices_have_numbers_and_no_forms() {
    let findings = Findings::of(named("lesson"));
    let equations = findings.equations().expect("it is analysed");
    assert_eq!(equations.form(0, 0), None);
    assert_eq!(equations.derivatives(1, 1), Vec::<&Parameter>::new());
    assert!(equations.value(0, 3) < 0.0, "−g");
    assert_eq!(equations.slider(0, 3).map(|(p, sign)| (p.key, sign)), Some(("g", -1.0)));
}

/// det(λI − A) by another road: Gauss with complex numbers.
fn determinant(findings: &Findings, lambda: Complex<f64>) -> Complex<f64> {
    let a = findings.plane().expect("it is analysed").model.a;
    let shifted = Matrix4::from_fn(|i, j| {
        let own = if i == j { lambda } else { Complex::from(0.0) };
        own - a[(i, j)]
    });
    shifted.lu().determinant()
}

#[test]
fn the_polynomial_is_the_determinant_and_its_factors_are_the_polynomial() {
    let mut pairs = 0;
    for scenario in scenarios() {
        let findings = Findings::of(scenario);
        let Some(equations) = findings.equations() else { continue };
        let scale = findings.modes().iter().map(|mode| mode.lambda.norm()).fold(0.0, f64::max);
        for lambda in [(0.0, 0.0), (0.7, 0.0), (-1.3, 0.4), (0.1, 2.0), (0.0, -0.6)] {
            let lambda = Complex::new(lambda.0, lambda.1) * scale;
            let [a3, a2, a1, a0] = equations.polynomial;
            let polynomial = (((lambda + a3) * lambda + a2) * lambda + a1) * lambda + a0;
            let factors = equations.factors.iter().map(|factor| match *factor {
                Factor::Root { c } => lambda + c,
                Factor::Pair { damping, stiffness } => (lambda + damping) * lambda + stiffness,
            });
            let factors: Complex<f64> = factors.product();
            let exact = determinant(&findings, lambda);
            // Eigenvalues of a matrix are good to its size times 10⁻¹⁶, of these to a hundred times that.
            let size = 1e-11 * (scale + lambda.norm()).powi(4);
            let key = &findings.scenario().aircraft.key;
            assert!((polynomial - exact).norm() < size, "{key}: {polynomial} for {exact}");
            assert!((factors - exact).norm() < size, "{key}: {factors} for {exact}");
        }
        pairs += equations.factors.iter().filter(|factor| matches!(factor, Factor::Pair { .. })).count();
    }
    assert!(pairs > 20, "{pairs}");
}

/// The same as central differences of the eigenvalues.
#[test]
fn the_strength_of_an_entry_is_how_far_it_moves_the_pole() {
    let findings = Findings::of(named("navion"));
    let equations = findings.equations().expect("it is analysed");
    let mut moved = 0;
    for row in 0..ROWS {
        for column in 0..STATES {
            let value = equations.value(row, column);
            for (index, mode) in findings.modes().iter().enumerate() {
                let strength = equations.strength(index, row, column).expect("no root is repeated");
                let step = 1e-4 * value;
                let at = |step: f64| {
                    let mut a = findings.plane().expect("it is analysed").model.a;
                    a[(row, column)] += step;
                    let roots = a.complex_eigenvalues();
                    let near = |x: &&Complex<f64>, y: &&Complex<f64>| {
                        (**x - mode.lambda).norm().total_cmp(&(**y - mode.lambda).norm())
                    };
                    *roots.iter().min_by(near).expect("four roots")
                };
                let rate = (at(step) - at(-step)).norm() / (2e-4 * mode.lambda.norm());
                // The error of a central difference is that of its step squared, and of the eigenvalues over the step.
                assert!((0.1 * rate - strength).abs() < 1e-6, "{row} {column}: {rate} for {strength}");
                moved += usize::from(strength > 0.01);
            }
        }
    }
    assert!(moved > 4, "{moved}");
    assert_eq!(equations.strength(0, 2, STATES), Some(0.0), "the elevator moves no pole");
}

#[test]
fn entries_are_written_in_the_notation_of_the_field() {
    let text = |key: &str, plane: Plane, row: usize, column: usize| {
        let findings = Findings::of(Scenario { plane, ..named(key) });
        let form = findings.equations().and_then(|equations| equations.form(row, column));
        form.map(|form| form.text(Convention::SI)).unwrap_or_default()
    };
    let lon = |row, column| text("navion", Plane::Longitudinal, row, column);
    assert_eq!(lon(0, 2), "X_q − W_0");
    assert_eq!(lon(0, 3), "−g cos θ_0");
    assert_eq!(lon(1, 2), "(U_0 + Z_q)/D");
    assert_eq!(lon(2, 2), "M_q + M_ẇ (U_0 + Z_q)/D");
    assert_eq!(lon(2, 3), "−M_ẇ g sin θ_0/D");
    let lat = |row, column| text("navion", Plane::Lateral, row, column);
    assert_eq!(lat(0, 2), "Y_r − U_0");
    assert_eq!(lat(1, 0), "(L_v + i_x N_v) G");
    assert_eq!(lat(3, 2), "tan θ_0");
}
