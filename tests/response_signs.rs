//! One sign a test: what a pilot would feel.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::states::Longitudinal;
use eigenwing::scenario::{Choice, START, Scenario, Shape, Source};
use nalgebra::Vector4;

fn step_of(source: Source) -> Choice {
    Choice { source, control_shape: Shape::Step, gust_shape: Shape::Step, mode: 0 }
}

/// The Navion's state a tenth of a second into a disturbance, when only the first push is felt.
fn first_push(source: Source) -> Vector4<f64> {
    let (aircraft, _) = embedded_aircraft();
    let mut scenario = Scenario::new(Arc::new(aircraft.into_iter().next().expect("an aircraft")));
    scenario.disturbance.choices.longitudinal = step_of(source);
    scenario.disturbance.sizes.time = 12.0;
    let response = scenario.analyse().expect("an analysis").motion.expect("a motion").response;
    response.states[((START + 0.1) / response.dt).round() as usize]
}

#[test]
fn trailing_edge_down_lowers_the_nose() {
    let x = first_push(Source::Elevator);
    assert!(x[Longitudinal::Q.index()] < 0.0 && x[Longitudinal::Theta.index()] < 0.0);
}

#[test]
fn rising_air_lifts_the_aircraft_and_a_stable_one_noses_down_into_it() {
    let x = first_push(Source::VerticalGust);
    // z points down: rising is w < 0.
    assert!(x[Longitudinal::W.index()] < 0.0);
    assert!(x[Longitudinal::Q.index()] < 0.0);
}

/// A gust that lasts is the same as flying with w = −w_g: when all has settled the aircraft moves with the air.
#[test]
fn in_steadily_rising_air_the_aircraft_ends_up_rising_with_it() {
    let (aircraft, _) = embedded_aircraft();
    let mut scenario = Scenario::new(Arc::new(aircraft.into_iter().next().expect("an aircraft")));
    scenario.disturbance.choices.longitudinal = step_of(Source::VerticalGust);
    scenario.disturbance.sizes.time = 300.0;
    let response = scenario.analyse().expect("an analysis").motion.expect("a motion").response;
    let end = response.states.last().expect("samples");
    let w_gust = -scenario.disturbance.sizes.vertical_gust;
    // The phugoid has halved 7 times.
    assert!((end[Longitudinal::W.index()] - w_gust).abs() < 0.02 * w_gust.abs(), "{end}");
}
