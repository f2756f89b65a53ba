//! The sheet of references: what the lessons rest on, and where the numbers of each aircraft come from.

use std::sync::Arc;

use egui::{Frame, Id, Modal, RichText, ScrollArea, Ui};

use crate::content::Aircraft;
use crate::lesson::Shelf;
use crate::ui::theme;

/// Widest that lines are read with ease.
const WIDEST: f32 = 560.0;

/// Draws the sheet. Says whether it is still wanted.
pub fn references_sheet_ui(ui: &Ui, shelf: &Shelf, aircraft: &[Arc<Aircraft>]) -> bool {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::unique("references")).frame(frame).show(ui, |ui| {
        ui.set_max_width((ui.content_rect().width() - 64.0).min(WIDEST));
        theme::heading(ui, RichText::new("References").heading().size(theme::sizes(ui).sheet), 2);
        let room = ui.content_rect().height() - 150.0;
        ScrollArea::vertical().max_height(room).show(ui, |ui| list_ui(ui, shelf, aircraft));
        ui.add_space(8.0);
        ui.button("Close").clicked()
    });
    !(modal.inner || modal.should_close())
}

fn list_ui(ui: &mut Ui, shelf: &Shelf, aircraft: &[Arc<Aircraft>]) {
    let strong = |text: &str| RichText::new(text).font(theme::semibold(theme::sizes(ui).value));
    let (of_lessons, of_aircraft) = (strong("Of the lessons"), strong("Of the aircraft"));
    theme::heading(ui, of_lessons, 3);
    for reference in shelf.references.values() {
        ui.label(format!("{}: {}. {}.", reference.author, reference.title, reference.published));
    }
    ui.add_space(8.0);
    theme::heading(ui, of_aircraft, 3);
    for aircraft in aircraft {
        ui.label(format!("{}, {}: {}", aircraft.name, aircraft.condition, aircraft.source));
    }
}
