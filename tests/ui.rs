//! The user interface by role and name, without a window.

mod page;

use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::scenario::{Notation, Source, parameters};
use eigenwing::ui::App;
use eigenwing::words;
use page::{PHONE, TABLET, WIDE, app, choose, open, page, type_into, value};

#[test]
fn a_changed_aircraft_is_modified_and_not_verified() {
    let mut harness = page(WIDE);
    harness.get_by_label("✓ verified: source and remarks");
    type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.5");
    assert!(harness.query_by_label("✓ verified: source and remarks").is_none());
    harness.get_by_label("modified: source and remarks");
}

#[test]
fn the_printed_lesson_warns_of_its_units_and_compares_with_the_mended_one() {
    let mut harness = page(WIDE);
    choose(&mut harness, "Aircraft", "Lesson 4, as printed");
    assert_eq!(app(&harness).scenario().aircraft.key, "lesson-printed");
    harness.get_by_label_contains("g/U₀ = 5.6 1/s");
    harness.get_by_label_contains("Dynamically unstable: the phugoid doubles every 4.1 s");
    harness.get_by_label_contains("Statically stable in pitch: ");
    harness.get_by_label_contains("det\u{a0}A\u{a0}=\u{a0}18.1\u{a0}1/s⁴\u{a0}>\u{a0}0");
    harness.get_by_label("Compare with gravity in the same unit").click();
    harness.run();
    harness.get_by_label_contains("pinned: Lesson 4, gravity in the same unit");
    assert_eq!(harness.query_all_by_label_contains("Pinned → now").count(), 2);
    harness.get_by_label_contains("Unpin").click();
    harness.run();
    assert_eq!(harness.query_all_by_label_contains("Pinned → now").count(), 0);
}

#[test]
fn help_has_a_button_and_tells_the_version() {
    let mut harness = page(WIDE);
    harness.get_by_role_and_label(Role::Button, "Help: all keys").click();
    harness.run();
    assert_eq!(harness.query_all_by_role_and_label(Role::Heading, "Keys").count(), 1);
    harness.get_by_label(concat!("Eigenwing ", env!("CARGO_PKG_VERSION")));
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(harness.query_all_by_role_and_label(Role::Heading, "Keys").count(), 0);
}

#[test]
fn an_idle_page_asks_for_no_frame() {
    for size in [WIDE, TABLET, PHONE] {
        let mut harness = page(size);
        harness.run();
        let delay =
            harness.output().viewport_output.values().map(|v| v.repaint_delay).min().expect("a viewport");
        assert!(delay > std::time::Duration::from_secs(1), "{size}: {delay:?}");
    }
}

#[test]
fn on_a_phone_the_pole_map_stays_with_each_pane() {
    let mut harness = page(PHONE);
    for pane in ["Modes", "Response", "Derivatives"] {
        harness.get_by_role_and_label(Role::Button, pane).click();
        harness.run();
        assert_eq!(harness.query_all_by_label_contains("Pole map, All modes").count(), 1, "{pane}");
    }
    assert!(harness.query_all_by_role(Role::Slider).count() > 5);
}

/// Nothing that can be pressed or moved reaches beyond the sides of the screen.
#[test]
fn every_control_is_on_the_screen() {
    for size in [WIDE, TABLET, PHONE] {
        let mut harness = page(size);
        choose(&mut harness, "Aircraft", "flight condition 8");
        harness.get_by_label_contains("Pin this state").click();
        harness.run();
        assert_eq!(harness.query_all_by_label("Undo").count(), 1, "{size}");
        for role in [Role::Button, Role::Slider, Role::ComboBox, Role::TextInput] {
            for node in harness.query_all_by_role(role) {
                let rect = node.rect();
                let label = node.accesskit_node().label().unwrap_or_default();
                assert!(rect.left() >= 0.0 && rect.right() <= size.x, "{size}: {label} at {rect}");
            }
        }
    }
}

