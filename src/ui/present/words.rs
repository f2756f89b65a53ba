//! What is written on a slide: its text, its question with lettered choices, and once that is answered what was right and why.

use super::{MOST_CHOICES, Presentation};
use crate::lesson::{Kind, Part, Step, Text, TextBlock};

/// A piece of what is written, from top to bottom.
#[derive(Clone, Debug)]
pub enum Piece<'a> {
    /// A block of text.
    Block(&'a TextBlock, Tone),
    /// A sentence of the page.
    Sentence(String, Tone),
    /// A choice.
    Choice(Choice<'a>),
    /// Hands that were counted where there are no choices.
    Hands(usize, Hands),
}

/// How it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// What is asked.
    Question,
    /// Running text.
    Plain,
    /// What the model says.
    Answer,
}

/// A choice of a question.
#[derive(Clone, Debug)]
pub struct Choice<'a> {
    /// Its place, from 0: A, B, C …
    pub number: usize,
    /// What it says.
    pub says: &'a Text,
    /// Whether it is right, once that is told.
    pub is_right: Option<bool>,
    /// Why it is wrong, where that is asked for.
    pub because: Option<&'a Text>,
    /// Hands for it.
    pub hands: Hands,
}

/// Hands for a choice, of the most that any choice has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Hands {
    /// For this one.
    pub count: u32,
    /// Of all choices together.
    pub of: u32,
}

/// The question that a slide is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked {
    /// Which of its questions, from 0.
    pub question: usize,
    /// Whether it has been answered for the room.
    pub is_answered: bool,
}

impl Asked {
    /// The question that a slide is at, of which so many have been answered; none on a slide that asks nothing.
    pub fn of(step: &Step, revealed: usize) -> Option<Self> {
        let last = step.predictions().count().checked_sub(1)?;
        Some(Self { question: revealed.min(last), is_answered: revealed > last })
    }
}

/// What the model says to the question of a slide, and whether the goals of its tasks are met.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Told {
    /// The answer in words.
    pub truth: Option<String>,
    /// Of each task whether its goal is met.
    pub met: Vec<bool>,
}

/// How much of a slide is written: where there is little room, less rather than smaller.
pub const LEVELS: usize = 3;

/// What is written on a slide.
///
/// `asked` is the question that it is at, as it stands or as if it had been answered.
pub fn pieces<'a>(
    step: &'a Step,
    lecture: &Presentation,
    (asked, told): (Option<Asked>, &Told),
    level: usize,
) -> Vec<Piece<'a>> {
    let (from, to) = range(step, asked);
    let mut pieces = Vec::new();
    let mut tasks = step.parts[..from].iter().filter(|part| matches!(part, Part::Task(_))).count();
    let mut is_asked = asked.is_none();
    for part in &step.parts[from..to] {
        match part {
            // What leads to the question goes first, then whatever is no answer.
            Part::Text(_) if level > 0 && !is_asked => {}
            Part::Text(text) if level < 2 => blocks(&mut pieces, text, Tone::Plain),
            Part::Text(_) => {}
            Part::Prediction(prediction) => {
                is_asked = true;
                blocks(&mut pieces, &prediction.ask, Tone::Question);
                if let Some(asked) = asked {
                    choices(&mut pieces, &prediction.kind, lecture, asked);
                    if let Some(truth) = told.truth.as_ref().filter(|_| asked.is_answered) {
                        pieces.push(Piece::Sentence(truth.clone(), Tone::Answer));
                    }
                }
            }
            Part::Reveal(text) => blocks(&mut pieces, text, Tone::Plain),
            Part::Task(task) => {
                blocks(&mut pieces, &task.goal, Tone::Question);
                if told.met.get(tasks) == Some(&true) {
                    pieces.push(Piece::Sentence("✓ The goal is reached".to_owned(), Tone::Answer));
                }
                tasks += 1;
            }
            Part::Write(writing) => blocks(&mut pieces, &writing.ask, Tone::Question),
            Part::Notes(_) => {}
        }
    }
    if asked.is_none() {
        counted(&mut pieces, lecture.hands(0));
    }
    pieces
}

/// The parts of a slide that are on screen: from behind the question before up to the one that waits, or to the end.
fn range(step: &Step, asked: Option<Asked>) -> (usize, usize) {
    let Some(Asked { question, is_answered }) = asked else { return (0, step.parts.len()) };
    let is_question = |(_, part): &(usize, &Part)| matches!(part, Part::Prediction(_));
    let places: Vec<usize> = step.parts.iter().enumerate().filter(is_question).map(|(at, _)| at).collect();
    let from = question.checked_sub(1).and_then(|before| places.get(before)).map_or(0, |at| at + 1);
    let to = places.get(question).map_or(step.parts.len(), |at| at + 1);
    (from, if is_answered { step.parts.len() } else { to })
}

fn blocks<'a>(pieces: &mut Vec<Piece<'a>>, text: &'a Text, tone: Tone) {
    pieces.extend(text.blocks.iter().map(|block| Piece::Block(block, tone)));
}

fn choices<'a>(pieces: &mut Vec<Piece<'a>>, kind: &'a Kind, lecture: &Presentation, asked: Asked) {
    let counted_hands = lecture.hands(asked.question);
    let of = counted_hands.iter().sum();
    let hands = |number: usize| Hands { count: counted_hands.get(number).copied().unwrap_or(0), of };
    match kind {
        Kind::Choose { choices, .. } => {
            let reasons = lecture.current().map(|slide| &slide.reasons);
            let tells =
                |number: usize| asked.is_answered && reasons.is_some_and(|reasons| reasons.contains(&number));
            pieces.extend(choices.iter().enumerate().take(MOST_CHOICES).map(|(number, choice)| {
                Piece::Choice(Choice {
                    number,
                    says: &choice.says,
                    is_right: asked.is_answered.then_some(choice.right),
                    because: choice.because.as_ref().filter(|_| tells(number)),
                    hands: hands(number),
                })
            }));
        }
        Kind::Order { items, .. } => {
            pieces.extend(items.iter().enumerate().take(MOST_CHOICES).map(|(number, item)| {
                let (says, hands) = (&item.says, hands(number));
                Piece::Choice(Choice { number, says, is_right: None, because: None, hands })
            }));
        }
        Kind::Estimate { .. } | Kind::Place { .. } | Kind::Sketch { .. } => counted(pieces, counted_hands),
    }
}

/// Hands for what is asked aloud.
fn counted(pieces: &mut Vec<Piece<'_>>, hands: &[u32]) {
    let of = hands.iter().sum();
    let each = hands.iter().enumerate();
    pieces.extend(each.map(|(number, &count)| Piece::Hands(number, Hands { count, of })));
}
