//! Running text: Markdown as blocks of spans, which whoever draws it lays out.

use std::sync::Arc;

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use super::formula::Formula;
use super::formula_file;
use super::number::{Number, unknown};
use crate::content::reader::line_of;
use crate::content::{Aircraft, ContentError};
use crate::findings::Findings;

/// Running text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text {
    /// Its blocks, in order.
    pub blocks: Vec<TextBlock>,
}

/// A block of text.
#[derive(Clone, Debug, PartialEq)]
pub enum TextBlock {
    /// A paragraph.
    Paragraph(Vec<Span>),
    /// A heading within a step.
    Heading(Vec<Span>),
    /// A paragraph of an item of a list.
    Item {
        /// How many lists it stands in, from 1.
        depth: usize,
        /// Its number in a list with numbers; `None` for a bullet and for what follows the first paragraph.
        number: Option<u64>,
        /// Whether it begins the item.
        begins: bool,
        /// Its text.
        spans: Vec<Span>,
    },
    /// A paragraph that is quoted.
    Quote(Vec<Span>),
    /// Text in which every space counts.
    Code(String),
    /// A formula on a line of its own.
    Formula(Formula),
    /// Rows of cells, the first the heads of the columns.
    Table(Vec<Vec<Vec<Span>>>),
}

impl TextBlock {
    /// Its spans; none of code.
    pub fn spans(&self) -> Vec<&Span> {
        match self {
            Self::Paragraph(spans) | Self::Heading(spans) | Self::Quote(spans) | Self::Item { spans, .. } => {
                spans.iter().collect()
            }
            Self::Table(rows) => rows.iter().flatten().flatten().collect(),
            Self::Code(_) | Self::Formula(_) => Vec::new(),
        }
    }
}

/// A run of text that looks the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// What stands there.
    pub what: What,
    /// Whether it is emphasised (`*…*`).
    pub emphasis: bool,
    /// Whether it is strong (`**…**`).
    pub strong: bool,
    /// Where it leads.
    pub target: Option<Target>,
    /// Line of the file, counted from 1.
    pub line: usize,
}

/// What stands in a span.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// Words.
    Words(String),
    /// A symbol in the notation of the page's symbols: text in backticks.
    Symbol(String),
    /// A number that is measured.
    Number(Number),
    /// A formula within the line.
    Formula(Formula),
    /// The end of a line that stays one.
    Break,
}

/// Where a link in the text leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A word of the glossary, by its key: `glossary:damping`.
    Glossary(String),
    /// What the words are quoted from, a reference by its key: `source:nelson`.
    Source(String),
    /// A lesson, by its key: `lesson:hangar`.
    Lesson(String),
    /// A scene: `#v=1&ac=navion`.
    Scene(String),
    /// A page elsewhere: `https://…`.
    Page(String),
}

impl Target {
    fn read(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            Some(("glossary", key)) => Ok(Self::Glossary(key.to_owned())),
            Some(("source", key)) => Ok(Self::Source(key.to_owned())),
            Some(("lesson", key)) => Ok(Self::Lesson(key.to_owned())),
            Some(("https" | "http", _)) => Ok(Self::Page(text.to_owned())),
            _ if text.starts_with('#') => Ok(Self::Scene(text.to_owned())),
            Some((kind, _)) => {
                Err(unknown("kind of link", kind, ["glossary", "source", "lesson", "https"].into_iter()))
            }
            None => Err(format!(
                "\"{text}\" leads nowhere; expected glossary:KEY, source:KEY, lesson:KEY, a scene (#v=1&…) or https://…"
            )),
        }
    }
}

/// The word of notes, the only block with more than its word after the fence.
pub(super) const NOTES: &str = "notes";

/// The words after the fence of a block of a lesson.
pub(super) const BLOCKS: [&str; 6] = ["scene", "predict", "reveal", "task", "write", NOTES];

/// The word after the fence of a formula on a line of its own.
const MATH: &str = "math";

/// The options of Markdown that lessons use beyond CommonMark: formulas between dollars, and tables.
pub(super) const OPTIONS: Options = Options::ENABLE_MATH.union(Options::ENABLE_TABLES);

