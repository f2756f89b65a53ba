//! One test a sign, over every aircraft that ships.

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::flight::aircraft::axes::StabilityAxes;
use eigenwing::flight::aircraft::plane::PlaneModel;
use eigenwing::flight::aircraft::study::Study;

fn models() -> Vec<(String, PlaneModel, Option<PlaneModel>)> {
    let (aircraft, _) = embedded_aircraft();
    let of = |one: Aircraft| {
        let models = one.study.models().expect("it has a steady flight");
        (one.key, models.planes.longitudinal.expect("longitudinal"), models.planes.lateral)
    };
    aircraft.into_iter().map(of).collect()
}

fn lateral() -> Vec<(String, PlaneModel)> {
    models().into_iter().filter_map(|(key, _, lateral)| Some((key, lateral?))).collect()
}

#[test]
fn trailing_edge_down_pitches_the_nose_down_and_lifts() {
    for (key, model, _) in models() {
        assert!(model.b[(2, 0)] < 0.0, "{key}: M_δe");
        // the F.2B's report gives Z_δe as 0
        assert!(model.b[(1, 0)] < 0.0 || key == "bristol-f2b", "{key}: Z_δe");
    }
}

#[test]
fn more_throttle_pushes_forward() {
    for (key, model, _) in models().into_iter().filter(|(key, ..)| !key.starts_with("lesson")) {
        assert!(model.b[(0, 1)] > 0.0, "{key}: X_δt");
    }
}

#[test]
fn faster_brakes_along_the_flight_path() {
    for (key, model, _) in models() {
        // in body axes the 747's Xu at Mach 0.7 is positive: part of its Zu
        assert!(StabilityAxes::of(&model).model().a[(0, 0)] < 0.0, "{key}: Xu");
    }
}

#[test]
fn pitch_rate_and_heave_are_damped() {
    for (key, model, _) in models() {
        assert!(model.a[(2, 2)] < 0.0 && model.a[(1, 1)] < 0.0, "{key}: Mq and Zw");
    }
}

#[test]
fn nose_up_turns_gravity_backward() {
    for (key, model, _) in models() {
        assert!(model.a[(0, 3)] < 0.0, "{key}: −g cos θ₀");
    }
}

#[test]
fn rudder_trailing_edge_left_pushes_right_and_turns_the_nose_left() {
    for (key, model) in lateral() {
        assert!(model.b[(2, 1)] < 0.0 || key == "bristol-f2b", "{key}: N_δr");
        assert!(model.b[(0, 1)] >= 0.0, "{key}: Y_δr");
    }
}

/// The F.2B's report counts its rudder the other way.
#[test]
fn the_f2bs_rudder_turns_the_nose_right() {
    let f2b = lateral().into_iter().find(|(key, _)| key == "bristol-f2b").expect("it ships").1;
    assert!(f2b.b[(2, 1)] > 0.0);
}

#[test]
fn positive_aileron_rolls_right_but_in_two_sources() {
    for (key, model) in lateral() {
        let rolls_left = key == "b747-cruise-etkin" || key == "citation";
        assert_eq!(model.b[(1, 0)] < 0.0, rolls_left, "{key}: L_δa");
    }
}

#[test]
fn wind_from_the_right_rolls_left_turns_right_and_pushes_left() {
    for (key, model) in lateral() {
        let [y_v, l_v, n_v] = [0, 1, 2].map(|i| model.a[(i, 0)]);
        assert!(y_v < 0.0 && l_v < 0.0 && n_v > 0.0, "{key}");
    }
}

#[test]
fn roll_and_yaw_are_damped() {
    for (key, model) in lateral() {
        assert!(model.a[(1, 1)] < 0.0 && model.a[(2, 2)] < 0.0, "{key}");
    }
}

#[test]
fn right_wing_down_falls_to_the_right() {
    for (key, model) in lateral() {
        assert!(model.a[(0, 3)] > 0.0, "{key}: g cos θ₀");
    }
}

#[test]
fn body_axes_have_w0_terms_and_stability_axes_none() {
    let (aircraft, _) = embedded_aircraft();
    for one in aircraft {
        let model = one.study.models().expect("it flies").planes.longitudinal.expect("longitudinal");
        let w0 = model.trim.w0();
        assert_eq!(model.a[(0, 2)], -w0 + 0.0, "{}", one.key);
        assert!(w0 == 0.0 || matches!(one.study, Study::Derivatives(_)), "{}", one.key);
    }
}
