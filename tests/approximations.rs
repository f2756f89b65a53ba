//! Textbook approximations: NumPy's ratios to the exact modes, and the limits in which each is exact.

mod reference;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::aircraft_model::DerivativeModel;
use eigenwing::flight::aircraft::axes::StabilityAxes;
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel, Trim};
use eigenwing::flight::modes::approximations::{
    Approximation, ApproximationName as Name, DownwashLag, ModeValue, approximations,
};
use eigenwing::flight::modes::mode::modes;
use eigenwing::scenario::Notation;
use eigenwing::words;
use nalgebra::{Matrix4, Matrix4x2};
use proptest::prelude::*;
use reference::{all_models, reference};
use serde_json::Value;

fn all(model: &PlaneModel) -> Vec<Approximation> {
    approximations(&StabilityAxes::of(model), DownwashLag::default(), &modes(model).expect("modes"))
}

fn one(model: &PlaneModel, name: Name) -> Approximation {
    all(model).into_iter().find(|a| a.name == name).expect("every approximation is there")
}

/// Those that are functions of the matrix alone; the others are evaluated from derivatives below.
const KEYS: [(&str, Plane, Name); 5] = [
    ("ph_residualised", Plane::Longitudinal, Name::PhugoidResidualised),
    ("ph_quartic", Plane::Longitudinal, Name::PhugoidQuartic),
    ("roll_Lp", Plane::Lateral, Name::RollDamping),
    ("spiral_ED", Plane::Lateral, Name::SpiralPolynomial),
    ("spiral_simple", Plane::Lateral, Name::SpiralQuick),
];

#[test]
fn ratios_to_the_exact_modes_are_numpys() {
    let file: Value = serde_json::from_str(include_str!("data/approximation_ratios.json")).expect("reads");
    let mut compared = 0;
    for case in file["cases"].as_array().expect("cases") {
        let id = case["id"].as_str().expect("an id");
        let reference = reference(id);
        for (key, plane, name) in KEYS {
            let Some(ratios) = case[key].as_array() else { continue };
            let found = one(&reference.model(plane), name);
            for (ratio, error) in ratios.iter().zip([found.error(), found.damping_error()]) {
                let (ratio, error) = (ratio.as_f64().expect("a number"), error.expect("an error"));
                // eight printed digits; a spiral of 10⁻³ 1/s among roots of 10 loses four of sixteen
                assert!((error + 1.0 - ratio).abs() < 2e-7 * ratio, "{id} {key}: {} {ratio}", error + 1.0);
                compared += 1;
            }
        }
    }
    assert!(compared > 80, "{compared}");
}

/// Derivatives in stability axes by the textbooks' turn of vectors: of forces by velocities, of the moment, of rates by rates.
struct InStabilityAxes {
    v: f64,
    g: f64,
    x_u: f64,
    z_u: f64,
    z_w: f64,
    m_w: f64,
    m_wdot: f64,
    m_q: f64,
}

impl InStabilityAxes {
    fn of(aircraft_model: &DerivativeModel) -> Self {
        let d = aircraft_model.longitudinal.as_ref().expect("data");
        let Trim { speed: v, alpha0, gravity: g, .. } = aircraft_model.trim;
        let (s, c) = alpha0.sin_cos();
        Self {
            v,
            g,
            x_u: c * c * d.x_u + s * c * (d.x_w + d.z_u) + s * s * d.z_w,
            z_u: c * c * d.z_u + s * c * (d.z_w - d.x_u) - s * s * d.x_w,
            z_w: c * c * d.z_w - s * c * (d.z_u + d.x_w) + s * s * d.x_u,
            m_w: c * d.m_w - s * d.m_u,
            m_wdot: c * d.m_wdot,
            m_q: d.m_q,
        }
    }

    fn value(&self, name: Name) -> Option<(f64, Option<f64>)> {
        let &Self { v, g, x_u, z_u, z_w, m_w, m_wdot, m_q } = self;
        let pair = |two_zeta_wn: f64, square: f64| (square.sqrt(), Some(two_zeta_wn / (2.0 * square.sqrt())));
        Some(match name {
            // ωₙ² = Z_w M_q − V M_w,  2ζωₙ = −(Z_w + M_q + V M_ẇ)
            Name::ShortPeriodTwoStates => pair(-(z_w + m_q + v * m_wdot), z_w * m_q - v * m_w),
            // ωₙ² = −V M_w,  2ζωₙ = −(M_q + V M_ẇ)
            Name::ShortPeriodPitchOnly => pair(-(m_q + v * m_wdot), -v * m_w),
            // ωₙ = √2 g/V
            Name::PhugoidLanchester => (2_f64.sqrt() * g / v, None),
            // ωₙ² = −Z_u g/V,  ζ = −X_u/(2ωₙ)
            Name::PhugoidTwoStates => pair(-x_u, -z_u * g / v),
            _ => return None,
        })
    }
}