/// The keys of a browser's zoom, Ctrl + and −, are egui's here: the same window has less room for everything.
#[test]
fn every_control_is_on_the_screen_at_a_zoom_of_150_and_200_per_cent_too() {
    for zoom in [1.5, 2.0] {
        let mut harness = page(WIDE / zoom);
        harness.ctx.set_zoom_factor(zoom);
        harness.run();
        assert_eq!(harness.ctx.pixels_per_point(), zoom);
        harness.get_by_label_contains("Pin this state").click();
        harness.run();
        let mut seen = 0;
        for role in [Role::Button, Role::Slider, Role::ComboBox, Role::TextInput, Role::CheckBox] {
            for node in harness.query_all_by_role(role) {
                let rect = node.rect();
                let label = node.accesskit_node().label().unwrap_or_default();
                let right = WIDE.x / zoom;
                assert!(rect.left() >= 0.0 && rect.right() <= right, "{zoom}: {label} at {rect}");
                seen += 1;
            }
        }
        assert!(seen > 60, "{zoom}: {seen} controls");
        // The bar's tools come from the right, what is studied from the left.
        let share = harness.get_by_label_contains("Share link").rect();
        for node in harness.query_all_by_label_contains("Lateral") {
            assert!(!share.intersects(node.rect()), "{zoom}: {share} and {}", node.rect());
        }
    }
}

#[test]
fn arrow_keys_scrub_the_playback_both_ways_from_a_round_number_too() {
    let mut harness = page(WIDE);
    let time = |harness: &page::Page| {
        let slider = harness.get_by_role_and_label(Role::Slider, "Time of the playback in s");
        slider.accesskit_node().numeric_value().expect("a time")
    };
    let slider = harness.get_by_role_and_label(Role::Slider, "Time of the playback in s");
    slider.set_value_accesskit(5.0);
    slider.focus();
    harness.run();
    assert_eq!(time(&harness), 5.0);
    for (key, sign) in [(Key::ArrowRight, 1.0), (Key::ArrowLeft, -1.0), (Key::ArrowLeft, -1.0)] {
        let before = time(&harness);
        harness.key_press(key);
        harness.run();
        assert!(sign * (time(&harness) - before) > 0.01, "{key:?}: from {before} to {}", time(&harness));
    }
}

/// A quick Tab is down and up within one frame; a widget keeps the arrow keys to itself from its second frame on.
#[test]
fn arrow_keys_stay_with_a_slider_that_a_quick_tab_has_reached() {
    let mut harness = page(WIDE);
    harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").focus();
    harness.run();
    let key = |pressed| egui::Event::Key {
        key: Key::Tab,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::SHIFT,
    };
    harness.input_mut().events.extend([true, false].map(key));
    harness.run();
    for _ in 0..3 {
        let before = value(&harness, "cm_alpha");
        harness.key_press(Key::ArrowLeft);
        harness.run();
        assert!(value(&harness, "cm_alpha") < before);
    }
}

