//! Links opened on the aircraft that ship.

use std::sync::{Arc, LazyLock};

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::scenario::link::{self, Opened};
use eigenwing::scenario::parameters;

/// The aircraft that ship.
pub static AIRCRAFT: LazyLock<Vec<Arc<Aircraft>>> =
    LazyLock::new(|| embedded_aircraft().0.into_iter().map(Arc::new).collect());

/// A link, opened.
pub fn open(link: &str) -> Opened {
    link::read(link, &AIRCRAFT).expect("there are aircraft")
}

/// Finite, within what may be typed, and itself a scene that a link carries without loss.
pub fn assert_sound(opened: &Opened, link: &str) {
    for scenario in [Some(&opened.scenario), opened.pinned.as_ref()].into_iter().flatten() {
        for p in parameters() {
            let value = p.added(scenario).unwrap_or_else(|| p.get(scenario));
            assert!(value.is_finite(), "{} = {value} from {link}", p.key);
        }
    }
    for notice in &opened.notices {
        let sentence = notice.to_string();
        assert!(sentence.ends_with('.') && sentence.chars().count() < 250, "{sentence}");
    }
    let again = open(&link::write(&opened.scenario, &opened.view, opened.pinned.as_ref()));
    assert_eq!((&again.scenario, &again.view), (&opened.scenario, &opened.view), "{link}");
    assert_eq!(again.pinned, opened.pinned, "{link}");
    assert_eq!(again.notices, [], "{link}");
}
