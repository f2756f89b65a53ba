//! What was handed in, graded: every goal is judged on the scene, every answer against the model, whatever a report says of itself.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;

use serde::Serialize;

use super::alike::{OwnThing, own_things};
use super::file::Lesson;
use super::given::{Answers, Given, Place};
use super::goal::{Unfit, progress};
use super::prediction::Prediction;
use super::record::{Record, Records};
use super::remark::Remark;
use super::said;
use super::scene::Scene;
use super::step::{Part, Step};
use super::submission::{Submission, Work};
use super::task::Task;
use super::truth::Truth;
use super::varied;
use super::vary::normalised;
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::scenario::link::{self, HandedIn, LessonPlace, Notice};
use crate::words;

/// A part of the lesson that is graded.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GradedPart {
    /// Where it stands.
    pub place: Place,
    /// Heading of its step.
    pub step: String,
    /// What is asked or to be done.
    pub says: String,
    /// What it is worth: what the file says, or one point.
    pub points: f64,
}

/// How a part was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Right, or reached.
    Right,
    /// Answered or tried, and not right.
    Wrong,
    /// Nothing was done.
    #[default]
    Open,
}

/// What a person gets for a part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Mark {
    /// How it was done.
    pub outcome: Outcome,
    /// The points.
    pub points: f64,
    /// How many answers were given, or how many scenes tried.
    pub tries: u32,
    /// How many hints were shown.
    pub hints: usize,
    /// Whether the solution was shown before.
    pub solution_shown: bool,
}

/// What a person gets.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Grade {
    /// Who it is.
    pub name: String,
    /// Where it was handed in.
    pub source: String,
    /// All points.
    pub points: f64,
    /// Of each graded part, in the order of the lesson.
    pub marks: Vec<Mark>,
    /// What is to be told.
    pub remarks: Vec<Remark>,
    /// What was answered, as far as it fits the lesson.
    #[serde(skip)]
    pub answers: Answers,
    /// Whose numbers it was done with; empty without varied numbers.
    #[serde(skip)]
    pub seed: String,
    /// What nobody else has by chance.
    #[serde(skip)]
    own: BTreeSet<OwnThing>,
}

/// The grades of all that was handed in.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grades {
    /// Title of the lesson.
    pub lesson: String,
    /// Version of its file.
    pub version: String,
    /// All points that there are.
    pub points: f64,
    /// What is graded.
    pub parts: Vec<GradedPart>,
    /// Of each person, in the order in which it was handed in.
    pub grades: Vec<Grade>,
}

/// The lesson with one person's numbers, and what the model says to it.
#[derive(Debug)]
pub struct Model {
    /// The lesson.
    pub lesson: Lesson,
    /// What follows from the scene of each step.
    starts: Vec<Option<Findings>>,
    truths: BTreeMap<Place, Truth>,
}

impl Model {
    fn of(lesson: Lesson, aircraft: &[Arc<Aircraft>]) -> Self {
        let start = |step: &Step| Some(Findings::of(step.scene.open(aircraft)?.scenario));
        let starts: Vec<Option<Findings>> = lesson.steps.iter().map(start).collect();
        let mut truths = BTreeMap::new();
        for (place, part) in parts(&lesson) {
            if let (Part::Prediction(prediction), Some(Some(start))) = (part, starts.get(place.step)) {
                truths.extend(prediction.truth(start, aircraft).map(|truth| (place, truth)));
            }
        }
        Self { lesson, starts, truths }
    }

    /// What follows from the scene of a step.
    pub fn start(&self, step: usize) -> Option<&Findings> {
        self.starts.get(step)?.as_ref()
    }

    /// What the model says to a question.
    pub fn truth(&self, place: Place) -> Option<&Truth> {
        self.truths.get(&place)
    }
}

/// The parts of a lesson with their places.
fn parts(lesson: &Lesson) -> impl Iterator<Item = (Place, &Part)> {
    lesson.steps.iter().enumerate().flat_map(|(step, of)| {
        of.parts.iter().enumerate().map(move |(part, what)| (Place { step, part }, what))
    })
}

