//! What is handed in, graded: good, wrong, damaged, forged and foreign, each a line of the table.

use std::sync::Arc;

use eigenwing::content::{Aircraft, embedded_aircraft};
use eigenwing::export::{ClassSource, class_answers};
use eigenwing::lesson::{
    Answer, Given, Grader, Grades, Lesson, Outcome, Place, Record, Records, Submission, Work, links_table,
};
use eigenwing::scenario::{Parameter, Scenario, View, link};
use proptest::prelude::*;

const LESSON: &str = r##"+++
title = "Week 3"
+++
## Asked
```scene
link = "#v=1&ac=navion&hide=curves"
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
```
```predict
kind = "sketch"
ask = "Draw it."
output = "theta"
first = "a"
oscillates = "b"
ends = "c"
```
## Done
```scene
link = "#v=1&ac=navion"
vary = { cm_alpha = [-0.9, -0.5] }
```
```task
goal = "Damp it."
offer = ["cm_q"]
points = 3
unaided = true
hints = ["Which slider?"]
solution = "#v=1&ac=navion&cm_q=-18"
[[until]]
measure = "short_period.damping_ratio"
at_least = "1.1 × start"
```
```write
ask = "Explain it."
```
"##;

fn aircraft() -> Vec<Arc<Aircraft>> {
    embedded_aircraft().0.into_iter().map(Arc::new).collect()
}

fn lesson() -> Lesson {
    Lesson::read("week-3.md", LESSON).expect("a lesson")
}

const CHOICE: Place = Place { step: 0, part: 0 };
const SKETCH: Place = Place { step: 0, part: 1 };
const TASK: Place = Place { step: 1, part: 0 };
const TEXT: Place = Place { step: 1, part: 1 };

/// The varied number of a person.
fn own(person: &str) -> String {
    let link = lesson().of_person(person).steps[1].scene.link.clone();
    link.split("cm_alpha=").nth(1).expect("it is varied").to_owned()
}

/// Somebody who has done all of it well.
fn good(person: &str) -> Records {
    let mut record = Record {
        title: "Week 3".to_owned(),
        version: lesson().version,
        seed: person.to_owned(),
        ..Record::default()
    };
    record.answers.at(CHOICE).answer(Answer::Chosen(vec![1]));
    let sketch = (0..61).map(|at| (f64::from(at) / 9.0).sin() + person.len() as f64 / 100.0).collect();
    record.answers.at(SKETCH).answer(Answer::Sketch(sketch));
    *record.answers.at(TASK) = Given { reached: true, tries: 2, ..Given::default() };
    record.answers.at(TEXT).answer = Some(Answer::Text(format!("{person} says: the tail damps.")));
    record.scenes.insert(TASK, format!("v=1&ac=navion&cm_alpha={}&cm_q=-18", own(person)));
    let mut records = Records { person: person.to_owned(), ..Records::default() };
    records.lessons.insert("class/week-3.md".to_owned(), record);
    records
}

fn handed_in(records: &Records) -> Submission {
    Submission::report("a.html", format!("<html>{}</html>", records.to_element()).as_bytes())
}

fn graded(submissions: &[Submission]) -> Grades {
    let (lesson, aircraft) = (lesson(), aircraft());
    let grader = Grader::new(&lesson, &aircraft);
    grader.finish(submissions.iter().map(|submission| grader.grade(submission)).collect())
}

