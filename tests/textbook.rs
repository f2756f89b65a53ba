//! Published modes of every aircraft, each with its source in the aircraft's file (validation).

use eigenwing::content::aircraft::{Comparison, compare};
use eigenwing::content::{Aircraft, Status, embedded_aircraft};
use eigenwing::flight::plane::{Plane, PlaneModel};

fn all() -> Vec<Aircraft> {
    let (aircraft, errors) = embedded_aircraft();
    assert!(errors.is_empty(), "{}", errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"));
    aircraft
}

#[test]
fn published() {
    for a in all() {
        let m = a.study.models().unwrap();
        for (p, m) in [(Plane::Longitudinal, m.longitudinal), (Plane::Lateral, m.lateral)] {
            let (Some(n), Some(m)) = (a.notes_of(p), m) else { continue };
            for c in compare(&m, &n.published).unwrap() {
                println!("{:20} {:14} {:12} {:12.6} {:12.6?} {:8.3} {}", a.key, c.published.mode.name(), c.published.quantity.symbol(), c.published.value, c.computed, 100.*c.relative_error().unwrap_or(f64::NAN), if c.is_reproduced() {""} else {"  <-----"});
            }
        }
    }
}
