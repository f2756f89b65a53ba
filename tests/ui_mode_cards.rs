//! The cards of the modes: what they say, show on request, and lead to.

mod page;

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use eigenwing::flight::analysis::PlaneAnalysis;
use eigenwing::scenario::Source;
use page::{WIDE, app, choose, open, page, type_into};

fn analysis(harness: &page::Page) -> &PlaneAnalysis {
    app(harness).findings().plane().expect("an analysis of the plane on screen")
}

#[test]
fn the_overall_level_is_told_for_the_class_and_category_that_are_chosen() {
    let mut harness = page(WIDE);
    harness.get_by_label("Level 1 overall, every criterion is met");
    choose(&mut harness, "Class of aircraft", "Class IV: high manoeuvrability");
    choose(&mut harness, "Category of flight phase", "Category A, combat: air combat and ground attack");
    // Table VI asks ζ ≥ 0.4 of a Class IV aircraft in air combat; the Navion's Dutch roll has 0.2.
    harness.get_by_label("Level 2 overall, set by the Dutch roll");
    type_into(&mut harness, "pitch stiffness C_mα, typed", "0.03");
    harness.get_by_label("Level 3 overall, set by the divergence of airspeed");
    // One step back each
    for _ in 0..3 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run();
    }
    assert_eq!(app(&harness).scenario().task, app(&harness).scenario().aircraft.task);
    // Where the source names no class, none is judged until one is chosen.
    choose(&mut harness, "Aircraft", "Lesson 4, gravity in the same unit");
    assert_eq!(harness.query_all_by_label_contains(" overall, ").count(), 0);
    choose(&mut harness, "Class of aircraft", "Class I: small and light");
    assert_eq!(harness.query_all_by_label_contains(" overall, ").count(), 1);
}

#[test]
fn a_growing_root_has_no_time_constant() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=c47&plane=lat");
    let grows = |mode: &&eigenwing::flight::modes::mode::Mode| mode.time_to_double().is_some();
    assert_eq!(analysis(&harness).modes.iter().filter(grows).count(), 1, "the spiral");
    let with_constant = analysis(&harness).modes.iter().filter(|mode| mode.time_constant().is_some()).count();
    assert_eq!((with_constant, harness.query_all_by_label("τ").count()), (2, 1), "of the roll only");
}

#[test]
fn an_overdamped_short_period_is_judged_on_both_of_its_cards() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=-30&cm_alpha=-0.1");
    harness.get_by_label("Level of the fast root of the short period").click();
    harness.run();
    let both = harness.query_all_by_label_contains("Its two real roots are taken as one motion").count();
    assert!(both >= 4, "two criteria on either card: {both}");
}

#[test]
fn a_mode_is_flown_alone_from_its_card_and_given_up_again() {
    let mut harness = page(WIDE);
    harness.get_by_label("Fly the phugoid alone").click();
    harness.run_steps(4);
    harness.get_by_label("Pause");
    let choice = app(&harness).scenario().disturbance.choices.longitudinal;
    assert_eq!((choice.source, choice.mode), (Source::OneMode, 1));
    harness.get_by_label("Stop flying the phugoid alone").click();
    harness.run();
    assert_eq!(app(&harness).scenario().disturbance.choices.longitudinal.source, Source::Elevator);
}

#[test]
fn shape_levels_and_approximations_of_every_mode_are_shown_on_request() {
    let mut harness = page(WIDE);
    for (button, seen) in [
        ("Shape of the short period", "Shape of the short period: u/V"),
        ("Level of the phugoid", "Level 1: ζ is 0.0801, Level 1 asks at least 0.0400"),
        (
            "Approximations of the short period",
            "one degree of freedom (pitch): ωₙ 2.97 rad/s, exact 3.61, −18\u{a0}%; ζ 0.503, exact 0.696, −28\u{a0}%",
        ),
    ] {
        assert_eq!(harness.query_all_by_label_contains(seen).count(), 0, "{seen}");
        harness.get_by_label(button).click();
        harness.run();
        harness.get_by_label_contains(seen);
    }
}

/// What a button opens is opened on every card, those above it too.
#[test]
fn a_button_of_a_card_stays_under_the_pointer() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&plane=lat");
    for what in ["Shape of the roll mode", "Level of the roll mode"] {
        let before = harness.get_by_role_and_label(Role::Button, what).rect();
        harness.get_by_role_and_label(Role::Button, what).click();
        harness.run();
        let after = harness.get_by_role_and_label(Role::Button, what).rect();
        assert!((after.top() - before.top()).abs() < 1.0, "{what}: {before} to {after}");
    }
}

#[test]
fn chips_of_levels_have_one_form_and_one_order() {
    let mut harness = page(WIDE);
    let mut chips = 0;
    for link in ["v=1&ac=navion", "v=1&ac=navion&plane=lat", "v=1&ac=navion&cg=15.38"] {
        open(&mut harness, link);
        let stable: Vec<egui::Rect> = harness.query_all_by_label("stable").map(|chip| chip.rect()).collect();
        for level in harness.query_all_by_label_contains("Level of the ").map(|chip| chip.rect()) {
            let beside = stable.iter().find(|chip| (chip.center().y - level.center().y).abs() < 4.0);
            assert!(beside.is_some_and(|chip| chip.right() < level.left()), "{link}: {level} {stable:?}");
            chips += 1;
        }
    }
    assert!(chips >= 6, "{chips}");
}
