//! The map of the damping over gain and washout that was found last.

use std::rc::Rc;

use crate::flight::aircraft::plane::PlaneModel;
use crate::flight::feedback::damping_map::{DampingMap, Fineness};
use crate::flight::feedback::law::RATE;
use crate::scenario::{Disturbance, Scenario};

/// The finest map, and the one for while something is dragged.
const FINENESS: [Fineness; 2] = [(32, 20), (12, 8)];

/// The map found last.
#[derive(Clone, Debug)]
pub(super) struct KnownMap {
    /// The scenario without the gain and the washout.
    start: Scenario,
    input: usize,
    reach: f64,
    fineness: Fineness,
    map: Option<Rc<DampingMap>>,
}

/// The map for gains of the rate to an input from zero to `reach`: the one found last where that is the same. It depends on neither the
/// gain nor the washout.
pub(super) fn known_or_found(
    known: &mut Option<KnownMap>,
    (scenario, model): (&Scenario, &PlaneModel),
    (input, reach): (usize, f64),
    is_coarse: bool,
) -> Option<Rc<DampingMap>> {
    let mut start = scenario.clone();
    let of_plane = &mut start.law.planes[start.plane];
    of_plane.washout = 0.0;
    if input == 0 {
        of_plane.to_first[RATE] = 0.0
    } else {
        of_plane.to_second[RATE] = 0.0
    }
    start.disturbance = Disturbance::default();
    let fineness = FINENESS[usize::from(is_coarse)];
    let same = known.as_ref().filter(|known| {
        (known.input, known.reach) == (input, reach) && known.fineness.0 >= fineness.0 && known.start == start
    });
    if let Some(known) = same {
        return known.map.clone();
    }
    let map = DampingMap::of(model, &start.law, (input, reach), fineness).map(Rc::new);
    *known = Some(KnownMap { start, input, reach, fineness, map: map.clone() });
    map
}

/// Judges one washout more, where the aircraft has a class; whether there was one to judge.
pub(super) fn judge(known: &mut Option<KnownMap>, model: &PlaneModel) -> bool {
    let Some(KnownMap { start, input, map: Some(map), .. }) = known else { return false };
    let Some(task) = start.task else { return false };
    map.levels.len() < map.places.len() && Rc::make_mut(map).judge(model, &start.law, *input, task)
}
