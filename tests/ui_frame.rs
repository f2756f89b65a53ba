//! The page in a frame of another page: what it tells, what it keeps to, how high it would like to be, and how a frame is made.

mod page;

use std::collections::BTreeSet;

use egui::accesskit::{Action, ActionData, ActionRequest, Role};
use egui::{Key, Modifiers, Theme, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::TextFile;
use eigenwing::export::Event;
use eigenwing::scenario::view::Look;
use eigenwing::ui::App;
use page::{PHONE, Page, WIDE, app, open, page};

const LESSON: &str = r##"+++
title = "Two questions"
+++

## A question

```scene
link = "#v=1&ac=navion&stage=poles&lock=aircraft"
```

```predict
kind = "choose"
ask = "Which?"
[[choice]]
says = "This one."
right = true
[[choice]]
says = "The other."
because = "It isn't."
```

## A task

```scene
link = "#v=1&ac=navion"
```

```task
goal = "Slow it down."
offer = ["cm_alpha"]
solution_after = "never"
solution = "#v=1&ac=navion&cm_alpha=-0.3"
[[until]]
measure = "parameter.cm_alpha"
at_least = "-0.4"
```
"##;

fn app_of(harness: &mut Page) -> &mut App {
    harness.state_mut().as_mut().expect("the page has been drawn")
}

/// The page in a frame, with a link.
fn framed(size: Vec2, link: &str) -> Page {
    let mut harness = page(size);
    app_of(&mut harness).stand_in_frame();
    open(&mut harness, link);
    app_of(&mut harness).want_events();
    harness
}

fn events(harness: &mut Page) -> Vec<Event> {
    app_of(harness).take_events()
}

fn scenes(events: &[Event]) -> Vec<&str> {
    let links = events.iter().filter_map(|event| match event {
        Event::Scene { link } => Some(link.as_str()),
        _ => None,
    });
    links.collect()
}

fn rest(harness: &mut Page) {
    for _ in 0..40 {
        harness.step();
    }
}

fn act(
    harness: &mut Page,
    (target_node, target_tree): (egui::accesskit::NodeId, egui::accesskit::TreeId),
    action: Action,
    data: Option<ActionData>,
) {
    harness.event(egui::Event::AccessKitActionRequest(ActionRequest {
        action,
        target_tree,
        target_node,
        data,
    }));
    harness.step();
}

fn click(harness: &mut Page, label: &str) {
    harness.get_by_label(label).click_accesskit();
    harness.run();
}

fn set(harness: &mut Page, label: &str, number: f64) {
    let sliders = harness.query_all_by_role(Role::Slider);
    let slider = sliders
        .into_iter()
        .find(|node| node.accesskit_node().label().is_some_and(|name| name.starts_with(label)));
    let target = slider.expect("a slider").accesskit_node().locate();
    act(harness, target, Action::SetValue, Some(ActionData::NumericValue(number)));
}

#[test]
fn a_scene_is_told_once_it_is_at_rest() {
    let mut harness = framed(WIDE, "v=1&ac=navion&stage=poles.derivatives");
    rest(&mut harness);
    assert_eq!(events(&mut harness), [], "nothing has happened");
    for number in [-0.5, -0.6, -0.7] {
        set(&mut harness, "pitch stiffness", number);
    }
    assert_eq!(events(&mut harness), [], "it still moves");
    rest(&mut harness);
    let told = events(&mut harness);
    let scenes = scenes(&told);
    assert!(
        matches!(scenes[..], [link] if link.contains("cm_alpha=-0.7") && link.contains("stage=")),
        "{scenes:?}"
    );
}

#[test]
fn while_something_is_dragged_no_scene_is_told() {
    let mut harness = framed(WIDE, "v=1&ac=navion&stage=poles.derivatives");
    let slider = harness.query_all_by_role(Role::Slider).next().expect("a slider").rect();
    harness.drag_at(slider.center());
    harness.step();
    harness.hover_at(slider.center() + Vec2::new(20.0, 0.0));
    rest(&mut harness);
    assert_eq!(events(&mut harness), [], "it is held");
    harness.drop_at(slider.center() + Vec2::new(20.0, 0.0));
    rest(&mut harness);
    assert_eq!(scenes(&events(&mut harness)).len(), 1);
}

#[test]
fn steps_answers_and_goals_are_told_once_each_with_how_far_the_person_is() {
    let mut harness = page(WIDE);
    app_of(&mut harness).want_events();
    app_of(&mut harness).open_files(&[TextFile::new("two.md", LESSON)]);
    harness.run();
    click(&mut harness, "The other.");
    click(&mut harness, "Answer");
    click(&mut harness, "Next →");
    set(&mut harness, "pitch stiffness", -0.35);
    rest(&mut harness);
    set(&mut harness, "pitch stiffness", -0.3);
    rest(&mut harness);
    let told: Vec<Event> =
        events(&mut harness).into_iter().filter(|event| !matches!(event, Event::Scene { .. })).collect();
    match &told[..] {
        [
            Event::StepOpened { at: first, title },
            Event::Answered { at: answered, part: 1, right: Some(false), .. },
            Event::StepOpened { at: second, .. },
            Event::GoalReached { at: reached, part: 1, unaided: true, link },
        ] => {
            assert_eq!((first.lesson.as_str(), first.step, first.steps, first.done), ("two.md", 1, 2, 0));
            assert_eq!(title, "A question");
            assert_eq!((answered.step, answered.done), (1, 1));
            assert_eq!((second.step, second.done), (2, 1));
            assert_eq!((reached.step, reached.done), (2, 2));
            assert!(link.contains("cm_alpha=-0.35"), "{link}");
        }
        other => panic!("{other:?}"),
    }
    let Event::Report { records } = app(&harness).report_event() else { panic!("a report") };
    assert_eq!(records.lessons["two.md"].scenes.len(), 1);
}

#[test]
fn nobody_who_does_not_ask_is_told() {
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&ac=navion&cm_alpha=-0.5");
    rest(&mut harness);
    assert_eq!(events(&mut harness), []);
}

/// Everything that can be pressed, by what it is called, and how often it has been found.
fn found(harness: &Page) -> Vec<(String, (egui::accesskit::NodeId, egui::accesskit::TreeId))> {
    harness
        .root()
        .children_recursive()
        .map(|node| {
            let node = node.accesskit_node();
            (format!("{:?} {}", node.role(), node.label().unwrap_or_default()), node.locate())
        })
        .collect()
}

/// Presses, sets and steps everything that can be found, also in the sheets and lists that this opens; then every key.
fn sweep(harness: &mut Page) -> usize {
    let mut done = BTreeSet::new();
    for _ in 0..30 {
        let fresh: Vec<_> =
            found(harness).into_iter().filter(|(name, _)| done.insert(name.clone())).collect();
        if fresh.is_empty() {
            break;
        }
        for (_, target) in fresh {
            act(harness, target, Action::Click, None);
            act(harness, target, Action::SetValue, Some(ActionData::NumericValue(1.0)));
            act(harness, target, Action::SetValue, Some(ActionData::Value("7".into())));
            act(harness, target, Action::Increment, None);
            act(harness, target, Action::Decrement, None);
        }
        harness.run_steps(2);
    }
    for modifiers in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND] {
        for &key in Key::ALL {
            harness.key_press_modifiers(modifiers, key);
            harness.run_steps(1);
            harness.key_press(Key::Tab);
            harness.run_steps(1);
        }
    }
    done.len()
}

