//! The user interface by role and name, without a window.

mod page;

use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::analysis::PlaneAnalysis;
use eigenwing::scenario::{Page, Parameter, Source, parameters};
use eigenwing::ui::App;
use eigenwing::words;
use page::{PHONE, TABLET, WIDE, app, choose, open, page, type_into, value};

fn analysis(harness: &page::Page) -> &PlaneAnalysis {
    app(harness).findings().plane().expect("an analysis of the plane on screen")
}

/// The rows of a page that the aircraft on screen has.
fn rows(harness: &page::Page, page: Page) -> Vec<&'static Parameter> {
    let scenario = app(harness).scenario();
    parameters().filter(|p| p.is_shown(scenario, page)).collect()
}

const PITCH_STIFFNESS: &str = "pitch stiffness C_mα";

#[test]
fn every_parameter_of_every_page_and_plane_has_a_slider_and_a_field_by_name() {
    let mut harness = page(WIDE);
    for (plane, words) in [(Plane::Longitudinal, "Longitudinal"), (Plane::Lateral, "Lateral–directional")] {
        harness.get_by_label(words).click();
        harness.run();
        assert_eq!(app(&harness).scenario().plane, plane);
        for page in Page::ALL {
            harness.get_by_label(words::sliders::page(page)).click();
            harness.run();
            let rows = rows(&harness, page);
            assert!(rows.len() >= 15, "{page:?} {plane:?}");
            // One more is the time of the playback.
            assert_eq!(harness.query_all_by_role(Role::Slider).count(), rows.len() + 1, "{page:?} {plane:?}");
            for p in rows {
                let named = |node: &egui_kittest::Node<'_>| {
                    node.accesskit_node()
                        .label()
                        .is_some_and(|label| label.starts_with(&format!("{} ", p.name)))
                };
                assert!(harness.get_all_by_role(Role::Slider).any(|node| named(&node)), "{}", p.name);
            }
        }
    }
}

#[test]
fn an_arrow_key_moves_a_slider_and_the_poles_in_the_same_frame() {
    let mut harness = page(WIDE);
    let before = analysis(&harness).modes[0].lambda;
    harness.get_by_role_and_label(Role::Slider, PITCH_STIFFNESS).focus();
    harness.run();
    let (m_w, computations) = (value(&harness, "cm_alpha"), app(&harness).computations());
    harness.key_press(Key::ArrowLeft);
    harness.step();
    let fine = m_w - value(&harness, "cm_alpha");
    assert!(fine > 0.0);
    assert!(analysis(&harness).modes[0].lambda.im > before.im, "stiffer pitch, faster short period");
    assert_eq!(app(&harness).computations(), computations + 1, "one edit, one computation");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    harness.run();
    let both = m_w - value(&harness, "cm_alpha");
    // A step ends on a round number, so that the first one may be shorter than the others.
    assert!((10.0..=21.0).contains(&(both / fine)), "{both} after {fine}");
    harness.key_press(Key::Delete);
    harness.run();
    assert_eq!(value(&harness, "cm_alpha"), m_w);
}

#[test]
fn every_slider_can_be_taken_to_both_ends_by_keyboard() {
    for (size, page_of) in [(WIDE, Page::Coefficients), (TABLET, Page::Matrix)] {
        let mut harness = page(size);
        harness.get_by_label(words::sliders::page(page_of)).click();
        harness.run();
        for p in rows(&harness, page_of) {
            let start = format!("{} ", p.name);
            let label = harness
                .get_all_by_role(Role::Slider)
                .filter_map(|node| node.accesskit_node().label())
                .filter(|label| label.starts_with(&start))
                // The symbol is one word: a longer label is that of another row with a longer name.
                .min_by_key(|label| label.len())
                .expect("a slider");
            for (key, end) in [(Key::Home, false), (Key::End, true)] {
                harness.get_by_role_and_label(Role::Slider, &label).focus();
                harness.run();
                harness.key_press(key);
                harness.run();
                let range = p.range(app(&harness).scenario());
                let expected = if end { *range.end() } else { *range.start() };
                let reached = value(&harness, p.key);
                assert!((reached - expected).abs() <= 1e-9 * expected.abs().max(1e-6), "{label}: {reached}");
            }
            harness.key_press(Key::Delete);
            harness.run();
        }
    }
}

