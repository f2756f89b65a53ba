//! Numbers in the units that a person reads.

mod page;

use egui::Key;
use egui_kittest::kittest::Queryable as _;
use eigenwing::scenario::Parameter;
use page::{Page, WIDE, app, open, page};

fn says(page: &Page, text: &str) -> bool {
    page.query_all_by_label_contains(text).next().is_some()
}

fn press(page: &mut Page, key: Key) {
    page.key_press(key);
    page.run();
}

#[test]
fn a_key_goes_from_the_source_to_metres_to_feet_and_back_and_the_link_tells_it() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=lesson&page=matrix");
    assert!(says(&page, "100 ft/s"), "the lesson counts in hundreds of feet");
    press(&mut page, Key::U);
    assert!(!says(&page, "ft/s") && says(&page, "m/s²"));
    assert!(app(&page).link().contains("&units=si"));
    press(&mut page, Key::U);
    assert!(!says(&page, "100 ft/s") && says(&page, "ft/s²"));
    assert!(app(&page).link().contains("&units=ft"));
    press(&mut page, Key::U);
    assert!(says(&page, "100 ft/s") && !app(&page).link().contains("units"));
}

#[test]
fn a_speed_is_shown_and_typed_in_feet() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&units=ft");
    assert!(says(&page, "ft/s"), "its speeds are in feet");
    let scenario = app(&page).scenario();
    let speed = Parameter::find("speed").expect("a row");
    let typed = speed.parse(scenario, "200").expect("a speed that it can fly");
    assert!((typed - 60.96).abs() < 1e-9, "200 ft/s are 60.96 m/s, not {typed}");
}

#[test]
fn who_reads_feet_goes_on_reading_feet_with_another_aircraft_and_a_link_that_says_nothing_of_units() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&units=ft");
    open(&mut page, "v=1&ac=b747-approach");
    assert!(app(&page).link().contains("&units=ft"));
    open(&mut page, "v=1&ac=navion&units=source");
    assert!(!app(&page).link().contains("units"));
}

#[test]
fn a_lesson_tells_its_numbers_in_the_same_units() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&units=ft");
    let number = |page: &Page| app(page).findings().scenario().units;
    assert_eq!(number(&page), eigenwing::scenario::Units::Feet);
    open(&mut page, "v=1&lesson=equations");
    page.run();
    assert!(app(&page).link().contains("&units=ft"), "a step keeps the units");
}

#[test]
fn a_key_writes_the_equations_in_angles_and_the_link_tells_it() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&page=dimensional");
    assert!(says(&page, "pitch stiffness Mw"), "the slider of M_w");
    press(&mut page, Key::N);
    assert!(says(&page, "pitch stiffness Mα") && !says(&page, "pitch stiffness Mw"));
    assert!(app(&page).link().contains("&notation=alpha-beta"));
    open(&mut page, "v=1&ac=b747-approach&page=matrix");
    assert!(says(&page, "row α dot, column q"), "another aircraft keeps it");
    press(&mut page, Key::N);
    assert!(says(&page, "row w dot, column q") && !app(&page).link().contains("notation"));
}

#[test]
fn the_equations_have_a_choice_of_notation_of_their_own() {
    let mut page = page(WIDE);
    open(&mut page, "v=1&ac=navion&page=matrix");
    page.get_by_label("α and β").click();
    page.run();
    assert!(says(&page, "row α dot, column q"));
    page.get_by_label("w and v").click();
    page.run();
    assert!(says(&page, "row w dot, column q"));
}

#[test]
fn sentences_of_what_can_t_be_flown_are_in_the_units_of_the_sliders() {
    let mut page = page(WIDE);
    for (units, speed) in [("si", "at 20.0 m/s"), ("ft", "at 65.6 ft/s")] {
        open(&mut page, &format!("v=1&ac=navion&speed=20&units={units}"));
        assert!(says(&page, speed), "{units}");
    }
    // A gust is a speed like any other.
    for (units, axis) in [("si", "w_g in m/s"), ("ft", "w_g in ft/s")] {
        open(&mut page, &format!("v=1&ac=navion&lon.source=vertical-gust&tab=time&units={units}"));
        assert!(says(&page, axis), "{units}");
    }
}
