//! Static stability of both planes: signs, the Navion's neutral and manoeuvre points, and its spiral.

mod reference;

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::axes::StabilityAxes;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::modes::mode::{modes, modes_of};
use eigenwing::flight::modes::stability::Stability;
use eigenwing::flight::verdicts::static_stability::{
    PlaneStiffness, manoeuvre_margin, plane_static_stability, static_margin,
};
use eigenwing::scenario::{Parameter, Scenario};
use nalgebra::Matrix4;
use proptest::prelude::*;
use reference::{NAVION_M_W, all_models, navion_with_m_w, reference, references, sweeps};

fn navion(plane: Plane) -> PlaneModel {
    reference("navion_teper_sl").model(plane)
}

#[test]
fn every_reference_aircraft_points_back_in_pitch_yaw_and_roll() {
    for reference in references() {
        for plane in Plane::ALL {
            match plane_static_stability(&StabilityAxes::of(&reference.model(plane)), None).stiffness {
                PlaneStiffness::Longitudinal { m_w, to_manoeuvre_point } => {
                    assert_eq!(m_w.verdict, Stability::Stable, "{}", reference.id);
                    assert!(to_manoeuvre_point.expect("a speed") > 0.0);
                }
                PlaneStiffness::Lateral { n_v, l_v, .. } => {
                    assert_eq!((n_v.verdict, l_v.verdict), (Stability::Stable, Stability::Stable));
                    assert!(n_v.value > 0.0 && l_v.value < 0.0, "{}", reference.id);
                }
            }
        }
    }
}

#[test]
fn a_real_root_that_grows_alone_is_what_a_negative_determinant_means() {
    for (id, model) in all_models() {
        let growing = modes(&model).expect("modes");
        let growing =
            growing.iter().filter(|m| !m.is_oscillatory() && m.stability == Stability::Unstable).count();
        let found = plane_static_stability(&StabilityAxes::of(&model), None);
        assert_eq!(found.determinant > 0.0, growing % 2 == 0, "{id}");
        let expected = if growing % 2 == 0 { Stability::Stable } else { Stability::Unstable };
        assert_eq!(found.of_determinant, expected, "{id}");
    }
}

#[test]
fn the_navion_is_neutral_at_no_stiffness_and_manoeuvres_until_the_manoeuvre_point() {
    let at = |factor: f64| {
        plane_static_stability(
            &StabilityAxes::of(&PlaneModel { a: navion_with_m_w(factor), ..navion(Plane::Longitudinal) }),
            None,
        )
    };
    use Stability::{Neutral, Stable, Unstable};
    let determinants = [1.0, 1e-9, 0.0, -1e-9].map(|factor| at(factor).of_determinant);
    assert_eq!(determinants, [Stable, Stable, Neutral, Unstable]);
    let verdicts = [1.0, 1e-9, -1e-9].map(|factor| at(factor).verdict);
    assert_eq!(verdicts, [Stable, Stable, Unstable]);
    let PlaneStiffness::Longitudinal { m_w, .. } = at(0.0).stiffness else { panic!("pitch") };
    // What is left is the rounding of entries that are 1.8 in size.
    assert!(m_w.value.abs() < 1e-11 * NAVION_M_W.abs(), "{}", m_w.value);
    let PlaneStiffness::Longitudinal { to_manoeuvre_point, .. } = at(1.0).stiffness else { panic!("pitch") };
    // Mw = Zw Mq/V = +0.023887 1/(ft·s)
    let point = NAVION_M_W + to_manoeuvre_point.expect("a speed");
    assert!((point * 0.3048 / sweeps().manoeuvre_point_m_w - 1.0).abs() < 1e-6, "{point}");
}

