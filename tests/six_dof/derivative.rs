//! The same trim and the same derivative: linearised by automatic differentiation, the flight is the linear model.

use eigenwing::flight::aircraft::aircraft_model::{AircraftModel, CoefficientModel};
use eigenwing::flight::aircraft::coefficients::{LATERAL_COEFFICIENTS, LONGITUDINAL_COEFFICIENTS};
use eigenwing::flight::aircraft::condition::FlightCondition;
use eigenwing::flight::aircraft::derivatives::{LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES};
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::inertia::Inertia;
use eigenwing::flight::aircraft::knobs::Knobs;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::aerodynamics::Aerodynamics;
use eigenwing::flight::motion::gusts::rate_columns;
use eigenwing::flight::motion::six_dof::{SixDof, TRIM_RESIDUAL};
use nalgebra::{Matrix4, SMatrix, Vector4};

use super::{edited, gust_column, ready, studies};

fn from_coefficients() -> Vec<(String, CoefficientModel)> {
    let of = |(key, aircraft_model)| match aircraft_model {
        AircraftModel::Coefficients(aircraft_model) => Some((key, aircraft_model)),
        _ => None,
    };
    studies().into_iter().filter_map(of).collect()
}

fn from_derivatives() -> Vec<(String, AircraftModel)> {
    studies()
        .into_iter()
        .filter(|(_, aircraft_model)| matches!(aircraft_model, AircraftModel::Derivatives(_)))
        .collect()
}

/// To 1e-8 of each entry, or 1e-12 of the largest in its row: automatic differentiation only rounds, some 10 ε of the
/// terms that are summed, and the terms of a row are accelerations of one size.
fn assert_same<const R: usize, const C: usize>(
    what: &str,
    got: &SMatrix<f64, R, C>,
    want: &SMatrix<f64, R, C>,
) {
    for i in 0..R {
        let row = want.row(i).amax();
        for j in 0..C {
            let (got, want) = (got[(i, j)], want[(i, j)]);
            let allowed = 1e-8 * want.abs() + 1e-12 * row.max(1.0);
            assert!((got - want).abs() <= allowed, "{what} ({i}, {j}): {got} should be {want}");
        }
    }
}

fn assert_linear_model_is_the_derivative(key: &str, edited: &EditedModel) {
    let flight = ready(edited);
    let (jacobian, models) = (flight.jacobian(), edited.models().expect("it flies"));
    assert!(flight.steady.residual <= TRIM_RESIDUAL, "{key}");
    for (plane, at, wind) in [(Plane::Longitudinal, 0, 2), (Plane::Lateral, 4, 1)] {
        let a: Matrix4<f64> = jacobian.a.fixed_view::<4, 4>(at, at).into_owned();
        let b = jacobian.b.fixed_view::<4, 2>(at, at / 2).into_owned();
        let gust: Vector4<f64> = jacobian.wind.fixed_view::<4, 1>(at, wind).into_owned();
        if let Some(model) = &models.planes[plane] {
            assert_same(&format!("{key}, {plane:?}, A"), &a, &model.a);
            assert_same(&format!("{key}, {plane:?}, B"), &b, &model.b);
            assert_same(&format!("{key}, {plane:?}, gust"), &gust, &gust_column(model));
            let gradient: Vector4<f64> = jacobian.wind_rate.fixed_view::<4, 1>(at, wind).into_owned();
            let derivatives = edited.derivatives().expect("it flies");
            let [along, column] = rate_columns(plane, derivatives.as_ref());
            let longitudinal: Vector4<f64> = jacobian.wind_rate.fixed_view::<4, 1>(at, 0).into_owned();
            if edited.offsets == Default::default() {
                assert_same(&format!("{key}, {plane:?}, gradient of the gust"), &gradient, &column);
                assert_same(&format!("{key}, {plane:?}, rate of the head gust"), &longitudinal, &along);
            }
        }
        let other = 4 - at;
        let cross = jacobian.a.fixed_view::<4, 4>(at, other).amax().max(
            jacobian
                .b
                .fixed_view::<4, 2>(at, other / 2)
                .amax()
                .max(jacobian.wind.fixed_view::<4, 1>(at, 3 - wind).amax()),
        );
        assert!(cross <= 1e-12, "{key}, {plane:?}: {cross} from the other plane");
    }
}