#[test]
fn a_screen_reader_sets_a_slider_and_undo_takes_it_back() {
    let mut harness = page(WIDE);
    let before = value(&harness, "cm_q");
    harness.get_by_role_and_label(Role::Slider, "pitch damping C_mq").set_value_accesskit(-1.0);
    harness.run_steps(120);
    assert_eq!(value(&harness, "cm_q"), -1.0);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(value(&harness, "cm_q"), before);
    harness.get_by_label("Redo").click();
    harness.run();
    assert_eq!(value(&harness, "cm_q"), -1.0);
}

#[test]
fn the_wheel_over_a_slider_or_a_number_edits_nothing() {
    let mut harness = page(WIDE);
    let before = app(&harness).scenario().clone();
    for role in [Role::Slider, Role::TextInput] {
        let center = harness.get_all_by_role(role).next().expect("a control").rect().center();
        harness.hover_at(center);
        harness.run();
        harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: Vec2::new(3.0, 5.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        harness.run();
    }
    assert_eq!(app(&harness).scenario(), &before);
}

#[test]
fn a_typed_number_is_taken() {
    let mut harness = page(WIDE);
    type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.25");
    assert_eq!(value(&harness, "cm_alpha"), -0.25);
}

#[test]
fn a_typed_number_that_cannot_be_used_is_refused_in_a_sentence_and_nothing_is_lost() {
    for (text, sentence) in
        [("steep", "is not a number"), ("nan", "finite number"), ("1e300", "beyond anything meaningful")]
    {
        let mut harness = page(WIDE);
        let before = app(&harness).scenario().clone();
        type_into(&mut harness, "pitch stiffness C_mα, typed", text);
        assert_eq!(app(&harness).scenario(), &before);
        assert_eq!(harness.query_all_by_label_contains(sentence).count(), 1, "{text}");
        let field = harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed");
        assert_eq!(field.value().as_deref(), Some(text));
        // Escape gives the number back.
        field.focus();
        harness.run();
        harness.key_press(Key::Escape);
        harness.run();
        assert_eq!(harness.query_all_by_label_contains(sentence).count(), 0);
    }
}

#[test]
fn resetting_takes_back_one_or_all() {
    let mut harness = page(WIDE);
    type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.25");
    type_into(&mut harness, "pitch damping C_mq, typed", "-1");
    harness.get_by_label("Reset pitch stiffness C_mα").click();
    harness.run();
    assert_eq!((value(&harness, "cm_alpha"), value(&harness, "cm_q")), (-0.683, -1.0));
    harness.get_by_label("Reset all").click();
    harness.run();
    assert!(!app(&harness).scenario().is_edited());
}

#[test]
fn the_overall_level_is_told_for_the_class_and_category_that_are_chosen() {
    let mut harness = page(WIDE);
    harness.get_by_label("Level 1 overall, every criterion is met");
    choose(&mut harness, "Class of aircraft", "Class IV: high manoeuvrability");
    choose(&mut harness, "Category of flight phase", "Category A, combat: air combat and ground attack");
    // Table VI asks ζ ≥ 0.4 of a Class IV aircraft in air combat; the Navion's Dutch roll has 0.2.
    harness.get_by_label("Level 2 overall, set by the Dutch roll");
    type_into(&mut harness, "pitch stiffness C_mα, typed", "0.03");
    harness.get_by_label("Level 3 overall, set by the divergence of airspeed");
    // One step back each
    for _ in 0..3 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run();
    }
    assert_eq!(app(&harness).scenario().task, app(&harness).scenario().aircraft.task);
    // Where the source names no class, none is judged until one is chosen.
    choose(&mut harness, "Aircraft", "Lesson 4, gravity in the same unit");
    assert_eq!(harness.query_all_by_label_contains(" overall, ").count(), 0);
    choose(&mut harness, "Class of aircraft", "Class I: small and light");
    assert_eq!(harness.query_all_by_label_contains(" overall, ").count(), 1);
}

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
fn a_growing_root_has_no_time_constant() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=c47&plane=lat");
    let grows = |mode: &&eigenwing::flight::modes::mode::Mode| mode.time_to_double().is_some();
    assert_eq!(analysis(&harness).modes.iter().filter(grows).count(), 1, "the spiral");
    let with_constant = analysis(&harness).modes.iter().filter(|mode| mode.time_constant().is_some()).count();
    assert_eq!((with_constant, harness.query_all_by_label("τ").count()), (2, 1), "of the roll only");
}

