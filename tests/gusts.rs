//! How the air's motion enters, against columns worked out apart from ours (`scripts/response_golden.py`) and against geometry.

use std::collections::BTreeMap;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::edits::Edited;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::motion::gusts::{air_across, penetration_column};
use nalgebra::Vector4;
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    models: Vec<Model>,
}

#[derive(Deserialize)]
struct Model {
    id: String,
    plane: String,
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
        let edited = Edited::new(found.study.clone());
        let derivatives = edited.derivatives().expect("a trim").expect("derivatives");
        for (plane, word, column) in
            [(Plane::Longitudinal, "longitudinal", "w_g"), (Plane::Lateral, "lateral", "v_g")]
        {
            let model = file.models.iter().find(|model| model.id == id && model.plane == word);
            let want: Vector4<f64> = model.expect("a model").rate_columns[column].into();
            let got = penetration_column(plane, Some(&derivatives));
            // By matrices, U₀ of the source against V of ours leaves a rest in the force that no moment feels.
            for row in [1, 2].into_iter().skip(usize::from(plane == Plane::Longitudinal)) {
                let off = (got[row] - want[row]).abs();
                assert!(off < 2e-3 * want.amax(), "{key} {word} row {row}: {got} should be {want}");
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
        Edited::new(found.study.clone()).derivatives().expect("a trim").expect("derivatives");
    let longitudinal = derivatives.longitudinal.as_mut().expect("data");
    (longitudinal.m_wdot, longitudinal.z_wdot) = (0.0, 0.0);
    let rising = -1.0; // ẇ_g, z points down
    let column = penetration_column(Plane::Longitudinal, Some(&derivatives));
    assert!(column[2] * rising > 0.0);
    assert_eq!(air_across(Plane::Longitudinal), Vector4::new(0.0, 1.0, 0.0, 0.0));
}
