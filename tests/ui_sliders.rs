//! Sliders and fields of numbers: by mouse, keyboard and screen reader, and how they are found.

mod page;

use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::analysis::PlaneAnalysis;
use eigenwing::scenario::{Page, Parameter, parameters};
use eigenwing::words;
use page::{PHONE, TABLET, WIDE, app, open, page, type_into, value};

fn analysis(harness: &page::Page) -> &PlaneAnalysis {
    app(harness).findings().plane().expect("an analysis of the plane on screen")
}

/// The rows of a page that the aircraft on screen has.
fn rows(harness: &page::Page, page: Page) -> Vec<&'static Parameter> {
    let scenario = app(harness).scenario();
    parameters().filter(|p| p.is_shown(scenario, page)).collect()
}

const PITCH_STIFFNESS: &str = "pitch stiffness C_mα";

#[test]
fn every_parameter_of_every_page_and_plane_has_a_slider_and_a_field_by_name() {
    let mut harness = page(WIDE);
    for (plane, words) in [(Plane::Longitudinal, "Longitudinal"), (Plane::Lateral, "Lateral–directional")] {
        harness.get_by_label(words).click();
        harness.run();
        assert_eq!(app(&harness).scenario().plane, plane);
        for page in Page::ALL {
            harness.get_by_label(words::sliders::page(page)).click();
            harness.run();
            let rows = rows(&harness, page);
            assert!(rows.len() >= 12, "{page:?} {plane:?}");
            // One more is the time of the playback.
            assert_eq!(harness.query_all_by_role(Role::Slider).count(), rows.len() + 1, "{page:?} {plane:?}");
            for p in rows {
                let named = |node: &egui_kittest::Node<'_>| {
                    node.accesskit_node()
                        .label()
                        .is_some_and(|label| label.starts_with(&format!("{} ", p.name)))
                };
                assert!(harness.get_all_by_role(Role::Slider).any(|node| named(&node)), "{}", p.name);
            }
        }
    }
}

#[test]
fn an_arrow_key_moves_a_slider_and_the_poles_in_the_same_frame() {
    let mut harness = page(WIDE);
    let before = analysis(&harness).modes[0].lambda;
    harness.get_by_role_and_label(Role::Slider, PITCH_STIFFNESS).focus();
    harness.run();
    let (m_w, computations) = (value(&harness, "cm_alpha"), app(&harness).computations());
    harness.key_press(Key::ArrowLeft);
    harness.step();
    let fine = m_w - value(&harness, "cm_alpha");
    assert!(fine > 0.0);
    assert!(analysis(&harness).modes[0].lambda.im > before.im, "stiffer pitch, faster short period");
    assert_eq!(app(&harness).computations(), computations + 1, "one edit, one computation");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    harness.run();
    let both = m_w - value(&harness, "cm_alpha");
    // A step ends on a round number, so that the first one may be shorter than the others.
    assert!((10.0..=21.0).contains(&(both / fine)), "{both} after {fine}");
    harness.key_press(Key::Delete);
    harness.run();
    assert_eq!(value(&harness, "cm_alpha"), m_w);
}

#[test]
fn every_slider_can_be_taken_to_both_ends_by_keyboard() {
    for (size, page_of) in [(WIDE, Page::Coefficients), (TABLET, Page::Matrix)] {
        let mut harness = page(size);
        harness.get_by_label(words::sliders::page(page_of)).click();
        harness.run();
        for p in rows(&harness, page_of) {
            let start = format!("{} ", p.name);
            let label = harness
                .get_all_by_role(Role::Slider)
                .filter_map(|node| node.accesskit_node().label())
                .filter(|label| label.starts_with(&start))
                // The symbol is one word: a longer label is that of another row with a longer name.
                .min_by_key(|label| label.len())
                .expect("a slider");
            for (key, end) in [(Key::Home, false), (Key::End, true)] {
                harness.get_by_role_and_label(Role::Slider, &label).focus();
                harness.run();
                harness.key_press(key);
                harness.run();
                let range = p.range(app(&harness).scenario());
                let expected = if end { *range.end() } else { *range.start() };
                let reached = value(&harness, p.key);
                assert!((reached - expected).abs() <= 1e-9 * expected.abs().max(1e-6), "{label}: {reached}");
            }
            harness.key_press(Key::Delete);
            harness.run();
        }
    }
}

#[test]
fn a_screen_reader_sets_a_slider_and_undo_takes_it_back() {
    let mut harness = page(WIDE);
    let before = value(&harness, "cm_q");
    harness.get_by_role_and_label(Role::Slider, "pitch damping C_mq").set_value_accesskit(-1.0);
    harness.run_steps(120);
    assert_eq!(value(&harness, "cm_q"), -1.0);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(value(&harness, "cm_q"), before);
    harness.get_by_label("Redo").click();
    harness.run();
    assert_eq!(value(&harness, "cm_q"), -1.0);
}