impl Text {
    /// Reads Markdown whose first line is `line` of the file.
    pub(super) fn read(file: &str, line: usize, markdown: &str) -> Result<Self, ContentError> {
        let mut reader = Reader { file, line, markdown, ..Reader::default() };
        for (event, range) in Parser::new_ext(markdown, OPTIONS).into_offset_iter() {
            reader.take(event, range.start)?;
        }
        reader.flush();
        Ok(Self { blocks: reader.blocks })
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// All of its spans.
    pub fn spans(&self) -> impl Iterator<Item = &Span> {
        self.blocks.iter().flat_map(|block| block.spans())
    }

    /// All of its spans, to be changed.
    pub(super) fn spans_mut(&mut self) -> impl Iterator<Item = &mut Span> {
        self.blocks.iter_mut().flat_map(|block| match block {
            TextBlock::Paragraph(spans)
            | TextBlock::Heading(spans)
            | TextBlock::Quote(spans)
            | TextBlock::Item { spans, .. } => spans.iter_mut().collect(),
            TextBlock::Table(rows) => rows.iter_mut().flatten().flatten().collect(),
            TextBlock::Code(_) | TextBlock::Formula(_) => Vec::new(),
        })
    }

    /// Its words without any form, numbers measured at a scene.
    pub fn plain_at(&self, findings: &Findings, aircraft: &[Arc<Aircraft>]) -> String {
        let words = self.spans().map(|span| match &span.what {
            What::Words(words) | What::Symbol(words) => words.clone(),
            What::Number(number) => match number.value(findings, aircraft) {
                Some(Ok(value)) => value,
                Some(Err(_)) | None => "–".to_owned(),
            },
            What::Formula(formula) => formula.line(),
            What::Break => " ".to_owned(),
        });
        words.collect()
    }

    /// Its words without any form, numbers left out.
    pub fn plain(&self) -> String {
        let words = self.spans().map(|span| match &span.what {
            What::Words(words) | What::Symbol(words) => words.clone(),
            What::Formula(formula) => formula.line(),
            What::Number(_) => String::new(),
            What::Break => " ".to_owned(),
        });
        words.collect()
    }
}

#[derive(Default)]
struct Reader<'t> {
    file: &'t str,
    line: usize,
    markdown: &'t str,
    blocks: Vec<TextBlock>,
    spans: Vec<Span>,
    emphasis: usize,
    strong: usize,
    target: Option<Target>,
    /// The next number of each list that is open; `None` for bullets.
    lists: Vec<Option<u64>>,
    /// Whether an item has just begun.
    begins: bool,
    quotes: usize,
    heading: bool,
    code: Option<String>,
    /// Where the formula begins that is being read as code.
    formula: Option<usize>,
    /// The rows of the table that is open.
    table: Vec<Vec<Vec<Span>>>,
}

