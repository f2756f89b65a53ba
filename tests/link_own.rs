//! A person's own aircraft in a link: it travels whole, comes back to the last bit, and is short.

use std::sync::Arc;

use eigenwing::content::import::review::Review;
use eigenwing::content::import::{FileBytes, review};
use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::scenario::link::{self, HandedIn, LONGEST, LessonPlace, Notice, Opened};
use eigenwing::scenario::{Dimension, Parameter, Scenario, View, parameters};
use proptest::prelude::*;

fn all() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn reopened(text: &str) -> Opened {
    link::read(text, &all()).expect("there are aircraft")
}

/// Files under tests/data/import, with everything taken that is suggested.
fn open(names: &[&str]) -> Review {
    let path = |name: &&str| format!("{}/tests/data/import/{name}", env!("CARGO_MANIFEST_DIR"));
    let contents: Vec<Vec<u8>> =
        names.iter().map(|name| std::fs::read(path(name)).expect("it is there")).collect();
    let files: Vec<FileBytes<'_>> =
        names.iter().zip(&contents).map(|(name, bytes)| FileBytes { name, bytes }).collect();
    review(&files, &[("all".to_owned(), "suggested".to_owned())].into()).expect("it is read")
}

fn scenario(files: &[&str]) -> Scenario {
    Scenario::new(Arc::new(open(files).aircraft().expect("it says enough")))
}

/// Matrices of one plane and of both, derivatives, coefficients; with the lengths that they may have.
#[test]
fn an_own_aircraft_comes_back_from_its_link_to_the_last_bit_with_its_edits() {
    for (files, most, edited) in [
        (&["12-vant-consistent.csv"][..], 1000, "a_pp"),
        (&["03-boyd747-crad.m"], 1400, "a_ww"),
        (&["navion.py"], 1000, "a_ww"),
        (&["navion-linearisation.json"], 2000, "a_ww"),
        (&["navion-xflr5.txt"], 2000, "m_q"),
        (&["navion.st", "navion.mass"], 2000, "cm_q"),
    ] {
        let mut scenario = scenario(files);
        let parameter = Parameter::find(edited).expect("a parameter");
        let value = 0.9 * parameter.get(&scenario);
        parameter.set(&mut scenario, value);
        let text = link::write(&scenario, &View::of(&scenario), None);
        assert!(text.len() < most, "{files:?}: {} characters", text.len());
        assert!(!text.ends_with(['-', '.', ')', '_']), "{text}");
        let opened = reopened(&text);
        assert_eq!(opened.notices, [], "{files:?}");
        assert_eq!(opened.scenario.aircraft.aircraft_model, scenario.aircraft.aircraft_model, "{files:?}");
        assert_eq!(opened.scenario.edited, scenario.edited, "{files:?}");
        assert_eq!(link::write(&opened.scenario, &opened.view, None), text, "{files:?}");
    }
}

#[test]
fn a_pinned_state_of_the_same_aircraft_carries_it_once_and_another_one_travels_beside_it() {
    let (scene, other) = (scenario(&["navion.py"]), scenario(&["07-boeing747-four.m"]));
    let view = View::of(&scene);
    let same = link::write(&scene, &view, Some(&scene));
    assert_eq!((same.matches("own=").count(), same.matches("pin.own=").count()), (1, 0));
    assert_eq!(
        reopened(&same).pinned.map(|pinned| pinned.aircraft),
        Some(scene.aircraft.clone()).map(|aircraft| {
            // The file's name is not in the link, and in nothing that is computed.
            Arc::new((*aircraft).clone())
        })
    );
    let both = link::write(&scene, &view, Some(&other));
    let opened = reopened(&both);
    assert_eq!(opened.notices, []);
    assert_eq!(opened.pinned.expect("it is pinned").aircraft.aircraft_model, other.aircraft.aircraft_model);
}

