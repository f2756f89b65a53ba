//! A lecture made of links, put in order and presented; and what its notes show.

mod page;

use egui::accesskit::Role;
use egui::{Event, Key};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::TextFile;
use eigenwing::lesson::Lesson;
use eigenwing::ui::{App, Cue, FileRequest};
use page::{Page, WIDE, app, open, page};

const LINKS: &str = "Third week\n\nThe phugoid (3 min): https://host.org/#v=1&ac=navion&lon.source=mode&lon.mode=2\n\
                     #v=1&ac=navion&cm_alfa=1 The short period\nAsk first.\n3. [Both](#v=1&ac=navion)\n";

fn state(page: &mut Page) -> &mut App {
    page.state_mut().as_mut().expect("the page has been drawn")
}

fn press(page: &mut Page, name: &str) {
    page.get_by_role_and_label(Role::Button, name).click_accesskit();
    page.run();
}

fn has(page: &Page, words: &str) -> bool {
    page.query_all_by_label_contains(words).next().is_some()
}

/// Titles in the sheet, in order.
fn titles(page: &Page) -> Vec<String> {
    let fields = page.query_all_by_role(Role::TextInput);
    let of_slide = fields.filter(|node| {
        node.accesskit_node().label().is_some_and(|label| label.starts_with("Title of slide"))
    });
    of_slide.filter_map(|node| node.accesskit_node().value()).collect()
}

fn cue(page: &Page) -> Cue {
    app(page).cue().expect("a lecture is on")
}

#[test]
fn links_that_are_pasted_become_a_lecture_that_is_ordered_named_saved_and_presented() {
    let mut page = page(WIDE);
    state(&mut page).offer_files();
    open(&mut page, "v=1&ac=x15");
    press(&mut page, "Lessons: begin with a question");
    press(&mut page, "A lecture from links …");
    page.get_by_role_and_label(Role::MultilineTextInput, "Links, one a line").focus();
    page.run();
    page.input_mut().events.push(Event::Paste(LINKS.to_owned()));
    page.run();
    assert_eq!(titles(&page), ["The phugoid", "The short period", "Both"]);
    assert!(has(&page, "“cm_alfa” means nothing to this version"), "of each link what can't be used");
    assert!(has(&page, "3 slides · 3 min"));
    press(&mut page, "Move up slide 3");
    press(&mut page, "Delete slide 3");
    assert_eq!(titles(&page), ["The phugoid", "Both"]);
    page::type_into(&mut page, "Title of slide 2", " of them");
    press(&mut page, "Save as a lesson file");
    let Some(FileRequest::Save(file)) = state(&mut page).take_file_request() else { panic!("a file") };
    assert_eq!(file.name, "third-week.md");
    let lesson = Lesson::read(&file.name, &file.text).expect("it reads back");
    assert!(lesson.lecture);
    let titles: Vec<&str> = lesson.steps.iter().map(|step| step.title.as_str()).collect();
    assert_eq!(titles, ["The phugoid", "Both of them"]);
    press(&mut page, "Present");
    page.run_steps(4);
    assert!(!has(&page, "A lecture from links"));
    assert_eq!((cue(&page).title.as_str(), cue(&page).slides), ("The phugoid", 2));
    assert_eq!(cue(&page).minutes, Some(3.0));
    page.key_press(Key::PageDown);
    page.run_steps(4);
    assert_eq!(cue(&page).title, "Both of them");
    // Kept on this device, as a lesson of one's own.
    let kept = state(&mut page).take_changed_records().expect("it has changed");
    assert!(kept.contains("third-week.md") && kept.contains("Both of them"), "{kept}");
}

#[test]
fn a_text_file_with_links_opens_the_sheet_and_one_without_says_so() {
    let mut page = page(WIDE);
    state(&mut page).open_files(&[TextFile::new("Lecture.TXT", LINKS)]);
    page.run();
    assert_eq!(titles(&page).len(), 3);
    press(&mut page, "Close");
    state(&mut page).open_files(&[TextFile::new("notes.txt", "# nothing")]);
    page.run();
    assert!(has(&page, "There is no link to a scene in it"));
    assert!(!has(&page, "3 slides"), "what was closed is gone");
}

const LECTURE: &str = r##"+++
title = "Bob"
lecture = true
+++
## First
```scene
link = "#v=1&ac=navion&stage=aircraft"
```
```predict
kind = "choose"
ask = "Up or down?"
[[choice]]
says = "Up"
because = "No."
[[choice]]
says = "Down"
right = true
```
```notes 2 min
Wait for `= phugoid.period`, *then* ask.

1. One <b> side
```
## Second
```notes 5 min
```
```predict
kind = "choose"
ask = "And now?"
[[choice]]
says = "Up"
because = "No."
[[choice]]
says = "Down"
right = true
```
"##;

#[test]
fn the_notes_follow_the_lecture_with_its_hands_and_what_comes_next() {
    let mut lesson = page(WIDE);
    let page = &mut lesson;
    state(page).open_files(&[TextFile::new("bob.md", LECTURE.replace("<b>", "b").as_str())]);
    page.run();
    assert_eq!(app(page).cue(), None, "nothing is presented");
    assert!(!has(page, "then ask"), "in the lesson notes aren't shown");
    page.key_press(Key::F);
    page.run_steps(4);
    let first = cue(page);
    assert_eq!((first.slide, first.slides, first.title.as_str()), (1, 2, "First"));
    assert_eq!((first.minutes, first.until, first.total), (Some(2.0), Some(2.0), Some(7.0)));
    assert!(
        first.notes[0].text.starts_with("Wait for 29.") && first.notes[0].text.ends_with("s, then ask."),
        "{first:?}"
    );
    let item = &first.notes[1];
    assert_eq!(
        (item.kind, item.depth, item.mark.as_str(), item.text.as_str()),
        ("item", 1, "1.", "One b side")
    );
    assert_eq!(first.next.expect("a slide").question.as_deref(), Some("And now?"));
    assert!(!has(page, "then ask"), "the room sees no notes");
    for key in [Key::Num2, Key::Num2, Key::Num1] {
        page.key_press(key);
        page.run_steps(2);
    }
    let counts: Vec<(String, u32, bool)> =
        cue(page).hands.into_iter().map(|hand| (hand.says, hand.count, hand.right)).collect();
    assert_eq!(counts, [("Up".to_owned(), 1, false), ("Down".to_owned(), 2, true)]);
    page.key_press(Key::N);
    page.run_steps(2);
    assert!(state(page).take_notes_wish(), "N asks for the notes");
    page.key_press(Key::PageDown);
    page.run_steps(2);
    assert_eq!(cue(page).revealed, [1, 1]);
    page.key_press(Key::PageDown);
    page.run_steps(4);
    let second = cue(page);
    assert_eq!((second.slide, second.until, second.next), (2, Some(7.0), None));
    state(page).end_lecture();
    page.run_steps(4);
    assert_eq!(app(page).cue(), None);
}
