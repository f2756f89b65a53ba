//! What a stage hides is nowhere on the page, and what it locks can't be moved.

mod page;

use egui::accesskit::{Action, ActionData, ActionRequest, Role};
use egui::{Key, Pos2, Rect, Shape, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::embedded_aircraft;
use eigenwing::findings::Findings;
use eigenwing::flight::aircraft::plane::Plane;
use eigenwing::flight::modes::mode_name::ModeName;
use eigenwing::key::Keyed as _;
use eigenwing::number::{eigenvalue, significant};
use eigenwing::scenario::{Hidden, Parameter, Scenario};
use eigenwing::words;
use page::{PHONE, Page, TABLET, WIDE, app, open, page, value};

const EVERYTHING: &str = "hide=names.numbers.reasons.verdicts.levels.curves.aircraft-name";

/// Everything that a screen reader finds: names, values and descriptions.
fn told(page: &Page) -> Vec<String> {
    let mut told = Vec::new();
    for node in page.root().children_recursive() {
        let node = node.accesskit_node();
        told.extend([node.label(), node.value()].into_iter().flatten());
        told.extend(node.data().description().map(str::to_owned));
    }
    told
}

/// Everything that is written on the picture.
fn written(page: &Page) -> Vec<String> {
    fn gather(shape: &Shape, texts: &mut Vec<String>) {
        match shape {
            Shape::Text(text) => texts.push(text.galley.text().to_owned()),
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, texts)),
            _ => {}
        }
    }
    let mut texts = Vec::new();
    page.output().shapes.iter().for_each(|clipped| gather(&clipped.shape, &mut texts));
    texts
}

const BESIDE_THE_FOUR: [ModeName; 11] = [
    ModeName::Height,
    ModeName::Heading,
    ModeName::Washout,
    ModeName::ElevatorActuator,
    ModeName::Engine,
    ModeName::AileronActuator,
    ModeName::RudderActuator,
    ModeName::FeedbackOscillation,
    ModeName::Position,
    ModeName::FurtherState,
    ModeName::FurtherOscillation,
];

/// What nobody may read where everything is hidden.
fn secrets(scenario: &Scenario) -> Vec<String> {
    let mut secrets = vec![scenario.aircraft.name.clone()];
    // Those of other states are not on the page, and "height" is a word of everyday.
    for name in ModeName::VALUES.iter().filter(|name| !BESIDE_THE_FOUR.contains(name)) {
        secrets.extend([words::mode::title(*name), words::mode::in_a_sentence(*name)].map(str::to_owned));
    }
    secrets
        .extend(["Level 1", "Level 2", "Level 3", "no level", "ynamically", "tatically"].map(str::to_owned));
    for mode in Findings::of(scenario.clone()).modes() {
        secrets.push(eigenvalue(mode.lambda));
        secrets.extend(mode.natural_frequency().map(|wn| format!("{} rad/s", significant(wn, 3))));
        secrets.extend(mode.period().map(|period| format!("{} s", significant(period, 3))));
        secrets.push(words::mode::plain_numbers(mode));
    }
    secrets.retain(|secret| !secret.is_empty());
    secrets
}

/// Words of a verdict, as whole words.
fn is_verdict(text: &str) -> bool {
    let text = text.replace("neutral point", "");
    let mut words = text.split(|c: char| !c.is_alphabetic());
    words.any(|word| ["stable", "unstable", "neutral"].contains(&word.to_lowercase().as_str()))
}

fn assert_silent(page: &Page, secrets: &[String], when: &str) {
    let axes = ["stable", "unstable"];
    let written = written(page).into_iter().filter(|text| !axes.contains(&text.as_str()));
    let told: Vec<String> = told(page).into_iter().chain(written).collect();
    for text in &told {
        let lower = text.to_lowercase();
        let secret = secrets.iter().find(|secret| lower.contains(&secret.to_lowercase()));
        assert_eq!(secret, None, "{when}: “{text}”");
        assert!(!is_verdict(text), "{when}: “{text}”");
    }
}

/// The middle of what has a label that begins so.
fn places(page: &Page, begins: &str) -> Vec<Pos2> {
    let nodes = page.root().children_recursive();
    let labelled = |node: &egui_kittest::Node<'_>| {
        node.accesskit_node().label().is_some_and(|label| label.starts_with(begins))
    };
    nodes.filter(labelled).map(|node| node.rect().center()).collect()
}

