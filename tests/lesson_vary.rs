//! Varied numbers: each person starts from numbers of their own, and everything in their lesson follows from these.

use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::findings::Findings;
use eigenwing::lesson::{Lesson, Part, Shelf, Step, Truth};
use eigenwing::scenario::Parameter;
use proptest::prelude::*;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

/// Two steps of varied numbers, and one without any.
const LESSON: &str = r##"+++
title = "Of one's own"
+++
## A question
```scene
link = "#v=1&ac=navion&cg=5"
vary = { cm_alpha = [-0.9, -0.5], speed = [45, 60] }
```
It swings with `= short_period.imaginary_part`; at 70 m/s, [as here](#v=1&ac=navion&cg=5&speed=70),
with `= short_period.imaginary_part at #v=1&ac=navion&cg=5&speed=70`.
```predict
kind = "estimate"
ask = "How long does it take?"
measure = "short_period.period"
after = "#v=1&ac=navion&cg=0"
tries = 2
points = 2
wrong_way = "It is positive."
far = "Think again."
```
## A task
```task
goal = "Make it stiffer."
offer = ["cm_alpha", "cm_q", "cg"]
points = 3
unaided = true
solution = "#v=1&ac=navion&cg=-10"
[[until]]
measure = "short_period.imaginary_part"
at_least = "1.2 × start"
[[until]]
measure = "short_period.period"
at_most = 30
```
## The same for all
```scene
link = "#v=1&ac=x15"
```
Fast.
"##;

fn lesson() -> Lesson {
    Lesson::read("own.md", LESSON).expect("a lesson")
}

fn start(step: &Step) -> Findings {
    Findings::of(step.scene.open(&aircraft()).expect("an aircraft").scenario)
}

fn value(findings: &Findings, key: &str) -> f64 {
    Parameter::find(key).expect("a row").get(findings.scenario())
}

#[test]
fn everything_in_a_step_follows_from_the_persons_own_numbers() {
    let own = lesson().of_person("Ada Lovelace");
    let ada = start(&own.steps[0]);
    let stiffness = value(&ada, "cm_alpha");
    assert!((-0.9..=-0.5).contains(&stiffness) && stiffness != -0.683, "{stiffness}");
    assert_eq!(value(&ada, "cg"), 0.05, "what isn't varied stays");
    // The same however it is typed, another for another person, and the same in the step that keeps the scene.
    let again = lesson().of_person("  ada lovelace ");
    assert_eq!(own, again);
    assert_ne!(own.steps[0].scene, lesson().of_person("Bob").steps[0].scene);
    assert_eq!(own.steps[0].scene, own.steps[1].scene);
    assert_eq!(own.steps[2], lesson().steps[2]);
    // The scene after the question has the stiffness, and its own centre of gravity.
    let Some(Part::Prediction(question)) =
        own.steps[0].parts.iter().find(|part| matches!(part, Part::Prediction(_)))
    else {
        panic!("a question")
    };
    let after = question.after.as_ref().and_then(|scene| scene.open(&aircraft())).expect("it opens");
    assert_eq!(Parameter::find("cm_alpha").expect("a row").get(&after.scenario), stiffness);
    let Some(Truth::Number { found, .. }) = question.truth(&ada, &aircraft()) else { panic!("a number") };
    let first = &lesson().steps[0];
    let unvaried = first.predictions().next().expect("it").truth(&start(first), &aircraft());
    assert!(matches!(unvaried, Some(Truth::Number { found: other, .. }) if other != found));
    // The numbers of the text: those at another scene say their own speed.
    let text: String = own.steps[0].texts()[0].plain_at(&ada, &aircraft());
    let faster = format!("cg=5&speed=70&cm_alpha={stiffness}");
    assert!(format!("{:?}", own.steps[0].parts[0]).matches(&faster).count() == 2, "{text}");
    // The goal counts from the start of one's own.
    let task = own.steps[1].tasks().next().expect("a task");
    let solved = task.solution.as_ref().and_then(|scene| scene.open(&aircraft())).expect("it opens");
    assert!(task.is_met(&ada, &Findings::of(solved.scenario), &aircraft()));
    assert!(!task.is_met(&ada, &ada, &aircraft()));
}

fn faults(text: &str) -> Vec<String> {
    let lesson = Lesson::read("own.md", text).expect("a lesson");
    lesson.check(&aircraft(), &Shelf::default()).iter().map(ToString::to_string).collect()
}

#[test]
fn a_lesson_is_proved_with_the_numbers_at_the_ends_and_between() {
    let good = LESSON.replace("at 70 m/s, ", "");
    assert_eq!(faults(&good), [""; 0]);
    for (right, wrong, sentence) in [
        // At the start of the file the stiffness is −0.683: it is met only from weaker ones.
        (
            "at_least = \"1.2 × start\"",
            "at_least = 2.4",
            "own.md, line 22: with cm_alpha=-0.9, speed=60: the goal is met",
        ),
        (
            "solution = \"#v=1&ac=navion&cg=-10\"",
            "solution = \"#v=1&ac=navion&cg=5&cm_alpha=-0.85\"",
            "own.md, line 29: with cm_alpha=-0.9, speed=45: the solution doesn’t meet this: short_period.imaginary_part is",
        ),
        (
            "speed = [45, 60]",
            "speed = [10, 60]",
            "own.md, line 9: with cm_alpha=-0.9, speed=10: `= short_period.imaginary_part` has no value",
        ),
    ] {
        assert!(good.contains(right), "{right}");
        let found = faults(&good.replacen(right, wrong, 1));
        assert!(found.iter().any(|found| found.starts_with(sentence)), "{found:#?}");
    }
}

proptest! {
    #[test]
    fn anybody_has_numbers_between_the_ends(person in "\\PC{0,40}") {
        let own = lesson().of_person(&person);
        let start = start(&own.steps[0]);
        prop_assert!((-0.9..=-0.5).contains(&value(&start, "cm_alpha")));
        prop_assert!((45.0..=60.0).contains(&value(&start, "speed")));
        prop_assert!(own.steps[0].scene.open(&aircraft()).is_some_and(|opened| opened.notices.is_empty()));
    }
}
