//! The page by keyboard alone: where Tab goes, what is seen of it, and whose the arrow keys are.

mod page;

use std::collections::HashSet;

use egui::accesskit::{NodeId, Role};
use egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use page::{PHONE, Page, WIDE, app, open, page, value};

/// What has the focus: its id, what it says, where it is.
fn focused(page: &Page) -> Option<(NodeId, String, Rect)> {
    let node = page.query_by(|node| node.is_focused() && node.role() != Role::Window)?;
    let label = node.accesskit_node().label().unwrap_or_default();
    Some((node.accesskit_node().locate().0, label, node.rect()))
}

/// Every shape near a place, but for grounds that go far beyond it.
fn painted(page: &Page, near: Rect) -> Vec<String> {
    let near = near.expand(16.0);
    let shapes = page.output().shapes.iter();
    let here = shapes.filter(|clipped| {
        let rect = clipped.shape.visual_bounding_rect().intersect(clipped.clip_rect);
        rect.intersects(near) && near.expand(40.0).contains_rect(rect)
    });
    here.map(|clipped| format!("{:?}", clipped.shape)).collect()
}

#[test]
fn tab_goes_once_round_the_whole_page_and_is_seen_at_every_stop() {
    for size in [WIDE, PHONE] {
        let mut page = page(size);
        let roles = [Role::Button, Role::Slider, Role::CheckBox, Role::ComboBox, Role::TextInput];
        let reachable: HashSet<NodeId> = page
            .query_all_by(|node| roles.contains(&node.role()) && !node.is_disabled())
            .map(|node| node.accesskit_node().locate().0)
            .collect();
        let (mut stops, mut seen) = (Vec::new(), HashSet::new());
        loop {
            page.key_press(Key::Tab);
            // So long that what is out of sight has been scrolled to.
            page.run_steps(25);
            let (id, label, rect) = focused(&page).expect("something has the focus");
            if !seen.insert(id) {
                assert_eq!(Some(&id), stops.first(), "{size}: from the last to the first, not to {label}");
                break;
            }
            stops.push(id);
            let with = painted(&page, rect);
            page.key_press(Key::Escape);
            page.step();
            page.step();
            assert_eq!(focused(&page), None);
            assert!(painted(&page, rect) != with, "{size}: nothing shows that {label} has the focus");
            let node = page.query_by(|node| node.locate().0 == id).expect("it is still there");
            node.focus();
            page.step();
            page.step();
            assert!(stops.len() < 200, "{size}: no end");
        }
        assert!(stops.len() > 40, "{size}: {}", stops.len());
        let missed: Vec<String> = page
            .query_all_by(|node| reachable.contains(&node.locate().0) && !seen.contains(&node.locate().0))
            .map(|node| format!("{:?}", node.accesskit_node().label()))
            .collect();
        assert!(missed.is_empty(), "{size}: never reached: {missed:?}");
    }
}

#[test]
fn the_tools_are_reached_in_the_order_of_reading() {
    let mut page = page(WIDE);
    page.get_by_role_and_label(Role::Button, "Lateral–directional").focus();
    page.run();
    let mut right = 0.0;
    // Undo and redo have nothing to do yet.
    for name in ["Lessons", "Present", "Share link", "Take the scene", "Pin this state", "theme", "Help"] {
        page.key_press(Key::Tab);
        page.run();
        let (_, label, rect) = focused(&page).expect("something has the focus");
        assert!(label.contains(name) && rect.left() > right, "{label} at {rect}");
        right = rect.right();
    }
}

