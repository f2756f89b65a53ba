//! The page under fingers, as a browser tells of them: what scrolls, and what they work on.

mod page;

use egui::accesskit::{Role, Toggled};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::scenario::Scenario;
use page::{PHONE, Page, TABLET, app, page, type_into, value};

/// A phone that lies on its side, or a page zoomed to twice its size.
const LOW: Vec2 = Vec2::new(720.0, 450.0);

const UP: Vec2 = Vec2::new(6.0, -90.0);
const SIDEWAYS: Vec2 = Vec2::new(-60.0, 8.0);

fn scenario(page: &Page) -> &Scenario {
    app(page).scenario()
}

fn rect(page: &Page, words: &str) -> Rect {
    page.get_by_label_contains(words).rect()
}

const MAP: &str = "Pole map, All modes";
const AIRCRAFT: &str = "Navion: pitch";

/// A place of the map where nothing is.
fn empty_spot(page: &Page) -> Pos2 {
    rect(page, MAP).left_top() + Vec2::new(14.0, 24.0)
}

fn touch(page: &mut Page, finger: u64, phase: TouchPhase, pos: Pos2) {
    let (device_id, id) = (TouchDeviceId(0), TouchId(finger));
    page.input_mut().events.push(Event::Touch { device_id, id, phase, pos, force: None });
}

fn button(page: &mut Page, pos: Pos2, pressed: bool) {
    let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
    page.input_mut().events.push(Event::PointerButton { pos, button, pressed, modifiers });
}

fn put_down(page: &mut Page, at: Pos2) {
    button(page, at, true);
    touch(page, 0, TouchPhase::Start, at);
    page.step();
}

fn lift(page: &mut Page, at: Pos2) {
    button(page, at, false);
    page.input_mut().events.push(Event::PointerGone);
    touch(page, 0, TouchPhase::End, at);
    page.step();
}

/// One finger: put down, drawn in some steps, rested and lifted.
fn swipe(page: &mut Page, from: Pos2, by: Vec2) {
    put_down(page, from);
    for k in 1..=9 {
        let at = from + by * (k as f32 / 9.0);
        page.input_mut().events.push(Event::PointerMoved(at));
        touch(page, 0, TouchPhase::Move, at);
        page.step();
    }
    // So long that nothing rolls out.
    page.run_steps(8);
    lift(page, from + by);
    page.run_steps(3);
}

/// Two fingers drawn together, a hand's breadth apart.
fn swipe_by_two(page: &mut Page, from: Pos2, by: Vec2) {
    let other = Vec2::new(40.0, 10.0);
    put_down(page, from);
    button(page, from, true);
    touch(page, 1, TouchPhase::Start, from + other);
    page.step();
    for k in 1..=9 {
        let at = from + by * (k as f32 / 9.0);
        page.input_mut().events.push(Event::PointerMoved(at));
        touch(page, 0, TouchPhase::Move, at);
        touch(page, 1, TouchPhase::Move, at + other);
        page.step();
    }
    touch(page, 1, TouchPhase::End, from + by + other);
    lift(page, from + by);
    page.run_steps(3);
}

/// Whether the aircraft is seen as the page opens.
fn is_three_quarter(page: &Page) -> bool {
    page.get_by_label("Three-quarter view").accesskit_node().toggled() == Some(Toggled::True)
}

/// Another pane of a phone.
fn turn_to(page: &mut Page, pane: &str) {
    page.get_by_role_and_label(Role::Button, pane).click();
    page.run();
}

/// Where a pole is on its map.
fn on_map(page: &Page) -> Vec2 {
    rect(page, "Short period pole, ").center() - rect(page, MAP).min
}

#[test]
fn a_finger_going_up_scrolls_the_page_wherever_it_begins() {
    for size in [TABLET, LOW] {
        let mut page = page(size);
        let pole = on_map(&page);
        let spot = empty_spot(&page);
        let before = rect(&page, MAP).top();
        swipe(&mut page, spot, UP);
        let after = rect(&page, MAP).top();
        assert!((before - after - 80.0).abs() < 15.0, "{size}, the map: {before} to {after}");
        assert!((on_map(&page) - pole).length() < 0.5, "{size}: the map itself stays");
        swipe(&mut page, spot, -2.0 * UP);

        if size == LOW {
            // There the aircraft is below the responses: brought onto the screen first.
            page.get_by_label_contains(AIRCRAFT).scroll_to_me();
            page.run();
        }
        let from = rect(&page, AIRCRAFT).center().clamp(Pos2::ZERO, (0.8 * size).to_pos2());
        let before = rect(&page, AIRCRAFT).top();
        swipe(&mut page, from, if size == LOW { -UP } else { UP });
        let after = rect(&page, AIRCRAFT).top();
        assert!(((after - before).abs() - 80.0).abs() < 15.0, "{size}, the aircraft: {before} to {after}");
        assert!(is_three_quarter(&page), "{size}: nor does the aircraft turn");
    }
}

