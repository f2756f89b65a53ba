//! Running text of a lesson: its words, symbols and measured numbers, and where they lead.

use std::sync::Arc;

use egui::{FontId, Label, Response, RichText, Sense, Ui};

use super::Wish;
use crate::content::Aircraft;
use crate::findings::Findings;
use crate::lesson::{Shelf, Span, Target, Text, TextBlock, What};
use crate::ui::symbol::prose;
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

/// Draws text; gives a scene that it leads to, if the person goes there.
pub fn text_ui(ui: &mut Ui, text: &Text, context: Context<'_>) -> Option<Wish> {
    let mut wish = None;
    for block in &text.blocks {
        let line = |ui: &mut Ui| {
            ui.spacing_mut().item_spacing = egui::Vec2::new(0.0, 3.0);
            if let TextBlock::Item { depth, number, begins, .. } = block {
                ui.add_space(12.0 * (*depth as f32));
                match number {
                    Some(number) => ui.label(format!("{number}. ")),
                    None if *begins => ui.label("• "),
                    None => ui.label(""),
                };
            }
            if let TextBlock::Code(code) = block {
                ui.monospace(code);
            }
            let is_strong = matches!(block, TextBlock::Heading(_));
            for span in block.spans() {
                wish = span_ui(ui, span, is_strong, context).or(wish.take());
            }
        };
        ui.scope(|ui| {
            // A word that leads somewhere stands in its line like the others, on a phone too.
            ui.spacing_mut().interact_size.y = 0.0;
            ui.horizontal_wrapped(line);
        });
        ui.add_space(2.0);
    }
    wish
}

fn span_ui(ui: &mut Ui, span: &Span, is_strong: bool, context: Context<'_>) -> Option<Wish> {
    let palette = Palette::of(ui);
    let font: FontId =
        if is_strong || span.strong { theme::semibold(theme::body().size) } else { theme::body() };
    let words = match &span.what {
        What::Words(words) | What::Symbol(words) => words.clone(),
        What::Number(number) => match number.value(context.start, context.aircraft) {
            Some(Ok(value)) => value,
            Some(Err(absence)) => format!("({})", words::measure::absence(&absence)),
            None => String::new(),
        },
        What::Break => {
            ui.end_row();
            return None;
        }
    };
    let response: Response = match &span.target {
        None => {
            ui.label(prose(&words, font, palette.text));
            return None;
        }
        Some(_) => {
            let text = RichText::new(words).font(font).color(palette.accent).underline();
            ui.add(Label::new(text).sense(Sense::CLICK))
        }
    };
    let target = span.target.as_ref()?;
    let told = match target {
        Target::Glossary(key) => context.shelf.glossary.get(key).map(|entry| entry.says.clone()),
        Target::Source(key) => context
            .shelf
            .references
            .get(key)
            .map(|source| format!("{}, {}, {}", source.author, source.title, source.published)),
        Target::Scene(_) => Some("Open this scene".to_owned()),
        Target::Lesson(_) | Target::Page(_) => None,
    };
    let response = match told {
        Some(told) => response.on_hover_text(told),
        None => response,
    };
    match target {
        Target::Scene(link) if response.clicked() => Some(Wish::Scene(link.clone())),
        Target::Lesson(key) if response.clicked() => Some(Wish::Lesson(key.clone())),
        _ => None,
    }
}
