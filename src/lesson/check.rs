//! The proof that a lesson holds what it promises, as far as a program can tell.

use std::sync::Arc;

use super::file::Lesson;
use super::goal::{changes, progress};
use super::number::unknown;
use super::prediction::{Kind, Prediction};
use super::scene::Scene;
use super::shelf::Shelf;
use super::step::{Part, Step};
use super::task::{Task, Wanted};
use super::text::{Target, Text, What};
use super::varied;
use crate::content::{Aircraft, ContentError};
use crate::few;
use crate::findings::Findings;
use crate::findings::measures::Reading;
use crate::flight::motion::outputs::Output;
use crate::scenario::{Hidden, Part as Page, Stage};
use crate::words;

impl Lesson {
    /// Everything that is wrong with it, in the order of the file; nothing where it holds.
    pub fn check(&self, aircraft: &[Arc<Aircraft>], shelf: &Shelf) -> Vec<ContentError> {
        let mut errors = self.faults(aircraft, shelf);
        for shares in self.shares() {
            let varied = self.at_shares(|vary| {
                shares.iter().find(|(key, _)| *key == vary.parameter.key).map_or(0.5, |at| at.1)
            });
            for fault in varied.faults(aircraft, shelf) {
                // One sentence a line is enough.
                if errors.iter().all(|error| error.line != fault.line) {
                    let numbers = varied.numbers_before(fault.line);
                    errors.push(ContentError {
                        problem: format!("with {numbers}: {}", fault.problem),
                        ..fault
                    });
                }
            }
        }
        few::sort_by_key(&mut errors, |error| error.line);
        errors
    }

    fn faults(&self, aircraft: &[Arc<Aircraft>], shelf: &Shelf) -> Vec<ContentError> {
        let mut check = Check { lesson: self, aircraft, shelf, errors: Vec::new() };
        for key in &self.references {
            check.reference(key, 1);
        }
        self.steps.iter().for_each(|step| check.step(step));
        let mut errors = check.errors;
        few::sort_by_key(&mut errors, |error| error.line);
        errors.dedup();
        errors
    }

    /// Where between their ends the varied numbers are proved: all at the same shares, each alone at its ends, and a few mixtures.
    fn shares(&self) -> Vec<Vec<(&'static str, f64)>> {
        let mut keys: Vec<&str> =
            self.steps.iter().flat_map(|step| &step.vary).map(|vary| vary.parameter.key).collect();
        keys.sort_unstable();
        keys.dedup();
        if keys.is_empty() {
            return Vec::new();
        }
        let all = |share: f64| keys.iter().map(|key| (*key, share)).collect::<Vec<_>>();
        let mut shares: Vec<Vec<(&str, f64)>> = [0.0, 1.0, 0.5, 0.25, 0.75].map(all).to_vec();
        if keys.len() > 1 {
            for alone in 0..keys.len() {
                for share in [0.0, 1.0] {
                    let at = |(number, key): (usize, &&'static str)| {
                        (*key, if number == alone { share } else { 1.0 - share })
                    };
                    shares.push(keys.iter().enumerate().map(at).collect());
                }
            }
            // Multiples of the golden section lie nowhere twice.
            let mixed = |round: usize| {
                let at = |(number, key): (usize, &&'static str)| {
                    (*key, (0.618 * (1 + number + 5 * round) as f64).fract())
                };
                keys.iter().enumerate().map(at).collect()
            };
            shares.extend((0..4).map(mixed));
        }
        shares
    }

    /// The varied numbers of the step in which a line stands, as links say them.
    fn numbers_before(&self, line: usize) -> String {
        let step = self.steps.iter().rev().find(|step| step.line <= line).or(self.steps.first());
        step.map_or_else(String::new, |step| varied::numbers(step).join(", "))
    }
}

struct Check<'l> {
    lesson: &'l Lesson,
    aircraft: &'l [Arc<Aircraft>],
    shelf: &'l Shelf,
    errors: Vec<ContentError>,
}

