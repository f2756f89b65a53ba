//! Nonlinear flight beside the linear model: same trim, same derivative, and the same responses as disturbances get small.

use std::sync::LazyLock;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aerodynamics::{Aerodynamics, Controls};
use eigenwing::flight::coefficients::{LATERAL_COEFFICIENTS, LONGITUDINAL_COEFFICIENTS};
use eigenwing::flight::condition::FlightCondition;
use eigenwing::flight::derivatives::{LATERAL_DERIVATIVES, LONGITUDINAL_DERIVATIVES};
use eigenwing::flight::edits::Edited;
use eigenwing::flight::flight_path::{Excitation, FlightPath, Reason, Sample, Stop};
use eigenwing::flight::gusts::{air_across, penetration_column};
use eigenwing::flight::inputs::Input;
use eigenwing::flight::knobs::Knobs;
use eigenwing::flight::plane::{Plane, PlaneModel};
use eigenwing::flight::response::{Forced, TimeGrid, respond};
use eigenwing::flight::rigid_body::{Attitude, Inertia};
use eigenwing::flight::six_dof::{SixDof, SixDofError, TRIM_RESIDUAL, Wind};
use eigenwing::flight::study::{CoefficientStudy, Study};
use nalgebra::{Matrix4, SMatrix, Vector4};
use proptest::prelude::*;

