//! The sheet “Embed this”: the scene as it stands as a frame for a page of one's own, with what it shows, hides and locks.

use egui::{Checkbox, DragValue, Frame, Id, Modal, RichText, ScrollArea, TextEdit, Ui};
use maud::html;

use super::theme::{self, Palette};
use crate::key::Keyed;
use crate::scenario::{Part, Stage};
use crate::words;

/// Heights of a frame that can be typed \[CSS pixels\].
const HEIGHTS: std::ops::RangeInclusive<u32> = 200..=2000;

/// Height of a frame until another is typed \[CSS pixels\]: one pane, or two beside each other, with the bar.
const HEIGHT: u32 = 480;

/// The same where there are more panes.
const HIGH: u32 = 860;

/// A frame as it is being made.
#[derive(Clone, Debug, PartialEq)]
pub struct Embedding {
    stage: Stage,
    /// \[CSS pixels\]; that which fits the stage until one is typed.
    height: Option<u32>,
}

/// What was done in the sheet.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Whether the frame is to be copied.
    pub copies: bool,
    /// Whether the sheet is still wanted.
    pub is_wanted: bool,
}

impl Embedding {
    /// A frame with a stage.
    pub const fn new(stage: Stage) -> Self {
        Self { stage, height: None }
    }

    /// What the frame shows, hides and locks.
    pub const fn stage(&self) -> &Stage {
        &self.stage
    }

    fn height(&self) -> u32 {
        let panes = self.stage.parts().iter().filter(|part| **part != Part::Derivatives).count();
        self.height.unwrap_or(if (1..=2).contains(&panes) { HEIGHT } else { HIGH })
    }

    /// The frame, for the source of a page.
    pub fn html(&self, address: &str, title: &str) -> String {
        let frame = html! {
            iframe src=(address) title=(title) width="100%" height=(self.height()) style="border:0" loading="lazy"
                allow="clipboard-write; fullscreen" {}
        };
        frame.into_string()
    }
}

/// Draws the sheet.
pub fn embed_sheet_ui(ui: &Ui, embedding: &mut Embedding, html: &str) -> Shown {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::unique("embed")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(560.0));
        theme::heading(ui, RichText::new("Embed this").heading().size(theme::sizes(ui).sheet), 2);
        ui.label("The scene as it stands, as a frame for a page of yours.");
        let room = (ui.content_rect().height() - 300.0).max(120.0);
        ScrollArea::vertical().max_height(room).show(ui, |ui| choices_ui(ui, embedding));
        ui.add_space(8.0);
        let mut text = html;
        let source =
            TextEdit::multiline(&mut text).code_editor().desired_rows(4).desired_width(f32::INFINITY);
        ui.add(source).accessible_name("HTML of the frame");
        ui.label(RichText::new(NOTE).font(theme::small()).color(Palette::of(ui).weak));
        ui.add_space(4.0);
        ui.horizontal(|ui| (ui.button("Copy the HTML").clicked(), ui.button("Close").clicked())).inner
    });
    let (copies, closes) = modal.inner;
    Shown { copies, is_wanted: !closes && !modal.should_close() }
}

/// What nobody should expect of locks.
const NOTE: &str = "What is locked stays so in the frame. Whoever opens its address in a tab of their own can edit it there.";

fn choices_ui(ui: &mut Ui, embedding: &mut Embedding) {
    let stage = &embedding.stage;
    let all = stage.parts().is_empty();
    let shown: Vec<Part> = Part::VALUES.iter().copied().filter(|part| stage.has(*part)).collect();
    let parts = boxes_ui(ui, "Shows", &shown, words::stage::part);
    let hidden = boxes_ui(ui, "Hides", stage.hidden(), words::stage::hidden);
    let locks = boxes_ui(ui, "Locks", stage.locks(), words::stage::lock);
    let usual = |part: &&Part| **part != Part::Equations;
    let is_all = all && parts == shown || parts.iter().eq(Part::VALUES.iter().filter(usual));
    let parts = if is_all { Vec::new() } else { parts };
    let mut staged = Stage::with(parts).hiding(hidden).locking(locks);
    let (offered, locked) = (stage.offered.clone(), stage.locked.clone());
    let mut type_size = stage.type_size;
    let mut height = embedding.height();
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        let label = ui.label("Size of type");
        let [least, most] = Stage::TYPE_SIZES;
        let size = DragValue::new(&mut type_size).range(least..=most).speed(0.01).max_decimals(2);
        ui.add(size).labelled_by(label.id);
        ui.add_space(12.0);
        let label = ui.label("Height");
        let size = DragValue::new(&mut height).range(HEIGHTS).suffix(" px");
        if ui.add(size).labelled_by(label.id).changed() {
            embedding.height = Some(height);
        }
    });
    (staged.offered, staged.locked, staged.type_size) = (offered, locked, type_size);
    embedding.stage = staged;
}

/// A box for each value of a list; gives those that are ticked.
fn boxes_ui<T: Keyed>(ui: &mut Ui, title: &str, ticked: &[T], words: fn(T) -> &'static str) -> Vec<T> {
    ui.add_space(6.0);
    theme::heading(ui, RichText::new(title).font(theme::semibold(theme::sizes(ui).value)), 3);
    let mut chosen = Vec::new();
    ui.horizontal_wrapped(|ui| {
        for &value in T::VALUES {
            let mut is_ticked = ticked.contains(&value);
            let text = words(value);
            ui.add(Checkbox::new(&mut is_ticked, text)).accessible_name(format!("{title}: {text}"));
            if is_ticked {
                chosen.push(value);
            }
        }
    });
    chosen
}
