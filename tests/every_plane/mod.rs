//! Every aircraft in each plane of motion.

use std::sync::Arc;

use eigenwing::content::embedded_aircraft;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::Scenario;

/// Every aircraft as it opens, in each plane that it has data of.
pub fn scenarios() -> Vec<Scenario> {
    let aircraft = embedded_aircraft().0.into_iter().map(Arc::new);
    let in_planes = aircraft.flat_map(|aircraft| {
        let of = |plane: Plane| Scenario { plane, ..Scenario::new(aircraft.clone()) };
        let has = |plane: &Plane| aircraft.plane_notes[*plane].is_some();
        Plane::ALL.into_iter().filter(has).map(of).collect::<Vec<_>>()
    });
    in_planes.collect()
}
