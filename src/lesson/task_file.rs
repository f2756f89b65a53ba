//! The reader of a task: the fenced block `task`.

use super::number::unknown;
use super::prediction_file::{count, measure_of, points, scene, text};
use super::scene::Scene;
use super::task::{Amount, Condition, SolutionAfter, Task, Wanted};
use super::text::Text;
use crate::content::reader::Block;
use crate::content::{ContentError, LengthUnit};
use crate::findings::measures::Measure;
use crate::flight::modes::stability::Stability;
use crate::flight::verdicts::handling_qualities::Level;
use crate::key::Keyed;
use crate::scenario::{Parameter, parameters};

/// The words of a condition, one of which it has.
const WORDS: [&str; 5] = ["at_least", "at_most", "within", "is", "same_as"];

/// Tries before the solution where the file says nothing.
const TRIES: u32 = 3;

/// How near counts as the same.
const SAME: f64 = 0.01;

/// Reads a task.
pub(super) fn read(file: &str, line: usize, block: &mut Block<'_>) -> Result<Task, ContentError> {
    let goal = text(file, block, "goal")?;
    let offer = block
        .texts("offer")?
        .iter()
        .map(|key| {
            let keys = || parameters().map(|parameter| parameter.key);
            Parameter::find(key).ok_or_else(|| block.error("offer", unknown("parameter", key, keys())))
        })
        .collect::<Result<_, _>>()?;
    let changes = count(block, "changes_at_most")?.map(|most| most as usize);
    let points = points(block)?;
    let unaided = block.optional_flag("unaided")?.unwrap_or(false);
    let solution_after = solution_after(block)?;
    let line_of_hints = block.line("hints");
    let hints = block.texts("hints")?;
    let hints = hints.iter().map(|hint| Text::read(file, line_of_hints, hint)).collect::<Result<_, _>>()?;
    let solution = scene(block, "solution")?;
    let until: Vec<Condition> =
        block.blocks("until")?.into_iter().map(condition).collect::<Result<_, _>>()?;
    if until.is_empty() {
        return Err(block.error("until", "missing; expected at least one condition, [[until]]"));
    }
    block.finish()?;
    Ok(Task { goal, offer, changes, points, unaided, solution_after, hints, solution, until, line })
}

fn solution_after(block: &mut Block<'_>) -> Result<SolutionAfter, ContentError> {
    let (key, expected) = ("solution_after", "a number of tries or \"never\"");
    let Some(word) = block.optional_number_or_text(key, expected)? else {
        return Ok(SolutionAfter::Tries(TRIES));
    };
    if word == "never" {
        return Ok(SolutionAfter::Never);
    }
    let tries = word.parse().map(SolutionAfter::Tries);
    tries.map_err(|_| block.error(key, format_args!("expected {expected}, found \"{word}\"")))
}

fn condition(mut block: Block<'_>) -> Result<Condition, ContentError> {
    let line = block.line("measure");
    let measure = measure_of(&mut block)?;
    let said: Vec<&str> = WORDS.into_iter().filter(|word| block.has(word)).collect();
    let wanted = match said[..] {
        ["at_least"] => Wanted::AtLeast(amount(&mut block, "at_least", measure)?),
        ["at_most"] => Wanted::AtMost(amount(&mut block, "at_most", measure)?),
        ["within"] => within(&mut block, measure)?,
        ["same_as"] => {
            let scene = Scene { link: block.text("same_as")?, line: block.line("same_as") };
            Wanted::SameAs(SAME, scene)
        }
        [_] => is(&mut block)?,
        [] => {
            let expected = format!("expected one of {}", WORDS.join(", "));
            // A misspelt word is told as such.
            let known = ["measure"].into_iter().chain(WORDS);
            let stranger = block.names().into_iter().find(|name| !known.clone().any(|word| word == *name));
            return Err(match stranger {
                Some(name) => block.error(name, unknown("condition", name, WORDS.into_iter())),
                None => block.error_here(expected),
            });
        }
        [_, second, ..] => {
            let problem = format!("a condition says one thing; expected another [[until]] for {second}");
            return Err(block.error(second, problem));
        }
    };
    block.finish()?;
    Ok(Condition { measure, wanted, line })
}

const AMOUNT: &str = "a number, \"start\" or a multiple of it such as \"2 × start\"";

fn amount(block: &mut Block<'_>, key: &'static str, measure: Measure) -> Result<Amount, ContentError> {
    match block.optional_number_or_text(key, AMOUNT)? {
        Some(text) => {
            let wrong = || block.error(key, format_args!("expected {AMOUNT}, found \"{text}\""));
            read_amount(&text, measure).ok_or_else(wrong)
        }
        None => Err(block.error(key, format_args!("missing; expected {AMOUNT}"))),
    }
}

/// Numbers are in the unit that the page shows, with lengths in metres, as in links.
fn read_amount(text: &str, measure: Measure) -> Option<Amount> {
    if let Some(times) = text.trim().strip_suffix("start") {
        let times = times.trim();
        let Some(number) = times.strip_suffix(['×', '*', 'x']) else {
            return times.is_empty().then_some(Amount::TimesStart(1.0));
        };
        return finite(number).map(Amount::TimesStart);
    }
    Some(Amount::Number(finite(text)? * measure.dimension().in_si(LengthUnit::Metre)))
}

fn finite(text: &str) -> Option<f64> {
    text.trim().replace('−', "-").parse().ok().filter(|number: &f64| number.is_finite())
}

fn within(block: &mut Block<'_>, measure: Measure) -> Result<Wanted, ContentError> {
    let (key, expected) = ("within", "a share of a number or of the start, such as \"5 % of start\"");
    let text = block.text(key)?;
    let read = || {
        let (share, of) = text.split_once("of")?;
        let share = finite(share.trim().strip_suffix('%')?).filter(|share| *share > 0.0)?;
        Some(Wanted::Within(share / 100.0, read_amount(of, measure)?))
    };
    read().ok_or_else(|| block.error(key, format_args!("expected {expected}, found \"{text}\"")))
}

/// The word for nothing to read.
const ABSENT: &str = "absent";

fn is(block: &mut Block<'_>) -> Result<Wanted, ContentError> {
    let word = block.text("is")?;
    let stability = Stability::by_key(&word).map(Wanted::Stability);
    let level = || Level::by_key(&word).map(Wanted::Level);
    let absent = || (word == ABSENT).then_some(Wanted::Absent);
    let wanted = stability.or_else(level).or_else(absent);
    wanted.ok_or_else(|| {
        let keys = Stability::VALUES.iter().map(|value| value.key());
        let keys = keys.chain(Level::VALUES.iter().map(|value| value.key())).chain([ABSENT]);
        block.error("is", unknown("verdict", &word, keys))
    })
}
