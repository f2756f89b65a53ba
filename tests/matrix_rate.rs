//! The exact ∂A/∂p against differences, for every parameter of every aircraft and both planes.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::atmosphere::standard_air;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::aircraft::real::Dual64;
use eigenwing::flight::modes::sensitivity::entry_rate;
use eigenwing::scenario::parameters::Group;
use eigenwing::scenario::{Page, Parameter, Scenario, parameters};
use nalgebra::Matrix4;

const PLANES: [Plane; 2] = Plane::ALL;

fn find(key: &str) -> &'static Parameter {
    Parameter::find(key).expect("a row")
}

/// Every aircraft as its file has it, in both planes.
fn shipped() -> Vec<Scenario> {
    let scenarios = embedded_aircraft().0.into_iter().map(|aircraft| Scenario::new(Arc::new(aircraft)));
    scenarios.flat_map(|scenario| PLANES.map(|plane| Scenario { plane, ..scenario.clone() })).collect()
}

/// The same away from its reference: another flight, every knob turned, derivatives and entries edited.
fn moved(scenario: &Scenario) -> Scenario {
    let mut moved = scenario.clone();
    for (key, factor, more) in [
        ("altitude", 1.0, 650.0),
        ("speed", 1.08, 0.0),
        ("gamma", 1.0, 0.06),
        ("mass", 1.07, 0.0),
        ("ix", 1.1, 0.0),
        ("iy", 0.9, 0.0),
        ("iz", 1.2, 0.0),
        ("cg", 1.0, 0.05),
        ("tail", 1.3, 0.0),
        ("fin", 0.8, 0.0),
        ("dihedral", 1.0, 0.05),
        ("m_w", 1.1, 0.0),
        ("z_wdot", 1.3, 0.02),
        ("m_wdot", 1.2, 0.0),
        ("l_r", 0.9, 0.0),
        ("a_wq", 1.01, 0.0),
    ] {
        let p = find(key);
        let mut next = moved.clone();
        p.set(&mut next, factor * p.get(&moved) + more);
        // A flight beyond the data is left alone.
        if next.edited.models().is_ok() {
            moved = next;
        }
    }
    moved
}

fn rows(scenario: &Scenario) -> impl Iterator<Item = &'static Parameter> {
    parameters().filter(|p| p.applies(scenario))
}

/// A with the parameter moved by `change`, if it can be flown.
fn at(scenario: &Scenario, p: &Parameter, change: f64) -> Option<Matrix4<f64>> {
    let mut moved = scenario.clone();
    p.set(&mut moved, p.get(scenario) + change);
    Some(moved.edited.models().ok()?.planes[scenario.plane].as_ref()?.a)
}

/// Slope from five values, with an error of h⁴A⁽⁵⁾/30 between them and h⁴A⁽⁵⁾/5 at an end.
fn slope(scenario: &Scenario, p: &Parameter, h: f64) -> Option<Matrix4<f64>> {
    let a = |steps: f64| at(scenario, p, steps * h);
    // (A₋₂ − 8 A₋₁ + 8 A₁ − A₂)/12h
    let central = || Some((a(-2.0)? - a(2.0)? + (a(1.0)? - a(-1.0)?) * 8.0) / (12.0 * h));
    // (−25 A₀ + 48 A₁ − 36 A₂ + 16 A₃ − 3 A₄)/12h
    let ahead = |s: f64| {
        let sum =
            a(0.0)? * -25.0 + a(s)? * 48.0 - a(2.0 * s)? * 36.0 + a(3.0 * s)? * 16.0 - a(4.0 * s)? * 3.0;
        Some(sum / (12.0 * h * s))
    };
    central().or_else(|| ahead(1.0)).or_else(|| ahead(-1.0))
}

/// A of the studied plane, if the aircraft has it.
fn state_matrix(scenario: &Scenario) -> Option<Matrix4<f64>> {
    Some(scenario.edited.models().ok()?.planes[scenario.plane].as_ref()?.a)
}

fn length(scenario: &Scenario, p: &Parameter) -> f64 {
    let range = p.range(scenario);
    range.end() - range.start()
}

/// Asserts that two rates are the same but for a part of each entry's rate, or of the rate that takes the entry to zero along the
/// slider, and for 8 ε of the largest entry in the row over the step h, the rounding of A.
fn assert_same(
    scenario: &Scenario,
    p: &Parameter,
    exact: &Matrix4<f64>,
    slope: &Matrix4<f64>,
    part: f64,
    h: f64,
) {
    let a = state_matrix(scenario).expect("a model");
    for i in 0..4 {
        for j in 0..4 {
            let size = exact[(i, j)].abs().max(a[(i, j)].abs() / length(scenario, p));
            let allowed = part * size + 8.0 * f64::EPSILON * a.row(i).amax() / h;
            let difference = exact[(i, j)] - slope[(i, j)];
            let (key, plane) = (&scenario.aircraft.key, scenario.plane);
            assert!(difference.abs() <= allowed, "{key} {plane:?} {}: {exact} {slope}", p.key);
        }
    }
}