#[test]
fn nothing_in_a_frame_steps_around_its_locks() {
    let everything = "aircraft.plane.disturbance.view.all";
    for (size, stages) in [
        (WIDE, &["", "&stage=modes.response.equations"][..]),
        (Vec2::new(900.0, 600.0), &["&stage=poles.derivatives"]),
        (PHONE, &["&stage=modes.derivatives"]),
    ] {
        for stage in stages {
            let link = format!("v=1&ac=lesson-printed{stage}&lock={everything}");
            let mut harness = framed(size, &link);
            harness.run();
            let before = app(&harness).scenario().clone();
            let is_locked = |harness: &Page| app(harness).link().contains(everything);
            assert!(is_locked(&harness));
            let count = sweep(&mut harness);
            assert!(count > 15, "{count} on {size}");
            assert_eq!(*app(&harness).scenario(), before, "{size} {stage}");
            assert!(is_locked(&harness), "{size} {stage}: {}", app(&harness).link());
            assert!(!app(&harness).link().contains("pin."), "{size} {stage}: {}", app(&harness).link());
        }
    }
}

#[test]
fn with_the_aircraft_locked_only_what_is_free_moves_and_no_lesson_opens() {
    let mut harness = framed(WIDE, "v=1&ac=navion&lock=aircraft.cm_alpha&stage=poles.derivatives.modes");
    sweep(&mut harness);
    let scenario = app(&harness).scenario();
    assert_eq!(scenario.aircraft.key, "navion");
    assert_eq!(page::value(&harness, "cm_alpha"), -0.683);
    let link = app(&harness).link();
    assert!(link.contains("lock=aircraft.cm_alpha") && !link.contains("lesson="), "{link}");
}

#[test]
fn a_lesson_in_a_frame_stays_open() {
    let mut harness = framed(WIDE, "v=1&lesson=longitudinal&step=1");
    let last = |harness: &Page| app(harness).link().contains("lesson=longitudinal");
    assert!(last(&harness));
    for gone in ["Close the lesson", "Lessons: begin with a question", "To the lessons"] {
        assert!(harness.query_by_label(gone).is_none(), "{gone}");
    }
    harness.get_by_label("Help: all keys").click_accesskit();
    harness.run_steps(8);
    assert!(harness.query_by_label("Lessons").is_none());
    // On a page of its own they are there.
    let mut harness = page(WIDE);
    open(&mut harness, "v=1&lesson=longitudinal&step=1");
    harness.get_by_label("Close the lesson");
    harness.get_by_label("Lessons: begin with a question");
}

