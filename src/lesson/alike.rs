//! What nobody else has by chance: sketches, placed poles, longer texts, dragged sliders. Two persons who share one of these have not
//! both made it.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::answer::Answer;
use super::file::Lesson;
use super::record::Record;
use super::step::{Part, Step};
use super::text::Target;
use crate::content::Aircraft;
use crate::scenario::{Parameter, Scenario, link};

/// Digits of a number that was dragged; one that is typed has fewer.
const DIGITS: usize = 6;

/// Characters of a text that two persons don't find alike.
const LONG: usize = 30;

/// Different heights of a sketch that is more than a level or a step.
const HEIGHTS: usize = 8;

/// One thing that somebody has made.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct OwnThing {
    /// The step, counted from 0.
    pub step: usize,
    /// What it is, in words.
    pub what: &'static str,
    /// The thing itself.
    made: String,
}

/// All that somebody has made in a lesson.
pub(super) fn own_things(record: &Record, lesson: &Lesson, aircraft: &[Arc<Aircraft>]) -> BTreeSet<OwnThing> {
    let mut things = BTreeSet::new();
    for (place, given) in record.answers.iter() {
        let made = given.earlier.iter().chain(&given.answer).filter_map(of_answer);
        things.extend(made.map(|(what, made)| OwnThing { step: place.step, what, made }));
    }
    for (place, scene) in &record.scenes {
        let Some(step) = lesson.steps.get(place.step) else { continue };
        if !scene.split(['&', '=']).any(is_long) {
            continue;
        }
        let Some(opened) = link::read(scene, aircraft) else { continue };
        let given: BTreeSet<&str> = links_of(step).into_iter().flat_map(pieces).collect();
        let own = pieces(scene).filter(|piece| !given.contains(piece));
        let made = own.filter(|piece| is_dragged(piece, &opened.scenario)).map(str::to_owned);
        things.extend(made.map(|made| OwnThing { step: place.step, what: "dragged slider", made }));
    }
    things
}

/// An answer that only one person gives, with what it is.
fn of_answer(answer: &Answer) -> Option<(&'static str, String)> {
    let what = match answer {
        Answer::Sketch(heights) => {
            let different: BTreeSet<u64> = heights.iter().map(|height| height.to_bits()).collect();
            (different.len() >= HEIGHTS).then_some("sketch")
        }
        Answer::Place { real, imaginary } => {
            [real, imaginary].iter().any(|number| is_long(&number.to_string())).then_some("placed pole")
        }
        Answer::Text(text) => (text.trim().chars().count() > LONG).then_some("text"),
        Answer::DontKnow | Answer::Chosen(_) | Answer::Number(_) | Answer::Order(_) => None,
    }?;
    Some((what, serde_json::to_string(answer).ok()?))
}

fn is_long(number: &str) -> bool {
    number.chars().filter(char::is_ascii_digit).count() >= DIGITS
}

fn pieces(link: &str) -> impl Iterator<Item = &str> {
    link.split_once('#').map_or(link, |(_, pieces)| pieces).split('&')
}

/// The links that everybody has in a step: its scene, its solutions and those in its text.
fn links_of(step: &Step) -> Vec<&str> {
    let in_text =
        step.texts().into_iter().flat_map(|text| text.spans()).filter_map(|span| match &span.target {
            Some(Target::Scene(link)) => Some(link.as_str()),
            _ => None,
        });
    let of_parts = step.parts.iter().filter_map(|part| match part {
        Part::Task(task) => task.solution.as_ref(),
        Part::Prediction(prediction) => prediction.after.as_ref(),
        Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => None,
    });
    std::iter::once(&step.scene).chain(of_parts).map(|scene| scene.link.as_str()).chain(in_text).collect()
}

/// Whether a piece of a link is a slider that was dragged, and not to its end, where it is the same for everybody.
fn is_dragged(piece: &str, scenario: &Scenario) -> bool {
    let Some((key, number)) = piece.split_once('=') else { return false };
    let parameter = Parameter::find(key.strip_prefix("add.").unwrap_or(key));
    parameter.filter(|parameter| is_long(number) && !parameter.is_of_disturbance()).is_some_and(|parameter| {
        let (value, range) = (parameter.get(scenario), parameter.range(scenario));
        let near = 1e-9 * (range.end() - range.start());
        [range.start(), range.end()].iter().all(|end| (value - **end).abs() > near)
    })
}