/// A quick key is down and up within one frame, and nothing else may come for long.
#[test]
fn a_pin_is_on_screen_without_another_event() {
    let mut harness = page(WIDE);
    for (pressed, expected) in [(Key::G, 1), (Key::G, 0)] {
        let key = |down| egui::Event::Key {
            key: pressed,
            physical_key: None,
            pressed: down,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        harness.input_mut().events.extend([true, false].map(key));
        harness.run();
        assert_eq!(harness.query_all_by_label_contains("○ pinned: Navion").count(), expected);
    }
}

#[test]
fn poles_are_described_in_words() {
    let harness = page(WIDE);
    harness.get_by_label_contains(
        "Pole map, All modes: Short period ζ 0.70 · T 2.42 s; Phugoid ζ 0.08 · T 29.5 s",
    );
}

#[test]
fn the_other_plane_names_its_own_modes_and_levels() {
    let mut harness = page(WIDE);
    harness.get_by_label("Lateral–directional").click();
    harness.run();
    for name in ["Dutch roll", "Roll subsidence", "Spiral"] {
        assert_eq!(harness.query_all_by_role_and_label(Role::Heading, name).count(), 1, "{name}");
    }
    harness.get_by_label("Level of the Dutch roll").click();
    harness.run();
    assert!(harness.query_all_by_label_contains("MIL-F-8785C").count() >= 3);
}

#[test]
fn an_aircraft_without_lateral_data_has_no_switch_to_it() {
    let mut harness = page(WIDE);
    choose(&mut harness, "Aircraft", "Lesson 4, as printed");
    assert_eq!(harness.query_all_by_label("Lateral–directional").count(), 0);
    assert_eq!(harness.query_all_by_label("Coefficients").count(), 0, "nor coefficients");
}

#[test]
fn a_flight_that_the_wing_cannot_carry_says_so() {
    let mut harness = page(WIDE);
    type_into(&mut harness, "airspeed V, typed", "15");
    assert_eq!(harness.query_all_by_label_contains("This can't be analysed").count(), 1, "said once");
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(harness.query_all_by_label_contains("This can't be analysed").count(), 0);
}

/// Every sentence that the page can show is drawn once; a character that no embedded font has is a failure of the harness.
#[test]
fn the_embedded_fonts_have_every_character_of_every_text() {
    let mut texts: Vec<String> = parameters()
        .flat_map(|p| [p.symbol, p.name, p.meaning, p.sign, p.origin])
        .map(str::to_owned)
        .collect();
    for aircraft in eigenwing::content::embedded_aircraft().0 {
        texts.extend(
            [&aircraft.name, &aircraft.condition, &aircraft.source, &aircraft.status_reason]
                .map(String::from),
        );
        texts.extend(aircraft.notes.iter().cloned());
        let mut scenario = eigenwing::scenario::Scenario::new(std::sync::Arc::new(aircraft));
        for plane in Plane::ALL {
            scenario.plane = plane;
            let analysis = scenario.analyse().expect("an analysis");
            let Some(Ok(of_plane)) = &analysis.planes[plane] else { continue };
            texts.extend(of_plane.modes.iter().map(words::naming::reason));
            texts.extend(of_plane.levels.iter().map(words::verdict::sentence));
            for approximation in &of_plane.approximations {
                let name = approximation.name;
                let words = [
                    words::approximation::formula(name, Notation::Velocities),
                    &words::approximation::neglects(name, Notation::Velocities),
                    words::approximation::name(name, Notation::Velocities),
                ];
                texts.extend(words.map(str::to_owned));
            }
        }
    }
    // egui draws nothing for a mark that the fonts don't have: of the combining ones they have the dot.
    for text in &texts {
        let lost = text.chars().find(|c| ('\u{300}'..='\u{36f}').contains(c) && *c != '\u{307}');
        assert_eq!(lost, None, "{text}");
    }
    let mut app = None;
    let mut harness = Harness::builder().with_size(Vec2::new(1200.0, 30_000.0)).build_ui(move |ui| {
        // The page's fonts, not its panes.
        app.get_or_insert_with(|| App::new(ui.ctx()));
        for text in &texts {
            ui.label(text);
        }
    });
    harness.run_steps(3);
}

#[test]
fn the_switch_of_planes_keeps_its_place_whatever_aircraft_is_chosen() {
    let mut harness = page(WIDE);
    let width =
        |harness: &page::Page| harness.get_by_role_and_label(Role::ComboBox, "Aircraft").rect().width();
    let first = width(&harness);
    for (file, _) in eigenwing::content::FILES {
        let aircraft = file.strip_suffix(".toml").expect("a file of an aircraft");
        open(&mut harness, &format!("v=1&ac={aircraft}"));
        assert!((width(&harness) - first).abs() < 0.5, "{aircraft}: {} not {first}", width(&harness));
    }
}

#[test]
fn every_list_of_disturbances_is_whole() {
    let mut harness = page(WIDE);
    harness.get_by_role_and_label(Role::ComboBox, "Disturbance").click();
    harness.run();
    let last = harness.get_by_role_and_label(Role::Button, "One mode").rect();
    // Where it stands it can be pressed: nothing scrolls.
    harness.hover_at(last.center());
    harness.run();
    harness.drag_at(last.center());
    harness.drop_at(last.center());
    harness.run();
    assert_eq!(app(&harness).scenario().disturbance.choices[Plane::Longitudinal].source, Source::OneMode);
}

#[test]
fn remarks_on_an_aircraft_s_source_are_shown_at_its_status() {
    let mut harness = page(WIDE);
    let remark = "only 184, as in Fig. X-1, reproduces";
    assert_eq!(harness.query_all_by_label_contains(remark).count(), 0);
    harness.get_by_label("✓ verified: source and remarks").hover();
    harness.run_steps(60);
    assert_eq!(harness.query_all_by_label_contains(remark).count(), 1);
}

/// What is said of a source is a hover text on a desk; the sheet is reached without hovering, too, and read by screen readers.
#[test]
fn the_source_and_the_remarks_on_it_open_as_a_sheet() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        let remark = "Table X-A prints S = 180; only 184";
        assert!(harness.query_by_label_contains(remark).is_none());
        harness.get_by_label("✓ verified: source and remarks").click();
        harness.run();
        harness.get_by_role_and_label(Role::Heading, "Source and remarks");
        harness.get_by_role_and_label(Role::Heading, "Longitudinal motion: verified");
        harness.get_by_label_contains(remark);
        let source = app(&harness).scenario().aircraft.source.clone();
        harness.get_by_label(&source);
        harness.key_press(Key::Escape);
        harness.run();
        assert!(harness.query_by_label_contains(remark).is_none());
        harness.get_by_label("✓ verified: source and remarks").click();
        harness.run();
        harness.get_by_label("Close").click();
        harness.run();
        assert!(harness.query_by_label_contains(remark).is_none());
    }
}

