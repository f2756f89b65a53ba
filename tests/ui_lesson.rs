//! A lesson beside the scene: asked before it shows, on a wide page, a tablet and a phone.

mod page;

use std::path::Path;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::lesson::{Place, Records};
use eigenwing::scenario::Parameter;
use eigenwing::ui::FileRequest;
use page::{PHONE, Page, WIDE, app, open, page, type_into};

fn click(harness: &mut Page, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run();
}

/// How many steps the chapter on longitudinal modes has.
fn steps() -> usize {
    let text = include_str!("../assets/lessons/longitudinal.md");
    text.lines().filter(|line| line.starts_with("## ")).count()
}

/// Where the person is in it.
fn at_step(step: usize) -> String {
    format!("Step {step} of {}", steps())
}

fn count(harness: &Page, label: &str) -> usize {
    harness.query_all_by_label_contains(label).count()
}

/// Opens a lesson by the bar, or on a phone by the sheet of help.
fn open_lesson(harness: &mut Page, title: &str) {
    let by_bar = harness.query_by_label("Lessons: begin with a question").is_some();
    if by_bar {
        click(harness, "Lessons: begin with a question");
    } else {
        click(harness, "Help: all keys");
        click(harness, "Lessons");
    }
    click(harness, title);
}

#[test]
fn a_step_asks_before_it_shows_and_says_why_a_wrong_answer_is_wrong() {
    for size in [WIDE, Vec2::new(1000.0, 800.0), PHONE] {
        let mut harness = page(size);
        open_lesson(&mut harness, "Longitudinal modes");
        harness.get_by_label_contains("What does the nose do in the first seconds?");
        // Nothing is told yet: neither the reveal nor the cards of the modes beside it.
        assert_eq!(count(&harness, "It swings once in"), 0, "{size}");
        assert_eq!(count(&harness, "Fly the"), 0, "{size}");
        click(&mut harness, "It swings for minutes.");
        click(&mut harness, "Answer");
        harness.get_by_label("Not so.");
        assert_eq!(count(&harness, "The quick motion of the nose is damped by the tail"), 1, "{size}");
        // The numbers of the text are the model's: 2.42 s is the published period of the Navion's short period.
        assert!(count(&harness, "2.42") > 0, "{size}");
        click(&mut harness, "Next →");
        harness.get_by_label(&at_step(2));
        // What was answered stays.
        click(&mut harness, "← Back");
        harness.get_by_label("Not so.");
        click(&mut harness, "Close the lesson");
        assert_eq!(count(&harness, "Step 1 of"), 0, "{size}");
    }
}

#[test]
fn not_knowing_is_an_answer_and_an_estimate_is_judged_by_its_factor() {
    let mut harness = page(WIDE);
    open_lesson(&mut harness, "Longitudinal modes");
    click(&mut harness, "I don’t know");
    harness.get_by_label("Now you can find out.");
    for _ in 0..6 {
        if harness
            .query_all_by_role(Role::TextInput)
            .any(|node| node.accesskit_node().label().unwrap_or_default().starts_with("Your estimate"))
        {
            break;
        }
        let next = harness.query_by_label("Next →").is_some();
        click(&mut harness, if next { "Next →" } else { "Skip →" });
    }
    let field = harness
        .query_all_by_role(Role::TextInput)
        .find_map(|node| node.accesskit_node().label().filter(|label| label.starts_with("Your estimate")))
        .expect("a step asks for a number");
    type_into(&mut harness, &field, "ten");
    assert_eq!(count(&harness, "“ten” is not a number"), 1);
    type_into(&mut harness, &field, "1000000");
    click(&mut harness, "Answer");
    assert_eq!(count(&harness, "It is "), 1);
    assert_eq!(count(&harness, "Within 10 %"), 0);
}