#[test]
fn the_linear_model_of_every_aircraft_is_the_derivative_of_its_flight() {
    let mut compared = 0;
    for (key, aircraft_model) in studies() {
        if !matches!(aircraft_model, AircraftModel::Matrices(_)) {
            assert_linear_model_is_the_derivative(&key, &EditedModel::new(aircraft_model));
            compared += 1;
        }
    }
    assert!(compared >= 15, "only {compared} aircraft");
}

/// Every coefficient different from zero, another engine, the knobs turned, another flight condition.
fn elsewhere(mut aircraft_model: CoefficientModel) -> EditedModel {
    for (k, field) in LONGITUDINAL_COEFFICIENTS.iter().enumerate() {
        *(field.of)(&mut aircraft_model.coefficients.longitudinal) += 0.003 * k as f64;
    }
    if let Some(lateral) = &mut aircraft_model.coefficients.lateral {
        for (k, field) in LATERAL_COEFFICIENTS.iter().enumerate() {
            *(field.of)(lateral) += 0.002 * k as f64;
        }
    }
    aircraft_model.airframe.thrust_exponent = -1.0;
    aircraft_model.airframe.thrust_offset = 0.4;
    aircraft_model.knobs =
        Knobs { mass_ratio: 1.03, ix_ratio: 1.2, iz_ratio: 1.1, cg_shift: 0.02, ..Knobs::default() };
    let FlightCondition { altitude, speed, .. } = aircraft_model.condition;
    aircraft_model.condition =
        FlightCondition { altitude: altitude + 500.0, speed: speed * 1.02, gamma0: -0.06 };
    EditedModel::new(AircraftModel::Coefficients(aircraft_model))
}

#[test]
fn it_stays_so_with_other_coefficients_knobs_and_condition() {
    for (key, aircraft_model) in from_coefficients() {
        assert_linear_model_is_the_derivative(&key, &elsewhere(aircraft_model));
    }
}

fn with_offsets(mut edited: EditedModel) -> EditedModel {
    let offsets = &mut edited.offsets;
    for (k, row) in LONGITUDINAL_DERIVATIVES.iter().enumerate() {
        *(row.field.of)(&mut offsets.longitudinal) = 0.01 * (k as f64 - 5.0);
    }
    for (k, row) in LATERAL_DERIVATIVES.iter().enumerate() {
        *(row.field.of)(&mut offsets.lateral) = 0.02 * (k as f64 - 4.0);
    }
    for plane in Plane::ALL {
        let matrices = &mut offsets.matrices[plane];
        matrices.a.iter_mut().enumerate().for_each(|(k, entry)| *entry = 0.03 * (k as f64 - 7.0));
        matrices.b.iter_mut().enumerate().for_each(|(k, entry)| *entry = 0.05 * (k as f64 - 3.0));
    }
    edited
}

/// All sixteen entries of A, kinematic rows included.
#[test]
fn it_stays_so_with_offsets_on_derivatives_and_matrices() {
    for (key, aircraft_model) in from_coefficients() {
        assert_linear_model_is_the_derivative(&key, &with_offsets(elsewhere(aircraft_model)));
    }
    for (key, aircraft_model) in from_derivatives() {
        assert_linear_model_is_the_derivative(&key, &with_offsets(EditedModel::new(aircraft_model)));
    }
}

