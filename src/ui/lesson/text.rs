//! Running text of a lesson: its words, symbols and measured numbers, and where they lead.

use std::ops::Range;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{FontId, Grid, RichText, Sense, TextStyle, Ui, Vec2, WidgetInfo};

use super::Wish;
use super::formula::{display_ui, inline_ui};
use super::word::word_ui;
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::lesson::{Shelf, Span, Text, TextBlock, What};
use crate::ui::symbol::{Symbol, prose};
use crate::ui::theme::{self, Palette};
use crate::words;

/// What text is read against.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// What follows from the scene of the step at its start.
    pub start: &'a Findings,
    /// Glossary and references.
    pub shelf: &'a Shelf,
    /// The aircraft that links may name.
    pub aircraft: &'a [Arc<Aircraft>],
}

/// Draws text, which can be selected and copied; gives what it leads to, if the person goes there.
pub fn text_ui(ui: &mut Ui, text: &Text, context: Context<'_>) -> Option<Wish> {
    let mut wish = None;
    for (number, block) in text.blocks.iter().enumerate() {
        ui.scope(|ui| {
            // A word that leads somewhere stands in its line like the others, on a phone too.
            ui.spacing_mut().interact_size.y = 0.0;
            ui.style_mut().interaction.selectable_labels = true;
            wish = block_ui(ui, block, number, context).or(wish.take());
        });
        ui.add_space(2.0);
    }
    wish
}

fn block_ui(ui: &mut Ui, block: &TextBlock, number: usize, context: Context<'_>) -> Option<Wish> {
    let (depth, bullet) = match block {
        TextBlock::Formula(formula) => {
            display_ui(ui, formula);
            return None;
        }
        TextBlock::Code(code) => {
            ui.monospace(code);
            return None;
        }
        TextBlock::Table(rows) => return table_ui(ui, rows, number, context),
        TextBlock::Item { depth, number: Some(number), .. } => (*depth, format!("{number}. ")),
        TextBlock::Item { depth, begins: true, .. } => (*depth, "• ".to_owned()),
        TextBlock::Item { depth, .. } => (*depth, String::new()),
        TextBlock::Quote(_) => (1, String::new()),
        TextBlock::Paragraph(_) | TextBlock::Heading(_) => (0, String::new()),
    };
    let mut wish = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = Vec2::new(0.0, 3.0);
        ui.add_space(12.0 * depth as f32);
        if !bullet.is_empty() {
            ui.label(bullet);
        }
        let is_strong = matches!(block, TextBlock::Heading(_));
        wish = spans_ui(ui, &block.spans(), is_strong, context);
    });
    wish
}

/// A table, its first row the heads of its columns.
fn table_ui(ui: &mut Ui, rows: &[Vec<Vec<Span>>], number: usize, context: Context<'_>) -> Option<Wish> {
    let mut wish = None;
    ui.spacing_mut().interact_size.y = ui.text_style_height(&TextStyle::Body);
    Grid::new(("table", number)).striped(true).spacing((14.0, 4.0)).show(ui, |ui| {
        for (row, cells) in rows.iter().enumerate() {
            for cell in cells {
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.0;
                    let spans: Vec<&Span> = cell.iter().collect();
                    wish = spans_ui(ui, &spans, row == 0, context).or(wish.take());
                });
            }
            ui.end_row();
        }
    });
    wish
}

/// Text that is being put together into one label, so that all of it stands on one baseline.
#[derive(Default)]
struct Line {
    job: LayoutJob,
    /// The same for a screen reader, which hears formulas in words.
    told: String,
    has_formula: bool,
}

/// What ends a clause, and belongs to the word before it.
const ENDS: [char; 7] = ['.', ',', ';', ':', '?', '!', ')'];

impl Line {
    /// Draws it where the line has come to, behind a word that leads somewhere or a formula.
    fn flush(&mut self, ui: &mut Ui) {
        let mut line = std::mem::take(self);
        if line.job.is_empty() {
            return;
        }
        let text = &line.job.text;
        let room = ui.available_size_before_wrap().x;
        let begins = ui.cursor().left() <= ui.max_rect().left();
        let width = |ui: &Ui, end: usize| ui.painter().layout_job(part(&line.job, 0..end)).size().x;
        let marks = text.find(|c| !ENDS.contains(&c)).unwrap_or(text.len());
        if !begins && marks > 0 && width(ui, marks) > room {
            // The end of a clause stays behind its word, in the margin.
            let galley = ui.painter().layout_job(part(&line.job, 0..marks));
            let (place, _) = ui.allocate_exact_size(Vec2::new(0.0, galley.size().y), Sense::hover());
            ui.painter().galley(place.left_top(), galley, Palette::of(ui).text);
            line.job = part(&line.job, marks..text.len());
        } else if let Some(words) = text.strip_prefix(' ') {
            let word = words.find(' ').unwrap_or(words.len());
            if !begins && width(ui, 1 + word) > room {
                // The space before a word that has no room any more would stand at the head of the next line.
                line.job = part(&line.job, 1..text.len());
            }
        }
        if line.job.is_empty() {
            return;
        }
        let response = ui.label(line.job);
        if line.has_formula {
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, line.told.as_str()));
        }
    }
}

/// A part of a text, set as it was.
fn part(job: &LayoutJob, bytes: Range<usize>) -> LayoutJob {
    let mut part = LayoutJob::default();
    for section in &job.sections {
        let (start, end) = (section.byte_range.start.0, section.byte_range.end.0);
        let (start, end) = (start.max(bytes.start), end.min(bytes.end));
        if start < end {
            part.append(&job.text[start..end], section.leading_space, section.format.clone());
        }
    }
    part
}

fn spans_ui(ui: &mut Ui, spans: &[&Span], is_strong: bool, context: Context<'_>) -> Option<Wish> {
    let palette = Palette::of(ui);
    let mut wish = None;
    let mut line = Line::default();
    for span in spans {
        let font: FontId =
            if is_strong || span.strong { theme::semibold(theme::body().size) } else { theme::body() };
        let words = match &span.what {
            What::Words(words) | What::Symbol(words) => words.clone(),
            What::Number(number) => match number.value(context.start, context.aircraft) {
                Some(Ok(value)) => value,
                Some(Err(absence)) => {
                    let length = context.start.scenario().length_unit();
                    format!("({})", words::measure::absence(&absence, length))
                }
                None => String::new(),
            },
            What::Formula(formula) if formula.is_flat() => formula.line(),
            What::Formula(formula) => {
                line.flush(ui);
                inline_ui(ui, formula);
                continue;
            }
            What::Break => {
                line.flush(ui);
                ui.end_row();
                continue;
            }
        };
        if let Some(target) = &span.target {
            line.flush(ui);
            let text = RichText::new(&words).font(font);
            wish = word_ui(ui, &words, text, target, context).or(wish);
            continue;
        }
        match &span.what {
            What::Formula(formula) => {
                line.told.push_str(&formula.in_words());
                line.has_formula = true;
            }
            _ => line.told.push_str(&words),
        }
        if matches!(span.what, What::Symbol(_) | What::Formula(_)) {
            // Letters of the maths face are smaller than those of the text.
            Symbol::parse(&words).append_to(&mut line.job, 1.15 * font.size, palette.text);
            continue;
        }
        let mut part = prose(&words, font, palette.text);
        for section in &mut part.sections {
            section.format.italics |= span.emphasis;
            let (from, to) = (section.byte_range.start.0, section.byte_range.end.0);
            line.job.append(&part.text[from..to], section.leading_space, section.format.clone());
        }
    }
    line.flush(ui);
    wish
}