/// Of every aircraft that ships with derivatives: V is the airspeed, g free fall, M_w the derivative by itself.
#[test]
fn every_longitudinal_number_is_that_of_the_formula_beside_it() {
    let mut compared = 0;
    for one in embedded_aircraft().0 {
        let edited = EditedModel::new(one.aircraft_model);
        let Some(aircraft_model) = edited.derivatives().expect("a trim") else { continue };
        let model = edited.models().expect("a trim").planes.longitudinal.expect("data");
        let by_hand = InStabilityAxes::of(&aircraft_model);
        let found = approximations(
            &StabilityAxes::of(&model),
            DownwashLag::of(Some(&aircraft_model)),
            &modes(&model).expect("modes"),
        );
        for found in found {
            let Some((frequency, damping)) = by_hand.value(found.name) else { continue };
            let Some(ModeValue::SecondOrder { natural_frequency, damping_ratio }) = found.value else {
                assert!(frequency.is_nan(), "{} {:?}", one.key, found.name);
                continue;
            };
            let near = |got: f64, want: f64| (got / want - 1.0).abs() < 1e-9;
            assert!(
                near(natural_frequency, frequency),
                "{} {:?}: {natural_frequency} {frequency}",
                one.key,
                found.name
            );
            for (got, want) in damping_ratio.iter().zip(damping) {
                assert!(near(*got, want), "{} {:?}: {got} {want}", one.key, found.name);
            }
            assert_eq!(damping_ratio.is_some(), damping.is_some());
            compared += 1;
            // Printed derivatives of the Navion and the 747 by hand: √(176 ft/s · 0.0499…), √2 · 9.81/85
            let known = match (one.key.as_str(), found.name) {
                ("navion", Name::ShortPeriodPitchOnly) => Some(2.966),
                ("c47", Name::ShortPeriodPitchOnly) => Some(1.223),
                ("b747-approach", Name::PhugoidLanchester) => Some(0.1630),
                _ => None,
            };
            if let Some(known) = known {
                assert!((natural_frequency / known - 1.0).abs() < 5e-4, "{}: {natural_frequency}", one.key);
            }
        }
    }
    assert!(compared >= 60, "{compared}");
}

#[test]
fn every_lateral_number_is_that_of_the_formula_beside_it() {
    let mut compared = 0;
    for one in embedded_aircraft().0 {
        let edited = EditedModel::new(one.aircraft_model);
        let Some(aircraft_model) = edited.derivatives().expect("a trim") else { continue };
        let Some(d) = aircraft_model.lateral else { continue };
        let model = edited.models().expect("a trim").planes.lateral.expect("data");
        let Trim { speed: v, alpha0, gravity: g, .. } = aircraft_model.trim;
        // Primed: both moments turn both rates by the product of inertia.
        let share = 1.0 - d.ixz_over_ix * d.ixz_over_iz;
        let primed = |l: f64, n: f64| [(l + d.ixz_over_ix * n) / share, (n + d.ixz_over_iz * l) / share];
        let [by_v, by_p, by_r] = [primed(d.l_v, d.n_v), primed(d.l_p, d.n_p), primed(d.l_r, d.n_r)];
        let (s, c) = alpha0.sin_cos();
        // [p, r] about the path and its normal: the rows turn, and of p and r the columns too.
        let rows = |[l, n]: [f64; 2]| [c * l + s * n, c * n - s * l];
        let [l_v, n_v] = rows(by_v);
        let [of_p, of_r] = [rows(by_p), rows(by_r)];
        let [l_p, n_p] = [0, 1].map(|i| c * of_p[i] + s * of_r[i]);
        let [l_r, n_r] = [0, 1].map(|i| c * of_r[i] - s * of_p[i]);
        let neutral = l_v * n_r - n_v * l_r;
        for found in
            approximations(&StabilityAxes::of(&model), DownwashLag::default(), &modes(&model).expect("modes"))
        {
            let pair = |two_zeta_wn: f64, square: f64| ModeValue::SecondOrder {
                natural_frequency: square.sqrt(),
                damping_ratio: Some(two_zeta_wn / (2.0 * square.sqrt())),
            };
            let want = match found.name {
                Name::DutchRollTwoStates => pair(-(d.y_v + n_r), v * n_v + d.y_v * n_r),
                Name::DutchRollYawOnly => pair(-n_r, v * n_v),
                Name::RollDamping => ModeValue::Root(l_p),
                Name::SpiralWithGravity => {
                    ModeValue::Root(-(g / v) * neutral / (l_v * (n_p - g / v) - n_v * l_p))
                }
                Name::SpiralQuick => ModeValue::Root(neutral / l_v),
                _ => continue,
            };
            let numbers = |value: ModeValue| match value {
                ModeValue::SecondOrder { natural_frequency, damping_ratio } => {
                    [natural_frequency, damping_ratio.expect("a damping")]
                }
                ModeValue::Root(root) => [root; 2],
            };
            let got = numbers(found.value.expect("a value"));
            for (got, want) in got.into_iter().zip(numbers(want)) {
                // Of a spiral that is nearly neutral little is left of the products.
                assert!((got / want - 1.0).abs() < 1e-8, "{} {:?}: {got} {want}", one.key, found.name);
            }
            compared += 1;
        }
    }
    assert!(compared >= 70, "{compared}");
}

