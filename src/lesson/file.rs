//! The reader of a lesson: front matter, steps headed by `##`, and fenced blocks.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Parser, Tag, TagEnd};

use super::scene::Scene;
use super::step::{Part, Step};
use super::text::{BLOCKS, NOTES, OPTIONS, Text};
use super::vary::{self, Vary};
use super::{notes, prediction_file, task_file, writing};
use crate::content::ContentError;
use crate::content::reader::{Block, line_of, with_file};

/// A lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// Name of its file, for messages.
    pub file: String,
    /// Its title.
    pub title: String,
    /// What it is about, in a sentence.
    pub about: Option<String>,
    /// Language of its text.
    pub language: String,
    /// Keys of the lessons that come before it.
    pub needs: Vec<String>,
    /// Keys of the references that it rests on.
    pub references: Vec<String>,
    /// Whether it is made to be presented to a room.
    pub lecture: bool,
    /// Its steps, at least one.
    pub steps: Vec<Step>,
    /// A word that is another for every other text of the file.
    pub version: String,
}

/// The line around the front matter.
const FENCE: &str = "+++";

impl Lesson {
    /// Reads a lesson; `file` is the name in messages.
    pub fn read(file: &str, text: &str) -> Result<Self, ContentError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (front, body) = front_matter(file, text)?;
        let mut lesson = with_block(file, text, front, |block| {
            let lesson = Self {
                file: file.to_owned(),
                title: block.text("title")?,
                about: block.optional_text("about")?,
                language: block.optional_text("language")?.unwrap_or_else(|| "en".to_owned()),
                needs: block.texts("needs")?,
                references: block.texts("references")?,
                lecture: block.optional_flag("lecture")?.unwrap_or_default(),
                steps: Vec::new(),
                version: version(text),
            };
            block.finish()?;
            Ok(lesson)
        })?;
        lesson.steps = steps(file, text, body)?;
        Ok(lesson)
    }

    /// Its key: the name of its file without folder and ending.
    pub fn key(&self) -> &str {
        let name = self.file.rsplit(['/', '\\']).next().unwrap_or_default();
        name.strip_suffix(".md").unwrap_or(name)
    }

    /// How long it is to take \[min\], where its notes say so.
    pub fn minutes(&self) -> Option<f64> {
        self.steps.iter().filter_map(Step::minutes).reduce(|sum, minutes| sum + minutes)
    }
}

/// Of the text of a lesson, whatever its lines end with.
fn version(text: &str) -> String {
    format!("{:016x}", vary::hash(&text.replace("\r\n", "\n")))
}

fn error(file: &str, line: usize, problem: impl Into<String>) -> ContentError {
    ContentError { file: file.to_owned(), line, problem: problem.into() }
}

/// The front matter, and where the rest begins.
fn front_matter<'t>(file: &str, text: &'t str) -> Result<(Range<usize>, usize), ContentError> {
    let mut lines = text.split_inclusive('\n').scan(0, |at, line: &'t str| {
        let start = *at;
        *at += line.len();
        Some((start, line))
    });
    let first = lines.next().filter(|(_, line)| line.trim_end() == FENCE);
    let Some((_, first)) = first else {
        return Err(error(file, 1, "expected front matter, which begins with a line +++"));
    };
    match lines.find(|(_, line)| line.trim_end() == FENCE) {
        Some((end, line)) => Ok((first.len()..end, end + line.len())),
        None => Err(error(file, 1, "expected a second line +++, which ends the front matter")),
    }
}

