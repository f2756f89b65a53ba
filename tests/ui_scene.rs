//! The scene that undo goes through, in the user interface: the time shown, and the pinned state.

use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::ui::App;

const WIDE: Vec2 = Vec2::new(1440.0, 900.0);
const TIME: &str = "time shown in s";
const AUTO: &str = "Time shown follows the motion";
const PIN: &str = "Pin this state, to compare what comes next with it";

type Page = Harness<'static, Option<App>>;

fn page(link: &'static str) -> Page {
    let mut harness = Harness::builder().with_size(WIDE).build_ui_state(
        move |ui, app: &mut Option<App>| {
            let start = || {
                let mut app = App::new(ui.ctx()).expect("an aircraft");
                app.open(link);
                app
            };
            app.get_or_insert_with(start).ui(ui);
        },
        None,
    );
    harness.run_steps(10);
    harness
}

fn app(harness: &mut Page) -> &mut App {
    harness.state_mut().as_mut().expect("the page has been drawn")
}

fn time(harness: &mut Page) -> f64 {
    app(harness).scenario().disturbance.sizes.time
}

fn follows(harness: &mut Page) -> bool {
    app(harness).scenario().disturbance.follows
}

fn link(harness: &mut Page) -> String {
    app(harness).link()
}

fn press(harness: &mut Page, label: &str) {
    harness.get_by_label(label).click();
    harness.run_steps(3);
}

/// Long enough for an edit to be a step of its own.
fn pause(harness: &mut Page) {
    harness.run_steps(10);
}

fn type_time(harness: &mut Page, text: &str) {
    harness.get_by_role_and_label(Role::TextInput, TIME).focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.get_by_role_and_label(Role::TextInput, TIME).type_text(text);
    harness.run_steps(2);
    harness.key_press(Key::Enter);
    pause(harness);
}

#[test]
fn the_page_opens_with_a_time_that_follows_and_nothing_to_undo() {
    let mut harness = page("");
    assert!(follows(&mut harness));
    assert_eq!(time(&mut harness), 60.0);
    assert_eq!(link(&mut harness), "v=1&ac=navion");
    assert!(harness.get_by_label("Undo").accesskit_node().is_disabled());
}

#[test]
fn a_typed_time_stays_until_auto_is_pressed_and_undo_takes_back_both() {
    let mut harness = page("");
    type_time(&mut harness, "20");
    assert_eq!((time(&mut harness), follows(&mut harness)), (20.0, false));
    assert_eq!(link(&mut harness), "v=1&ac=navion&time=20");
    press(&mut harness, AUTO);
    pause(&mut harness);
    assert!(follows(&mut harness));
    let period = {
        let modes = &app(&mut harness).findings().plane().expect("an analysis").modes;
        modes.iter().filter_map(|mode| mode.period()).fold(0.0, f64::max)
    };
    let shown = time(&mut harness);
    assert!(shown > 1.5 * period && shown < 4.0 * period, "{shown} s, phugoid of {period} s");
    press(&mut harness, "Undo");
    assert_eq!((time(&mut harness), follows(&mut harness)), (20.0, false));
    press(&mut harness, "Undo");
    assert_eq!((time(&mut harness), follows(&mut harness)), (60.0, true));
    press(&mut harness, "Redo");
    assert_eq!((time(&mut harness), follows(&mut harness)), (20.0, false));
}

/// The time of a link is what the sender saw; without a word it is what the scene says.
#[test]
fn an_old_link_with_a_time_keeps_it_and_one_without_follows() {
    let mut harness = page("v=1&ac=b747-cruise-etkin&time=90");
    assert_eq!((time(&mut harness), follows(&mut harness)), (90.0, false));
    let mut harness = page("v=1&ac=b747-cruise-etkin");
    let shown = time(&mut harness);
    assert!(follows(&mut harness) && shown > 150.0, "{shown} s");
    let link = link(&mut harness);
    assert!(link.ends_with(&format!("&follows={shown}")), "{link}");
    // Whatever was shown before.
    let mut other = page("v=1&ac=b747-cruise-etkin&follows=7");
    assert_eq!(time(&mut other), shown);
}