#[test]
fn a_finger_going_sideways_or_two_fingers_turn_the_aircraft_and_scroll_nothing() {
    type Fingers = fn(&mut Page, Pos2, Vec2);
    let hands: [(Fingers, Vec2); 3] = [(swipe, SIDEWAYS), (swipe_by_two, UP), (swipe_by_two, SIDEWAYS)];
    for (fingers, by) in hands {
        let mut page = page(TABLET);
        let before = rect(&page, AIRCRAFT);
        fingers(&mut page, before.center(), by);
        assert_eq!(rect(&page, AIRCRAFT).min, before.min, "{by}");
        assert!(!is_three_quarter(&page), "{by}");
    }
}

#[test]
fn two_fingers_move_the_map_with_them() {
    for (size, by) in [(TABLET, UP / 3.0), (PHONE, UP / 3.0), (PHONE, SIDEWAYS / 3.0)] {
        let mut page = page(size);
        let (before, pole) = (rect(&page, MAP), on_map(&page));
        let from = before.center() - Vec2::new(20.0, 0.0);
        swipe_by_two(&mut page, from, by);
        assert_eq!(rect(&page, MAP).min, before.min, "{size} {by}");
        let moved = on_map(&page) - pole;
        assert!((moved - by).length() < 0.25 * by.length(), "{size}: {moved}, not {by}");
    }
}

#[test]
fn a_finger_on_a_pole_takes_it_whichever_way_it_goes() {
    for size in [TABLET, PHONE] {
        let mut page = page(size);
        let (before, map) = (value(&page, "cm_alpha"), rect(&page, MAP));
        let from = rect(&page, "Short period pole, ").center();
        swipe(&mut page, from, Vec2::new(1.0, -16.0));
        assert!(value(&page, "cm_alpha") < before, "{size}: up is faster, so stiffer");
        assert_eq!(rect(&page, MAP).min, map.min, "{size}: and nothing scrolls");
    }
}

#[test]
fn on_a_phone_a_finger_going_up_on_the_map_or_a_slider_scrolls_the_sliders_and_sets_none() {
    let mut page = page(PHONE);
    let before = scenario(&page).clone();
    let slider = |page: &Page| page.get_by_role_and_label(Role::Slider, "altitude h").rect();
    let (pole, place) = (on_map(&page), slider(&page));
    let spot = empty_spot(&page);
    swipe(&mut page, spot, UP);
    let scrolled = slider(&page);
    assert!((place.top() - scrolled.top() - 80.0).abs() < 15.0, "{place} to {scrolled}");
    assert!((on_map(&page) - pole).length() < 0.5);
    swipe(&mut page, scrolled.center() + Vec2::new(20.0, 0.0), UP / 2.0);
    assert!(slider(&page).top() < scrolled.top() - 25.0, "over a slider too");
    assert_eq!(scenario(&page), &before);
    let at = slider(&page).center() + Vec2::new(20.0, 0.0);
    swipe(&mut page, at, Vec2::new(25.0, 6.0));
    assert_ne!(scenario(&page), &before, "sideways it is drawn along");
}

#[test]
fn over_the_whole_page_one_finger_works_on_the_aircraft() {
    let mut page = page(TABLET);
    page.key_press(Key::A);
    page.run();
    let from = rect(&page, AIRCRAFT).center();
    swipe(&mut page, from, UP);
    assert!(!is_three_quarter(&page));
}

