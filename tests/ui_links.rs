//! Links in the user interface: sharing one, opening one, and what is said of a damaged one.

mod page;

use egui::accesskit::{Role, Toggled};
use egui::{Key, Modifiers, OutputCommand, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::Parameter;
use eigenwing::ui::App;
use page::{PHONE, Page, WIDE, page};

const SHARE: &str = "Share link: copy the whole scene as a link (key L)";

fn app(harness: &mut Page) -> &mut App {
    harness.state_mut().as_mut().expect("the page has been drawn")
}

fn open(harness: &mut Page, link: &str) {
    app(harness).open(link);
    harness.run();
}

fn value(harness: &mut Page, key: &str) -> f64 {
    Parameter::find(key).expect("a row").get(app(harness).scenario())
}

/// What was copied in the last frame.
fn copied(harness: &Page) -> Option<String> {
    harness.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    })
}

#[test]
fn the_button_copies_the_address_with_the_whole_scene_and_says_so() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        app(&mut harness).set_address("https://example.org/eigenwing/".to_owned());
        open(&mut harness, "v=1&ac=navion&speed=60&cm_alpha=-0.5&pin.ac=navion");
        harness.get_by_label(SHARE).click();
        harness.step();
        // At 60 m/s the phugoid is slower, so that more time is shown.
        let link =
            "https://example.org/eigenwing/#v=1&ac=navion&cm_alpha=-0.5&speed=60&follows=100&pin.ac=navion";
        assert_eq!(copied(&harness).as_deref(), Some(link), "{size}");
        assert_eq!(app(&mut harness).take_unsaid().as_deref(), Some("Link copied"));
        assert_eq!(app(&mut harness).take_unsaid(), None, "said once");
        harness.step();
        harness.get_by_label("Link copied");
    }
}

#[test]
fn the_word_that_a_link_was_copied_goes_and_leaves_an_idle_page() {
    let mut harness = page(WIDE);
    harness.key_press(Key::L);
    harness.step();
    harness.get_by_label("Link copied");
    harness.run_steps(60);
    harness.run();
    assert_eq!(harness.query_all_by_label("Link copied").count(), 0);
    let delay = harness.output().viewport_output.values().map(|v| v.repaint_delay).min().expect("a viewport");
    assert!(delay > std::time::Duration::from_secs(1), "{delay:?}");
}

/// Whether a press of the key copies: the word is said at the press, the copy itself is not in the frame of the release.
fn copies(harness: &mut Page, modifiers: Modifiers) -> bool {
    harness.key_press_modifiers(modifiers, Key::L);
    harness.step();
    app(harness).take_unsaid().is_some()
}

#[test]
fn the_key_copies_except_while_a_person_types() {
    let mut harness = page(WIDE);
    assert!(copies(&mut harness, Modifiers::NONE), "at nothing");
    harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").focus();
    harness.run_steps(60);
    assert!(copies(&mut harness, Modifiers::NONE), "at a slider");
    harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").focus();
    harness.run_steps(60);
    assert!(!copies(&mut harness, Modifiers::NONE), "in a field");
    harness.key_press(Key::Escape);
    harness.run_steps(60);
    assert!(!copies(&mut harness, Modifiers::COMMAND), "the browser's own key for the address bar");
    assert!(copies(&mut harness, Modifiers::NONE), "at nothing again");
}

#[test]
fn a_link_opens_its_scene_and_undo_goes_back() {
    let mut harness = page(WIDE);
    let before = app(&mut harness).scenario().clone();
    let poles = app(&mut harness).findings().plane().expect("an analysis").modes[0].lambda;
    let link = "v=1&ac=b747-approach&cn_beta=0.2&plane=lateral&lat.source=aileron&page=matrix&tab=metrics&pin.ac=navion";
    open(&mut harness, link);
    assert_eq!(app(&mut harness).scenario().plane, Plane::Lateral);
    assert_ne!(app(&mut harness).findings().plane().expect("an analysis").modes[0].lambda, poles);
    assert_eq!(value(&mut harness, "cn_beta"), 0.2);
    harness.get_by_label_contains("pinned: Navion");
    assert_eq!(harness.query_all_by_label("Dismiss").count(), 0);
    assert_eq!(app(&mut harness).link(), link);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(app(&mut harness).scenario(), &before);
}

/// The harness draws a frame with the page: one opened before it has nothing behind it.
#[test]
fn the_scene_that_a_page_starts_with_has_nothing_to_undo() {
    let mut harness = Harness::builder().with_size(WIDE).build_ui_state(
        |ui, app: &mut Option<App>| {
            let start = || {
                let mut app = App::new(ui.ctx()).expect("an aircraft");
                app.open("v=1&ac=lesson&a_qq=-6");
                app
            };
            app.get_or_insert_with(start).ui(ui);
        },
        None,
    );
    harness.run_steps(120);
    assert_eq!(app(&mut harness).scenario().aircraft.key, "lesson");
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(app(&mut harness).scenario().aircraft.key, "lesson");
}

#[test]
fn what_is_left_out_of_a_link_is_said_until_it_is_dismissed() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        open(&mut harness, "v=2&ac=navion&speed=60&cm_q=steep&wings=2");
        assert_eq!(value(&mut harness, "speed"), 60.0);
        for sentence in [
            "made by a newer version",
            "(cm_q) was left out: “steep” is not a number",
            "“wings” means nothing",
        ] {
            harness.get_by_label_contains(sentence);
        }
        let said = app(&mut harness).take_unsaid().expect("something to say");
        assert!(said.contains("newer version") && said.contains("wings"), "{said}");
        harness.get_by_label("Dismiss").click();
        harness.run();
        assert_eq!(harness.query_all_by_label_contains("newer version").count(), 0, "{size}");
        assert_eq!(value(&mut harness, "speed"), 60.0);
    }
}