#[test]
fn the_margins_are_those_of_the_coefficients() {
    // Cm_α = −0.683, CL_α = 4.44 of the Navion: 15.4 % of the chord
    let margin = static_margin(-0.683, 4.44).expect("a margin");
    assert!((margin - 0.15383).abs() < 1e-5);
    // ρ 0.002378 slug/ft³, S 184 ft², c 5.7 ft, m 85.4 slug, Cm_q −9.96: 7.27 % behind
    let manoeuvre = manoeuvre_margin(margin, -9.96, 0.002378, 184.0, 5.7, 85.4).expect("a margin");
    assert!((manoeuvre - margin - 0.07272).abs() < 1e-5, "{manoeuvre}");
    // The same from M_w: both distances are to each other as the margins, but for the drag beside CL_α (1.1 %).
    let PlaneStiffness::Longitudinal { to_manoeuvre_point, .. } =
        plane_static_stability(&StabilityAxes::of(&navion(Plane::Longitudinal)), None).stiffness
    else {
        panic!("pitch")
    };
    let ratio = to_manoeuvre_point.expect("a speed") / -NAVION_M_W;
    assert!((ratio / (manoeuvre / margin) - 1.0).abs() < 0.012, "{ratio}");
    assert_eq!((static_margin(-1.0, 0.0), manoeuvre_margin(0.1, -9.0, 1.2, 17.0, 1.7, 0.0)), (None, None));
}

#[test]
fn the_navions_spiral_is_neutral_where_the_condition_is() {
    let factor = sweeps().spiral_neutral_l_beta_factor;
    let condition = |factor: f64| {
        let mut model = navion(Plane::Lateral);
        model.a[(1, 0)] *= factor;
        let PlaneStiffness::Lateral { spiral, .. } =
            plane_static_stability(&StabilityAxes::of(&model), None).stiffness
        else {
            panic!("yaw and roll")
        };
        (spiral, plane_static_stability(&StabilityAxes::of(&model), None).determinant)
    };
    let (one, _) = condition(1.0);
    assert!(condition(factor).0.value.abs() < 1e-6 * one.value);
    use Stability::{Stable, Unstable};
    for (by, expected) in [(1.001, Stable), (0.999, Unstable)] {
        let (spiral, determinant) = condition(factor * by);
        assert_eq!((spiral.verdict, determinant > 0.0), (expected, expected == Stable));
    }
}

/// A slow spiral that grows is nothing static, and a nose that turns out of the wind is, whatever det A says.
#[test]
fn sideways_the_verdict_is_on_the_moments_of_a_sideslip_not_on_the_spiral() {
    let lateral = |scale: [f64; 2]| {
        let mut model = navion(Plane::Lateral);
        model.a[(1, 0)] *= scale[0];
        model.a[(2, 0)] *= scale[1];
        plane_static_stability(&StabilityAxes::of(&model), None)
    };
    // Half the dihedral: the Navion's spiral grows, but a sideslip still rolls and yaws it back.
    let spiral = lateral([0.5 * sweeps().spiral_neutral_l_beta_factor, 1.0]);
    assert!(spiral.determinant < 0.0);
    assert_eq!(spiral.verdict, Stability::Stable);
    // Turned out of the wind so hard that two real roots grow: det A is positive again.
    let weathercock = lateral([1.0, -1.4]);
    assert!(weathercock.determinant > 0.0);
    assert_eq!(weathercock.verdict, Stability::Unstable);
    assert_eq!(lateral([-0.1, 1.0]).verdict, Stability::Unstable);
    assert_eq!(lateral([0.0, 1.0]).verdict, Stability::Neutral);
}