/// While the pointer is down the time keeps still; once it is up, it goes to the divergence that the slider has led to.
#[test]
fn the_time_keeps_still_during_a_drag_and_is_no_step_of_its_own() {
    let mut harness = page("v=1&ac=navion");
    let before = app(&mut harness).scenario().clone();
    let slider = harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").rect();
    let (from, to) = (slider.center(), slider.right_center());
    harness.drag_at(from);
    harness.run_steps(2);
    let mut x = from.x;
    while x < to.x + 20.0 {
        x += 6.0;
        harness.hover_at(egui::pos2(x, from.y));
        harness.run_steps(1);
        assert_eq!(time(&mut harness), 60.0);
    }
    assert_ne!(app(&mut harness).scenario(), &before, "the slider has moved");
    harness.drop_at(egui::pos2(x, from.y));
    harness.run_steps(3);
    let after = time(&mut harness);
    assert_ne!(after, 60.0);
    pause(&mut harness);
    press(&mut harness, "Undo");
    pause(&mut harness);
    let undone = app(&mut harness).scenario().clone();
    assert_eq!(undone.edited, before.edited, "one step");
    press(&mut harness, "Undo");
    assert_eq!(app(&mut harness).scenario().edited, before.edited, "and nothing before it");
}

/// However long the slider is held still, and whatever the keyboard did just before.
#[test]
fn a_drag_with_rests_is_one_step() {
    let mut harness = page("v=1&ac=navion");
    let before = app(&mut harness).scenario().edited.clone();
    nudge(&mut harness);
    let nudged = app(&mut harness).scenario().edited.clone();
    let slider = harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").rect();
    harness.drag_at(slider.center());
    for k in 1..5 {
        harness.hover_at(slider.center() + Vec2::new(6.0 * k as f32, 0.0));
        // More than a second each.
        harness.run_steps(10);
    }
    harness.drop_at(slider.center() + Vec2::new(24.0, 0.0));
    harness.run_steps(2);
    assert_ne!(app(&mut harness).scenario().edited, nudged);
    for expected in [&nudged, &before] {
        press(&mut harness, "Undo");
        assert_eq!(&app(&mut harness).scenario().edited, expected);
    }
}

/// A field has its own undo, which must not move an aircraft.
#[test]
fn undo_in_a_field_is_the_fields() {
    let mut harness = page("v=1&ac=navion");
    nudge(&mut harness);
    pause(&mut harness);
    let nudged = link(&mut harness);
    harness.get_by_role_and_label(Role::TextInput, "Find a derivative").focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(link(&mut harness), nudged);
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(link(&mut harness), "v=1&ac=navion");
}

/// What was chosen before a mode was flown comes back as often as the flight is stopped.
#[test]
fn what_disturbed_before_a_mode_was_flown_survives_undo() {
    let mut harness = page("v=1&ac=navion&lon.shape=doublet");
    let before = link(&mut harness);
    let flown = |harness: &mut Page| link(harness).contains("source=mode");
    press(&mut harness, "Fly the phugoid alone");
    assert!(flown(&mut harness));
    press(&mut harness, "Stop flying the phugoid alone");
    assert_eq!(link(&mut harness), before);
    press(&mut harness, "Undo");
    assert!(flown(&mut harness));
    press(&mut harness, "Stop flying the phugoid alone");
    assert_eq!(link(&mut harness), before);
}

