//! Each chapter of the course, from its first step to its last with the keyboard alone.

mod page;

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use eigenwing::content::lessons;
use page::{Page, WIDE, app, open, page};

/// Stops of the Tab key: more than any page has.
const STOPS: usize = 400;

/// Presses Tab until something that `wanted` accepts has the focus; says whether there is such a stop.
fn tab_to(page: &mut Page, modifiers: Modifiers, wanted: impl Fn(&str) -> bool) -> bool {
    for _ in 0..STOPS {
        page.key_press_modifiers(modifiers, Key::Tab);
        page.step();
        let focused = page.query_by(|node| node.is_focused() && node.role() != Role::Window);
        if focused.and_then(|node| node.accesskit_node().label()).is_some_and(|label| wanted(&label)) {
            return true;
        }
    }
    false
}

fn press(page: &mut Page, label: &str) {
    // What comes next in the pane is most often a few stops ahead.
    assert!(tab_to(page, Modifiers::NONE, |found| found == label), "Tab never reaches “{label}”");
    page.key_press(Key::Enter);
    page.run();
}

fn has(page: &Page, label: &str) -> bool {
    page.query_all_by_role_and_label(Role::Button, label).next().is_some()
}

#[test]
fn every_chapter_is_done_with_the_keyboard_alone() {
    let chapters: Vec<&str> = lessons::NAMES.iter().filter_map(|name| name.strip_suffix(".md")).collect();
    assert!(chapters.len() >= 7, "{chapters:?}");
    for chapter in chapters {
        let mut page = page(WIDE);
        open(&mut page, &format!("#v=1&lesson={chapter}"));
        let mut steps = 0;
        loop {
            steps += 1;
            let unanswered =
                |page: &Page| page.query_all_by_role_and_label(Role::Button, "I don’t know").count();
            for left in (0..unanswered(&page)).rev() {
                press(&mut page, "I don’t know");
                assert_eq!(unanswered(&page), left, "{chapter}, step {steps}");
            }
            assert!(!has(&page, "Skip →"), "{chapter}, step {steps}: something is left to be answered");
            if has(&page, "To the lessons") {
                break;
            }
            press(&mut page, "Next →");
            let place = format!("&lesson={chapter}&step={}", steps + 1);
            assert!(app(&page).link().ends_with(&place), "{} is not at {place}", app(&page).link());
        }
        assert!(steps >= 6, "{chapter} has {steps} steps");
    }
}