/// The number on screen is the slider's, whatever is folded into the matrix.
#[test]
fn stiffnesses_are_the_derivatives_where_there_are_any() {
    let navion = embedded_aircraft().0.into_iter().next().expect("the Navion");
    let mut scenario = Scenario::new(Arc::new(navion));
    let row = |key: &str| Parameter::find(key).expect("a row");
    row("cm_alpha").set(&mut scenario, -0.14);
    let stability = |scenario: &Scenario, plane: Plane| {
        let analysis = scenario.analyse().expect("an analysis");
        analysis.planes[plane].as_ref().expect("a plane").as_ref().expect("modes").static_stability
    };
    let pitch = |scenario: &Scenario| {
        let found = stability(scenario, Plane::Longitudinal);
        let PlaneStiffness::Longitudinal { m_w, .. } = found.stiffness else { panic!("pitch") };
        (m_w, found)
    };
    let (m_w, found) = pitch(&scenario);
    assert!((m_w.value - row("m_w").get(&scenario)).abs() < 1e-12);
    assert!(found.is_plain && m_w.value < 0.0 && m_w.verdict == Stability::Stable);
    // The entry of A has M_ẇ Z_w folded in, and another sign here.
    assert!(row("a_qw").get(&scenario) > 0.0);
    let PlaneStiffness::Lateral { n_v, l_v, .. } = stability(&scenario, Plane::Lateral).stiffness else {
        panic!("yaw and roll")
    };
    let sliders = ["n_v", "l_v"].map(|key| row(key).get(&scenario));
    assert!((n_v.value - sliders[0]).abs() < 1e-12 && (l_v.value - sliders[1]).abs() < 1e-12);
    // An entry that was edited belongs to no derivative.
    row("a_qw").set(&mut scenario, 0.01);
    let (m_w, found) = pitch(&scenario);
    // M_ẇ = A_qu/Z_u, as M_u of the Navion is zero: the stiffness is the entry without M_ẇ Z_w.
    let [m_u, z_u, z_w] = ["a_qu", "a_wu", "a_ww"].map(|key| row(key).get(&scenario));
    assert!(!found.is_plain && (m_w.value - (0.01 - m_u * z_w / z_u)).abs() < 1e-12, "{}", m_w.value);
    assert_eq!(m_w.verdict, Stability::Stable);
}

#[test]
fn static_stability_is_neither_needed_nor_enough_for_dynamic_stability() {
    // The lesson's printed matrix: det A = +18 and an oscillation that grows.
    let a = Matrix4::from_row_slice(&[
        -0.045, 0.036, 0.0, -9.81, -0.369, -2.02, 1.76, 0.0, 0.191, -3.96, -2.98, 0.0, 0.0, 0.0, 1.0, 0.0,
    ]);
    let found =
        plane_static_stability(&StabilityAxes::of(&PlaneModel { a, ..navion(Plane::Longitudinal) }), None);
    assert_eq!(found.verdict, Stability::Stable);
    let modes = modes_of(Plane::Longitudinal, &a).expect("modes");
    assert!(modes.iter().any(|mode| mode.stability == Stability::Unstable));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_number_is_ever_not_finite(entries in proptest::collection::vec(prop_oneof![Just(0.0), -10.0..10.0_f64, -1e75..1e75_f64], 16), lateral in any::<bool>()) {
        let mut model = navion(if lateral { Plane::Lateral } else { Plane::Longitudinal });
        model.a = Matrix4::from_row_slice(&entries);
        let found = plane_static_stability(&StabilityAxes::of(&model), None);
        prop_assert!(found.determinant.is_finite());
        match found.stiffness {
            PlaneStiffness::Longitudinal { m_w, to_manoeuvre_point } => prop_assert!(m_w.value.is_finite() && to_manoeuvre_point.is_none_or(f64::is_finite)),
            PlaneStiffness::Lateral { n_v, l_v, spiral } => prop_assert!([n_v, l_v, spiral].iter().all(|s| s.value.is_finite())),
        }
    }
}

/// Behind the neutral point the nose goes on up, whatever det A says: two real roots grow, and their product is positive.
#[test]
fn a_positive_determinant_is_not_static_stability() {
    for (key, parameter, value) in [("b747-cruise-etkin", "cg", 0.3), ("x15", "m_w", 0.019)] {
        let aircraft = embedded_aircraft().0.into_iter().find(|one| one.key == key).expect("it ships");
        let mut scenario = Scenario::new(Arc::new(aircraft));
        Parameter::find(parameter).expect("a row").set(&mut scenario, value);
        let analysis = scenario.analyse().expect("an analysis");
        let pitch = analysis.planes.longitudinal.as_ref().expect("data").as_ref().expect("modes");
        let found = pitch.static_stability;
        assert!(found.determinant > 0.0, "{key}");
        assert_eq!((found.verdict, found.of_determinant), (Stability::Unstable, Stability::Stable), "{key}");
        let sentence =
            eigenwing::words::stability::static_sentence(pitch, analysis.margins, scenario.convention());
        assert!(sentence.starts_with("Statically unstable in pitch: "), "{sentence}");
        assert!(sentence.contains("det A is positive since two real roots grow"), "{sentence}");
    }
}
