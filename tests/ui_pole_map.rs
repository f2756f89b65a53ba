//! The pole map by pointer and keyboard, without a window.

mod page;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, TouchPhase, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::modes::mode::Mode;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::scenario::{Notation, Parameter};
use eigenwing::words;
use nalgebra::Complex;
use page::{PHONE, Page, WIDE, app, open, page, value};

/// The eigenvalue of the short period as the page opens, on its card and in words.
const SHORT_PERIOD: &str = "−2.510 ± 2.592j 1/s";

fn mode(harness: &Page, name: ModeName) -> Mode {
    let modes = &app(harness).findings().plane().expect("an analysis").modes;
    modes.iter().find(|mode| mode.naming.name == name).expect("the mode").clone()
}

/// Where a pole that can be reached by keyboard is on the screen.
fn pole(harness: &Page, name: &str) -> Pos2 {
    harness.get_by_label_contains(&format!("{name} pole, ")).rect().center()
}

fn map(harness: &Page, name: &str) -> Rect {
    harness.get_by_label_contains(&format!("Pole map, {name}")).rect()
}

fn press(harness: &mut Page, at: Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
}

fn go(harness: &mut Page, to: Pos2) {
    harness.hover_at(to);
    harness.step();
}

fn release(harness: &mut Page, at: Pos2) {
    harness.drop_at(at);
    harness.run();
}

/// Presses, goes there in some steps, and lets go.
fn drag(harness: &mut Page, from: Pos2, by: Vec2) {
    press(harness, from);
    for k in 1..=4 {
        go(harness, from + by * (k as f32 / 4.0));
    }
    release(harness, from + by);
}

#[test]
fn dragging_a_pole_moves_its_derivatives_and_nothing_else_and_undo_is_one_step() {
    let mut harness = page(WIDE);
    let (before, scenario) = (mode(&harness, ModeName::ShortPeriod), app(&harness).scenario().clone());
    let from = pole(&harness, "Short period");
    drag(&mut harness, from, Vec2::new(-14.0, -22.0));
    let after = mode(&harness, ModeName::ShortPeriod);
    assert!(after.lambda.re < before.lambda.re && after.lambda.im > before.lambda.im, "{}", after.lambda);
    for (key, moved) in [("cm_alpha", true), ("cm_q", true), ("cl_alpha", false), ("cd", false)] {
        let was = Parameter::find(key).expect("a row").get(&scenario);
        assert_eq!(value(&harness, key) != was, moved, "{key}");
    }
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(app(&harness).scenario(), &scenario);
    harness.get_by_label("Redo").click();
    harness.run();
    assert_eq!(mode(&harness, ModeName::ShortPeriod).lambda, after.lambda);
}

#[test]
fn the_pole_is_under_the_pointer_while_it_is_dragged_and_sliders_show_it_in_the_same_frame() {
    let mut harness = page(WIDE);
    let from = pole(&harness, "Short period");
    press(&mut harness, from);
    for to in [Vec2::new(-8.0, -4.0), Vec2::new(-12.0, -16.0), Vec2::new(4.0, 10.0)] {
        go(&mut harness, from + to);
        assert!((pole(&harness, "Short period") - (from + to)).length() < 0.5, "{to}");
        let slider = harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα");
        let shown = slider.accesskit_node().numeric_value().expect("a value");
        assert!((shown - value(&harness, "cm_alpha")).abs() < 1e-12);
    }
    // Back at the start nothing has changed: the way there makes no difference.
    go(&mut harness, from);
    assert!((value(&harness, "cm_alpha") + 0.683).abs() < 1e-6);
}

#[test]
fn the_lower_pole_of_a_pair_goes_with_the_pointer_too() {
    let mut harness = page(WIDE);
    let before = mode(&harness, ModeName::ShortPeriod).lambda;
    let chart = map(&harness, "All modes");
    let upper = pole(&harness, "Short period");
    let lower = Pos2::new(upper.x, 2.0 * chart.center().y - upper.y);
    drag(&mut harness, lower, Vec2::new(0.0, 20.0));
    let after = mode(&harness, ModeName::ShortPeriod).lambda;
    assert!(after.im > 1.05 * before.im, "{after}");
    assert!((after.re - before.re).abs() < 0.02 * before.im, "{after}");
}

#[test]
fn two_drags_are_two_steps_of_undo_however_quick() {
    let mut harness = page(WIDE);
    let start = app(&harness).scenario().clone();
    let from = pole(&harness, "Short period");
    drag(&mut harness, from, Vec2::new(0.0, -20.0));
    let between = app(&harness).scenario().clone();
    let from = pole(&harness, "Phugoid");
    drag(&mut harness, from, Vec2::new(-10.0, 0.0));
    assert_ne!(app(&harness).scenario(), &between);
    for expected in [&between, &start] {
        harness.get_by_label("Undo").click();
        harness.run();
        assert_eq!(app(&harness).scenario(), expected);
    }
}