#[test]
fn the_wheel_over_a_slider_or_a_number_edits_nothing() {
    let mut harness = page(WIDE);
    let before = app(&harness).scenario().clone();
    for role in [Role::Slider, Role::TextInput] {
        let center = harness.get_all_by_role(role).next().expect("a control").rect().center();
        harness.hover_at(center);
        harness.run();
        harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: Vec2::new(3.0, 5.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        harness.run();
    }
    assert_eq!(app(&harness).scenario(), &before);
}

#[test]
fn a_typed_number_is_taken() {
    let mut harness = page(WIDE);
    type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.25");
    assert_eq!(value(&harness, "cm_alpha"), -0.25);
}

#[test]
fn a_typed_number_that_cannot_be_used_is_refused_in_a_sentence_and_nothing_is_lost() {
    for (text, sentence) in
        [("steep", "is not a number"), ("nan", "finite number"), ("1e300", "beyond anything meaningful")]
    {
        let mut harness = page(WIDE);
        let before = app(&harness).scenario().clone();
        type_into(&mut harness, "pitch stiffness C_mα, typed", text);
        assert_eq!(app(&harness).scenario(), &before);
        assert_eq!(harness.query_all_by_label_contains(sentence).count(), 1, "{text}");
        let field = harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed");
        assert_eq!(field.value().as_deref(), Some(text));
        // Escape gives the number back.
        field.focus();
        harness.run();
        harness.key_press(Key::Escape);
        harness.run();
        assert_eq!(harness.query_all_by_label_contains(sentence).count(), 0);
    }
}

#[test]
fn resetting_takes_back_one_or_all() {
    let mut harness = page(WIDE);
    type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.25");
    type_into(&mut harness, "pitch damping C_mq, typed", "-1");
    harness.get_by_label("Reset pitch stiffness C_mα").click();
    harness.run();
    assert_eq!((value(&harness, "cm_alpha"), value(&harness, "cm_q")), (-0.683, -1.0));
    harness.get_by_label("Reset all").click();
    harness.run();
    assert!(!app(&harness).scenario().is_edited());
}

#[test]
fn the_value_in_effect_is_larger_than_the_one_that_the_slider_sets() {
    for size in [WIDE, TABLET, PHONE] {
        let mut harness = page(size);
        let field = |harness: &page::Page| {
            harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").rect()
        };
        let alone = field(&harness);
        open(&mut harness, "v=1&ac=navion&cg=15.38");
        let effective = harness.get_by_role_and_label(Role::Label, "−0.000128").rect();
        let small = field(&harness);
        assert_eq!(
            harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").value().as_deref(),
            Some("−0.683")
        );
        // Where the number stood alone; beside it what the slider sets, in a field that is smaller.
        assert!(alone.expand(9.0).contains_rect(effective), "{size}: {effective} in {alone}");
        assert!(small.left() >= effective.right() && small.width() < alone.width() - 15.0, "{size}: {small}");
        assert!(small.height() <= alone.height(), "{size}: {small}");
        // It is still typed into.
        type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.7");
        assert_eq!(value(&harness, "cm_alpha"), -0.7);
    }
}

#[test]
fn the_knobs_and_what_stiffens_and_damps_are_in_sight_as_the_page_opens() {
    let mut harness = page(WIDE);
    let knob = |name: &str| name.starts_with("shift of the centre of gravity");
    for (plane, wanted) in [
        (
            "Longitudinal",
            ["airspeed V", "size of the horizontal tail", "pitch stiffness C_mα", "pitch damping C_mq"],
        ),
        ("Lateral–directional", ["airspeed V", "size of the fin", "weathercock stability", "roll damping"]),
    ] {
        harness.get_by_label(plane).click();
        harness.run();
        let list = harness.get_by_label("Find a derivative").rect().bottom()..=WIDE.y - 178.0;
        let sliders: Vec<(String, egui::Rect)> = harness
            .get_all_by_role(Role::Slider)
            .map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()))
            .collect();
        assert!(knob(&sliders[0].0), "{plane}: {}", sliders[0].0);
        for name in wanted {
            let (_, rect) = sliders.iter().find(|(label, _)| label.starts_with(name)).expect(name);
            assert!(list.contains(&rect.top()) && list.contains(&rect.bottom()), "{name} at {rect}");
        }
    }
    // What is next to nothing at low speed comes last.
    harness.get_by_label("Longitudinal").click();
    harness.run();
    let top = |name: &str| {
        harness
            .get_all_by_role(Role::Slider)
            .find(|node| node.accesskit_node().label().is_some_and(|l| l.contains(name)))
            .expect("a slider")
            .rect()
            .top()
    };
    assert!(top("C_LM") > top("C_mδe") && top("C_mM") > top("C_D"));
}