/// A challenge of the hangar: no condition is met at its start, its solution meets all.
#[test]
fn a_task_tells_how_near_it_is_and_shows_a_solution_last() {
    let mut harness = page(WIDE);
    open_lesson(&mut harness, "The hangar");
    let mut tasks = 0;
    for _ in 0..20 {
        if count(&harness, ", wanted ") > 0 {
            tasks += 1;
            assert_eq!(count(&harness, "✓ Done"), 0);
            while harness.query_by_label("Give me a hint").is_some() {
                assert!(harness.query_by_label("Show a solution").is_none(), "hints come first");
                click(&mut harness, "Give me a hint");
            }
            if harness.query_by_label("Show a solution").is_some() {
                click(&mut harness, "Show a solution");
                assert_eq!(count(&harness, "✓ Done"), 1, "task {tasks}");
            }
        }
        let next = ["Next →", "Skip →"].into_iter().find(|label| {
            harness.query_by_label(label).is_some_and(|node| !node.accesskit_node().is_disabled())
        });
        let Some(next) = next else { break };
        click(&mut harness, next);
    }
    assert!(tasks >= 8, "{tasks}");
    // A slider that no task offers is there again once the lesson is closed.
    click(&mut harness, "Close the lesson");
    assert!(harness.query_all_by_role(Role::Slider).count() > 10);
    assert!(Parameter::find("cm_alpha").is_some());
}

#[test]
fn a_question_with_several_right_answers_says_so_until_it_is_answered() {
    for size in [WIDE, PHONE] {
        let mut harness = page(size);
        open(&mut harness, "#v=1&lesson=frames");
        assert_eq!(count(&harness, "More than one may be right."), 1);
        click(&mut harness, "I don’t know");
        assert_eq!(count(&harness, "More than one may be right."), 0);
        // The next question has one answer.
        click(&mut harness, "Next →");
        assert_eq!(count(&harness, "More than one may be right."), 0);
    }
}

#[test]
fn no_line_begins_with_a_comma_or_a_stop() {
    for place in ["forces&step=1", "frames&step=6"] {
        let mut harness = page(PHONE);
        open(&mut harness, &format!("#v=1&lesson={place}"));
        click(&mut harness, "I don’t know");
        for node in harness.query_all_by_role(Role::Label) {
            let text = node.accesskit_node().value().unwrap_or_default();
            let begins = node.rect().left();
            assert!(!text.starts_with([',', '.']) || begins > 40.0, "{place}: “{text}” at {begins}");
        }
    }
}

/// Each task has the sliders that it offers, whatever the step before it had.
#[test]
fn a_task_offers_its_own_sliders() {
    let mut harness = page(WIDE);
    open_lesson(&mut harness, "Longitudinal modes");
    let mut offers = 0;
    for step in 1..steps() {
        let next = harness.query_by_label("Next →").is_some();
        click(&mut harness, if next { "Next →" } else { "Skip →" });
        harness.get_by_label(&at_step(step + 1));
        if count(&harness, "The centre of gravity moves aft, step by step.") > 0 {
            click(&mut harness, "I don’t know");
            assert_eq!(count(&harness, "Move the centre of gravity until"), 1);
            harness.get_by_role_and_label(Role::Slider, "shift of the centre of gravity Δx_cg/c");
            offers += 1;
        }
    }
    assert_eq!(offers, 1);
}

/// A goal tells what can be done, and sliders let it be tried: both would answer the question above them.
#[test]
fn a_task_below_a_question_waits_for_the_answer_with_its_sliders() {
    for size in [WIDE, Vec2::new(1000.0, 800.0), PHONE] {
        let mut harness = page(size);
        open(&mut harness, "#v=1&lesson=longitudinal&step=7");
        harness.get_by_label("Heavy at the back");
        let cg = "shift of the centre of gravity Δx_cg/c";
        let sliders = |harness: &Page| harness.query_all_by_role_and_label(Role::Slider, cg).count();
        let tabs = |harness: &Page| harness.query_all_by_role_and_label(Role::Button, "Derivatives").count();
        assert_eq!(count(&harness, "Move the centre of gravity until"), 0, "{size}");
        assert_eq!((sliders(&harness), tabs(&harness)), (0, 0), "{size}");
        click(&mut harness, "It swings faster.");
        click(&mut harness, "Answer");
        assert_eq!(count(&harness, "Move the centre of gravity until"), 1, "{size}");
        if size == PHONE {
            click(&mut harness, "Derivatives");
        }
        assert_eq!(sliders(&harness), 1, "{size}");
    }
}