/// Grades what is handed in to one lesson.
#[derive(Debug)]
pub struct Grader<'a> {
    lesson: &'a Lesson,
    aircraft: &'a [Arc<Aircraft>],
    /// By whose numbers they are.
    models: RefCell<BTreeMap<String, Rc<Model>>>,
}

impl<'a> Grader<'a> {
    /// For a lesson, with the aircraft that links may name.
    pub fn new(lesson: &'a Lesson, aircraft: &'a [Arc<Aircraft>]) -> Self {
        Self { lesson, aircraft, models: RefCell::default() }
    }

    /// The lesson with the numbers of a person.
    pub fn model(&self, seed: &str) -> Rc<Model> {
        let varies = self.lesson.varies() && !seed.is_empty();
        let key = if varies { normalised(seed) } else { String::new() };
        let mut models = self.models.borrow_mut();
        let model = || {
            let lesson = if varies { self.lesson.of_person(seed) } else { self.lesson.clone() };
            Rc::new(Model::of(lesson, self.aircraft))
        };
        models.entry(key).or_insert_with(model).clone()
    }

    /// Grades what one person has handed in.
    pub fn grade(&self, submission: &Submission) -> Grade {
        let mut grade = match &submission.work {
            Ok(Work::Report(records)) => self.report(submission, records),
            Ok(Work::Links(links)) => self.links(submission, links),
            Err(why) => Grade {
                name: submission.name.clone().unwrap_or_default(),
                remarks: vec![Remark::Unreadable(why.clone())],
                ..Grade::default()
            },
        };
        let count = self.graded().count();
        grade.marks.resize(count, Mark::default());
        grade.points = grade.marks.iter().map(|mark| mark.points).sum();
        grade.source = submission.source.clone();
        grade
    }

    /// All grades, with what is to be told of them together.
    pub fn finish(&self, mut grades: Vec<Grade>) -> Grades {
        let others = |index: usize| {
            let of: &Grade = &grades[index];
            let key = normalised(&of.name);
            let (mut whose, mut shared) = (Vec::new(), BTreeSet::new());
            for (_, other) in grades.iter().enumerate().filter(|(other, _)| *other != index) {
                let same: Vec<&OwnThing> = other.own.intersection(&of.own).collect();
                if !same.is_empty() && normalised(&other.name) != key {
                    let is_named = !other.name.is_empty();
                    whose.push(if is_named { other.name.clone() } else { other.source.clone() });
                    shared.extend(same.into_iter().map(|thing| (thing.step, thing.what)));
                }
            }
            let shared: Vec<_> = shared.into_iter().collect();
            let same = (!whose.is_empty()).then_some(Remark::SameAs { whose, shared });
            let is_again =
                !key.is_empty() && grades[..index].iter().any(|grade| normalised(&grade.name) == key);
            same.into_iter().chain(is_again.then_some(Remark::Again)).collect::<Vec<_>>()
        };
        let more: Vec<Vec<Remark>> = (0..grades.len()).map(others).collect();
        for (grade, more) in grades.iter_mut().zip(more) {
            grade.remarks.extend(more);
        }
        let model = self.model("");
        let parts: Vec<GradedPart> = self
            .graded()
            .map(|(place, part)| {
                let (text, points) = match part {
                    Part::Prediction(prediction) => (&prediction.ask, prediction.points),
                    Part::Task(task) => (&task.goal, task.points),
                    Part::Text(text) | Part::Reveal(text) => (text, None),
                    Part::Write(writing) => (&writing.ask, None),
                    Part::Notes(notes) => (&notes.text, None),
                };
                GradedPart {
                    place,
                    step: self
                        .lesson
                        .steps
                        .get(place.step)
                        .map_or_else(String::new, |step| step.title.clone()),
                    says: model
                        .start(place.step)
                        .map_or_else(|| text.plain(), |start| text.plain_at(start, self.aircraft)),
                    points: points.unwrap_or(1.0),
                }
            })
            .collect();
        Grades {
            lesson: self.lesson.title.clone(),
            version: self.lesson.version.clone(),
            points: parts.iter().map(|part| part.points).sum(),
            parts,
            grades,
        }
    }