/// Rests there until a hover text has come.
fn rest_at(page: &mut Page, place: Pos2) {
    page.hover_at(place);
    for _ in 0..6 {
        page.step();
    }
}

#[test]
fn nothing_that_is_hidden_is_told_or_written_of_any_aircraft_in_either_plane() {
    let mut harness = page(WIDE);
    for aircraft in embedded_aircraft().0 {
        for plane in Plane::ALL.into_iter().filter(|plane| aircraft.plane_notes[*plane].is_some()) {
            for rest in [
                "",
                "&tab=phase",
                "&tab=frequency",
                "&tab=figures&marks=approximations.levels",
                "&page=matrix&coloured=1&entries=full",
                "&stage=equations.poles.modes&coloured=2",
            ] {
                let link = format!(
                    "v=1&ac={}&plane={}{rest}&details=shape.levels.approximations&split=modes&flight=nonlinear&{EVERYTHING}",
                    aircraft.key,
                    plane.in_links()
                );
                open(&mut harness, &link);
                let secrets = secrets(app(&harness).scenario());
                assert_silent(&harness, &secrets, &link);
            }
        }
    }
}

#[test]
fn neither_hovering_nor_the_keyboard_answers_a_riddle() {
    for (ac, plane) in [("navion", "lon"), ("b747-approach", "lat")] {
        for size in [WIDE, TABLET, PHONE] {
            let mut harness = page(size);
            let link =
                format!("v=1&ac={ac}&plane={plane}&pin.ac={ac}&pin.speed=70&t=2&marks=levels&{EVERYTHING}");
            open(&mut harness, &link);
            let secrets = secrets(app(&harness).scenario());
            let mut hovered = 0;
            for begins in [
                "Mode ",
                "Fly the mode",
                "pitch stiffness",
                "weathercock",
                "α in",
                "β in",
                "The aircraft",
                "Legend",
                "Aircraft:",
                "To the slider",
                "Pole map",
                "Unpin",
                "Share",
            ] {
                for place in places(&harness, begins) {
                    rest_at(&mut harness, place);
                    assert_silent(&harness, &secrets, &format!("{size} {ac} {begins}"));
                    hovered += 1;
                }
            }
            assert!(hovered > 6, "{hovered}");
            for _ in 0..90 {
                harness.key_press(Key::Tab);
                harness.step();
                harness.step();
                assert_silent(&harness, &secrets, &format!("{size} {ac} by Tab"));
            }
        }
    }
}

/// What the tests above look for is found where nothing is hidden, so they would find it.
#[test]
fn where_nothing_is_hidden_hovering_and_the_keyboard_tell_all_of_it() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&plane=lon");
    let secrets = secrets(app(&harness).scenario());
    let count = |harness: &Page| {
        let all: Vec<String> = told(harness).into_iter().chain(written(harness)).collect();
        secrets.iter().filter(|secret| all.iter().any(|text| text.contains(*secret))).count()
    };
    let at_rest = count(&harness);
    assert!(at_rest > 8, "{at_rest}");
    let before = told(&harness).len();
    let aircraft = places(&harness, "Fly the short period")[0];
    rest_at(&mut harness, aircraft);
    assert!(told(&harness).len() > before, "a hover text has come");
}

#[test]
fn each_word_hides_what_it_names_and_leaves_the_rest() {
    let link = "v=1&ac=b747-approach&split=modes&details=shape.levels.approximations";
    let mut harness = page(WIDE);
    let mut seen = |hide: &str| {
        open(&mut harness, &format!("{link}{hide}"));
        told(&harness).join("\n") + &written(&harness).join("\n")
    };
    let all = seen("");
    for (hidden, words) in [
        (Hidden::Names, &["Phugoid", "short period"][..]),
        (Hidden::Numbers, &[" · T "][..]),
        (Hidden::Reasons, &["Participation", "Which derivative moves which mode"][..]),
        (Hidden::Verdicts, &["Dynamically", "Statically"][..]),
        (Hidden::Levels, &[" · Cat ", "Level boundaries"][..]),
        (Hidden::AircraftName, &["Boeing 747"][..]),
    ] {
        let left = seen(&format!("&hide={}", hidden.key()));
        for word in words {
            assert!(all.contains(word), "{word} is on the page");
            assert!(!left.contains(word), "{word} is hidden with {}", hidden.key());
        }
        // The sliders stay, and so does what isn't hidden.
        assert!(left.contains("pitch stiffness"), "{}", hidden.key());
        if hidden != Hidden::AircraftName {
            assert!(left.contains("Boeing 747"), "{}", hidden.key());
        }
        if hidden != Hidden::Verdicts {
            assert!(left.contains("Dynamically"), "{}", hidden.key());
        }
        if hidden != Hidden::Names {
            assert!(left.contains("Phugoid"), "{}", hidden.key());
        }
    }
}

