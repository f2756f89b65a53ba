//! What whoever presents reads in a window of their own: the notes of the slide, what comes next, how many hands were counted.

use std::sync::Arc;

use serde::Serialize;

use super::{Asked, Presentation};
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::lesson::{Kind, Prediction, Step, Text, TextBlock};

/// What the notes of a lecture show, as plain text. `web/notes.js` reads it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cue {
    /// The slide on screen, counted from 1.
    pub slide: usize,
    /// How many slides there are.
    pub slides: usize,
    /// Heading of the slide.
    pub title: String,
    /// How many of its questions have been answered for the room, and how many there are.
    pub revealed: [usize; 2],
    /// Whether the screen is black.
    pub blank: bool,
    /// The notes of the slide.
    pub notes: Vec<Line>,
    /// The question that it is at.
    pub question: Option<String>,
    /// Hands that were counted for each choice of it.
    pub hands: Vec<Hand>,
    /// The next slide.
    pub next: Option<Next>,
    /// How long the slide is to take \[min\].
    pub minutes: Option<f64>,
    /// When it is to be over, since the start of the lecture \[min\].
    pub until: Option<f64>,
    /// How long the lecture is to take \[min\].
    pub total: Option<f64>,
}

/// A paragraph of notes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Line {
    /// `heading`, `paragraph`, `quote`, `code`, or `item` of a list.
    pub kind: &'static str,
    /// How many lists it stands in; 0 outside.
    pub depth: usize,
    /// What stands before an item: its number, or a dot.
    pub mark: String,
    /// Its words.
    pub text: String,
}

/// Hands for a choice.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Hand {
    /// What the choice says.
    pub says: String,
    /// How many hands.
    pub count: u32,
    /// Whether it is right; the room isn't told.
    pub right: bool,
}

/// The next slide.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Next {
    /// Its heading.
    pub title: String,
    /// Its first question.
    pub question: Option<String>,
}

impl Cue {
    /// Of a slide of a lesson. `start` is what follows from its scene.
    pub fn of(
        lecture: &Presentation,
        steps: &[Step],
        start: &Findings,
        aircraft: &[Arc<Aircraft>],
    ) -> Option<Self> {
        let step = steps.get(lecture.slide)?;
        let asked = Asked::of(step, lecture.revealed());
        let question = asked.and_then(|asked| step.predictions().nth(asked.question));
        let counted = lecture.hands(asked.map_or(0, |asked| asked.question));
        let next = steps.get(lecture.slide + 1).map(|next| Next {
            title: next.title.clone(),
            // Its numbers are those of another scene.
            question: next.predictions().next().map(|prediction| prediction.ask.plain()),
        });
        let minutes =
            |steps: &[Step]| steps.iter().filter_map(Step::minutes).reduce(|sum: f64, minutes| sum + minutes);
        Some(Self {
            slide: lecture.slide + 1,
            slides: lecture.count,
            title: step.title.clone(),
            revealed: [lecture.revealed(), step.predictions().count()],
            blank: lecture.is_blank,
            notes: step
                .notes()
                .flat_map(|notes| &notes.text.blocks)
                .map(|block| line(block, start, aircraft))
                .collect(),
            question: question.map(|prediction| prediction.ask.plain_at(start, aircraft)),
            hands: question.map_or_else(Vec::new, |prediction| hands(prediction, counted)),
            next,
            minutes: step.minutes(),
            until: step.minutes().and_then(|_| minutes(&steps[..=lecture.slide])),
            total: minutes(steps),
        })
    }

    /// Of a scene that is shown alone.
    pub fn alone(title: &str, lecture: &Presentation) -> Self {
        Self {
            slide: 1,
            slides: 1,
            title: title.to_owned(),
            revealed: [lecture.revealed(), 0],
            blank: lecture.is_blank,
            notes: Vec::new(),
            question: None,
            hands: Vec::new(),
            next: None,
            minutes: None,
            until: None,
            total: None,
        }
    }
}

fn hands(prediction: &Prediction, counted: &[u32]) -> Vec<Hand> {
    let Kind::Choose { choices, .. } = &prediction.kind else { return Vec::new() };
    choices
        .iter()
        .enumerate()
        .map(|(place, choice)| Hand {
            says: choice.says.plain(),
            count: counted.get(place).copied().unwrap_or_default(),
            right: choice.right,
        })
        .collect()
}

/// A block of notes, numbers measured at the slide's scene.
fn line(block: &TextBlock, start: &Findings, aircraft: &[Arc<Aircraft>]) -> Line {
    let plain = |block: &TextBlock| Text { blocks: vec![block.clone()] }.plain_at(start, aircraft);
    let (kind, depth, mark, text) = match block {
        TextBlock::Heading(_) => ("heading", 0, String::new(), plain(block)),
        TextBlock::Paragraph(_) => ("paragraph", 0, String::new(), plain(block)),
        TextBlock::Quote(_) => ("quote", 0, String::new(), plain(block)),
        TextBlock::Item { depth, number, begins, .. } => {
            let mark = match number {
                Some(number) => format!("{number}."),
                None if *begins => "•".to_owned(),
                None => String::new(),
            };
            ("item", *depth, mark, plain(block))
        }
        TextBlock::Code(code) => ("code", 0, String::new(), code.clone()),
        TextBlock::Formula(formula) => ("code", 0, String::new(), formula.line()),
        TextBlock::Table(rows) => {
            let row = |cells: &Vec<Vec<_>>| {
                let cells = cells.iter().map(|cell| plain(&TextBlock::Paragraph(cell.clone())));
                cells.collect::<Vec<_>>().join(" | ")
            };
            ("code", 0, String::new(), rows.iter().map(row).collect::<Vec<_>>().join("\n"))
        }
    };
    Line { kind, depth, mark, text }
}
