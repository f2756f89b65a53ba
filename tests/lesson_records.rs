//! What a person has done in their lessons: kept, written into a report, read from it again, and nothing lost on the way.

use std::sync::Arc;

use eigenwing::content::{Aircraft, TextFile, embedded_aircraft};
use eigenwing::export::ReportSource;
use eigenwing::lesson::{Answer, Course, Given, Place, Record, Records};
use proptest::prelude::*;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

/// A lesson with a question, a task and something to write.
const LESSON: &str = r##"+++
title = "Of <my> own"
+++
## One
```scene
link = "#v=1&ac=navion"
```
```predict
kind = "estimate"
ask = "How long does the phugoid take?"
measure = "phugoid.period"
wrong_way = "It is positive."
far = "Think of √2 π V/g."
```
## Two
```task
goal = "Stiffen it"
offer = ["cm_alpha"]
hints = ["More negative."]
solution = "#v=1&ac=navion&cm_alpha=-2"
[[until]]
measure = "short_period.imaginary_part"
at_least = "1.5 × start"
```
```write
ask = "Say it in two sentences."
```
"##;

fn files() -> Vec<TextFile> {
    vec![TextFile::new("own.md", LESSON)]
}

fn record() -> Record {
    let mut record = Record { title: "Of <my> own".to_owned(), step: 1, files: files(), ..Record::default() };
    record.seen.extend([0, 1]);
    record.answers.at(Place { step: 0, part: 0 }).answer(Answer::Number(28.0));
    *record.answers.at(Place { step: 1, part: 0 }) = Given { hints: 1, reached: true, ..Given::default() };
    record.answers.at(Place { step: 1, part: 1 }).answer = Some(Answer::Text("</script> & more".to_owned()));
    record.scenes.insert(Place { step: 1, part: 0 }, "v=1&ac=navion&cm_alpha=-2".to_owned());
    record
}

fn records() -> Records {
    let mut records = Records { person: "Ada <L>".to_owned(), ..Records::default() };
    records.lessons.insert("own.md".to_owned(), record());
    records
}

#[test]
fn a_report_is_one_page_that_says_what_happened_and_carries_its_records() {
    let (course, aircraft) = (Course::default(), aircraft());
    let source = ReportSource { course: &course, aircraft: &aircraft, address: "https://page.example/" };
    let report = records().report(source);
    for said in [
        "Ada &lt;L&gt;",
        "Of &lt;my&gt; own",
        "2 of 2 steps done",
        "My answer: 28.0",
        // The published period of the Navion's phugoid is 29.5 s or so; 28 is within a tenth of it.
        "The model: 29.5",
        "Within 10 %.",
        "Reached.",
        "Hints: 1 of 1.",
        "&lt;/script&gt; &amp; more",
        "https://page.example/#v=1&amp;ac=navion&amp;cm_alpha=-2",
        "imaginary part of the short period",
    ] {
        assert!(report.contains(said), "{said} is not in {report}");
    }
    // Nothing is loaded from elsewhere, and the only script is data.
    for outside in ["src=", "@import", "url(", "<link"] {
        assert!(!report.contains(outside), "{outside}");
    }
    assert_eq!(report.matches("<script").count(), 1);
    assert_eq!(Records::read(&report).expect("its own"), records());
}

