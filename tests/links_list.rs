//! A lecture out of a list of links, as a person pastes it.

use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::lesson::{Lesson, LinksList, Shelf};
use proptest::prelude::*;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn read(text: &str) -> LinksList {
    LinksList::read(text, &aircraft()).expect("a list")
}

/// The headings and links of a list, and its minutes.
fn rows(list: &LinksList) -> Vec<(&str, &str, Option<f64>)> {
    list.slides.iter().map(|slide| (slide.title.as_str(), slide.link.as_str(), slide.minutes)).collect()
}

/// The scenes of a lecture of 45 minutes, as an instructor wrote them down.
const TABLE: &str = "\
| min | link | question to the room |
|---|---|---|
| 0 | `#v=1&ac=navion&pane=aircraft` | Which forces balance? Where is +z? |
| 3 | `#v=1&ac=navion&lon.shape=pulse&lon.show=u.alpha.q.theta` | How many motions do you see? |
| 7 | `#v=1&ac=navion&lon.shape=pulse&split=modes&pane=response` | Which state belongs to which? |
| 10 | `#v=1&ac=navion&lon.source=mode&lon.mode=1&details=shape` | What stays constant? |
| 14 | `#v=1&ac=navion&lon.source=mode&lon.mode=3&details=shape&camera=side&rate=4` | Where is it fastest? |
| 18 | `#v=1&ac=navion&cd=0.02&pin.ac=navion&details=approximations` | Cleaner aircraft: better damped? Lanchester +21 %: why? |
| 21 | `#v=1&ac=navion&cg=16&pin.ac=navion` | c.g. aft 16 %: what happens at 15.4 %? |
| 26 | `#v=1&ac=navion&plane=lat&lat.source=aileron&lat.shape=pulse` | three motions, name them |
| 30 | `#v=1&ac=b747-approach&plane=lat&lat.source=mode&lat.mode=1&details=shape&camera=chase` | which wing goes down first? |
| 34 | `#v=1&ac=b747-cruise-etkin&plane=lat&page=matrix&pin.ac=b747-cruise-etkin&add.a_vr=1.719&add.a_pr=0.1146&add.a_rr=-0.4859` | faked yaw damper K=1 |
| 38 | `#v=1&ac=b747-fc8&plane=lat&lat.source=mode&lat.mode=4` | unstable yet certified: why? |
| 40 | `#v=1&ac=navion&plane=lat&croll_beta=-0.3&pin.ac=navion&marks=levels&details=levels` | more dihedral: price? |
| 42 | `#v=1&ac=lesson-printed&pin.ac=lesson` | find the error in the lesson (g in m/s² beside 100 ft/s) |
";

#[test]
fn a_table_of_scenes_with_the_minutes_at_which_they_begin_is_a_lecture() {
    let list = read(TABLE);
    assert_eq!((list.slides.len(), list.minutes(), &list.left_out[..]), (13, Some(42.0), &[][..]));
    assert_eq!(
        rows(&list)[0],
        ("Which forces balance? Where is +z?", "#v=1&ac=navion&pane=aircraft", Some(3.0))
    );
    assert_eq!(list.slides[5].title, "Cleaner aircraft: better damped? Lanchester +21 %: why?");
    assert_eq!(list.slides[12].title, "find the error in the lesson (g in m/s² beside 100 ft/s)");
    assert_eq!(list.slides[12].minutes, None, "nothing says how long the last one takes");
    assert!(list.slides.iter().all(|slide| slide.faults.is_empty()), "{list:#?}");
    let lesson = Lesson::read("lecture.md", &list.to_lesson()).expect("a lesson");
    assert!(lesson.lecture);
    assert_eq!(lesson.check(&aircraft(), &Shelf::default()), []);
    let steps =
        lesson.steps.iter().map(|step| (step.title.as_str(), step.scene.link.as_str(), step.minutes()));
    assert_eq!(steps.collect::<Vec<_>>(), rows(&list));
}

#[test]
fn headings_stand_before_or_behind_their_links_or_in_the_line_above() {
    let scene = "#v=1&ac=navion";
    for (line, title, minutes) in [
        ("The phugoid: https://host.org/page/#v=1&ac=navion", "The phugoid", None),
        ("#v=1&ac=navion The phugoid", "The phugoid", None),
        ("v=1&ac=navion – The phugoid?", "The phugoid?", None),
        ("1. [The phugoid](https://host.org/#v=1&ac=navion) (2.5 min)", "The phugoid", Some(2.5)),
        ("- **The phugoid** <https://host.org/#v=1&ac=navion>.", "The phugoid", None),
        ("12) The phugoid (clean) → “#v=1&ac=navion”", "The phugoid (clean)", None),
        ("The phugoid\t3 min\thttps://host.org/?a=b#v=1&ac=navion", "The phugoid", Some(3.0)),
        ("The phugoid\nhttps://host.org/#v=1&ac=navion", "The phugoid", None),
        ("## The phugoid\n#v=1&ac=navion&lesson=longitudinal&step=2&present=on", "The phugoid", None),
    ] {
        assert_eq!(rows(&read(line)), [(title, scene, minutes)], "{line}");
    }
}

