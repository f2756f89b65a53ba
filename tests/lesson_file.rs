//! The reader of lessons: what a file means, and a sentence for each mistake.

use eigenwing::lesson::{Kind, Lesson, Part, SolutionAfter, Target, What};
use proptest::prelude::*;

const LESSON: &str = r##"+++
title = "Why the nose bobs"
needs = ["frames"]
references = ["nelson"]
+++
## A gust lifts the nose
```scene
link = "#v=1&ac=navion&lon.source=gust"
```
The [short period](glossary:short_period) of the Navion.
It has a period of `= short_period.period`, and `C_mα` matters.

- one
- *two*, as $\dot{q} = M_q q$

```predict
kind = "choose"
ask = "What does the nose do?"
[[choice]]
says = "It rises and stays"
because = "Something pulls it back."
[[choice]]
says = "It swings and settles"
right = true
```
```reveal
It halves every `= short_period.time_to_half`.
```
## Faster
```task
goal = "Make it bob twice as fast"
offer = ["cm_alpha", "cm_q"]
solution_after = 2
hints = ["Which slider is stiffness?"]
solution = "#v=1&ac=navion&cm_alpha=-4"
[[until]]
measure = "short_period.imaginary_part"
at_least = "1.5 × start"
```
```write
ask = "Explain it to a pilot in *two* sentences."
```
"##;

#[test]
fn a_lesson_is_steps_with_text_questions_and_tasks() {
    let lesson = Lesson::read("bob.md", LESSON).expect("a lesson");
    assert_eq!((lesson.key(), lesson.title.as_str()), ("bob", "Why the nose bobs"));
    let [gust, faster] = &lesson.steps[..] else { panic!("two steps") };
    assert_eq!(faster.scene, gust.scene, "a step without a scene keeps that of the step before");
    let [Part::Text(text), Part::Prediction(prediction), Part::Reveal(_)] = &gust.parts[..] else {
        panic!("{:?}", gust.parts)
    };
    assert_eq!(text.blocks.len(), 3);
    let number = text.spans().find_map(|span| match &span.what {
        What::Number(number) => Some((number.measure.key(), number.line)),
        _ => None,
    });
    assert_eq!(number, Some(("short_period.period".to_owned(), 11)));
    let target = text.spans().find_map(|span| span.target.clone());
    assert_eq!(target, Some(Target::Glossary("short_period".to_owned())));
    let formula = text.spans().find_map(|span| match &span.what {
        What::Formula(formula) => Some((formula.in_words(), span.line)),
        _ => None,
    });
    assert_eq!(formula, Some(("q dot equals M sub q times q".to_owned(), 14)));
    let Kind::Choose { choices, several: false } = &prediction.kind else { panic!("a choice") };
    assert_eq!(choices.iter().map(|choice| choice.right).collect::<Vec<_>>(), [false, true]);
    let task = faster.tasks().next().expect("a task");
    assert_eq!((task.offer.len(), task.solution_after), (2, SolutionAfter::Tries(2)));
    let Some(Part::Write(writing)) = faster.parts.last() else { panic!("something to write") };
    assert_eq!((writing.ask.plain().as_str(), writing.line), ("Explain it to a pilot in two sentences.", 40));
}

#[test]
fn a_lecture_has_notes_with_their_minutes() {
    let lecture = LESSON
        .replacen("needs = [\"frames\"]", "lecture = true", 1)
        .replacen("## Faster", "```notes 3 min\nAsk *one of each side*.\n```\n```notes\n```\n## Faster", 1)
        .replacen("```write", "``` notes  1.5 minutes \nWait for `= short_period.period`.\n```\n```write", 1);
    let lecture = Lesson::read("bob.md", &lecture).expect("a lecture");
    assert!(lecture.lecture);
    let minutes: Vec<_> = lecture.steps.iter().map(|step| step.minutes()).collect();
    assert_eq!((minutes, lecture.minutes()), (vec![Some(3.0), Some(1.5)], Some(4.5)));
    let said: Vec<String> =
        lecture.steps.iter().flat_map(|step| step.notes()).map(|notes| notes.text.plain()).collect();
    assert_eq!(said, ["Ask one of each side.", "", "Wait for ."]);
    let lesson = Lesson::read("bob.md", LESSON).expect("a lesson");
    assert_eq!((lesson.lecture, lesson.minutes()), (false, None));
}