#[test]
fn a_report_of_homework_tells_its_points_and_how_often_it_was_begun_again() {
    let (course, aircraft) = (Course::default(), aircraft());
    let source = ReportSource { course: &course, aircraft: &aircraft, address: "" };
    let mut records = records();
    assert!(!records.report(source).contains("point"), "a lesson without points says nothing of them");
    let record = records.lessons.get_mut("own.md").expect("it is here");
    record.files[0].text = LESSON.replacen("ask = ", "points = 2\nask = ", 1);
    let report = records.report(source);
    for said in ["2 of 2 steps done, 3 of 3 points", "Within 10 %. 2 of 2 points.", "1 of 1 point."] {
        assert!(report.replace("</span>", "").contains(said), "{said} is not in {report}");
    }
    assert!(!report.contains("begun again"));
    let record = records.lessons.get_mut("own.md").expect("it is here");
    record.answers.at(Place { step: 0, part: 0 }).answer(Answer::Number(60.0));
    record.begun_again = 2;
    assert!(records.report(source).contains("1 of 3 points; begun again 2 times"));
    let again = records.lessons["own.md"].begun_again();
    assert_eq!((again.begun_again, again.answers.iter().count(), again.scenes.len()), (3, 0, 0));
    assert_eq!(again.files, records.lessons["own.md"].files, "its file stays");
}

#[test]
fn a_report_taken_up_elsewhere_adds_what_is_missing_and_loses_nothing() {
    let place = Place { step: 0, part: 0 };
    let mut here = records();
    here.lessons.get_mut("own.md").expect("it is here").answers.at(place).answer(Answer::Number(60.0));
    let mut there = records();
    there.person = "Somebody else".to_owned();
    there.lessons.insert("longitudinal".to_owned(), Record::default());
    here.complete(there);
    assert_eq!(here.person, "Ada <L>");
    assert!(here.lessons.contains_key("longitudinal"));
    let answer = here.lessons["own.md"].answers.get(place).and_then(Given::final_answer);
    assert_eq!(answer, Some(&Answer::Number(60.0)), "what is here stays");
}

#[test]
fn a_name_that_was_changed_on_one_page_is_changed_on_the_other_and_stays() {
    let named = |person: &str| Records { person: person.to_owned(), ..records() };
    for (here, stored, known, name) in [
        ("Ada", "Ada", "Ada", "Ada"),
        ("Ada", "Bea", "Ada", "Bea"),
        ("Bea", "Ada", "Ada", "Bea"),
        ("", "Ada", "Ada", ""),
        ("Ada", "", "Ada", ""),
        ("", "Ada", "", "Ada"),
        ("Bea", "Cy", "Ada", "Bea"),
    ] {
        let mut joined = named(here);
        joined.join(named(stored), &named(known));
        assert_eq!(joined.person, name, "{here}, {stored}, {known}");
        assert_eq!(joined.adds_to(&named(stored)), name != stored, "{here}, {stored}, {known}");
    }
}

/// The records of one lesson after something was done in it.
fn after(records: &Records, doing: impl FnOnce(&mut Record)) -> Records {
    let mut records = records.clone();
    doing(records.lessons.get_mut("own.md").expect("it is here"));
    records
}

#[test]
fn what_is_done_in_the_same_lesson_on_two_pages_is_joined_whichever_stores_it_first() {
    let (question, task) = (Place { step: 0, part: 0 }, Place { step: 1, part: 0 });
    let mut begun = Record { title: "Of <my> own".to_owned(), seen: [0].into(), ..Record::default() };
    begun.answers.at(question).answer = Some(Answer::Number(10.0));
    let both = Records { lessons: [("own.md".to_owned(), begun)].into(), ..Records::default() };
    let one = after(&both, |record| record.answers.at(question).answer(Answer::Number(28.0)));
    let other = after(&both, |record| {
        record.seen.insert(1);
        *record.answers.at(task) = Given { hints: 1, tries: 3, reached: true, ..Given::default() };
        record.scenes.insert(task, "v=1&ac=navion&cm_alpha=-2".to_owned());
    });
    assert!(one.adds_to(&other) && other.adds_to(&one), "each has something that the other hasn't");
    for (first, second) in [(&one, &other), (&other, &one)] {
        let mut joined = first.clone();
        joined.join(second.clone(), &Records::default());
        let record = &joined.lessons["own.md"];
        let given = record.answers.get(question).and_then(Given::final_answer);
        assert_eq!(given, Some(&Answer::Number(28.0)), "the answer that is final");
        let reached = Given { hints: 1, tries: 3, reached: true, ..Given::default() };
        assert_eq!(record.answers.get(task), Some(&reached));
        assert_eq!((record.seen.len(), record.scenes.len()), (2, 1));
        // Then each is told of the other, and it is over.
        assert!(!first.adds_to(&joined) && !second.adds_to(&joined));
    }
}

