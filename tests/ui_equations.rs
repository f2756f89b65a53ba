//! The equations on the page: read by place and value, reached by keyboard, led from to their sliders.

mod page;

use egui::accesskit::Role;
use egui::{Key, Rect, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use page::{PHONE, Page, WIDE, app, choose, open, page, type_into};

const MATRIX: &str = "v=1&ac=navion&page=matrix";

fn opened(size: Vec2, link: &str) -> Page {
    let mut page = page(size);
    open(&mut page, link);
    page
}

/// What is said of every entry, and where it is.
fn entries(page: &Page) -> Vec<(String, Rect)> {
    let is_entry = |label: &str| label.starts_with("A, row") || label.starts_with("B, row");
    let all = page.query_all_by_role(Role::Button);
    all.filter_map(|node| Some((node.accesskit_node().label().filter(|label| is_entry(label))?, node.rect())))
        .collect()
}

fn entry(page: &Page, place: &str) -> String {
    let found = entries(page).into_iter().find(|(label, _)| label.starts_with(place));
    found.map(|(label, _)| label).unwrap_or_default()
}

fn focused(page: &Page) -> String {
    let node = page.query_by(|node| node.is_focused() && node.role() != Role::Window);
    node.and_then(|node| node.accesskit_node().label()).unwrap_or_default()
}

fn press(page: &mut Page, key: Key) {
    page.key_press(key);
    page.run();
}

fn says(page: &Page, text: &str) -> bool {
    page.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn every_entry_is_read_by_its_row_its_column_and_its_value() {
    let page = opened(WIDE, MATRIX);
    assert_eq!(entries(&page).len(), 24);
    assert_eq!(
        entry(&page, "A, row u dot, column θ"),
        "A, row u dot, column θ: −g cos θ_0 = −9.81 m/s²; 10 % of it move the short period by 0.019 %"
    );
    assert_eq!(entry(&page, "B, row q dot, column δe"), "B, row q dot, column δe: M′_δe = −11.1 1/s²");
    assert!(says(&page, "Drag equation"), "the first row in words");
    assert!(says(&page, "λ4 + 5.053 λ3 + 13.23 λ2 + 0.6744 λ + 0.5939 ="));
    assert!(says(&page, "(λ2 + 5.019 λ + 13.02)") && says(&page, "(λ2 + 0.03422 λ + 0.04562)"));
}

#[test]
fn they_follow_the_sliders_in_the_same_frame() {
    let mut page = opened(WIDE, MATRIX);
    open(&mut page, "v=1&ac=navion&page=matrix&a_uw=0.1");
    assert!(entry(&page, "A, row u dot, column w").contains("X_w = 0.1 1/s"));
}

#[test]
fn a_click_on_an_entry_leads_to_its_slider_and_says_its_row() {
    let mut page = opened(WIDE, MATRIX);
    page.get_by_label_contains("A, row q dot, column w").click();
    page.run();
    assert_eq!(focused(&page), "pitch stiffness M′_w");
    assert!(says(&page, "Pitching moment over"));
    page.get_by_label("To the slider of heave damping Z_w").click();
    page.run();
    assert_eq!(focused(&page), "heave damping Z_w");
    assert!(app(&page).link().contains("page=dimensional"), "{}", app(&page).link());
}

#[test]
fn the_arrow_keys_go_from_entry_to_entry_and_enter_to_the_slider() {
    let mut page = opened(WIDE, MATRIX);
    page.get_by_label_contains("A, row u dot, column u").focus();
    page.run();
    for key in [Key::ArrowDown, Key::ArrowDown, Key::ArrowRight, Key::ArrowRight] {
        press(&mut page, key);
    }
    assert!(focused(&page).starts_with("A, row q dot, column q"), "{}", focused(&page));
    for _ in 0..9 {
        press(&mut page, Key::ArrowLeft);
    }
    assert!(focused(&page).starts_with("A, row q dot, column u"), "{}", focused(&page));
    press(&mut page, Key::Enter);
    assert_eq!(focused(&page), "pitching moment due to speed M′_u");
}

#[test]
fn symbols_and_what_they_are_made_of_come_by_turns_with_the_numbers() {
    let mut page = opened(WIDE, MATRIX);
    page.get_by_label("Entries as symbols").click();
    page.run();
    assert!(says(&page, "u\u{307} = Xu u + Xw w + (Xq − W0) q − g cos θ0 θ + Xδe δe + Xδt δt"));
    page.get_by_label("Entries as what they are made of").click();
    page.get_by_label_contains("A, row w dot, column w").click();
    page.run();
    assert!(says(&page, "w\u{307} = Zu/D u + Zw/D w + (U0 + Zq)/D q − g sin θ0/D θ"), "a row of the lift");
    assert!(says(&page, "D = 1 − Zẇ = 1"));
    assert!(app(&page).link().contains("entries=full"));
}

#[test]
fn bare_matrices_have_numbers_only() {
    let page = opened(WIDE, "v=1&ac=lesson&entries=full");
    assert!(page.get_by_label("Entries as symbols").accesskit_node().is_disabled());
    assert_eq!(
        entry(&page, "A, row w dot, column q").split(';').next(),
        Some("A, row w dot, column q = 1.76 100 ft/s")
    );
    assert!(says(&page, "u\u{307} = −0.045 u + 0.036 w + 0 q − 0.322 θ"));
}

#[test]
fn the_mode_that_colours_the_entries_is_chosen_and_said() {
    let mut page = opened(WIDE, MATRIX);
    choose(&mut page, "Coloured by", "Phugoid");
    assert!(entry(&page, "A, row u dot, column u").contains("10 % of it move the phugoid by 1"));
    assert!(says(&page, "how far 10 % of an entry move the pole of the phugoid"));
    assert!(app(&page).link().ends_with("coloured=2"));
    choose(&mut page, "Coloured by", "no mode");
    assert!(!entry(&page, "A, row u dot, column u").contains("move"));
}

#[test]
fn they_stand_alone_by_key_by_button_by_link_and_as_a_part_of_the_stage() {
    let mut by_key = page(WIDE);
    press(&mut by_key, Key::E);
    let mut by_button = page(WIDE);
    by_button.get_by_label("Equations").click();
    by_button.run();
    let by_link = opened(WIDE, "v=1&ac=navion&pane=equations");
    for page in [&by_key, &by_button, &by_link] {
        assert_eq!(entries(page).len(), 24);
        assert!(app(page).link().contains("pane=equations"));
        assert!(page.query_by_label("Maximise the pole map").is_none());
    }
    press(&mut by_key, Key::Escape);
    assert_eq!(entries(&by_key).len(), 0);
    for size in [WIDE, PHONE] {
        let page = opened(size, "v=1&ac=navion&stage=equations");
        assert_eq!(entries(&page).len(), 24, "{size}");
        let page = opened(size, "v=1&ac=navion&pane=equations");
        assert_eq!(entries(&page).len(), 24, "{size}");
    }
    assert_eq!(entries(&page(WIDE)).len(), 0, "only where they are named");
}

#[test]
fn without_sliders_an_entry_leads_nowhere_and_says_its_row() {
    let mut page = opened(WIDE, "v=1&ac=navion&stage=equations.poles");
    page.get_by_label_contains("A, row q dot, column w").click();
    page.run();
    assert!(says(&page, "Pitching moment over"));
    assert!(!says(&page, "To the slider of") && !app(&page).link().contains("page="));
}

#[test]
fn who_searches_for_the_equations_is_told_where_they_are() {
    let mut page = page(WIDE);
    type_into(&mut page, "Find a derivative", "equat");
    assert!(says(&page, "The equations are behind the button beside this field"));
}

#[test]
fn what_a_question_hides_is_not_told_by_the_equations() {
    let page = opened(WIDE, "v=1&ac=navion&page=matrix&hide=names.numbers.reasons");
    assert_eq!(entry(&page, "A, row u dot, column w"), "A, row u dot, column w: X_w = 0.036 1/s");
    assert!(!says(&page, "λ4") && !says(&page, "short period"));
    assert!(page.query_by_role_and_label(Role::ComboBox, "Coloured by").is_none());
}

#[test]
fn entries_never_lie_on_each_other_however_narrow_the_page_is() {
    for (width, link) in [
        (300.0, MATRIX),
        (390.0, MATRIX),
        (300.0, "v=1&ac=navion&stage=equations&entries=full"),
        (390.0, "v=1&ac=navion&stage=equations&entries=symbols&plane=lat"),
        (1440.0, "v=1&ac=b747-fc9&stage=equations&entries=full"),
    ] {
        let page = opened(Vec2::new(width, 844.0), link);
        let entries = entries(&page);
        assert_eq!(entries.len(), 24);
        for (i, (label, rect)) in entries.iter().enumerate() {
            for (other, of_other) in &entries[..i] {
                let common = rect.intersect(*of_other);
                assert!(common.width() < 0.5 || common.height() < 0.5, "{width}: {label} on {other}");
            }
        }
        // What is written in an entry stays within it.
        let texts = page.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) => Some(text.visual_bounding_rect()),
            _ => None,
        });
        let within = texts.filter(|text| {
            entries
                .iter()
                .any(|(_, entry)| entry.contains(text.center()) && entry.expand(1.0).contains_rect(*text))
        });
        assert!(within.count() >= 12, "{width}");
    }
}

/// Y_v is no longer Y_v + Δ once something is added to the entry that it was.
#[test]
fn what_is_added_to_an_entry_makes_no_false_equation() {
    let page = opened(WIDE, "v=1&ac=navion&plane=lateral&page=matrix&entries=full&add.a_vv=0.1");
    assert!(page.query_all_by_label_contains("Yv + Δ = −0.15").next().is_some());
    assert!(page.query_all_by_label_contains("Yv = Yv").next().is_none());
}
