//! What a screen reader is told of the page: parts to jump to, what follows from a slider, how the pole map looks, verdicts that change;
//! and a page that is enlarged.

mod page;

use std::collections::BTreeSet;

use egui::accesskit::Role;
use egui::{Key, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use page::{PHONE, Page, WIDE, open, page};

const STIFFNESS: &str = "pitch stiffness C_mα";

/// What a slider says of its value.
fn told(page: &Page) -> String {
    page.get_by_role_and_label(Role::Slider, STIFFNESS).accesskit_node().value().unwrap_or_default()
}

fn map(page: &Page) -> String {
    let map = page.get_by_label_contains("Pole map, All modes");
    map.accesskit_node().label().unwrap_or_default()
}

#[test]
fn the_parts_of_the_page_have_names_of_their_own() {
    let page = page(WIDE);
    let names: Vec<String> =
        page.query_all_by_role(Role::Region).filter_map(|node| node.accesskit_node().label()).collect();
    for part in ["Page bar", "Sliders", "Verdicts and cards", "Map", "Flight", "Motion"] {
        assert!(names.iter().any(|name| name == part), "{part} in {names:?}");
    }
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{names:?}");
}

#[test]
fn a_slider_that_is_reached_says_what_follows_and_nothing_that_is_hidden() {
    let mut page = page(WIDE);
    assert_eq!(told(&page), "−0.683 1/rad", "until it is reached its value is enough");
    let reach = |page: &mut Page| {
        page.get_by_role_and_label(Role::Slider, STIFFNESS).focus();
        page.run();
    };
    reach(&mut page);
    assert_eq!(
        told(&page),
        "−0.683 1/rad: Short period 3.6 radians a second, damping ratio 0.70, Dynamically stable"
    );
    open(&mut page, "v=1&ac=navion&hide=names.numbers.verdicts.reasons");
    reach(&mut page);
    assert_eq!(told(&page), "−0.683 1/rad");
    open(&mut page, "v=1&ac=navion&cm_alpha=0.2&hide=numbers");
    reach(&mut page);
    assert_eq!(told(&page), "0.2 1/rad: Dynamically unstable");
}

#[test]
fn the_pole_map_tells_what_is_seen_and_where_the_poles_have_gone() {
    let mut page = page(WIDE);
    assert!(map(&page).contains(". Two pairs, one quick and well damped at −2.51"), "{}", map(&page));
    assert!(!map(&page).contains("has moved"));
    page.get_by_role_and_label(Role::Slider, STIFFNESS).focus();
    page.run();
    for _ in 0..30 {
        page.get_by_role_and_label(Role::Slider, STIFFNESS).decrement_accesskit();
        page.run();
    }
    assert!(map(&page).contains("Short period has moved up"), "{}", map(&page));
    page.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
    page.run();
    assert!(!map(&page).contains("has moved"), "{}", map(&page));
}

#[test]
fn a_verdict_that_becomes_another_is_said_and_one_that_is_hidden_is_not() {
    for (hidden, expected) in [("", true), ("&hide=verdicts", false)] {
        let mut page = page(WIDE);
        open(&mut page, &format!("v=1&ac=navion{hidden}"));
        let said = |page: &mut Page| page.state_mut().as_mut().expect("the page").take_unsaid();
        said(&mut page);
        page.get_by_role_and_label(Role::Slider, STIFFNESS).focus();
        page.run();
        page.key_press(Key::End);
        page.run();
        let told = said(&mut page);
        assert_eq!(told.is_some_and(|told| told.starts_with("Dynamically unstable")), expected, "{hidden}");
        page.key_press(Key::ArrowLeft);
        page.run();
        assert_eq!(said(&mut page), None, "it is still so");
    }
}

/// A phone on its side, and a page enlarged four times.
#[test]
fn where_the_pole_map_leaves_no_room_it_is_a_pane_like_the_others() {
    for size in [Vec2::new(640.0, 360.0), Vec2::new(320.0, 256.0)] {
        let mut page = page(size);
        assert!(page.query_by_label_contains("Pole map, All modes").is_none(), "{size}");
        assert!(page.query_all_by_role(Role::Slider).next().is_some(), "{size}");
        page.get_by_role_and_label(Role::Button, "Poles").click();
        page.run();
        assert!(page.query_by_label_contains("Pole map, All modes").is_some(), "{size}");
    }
    let page = page(PHONE);
    assert!(page.query_all_by_role_and_label(Role::Button, "Poles").next().is_none());
    assert!(page.query_by_label_contains("Pole map, All modes").is_some());
}