/// Noise leaves room for the page, and every character of what is quoted has a glyph.
#[test]
fn a_link_of_noise_is_told_in_a_few_lines() {
    let mut harness = page(PHONE);
    open(&mut harness, "ж=1&漢=2&\u{7}=3&ac=💥&%ff%fe=4&a&b&c&d");
    assert_eq!(harness.query_all_by_label_contains("⚠").filter(|node| node.rect().top() < 500.0).count(), 5);
    harness.get_by_label_contains("more parts of the link were left out");
    assert!(harness.query_all_by_label_contains("Pole map, All modes").count() == 1);
}

/// The panes as an instructor sets them before sending a scene.
#[test]
fn what_the_panes_show_is_in_the_link_and_opens_again() {
    let mut harness = page(WIDE);
    for label in ["View from the right", "Level boundaries", "Split into modes", "Phase"] {
        harness.get_by_label(label).click();
        harness.run();
    }
    harness.key_press(Key::R);
    harness.run();
    let link = app(&mut harness).link();
    assert_eq!(
        link,
        "v=1&ac=navion&elevator=-1&tab=phase&split=modes&marks=levels&pane=response&camera=side"
    );
    let mut other = page(WIDE);
    open(&mut other, &link);
    assert_eq!(app(&mut other).link(), link);
    assert_eq!(other.query_all_by_label("View from the right").count(), 0, "the response has the whole page");
    other.key_press(Key::Escape);
    other.run();
    let toggled = |label: &str| other.get_by_label(label).accesskit_node().toggled();
    assert_eq!(toggled("View from the right"), Some(Toggled::True));
    assert_eq!(toggled("Three-quarter view"), Some(Toggled::False));
    assert_eq!(toggled("Level boundaries"), Some(Toggled::True));
    assert_eq!(toggled("Textbook approximations"), Some(Toggled::False));
}

#[test]
fn the_camera_and_the_quantities_are_in_the_link_and_undo_leaves_them_alone() {
    let mut harness = page(WIDE);
    let above = harness.get_by_label("View from the right").rect().center();
    let from = above + Vec2::new(0.0, 150.0);
    harness.drag_at(from);
    harness.run_steps(2);
    harness.hover_at(from + Vec2::new(80.0, 40.0));
    harness.run_steps(2);
    harness.drop_at(from + Vec2::new(80.0, 40.0));
    harness.run();
    let link = app(&mut harness).link();
    let camera = link.strip_prefix("v=1&ac=navion&elevator=-1&camera=").expect("a camera and nothing else");
    assert_eq!(camera.split('.').filter(|number| number.parse::<i16>().is_ok()).count(), 3, "{camera}");
    let shown =
        format!("v=1&ac=navion&elevator=-1&lon.show=gamma.nz&camera={camera}&drawn=none&rate=0.5&loop=off");
    open(&mut harness, &shown);
    assert_eq!(app(&mut harness).link(), shown);
    harness.get_by_label_contains("Δn_z in g against time");
    assert_eq!(harness.query_all_by_label_contains("Δu in m/s against time").count(), 0);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(app(&mut harness).link(), shown, "nothing was done to the aircraft");
}

/// One sentence for each, and the page as it opens.
#[test]
fn a_damaged_view_is_told_and_left_as_it_opens() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&camera=cockpit&lon.show=u.nothing&pane=all");
    for sentence in
        ["“camera=cockpit” was left out", "“lon.show=u.nothing” was left out", "“pane=all” was left out"]
    {
        harness.get_by_label_contains(sentence);
    }
    assert_eq!(app(&mut harness).link(), "v=1&ac=navion");
}

/// A step of a lesson or a slide has on the screen what it is about, and nothing else.
#[test]
fn a_stage_has_the_parts_and_the_sliders_that_its_link_names() {
    for size in [WIDE, Vec2::new(1000.0, 800.0), PHONE] {
        let mut harness = page(size);
        let count = |harness: &Page, label: &str| harness.query_all_by_label_contains(label).count();
        let sliders = |harness: &Page| harness.query_all_by_role(Role::Slider).count();
        open(&mut harness, "v=1&ac=navion&stage=derivatives.poles&offer=cm_alpha.cm_q");
        assert_eq!(sliders(&harness), 2, "{size}");
        assert!(count(&harness, "Pole map, ") > 0, "{size}");
        assert_eq!(count(&harness, "against time"), 0, "{size}");
        assert_eq!(count(&harness, "Dynamically "), 0, "{size}");
        assert_eq!(count(&harness, "Play"), 0, "{size}");
        // Only what moves: no pole map, no sliders.
        open(&mut harness, "v=1&ac=navion&stage=response");
        assert_eq!(sliders(&harness), 0, "{size}");
        assert_eq!(count(&harness, "Pole map, "), 0, "{size}");
        assert!(count(&harness, "against time") > 0, "{size}");
        let link = app(&mut harness).link();
        assert!(link.contains("&stage=response"), "{link}");
        // The workbench is the stage with everything on.
        open(&mut harness, "v=1&ac=navion");
        assert!(count(&harness, "Pole map, ") > 0 && count(&harness, "against time") > 0, "{size}");
    }
}
