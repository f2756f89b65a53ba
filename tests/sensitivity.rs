//! Exact sensitivities against central differences, on every reference aircraft and every entry of A.

mod reference;

use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode::{Mode, modes_of};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::flight::modes::sensitivity::{REPEATED_CONDITION, Rate, Sensitivity, entry_rate, sensitivity};
use nalgebra::{Complex, Matrix4};
use proptest::prelude::*;
use reference::{all_models, navion_with_m_w, reference};

fn modes(plane: Plane, a: &Matrix4<f64>) -> Vec<Mode> {
    modes_of(plane, a).expect("a finite matrix has modes")
}

fn rate(answer: Sensitivity) -> Rate {
    answer.rate().expect("a simple root")
}

fn entry_sensitivity(mode: &Mode, row: usize, column: usize) -> Sensitivity {
    sensitivity(mode, &entry_rate(row, column))
}

fn near(a: &Matrix4<f64>, plane: Plane, lambda: Complex<f64>) -> Complex<f64> {
    let distance = |mode: &&Mode| (mode.lambda - lambda).norm();
    let all = modes(plane, a);
    all.iter().min_by(|x, y| distance(x).total_cmp(&distance(y))).expect("modes").lambda
}

/// Fourth-order central differences with a step h that moves the fastest root by 10⁻³ of the gap to its neighbour.
///
/// λ is analytic up to where it meets a neighbour, about gap/|dλ/da| away, so the truncation is some (10⁻³)⁴ of the fastest
/// rate, with a constant of up to 10⁴ where modes are coupled. Each computed λ carries some 10 ε ρ κ, divided by h.
#[test]
fn every_entry_of_every_reference_aircraft_agrees_with_central_differences() {
    let mut compared = 0;
    for (id, model) in all_models() {
        let all = modes(model.plane, &model.a);
        let poles: Vec<Complex<f64>> = all.iter().flat_map(|m| [m.lambda, m.lambda.conj()]).collect();
        let radius = poles.iter().map(|pole| pole.norm()).fold(0.0, f64::max);
        for mode in &all {
            let gap = poles
                .iter()
                .map(|pole| (pole - mode.lambda).norm())
                .filter(|&gap| gap > 0.0)
                .fold(f64::INFINITY, f64::min);
            for i in 0..4 {
                for j in 0..4 {
                    let exact = rate(entry_sensitivity(mode, i, j)).lambda;
                    // The largest rate of any root with this entry says how large a change is small for all of them.
                    let fastest = all
                        .iter()
                        .map(|m| rate(entry_sensitivity(m, i, j)).lambda.norm())
                        .fold(0.0, f64::max);
                    let h = 1e-3 * gap / fastest;
                    let at = |step: f64| near(&(model.a + entry_rate(i, j) * step), model.plane, mode.lambda);
                    let (one, two) = (at(h) - at(-h), at(2.0 * h) - at(-2.0 * h));
                    let difference = (one * 8.0 - two) / (12.0 * h);
                    let error = (exact - difference).norm();
                    let allowed = 1e-8 * fastest + 10.0 * f64::EPSILON * radius * mode.condition / h;
                    assert!(
                        error <= allowed,
                        "{id}, {:?}, entry {i}{j}: {exact}, {difference}",
                        mode.naming.name
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000);
}

#[test]
fn frequency_and_damping_rates_agree_with_central_differences() {
    for (id, model) in all_models() {
        for mode in modes(model.plane, &model.a).iter().filter(|mode| mode.is_oscillatory()) {
            let da = model.a.map(|x| x * 0.37) - Matrix4::identity() * 0.11;
            let h = 1e-5;
            let [above, below] = [h, -h].map(|h| near(&(model.a + da * h), model.plane, mode.lambda));
            let rate = rate(sensitivity(mode, &da));
            let zeta = |l: Complex<f64>| -l.re / l.norm();
            let wn_rate = (above.norm() - below.norm()) / (2.0 * h);
            let zeta_rate = (zeta(above) - zeta(below)) / (2.0 * h);
            // h² of truncation, ε/h of rounding, each with the size of the other modes beside this one
            assert!((rate.natural_frequency.expect("ωₙ") - wn_rate).abs() < 1e-7, "{id} ωₙ");
            assert!((rate.damping_ratio.expect("ζ") - zeta_rate).abs() < 1e-6, "{id} ζ");
        }
    }
}

#[test]
fn sensitivities_to_the_diagonal_add_up_to_one() {
    // A + tI moves every root by t.
    for (id, model) in all_models() {
        for mode in modes(model.plane, &model.a) {
            let rate = rate(sensitivity(&mode, &Matrix4::identity())).lambda;
            assert!((rate - Complex::from(1.0)).norm() < 1e-10, "{id}: {rate}");
        }
    }
}

#[test]
fn ten_per_cent_of_m_w_moves_the_short_period_as_the_locus_does() {
    let model = reference("navion_teper_sl").model(Plane::Longitudinal);
    let m_w = reference::NAVION_M_W;
    let mode = &modes(model.plane, &model.a)[0];
    let rate = rate(entry_sensitivity(mode, 2, 1));
    let step = rate.lambda * (0.1 * m_w);
    let moved = near(&navion_with_m_w(1.1), model.plane, mode.lambda) - mode.lambda;
    // ω² is nearly linear in M_w, by 13 % here: the second order of the square root is a quarter of that.
    assert!((step - moved).norm() < 0.04 * moved.norm(), "{step} {moved}");
    // M_w is negative, and more of it stiffens and leaves less damping for its frequency.
    assert!(rate.natural_frequency.expect("ωₙ") < 0.0 && rate.damping_ratio.expect("ζ") > 0.0);
}

#[test]
fn where_roots_meet_there_is_no_number_but_a_condition() {
    // Bisect to where the Navion's short period becomes two roots.
    let pairs = |factor: f64| {
        let all = modes(Plane::Longitudinal, &navion_with_m_w(factor));
        all.iter().filter(|mode| mode.is_oscillatory()).count()
    };
    let (mut one, mut two) = (0.2, 0.3);
    for _ in 0..60 {
        let middle = 0.5 * (one + two);
        if pairs(middle) == 1 { one = middle } else { two = middle }
    }
    let all = modes(Plane::Longitudinal, &navion_with_m_w(two));
    let short_period = &all[0];
    assert_eq!(short_period.naming.name, ModeName::ShortPeriod);
    let Sensitivity::Repeated { condition } = entry_sensitivity(short_period, 2, 1) else {
        panic!("a repeated root has no rate")
    };
    assert!(condition > 1e6);
    // The phugoid is far away and has its rate.
    assert!(entry_sensitivity(&all[1], 2, 1).rate().is_some());
}

#[test]
fn equal_roots_with_independent_vectors_are_repeated_too() {
    let all = modes(Plane::Lateral, &Matrix4::from_diagonal(&[-1.0, -1.0, -2.0, -3.0].into()));
    let repeated = |m: &&Mode| matches!(entry_sensitivity(m, 0, 0), Sensitivity::Repeated { .. });
    assert_eq!(all.iter().filter(repeated).count(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_number_is_ever_not_finite(entries in proptest::collection::vec(prop_oneof![Just(0.0), Just(1.0), -10.0..10.0_f64, -1e200..1e200_f64], 16), da in proptest::collection::vec(any::<f64>(), 16)) {
        let Ok(all) = modes_of(Plane::Lateral, &Matrix4::from_row_slice(&entries)) else { return Ok(()) };
        for mode in all {
            match sensitivity(&mode, &Matrix4::from_row_slice(&da)) {
                Sensitivity::Simple(rate) => {
                    prop_assert!(mode.condition <= REPEATED_CONDITION);
                    prop_assert!(rate.sigma().is_finite() && rate.omega().is_finite());
                    prop_assert!(rate.natural_frequency.is_none_or(f64::is_finite));
                    prop_assert!(rate.damping_ratio.is_none_or(f64::is_finite));
                }
                Sensitivity::Repeated { condition } => prop_assert!(condition.is_finite() && condition > REPEATED_CONDITION),
                Sensitivity::NotFinite => {}
            }
        }
    }
}
