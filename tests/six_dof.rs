//! Nonlinear flight beside the linear model: same trim, same derivative, and the same responses as disturbances get small.

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aerodynamics::Controls;
use eigenwing::flight::coefficients::{LATERAL_COEFFICIENTS, LONGITUDINAL_COEFFICIENTS};
use eigenwing::flight::condition::FlightCondition;
use eigenwing::flight::derivatives::{LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES};
use eigenwing::flight::edits::{Edited, gust_column};
use eigenwing::flight::flight_path::{Excitation, FlightPath, Reason, Stop};
use eigenwing::flight::inputs::Input;
use eigenwing::flight::knobs::Knobs;
use eigenwing::flight::plane::Plane;
use eigenwing::flight::response::{TimeGrid, respond};
use eigenwing::flight::six_dof::{SixDof, SixDofError, TRIM_RESIDUAL};
use eigenwing::flight::study::{CoefficientStudy, Study};
use nalgebra::{Matrix4, SMatrix, Vector4};
use proptest::prelude::*;

fn studies() -> Vec<(String, Study)> {
    embedded_aircraft().0.into_iter().map(|one| (one.key, one.study)).collect()
}

fn from_coefficients() -> Vec<(String, CoefficientStudy)> {
    let of = |(key, study)| match study {
        Study::Coefficients(study) => Some((key, study)),
        _ => None,
    };
    studies().into_iter().filter_map(of).collect()
}

fn from_derivatives() -> Vec<(String, Study)> {
    studies().into_iter().filter(|(_, study)| matches!(study, Study::Derivatives(_))).collect()
}

fn edited(key: &str) -> Edited {
    Edited::new(studies().into_iter().find(|(name, _)| name == key).expect("the aircraft ships").1)
}