fn remarks(grades: &Grades, index: usize) -> String {
    grades.grades[index].remarks.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// The only grade, and its remarks.
fn one(submission: Submission) -> (f64, Vec<Outcome>, String) {
    let grades = graded(&[submission]);
    let grade = &grades.grades[0];
    (grade.points, grade.marks.iter().map(|mark| mark.outcome).collect(), remarks(&grades, 0))
}

fn changed(change: impl FnOnce(&mut Record)) -> Submission {
    let mut records = good("Ada");
    change(records.lessons.get_mut("class/week-3.md").expect("it is there"));
    handed_in(&records)
}

#[test]
fn good_work_gets_its_points_and_wrong_work_gets_those_of_what_is_right() {
    let (points, outcomes, said) = one(handed_in(&good("Ada")));
    assert_eq!((outcomes[0], outcomes[2], said.as_str()), (Outcome::Right, Outcome::Right, ""));
    // The sketch is no motion of the Navion after a step of its elevator.
    assert_eq!(outcomes[1], Outcome::Wrong);
    assert_eq!(points, 5.0);
    let hinted = changed(|record| record.answers.at(TASK).hints = 1);
    assert_eq!(one(hinted).0, 2.0, "a hint costs the points of this task");
    let shown = changed(|record| record.answers.at(TASK).solution_shown = true);
    assert_eq!(one(shown).0, 2.0);
    let second = changed(|record| record.answers.at(CHOICE).earlier = vec![Answer::Chosen(vec![0])]);
    let grades = graded(&[second]);
    assert_eq!((grades.grades[0].points, grades.grades[0].marks[0].tries), (5.0, 2));
    let wrong = changed(|record| record.answers.at(CHOICE).answer(Answer::Chosen(vec![0])));
    assert_eq!(one(wrong).0, 3.0);
    let nothing = changed(|record| *record = Record { title: "Week 3".to_owned(), ..Record::default() });
    assert_eq!(one(nothing), (0.0, vec![Outcome::Open; 3], String::new()));
    assert_eq!((grades.points, grades.parts.len()), (6.0, 3));
}

/// Whatever a report says of itself: what is changed, the points that are left, and the sentence.
#[test]
fn a_report_that_was_forged_gets_nothing_for_it_and_one_sentence() {
    let other = own("Bob");
    let scene = |text: &str| {
        let link = text.replace("OWN", &own("Ada")).replace("OTHER", &other);
        changed(|record| drop(record.scenes.insert(TASK, link)))
    };
    let unlike: Vec<(Submission, f64, &str)> = vec![
        (
            scene("v=1&ac=navion&cm_alpha=OWN"),
            2.0,
            "Step 2: said to be reached, but damping ratio of the short period is",
        ),
        (
            scene("v=1&ac=navion&cm_alpha=OWN&cm_q=-18&cg=3"),
            2.0,
            "Step 2: cg differs from the start, which isn’t offered.",
        ),
        (scene("v=1&ac=navion&cm_alpha=OTHER&cm_q=-18"), 2.0, "Step 2: it begins with cm_alpha = "),
        (scene("v=1&ac=x15"), 2.0, "Step 2: It is another aircraft than at the start."),
        (
            scene("v=1&ac=navion&cm_alpha=OWN&cm_q=-18&category=a"),
            2.0,
            "Step 2: Its levels are judged for another class",
        ),
        (scene("nonsense"), 2.0, "Step 2: its link doesn’t open as it says: "),
        (changed(|record| record.scenes.clear()), 2.0, "Step 2: said to be reached, but there is no scene."),
        (
            changed(|record| record.answers.at(CHOICE).is_final = false),
            3.0,
            "1 answer was begun and not given, so it doesn’t count.",
        ),
        (
            changed(|record| record.answers.at(CHOICE).earlier = vec![Answer::Chosen(vec![0]); 7]),
            3.0,
            "Step 1: answered more often than it may be.",
        ),
        (
            changed(|record| record.answers.at(CHOICE).answer(Answer::Chosen(vec![9]))),
            3.0,
            "1 answer doesn’t fit the lesson, so the report was edited.",
        ),
        (
            changed(|record| {
                record.version = "another".to_owned();
                record.answers.at(CHOICE).answer(Answer::Number(1.0));
            }),
            3.0,
            "It was done with another version of the lesson’s file; 1 answer doesn’t fit this one.",
        ),
        (changed(|record| record.seed = "Bob".to_owned()), 2.0, "It was done with the numbers of “Bob”."),
    ];
    for (submission, points, sentence) in unlike {
        let (found, _, said) = one(submission);
        assert!(said.starts_with(sentence), "{sentence}: {said}");
        assert_eq!(found, points, "{sentence}");
    }
    // A goal that is reached counts, whatever the report forgot to say.
    let modest = changed(|record| record.answers.at(TASK).reached = false);
    assert_eq!((one(modest.clone()).0, one(modest).2), (5.0, String::new()));
}

#[test]
fn what_cannot_be_read_is_one_line_with_one_sentence() {
    let report = good("Ada").to_element();
    let broken = &report[..report.len() / 2];
    let foreign = r#"{"person":"Cy","lessons":{"hangar":{"title":"The hangar"}}}"#;
    for (bytes, sentence) in [
        (&b""[..], "The file is empty."),
        (b" \n", "The file is empty."),
        (b"%PDF-1.7 \xff\xfe", "This is no report that the page has saved."),
        (broken.as_bytes(), "What the report carries is damaged: "),
        (foreign.as_bytes(), "It is of another lesson: The hangar."),
        (b"{}", "Nothing was done in it."),
    ] {
        let (points, outcomes, said) = one(Submission::report("b.html", bytes));
        assert!(said.starts_with(sentence), "{said}");
        assert_eq!((points, outcomes.len()), (0.0, 3));
    }
}

#[test]
fn the_same_work_under_two_names_is_told_and_a_second_report_of_one_name() {
    let mut copied = good("Ada");
    copied.person = "Bob".to_owned();
    let grades = graded(&[
        handed_in(&good("Ada")),
        handed_in(&copied),
        handed_in(&good("Cy")),
        handed_in(&good(" ADA")),
    ]);
    let shared = "The same as Bob has: sketch in step 1.";
    assert!(remarks(&grades, 0).contains(shared), "{}", remarks(&grades, 0));
    assert!(remarks(&grades, 1).contains("It was done with the numbers of “Ada”."));
    assert_eq!(remarks(&grades, 2), "");
    assert!(remarks(&grades, 3).contains("Another was handed in before under this name."));
    // Whatever else was changed: one thing of their own is enough.
    let record = copied.lessons.get_mut("class/week-3.md").expect("it is there");
    record.answers.at(CHOICE).answer(Answer::Chosen(vec![0]));
    record.answers.at(SKETCH).earlier = vec![Answer::DontKnow];
    let grades = graded(&[handed_in(&good("Ada")), handed_in(&copied)]);
    assert_eq!(remarks(&grades, 0), shared);
    assert!(remarks(&grades, 1).contains("The same as Ada has: sketch in step 1."));
    // A slider that was dragged is one's own, unless it was dragged to its end.
    let dragged = |person: &str, number: &str| {
        let mut records = good(person);
        let record = records.lessons.get_mut("class/week-3.md").expect("it is there");
        record.answers.at(SKETCH).answer(Answer::DontKnow);
        let link = format!("v=1&ac=navion&cm_alpha={}&cm_q={number}", own(person));
        record.scenes.insert(TASK, link);
        handed_in(&records)
    };
    let aircraft = aircraft();
    let navion = Scenario::new(aircraft.iter().find(|one| one.key == "navion").expect("it ships").clone());
    let end = *Parameter::find("cm_q").expect("a slider").range(&navion).start();
    for (number, said) in [("-17.123456", "The same as Bob has: dragged slider in step 2."), ("-17", "")] {
        let grades = graded(&[dragged("Ada", number), dragged("Bob", number)]);
        assert_eq!(remarks(&grades, 0), said, "{number}");
    }
    // At its end the goal isn't met; that is all that is told.
    let at_end = format!("{end:.12}");
    let grades = graded(&[dragged("Ada", &at_end), dragged("Bob", &at_end)]);
    let said = remarks(&grades, 0);
    assert!(said.starts_with("Step 2: said to be reached") && !said.contains("The same as"), "{said}");
    // Two who have chosen the same are no twins.
    let chosen = |person: &str| {
        let mut records = good(person);
        let record = records.lessons.get_mut("class/week-3.md").expect("it is there");
        record.scenes.clear();
        record.answers = Default::default();
        record.answers.at(CHOICE).answer(Answer::Chosen(vec![1]));
        handed_in(&records)
    };
    let grades = graded(&[chosen("Ada"), chosen("Bob")]);
    assert_eq!([remarks(&grades, 0), remarks(&grades, 1)], ["", ""]);
}

#[test]
fn links_of_a_form_are_graded_whatever_program_wrote_the_table() {
    let link = |person: &str, rest: &str| {
        format!(
            "https://page.example/#v=1&ac=navion&cm_alpha={}{rest}&lesson=class/week-3.md&step=2&by={person}",
            own(person)
        )
    };
    let (ada, bob) = (link("Ada", "&cm_q=-18"), link("Bob", "&cm_q=-18"));
    let google = format!(
        "\u{feff}\"Timestamp\",\"Your name\",\"Link of task 2\"\n\"2026/11/29 5:00:00 PM\",\"Ada\",\"{ada}\"\n\"2026/11/29\",\"Bob\",\"{bob}\"\n"
    );
    let microsoft =
        format!("ID;Start time;Name;Link\r\n1;11/29/26 5:00;Ada;{ada}\r\n2;11/29/26 6:00;Bob;{bob}\r\n");
    let bare = format!("Ada\t{ada}\nBob\t{bob}\n");
    let wide: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(bare.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    for table in [google.as_bytes(), microsoft.as_bytes(), bare.as_bytes(), &wide] {
        let found = links_table("form.csv", table);
        let names: Vec<Option<&str>> = found.iter().map(|one| one.name.as_deref()).collect();
        assert_eq!(names, [Some("Ada"), Some("Bob")], "{}", String::from_utf8_lossy(table));
        let grades = graded(&found);
        assert_eq!(grades.grades.iter().map(|grade| grade.points).collect::<Vec<_>>(), [3.0, 3.0]);
        assert_eq!([remarks(&grades, 0), remarks(&grades, 1)], ["", ""]);
    }
    for (name, link, points, sentence) in [
        ("Cy", ada.clone(), 3.0, "Its link was made by “Ada”."),
        ("Ada", ada.replace(&own("Ada"), &own("Bob")), 0.0, "Step 2: it begins with cm_alpha = "),
        ("Ada", ada.replace("step=2", "step=1"), 0.0, "A link names no step with a task."),
        ("Ada", ada.replace("week-3", "week-4"), 0.0, "A link is of another lesson, “class/week-4.md”."),
        ("Ada", ada.replace("lesson=", "lessen="), 0.0, "A link names no step with a task."),
        ("Ada", format!("{ada}&help=1"), 0.0, ""),
        ("Ada", format!("{ada}&help=solution"), 0.0, ""),
        ("Ada", link("Ada", ""), 0.0, "Step 2: said to be reached, but"),
    ] {
        let grades = graded(&links_table("form.csv", format!("Name,Link\n{name},{link}\n").as_bytes()));
        assert!(remarks(&grades, 0).starts_with(sentence), "{sentence}: {}", remarks(&grades, 0));
        assert_eq!(grades.grades[0].points, points, "{link}");
    }
    let found = links_table("form.csv", format!("Name,Link\nAda,\nAda,{ada}\nBob,nothing yet\n").as_bytes());
    assert!(matches!(&found[0].work, Ok(Work::Links(links)) if links.len() == 1), "{found:?}");
    assert_eq!(found[1].source, "form.csv, line 4");
    for none in [&b""[..], b"a,b\n1,2\n", b"\x00\x01"] {
        assert_eq!(links_table("form.csv", none).len(), 1);
    }
}

/// The grade of a row of a table, and its remarks.
fn row(lesson: &Lesson, name: &str, links: &str) -> (f64, String) {
    let aircraft = aircraft();
    let grader = Grader::new(lesson, &aircraft);
    let table = format!("Name,Links\n{name},\"{links}\"\n");
    let found = links_table("form.csv", table.as_bytes());
    assert_eq!(found.len(), 1, "{found:?}");
    let grades = grader.finish(vec![grader.grade(&found[0])]);
    (grades.grades[0].points, remarks(&grades, 0))
}

/// A lesson with nothing but a task, which everybody has the same numbers of.
fn one_task() -> Lesson {
    let task = LESSON.split("## Done").nth(1).expect("a step").split("```write").next().expect("a task");
    let same = task.lines().filter(|line| !line.starts_with("vary")).collect::<Vec<_>>().join("\n");
    Lesson::read("week-3.md", &format!("+++\ntitle = \"Week 3\"\n+++\n## Done{same}\n")).expect("a lesson")
}

#[test]
fn whose_a_link_is_is_looked_at_in_each_and_by_the_words_of_the_name() {
    let lesson = one_task();
    let link =
        |by: &str| format!("https://page.example/#v=1&ac=navion&cm_q=-18&lesson=week-3.md&step=1&by={by}");
    for (name, by, others) in [
        ("Ada", &["Ada"][..], &[][..]),
        ("Ada", &["Ada", "Bob"], &["Bob"]),
        ("Ada", &["Bob", "Ada", "bob", "Cy"], &["Bob", "Cy"]),
        ("Joanne", &["Ann"], &["Ann"]),
        ("Ann Miller", &["Ann"], &[]),
        ("Miller Ann", &["Ann%20Miller"], &[]),
        ("AnnMiller", &["Ann%20Miller"], &[]),
        ("Ann Miller", &["annmiller"], &[]),
        ("ann.miller@uni.example", &["Ann%20Miller"], &[]),
        ("Ann", &["Anna"], &["Anna"]),
        ("Ada", &["", "Ada"], &[]),
    ] {
        let links: Vec<String> = by.iter().map(|by| link(by)).collect();
        let told: Vec<String> = others.iter().map(|by| format!("Its link was made by “{by}”.")).collect();
        assert_eq!(row(&lesson, name, &links.join(" ")), (3.0, told.join(" ")), "{name}: {by:?}");
    }
}

#[test]
fn a_link_that_does_not_open_as_it_says_is_told_though_its_goal_is_met() {
    let lesson = one_task();
    let link = "https://page.example/#v=1&ac=navion&cm_q=-18&lesson=week-3.md&by=Ada";
    for step in ["x", "0", "99999999999999999999"] {
        let (points, said) = row(&lesson, "Ada", &format!("{link}&step={step}"));
        assert!(said.starts_with("A link doesn’t open as it says: ") && said.contains("step"), "{said}");
        assert_eq!(points, 0.0);
    }
    for rest in ["&help=one", "&cm_alfa=1"] {
        let (points, said) = row(&lesson, "Ada", &format!("{link}&step=1{rest}"));
        assert!(said.starts_with("Step 1: its link doesn’t open as it says: "), "{said}");
        assert_eq!(points, 3.0);
    }
}

/// However a form puts several links into one cell.
#[test]
fn a_hint_counts_whatever_joins_the_links_of_a_cell() {
    let lesson = one_task();
    let link = "https://page.example/a,b/#v=1&ac=navion&cm_q=-18&lesson=week-3.md&step=1&by=Ada&help=1";
    for join in ["; ", ";", ", ", ",", " ", "\n", "|", " and ", ".\n"] {
        assert_eq!(row(&lesson, "Ada", &format!("{link}{join}{link}")), (0.0, String::new()), "{join:?}");
    }
    assert_eq!(row(&lesson, "Ada", &format!("My answer: <{link}>.")), (0.0, String::new()));
}

#[test]
fn of_a_lesson_that_is_in_a_report_twice_what_has_come_further_counts() {
    let mut records = good("Ada");
    let blank = Record { title: "Week 3".to_owned(), version: lesson().version, ..Record::default() };
    for address in ["a/week-3.md", "z/week-3.md", "week-3 (1).md"] {
        records.lessons.insert(address.to_owned(), blank.clone());
    }
    let (points, _, said) = one(handed_in(&records));
    assert_eq!((points, said.as_str()), (5.0, ""));
    let mut begun = blank;
    begun.answers.at(CHOICE).answer(Answer::Chosen(vec![0]));
    records.lessons.insert("a/week-3.md".to_owned(), begun);
    let (points, _, said) = one(handed_in(&records));
    assert_eq!(points, 5.0);
    assert_eq!(said, "The lesson is in it 2 times; what has come furthest is graded.");
}

#[test]
fn another_aircraft_under_the_key_of_the_start_is_another() {
    let lesson = one_task();
    let file = include_str!("../assets/aircraft/navion.toml");
    let link = |text: &str| {
        let mut scene = Scenario::new(Arc::new(Aircraft::own("navion.toml", text).expect("it reads")));
        assert_eq!(scene.aircraft.key, "navion");
        Parameter::find("cm_q").expect("a slider").set(&mut scene, -18.0);
        format!("#{}&lesson=week-3.md&step=1&by=Ada", link::write(&scene, &View::of(&scene), None))
    };
    assert_eq!(row(&lesson, "Ada", &link(file)), (3.0, String::new()), "the same file is the same aircraft");
    for (line, forged) in [("b = 33.4", "b = 30"), ("c = 5.7", "c = 7"), ("class = \"I\"", "class = \"IV\"")]
    {
        assert!(file.contains(line), "{line}");
        let (points, said) = row(&lesson, "Ada", &link(&file.replacen(line, forged, 1)));
        assert_eq!(
            (points, said.as_str()),
            (0.0, "Step 1: It is another aircraft than at the start."),
            "{line}"
        );
    }
}

#[test]
fn the_answers_of_a_class_are_one_page_without_anybodys_name() {
    let (lesson, aircraft) = (lesson(), aircraft());
    let grader = Grader::new(&lesson, &aircraft);
    let mut wrong = good("B<o>b");
    let record = wrong.lessons.get_mut("class/week-3.md").expect("it is there");
    record.answers.at(CHOICE).answer(Answer::Chosen(vec![0]));
    record.answers.at(TEXT).answer = Some(Answer::Text("<b>It</b>".to_owned()));
    let submissions = [handed_in(&good("Ada")), handed_in(&wrong)];
    let grades = grader.finish(submissions.iter().map(|submission| grader.grade(submission)).collect());
    let page =
        |names| class_answers(&ClassSource { grader: &grader, grades: &grades, aircraft: &aircraft, names });
    let anonymous = page(false);
    for said in [
        "Which way?",
        "1 of 2 right in the end",
        "It is heavy.",
        "width:50.0%",
        "reached without help",
        "&lt;b&gt;It&lt;/b&gt;",
    ] {
        assert!(anonymous.contains(said), "{said} is not in {anonymous}");
    }
    assert_eq!(anonymous.matches("class=\"one\" d=").count(), 2, "both sketches");
    assert_eq!(anonymous.matches("class=\"model\" d=").count(), 1);
    // Ada's own words name her, and nothing else does.
    assert_eq!(anonymous.matches("Ada").count(), 1);
    for outside in ["<script", "src=", "@import", "url("] {
        assert!(!anonymous.contains(outside), "{outside}");
    }
    assert!(page(true).contains("B&lt;o&gt;b"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_as_a_report_give_a_line(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let grades = graded(&[Submission::report("a.html", &bytes)]);
        prop_assert_eq!(grades.grades.len(), 1);
        let tables = links_table("a.csv", &bytes);
        prop_assert!(!tables.is_empty());
        graded(&tables);
    }

    #[test]
    fn a_report_with_other_bytes_in_it_gives_a_line(
        at in 0_usize..3000, take in 0_usize..30, bytes in prop::collection::vec(any::<u8>(), 0..12)
    ) {
        let mut report = good("Ada").to_element().into_bytes();
        let at = at % report.len();
        let end = (at + take).min(report.len());
        report.splice(at..end, bytes);
        let grades = graded(&[Submission::report("a.html", &report)]);
        prop_assert_eq!(grades.grades.len(), 1);
        prop_assert!(grades.grades[0].points.is_finite());
    }
}