impl Check<'_> {
    fn error(&mut self, line: usize, problem: impl Into<String>) {
        self.errors.push(ContentError { file: self.lesson.file.clone(), line, problem: problem.into() });
    }

    fn step(&mut self, step: &Step) {
        let Some(start) = self.open(&step.scene) else { return };
        let stage = step.scene.open(self.aircraft).map(|opened| opened.view.stage).unwrap_or_default();
        let mut asked = false;
        for part in &step.parts {
            match part {
                Part::Reveal(_) if !asked => {
                    self.error(step.line, "a reveal has a question before it; expected ```predict")
                }
                Part::Prediction(prediction) => {
                    asked = true;
                    self.prediction(prediction, &start);
                    self.answer_on_screen(prediction, &stage);
                }
                Part::Task(task) => self.task(task, &start),
                Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => {}
            }
        }
        step.texts().into_iter().for_each(|text| self.text(text, &start, true));
        // Notes speak of the clock on the wall: “give them 30 s”.
        step.notes().for_each(|notes| self.text(&notes.text, &start, false));
    }

    /// What a scene leads to, without a notice.
    fn open(&mut self, scene: &Scene) -> Option<Findings> {
        let opened = scene.open(self.aircraft)?;
        for notice in &opened.notices {
            self.error(scene.line, format!("the link doesn’t open as it says: {notice}"));
        }
        Some(Findings::of(opened.scenario))
    }

    fn reference(&mut self, key: &str, line: usize) {
        if !self.shelf.references.contains_key(key) {
            let problem = unknown("reference", key, self.shelf.references.keys().map(String::as_str));
            self.error(line, problem);
        }
    }

    /// Links and numbers of a text; whether its numbers are the model’s, which are never typed.
    fn text(&mut self, text: &Text, start: &Findings, is_of_model: bool) {
        for span in text.spans() {
            match &span.target {
                Some(Target::Glossary(key)) if !self.shelf.glossary.contains_key(key) => {
                    let problem =
                        unknown("word of the glossary", key, self.shelf.glossary.keys().map(String::as_str));
                    self.error(span.line, problem);
                }
                Some(Target::Source(key)) => self.reference(key, span.line),
                Some(Target::Scene(link)) => {
                    self.open(&Scene { link: link.clone(), line: span.line });
                }
                Some(Target::Glossary(_) | Target::Lesson(_) | Target::Page(_)) | None => {}
            }
            match &span.what {
                What::Number(number) => {
                    if let Some(scene) = &number.at {
                        self.open(scene);
                    }
                    if let Some(Err(absence)) = number.value(start, self.aircraft) {
                        let length = start.scenario().length_unit();
                        let (key, why) = (number.measure.key(), words::measure::absence(&absence, length));
                        self.error(number.line, format!("`= {key}` has no value at this scene: {why}"));
                    }
                }
                What::Words(said) if is_of_model && !matches!(span.target, Some(Target::Source(_))) => {
                    if let Some(found) = typed_number(said) {
                        self.error(span.line, format!(
                            "“{found}” is typed: expected a number that is measured, `= KEY`, or one quoted, [{found}](source:KEY)"
                        ));
                    }
                }
                What::Words(_) | What::Symbol(_) | What::Formula(_) | What::Break => {}
            }
        }
    }

    /// What is asked for isn't on screen while it is asked for.
    fn answer_on_screen(&mut self, prediction: &Prediction, stage: &Stage) {
        let problem = match prediction.kind {
            _ if prediction.after.is_some() => return,
            Kind::Place { .. } if stage.has(Page::Poles) => {
                "the pole is on screen: expected a scene whose stage is without poles, or after, a scene to which it goes"
            }
            Kind::Sketch { .. } if stage.has(Page::Response) && !stage.hides(Hidden::Curves) => {
                "the curve is on screen: expected a scene with hide=curves, or after, a scene that has it"
            }
            _ => return,
        };
        self.error(prediction.line, problem);
    }

    fn prediction(&mut self, prediction: &Prediction, start: &Findings) {
        let line = prediction.line;
        let elsewhere = prediction.after.as_ref().and_then(|scene| self.open(scene));
        let after = elsewhere.as_ref().unwrap_or(start);
        match &prediction.kind {
            Kind::Choose { choices, several } => {
                let right = choices.iter().filter(|choice| choice.right).count();
                if choices.len() < 2 {
                    self.error(line, format!("expected two choices or more, found {}", choices.len()));
                }
                if right == 0 || right > 1 && !several {
                    self.error(line, format!(
                        "expected one right choice, found {right}; where more are right, say several = true"
                    ));
                }
                let mut reasons = Vec::new();
                for choice in choices.iter().filter(|choice| !choice.right) {
                    match choice.because.as_ref().map(Text::plain) {
                        None => self
                            .error(choice.line, "a wrong choice has a reason of its own; expected because"),
                        Some(reason) if reasons.contains(&reason) => {
                            self.error(
                                choice.line,
                                "another choice has the same reason; expected one of its own",
                            );
                        }
                        Some(reason) => reasons.push(reason),
                    }
                }
            }
            Kind::Estimate { measure, .. } => {
                if let Err(absence) = measure.read(after) {
                    let why = words::measure::absence(&absence, after.scenario().length_unit());
                    self.error(line, format!("{} has no value to be estimated: {why}", measure.key()));
                }
            }
            Kind::Place { mode, .. } => {
                if !after.flown_modes().iter().any(|found| found.naming.name == *mode) {
                    let name = words::mode::in_a_sentence(*mode);
                    self.error(line, format!("there is no {name} to be placed in the plane on screen"));
                }
            }
            Kind::Sketch { output, .. } => {
                let plane = after.scenario().plane;
                if after.motion().is_none() || !Output::of(plane).contains(output) {
                    self.error(line, "there is no such motion to be drawn in the plane on screen");
                }
            }
            Kind::Order { items, measure, .. } => {
                let mut values = Vec::new();
                for item in items {
                    let Some(findings) = self.open(&item.scene) else { continue };
                    match measure.read(&findings) {
                        Ok(Reading::Number(value)) if values.contains(&value) => {
                            self.error(item.scene.line, "two things have the same value: expected an order");
                        }
                        Ok(Reading::Number(value)) => values.push(value),
                        _ => self
                            .error(item.scene.line, format!("{} is no number at this scene", measure.key())),
                    }
                }
                if items.len() < 2 {
                    self.error(line, format!("expected two things or more, found {}", items.len()));
                }
            }
        }
    }

    fn task(&mut self, task: &Task, start: &Findings) {
        for condition in &task.until {
            if let Wanted::SameAs(_, scene) = &condition.wanted {
                self.open(scene);
            }
        }
        for parameter in task.offer.iter().filter(|parameter| !parameter.applies(start.scenario())) {
            let problem = format!("the aircraft of this scene has no {}, which is offered", parameter.key);
            self.error(task.line, problem);
        }
        if task.is_met(start, start, self.aircraft) {
            self.error(task.line, "the goal is met before anything is done");
        }
        let Some(scene) = &task.solution else {
            self.error(task.line, "solution: missing; expected a link to a scene that meets the goal");
            return;
        };
        let Some(solved) = self.open(scene) else { return };
        if solved.scenario().aircraft.key != start.scenario().aircraft.key {
            self.error(scene.line, "the solution is of another aircraft than the start");
            return;
        }
        let moved = changes(start.scenario(), solved.scenario());
        if let Some(most) = task.changes.filter(|most| moved.len() > *most) {
            self.error(scene.line, format!("the solution changes {}, more than {most}", moved.join(", ")));
        }
        let strangers: Vec<&str> = moved
            .iter()
            .copied()
            .filter(|key| !task.offer.is_empty() && task.offer.iter().all(|offered| offered.key != *key))
            .collect();
        if !strangers.is_empty() {
            self.error(scene.line, format!("the solution changes {}, not offered", strangers.join(", ")));
        }
        for (condition, progress) in task.until.iter().zip(progress(task, start, &solved, self.aircraft)) {
            if !progress.met {
                let convention = solved.scenario().convention();
                let found = match &progress.now {
                    Ok(reading) => words::measure::reading(condition.measure, *reading, convention),
                    Err(absence) => words::measure::absence(absence, convention.length),
                };
                let key = condition.measure.key();
                self.error(condition.line, format!("the solution doesn’t meet this: {key} is {found}"));
            }
        }
    }
}

/// Units after which a number is one of the model's.
const UNITS: [&str; 18] = [
    "s", "ms", "min", "m", "km", "ft", "m/s", "ft/s", "kt", "rad", "rad/s", "1/s", "deg", "deg/s", "°", "%",
    "Hz", "kg",
];

/// The first number with a unit in a text.
fn typed_number(text: &str) -> Option<String> {
    let words: Vec<&str> =
        text.split(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | '“' | '”')).collect();
    let stripped = |word: &'_ str| word.trim_end_matches(['.', ',', ';', ':', '?', '!']).to_owned();
    words.iter().enumerate().find_map(|(index, word)| {
        let word = stripped(word);
        let end = word
            .find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '−' | '-' | '+' | '±')))
            .unwrap_or(word.len());
        let (number, unit) = word.split_at(end);
        if !number.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        if UNITS.contains(&unit) {
            return Some(word.clone());
        }
        let next = words.get(index + 1).map(|next| stripped(next))?;
        (unit.is_empty() && UNITS.contains(&next.as_str())).then(|| format!("{number} {next}"))
    })
}