    /// The parts that are graded.
    fn graded(&self) -> impl Iterator<Item = (Place, &'a Part)> {
        parts(self.lesson).filter(|(_, part)| matches!(part, Part::Prediction(_) | Part::Task(_)))
    }

    fn report(&self, submission: &Submission, records: &Records) -> Grade {
        let name = submission.name.clone().unwrap_or_else(|| records.person.trim().to_owned());
        let is_this = |(address, record): &(&String, &Record)| {
            record.title == self.lesson.title || record.title.is_empty() && self.is_its_address(address)
        };
        let these: Vec<&Record> = records.lessons.iter().filter(is_this).map(|(_, record)| record).collect();
        // Of those that are equally far the first.
        let Some(record) = these.iter().copied().rev().max_by_key(|record| progress_of(record)) else {
            let titles = records.lessons.values().map(|record| record.title.clone()).collect();
            return Grade { name, remarks: vec![Remark::OtherLessons(titles)], ..Grade::default() };
        };
        let mut remarks = Vec::new();
        if name.is_empty() {
            remarks.push(Remark::Nameless);
        }
        let begun = these.iter().filter(|record| !record.answers.is_empty()).count();
        if begun > 1 {
            remarks.push(Remark::Several(begun));
        }
        if record.begun_again > 0 {
            remarks.push(Remark::BegunAgain(record.begun_again));
        }
        let given = record.answers.iter().count();
        let answers = record.answers.clone().fitting(self.lesson);
        let left = given - answers.iter().count();
        if !record.version.is_empty() && record.version != self.lesson.version {
            remarks.push(Remark::OtherVersion(left));
        } else if left > 0 {
            remarks.push(Remark::Unfitting(left));
        }
        let seed = if record.seed.is_empty() { name.clone() } else { record.seed.clone() };
        if self.lesson.varies() && !name.is_empty() && normalised(&seed) != normalised(&name) {
            remarks.push(Remark::OtherNumbers(seed.clone()));
        }
        let record = Record { answers, ..record.clone() };
        self.record(name, seed, &record, remarks)
    }

    /// Whether a lesson that was opened from there is this one; the name of a file may have lost its spaces on the way.
    fn is_its_address(&self, address: &str) -> bool {
        let name = address.rsplit('/').next().unwrap_or_default();
        normalised(name.strip_suffix(".md").unwrap_or(name)) == normalised(self.lesson.key())
    }

    fn links(&self, submission: &Submission, links: &[String]) -> Grade {
        let mut remarks = Vec::new();
        let mut record = Record::default();
        let opened: Vec<_> =
            links.iter().filter_map(|link| Some((link, link::read(link, self.aircraft)?))).collect();
        // Whose links they are, each person once.
        let mut by: Vec<String> = Vec::new();
        for handed_in in opened.iter().filter_map(|(_, opened)| opened.handed_in.as_ref()) {
            let key = normalised(&handed_in.by);
            if !key.is_empty() && by.iter().all(|by| normalised(by) != key) {
                by.push(handed_in.by.clone());
            }
        }
        let name = submission.name.clone().or_else(|| by.first().cloned()).unwrap_or_default();
        let (own, others): (Vec<String>, Vec<String>) = by.into_iter().partition(|by| is_name_of(&name, by));
        let seed = own.into_iter().next().or_else(|| others.first().cloned()).unwrap_or_else(|| name.clone());
        remarks.extend(others.into_iter().map(Remark::By));
        let model = self.model(&seed);
        for (link, opened) in &opened {
            let is_of_step =
                |notice: &Notice| matches!(notice, Notice::Word { key, .. } if key == LessonPlace::STEP);
            let mut notices = opened.notices.iter().filter(|_| opened.lesson.is_some());
            if let Some(notice) = notices.find(|notice| is_of_step(notice)) {
                remarks.push(Remark::BadLink(notice.to_string()));
                continue;
            }
            let step = match &opened.lesson {
                Some(place) if self.is_its_address(&place.address) => place.step,
                Some(place) => {
                    remarks.push(Remark::OtherLink(place.address.clone()));
                    continue;
                }
                None => {
                    remarks.push(Remark::NoStep);
                    continue;
                }
            };
            let tasks: Vec<(Place, &Task)> = parts(&model.lesson)
                .filter(|(place, _)| place.step == step)
                .filter_map(
                    |(place, part)| if let Part::Task(task) = part { Some((place, task)) } else { None },
                )
                .collect();
            let now = Findings::of(opened.scenario.clone());
            let is_met =
                |task: &Task| model.start(step).is_some_and(|start| task.is_met(start, &now, self.aircraft));
            // A link is that of the tasks of its step whose goals it meets, and if it meets none that of the first.
            let met = tasks.iter().filter(|(_, task)| is_met(task)).map(|(place, _)| (*place, true));
            let mut of: Vec<(Place, bool)> = met.collect();
            if of.is_empty() {
                of.extend(tasks.first().map(|(place, _)| (*place, false)));
            }
            if of.is_empty() {
                remarks.push(Remark::NoStep);
            }
            for (place, is_met) in of {
                if is_met || !record.scenes.contains_key(&place) {
                    let HandedIn { hints, solution_shown, .. } = opened.handed_in.clone().unwrap_or_default();
                    *record.answers.at(place) =
                        Given { reached: true, hints, solution_shown, ..Given::default() };
                    record.scenes.insert(place, (*link).clone());
                }
            }
        }
        let mut told = Vec::new();
        remarks.retain(|remark| {
            !told.contains(remark) && {
                told.push(remark.clone());
                true
            }
        });
        self.record(name, seed, &record, remarks)
    }

