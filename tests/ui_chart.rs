//! The chart of a measure over a slider: chosen, opened from a slider, held with the pointer, moved by keys, with lines of one's own.

mod page;

use egui::accesskit::Role;
use egui::{Key, PointerButton, Pos2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use page::{PHONE, Page, TABLET, WIDE, app, open, page, type_into, value};

fn press(page: &mut Page, name: &str) {
    page.get_by_role_and_label(Role::Button, name).click_accesskit();
    page.run();
}

fn click_at(page: &mut Page, pos: Pos2) {
    page.drag_at(pos);
    page.run();
    release_at(page, pos);
}

fn release_at(page: &mut Page, pos: Pos2) {
    let (button, modifiers) = (PointerButton::Primary, egui::Modifiers::NONE);
    page.event(egui::Event::PointerButton { pos, button, pressed: false, modifiers });
    page.run();
}

fn to_response(page: &mut Page) {
    if page.ctx.content_rect().width() < 700.0 {
        press(page, "Response");
    }
}

fn plot(page: &Page) -> egui::Rect {
    let plots = page.query_all_by_role(Role::Image);
    let chart = plots.into_iter().find(|node| {
        node.accesskit_node()
            .label()
            .is_some_and(|label| label.contains("in  against") || label.contains("against C_mα"))
    });
    chart.expect("a chart").rect()
}

fn has(page: &Page, words: &str) -> bool {
    page.query_all_by_label_contains(words).next().is_some()
}

/// Opens a chooser, searches in it, and takes the first with Enter.
fn choose_by_search(page: &mut Page, chooser: &str, search: &str) {
    let button = |label: &str| label.starts_with(chooser);
    page.query_all_by_role(Role::Button)
        .find(|node| node.accesskit_node().label().is_some_and(|label| button(&label)))
        .expect("a chooser")
        .click();
    page.run();
    let field = format!("Find a {}", chooser.to_lowercase());
    page.get_by_role_and_label(Role::TextInput, &field).focus();
    page.run();
    page.get_by_role_and_label(Role::TextInput, &field).type_text(search);
    page.run();
    page.key_press(Key::Enter);
    page.run();
}

#[test]
fn any_measure_is_charted_over_any_slider_by_search_at_every_size() {
    for size in [WIDE, TABLET, PHONE] {
        let mut page = page(size);
        to_response(&mut page);
        press(&mut page, "Chart");
        assert!(has(&page, "Measure of the chart: damping ratio of the short period"), "{size}");
        assert!(has(&page, "Slider of the chart: Δx_cg/c · shift of the centre of gravity"), "{size}");
        choose_by_search(&mut page, "Measure of the chart", "static margin");
        choose_by_search(&mut page, "Slider of the chart", "cma");
        assert!(has(&page, "Measure of the chart: static margin"), "{size}");
        assert!(app(&page).link().contains("tab=chart&"), "{}", app(&page).link());
        assert!(
            app(&page).link().contains("&lon.chart=static_margin&lon.over=cm_alpha"),
            "{}",
            app(&page).link()
        );
        assert!(has(&page, "Now 15.4\u{a0}% at C_mα = −0.683"), "{size}");
    }
}

#[test]
fn the_chart_is_held_and_moves_the_slider_and_a_drag_is_one_step_back() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&tab=chart&lon.over=cm_alpha");
    let before = value(&page, "cm_alpha");
    let frame = plot(&page);
    let at = |part: f32| Pos2::new(frame.left() + part * frame.width(), frame.center().y);
    page.drag_at(at(0.1));
    page.run();
    let first = value(&page, "cm_alpha");
    assert!(first != before);
    page.hover_at(at(0.2));
    page.run();
    page.hover_at(at(0.35));
    page.run();
    let last = value(&page, "cm_alpha");
    release_at(&mut page, at(0.35));
    assert!(last > first && value(&page, "cm_alpha") == last, "{first} {last}");
    assert!(has(&page, &format!("at C_mα = {}", eigenwing::number::trimmed(last, 4))));
    page.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
    page.run();
    assert_eq!(value(&page, "cm_alpha"), before);
}

#[test]
fn the_slider_below_the_chart_is_moved_by_keys() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&tab=chart&lon.over=cm_alpha");
    let before = value(&page, "cm_alpha");
    let below = page.query_all_by_label_contains(", below the chart").next().expect("a slider");
    below.focus();
    page.run();
    page.key_press(Key::ArrowRight);
    page.run();
    assert!(value(&page, "cm_alpha") > before);
    page.key_press(Key::Delete);
    page.run();
    assert_eq!(value(&page, "cm_alpha"), before);
}

#[test]
fn lines_of_ones_own_are_typed_travel_in_the_link_and_are_taken_away() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&tab=chart&lon.chart=static_margin");
    type_into(&mut page, "line at, in %", "12");
    assert!(app(&page).link().contains("lon.lines=0.12"), "{}", app(&page).link());
    type_into(&mut page, "line at, in %", "zwölf");
    assert!(has(&page, "zwölf"));
    press(&mut page, "Remove the line at 12\u{a0}%");
    assert!(!app(&page).link().contains("lines"));
}

#[test]
fn a_symbol_of_a_slider_leads_to_a_chart_over_it() {
    for size in [WIDE, PHONE] {
        let mut page = page(size);
        if size == PHONE {
            let button = |label: &str| label.ends_with("C_mα means");
            let symbol = page
                .query_all_by_role(Role::Button)
                .find(|node| node.accesskit_node().label().is_some_and(|label| button(&label)));
            symbol.expect("the symbol of a slider").click_accesskit();
            page.run();
        } else {
            // Who has a mouse clicks on the symbol, left of its slider.
            let slider = page.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").rect();
            click_at(&mut page, Pos2::new(slider.left() - 40.0, slider.center().y));
        }
        press(&mut page, "Chart a measure over this slider");
        assert!(app(&page).link().contains("tab=chart") && app(&page).link().contains("lon.over=cm_alpha"));
        assert!(has(&page, "Slider of the chart: C_mα"), "{size}");
    }
}

#[test]
fn a_chart_says_what_it_can_t_show() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&tab=chart&lon.chart=nonsense");
    assert!(has(&page, "There is no measure “nonsense” that could be charted"));
    open(&mut page, "v=1&ac=navion&tab=chart&hide=numbers");
    assert!(has(&page, "The numbers are hidden in this scene"));
    assert!(!has(&page, "Measure of the chart"));
    open(&mut page, "v=1&ac=navion&tab=chart&cm_alpha=0.2");
    assert!(has(&page, "No reading now: no mode is called short period"));
}
