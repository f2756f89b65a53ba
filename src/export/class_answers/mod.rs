//! The answers of a class as one page to show in the room or to print: for each question how many said what, with nobody's name
//! unless it is wanted.
//!
//! | file | in one line |
//! |---|---|
//! | `bars` | how many chose what, as bars |
//! | `drawings` | estimates, places and sketches, drawn over each other |

mod bars;
mod drawings;

use std::sync::Arc;

use maud::{Markup, html};

use crate::content::Aircraft;
use crate::export::document::document;
use crate::lesson::{
    Answer, Given, Grade, Grader, Grades, Kind, Model, Outcome, Part, Place, Prediction, Task, Truth, said,
};
use crate::scenario::Convention;
use bars::{Bar, bars};
use drawings::One;

/// What the page is made of.
#[derive(Clone, Copy, Debug)]
pub struct ClassSource<'a> {
    /// With the lesson.
    pub grader: &'a Grader<'a>,
    /// What was handed in.
    pub grades: &'a Grades,
    /// The aircraft that links may name.
    pub aircraft: &'a [Arc<Aircraft>],
    /// Whether it says who answered what.
    pub names: bool,
}

/// The style of the page: light and dark, on a screen and on paper.
const STYLE: &str = ":root{color-scheme:light dark;--ink:#1b2430;--weak:#5b6675;--line:#ccd3dc;--ground:#fff;--good:#1a6b35;\
--bad:#a3231f;--one:#1f5fa8}@media(prefers-color-scheme:dark){:root{--ink:#e6eaf0;--weak:#9aa6b5;--line:#3a4450;\
--ground:#12171e;--good:#6fce8d;--bad:#f0938d;--one:#7db4f0}}body{font:18px/1.5 system-ui,sans-serif;max-width:56rem;\
margin:2rem auto;padding:0 1rem;color:var(--ink);background:var(--ground)}section{break-inside:avoid;\
border-top:1px solid var(--line);padding-top:.5rem}h2{break-after:avoid}.good{color:var(--good)}.bad{color:var(--bad)}\
.weak{color:var(--weak);font-size:.85em}.bar{display:grid;grid-template-columns:minmax(7rem,2fr) minmax(5rem,3fr) 2.5rem;gap:.2rem .8rem;\
align-items:center;margin:.3rem 0}.bar i{display:block;height:1.1rem;background:var(--one);min-width:1px;print-color-adjust:exact;\
-webkit-print-color-adjust:exact}\
.bar i.good{background:var(--good)}.bar p{grid-column:1/-1;margin:0}blockquote{white-space:pre-wrap;overflow-wrap:anywhere;\
border-left:3px solid var(--line);margin:.6rem 0;padding-left:1rem}svg{width:100%;height:auto;display:block}\
svg text{font:13px system-ui,sans-serif;fill:var(--weak)}svg .axis{stroke:var(--line);fill:none}\
svg .one{stroke:var(--one);fill:none;stroke-width:1.5;opacity:.5}svg circle.one{fill:var(--one)}\
svg .model{stroke:var(--ink);fill:none;stroke-width:3}\
@media(max-width:36rem){svg text{font-size:26px}}\
@media print{:root{color-scheme:light;--ink:#000;--weak:#444;--line:#999;--ground:#fff;--good:#1a6b35;--bad:#a3231f;--one:#1f5fa8}body{font-size:12px}}";

/// The page, without anything outside it.
pub fn class_answers(source: &ClassSource<'_>) -> String {
    let model = source.grader.model("");
    let title = format!("{}: what we answered", source.grades.lesson);
    let body = html! {
        p class="weak" { (source.grades.grades.len()) " handed in" }
        @for (number, step) in model.lesson.steps.iter().enumerate() {
            @let shown: Vec<Markup> = step.parts.iter().enumerate()
                .filter_map(|(at, part)| part_of(source, &model, Place { step: number, part: at }, part)).collect();
            @if !shown.is_empty() {
                h2 { (number + 1) ". " (step.title) }
                @for part in &shown { section { (part) } }
            }
        }
    };
    document(&title, &model.lesson.language, STYLE, &body)
}

fn part_of(source: &ClassSource<'_>, model: &Model, place: Place, part: &Part) -> Option<Markup> {
    let start = model.start(place.step)?;
    Some(match part {
        Part::Prediction(prediction) => html! {
            h3 { (prediction.ask.plain_at(start, source.aircraft)) }
            (question(source, place, prediction))
        },
        Part::Task(of) => html! {
            h3 { "Task: " (of.goal.plain_at(start, source.aircraft)) }
            (task(source, place, of))
        },
        Part::Write(writing) => html! {
            h3 { (writing.ask.plain_at(start, source.aircraft)) }
            @for (grade, given) in given(source, place) {
                @if let Some(Answer::Text(text)) = &given.answer {
                    blockquote { (text) @if source.names { br; span class="weak" { (grade.name) } } }
                }
            }
        },
        Part::Text(_) | Part::Reveal(_) | Part::Notes(_) => return None,
    })
}

