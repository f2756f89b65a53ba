//! How the air's motion enters, against columns worked out apart from ours (`scripts/response_golden.py`) and against geometry.

use std::collections::BTreeMap;
use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::aircraft_model::{AircraftModel, DerivativeModel};
use eigenwing::flight::aircraft::derivatives::{LateralDerivatives, LongitudinalDerivatives};
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::inertia::Inertia;
use eigenwing::flight::aircraft::plane::{Plane, Trim};
use eigenwing::flight::analyse;
use eigenwing::flight::motion::experiment::fly;
use eigenwing::flight::motion::gusts::{air_across, air_along, rate_columns};
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::outputs::Output;
use eigenwing::flight::motion::response::TimeGrid;
use eigenwing::flight::{Channel, Experiment, Start};
use eigenwing::scenario::{START, Scenario, Shape, Source};
use nalgebra::{Matrix2, Vector2, Vector4};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    models: Vec<Model>,
}

#[derive(Deserialize)]
struct Model {
    id: String,
    plane: String,
    columns: BTreeMap<String, [f64; 4]>,
    rate_columns: BTreeMap<String, [f64; 4]>,
}

#[test]
fn the_gradient_of_a_gust_enters_as_derived_from_the_matrices_of_the_sources() {
    let file: File = serde_json::from_str(include_str!("data/responses.json")).expect("the data file reads");
    let (aircraft, _) = embedded_aircraft();
    for (id, key) in [
        ("navion_teper_sl", "navion"),
        ("b747_cr2144_fc09", "b747-fc9"),
        ("a4d_fc1", "a4d"),
        ("bristol_f2b", "bristol-f2b"),
        ("x15_m05_sl", "x15"),
    ] {
        let found = aircraft.iter().find(|aircraft| aircraft.key == key).expect("an aircraft");
        let edited = EditedModel::new(found.aircraft_model.clone());
        let derivatives = edited.derivatives().expect("a trim").expect("derivatives");
        let models = edited.models().expect("a trim");
        for (plane, word) in [(Plane::Longitudinal, "longitudinal"), (Plane::Lateral, "lateral")] {
            let model = models.planes[plane].as_ref().expect("data");
            let alpha0 = model.trim.alpha0;
            let of = |column: &str| {
                let found = file.models.iter().find(|model| model.id == id && model.plane == word);
                let model = found.expect("a model");
                let columns = [&model.columns, &model.rate_columns].map(|columns| columns.get(column));
                columns.map(|column| column.map(|column| Vector4::from(*column)))
            };
            let [along, across] = rate_columns(plane, Some(&derivatives));
            let air = [air_along(plane, alpha0), air_across(plane, alpha0)].map(|air| -(model.a * air));
            let names = if plane == Plane::Longitudinal { ["u_g", "w_g"] } else { ["", "v_g"] };
            for (name, got) in names.into_iter().zip([[air[0], along], [air[1], across]]) {
                for (got, want) in got.into_iter().zip(of(name)) {
                    let want = want.unwrap_or_default();
                    // By matrices, U₀ of the source against V of ours leaves a rest in the force that no moment feels.
                    for row in [1, 2].into_iter().skip(usize::from(plane == Plane::Longitudinal)) {
                        let off = (got[row] - want[row]).abs();
                        assert!(off <= 2e-3 * want.amax(), "{key} {name} row {row}: {got} should be {want}");
                    }
                }
            }
        }
    }
}

/// Nose first: where rising air grows, the tail is still in calmer air, so the gust lifts the nose at first more than the same
/// air all over the aircraft would; pitch damping alone (no Ẇ terms) shows it.
#[test]
fn flying_into_growing_rising_air_lifts_the_nose_before_the_tail_feels_it() {
    let (aircraft, _) = embedded_aircraft();
    let found = aircraft.iter().find(|aircraft| aircraft.key == "x15").expect("an aircraft");
    let mut derivatives =
        EditedModel::new(found.aircraft_model.clone()).derivatives().expect("a trim").expect("derivatives");
    let longitudinal = derivatives.longitudinal.as_mut().expect("data");
    (longitudinal.m_wdot, longitudinal.z_wdot) = (0.0, 0.0);
    let rising = -1.0; // ẇ_g, z points down
    let [_, column] = rate_columns(Plane::Longitudinal, Some(&derivatives));
    assert!(column[2] * rising > 0.0);
    assert_eq!(air_across(Plane::Longitudinal, 0.0), Vector4::new(0.0, 1.0, 0.0, 0.0));
}