#[test]
fn an_overdamped_short_period_is_judged_on_both_of_its_cards() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_q=-30&cm_alpha=-0.1");
    harness.get_by_label("Level of the fast root of the short period").click();
    harness.run();
    let both = harness.query_all_by_label_contains("Its two real roots are taken as one motion").count();
    assert!(both >= 4, "two criteria on either card: {both}");
}

#[test]
fn the_value_in_effect_is_larger_than_the_one_that_the_slider_sets() {
    for size in [WIDE, TABLET, PHONE] {
        let mut harness = page(size);
        let field = |harness: &page::Page| {
            harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").rect()
        };
        let alone = field(&harness);
        open(&mut harness, "v=1&ac=navion&cg=15.38");
        let effective = harness.get_by_role_and_label(Role::Label, "−0.000128").rect();
        let small = field(&harness);
        assert_eq!(
            harness.get_by_role_and_label(Role::TextInput, "pitch stiffness C_mα, typed").value().as_deref(),
            Some("−0.683")
        );
        // Where the number stood alone; beside it what the slider sets, in a field that is smaller.
        assert!(alone.expand(9.0).contains_rect(effective), "{size}: {effective} in {alone}");
        assert!(small.left() >= effective.right() && small.width() < alone.width() - 15.0, "{size}: {small}");
        assert!(small.height() <= alone.height(), "{size}: {small}");
        // It is still typed into.
        type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.7");
        assert_eq!(value(&harness, "cm_alpha"), -0.7);
    }
}

#[test]
fn the_knobs_and_what_stiffens_and_damps_are_in_sight_as_the_page_opens() {
    let mut harness = page(WIDE);
    let knob = |name: &str| name.starts_with("shift of the centre of gravity");
    for (plane, wanted) in [
        (
            "Longitudinal",
            ["airspeed V", "size of the horizontal tail", "pitch stiffness C_mα", "pitch damping C_mq"],
        ),
        ("Lateral–directional", ["airspeed V", "size of the fin", "weathercock stability", "roll damping"]),
    ] {
        harness.get_by_label(plane).click();
        harness.run();
        let list = harness.get_by_label("Find a derivative").rect().bottom()..=WIDE.y - 178.0;
        let sliders: Vec<(String, egui::Rect)> = harness
            .get_all_by_role(Role::Slider)
            .map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()))
            .collect();
        assert!(knob(&sliders[0].0), "{plane}: {}", sliders[0].0);
        for name in wanted {
            let (_, rect) = sliders.iter().find(|(label, _)| label.starts_with(name)).expect(name);
            assert!(list.contains(&rect.top()) && list.contains(&rect.bottom()), "{name} at {rect}");
        }
    }
    // What is next to nothing at low speed comes last.
    harness.get_by_label("Longitudinal").click();
    harness.run();
    let top = |name: &str| {
        harness
            .get_all_by_role(Role::Slider)
            .find(|node| node.accesskit_node().label().is_some_and(|l| l.contains(name)))
            .expect("a slider")
            .rect()
            .top()
    };
    assert!(top("C_LM") > top("C_mδe") && top("C_mM") > top("C_D"));
}