/// A file as a browser drops it on the page.
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

fn drop_file(harness: &mut Page, name: &'static str, bytes: &[u8]) {
    harness.input_mut().dropped_files.push(Arc::new(Dropped(name, bytes.to_vec())));
    harness.run();
}

/// A lesson that an instructor may have written.
const OWN: &str = r##"+++
title = "Of my own"
+++
## One question
```scene
link = "#v=1&ac=x15"
```
A word of the course: [phugoid](glossary:phugoid).
```predict
kind = "choose"
ask = "Is it fast?"
[[choice]]
says = "Yes"
right = true
[[choice]]
says = "No"
because = "It is."
```
"##;

#[test]
fn a_lesson_that_is_dropped_on_the_page_opens_and_one_with_a_fault_says_where() {
    for size in [WIDE, Vec2::new(1000.0, 800.0), PHONE] {
        let mut harness = page(size);
        drop_file(&mut harness, "own.md", OWN.as_bytes());
        harness.get_by_label_contains("Is it fast?");
        assert_eq!(app(&harness).scenario().aircraft.key, "x15", "its scene is on screen");
        assert!(app(&harness).link().ends_with("&lesson=own.md&step=1"));
        assert!(!app(&harness).link_with_instant().contains("lesson"), "nobody else has this file");
        let faulty = OWN.replace("says = \"No\"", "sais = \"No\"");
        drop_file(&mut harness, "own.md", faulty.as_bytes());
        let told = harness.get_by_label_contains("own.md").accesskit_node().value().unwrap_or_default();
        assert!(told.contains("own.md, line 15: choice.says"), "{told}");
        drop_file(&mut harness, "photo.md", &[0xff, 0xfe, 0x00]);
        assert_eq!(count(&harness, "“photo.md” is no text file"), 1, "{size}");
        drop_file(&mut harness, "numbers.csv", b"1,2");
        assert_eq!(count(&harness, "numbers.csv"), 1, "all else may be an aircraft: {size}");
        click(&mut harness, "Cancel");
        click(&mut harness, "Close the lesson");
        assert_eq!(count(&harness, "is no text file"), 0, "{size}");
    }
}

#[test]
fn a_link_leads_to_a_step_of_a_lesson_with_its_scene_or_with_one_of_its_own() {
    let mut harness = page(WIDE);
    open(&mut harness, "#v=1&lesson=longitudinal&step=4");
    harness.get_by_label(&at_step(4));
    assert!(app(&harness).link().ends_with("&lesson=longitudinal&step=4"), "{}", app(&harness).link());
    open(&mut harness, "#v=1&ac=x15&lesson=longitudinal&step=2");
    harness.get_by_label(&at_step(2));
    assert_eq!(app(&harness).scenario().aircraft.key, "x15", "the link's own scene");
    open(&mut harness, "#v=1&ac=navion&lesson=longitudinal&step=99");
    harness.get_by_label(&at_step(steps()));
    open(&mut harness, "#v=1&ac=navion&lesson=gliding");
    harness.get_by_label_contains("There is no lesson “gliding”.");
}

/// The page as it is loaded again on the same device: its storage and its address.
fn reload(harness: &mut Page, stored: &str) -> Page {
    let link = app(harness).link();
    let mut loaded = page(WIDE);
    loaded.state_mut().as_mut().expect("the page").take_up_records(stored, "");
    open(&mut loaded, &link);
    loaded
}

fn stored(harness: &mut Page) -> String {
    harness.state_mut().as_mut().expect("the page").take_changed_records().expect("something was done")
}