/// Each mistake: what is replaced, by what, and the sentence.
#[test]
fn each_mistake_has_its_sentence() {
    let mut others = Vec::new();
    for (right, wrong, sentence) in [
        ("+++\ntitle", "title", "bob.md, line 1: expected front matter, which begins with a line +++"),
        ("\n+++\n##", "\n##", "bob.md, line 1: expected a second line +++, which ends the front matter"),
        ("title = \"Why the nose bobs\"\n", "", "bob.md, line 1: title: missing; expected a text in quotes"),
        (
            "needs",
            "need",
            "bob.md, line 3: need: not a field of this table; expected: title, about, language, needs, references, lecture",
        ),
        (
            "## A gust",
            "# A gust",
            "bob.md, line 6: expected ## for a step; the title of the lesson stands in the front matter",
        ),
        ("## A gust lifts the nose\n", "", "bob.md, line 6: expected a step: ## and its heading"),
        (
            "```scene\nlink = \"#v=1&ac=navion&lon.source=gust\"\n```",
            "",
            "bob.md, line 6: expected a block ```scene in the first step",
        ),
        (
            "## Faster\n",
            "## Faster\n```scene\nlink = \"#\"\n```\n```scene\nlink = \"#\"\n```\n",
            "bob.md, line 33: a step has one scene; expected another step, ##",
        ),
        (
            "```predict",
            "```predikt",
            "bob.md, line 16: there is no block of a lesson \"predikt\"; did you mean \"predict\"?",
        ),
        (
            "kind = \"choose\"",
            "kind = \"chose\"",
            "bob.md, line 17: kind: expected \"choose\" or \"estimate\" or \"place\" or \"sketch\" or \"order\", found \"chose\"",
        ),
        (
            "because",
            "becaus",
            "bob.md, line 21: choice.becaus: not a field of this table; expected: says, right, because",
        ),
        (
            "\\dot{q}",
            "\\dott{q}",
            "bob.md, line 14: formula: there is no command in formulas \"dott\"; did you mean \"dot\"?",
        ),
        ("- one\n", "```math\na\n\\frac{b}\n```\n", "bob.md, line 15: formula: expected a symbol or { and }"),
        ("ask = \"Explain", "as = \"Explain", "bob.md, line 40: ask: missing; expected a text in quotes"),
        (
            "short_period.period",
            "short_perod.period",
            "bob.md, line 11: there is no measure \"short_perod.period\"; did you mean \"short_period.period\"?",
        ),
        (
            "glossary:",
            "glosary:",
            "bob.md, line 10: there is no kind of link \"glosary\"; did you mean \"glossary\"?",
        ),
        ("cm_q", "cmq", "bob.md, line 32: offer: there is no parameter \"cmq\"; did you mean \"cm_q\"?"),
        (
            "at_least",
            "at_lest",
            "bob.md, line 38: until.at_lest: there is no condition \"at_lest\"; did you mean \"at_least\"?",
        ),
        (
            "1.5 × start",
            "more",
            "bob.md, line 38: until.at_least: expected a number, \"start\" or a multiple of it such as \"2 × start\", found \"more\"",
        ),
        (
            "at_least = \"1.5 × start\"",
            "is = \"stabel\"",
            "bob.md, line 38: until.is: there is no verdict \"stabel\"; did you mean \"stable\"?",
        ),
        (
            "at_least = \"1.5 × start\"",
            "within = \"5 % start\"",
            "bob.md, line 38: until.within: expected a share of a number or of the start, such as \"5 % of start\", found \"5 % start\"",
        ),
        (
            "solution_after = 2",
            "solution_after = \"soon\"",
            "bob.md, line 33: solution_after: expected a number of tries or \"never\", found \"soon\"",
        ),
        (
            "```write\n",
            "```notes three minutes\n```\n```write\n",
            "bob.md, line 40: expected minutes, such as ```notes 3 min, found \"three minutes\"",
        ),
        (
            "```write\n",
            "```notes -3 min\n```\n```write\n",
            "bob.md, line 40: expected minutes, such as ```notes 3 min, found \"-3 min\"",
        ),
        (
            "```write\n",
            "```note 3 min\n```\n```write\n",
            "bob.md, line 40: there is no block of a lesson \"note\"; did you mean \"notes\"?",
        ),
        (
            "```write\n",
            "```notes\n![one](a.png)\n```\n```write\n",
            "bob.md, line 41: expected text, found a picture",
        ),
        ("needs", "lecture = 3\nneeds", "bob.md, line 3: lecture: expected true or false, found a number"),
        (
            "gust\"\n```",
            "gust\"\nvary = { cm_alfa = [-0.9, -0.5] }\n```",
            "bob.md, line 9: vary.cm_alfa: there is no parameter \"cm_alfa\"; did you mean \"cm_alpha\"?",
        ),
        (
            "gust\"\n```",
            "gust\"\nvary = { cm_alpha = [-0.5, -0.9] }\n```",
            "bob.md, line 9: vary.cm_alpha: expected the least number and then the greatest, such as [-0.9, -0.5], found [-0.5, -0.9]",
        ),
        (
            "gust\"\n```",
            "gust\"\nvary = { cm_alpha = [-0.5] }\n```",
            "bob.md, line 9: vary.cm_alpha: expected 2 numbers, found 1",
        ),
        (
            "kind = \"choose\"",
            "kind = \"choose\"\ntries = 1.5",
            "bob.md, line 18: tries: expected a whole number, found 1.5",
        ),
        (
            "kind = \"choose\"",
            "kind = \"choose\"\npoints = -1",
            "bob.md, line 18: points: expected a number of points, found -1",
        ),
        (
            "solution_after = 2",
            "unaided = \"yes\"",
            "bob.md, line 33: unaided: expected true or false, found a text",
        ),
        (
            "solution_after = 2",
            "point = 2",
            "bob.md, line 33: point: not a field of this table; expected: goal, offer, changes_at_most, points, unaided, solution_after, hints, solution, until",
        ),
        ("- one", "<b>one</b>", "bob.md, line 13: expected Markdown, found HTML"),
        ("- one", "![one](a.png)", "bob.md, line 13: expected text, found a picture"),
    ] {
        assert!(LESSON.contains(right), "{right}");
        let error = Lesson::read("bob.md", &LESSON.replacen(right, wrong, 1)).expect_err(wrong);
        if error.to_string() != sentence {
            others.push((error.to_string(), sentence));
        }
    }
    assert!(others.is_empty(), "{others:#?}");
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "\\PC*") {
        let _ = Lesson::read("any.md", &text);
        let _ = Lesson::read("any.md", &format!("+++\ntitle = \"t\"\n+++\n## s\n{text}"));
    }

    #[test]
    fn a_lesson_with_other_bytes_in_it_is_read_or_refused(
        at in 0..LESSON.len(), take in 0..40_usize, bytes in prop::collection::vec(any::<u8>(), 0..12)
    ) {
        let mut text = LESSON.as_bytes().to_vec();
        let end = (at + take).min(text.len());
        text.splice(at..end, bytes);
        let _ = Lesson::read("any.md", &String::from_utf8_lossy(&text));
    }
}