#[test]
fn help_has_a_button() {
    let mut harness = page(WIDE);
    harness.get_by_role_and_label(Role::Button, "Help: all keys").click();
    harness.run();
    assert_eq!(harness.query_all_by_role_and_label(Role::Heading, "Keys").count(), 1);
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
                    words::approximation::formula(name),
                    words::approximation::neglects(name),
                    words::approximation::name(name),
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
fn a_mode_is_flown_alone_from_its_card_and_given_up_again() {
    let mut harness = page(WIDE);
    harness.get_by_label("Fly the phugoid alone").click();
    harness.run_steps(4);
    harness.get_by_label("Pause");
    let choice = app(&harness).scenario().disturbance.choices.longitudinal;
    assert_eq!((choice.source, choice.mode), (Source::OneMode, 1));
    harness.get_by_label("Stop flying the phugoid alone").click();
    harness.run();
    assert_eq!(app(&harness).scenario().disturbance.choices.longitudinal.source, Source::Elevator);
}

#[test]
fn shape_levels_and_approximations_of_every_mode_are_shown_on_request() {
    let mut harness = page(WIDE);
    for (button, seen) in [
        ("Shape of the short period", "Shape of the short period: u/V"),
        ("Level of the phugoid", "Level 1: ζ is 0.0801, Level 1 asks at least 0.0400"),
        (
            "Approximations of the short period",
            "one degree of freedom (pitch): ωₙ 2.97 rad/s, exact 3.61, −18\u{a0}%; ζ 0.503, exact 0.696, −28\u{a0}%",
        ),
    ] {
        assert_eq!(harness.query_all_by_label_contains(seen).count(), 0, "{seen}");
        harness.get_by_label(button).click();
        harness.run();
        harness.get_by_label_contains(seen);
    }
}

/// A knob moves coefficients: each that it moves says to what, and the rest say nothing.
#[test]
fn a_knob_shows_what_it_moves() {
    let mut harness = page(WIDE);
    let told = |harness: &page::Page| {
        let sliders = harness.query_all_by_role(Role::Slider);
        sliders.filter(|slider| slider.value().is_some_and(|value| value.contains("in effect"))).count()
    };
    assert_eq!(told(&harness), 0);
    type_into(&mut harness, "airspeed V, typed", "60");
    // C_L, C_D and C_Dα follow the speed.
    assert_eq!(told(&harness), 3);
    let lift = harness.query_all_by_role(Role::Slider).find_map(|slider| {
        slider.value().filter(|value| value.starts_with("0.41") && value.contains("in effect"))
    });
    // 0.41 (53.64/60)² = 0.3277
    assert!(lift.as_ref().is_some_and(|value| value.contains("0.3277")), "{lift:?}");
}

/// On many keyboards the key of the search is typed with Shift.
#[test]
fn a_slash_goes_to_the_search_with_shift_or_without() {
    for modifiers in [Modifiers::NONE, Modifiers::SHIFT] {
        let mut harness = page(WIDE);
        harness.key_press_modifiers(modifiers, Key::Slash);
        harness.run();
        let search = harness.get_by_role_and_label(Role::TextInput, "Find a derivative");
        assert!(search.is_focused(), "{modifiers:?}");
    }
}

/// The list beside the cards names what moves each mode most, shows its path, and leads to its slider.
#[test]
fn the_strongest_derivatives_lead_to_their_sliders() {
    let link = |key: &str| format!("To the slider of {key}");
    let mut harness = page(WIDE);
    // The short period hangs on the pitch stiffness, its damping on that of pitch; the phugoid on lift (Lanchester) and drag.
    for key in ["pitch stiffness C_mα", "pitch damping C_mq", "trim lift C_L"] {
        harness.get_by_role_and_label(Role::Button, &link(key));
    }
    type_into_search(&mut harness, "drag");
    assert_eq!(harness.query_all_by_label("pitch stiffness C_mα").count(), 0);
    harness.get_by_role_and_label(Role::Button, &link("pitch stiffness C_mα")).click();
    harness.run();
    assert!(harness.get_by_role_and_label(Role::Slider, "pitch stiffness C_mα").is_focused());
    // On a phone the sliders are on another page.
    let mut harness = page(PHONE);
    harness.get_by_role_and_label(Role::Button, "Modes").click();
    harness.run();
    harness.get_by_role_and_label(Role::Button, &link("pitch damping C_mq")).click_accesskit();
    harness.run();
    assert!(harness.get_by_role_and_label(Role::Slider, "pitch damping C_mq").is_focused());
}

/// Under a hand that drags it a slider must mean the same from one pixel to the next.
#[test]
fn a_slider_keeps_its_place_and_length_where_two_roots_meet() {
    let mut harness = page(WIDE);
    let place = |harness: &page::Page| harness.get_by_role_and_label(Role::Slider, PITCH_STIFFNESS).rect();
    let before = (analysis(&harness).modes.len(), place(&harness));
    for value in ["-0.05", "0.2"] {
        open(&mut harness, &format!("v=1&ac=navion&cm_alpha={value}"));
        assert!(analysis(&harness).modes.len() > before.0);
        assert_eq!(place(&harness), before.1);
    }
}

/// What a button opens is opened on every card, those above it too.
#[test]
fn a_button_of_a_card_stays_under_the_pointer() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&plane=lat");
    for what in ["Shape of the roll mode", "Level of the roll mode"] {
        let before = harness.get_by_role_and_label(Role::Button, what).rect();
        harness.get_by_role_and_label(Role::Button, what).click();
        harness.run();
        let after = harness.get_by_role_and_label(Role::Button, what).rect();
        assert!((after.top() - before.top()).abs() < 1.0, "{what}: {before} to {after}");
    }
}