fn model(plane: Plane, rows: [[f64; 4]; 4]) -> PlaneModel {
    PlaneModel {
        plane,
        a: Matrix4::from_fn(|i, j| rows[i][j]),
        b: Matrix4x2::zeros(),
        trim: Trim { speed: 50.0, alpha0: 0.0, gamma0: 0.0, gravity: 9.81 },
        further: None,
    }
}

fn navion(plane: Plane, change: impl Fn(&mut Matrix4<f64>)) -> PlaneModel {
    let mut model = reference("navion_teper_sl").model(plane);
    change(&mut model.a);
    model
}

fn assert_exact(model: &PlaneModel, name: Name, damping: bool, tolerance: f64) {
    let found = one(model, name);
    let error = found.error().expect("a value");
    assert!(error.abs() < tolerance, "{name:?}: {error:e}");
    if damping {
        let error = found.damping_error().expect("a damping");
        assert!(error.abs() < tolerance, "{name:?} ζ: {error:e}");
    }
}

#[test]
fn the_short_period_of_two_states_is_exact_without_changes_of_speed() {
    let no_speed = |a: &mut Matrix4<f64>| {
        a[(1, 0)] = 0.0;
        a[(2, 0)] = 0.0;
    };
    assert_exact(&navion(Plane::Longitudinal, no_speed), Name::ShortPeriodTwoStates, true, 1e-12);
    let nor_heave = |a: &mut Matrix4<f64>| {
        no_speed(a);
        a[(1, 1)] = 0.0;
    };
    assert_exact(&navion(Plane::Longitudinal, nor_heave), Name::ShortPeriodPitchOnly, true, 1e-12);
}

#[test]
fn the_phugoid_at_constant_angle_of_attack_is_exact_for_great_stiffness() {
    for stiffness in [1e2, 1e4, 1e6] {
        let stiff = |a: &mut Matrix4<f64>| {
            a[(2, 1)] *= stiffness;
            a[(2, 0)] = 0.0;
        };
        // the error falls as 1/Mw
        assert_exact(&navion(Plane::Longitudinal, stiff), Name::PhugoidTwoStates, true, 20.0 / stiffness);
        let lanchester = |a: &mut Matrix4<f64>| {
            stiff(a);
            a[(0, 0)] = 0.0;
            // Zu = −2g/V
            a[(1, 0)] = 2.0 * a[(0, 3)] / a[(1, 2)];
        };
        assert_exact(
            &navion(Plane::Longitudinal, lanchester),
            Name::PhugoidLanchester,
            false,
            20.0 / stiffness,
        );
    }
}

#[test]
fn the_slow_phugoid_is_exact_as_the_modes_part() {
    for slowness in [1e-2, 1e-4, 1e-6] {
        let slow = |a: &mut Matrix4<f64>| {
            for j in 0..4 {
                a[(0, j)] *= slowness;
                a[(3, j)] *= slowness;
            }
        };
        for name in [Name::PhugoidResidualised, Name::PhugoidQuartic] {
            assert_exact(&navion(Plane::Longitudinal, slow), name, true, 10.0 * slowness);
        }
    }
}

