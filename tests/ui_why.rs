//! Why a mode has moved, on its card, and why a step ends where it does, beside its numbers.

mod page;

use egui::Vec2;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use page::{WIDE, open, page, type_into, value};

/// Its period, in the sentence of a card.
const PHUGOID_OF_THE_NAVION: &str = "T\u{a0}29.5\u{a0}→\u{a0}";

/// Of the cards of the modes.
fn reason_of_the_phugoid(harness: &page::Page) -> Option<String> {
    let text = |node: egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value())
    };
    harness.query_all_by_label_contains(PHUGOID_OF_THE_NAVION).filter_map(text).next()
}

#[test]
fn a_card_says_why_its_mode_has_moved_and_more_where_one_asks() {
    let mut harness = page(WIDE);
    assert!(harness.query_by_label("Why it moved").is_none(), "nothing has been changed");
    type_into(&mut harness, "pitch damping C_mq, typed", "-19.92");
    assert_eq!(harness.query_all_by_label("Why it moved").count(), 2);
    assert!(harness.query_by_label_contains(PHUGOID_OF_THE_NAVION).is_some());
    let formula = "there is left −V";
    assert!(harness.query_by_label_contains(formula).is_none());
    harness.get_by_label("More on why the phugoid moved").click_accesskit();
    harness.run();
    assert!(harness.query_by_label_contains(formula).is_some());
    // As it was: no reason is left.
    type_into(&mut harness, "pitch damping C_mq, typed", "-9.96");
    assert!(harness.query_by_label("Why it moved").is_none());
}

#[test]
fn no_reason_is_told_where_reasons_are_hidden() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=-19.92");
    assert!(harness.query_all_by_label("Why it moved").next().is_some());
    open(&mut harness, "v=1&ac=navion&cm_q=-19.92&hide=reasons");
    assert!(harness.query_all_by_label("Why it moved").next().is_none());
}

#[test]
fn the_reason_stays_while_a_slider_is_dragged_and_follows_when_the_hand_rests() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=-15");
    let before = reason_of_the_phugoid(&harness).expect("it has moved");
    let slider = harness.get_by_role_and_label(Role::Slider, "pitch damping C_mq").rect();
    let start = slider.center();
    harness.drag_at(start);
    harness.run();
    harness.hover_at(start - Vec2::new(30.0, 0.0));
    harness.run();
    assert!((value(&harness, "cm_q") + 15.0).abs() > 1.0, "the slider follows the hand");
    assert_eq!(reason_of_the_phugoid(&harness).as_deref(), Some(before.as_str()));
    harness.drop_at(start - Vec2::new(30.0, 0.0));
    harness.run();
    assert_ne!(reason_of_the_phugoid(&harness), Some(before));
}

#[test]
fn since_a_pin_the_reason_is_that_of_the_pin() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=-19.92&pin.ac=navion&pin.cm_q=-19.92&cg=10");
    // Since the source M_q would have a part in it; since the pin only the centre of gravity has moved.
    // The two real roots of the short period, and the phugoid.
    assert_eq!(harness.query_all_by_label_contains(", by Mw.").count(), 3);
    assert!(harness.query_all_by_label_contains("by Mq").next().is_none());
}

#[test]
fn the_numbers_of_an_elevator_step_say_why_it_ends_at_another_speed() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&lon.source=elevator&lon.shape=step&elevator=1");
    harness.get_by_label("Numbers").click();
    harness.run();
    harness.get_by_label_contains("A new elevator is a new trim");
    open(&mut harness, "v=1&ac=navion&lon.source=elevator&lon.shape=pulse");
    harness.get_by_label("Numbers").click();
    harness.run();
    assert!(harness.query_by_label_contains("is a new trim").is_none());
}