#[test]
fn a_tap_on_a_plot_moves_the_cursor_and_a_finger_going_up_scrolls() {
    let mut page = page(PHONE);
    turn_to(&mut page, "Response");
    let plot = |page: &Page| {
        let mut plots = page.get_all_by_label_contains(" against time: between ");
        plots.next().expect("a plot").rect()
    };
    let before = plot(&page);
    swipe(&mut page, before.center(), UP);
    let after = plot(&page);
    assert!((before.top() - after.top() - 80.0).abs() < 15.0, "{before} to {after}");
    let time = |page: &mut Page| {
        turn_to(page, "Aircraft");
        let time = page.get_by_label("Time of the playback in s").accesskit_node().numeric_value();
        turn_to(page, "Response");
        time.expect("a time")
    };
    assert_eq!(time(&mut page), 0.0, "a swipe points at no moment");
    let at = plot(&page).center();
    put_down(&mut page, at);
    lift(&mut page, at);
    page.run();
    let tapped = time(&mut page);
    assert!(tapped > 0.0);
    swipe(&mut page, at, Vec2::new(50.0, 4.0));
    assert!(time(&mut page) > tapped, "and sideways it goes along");
}

#[test]
fn a_slider_that_is_moved_stays_where_it_is() {
    let mut page = page(PHONE);
    let place = |page: &Page| page.get_by_role_and_label(Role::Slider, "airspeed V").rect();
    let before = place(&page);
    page.get_by_role_and_label(Role::Slider, "airspeed V").focus();
    page.run();
    page.key_press(Key::ArrowRight);
    page.run();
    assert_eq!(page.query_all_by_label("Reset the group Aircraft and flight condition").count(), 1);
    assert_eq!(place(&page), before);
}

#[test]
fn why_a_number_is_refused_is_brought_into_sight() {
    // Far down: to be typed into, it is scrolled to the last row on the screen.
    for name in ["pitch stiffness C_mα", "pitch damping C_mq", "airspeed V"] {
        let mut page = page(PHONE);
        type_into(&mut page, &format!("{name}, typed"), "banana");
        let sentence = rect(&page, "is not a number");
        let panel = Rect::from_min_size(Pos2::ZERO, PHONE).shrink2(Vec2::new(0.0, 6.0));
        assert!(panel.contains_rect(sentence), "{name}: {sentence}");
    }
}

#[test]
fn a_tap_on_a_symbol_tells_what_it_means_and_how_it_moves_the_modes() {
    let mut page = page(PHONE);
    let means = "How far the centre of gravity lies behind";
    assert_eq!(page.query_all_by_label_contains(means).count(), 0);
    let symbol = rect(&page, "What shift of the centre of gravity Δx_cg/c means");
    assert!(symbol.height() >= 44.0 && symbol.width() >= 44.0, "{symbol}: a finger hits it");
    let before = scenario(&page).clone();
    put_down(&mut page, symbol.center());
    lift(&mut page, symbol.center());
    page.run();
    let card = rect(&page, means);
    assert!(card.left() >= 0.0 && card.right() <= PHONE.x, "{card}");
    page.get_by_label_contains("more of this:");
    assert_eq!(scenario(&page), &before, "nothing is moved");
    put_down(&mut page, card.center());
    lift(&mut page, card.center());
    page.run();
    assert_eq!(page.query_all_by_label_contains(means).count(), 0, "another tap closes it");
    // A number of the disturbance too.
    page.get_by_role_and_label(Role::Button, "Response").click();
    page.run_steps(12);
    let symbol = rect(&page, "What elevator in deg means");
    put_down(&mut page, symbol.center());
    lift(&mut page, symbol.center());
    page.run_steps(12);
    page.get_by_label("Elevator, trailing edge down positive; at the crest of a sine.");
}

#[test]
fn what_explains_itself_to_a_resting_mouse_does_so_to_a_finger_that_is_held() {
    let mut page = page(PHONE);
    turn_to(&mut page, "Modes");
    let text = "Press to see which paragraphs of MIL-F-8785C";
    let button = rect(&page, "Level of the short period");
    assert_eq!(page.query_all_by_label_contains(text).count(), 0);
    put_down(&mut page, button.center());
    // No finger is quite still.
    let at = button.center() + Vec2::new(0.5, 0.0);
    page.input_mut().events.push(Event::PointerMoved(at));
    touch(&mut page, 0, TouchPhase::Move, at);
    page.run_steps(8);
    assert_eq!(page.query_all_by_label_contains(text).count(), 1);
    lift(&mut page, button.center());
}

#[test]
fn the_sheet_of_a_phone_tells_first_what_fingers_do() {
    let mut page = page(PHONE);
    page.get_by_label("Help: all keys").click();
    page.run();
    let (fingers, keys) = (rect(&page, "By finger"), rect(&page, "Tab, Shift Tab"));
    assert!(fingers.top() < keys.top());
    page.get_by_label("Tap a symbol");
}

