//! The matrix from coefficients is the Jacobian of the nonlinear equations of motion: trim, thrust and Mach terms,
//! climb and all, by central differences.

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::plane::PlaneModel;
use eigenwing::flight::study::{CoefficientStudy, Derived, Study};
use nalgebra::{Vector2, Vector4};

fn studies() -> Vec<(String, CoefficientStudy)> {
    let (aircraft, _) = embedded_aircraft();
    aircraft
        .into_iter()
        .filter_map(|one| match one.study {
            Study::Coefficients(study) => Some((one.key, study)),
            _ => None,
        })
        .collect()
}

/// ẋ of the nonlinear equations in the plane of symmetry, Etkin & Reid §4.7, x = \[u, w, q, θ\] away from steady flight.
fn rates(d: &Derived, study: &CoefficientStudy, x: &Vector4<f64>, input: &Vector2<f64>) -> Vector4<f64> {
    let (airframe, c, flight) = (&d.airframe, &d.coefficients.longitudinal, &d.flight);
    let (v0, gamma0, g) = (flight.condition.speed, flight.condition.gamma0, study.reference.gravity);
    let (u, w, q, theta) = (v0 + x[0], x[1], x[2], gamma0 + x[3]);
    let (v, alpha) = (u.hypot(w), w.atan2(u));
    let (mach_change, rate) = (flight.mach * (v / v0 - 1.0), q * airframe.c / (2.0 * v0));
    let (q_bar, q_bar0) = (0.5 * flight.density * v * v, flight.dynamic_pressure);
    let thrust0 = q_bar0 * airframe.s * (c.cd + c.cl * gamma0.tan());
    let thrust = thrust0 * (v / v0).powf(airframe.thrust_exponent) + input[1] * airframe.thrust_per_throttle;
    let cl = c.cl + c.cl_alpha * alpha + c.cl_q * rate + c.cl_m * mach_change + c.cl_de * input[0];
    let cd = c.cd + c.cd_alpha * alpha + c.cd_m * mach_change + c.cd_de * input[0];
    let cm0 = -thrust0 * airframe.thrust_offset / (q_bar0 * airframe.s * airframe.c);
    let cm = cm0 + c.cm_alpha * alpha + c.cm_q * rate + c.cm_m * mach_change + c.cm_de * input[0];
    let (lift, drag) = (q_bar * airframe.s * cl, q_bar * airframe.s * cd);
    let (sin, cos) = alpha.sin_cos();
    let pitch = q_bar * airframe.s * airframe.c * cm + thrust * airframe.thrust_offset;
    Vector4::new(
        (thrust + lift * sin - drag * cos) / airframe.mass - g * theta.sin() - q * w,
        (-lift * cos - drag * sin) / airframe.mass + g * theta.cos() + q * u,
        pitch / airframe.iy,
        q,
    )
}

fn assert_is_jacobian(key: &str, study: &CoefficientStudy) {
    let derived = study.derive().expect("it flies");
    let model: PlaneModel = derived.derivatives.models().longitudinal.expect("longitudinal");
    let step = 1e-4;
    let (still, free) = (Vector4::zeros(), Vector2::zeros());
    let assert_column = |got: Vector4<f64>, want: Vector4<f64>, what: &str| {
        let allowed = 1e-6 * got.amax().max(1.0);
        assert!((got - want).amax() <= allowed, "{key}, column {what}: {got} should be {want}");
    };
    for (j, name) in ["u", "w", "q", "θ"].iter().enumerate() {
        let (mut ahead, mut behind) = (still, still);
        ahead[j] = step;
        behind[j] = -step;
        let slope =
            (rates(&derived, study, &ahead, &free) - rates(&derived, study, &behind, &free)) / (2.0 * step);
        assert_column(model.a.column(j).into_owned(), slope, name);
    }
    for (j, name) in ["δe", "δt"].iter().enumerate() {
        let (mut ahead, mut behind) = (free, free);
        ahead[j] = step;
        behind[j] = -step;
        let slope =
            (rates(&derived, study, &still, &ahead) - rates(&derived, study, &still, &behind)) / (2.0 * step);
        assert_column(model.b.column(j).into_owned(), slope, name);
    }
}

/// Without the α̇ terms, which make the equations implicit; Caughey's printed matrix covers those.
fn without_lag(mut study: CoefficientStudy) -> CoefficientStudy {
    let l = &mut study.coefficients.longitudinal;
    (l.cl_alphadot, l.cm_alphadot) = (0.0, 0.0);
    study
}

#[test]
fn level_flight_is_linearised_exactly() {
    for (key, study) in studies() {
        assert_is_jacobian(&key, &without_lag(study));
    }
}

#[test]
fn climb_thrust_line_propeller_and_mach_terms_are_linearised_exactly() {
    for (key, study) in studies() {
        for (gamma0, exponent, offset) in
            [(0.2, 0.0, 0.0), (-0.1, -1.0, 0.0), (0.1, -1.0, 0.8), (0.0, 0.5, -0.5)]
        {
            let mut study = without_lag(study.clone());
            study.condition.gamma0 = gamma0;
            study.condition.speed *= 1.01;
            study.airframe.thrust_exponent = exponent;
            study.airframe.thrust_offset = offset;
            let l = &mut study.coefficients.longitudinal;
            (l.cl_m, l.cd_m, l.cm_m, l.cd_de) = (0.2, 0.05, -0.1, 0.03);
            assert_is_jacobian(&key, &study);
        }
    }
}

#[test]
fn steady_flight_is_in_balance() {
    for (key, study) in studies() {
        for speed_ratio in [1.0, 1.03] {
            let mut study = study.clone();
            study.condition.speed *= speed_ratio;
            let derived = study.derive().expect("it flies");
            let still = rates(&derived, &study, &Vector4::zeros(), &Vector2::zeros());
            // what is left is the source's rounding of C_L, up to 1.5 % of g (the Navion: 0.41 for 0.406)
            assert!(still.amax() < 0.015 * study.reference.gravity, "{key}: {still}");
        }
    }
}