#[test]
fn every_aircraft_shows_its_forces_with_numbers_and_says_what_no_source_gives() {
    let (mut in_newtons, mut in_weights) = (0, 0);
    let mut harness = page(WIDE);
    for (file, _) in eigenwing::content::FILES {
        let aircraft = file.strip_suffix(".toml").expect("a file of an aircraft");
        open(&mut harness, &format!("v=1&ac={aircraft}"));
        let images = harness.query_all_by_role(Role::Image).filter_map(|node| node.accesskit_node().label());
        let sentence = images.into_iter().find(|label| label.contains(": pitch ")).expect("the aircraft");
        assert!(sentence.contains(", weight "), "{sentence}");
        let told = sentence.contains(", drag ");
        in_newtons += usize::from(sentence.contains("N, weight"));
        in_weights += usize::from(sentence.contains("lift 1.00 W"));
        harness.get_by_label("Shown on the picture").click();
        harness.run();
        let remarks = harness.query_all_by_label_contains("The source gives").count();
        assert_eq!(remarks, usize::from(!told || sentence.contains(" W")), "{aircraft}: {sentence}");
        harness.key_press(Key::Escape);
        harness.run();
    }
    assert!(in_newtons >= 5 && in_weights >= 1, "{in_newtons} {in_weights}");
}

/// What can be pressed or moved, with its place; lists that scroll hide a part.
fn controls(harness: &page::Page) -> Vec<(String, egui::Rect)> {
    let roles = [Role::Button, Role::Slider, Role::ComboBox, Role::TextInput, Role::CheckBox];
    let all = roles.into_iter().flat_map(|role| harness.query_all_by_role(role));
    all.map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()))
        // A pole is a mark of the map, which labels and buttons keep clear of by themselves.
        .filter(|(label, _)| !label.contains(" pole, "))
        .collect()
}

#[test]
fn no_control_lies_on_another_at_any_usual_width() {
    let scenes = [
        "v=1&ac=navion",
        "v=1&ac=navion&cg=15&pin.ac=navion&lon.source=mode&lon.mode=3",
        "v=1&ac=navion&plane=lat&lat.source=aileron&lat.shape=3211&tab=phase",
        "v=1&ac=b747-cruise-etkin&tab=frequency&page=matrix",
        "v=1&ac=navion&lon.source=turbulence&tab=figures&nonlinear=1",
        "v=1&ac=navion&pane=aircraft",
        "v=1&ac=navion&pane=poles",
        "v=1&ac=navion&plane=lat&pane=response&split=modes",
    ];
    let mut on_each_other = Vec::new();
    for width in [720.0, 960.0, 1024.0, 1180.0, 1366.0, 1440.0] {
        let mut harness = page(Vec2::new(width, 820.0));
        for scene in scenes {
            open(&mut harness, scene);
            let controls = controls(&harness);
            assert!(controls.len() > 30, "{width} {scene}: {}", controls.len());
            for (i, (name, rect)) in controls.iter().enumerate() {
                for (other, place) in &controls[i + 1..] {
                    let shared = rect.intersect(*place);
                    if shared.width() > 0.5 && shared.height() > 0.5 {
                        on_each_other.push(format!("{width} {scene}: {name} {rect} and {other} {place}"));
                    }
                }
            }
        }
    }
    assert!(on_each_other.is_empty(), "{}", on_each_other.join("\n"));
}
