//! The reader of a question: the fenced block `predict`.

use super::number::{measure, unknown};
use super::prediction::{Choice, Item, Kind, Prediction};
use super::scene::Scene;
use super::text::Text;
use crate::content::ContentError;
use crate::content::reader::Block;
use crate::findings::measures::Measure;
use crate::flight::modes::mode_name::ModeName;
use crate::flight::motion::outputs::Output;
use crate::key::Keyed;

/// The kinds of questions, by the word of the file.
#[derive(Clone, Copy)]
enum Word {
    Choose,
    Estimate,
    Place,
    Sketch,
    Order,
}

const WORDS: [(&str, Word); 5] = [
    ("choose", Word::Choose),
    ("estimate", Word::Estimate),
    ("place", Word::Place),
    ("sketch", Word::Sketch),
    ("order", Word::Order),
];

/// Reads a question.
pub(super) fn read(file: &str, line: usize, block: &mut Block<'_>) -> Result<Prediction, ContentError> {
    let word = block.choice("kind", &WORDS)?;
    let ask = text(file, block, "ask")?;
    let after = scene(block, "after")?;
    let kind = match word {
        Word::Choose => {
            let several = block.optional_flag("several")?.unwrap_or(false);
            let choices = block.blocks("choice")?.into_iter().map(|choice| read_choice(file, choice));
            Kind::Choose { choices: choices.collect::<Result<_, _>>()?, several }
        }
        Word::Estimate => Kind::Estimate {
            measure: measure_of(block)?,
            wrong_way: text(file, block, "wrong_way")?,
            far: text(file, block, "far")?,
        },
        Word::Place => Kind::Place {
            mode: keyed::<ModeName>(block, "mode", "mode")?,
            wrong_side: text(file, block, "wrong_side")?,
            far: text(file, block, "far")?,
        },
        Word::Sketch => Kind::Sketch {
            output: keyed::<Output>(block, "output", "output")?,
            first: text(file, block, "first")?,
            oscillates: text(file, block, "oscillates")?,
            ends: text(file, block, "ends")?,
        },
        Word::Order => {
            let items = block.blocks("item")?.into_iter().map(|item| read_item(file, item));
            Kind::Order {
                items: items.collect::<Result<_, _>>()?,
                measure: measure_of(block)?,
                because: text(file, block, "because")?,
            }
        }
    };
    let tries = count(block, "tries")?.unwrap_or(1);
    let points = points(block)?;
    block.finish()?;
    Ok(Prediction { ask, kind, after, tries, points, line })
}

fn read_choice(file: &str, mut block: Block<'_>) -> Result<Choice, ContentError> {
    let choice = Choice {
        says: text(file, &mut block, "says")?,
        right: block.optional_flag("right")?.unwrap_or(false),
        because: optional_text(file, &mut block, "because")?,
        line: block.line("says"),
    };
    block.finish()?;
    Ok(choice)
}

fn read_item(file: &str, mut block: Block<'_>) -> Result<Item, ContentError> {
    let says = text(file, &mut block, "says")?;
    let scene = Scene { link: block.text("link")?, line: block.line("link") };
    block.finish()?;
    Ok(Item { says, scene })
}

/// A whole number from 1 on.
pub(super) fn count<'t>(block: &mut Block<'t>, key: &'t str) -> Result<Option<u32>, ContentError> {
    match block.optional_positive(key)? {
        Some(number) if number.fract() == 0.0 && number <= f64::from(u16::MAX) => Ok(Some(number as u32)),
        Some(number) => Err(block.error(key, format_args!("expected a whole number, found {number}"))),
        None => Ok(None),
    }
}

/// What the part is worth: zero or more.
pub(super) fn points(block: &mut Block<'_>) -> Result<Option<f64>, ContentError> {
    match block.optional_number("points")? {
        Some(points) if points < 0.0 => {
            Err(block.error("points", format_args!("expected a number of points, found {points}")))
        }
        points => Ok(points),
    }
}

/// Markdown in a field.
pub(super) fn text(file: &str, block: &mut Block<'_>, key: &'static str) -> Result<Text, ContentError> {
    let markdown = block.text(key)?;
    Text::read(file, block.line(key), &markdown)
}

fn optional_text(file: &str, block: &mut Block<'_>, key: &'static str) -> Result<Option<Text>, ContentError> {
    let markdown = block.optional_text(key)?;
    markdown.map(|markdown| Text::read(file, block.line(key), &markdown)).transpose()
}

/// A link in a field.
pub(super) fn scene(block: &mut Block<'_>, key: &'static str) -> Result<Option<Scene>, ContentError> {
    Ok(block.optional_text(key)?.map(|link| Scene { link, line: block.line(key) }))
}

/// The measure of the field `measure`.
pub(super) fn measure_of(block: &mut Block<'_>) -> Result<Measure, ContentError> {
    let key = block.text("measure")?;
    measure(&key).map_err(|problem| block.error("measure", problem))
}

fn keyed<T: Keyed>(block: &mut Block<'_>, key: &'static str, kind: &str) -> Result<T, ContentError> {
    let word = block.text(key)?;
    let names = || T::VALUES.iter().map(|value| value.key());
    T::by_key(&word).ok_or_else(|| block.error(key, unknown(kind, &word, names())))
}