/// Lift goes with the square of the airspeed: air from ahead lifts at once by 2 U/V of the weight (of what carries it, L = W cos γ₀),
/// and where it blows along the path the angle of attack feels nothing. Compressibility takes some per cent, the F.2B's
/// derivatives more.
#[test]
fn air_from_ahead_lifts_by_twice_its_share_of_the_speed_and_leaves_the_angle_of_attack() {
    let (aircraft, _) = embedded_aircraft();
    let mut turned = 0;
    for one in aircraft {
        let AircraftModel::Derivatives(aircraft_model) = &one.aircraft_model else { continue };
        turned += usize::from(aircraft_model.trim.alpha0 != 0.0);
        let (key, expected) =
            (one.key.clone(), 2.0 * 3.0 / aircraft_model.trim.speed * aircraft_model.trim.gamma0.cos());
        let mut scenario = Scenario::new(Arc::new(one));
        scenario.plane = Plane::Longitudinal;
        scenario.disturbance.choices.longitudinal.source = Source::HeadGust;
        *scenario.disturbance.choices.longitudinal.shape_mut() = Shape::Step;
        scenario.disturbance.sizes.time = 3.0;
        let motion = scenario.analyse().expect("an analysis").motion.expect("a motion");
        let first = (START / motion.response.dt).round() as usize;
        let at_once = |output: Output| motion.values(output)[first];
        assert!(at_once(Output::AngleOfAttack).abs() < 1e-15, "{key}");
        let load = at_once(Output::NormalLoad);
        assert!((load / expected - 1.0).abs() < 0.25, "{key}: {load} g beside {expected} g");
        if key == "x15" {
            assert!((load - 0.0352).abs() < 5e-5, "{load}");
        }
    }
    assert!(turned >= 7, "{turned} aircraft have body axes");
}

/// An aircraft in stability axes, with every derivative but those by ẇ, which body axes share between u̇ and ẇ.
fn in_stability_axes() -> DerivativeModel {
    DerivativeModel {
        trim: Trim { speed: 60.0, alpha0: 0.0, gamma0: 0.05, gravity: 9.81 },
        inertia: Some(Inertia { ix: 1500.0, iy: 4000.0, iz: 4800.0, ixz: 300.0 }),
        longitudinal: Some(LongitudinalDerivatives {
            x_u: -0.05,
            x_w: 0.04,
            x_q: 0.3,
            z_u: -0.33,
            z_w: -2.0,
            z_q: -1.1,
            m_u: 0.004,
            m_w: -0.16,
            m_q: -2.1,
            ..LongitudinalDerivatives::default()
        }),
        lateral: Some(LateralDerivatives {
            y_v: -0.25,
            y_p: 0.2,
            y_r: 0.7,
            l_v: -0.28,
            l_p: -8.0,
            l_r: 2.1,
            n_v: 0.08,
            n_p: -0.4,
            n_r: -0.8,
            ixz_over_ix: 300.0 / 1500.0,
            ixz_over_iz: 300.0 / 4800.0,
            ..LateralDerivatives::default()
        }),
    }
}