/// What each person gave to a part.
fn given<'a>(source: &ClassSource<'a>, place: Place) -> impl Iterator<Item = (&'a Grade, &'a Given)> {
    source.grades.grades.iter().filter_map(move |grade| Some((grade, grade.answers.get(place)?)))
}

/// A question: what was answered first, which is what was predicted.
fn question(source: &ClassSource<'_>, place: Place, of: &Prediction) -> Markup {
    let answered: Vec<One<'_>> = given(source, place)
        .filter_map(|(grade, given)| Some((grade, given.earlier.first().or(given.final_answer())?)))
        .map(|(grade, answer)| One { name: &grade.name, answer, model: source.grader.model(&grade.seed) })
        .collect();
    let at = source.grades.parts.iter().position(|part| part.place == place);
    let is_right = |grade: &&Grade| {
        at.and_then(|at| grade.marks.get(at)).is_some_and(|mark| mark.outcome == Outcome::Right)
    };
    let right = source.grades.grades.iter().filter(is_right).count();
    let unknowing: Vec<&str> =
        answered.iter().filter(|one| *one.answer == Answer::DontKnow).map(|one| one.name).collect();
    let varies =
        source.grader.model("").lesson.steps.get(place.step).is_some_and(|step| !step.vary.is_empty());
    html! {
        p class="weak" {
            (right) " of " (answered.len()) " right" @if of.tries > 1 { " in the end; below is what was answered first" }
            @if !unknowing.is_empty() { " · " (unknowing.len()) " didn’t know" }
        }
        @match &of.kind {
            Kind::Choose { choices, .. } => (bars(source.names, answered.len(), choices.iter().enumerate().map(|(number, choice)| Bar {
                says: choice.says.plain(),
                is_right: choice.right,
                because: choice.because.as_ref().map(|because| because.plain()),
                names: answered.iter().filter(|one| matches!(one.answer, Answer::Chosen(chosen) if chosen.contains(&number)))
                    .map(|one| one.name).collect(),
            }).collect())),
            Kind::Order { .. } => (bars(source.names, answered.len(), orders(of, &answered, place))),
            Kind::Estimate { measure, .. } => (drawings::estimates(source.names, *measure, place, &answered, varies)),
            Kind::Place { .. } => (drawings::places(source.names, place, &answered)),
            Kind::Sketch { .. } => (drawings::sketches(source.names, place, &answered, varies)),
        }
    }
}

/// The orders that were given, the most frequent first.
fn orders<'a>(of: &Prediction, answered: &[One<'a>], place: Place) -> Vec<Bar<'a>> {
    let mut orders: Vec<Bar<'a>> = Vec::new();
    for one in answered.iter().filter(|one| matches!(one.answer, Answer::Order(_))) {
        let start = one.model.start(place.step);
        let convention = start.map_or(Convention::SI, |start| start.scenario().convention());
        let says = said::answer(of, one.answer, convention);
        let is_right = one
            .model
            .truth(place)
            .is_some_and(|truth: &Truth| truth.compare(&of.kind, one.answer).is_right());
        match orders.iter_mut().find(|order| order.says == says) {
            Some(order) => order.names.push(one.name),
            None => orders.push(Bar { says, is_right, because: None, names: vec![one.name] }),
        }
    }
    orders.sort_by_key(|order| std::cmp::Reverse(order.names.len()));
    orders
}

/// A task: by how many it was reached, and with which help.
fn task(source: &ClassSource<'_>, place: Place, of: &Task) -> Markup {
    let at = source.grades.parts.iter().position(|part| part.place == place);
    let mut unaided = Vec::new();
    let mut hinted = Vec::new();
    let mut shown = Vec::new();
    let mut tried = Vec::new();
    for grade in &source.grades.grades {
        let Some(mark) = at.and_then(|at| grade.marks.get(at)) else { continue };
        let name = grade.name.as_str();
        match (mark.outcome, mark.solution_shown, mark.hints) {
            (Outcome::Right, true, _) => shown.push(name),
            (Outcome::Right, false, 0) => unaided.push(name),
            (Outcome::Right, false, _) => hinted.push(name),
            (Outcome::Wrong, ..) => tried.push(name),
            (Outcome::Open, ..) => {}
        }
    }
    let all = unaided.len() + hinted.len() + shown.len() + tried.len();
    let bar = |says: &str, is_right, names| Bar { says: says.to_owned(), is_right, because: None, names };
    let mut list = vec![bar("reached without help", true, unaided)];
    if !of.hints.is_empty() {
        list.push(bar("reached with a hint", true, hinted));
    }
    list.push(bar("reached after the solution was shown", false, shown));
    list.push(bar("tried, not reached", false, tried));
    bars(source.names, all, list)
}
