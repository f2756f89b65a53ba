//! Nonlinear flight in six degrees of freedom beside the linear model, in one program: what its parts share is here.

mod derivative;
mod ends;
mod small;
mod wind;

use std::sync::LazyLock;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::aircraft_model::AircraftModel;
use eigenwing::flight::aircraft::edits::EditedModel;
use eigenwing::flight::aircraft::plane::{Plane, PlaneModel};
use eigenwing::flight::motion::aerodynamics::Controls;
use eigenwing::flight::motion::flight_path::{Excitation, FlightPath};
use eigenwing::flight::motion::gusts::air_across;
use eigenwing::flight::motion::response::TimeGrid;
use eigenwing::flight::motion::six_dof::{SixDof, Wind};
use nalgebra::Vector4;

fn studies() -> Vec<(String, AircraftModel)> {
    static READ: LazyLock<Vec<(String, AircraftModel)>> = LazyLock::new(|| {
        embedded_aircraft().0.into_iter().map(|one| (one.key, one.aircraft_model)).collect()
    });
    READ.clone()
}

fn edited(key: &str) -> EditedModel {
    EditedModel::new(studies().into_iter().find(|(name, _)| name == key).expect("the aircraft ships").1)
}

fn ready(edited: &EditedModel) -> SixDof {
    SixDof::new(edited).expect("it flies")
}

/// Column by which the cross gust enters the linear model.
fn gust_column(model: &PlaneModel) -> Vector4<f64> {
    -(model.a * air_across(model.plane, model.trim.alpha0))
}

const GRID: TimeGrid = TimeGrid { duration: 12.0, steps: 120 };

fn still(_: f64) -> Controls {
    Controls::default()
}

fn calm(_: f64) -> Wind {
    Wind::default()
}

fn from_rest<'a>() -> Excitation<'a> {
    Excitation {
        controls: &still,
        wind: &calm,
        edges: &[],
        longitudinal: Vector4::zeros(),
        lateral: Vector4::zeros(),
        heading: 0.0,
        position: [0.0; 3],
        servos: None,
    }
}

/// Where a step enters, with its full size.
#[derive(Clone, Copy, Debug)]
enum Entry {
    Elevator,
    Throttle,
    Aileron,
    Rudder,
    RisingAir,
    SideWind,
}

impl Entry {
    const ALL: [Self; 6] =
        [Self::Elevator, Self::Throttle, Self::Aileron, Self::Rudder, Self::RisingAir, Self::SideWind];

    fn plane(self) -> Plane {
        match self {
            Self::Elevator | Self::Throttle | Self::RisingAir => Plane::Longitudinal,
            Self::Aileron | Self::Rudder | Self::SideWind => Plane::Lateral,
        }
    }

    fn fly(self, flight: &SixDof, size: f64, grid: TimeGrid) -> FlightPath {
        let on = |t: f64| if t >= 1.0 { size } else { 0.0 };
        let controls = |t: f64| {
            let mut controls = Controls::default();
            match self {
                Self::Elevator => controls.elevator = on(t),
                Self::Throttle => controls.throttle = on(t),
                Self::Aileron => controls.aileron = on(t),
                Self::Rudder => controls.rudder = on(t),
                Self::RisingAir | Self::SideWind => {}
            }
            controls
        };
        let wind = |t: f64| match self {
            Self::RisingAir => Wind { velocity: [0.0, 0.0, on(t)], ..Wind::default() },
            Self::SideWind => Wind { velocity: [0.0, on(t), 0.0], ..Wind::default() },
            _ => Wind::default(),
        };
        flight.fly(&Excitation { controls: &controls, wind: &wind, edges: &[1.0], ..from_rest() }, grid)
    }
}

/// Off the trim by \[u, w, q, θ\] and \[v, p, r, φ\].
fn off<'a>(longitudinal: [f64; 4], lateral: [f64; 4]) -> Excitation<'a> {
    Excitation { longitudinal: longitudinal.into(), lateral: lateral.into(), ..from_rest() }
}
