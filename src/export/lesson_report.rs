//! A report of what a person has done in their lessons: one page to read, print or hand in, which carries its records.

use std::sync::Arc;

use maud::{Markup, PreEscaped, html};

use super::document::document;
use crate::content::Aircraft;
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

/// The style of the page: light and dark, on a screen and on paper.
const STYLE: &str = ":root{color-scheme:light dark;--ink:#1b2430;--line:#ccd3dc;--ground:#fff;--good:#1a6b35;--bad:#a3231f;\
--link:#0a58a8}@media(prefers-color-scheme:dark){:root{--ink:#e6eaf0;--line:#3a4450;--ground:#12171e;--good:#6fce8d;\
--bad:#f0938d;--link:#7db4f0}}body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem;\
color:var(--ink);background:var(--ground);overflow-wrap:break-word}a{color:var(--link)}h2{border-top:1px solid var(--line);\
padding-top:1rem}h2,h3{break-after:avoid}section{break-inside:avoid}table{border-collapse:collapse;font-size:.9em}\
td,th{border:1px solid var(--line);padding:.2rem .6rem;text-align:left}blockquote{white-space:pre-wrap;\
border-left:3px solid var(--line);margin-left:0;padding-left:1rem}.good{color:var(--good)}.bad{color:var(--bad)}\
@page{margin:15mm}@media print{:root{color-scheme:light;--ink:#000;--line:#999;--ground:#fff;--good:#1a6b35;--bad:#a3231f;--link:#000}\
body{font-size:10.5pt;margin:0;padding:0;max-width:none}h1{break-after:avoid}table,blockquote{break-inside:avoid}}";

impl Records {
    /// The report as one page, without anything outside it.
    pub fn report(&self, source: ReportSource<'_>) -> String {
        let title = "Eigenwing: what I predicted, and what happened";
        let body = html! {
            @if !self.person.is_empty() { p { (self.person) } }
            @for (address, record) in &self.lessons { (lesson(address, record, source)) }
            (PreEscaped(self.to_element()))
        };
        document(title, "en", STYLE, &body)
    }
}

fn lesson(address: &str, record: &Record, source: ReportSource<'_>) -> Markup {
    let own = Course::read(&record.files);
    let shipped = source.course.find(address).map(|(_, lesson)| lesson);
    let Some(lesson) = shipped.or_else(|| own.lessons.first()) else {
        return html! { h2 { (record.title) } p { "Its file isn’t here, so only its answers are kept below." } };
    };
    let lesson = &if record.seed.is_empty() { Lesson::clone(lesson) } else { lesson.of_person(&record.seed) };
    let (done, count) = record.done(lesson);
    let mut earned = 0.0;
    let mut steps = Vec::new();
    for (number, of) in lesson.steps.iter().enumerate().filter(|(number, _)| record.seen.contains(number)) {
        steps.push(step(number, of, lesson, record, source, &mut earned));
    }
    html! {
        h2 { (lesson.title) }
        p { (done) " of " (count) " steps done" @if lesson.is_homework() { ", " (said::sum(earned, lesson.points())) }
            @if record.begun_again > 0 { "; " (said::begun_again(record.begun_again)) } }
        @for step in steps { (step) }
    }
}

/// A step, with its points added to those that were `earned`.
fn step(
    number: usize,
    step: &Step,
    lesson: &Lesson,
    record: &Record,
    source: ReportSource<'_>,
    earned: &mut f64,
) -> Markup {
    let Some(opened) = step.scene.open(source.aircraft) else { return html! {} };
    let start = Findings::of(opened.scenario);
    let mark = if record.is_done(lesson, number) { "✓ " } else { "" };
    let tells = lesson.is_homework();
    for (part, what) in step.parts.iter().enumerate() {
        let given = record.answers.get(Place { step: number, part });
        *earned += given.map_or(0.0, |given| part_earned(what, given, &start, source));
    }
    html! {
        section {
            h3 { (mark) (number + 1) ". " (step.title) }
            @for (part, what) in step.parts.iter().enumerate() {
                @let place = Place { step: number, part };
                @let given = record.answers.get(place);
                @match (what, given) {
                    (Part::Prediction(of), Some(given)) => (question(of, given, &start, source, tells)),
                    (Part::Task(of), given) => (task(of, given, &start, record.scenes.get(&place), source, tells)),
                    (Part::Write(of), Some(given)) => {
                        p { (of.ask.plain_at(&start, source.aircraft)) }
                        @if let Some(crate::lesson::Answer::Text(text)) = &given.answer { blockquote { (text) } }
                    }
                    (
                        Part::Text(_) | Part::Reveal(_) | Part::Prediction(_) | Part::Write(_) | Part::Notes(_),
                        _,
                    ) => {}
                }
            }
        }
    }
}

/// The points that were earned with a part.
fn part_earned(what: &Part, given: &Given, start: &Findings, source: ReportSource<'_>) -> f64 {
    let is_earned = match what {
        Part::Prediction(of) => given.final_answer().is_some_and(|answer| {
            let truth = of.truth(start, source.aircraft);
            truth.is_some_and(|truth| truth.compare(&of.kind, answer).is_right())
        }),
        Part::Task(of) => of.is_earned(given),
        Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => false,
    };
    if is_earned { what.points().unwrap_or(0.0) } else { 0.0 }
}

fn question(
    of: &Prediction,
    given: &Given,
    start: &Findings,
    source: ReportSource<'_>,
    tells: bool,
) -> Markup {
    let Some(answer) = given.final_answer() else { return html! {} };
    let convention = start.scenario().convention();
    let truth = of.truth(start, source.aircraft);
    html! {
        p { strong { (of.ask.plain_at(start, source.aircraft)) } }
        p { "My answer: " (said::answer(of, answer, convention)) }
        @if let Some(truth) = truth {
            @let compared = truth.compare(&of.kind, answer);
            @let class = if compared.is_right() { "good" } else { "bad" };
            p { "The model: " (said::truth(of, &truth, convention)) ". "
                span class=(class) { (compared.says()) }
                @if tells { " " (said::earned(of.points.unwrap_or(1.0), compared.is_right())) "." } }
        }
    }
}

fn task(
    of: &Task,
    given: Option<&Given>,
    start: &Findings,
    scene: Option<&String>,
    source: ReportSource<'_>,
    tells: bool,
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
            @if !of.hints.is_empty() { " Hints: " (given.hints) " of " (of.hints.len()) "." }
            @if tells { " " (said::earned(of.points.unwrap_or(1.0), of.is_earned(given))) "." } }
        @if let Some(end) = &end { (conditions(of, start, end, source)) }
        @if let Some(link) = scene {
            p { a href={ (source.address) "#" (link) } { "The scene it ended with" } }
        }
    }
}

fn conditions(of: &Task, start: &Findings, end: &Findings, source: ReportSource<'_>) -> Markup {
    let convention = start.scenario().convention();
    let read = |measure, reading: &Result<_, _>| match reading {
        Ok(reading) => words::measure::reading(measure, *reading, convention),
        Err(absence) => words::measure::absence(absence, convention.length),
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
                    td { (said::wanted(measure, &condition.wanted, &progress, convention)) }
                }
            }
        }
    }
}