#[test]
fn the_height_that_is_wished_shows_the_stage_and_stays_once_it_is_granted() {
    for (width, stage) in [
        (1300.0, "&stage=poles"),
        (1300.0, "&stage=poles.aircraft.response"),
        (1300.0, "&stage=poles.derivatives&offer=cm_alpha.cm_q"),
        (900.0, "&stage=response.poles"),
        (900.0, "&stage=modes"),
        (390.0, "&stage=poles.derivatives&offer=cm_alpha.cm_q"),
        (390.0, "&stage=modes"),
        (1300.0, "&stage=poles&type=1.5"),
    ] {
        let link = format!("v=1&ac=navion{stage}");
        let mut height = 500.0;
        let mut wished = Vec::new();
        for _ in 0..4 {
            let harness = framed(Vec2::new(width, height), &link);
            height = app(&harness).wished_height(&harness.ctx);
            wished.push(height);
        }
        assert!((wished[3] - wished[1]).abs() < 2.0, "{width} {stage}: {wished:?}");
        assert!((200.0..=1200.0).contains(&height), "{width} {stage}: {height}");
    }
}

#[test]
fn the_look_of_a_link_is_in_force_until_a_person_chooses_another() {
    let mut harness = page(WIDE);
    Look::Light.set(&harness.ctx);
    open(&mut harness, "v=1&ac=navion&look=dark");
    assert_eq!(harness.ctx.theme(), Theme::Dark);
    assert_eq!(Look::chosen(&harness.ctx), Some(Look::Light), "theirs is kept");
    open(&mut harness, "v=1&ac=navion");
    assert_eq!(harness.ctx.theme(), Theme::Light);
    open(&mut harness, "v=1&ac=navion&look=dark");
    harness.key_press(Key::T);
    harness.run();
    assert_eq!(Look::of(&harness.ctx), Look::Projector);
    harness.run();
    assert!(!app(&harness).link().contains("look="), "{}", app(&harness).link());
}

fn html(harness: &Page) -> String {
    harness.get_by_label("HTML of the frame").accesskit_node().value().unwrap_or_default()
}

fn tick(harness: &mut Page, label: &str) {
    harness.get_by_role_and_label(Role::CheckBox, label).click_accesskit();
    harness.run();
}

#[test]
fn a_scene_is_embedded_by_keys_and_by_a_screen_reader() {
    let mut harness = page(WIDE);
    app_of(&mut harness).set_address("https://example.org/eigenwing/".to_owned());
    open(&mut harness, "v=1&ac=navion&cm_alpha=-0.5");
    harness.key_press(Key::M);
    harness.run();
    let begins = r#"<iframe src="https://example.org/eigenwing/#v=1&amp;ac=navion&amp;cm_alpha=-0.5"#;
    assert!(html(&harness).starts_with(begins), "{}", html(&harness));
    assert!(!html(&harness).contains("stage="), "everything is on");
    for label in ["Shows: aircraft", "Shows: modes", "Shows: responses", "Hides: numbers", "Locks: aircraft"]
    {
        tick(&mut harness, label);
    }
    let text = html(&harness);
    for piece in [
        "&amp;stage=derivatives.poles&amp;",
        "&amp;hide=numbers&amp;",
        "&amp;lock=aircraft",
        r#"height="480""#,
    ] {
        assert!(text.contains(piece), "{piece} in {text}");
    }
    // The page itself is as it was.
    assert!(!app(&harness).link().contains("stage="));
    click(&mut harness, "Copy the HTML");
    harness.get_by_label("Frame copied");
    click(&mut harness, "Close");
    assert!(harness.query_by_label("HTML of the frame").is_none());
}

#[test]
fn who_copies_a_link_is_offered_a_frame() {
    let mut harness = page(WIDE);
    harness.key_press(Key::L);
    harness.run_steps(3);
    harness.get_by_label("Link copied");
    harness.get_by_label("Embed this …").click_accesskit();
    harness.run_steps(3);
    harness.get_by_label("HTML of the frame");
    // Not in a frame: its host would have to.
    let mut harness = framed(WIDE, "v=1&ac=navion&stage=poles");
    harness.key_press(Key::L);
    harness.run_steps(3);
    harness.get_by_label("Link copied");
    assert!(harness.query_by_label("Embed this …").is_none());
    harness.key_press(Key::M);
    harness.run_steps(3);
    assert!(harness.query_by_label("HTML of the frame").is_none());
}