    /// Grades a record whose answers fit the lesson.
    fn record(&self, name: String, seed: String, record: &Record, mut remarks: Vec<Remark>) -> Grade {
        let model = self.model(&seed);
        let mut not_given = 0;
        let marks = parts(&model.lesson)
            .filter_map(|(place, part)| {
                let blank = Given::default();
                let given = record.answers.get(place).unwrap_or(&blank);
                match part {
                    Part::Prediction(prediction) => {
                        not_given += usize::from(given.answer.is_some() && !given.is_final);
                        Some(question(prediction, given, model.truth(place), place, &mut remarks))
                    }
                    Part::Task(task) => {
                        let work = TaskWork { place, task, given, scene: record.scenes.get(&place) };
                        Some(self.task(&model, work, &mut remarks))
                    }
                    Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => None,
                }
            })
            .collect();
        if not_given > 0 {
            remarks.push(Remark::NotGiven(not_given));
        }
        let own = own_things(record, &model.lesson, self.aircraft);
        let seed = if self.lesson.varies() { seed } else { String::new() };
        Grade { name, marks, remarks, answers: record.answers.clone(), seed, own, ..Grade::default() }
    }

    fn task(&self, model: &Model, work: TaskWork<'_>, remarks: &mut Vec<Remark>) -> Mark {
        let TaskWork { place, task, given, scene } = work;
        let touched = given.tries > 0 || given.hints > 0 || given.reached || scene.is_some();
        let outcome = if touched { Outcome::Wrong } else { Outcome::Open };
        let (tries, hints, solution_shown) = (given.tries, given.hints, given.solution_shown);
        let missed = Mark { outcome, points: 0.0, tries, hints, solution_shown };
        let (Some(scene), Some(start)) = (scene, model.start(place.step)) else {
            remarks.extend(given.reached.then_some(Remark::NoScene(place)));
            return missed;
        };
        let Some(opened) = (Scene { link: scene.clone(), line: task.line }).open(self.aircraft) else {
            return missed;
        };
        let now = Findings::of(opened.scenario);
        let problem = match task.unfit(start, &now) {
            Some(Unfit::NotOffered(keys)) => Some(self.not_offered(model, place, keys, &now)),
            Some(unfit) => Some(Remark::Unfit(place, unfit)),
            None => {
                let convention = now.scenario().convention();
                let progress = progress(task, start, &now, self.aircraft);
                let missed = task.until.iter().zip(&progress).find(|(_, progress)| !progress.met);
                missed.map(|(condition, progress)| {
                    let measure = condition.measure;
                    let found = match &progress.now {
                        Ok(reading) => {
                            format!("is {}", words::measure::reading(measure, *reading, convention))
                        }
                        Err(absence) => {
                            format!("can’t be read, {}", words::measure::absence(absence, convention.length))
                        }
                    };
                    let wanted = said::wanted(measure, &condition.wanted, progress, convention);
                    Remark::NotMet(place, [words::measure::name(measure), found, wanted])
                })
            }
        };
        // Only what is reached, or said to be, is to be told; a try is a try.
        if given.reached || problem.is_none() {
            remarks.extend(opened.notices.first().map(|notice| Remark::Link(place, notice.to_string())));
            remarks.extend(problem.clone());
        }
        if problem.is_some() {
            return missed;
        }
        let given = Given { reached: true, ..given.clone() };
        let points = if task.is_earned(&given) { task.points.unwrap_or(1.0) } else { 0.0 };
        Mark { outcome: Outcome::Right, points, ..missed }
    }

