//! A report of what a person has done in their lessons: one page to read, print or hand in, which carries its records.

use std::sync::Arc;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::content::{Aircraft, LengthUnit};
use crate::findings::Findings;
use crate::lesson::{
    Course, Given, Lesson, Part, Place, Prediction, Record, Records, Step, Task, progress, said,
};
use crate::words;

/// What a report is made with.
#[derive(Clone, Copy, Debug)]
pub struct ReportSource<'a> {
    /// The lessons that ship.
    pub course: &'a Course,
    /// The aircraft that links may name.
    pub aircraft: &'a [Arc<Aircraft>],
    /// Address of the page, before the `#` of a link.
    pub address: &'a str,
}

/// The style of the page: readable on a screen and on paper.
const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem;color:#1b2430}\
h2{border-top:1px solid #ccd3dc;padding-top:1rem}section{break-inside:avoid}table{border-collapse:collapse}\
td,th{border:1px solid #ccd3dc;padding:.2rem .6rem;text-align:left}blockquote{white-space:pre-wrap;border-left:3px solid #ccd3dc;\
margin-left:0;padding-left:1rem}.good{color:#1a6b35}.bad{color:#a3231f}";

impl Records {
    /// The report as one page, without anything outside it.
    pub fn report(&self, source: ReportSource<'_>) -> String {
        let title = "Eigenwing: what I predicted, and what happened";
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width";
                    title { (title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    h1 { (title) }
                    @if !self.person.is_empty() { p { (self.person) } }
                    @for (address, record) in &self.lessons { (lesson(address, record, source)) }
                    (PreEscaped(self.to_element()))
                }
            }
        };
        page.into_string()
    }
}

fn lesson(address: &str, record: &Record, source: ReportSource<'_>) -> Markup {
    let own = Course::read(&record.files);
    let shipped = source.course.find(address).map(|(_, lesson)| lesson);
    let Some(lesson) = shipped.or_else(|| own.lessons.first()) else {
        return html! { h2 { (record.title) } p { "Its file isn’t here, so only its answers are kept below." } };
    };
    let (done, count) = record.done(lesson);
    html! {
        h2 { (lesson.title) }
        p { (done) " of " (count) " steps done" }
        @for (number, of) in lesson.steps.iter().enumerate().filter(|(number, _)| record.seen.contains(number)) {
            (step(number, of, lesson, record, source))
        }
    }
}

fn step(number: usize, step: &Step, lesson: &Lesson, record: &Record, source: ReportSource<'_>) -> Markup {
    let Some(opened) = step.scene.open(source.aircraft) else { return html! {} };
    let start = Findings::of(opened.scenario);
    let mark = if record.is_done(lesson, number) { "✓ " } else { "" };
    html! {
        section {
            h3 { (mark) (number + 1) ". " (step.title) }
            @for (part, what) in step.parts.iter().enumerate() {
                @let place = Place { step: number, part };
                @let given = record.answers.get(place);
                @match (what, given) {
                    (Part::Prediction(of), Some(given)) => (question(of, given, &start, source)),
                    (Part::Task(of), given) => (task(of, given, &start, record.scenes.get(&place), source)),
                    (Part::Write(of), Some(given)) => {
                        p { (of.ask.plain_at(&start, source.aircraft)) }
                        @if let Some(crate::lesson::Answer::Text(text)) = &given.answer { blockquote { (text) } }
                    }
                    (Part::Text(_) | Part::Reveal(_) | Part::Prediction(_) | Part::Write(_), _) => {}
                }
            }
        }
    }
}

fn question(of: &Prediction, given: &Given, start: &Findings, source: ReportSource<'_>) -> Markup {
    let Some(answer) = given.final_answer() else { return html! {} };
    let length = start.scenario().aircraft.length_unit;
    let truth = of.truth(start, source.aircraft);
    html! {
        p { strong { (of.ask.plain_at(start, source.aircraft)) } }
        p { "My answer: " (said::answer(of, answer, length)) }
        @if let Some(truth) = truth {
            @let compared = truth.compare(&of.kind, answer);
            @let class = if compared.is_right() { "good" } else { "bad" };
            p { "The model: " (said::truth(of, &truth, length)) ". "
                span class=(class) { (compared.says()) } }
        }
    }
}

fn task(
    of: &Task,
    given: Option<&Given>,
    start: &Findings,
    scene: Option<&String>,
    source: ReportSource<'_>,
) -> Markup {
    let blank = Given::default();
    let given = given.unwrap_or(&blank);
    let end = scene.and_then(|link| crate::scenario::link::read(link, source.aircraft));
    let end = end.map(|opened| Findings::of(opened.scenario));
    let said = match (given.reached, given.solution_shown) {
        (true, false) => "Reached.",
        (true, true) => "Reached, after the solution was shown.",
        (false, _) => "Not reached.",
    };
    html! {
        p { strong { "Task: " (of.goal.plain_at(start, source.aircraft)) } }
        p { span class=(if given.reached { "good" } else { "bad" }) { (said) }
            @if !of.hints.is_empty() { " Hints: " (given.hints) " of " (of.hints.len()) "." } }
        @if let Some(end) = &end { (conditions(of, start, end, source)) }
        @if let Some(link) = scene {
            p { a href={ (source.address) "#" (link) } { "The scene it ended with" } }
        }
    }
}

fn conditions(of: &Task, start: &Findings, end: &Findings, source: ReportSource<'_>) -> Markup {
    let length: LengthUnit = start.scenario().aircraft.length_unit;
    let read = |measure, reading: &Result<_, _>| match reading {
        Ok(reading) => words::measure::reading(measure, *reading, length),
        Err(absence) => words::measure::absence(absence),
    };
    html! {
        table {
            tr { th { "measure" } th { "at the start" } th { "at the end" } th { "wanted" } }
            @for (condition, progress) in of.until.iter().zip(progress(of, start, end, source.aircraft)) {
                @let measure = condition.measure;
                tr {
                    td { (words::measure::name(measure)) }
                    td { (read(measure, &progress.start)) }
                    td { (read(measure, &progress.now)) }
                    td { (said::wanted(measure, &condition.wanted, &progress, length)) }
                }
            }
        }
    }
}
