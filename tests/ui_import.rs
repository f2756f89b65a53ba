//! A person's own aircraft on the page: dropped, pasted, reviewed, used, kept, deleted.

mod page;

use std::path::Path;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Event, Key};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::ui::App;
use page::{PHONE, Page, WIDE, app, page, type_into};

#[derive(Debug)]
struct Dropped(&'static str, Vec<u8>);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        Path::new(self.0)
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.clone())
    }
}

/// The Navion by Nelson, longitudinal, in feet.
const MATRICES: &str = "states = {'u', 'w', 'q', 'theta'};\ninputs = {'elevator'};\n\
    A = [-0.045 0.036 0 -32.2; -0.369 -2.02 176 0; 0.0019 -0.0396 -2.948 0; 0 0 1 0];\n\
    B = [0; -28.17; -11.87; 0];\n";

fn state(page: &mut Page) -> &mut App {
    page.state_mut().as_mut().expect("the page has been drawn")
}

fn drop_file(page: &mut Page, name: &'static str, bytes: &[u8]) {
    page.input_mut().dropped_files.push(Arc::new(Dropped(name, bytes.to_vec())));
    page.run_steps(8);
}

fn press(page: &mut Page, name: &str) {
    page.get_by_role_and_label(Role::Button, name).click_accesskit();
    page.run_steps(8);
}

fn has(page: &Page, words: &str) -> bool {
    page.query_all_by_label_contains(words).next().is_some()
}

/// Takes what the review suggests until nothing is missing.
fn take_suggestions(page: &mut Page) {
    for _ in 0..12 {
        let Some(button) = page.query_all_by_role(Role::Button).find(|node| {
            node.accesskit_node()
                .label()
                .is_some_and(|label| label.starts_with("Take ") && label != "Take the scene along")
        }) else {
            break;
        };
        button.click_accesskit();
        page.run_steps(8);
    }
}

#[test]
fn matrices_that_are_dropped_are_reviewed_used_kept_and_deleted() {
    for size in [WIDE, PHONE] {
        let mut page = page(size);
        drop_file(&mut page, "mine.m", MATRICES.as_bytes());
        assert!(has(&page, "mine.m: matrices as MATLAB"), "{size}");
        assert!(has(&page, "Eigenvalues, longitudinal"), "{size}");
        take_suggestions(&mut page);
        press(&mut page, "Use this aircraft");
        let key = app(&page).scenario().aircraft.key.clone();
        assert!(key.starts_with("own-"), "{key}");
        assert_eq!(app(&page).findings().modes().len(), 2, "{size}");
        // It travels in the link, and is there when the page is opened again.
        assert!(app(&page).link().contains("own="), "{}", app(&page).link());
        let kept = state(&mut page).take_changed_aircraft().expect("it is kept");
        assert!(state(&mut page).take_changed_aircraft().is_none());
        let mut again = page::page(size);
        state(&mut again).take_up_aircraft(&kept, "");
        again.key_press(Key::O);
        again.run();
        let name = app(&page).scenario().aircraft.name.clone();
        press(&mut again, &name);
        assert_eq!(app(&again).scenario().aircraft.key, key);
        again.key_press(Key::O);
        again.run();
        press(&mut again, &format!("Delete {name}"));
        assert_eq!(state(&mut again).take_changed_aircraft().as_deref(), Some("[]"));
        assert!(!has(&again, "On this device"));
    }
}

#[test]
fn aircraft_of_one_name_that_two_tabs_have_kept_are_both_there() {
    let keep = |matrices: &str| {
        let mut page = page(WIDE);
        drop_file(&mut page, "mine.m", matrices.as_bytes());
        take_suggestions(&mut page);
        press(&mut page, "Use this aircraft");
        page
    };
    let (mut one, mut other) = (keep(MATRICES), keep(&MATRICES.replace("-2.02", "-1.8")));
    let kept = state(&mut one).take_changed_aircraft().expect("it is kept");
    let count = |page: &mut Page| {
        let files = state(page).take_changed_aircraft().expect("it is kept");
        files.matches("\"name\":\"own-").count()
    };
    for _ in 0..2 {
        state(&mut other).take_up_aircraft(&kept, "");
        assert_eq!(count(&mut other), 2, "taken up again, it is the same");
    }
}