/// Reads a part of the file as TOML, so that errors name its lines.
fn with_block<T>(
    file: &str,
    text: &str,
    part: Range<usize>,
    read: impl FnOnce(&mut Block<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    let first = line_of(text, part.start);
    let before = "\n".repeat(first - 1);
    // What is missing is missed at the fence, which is the line before.
    with_file(file, &format!("{before}{}", &text[part]), read)
        .map_err(|error| ContentError { line: error.line.max(first - 1), ..error })
}

/// A piece of the file on its own level.
enum Piece {
    Heading(HeadingLevel),
    /// A fenced block by its word, what follows the word, and what is inside.
    Block(&'static str, String, Range<usize>),
    Text,
}

/// The pieces with the ranges of the file that they take.
fn pieces(text: &str, body: usize) -> Vec<(Piece, Range<usize>)> {
    let mut pieces = Vec::new();
    let mut depth = 0_usize;
    let mut inside: Option<Range<usize>> = None;
    for (event, range) in Parser::new_ext(&text[body..], OPTIONS).into_offset_iter() {
        let range = range.start + body..range.end + body;
        match event {
            Event::Start(tag) => {
                if depth == 0 {
                    let piece = match tag {
                        Tag::Heading { level, .. } if level <= HeadingLevel::H2 => Piece::Heading(level),
                        Tag::CodeBlock(CodeBlockKind::Fenced(info)) => {
                            match block(&info) {
                                Some((word, after)) => {
                                    // An empty block has no text: it stands where the fence ends.
                                    inside = Some(range.end..range.end);
                                    Piece::Block(word, after.to_owned(), range.end..range.end)
                                }
                                None => Piece::Text,
                            }
                        }
                        _ => Piece::Text,
                    };
                    pieces.push((piece, range));
                }
                depth += 1;
            }
            Event::Text(_) => {
                if let Some(inside) = &mut inside {
                    *inside = inside.start.min(range.start)..range.end;
                }
            }
            Event::End(tag) => {
                depth = depth.saturating_sub(1);
                if depth == 0
                    && tag == TagEnd::CodeBlock
                    && let (Some(found), Some((Piece::Block(_, _, part), _))) =
                        (inside.take(), pieces.last_mut())
                {
                    *part = found;
                }
            }
            // Rules and HTML on their own level.
            _ if depth == 0 => pieces.push((Piece::Text, range)),
            _ => {}
        }
    }
    pieces
}

/// The word of a block and what follows it; only notes have more than the word.
fn block(info: &str) -> Option<(&'static str, &str)> {
    let (first, after) = info.split_once(char::is_whitespace).unwrap_or((info, ""));
    let word = BLOCKS.into_iter().find(|word| *word == first)?;
    (after.trim().is_empty() || word == NOTES).then_some((word, after))
}

fn steps(file: &str, text: &str, body: usize) -> Result<Vec<Step>, ContentError> {
    let mut steps: Vec<Step> = Vec::new();
    let mut scenes: Vec<Option<(Scene, Vec<Vary>)>> = Vec::new();
    let mut running: Option<Range<usize>> = None;
    for (piece, range) in pieces(text, body) {
        let line = line_of(text, range.start);
        if let Piece::Text = piece {
            if steps.is_empty() {
                return Err(error(file, line, "expected a step: ## and its heading"));
            }
            running = Some(running.map_or(range.start, |before| before.start)..range.end);
            continue;
        }
        take_text(file, text, &mut running, &mut steps)?;
        match piece {
            Piece::Heading(HeadingLevel::H2) => {
                let title = text[range].trim().trim_matches('#').trim().to_owned();
                let title = title.lines().next().unwrap_or_default().to_owned();
                if title.is_empty() {
                    return Err(error(file, line, "expected a heading after ##"));
                }
                steps.push(Step {
                    title,
                    scene: Scene { link: String::new(), line },
                    vary: Vec::new(),
                    parts: Vec::new(),
                    line,
                });
                scenes.push(None);
            }
            Piece::Heading(_) => {
                let problem = "expected ## for a step; the title of the lesson stands in the front matter";
                return Err(error(file, line, problem));
            }
            Piece::Block(word, after, part) => {
                let (Some(step), Some(scene)) = (steps.last_mut(), scenes.last_mut()) else {
                    return Err(error(file, line, "expected a step: ## and its heading"));
                };
                match word {
                    "scene" if scene.is_some() => {
                        return Err(error(file, line, "a step has one scene; expected another step, ##"));
                    }
                    "scene" => {
                        *scene = Some(with_block(file, text, part, |block| {
                            let link = block.text("link")?;
                            let vary = vary::read(block)?;
                            block.finish()?;
                            Ok((Scene { link, line: block.line("link") }, vary))
                        })?);
                    }
                    "reveal" => {
                        let shown = Text::read(file, line_of(text, part.start), &text[part])?;
                        step.parts.push(Part::Reveal(shown));
                    }
                    "predict" => step.parts.push(Part::Prediction(with_block(file, text, part, |block| {
                        prediction_file::read(file, line, block)
                    })?)),
                    NOTES => {
                        let inside = (line_of(text, part.start), &text[part]);
                        step.parts.push(Part::Notes(notes::read(file, (line, &after), inside)?));
                    }
                    "write" => step.parts.push(Part::Write(with_block(file, text, part, |block| {
                        writing::read(file, line, block)
                    })?)),
                    _ => {
                        let task = with_block(file, text, part, |block| task_file::read(file, line, block))?;
                        step.parts.push(Part::Task(task));
                    }
                }
            }
            Piece::Text => {}
        }
    }
    take_text(file, text, &mut running, &mut steps)?;
    let mut before: Option<(Scene, Vec<Vary>)> = None;
    for (step, scene) in steps.iter_mut().zip(scenes) {
        before = scene.or(before);
        let Some((scene, vary)) = &before else {
            return Err(error(file, step.line, "expected a block ```scene in the first step"));
        };
        (step.scene, step.vary) = (scene.clone(), vary.clone());
    }
    if steps.is_empty() {
        return Err(error(file, line_of(text, body), "expected a step: ## and its heading"));
    }
    Ok(steps)
}

/// Ends the running text and gives it to the last step.
fn take_text(
    file: &str,
    text: &str,
    running: &mut Option<Range<usize>>,
    steps: &mut [Step],
) -> Result<(), ContentError> {
    let (Some(range), Some(step)) = (running.take(), steps.last_mut()) else { return Ok(()) };
    let read = Text::read(file, line_of(text, range.start), &text[range])?;
    if !read.is_empty() {
        step.parts.push(Part::Text(read));
    }
    Ok(())
}
