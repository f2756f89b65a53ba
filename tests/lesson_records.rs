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