#[test]
fn of_two_pages_that_answer_otherwise_each_keeps_its_own_and_neither_writes_over_the_other_again() {
    let place = Place { step: 0, part: 0 };
    let answered =
        |number| after(&records(), |record| record.answers.at(place).answer(Answer::Number(number)));
    let (one, other) = (answered(28.0), answered(60.0));
    assert!(!one.adds_to(&other) && !other.adds_to(&one));
    let wrong = |times| {
        let earlier = vec![Answer::Number(1.0); times];
        after(&records(), |record| {
            *record.answers.at(place) =
                Given { earlier, answer: Some(Answer::Number(2.0)), ..Given::default() };
        })
    };
    let mut joined = wrong(1);
    joined.join(wrong(2), &Records::default());
    let given = joined.lessons["own.md"].answers.get(place).expect("given").clone();
    assert_eq!(given.earlier.len(), 2, "answers that were wrong count on every page");
}

#[test]
fn a_lesson_begun_again_on_one_page_is_begun_again_on_the_other() {
    let again = after(&records(), |record| *record = record.begun_again());
    for (first, second) in [(again.clone(), records()), (records(), again.clone())] {
        let mut joined = first;
        joined.join(second, &Records::default());
        let record = &joined.lessons["own.md"];
        assert_eq!((record.begun_again, record.answers.is_empty(), record.scenes.len()), (1, true, 0));
    }
    // Another lesson in a file of the same name has nothing to do with this one.
    let other = after(&again, |record| record.title = "Another".to_owned());
    let mut joined = records();
    joined.join(other.clone(), &Records::default());
    assert_eq!(joined, records());
    assert!(!records().adds_to(&other), "and isn't written over it");
}

#[test]
fn a_goal_that_was_reached_without_its_solution_stays_so() {
    let task = Place { step: 1, part: 0 };
    let given = |reached, solution_shown| {
        let given = Given { reached, solution_shown, ..Given::default() };
        after(&records(), |record| *record.answers.at(task) = given)
    };
    let (unaided, shown) = (given(true, false), given(false, true));
    for (first, second) in [(unaided.clone(), shown.clone()), (shown, unaided)] {
        let mut joined = first;
        joined.join(second, &Records::default());
        assert!(joined.lessons["own.md"].answers.get(task).is_some_and(Given::is_unaided));
    }
}

#[test]
fn a_step_is_done_once_each_question_has_its_answer_and_each_goal_is_reached() {
    let course = Course::read(&files());
    let lesson = course.lessons.first().expect("it is read");
    let mut record = record();
    assert_eq!(record.done(lesson), (2, 2));
    record.answers.at(Place { step: 1, part: 0 }).reached = false;
    assert_eq!(record.done(lesson), (1, 2));
    record.answers.at(Place { step: 0, part: 0 }).is_final = false;
    assert_eq!(record.done(lesson), (0, 2));
}

proptest! {
    #[test]
    fn any_text_is_records_or_an_error(text in ".{0,200}") {
        let _ = Records::read(&text);
    }

    #[test]
    fn a_damaged_report_is_read_or_refused(at in 0_usize..2000, with in any::<char>()) {
        let mut text: Vec<char> = records().to_element().chars().collect();
        let at = at % text.len();
        text[at] = with;
        if let Ok(read) = Records::read(&text.into_iter().collect::<String>()) {
            // Whatever it says can be written into a report again.
            let (course, aircraft) = (Course::default(), Vec::new());
            read.report(ReportSource { course: &course, aircraft: &aircraft, address: "" });
        }
    }
}