/// The short period splits into two real roots, and the phugoid is no longer the second mode.
#[test]
fn a_mode_is_flown_on_where_its_place_changes() {
    let mut harness = page("v=1&ac=navion&lon.source=mode&lon.mode=2&pin.ac=navion");
    let name = |harness: &mut Page| {
        let choice = app(harness).scenario().disturbance.choices.longitudinal;
        app(harness).findings().plane().expect("an analysis").modes[choice.mode].naming.name
    };
    assert_eq!(name(&mut harness), ModeName::Phugoid);
    let curve = |harness: &Page| {
        let node = harness.get_by_label_contains("Δu in m/s against time");
        // Up to its extremes: the time shown follows the modes in its own way.
        node.accesskit_node().label().unwrap_or_default().split(',').next().map(str::to_owned)
    };
    let before = curve(&harness);
    harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").set_value_accesskit(-0.05);
    harness.run_steps(3);
    assert_eq!(app(&mut harness).findings().plane().expect("an analysis").modes.len(), 3);
    assert_eq!(name(&mut harness), ModeName::Phugoid);
    assert_ne!(curve(&harness), before);
    press(&mut harness, "Reset pitch stiffness C_mα");
    assert_eq!(name(&mut harness), ModeName::Phugoid);
    assert_eq!(curve(&harness), before);
}

#[test]
fn undo_takes_back_a_pin_and_redo_brings_it_again() {
    let mut harness = page("v=1&ac=navion&cn_beta=0.09");
    press(&mut harness, PIN);
    harness.get_by_label_contains("pinned: Navion");
    // At once, with no pause for the history.
    press(&mut harness, "Undo");
    assert_eq!(harness.query_all_by_label_contains("pinned: Navion").count(), 0);
    assert_eq!(link(&mut harness), "v=1&ac=navion&cn_beta=0.09");
    press(&mut harness, "Redo");
    harness.get_by_label_contains("pinned: Navion");
    assert_eq!(link(&mut harness), "v=1&ac=navion&cn_beta=0.09&pin.ac=navion&pin.cn_beta=0.09");
}

#[test]
fn undo_brings_back_a_state_that_was_unpinned() {
    let mut harness = page("v=1&ac=navion&pin.ac=b747-approach&pin.speed=90");
    let before = link(&mut harness);
    harness.key_press(Key::G);
    harness.run_steps(3);
    assert_eq!(link(&mut harness), "v=1&ac=navion");
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), before);
}

/// The warning about units offers the lesson with gravity in the unit of its other entries.
#[test]
fn undo_takes_back_a_comparison_that_was_offered() {
    let mut harness = page("v=1&ac=lesson-printed");
    let before = link(&mut harness);
    press(&mut harness, "Compare with gravity in the same unit");
    assert!(link(&mut harness).contains("pin.ac=lesson"));
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), before);
}

#[test]
fn a_link_is_one_step_and_undo_brings_back_the_pinned_state_before_it() {
    let mut harness = page("v=1&ac=navion&pin.ac=navion&pin.speed=60");
    let before = link(&mut harness);
    app(&mut harness).open("v=1&ac=b747-approach&pin.ac=navion&pin.speed=50");
    pause(&mut harness);
    assert!(link(&mut harness).contains("pin.speed=50"));
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), before);
}

/// One fine step of a slider.
fn nudge(harness: &mut Page) {
    harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    harness.run_steps(2);
    harness.key_press(Key::ArrowRight);
    harness.run_steps(2);
}

#[test]
fn what_was_undone_is_gone_once_something_is_pinned() {
    let mut harness = page("v=1&ac=navion");
    nudge(&mut harness);
    pause(&mut harness);
    press(&mut harness, "Undo");
    press(&mut harness, PIN);
    let pinned = link(&mut harness);
    press(&mut harness, "Redo");
    assert_eq!(link(&mut harness), pinned);
}

/// A pin between two edits in quick succession is a step between them.
#[test]
fn a_pin_is_a_step_of_its_own_whatever_is_edited_around_it() {
    let mut harness = page("v=1&ac=navion");
    nudge(&mut harness);
    let edited = link(&mut harness);
    assert_ne!(edited, "v=1&ac=navion");
    press(&mut harness, PIN);
    let pinned = link(&mut harness);
    nudge(&mut harness);
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), pinned);
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), edited);
    press(&mut harness, "Undo");
    assert_eq!(link(&mut harness), "v=1&ac=navion");
}