fn ready(edited: &Edited) -> SixDof {
    SixDof::new(edited).expect("it flies")
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

fn assert_linear_model_is_the_derivative(key: &str, edited: &Edited) {
    let flight = ready(edited);
    let (jacobian, models) = (flight.jacobian(), edited.models().expect("it flies"));
    assert!(flight.steady.residual <= TRIM_RESIDUAL, "{key}");
    for (plane, at, wind) in [(Plane::Longitudinal, 0, 2), (Plane::Lateral, 4, 1)] {
        let a: Matrix4<f64> = jacobian.a.fixed_view::<4, 4>(at, at).into_owned();
        let b = jacobian.b.fixed_view::<4, 2>(at, at / 2).into_owned();
        let gust: Vector4<f64> = jacobian.wind.fixed_view::<4, 1>(at, wind).into_owned();
        if let Some(model) = models.of(plane) {
            assert_same(&format!("{key}, {plane:?}, A"), &a, &model.a);
            assert_same(&format!("{key}, {plane:?}, B"), &b, &model.b);
            assert_same(&format!("{key}, {plane:?}, gust"), &gust, &gust_column(model));
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
    for (key, study) in studies() {
        if !matches!(study, Study::Matrices(_)) {
            assert_linear_model_is_the_derivative(&key, &Edited::new(study));
            compared += 1;
        }
    }
    assert!(compared >= 15, "only {compared} aircraft");
}

/// Every coefficient different from zero, another engine, the knobs turned, another flight condition.
fn elsewhere(mut study: CoefficientStudy) -> Edited {
    for (k, field) in LONGITUDINAL_COEFFICIENTS.iter().enumerate() {
        *(field.of)(&mut study.coefficients.longitudinal) += 0.003 * k as f64;
    }
    if let Some(lateral) = &mut study.coefficients.lateral {
        for (k, field) in LATERAL_COEFFICIENTS.iter().enumerate() {
            *(field.of)(lateral) += 0.002 * k as f64;
        }
    }
    study.airframe.thrust_exponent = -1.0;
    study.airframe.thrust_offset = 0.4;
    study.knobs =
        Knobs { mass_ratio: 1.03, ix_ratio: 1.2, iz_ratio: 1.1, cg_shift: 0.02, ..Knobs::default() };
    let FlightCondition { altitude, speed, .. } = study.condition;
    study.condition = FlightCondition { altitude: altitude + 500.0, speed: speed * 1.02, gamma0: -0.06 };
    Edited::new(Study::Coefficients(study))
}

#[test]
fn it_stays_so_with_other_coefficients_knobs_and_condition() {
    for (key, study) in from_coefficients() {
        assert_linear_model_is_the_derivative(&key, &elsewhere(study));
    }
}

fn with_offsets(mut edited: Edited) -> Edited {
    let offsets = &mut edited.offsets;
    for (k, row) in LONGITUDINAL_DERIVATIVES.iter().enumerate() {
        *(row.field.of)(&mut offsets.longitudinal) = 0.01 * (k as f64 - 5.0);
    }
    for (k, row) in LATERAL_DERIVATIVES.iter().enumerate() {
        *(row.field.of)(&mut offsets.lateral) = 0.02 * (k as f64 - 4.0);
    }
    for plane in [Plane::Longitudinal, Plane::Lateral] {
        let matrices = offsets.matrices_mut(plane);
        matrices.a.iter_mut().enumerate().for_each(|(k, entry)| *entry = 0.03 * (k as f64 - 7.0));
        matrices.b.iter_mut().enumerate().for_each(|(k, entry)| *entry = 0.05 * (k as f64 - 3.0));
    }
    edited
}

/// All sixteen entries of A, kinematic rows included.
#[test]
fn it_stays_so_with_offsets_on_derivatives_and_matrices() {
    for (key, study) in from_coefficients() {
        assert_linear_model_is_the_derivative(&key, &with_offsets(elsewhere(study)));
    }
    for (key, study) in from_derivatives() {
        assert_linear_model_is_the_derivative(&key, &with_offsets(Edited::new(study)));
    }
}

#[test]
fn the_trim_is_solved_and_is_where_the_linear_model_has_it() {
    for (key, study) in studies() {
        let Ok(flight) = SixDof::new(&Edited::new(study)) else { continue };
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
    let Study::Coefficients(study) = &mut edited.study else { panic!("it starts from coefficients") };
    study.condition.gamma0 = 0.05;
    let derived = study.derive().expect("it flies");
    let c = derived.coefficients.longitudinal;
    // T/m = q̄S (C_D + C_L tan γ₀)/m
    let q_s = derived.flight.dynamic_pressure * derived.airframe.s / derived.airframe.mass;
    let want = q_s * (c.cd + c.cl * 0.05_f64.tan());
    let got = ready(&edited).steady.thrust;
    assert!((got - want).abs() < 1e-9, "{got} should be {want}");
}

const GRID: TimeGrid = TimeGrid { duration: 12.0, steps: 120 };

fn still(_: f64) -> Controls {
    Controls::default()
}

fn calm(_: f64) -> [f64; 3] {
    [0.0; 3]
}

fn from_rest<'a>() -> Excitation<'a> {
    Excitation {
        controls: &still,
        wind: &calm,
        edges: &[],
        longitudinal: Vector4::zeros(),
        lateral: Vector4::zeros(),
    }
}

/// Where a step enters, with its full size.
#[derive(Clone, Copy, Debug)]
enum Entry {
    Elevator,
    Throttle,
    Aileron,
    Rudder,
    RisingAir,
    SideWind,
}

impl Entry {
    const ALL: [Self; 6] =
        [Self::Elevator, Self::Throttle, Self::Aileron, Self::Rudder, Self::RisingAir, Self::SideWind];

    fn plane(self) -> Plane {
        match self {
            Self::Elevator | Self::Throttle | Self::RisingAir => Plane::Longitudinal,
            Self::Aileron | Self::Rudder | Self::SideWind => Plane::Lateral,
        }
    }

    fn fly(self, flight: &SixDof, size: f64, grid: TimeGrid) -> FlightPath {
        let on = |t: f64| if t >= 1.0 { size } else { 0.0 };
        let controls = |t: f64| {
            let mut controls = Controls::default();
            match self {
                Self::Elevator => controls.elevator = on(t),
                Self::Throttle => controls.throttle = on(t),
                Self::Aileron => controls.aileron = on(t),
                Self::Rudder => controls.rudder = on(t),
                Self::RisingAir | Self::SideWind => {}
            }
            controls
        };
        let wind = |t: f64| match self {
            Self::RisingAir => [0.0, 0.0, on(t)],
            Self::SideWind => [0.0, on(t), 0.0],
            _ => [0.0; 3],
        };
        flight.fly(&Excitation { controls: &controls, wind: &wind, edges: &[1.0], ..from_rest() }, grid)
    }

    /// The linear model's response to the same.
    fn respond(self, edited: &Edited, size: f64, grid: TimeGrid) -> Vec<Vector4<f64>> {
        let models = edited.models().expect("it flies");
        let model = models.of(self.plane()).expect("both planes");
        let column = match self {
            Self::Elevator | Self::Aileron => model.b.column(0).into_owned(),
            Self::Throttle | Self::Rudder => model.b.column(1).into_owned(),
            Self::RisingAir | Self::SideWind => gust_column(model),
        };
        respond(&model.a, &column, &Input::Step { amplitude: size, start: 1.0 }, grid).states
    }

    /// Largest difference between both, velocities over V: numbers of one size.
    fn difference(self, flight: &SixDof, edited: &Edited, size: f64) -> f64 {
        let path = self.fly(flight, size, GRID);
        assert_eq!(path.stop, None, "{self:?} of {size}");
        let linear = self.respond(edited, size, GRID);
        assert_eq!(path.samples.len(), linear.len());
        let v = flight.trim.speed;
        let scale = match self.plane() {
            Plane::Longitudinal => Vector4::new(1.0 / v, 1.0 / v, 1.0, 1.0),
            Plane::Lateral => Vector4::new(1.0 / v, 1.0, 1.0, 1.0),
        };
        let apart = |(sample, linear): (&eigenwing::flight::flight_path::Sample, &Vector4<f64>)| {
            let of = match self.plane() {
                Plane::Longitudinal => sample.longitudinal,
                Plane::Lateral => sample.lateral,
            };
            (of - linear).component_mul(&scale).amax()
        };
        path.samples.iter().zip(&linear).map(apart).fold(0.0, f64::max)
    }
}

#[test]
fn debug_slopes() {
    for key in ["navion", "b747-approach", "a4d"] {
        let edited = edited(key);
        let flight = ready(&edited);
        for entry in Entry::ALL {
            for size in [1e-1, 1e-2, 1e-3, 1e-4] {
                print!(
                    "{key} {entry:?} {size}: {:.3e}   ",
                    entry.difference(
                        &flight,
                        &edited,
                        size * match entry {
                            Entry::RisingAir | Entry::SideWind => 10.0,
                            _ => 0.1,
                        }
                    )
                );
            }
            println!();
        }
    }
}
