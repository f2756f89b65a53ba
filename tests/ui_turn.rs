//! The aircraft turned by hand: axes and angles, and nothing else of the page.

mod page;

use egui::accesskit::Role;
use egui::{Key, Vec2};
use egui_kittest::kittest::Queryable as _;
use page::{PHONE, Page, WIDE, app, open, page};

const TURN: &str = "Turn the aircraft by hand";

fn says(page: &Page, text: &str) -> bool {
    page.query_all_by_label_contains(text).next().is_some()
}

fn click(page: &mut Page, label: &str) {
    page.get_by_label(label).click();
    page.run();
}

#[test]
fn it_is_turned_by_three_sliders_and_nothing_else_of_the_page_changes() {
    let mut page = page(WIDE);
    let (link, computed) = (app(&page).link(), app(&page).computations());
    click(&mut page, TURN);
    assert_eq!(app(&page).link(), format!("{link}&turn=0.0.0"));
    assert!(page.query_by_label("Play").is_none(), "it doesn't fly");
    assert!(says(&page, "turned by hand: heading 0.0°, pitch 0.0°, bank 0.0°"));
    for (slider, key) in
        [("First: heading ψ", Key::ArrowRight), ("Second: pitch θ", Key::End), ("Third: bank φ", Key::Home)]
    {
        page.get_by_role_and_label(Role::Slider, slider).focus();
        page.run();
        page.key_press(key);
        page.run();
    }
    assert!(says(&page, "turned by hand: heading 2.0°, pitch 90.0°, bank −180.0°"));
    assert_eq!(app(&page).link(), format!("{link}&turn=2.90.-180"));
    assert_eq!(app(&page).computations(), computed, "nothing is computed for it");
    click(&mut page, "Back to level flight to the north");
    assert!(app(&page).link().ends_with("turn=0.0.0"));
    click(&mut page, TURN);
    assert_eq!(app(&page).link(), link);
    assert!(says(&page, "Play") && !says(&page, "turned by hand"));
}

#[test]
fn what_an_axis_or_an_angle_is_is_said_in_a_sentence() {
    for size in [WIDE, PHONE] {
        let mut page = page(size);
        open(&mut page, "v=1&ac=navion&turn=30.20.10&pane=aircraft&stage=aircraft");
        assert!(says(&page, "x points forward, out of the nose"), "{size}");
        page.get_by_label("What z means").click_accesskit();
        page.run();
        assert!(says(&page, "z points down, through the floor"), "{size}");
        assert!(says(&page, "the fingers curl from x to y"), "{size}");
        page.get_by_label("What θ means").click_accesskit();
        page.run();
        assert!(says(&page, "turns second"), "{size}");
    }
}

/// Where the label of an angle is written on the picture.
fn label(page: &Page, text: &str) -> Option<egui::Pos2> {
    page.output().shapes.iter().find_map(|clipped| match &clipped.shape {
        egui::Shape::Text(shape) if shape.galley.text() == text.replace(' ', "") => {
            Some(shape.visual_bounding_rect().center())
        }
        _ => None,
    })
}

#[test]
fn the_label_of_an_angle_is_a_handle() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&turn=30.20.10&pane=aircraft");
    for (text, by, turned) in [
        ("ψ 30.0°", Vec2::new(40.0, 0.0), "turn=50.20.10"),
        ("θ 20.0°", Vec2::new(0.0, -30.0), "turn=50.35.10"),
        ("φ 10.0°", Vec2::new(-60.0, 0.0), "turn=50.35.-20"),
    ] {
        let at = label(&page, text).expect("a label");
        page.hover_at(at);
        page.run();
        page.drag_at(at);
        page.run();
        page.hover_at(at + by);
        page.run();
        page.drop_at(at + by);
        page.run();
        assert!(app(&page).link().contains(turned), "{text}: {}", app(&page).link());
    }
}

#[test]
fn every_control_of_it_is_in_the_pane_and_on_no_other() {
    for size in [WIDE, PHONE, Vec2::new(1024.0, 768.0)] {
        let mut page = page(size);
        open(&mut page, "v=1&ac=navion&turn=30.20.10&stage=aircraft");
        let names = ["First: heading ψ", "Second: pitch θ", "Third: bank φ", "What φ means"];
        let sizes = names.map(|name| page.get_by_label(name).rect());
        for (i, rect) in sizes.iter().enumerate() {
            assert!(rect.right() <= size.x && rect.width() > 10.0, "{size}: {} at {rect:?}", names[i]);
            for other in &sizes[..i] {
                assert!(!rect.shrink(1.0).intersects(*other), "{size}: {rect:?} on {other:?}");
            }
        }
    }
}
