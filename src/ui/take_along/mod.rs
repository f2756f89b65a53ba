//! The sheet “Take along”: the scene as a script, a file, data or a figure for another program. `words` are those of its
//! buttons.

mod words;

pub use words::take_pane;

use egui::{Frame, Id, Modal, RichText, ScrollArea, Ui};

use super::finger;
use super::theme::{self, Palette};
use crate::export::Target;
use crate::scenario::view::{Pane, Tab};

/// The sheet as it stands.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TakeAlong {
    /// Whether the text is copied, not saved.
    copies: bool,
    /// Whether figures become pictures (PNG), not drawings (SVG).
    as_pictures: bool,
    /// The pane that it was opened for, with its tab: what it has stands first.
    of: Option<(Pane, Tab)>,
    /// Whether what stands first is to have the keyboard.
    begins: bool,
    /// What is on its way.
    waits: Option<Target>,
    /// What became of the last, in sentences; why it can't be had, where it is an error.
    said: Option<Result<Vec<String>, String>>,
}

/// What a holder of the page can do with files.
#[derive(Clone, Copy, Debug)]
pub struct Means {
    /// Whether files can be saved.
    pub files: bool,
    /// Whether figures can become pictures, and pages be printed.
    pub pictures: bool,
}

/// What was done in the sheet.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// What is wanted.
    pub wanted: Option<Target>,
    /// Whether the scene is to be printed.
    pub prints: bool,
    /// Whether the sheet is still wanted.
    pub is_wanted: bool,
}

impl TakeAlong {
    /// The sheet with what a pane has in its first group.
    pub fn of_pane(pane: Pane, tab: Tab) -> Self {
        Self { of: Some((pane, tab)), begins: true, ..Self::default() }
    }

    /// Whether a file of a name is to become a picture.
    pub fn wants_picture(&self, file: &str) -> bool {
        self.as_pictures && file.ends_with(".svg")
    }

    /// A target is on its way.
    pub fn wait(&mut self, target: Target) {
        (self.waits, self.said) = (Some(target), None);
    }

    /// Whether something is on its way.
    pub const fn is_waiting(&self) -> bool {
        self.waits.is_some()
    }

    /// Whether what has come is to be copied. It is here, or can't be had.
    pub fn take(&mut self, said: Result<Vec<String>, String>) -> bool {
        (self.waits, self.said) = (None, Some(said));
        self.copies
    }

    /// Says what became of it, before anything else.
    pub fn tell(&mut self, told: String) {
        if let Some(Ok(sentences)) = &mut self.said {
            sentences.insert(0, told);
        }
    }
}

/// Draws the sheet.
pub fn take_along_sheet_ui(ui: &Ui, sheet: &mut TakeAlong, means: Means) -> Shown {
    sheet.copies |= !means.files;
    let (mut wanted, mut prints) = (None, false);
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::unique("take along")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(520.0));
        theme::heading(ui, RichText::new("Take along").heading().size(theme::sizes(ui).sheet), 2);
        ui.label("The scene as it stands, for another program.");
        if means.files {
            ui.horizontal_wrapped(|ui| {
                ui.selectable_value(&mut sheet.copies, false, "Save a file");
                ui.selectable_value(&mut sheet.copies, true, "Copy the text");
            });
        }
        if means.pictures {
            ui.horizontal_wrapped(|ui| {
                ui.label("Figures:");
                ui.selectable_value(&mut sheet.as_pictures, false, "SVG");
                ui.selectable_value(&mut sheet.as_pictures, true, "PNG");
            });
        }
        let room = (ui.content_rect().height() - 300.0).max(120.0);
        let area = ScrollArea::vertical().max_height(room);
        wanted = finger::scroll_area_ui(ui, "targets", area, |ui| targets_ui(ui, sheet));
        ui.add_space(6.0);
        said_ui(ui, sheet);
        ui.horizontal(|ui| {
            if means.pictures {
                prints =
                    ui.button("Print …").on_hover_text("The scene on a page of paper (Ctrl P)").clicked();
            }
            ui.button("Close").clicked()
        })
        .inner
    });
    Shown { wanted, prints, is_wanted: !modal.inner && !modal.should_close() }
}

fn targets_ui(ui: &mut Ui, sheet: &mut TakeAlong) -> Option<Target> {
    let mut wanted = None;
    let first = sheet.of.map(|(pane, tab)| words::of_pane(pane, tab));
    let in_first = |target: Target| first.is_some_and(|(_, targets)| targets.contains(&target));
    for (place, (title, targets)) in first.into_iter().chain(words::GROUPS).enumerate() {
        let is_first = first.is_some() && place == 0;
        ui.add_space(8.0);
        theme::heading(ui, RichText::new(title).font(theme::semibold(theme::sizes(ui).value)), 3);
        ui.horizontal_wrapped(|ui| {
            for &target in targets.iter().filter(|target| is_first || !in_first(**target)) {
                let button = ui.button(words::target(target));
                if std::mem::take(&mut sheet.begins) {
                    button.request_focus();
                }
                if button.on_hover_text(words::hint(target)).clicked() && sheet.waits.is_none() {
                    wanted = Some(target);
                }
            }
        });
    }
    wanted
}

/// What became of the last.
fn said_ui(ui: &mut Ui, sheet: &TakeAlong) {
    let palette = Palette::of(ui);
    if let Some(target) = sheet.waits {
        ui.label(format!("{} is on its way.", words::target(target)));
    }
    match &sheet.said {
        Some(Ok(sentences)) => {
            for sentence in sentences {
                ui.label(RichText::new(sentence).color(palette.good));
            }
        }
        Some(Err(problem)) => {
            ui.label(RichText::new(format!("⚠ {problem}")).color(palette.bad));
        }
        None => {}
    }
}