#[test]
fn a_search_finds_symbols_as_they_are_typed_and_points_to_where_else_it_would_find() {
    let mut harness = page(WIDE);
    let stiffness = "pitch stiffness C_mα";
    let shift = "shift of the centre of gravity Δx_cg/c";
    for (text, name) in [
        ("cma", stiffness),
        ("cm alpha", stiffness),
        ("cmalpha", stiffness),
        ("Cm_alpha", stiffness),
        ("c.g.", shift),
        ("cg", shift),
        ("CLq", "lift due to pitch rate C_Lq"),
    ] {
        type_into_search(&mut harness, text);
        assert_eq!(harness.query_all_by_role_and_label(Role::Slider, name).count(), 1, "{text}");
        harness.get_by_label("Show all sliders").click();
        harness.run();
    }
    for (text, place) in [
        ("dihedral", "is under Lateral–directional."),
        ("Z_w", "is under Dimensional."),
        ("no such thing", "No slider of this page matches “no such thing”."),
    ] {
        type_into_search(&mut harness, text);
        let sentence = harness.get_by_label_contains("No slider of this page").accesskit_node().value();
        let label = harness.get_by_label_contains("No slider of this page").accesskit_node().label();
        let said = label.or(sentence).unwrap_or_default();
        assert!(said.ends_with(place), "{text}: {said}");
        harness.get_by_label("Show all sliders").click();
        harness.run();
    }
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
fn chips_of_levels_have_one_form_and_one_order() {
    let mut harness = page(WIDE);
    let mut chips = 0;
    for link in ["v=1&ac=navion", "v=1&ac=navion&plane=lat", "v=1&ac=navion&cg=15.38"] {
        open(&mut harness, link);
        let stable: Vec<egui::Rect> = harness.query_all_by_label("stable").map(|chip| chip.rect()).collect();
        for level in harness.query_all_by_label_contains("Level of the ").map(|chip| chip.rect()) {
            let beside = stable.iter().find(|chip| (chip.center().y - level.center().y).abs() < 4.0);
            assert!(beside.is_some_and(|chip| chip.right() < level.left()), "{link}: {level} {stable:?}");
            chips += 1;
        }
    }
    assert!(chips >= 6, "{chips}");
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

fn type_into_search(harness: &mut page::Page, text: &str) {
    harness.get_by_role_and_label(Role::TextInput, "Find a derivative").focus();
    harness.run();
    harness.get_by_role_and_label(Role::TextInput, "Find a derivative").type_text(text);
    harness.run();
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