impl Reader<'_> {
    fn line(&self, offset: usize) -> usize {
        self.line + line_of(self.markdown, offset) - 1
    }

    fn error(&self, offset: usize, problem: impl Into<String>) -> ContentError {
        ContentError { file: self.file.to_owned(), line: self.line(offset), problem: problem.into() }
    }

    fn push(&mut self, what: What, offset: usize) {
        let line = self.line(offset);
        self.spans.push(Span {
            what,
            emphasis: self.emphasis > 0,
            strong: self.strong > 0,
            target: self.target.clone(),
            line,
        });
    }

    /// Ends the block that is open.
    fn flush(&mut self) {
        let spans = std::mem::take(&mut self.spans);
        if spans.is_empty() {
            return;
        }
        self.blocks.push(if self.heading {
            TextBlock::Heading(spans)
        } else if let Some(number) = self.lists.last().copied() {
            let begins = std::mem::take(&mut self.begins);
            TextBlock::Item { depth: self.lists.len(), number: number.filter(|_| begins), begins, spans }
        } else if self.quotes > 0 {
            TextBlock::Quote(spans)
        } else {
            TextBlock::Paragraph(spans)
        });
    }

    fn take(&mut self, event: Event<'_>, offset: usize) -> Result<(), ContentError> {
        match event {
            Event::Start(tag) => self.start(tag, offset)?,
            Event::End(tag) => self.end(tag)?,
            Event::Text(text) => match &mut self.code {
                Some(code) => code.push_str(&text),
                None => self.push(What::Words(text.into_string()), offset),
            },
            Event::Code(code) => {
                let what = match code.strip_prefix('=') {
                    Some(rest) => What::Number(Number::read(self.file, self.line(offset), rest)?),
                    None => What::Symbol(code.into_string()),
                };
                self.push(what, offset);
            }
            Event::SoftBreak => self.push(What::Words(" ".to_owned()), offset),
            Event::HardBreak => self.push(What::Break, offset),
            Event::Html(_) | Event::InlineHtml(_) => {
                return Err(self.error(offset, "expected Markdown, found HTML"));
            }
            Event::InlineMath(written) => {
                let what = What::Formula(self.formula(&written, offset + 1)?);
                self.push(what, offset);
            }
            Event::DisplayMath(written) => {
                let formula = self.formula(&written, offset + 2)?;
                self.flush();
                self.blocks.push(TextBlock::Formula(formula));
            }
            Event::Rule | Event::FootnoteReference(_) | Event::TaskListMarker(_) => self.flush(),
        }
        Ok(())
    }

    /// Reads a formula that begins at an offset of the text.
    fn formula(&self, written: &str, offset: usize) -> Result<Formula, ContentError> {
        formula_file::read(written.trim_end()).map_err(|(at, problem)| {
            let before = written.get(..at).unwrap_or_default().matches('\n').count();
            let error = self.error(offset.min(self.markdown.len()), format!("formula: {problem}"));
            ContentError { line: error.line + before, ..error }
        })
    }

    fn start(&mut self, tag: Tag<'_>, offset: usize) -> Result<(), ContentError> {
        match tag {
            Tag::Emphasis => self.emphasis += 1,
            Tag::Strong => self.strong += 1,
            Tag::Link { dest_url, .. } => {
                self.target = Some(Target::read(&dest_url).map_err(|problem| self.error(offset, problem))?);
            }
            Tag::Image { .. } => return Err(self.error(offset, "expected text, found a picture")),
            Tag::Heading { level, .. } => {
                if level <= HeadingLevel::H2 {
                    return Err(self.error(offset, "expected a heading within a step, ### and its words"));
                }
                self.flush();
                self.heading = true;
            }
            Tag::List(first) => {
                self.flush();
                self.lists.push(first);
            }
            Tag::Item => self.begins = true,
            Tag::BlockQuote(_) => {
                self.flush();
                self.quotes += 1;
            }
            Tag::CodeBlock(CodeBlockKind::Fenced(info)) if &*info == MATH => {
                self.flush();
                self.code = Some(String::new());
                self.formula = Some(offset);
            }
            Tag::CodeBlock(CodeBlockKind::Fenced(info)) if !info.is_empty() => {
                // Only notes have more than a word.
                let word = info.split_whitespace().next().filter(|word| !BLOCKS.contains(word));
                let word = word.unwrap_or(&info);
                let problem = unknown("block of a lesson", word, BLOCKS.into_iter().chain([MATH]));
                return Err(self.error(offset, problem));
            }
            Tag::Table(_) => self.flush(),
            Tag::TableHead | Tag::TableRow => self.table.push(Vec::new()),
            Tag::CodeBlock(_) => {
                self.flush();
                self.code = Some(String::new());
            }
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, tag: TagEnd) -> Result<(), ContentError> {
        match tag {
            TagEnd::Emphasis => self.emphasis = self.emphasis.saturating_sub(1),
            TagEnd::Strong => self.strong = self.strong.saturating_sub(1),
            TagEnd::Link => self.target = None,
            TagEnd::Heading(_) => {
                self.flush();
                self.heading = false;
            }
            TagEnd::Paragraph => self.flush(),
            TagEnd::Item => {
                self.flush();
                if let Some(Some(number)) = self.lists.last_mut() {
                    *number = number.saturating_add(1);
                }
            }
            TagEnd::List(_) => {
                self.lists.pop();
            }
            TagEnd::BlockQuote(_) => {
                self.flush();
                self.quotes = self.quotes.saturating_sub(1);
            }
            TagEnd::TableCell => {
                let cell = std::mem::take(&mut self.spans);
                self.table.last_mut().into_iter().for_each(|row| row.push(cell.clone()));
            }
            TagEnd::Table => self.blocks.push(TextBlock::Table(std::mem::take(&mut self.table))),
            TagEnd::CodeBlock => {
                let code = self.code.take().unwrap_or_default();
                self.blocks.push(match self.formula.take() {
                    // It begins on the line after the fence.
                    Some(fence) => {
                        let first = self.markdown[fence..].find('\n').map_or(fence, |end| fence + end + 1);
                        TextBlock::Formula(self.formula(&code, first)?)
                    }
                    None => TextBlock::Code(code),
                });
            }
            _ => {}
        }
        Ok(())
    }
}