#[test]
fn escape_puts_the_pole_back() {
    let mut harness = page(WIDE);
    let start = app(&harness).scenario().clone();
    let from = pole(&harness, "Short period");
    press(&mut harness, from);
    go(&mut harness, from + Vec2::new(0.0, -25.0));
    assert_ne!(app(&harness).scenario(), &start);
    harness.key_press(Key::Escape);
    harness.step();
    assert_eq!(app(&harness).scenario(), &start);
    go(&mut harness, from + Vec2::new(0.0, -40.0));
    release(&mut harness, from);
    assert_eq!(app(&harness).scenario(), &start);
}

#[test]
fn a_target_out_of_reach_says_why_and_the_sentence_goes_with_the_next_press() {
    let mut harness = page(WIDE);
    let from = pole(&harness, "Short period");
    let axis = map(&harness, "All modes").center().y;
    press(&mut harness, from);
    go(&mut harness, Pos2::new(from.x, axis));
    harness.get_by_label_contains("Short period can’t follow: this pair would meet on the real axis");
    release(&mut harness, Pos2::new(from.x, axis));
    assert!(mode(&harness, ModeName::ShortPeriod).lambda.im > 0.0);
    harness.key_press(Key::Tab);
    harness.run();
    assert_eq!(harness.query_all_by_label_contains("can’t follow").count(), 0);
}

#[test]
fn another_choice_of_derivatives_moves_those_and_says_where_one_is_not_enough() {
    let mut harness = page(WIDE);
    let before = (value(&harness, "cm_q"), value(&harness, "cl_alpha"));
    harness.get_by_label("Drag of the short period moves C_mα, C_mq").click();
    harness.run();
    for name in ["Drag moves C_mα", "Drag moves C_mq", "Drag moves C_Lα"] {
        harness.get_by_role_and_label(Role::CheckBox, name).click();
        harness.run();
    }
    harness.key_press(Key::Escape);
    harness.run();
    harness.get_by_label("Drag of the short period moves C_Lα");
    let from = pole(&harness, "Short period");
    press(&mut harness, from);
    go(&mut harness, from + Vec2::new(-20.0, -10.0));
    harness.get_by_label_contains("C_Lα alone moves this pole along one path");
    release(&mut harness, from);
    assert_eq!(value(&harness, "cm_q"), before.0);
    assert_ne!(value(&harness, "cl_alpha"), before.1);
}

#[test]
fn on_every_page_and_plane_the_first_pole_can_be_dragged() {
    let mut harness = page(WIDE);
    for plane in ["Longitudinal", "Lateral–directional"] {
        harness.get_by_label(plane).click();
        harness.run();
        for page in ["Coefficients", "Dimensional", "Matrix"] {
            harness.get_by_label(page).click();
            harness.run();
            let name = app(&harness).findings().plane().expect("an analysis").modes[0].naming.name;
            let before = mode(&harness, name).lambda;
            let from = pole(&harness, words::mode::title(name));
            drag(&mut harness, from, Vec2::new(-6.0, -8.0));
            let after = mode(&harness, name).lambda;
            assert!(after.re < before.re && after.im > before.im, "{plane} {page}: {before} {after}");
            assert_eq!(harness.query_all_by_label_contains("can’t follow").count(), 0, "{plane} {page}");
        }
    }
}

#[test]
fn arrow_keys_move_the_pole_that_has_focus_and_escape_ends() {
    let mut harness = page(WIDE);
    let before = mode(&harness, ModeName::ShortPeriod).lambda;
    harness.get_by_label("Short period pole, −2.510 ± 2.592j 1/s").focus();
    harness.run();
    harness.key_press(Key::ArrowUp);
    harness.run();
    let up = mode(&harness, ModeName::ShortPeriod).lambda;
    assert!(up.im > before.im && (up.re - before.re).abs() < 1e-6, "{up}");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    harness.run();
    let left = mode(&harness, ModeName::ShortPeriod).lambda;
    let (fine, coarse) = (up.im - before.im, up.re - left.re);
    assert!((coarse / fine - 10.0).abs() < 1e-3, "{fine} {coarse}");
    harness.key_press(Key::Escape);
    harness.run();
    harness.key_press(Key::ArrowUp);
    harness.run();
    assert_eq!(mode(&harness, ModeName::ShortPeriod).lambda, left);
}

#[test]
fn every_mode_can_be_reached_by_keyboard_once() {
    let mut harness = page(WIDE);
    for plane in ["Lateral–directional", "Longitudinal"] {
        harness.get_by_label(plane).click();
        harness.run();
        for mode in &app(&harness).findings().plane().expect("an analysis").modes {
            let name = format!("{} pole, ", words::mode::title(mode.naming.name));
            assert_eq!(harness.query_all_by_label_contains(&name).count(), 1, "{name}");
        }
    }
}