    /// What is to be told of a scene with other numbers than it may have: of varied ones, that they are another's.
    fn not_offered(&self, model: &Model, place: Place, keys: Vec<&'static str>, now: &Findings) -> Remark {
        let step = model.lesson.steps.get(place.step);
        let vary = step.and_then(|step| step.vary.iter().find(|vary| keys.contains(&vary.parameter.key)));
        let (Some(step), Some(vary)) = (step, vary) else {
            return Remark::Unfit(place, Unfit::NotOffered(keys));
        };
        let of = |text: String| text.split_once('=').map(|(_, number)| number.to_owned());
        let own = varied::numbers(step)
            .into_iter()
            .find(|said| said.starts_with(&format!("{}=", vary.parameter.key)));
        let unit = vary.parameter.dimension.in_si(crate::content::LengthUnit::Metre);
        let found = crate::number::trimmed(vary.parameter.get(now.scenario()) / unit, 6);
        let own = own.and_then(of).unwrap_or_default().replace('-', "−");
        Remark::OtherStart(place, [format!("{} = {found}", vary.parameter.key), own])
    }
}

/// What was done to a task.
struct TaskWork<'w> {
    place: Place,
    task: &'w Task,
    given: &'w Given,
    scene: Option<&'w String>,
}

fn question(
    prediction: &Prediction,
    given: &Given,
    truth: Option<&Truth>,
    place: Place,
    remarks: &mut Vec<Remark>,
) -> Mark {
    let earlier = u32::try_from(given.earlier.len()).unwrap_or(u32::MAX);
    let outcome = if earlier > 0 { Outcome::Wrong } else { Outcome::Open };
    let mark = Mark { outcome, tries: earlier, ..Mark::default() };
    let (Some(answer), Some(truth)) = (given.final_answer(), truth) else { return mark };
    let mark = Mark { outcome: Outcome::Wrong, tries: earlier.saturating_add(1), ..mark };
    if mark.tries > prediction.tries {
        remarks.push(Remark::TooManyAnswers(place));
        return mark;
    }
    if truth.compare(&prediction.kind, answer).is_right() {
        Mark { outcome: Outcome::Right, points: prediction.points.unwrap_or(1.0), ..mark }
    } else {
        mark
    }
}

/// How far a record has come: what is answered for good or reached, and what was given at all.
fn progress_of(record: &Record) -> (usize, usize) {
    let given = || record.answers.iter().map(|(_, given)| given);
    (given().filter(|given| given.is_final || given.reached).count(), given().count())
}

/// Whether a name that a person has typed is that of the row: each of its words is one of the row's, or they are the same but for
/// their spaces.
fn is_name_of(row: &str, typed: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        text.split(|c: char| !c.is_alphanumeric()).map(normalised).filter(|word| !word.is_empty()).collect()
    };
    let (row, typed) = (words(row), words(typed));
    let joined = typed.concat();
    // A run of words of the row, as they stand in an address or the name of a file.
    let is_run = (0..row.len()).any(|from| (from..row.len()).any(|to| row[from..=to].concat() == joined));
    is_run || typed.iter().all(|word| row.contains(word))
}