#[test]
fn what_is_said_of_a_damaged_link_keeps_the_name_that_the_link_hides() {
    let mut harness = page(WIDE);
    let damaged = "v=1&ac=lesson&speed=70&page=coefficients&hide=aircraft-name";
    harness.state_mut().as_mut().expect("a page").open(damaged);
    let said = harness.state_mut().as_mut().expect("a page").take_unsaid().expect("a sentence");
    let name = app(&harness).scenario().aircraft.name.clone();
    assert!(said.contains("airspeed") && !said.contains(&name), "{said}");
}

fn set_by_reader(harness: &mut Page, label: &str, number: f64) -> bool {
    let sliders = harness.query_all_by_role(Role::Slider);
    let slider = sliders
        .into_iter()
        .find(|node| node.accesskit_node().label().is_some_and(|name| name.starts_with(label)));
    let Some(target) = slider.map(|node| node.accesskit_node().locate()) else { return false };
    let data = Some(ActionData::NumericValue(number));
    let (target_node, target_tree) = target;
    harness.event(egui::Event::AccessKitActionRequest(ActionRequest {
        action: Action::SetValue,
        target_tree,
        target_node,
        data,
    }));
    harness.run();
    true
}

fn drag(harness: &mut Page, from: Pos2, by: Vec2) {
    harness.drag_at(from);
    harness.run();
    for part in 1..=4 {
        harness.hover_at(from + 0.25 * part as f32 * by);
        harness.step();
    }
    harness.drop_at(from + by);
    harness.run();
}

#[test]
fn a_locked_parameter_moves_by_no_hand_key_reader_pole_or_undo() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        open(&mut harness, "v=1&ac=navion&cm_alpha=-0.5");
        open(&mut harness, "v=1&ac=navion&cm_alpha=-0.9&lock=cm_alpha.aircraft");
        assert!(!set_by_reader(&mut harness, "pitch stiffness", -1.5), "there is no slider");
        assert!(
            !places(&harness, "pitch stiffness C_mα: −0.9").is_empty() || size == PHONE,
            "but its number"
        );
        assert!(set_by_reader(&mut harness, "pitch damping C_mq", -20.0), "others move");
        assert!((value(&harness, "cm_q") + 20.0).abs() < 1e-9);
        for place in places(&harness, "Short period pole") {
            drag(&mut harness, place, Vec2::new(-20.0, -30.0));
        }
        for key in [Key::ArrowRight, Key::ArrowUp, Key::Delete, Key::End] {
            for _ in 0..3 {
                harness.key_press(Key::Tab);
                harness.step();
                harness.key_press(key);
                harness.step();
            }
        }
        assert_eq!(value(&harness, "cm_alpha"), -0.9, "{size}");
        for _ in 0..12 {
            harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
            harness.run();
            assert_eq!(value(&harness, "cm_alpha"), -0.9, "{size}");
        }
        // Without the lock the way back leads to where it was.
        open(&mut harness, "v=1&ac=navion&cm_alpha=-0.9");
        assert!(set_by_reader(&mut harness, "pitch stiffness", -1.5), "a slider again");
        assert_eq!(value(&harness, "cm_alpha"), -1.5);
    }
}

