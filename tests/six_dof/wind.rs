//! Galileo's principle: a wind that is the same everywhere and for ever moves the aircraft as if it had been let go in still air with
//! the velocity that it has through this wind.

use eigenwing::flight::motion::response::TimeGrid;
use eigenwing::flight::motion::six_dof::{SixDof, Wind};

use super::{Excitation, from_rest, off, ready, studies};
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::edits::EditedModel;

/// Everything that is felt of the air, and the attitude, to the integrator's 10⁻⁹ a step.
fn assert_alike(key: &str, flight: &SixDof, wind: [f64; 3]) {
    let grid = TimeGrid { duration: 15.0, steps: 60 };
    let [along, aside, down] = wind;
    let (sin, cos) = flight.trim.alpha0.sin_cos();
    // The air goes one way, the aircraft through it the other.
    let (u, w) = (-(along * cos - down * sin), -(along * sin + down * cos));
    let blowing = |_: f64| Wind { velocity: wind, ..Wind::default() };
    let windy = flight.fly(&Excitation { wind: &blowing, ..from_rest() }, grid);
    let still = flight.fly(&off([u, w, 0.0, 0.0], [-aside, 0.0, 0.0, 0.0]), grid);
    assert_eq!(windy.samples.len(), still.samples.len(), "{key}: {:?} {:?}", windy.stop, still.stop);
    assert!(windy.samples.len() > 4, "{key} in {wind:?}: {:?}", windy.stop);
    for (k, (a, b)) in windy.samples.iter().zip(&still.samples).enumerate() {
        let rates =
            [a.longitudinal[2] - b.longitudinal[2], a.lateral[1] - b.lateral[1], a.lateral[2] - b.lateral[2]];
        let felt = [a.alpha - b.alpha, a.beta - b.beta, a.n_z - b.n_z, a.n_y - b.n_y];
        let nose = [0, 1, 2]
            .map(|i| a.attitude.to_earth([1.0, 0.0, 0.0])[i] - b.attitude.to_earth([1.0, 0.0, 0.0])[i]);
        let speed = [(a.airspeed - b.airspeed) / flight.trim.speed];
        let off = rates.iter().chain(&felt).chain(&nose).chain(&speed).fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(off < 1e-6, "{key} in {wind:?}, sample {k}: {off:e}");
        // Over the ground one has been carried along.
        let t = grid.time(k);
        let (sin, cos) = flight.trim.gamma0.sin_cos();
        let carried = [along * cos + down * sin, aside, along * sin - down * cos];
        let path = [0, 1, 2].map(|i| (a.position[i] - b.position[i] - carried[i] * t).abs());
        assert!(path.iter().all(|x| *x < 1e-4), "{key} in {wind:?}, sample {k}: {path:?}");
    }
}

#[test]
fn a_steady_wind_is_a_release_in_still_air_at_any_size() {
    let mut flown = 0;
    for (key, aircraft_model) in studies() {
        let lateral = match &aircraft_model {
            AircraftModel::Coefficients(aircraft_model) => aircraft_model.coefficients.lateral.is_some(),
            AircraftModel::Derivatives(aircraft_model) => aircraft_model.lateral.is_some(),
            AircraftModel::Matrices(_) => continue,
        };
        let flight = ready(&EditedModel::new(aircraft_model));
        let v = flight.trim.speed;
        for share in [0.01, 0.03] {
            assert_alike(&key, &flight, [-share * v, 0.0, 0.0]);
            assert_alike(&key, &flight, [0.0, 0.0, -share * v]);
            if lateral {
                assert_alike(&key, &flight, [share * v, share * v, 0.5 * share * v]);
            }
        }
        flown += 1;
    }
    assert!(flown >= 15, "{flown} aircraft");
}

/// Fifteen and twenty metres a second, a third of the Navion's speed, with lift by the rate of α as well.
#[test]
fn so_does_a_strong_wind_with_lift_by_the_rate_of_the_angle_of_attack() {
    let mut navion = super::edited("navion");
    let AircraftModel::Coefficients(aircraft_model) = &mut navion.aircraft_model else {
        panic!("it starts from coefficients")
    };
    aircraft_model.coefficients.longitudinal.cl_alphadot = 3.0;
    let flight = ready(&navion);
    for wind in [[-15.0, 0.0, 0.0], [-20.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, -8.0, 2.0]] {
        assert_alike("navion", &flight, wind);
    }
}