/// What can't be flown leaves the last good state in every pane, dimmed, and the sliders of every page.
#[test]
fn what_cannot_be_flown_leaves_the_last_good_state_in_every_pane() {
    let mut harness = page("v=1&ac=navion");
    let plots = harness.query_all_by_label_contains("against time").count();
    harness.get_by_role_and_label(Role::Slider, "airspeed V").focus();
    harness.run_steps(3);
    harness.key_press(Key::Home);
    harness.run_steps(3);
    assert!(app(&mut harness).findings().plane().is_none());
    for page in ["Coefficients", "Dimensional", "Matrix"] {
        press(&mut harness, page);
        assert_eq!(
            harness.query_all_by_label_contains("This can't be analysed: the wing would need").count(),
            1
        );
        assert_eq!(harness.query_all_by_label_contains("As it was last").count(), 3, "{page}");
        harness.get_by_label_contains("Pole map, All modes");
        assert_eq!(harness.query_all_by_label_contains("against time").count(), plots, "{page}");
        assert!(harness.query_all_by_label_contains("Phugoid").count() > 1, "{page}");
        assert_eq!(harness.query_all_by_label_contains("No slider of this page").count(), 0, "{page}");
        let sliders = harness.query_all_by_role(Role::Slider).count();
        assert!(sliders > 10, "{page}: {sliders}");
    }
    press(&mut harness, "Coefficients");
    harness.get_by_role_and_label(Role::Slider, "airspeed V").focus();
    harness.run_steps(3);
    harness.key_press(Key::Delete);
    harness.run_steps(3);
    assert!(app(&mut harness).findings().plane().is_some());
    assert_eq!(harness.query_all_by_label_contains("As it was last").count(), 0);
}

/// Where nothing has ever followed there is nothing to show, and no sentence of a search that nobody made.
#[test]
fn a_link_to_what_cannot_be_flown_says_so_on_every_page() {
    let harness = page("v=1&ac=navion&speed=26.82&page=dimensional");
    assert_eq!(harness.query_all_by_label_contains("can't be analysed: the wing").count(), 1);
    assert_eq!(harness.query_all_by_label_contains("matches “”").count(), 0);
}

fn playback(harness: &Page) -> (f64, bool) {
    let slider = harness.get_by_role_and_label(Role::Slider, "Time of the playback in s");
    let time = slider.accesskit_node().numeric_value().expect("a time");
    (time, harness.query_by_label("Pause").is_some())
}

/// A new scene begins at time zero, at rest, whatever was played before; or as its link says.
#[test]
fn a_new_scene_begins_at_time_zero_at_rest() {
    let mut harness = page("v=1&ac=navion");
    let play = |harness: &mut Page| {
        press(harness, "Play");
        harness.run_steps(30);
        assert!(playback(harness).0 > 0.1 && playback(harness).1);
    };
    play(&mut harness);
    app(&mut harness).open("v=1&ac=b747-approach");
    harness.run_steps(3);
    assert_eq!(playback(&harness), (0.0, false));
    play(&mut harness);
    press(&mut harness, "Lateral–directional");
    assert_eq!(playback(&harness), (0.0, false));
    play(&mut harness);
    press(&mut harness, "Undo");
    assert_eq!(playback(&harness), (0.0, false));
    app(&mut harness).open("v=1&ac=navion&t=12.5");
    harness.run_steps(3);
    assert_eq!(playback(&harness), (12.5, false));
    // The address keeps still while it plays; a copied link tells the moment.
    let still = link(&mut harness);
    assert!(!still.contains("&t="), "{still}");
    assert!(app(&mut harness).link_with_instant().ends_with("&t=12.5"));
    press(&mut harness, "Play");
    assert_eq!(link(&mut harness), still);
    assert!(app(&mut harness).link_with_instant().ends_with("&play=on"));
    app(&mut harness).open("v=1&ac=navion&t=12.5&play=on");
    harness.run_steps(3);
    let (time, is_playing) = playback(&harness);
    assert!(is_playing && (12.5..14.0).contains(&time), "{time}");
}