#[test]
fn the_dutch_roll_is_exact_without_rolling() {
    let no_roll = |a: &mut Matrix4<f64>| {
        a[(0, 1)] = 0.0;
        a[(0, 3)] = 0.0;
        a[(2, 1)] = 0.0;
    };
    assert_exact(&navion(Plane::Lateral, no_roll), Name::DutchRollTwoStates, true, 1e-12);
    let nor_side_force = |a: &mut Matrix4<f64>| {
        no_roll(a);
        a[(0, 0)] = 0.0;
    };
    assert_exact(&navion(Plane::Lateral, nor_side_force), Name::DutchRollYawOnly, true, 1e-12);
}

#[test]
fn the_roll_is_exact_without_sideslip_and_yaw_in_it() {
    let alone = |a: &mut Matrix4<f64>| {
        a[(1, 0)] = 0.0;
        a[(1, 2)] = 0.0;
    };
    assert_exact(&navion(Plane::Lateral, alone), Name::RollDamping, false, 1e-12);
}

#[test]
fn the_spiral_is_exact_as_it_becomes_neutral() {
    for distance in [1e-2, 1e-4, 1e-6] {
        // N'r beside its neutral value N'v L'r/L'v
        let nearly_neutral = |a: &mut Matrix4<f64>| {
            a[(2, 2)] = a[(2, 0)] * a[(1, 2)] / a[(1, 0)] * (1.0 + distance);
        };
        let no_side_force = |a: &mut Matrix4<f64>| {
            nearly_neutral(a);
            a[(0, 0)] = 0.0;
        };
        let nor_roll_damping = |a: &mut Matrix4<f64>| {
            no_side_force(a);
            a[(2, 1)] = 0.0;
            a[(1, 1)] = 0.0;
        };
        let tolerance = 2.0 * distance + 1e-9;
        assert_exact(&navion(Plane::Lateral, nearly_neutral), Name::SpiralPolynomial, false, tolerance);
        assert_exact(&navion(Plane::Lateral, no_side_force), Name::SpiralWithGravity, false, tolerance);
        let quick = approximations(
            &StabilityAxes::of(&navion(Plane::Lateral, nor_roll_damping)),
            DownwashLag::default(),
            &[],
        );
        let value = |name| quick.iter().find(|a| a.name == name).and_then(|a| a.value).expect("a value");
        // Without roll damping the roots' names are others; the polynomial's root stands for the exact one.
        let (ModeValue::Root(quick), ModeValue::Root(exact)) =
            (value(Name::SpiralQuick), value(Name::SpiralPolynomial))
        else {
            panic!("roots")
        };
        assert!((quick / exact - 1.0).abs() < 1e-9, "{quick} {exact}");
    }
}

#[test]
fn what_an_approximation_cannot_give_is_absent() {
    // Mw > 0: no frequency in the pitch-only form.
    let unstable = navion(Plane::Longitudinal, |a| a[(2, 1)] = 0.1);
    assert_eq!(one(&unstable, Name::ShortPeriodPitchOnly).value, None);
    assert_eq!(one(&unstable, Name::ShortPeriodPitchOnly).error(), None);
    // nothing at all
    for plane in Plane::ALL {
        for found in all(&model(plane, [[0.0; 4]; 4])) {
            assert!(found.error().is_none());
        }
    }
}

#[test]
fn every_approximation_says_what_it_leaves_out() {
    for (_, model) in all_models() {
        for found in all(&model) {
            assert!(
                words::approximation::formula(found.name, Notation::Velocities).contains('=')
                    && words::approximation::neglects(found.name, Notation::Velocities).ends_with('.')
            );
            assert!(found.value.is_some() && found.exact.is_some());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_number_is_ever_not_finite(entries in proptest::collection::vec(prop_oneof![Just(0.0), -10.0..10.0_f64, -1e150..1e150_f64], 16), lateral in any::<bool>(), alpha0 in -3.2..3.2_f64) {
        let mut model = model(if lateral { Plane::Lateral } else { Plane::Longitudinal }, [[0.0; 4]; 4]);
        model.a = Matrix4::from_row_slice(&entries);
        model.trim.alpha0 = alpha0;
        let modes = modes(&model).unwrap_or_default();
        for found in approximations(&StabilityAxes::of(&model), DownwashLag { z_wdot: alpha0, m_wdot: 1.0, alpha0 }, &modes) {
            for value in [found.value, found.exact].into_iter().flatten() {
                let finite = match value {
                    ModeValue::SecondOrder { natural_frequency, damping_ratio } => natural_frequency.is_finite() && damping_ratio.is_none_or(f64::is_finite),
                    ModeValue::Root(root) => root.is_finite(),
                };
                prop_assert!(finite, "{:?}", found);
            }
            prop_assert!(found.error().is_none_or(f64::is_finite) && found.damping_error().is_none_or(f64::is_finite));
        }
    }
}