#[test]
fn every_line_of_the_list_of_aircraft_is_whole_on_a_phone() {
    let mut page = page(PHONE);
    page.get_by_role_and_label(Role::ComboBox, "Aircraft").click();
    page.run();
    let lines: Vec<Rect> = page.get_all_by_label_contains(" · ").map(|line| line.rect()).collect();
    assert!(lines.len() > 10, "{}", lines.len());
    for line in lines {
        assert!(line.left() >= 0.0 && line.right() <= PHONE.x - 8.0, "{line}");
    }
}

/// Wherever on its rail the finger begins: a slider that is not at its middle would show at once that it was set.
#[test]
fn a_finger_going_down_on_any_slider_sets_nothing() {
    let mut page = page(PHONE);
    for (name, key) in
        [("airspeed V", "speed"), ("mass m/m_0", "mass"), ("shift of the centre of gravity Δx_cg/c", "cg")]
    {
        for by in [Vec2::new(3.0, 40.0), Vec2::new(3.0, -40.0), Vec2::new(1.0, 8.0)] {
            let before = value(&page, key);
            let slider = page.get_by_role_and_label(Role::Slider, name).rect();
            swipe(&mut page, slider.center() + Vec2::new(9.0, 0.0), by);
            assert_eq!(value(&page, key), before, "{name} by {by}");
        }
    }
}

/// A browser tells of a finger as a pointer first; a frame may be drawn before it tells that it is a finger.
#[test]
fn a_finger_that_is_told_as_a_pointer_first_sets_nothing_either() {
    let mut page = page(PHONE);
    let before = value(&page, "speed");
    let at = page.get_by_role_and_label(Role::Slider, "airspeed V").rect().center() + Vec2::new(20.0, 0.0);
    button(&mut page, at, true);
    page.step();
    touch(&mut page, 0, TouchPhase::Start, at);
    page.step();
    for k in 1..=6 {
        let to = at + Vec2::new(0.5, 7.0) * k as f32;
        page.input_mut().events.push(Event::PointerMoved(to));
        touch(&mut page, 0, TouchPhase::Move, to);
        page.step();
    }
    lift(&mut page, at + Vec2::new(3.0, 42.0));
    assert_eq!(value(&page, "speed"), before);
}

/// A tap on the rail sets the slider where the finger was.
#[test]
fn a_tap_on_a_slider_sets_it() {
    for pointer_first in [false, true] {
        let mut page = page(PHONE);
        let before = value(&page, "cg");
        let rail = page.get_by_role_and_label(Role::Slider, "shift of the centre of gravity Δx_cg/c").rect();
        let at = rail.center() - Vec2::new(0.25 * rail.width(), 0.0);
        if pointer_first {
            button(&mut page, at, true);
            page.step();
            touch(&mut page, 0, TouchPhase::Start, at);
            page.step();
        } else {
            put_down(&mut page, at);
        }
        lift(&mut page, at);
        page.run_steps(3);
        assert!(value(&page, "cg") < before, "{pointer_first}");
        // At once, in one frame.
        let rail = page.get_by_role_and_label(Role::Slider, "airspeed V").rect();
        let (at, before) = (rail.center() + Vec2::new(0.25 * rail.width(), 0.0), value(&page, "speed"));
        button(&mut page, at, true);
        touch(&mut page, 0, TouchPhase::Start, at);
        lift(&mut page, at);
        page.run_steps(3);
        assert!(value(&page, "speed") > before, "{pointer_first}: in one frame");
    }
}

/// A browser tells that a pointer has gone before it tells that the finger has.
#[test]
fn a_tap_counts_while_its_touch_has_not_ended() {
    let mut page = page(PHONE);
    let before = value(&page, "cg");
    let rail = page.get_by_role_and_label(Role::Slider, "shift of the centre of gravity Δx_cg/c").rect();
    let at = rail.center() - Vec2::new(0.25 * rail.width(), 0.0);
    button(&mut page, at, true);
    page.step();
    touch(&mut page, 0, TouchPhase::Start, at);
    page.step();
    button(&mut page, at, false);
    page.step();
    touch(&mut page, 0, TouchPhase::End, at);
    page.step();
    assert!(value(&page, "cg") < before);
}