#[test]
fn an_aircraft_that_was_deleted_in_one_tab_does_not_come_back_with_another() {
    let mut one = page(WIDE);
    for (name, damping) in [("first.m", "-2.02"), ("second.m", "-1.8")] {
        drop_file(&mut one, name, MATRICES.replace("-2.02", damping).as_bytes());
        take_suggestions(&mut one);
        press(&mut one, "Use this aircraft");
    }
    let both = state(&mut one).take_changed_aircraft().expect("they are kept");
    let mut other = page(WIDE);
    state(&mut other).take_up_aircraft(&both, "");
    let _ = state(&mut other).take_changed_aircraft();
    let delete = |page: &mut Page, name: &str| {
        page.key_press(Key::O);
        page.run();
        press(page, name);
        page.key_press(Key::Escape);
        page.run();
        state(page).take_changed_aircraft().expect("one less")
    };
    let names = |json: &str| -> Vec<String> {
        let files: serde_json::Value = serde_json::from_str(json).expect("JSON");
        files.as_array().expect("files").iter().map(|file| file["name"].to_string()).collect()
    };
    let kept = names(&both);
    assert_eq!(kept.len(), 2);
    let stored = delete(&mut one, "Delete first.m");
    assert_eq!(names(&stored), kept[1..]);
    // The other tab deletes the second, with both in mind.
    let here = delete(&mut other, "Delete second.m");
    assert_eq!(names(&here), kept[..1]);
    state(&mut other).take_up_aircraft(&stored, &both);
    let left = state(&mut other).take_changed_aircraft().expect("to be stored");
    assert_eq!(left, "[]", "both are gone");
    state(&mut one).take_up_aircraft(&left, &stored);
    assert_eq!(state(&mut one).take_changed_aircraft().as_deref(), Some("[]"));
    one.key_press(Key::O);
    one.run();
    assert!(!has(&one, "On this device"));
}

/// What is opened on one device goes on to another by its link, and stays there if that is wanted.
#[test]
fn an_aircraft_that_came_with_a_link_can_be_kept_with_what_was_changed_on_it() {
    let mut page = page(WIDE);
    drop_file(&mut page, "mine.m", MATRICES.as_bytes());
    take_suggestions(&mut page);
    press(&mut page, "Use this aircraft");
    let link = format!("{}&a_ww=-1.5", app(&page).link());
    let mut other = page::page(WIDE);
    page::open(&mut other, &link);
    assert_eq!(page::value(&other, "a_ww"), -1.5);
    other.key_press(Key::O);
    other.run();
    assert!(has(&other, "came with a link") && !has(&other, "On this device"));
    press(&mut other, "Keep it on this device");
    assert!(has(&other, "On this device") && !has(&other, "came with a link"));
    assert!(state(&mut other).take_changed_aircraft().expect("it is kept").contains("own-"));
    assert_eq!(page::value(&other, "a_ww"), -1.5);
    assert!(app(&other).scenario().aircraft.key.starts_with("own-"));
}

/// Height and the elevator behind its actuator: they are seen as modes, and the words speak of no law.
#[test]
fn states_beside_the_four_are_modes_on_the_page() {
    const WITH_MORE: &str = "% units: SI\n% speed: 50\n% states: u alpha q theta h de\n% inputs: elevator\n\
        A = [-0.05 4 0 -9.81 2e-5 0; -0.007 -2 1 0 0 -0.16; 0 -8 -3 0 0 -11; 0 0 1 0 0 0; 0 -50 0 50 0 0; 0 0 0 0 0 -10];\n\
        B = [0;0;0;0;0;10];\n";
    for size in [WIDE, PHONE] {
        let mut page = page(size);
        drop_file(&mut page, "more.m", WITH_MORE.as_bytes());
        press(&mut page, "Use this aircraft");
        let names: Vec<ModeName> =
            app(&page).findings().flown_modes().iter().map(|mode| mode.naming.name).collect();
        assert_eq!(
            names,
            [ModeName::ShortPeriod, ModeName::Phugoid, ModeName::Height, ModeName::ElevatorActuator],
            "{size}"
        );
        if size == WIDE {
            assert!(has(&page, "Elevator actuator") && has(&page, "Height"), "the cards");
            assert!(has(&page, "With the states that the file has beside these four"));
            assert!(!has(&page, "law of feedback"));
        }
    }
}