fn studies() -> Vec<(String, Study)> {
    static READ: LazyLock<Vec<(String, Study)>> =
        LazyLock::new(|| embedded_aircraft().0.into_iter().map(|one| (one.key, one.study)).collect());
    READ.clone()
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

/// Column by which the cross gust enters the linear model.
fn gust_column(model: &PlaneModel) -> Vector4<f64> {
    -(model.a * air_across(model.plane))
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
            let gradient: Vector4<f64> = jacobian.wind_rate.fixed_view::<4, 1>(at, wind).into_owned();
            let derivatives = edited.derivatives().expect("it flies");
            let column = penetration_column(plane, derivatives.as_ref());
            if edited.offsets == Default::default() {
                assert_same(&format!("{key}, {plane:?}, gradient of the gust"), &gradient, &column);
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

fn calm(_: f64) -> Wind {
    Wind::default()
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
            Self::RisingAir => Wind { velocity: [0.0, 0.0, on(t)], ..Wind::default() },
            Self::SideWind => Wind { velocity: [0.0, on(t), 0.0], ..Wind::default() },
            _ => Wind::default(),
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
        let step = Input::Step { amplitude: size, start: 1.0 };
        respond(&Forced::from_rest(model.a, column, step), grid).states
    }

    /// Largest difference between both in all eight states, velocities over V. The linear model leaves the other plane at rest.
    fn difference(self, flight: &SixDof, edited: &Edited, size: f64) -> f64 {
        let path = self.fly(flight, size, GRID);
        assert_eq!(path.stop, None, "{self:?} of {size}");
        let linear = self.respond(edited, size, GRID);
        assert_eq!(path.samples.len(), linear.len());
        let v = flight.trim.speed;
        let apart = |(sample, linear): (&Sample, &Vector4<f64>)| {
            let (mut x, mut y) = (sample.longitudinal, sample.lateral);
            match self.plane() {
                Plane::Longitudinal => x -= linear,
                Plane::Lateral => y -= linear,
            }
            [x[0] / v, x[1] / v, x[2], x[3], y[0] / v, y[1], y[2], y[3]]
                .into_iter()
                .fold(0.0, |m: f64, e| m.max(e.abs()))
        };
        path.samples.iter().zip(&linear).map(apart).fold(0.0, f64::max)
    }
}

/// Size of a step that is some tenths of what the model bears: controls in radians, throttle in weights, air in m/s.
fn fair_size(entry: Entry, flight: &SixDof) -> f64 {
    match entry {
        Entry::Elevator => 4e-3,
        Entry::Throttle => 2e-2,
        Entry::Aileron | Entry::Rudder => 4e-3,
        Entry::RisingAir | Entry::SideWind => 0.01 * flight.trim.speed,
    }
}

/// What the first order leaves is of second order: a hundredth of the error for a tenth of the size. Sizes from the fair one
/// to a thirtieth of it, for then rounding and the integrator's 10⁻⁹ come near.
#[test]
fn the_error_of_the_linear_model_falls_as_the_square_of_the_amplitude() {
    for key in ["navion", "b747-approach", "cessna-172", "a4d", "nt33a"] {
        let edited = edited(key);
        let flight = ready(&edited);
        for entry in Entry::ALL {
            let size = fair_size(entry, &flight);
            let [large, small] = [size, size / 30.0].map(|size| entry.difference(&flight, &edited, size));
            let slope = (large / small).ln() / 30.0_f64.ln();
            assert!((slope - 2.0).abs() < 0.15, "{key}, {entry:?}: slope {slope} from {large} and {small}");
        }
    }
}

/// So a lateral response has no error of second order in its own plane, and what it does to the other is of second order.
#[test]
fn left_and_right_are_alike() {
    let edited = edited("navion");
    let flight = ready(&edited);
    for entry in [Entry::Aileron, Entry::Rudder] {
        let [left, right] = [-0.01, 0.01].map(|size| entry.fly(&flight, size, GRID).samples);
        for (left, right) in left.iter().zip(&right) {
            assert!((left.lateral + right.lateral).amax() < 1e-6, "{entry:?}");
            assert!((left.longitudinal - right.longitudinal).amax() < 1e-6, "{entry:?}");
        }
    }
}

#[test]
fn nothing_done_nothing_happens() {
    for (key, study) in studies() {
        let Ok(flight) = SixDof::new(&Edited::new(study)) else { continue };
        let path = flight.fly(&from_rest(), TimeGrid { duration: 20.0, steps: 40 });
        assert_eq!((path.stop, path.samples.len()), (None, 41), "{key}");
        for (k, sample) in path.samples.iter().enumerate() {
            // a mode that doubles in a few seconds leaves 1e-10 of rounding small in 20 s
            assert!(sample.longitudinal.amax() < 1e-6 && sample.lateral.amax() < 1e-6, "{key}: {sample:?}");
            let (t, v, gamma0) = (path.dt * k as f64, flight.trim.speed, flight.trim.gamma0);
            let [north, east, up] = sample.position;
            assert!((north - v * gamma0.cos() * t).abs() < 1e-4 && east.abs() < 1e-4, "{key}");
            assert!((up - v * gamma0.sin() * t).abs() < 1e-4, "{key}");
            assert!(
                (sample.n_z - gamma0.cos()).abs() < 1e-7 && sample.n_y.abs() < 1e-7,
                "{key}: {}",
                sample.n_z
            );
            assert!((sample.airspeed - v).abs() < 1e-6 && sample.alpha.abs() < 1e-8, "{key}");
        }
    }
}

/// The source's C_L is rounded, the Navion's 0.41 for 0.406: what it leaves of the weight is small.
#[test]
fn what_the_sources_rounding_leaves_of_the_weight_is_small() {
    for (key, study) in from_coefficients() {
        let flight = ready(&Edited::new(Study::Coefficients(study)));
        let Aerodynamics::Coefficients(model) = &flight.aerodynamics else { panic!("{key}") };
        let [x, z] = model.remainder();
        assert!(x.hypot(z) < 0.015 * flight.trim.gravity, "{key}: {x}, {z}");
    }
}

/// Climb, thrust line, propeller and Mach terms, one at a time.
#[test]
fn climb_thrust_line_propeller_and_mach_terms_have_their_derivatives() {
    for (key, study) in from_coefficients() {
        for (gamma0, exponent, offset) in
            [(0.2, 0.0, 0.0), (-0.1, -1.0, 0.0), (0.1, -1.0, 0.8), (0.0, 0.5, -0.5)]
        {
            let mut study = study.clone();
            study.condition.gamma0 = gamma0;
            study.condition.speed *= 1.01;
            study.airframe.thrust_exponent = exponent;
            study.airframe.thrust_offset = offset;
            let l = &mut study.coefficients.longitudinal;
            (l.cl_m, l.cd_m, l.cm_m, l.cd_de, l.cl_alphadot) = (0.2, 0.05, -0.1, 0.03, 1.5);
            assert_linear_model_is_the_derivative(&key, &Edited::new(Study::Coefficients(study)));
        }
    }
}

#[test]
fn a_trim_at_the_stall_or_at_the_end_of_the_mach_numbers_can_be_flown() {
    let mut edited = edited("navion");
    let Study::Coefficients(study) = &mut edited.study else { panic!("it starts from coefficients") };
    study.validity.cl_max = study.coefficients.longitudinal.cl;
    study.validity.mach_max = study.reference.mach();
    let path = ready(&edited).fly(&from_rest(), GRID);
    assert_eq!((path.stop, path.samples.len()), (None, 121));
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
    let Study::Coefficients(study) = &mut heavier.study else { panic!("it starts from coefficients") };
    study.knobs.iy_ratio = 1.5;
    assert!((ready(&heavier).inertia.iy / slug_ft2 - 4500.0).abs() < 1e-3);
    assert_eq!(ready(&edited("c47")).inertia, Inertia { ix: 1.0, iy: 1.0, iz: 1.0, ixz: 0.0 });
}

/// Off the trim by \[u, w, q, θ\] and \[v, p, r, φ\].
fn off<'a>(longitudinal: [f64; 4], lateral: [f64; 4]) -> Excitation<'a> {
    Excitation { longitudinal: longitudinal.into(), lateral: lateral.into(), ..from_rest() }
}

#[test]
fn an_initial_displacement_is_that_of_the_linear_model() {
    let edited = edited("navion");
    let flight = ready(&edited);
    let (x, y) = ([1e-3, 2e-3, 1e-4, -1e-4], [3e-3, 1e-4, -2e-4, 3e-4]);
    let grid = TimeGrid { duration: 2.0, steps: 2 };
    let path = flight.fly(&off(x, y), grid);
    let models = edited.models().expect("it flies");
    for (k, sample) in path.samples.iter().enumerate() {
        let free = |model: &eigenwing::flight::plane::PlaneModel, x: [f64; 4]| {
            (model.a * k as f64).exp() * Vector4::from(x)
        };
        let want = free(models.longitudinal.as_ref().expect("longitudinal"), x);
        assert!((sample.longitudinal - want).amax() < 1e-5, "{k}");
        let want = free(models.lateral.as_ref().expect("lateral"), y);
        assert!((sample.lateral - want).amax() < 1e-5, "{k}");
    }
}

#[test]
fn flight_goes_on_through_the_vertical_and_upside_down() {
    let flight = ready(&edited("a4d"));
    // almost straight up, and pulling
    let pull = |_: f64| Controls { elevator: -0.05, ..Controls::default() };
    let climbing = Excitation { controls: &pull, ..off([0.0, 0.0, 0.0, 1.3], [0.0; 4]) };
    let path = flight.fly(&climbing, TimeGrid { duration: 2.0, steps: 200 });
    let over = path.samples.iter().map(|s| s.euler[0].abs()).fold(0.0, f64::max);
    assert!(over > 3.0, "the bank beyond the vertical is 180°, {over}, {:?}", path.stop);
    assert!(path.samples.len() > 100, "{:?}", path.stop);
    // a whole roll
    let aileron = |_: f64| Controls { aileron: 0.05, ..Controls::default() };
    let excitation = Excitation { controls: &aileron, ..from_rest() };
    let path = flight.fly(&excitation, TimeGrid { duration: 8.0, steps: 800 });
    let bank: Vec<f64> = path.samples.iter().map(|s| s.euler[0]).collect();
    let turns = bank.windows(2).filter(|pair| (pair[1] - pair[0]).abs() > 3.0).count();
    assert!(turns >= 1, "{:?}, {:?}", path.stop, bank.last());
    for sample in &path.samples {
        assert!((sample.attitude.square() - 1.0).abs() < 1e-12);
    }
}

fn stop(path: FlightPath) -> Stop {
    path.stop.expect("it stops")
}

#[test]
fn a_flight_stops_with_a_sentence_where_the_model_ends() {
    let flight = ready(&edited("navion"));
    let grid = TimeGrid { duration: 60.0, steps: 600 };
    // C_L 1.4 at the stall, 0.41 in the trim, 4.44 a radian: 12.8° above the trim
    let stalled = stop(Entry::Elevator.fly(&flight, -0.3, grid));
    let Reason::AngleOfAttack(alpha) = stalled.reason else { panic!("{stalled}") };
    assert!((alpha - (1.4 - 0.41) / 4.44).abs() < 1e-8, "{alpha}");
    let text = stalled.to_string();
    assert!(text.contains("the angle of attack is 12.8° above the trim’s"), "{text}");
    assert!(stalled.time > 1.0 && stalled.time < 2.0);

    // A gust is felt at once.
    let blown = stop(Entry::SideWind.fly(&flight, 25.0, grid));
    assert_eq!(blown.time, 1.0);
    assert!(matches!(blown.reason, Reason::Sideslip(beta) if beta < 0.0), "{blown}");
    assert!(blown.to_string().contains("to the left"), "{blown}");

    // 0.158 in the trim, 0.3 where the coefficients end
    let diving = |_: f64| Controls { throttle: 0.6, ..Controls::default() };
    let dive = Excitation { controls: &diving, ..off([0.0, 0.0, 0.0, -0.5], [0.0; 4]) };
    let fast = stop(flight.fly(&dive, grid));
    assert!(matches!(fast.reason, Reason::Mach(mach) if (mach - 0.3).abs() < 1e-8), "{fast}");

    // Derivatives: half the trim speed away.
    let flight = ready(&edited("navion-nelson"));
    let slow = stop(flight.fly(&off([-30.0, 0.0, 0.0, 0.0], [0.0; 4]), grid));
    assert!(matches!(slow.reason, Reason::Airspeed(_)), "{slow}");
    assert_eq!(slow.time, 0.0);
}

#[test]
fn samples_end_where_the_flight_stops() {
    let flight = ready(&edited("navion"));
    let path = Entry::Elevator.fly(&flight, -0.3, TimeGrid { duration: 60.0, steps: 6000 });
    let time = stop(path.clone()).time;
    let last = (path.samples.len() - 1) as f64 * path.dt;
    assert!(last <= time && time < last + 1.001 * path.dt, "{last}, {time}");
    for sample in &path.samples {
        assert!(sample.alpha <= flight.limits.alpha[1] + 1e-8);
    }
}

/// Where the edges are and how dense the samples are changes nothing.
#[test]
fn samples_and_edges_do_not_move_the_flight() {
    let flight = ready(&edited("navion"));
    let controls = |_: f64| Controls { elevator: -0.01, aileron: 0.01, ..Controls::default() };
    let fly = |edges: &[f64], steps: usize| {
        let excitation = Excitation { controls: &controls, edges, ..from_rest() };
        flight.fly(&excitation, TimeGrid { duration: 5.0, steps }).samples.pop().expect("a sample")
    };
    let one = fly(&[], 1);
    for (edges, steps) in [(&[][..], 1000), (&[f64::NAN, 3.0, -1.0, 1.234, 3.0, 7.0][..], 7)] {
        let other = fly(edges, steps);
        assert!((one.longitudinal - other.longitudinal).amax() < 1e-6);
        assert!((one.lateral - other.lateral).amax() < 1e-6);
    }
}

#[test]
fn what_cannot_be_flown_says_so() {
    assert_eq!(SixDof::new(&edited("lesson")), Err(SixDofError::Matrices));
    assert!(SixDofError::Matrices.to_string().contains("small disturbances only"));
    let mut steep = edited("navion-nelson");
    let Study::Derivatives(study) = &mut steep.study else { panic!("it starts from derivatives") };
    study.trim.gamma0 = 1.55;
    assert!(matches!(SixDof::new(&steep), Err(SixDofError::Trim { .. })));
    let mut heavy = edited("navion");
    let Study::Coefficients(study) = &mut heavy.study else { panic!("it starts from coefficients") };
    study.condition.speed = 20.0;
    assert!(matches!(SixDof::new(&heavy), Err(SixDofError::Study(_))));
    let mut without = edited("a4d");
    let Study::Derivatives(study) = &mut without.study else { panic!("it starts from derivatives") };
    study.inertia = None;
    assert_eq!(SixDof::new(&without), Err(SixDofError::NoInertia));
}

#[test]
fn without_lateral_data_it_flies_in_its_plane_and_not_out_of_it() {
    let mut flat = edited("navion");
    let Study::Coefficients(study) = &mut flat.study else { panic!("it starts from coefficients") };
    study.coefficients.lateral = None;
    let flight = ready(&flat);
    assert_eq!(Entry::Elevator.fly(&flight, -0.01, GRID).stop, None);
    for entry in [Entry::Aileron, Entry::Rudder, Entry::SideWind] {
        let stopped = stop(entry.fly(&flight, 0.01, GRID));
        assert_eq!((stopped.time, stopped.reason), (1.0, Reason::NoLateralData), "{entry:?}");
    }
}

#[test]
fn inputs_that_are_no_numbers_stop_the_flight() {
    let flight = ready(&edited("navion"));
    for bad in [f64::NAN, f64::INFINITY] {
        for entry in Entry::ALL {
            let stopped = stop(entry.fly(&flight, bad, GRID));
            assert_eq!((stopped.time, stopped.reason), (1.0, Reason::Input), "{entry:?}");
        }
    }
    for duration in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        let path = flight.fly(&from_rest(), TimeGrid { duration, steps: 10 });
        assert_eq!((path.samples.len(), path.dt), (1, 0.0));
    }
}

fn is_finite(path: &FlightPath) -> bool {
    path.samples.iter().all(|s| {
        let Attitude { w, x, y, z } = s.attitude;
        let rest = [w, x, y, z, s.alpha, s.beta, s.airspeed, s.n_z, s.n_y];
        let all = s.longitudinal.iter().chain(&s.lateral).chain(&s.euler).chain(&s.position).chain(&rest);
        all.copied().all(f64::is_finite)
    }) && path.stop.is_none_or(|stop| stop.time.is_finite() && !stop.to_string().contains("NaN"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// No piece is too short and no end is missed by rounding.
    #[test]
    fn every_flight_reaches_its_end(
        duration in 1e-9..20.0_f64,
        steps in 1..50_usize,
        edges in prop::collection::vec(0.0..20.0_f64, 0..6),
    ) {
        let path = ready(&edited("navion")).fly(&Excitation { edges: &edges, ..from_rest() }, TimeGrid { duration, steps });
        prop_assert_eq!(path.stop, None);
        prop_assert_eq!(path.samples.len(), steps + 1);
    }

    /// Whatever is turned and done: finite numbers, or a sentence.
    #[test]
    fn every_flight_is_finite(
        which in 0..18_usize,
        knobs in prop::array::uniform4(0.3..3.0_f64),
        cg_shift in -0.5..0.5_f64,
        (altitude, speed, gamma0) in (0.0..12e3_f64, 0.7..1.4_f64, -0.8..0.8_f64),
        entries in prop::array::uniform12(-30.0..30.0_f64),
        gain in prop::sample::select(vec![0.0, 1e-3, 1.0, 1e3, 1e8]),
        controls in prop::array::uniform4(-1.0..1.0_f64),
        wind in prop::array::uniform3(-20.0..20.0_f64),
        from in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        let all = studies();
        let mut edited = Edited::new(all[which % all.len()].1.clone());
        if let Study::Coefficients(study) = &mut edited.study {
            let [mass_ratio, ix_ratio, iy_ratio, iz_ratio] = knobs;
            study.knobs = Knobs { mass_ratio, ix_ratio, iy_ratio, iz_ratio, cg_shift, ..Knobs::default() };
            let speed = study.condition.speed * speed;
            study.condition = FlightCondition { altitude, speed, gamma0 };
        }
        for (k, entry) in entries.into_iter().enumerate() {
            edited.offsets.longitudinal_matrices.a[k] = gain * entry;
            edited.offsets.lateral_matrices.a[k] = gain * entry;
        }
        let Ok(flight) = SixDof::new(&edited) else { return Ok(()) };
        let [elevator, throttle, aileron, rudder] = controls;
        let moved = |t: f64| Controls { elevator: elevator * t.sin(), throttle, aileron, rudder };
        let blowing = |t: f64| Wind {
            velocity: wind.map(|w| w * (0.7 * t).cos()),
            rate: wind.map(|w| -0.7 * w * (0.7 * t).sin()),
        };
        let [u, w, q, theta, v, p, r, phi] = from;
        let excitation = Excitation {
            controls: &moved,
            wind: &blowing,
            edges: &[2.0],
            longitudinal: Vector4::new(u, w, q, theta),
            lateral: Vector4::new(v, p, r, phi),
        };
        let path = flight.fly(&excitation, TimeGrid { duration: 10.0, steps: 50 });
        prop_assert!(is_finite(&path), "{:?}", path.stop);
        prop_assert!(path.stop.is_some() || path.samples.len() == 51);
    }
}