/// A knob moves coefficients: each that it moves says to what, and the rest say nothing.
#[test]
fn a_knob_shows_what_it_moves() {
    let mut harness = page(WIDE);
    let told = |harness: &page::Page| {
        let sliders = harness.query_all_by_role(Role::Slider);
        sliders.filter(|slider| slider.value().is_some_and(|value| value.contains("in effect"))).count()
    };
    assert_eq!(told(&harness), 0);
    type_into(&mut harness, "airspeed V, typed", "60");
    // C_L, C_D and C_Dα follow the speed.
    assert_eq!(told(&harness), 3);
    let lift = harness.query_all_by_role(Role::Slider).find_map(|slider| {
        slider.value().filter(|value| value.starts_with("0.41") && value.contains("in effect"))
    });
    // 0.41 (53.64/60)² = 0.3277
    assert!(lift.as_ref().is_some_and(|value| value.contains("0.3277")), "{lift:?}");
}

/// On many keyboards the key of the search is typed with Shift.
#[test]
fn a_slash_goes_to_the_search_with_shift_or_without() {
    for modifiers in [Modifiers::NONE, Modifiers::SHIFT] {
        let mut harness = page(WIDE);
        harness.key_press_modifiers(modifiers, Key::Slash);
        harness.run();
        let search = harness.get_by_role_and_label(Role::TextInput, "Find a derivative");
        assert!(search.is_focused(), "{modifiers:?}");
    }
}

/// Under a hand that drags it a slider must mean the same from one pixel to the next.
#[test]
fn a_slider_keeps_its_place_and_length_where_two_roots_meet() {
    let mut harness = page(WIDE);
    let place = |harness: &page::Page| harness.get_by_role_and_label(Role::Slider, PITCH_STIFFNESS).rect();
    let before = (analysis(&harness).modes.len(), place(&harness));
    for value in ["-0.05", "0.2"] {
        open(&mut harness, &format!("v=1&ac=navion&cm_alpha={value}"));
        assert!(analysis(&harness).modes.len() > before.0);
        assert_eq!(place(&harness), before.1);
    }
}

#[test]
fn a_search_finds_symbols_as_they_are_typed_and_points_to_where_else_it_would_find() {
    let mut harness = page(WIDE);
    let stiffness = "pitch stiffness C_mα";
    let shift = "shift of the centre of gravity Δx_cg/c";
    for (text, name) in [
        ("cma", stiffness),
        ("cm alpha", stiffness),
        ("cmalpha", stiffness),
        ("Cm_alpha", stiffness),
        ("c.g.", shift),
        ("cg", shift),
        ("CLq", "lift due to pitch rate C_Lq"),
    ] {
        type_into_search(&mut harness, text);
        assert_eq!(harness.query_all_by_role_and_label(Role::Slider, name).count(), 1, "{text}");
        harness.get_by_label("Show all sliders").click();
        harness.run();
    }
    for (text, place) in [
        ("dihedral", "is under Lateral–directional."),
        ("Z_w", "is under Dimensional."),
        ("no such thing", "No slider of this page matches “no such thing”."),
    ] {
        type_into_search(&mut harness, text);
        let sentence = harness.get_by_label_contains("No slider of this page").accesskit_node().value();
        let label = harness.get_by_label_contains("No slider of this page").accesskit_node().label();
        let said = label.or(sentence).unwrap_or_default();
        assert!(said.ends_with(place), "{text}: {said}");
        harness.get_by_label("Show all sliders").click();
        harness.run();
    }
}

/// The list beside the cards names what moves each mode most, shows its path, and leads to its slider.
#[test]
fn the_strongest_derivatives_lead_to_their_sliders() {
    let link = |key: &str| format!("To the slider of {key}");
    let mut harness = page(WIDE);
    // The short period hangs on the pitch stiffness, its damping on that of pitch; the phugoid on lift (Lanchester) and drag.
    for key in ["pitch stiffness C_mα", "pitch damping C_mq", "trim lift C_L"] {
        harness.get_by_role_and_label(Role::Button, &link(key));
    }
    type_into_search(&mut harness, "drag");
    assert_eq!(harness.query_all_by_label("pitch stiffness C_mα").count(), 0);
    harness.get_by_role_and_label(Role::Button, &link("pitch stiffness C_mα")).click();
    harness.run();
    assert!(harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").is_focused());
    // On a phone the sliders are on another page.
    let mut harness = page(PHONE);
    harness.get_by_role_and_label(Role::Button, "Modes").click();
    harness.run();
    harness.get_by_role_and_label(Role::Button, &link("pitch damping C_mq")).click_accesskit();
    harness.run();
    assert!(harness.get_by_role_and_label(Role::Slider, "pitch damping C_mq").is_focused());
}

fn type_into_search(harness: &mut page::Page, text: &str) {
    harness.get_by_role_and_label(Role::TextInput, "Find a derivative").focus();
    harness.run();
    harness.get_by_role_and_label(Role::TextInput, "Find a derivative").type_text(text);
    harness.run();
}
