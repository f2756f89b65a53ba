//! The same responses as disturbances get small.

use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::motion::flight_path::Sample;
use eigenwing::flight::motion::inputs::Input;
use eigenwing::flight::motion::response::{DrivenSystem, TimeGrid, respond};
use eigenwing::flight::motion::six_dof::SixDof;
use nalgebra::Vector4;

use super::{Entry, GRID, edited, from_rest, gust_column, off, ready, studies};

impl Entry {
    /// The linear model's response to the same.
    fn respond(self, edited: &EditedModel, size: f64, grid: TimeGrid) -> Vec<Vector4<f64>> {
        let models = edited.models().expect("it flies");
        let model = models.planes[self.plane()].as_ref().expect("both planes");
        let column = match self {
            Self::Elevator | Self::Aileron => model.b.column(0).into_owned(),
            Self::Throttle | Self::Rudder => model.b.column(1).into_owned(),
            Self::RisingAir | Self::SideWind => gust_column(model),
        };
        let step = Input::Step { amplitude: size, start: 1.0 };
        respond(&DrivenSystem::from_rest(model.a, column, step), grid).states
    }

    /// Largest difference between both in all eight states, velocities over V. The linear model leaves the other plane at rest.
    fn difference(self, flight: &SixDof, edited: &EditedModel, size: f64) -> f64 {
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
    for (key, aircraft_model) in studies() {
        let Ok(flight) = SixDof::new(&EditedModel::new(aircraft_model)) else { continue };
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

#[test]
fn an_initial_displacement_is_that_of_the_linear_model() {
    let edited = edited("navion");
    let flight = ready(&edited);
    let (x, y) = ([1e-3, 2e-3, 1e-4, -1e-4], [3e-3, 1e-4, -2e-4, 3e-4]);
    let grid = TimeGrid { duration: 2.0, steps: 2 };
    let path = flight.fly(&off(x, y), grid);
    let models = edited.models().expect("it flies");
    for (k, sample) in path.samples.iter().enumerate() {
        let free = |model: &PlaneModel, x: [f64; 4]| (model.a * k as f64).exp() * Vector4::from(x);
        let want = free(models.planes.longitudinal.as_ref().expect("longitudinal"), x);
        assert!((sample.longitudinal - want).amax() < 1e-5, "{k}");
        let want = free(models.planes.lateral.as_ref().expect("lateral"), y);
        assert!((sample.lateral - want).amax() < 1e-5, "{k}");
    }
}