/// The same aircraft in body axes at an angle of attack: vectors of force, moment, velocity and rate turned about y, and the
/// tensor of inertia with them.
fn in_body_axes(aircraft_model: &DerivativeModel, alpha0: f64) -> DerivativeModel {
    let (sin, cos) = alpha0.sin_cos();
    // From components in stability axes to those in body axes.
    let turn = Matrix2::new(cos, -sin, sin, cos);
    let turned = |of: Matrix2<f64>| turn * of * turn.transpose();
    let d = aircraft_model.longitudinal.expect("data");
    let force = turned(Matrix2::new(d.x_u, d.x_w, d.z_u, d.z_w));
    let by_q = turn * Vector2::new(d.x_q, d.z_q);
    let moment = turn * Vector2::new(d.m_u, d.m_w);
    let longitudinal = LongitudinalDerivatives {
        x_u: force[(0, 0)],
        x_w: force[(0, 1)],
        z_u: force[(1, 0)],
        z_w: force[(1, 1)],
        x_q: by_q[0],
        z_q: by_q[1],
        m_u: moment[0],
        m_w: moment[1],
        ..d
    };
    let (i, l) = (aircraft_model.inertia.expect("inertia"), aircraft_model.lateral.expect("data"));
    let tensor = turned(Matrix2::new(i.ix, -i.ixz, -i.ixz, i.iz));
    let inertia = Inertia { ix: tensor[(0, 0)], iy: i.iy, iz: tensor[(1, 1)], ixz: -tensor[(0, 1)] };
    let per = Vector2::new(1.0 / inertia.ix, 1.0 / inertia.iz);
    let by_v = (turn * Vector2::new(i.ix * l.l_v, i.iz * l.n_v)).component_mul(&per);
    let by_rates = turned(Matrix2::new(i.ix * l.l_p, i.ix * l.l_r, i.iz * l.n_p, i.iz * l.n_r));
    let by_rates = Matrix2::from_diagonal(&per) * by_rates;
    let side = turn * Vector2::new(l.y_p, l.y_r);
    let lateral = LateralDerivatives {
        y_p: side[0],
        y_r: side[1],
        l_v: by_v[0],
        n_v: by_v[1],
        l_p: by_rates[(0, 0)],
        l_r: by_rates[(0, 1)],
        n_p: by_rates[(1, 0)],
        n_r: by_rates[(1, 1)],
        ixz_over_ix: inertia.ixz / inertia.ix,
        ixz_over_iz: inertia.ixz / inertia.iz,
        ..l
    };
    DerivativeModel {
        trim: Trim { alpha0, ..aircraft_model.trim },
        inertia: Some(inertia),
        longitudinal: Some(longitudinal),
        lateral: Some(lateral),
    }
}

/// What is felt and where it flies is the same whichever axes the numbers are given in, in every gust, small and large.
#[test]
fn a_gust_does_the_same_in_whatever_axes_the_aircraft_is_given() {
    let aircraft_model = in_stability_axes();
    let [stability, body] = [aircraft_model.clone(), in_body_axes(&aircraft_model, 0.21)]
        .map(|s| EditedModel::new(AircraftModel::Derivatives(s)));
    let grid = TimeGrid { duration: 8.0, steps: 80 };
    let seen: [(Plane, &[Output]); 2] = [
        (
            Plane::Longitudinal,
            &[
                Output::AngleOfAttack,
                Output::PitchRate,
                Output::PitchAngle,
                Output::PathAngle,
                Output::NormalLoad,
                Output::Height,
                Output::Distance,
            ],
        ),
        (Plane::Lateral, &[Output::Sideslip, Output::SideLoad, Output::SideSpeed, Output::Offset]),
    ];
    for (plane, outputs) in seen {
        for channel in [Channel::AirAlong, Channel::AirAcross] {
            let gust = Input::OneMinusCosine { amplitude: 5.0, start: 1.0, duration: 1.5 };
            let experiment = Experiment { plane, inputs: vec![(channel, gust)], start: Start::Rest, grid };
            let flown = [&stability, &body].map(|edited| {
                let analysis = analyse(edited, None, &experiment).expect("an analysis");
                let modes =
                    analysis.planes[plane].as_ref().expect("data").as_ref().expect("modes").modes.clone();
                let motion = analysis.motion.expect("a motion");
                let path = fly(edited, &motion.model, &modes, &experiment).expect("it flies");
                assert_eq!(path.stop, None);
                (motion, path)
            });
            for output in outputs {
                let of = |nonlinear: bool| {
                    [&flown[0], &flown[1]].map(|(motion, path)| {
                        if nonlinear { output.of_flight(&motion.model, path) } else { motion.values(*output) }
                    })
                };
                for (nonlinear, tolerance) in [(false, 1e-11), (true, 1e-6)] {
                    let [one, other] = of(nonlinear);
                    let off = one.iter().zip(&other).fold(0.0, |off: f64, (a, b)| off.max((a - b).abs()));
                    assert!(off < tolerance, "{channel:?} {output:?}, nonlinear {nonlinear}: {off:e}");
                }
            }
        }
    }
}
