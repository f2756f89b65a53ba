//! The lessons that ship, proved one by one, and a sentence for each promise that a lesson can break.

use std::path::Path;
use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::lesson::{Kind, Lesson, Shelf};

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn text(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    std::fs::read_to_string(path).expect("a file of the repository")
}

fn shelf() -> Shelf {
    Shelf::read(&text("assets/lessons/glossary.toml"), &text("assets/lessons/references.toml"))
        .expect("both hold")
}

fn faults(file: &str, text: &str) -> Vec<String> {
    match Lesson::read(file, text) {
        Ok(lesson) => lesson.check(&aircraft(), &shelf()).iter().map(ToString::to_string).collect(),
        Err(error) => vec![error.to_string()],
    }
}

#[test]
fn every_lesson_holds_what_it_promises() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let entries = std::fs::read_dir(folder).expect("the lessons");
    let names = entries.map(|entry| entry.expect("a file").file_name().to_string_lossy().into_owned());
    let lessons: Vec<String> = names.filter(|name| name.ends_with(".md")).collect();
    assert!(lessons.len() >= 2, "{lessons:?}");
    let faults: Vec<String> =
        lessons.iter().flat_map(|name| faults(name, &text(&format!("assets/lessons/{name}")))).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

/// What a projector has room for: a short title, one or two panes, one question with at most four short answers, two sentences.
#[test]
fn a_supplied_lecture_takes_45_minutes_and_each_slide_asks_one_question_in_large_type() {
    for file in ["lecture-modes.md", "lecture-matrix.md"] {
        let lesson = Lesson::read(file, &text(&format!("assets/lessons/{file}"))).expect("it holds");
        assert!(lesson.lecture && lesson.minutes() == Some(45.0), "{file}: {:?}", lesson.minutes());
        for step in &lesson.steps {
            let title = &step.title;
            let panes = step.scene.open(&aircraft()).expect("a scene").view.stage.parts().len();
            let room = title.chars().count() <= 45 && (1..=2).contains(&panes);
            assert!(room && step.notes().count() == 1, "{file}, {title}: {panes} panes");
            let [question] = &step.predictions().collect::<Vec<_>>()[..] else {
                panic!("{file}, {title}: expected one question")
            };
            if let Kind::Choose { choices, .. } = &question.kind {
                let are_short = choices.iter().all(|choice| choice.says.plain().chars().count() <= 60);
                assert!((3..=4).contains(&choices.len()) && are_short, "{file}, {title}: {choices:?}");
            }
        }
    }
}

/// A lesson that holds, into which mistakes are put.
const GOOD: &str = r##"+++
title = "Good"
references = ["teper"]
+++
## One
```scene
link = "#v=1&ac=navion"
```
The [phugoid](glossary:phugoid) takes `= phugoid.period`, not [24 s](source:teper).
```predict
kind = "choose"
ask = "Which way?"
[[choice]]
says = "Up"
because = "It goes down."
[[choice]]
says = "Sideways"
because = "It stays in its plane."
[[choice]]
says = "Down"
right = true
```
```task
goal = "Stiffen it"
offer = ["cm_alpha"]
solution = "#v=1&ac=navion&cm_alpha=-2"
[[until]]
measure = "short_period.imaginary_part"
at_least = "1.5 × start"
```
"##;

/// Each broken promise: what is replaced, by what, and the sentences.
#[test]
fn each_broken_promise_has_its_sentence() {
    assert_eq!(faults("good.md", GOOD), [""; 0]);
    let mut others = Vec::new();
    for (right, wrong, sentence) in [
        (
            "ac=navion\"",
            "ac=navion&cm_alfa=1\"",
            "good.md, line 7: the link doesn’t open as it says: “cm_alfa” means nothing to this version and was left out.",
        ),
        (
            "link = \"#v=1&ac=navion\"",
            "link = \"#v=1&ac=lesson\"",
            "good.md, line 23: the aircraft of this scene has no cm_alpha, which is offered\n\
             good.md, line 26: the solution is of another aircraft than the start",
        ),
        ("1.5 × start", "start", "good.md, line 23: the goal is met before anything is done"),
        (
            "cm_alpha=-2",
            "cm_alpha=-0.7",
            "good.md, line 28: the solution doesn’t meet this: short_period.imaginary_part is 2.63\u{a0}rad/s",
        ),
        (
            "solution = \"#v=1&ac=navion&cm_alpha=-2\"\n",
            "",
            "good.md, line 23: solution: missing; expected a link to a scene that meets the goal",
        ),
        ("&cm_alpha=-2", "&cm_alpha=-2&cm_q=-5", "good.md, line 26: the solution changes cm_q, not offered"),
        ("offer = [\"cm_alpha\"]", "offer = [\"cm_alpha\"]\nchanges_at_most = 1", ""),
        (
            "says = \"Up\"",
            "says = \"Up\"\nright = true",
            "good.md, line 10: expected one right choice, found 2; where more are right, say several = true",
        ),
        (
            "right = true",
            "because = \"No.\"",
            "good.md, line 10: expected one right choice, found 0; where more are right, say several = true",
        ),
        (
            "because = \"It goes down.\"\n",
            "",
            "good.md, line 14: a wrong choice has a reason of its own; expected because",
        ),
        (
            "It stays in its plane.",
            "It goes down.",
            "good.md, line 17: another choice has the same reason; expected one of its own",
        ),
        (
            "= phugoid.period",
            "= phugoid.time_to_double",
            "good.md, line 9: `= phugoid.time_to_double` has no value at this scene: the phugoid doesn’t grow",
        ),
        (
            "glossary:phugoid",
            "glossary:fugoid",
            "good.md, line 9: there is no word of the glossary \"fugoid\"; did you mean \"phugoid\"?",
        ),
        (
            "source:teper",
            "source:tepper",
            "good.md, line 9: there is no reference \"tepper\"; did you mean \"teper\"?",
        ),
        (
            "[24 s](source:teper)",
            "24 s",
            "good.md, line 9: “24 s” is typed: expected a number that is measured, `= KEY`, or one quoted, [24 s](source:KEY)",
        ),
        (
            "```predict",
            "```predict\nkind = \"place\"\nask = \"?\"\nmode = \"phugoid\"\nwrong_side = \"a\"\nfar = \"b\"\n```\n```predict",
            "good.md, line 10: the pole is on screen: expected a scene whose stage is without poles, or after, a scene to which it goes",
        ),
        (
            "```predict",
            "```predict\nkind = \"sketch\"\nask = \"?\"\noutput = \"q\"\nfirst = \"a\"\noscillates = \"b\"\nends = \"c\"\n```\n```predict",
            "good.md, line 10: the curve is on screen: expected a scene with hide=curves, or after, a scene that has it",
        ),
        (
            "```predict",
            "```reveal\nDown.\n```\n```predict",
            "good.md, line 5: a reveal has a question before it; expected ```predict",
        ),
    ] {
        assert!(GOOD.contains(right), "{right}");
        let found = faults("good.md", &GOOD.replacen(right, wrong, 1)).join("\n");
        if found != sentence {
            others.push((found, sentence));
        }
    }
    assert!(others.is_empty(), "{others:#?}");
}

#[test]
fn the_example_of_the_documentation_holds() {
    let documentation = text("docs/LESSONS.md");
    let example = documentation.split("````").nth(1).expect("an example").strip_prefix("markdown\n");
    assert_eq!(faults("example.md", example.expect("it is Markdown")), [""; 0]);
}