#[test]
fn a_lesson_that_is_open_in_two_tabs_shows_in_each_what_is_done_in_the_other_and_loses_nothing() {
    let (mut one, mut other) = (page(WIDE), page(WIDE));
    for tab in [&mut one, &mut other] {
        open_lesson(tab, "Longitudinal modes");
    }
    click(&mut one, "It swings for minutes.");
    click(&mut one, "Answer");
    let hear = |tab: &mut Page, records: &str| {
        let adds = tab.state_mut().as_mut().expect("the page").take_up_records(records, "");
        tab.run();
        adds
    };
    let records = stored(&mut one);
    assert!(!hear(&mut other, &records), "the other has nothing to tell");
    other.get_by_label("Not so.");
    click(&mut other, "Next →");
    let records = stored(&mut other);
    assert!(!hear(&mut one, &records));
    one.get_by_label(&at_step(1));
    click(&mut one, "Next →");
    click(&mut one, "Skip →");
    let records = stored(&mut one);
    assert!(records.contains(r#""final":true"#) && records.contains(r#""seen":[0,1,2]"#), "{records}");
    // What is answered while a lecture fills the screen of the other tab is there when it is over.
    let mut lecturing = page(WIDE);
    open(&mut lecturing, "#v=1&lesson=longitudinal&present=on");
    hear(&mut lecturing, &records);
    assert_eq!(count(&lecturing, "Not so."), 0, "a lecture has no answers of anybody");
    lecturing.key_press(Key::Escape);
    lecturing.run();
    lecturing.get_by_label("Not so.");
    assert!(stored(&mut lecturing).contains(r#""seen":[0,1,2]"#));
}

#[test]
fn a_reload_in_the_middle_loses_nothing_and_a_report_is_taken_up_elsewhere() {
    let mut harness = page(WIDE);
    harness.state_mut().as_mut().expect("the page").offer_files();
    open_lesson(&mut harness, "Longitudinal modes");
    click(&mut harness, "It swings for minutes.");
    click(&mut harness, "Answer");
    click(&mut harness, "Next →");
    let records = stored(&mut harness);
    let mut loaded = reload(&mut harness, &records);
    loaded.get_by_label(&at_step(2));
    click(&mut loaded, "← Back");
    loaded.get_by_label("Not so.");
    // A lesson that was dropped comes back too, though no link leads to it.
    drop_file(&mut harness, "own.md", OWN.as_bytes());
    click(&mut harness, "Yes");
    click(&mut harness, "Answer");
    let records = stored(&mut harness);
    let loaded = reload(&mut harness, &records);
    loaded.get_by_label("That is right.");
    // The sheet says what is done, and saves a report, which another device takes up.
    click(&mut harness, "Lessons: begin with a question");
    let done = format!("1 of {} steps done", steps());
    assert_eq!(count(&harness, &done), 1);
    click(&mut harness, "Save my report");
    let saved = harness.state_mut().as_mut().expect("the page").take_file_request();
    let Some(FileRequest::Save(report)) = saved else { panic!("{saved:?}") };
    let mut elsewhere = page(PHONE);
    drop_file(&mut elsewhere, "eigenwing-report.html", report.text.as_bytes());
    assert_eq!(count(&elsewhere, &done), 1);
    // Another lesson in a file of the same name begins anew.
    drop_file(&mut harness, "own.md", OWN.replace("Of my own", "Of another").as_bytes());
    assert_eq!(count(&harness, "That is right."), 0);
    drop_file(&mut elsewhere, "photos.html", b"<html>");
    assert_eq!(count(&elsewhere, "“photos.html” is no report of a lesson"), 1);
}

#[test]
fn a_first_visit_is_greeted_once_with_three_ways_to_begin() {
    for (way, then) in [
        ("The course", "Go on without a lesson"),
        ("A riddle", "Close the lesson"),
        ("The workbench", "Pole map"),
    ] {
        for size in [WIDE, PHONE] {
            let mut harness = page(size);
            assert_eq!(count(&harness, "New here? Start with a question."), 0, "only where it was asked for");
            harness.state_mut().as_mut().expect("the page").greet();
            harness.run();
            assert_eq!(count(&harness, "New here? Start with a question."), 1);
            click(&mut harness, way);
            assert!(!app(&harness).greets());
            assert_eq!(count(&harness, "New here? Start with a question."), 0);
            if size == WIDE {
                assert!(count(&harness, then) > 0, "{way}");
            }
        }
    }
}

/// Two steps that hide what they are about: one asks, the other only sets a task.
const RIDDLE: &str = r##"+++
title = "A riddle"
+++
## Which one?
```scene
link = "#v=1&ac=navion&hide=names.numbers.levels.verdicts.reasons"
```
```predict
kind = "choose"
ask = "Which one fades first?"
[[choice]]
says = "The one on the left"
right = true
[[choice]]
says = "The other"
because = "Left is fading."
```
## Without numbers
```scene
link = "#v=1&ac=navion&hide=numbers"
```
```task
goal = "Make it swing twice as fast."
solution = "#v=1&ac=navion&cm_alpha=-2.5"
[[until]]
measure = "short_period.imaginary_part"
at_least = "2 × start"
```
"##;

#[test]
fn what_a_step_hides_is_shown_once_its_questions_are_answered() {
    for size in [WIDE, Vec2::new(1000.0, 800.0), PHONE] {
        let mut harness = page(size);
        drop_file(&mut harness, "riddle.md", RIDDLE.as_bytes());
        assert_eq!(count(&harness, "Phugoid"), 0, "{size}");
        assert!(count(&harness, "Mode 2") > 0, "{size}");
        click(&mut harness, "The other");
        assert_eq!(count(&harness, "Phugoid"), 0, "not before it is given: {size}");
        click(&mut harness, "Answer");
        assert!(count(&harness, "Phugoid") > 0, "{size}");
        assert!(count(&harness, " · T 29.5 s") > 0, "{size}");
        assert_eq!(count(&harness, "Mode 2"), 0, "{size}");
        // A step without a question keeps to itself what it hides, the way to its goal too.
        click(&mut harness, "Next →");
        assert_eq!(count(&harness, " · T 29.5 s"), 0, "{size}");
        assert!(count(&harness, "Phugoid") > 0, "{size}");
        assert_eq!(count(&harness, "2.6 rad/s, wanted"), 0, "{size}");
        assert_eq!(count(&harness, "wanted at least"), 1, "{size}");
        click(&mut harness, "← Back");
        assert!(count(&harness, " · T 29.5 s") > 0, "answered before: {size}");
    }
}

#[test]
fn the_report_has_the_scene_that_reached_the_goal_and_not_the_try_before_it() {
    let goal = r##"+++
title = "A goal"
+++
## Stiffer
```scene
link = "#v=1&ac=navion"
```
```task
goal = "Stiffen it."
offer = ["cm_alpha"]
solution = "#v=1&ac=navion&cm_alpha=-2"
[[until]]
measure = "short_period.imaginary_part"
at_least = "1.5 × start"
```
"##;
    let mut harness = page(WIDE);
    for size in [PHONE, WIDE] {
        harness = page(size);
        drop_file(&mut harness, "goal.md", goal.as_bytes());
        let has_tabs = harness.query_by_label("Derivatives").is_some();
        if has_tabs {
            // The task is out of sight while its slider is moved.
            click(&mut harness, "Derivatives");
        }
        for value in ["-0.8", "-2"] {
            type_into(&mut harness, "pitch stiffness C_mα, typed", value);
        }
        assert_eq!(
            count(&harness, "Done: the goal of this step is reached"),
            usize::from(has_tabs),
            "{size}"
        );
        type_into(&mut harness, "pitch stiffness C_mα, typed", "-0.9");
        let records = Records::read(&stored(&mut harness)).expect("records");
        let record = &records.lessons["goal.md"];
        let place = Place { step: 0, part: 0 };
        assert!(record.answers.get(place).is_some_and(|given| given.reached), "{size}");
        assert!(record.scenes[&place].contains("cm_alpha=-2"), "{size}: {:?}", record.scenes);
    }
    // Nobody is greeted who has begun.
    harness.state_mut().as_mut().expect("the page").greet();
    harness.run();
    assert_eq!(count(&harness, "New here?"), 0);
}