/// Step h of a thousandth of the slider: A follows powers of p from −3 to 2 and sines of small angles, which change over
/// no less than a third of the slider, so that h⁴A⁽⁵⁾/5 is some (3·10⁻³)⁴·5!/5 = 2·10⁻⁹ of the change along it.
#[test]
fn the_exact_rate_agrees_with_fourth_order_differences() {
    let mut compared = 0;
    for scenario in shipped().into_iter().flat_map(|scenario| [moved(&scenario), scenario]) {
        if state_matrix(&scenario).is_none() {
            continue;
        }
        for p in rows(&scenario) {
            let h = 1e-3 * length(&scenario, p);
            let exact = p.matrix_rate(&scenario.edited, scenario.plane).expect("a rate");
            let slope = slope(&scenario, p, h).expect("a difference");
            assert_same(&scenario, p, &exact, &slope, 2e-9, h);
            compared += 1;
        }
    }
    assert!(compared > 5000, "{compared}");
}

/// All but those that enter the denominator 1 − Zẇ; at the reference lift A is affine in the trim lift too.
#[test]
fn where_a_is_affine_the_rate_is_the_difference_quotient() {
    let mut compared = 0;
    let affine = |p: &&Parameter| !p.is_of_disturbance() && !["cl_alphadot", "z_wdot"].contains(&p.key);
    let coefficient_or_later =
        |p: &&Parameter| p.page != Some(Page::Coefficients) || p.group != Group::Aircraft;
    for scenario in shipped().iter().filter(|scenario| state_matrix(scenario).is_some()) {
        for p in rows(scenario).filter(affine).filter(coefficient_or_later) {
            let exact = p.matrix_rate(&scenario.edited, scenario.plane).expect("a rate");
            // a tenth of the slider: far beyond what any truncation would forgive
            let h = 0.05 * length(scenario, p);
            let (above, below) = (at(scenario, p, h), at(scenario, p, -h));
            let quotient = (above.expect("a model") - below.expect("a model")) / (2.0 * h);
            assert_same(scenario, p, &exact, &quotient, 1e-9, h);
            compared += 1;
        }
    }
    assert!(compared > 2000, "{compared}");
}

#[test]
fn an_entry_of_a_moves_itself_alone_and_inputs_move_nothing() {
    let mut entries = 0;
    for scenario in shipped().iter().filter(|scenario| state_matrix(scenario).is_some()) {
        for p in rows(scenario).filter(|p| matches!(p.page, Some(Page::Matrix) | None)) {
            let rate = p.matrix_rate(&scenario.edited, scenario.plane).expect("a rate");
            let is_entry = p.key.starts_with("a_") || p.key == "g";
            let unit = (0..16).map(|k| entry_rate(k / 4, k % 4)).find(|unit| *unit == rate || -*unit == rate);
            assert_eq!(unit.is_some(), is_entry && p.plane == Some(scenario.plane), "{}: {rate}", p.key);
            assert!(unit.is_some() || rate == Matrix4::zeros(), "{}: {rate}", p.key);
            entries += usize::from(unit.is_some());
        }
    }
    assert!(entries > 200, "{entries}");
}

/// There is no air below sea level in the standard atmosphere, and no flight below the stall: the rate needs no step outside.
#[test]
fn at_the_edge_of_what_can_be_flown_the_rate_is_that_of_the_side_inside() {
    let (altitude, speed) = (find("altitude"), find("speed"));
    let mut compared = 0;
    for scenario in shipped().iter().filter(|s| altitude.applies(s) && state_matrix(s).is_some()) {
        let mut low = scenario.clone();
        altitude.set(&mut low, 0.0);
        let (mut slow, mut slowest) = (0.0, speed.get(scenario));
        for _ in 0..60 {
            let middle = 0.5 * (slow + slowest);
            let flown = at(scenario, speed, middle - speed.get(scenario)).is_some();
            if flown { slowest = middle } else { slow = middle }
        }
        let mut stalling = scenario.clone();
        speed.set(&mut stalling, slowest);
        for (edge, p) in [(low, altitude), (stalling, speed)] {
            // the induced drag's V⁻³ is steep at the stall: a smaller step
            let h = 3e-4 * length(&edge, p);
            if state_matrix(&edge).is_none() {
                continue;
            }
            assert_eq!(at(&edge, p, -h), None);
            let (exact, slope) = (p.matrix_rate(&edge.edited, edge.plane), slope(&edge, p, h));
            assert_same(&edge, p, &exact.expect("a rate"), &slope.expect("a difference"), 2e-9, h);
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared}");
}

#[test]
fn a_knob_that_cannot_be_turned_has_no_rate() {
    let mut navion = shipped().remove(0);
    let AircraftModel::Coefficients(aircraft_model) = &mut navion.edited.aircraft_model else {
        panic!("the Navion has coefficients")
    };
    (aircraft_model.airframe.tail, aircraft_model.airframe.fin, aircraft_model.airframe.taper) =
        (None, None, None);
    for key in ["tail", "fin", "dihedral"] {
        assert_eq!(find(key).matrix_rate(&navion.edited, navion.plane), None, "{key}");
    }
    assert!(find("cg").matrix_rate(&navion.edited, navion.plane).is_some());
}

/// dp/dh = −ρ g, at the kink of the temperature too; there the rate is that of the side above.
#[test]
fn pressure_falls_by_the_weight_of_the_air() {
    for altitude in [0.0, 1_000.0, 10_999.0, 11_000.0, 11_001.0, 20_000.0] {
        let air = standard_air(Dual64::new(altitude, 1.0)).expect("inside the atmosphere");
        let weight = air.density.re * 9.80665;
        assert!((air.pressure.eps + weight).abs() <= 1e-14 * weight, "{altitude}: {}", air.pressure);
        assert_eq!(air.temperature.eps, if altitude < 11_000.0 { -0.0065 } else { 0.0 });
    }
}