#[test]
fn the_same_file_twice_is_one_aircraft() {
    let mut page = page(WIDE);
    let mut keys = Vec::new();
    for _ in 0..2 {
        drop_file(&mut page, "mine.m", MATRICES.as_bytes());
        take_suggestions(&mut page);
        press(&mut page, "Use this aircraft");
        keys.push(app(&page).scenario().aircraft.key.clone());
    }
    assert_eq!(keys[0], keys[1]);
}

#[test]
fn matrices_that_are_pasted_over_the_page_or_into_the_sheet_are_read() {
    let mut page = page(WIDE);
    page.input_mut().events.push(Event::Paste(MATRICES.to_owned()));
    page.run_steps(8);
    assert!(has(&page, "pasted text: matrices"));
    press(&mut page, "Another file");
    page.get_by_role_and_label(Role::MultilineTextInput, "Matrices or a file, as text").focus();
    page.run_steps(8);
    page.input_mut().events.push(Event::Paste(MATRICES.to_owned()));
    page.run_steps(8);
    press(&mut page, "Read the text");
    assert!(has(&page, "pasted text: matrices"));
}

#[test]
fn a_file_that_can_t_be_read_says_so_in_one_sentence() {
    let mut page = page(WIDE);
    drop_file(&mut page, "photo.png", &[0x89, 0x50, 0x4e, 0x47, 0, 0, 0, 1]);
    assert!(has(&page, "photo.png, line 1: "), "where it happened");
    press(&mut page, "Cancel");
    assert!(!has(&page, "photo.png"));
}

#[test]
fn a_field_takes_a_number_with_its_unit_and_refuses_what_is_none() {
    let mut page = page(WIDE);
    let file = include_bytes!("data/import/navion-datcom.out");
    drop_file(&mut page, "navion.out", file);
    assert!(has(&page, "Digital DATCOM"));
    let missing = |page: &Page| {
        let fields = page.query_all_by_role(Role::TextInput);
        fields.filter_map(|node| node.accesskit_node().label()).find(|label| label.ends_with("– missing"))
    };
    let name = missing(&page).expect("a DATCOM output has no mass");
    type_into(&mut page, &name, "many");
    assert!(has(&page, "expected a number, found “many”"));
}

#[test]
fn a_link_without_the_aircraft_since_that_is_too_long_says_so() {
    let mut page = page(WIDE);
    drop_file(&mut page, "mine.m", MATRICES.as_bytes());
    take_suggestions(&mut page);
    press(&mut page, "Use this aircraft");
    page.key_press(Key::L);
    page.run_steps(3);
    assert!(has(&page, "Link copied") && !has(&page, "without your aircraft"));
    // Remarks that can't be compressed.
    let noise: String =
        (0_u64..900).map(|k| format!("# {}\n", k.wrapping_mul(0x9e37_79b9_7f4a_7c15))).collect();
    let long = format!("{noise}{}", include_str!("../assets/aircraft/navion.toml"));
    drop_file(&mut page, "long.toml", long.as_bytes());
    press(&mut page, "Use this aircraft");
    assert!(!app(&page).link().contains("own="), "{}", app(&page).link().len());
    page.key_press(Key::L);
    page.run_steps(3);
    assert!(has(&page, "Link copied, without your aircraft: it is too long for a link"));
}