#[test]
fn a_link_alone_is_named_by_its_scene_as_far_as_its_stage_tells() {
    for (link, title) in [
        ("#v=1&ac=navion", "Navion: elevator step"),
        ("#v=1&ac=navion&cm_alpha=-0.5&lon.source=gust", "Navion, another pitch stiffness: vertical gust"),
        ("#v=1&ac=navion&lon.source=mode&lon.mode=2", "Navion: the phugoid alone"),
        (
            "#v=1&ac=navion&lon.source=mode&lon.mode=2&hide=names.aircraft-name",
            "The aircraft: one mode alone",
        ),
    ] {
        let list = read(link);
        assert!(list.slides[0].title.ends_with(title.split(": ").last().expect("words")), "{list:?}");
        assert_eq!(list.slides[0].title, title);
    }
}

#[test]
fn what_cannot_be_used_is_said_of_each_link_and_other_lines_are_kept() {
    let list = read(
        "Lecture 3\n\n#v=1&ac=navion\nAsk them *first*, 1 < 2.\n1. Then wait.\n\n\
         Next\n#v=1&ac=navion&cm_alfa=1\nhttps://host.org/\n#v=1&lesson=hangar\n",
    );
    assert_eq!(list.title, "Lecture 3");
    assert_eq!(list.slides[0].notes, ["Ask them *first*, 1 < 2.", "Then wait."]);
    assert_eq!(list.slides[1].title, "Next");
    assert_eq!(list.slides[1].faults, ["“cm_alfa” means nothing to this version and was left out."]);
    assert_eq!(list.slides[1].notes, ["https://host.org/"], "an address without a scene is kept");
    assert_eq!(list.left_out, ["Line 10: the link leads to a lesson, not to a scene"]);
    let lesson = Lesson::read("lecture.md", &list.to_lesson()).expect("a lesson");
    let notes = lesson.steps[0].notes().next().expect("notes");
    let spans: Vec<String> = notes.text.blocks.iter().map(|block| format!("{block:?}")).collect();
    assert_eq!(notes.text.plain(), "Ask them *first*, 1 < 2.Then wait.", "{spans:#?}");
    for (text, sentence) in [
        ("", "There is no link to a scene in it: expected one a line, such as #v=1&ac=navion"),
        (
            "Hello\nhttps://host.org/#top",
            "There is no link to a scene in it: expected one a line, such as #v=1&ac=navion",
        ),
        ("#v=1&lesson=hangar", "Line 1: the link leads to a lesson, not to a scene"),
    ] {
        assert_eq!(LinksList::read(text, &aircraft()), Err(sentence.to_owned()));
    }
}

fn lines() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        Just("#v=1&ac=navion".to_owned()),
        Just("https://host.org/#v=1&ac=x15&cg=3".to_owned()),
        Just("#v=1&lesson=hangar".to_owned()),
        "\\PC{0,8}",
        "[-#*`|\\[\\]()<>$~+=.:\"\\\\ \t0-9a-z]{0,8}",
        Just("\n".to_owned()),
        Just("\r".to_owned()),
        any::<char>().prop_map(String::from),
    ];
    prop::collection::vec(piece, 0..24).prop_map(|pieces| pieces.concat())
}

proptest! {
    /// Whatever is pasted is a lecture that reads back, or one sentence.
    #[test]
    fn any_text_is_a_lecture_or_a_sentence(text in lines()) {
        let aircraft = aircraft();
        match LinksList::read(&text, &aircraft) {
            Err(sentence) => prop_assert!(!sentence.contains('\n') && !sentence.is_empty()),
            Ok(list) => {
                let written = list.to_lesson();
                let lesson = Lesson::read("lecture.md", &written)
                    .map_err(|error| TestCaseError::fail(format!("{error}\n{written}")))?;
                prop_assert_eq!(lesson.steps.len(), list.slides.len(), "{}", written);
                for (step, slide) in lesson.steps.iter().zip(&list.slides) {
                    prop_assert_eq!(&step.scene.link, &slide.link, "{}", &written);
                    prop_assert_eq!(step.minutes(), slide.minutes, "{}", &written);
                    let is_kept = step.title == slide.title
                        || step.title == "Scene"
                        || slide.title.contains(&step.title);
                    prop_assert!(is_kept, "{:?} {:?}", step.title, slide.title);
                }
            }
        }
    }
}