#[test]
fn an_arrow_key_in_the_very_next_frame_works_on_what_tab_has_reached_and_stays_there() {
    for name in ["trim lift C_L", "Time of the playback in s", "trim drag C_D, typed", "Find a derivative"] {
        for (there, modifiers) in [(Key::ArrowRight, Modifiers::NONE), (Key::ArrowDown, Modifiers::NONE)] {
            let mut page = page(WIDE);
            page.get_by_label(name).focus();
            page.step();
            page.key_press_modifiers(modifiers, there);
            page.step();
            page.step();
            let (_, label, _) = focused(&page).expect("something has the focus");
            assert_eq!(label, name, "{there:?}");
        }
    }
    let mut page = page(WIDE);
    let before = value(&page, "cl");
    page.get_by_label("trim lift C_L").focus();
    page.step();
    page.key_press(Key::ArrowRight);
    page.step();
    assert!(value(&page, "cl") > before);
}

#[test]
fn enter_and_space_press_and_escape_closes_what_is_in_front_first() {
    let mut page = page(WIDE);
    let toggled = |page: &Page, name: &str| page.get_by_label(name).accesskit_node().toggled();
    for key in [Key::Enter, Key::Space] {
        let before = toggled(&page, "Level boundaries");
        page.get_by_label("Level boundaries").focus();
        page.run();
        page.key_press(key);
        page.run();
        assert_ne!(toggled(&page, "Level boundaries"), before, "{key:?}");
    }
    // A list over a pane over the page: each Escape closes one.
    page.key_press(Key::Escape);
    page.run();
    page.key_press(Key::R);
    page.run();
    assert!(page.query_by_label_contains("Pole map, All modes").is_none());
    page.get_by_role_and_label(Role::ComboBox, "Disturbance").click();
    page.run();
    let open = page.query_all_by_role(Role::Button).count();
    page.key_press(Key::Escape);
    page.run();
    assert!(page.query_all_by_role(Role::Button).count() < open, "the list is closed");
    assert!(page.query_by_label_contains("Pole map, All modes").is_none(), "the pane is not");
    page.key_press(Key::Escape);
    page.run();
    assert!(page.query_by_label_contains("Pole map, All modes").is_some(), "now it is");
}

/// "Drag, then Space": what was clicked last has no use for Space, so that the motion plays.
#[test]
fn space_plays_after_a_click_on_a_slider_and_page_keys_edit_nothing() {
    let mut page = page(WIDE);
    page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").click();
    page.run();
    let slider = focused(&page).expect("the slider has the focus").1;
    assert!(slider.contains("pitch stiffness"), "{slider}");
    let before = value(&page, "cm_alpha");
    for key in [Key::PageUp, Key::PageDown] {
        page.key_press(key);
        page.run();
        assert_eq!(value(&page, "cm_alpha"), before, "{key:?}");
    }
    page.key_press(Key::Space);
    page.run_steps(3);
    page.get_by_label("Pause");
    page.key_press(Key::Space);
    page.run();
    page.get_by_label("Play");
    assert_eq!(value(&page, "cm_alpha"), before);
}

/// A machine that was put to sleep: the page's clock, which nobody can set, has gone on or has not.
#[test]
fn a_page_that_has_slept_for_an_hour_goes_on_where_it_was_and_undoes_what_was_done_before() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&time=60");
    let mut now = page.ctx.input(|input| input.time);
    let mut frame = |page: &mut Page, after: f64| {
        now += after;
        page.input_mut().time = Some(now);
        page.step();
    };
    page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    frame(&mut page, 0.1);
    let before = value(&page, "cm_alpha");
    page.key_press(Key::ArrowRight);
    frame(&mut page, 0.1);
    let edited = value(&page, "cm_alpha");
    assert_ne!(edited, before);
    page.key_press(Key::Space);
    for after in [0.1, 0.2, 3600.0, 0.2] {
        frame(&mut page, after);
    }
    page.key_press(Key::Space);
    frame(&mut page, 0.1);
    let link = app(&page).link_with_instant();
    let played = link.split('&').find_map(|piece| piece.strip_prefix("t=")).map(str::parse::<f64>);
    let played = played.expect("it has played").expect("a number");
    assert!((0.3..5.0).contains(&played), "{played}");
    page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    frame(&mut page, 0.1);
    assert_eq!(value(&page, "cm_alpha"), before);
}
