//! The lesson of one person, where numbers are varied: the same lesson with other links, so that whatever follows from a link follows
//! from their numbers: the numbers in the text, what the model says, the start of a goal.
//!
//! The scene of the step has the number. So have its solutions, its scenes `after`, the links in its text and those `at` which
//! numbers are measured, where they are of the same aircraft and say no other number than the scene. `same_as` and the things
//! of an order stay what they say.

use super::file::Lesson;
use super::prediction::Prediction;
use super::scene::Scene;
use super::step::{Part, Step};
use super::text::{Target, Text, What};
use super::vary::Vary;

impl Lesson {
    /// Whether any of its steps has a number of each person's own.
    pub fn varies(&self) -> bool {
        self.steps.iter().any(|step| !step.vary.is_empty())
    }

    /// Whether it is made to be handed in: something in it is worth points, or numbers are varied.
    pub fn is_homework(&self) -> bool {
        let is_worth = |part: &Part| match part {
            Part::Prediction(prediction) => prediction.points.is_some(),
            Part::Task(task) => task.points.is_some() || task.unaided,
            Part::Text(_) | Part::Reveal(_) | Part::Write(_) | Part::Notes(_) => false,
        };
        self.varies() || self.steps.iter().flat_map(|step| &step.parts).any(is_worth)
    }

    /// All points that there are.
    pub fn points(&self) -> f64 {
        self.steps.iter().flat_map(|step| &step.parts).filter_map(Part::points).sum()
    }

    /// The lesson with the numbers of a person.
    pub fn of_person(&self, person: &str) -> Self {
        self.with_numbers(|vary| vary.number_of(person))
    }

    /// The lesson with numbers at a share, from 0 to 1, of the way from the least to the greatest, as `share` says of each number.
    pub fn at_shares(&self, share: impl Fn(&Vary) -> f64) -> Self {
        self.with_numbers(|vary| vary.number_at(share(vary)))
    }

    fn with_numbers(&self, number: impl Fn(&Vary) -> String) -> Self {
        let mut lesson = self.clone();
        for step in lesson.steps.iter_mut().filter(|step| !step.vary.is_empty()) {
            let numbers = step.vary.iter().map(|vary| (vary.parameter.key, number(vary))).collect();
            Numbers { scene: step.scene.link.clone(), numbers }.set(step);
        }
        lesson
    }
}

/// The varied numbers of a step, and the link of its scene as the file has it.
struct Numbers {
    scene: String,
    numbers: Vec<(&'static str, String)>,
}

impl Numbers {
    fn set(&self, step: &mut Step) {
        step.scene.link = self.in_link(&step.scene.link);
        for part in &mut step.parts {
            match part {
                Part::Text(text) | Part::Reveal(text) => self.in_text(text),
                Part::Prediction(prediction) => self.in_prediction(prediction),
                Part::Task(task) => {
                    self.in_scene(task.solution.as_mut());
                    self.in_text(&mut task.goal);
                    task.hints.iter_mut().for_each(|hint| self.in_text(hint));
                }
                Part::Write(writing) => self.in_text(&mut writing.ask),
                Part::Notes(notes) => self.in_text(&mut notes.text),
            }
        }
    }

    fn in_prediction(&self, prediction: &mut Prediction) {
        self.in_scene(prediction.after.as_mut());
        prediction.texts_mut().into_iter().for_each(|text| self.in_text(text));
    }

    fn in_text(&self, text: &mut Text) {
        for span in text.spans_mut() {
            if let Some(Target::Scene(link)) = &mut span.target {
                *link = self.in_link(link);
            }
            if let What::Number(number) = &mut span.what {
                self.in_scene(number.at.as_mut());
            }
        }
    }

    fn in_scene(&self, scene: Option<&mut Scene>) {
        if let Some(scene) = scene {
            scene.link = self.in_link(&scene.link);
        }
    }

    /// A link with the numbers; one of another aircraft as it is.
    fn in_link(&self, link: &str) -> String {
        if word(link, "ac") != word(&self.scene, "ac") {
            return link.to_owned();
        }
        let mut link = link.to_owned();
        for (key, number) in &self.numbers {
            let added = format!("add.{key}");
            let says_as_scene = |key: &str| word(&link, key) == word(&self.scene, key);
            if says_as_scene(key) && says_as_scene(&added) {
                link = with_word(&without(&without(&link, key), &added), key, number);
            }
        }
        link
    }
}

/// The varied numbers of a step as its link says them: `cm_alpha=-0.61`.
pub(super) fn numbers(step: &Step) -> Vec<String> {
    let said = |vary: &Vary| {
        let key = vary.parameter.key;
        Some(format!("{key}={}", word(&step.scene.link, key)?))
    };
    step.vary.iter().filter_map(said).collect()
}

/// The pieces of a link, as they stand between its `&`.
fn pieces(link: &str) -> impl Iterator<Item = &str> {
    let link = link.trim();
    let pieces = link.split_once('#').map_or(link, |(_, pieces)| pieces);
    pieces
        .split('&')
        .map(|piece| piece.strip_prefix("amp;").unwrap_or(piece))
        .filter(|piece| !piece.is_empty())
}

/// What a link says of a key.
fn word<'l>(link: &'l str, key: &str) -> Option<&'l str> {
    pieces(link)
        .filter_map(|piece| piece.split_once('='))
        .find(|(name, _)| *name == key)
        .map(|(_, word)| word)
}

fn without(link: &str, key: &str) -> String {
    let is_other = |piece: &&str| piece.split_once('=').is_none_or(|(name, _)| name != key);
    format!("#{}", pieces(link).filter(is_other).collect::<Vec<_>>().join("&"))
}

fn with_word(link: &str, key: &str, word: &str) -> String {
    format!("{link}&{key}={word}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_has_the_number_in_place_of_that_of_the_scene() {
        let numbers = Numbers {
            scene: "#v=1&ac=navion&cm_alpha=-0.7".to_owned(),
            numbers: vec![("cm_alpha", "-0.61".to_owned())],
        };
        for (link, varied) in [
            ("#v=1&ac=navion&cm_alpha=-0.7&cg=10", "#v=1&ac=navion&cg=10&cm_alpha=-0.61"),
            ("#v=1&ac=navion&cm_alpha=-2", "#v=1&ac=navion&cm_alpha=-2"),
            ("#v=1&ac=navion", "#v=1&ac=navion"),
            ("#v=1&ac=x15&cm_alpha=-0.7", "#v=1&ac=x15&cm_alpha=-0.7"),
        ] {
            assert_eq!(numbers.in_link(link), varied);
        }
    }
}