#[test]
fn a_damaged_aircraft_is_told_and_its_edits_are_left_out() {
    let mut scenario = scenario(&["navion.py"]);
    Parameter::find("a_ww").expect("a parameter").set(&mut scenario, -1.0);
    let text = link::write(&scenario, &View::of(&scenario), None);
    let start = text.find("own=").expect("it is in the link") + 4;
    let end = text[start..].find('&').map_or(text.len(), |at| start + at);
    for cut in [start + 1, (start + end) / 2, end - 4] {
        let damaged = format!("{}{}", &text[..cut], &text[end..]);
        let opened = reopened(&damaged);
        assert!(matches!(&opened.notices[..], [Notice::Own { .. }]), "{:?}", opened.notices);
        assert_eq!(
            opened.notices[0].to_string(),
            "The aircraft in the link can't be read, a part of it is missing or was changed: this is Navion instead, without the \
             changes made to it."
        );
        assert!(!opened.scenario.is_edited());
    }
    // At the end of a sentence, as mail programs copy it.
    let last = format!("v=1&own={}.", &text[start..end]);
    assert_eq!(reopened(&last).notices, []);
}

/// An aircraft with so long a note, of words that can't be made shorter.
fn noted(letters: u64) -> Aircraft {
    let noise: String = (0..letters)
        .map(|k| char::from(b'a' + (k.wrapping_mul(k).wrapping_mul(2_654_435_761) >> 13) as u8 % 26))
        .collect();
    let review = open(&["navion.py"]);
    let long =
        review.text().expect("it is ready").replacen("basis", &format!("note = \"{noise}\"\nbasis"), 1);
    Aircraft::own("long", &long).expect("it reads")
}

/// Both as long as one may be, and every number edited: nothing of the scene, the pinned state or the view is cut off.
#[test]
fn two_aircraft_as_long_as_they_may_be_fit_into_one_link() {
    let longest = |most: u64| {
        let fits = |letters: &u64| link::own::has_room(&noted(*letters));
        Scenario::new(Arc::new(noted((0..most).rev().step_by(40).find(fits).expect("a short one fits"))))
    };
    let edited = |mut scenario: Scenario| {
        for p in parameters() {
            if !p.applies(&scenario) {
                continue;
            }
            let range = p.range(&scenario);
            let value = 0.3 / 7.0 * range.start() + (1.0 - 0.3 / 7.0) * range.end();
            let value = if p.dimension == Dimension::Count { value.round() } else { value };
            match p.added(&scenario) {
                Some(_) => p.set_added(&mut scenario, value),
                None => p.set(&mut scenario, value),
            }
        }
        scenario
    };
    let (scene, other) = (edited(longest(9000)), edited(longest(8900)));
    assert_ne!(scene.aircraft, other.aircraft);
    let view = View { presents: true, ..View::of(&scene) };
    let place = LessonPlace { address: "a".repeat(200), step: 998, begins: false };
    let handed_in = HandedIn { by: "é".repeat(80), hints: 20, solution_shown: true };
    let text = link::write(&scene, &view, Some(&other));
    let text = format!("{text}{}{}", place.in_link(), handed_in.in_link());
    assert!(text.len() > 12_000 && text.len() <= LONGEST, "{}", text.len());
    let opened = reopened(&text);
    assert_eq!(opened.notices, []);
    assert_eq!((opened.scenario.edited, opened.view), (scene.edited, view));
    assert_eq!(opened.pinned.expect("it is pinned").edited, other.edited);
    assert_eq!((opened.lesson, opened.handed_in), (Some(place), Some(handed_in)));
}

#[test]
fn an_aircraft_too_long_for_a_link_is_left_out_of_it() {
    let scenario = Scenario::new(Arc::new(noted(12_000)));
    let text = link::write(&scenario, &View::of(&scenario), None);
    assert!(!text.contains("own="), "{} characters", text.len());
    assert!(matches!(&reopened(&text).notices[..], [Notice::Aircraft { .. }]));
}

proptest! {
    #[test]
    fn no_changed_aircraft_in_a_link_panics(packed in "[A-Za-z0-9_-]{0,200}", at in 0.0..1.0_f64, letter in "[A-Za-z0-9_-]") {
        reopened(&format!("v=1&own={packed}&ac=file&a_ww=-1"));
        let scenario = scenario(&["12-vant-consistent.csv"]);
        let mut text = link::write(&scenario, &View::of(&scenario), None);
        let place = (at * text.len() as f64) as usize;
        text.replace_range(place..=place, &letter);
        reopened(&text);
    }
}