/// How often a text is on the page beyond the cards of the modes.
fn count(harness: &Page, text: &str) -> usize {
    harness.query_all_by_label_contains(text).count()
}

#[test]
fn a_card_tells_of_the_pole_near_the_pointer_and_of_a_tapped_one() {
    let mut harness = page(WIDE);
    let from = pole(&harness, "Short period");
    let before = count(&harness, SHORT_PERIOD);
    harness.hover_at(from + Vec2::new(12.0, 10.0));
    harness.run();
    assert_eq!(count(&harness, SHORT_PERIOD), before + 1);
    harness.hover_at(from + Vec2::new(24.0, 24.0));
    harness.run();
    assert_eq!(count(&harness, SHORT_PERIOD), before);
    // A tap: the card stays until another place is tapped.
    press(&mut harness, from);
    release(&mut harness, from);
    harness.remove_cursor();
    harness.run();
    assert_eq!(count(&harness, SHORT_PERIOD), before + 1);
    let elsewhere = from + Vec2::new(-80.0, 60.0);
    press(&mut harness, elsewhere);
    release(&mut harness, elsewhere);
    harness.remove_cursor();
    harness.run();
    assert_eq!(count(&harness, SHORT_PERIOD), before);
}

#[test]
fn the_path_of_a_slider_tells_its_value_under_the_pointer() {
    let mut harness = page(WIDE);
    harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    harness.run();
    // Stiffer is straight up, at the same σ.
    harness.hover_at(pole(&harness, "Short period") - Vec2::new(0.0, 30.0));
    harness.run();
    assert_eq!(count(&harness, "Cmα = −"), 1);
}

#[test]
fn an_approximation_is_marked_on_request_and_tells_its_formula_and_error() {
    let mut harness = page(WIDE);
    // In notation, and as it is set.
    let (notation, formula) = ("ωₙ² = −Z_u g/V,  ζ = −X_u/(2ωₙ)", "ωₙ² = −Zu g/V,  ζ = −Xu/(2ωₙ)");
    let plane = app(&harness).findings().plane().expect("an analysis");
    let approximation = plane
        .approximations
        .iter()
        .find(|a| words::approximation::formula(a.name, Notation::Velocities) == notation)
        .expect("two states");
    let (root, exact) = (approximation.root().expect("a root"), mode(&harness, ModeName::Phugoid).lambda);
    // Where the mark is, from the scale that the axis and the pole give.
    let (chart, at) = (map(&harness, "Slow modes"), pole(&harness, "Phugoid"));
    let scale = f64::from(chart.center().y - at.y) / exact.im;
    let off: Complex<f64> = (root - exact) * scale;
    let mark = at + Vec2::new(off.re as f32, -off.im as f32) * 1.1;
    harness.hover_at(mark);
    harness.run();
    assert_eq!(count(&harness, formula), 0);
    harness.get_by_label("Textbook approximations").click();
    harness.run();
    harness.hover_at(mark);
    harness.run();
    assert_eq!(count(&harness, formula), 1);
    harness.get_by_label("Textbook approximations").click();
    harness.run();
    harness.hover_at(mark);
    harness.run();
    assert_eq!(count(&harness, formula), 0);
}

fn wheel(harness: &mut Page, modifiers: Modifiers) {
    harness.event_modifiers(
        Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: Vec2::new(0.0, 3.0),
            phase: TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers,
        },
        modifiers,
    );
    harness.run();
}

fn fit_buttons(harness: &Page) -> usize {
    count(harness, "Show all again")
}

#[test]
fn control_and_wheel_zoom_about_the_pointer_and_the_plain_wheel_does_nothing() {
    let mut harness = page(WIDE);
    let from = pole(&harness, "Short period");
    let axis = map(&harness, "All modes").center().y;
    harness.hover_at(from);
    harness.run();
    wheel(&mut harness, Modifiers::NONE);
    assert_eq!((pole(&harness, "Short period"), fit_buttons(&harness)), (from, 0));
    let slow = pole(&harness, "Phugoid");
    wheel(&mut harness, Modifiers::COMMAND);
    assert_eq!(fit_buttons(&harness), 1);
    assert!((pole(&harness, "Short period") - from).length() < 0.5, "it is under the pointer");
    assert_eq!(pole(&harness, "Phugoid"), slow, "the other map stays");
    assert!(!app(&harness).scenario().is_edited());
    // Its conjugate has gone further away: the map is nearer.
    let lower = Pos2::new(from.x, 2.0 * axis - from.y);
    harness.hover_at(lower);
    harness.run();
    assert_eq!(count(&harness, SHORT_PERIOD), 2, "no card where it was");
    harness.get_by_label("Show all again, All modes").click();
    harness.run();
    assert_eq!(fit_buttons(&harness), 0);
    assert!((pole(&harness, "Short period") - from).length() < 0.5);
}