#[test]
fn all_that_is_locked_stays_whatever_is_tried() {
    let mut harness = page(WIDE);
    let link = "v=1&ac=navion&cm_alpha=-0.9&elevator=2&lon.source=elevator&time=30&tab=phase&lock=aircraft.plane.disturbance.view.all";
    open(&mut harness, "v=1&ac=b747-approach&plane=lat");
    open(&mut harness, link);
    let before = app(&harness).link();
    let scenario = app(&harness).scenario().clone();
    for place in places(&harness, "Short period pole").into_iter().chain(places(&harness, "Phugoid pole")) {
        drag(&mut harness, place, Vec2::new(-20.0, -30.0));
    }
    let buttons: Vec<Pos2> = harness
        .root()
        .children_recursive()
        .filter(|node| matches!(node.accesskit_node().role(), Role::Button | Role::ComboBox | Role::CheckBox))
        .filter(|node| {
            // What opens a sheet, or pins, is no change of the scene.
            let label = node.accesskit_node().label().unwrap_or_default();
            ![
                "Help",
                "Lessons",
                "Share",
                "Pin",
                "light",
                "dark",
                "Dark",
                "Light",
                "projector",
                "source and remarks",
            ]
            .iter()
            .any(|word| label.contains(word))
        })
        .map(|node| node.rect().center())
        .collect();
    assert!(buttons.len() > 20, "{}", buttons.len());
    for place in buttons {
        harness.drag_at(place);
        harness.drop_at(place);
        harness.run_steps(2);
        harness.key_press(Key::Escape);
        harness.run_steps(2);
    }
    for key in [Key::Z, Key::Y] {
        for _ in 0..4 {
            harness.key_press_modifiers(egui::Modifiers::COMMAND, key);
            harness.run_steps(2);
        }
    }
    for _ in 0..60 {
        for key in [Key::Tab, Key::Space, Key::ArrowDown, Key::ArrowRight, Key::Escape] {
            harness.key_press(key);
            harness.run_steps(1);
        }
    }
    assert_eq!(*app(&harness).scenario(), scenario);
    let after = app(&harness).link();
    let unplayed = |link: &str| {
        link.split('&')
            .filter(|piece| {
                !piece.starts_with("rate") && !piece.starts_with("loop") && !piece.starts_with("pin.")
            })
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(unplayed(&after), unplayed(&before));
}

#[test]
fn a_pole_is_dragged_by_what_is_free() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&lock=cm_alpha.cm_q");
    let before = app(&harness).scenario().clone();
    let place = places(&harness, "Short period pole")[0];
    drag(&mut harness, place, Vec2::new(-25.0, 0.0));
    let after = app(&harness).scenario().clone();
    assert_ne!(after, before, "by others");
    for key in ["cm_alpha", "cm_q"] {
        assert_eq!(value(&harness, key), Parameter::find(key).expect("a row").get(&before), "{key}");
    }
    // A task that offers one slider is solved by that one.
    open(&mut harness, "v=1&ac=navion&offer=cm_q");
    let before = app(&harness).scenario().clone();
    let place = places(&harness, "Short period pole")[0];
    drag(&mut harness, place, Vec2::new(-25.0, -10.0));
    assert_ne!(value(&harness, "cm_q"), Parameter::find("cm_q").expect("a row").get(&before));
    assert_eq!(value(&harness, "cm_alpha"), Parameter::find("cm_alpha").expect("a row").get(&before));
}

/// Pitch damping moves nothing of lateral motion.
#[test]
fn where_no_slider_of_a_page_is_offered_it_says_so() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&plane=lat&offer=cm_q");
    let told = told(&harness);
    assert!(told.iter().any(|text| text == words::sliders::NOT_OFFERED));
    assert!(!told.iter().any(|text| text.contains("can't be analysed")));
}

#[test]
fn type_is_as_large_as_the_link_says_and_goes_back_with_another_scene() {
    let mut harness = page(WIDE);
    let height = |harness: &Page| -> f32 {
        let bounds: Rect = harness.get_by_label("Eigenwing").rect();
        bounds.height() * harness.ctx.zoom_factor()
    };
    let usual = height(&harness);
    open(&mut harness, "v=1&ac=navion&type=1.5");
    assert_eq!(harness.ctx.zoom_factor(), 1.5);
    assert!((height(&harness) / usual - 1.5).abs() < 0.1);
    assert!(app(&harness).link().contains("type=1.5"));
    open(&mut harness, "v=1&ac=navion");
    assert_eq!(harness.ctx.zoom_factor(), 1.0);
}
