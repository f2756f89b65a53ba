//! Homework beside the scene: how many answers count, what help costs, numbers of one's own, and the link that is handed in.

mod page;

use egui::accesskit::Role;
use egui::{OutputCommand, Vec2};
use egui_kittest::kittest::Queryable as _;
use eigenwing::content::{TextFile, embedded_aircraft};
use eigenwing::lesson::Records;
use eigenwing::scenario::link;
use page::{PHONE, Page, WIDE, app, open, page, type_into, value};

const HOMEWORK: &str = r##"+++
title = "Homework"
+++
## A question
```scene
link = "#v=1&ac=navion"
```
```predict
kind = "choose"
ask = "Which way?"
tries = 2
points = 2
[[choice]]
says = "Up"
because = "It is heavy."
[[choice]]
says = "Down"
right = true
[[choice]]
says = "Sideways"
because = "Nothing pushes it there."
```
```reveal
Seen.
```
## A task
```scene
link = "#v=1&ac=navion"
vary = { cm_alpha = [-0.9, -0.5] }
```
It swings with `= short_period.imaginary_part`.
```task
goal = "Damp it."
offer = ["cm_q"]
points = 3
unaided = true
hints = ["Which slider is the damping?"]
solution = "#v=1&ac=navion&cm_q=-18"
[[until]]
measure = "short_period.damping_ratio"
at_least = "1.1 × start"
```
"##;

fn homework(size: Vec2) -> Page {
    let mut harness = page(size);
    let file = TextFile::new("week 3.md", HOMEWORK);
    harness.state_mut().as_mut().expect("the page has been drawn").open_files(&[file]);
    harness.run();
    harness
}

fn click(harness: &mut Page, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run();
}

fn count(harness: &Page, label: &str) -> usize {
    harness.query_all_by_label_contains(label).count()
}

fn records(harness: &mut Page) -> Records {
    let stored = harness.state_mut().as_mut().expect("the page").take_changed_records();
    Records::read(&stored.expect("something was done")).expect("records")
}

#[test]
fn a_wrong_answer_may_be_followed_by_another_and_the_last_one_counts() {
    for size in [WIDE, PHONE] {
        let mut harness = homework(size);
        assert_eq!(count(&harness, "2 points · 2 tries"), 1, "{size}");
        click(&mut harness, "Up");
        click(&mut harness, "Answer");
        assert_eq!(count(&harness, "It is heavy."), 1, "{size}");
        assert_eq!(count(&harness, "One more answer counts."), 1);
        // Nothing is told yet of what is right.
        assert_eq!((count(&harness, "Seen."), count(&harness, "✓ Down")), (0, 0), "{size}");
        click(&mut harness, "Down");
        click(&mut harness, "Answer");
        assert_eq!(count(&harness, "That is right. 2 of 2 points."), 1, "{size}");
        assert_eq!((count(&harness, "Seen."), count(&harness, "One more answer")), (1, 0));
        // Wrong twice is wrong.
        let mut harness = homework(size);
        for answer in ["Up", "Sideways"] {
            click(&mut harness, answer);
            click(&mut harness, "Answer");
        }
        assert_eq!(count(&harness, "Not so. 0 of 2 points."), 1, "{size}");
        let given = &records(&mut harness).lessons["week-3.md"].answers;
        let (_, given) = given.iter().next().expect("it was answered");
        assert_eq!((given.earlier.len(), given.is_final), (1, true));
    }
}

#[test]
fn answers_are_forgotten_when_that_is_asked_for_twice_and_the_record_says_how_often() {
    for size in [WIDE, PHONE] {
        let mut harness = homework(size);
        click(&mut harness, "Down");
        click(&mut harness, "Answer");
        assert_eq!(count(&harness, "2 of 2 points"), 1, "{size}");
        let asks = |harness: &mut Page| {
            click(harness, "Step 1 of 2");
            click(harness, "Forget my answers …");
        };
        // Whoever closes the menu has thought better of it.
        asks(&mut harness);
        harness.key_press(egui::Key::Escape);
        harness.run();
        asks(&mut harness);
        click(&mut harness, "All answers to this lesson are lost: forget them");
        assert_eq!(count(&harness, "2 points · 2 tries"), 1, "{size}");
        let record = &records(&mut harness).lessons["week-3.md"];
        assert_eq!((record.begun_again, record.answers.iter().count()), (1, 0), "{size}");
        assert!(!record.files.is_empty(), "its file stays");
    }
}

#[test]
fn numbers_of_ones_own_wait_for_a_name_and_the_link_that_is_handed_in_has_both() {
    for size in [WIDE, PHONE] {
        let mut harness = homework(size);
        click(&mut harness, "Skip →");
        assert_eq!(count(&harness, "Here everybody has numbers of their own."), 1, "{size}");
        assert_eq!((count(&harness, "It swings with"), count(&harness, "Damp it.")), (0, 0));
        type_into(&mut harness, "Your name or number", "Ada L.");
        assert_eq!(count(&harness, "Damp it."), 1, "{size}");
        let stiffness = value(&harness, "cm_alpha");
        assert!((-0.9..=-0.5).contains(&stiffness) && stiffness != -0.683, "{stiffness}");
        assert_eq!(count(&harness, "3 points, only without a hint or the solution"), 1, "{size}");
        assert_eq!(count(&harness, "Copy the link to hand in"), 0, "{size}");
        let link = format!("#v=1&ac=navion&cm_alpha={stiffness}&cm_q=-18&lesson=week-3.md&step=2");
        open(&mut harness, &link);
        assert_eq!(count(&harness, "✓ Done"), 1, "{size}");
        assert_eq!(count(&harness, "3 of 3 points"), 1, "{size}");
        harness.run();
        click(&mut harness, "Copy the link to hand in");
        let copied = harness.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        let aircraft: Vec<_> = embedded_aircraft().0.into_iter().map(Into::into).collect();
        if let Some(copied) = copied {
            let opened = link::read(&copied, &aircraft).expect("an aircraft");
            assert_eq!(opened.notices, [], "{copied}");
            let (place, handed_in) = (opened.lesson.expect("a step"), opened.handed_in.expect("a name"));
            assert_eq!(
                (place.address.as_str(), place.step, handed_in.by.as_str()),
                ("week-3.md", 1, "Ada L.")
            );
        }
        assert_eq!(count(&harness, "Link copied"), 1, "{size}");
        let record = &records(&mut harness).lessons["week-3.md"];
        assert_eq!(record.seed, "Ada L.");
        assert!(!record.version.is_empty());
        // Taken up again, it begins with the same numbers.
        click(&mut harness, "Begin again");
        assert_eq!(value(&harness, "cm_alpha"), stiffness);
        assert_eq!(value(&harness, "cm_q"), -9.96);
    }
}

#[test]
fn a_hint_that_costs_the_points_says_so_before_and_after() {
    let mut harness = homework(WIDE);
    harness.state_mut().as_mut().expect("the page").take_up_records(r#"{"person":"Ada"}"#, "");
    click(&mut harness, "Skip →");
    type_into(&mut harness, "Your name or number", "Ada");
    click(&mut harness, "Give me a hint");
    assert_eq!(count(&harness, "No points any more: a hint was shown."), 1);
    // What isn't offered doesn't count, and is told.
    let unoffered = "#v=1&ac=navion&cm_q=-18&cg=3&lesson=week-3.md&step=2";
    open(&mut harness, unoffered);
    assert_eq!(count(&harness, "✓ Done"), 0);
    assert_eq!(count(&harness, "which isn’t offered"), 1);
    assert_eq!(app(&harness).scenario().aircraft.key, "navion");
}