#[test]
fn empty_ground_pans_and_a_double_click_goes_back() {
    let mut harness = page(WIDE);
    let start = app(&harness).scenario().clone();
    let from = pole(&harness, "Short period");
    let ground = from + Vec2::new(-90.0, 60.0);
    drag(&mut harness, ground, Vec2::new(40.0, 25.0));
    let moved = pole(&harness, "Short period") - from;
    assert!((moved - Vec2::new(40.0, 25.0)).length() < 8.0, "{moved}");
    assert_eq!(app(&harness).scenario(), &start, "nothing is edited");
    harness.run_steps(60);
    harness.hover_at(ground);
    harness.step();
    // In one frame: frames of the harness are too far apart for a double click.
    let button = PointerButton::Primary;
    let click = |pressed| Event::PointerButton { pos: ground, button, pressed, modifiers: Modifiers::NONE };
    harness.input_mut().events.extend([true, false, true, false].map(click));
    harness.run();
    assert!((pole(&harness, "Short period") - from).length() < 0.5);
    assert_eq!(fit_buttons(&harness), 0);
}

#[test]
fn a_map_zooms_by_its_buttons_and_by_keys() {
    let mut harness = page(WIDE);
    let axis = map(&harness, "Slow modes").center().y;
    let height = |harness: &Page| axis - pole(harness, "Phugoid").y;
    let fitted = height(&harness);
    harness.get_by_label("Zoom out, Slow modes, own scale").click();
    harness.run();
    assert!((height(&harness) * 1.5 - fitted).abs() < 0.5);
    harness.get_by_label("Zoom in, Slow modes, own scale").click();
    harness.run();
    assert!((height(&harness) - fitted).abs() < 0.5);
    harness.get_by_label_contains("Pole map, Slow modes").focus();
    harness.run();
    harness.key_press(Key::Minus);
    harness.run();
    assert!((height(&harness) * 1.5 - fitted).abs() < 0.5);
    harness.key_press(Key::Num0);
    harness.run();
    assert!((height(&harness) - fitted).abs() < 0.5);
}

fn starts(node: &egui_kittest::Node<'_>, with: &str) -> bool {
    node.accesskit_node().label().is_some_and(|label| label.starts_with(with))
}

#[test]
fn levels_are_drawn_for_every_plane_and_an_idle_page_with_everything_on_asks_for_no_frame() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        harness.get_by_label("Level boundaries").click();
        harness.run();
        harness.get_by_label("Textbook approximations").click();
        harness.run();
        for plane in ["Lat", "Long"] {
            harness.get_all_by_role(Role::Button).find(|node| starts(node, plane)).expect("a switch").click();
            harness.run();
        }
        let delay =
            harness.output().viewport_output.values().map(|v| v.repaint_delay).min().expect("a viewport");
        assert!(delay > std::time::Duration::from_secs(1), "{size}: {delay:?}");
    }
}

/// Pinned, then a c.g. and a damping that bring the short period to a third of its frequency.
#[test]
fn the_pinned_poles_stay_in_sight_and_fitting_brings_them_back() {
    let mut harness = page(WIDE);
    for (title, name, link) in [
        ("All modes", ModeName::ShortPeriod, "v=1&ac=navion&cm_alpha=-0.25&cm_q=-3&pin.ac=navion"),
        ("Slow modes", ModeName::Phugoid, "v=1&ac=navion&speed=75&cd=0.02&pin.ac=navion"),
    ] {
        open(&mut harness, "v=1&ac=navion");
        let pinned = mode(&harness, name).lambda;
        open(&mut harness, link);
        harness.run_steps(60);
        let now = mode(&harness, name).lambda;
        let stands = |harness: &Page| {
            let chart = map(harness, title);
            let at = pole(harness, words::mode::title(name));
            // The same scale on both axes.
            let scale = f64::from(chart.center().y - at.y) / now.im;
            let off = (pinned - now) * scale;
            chart.contains(at + Vec2::new(off.re as f32, -off.im as f32))
        };
        assert!(now.im < 0.8 * pinned.im, "{title}: {now} {pinned}");
        assert!(stands(&harness), "{title}");
        harness.get_by_label_contains(&format!("Pole map, {title}")).focus();
        harness.run();
        for _ in 0..3 {
            harness.key_press(Key::Plus);
            harness.run();
        }
        harness.key_press(Key::Num0);
        harness.run();
        assert!(stands(&harness), "{title} after key 0");
    }
}