#[test]
fn the_trim_is_solved_and_is_where_the_linear_model_has_it() {
    for (key, aircraft_model) in studies() {
        let Ok(flight) = SixDof::new(&EditedModel::new(aircraft_model)) else { continue };
        let steady = flight.steady;
        assert!(steady.residual <= TRIM_RESIDUAL, "{key}: {}", steady.residual);
        // 1e-10 m/s² is 1e-11 of g, and lift per radian is several g
        assert!(steady.alpha.abs() < 1e-11 && steady.elevator.abs() < 1e-11, "{key}: {steady:?}");
        // In level flight of an aircraft given by coefficients thrust is drag; all know some drag.
        if flight.trim.gamma0 == 0.0 && flight.trim.alpha0 == 0.0 && flight.limits.sound_speed.is_some() {
            assert!(
                (0.02..0.25).contains(&(steady.thrust / flight.trim.gravity)),
                "{key}: {}",
                steady.thrust
            );
        }
    }
}

/// An engine the numbers of which can be checked by hand: the Navion climbing at 0.05 rad.
#[test]
fn thrust_in_a_climb_is_drag_and_a_share_of_the_weight() {
    let mut edited = edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut edited.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.condition.gamma0 = 0.05;
    let derived = aircraft_model.derive().expect("it flies");
    let c = derived.coefficients.longitudinal;
    // T/m = q̄S (C_D + C_L tan γ₀)/m
    let q_s = derived.flight.dynamic_pressure * derived.airframe.s / derived.airframe.mass;
    let want = q_s * (c.cd + c.cl * 0.05_f64.tan());
    let got = ready(&edited).steady.thrust;
    assert!((got - want).abs() < 1e-9, "{got} should be {want}");
}

/// The source's C_L is rounded, the Navion's 0.41 for 0.406: what it leaves of the weight is small.
#[test]
fn what_the_sources_rounding_leaves_of_the_weight_is_small() {
    for (key, aircraft_model) in from_coefficients() {
        let flight = ready(&EditedModel::new(AircraftModel::Coefficients(aircraft_model)));
        let Aerodynamics::Coefficients(model) = &flight.aerodynamics else { panic!("{key}") };
        let [x, z] = model.remainder();
        assert!(x.hypot(z) < 0.015 * flight.trim.gravity, "{key}: {x}, {z}");
    }
}

/// Climb, thrust line, propeller and Mach terms, one at a time.
#[test]
fn climb_thrust_line_propeller_and_mach_terms_have_their_derivatives() {
    for (key, aircraft_model) in from_coefficients() {
        for (gamma0, exponent, offset) in
            [(0.2, 0.0, 0.0), (-0.1, -1.0, 0.0), (0.1, -1.0, 0.8), (0.0, 0.5, -0.5)]
        {
            let mut aircraft_model = aircraft_model.clone();
            aircraft_model.condition.gamma0 = gamma0;
            aircraft_model.condition.speed *= 1.01;
            aircraft_model.airframe.thrust_exponent = exponent;
            aircraft_model.airframe.thrust_offset = offset;
            let l = &mut aircraft_model.coefficients.longitudinal;
            (l.cl_m, l.cd_m, l.cm_m, l.cd_de, l.cl_alphadot) = (0.2, 0.05, -0.1, 0.03, 1.5);
            assert_linear_model_is_the_derivative(
                &key,
                &EditedModel::new(AircraftModel::Coefficients(aircraft_model)),
            );
        }
    }
}

/// The A-4D's in its body axes, 25 900 slug ft² in pitch; the Navion's with its knob; the C-47 has none.
#[test]
fn moments_of_inertia_are_those_of_the_source() {
    let slug_ft2 = 1.355_817_948;
    let body = ready(&edited("a4d")).inertia;
    for (got, want) in [(body.ix, 8780.0), (body.iy, 25_900.0), (body.iz, 28_500.0), (body.ixz, -4070.0)] {
        assert!((got / slug_ft2 - want).abs() < 1e-3, "{got} should be {want} slug ft²");
    }
    let mut heavier = edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut heavier.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.knobs.iy_ratio = 1.5;
    assert!((ready(&heavier).inertia.iy / slug_ft2 - 4500.0).abs() < 1e-3);
    assert_eq!(ready(&edited("c47")).inertia, Inertia { ix: 1.0, iy: 1.0, iz: 1.0, ixz: 0.0 });
}
